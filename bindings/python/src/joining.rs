//! More knots and fewer; how smoothly forms meet; forms made to meet.

use pforms_kernel::Error;
use pforms_operators::{
    self as operators, Continuity, ContinuityOptions, FormEnd, Poles, Shape, Smoothness,
};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};
use pyo3::{IntoPyObjectExt, intern};

use crate::arguments::{axis_number, real, require_idle, truth, whole, wholes, word};
use crate::arrays::Numbers;
use crate::errors::{done, fail};
use crate::making::one_list;
use crate::outputs::array;
use crate::shapes;
use crate::spline::PySpline;

/// The same spline with more knots, and so with more poles; nothing moves.
///
/// Parameters
/// ----------
/// spline : Spline or Form
/// knots : float or sequence of float
///     A repeated one is inserted as often as it is given.
/// axis : int, optional
///
/// Raises
/// ------
/// ShapeError, DomainError
///     When there is no such axis; for knots outside the window or more often than degree + 1 times.
///
/// Examples
/// --------
/// >>> pf.insert_knots(pf.Form([(0,), (4,)]), 0.25).net.poles.ravel()
/// array([0., 1., 4.])
#[pyfunction]
#[pyo3(signature = (spline, knots, *, axis=None), text_signature = "(spline, knots, *, axis=0)")]
pub(crate) fn insert_knots(
    spline: &Bound<'_, PyAny>,
    knots: &Bound<'_, PyAny>,
    axis: Option<&Bound<'_, PyAny>>,
) -> PyResult<PySpline> {
    let whole = shapes::read("spline", spline)?.into_spline();
    let (knots, axis) = (some_numbers("knots", knots)?, axis_number(axis)?);
    let cost = whole.net().homogeneous().len() * (knots.len() + 1);
    done(spline.py(), cost, || whole.insert_knots(axis, &knots)).map(PySpline::from)
}

/// The same spline without knots that it can spare.
///
/// Parameters
/// ----------
/// spline : Spline or Form
/// knots : float or sequence of float, optional
///     Every knot that can be spared if absent.
/// axis : int, optional
/// accuracy : float, optional
///     How far poles may move, relative to the largest coordinate.
/// report : bool, optional
///     Return a :class:`Simplified` of ``spline`` and ``error``.
///
/// Raises
/// ------
/// AccuracyError
///     When a given knot is needed.
/// ShapeError, DomainError
///     When there is no such axis; for what is no inner knot.
///
/// Examples
/// --------
/// >>> quarters = pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(2)
/// >>> pf.remove_knots(quarters).net
/// <pforms.Form pL3 in 2D>
#[pyfunction]
#[pyo3(
    signature = (spline, knots=None, *, axis=None, accuracy=None, report=None),
    text_signature = "(spline, knots=None, *, axis=0, accuracy=1e-12, report=False)"
)]
pub(crate) fn remove_knots<'py>(
    spline: &Bound<'py, PyAny>,
    knots: Option<&Bound<'py, PyAny>>,
    axis: Option<&Bound<'py, PyAny>>,
    accuracy: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = spline.py();
    let whole = shapes::read("spline", spline)?.into_spline();
    let knots = knots.map(|knots| some_numbers("knots", knots)).transpose()?;
    let accuracy = accuracy.map_or(Ok(1e-12), |accuracy| real("accuracy", accuracy))?;
    let (axis, report) = (axis_number(axis)?, read_report(report)?);
    let found = done(py, usize::MAX, || {
        operators::remove_knots(&whole, axis, knots.as_deref(), &accuracy)
    })?;
    let spline = PySpline::from(found.spline).into_bound_py_any(py)?;
    if report { record(py, "Simplified", (spline, found.error)) } else { Ok(spline) }
}

/// How smoothly two forms meet, or a spline at its joints: C^k and G^k, with the gaps.
///
/// Both are looked at in the direction from ``f`` to ``g``; edges of surfaces may run either way. Along
/// an edge the gaps are the largest at more parameters than the degree.
///
/// Parameters
/// ----------
/// f : Form or Spline
/// g : Form or Spline, optional
///     Without it ``f`` is looked at where its pieces meet, and where it closes.
/// at : (int, int) or ((int, int), (int, int)), optional
///     Ends that meet, 0 or 1, of axis 0; or an axis and an end of each form. The end of ``f`` and the
///     start of ``g`` if absent.
/// order : int, optional
///     The highest order looked at, at most 16.
/// accuracy : float, optional
///     Below it a gap counts as none, relative to what is compared.
/// axis : int, optional
///     That along which the pieces of one spline meet.
///
/// Returns
/// -------
/// Continuity, or list of (float, Continuity)
///     For one spline each joint comes with its parameter.
///
/// Raises
/// ------
/// ShapeError, DomainError
///     When axes or spaces differ; where a form goes to infinity.
///
/// Examples
/// --------
/// >>> f, g = pf.Form([(0, 0), (1, 0), (2, 1)]), pf.Form([(2, 1), (4, 3), (4, 5)])
/// >>> joint = pf.continuity(f, g)
/// >>> joint.parametric, joint.geometric
/// (0, 1)
/// >>> cubic = pf.bspline([(0, 0), (1, 2), (2, 0), (3, 2), (4, 0)], 3)
/// >>> [(t, joint.parametric) for t, joint in pf.continuity(cubic)]
/// [(1.0, 2)]
#[pyfunction]
#[pyo3(
    signature = (f, g=None, *, at=None, order=None, accuracy=None, axis=None),
    text_signature = "(f, g=None, *, at=None, order=2, accuracy=1e-9, axis=0)"
)]
pub(crate) fn continuity<'py>(
    f: &Bound<'py, PyAny>,
    g: Option<&Bound<'py, PyAny>>,
    at: Option<&Bound<'py, PyAny>>,
    order: Option<&Bound<'py, PyAny>>,
    accuracy: Option<&Bound<'py, PyAny>>,
    axis: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = f.py();
    let first = shapes::read("f", f)?;
    let usual = ContinuityOptions::default();
    let options = ContinuityOptions {
        order: order.map_or(Ok(usual.order), |order| whole("order", order))?,
        accuracy: accuracy.map_or(Ok(usual.accuracy), |accuracy| real("accuracy", accuracy))?,
    };
    let Some(g) = g else {
        require_idle("at", at, "without g all joints of f are looked at")?;
        let (spline, axis) = (first.into_spline(), axis_number(axis)?);
        let joints = done(py, usize::MAX, || operators::joints(&spline, axis, options))?;
        let pairs = joints.into_iter().map(|(t, joint)| Ok((t, reported(py, joint)?)));
        return Ok(PyList::new(py, pairs.collect::<PyResult<Vec<_>>>()?)?.into_any());
    };
    require_idle("axis", axis, "with g it is at that names the axes")?;
    let (second, at) = (shapes::read("g", g)?, ends(at)?);
    let joint = done(py, usize::MAX, || operators::continuity(&first, &second, at, options))?;
    reported(py, joint)
}

/// Two forms made to meet smoothly, by moving poles near the joint as little as may be.
///
/// Parameters
/// ----------
/// f, g : Form or Spline
///     Curves, or polynomial surfaces and volumes with the same degrees along the edge.
/// order : int, optional
///     1 makes tangents agree, 2 curvatures.
/// kind : "geometric" or "parametric", optional
///     Parametric continuity makes the derivatives agree.
/// moving : (int, int), optional
///     How many rows of poles of each may move, counted from the joint; ``order + 1`` if absent.
/// at : (int, int) or ((int, int), (int, int)), optional
///     As for :func:`continuity`.
///
/// Returns
/// -------
/// Joined
///     ``f``, ``g``, and ``moved``: the largest distance by which a pole was moved.
///
/// Raises
/// ------
/// DegenerateError
///     When the poles that may move cannot do it, or an end has no tangent.
/// ShapeError, DomainError
///     When the forms do not fit together; for rational surfaces.
///
/// Examples
/// --------
/// >>> f, g = pf.Form([(0, 0), (1, 1), (2, 1)]), pf.Form([(2, 1), (3, 2), (4, 0)])
/// >>> pf.join_forms(f, g, kind="parametric", moving=(0, 2)).g.poles
/// array([[2., 1.],
///        [3., 1.],
///        [4., 0.]])
#[pyfunction]
#[pyo3(
    signature = (f, g, order=None, *, kind=None, moving=None, at=None),
    text_signature = "(f, g, order=1, *, kind='geometric', moving=None, at=None)"
)]
pub(crate) fn join_forms<'py>(
    f: &Bound<'py, PyAny>,
    g: &Bound<'py, PyAny>,
    order: Option<&Bound<'py, PyAny>>,
    kind: Option<&Bound<'py, PyAny>>,
    moving: Option<&Bound<'py, PyAny>>,
    at: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = f.py();
    let (first, second) = (shapes::read("f", f)?, shapes::read("g", g)?);
    let order = order.map_or(Ok(1), |order| whole("order", order))?;
    let kind =
        kind.map_or(Ok("geometric"), |kind| word("kind", kind, &["geometric", "parametric"]))?;
    let smoothness = match kind {
        "parametric" => Smoothness::Parametric(order),
        _ => Smoothness::Geometric(order),
    };
    let at = ends(at)?;
    let moving = match moving {
        Some(moving) => match wholes("moving", moving, 2)?[..] {
            [a, b] => [a, b],
            ref other => return fail(&Error::shape("moving", other.len(), "two numbers of rows")),
        },
        None => [reach(&first, at[0], order), reach(&second, at[1], order)],
    };
    let joined =
        done(py, usize::MAX, || operators::join_forms(&first, &second, at, smoothness, moving))?;
    let (f, g) = (shapes::object(py, joined.f)?, shapes::object(py, joined.g)?);
    record(py, "Joined", (f, g, joined.moved))
}

/// Rows of poles that a joint of this order is made of.
fn reach(shape: &Shape, end: FormEnd, order: usize) -> usize {
    let spline = shape.clone().into_spline();
    let rows = spline.knots().get(end.axis).map_or(0, |knots| knots.degree() + 1);
    rows.min(order.saturating_add(1)).min(shape.net().pole_count())
}

fn ends(at: Option<&Bound<'_, PyAny>>) -> PyResult<[FormEnd; 2]> {
    let Some(at) = at else { return Ok([FormEnd::end(0), FormEnd::start(0)]) };
    let numbers = Numbers::read("at", at)?;
    let end = |axis: f64, end: f64| match end {
        _ if axis < 0.0 || axis.fract() != 0.0 => None,
        0.0 => Some(FormEnd::start(axis as usize)),
        1.0 => Some(FormEnd::end(axis as usize)),
        _ => None,
    };
    let both = match *numbers.values() {
        [f, g] => end(0.0, f).zip(end(0.0, g)),
        [f_axis, f, g_axis, g] => end(f_axis, f).zip(end(g_axis, g)),
        _ => None,
    };
    match both {
        Some((f, g)) => Ok([f, g]),
        None => fail(&Error::domain(
            "at",
            format!("{:?}", numbers.values()),
            "two ends, 0 or 1, or an axis and an end of each form",
        )),
    }
}

fn reported(py: Python<'_>, joint: Continuity) -> PyResult<Bound<'_, PyAny>> {
    let gaps = |list: Vec<f64>| array(py, &[list.len()], list);
    let (parametric, geometric) = (gaps(joint.parametric_gaps)?, gaps(joint.geometric_gaps)?);
    record(py, "Continuity", (joint.parametric, joint.geometric, parametric, geometric))
}

/// A record of the package.
pub(crate) fn record<'py>(
    py: Python<'py>,
    name: &str,
    entries: impl IntoPyObject<'py, Target = PyTuple, Output = Bound<'py, PyTuple>, Error = PyErr>,
) -> PyResult<Bound<'py, PyAny>> {
    let class = py.import(intern!(py, "pforms.records"))?.getattr(name)?;
    class.call1(entries.into_pyobject(py)?)
}

pub(crate) fn read_report(report: Option<&Bound<'_, PyAny>>) -> PyResult<bool> {
    report.map_or(Ok(false), |report| truth("report", report))
}

/// A number, or several.
fn some_numbers(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    if let Ok(number) = real(argument, object) {
        return Ok(vec![number]);
    }
    one_list(argument, object)
}
