//! Settings of the whole process: what one result may occupy, how many threads work.

use pforms_kernel::{Error, limit, threads as kernel};
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
    limit::set_cap(positive("bytes", bytes)? as u64);
    Ok(())
}

/// How many threads large work is spread over: the processors of the process, unless limited.
///
/// Small work stays on one, and results have the same bits on any number.
///
/// >>> pf.threads() >= 1
/// True
#[pyfunction]
pub(crate) fn threads() -> usize {
    kernel::count()
}

/// Limits the threads of the whole process; None stands for as many as there are processors.
///
/// Raises DomainError unless it is a whole number above 0.
///
/// >>> pf.set_threads(1)
/// >>> pf.threads()
/// 1
/// >>> pf.set_threads(None)
#[pyfunction]
#[pyo3(signature = (count))]
pub(crate) fn set_threads(count: &Bound<'_, PyAny>) -> PyResult<()> {
    kernel::limit(if count.is_none() { usize::MAX } else { positive("count", count)? });
    Ok(())
}

fn positive(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<usize> {
    match whole(argument, object)? {
        0 => fail(&Error::domain(argument, 0, "a whole number above 0")),
        number => Ok(number),
    }
}
