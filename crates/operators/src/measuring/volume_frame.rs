//! Frames of volumes, and of forms with any number of axes.

use nalgebra::DMatrix;
use pforms_kernel::{Error, Form, Result};

use super::local::Local;
use super::surface_frame::limit_tangent;
use super::vector::{norm, scaled};

/// The tangents of a form at one point.
#[derive(Clone, Debug, PartialEq)]
pub struct VolumeFrame {
    /// The euclidean point.
    pub point: Vec<f64>,
    /// The unit tangent along each axis; where a derivative vanishes, the direction it has next to
    /// this point, in the window.
    pub tangents: Vec<Vec<f64>>,
    /// Lengths of the derivatives.
    pub lengths: Vec<f64>,
    /// The determinant of the derivatives, when there are as many axes as dimensions: the signed
    /// stretch of volume.
    pub jacobian: Option<f64>,
}

impl VolumeFrame {
    /// The frame of the same form over windows longer by these factors.
    pub(crate) fn slowed(self, factors: &[f64]) -> Self {
        let lengths = self.lengths.iter().zip(factors).map(|(length, k)| length / k).collect();
        let jacobian = self.jacobian.map(|stretch| stretch / factors.iter().product::<f64>());
        Self { lengths, jacobian, ..self }
    }

    /// The same frame with the derivatives themselves as tangents.
    #[must_use]
    pub fn unnormalised(&self) -> Self {
        let pairs = self.tangents.iter().zip(&self.lengths);
        Self {
            tangents: pairs.map(|(tangent, length)| scaled(tangent, *length)).collect(),
            ..self.clone()
        }
    }
}

/// The tangents `(t_u, t_v, t_w, …)` of a form with at least one axis, by exact derivatives.
///
/// Errors: `Shape` for a point or a wrong number of parameters; `Degenerate` where a tangent has
/// no limit; `Domain` where the weight vanishes or a parameter is not finite.
pub fn volume_frame(form: &Form, parameters: &[f64]) -> Result<VolumeFrame> {
    if form.axes() == 0 {
        return Err(Error::shape("form", "a point", "a form with at least one axis"));
    }
    let local = Local::new(form, parameters, 1)?;
    let axes = form.axes();
    let derivatives: Vec<Vec<f64>> = (0..axes)
        .map(|axis| local.first(axis).iter().map(|series| series[0].value).collect())
        .collect();
    let jacobian = (axes == form.ambient())
        .then(|| DMatrix::from_fn(axes, axes, |i, j| derivatives[j][i]).determinant());
    Ok(VolumeFrame {
        point: local.at(),
        tangents: (0..axes)
            .map(|axis| limit_tangent(form, parameters, axis))
            .collect::<Result<_>>()?,
        lengths: derivatives.iter().map(|derivative| norm(derivative)).collect(),
        jacobian,
    })
}
