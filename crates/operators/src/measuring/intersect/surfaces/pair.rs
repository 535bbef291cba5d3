//! Two pieces seen together: where a pair of points is, how the surfaces cross there, and Newton's steps.
//!
//! A place `x = (u, v, s, t)` names a point of each surface. Where the points coincide and the
//! normals are not parallel the intersection is a curve, with a tangent and a curvature.

use super::patch::{Jet, Patch};
use super::space::{V3, apart, cross, dot, minus, norm, plus, solve, times, unit};

/// Parameters on the first and the second surface.
pub(super) type Place = [f64; 4];

/// Two pieces in common units.
pub(super) struct Pair<'a> {
    pub a: &'a Patch,
    pub b: &'a Patch,
}

/// A point of the intersection with its derivatives by arc length, in space and of all parameters.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Knot {
    pub x: Place,
    pub dx: Place,
    pub ddx: Place,
    pub p: V3,
    pub dp: V3,
    pub ddp: V3,
    /// The sine of the angle between the surfaces.
    pub sine: f64,
}

/// Newton's steps for one answer: they double the digits.
const STEPS: usize = 12;

/// A residual that is rounding alone, in units of the size of the pieces.
pub(super) const ROUNDING: f64 = 4e-15;

/// Newton's steps are not followed outside the window by more than this.
const OUTSIDE: f64 = 0.5;

impl Pair<'_> {
    pub(super) fn jets<const SECOND: bool>(&self, x: &Place) -> [Jet; 2] {
        [self.a.jet::<SECOND>(x[0], x[1]), self.b.jet::<SECOND>(x[2], x[3])]
    }

    /// The nearest common point of the surfaces with `(P − from)·along = 0`: the common point of
    /// both tangent planes and that plane, again and again.
    pub(super) fn in_plane(&self, start: &Place, from: &V3, along: &V3) -> Option<Place> {
        let mut x = *start;
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let [a, b] = self.jets::<false>(&x);
            let (m, n) = (unit(&cross(&a.u, &a.v))?, unit(&cross(&b.u, &b.v))?);
            let offset = minus(&b.p, &a.p);
            let level = -dot(along, &minus(&a.p, from));
            // Relative to the point of the first surface.
            let to = reciprocal(&[m, n, *along], &[0.0, dot(&n, &offset), level])?;
            let step = [a.split(&to), b.split(&minus(&to, &offset))];
            let [Some([du, dv]), Some([ds, dt])] = step else { return None };
            let (next, moved) = advanced(&x, &[du, dv, ds, dt])?;
            x = next;
            let far = norm(&to) + norm(&offset);
            if moved == 0.0 || far <= ROUNDING || (far < 1e-9 && far >= 0.5 * last) {
                return Some(x);
            }
            last = far;
        }
        None
    }

    /// The common point near `start` where parameter `axis` keeps its value.
    pub(super) fn on_line(&self, start: &Place, axis: usize) -> Option<Place> {
        let mut x = *start;
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let [a, b] = self.jets::<false>(&x);
            let gap = minus(&b.p, &a.p);
            let columns = [a.u, a.v, times(&b.u, -1.0), times(&b.v, -1.0)];
            let others: [usize; 3] = std::array::from_fn(|k| k + usize::from(k >= axis));
            let [i, j, k] = others;
            let found = solve(&columns[i], &columns[j], &columns[k], &gap)?;
            let mut step = [0.0; 4];
            others.iter().zip(found).for_each(|(k, d)| step[*k] = d);
            let (next, moved) = advanced(&x, &step)?;
            x = next;
            let size = step.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
            if moved == 0.0 || size <= ROUNDING || (size < 1e-9 && size >= 0.5 * last) {
                let [a, b] = self.jets::<false>(&x);
                return (apart(&a.p, &b.p) < 1e-11).then_some(x);
            }
            last = size;
        }
        None
    }

    /// What the intersection is at a place on it, run along the product of the normals, or against
    /// it; nothing where the surfaces touch.
    pub(super) fn knot(&self, x: &Place, sign: f64) -> Option<Knot> {
        let [a, b] = self.jets::<true>(x);
        let (m, n) = (unit(&cross(&a.u, &a.v))?, unit(&cross(&b.u, &b.v))?);
        let across = cross(&m, &n);
        let sine = norm(&across);
        let dp = times(&unit(&across)?, sign);
        let ([du, dv], [ds, dt]) = (a.split(&dp)?, b.split(&dp)?);
        let (bend_a, bend_b) = (a.bend(du, dv), b.bend(ds, dt));
        let ddp = reciprocal(&[m, n, dp], &[dot(&m, &bend_a), dot(&n, &bend_b), 0.0])?;
        let [ddu, ddv] = a.split(&minus(&ddp, &bend_a))?;
        let [dds, ddt] = b.split(&minus(&ddp, &bend_b))?;
        let p = std::array::from_fn(|k| f64::midpoint(a.p[k], b.p[k]));
        let (dx, ddx) = ([du, dv, ds, dt], [ddu, ddv, dds, ddt]);
        let all = dx.iter().chain(&ddx).chain(&ddp);
        all.clone().all(|z| z.is_finite()).then_some(Knot { x: *x, dx, ddx, p, dp, ddp, sine })
    }
}

impl Jet {
    /// Factors of the two tangents that give a vector's part in the tangent plane.
    pub(super) fn split(&self, vector: &V3) -> Option<[f64; 2]> {
        let normal = cross(&self.u, &self.v);
        let square = dot(&normal, &normal);
        let factors = [
            dot(&cross(vector, &self.v), &normal) / square,
            dot(&cross(&self.u, vector), &normal) / square,
        ];
        factors.iter().all(|x| x.is_finite()).then_some(factors)
    }

    /// The second derivative of a line on the surface whose parameters move evenly.
    pub(super) fn bend(&self, du: f64, dv: f64) -> V3 {
        plus(&plus(&times(&self.uu, du * du), 2.0 * du * dv, &self.uv), dv * dv, &self.vv)
    }

    /// The unit normal.
    pub(super) fn normal(&self) -> Option<V3> {
        unit(&cross(&self.u, &self.v))
    }
}

/// The vector with these products with three others.
fn reciprocal(rows: &[V3; 3], products: &[f64; 3]) -> Option<V3> {
    let [a, b, c] = rows;
    let (bc, ca, ab) = (cross(b, c), cross(c, a), cross(a, b));
    let determinant = dot(a, &bc);
    let sum = plus(&plus(&times(&bc, products[0]), products[1], &ca), products[2], &ab);
    let found = times(&sum, 1.0 / determinant);
    found.iter().all(|x| x.is_finite()).then_some(found)
}

/// A place after a step, and how far it moved; nothing when that leads far outside.
fn advanced(x: &Place, step: &Place) -> Option<(Place, f64)> {
    let next = plus(x, 1.0, step);
    let inside = next.iter().all(|t| (-OUTSIDE..=1.0 + OUTSIDE).contains(t));
    inside.then(|| (next, apart(&next, x)))
}
