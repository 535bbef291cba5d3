//! Numbers given for an argument: one, or one for each axis.

use pforms_kernel::{Error, Form};
use pyo3::prelude::*;
use pyo3::types::PyString;

use crate::arrays::Numbers;
use crate::errors::{LimitError, fail, mistyped};
use crate::form::PyForm;

/// No memory holds so many numbers.
const CEILING: f64 = 1e12;

/// A finite or infinite real number.
pub(crate) fn real(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<f64> {
    let numbers = Numbers::read(argument, object)?;
    match (numbers.shape(), numbers.values()) {
        ([], [number]) => Ok(*number),
        (shape, _) => {
            fail(&Error::shape(argument, format!("an array of shape {shape:?}"), "a number"))
        }
    }
}

/// A whole number of at least 0.
///
/// Errors: `DomainError` for a negative number or a fraction.
pub(crate) fn whole(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<usize> {
    to_whole(argument, real(argument, object)?)
}

/// One real number for each of `axes`, a single one counting for all.
pub(crate) fn reals(argument: &str, object: &Bound<'_, PyAny>, axes: usize) -> PyResult<Vec<f64>> {
    let numbers = Numbers::read(argument, object)?;
    match (numbers.shape(), numbers.values()) {
        ([], [number]) => Ok(vec![*number; axes]),
        ([_], _) => Ok(numbers.into_values()),
        (shape, _) => fail(&Error::shape(
            argument,
            format!("an array of shape {shape:?}"),
            "a number, or one for each axis",
        )),
    }
}

/// One whole number for each of `axes`, a single one counting for all.
pub(crate) fn wholes(
    argument: &str,
    object: &Bound<'_, PyAny>,
    axes: usize,
) -> PyResult<Vec<usize>> {
    let numbers = reals(argument, object, axes)?;
    numbers.into_iter().map(|number| to_whole(argument, number)).collect()
}

/// An axis of a form.
///
/// Errors: `ShapeError` when there is no such axis.
pub(crate) fn axis(form: &Form, object: &Bound<'_, PyAny>) -> PyResult<usize> {
    let number = real("axis", object)?;
    if number >= 0.0 && number.fract() == 0.0 {
        let axis = number as usize;
        if axis < form.axes() {
            return Ok(axis);
        }
    }
    let last = form.axes().saturating_sub(1);
    fail(&Error::shape("axis", number, format!("0 to {last} for a {}", form.kind())))
}

/// The number of an axis, 0 if absent.
pub(crate) fn axis_number(object: Option<&Bound<'_, PyAny>>) -> PyResult<usize> {
    object.map_or(Ok(0), |object| whole("axis", object))
}

/// A level of recursion.
pub(crate) fn level(argument: &str, level: usize) -> PyResult<u32> {
    const MOST: u32 = 1_000_000;
    let small = u32::try_from(level).ok().filter(|level| *level <= MOST);
    small.ok_or_else(|| too_large(argument, level as f64, f64::from(MOST)))
}

/// `True` or `False`.
pub(crate) fn truth(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<bool> {
    object.extract().map_err(|_| mistyped(argument, object, "True or False"))
}

/// Complains about an argument that the others leave no part in; `False` asks for nothing.
pub(crate) fn require_idle(
    argument: &str,
    given: Option<&Bound<'_, PyAny>>,
    why: &str,
) -> PyResult<()> {
    match given {
        Some(object) if !object.extract().is_ok_and(|truth: bool| !truth) => {
            Err(mistyped(argument, object, &format!("nothing: {why}")))
        }
        _ => Ok(()),
    }
}

/// Complains about NaN and infinities.
pub(crate) fn require_finite(argument: &str, numbers: &[f64]) -> PyResult<()> {
    match numbers.iter().find(|number| !number.is_finite()) {
        None => Ok(()),
        Some(number) => fail(&Error::domain(argument, number, "finite numbers")),
    }
}

/// A form.
pub(crate) fn form(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<Form> {
    match object.cast::<PyForm>() {
        Ok(form) => Ok(form.get().form.clone()),
        Err(_) => Err(mistyped(argument, object, "a pforms.Form")),
    }
}

/// A text that must be one of a few words.
pub(crate) fn word(
    argument: &str,
    object: &Bound<'_, PyAny>,
    known: &[&'static str],
) -> PyResult<&'static str> {
    let expected = known.iter().map(|word| format!("{word:?}")).collect::<Vec<_>>().join(", ");
    let Ok(text) = object.cast::<PyString>() else {
        return Err(mistyped(argument, object, &expected));
    };
    let text = text.to_string_lossy();
    match known.iter().find(|word| **word == text) {
        Some(word) => Ok(word),
        None => fail(&Error::domain(argument, format!("{text:?}"), format!("one of {expected}"))),
    }
}

fn to_whole(argument: &str, number: f64) -> PyResult<usize> {
    if number > CEILING {
        return Err(too_large(argument, number, CEILING));
    }
    if number >= 0.0 && number.fract() == 0.0 {
        return Ok(number as usize);
    }
    fail(&Error::domain(argument, number, "a whole number of at least 0"))
}

fn too_large(argument: &str, number: f64, most: f64) -> PyErr {
    LimitError::new_err(format!("{argument}: received {number:e}, expected at most {most:e}"))
}
