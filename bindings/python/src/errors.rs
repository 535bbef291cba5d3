//! The kernel's errors as Python exceptions, and the one door through which work is done.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;
use std::time::{Duration, Instant};

use pforms_kernel::stopping::stoppable;
use pforms_kernel::{Error, Fault, Result};
use pyo3::prelude::*;
use pyo3::types::PyType;

pyo3::import_exception!(pforms.errors, PformsError);
pyo3::import_exception!(pforms.errors, ShapeError);
pyo3::import_exception!(pforms.errors, ArgumentError);
pyo3::import_exception!(pforms.errors, DomainError);
pyo3::import_exception!(pforms.errors, DegenerateError);
pyo3::import_exception!(pforms.errors, AccuracyError);
pyo3::import_exception!(pforms.errors, FormatError);
pyo3::import_exception!(pforms.errors, LimitError);

/// Multiplications below which giving the lock away costs more than it brings.
const LOCK_WORTH: usize = 1 << 14;

/// How long a signal may wait: taking the lock to look for one costs something too.
const PATIENCE: Duration = Duration::from_millis(50);

/// The exception of the same name.
pub(crate) fn raised(error: &Error) -> PyErr {
    let message = error.to_string();
    match error {
        Error::Shape(_) => ShapeError::new_err(message),
        Error::Domain(_) => DomainError::new_err(message),
        Error::Degenerate(_) => DegenerateError::new_err(message),
        Error::Accuracy(_) => AccuracyError::new_err(message),
        Error::Format { .. } => FormatError::new_err(message),
        Error::Limit { .. } => LimitError::new_err(message),
        Error::Stopped => PformsError::new_err(message),
    }
}

/// Does a job of about `cost` multiplications, without Python's lock when that is worth it, and
/// translates what goes wrong.
///
/// A panic would be a defect of pforms: it becomes an ordinary exception that says so.
pub(crate) fn done<T: Send>(
    py: Python<'_>,
    cost: usize,
    job: impl FnOnce() -> Result<T> + Send,
) -> PyResult<T> {
    let job = || catch_unwind(AssertUnwindSafe(job));
    let outcome = if cost < LOCK_WORTH { job() } else { py.detach(|| interruptible(job))? };
    match outcome {
        Ok(result) => result.map_err(|error| raised(&error)),
        Err(_) => Err(PformsError::new_err(
            "a defect of pforms, not of the call: please report it with the call that caused it",
        )),
    }
}

/// Does a job that ends when Python has a signal to handle, with what the signal raises.
fn interruptible<T>(job: impl FnOnce() -> T) -> PyResult<T> {
    let raised = Rc::new(Cell::new(None));
    let (heard, last) = (Rc::clone(&raised), Cell::new(Instant::now()));
    let asked = move || {
        if last.get().elapsed() < PATIENCE {
            return false;
        }
        last.set(Instant::now());
        let Err(signal) = Python::attach(signals) else {
            return false;
        };
        heard.set(Some(signal));
        true
    };
    let (answer, _) = stoppable(asked, job);
    raised.take().map_or(Ok(answer), Err)
}

fn signals(py: Python<'_>) -> PyResult<()> {
    py.check_signals()
}

/// The error under the name by which the caller knows the argument.
pub(crate) fn renamed(error: Error, name: &str, known: &str) -> Error {
    let rename = |mut fault: Fault| {
        if fault.argument == name {
            known.clone_into(&mut fault.argument);
        }
        fault
    };
    match error {
        Error::Shape(fault) => Error::Shape(rename(fault)),
        Error::Domain(fault) => Error::Domain(rename(fault)),
        Error::Degenerate(fault) => Error::Degenerate(rename(fault)),
        other => other,
    }
}

/// Raises a kernel error made here.
pub(crate) fn fail<T>(error: &Error) -> PyResult<T> {
    Err(raised(error))
}

/// An argument of the wrong type: `poles: received a str, expected …`.
pub(crate) fn mistyped(argument: &str, object: &Bound<'_, PyAny>, expected: &str) -> PyErr {
    let received = type_name(object);
    ArgumentError::new_err(format!("{argument}: received {received}, expected {expected}"))
}

/// `None`, or the name of the type with its article.
pub(crate) fn type_name(object: &Bound<'_, PyAny>) -> String {
    if object.is_none() {
        return "None".to_owned();
    }
    let name = match object.cast::<PyType>() {
        Ok(class) => return format!("the type {}", name_of(class)),
        Err(_) => name_of(&object.get_type()),
    };
    let article = if name.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
    format!("{article} {name}")
}

fn name_of(class: &Bound<'_, PyType>) -> String {
    class.name().map_or_else(|_| "?".to_owned(), |name| name.to_string())
}
