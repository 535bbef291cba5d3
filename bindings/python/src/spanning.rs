//! Forms spanned by their borders, and by networks of curves.

use pforms_operators::{self as operators, CoonsOptions, Network, Poles, Shape, Spline};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arguments::{real, reals, truth};
use crate::arrays::check_whole;
use crate::errors::{done, mistyped};
use crate::outputs::array;
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

/// The surface through a network of curves: a Gordon surface.
///
/// With ``u`` and ``v`` given it has every curve exactly. Without them crossings, order and directions
/// of the curves are found; curves that cross at unequal parameters are followed, as point sets,
/// within the accuracy.
///
/// Parameters
/// ----------
/// us, vs : sequence of Form or Spline
///     The curves along u and those along v. With parameters given one of the lists may be empty.
/// u, v : sequence of float, optional
///     The parameters of the curves ``vs``, and of the curves ``us``, both growing.
/// accuracy : float, optional
///     Largest gap between two curves that cross, and how near curves are followed, in sizes of the
///     largest coordinate.
/// report : bool, optional
///     Return a :class:`Network` of ``surface``, ``error``, ``gap``, ``u`` and ``v``.
///
/// Returns
/// -------
/// Form if all curves are and one piece is enough, or Spline; or Network if report
///
/// Raises
/// ------
/// DomainError
///     Where curves do not meet: the message names them and the gap; when their order differs from
///     curve to curve; when parameters do not grow.
/// DegenerateError
///     For given parameters and weights that do not agree where curves cross.
/// ShapeError, AccuracyError, LimitError
///     When numbers of curves and parameters differ; when the accuracy is not reached; when too large.
///
/// Examples
/// --------
/// >>> us = [pf.Form([(0, 0, 0), (2, 0, 0)]), pf.Form([(0, 1, 1), (2, 1, 1)])]
/// >>> vs = [pf.Form([(x, 0, 0), (x, 1, 0), (x, 1, 1)]) for x in (0, 1, 2)]
/// >>> pf.gordon(us, vs, [0, 0.5, 1], [0, 1])
/// <pforms.Form pS33 in 3D>
/// >>> found = pf.gordon(us, vs, report=True)
/// >>> found.u, found.v, found.error < 1e-12
/// (array([0. , 0.5, 1. ]), array([0., 1.]), True)
#[pyfunction]
#[pyo3(
    signature = (us, vs, u=None, v=None, *, accuracy=None, report=None),
    text_signature = "(us, vs, u=None, v=None, *, accuracy=1e-06, report=False)"
)]
pub(crate) fn gordon<'py>(
    us: &Bound<'py, PyAny>,
    vs: &Bound<'py, PyAny>,
    u: Option<&Bound<'py, PyAny>>,
    v: Option<&Bound<'py, PyAny>>,
    accuracy: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = us.py();
    let ((us, first), (vs, second)) = (curves("us", us)?, curves("vs", vs)?);
    let accuracy = accuracy.map_or(Ok(1e-6), |given| real("accuracy", given))?;
    let report = report.map_or(Ok(false), |given| truth("report", given))?;
    let places = match (u, v) {
        (None, None) => None,
        (u, v) => Some([places("u", u, vs.len(), py)?, places("v", v, us.len(), py)?]),
    };
    let found = done(py, usize::MAX, || match &places {
        Some([u, v]) => Network::given(&us, &vs, u, v, accuracy),
        None => operators::gordon_network(&us, &vs, accuracy),
    })?;
    let form = first && second && found.spline.counts() == [1, 1];
    let shape =
        if form { Shape::Form(found.spline.net().clone()) } else { Shape::Spline(found.spline) };
    let surface = shapes::object(py, shape)?;
    if !report {
        return Ok(surface);
    }
    let class = py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Network"))?;
    let list = |list: Vec<f64>| array(py, &[list.len()], list);
    class.call1((surface, found.error, found.gap, list(found.u)?, list(found.v)?))
}

/// The curves of a family, and whether all of them are forms.
fn curves(argument: &str, given: &Bound<'_, PyAny>) -> PyResult<(Vec<Spline>, bool)> {
    check_whole(argument, given)?;
    let Ok(items) = given.try_iter() else {
        return Err(mistyped(argument, given, "a list of curves"));
    };
    let shapes: Vec<Shape> =
        items.map(|item| shapes::read(argument, &item?)).collect::<PyResult<_>>()?;
    let forms = shapes.iter().all(|shape| matches!(shape, Shape::Form(_)));
    Ok((shapes.into_iter().map(Shape::into_spline).collect(), forms))
}

/// The parameters of a family; one that is empty needs none.
fn places(
    argument: &str,
    given: Option<&Bound<'_, PyAny>>,
    count: usize,
    py: Python<'_>,
) -> PyResult<Vec<f64>> {
    match given {
        Some(list) => reals(argument, list, 1),
        None if count == 0 => Ok(Vec::new()),
        None => Err(mistyped(argument, py.None().bind(py), "a parameter for each curve across")),
    }
}
