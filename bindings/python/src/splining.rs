//! Splines from poles, knots, pieces and points.

use pforms_kernel::{Error, Form};
use pforms_operators::{self as operators, KnotRule, Parameters, Poles, Spline, SplineEnds};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyString, PyTuple};

use crate::arguments::{axis_number, require_idle, truth, whole, wholes, word};
use crate::arrays::Numbers;
use crate::errors::{done, fail, raised};
use crate::form::{PyForm, from_euclidean};
use crate::forms::Forms;
use crate::making::{lists, one_list};
use crate::shapes;
use crate::spline::{PySpline, knot_lists};

/// The B-spline of a net: a window of ``degree + 1`` poles that slides along it.
///
/// Parameters
/// ----------
/// points : array_like, shape (n1, …, nd, c), or Form
///     The poles; a form brings their weights.
/// degree : int or sequence of int, optional
///     Of the pieces, for all axes or one for each.
/// knots : "uniform", "clamped", sequence of float, or one of these for each axis, optional
///     Uniform as in the book: each piece one unit of the parameter. Clamped: from the first pole to
///     the last. Given: poles + degree + 1 knots; for a closed axis one turn, poles + 1.
/// closed : bool or sequence of bool, optional
///     Go on from the last pole to the first.
///
/// Raises
/// ------
/// ShapeError
///     Without more poles than the degree, for clamped knots on a closed axis, wrong numbers of knots.
/// DomainError
///     For knots that decrease or coincide too often.
///
/// Examples
/// --------
/// >>> square = [(0, 0), (0, 2), (2, 2), (2, 0)]
/// >>> pf.bspline(square, 2).pieces[0].poles
/// array([[0., 1.],
///        [0., 2.],
///        [1., 2.]])
/// >>> pf.bspline(square, 3, closed=True)
/// <pforms.Spline of 4 pieces pL4 in 2D>
#[pyfunction]
#[pyo3(
    signature = (points, degree=None, knots=None, *, closed=None),
    text_signature = "(points, degree=3, knots='uniform', *, closed=False)"
)]
pub(crate) fn bspline(
    points: &Bound<'_, PyAny>,
    degree: Option<&Bound<'_, PyAny>>,
    knots: Option<&Bound<'_, PyAny>>,
    closed: Option<&Bound<'_, PyAny>>,
) -> PyResult<PySpline> {
    let net = net("points", points)?;
    let axes = net.axes();
    let degrees = degree.map_or(Ok(vec![3; axes]), |degree| wholes("degree", degree, axes))?;
    let rules = knots.map_or(Ok(vec![KnotRule::Uniform; axes]), |knots| rules(knots, axes))?;
    let closed = closed.map_or(Ok(vec![false; axes]), |closed| {
        each("closed", closed, axes, |one| truth("closed", one))
    })?;
    done(points.py(), net.homogeneous().len(), || {
        operators::bspline(&net, &degrees, &rules, &closed)
    })
    .map(PySpline::from)
}

/// The rational B-spline (NURBS) of poles, weights and full knot vectors.
///
/// The knots say the degree: n poles and m knots make degree m − n − 1. :attr:`Spline.pieces` takes it
/// apart, :func:`concatenate` and :func:`remove_knots` put it together again.
///
/// Parameters
/// ----------
/// poles : array_like, shape (n1, …, nd, c)
/// weights : array_like, shape (n1, …, nd), or None
///     1 for all if None.
/// knots : sequence of float, or one for each axis
///
/// Raises
/// ------
/// ShapeError, DomainError
///     When numbers do not fit; for knots that decrease or coincide too often.
///
/// Examples
/// --------
/// >>> w = 0.5**0.5
/// >>> quarter = pf.nurbs([(1, 0), (1, 1), (0, 1)], [1, w, 1], [0, 0, 0, 1, 1, 1])
/// >>> float(np.hypot(*quarter(0.3)))
/// 1.0
#[pyfunction]
#[pyo3(signature = (poles, weights, knots))]
pub(crate) fn nurbs(
    poles: &Bound<'_, PyAny>,
    weights: &Bound<'_, PyAny>,
    knots: &Bound<'_, PyAny>,
) -> PyResult<PySpline> {
    let py = poles.py();
    let net = if weights.is_none() {
        net("poles", poles)?
    } else {
        let (poles, weights) = (Numbers::read("poles", poles)?, Numbers::read("weights", weights)?);
        from_euclidean("poles", &poles, Some(&weights)).map_err(|error| raised(&error))?
    };
    let knots = knot_lists(knots, net.axes())?;
    done(py, net.homogeneous().len(), || operators::nurbs(net, knots)).map(PySpline::from)
}

/// Forms end to end along an axis, as one spline.
///
/// Degrees that differ are raised. Where the end of a form is the start of the next they share its
/// poles, the weights of the next being scaled to agree; elsewhere the spline has a gap.
///
/// Parameters
/// ----------
/// forms : sequence of Form
/// axis : int, optional
/// breaks : sequence of float, optional
///     Where each begins, and where the last ends; 0, 1, 2, … if absent.
///
/// Raises
/// ------
/// ShapeError, DomainError
///     When axes, spaces or numbers do not fit; for breaks that do not grow.
///
/// Examples
/// --------
/// >>> halves = pf.Form([(0, 0), (1, 2), (2, 0)]).split(0, 0.5)
/// >>> arch = pf.concatenate(halves, breaks=[0, 0.5, 1])
/// >>> pf.remove_knots(arch).net.poles
/// array([[0., 0.],
///        [1., 2.],
///        [2., 0.]])
#[pyfunction]
#[pyo3(signature = (forms, *, axis=None, breaks=None), text_signature = "(forms, *, axis=0, breaks=None)")]
pub(crate) fn concatenate(
    forms: &Bound<'_, PyAny>,
    axis: Option<&Bound<'_, PyAny>>,
    breaks: Option<&Bound<'_, PyAny>>,
) -> PyResult<PySpline> {
    let list = Forms::read("forms", forms)?;
    let all: Vec<Form> = list.refs().into_iter().cloned().collect();
    let axis = axis_number(axis)?;
    let breaks = match breaks {
        Some(breaks) => one_list("breaks", breaks)?,
        None => (0..=all.len()).map(|i| i as f64).collect(),
    };
    let cost = all.iter().map(|form| form.homogeneous().len()).sum();
    done(forms.py(), cost, || Spline::end_to_end(&all, axis, &breaks)).map(PySpline::from)
}

/// A spline through points: the smooth cubic, or the chains of the book.
///
/// The cubic is twice continuously differentiable and solves one system. A chain finds each piece from
/// the one before it, from the poles before the first point; the cubic chain multiplies errors by 3.73
/// from piece to piece.
///
/// Parameters
/// ----------
/// points : array_like, shape (n1, …, nd, c), or Form
///     A row or a net; chains take a row.
/// degree : 3 or 2, optional
/// start : array_like, optional
///     For a chain the pole before the first point, shape (c,), or for degree 3 the two before it,
///     shape (2, c); of degree 2 the first point if absent. A form brings weights.
/// ends : "natural", "clamped", "not-a-knot", "periodic", or one for each axis, optional
///     What the smooth cubic does at its ends.
/// params : "chord", "centripetal", "uniform", or sequences of float, one for each axis, optional
///     Where on the smooth cubic the points lie; a periodic axis needs one more than points.
/// tangents : array_like, shape (2, c), optional
///     The derivatives at the ends of a clamped curve.
/// circle : bool, optional
///     Multiply the middle poles of a chain of degree 2 by √½: points at right angles around a centre
///     then give arcs of circles.
///
/// Raises
/// ------
/// ShapeError, DomainError, DegenerateError
///     When numbers do not fit; for parameters that do not grow; for points that all coincide.
/// ArgumentError
///     For what is given and has no part: tangents of natural ends, parameters of a chain.
///
/// Examples
/// --------
/// >>> curve = pf.interpolating_spline([(0, 0), (1, 1), (2, 0), (3, 1)], params="uniform")
/// >>> curve(1 / 3)
/// array([1., 1.])
/// >>> square = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 0)]
/// >>> circle = pf.interpolating_spline(square, 2, start=(1, -1), circle=True)
/// >>> bool(abs(np.hypot(*circle(0.3)) - 1) < 1e-15)
/// True
#[pyfunction]
#[pyo3(
    signature = (points, degree=None, *, start=None, ends=None, params=None, tangents=None, circle=None),
    text_signature = "(points, degree=3, *, start=None, ends='natural', params='chord', \
                      tangents=None, circle=False)"
)]
pub(crate) fn interpolating_spline(
    points: &Bound<'_, PyAny>,
    degree: Option<&Bound<'_, PyAny>>,
    start: Option<&Bound<'_, PyAny>>,
    ends: Option<&Bound<'_, PyAny>>,
    params: Option<&Bound<'_, PyAny>>,
    tangents: Option<&Bound<'_, PyAny>>,
    circle: Option<&Bound<'_, PyAny>>,
) -> PyResult<PySpline> {
    let py = points.py();
    let net = net("points", points)?;
    let start = start.map(|start| self::net("start", start)).transpose()?;
    let given_circle = circle;
    let circle = circle.map_or(Ok(false), |circle| truth("circle", circle))?;
    let degree = degree.map_or(Ok(3), |degree| whole("degree", degree))?;
    let chain = degree == 2 || start.is_some();
    if chain {
        for (name, given) in [("ends", ends), ("params", params), ("tangents", tangents)] {
            require_idle(name, given, "degree 2, or a start, gives a chain")?;
        }
    }
    if degree == 3 {
        require_idle("circle", given_circle, "arcs are for chains of degree 2")?;
    }
    let cost = 32 * net.homogeneous().len();
    if degree == 2 {
        let before = start.unwrap_or_else(|| net.clone());
        let before = &before.homogeneous()[..before.width()];
        let factor = if circle { 0.5_f64.sqrt() } else { 1.0 };
        return done(py, cost, || operators::quadratic_chain(&net, before, &factor))
            .map(PySpline::from);
    }
    if degree != 3 {
        return fail(&Error::domain("degree", degree, "2 or 3"));
    }
    if let Some(start) = start {
        let poles: Vec<&[f64]> = start.homogeneous().chunks(start.width()).collect();
        let [p, q] = poles[..] else {
            let received = format!("{} poles", poles.len());
            return fail(&Error::shape("start", received, "the two poles before the points"));
        };
        return done(py, cost, || operators::cubic_chain(&net, [p, q])).map(PySpline::from);
    }
    let clamped = tangents.map(|tangents| vectors(tangents, net.ambient())).transpose()?;
    let ends = match ends {
        Some(ends) => each("ends", ends, net.axes(), |one| end(one, clamped.as_ref()))?,
        None => vec![SplineEnds::Natural; net.axes()],
    };
    if !ends.iter().any(|end| matches!(end, SplineEnds::Clamped(..))) {
        require_idle("tangents", tangents, "no end is \"clamped\"")?;
    }
    let rule = params.map_or(Ok(Parameters::Chord), crate::making::read_parameters)?;
    done(py, cost, || {
        let periodic: Vec<bool> = ends.iter().map(|ends| *ends == SplineEnds::Periodic).collect();
        let lists = match rule {
            Parameters::Given(lists) => lists,
            rule => operators::spline_parameters(&net, &rule, &periodic)?,
        };
        operators::interpolating_spline(&net, &lists, &ends)
    })
    .map(PySpline::from)
}

fn end(one: &Bound<'_, PyAny>, clamped: Option<&[Vec<f64>; 2]>) -> PyResult<SplineEnds> {
    let known = ["natural", "clamped", "not-a-knot", "periodic"];
    Ok(match word("ends", one, &known)? {
        "clamped" => match clamped {
            Some([start, end]) => SplineEnds::Clamped(start.clone(), end.clone()),
            None => return fail(&Error::shape("tangents", "none", "two vectors for clamped ends")),
        },
        "not-a-knot" => SplineEnds::NotAKnot,
        "periodic" => SplineEnds::Periodic,
        _ => SplineEnds::Natural,
    })
}

/// Two vectors, homogeneous: their weight does not change.
fn vectors(tangents: &Bound<'_, PyAny>, ambient: usize) -> PyResult<[Vec<f64>; 2]> {
    let numbers = Numbers::read("tangents", tangents)?;
    if numbers.shape() != [2, ambient] {
        let received = format!("an array of shape {:?}", numbers.shape());
        return fail(&Error::shape("tangents", received, format!("shape (2, {ambient})")));
    }
    let (start, end) = numbers.values().split_at(ambient);
    Ok([start, end].map(|vector| [vector, &[0.0]].concat()))
}

/// The poles of a form, or an array of points.
fn net(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<Form> {
    if let Ok(form) = object.cast::<PyForm>() {
        return Ok(form.get().form.clone());
    }
    Ok(shapes::read(argument, object)?.net().clone())
}

/// A rule for the knots of each axis.
fn rules(knots: &Bound<'_, PyAny>, axes: usize) -> PyResult<Vec<KnotRule>> {
    let one = |one: &Bound<'_, PyAny>| -> PyResult<KnotRule> {
        if one.is_instance_of::<PyString>() {
            return Ok(match word("knots", one, &["uniform", "clamped"])? {
                "clamped" => KnotRule::Clamped,
                _ => KnotRule::Uniform,
            });
        }
        one_list("knots", one).map(KnotRule::Given)
    };
    let numbers = !knots.is_instance_of::<PyString>()
        && knots.get_item(0).is_ok_and(|first| first.len().is_err());
    if numbers {
        let list = lists("knots", knots)?.swap_remove(0);
        return Ok(vec![KnotRule::Given(list); axes]);
    }
    each("knots", knots, axes, one)
}

/// One value for all axes, or a list or tuple with one for each.
fn each<T: Clone>(
    argument: &str,
    object: &Bound<'_, PyAny>,
    axes: usize,
    one: impl Fn(&Bound<'_, PyAny>) -> PyResult<T>,
) -> PyResult<Vec<T>> {
    if !object.is_instance_of::<PyList>() && !object.is_instance_of::<PyTuple>() {
        return Ok(vec![one(object)?; axes]);
    }
    let count = object.len()?;
    if count != axes {
        let expected = format!("{axes}, one for each axis");
        return fail(&Error::shape(argument, format!("{count} values"), expected));
    }
    object.try_iter()?.map(|item| one(&item?)).collect()
}
