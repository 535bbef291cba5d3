//! Arcs that two curves share.
//!
//! Two ways of running once along the same arc from end to end differ by a homography of the
//! parameter; so poles of the same degree differ by factors `k·cⁱ`, and are the same points. That is
//! compared: poles that are near bound how far the arcs are apart.

use pforms_kernel::{Form, Result};

use crate::measuring::intersect::answer::Overlap;
use crate::{project, raise_together, stretch};

/// The arcs along which two curves stay within `margin`: from end to end of one or the other.
///
/// Errors: those of projection on either curve.
pub(super) fn overlaps(a: &Form, b: &Form, margin: f64) -> Result<Vec<Overlap>> {
    for ends in [[0.0, 1.0], [1.0, 0.0]] {
        if let Some(gap) = compared(a, [0.0, 1.0], b, ends, margin)? {
            return Ok(vec![shared([0.0, 1.0], ends, gap)]);
        }
    }
    let mut found = Vec::new();
    for pair in ends(a, b, margin)?.windows(2) {
        let (from, to) = ([pair[0][0], pair[1][0]], [pair[0][1], pair[1][1]]);
        if from[1] - from[0] < SHORT || (to[1] - to[0]).abs() < SHORT {
            continue;
        }
        if let Some(gap) = compared(a, from, b, to, margin)? {
            found.push(shared(from, to, gap));
        }
    }
    Ok(found)
}

/// The ends of either curve that lie on the other, in the order of the first parameter.
///
/// Errors: those of projection on either curve.
pub(super) fn ends(a: &Form, b: &Form, margin: f64) -> Result<Vec<[f64; 2]>> {
    let mut events: Vec<[f64; 2]> = feet(a, b, margin)?;
    events.extend(feet(b, a, margin)?.into_iter().map(|[t, s]| [s, t]));
    events.sort_by(|x, y| x[0].total_cmp(&y[0]));
    Ok(events)
}

/// Windows below this hold a contact, not an arc.
const SHORT: f64 = 1e-6;

fn shared(first: [f64; 2], second: [f64; 2], gap: f64) -> Overlap {
    Overlap { first: first.map(|s| vec![s]), second: second.map(|t| vec![t]), gap, proved: false }
}

/// The ends of a curve that lie on another, and where.
fn feet(a: &Form, b: &Form, margin: f64) -> Result<Vec<[f64; 2]>> {
    let ends = [a.at(&[0.0])?, a.at(&[1.0])?].concat();
    let found = project(b, &ends, 0.0)?;
    let all = [0.0, 1.0].into_iter().zip(found.distances).zip(found.parameters);
    Ok(all.filter(|((_, distance), _)| *distance <= margin).map(|((s, _), t)| [s, t]).collect())
}

/// How far corresponding poles of two arcs are apart, unless that is more than `margin`.
fn compared(a: &Form, from: [f64; 2], b: &Form, to: [f64; 2], margin: f64) -> Result<Option<f64>> {
    let arcs = [stretch(a, &from[..1], &from[1..])?, stretch(b, &to[..1], &to[1..])?];
    let arcs = raise_together(&[&arcs[0], &arcs[1]])?;
    let [a, b] = &arcs[..] else { return Ok(None) };
    let last = a.ambient();
    let poles =
        || a.homogeneous().chunks_exact(last + 1).zip(b.homogeneous().chunks_exact(last + 1));
    let ratios: Vec<f64> = poles().map(|(p, q)| p[last] / q[last]).collect();
    let factor = ratios.get(1).map_or(1.0, |second| second / ratios[0]);
    let (mut expected, mut gap) = (ratios[0], 0.0_f64);
    for ((p, q), ratio) in poles().zip(&ratios) {
        let off = (ratio / expected - 1.0).abs();
        if off.is_nan() || off > WEIGHT {
            return Ok(None);
        }
        expected *= factor;
        let offsets = p[..last].iter().zip(q).map(|(x, y)| x / p[last] - y / q[last]);
        gap = gap.max(offsets.map(|x| x * x).sum::<f64>().sqrt());
        if gap.is_nan() || gap > margin {
            return Ok(None);
        }
    }
    Ok(Some(gap))
}

/// Weights agree if they differ by less.
const WEIGHT: f64 = 1e-12;
