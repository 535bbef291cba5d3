//! The cap on what one result may occupy.

use pforms_kernel::{Error, limit};
use pyo3::prelude::*;

use crate::arguments::whole;
use crate::errors::fail;

/// Bytes that one result may occupy: 1 GiB until somebody changes it.
///
/// >>> pf.cap()
/// 1073741824
#[pyfunction]
pub(crate) fn cap() -> u64 {
    limit::cap()
}

/// Changes the cap for the whole process; what would be larger raises LimitError.
///
/// Raises DomainError unless it is a whole number above 0.
///
/// >>> pf.set_cap(1000)
/// >>> pf.Form([(0, 0), (1, 2)]).grid(100)
/// Traceback (most recent call last):
/// pforms.LimitError: the points would have 100 poles, 1.6 kB: refused, the cap is 1.0 kB
/// >>> pf.set_cap(2**30)
#[pyfunction]
#[pyo3(signature = (bytes))]
pub(crate) fn set_cap(bytes: &Bound<'_, PyAny>) -> PyResult<()> {
    match whole("bytes", bytes)? {
        0 => fail(&Error::domain("bytes", 0, "a whole number above 0")),
        bytes => {
            limit::set_cap(bytes as u64);
            Ok(())
        }
    }
}
