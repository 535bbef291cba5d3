//! Unit normals of a surface, exact from its derivatives, and their limits where those vanish.

use pforms_kernel::{Form, Result};

use crate::adaptive::net::{Net, Quadruple, bernstein_slopes};
use crate::series::Line;
use crate::space::{centred, project, quadruples, tensor};
use crate::vector::{Vec3, add, cross, norm, perpendicular, scale, subtract, unit};

/// Below this share of the product of the largest derivatives, a normal counts as vanishing: a
/// hundred roundings of the terms that cancel.
const VANISHING: f64 = 1e-12;

/// Points and unit normals of a surface on a grid of parameters, in C order.
pub(crate) struct Grid {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) normals: Vec<Vec3>,
}

/// A surface in space, ready to be sampled.
pub(crate) struct Surface {
    form: Form,
    centred: Form,
    threshold: f64,
}

impl Surface {
    /// `centre` and `radius` describe the ball round the form: normals do not depend on the place,
    /// and near the origin they lose nothing to cancellation.
    pub(crate) fn new(form: &Form, centre: Vec3, radius: f64) -> Result<Self> {
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
        Ok(Self { form: form.clone(), centred, threshold })
    }

    /// Points and normals on the grid `us × vs`.
    pub(crate) fn grid(&self, us: &[f64], vs: &[f64]) -> Result<Grid> {
        let parameters = [us, vs];
        let positions =
            quadruples(&tensor(&self.form, &parameters, None)?).iter().map(project).collect();
        let points = tensor(&self.centred, &parameters, None)?;
        let along_u = tensor(&self.centred, &parameters, Some(0))?;
        let along_v = tensor(&self.centred, &parameters, Some(1))?;
        let samples =
            quadruples(&points).iter().zip(quadruples(&along_u).iter().zip(quadruples(&along_v)));
        let mut normals = Vec::with_capacity(us.len() * vs.len());
        for (k, (point, (du, dv))) in samples.enumerate() {
            let raw = normal(point, du, dv);
            normals.push(match unit(raw).filter(|_| norm(raw) > self.threshold) {
                Some(normal) => normal,
                None => self.limit(us[k / vs.len()], vs[k % vs.len()])?,
            });
        }
        Ok(Grid { positions, normals })
    }

    /// Unit normals at scattered parameters, the axes of the surface exchanged if `swapped`.
    ///
    /// Parameters of one row one after another share its contraction.
    pub(crate) fn normals(&self, parameters: &[[f64; 2]], swapped: bool) -> Result<Vec<Vec3>> {
        let net = Net::of(&self.centred, swapped);
        let mut rows = [const { Vec::new() }; 2];
        let mut lines = [const { Vec::new() }; 2];
        let mut last = f64::NAN;
        let mut normals = Vec::with_capacity(parameters.len());
        for &[u, v] in parameters {
            if u != last {
                bernstein_slopes(net.rows - 1, u, &mut rows);
                for (line, row) in lines.iter_mut().zip(&rows) {
                    net.contracted(row, line);
                }
                last = u;
            }
            bernstein_slopes(net.columns - 1, v, &mut rows);
            let [point, dv] = [0, 1].map(|order: usize| sum(&rows[order], &lines[0]));
            let du = sum(&rows[0], &lines[1]);
            let raw = if swapped { normal(&point, &dv, &du) } else { normal(&point, &du, &dv) };
            let length = norm(raw);
            normals.push(if length > self.threshold {
                scale(1.0 / length, raw)
            } else {
                let [u, v] = if swapped { [v, u] } else { [u, v] };
                self.limit(u, v)?
            });
        }
        Ok(normals)
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

/// `Σ row · pole`.
fn sum(row: &[f64], poles: &[Quadruple]) -> Quadruple {
    let mut sum = [0.0; 4];
    for (factor, pole) in row.iter().zip(poles) {
        sum = std::array::from_fn(|k| sum[k] + factor * pole[k]);
    }
    sum
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
