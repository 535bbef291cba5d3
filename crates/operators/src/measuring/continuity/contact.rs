//! What two sides of a joint have in common at its places.

use std::iter::zip;

use pforms_kernel::{Result, limit};

use super::apart;
use super::side::{Place, Side};

/// Gaps at a place, each with the size that it is to be compared with.
pub(super) struct Contact {
    pub parametric: Vec<[f64; 2]>,
    pub geometric: Vec<[f64; 2]>,
}

/// What there is in common at places all along the joint.
pub(super) fn contacts(before: &Side, after: &Side, order: usize) -> Result<Vec<Contact>> {
    let after = &turned(before, after)?;
    let lists: Vec<Vec<f64>> =
        (0..before.others().len()).map(|k| places(before, after, k)).collect();
    let counts: Vec<usize> = lists.iter().map(Vec::len).collect();
    limit::check::<f64>("the places of the joint", &counts, counts.len())?;
    combinations(&lists)
        .iter()
        .map(|shares| contact(&before.place(shares)?, &after.place(shares)?, order))
        .collect()
}

/// The second side, its other axes run so that it comes nearest to the first.
fn turned<'a>(before: &Side, after: &Side<'a>) -> Result<Side<'a>> {
    /// Shares that tell a direction from its opposite.
    const PROBES: [f64; 3] = [0.0, 0.3, 1.0];
    let count = after.flips.len();
    limit::check::<f64>("the probes of the joint", &vec![2 * PROBES.len(); count], count)?;
    let probes = combinations(&vec![PROBES.to_vec(); count]);
    let mut best: Option<(f64, Side<'a>)> = None;
    for bits in 0..1_usize << count {
        let mut side = after.clone();
        side.flips = (0..count).map(|k| bits >> k & 1 == 1).collect();
        let mut gap = 0.0_f64;
        for shares in &probes {
            let [a, b] = [before.place(shares)?, side.place(shares)?];
            gap = gap.max(apart(&a.across(0)?[0], &b.across(0)?[0]));
        }
        if best.as_ref().is_none_or(|(least, _)| gap < *least) {
            best = Some((gap, side));
        }
    }
    Ok(best.map_or_else(|| after.clone(), |(_, side)| side))
}

/// Shares of the window of the other axis `k`: more between the breaks of both than the degrees.
fn places(before: &Side, after: &Side, k: usize) -> Vec<f64> {
    let mut breaks = [before.shares(k), after.shares(k)].concat();
    breaks.sort_by(f64::total_cmp);
    breaks.dedup();
    let count = 2 * before.degree(k).max(after.degree(k)) + 3;
    let mut places = vec![0.0];
    for pair in breaks.windows(2) {
        let step = (pair[1] - pair[0]) / count as f64;
        places.extend((0..count).map(|i| pair[0] + (i as f64 + 0.5) * step));
    }
    places.push(1.0);
    places
}

fn combinations(lists: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut all = vec![Vec::new()];
    for list in lists {
        let longer = |shares: &Vec<f64>| -> Vec<Vec<f64>> {
            list.iter().map(|share| [shares.as_slice(), &[*share]].concat()).collect()
        };
        all = all.iter().flat_map(longer).collect();
    }
    all
}

fn contact(a: &Place, b: &Place, order: usize) -> Result<Contact> {
    let (across_a, across_b) = (a.across(order)?, b.across(order)?);
    let parametric = zip(&across_a, &across_b).enumerate().map(|(k, (x, y))| {
        let size = if k == 0 { 0.0 } else { norm(x).max(norm(y)) };
        [apart(x, y), size.max(a.usual(k)).max(b.usual(k))]
    });
    let parametric: Vec<[f64; 2]> = parametric.collect();
    let mut geometric = vec![parametric[0]];
    match a.axes() {
        1 => geometric.extend(curves(a, &across_a, b, &across_b)),
        2 if order > 0 => geometric.extend(surfaces(a, b, order)?),
        _ => {}
    }
    Ok(Contact { parametric, geometric })
}

/// The angle of two curves, and the differences of their derivatives by the length of arc.
fn curves(a: &Place, across_a: &[Vec<f64>], b: &Place, across_b: &[Vec<f64>]) -> Vec<[f64; 2]> {
    let still = |place: &Place, across: &[Vec<f64>]| {
        across.len() < 2 || norm(&across[1]) <= STILL * place.usual(1)
    };
    if still(a, across_a) || still(b, across_b) {
        return Vec::new();
    }
    let (by_a, by_b) = (by_length(across_a), by_length(across_b));
    let size = a.size.max(b.size);
    let pairs = zip(by_a, by_b).enumerate();
    let gap = |(k, (x, y)): (usize, (Vec<f64>, Vec<f64>))| {
        if k == 0 {
            return [angle(&x, &y), 1.0];
        }
        [apart(&x, &y), norm(&x).max(norm(&y)).max(size.powi(-(k as i32)))]
    };
    pairs.map(gap).collect()
}

/// What is left of a usual derivative when it counts as none: far above rounding, far below use.
const STILL: f64 = 1e-13;

/// The derivatives of order 1 and more by the length of arc, from those by a parameter.
///
/// `d/ds = (1/v)·d/dt` is applied to Taylor series; `1/v` is the power `−1/2` of the series of `v²`.
fn by_length(across: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let order = across.len() - 1;
    let mut factorial = 1.0;
    let mut series: Vec<Vec<f64>> = Vec::with_capacity(order);
    for (k, derivative) in across.iter().enumerate().skip(1) {
        // The coefficients of the derivative: order k of the curve, over (k − 1)!.
        series.push(derivative.iter().map(|x| x / factorial).collect());
        factorial *= k as f64;
    }
    let square: Vec<f64> =
        (0..order).map(|k| (0..=k).map(|i| dot(&series[i], &series[k - i])).sum()).collect();
    let slowness = inverse_root(&square);
    let mut result = Vec::with_capacity(order);
    loop {
        series = (0..series.len())
            .map(|k| {
                let mut sum = vec![0.0; series[0].len()];
                for i in 0..=k {
                    zip(&mut sum, &series[k - i]).for_each(|(s, x)| *s += slowness[i] * x);
                }
                sum
            })
            .collect();
        result.push(series[0].clone());
        if series.len() == 1 {
            return result;
        }
        let slope = series.iter().enumerate().skip(1);
        series = slope.map(|(k, line)| line.iter().map(|x| k as f64 * x).collect()).collect();
    }
}

/// The power `−1/2` of a series (Miller's recurrence; Knuth, *Seminumerical Algorithms*, 4.7).
fn inverse_root(series: &[f64]) -> Vec<f64> {
    let mut power = vec![1.0 / series[0].sqrt()];
    for k in 1..series.len() {
        let terms = (1..=k).map(|i| (-0.5 * i as f64 - (k - i) as f64) * series[i] * power[k - i]);
        power.push(terms.sum::<f64>() / (k as f64 * series[0]));
    }
    power
}

/// The angle of the tangent planes, seen along the joint, and the difference of the second
/// fundamental forms; nothing where there is no tangent plane.
fn surfaces(a: &Place, b: &Place, order: usize) -> Result<Vec<[f64; 2]>> {
    let (Some(x), Some(y)) = (Tangents::of(a)?, Tangents::of(b)?) else { return Ok(Vec::new()) };
    let mut gaps = vec![[angle(&x.conormal, &y.conormal), 1.0]];
    if order > 1 {
        let (x, y) = (x.bending(a)?, y.bending(b)?);
        let size = norm(&x).max(norm(&y)).max(1.0 / a.size.max(b.size));
        gaps.push([apart(&x, &y), size]);
    }
    Ok(gaps)
}

/// The tangent plane at a place of an edge.
struct Tangents {
    across: Vec<f64>,
    along: Vec<f64>,
    /// The unit vector of the tangent plane that crosses the edge at right angles.
    conormal: Vec<f64>,
    other: usize,
}

impl Tangents {
    fn of(place: &Place) -> Result<Option<Self>> {
        let other = 1 - place.axis;
        let mut orders = [[0; 2]; 2];
        orders[0][place.axis] = 1;
        orders[1][other] = 1;
        let (across, along) = (place.derivative(&orders[0])?, place.derivative(&orders[1])?);
        let length = norm(&along);
        if length == 0.0 {
            return Ok(None);
        }
        let edge: Vec<f64> = along.iter().map(|x| x / length).collect();
        let share = dot(&across, &edge);
        let conormal: Vec<f64> = zip(&across, &edge).map(|(x, e)| x - share * e).collect();
        let width = norm(&conormal);
        if width <= STILL * norm(&across) || width == 0.0 {
            return Ok(None);
        }
        let conormal = conormal.iter().map(|x| x / width).collect();
        Ok(Some(Self { across, along, conormal, other }))
    }

    /// The second fundamental form as a tensor of the space: `Σ (S_ij)⊥ ⊗ e^i ⊗ e^j` over the basis
    /// dual to the tangents. It does not depend on parameters, nor on which normal is meant.
    fn bending(&self, place: &Place) -> Result<Vec<f64>> {
        let tangents = [&self.across, &self.along];
        let axes = [place.axis, self.other];
        let metric = tangents.map(|x| tangents.map(|y| dot(x, y)));
        let area = metric[0][0] * metric[1][1] - metric[0][1] * metric[1][0];
        let inverse = [
            [metric[1][1] / area, -metric[0][1] / area],
            [-metric[1][0] / area, metric[0][0] / area],
        ];
        let dual = inverse.map(|row| -> Vec<f64> {
            zip(tangents[0], tangents[1]).map(|(x, y)| row[0] * x + row[1] * y).collect()
        });
        let dimension = self.across.len();
        let mut tensor = vec![0.0; dimension.pow(3)];
        for i in 0..2 {
            for j in 0..2 {
                let mut orders = [0; 2];
                orders[axes[i]] += 1;
                orders[axes[j]] += 1;
                let mut bend = place.derivative(&orders)?;
                for k in 0..2 {
                    let share = dot(&bend, &dual[k]);
                    zip(&mut bend, tangents[k]).for_each(|(x, t)| *x -= share * t);
                }
                for (at, entry) in tensor.iter_mut().enumerate() {
                    let (p, q, r) =
                        (at / dimension / dimension, at / dimension % dimension, at % dimension);
                    *entry += bend[p] * dual[i][q] * dual[j][r];
                }
            }
        }
        Ok(tensor)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    zip(a, b).map(|(x, y)| x * y).sum()
}

/// The length of a vector of any size.
fn norm(vector: &[f64]) -> f64 {
    vector.iter().fold(0.0_f64, |sum, x| libm::hypot(sum, *x))
}

/// The angle of two unit vectors, without loss when it is small (Kahan).
fn angle(a: &[f64], b: &[f64]) -> f64 {
    let sum: Vec<f64> = zip(a, b).map(|(x, y)| x + y).collect();
    2.0 * libm::atan2(apart(a, b), norm(&sum))
}
