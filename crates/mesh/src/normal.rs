//! Unit normals of a surface where it is hardly one: the limits from inside the window, and any
//! direction across where there is none.

use pforms_kernel::{Form, Result};

use crate::pieces::{ball, finite_pieces};
use crate::series::Line;
use crate::space::{centred, quadruples, tensor};
use crate::vector::{Vec3, add, cross, norm, perpendicular, scale, subtract, unit};

/// Below this share of the product of the largest derivatives, a normal counts as vanishing: a
/// hundred roundings of the terms that cancel.
const VANISHING: f64 = 1e-12;

/// A surface in space, ready to be sampled.
pub(crate) struct Surface {
    centred: Form,
    threshold: f64,
}

impl Surface {
    /// Normals do not depend on the place, and near the origin they lose nothing to cancellation.
    pub(crate) fn new(form: &Form) -> Result<Self> {
        let (centre, radius) = ball(&finite_pieces(form)?);
        let centred = centred(form, centre)?;
        let heaviest = quadruples(&centred).iter().map(|pole| pole[3].abs()).fold(0.0, f64::max);
        let size = |axis| -> Result<f64> {
            Ok(crate::space::derivative(&centred, axis)?.map_or(0.0, |derived| {
                let lengths = quadruples(&derived)
                    .iter()
                    .map(|&[x, y, z, w]| norm([x, y, z]) + radius * w.abs());
                lengths.fold(0.0, f64::max)
            }))
        };
        let threshold = VANISHING * size(0)? * size(1)? * heaviest;
        Ok(Self { centred, threshold })
    }

    /// Unit normals at scattered parameters.
    pub(crate) fn normals(&self, parameters: &[[f64; 2]]) -> Result<Vec<Vec3>> {
        parameters.iter().map(|at| self.normal_at(*at)).collect()
    }

    fn normal_at(&self, [u, v]: [f64; 2]) -> Result<Vec3> {
        let at: [&[f64]; 2] = [&[u], &[v]];
        let value = |derived| tensor(&self.centred, &at, derived).map(|one| quadruples(&one)[0]);
        let raw = normal(&value(None)?, &value(Some(0))?, &value(Some(1))?);
        match unit(raw).filter(|_| norm(raw) > self.threshold) {
            Some(normal) => Ok(normal),
            None => self.limit(u, v),
        }
    }

    /// The limit of the unit normal on the way out from inside the window.
    ///
    /// First straight inwards, then along each axis and both diagonals; a surface that is nowhere
    /// one gets a direction at right angles to what it is.
    fn limit(&self, u: f64, v: f64) -> Result<Vec3> {
        let [a, b] = [inward(u), inward(v)];
        let straight = if (a, b) == (0.0, 0.0) { [1.0, 1.0] } else { [a, b] };
        let [s, t] = [if a == 0.0 { 1.0 } else { a }, if b == 0.0 { 1.0 } else { b }];
        let ways = [straight, [s, t], [s, 0.0], [0.0, t], [s, t / 2.0]];
        for way in ways {
            let line = Line::new(&self.centred, &[u, v], &way)?;
            let series = line.normal();
            let term = series.into_iter().find(|term| norm(*term) > self.threshold);
            if let Some(normal) = term.and_then(unit) {
                return Ok(scale(line.weight_sign(), normal));
            }
        }
        let line = Line::new(&self.centred, &[u, v], &straight)?;
        let slopes = [line.slope(0), line.slope(1)];
        let tangent = slopes.iter().flatten().find_map(|term| unit(*term));
        Ok(tangent.map_or([0.0, 0.0, 1.0], perpendicular))
    }
}

/// The direction from the border of `[0, 1]` inwards; 0 inside.
fn inward(t: f64) -> f64 {
    if t <= 0.0 {
        1.0
    } else if t >= 1.0 {
        -1.0
    } else {
        0.0
    }
}

/// `∂ᵤ × ∂ᵥ` of the point, up to a positive factor.
fn normal(
    &[x, y, z, w]: &[f64; 4],
    &[ux, uy, uz, uw]: &[f64; 4],
    &[vx, vy, vz, vw]: &[f64; 4],
) -> Vec3 {
    let (point, du, dv) = ([x, y, z], [ux, uy, uz], [vx, vy, vz]);
    let flat = scale(w, cross(du, dv));
    let tilt = add(scale(vw, cross(du, point)), scale(uw, cross(point, dv)));
    scale(w.signum(), subtract(flat, tilt))
}
