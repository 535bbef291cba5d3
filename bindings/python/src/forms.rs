//! Forms in a list, borrowed from Python without copies.

use pforms_kernel::Form;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::errors::mistyped;
use crate::form::PyForm;

/// Forms that Python keeps alive.
pub(crate) struct Forms<'py>(Vec<Bound<'py, PyForm>>);

impl<'py> Forms<'py> {
    /// The forms in a list; a single form stands for a list of one.
    ///
    /// Errors: `ArgumentError` for anything else.
    pub(crate) fn read(argument: &str, object: &Bound<'py, PyAny>) -> PyResult<Self> {
        if let Ok(form) = object.cast::<PyForm>() {
            return Ok(Self(vec![form.clone()]));
        }
        let Ok(items) = object.try_iter() else {
            return Err(mistyped(argument, object, "a list of forms"));
        };
        items.map(|item| one(argument, item?)).collect::<PyResult<_>>().map(Self)
    }

    /// Forms given one by one, or all in a list.
    pub(crate) fn read_several(argument: &str, given: &Bound<'py, PyTuple>) -> PyResult<Self> {
        if given.len() == 1 {
            return Self::read(argument, &given.get_item(0)?);
        }
        given.iter().map(|item| one(argument, item)).collect::<PyResult<_>>().map(Self)
    }

    pub(crate) fn refs(&self) -> Vec<&Form> {
        self.0.iter().map(|form| &form.get().form).collect()
    }

    /// Forms share their poles, so this copies none.
    pub(crate) fn cloned(&self) -> Vec<Form> {
        self.refs().into_iter().cloned().collect()
    }
}

fn one<'py>(argument: &str, object: Bound<'py, PyAny>) -> PyResult<Bound<'py, PyForm>> {
    object.cast_into().map_err(|error| mistyped(argument, &error.into_inner(), "a pforms.Form"))
}
