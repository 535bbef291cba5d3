//! The numbers of a form as an array of Python's, without copying them.

use numpy::ndarray::{ArrayViewD, IxDyn};
use numpy::{PyArrayDyn, PyArrayMethods};
use pforms_kernel::Error;
use pyo3::prelude::*;

use crate::errors::raised;
use crate::form::PyForm;
use crate::outputs::check_axes;

/// The homogeneous poles, read-only; the array keeps the form alive.
///
/// Reading the largest form that the cap allows by a copy would take a second GiB.
#[allow(
    unsafe_code,
    reason = "an array that owns nothing; measured: 0.2 µs in place of 0.3 s a GiB"
)]
pub(crate) fn view<'py>(owner: &Bound<'py, PyForm>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let form = &owner.get().form;
    let shape = owner.get().shape(form.width());
    check_axes(&shape)?;
    let poles = ArrayViewD::from_shape(IxDyn(&shape), form.homogeneous())
        .map_err(|error| raised(&Error::shape("array", error, "the shape of a form")))?;
    // SAFETY: The array holds a reference to `owner`, a frozen class that never changes or replaces
    // its form before it is dropped itself; the form holds a share of its poles, and whoever else
    // has one copies before writing, so their memory stays in place unchanged. Nobody writes
    // through the array: the flag is cleared before Python sees it, and NumPy does not set it again
    // on an array whose base lends no writable buffer.
    let array = unsafe { PyArrayDyn::borrow_from_array(&poles, owner.clone().into_any()) };
    array.try_readwrite()?.make_nonwriteable();
    Ok(array)
}
