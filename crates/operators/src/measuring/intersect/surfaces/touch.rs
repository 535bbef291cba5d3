//! Where two surfaces touch: their normals are one line, and they have a point in common.
//!
//! Over the common tangent plane both are graphs, and the difference of their heights has a
//! critical point. Its second derivatives tell how the surfaces touch: in a single point, as two
//! branches that cross, along a curve, or closer than that.

use super::pair::{Knot, Pair, Place};
use super::pivots::solve;
use super::space::{V3, apart, cross, dot, minus, norm, plus, times, unit};
use super::track::Track;

/// How surfaces touch at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    /// In this point alone, as far as second derivatives tell.
    Single,
    /// Two branches cross, in these directions.
    Node([V3; 2]),
    /// Second derivatives vanish along this direction: along a curve, or of higher order.
    Along(V3),
    /// All second derivatives agree: the surfaces coincide, or touch of higher order.
    Flat,
}

/// The system of touching, and what can be followed when it is a curve.
pub(super) struct Tangency<'a> {
    pub pair: &'a Pair<'a>,
    /// Distance up to which surfaces count as having a common point.
    pub reach: f64,
}

/// Pivots below this share of the largest count as nothing.
const RANK: f64 = 1e-6;

/// Second derivatives that differ by less than this share agree.
const AGREE: f64 = 1e-6;

const STEPS: usize = 30;

impl Tangency<'_> {
    /// The place near `start` where the normals are one line: the distance across the tangent
    /// plane vanishes and the tangents of one are normal to the normal of the other. With `plane`
    /// given, in this plane; with `axis`, where that parameter keeps its value.
    pub(super) fn settle(
        &self,
        start: &Place,
        plane: Option<(&V3, &V3)>,
        axis: Option<usize>,
    ) -> Option<Place> {
        let mut x = *start;
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let (mut rows, mut right) = self.rows(&x, plane)?;
            // Columns in units of length, so that pivots compare.
            let sizes = self.sizes(&x);
            for row in &mut rows {
                for k in 0..4 {
                    row[k] = if axis == Some(k) { 0.0 } else { row[k] / sizes[k] };
                }
            }
            let moved = solve(&mut rows, &mut right, RANK);
            let step: Place = std::array::from_fn(|k| moved[k] / sizes[k]);
            let size = moved.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
            x = plus(&x, 1.0, &step);
            if !x.iter().all(|t| (-0.5..=1.5).contains(t)) {
                return None;
            }
            if size < 1e-14 || (size < 1e-7 && size >= 0.5 * last) {
                return Some(x);
            }
            last = size;
        }
        None
    }

    fn sizes(&self, x: &Place) -> Place {
        let [a, b] = self.pair.jets::<false>(x);
        [norm(&a.u), norm(&a.v), norm(&b.u), norm(&b.v)].map(|size| size.max(1e-12))
    }

    /// The equations linearised, and minus their residuals.
    #[allow(clippy::type_complexity, reason = "rows and their right sides")]
    fn rows(&self, x: &Place, plane: Option<(&V3, &V3)>) -> Option<(Vec<[f64; 4]>, Vec<f64>)> {
        let [a, b] = self.pair.jets::<true>(x);
        let normal = cross(&b.u, &b.v);
        let n = unit(&normal)?;
        let share = 1.0 / norm(&normal);
        let by_s = plus(&cross(&b.uu, &b.v), 1.0, &cross(&b.u, &b.uv));
        let by_t = plus(&cross(&b.uv, &b.v), 1.0, &cross(&b.u, &b.vv));
        let gap = minus(&a.p, &b.p);
        let mut rows = Vec::with_capacity(5);
        let mut right = Vec::with_capacity(5);
        for e in frame(&n) {
            rows.push([dot(&a.u, &e), dot(&a.v, &e), -dot(&b.u, &e), -dot(&b.v, &e)]);
            right.push(-dot(&gap, &e));
        }
        for (tangent, by_u, by_v) in [(a.u, a.uu, a.uv), (a.v, a.uv, a.vv)] {
            let scale = share / norm(&tangent).max(1e-12);
            let row = [
                dot(&by_u, &normal),
                dot(&by_v, &normal),
                dot(&tangent, &by_s),
                dot(&tangent, &by_t),
            ];
            rows.push(times(&row, scale));
            right.push(-dot(&tangent, &normal) * scale);
        }
        if let Some((from, along)) = plane {
            rows.push([dot(&a.u, along), dot(&a.v, along), 0.0, 0.0]);
            right.push(-dot(&minus(&a.p, from), along));
        }
        Some((rows, right))
    }

    /// How far apart the surfaces are at a place.
    pub(super) fn gap(&self, x: &Place) -> f64 {
        let [p, q] = self.pair.points(x);
        norm(&minus(&p, &q))
    }

    /// How the surfaces touch at a place where they do.
    pub(super) fn kind(&self, x: &Place) -> Option<Kind> {
        let [a, b] = self.pair.jets::<true>(x);
        let n = b.normal()?;
        let [e, f] = frame(&n);
        let second = |jet: &super::patch::Jet| -> Option<[f64; 3]> {
            let ([p, q], [r, s]) = (jet.split(&e)?, jet.split(&f)?);
            let form = |p: f64, q: f64, r: f64, s: f64| {
                let mixed = times(&jet.uv, p * s + q * r);
                dot(&n, &plus(&plus(&mixed, p * r, &jet.uu), q * s, &jet.vv))
            };
            Some([form(p, q, p, q), form(p, q, r, s), form(r, s, r, s)])
        };
        let (one, other) = (second(&a)?, second(&b)?);
        let [l, m, r] = minus(&one, &other);
        let bend = one.iter().chain(&other).fold(0.1_f64, |most, x| most.max(x.abs()));
        // Eigenvalues and the direction of the first.
        let (mean, half) = (0.5 * (l + r), 0.5 * (l - r));
        let radius = (half * half + m * m).sqrt();
        let (first, last) = if mean >= 0.0 {
            (mean + radius, mean - radius)
        } else {
            (mean - radius, mean + radius)
        };
        if first.abs() <= AGREE * bend {
            return Some(Kind::Flat);
        }
        let angle = 0.5
            * libm::atan2(if mean >= 0.0 { m } else { -m }, if mean >= 0.0 { half } else { -half });
        let turned = |by: f64| plus(&times(&e, libm::cos(angle + by)), libm::sin(angle + by), &f);
        if last.abs() <= AGREE * first.abs().max(bend) * 10.0 {
            return Some(Kind::Along(turned(std::f64::consts::FRAC_PI_2)));
        }
        if first * last > 0.0 {
            return Some(Kind::Single);
        }
        // Where first·cos² + last·sin² vanishes.
        let by = libm::atan(libm::sqrt(-first / last));
        Some(Kind::Node([turned(by), turned(-by)]))
    }

    /// The knot of a curve through a place, whose direction there is known: how it bends is read
    /// off the directions a little before and after.
    pub(super) fn bent(&self, track: &impl Track, x: &Place, dp: &V3) -> Option<Knot> {
        let [a, b] = self.pair.jets::<true>(x);
        let p = std::array::from_fn(|k| f64::midpoint(a.p[k], b.p[k]));
        let ([du, dv], [ds, dt]) = (a.split(dp)?, b.split(dp)?);
        let dx = [du, dv, ds, dt];
        let turn = |by: f64| -> Option<V3> {
            let along = |by: f64| -> Option<V3> {
                let y = track.in_plane(&plus(x, by, &dx), &plus(&p, by, dp), dp)?;
                Some(track.knot(&y, dp)?.dp)
            };
            let difference = minus(&along(by)?, &along(-by)?);
            Some(times(&difference, 0.5 / by))
        };
        let (near, far) = (turn(BY)?, turn(2.0 * BY)?);
        let bend = plus(&times(&near, 4.0 / 3.0), -1.0 / 3.0, &far);
        let ddp = plus(&bend, -dot(&bend, dp), dp);
        let [ddu, ddv] = a.split(&minus(&ddp, &a.bend(du, dv)))?;
        let [dds, ddt] = b.split(&minus(&ddp, &b.bend(ds, dt)))?;
        Some(Knot { x: *x, dx, ddx: [ddu, ddv, dds, ddt], p, dp: *dp, ddp, sine: 0.0 })
    }

    /// The direction in which the surfaces touch along a curve.
    fn along(&self, x: &Place) -> Option<V3> {
        match self.kind(x)? {
            Kind::Along(direction) => Some(direction),
            _ => None,
        }
    }
}

/// How far before and after a place directions are compared.
const BY: f64 = 1e-3;

/// Directions alone, where the curve is known to be one along which surfaces touch.
struct Directions<'a, 'b>(&'a Tangency<'b>);

impl Track for Tangency<'_> {
    fn in_plane(&self, start: &Place, from: &V3, along: &V3) -> Option<Place> {
        let x = self.settle(start, Some((from, along)), None)?;
        (self.gap(&x) <= self.reach && apart(&x, start) < 0.3).then_some(x)
    }

    fn on_line(&self, start: &Place, axis: usize) -> Option<Place> {
        let x = self.settle(start, None, Some(axis))?;
        (self.gap(&x) <= self.reach).then_some(x)
    }

    fn knot(&self, x: &Place, along: &V3) -> Option<Knot> {
        let direction = self.along(x)?;
        let dp = if dot(&direction, along) < 0.0 { times(&direction, -1.0) } else { direction };
        self.bent(&Directions(self), x, &dp)
    }

    fn points(&self, x: &Place) -> [V3; 2] {
        self.pair.points(x)
    }
}

impl Track for Directions<'_, '_> {
    fn in_plane(&self, start: &Place, from: &V3, along: &V3) -> Option<Place> {
        self.0.in_plane(start, from, along)
    }

    fn on_line(&self, start: &Place, axis: usize) -> Option<Place> {
        self.0.on_line(start, axis)
    }

    fn knot(&self, x: &Place, along: &V3) -> Option<Knot> {
        let direction = self.0.along(x)?;
        let dp = if dot(&direction, along) < 0.0 { times(&direction, -1.0) } else { direction };
        Some(Knot { x: *x, dp, ..Knot::default() })
    }

    fn points(&self, x: &Place) -> [V3; 2] {
        self.0.points(x)
    }
}

/// Two unit vectors at right angles to a unit vector and to each other.
fn frame(n: &V3) -> [V3; 2] {
    let least = (0..3).min_by(|&i, &j| n[i].abs().total_cmp(&n[j].abs())).unwrap_or(0);
    let mut axis = [0.0; 3];
    axis[least] = 1.0;
    let e = unit(&plus(&axis, -n[least], n)).unwrap_or(axis);
    [e, cross(n, &e)]
}
