//! Arrays that go out: new ones, and those of the caller, filled in place.

use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyReadwriteArrayDyn, PyUntypedArrayMethods};
use pforms_kernel::{Error, limit};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyTuple;

use crate::arrays::Shape;
use crate::errors::{ShapeError, fail, mistyped, raised};

/// NumPy allows no more axes.
pub(crate) const MOST_AXES: usize = 64;

/// Numbers in an array that no machine is short of memory for.
const LARGE: usize = 1 << 16;

/// A new array from its numbers in C order.
pub(crate) fn array<'py>(
    py: Python<'py>,
    shape: &[usize],
    values: Vec<f64>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    check_axes(shape)?;
    PyArray1::from_vec(py, values).reshape(shape)
}

/// An array of points filled in place: the caller's `out`, or a new one.
///
/// `shape` is that of the parameters, each with `width` numbers.
///
/// Errors: those of [`Output::new`] and of `fill`.
pub(crate) fn filled<'py>(
    py: Python<'py>,
    shape: &[usize],
    width: Option<usize>,
    out: Option<&Bound<'py, PyAny>>,
    fill: impl FnOnce(&mut [f64]) -> PyResult<()>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let mut output = Output::new(py, shape, width, out)?;
    fill(output.numbers()?)?;
    Ok(output.array())
}

/// An array that nobody else uses while it is written.
pub(crate) struct Output<'py>(PyReadwriteArrayDyn<'py, f64>);

impl<'py> Output<'py> {
    /// The caller's `out`, or a new array, of `width` numbers for each place in `shape`.
    ///
    /// Errors: `ShapeError` when `out` has another shape, type or layout; `LimitError`.
    pub(crate) fn new(
        py: Python<'py>,
        shape: &[usize],
        width: Option<usize>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Self> {
        let limited = limit::check::<f64>("the points", shape, width.unwrap_or(1));
        limited.map_err(|error| raised(&error))?;
        let shape: Shape = shape.iter().copied().chain(width).collect();
        check_axes(&shape)?;
        let array = match out {
            Some(out) => writable(out, &shape)?,
            None => fresh(py, &shape)?,
        };
        array.try_readwrite().map(Self).map_err(|_| ShapeError::new_err(NOT_ALONE))
    }

    pub(crate) fn numbers(&mut self) -> PyResult<&mut [f64]> {
        Ok(self.0.as_slice_mut()?)
    }

    pub(crate) fn array(self) -> Bound<'py, PyArrayDyn<f64>> {
        (**self.0).clone()
    }
}

const NOT_ALONE: &str = "out: received a read-only array or one of the arguments, expected an \
                         array that can be written";

/// An array to be filled. NumPy makes the large ones, since it can say that memory is short.
fn fresh<'py>(py: Python<'py>, shape: &[usize]) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    static EMPTY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    if shape.iter().product::<usize>() < LARGE {
        return Ok(PyArrayDyn::zeros(py, shape, false));
    }
    let array = EMPTY.import(py, "numpy", "empty")?.call1((PyTuple::new(py, shape)?,))?;
    Ok(array.cast_into::<PyArrayDyn<f64>>()?)
}

fn writable<'py>(
    out: &Bound<'py, PyAny>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let expected = format!("a C-contiguous float64 array of shape {shape:?}");
    let Ok(array) = out.cast::<PyArrayDyn<f64>>() else {
        return Err(mistyped("out", out, &expected));
    };
    let plain = array.is_c_contiguous() && array.is_aligned();
    if array.shape() != shape || !plain {
        let layout = if plain { "" } else { ", not C-contiguous" };
        return fail(&Error::shape("out", format!("shape {:?}{layout}", array.shape()), expected));
    }
    Ok(array.clone())
}

/// NumPy has no arrays of more axes.
pub(crate) fn check_axes(shape: &[usize]) -> PyResult<()> {
    if shape.len() <= MOST_AXES {
        return Ok(());
    }
    fail(&Error::shape(
        "array",
        format!("{} axes", shape.len()),
        format!("at most {MOST_AXES}, all that NumPy allows"),
    ))
}
