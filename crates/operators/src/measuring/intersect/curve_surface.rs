//! Where a curve meets a surface.
//!
//! Crossings come from the system of equations, each proved. What that leaves undecided is looked at by
//! the distance of the curve from the surface: it is small over an arc that lies in the surface, and
//! such an arc ends only at the end of a window, for what is analytic leaves a surface at a point or
//! not at all; elsewhere it is small around a point where they touch.

use pforms_kernel::{Error, Form, Result};

use super::answer::{Contact, ContactKind, Intersections, Overlap, Undecided, sort};
use crate::measuring::project::{Weights, descend, positive_weights};
use crate::measuring::scale::{in_units, unit};
use crate::measuring::system::{Cluster, Equations, Limits, Root, Solutions, solve};
use crate::measuring::vector::{cross, norm};

/// On the windows from 0 to 1.
pub(super) fn curve_surface(curve: &Form, surface: &Form, accuracy: f64) -> Result<Intersections> {
    if curve.ambient() < 3 {
        let received = format!("a surface in dimension {}", curve.ambient());
        return Err(Error::shape("second", received, "dimension 3 or more"));
    }
    let unit = unit([curve, surface]);
    let (curve, surface) = (in_units(curve, unit)?, in_units(surface, unit)?);
    let (ours, theirs) = (positive_weights(&curve)?, positive_weights(&surface)?);
    let size = extent(&ours).max(extent(&theirs));
    let mut found = Intersections { complete: true, ..Intersections::default() };
    let near = accuracy * size;
    let apart = |k: usize| (ours.lower[k] - theirs.upper[k]).max(theirs.lower[k] - ours.upper[k]);
    if (0..curve.ambient()).any(|k| apart(k) > near + ROUNDINGS * (size + ours.upper[k].abs())) {
        return Ok(found);
    }
    let mut equations = Equations::meeting(&curve, &surface)?;
    if curve.ambient() > 3 {
        let heaviest = ours.largest * theirs.largest;
        equations = equations.with_tolerance((near + ROUNDINGS * size) * heaviest);
    }
    let limits = Limits { most: MOST, ..Limits::default() };
    let Solutions { roots, clusters, .. } = solve(&equations, &limits);
    let away = ours.upper.iter().chain(&ours.lower).fold(0.0_f64, |most, x| most.max(x.abs()));
    let noise = ROUNDINGS * (size + away);
    let pair = Pair { curve, surface, unit, noise, reach: near.max(noise), accuracy };
    for cluster in &clusters {
        Beside { pair: &pair, cluster }.explain(&mut found)?;
    }
    for root in roots {
        let within = |overlap: &Overlap| {
            let (from, to) = (overlap.first[0][0], overlap.first[1][0]);
            (from - WITHIN..=to + WITHIN).contains(&root.parameters[0])
        };
        if !found.overlaps.iter().any(within) {
            found.contacts.push(pair.crossing(&root)?);
        }
    }
    sort(&mut found.contacts);
    Ok(found)
}

/// Cells looked at, at most.
const MOST: usize = 1 << 12;

/// What rounding does to a distance, in sizes of the forms.
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;

/// So near to an end of an overlap a crossing is a part of it.
const WITHIN: f64 = 1e-9;

/// Shorter arcs count as points.
const SHORT: f64 = 1e-6;

fn extent(weights: &Weights) -> f64 {
    let sides = weights.lower.iter().zip(&weights.upper).map(|(a, b)| b - a);
    sides.fold(0.0_f64, f64::hypot)
}

/// A curve and a surface, in units of their size.
struct Pair {
    curve: Form,
    surface: Form,
    unit: f64,
    /// What rounding does to a distance.
    noise: f64,
    /// Nearer than this they are taken to meet.
    reach: f64,
    accuracy: f64,
}

impl Pair {
    fn crossing(&self, root: &Root) -> Result<Contact> {
        let (first, second) = root.parameters.split_at(1);
        let (p, q) = (self.curve.at(first)?, self.surface.at(second)?);
        let proved = self.curve.ambient() == 3;
        // With more equations than unknowns rounding leaves no solution to prove.
        let gap = if proved { 0.0 } else { distance(&p, &q) * self.unit };
        let kind =
            if gap > self.noise * self.unit { ContactKind::Touch } else { ContactKind::Crossing };
        Ok(Contact {
            first: first.to_vec(),
            second: second.to_vec(),
            point: p.iter().map(|x| x * self.unit).collect(),
            kind,
            order: 1,
            gap,
            error: root.radius,
            proved,
        })
    }
}

fn distance(p: &[f64], q: &[f64]) -> f64 {
    let offset: Vec<f64> = p.iter().zip(q).map(|(x, y)| x - y).collect();
    norm(&offset)
}

/// The curve seen from the part of the surface that a cluster holds.
struct Beside<'a> {
    pair: &'a Pair,
    cluster: &'a Cluster,
}

impl Beside<'_> {
    /// The distance of a point of the curve from the surface, and its foot: by descent from the cell
    /// beside it.
    fn foot(&self, t: f64) -> Result<(f64, Vec<f64>)> {
        let point = self.pair.curve.at(&[t])?;
        let off = |cell: &(Vec<f64>, Vec<f64>)| (cell.0[0] - t).max(t - cell.1[0]).max(0.0);
        let beside = self.cluster.cells.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        let middle = beside.map(|(low, high)| -> Vec<f64> {
            low[1..].iter().zip(&high[1..]).map(|(a, b)| f64::midpoint(*a, *b)).collect()
        });
        let least = descend(&self.pair.surface, &point, &self.cluster.parameters[1..]);
        let other = middle.map(|from| descend(&self.pair.surface, &point, &from));
        Ok(other.filter(|other| other.0 < least.0).unwrap_or(least))
    }

    fn meets(&self, t: f64) -> Result<bool> {
        Ok(self.foot(t)?.0 <= self.pair.reach)
    }

    /// Adds what a cluster is: an arc, a point where they touch, or a doubt.
    fn explain(&self, found: &mut Intersections) -> Result<()> {
        let cluster = self.cluster;
        let (low, high) = (cluster.lower[0], cluster.upper[0]);
        let Some(inside) = self.inside()? else {
            // Nowhere near on a sound sample of it, but not shown to be so.
            leave(cluster, found);
            return Ok(());
        };
        let from = self.end(inside, low, (low - 0.5 * (high - low)).max(0.0))?;
        let to = self.end(inside, high, (high + 0.5 * (high - low)).min(1.0))?;
        let (start, end) = (self.foot(from)?, self.foot(to)?);
        if to - from > SHORT && at_border(from, &start.1) && at_border(to, &end.1) {
            let samples =
                (0..=32).map(|i| Ok(self.foot(from + (to - from) * f64::from(i) / 32.0)?.0));
            let gap = samples.collect::<Result<Vec<f64>>>()?.into_iter().fold(0.0, f64::max);
            if gap <= self.pair.reach {
                found.overlaps.push(Overlap {
                    first: [vec![from], vec![to]],
                    second: [start.1, end.1],
                    gap: gap * self.pair.unit,
                    proved: false,
                });
                // The rest of the cluster is decided if it is no more than its cells are wide.
                let slack = widest(cluster);
                if low < from - slack || high > to + slack {
                    leave(cluster, found);
                }
                return Ok(());
            }
        }
        let contact = self.contact(f64::midpoint(from, to), to - from)?;
        if cluster.unfinished || self.pair.accuracy == 0.0 {
            leave(cluster, found);
        }
        // Two cells of one place may have stayed apart.
        let known = |other: &Contact| {
            (other.first[0] - contact.first[0]).abs()
                <= other.error.min(SHORT) + contact.error.min(SHORT)
                && distance(&other.point, &contact.point) <= 4.0 * self.pair.reach * self.pair.unit
        };
        if !found.contacts.iter().any(known) {
            found.contacts.push(contact);
        }
        Ok(())
    }

    /// A parameter in the cluster where the curve is on the surface.
    fn inside(&self) -> Result<Option<f64>> {
        let cluster = self.cluster;
        let middle = cluster.cells.len() / 2;
        let of_cell = |(low, high): &(Vec<f64>, Vec<f64>)| f64::midpoint(low[0], high[0]);
        let tried = [cluster.parameters[0], of_cell(&cluster.cells[middle])];
        let tried = tried.into_iter().chain(cluster.cells.iter().take(16).map(of_cell));
        for t in tried {
            if self.meets(t)? {
                return Ok(Some(t));
            }
        }
        Ok(None)
    }

    /// How far the curve stays on the surface, from a place inside, to one that may be outside.
    fn end(&self, inside: f64, edge: f64, beyond: f64) -> Result<f64> {
        for t in [beyond, edge] {
            if (t == 0.0 || t == 1.0) && self.meets(t)? && self.meets(f64::midpoint(t, inside))? {
                return Ok(t);
            }
        }
        let (mut on, mut off) = (inside, beyond);
        if self.meets(off)? {
            return Ok(off);
        }
        for _ in 0..60 {
            let middle = f64::midpoint(on, off);
            if middle == on || middle == off {
                break;
            }
            if self.meets(middle)? { on = middle } else { off = middle }
        }
        Ok(on)
    }

    /// The place where they touch: `width` is as far as they stay together.
    fn contact(&self, middle: f64, width: f64) -> Result<Contact> {
        let cluster = self.cluster;
        let order = self.order(middle, width)?;
        let t = if order == 2 && self.pair.curve.ambient() == 3 {
            self.level(middle, width)?
        } else {
            middle
        };
        let (gap, second) = self.foot(t)?;
        let sides: Vec<f64> =
            cluster.lower.iter().zip(&cluster.upper).map(|(a, b)| b - a).collect();
        let slack = sides.iter().fold(width, |most, side| most.max(*side));
        let kind = match order {
            1 => ContactKind::Crossing,
            _ if gap <= self.pair.noise => ContactKind::Tangent,
            _ => ContactKind::Touch,
        };
        let point = self.pair.curve.at(&[t])?.iter().map(|x| x * self.pair.unit).collect();
        Ok(Contact {
            first: vec![t],
            second,
            point,
            kind,
            order,
            gap: gap * self.pair.unit,
            error: slack,
            proved: false,
        })
    }

    /// By which power the distance grows, from its growth when the way is doubled; 0 if by none.
    fn order(&self, t: f64, width: f64) -> Result<usize> {
        let step = (16.0 * width).clamp(1e-9, 0.05);
        let (mut powers, mut at_edge) = (Vec::new(), Vec::new());
        for side in [-1.0, 1.0] {
            let (near, far) = (t + side * step, t + 2.0 * side * step);
            if (0.0..=1.0).contains(&far) {
                let (d, (e, foot)) = (self.foot(near)?.0, self.foot(far)?);
                // Beside the border of the surface the distance is that from the border.
                let powers = if at_border(0.5, &foot) { &mut at_edge } else { &mut powers };
                powers.push(libm::log2(e / d));
            }
        }
        let powers = if powers.is_empty() { at_edge } else { powers };
        let mean = powers.iter().sum::<f64>() / powers.len().max(1) as f64;
        let whole = mean.round();
        let sure = (mean - whole).abs() < 0.25 && (1.0..=20.0).contains(&whole);
        Ok(if sure { whole as usize } else { 0 })
    }

    /// Where the curve runs along the surface, near `t`: there the distance has a double zero.
    fn level(&self, t: f64, width: f64) -> Result<f64> {
        let step = (8.0 * width).max(1e-6);
        let (low, high) = ((t - step).max(0.0), (t + step).min(1.0));
        let (mut a, mut b) = (low, high);
        let (mut climb, mut other) = (self.climb(a)?, self.climb(b)?);
        let mut best = t;
        for _ in 0..20 {
            if climb == other {
                break;
            }
            let next = b - other * (b - a) / (other - climb);
            if !(low..=high).contains(&next) {
                break;
            }
            best = next;
            if (next - b).abs() <= f64::EPSILON {
                break;
            }
            (a, climb) = (b, other);
            (b, other) = (next, self.climb(next)?);
        }
        Ok(best)
    }

    /// The speed of the curve across the surface at the foot of one of its points.
    fn climb(&self, t: f64) -> Result<f64> {
        let (_, foot) = self.foot(t)?;
        let along = tangents(&self.pair.surface, &foot)?;
        let velocity = tangents(&self.pair.curve, &[t])?.remove(0);
        let normal = cross(&along[0], &along[1]);
        let size = norm(&normal);
        let dot: f64 = normal.iter().zip(&velocity).map(|(x, y)| x * y).sum();
        Ok(if size > 0.0 { dot / size } else { 0.0 })
    }
}

/// Says that a cluster is not decided.
fn leave(cluster: &Cluster, found: &mut Intersections) {
    let part = |corner: &[f64], range: std::ops::Range<usize>| corner[range].to_vec();
    found.complete = false;
    found.undecided.push(Undecided {
        first: [part(&cluster.lower, 0..1), part(&cluster.upper, 0..1)],
        second: [part(&cluster.lower, 1..3), part(&cluster.upper, 1..3)],
    });
}

/// The derivatives of a form, one for each axis.
fn tangents(form: &Form, at: &[f64]) -> Result<Vec<Vec<f64>>> {
    let along = |axis: usize| {
        let orders: Vec<usize> = (0..form.axes()).map(|k| usize::from(k == axis)).collect();
        form.derivative_at(at, &orders)
    };
    (0..form.axes()).map(along).collect()
}

/// Is it the end of a window, that of the curve or that of the surface?
fn at_border(t: f64, foot: &[f64]) -> bool {
    let end = |t: f64, slack: f64| t <= slack || t >= 1.0 - slack;
    end(t, 0.0) || foot.iter().any(|t| end(*t, 1e-9))
}

/// The longest side of a cell, along the curve.
fn widest(cluster: &Cluster) -> f64 {
    cluster.cells.iter().fold(0.0, |most, (low, high)| most.max(high[0] - low[0]))
}
