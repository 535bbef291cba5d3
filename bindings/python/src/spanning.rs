//! Forms spanned by their borders, and by networks of curves.

use pforms_operators::{self as operators, CoonsOptions, Poles, Shape};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arguments::{real, truth};
use crate::errors::done;
use crate::shapes;

/// The surface that four curves span, the volume of six surfaces, and so on: a Coons patch.
///
/// Faces come in pairs, those across the last axis first: the curves at v=0, v=1, u=0 and u=1, the
/// surfaces at w=0, w=1, v=0, v=1, u=0 and u=1. Opposite faces run the same way. Orders may differ.
/// The faces of the result are the given ones exactly. Where their weights do not agree up to a
/// factor for each face, the points are blended: the same border, with higher orders.
///
/// Parameters
/// ----------
/// *faces : Form or Spline
///     Two for each axis of the result, one by one or in a list, each with one axis less.
/// accuracy : float, optional
///     Largest gap between faces that should meet, in sizes of the largest coordinate; 1e-9.
/// pointwise : bool, optional
///     Blend the points whatever the weights, so that no weight vanishes that did not before.
///
/// Returns
/// -------
/// Form, or Spline if a face is one
///
/// Raises
/// ------
/// DomainError
///     Where faces do not meet: the message names the corner or edge, and the gap.
/// ShapeError
///     When faces, axes or dimensions do not fit together.
///
/// Examples
/// --------
/// >>> low, high = pf.Form([(0, 0, 0), (1, 0, 0)]), pf.Form([(0, 1, 0), (1, 1, 0)])
/// >>> arch, side = pf.Form([(0, 0, 0), (0, 0.5, 1), (0, 1, 0)]), pf.Form([(1, 0, 0), (1, 1, 0)])
/// >>> patch = pf.coons(low, high, arch, side)
/// >>> patch, patch(0.5, 0.5)
/// (<pforms.Form pS23 in 3D>, array([0.5 , 0.5 , 0.25]))
/// >>> patch.sub(0, 0) == arch
/// True
#[pyfunction]
#[pyo3(
    signature = (*faces, accuracy=None, pointwise=None),
    text_signature = "(*faces, accuracy=1e-09, pointwise=False)"
)]
pub(crate) fn coons<'py>(
    faces: &Bound<'py, PyTuple>,
    accuracy: Option<&Bound<'py, PyAny>>,
    pointwise: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = faces.py();
    let mut options = CoonsOptions::default();
    if let Some(accuracy) = accuracy {
        options.accuracy = real("accuracy", accuracy)?;
    }
    options.pointwise = pointwise.map_or(Ok(false), |given| truth("pointwise", given))?;
    let shapes = shapes::read_several("faces", faces)?;
    let patch = done(py, usize::MAX, || spanned(shapes, &options))?;
    shapes::object(py, patch)
}

fn spanned(shapes: Vec<Shape>, options: &CoonsOptions) -> pforms_kernel::Result<Shape> {
    if shapes.iter().any(|shape| matches!(shape, Shape::Spline(_))) {
        let splines: Vec<_> = shapes.into_iter().map(Shape::into_spline).collect();
        let faces: Vec<_> = splines.iter().collect();
        return operators::coons_splines(&faces, options).map(Shape::Spline);
    }
    let faces: Vec<_> = shapes.iter().map(Poles::net).collect();
    operators::coons(&faces, options).map(Shape::Form)
}
