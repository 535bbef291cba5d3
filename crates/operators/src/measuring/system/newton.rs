//! The one solution that a cell can hold: found, and proved.

use super::cell::{Cell, largest_step};
use super::combined::{Combined, MARGIN};
use super::linear::left_inverse;
use super::{Each, Equations, MOST_UNKNOWNS, Root};

/// What is shown of a cell over which `u − G(u)` contracts.
pub(super) enum Proof {
    /// It holds this solution and no other.
    Root(Root),
    /// It holds none.
    None,
    /// Nothing yet.
    Open,
}

/// Newton's steps at most: they double the digits, from a cell in which the map contracts.
const STEPS: usize = 12;

/// Cells narrower than this are not proved in: their corners are known no better.
const NARROWEST: f64 = 1e-11;

/// Finds the place where the combined equations vanish and shows that they do.
///
/// By Banach's theorem a map that contracts by `q` on a ball around `r` of radius
/// `|G(r)| / (1 − q)` has its fixed point in there.
pub(super) fn prove(equations: &Equations, cell: &Cell, combined: &Combined, border: f64) -> Proof {
    let axes = equations.axes();
    if (0..axes).any(|axis| cell.side(axis) < NARROWEST) {
        return Proof::Open;
    }
    let shrinking = combined.contraction();
    let mut at = [0.0; MOST_UNKNOWNS];
    for (t, (a, b)) in at.iter_mut().zip(cell.lower.iter().zip(&cell.upper)) {
        *t = f64::midpoint(*a, *b);
    }
    let mut inverse = Vec::new();
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let (values, slopes) = equations.jet(&at);
        left_inverse(&slopes, axes, &mut inverse);
        let step = product(&inverse, &values, axes);
        let size = (0..axes).map(|k| step[k].abs() / cell.side(k)).fold(0.0, f64::max);
        if size.is_nan() || size > 2.0 {
            return Proof::Open;
        }
        if size >= last && size < 1e-8 {
            break;
        }
        (0..axes).for_each(|k| at[k] -= step[k]);
        last = size;
    }
    let Some(radius) = ball(equations, cell, combined, &at, shrinking) else { return Proof::Open };
    let local = |k: usize| (at[k] - cell.lower[k]) / cell.side(k);
    let outside = |k: usize| (-local(k)).max(local(k) - 1.0);
    let within = |k: usize| outside(k) + radius <= MARGIN;
    if !(0..axes).all(within) {
        return Proof::Open;
    }
    // Corners are known to a few roundings of the window, and its border is not a hard one.
    let slack = |k: usize| {
        let [low, high] = cell.reach(k);
        radius + 64.0 * f64::EPSILON / cell.side(k) + low.max(high)
    };
    if (0..axes).any(|k| outside(k) > slack(k)) {
        return Proof::None;
    }
    finished(equations, cell, &at, radius, border)
}

/// The root, if it is in the window and all equations vanish there.
fn finished(equations: &Equations, cell: &Cell, at: &Each, radius: f64, border: f64) -> Proof {
    let axes = equations.axes();
    let widest = cell.width() * radius;
    let beyond = |t: &f64| (-t).max(t - 1.0);
    if at[..axes].iter().any(|t| beyond(t) > border + widest) {
        return Proof::None;
    }
    let mut inside = *at;
    inside[..axes].iter_mut().for_each(|t| *t = onto_border(*t));
    if equations.number() > axes && !solves(equations, cell, &equations.jet(at).0, radius) {
        return Proof::None;
    }
    Proof::Root(Root { parameters: inside[..axes].to_vec(), radius: widest })
}

/// A parameter that is a rounding or two from an end of the window is that end.
fn onto_border(t: f64) -> f64 {
    let near = 2.0 * f64::EPSILON;
    if t < near {
        0.0
    } else if t > 1.0 - near {
        1.0
    } else {
        t
    }
}

/// Do all equations vanish within what is known: the ball, the noise, the tolerance?
fn solves(equations: &Equations, cell: &Cell, values: &[f64], radius: f64) -> bool {
    cell.each().enumerate().all(|(i, coefficients)| {
        let steps = (0..equations.axes()).map(|axis| {
            let degree = (equations.orders()[axis] - 1) as f64;
            degree * largest_step(coefficients, equations.orders(), axis)
        });
        let slack =
            equations.noise_of_values(i) + equations.tolerance()[i] + radius * steps.sum::<f64>();
        values[i].abs() <= slack
    })
}

/// The radius of a ball around `at` that holds the fixed point, in units of the cell.
fn ball(
    equations: &Equations,
    cell: &Cell,
    combined: &Combined,
    at: &Each,
    shrinking: f64,
) -> Option<f64> {
    let axes = equations.axes();
    let number = equations.number();
    let (values, _) = equations.jet(at);
    let mut most = 0.0_f64;
    for row in combined.matrix.chunks_exact(number) {
        let value: f64 = row.iter().zip(&values).map(|(m, x)| m * x).sum();
        let noise = row.iter().enumerate().map(|(i, m)| {
            m.abs()
                * (equations.noise_of_values(i) + f64::EPSILON * number as f64 * values[i].abs())
        });
        most = most.max(value.abs() + noise.sum::<f64>());
    }
    let local = (0..axes).map(|k| 4.0 * f64::EPSILON / cell.side(k)).fold(0.0, f64::max);
    let radius = most / (1.0 - shrinking) + local;
    (shrinking < 1.0 && radius.is_finite()).then_some(radius)
}

fn product(inverse: &[f64], values: &[f64], axes: usize) -> Each {
    let mut step = [0.0; MOST_UNKNOWNS];
    for (k, row) in inverse.chunks_exact(values.len()).take(axes).enumerate() {
        step[k] = row.iter().zip(values).map(|(m, x)| m * x).sum();
    }
    step
}

/// Steps of a descent in a cluster.
const DESCENT: usize = 30;

/// The place in a box where the equations are least, as far as damped steps find it; and their values.
pub(super) fn least(equations: &Equations, lower: &[f64], upper: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let axes = equations.axes();
    let mut at = [0.0; MOST_UNKNOWNS];
    (0..axes).for_each(|k| at[k] = f64::midpoint(lower[k], upper[k]));
    let size = |values: &[f64]| values.iter().map(|x| x * x).sum::<f64>();
    let (mut values, mut slopes) = equations.jet(&at);
    let mut inverse = Vec::new();
    for _ in 0..DESCENT {
        left_inverse(&slopes, axes, &mut inverse);
        let step = product(&inverse, &values, axes);
        let mut factor = 1.0;
        let next = (0..8).find_map(|_| {
            let mut next = at;
            (0..axes).for_each(|k| next[k] = (at[k] - factor * step[k]).clamp(lower[k], upper[k]));
            factor *= 0.5;
            let jet = equations.jet(&next);
            (size(&jet.0) < size(&values)).then_some((next, jet))
        });
        let Some((next, jet)) = next else { break };
        at = next;
        (values, slopes) = jet;
    }
    (at[..axes].to_vec(), values)
}
