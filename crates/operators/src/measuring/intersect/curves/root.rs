//! A crossing, found by Newton's steps and proved by Krawczyk's test.
//!
//! The equations are `X_A·W_B = X_B·W_A` and the same in `Y`. With `Y` the inverse of their
//! derivative at the place found, and `L` a bound of second derivatives, the map `x − Y·F(x)` takes
//! the square of half side `r` into itself if `‖Y‖·|F| + ‖Y‖·4·L·r² ≤ r`: then it holds one
//! solution (Krawczyk 1969). All roundings are counted in `|F|`.

use super::part::Part;

/// A crossing: its parameters, and how far these may be off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Root {
    pub s: f64,
    pub t: f64,
    pub error: f64,
}

/// Bounds of a curve's homogeneous coordinates and their derivatives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    /// Of the coordinates: values, first and second derivatives.
    point: [f64; 3],
    /// Of the weight: the same.
    weight: [f64; 3],
    degree: f64,
}

impl Bounds {
    pub(super) fn new<const D: usize, const N: usize>(part: &Part<D, N>) -> Self {
        let degree = (part.order - 1) as f64;
        let of = |k: usize| {
            let x = |i: usize| part.poles[i][k];
            let most = |count: usize, value: &dyn Fn(usize) -> f64| {
                (0..count).fold(0.0_f64, |most, i| most.max(value(i).abs()))
            };
            let first = most(part.order - 1, &|i| x(i + 1) - x(i));
            let second = if part.order > 2 {
                most(part.order - 2, &|i| x(i + 2) - 2.0 * x(i + 1) + x(i))
            } else {
                0.0
            };
            let u = f64::EPSILON;
            [
                most(part.order, &x),
                degree * (first + u),
                degree * (degree - 1.0) * (second + 2.0 * u),
            ]
        };
        let (x, y) = (of(0), of(1));
        let point = [x[0].max(y[0]), x[1].max(y[1]), x[2].max(y[2])];
        let weight = if D == 3 { of(2) } else { [1.0, 0.0, 0.0] };
        Self { point, weight, degree }
    }

    /// A bound of the second derivative of the curve as points, for weights at least `least`.
    pub(super) fn bend(&self, least: f64) -> f64 {
        let [x, dx, ddx] = self.point;
        let [_, dw, ddw] = self.weight;
        let reach = x / least;
        (ddx + reach * ddw) / least + 2.0 * dw * (dx + reach * dw) / (least * least)
    }
}

/// Value and derivative of the homogeneous coordinates.
fn jet<const D: usize, const N: usize>(part: &Part<D, N>, t: f64) -> ([f64; 3], [f64; 3]) {
    let last = part.order - 1;
    let mut p = part.poles;
    let rest = 1.0 - t;
    for step in 1..last {
        for i in 0..=last - step {
            let next = p[i + 1];
            for (x, y) in p[i].iter_mut().zip(next) {
                *x = rest * *x + t * y;
            }
        }
    }
    let (mut value, mut slope) = ([0.0, 0.0, 1.0], [0.0; 3]);
    for k in 0..D {
        if last == 0 {
            value[k] = p[0][k];
        } else {
            value[k] = rest * p[0][k] + t * p[1][k];
            slope[k] = last as f64 * (p[1][k] - p[0][k]);
        }
    }
    (value, slope)
}

/// The equations and their derivatives.
struct System {
    f: [f64; 2],
    by_s: [f64; 2],
    by_t: [f64; 2],
}

fn system<const D: usize, const N: usize>(
    a: &Part<D, N>,
    b: &Part<D, N>,
    s: f64,
    t: f64,
) -> System {
    let ((p, dp), (q, dq)) = (jet(a, s), jet(b, t));
    let f = |k: usize| p[k] * q[2] - q[k] * p[2];
    let by_s = |k: usize| dp[k] * q[2] - q[k] * dp[2];
    let by_t = |k: usize| p[k] * dq[2] - dq[k] * p[2];
    System { f: [f(0), f(1)], by_s: [by_s(0), by_s(1)], by_t: [by_t(0), by_t(1)] }
}

/// Newton's steps at most.
const STEPS: usize = 12;

/// The root that Newton's steps from a place lead to, with its proof; none if they lead farther away
/// than `reach`, or the proof fails.
pub(super) fn root<const D: usize, const N: usize>(
    a: &Part<D, N>,
    b: &Part<D, N>,
    bounds: &[Bounds; 2],
    start: [f64; 2],
    reach: [f64; 2],
) -> Option<Root> {
    let [mut s, mut t] = start;
    let mut before = f64::INFINITY;
    for _ in 0..STEPS {
        let System { f, by_s, by_t } = system(a, b, s, t);
        let det = by_s[0] * by_t[1] - by_s[1] * by_t[0];
        let ds = (f[1] * by_t[0] - f[0] * by_t[1]) / det;
        let dt = (f[0] * by_s[1] - f[1] * by_s[0]) / det;
        let step = ds.abs().max(dt.abs());
        if !step.is_finite() {
            return None;
        }
        s += ds;
        t += dt;
        if (s - start[0]).abs() > reach[0] || (t - start[1]).abs() > reach[1] {
            return None;
        }
        if step < 1e-9 || (step < 1e-6 && step >= 0.5 * before) {
            // One more would not change what can be proved: it has converged twice over.
            break;
        }
        before = step;
    }
    proved(a, b, bounds, s, t)
}

fn proved<const D: usize, const N: usize>(
    a: &Part<D, N>,
    b: &Part<D, N>,
    bounds: &[Bounds; 2],
    s: f64,
    t: f64,
) -> Option<Root> {
    let System { f, by_s, by_t } = system(a, b, s, t);
    let det = by_s[0] * by_t[1] - by_s[1] * by_t[0];
    let rows = [by_t[1].abs() + by_t[0].abs(), by_s[1].abs() + by_s[0].abs()];
    let inverse = rows[0].max(rows[1]) / det.abs();
    let [p, q] = bounds;
    let norm = (by_s[0].abs() + by_t[0].abs()).max(by_s[1].abs() + by_t[1].abs());
    // The inverse is off by some roundings times its condition: below a quarter here.
    let most = p.point[1] * q.weight[0] + q.point[0] * p.weight[1] + q.point[1] + p.point[1] + norm;
    let condition = inverse * most * (p.degree + q.degree + 4.0);
    if condition.is_nan() || condition >= 1e12 {
        return None;
    }
    let roundings = f64::EPSILON * 2.0 * (p.degree + q.degree + 4.0);
    let rounding = roundings * (p.point[0] * q.weight[0] + q.point[0] * p.weight[0]);
    let size = f[0].abs().max(f[1].abs()) + rounding;
    let second = [
        p.point[2] * q.weight[0] + q.point[0] * p.weight[2],
        p.point[1] * q.weight[1] + q.point[1] * p.weight[1],
        p.point[0] * q.weight[2] + q.point[2] * p.weight[0],
    ];
    let bend = second.iter().fold(0.0_f64, |most, x| most.max(*x));
    let r = 2.5 * inverse * size + f64::EPSILON;
    (inverse * 4.0 * bend * r <= 0.25).then_some(Root { s, t, error: r })
}
