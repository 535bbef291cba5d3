//! Proportions: the ratios of a control polygon, and the golden one.

use pforms_operators::{self as operators, Poles};
use pyo3::intern;
use pyo3::prelude::*;

use crate::arguments::axis_number;
use crate::errors::done;
use crate::outputs::array;
use crate::shapes;

/// The sides of a control polygon and their ratios.
///
/// Parameters
/// ----------
/// form : Form, Spline or array
/// axis : int, optional
///     The axis along which sides follow one another.
///
/// Returns
/// -------
/// Ratios
///     ``sides``, ``ratios`` of each to the one before, ``angles`` between them, ``nearest`` known
///     ratios by name, ``gaps``. Of a curve in one axis; of others with an axis before it, for the lines.
///
/// Raises
/// ------
/// ShapeError
///     When there is no such axis.
/// DomainError
///     For poles at infinity.
///
/// Examples
/// --------
/// >>> found = pf.ratios([(0, 0), (2, 0), (2, 3), (2, 0)])
/// >>> found.ratios, found.nearest
/// (array([1.5, 1. ]), ['3/2', '1'])
#[pyfunction]
#[pyo3(signature = (form, axis=None), text_signature = "(form, axis=0)")]
pub(crate) fn ratios<'py>(
    form: &Bound<'py, PyAny>,
    axis: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = form.py();
    let shape = shapes::read("form", form)?;
    let net = shape.net();
    let axis = axis_number(axis)?;
    let found = done(py, net.homogeneous().len(), || operators::ratios(net, axis))?;
    let lines = found.sides.len();
    let table = |lists: Vec<Vec<f64>>| {
        let count = lists.first().map_or(0, Vec::len);
        let shape: &[usize] = if net.axes() == 1 { &[count] } else { &[lines, count] };
        array(py, shape, lists.concat())
    };
    let class = py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Ratios"))?;
    let (sides, ratios, angles) = (found.sides, found.ratios, found.angles);
    let numbers = (table(sides)?, table(ratios)?, table(angles)?);
    let gaps = table(found.gaps)?;
    let mut nearest = found.nearest;
    match nearest.pop() {
        Some(line) if net.axes() == 1 => class.call1((numbers.0, numbers.1, numbers.2, line, gaps)),
        line => {
            nearest.extend(line);
            class.call1((numbers.0, numbers.1, numbers.2, nearest, gaps))
        }
    }
}

/// Between two points or forms, in the golden ratio, the longer part first.
///
/// Parameters
/// ----------
/// a, b : Form, Spline or array
///     Of forms the way is divided pole by pole; an array of one point is a point.
///
/// Returns
/// -------
/// Form, or Spline if one of them is
///
/// Raises
/// ------
/// ShapeError
///     When axes or dimensions differ.
///
/// Examples
/// --------
/// >>> pf.golden((0, 0), (1, 0)).poles.round(6)
/// array([0.618034, 0.      ])
#[pyfunction]
pub(crate) fn golden<'py>(
    a: &Bound<'py, PyAny>,
    b: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = a.py();
    let (first, second) = (shapes::read("a", a)?, shapes::read("b", b)?);
    let cost = first.net().homogeneous().len() + second.net().homogeneous().len();
    shapes::object(py, done(py, cost, || operators::golden(&first, &second))?)
}
