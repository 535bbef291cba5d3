//! Values of cells as Python objects.

use pforms_catalogue::{Arithmetic, Value};
use pforms_kernel::{Form, Rational};
use pforms_operators::{Immersed, Spline};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::errors::raised;
use crate::form::PyForm;
use crate::immersed::PyImmersed;
use crate::spline::PySpline;

/// A scalar whose values Python knows: floats and forms, or fractions in arrays.
pub(crate) trait Shown: Arithmetic {
    fn number(py: Python<'_>, x: Self) -> PyResult<Bound<'_, PyAny>>;
    fn form(py: Python<'_>, form: Form<Self>) -> PyResult<Bound<'_, PyAny>>;
    fn pieces(py: Python<'_>, pieces: Spline<Self>) -> PyResult<Bound<'_, PyAny>>;
    fn immersed(py: Python<'_>, lazy: Immersed<Self>) -> PyResult<Bound<'_, PyAny>>;
}

impl Shown for f64 {
    fn number(py: Python<'_>, x: Self) -> PyResult<Bound<'_, PyAny>> {
        x.into_bound_py_any(py)
    }

    fn form(py: Python<'_>, form: Form) -> PyResult<Bound<'_, PyAny>> {
        PyForm::from(form).into_bound_py_any(py)
    }

    fn pieces(py: Python<'_>, pieces: Spline) -> PyResult<Bound<'_, PyAny>> {
        PySpline::from(pieces).into_bound_py_any(py)
    }

    fn immersed(py: Python<'_>, lazy: Immersed) -> PyResult<Bound<'_, PyAny>> {
        PyImmersed::from(lazy).into_bound_py_any(py)
    }
}

impl Shown for Rational {
    fn number(py: Python<'_>, x: Self) -> PyResult<Bound<'_, PyAny>> {
        x.into_bound_py_any(py)
    }

    /// An object array of the homogeneous poles.
    fn form(py: Python<'_>, form: Form<Self>) -> PyResult<Bound<'_, PyAny>> {
        let poles = PyList::new(py, form.homogeneous())?;
        let shape: Vec<usize> = form.orders().iter().copied().chain([form.width()]).collect();
        let array = py.import("numpy")?.getattr("array")?.call1((poles, "O"))?;
        array.call_method1("reshape", (shape,))
    }

    fn pieces(py: Python<'_>, pieces: Spline<Self>) -> PyResult<Bound<'_, PyAny>> {
        Self::form(py, pieces.net().clone())
    }

    fn immersed(py: Python<'_>, lazy: Immersed<Self>) -> PyResult<Bound<'_, PyAny>> {
        Self::form(py, lazy.expand().map_err(|error| raised(&error))?)
    }
}

/// The value as Python has it. A failure is raised, and names the cell it came from.
pub(crate) fn shown<S: Shown>(py: Python<'_>, value: Value<S>) -> PyResult<Bound<'_, PyAny>> {
    match value {
        Value::Empty => Ok(py.None().into_bound(py)),
        Value::Number(x) => S::number(py, x),
        Value::Boolean(truth) => truth.into_bound_py_any(py),
        Value::Text(text) => text.into_bound_py_any(py),
        Value::Form(form) => S::form(py, form),
        Value::Spline(pieces) => S::pieces(py, pieces),
        Value::Immersed(lazy) => S::immersed(py, lazy),
        Value::Mesh(mesh) => crate::meshes::record(py, &mesh),
        Value::List(items) => {
            let list = PyList::empty(py);
            for item in items {
                list.append(shown(py, item)?)?;
            }
            Ok(list.into_any())
        }
        Value::Record(entries) => {
            let record = PyDict::new(py);
            for (name, value) in entries {
                record.set_item(name.en, shown(py, value)?)?;
            }
            Ok(record.into_any())
        }
        Value::Error(failure) => Err(raised(&failure.to_error())),
    }
}

/// The text of a literal cell that holds this form: nested lists of points with their weights.
pub(crate) fn literal(form: &Form) -> String {
    let mut points: Vec<String> =
        form.homogeneous().chunks_exact(form.width()).map(point).collect();
    for &order in form.orders().iter().rev() {
        let lists = points.chunks_exact(order);
        points = lists.map(|list| format!("[{}]", list.join(", "))).collect();
    }
    points.concat()
}

fn point(pole: &[f64]) -> String {
    let (weight, coordinates) = pole.split_last().unwrap_or((&1.0, pole));
    let divisor = if *weight == 0.0 { 1.0 } else { *weight };
    let numbers: Vec<String> = coordinates.iter().map(|x| (x / divisor).write()).collect();
    match (numbers.as_slice(), *weight == 1.0) {
        ([only], true) => format!("({only},)"),
        (several, true) => format!("({})", several.join(", ")),
        (several, false) => format!("({}; {})", several.join(", "), weight.write()),
    }
}
