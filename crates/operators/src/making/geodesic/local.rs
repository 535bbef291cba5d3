//! What a surface is like beside a collapsed edge, at one place.

use super::metric::Net;
use super::spokes::Polar;
use crate::measuring::vector::{dot, norm};

/// Tangents, and second derivatives without their tangential parts.
pub(super) struct Local {
    ambient: usize,
    /// `Y_u` and `f_v`; then, for `u′ = w/v`, the normal parts of `Y_uu/v`, `Y_uv`, `f_vv`.
    rows: Vec<f64>,
    /// The projections of the tangents, as columns.
    pub projected: [[f64; 2]; 2],
    /// `Y_u·Y_u`, `Y_u·f_v`, `f_v·f_v`.
    first: [f64; 3],
}

impl Local {
    /// `offsets` are those of a member, `Y` as a rational form.
    pub(super) fn new(offsets: &Net, basis: &[Vec<f64>; 2], at: Polar) -> Self {
        let ambient = offsets.ambient;
        let mut rows = vec![0.0; 5 * ambient];
        let mut k = 0;
        let (v, inverse) = (at.v, if at.v == 0.0 { 0.0 } else { 1.0 / at.v });
        offsets.each([at.u, at.v], &mut |[y, yu, yv, yuu, yuv, yvv]| {
            let here = [yu, y + v * yv, yuu * inverse, yuv, yv + yv + v * yvv];
            for (row, x) in here.into_iter().enumerate() {
                rows[row * ambient + k] = x;
            }
            k += 1;
        });
        let (tangents, bends) = rows.split_at_mut(2 * ambient);
        let (t, s) = tangents.split_at(ambient);
        let project = |x: &[f64]| [dot(x, &basis[0]), dot(x, &basis[1])];
        let projected = [project(t), project(s)];
        let first = [dot(t, t), dot(t, s), dot(s, s)];
        normal_parts(t, s, bends);
        Self { ambient, rows, projected, first }
    }

    fn row(&self, k: usize) -> &[f64] {
        &self.rows[k * self.ambient..(k + 1) * self.ambient]
    }

    /// The area that the tangents span, squared.
    pub(super) fn area(&self) -> f64 {
        let [e, f, g] = self.first;
        e * g - f * f
    }

    /// The product of two directions that are given along the tangents.
    pub(super) fn product(&self, a: [f64; 2], b: [f64; 2]) -> f64 {
        let [e, f, g] = self.first;
        e * a[0] * b[0] + f * (a[0] * b[1] + a[1] * b[0]) + g * a[1] * b[1]
    }

    /// How a course bends over the tangent plane.
    pub(super) fn bend(&self, basis: &[Vec<f64>; 2], w: f64, speed: f64) -> [f64; 2] {
        let factors = [w * w, 2.0 * w * speed, speed * speed];
        [0, 1].map(|axis: usize| {
            (0..3).map(|k| factors[k] * dot(self.row(2 + k), &basis[axis])).sum()
        })
    }

    /// A direction in space.
    pub(super) fn direction(&self, w: f64, speed: f64) -> Vec<f64> {
        self.row(0).iter().zip(self.row(1)).map(|(t, s)| w * t + speed * s).collect()
    }

    /// The Gauss curvature.
    pub(super) fn curvature(&self) -> f64 {
        let [uu, uv, vv] = [2, 3, 4].map(|k| self.row(k));
        (dot(uu, vv) - dot(uv, uv)) / self.area()
    }
}

/// Takes the parts along two tangents away: twice, since what the first time leaves of a large part is rounding.
fn normal_parts(t: &[f64], s: &[f64], bends: &mut [f64]) {
    let length = norm(s);
    let first: Vec<f64> = s.iter().map(|x| x / length).collect();
    let mut second = t.to_vec();
    for _ in 0..2 {
        remove(&mut second, &first);
    }
    let length = norm(&second);
    for x in &mut second {
        *x /= length;
    }
    for bend in bends.chunks_exact_mut(t.len()) {
        for direction in [&first, &second, &first, &second] {
            remove(bend, direction);
        }
    }
}

fn remove(vector: &mut [f64], direction: &[f64]) {
    let along = dot(vector, direction);
    vector.iter_mut().zip(direction).for_each(|(x, d)| *x -= along * d);
}
