//! Files of forms. Paths and bytes go through Python, whose errors name the file.

use pforms_formats::{Format, Named, read as read_named, write_forms};
use pforms_operators::Shape;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyString};

use crate::errors::{done, mistyped, raised};
use crate::form::PyForm;
use crate::shapes::{self, object};

/// The bytes of a file.
pub(crate) fn read(path: &Bound<'_, PyAny>) -> PyResult<Vec<u8>> {
    opened(path)?.call_method0("read_bytes")?.extract()
}

/// Writes the bytes of a file.
pub(crate) fn write(path: &Bound<'_, PyAny>, bytes: &[u8]) -> PyResult<()> {
    opened(path)?.call_method1("write_bytes", (PyBytes::new(path.py(), bytes),))?;
    Ok(())
}

fn opened<'py>(path: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let py = path.py();
    let known = path.is_instance_of::<PyString>() || path.hasattr("__fspath__")?;
    if !known {
        return Err(mistyped("path", path, "a path"));
    }
    py.import("pathlib")?.getattr("Path")?.call1((path,))
}

/// The forms in the bytes of a file, by its name.
#[pyfunction]
pub(crate) fn _read_forms<'py>(
    py: Python<'py>,
    name: &str,
    bytes: &[u8],
) -> PyResult<Vec<(Option<String>, Bound<'py, PyAny>)>> {
    let forms = done(py, usize::MAX, || read_named(name, bytes))?;
    forms.into_iter().map(|Named { name, shape }| Ok((name, object(py, shape)?))).collect()
}

/// The bytes of a file of this name that holds forms.
#[pyfunction]
pub(crate) fn _write_forms<'py>(
    name: &str,
    forms: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyBytes>> {
    let list = shapes::list("forms", forms)?;
    let bytes = done(forms.py(), usize::MAX, || {
        let named: Vec<Named> = list.into_iter().map(Named::from).collect();
        write_forms(Format::of_name(name)?, &named)
    })?;
    Ok(PyBytes::new(forms.py(), &bytes))
}

#[pymethods]
impl PyForm {
    /// Writes the form into a file, ``.json`` exactly, or ``.bpt`` if it is such a patch.
    ///
    /// Raises FormatError when its name ends in something else or the format cannot hold it,
    /// OSError when it cannot be written.
    ///
    /// >>> pf.Form([(0, 0), (1, 2)]).save("segment.json")
    /// >>> pf.load("segment.json")
    /// <pforms.Form pL2 in 2D>
    fn save(&self, path: &Bound<'_, PyAny>) -> PyResult<()> {
        save(self.form.clone().into(), path)
    }
}

/// Writes a form or a spline into a file.
pub(crate) fn save(shape: Shape, path: &Bound<'_, PyAny>) -> PyResult<()> {
    let name = opened(path)?.getattr("name")?.extract::<String>()?;
    let bytes = Format::of_name(&name).and_then(|format| write_forms(format, &[shape.into()]));
    write(path, &bytes.map_err(|error| raised(&error))?)
}
