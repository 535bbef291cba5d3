//! Lengths of curves, and curves by their length.

use pforms_operators::{self as operators, ArcLength, Spline};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

use crate::arguments::real;
use crate::arrays::Numbers;
use crate::errors::{done, raised};
use crate::joining::{read_report, record};
use crate::outputs::array;
use crate::shapes;
use crate::spline::PySpline;

/// The length of a curve, to ``accuracy`` relative to itself, with a bound of the error.
///
/// Gauss with 16 points on windows where the speed is shown to be analytic.
///
/// Parameters
/// ----------
/// curve : Form or Spline
/// a, b : float, optional
///     From one parameter to another; the window if absent. Beyond it the curve goes on.
/// accuracy : float, optional
/// report : bool, optional
///     Return a :class:`Length` of ``length`` and ``error``.
///
/// Raises
/// ------
/// ShapeError, DomainError
///     For what is no curve; for a curve that goes to infinity.
/// AccuracyError
///     When the accuracy cannot be had.
///
/// Examples
/// --------
/// >>> pf.arc_length(pf.Form([(0, 0), (3, 4)]))
/// 5.0
/// >>> quarter = pf.Form([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
/// >>> abs(pf.arc_length(quarter) - np.pi / 2) < 1e-15
/// True
#[pyfunction]
#[pyo3(
    signature = (curve, a=None, b=None, *, accuracy=None, report=None),
    text_signature = "(curve, a=None, b=None, *, accuracy=1e-12, report=False)"
)]
pub(crate) fn arc_length<'py>(
    curve: &Bound<'py, PyAny>,
    a: Option<&Bound<'py, PyAny>>,
    b: Option<&Bound<'py, PyAny>>,
    accuracy: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = curve.py();
    let whole = shapes::read("curve", curve)?.into_spline();
    let a = a.map(|a| real("a", a)).transpose()?;
    let b = b.map(|b| real("b", b)).transpose()?;
    let (accuracy, report) = (read_accuracy(accuracy, 1e-12)?, read_report(report)?);
    let (length, error) = done(py, usize::MAX, || {
        let Some(part) = part_of(whole, a, b)? else { return Ok((0.0, 0.0)) };
        let measured = ArcLength::new(part, accuracy)?;
        Ok((measured.length(), measured.error()))
    })?;
    if report { record(py, "Length", (length, error)) } else { length.into_bound_py_any(py) }
}

/// The curve from `a` to `b`, in either direction; `None` when they are the same.
fn part_of(curve: Spline, a: Option<f64>, b: Option<f64>) -> pforms_kernel::Result<Option<Spline>> {
    if a.is_none() && b.is_none() || curve.axes() != 1 {
        return Ok(Some(curve));
    }
    let (start, end) = curve.window(0)?;
    let (from, to) = (a.unwrap_or(start), b.unwrap_or(end));
    if from == to {
        return Ok(None);
    }
    curve.restrict(0, &from.min(to), &from.max(to)).map(Some)
}

/// The parameters to which a curve has gone given lengths from its start.
///
/// Parameters
/// ----------
/// curve : Form or Spline
/// length : float or array_like
/// accuracy : float, optional
///     Relative to the length of the curve.
///
/// Returns
/// -------
/// float, or ndarray of the shape of ``length``
///
/// Raises
/// ------
/// DomainError
///     For lengths that are negative or beyond the end.
///
/// Examples
/// --------
/// >>> pf.parameter_at_length(pf.Form([(0, 0), (3, 4)]), 2.5)
/// 0.5
#[pyfunction]
#[pyo3(
    signature = (curve, length, *, accuracy=None),
    text_signature = "(curve, length, *, accuracy=1e-12)"
)]
pub(crate) fn parameter_at_length<'py>(
    curve: &Bound<'py, PyAny>,
    length: &Bound<'py, PyAny>,
    accuracy: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = curve.py();
    let whole = shapes::read("curve", curve)?;
    let lengths = Numbers::read("length", length)?;
    let accuracy = read_accuracy(accuracy, 1e-12)?;
    let measured = done(py, usize::MAX, || ArcLength::new(whole, accuracy))?;
    let found = lengths.values().iter().map(|length| measured.parameter(*length));
    let found = found.collect::<pforms_kernel::Result<Vec<f64>>>();
    let found = found.map_err(|error| raised(&error))?;
    match (lengths.shape(), &found[..]) {
        ([], [parameter]) => parameter.into_bound_py_any(py),
        (shape, _) => Ok(array(py, shape, found)?.into_any()),
    }
}

/// The same curve run through at unit speed: a spline over the window from 0 to its length.
///
/// Every point stays on the curve; the speed differs from 1 by no more than ``accuracy``. The degree
/// is 5 times that of the curve.
///
/// Parameters
/// ----------
/// curve : Form or Spline
/// accuracy : float, optional
/// report : bool, optional
///     Return a :class:`UnitSpeed` of ``spline``, ``length`` and ``error``.
///
/// Raises
/// ------
/// DegenerateError
///     Where the curve stands still.
/// ShapeError, DomainError, AccuracyError
///     For what is no curve; for one that goes to infinity; when the accuracy cannot be reached.
///
/// Examples
/// --------
/// >>> even = pf.by_arc_length(pf.Form([(0, 0), (3, 4)]))
/// >>> even(2.5)
/// array([1.5, 2. ])
#[pyfunction]
#[pyo3(
    signature = (curve, *, accuracy=None, report=None),
    text_signature = "(curve, *, accuracy=1e-9, report=False)"
)]
pub(crate) fn by_arc_length<'py>(
    curve: &Bound<'py, PyAny>,
    accuracy: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = curve.py();
    let whole = shapes::read("curve", curve)?;
    let (accuracy, report) = (read_accuracy(accuracy, 1e-9)?, read_report(report)?);
    let even = done(py, usize::MAX, || operators::by_arc_length(whole, accuracy))?;
    let spline = PySpline::from(even.spline).into_bound_py_any(py)?;
    if report { record(py, "UnitSpeed", (spline, even.length, even.error)) } else { Ok(spline) }
}

fn read_accuracy(accuracy: Option<&Bound<'_, PyAny>>, usual: f64) -> PyResult<f64> {
    accuracy.map_or(Ok(usual), |accuracy| real("accuracy", accuracy))
}
