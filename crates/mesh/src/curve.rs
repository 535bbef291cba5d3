//! Curves to polylines.

use pforms_kernel::{Form, Result};

use crate::Sampling;
use crate::pieces::pieces;
use crate::series::Line;
use crate::space::{embed, project, quadruples, require_axes, tensor, ticks, window};
use crate::vector::{Vec3, dot, norm, scale, subtract, unit};

/// Share of a window given up next to a point at infinity; what is left there reaches about as
/// far as the curve is wide, times the inverse of this.
const TRIMMED: f64 = 1.0 / 32.0;

/// Below this share of the largest derivative, a derivative counts as vanishing: some hundred
/// roundings, while a regular curve sampled a million times stays far above.
const VANISHING: f64 = 1e-12;

/// Points of a curve in their order, with the direction of the curve at each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Polyline {
    /// The points.
    pub points: Vec<Vec3>,
    /// Directions of length 1. Where the derivative vanishes, the limit from inside the window.
    pub tangents: Vec<Vec3>,
    /// The parameter of each point.
    pub parameters: Vec<f64>,
}

/// A curve as polylines: one, unless the curve passes through infinity.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// The finite parts.
    pub polylines: Vec<Polyline>,
    /// Parameters at which the curve is infinitely far; next to them a little is left out.
    pub gaps: Vec<f64>,
}

/// Samples a curve.
///
/// A curve through infinity is cut there and each part is sampled as a curve of its own.
///
/// Errors: `Shape` unless the form has one axis; `Domain` when all its weights are 0; those of
/// [`Sampling::segments`].
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_mesh::{Sampling, curve};
/// let parabola = Form::from_points(&[3], 2, &[0., 0., 1., 2., 2., 0.], None)?;
/// let drawn = curve(&parabola, &Sampling::Tolerance(0.01))?;
/// assert_eq!(drawn.polylines[0].points.first(), Some(&[0.0, 0.0, 0.0]));
/// assert!(drawn.gaps.is_empty());
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn curve(form: &Form, sampling: &Sampling) -> Result<Curve> {
    require_axes(form, 1, "a curve: one axis")?;
    let form = embed(form)?;
    if quadruples(&form).iter().all(|pole| pole[3] > 0.0) {
        let whole = polyline(&form, sampling, 0.0, 1.0)?;
        return Ok(Curve { polylines: vec![whole], gaps: Vec::new() });
    }
    let gaps = zeros(&form)?;
    let mut polylines = Vec::new();
    for (a, b) in between(&gaps) {
        polylines.push(polyline(&window(&form, 0, a, b)?, sampling, a, b)?);
    }
    Ok(Curve { polylines, gaps })
}

/// Parameters where the weight vanishes, neighbours found from two sides counted once.
fn zeros(form: &Form) -> Result<Vec<f64>> {
    let mut zeros: Vec<f64> =
        pieces(form, true)?.zeros.into_iter().filter_map(|at| at.first().copied()).collect();
    zeros.sort_by(f64::total_cmp);
    zeros.dedup_by(|next, kept| *next - *kept < 1e-9);
    Ok(zeros)
}

/// The windows that the gaps leave, trimmed next to each gap.
fn between(gaps: &[f64]) -> Vec<(f64, f64)> {
    let mut windows = Vec::new();
    let mut start = 0.0;
    let mut open = false;
    for (&end, last) in gaps.iter().map(|gap| (gap, false)).chain([(&1.0, true)]) {
        let trim = TRIMMED * (end - start);
        let a = if open { start + trim } else { start };
        let b = if last { end } else { end - trim };
        if end - start > 1e-9 {
            windows.push((a, b));
        }
        (start, open) = (end, true);
    }
    windows
}

/// Samples a part that is finite; its parameters are told as those of `[a, b]`.
fn polyline(form: &Form, sampling: &Sampling, a: f64, b: f64) -> Result<Polyline> {
    let parameters = ticks(sampling.segments(form)?[0]);
    let values = tensor(form, &[&parameters], None)?;
    let slopes = tensor(form, &[&parameters], Some(0))?;
    let points: Vec<Vec3> = quadruples(&values).iter().map(project).collect();
    let raw: Vec<Vec3> =
        quadruples(&values).iter().zip(quadruples(&slopes)).map(|(p, d)| slope(p, d)).collect();
    let largest = raw.iter().map(|slope| norm(*slope)).fold(0.0, f64::max);
    let mut tangents = Vec::with_capacity(points.len());
    for (i, slope) in raw.iter().enumerate() {
        let regular = unit(*slope).filter(|_| norm(*slope) > VANISHING * largest);
        tangents.push(match regular {
            Some(tangent) => tangent,
            None => {
                limit_tangent(form, parameters[i], largest)?.unwrap_or_else(|| chord(&points, i))
            }
        });
    }
    let parameters = parameters.iter().map(|t| a + (b - a) * t).collect();
    Ok(Polyline { points, tangents, parameters })
}

/// `P'w − Pw'`.
fn slope(&[x, y, z, w]: &[f64; 4], &[dx, dy, dz, dw]: &[f64; 4]) -> Vec3 {
    subtract(scale(w, [dx, dy, dz]), scale(dw, [x, y, z]))
}

/// The tangent where the first derivative vanishes: the first term of its series into the window
/// that does not.
fn limit_tangent(form: &Form, t: f64, largest: f64) -> Result<Option<Vec3>> {
    let inward = if t >= 1.0 { -1.0 } else { 1.0 };
    let series = Line::new(form, &[t], &[inward])?.slope(0);
    let term = series.into_iter().find(|term| norm(*term) > VANISHING * largest);
    Ok(term.and_then(unit))
}

/// The direction from the last distinct point before to the next after; any, for a single point.
fn chord(points: &[Vec3], i: usize) -> Vec3 {
    let here = points[i];
    let after = points[i..].iter().find_map(|point| unit(subtract(*point, here)));
    let before = points[..i].iter().rev().find_map(|point| unit(subtract(here, *point)));
    after.or(before).unwrap_or([1.0, 0.0, 0.0])
}

impl Polyline {
    /// The polyline through given points, its tangents the mean directions of the two sides.
    pub fn through(points: Vec<Vec3>) -> Self {
        let last = points.len().saturating_sub(1);
        let tangents = (0..points.len())
            .map(|i| {
                let across = subtract(points[(i + 1).min(last)], points[i.saturating_sub(1)]);
                unit(across).unwrap_or_else(|| chord(&points, i))
            })
            .collect();
        let parameters = (0..points.len()).map(|i| i as f64 / last.max(1) as f64).collect();
        Self { points, tangents, parameters }
    }

    /// Does it end where it began, in the same direction?
    pub fn is_closed(&self) -> bool {
        let [Some(first), Some(last)] = [self.points.first(), self.points.last()] else {
            return false;
        };
        let size = self.points.iter().map(|p| norm(subtract(*p, *first))).fold(0.0, f64::max);
        let turned = dot(self.tangents[0], self.tangents[self.tangents.len() - 1]);
        self.points.len() > 3 && norm(subtract(*last, *first)) <= 1e-9 * size && turned > 0.99
    }
}
