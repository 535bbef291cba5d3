//! Curvatures alone.

use pforms_kernel::{Error, Form, Result};

use super::curve_frame::{FrameKind, curve_frames};
use super::surface_frame::{SurfaceCurvature, surface_frame};

/// How a form bends at one point.
#[derive(Clone, Debug, PartialEq)]
pub enum Curvature {
    /// Of a curve: signed in the plane, and with a torsion in space.
    Curve {
        /// The curvature: one over the radius of the osculating circle.
        curvature: f64,
        /// The torsion, in dimension 3.
        torsion: Option<f64>,
    },
    /// Of a surface in space.
    Surface(SurfaceCurvature),
}

/// The curvature of a curve in dimension 2 or more, or of a surface in dimension 3.
///
/// Accuracy, limits and errors as [`curve_frames`] (a straight line has curvature 0) and
/// [`surface_frame`]; `Shape` for other forms.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Curvature, curvature};
/// // Half a circle of radius 2: the weight in the middle is 0.
/// let half: Form = Form::from_homogeneous(&[3], 2, vec![2., 0., 1., 0., 2., 0., -2., 0., 1.])?;
/// let Curvature::Curve { curvature, .. } = curvature(&half, &[0.25])? else { unreachable!() };
/// assert!((curvature - 0.5).abs() < 1e-15);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn curvature(form: &Form, parameters: &[f64]) -> Result<Curvature> {
    form.require_per_axis("parameters", parameters)?;
    match (form.axes(), form.ambient()) {
        (1, _) => {
            let frames = curve_frames(form, parameters, FrameKind::Tangent, 0.0)?;
            Ok(Curvature::Curve { curvature: frames[0].curvature, torsion: frames[0].torsion })
        }
        (2, 3) => match surface_frame(form, parameters[0], parameters[1])?.curvature {
            Some(curvature) => Ok(Curvature::Surface(curvature)),
            None => Err(wrong(form)),
        },
        _ => Err(wrong(form)),
    }
}

fn wrong(form: &Form) -> Error {
    Error::shape(
        "form",
        format!("a {} in dimension {}", form.kind(), form.ambient()),
        "a curve, or a surface in dimension 3",
    )
}
