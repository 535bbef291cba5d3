//! Surfaces laid out flat (book, section 326).
//!
//! A curve on a surface keeps its geodesic curvature when the surface is unrolled, and a plane curve
//! is known from its curvature and its lengths. So one isoparametric line is laid out, and from each of
//! its points the line that crosses it, at the angle they have on the surface. Both are quadratures:
//! `θ = ∫ n·(f_t × f_tt)/|f_t|² dt`, then `∫ |f_t|·(cos θ, sin θ) dt`. On a developable surface the result
//! does not depend on the line chosen and is an isometry; on others the crossing lines keep their
//! lengths, and what happens to lengths, angles and areas elsewhere is measured and reported.

mod chart;
mod distortion;
mod line;
mod quadrature;

use pforms_kernel::{Error, Result};

use crate::Spline;
use crate::measuring::about_one::unit_of;
use chart::{Base, Chart, in_one};
pub use distortion::Distortion;

/// A surface laid out in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Unrolling {
    /// The surface in the plane, with the same parameters; the normal was towards the reader.
    pub spline: Spline,
    /// What this spline does to the surface, where it does most.
    pub distortion: Distortion,
}

/// Lays a surface out in the plane, and measures what that does to it.
///
/// Developable surfaces (cones, cylinders, tangent developables, in any parametrisation) keep their
/// lengths, angles and areas, to about `accuracy` and rounding; others are stretched, and the
/// distortion says how much. Of six lines to begin from, the sides and middles of the window, that
/// which distorts least is taken; it begins in the origin, along the coordinate of its own axis.
/// `accuracy` is that of the polynomials of the result, in sizes of the surface, and of their slopes.
///
/// Errors: `Shape` unless it is a surface in dimension 2 or 3; `Degenerate` when it has no normals or
/// every line to begin from is collapsed; `Domain` when the accuracy is not positive, and where the
/// weight vanishes; `Accuracy` when the accuracy takes too many pieces.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::unroll;
/// // A quarter of a cylinder of radius 1 and height 2.
/// let (w, z) = (0.5_f64.sqrt(), 2.0);
/// let poles = vec![1., 0., 0., 1., 1., 0., z, 1., w, w, 0., w, w, w, z * w, w, 0., 1., 0., 1., 0., 1., z, 1.];
/// let quarter: Form = Form::from_homogeneous(&[3, 2], 3, poles)?;
/// let flat = unroll(quarter, 1e-12)?;
/// assert!(flat.distortion.length < 1e-9 && flat.distortion.area < 1e-9);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn unroll(surface: impl Into<Spline>, accuracy: f64) -> Result<Unrolling> {
    let surface = surface.into();
    if surface.axes() != 2 || !(2..=3).contains(&surface.ambient()) {
        return Err(Error::shape(
            "form",
            format!("a form of {} axes in dimension {}", surface.axes(), surface.ambient()),
            "a surface in dimension 2 or 3",
        ));
    }
    if !(accuracy > 0.0 && accuracy.is_finite()) {
        return Err(Error::domain("accuracy", accuracy, "a number above 0"));
    }
    let unit = unit_of(surface.net())?;
    let mut chart = Chart::new(&surface, unit)?;
    let base = best_base(&chart)?;
    loop {
        let flat = chart.laid_out(base)?;
        let coarse = flat.unresolved(accuracy)?;
        if coarse.iter().flatten().all(|coarse| !coarse) {
            let forms = flat.lowered(accuracy)?;
            let distortion = flat.distortion(&chart, &forms)?;
            return Ok(Unrolling { spline: in_one(&forms, &chart, unit)?, distortion });
        }
        chart.halve(&coarse)?;
    }
}

/// The line whose layout distorts least; among equals the first.
fn best_base(chart: &Chart) -> Result<Base> {
    let mut best: Option<(Base, f64)> = None;
    let mut failure = None;
    for base in chart.bases() {
        match chart.laid_out(base).and_then(|flat| flat.distortion(chart, &flat.forms()?)) {
            Ok(distortion) => {
                let total = distortion.length + distortion.angle;
                // A little worse is no reason: rounding must not choose.
                if best.as_ref().is_none_or(|(_, least)| total < 0.9 * least - NOTHING) {
                    best = Some((base, total));
                }
            }
            Err(error) => failure = Some(error),
        }
    }
    match (best, failure) {
        (Some((base, _)), _) => Ok(base),
        (None, Some(error)) => Err(error),
        (None, None) => Err(Error::degenerate("form", "no line to begin from", "a surface")),
    }
}

/// Differences of distortion that do not count.
const NOTHING: f64 = 1e-6;
