//! Forms and splines, where either will do.

use pforms_operators::Shape;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use crate::arrays::Numbers;
use crate::errors::{mistyped, raised};
use crate::form::{PyForm, from_euclidean};
use crate::meshes::is_mesh;
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
    let expected = "a pforms.Form, a pforms.Spline or an array";
    if is_mesh(object) {
        return Err(mistyped(argument, object, expected));
    }
    match Numbers::if_any(argument, object)? {
        Some(numbers) => {
            Ok(from_euclidean(argument, &numbers, None).map_err(|e| raised(&e))?.into())
        }
        None => Err(mistyped(argument, object, expected)),
    }
}

/// Forms, splines and arrays of poles given one by one, or all in a list.
pub(crate) fn read_several(argument: &str, given: &Bound<'_, PyTuple>) -> PyResult<Vec<Shape>> {
    let single = given.get_item(0).ok().filter(|_| given.len() == 1);
    let listed = |item: &Bound<'_, PyAny>| {
        item.is_instance_of::<PyList>() || item.is_instance_of::<PyTuple>() && !is_mesh(item)
    };
    match single.filter(listed) {
        Some(list) => list.try_iter()?.map(|item| read(argument, &item?)).collect(),
        None => given.iter().map(|item| read(argument, &item)).collect(),
    }
}

/// Forms and splines given one by one, or all in a list.
///
/// Errors: `ArgumentError` for anything else.
pub(crate) fn several(argument: &str, given: &Bound<'_, PyTuple>) -> PyResult<Vec<Shape>> {
    if given.len() == 1 {
        return list(argument, &given.get_item(0)?);
    }
    given.iter().map(|item| one(argument, &item)).collect()
}

/// The forms and splines of a list; a single one stands for a list of one.
///
/// Errors: `ArgumentError` for anything else.
pub(crate) fn list(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<Vec<Shape>> {
    if is_shape(object) {
        return Ok(vec![one(argument, object)?]);
    }
    let Ok(items) = object.try_iter() else {
        return Err(mistyped(argument, object, "a list of forms"));
    };
    items.map(|item| one(argument, &item?)).collect()
}

/// Is it a form or a spline?
pub(crate) fn is_shape(object: &Bound<'_, PyAny>) -> bool {
    object.is_instance_of::<PyForm>() || object.is_instance_of::<PySpline>()
}

fn one(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<Shape> {
    if is_shape(object) {
        return read(argument, object);
    }
    Err(mistyped(argument, object, "a pforms.Form or a pforms.Spline"))
}

/// The Python object of a form or of a spline.
pub(crate) fn object(py: Python<'_>, shape: Shape) -> PyResult<Bound<'_, PyAny>> {
    match shape {
        Shape::Form(form) => PyForm::from(form).into_bound_py_any(py),
        Shape::Spline(spline) => PySpline::from(spline).into_bound_py_any(py),
    }
}
