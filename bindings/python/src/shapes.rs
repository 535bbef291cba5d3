//! Forms and splines, where either will do.

use pforms_operators::Shape;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use crate::arrays::Numbers;
use crate::errors::{mistyped, raised};
use crate::form::{PyForm, from_euclidean};
use crate::spline::PySpline;

/// A form or a spline; an array of points is the poles of a form.
///
/// Errors: `ArgumentError` for anything else.
pub(crate) fn read(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<Shape> {
    if let Ok(form) = object.cast::<PyForm>() {
        return Ok(form.get().form.clone().into());
    }
    if let Ok(spline) = object.cast::<PySpline>() {
        return Ok(spline.get().spline.clone().into());
    }
    match Numbers::read(argument, object) {
        Ok(numbers) => Ok(from_euclidean(argument, &numbers, None).map_err(|e| raised(&e))?.into()),
        Err(_) => Err(mistyped(argument, object, "a pforms.Form, a pforms.Spline or an array")),
    }
}

/// Forms and splines given one by one, or all in a list.
pub(crate) fn read_several(argument: &str, given: &Bound<'_, PyTuple>) -> PyResult<Vec<Shape>> {
    let single = given.get_item(0).ok().filter(|_| given.len() == 1);
    match single.filter(|item| item.is_instance_of::<PyList>() || item.is_instance_of::<PyTuple>())
    {
        Some(list) => list.try_iter()?.map(|item| read(argument, &item?)).collect(),
        None => given.iter().map(|item| read(argument, &item)).collect(),
    }
}

/// The Python object of a form or of a spline.
pub(crate) fn object(py: Python<'_>, shape: Shape) -> PyResult<Bound<'_, PyAny>> {
    match shape {
        Shape::Form(form) => PyForm::from(form).into_bound_py_any(py),
        Shape::Spline(spline) => PySpline::from(spline).into_bound_py_any(py),
    }
}
