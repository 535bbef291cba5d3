//! Tubes: a section carried along a path.

use pforms_kernel::Form;
use pforms_operators::{self as operators, FrameKind, Law, Pipe, PipeOptions, Shape, Spline};
use pyo3::prelude::*;
use pyo3::{IntoPyObjectExt, intern};

use crate::arguments::{real, truth, word};
use crate::arrays::Numbers;
use crate::errors::{done, raised, renamed};
use crate::shapes;
use crate::spline::PySpline;

type Object<'py> = Bound<'py, PyAny>;

/// The tube that a section describes along a path: path(u) + radius(u)·(N(u)·x + B(u)·y + T(u)·z).
///
/// Exact along the section and at the centre line; the frame is replaced by polynomials of degree 5
/// on as many pieces as the tolerance asks for, with a proved bound on the distance from the true
/// tube at the same parameters. A closed path makes a closed tube.
///
/// Parameters
/// ----------
/// path : Form or Spline
///     A curve in space or in the plane, without cusps, corners and gaps.
/// section : Form or Spline
///     In 2D: x goes along the normal, y along the binormal; in 3D z goes along the tangent.
/// radius, twist : float, sequence of float, Form or Spline, optional
///     Factor of the section, at least 0, and the angle by which it is turned, in radians. A sequence
///     is the poles of a curve in 1D, which runs over its window as the path runs over its own.
/// frame : "rotation-minimising" or "frenet", optional
///     The first passes inflections and straight stretches without turning over.
/// tolerance : float, optional
///     Largest distance from the true tube; a millionth of its radius if absent.
/// closed : bool, optional
///     Whether the frame is turned, evenly along the path, to close; if absent, when the ends of the
///     path and their tangents agree.
/// report : bool, optional
///     Return a :class:`Pipe` of ``spline``, ``error``, ``bending`` and ``closing``.
///
/// Returns
/// -------
/// Spline, or Pipe if report
///
/// Raises
/// ------
/// ShapeError, DomainError
///     For a path, section, radius or twist of the wrong kind; a radius below 0; NaN.
/// DegenerateError
///     For a path with a cusp, a corner or a gap; where the Frenet frame does not exist; for a
///     section in a plane along the path.
/// AccuracyError, LimitError
///     When the tolerance is out of reach; when the result is too large.
///
/// Examples
/// --------
/// >>> path = pf.Form([(0, 0, 0), (2, 0, 0), (-1, 2, 0), (1, 2, 1)])
/// >>> ribbon = pf.pipe(path, [(-1, 0), (1, 0)], radius=[0.1, 0.3, 0.1], report=True)
/// >>> ribbon.spline.degrees, ribbon.error < 4e-7
/// ((5, 1), True)
#[pyfunction]
#[pyo3(
    signature = (path, section, *, radius=None, twist=None, frame=None, tolerance=None, closed=None, report=None),
    text_signature = "(path, section, *, radius=1, twist=0, frame='rotation-minimising', tolerance=None, closed=None, report=False)"
)]
#[allow(clippy::too_many_arguments)]
pub(crate) fn pipe<'py>(
    path: &Object<'py>,
    section: &Object<'py>,
    radius: Option<&Object<'py>>,
    twist: Option<&Object<'py>>,
    frame: Option<&Object<'py>>,
    tolerance: Option<&Object<'py>>,
    closed: Option<&Object<'py>>,
    report: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let options = PipeOptions {
        radius: radius.map_or(Ok(Law::Constant(1.0)), |given| law("radius", given))?,
        twist: twist.map_or(Ok(Law::Constant(0.0)), |given| law("twist", given))?,
        frame: frame.map_or(Ok(FrameKind::RotationMinimising), kind)?,
        tolerance: tolerance.map(|given| real("tolerance", given)).transpose()?,
        closed: closed.map(|given| truth("closed", given)).transpose()?,
    };
    made(path, section, &options, report)
}

/// A tube whose radius swells and shrinks: :func:`pipe` with the radius
/// radius·(1 + amplitude·sin(2π·periods·u)), u from 0 to 1 along the path.
///
/// Parameters
/// ----------
/// path, section : Form or Spline
/// amplitude : float
///     Share of the radius that waves, at most 1.
/// periods : float
/// radius : float, optional
/// frame, tolerance, report : optional
///     As for :func:`pipe`.
///
/// Returns
/// -------
/// Spline, or Pipe if report
///
/// Raises
/// ------
/// ShapeError, DomainError, DegenerateError, AccuracyError, LimitError
///     As :func:`pipe`.
///
/// Examples
/// --------
/// >>> path = pf.Form([(0, 0, 0), (2, 0, 0), (2, 2, 1)])
/// >>> tube = pf.waving_pipe(path, [(0.2, 0), (0, 0.2), (-0.2, 0)], 0.5, 3)
/// >>> tube.axes
/// 2
#[pyfunction]
#[pyo3(
    signature = (path, section, amplitude, periods, *, radius=None, frame=None, tolerance=None, report=None),
    text_signature = "(path, section, amplitude, periods, *, radius=1, frame='rotation-minimising', tolerance=None, report=False)"
)]
#[allow(clippy::too_many_arguments)]
pub(crate) fn waving_pipe<'py>(
    path: &Object<'py>,
    section: &Object<'py>,
    amplitude: &Object<'py>,
    periods: &Object<'py>,
    radius: Option<&Object<'py>>,
    frame: Option<&Object<'py>>,
    tolerance: Option<&Object<'py>>,
    report: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let mean = radius.map_or(Ok(1.0), |given| real("radius", given))?;
    let (amplitude, periods) = (real("amplitude", amplitude)?, real("periods", periods)?);
    let options = PipeOptions {
        radius: Law::Wave { mean, amplitude, periods },
        frame: frame.map_or(Ok(FrameKind::RotationMinimising), kind)?,
        tolerance: tolerance.map(|given| real("tolerance", given)).transpose()?,
        ..PipeOptions::default()
    };
    made(path, section, &options, report)
}

fn made<'py>(
    path: &Object<'py>,
    section: &Object<'py>,
    options: &PipeOptions,
    report: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let py = path.py();
    let [path, section] = [("path", path), ("section", section)]
        .map(|(name, given)| shapes::read(name, given).map(Shape::into_spline));
    let (path, section): (Spline, Spline) = (path?, section?);
    let report = report.map_or(Ok(false), |given| truth("report", given))?;
    let tube = done(py, usize::MAX, || operators::pipe(&path, &section, options))?;
    if report { reported(py, tube) } else { PySpline::from(tube.spline).into_bound_py_any(py) }
}

fn reported(py: Python<'_>, tube: Pipe) -> PyResult<Object<'_>> {
    let class = py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Pipe"))?;
    class.call1((PySpline::from(tube.spline), tube.error, tube.bending, tube.closing))
}

fn kind(given: &Object<'_>) -> PyResult<FrameKind> {
    Ok(match word("frame", given, &["rotation-minimising", "frenet"])? {
        "frenet" => FrameKind::Frenet,
        _ => FrameKind::RotationMinimising,
    })
}

/// A number, numbers that are the poles of a curve in 1D, or such a curve.
fn law(name: &str, given: &Object<'_>) -> PyResult<Law> {
    if let Ok(numbers) = Numbers::read(name, given) {
        match numbers.shape() {
            [] => return Ok(Law::Constant(numbers.values()[0])),
            [count] => {
                let curve = Form::from_points(&[*count], 1, numbers.values(), None);
                return curve.map(Law::from).map_err(|e| raised(&renamed(e, "points", name)));
            }
            _ => {}
        }
    }
    Ok(shapes::read(name, given)?.into_spline().into())
}
