//! Numbers that come in: whatever NumPy reads as an array of reals, without needless copies.

use std::slice;

use numpy::ndarray::{ArrayViewD, aview0, aview1};
use numpy::{
    PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArray, PyUntypedArrayMethods,
};
use pforms_kernel::limit;
use pyo3::exceptions::{PyOverflowError, PyTypeError, PyValueError};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyInt, PyList, PyTuple};
use smallvec::SmallVec;

use crate::errors::{LimitError, ShapeError, mistyped, raised};
use crate::form::PyForm;
use crate::outputs::MOST_AXES;

/// The shape of an array; those of small ones need no allocation.
pub(crate) type Shape = SmallVec<[usize; 6]>;

/// An array of `f64` in C order: the caller's own when it is one already, else a converted copy.
pub(crate) enum Numbers<'py> {
    Number(f64),
    List { length: usize, values: Vec<f64> },
    Array(PyReadonlyArrayDyn<'py, f64>),
}

impl From<Vec<f64>> for Numbers<'_> {
    fn from(values: Vec<f64>) -> Self {
        Self::List { length: values.len(), values }
    }
}

impl<'py> Numbers<'py> {
    /// Reads an argument: a number, an array of any real type and layout, nested lists.
    ///
    /// Errors: `ArgumentError` for what holds no real numbers, or masks some of them; `ShapeError`
    /// for ragged lists.
    pub(crate) fn read(argument: &str, object: &Bound<'py, PyAny>) -> PyResult<Self> {
        if let Some(number) = plain_number(object) {
            return Ok(Self::Number(number));
        }
        if let Some(values) = plain_numbers(object) {
            return Ok(values.into());
        }
        if is_masked(object)? {
            return Err(mistyped(argument, object, "numbers none of which is masked"));
        }
        if let Ok(array) = object.cast::<PyArrayDyn<f64>>() {
            return Self::borrow(argument, array);
        }
        if let Ok(point) = object.cast::<PyForm>() {
            return Self::of_point(argument, point);
        }
        if object.is_none() {
            return Err(mistyped(argument, object, "numbers"));
        }
        let array = real_array(object).map_err(|error| explained(argument, object, error))?;
        check_size(argument, array.cast::<PyUntypedArray>()?)?;
        let array = to_float(&array).map_err(|error| explained(argument, object, error))?;
        Self::borrow(argument, array.cast::<PyArrayDyn<f64>>()?)
    }

    /// The same, or none where an object is no array of numbers but perhaps a list of others.
    ///
    /// Errors: `LimitError` for an array too large, which would be no smaller item by item.
    pub(crate) fn if_any(argument: &str, object: &Bound<'py, PyAny>) -> PyResult<Option<Self>> {
        match Self::read(argument, object) {
            Ok(numbers) => Ok(Some(numbers)),
            Err(error) if error.is_instance_of::<LimitError>(object.py()) => Err(error),
            Err(_) => Ok(None),
        }
    }

    /// The coordinates of a form without axes.
    fn of_point(argument: &str, point: &Bound<'py, PyForm>) -> PyResult<Self> {
        let form = &point.get().form;
        if form.axes() > 0 {
            return Err(mistyped(argument, point, "numbers, or a form without axes"));
        }
        let values = form.points().map_err(|error| raised(&error))?;
        Ok(values.into())
    }

    fn borrow(argument: &str, array: &Bound<'py, PyArrayDyn<f64>>) -> PyResult<Self> {
        if array.is_c_contiguous() {
            let view = array.try_readonly()?;
            if view.as_slice().is_ok() {
                return Ok(Self::Array(view));
            }
        }
        check_size(argument, array.as_untyped())?;
        let copy = array.call_method0(intern!(array.py(), "copy"))?;
        let copy = copy.cast::<PyArrayDyn<f64>>()?.try_readonly()?;
        copy.as_slice()?;
        Ok(Self::Array(copy))
    }

    pub(crate) fn shape(&self) -> &[usize] {
        match self {
            Self::Number(_) => &[],
            Self::List { length, .. } => slice::from_ref(length),
            Self::Array(array) => array.shape(),
        }
    }

    pub(crate) fn values(&self) -> &[f64] {
        match self {
            Self::Number(number) => slice::from_ref(number),
            Self::List { values, .. } => values,
            Self::Array(array) => array.as_slice().unwrap_or_default(),
        }
    }

    /// The numbers in a list of our own.
    pub(crate) fn into_values(self) -> Vec<f64> {
        match self {
            Self::List { values, .. } => values,
            other => other.values().to_vec(),
        }
    }

    pub(crate) fn view(&self) -> ArrayViewD<'_, f64> {
        match self {
            Self::Number(number) => aview0(number).into_dyn(),
            Self::List { values, .. } => aview1(values).into_dyn(),
            Self::Array(array) => array.as_array(),
        }
    }
}

/// One of Python's own numbers, without a detour through NumPy.
fn plain_number(object: &Bound<'_, PyAny>) -> Option<f64> {
    if let Ok(number) = object.cast::<PyFloat>() {
        return Some(number.value());
    }
    object.cast::<PyInt>().ok().and_then(|number| number.extract().ok())
}

/// A short list of Python's own numbers, likewise.
fn plain_numbers(object: &Bound<'_, PyAny>) -> Option<Vec<f64>> {
    if let Ok(tuple) = object.cast::<PyTuple>() {
        return tuple.iter().map(|item| plain_number(&item)).collect();
    }
    object.cast::<PyList>().ok()?.iter().map(|item| plain_number(&item)).collect()
}

/// `numpy.asarray(object)`, refusing what is no array of real numbers.
fn real_array<'py>(object: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let py = object.py();
    let array = asarray(py)?.call1((object,))?;
    let kind: char =
        array.getattr(intern!(py, "dtype"))?.getattr(intern!(py, "kind"))?.extract()?;
    if "biufO".contains(kind) { Ok(array) } else { Err(PyTypeError::new_err("no real numbers")) }
}

/// `numpy.asarray(array, "float64", "C")`.
fn to_float<'py>(array: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let py = array.py();
    asarray(py)?.call1((array, intern!(py, "float64"), intern!(py, "C")))
}

fn asarray(py: Python<'_>) -> PyResult<&Bound<'_, PyAny>> {
    static ASARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    ASARRAY.import(py, "numpy", "asarray")
}

/// Does an array hide some of its numbers behind a mask?
fn is_masked(object: &Bound<'_, PyAny>) -> PyResult<bool> {
    let array = object.is_instance_of::<PyUntypedArray>();
    if !array || object.is_exact_instance_of::<PyUntypedArray>() {
        return Ok(false);
    }
    match object.getattr_opt(intern!(object.py(), "mask"))? {
        Some(mask) => mask.call_method0(intern!(object.py(), "any"))?.is_truthy(),
        None => Ok(false),
    }
}

/// Complains before a copy above the cap: a broadcast array may be larger than any memory.
fn check_size(argument: &str, array: &Bound<'_, PyUntypedArray>) -> PyResult<()> {
    limit::check::<f64>(argument, array.shape(), 1).map(|_| ()).map_err(|error| raised(&error))
}

/// The same for what may be an array, before its lines are read one by one.
pub(crate) fn check_whole(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<()> {
    object.cast::<PyUntypedArray>().map_or(Ok(()), |array| check_size(argument, array))
}

/// Says what was wrong with an object that NumPy could not convert.
fn explained(argument: &str, object: &Bound<'_, PyAny>, error: PyErr) -> PyErr {
    let py = object.py();
    let ours = error.is_instance_of::<PyValueError>(py)
        || error.is_instance_of::<PyTypeError>(py)
        || error.is_instance_of::<PyOverflowError>(py);
    if !ours {
        return error;
    }
    match ragged(object) {
        Some((depth, lengths)) => ShapeError::new_err(format!(
            "{argument}: received lists of lengths {lengths:?} at depth {depth}, \
             expected lists of one length"
        )),
        None => mistyped(argument, object, "real numbers in an array or nested lists"),
    }
}

/// The first depth at which nested lists differ in length, and the lengths there; a number beside
/// a list counts 0.
fn ragged(object: &Bound<'_, PyAny>) -> Option<(usize, Vec<usize>)> {
    let mut level = vec![object.clone()];
    for depth in 0..MOST_AXES {
        let lengths: Vec<usize> = level.iter().map(|item| length(item).unwrap_or(0)).collect();
        let first = *lengths.first()?;
        if lengths.iter().any(|length| *length != first) {
            return Some((depth, lengths));
        }
        let items = level.iter().filter_map(|item| item.try_iter().ok());
        level = items.take(if first > 0 { level.len() } else { 0 }).flatten().flatten().collect();
    }
    None
}

fn length(object: &Bound<'_, PyAny>) -> Option<usize> {
    let listed = object.is_instance_of::<PyList>() || object.is_instance_of::<PyTuple>();
    let array = object.cast::<PyUntypedArray>().is_ok_and(|array| array.ndim() > 0);
    if listed || array { object.len().ok() } else { None }
}
