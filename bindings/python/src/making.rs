//! Forms from data: through given points, or near them.

use numpy::PyUntypedArray;
use pforms_kernel::{Error, Form, Result};
use pforms_operators::{self as operators, Fit, FitOptions, Nodes, Parameters};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyString, PyTuple};
use pyo3::{IntoPyObjectExt, intern};

use crate::arguments::{truth, wholes, word};
use crate::arrays::Numbers;
use crate::errors::{done, fail, raised, renamed};
use crate::form::{PyForm, from_euclidean, from_homogeneous};
use crate::outputs::array;
use crate::slices::require_feasible;

/// The form of the same orders through a net of points, at the nodes of each axis.
///
/// Parameters
/// ----------
/// net : array_like, shape (n1, …, nd, c), or Form
///     The points, or a form whose poles are the points.
/// nodes : "uniform", "chebyshev", "lobatto", or sequences of float, one for each axis
///     Parameters at which the points are met; for a curve a plain list will do.
/// homogeneous : bool, optional
///     Interpolate all homogeneous coordinates, the weight too: an array then has c+1 of them.
///
/// Returns
/// -------
/// Form
///
/// Raises
/// ------
/// DegenerateError
///     When two nodes of an axis coincide.
/// ShapeError, DomainError
///     When their number is not the order; for NaN, and for points at infinity.
/// LimitError
///     Above 1e11 multiplications.
///
/// Examples
/// --------
/// >>> parabola = pf.interpolate([(0, 0), (1, 1), (2, 0)])
/// >>> parabola(0.5)
/// array([1., 1.])
#[pyfunction]
#[pyo3(
    signature = (net, nodes=None, homogeneous=None),
    text_signature = "(net, nodes='uniform', homogeneous=False)"
)]
pub(crate) fn interpolate(
    net: &Bound<'_, PyAny>,
    nodes: Option<&Bound<'_, PyAny>>,
    homogeneous: Option<&Bound<'_, PyAny>>,
) -> PyResult<PyForm> {
    let py = net.py();
    let homogeneous = homogeneous.map_or(Ok(false), |given| truth("homogeneous", given))?;
    let net = read_net(net, homogeneous)?;
    let nodes = nodes.map_or(Ok(Nodes::Uniform), read_nodes)?;
    let orders = net.orders().iter().map(|&order| order as f64);
    let passes = orders.map(|order| order * (order * order + net.homogeneous().len() as f64));
    let cost = passes.sum();
    require_feasible("the interpolation", cost)?;
    let solved = done(py, cost as usize, || {
        if homogeneous {
            operators::interpolate_homogeneous(&net, &nodes)
        } else {
            operators::interpolate(&net, &nodes)
        }
    });
    solved.map(PyForm::from)
}

fn read_net(net: &Bound<'_, PyAny>, homogeneous: bool) -> PyResult<Form> {
    if let Ok(form) = net.cast::<PyForm>() {
        return Ok(form.get().form.clone());
    }
    let numbers = Numbers::read("net", net)?;
    let form = if homogeneous {
        from_homogeneous("net", &numbers)
    } else {
        from_euclidean("net", &numbers, None)
    };
    form.map_err(|error| raised(&error))
}

fn read_nodes(nodes: &Bound<'_, PyAny>) -> PyResult<Nodes> {
    if !nodes.is_instance_of::<PyString>() {
        return lists("nodes", nodes).map(Nodes::Given);
    }
    Ok(match word("nodes", nodes, &["uniform", "chebyshev", "lobatto"])? {
        "chebyshev" => Nodes::Chebyshev,
        "lobatto" => Nodes::Lobatto,
        _ => Nodes::Uniform,
    })
}

/// The form of given orders nearest to points, in the sense of least squares.
///
/// Parameters
/// ----------
/// points : array_like, shape (m1, …, md, c) or (m, c)
///     A grid, or scattered points whose parameters are then given.
/// orders : int or sequence of int
///     For all axes of the grid, or one for each.
/// params : "chord", "centripetal", "uniform", or sequences of float, one for each axis
///     Parameters of the points; for a curve a plain list will do.
/// weights : array_like, shape (m1, …, md), optional
///     How often the square distance of each point counts.
/// ends : bool, optional
///     Pass exactly through the first and last points of every axis.
/// report : bool, optional
///     Return a :class:`Fit` of ``form``, ``parameters``, ``max_error`` and ``rms_error``.
///
/// Returns
/// -------
/// Form, or Fit if report
///
/// Raises
/// ------
/// DegenerateError
///     With fewer points than poles, and for coincident parameters.
/// ShapeError, DomainError, LimitError
///     When counts do not fit; for NaN and negative weights; when too large.
///
/// Examples
/// --------
/// >>> near = pf.fit([(0, 0), (1, 0.9), (2, 1.1), (3, 0)], 3, ends=True)
/// >>> near(0), near(1)
/// (array([0., 0.]), array([3., 0.]))
/// >>> pf.fit([(0, 0), (1, 1), (3, 3)], 2, report=True).max_error < 1e-15
/// True
#[pyfunction]
#[pyo3(
    signature = (points, orders, params=None, *, weights=None, ends=None, report=None),
    text_signature = "(points, orders, params='chord', *, weights=None, ends=False, report=False)"
)]
pub(crate) fn fit<'py>(
    points: &Bound<'py, PyAny>,
    orders: &Bound<'py, PyAny>,
    params: Option<&Bound<'py, PyAny>>,
    weights: Option<&Bound<'py, PyAny>>,
    ends: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = points.py();
    let points = Numbers::read("points", points)?;
    let axes = points.shape().len().saturating_sub(1);
    let options = FitOptions {
        orders: wholes("orders", orders, axes)?,
        parameters: params.map_or(Ok(Parameters::default()), read_parameters)?,
        weights: weights.map(|weights| read_weights(weights, &points)).transpose()?,
        ends: ends.map_or(Ok(false), |ends| truth("ends", ends))?,
    };
    let report = report.map_or(Ok(false), |report| truth("report", report))?;
    let (values, shape) = (points.values(), points.shape());
    let fit = done(py, usize::MAX, || {
        operators::fit(values, shape, &options)
            .map_err(|error| renamed(error, "parameters", "params"))
    })?;
    if report { reported(py, fit) } else { PyForm::from(fit.form).into_bound_py_any(py) }
}

pub(crate) fn read_parameters(params: &Bound<'_, PyAny>) -> PyResult<Parameters> {
    if !params.is_instance_of::<PyString>() {
        return lists("params", params).map(Parameters::Given);
    }
    Ok(match word("params", params, &["chord", "centripetal", "uniform"])? {
        "centripetal" => Parameters::Centripetal,
        "uniform" => Parameters::Uniform,
        _ => Parameters::Chord,
    })
}

fn read_weights(weights: &Bound<'_, PyAny>, points: &Numbers) -> PyResult<Vec<f64>> {
    let weights = Numbers::read("weights", weights)?;
    let expected = points.shape().split_last().map_or(&[][..], |(_, shape)| shape);
    if weights.shape() == expected {
        return Ok(weights.values().to_vec());
    }
    let received = format!("an array of shape {:?}", weights.shape());
    fail(&Error::shape("weights", received, format!("shape {expected:?}, that of the points")))
}

fn reported(py: Python<'_>, fit: Fit) -> PyResult<Bound<'_, PyAny>> {
    let lists = fit.parameters.into_iter();
    let parameters: Vec<_> =
        lists.map(|list| array(py, &[list.len()], list)).collect::<PyResult<_>>()?;
    let class = py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Fit"))?;
    let parameters = PyTuple::new(py, parameters)?;
    class.call1((PyForm::from(fit.form), parameters, fit.max_error, fit.rms_error))
}

/// A list of numbers for each axis; a plain list is that of the only axis.
pub(crate) fn lists(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<Vec<Vec<f64>>> {
    let outer = object.is_instance_of::<PyList>()
        || object.is_instance_of::<PyTuple>()
        || object.is_instance_of::<PyUntypedArray>();
    if outer && object.get_item(0).is_ok_and(|first| first.len().is_ok()) {
        // The rows of an array may be one and the same in memory: copies of them are not.
        if object.is_instance_of::<PyUntypedArray>() {
            Numbers::read(argument, object)?;
        }
        return object.try_iter()?.map(|list| one_list(argument, &list?)).collect();
    }
    one_list(argument, object).map(|list| vec![list])
}

pub(crate) fn one_list(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    let numbers = Numbers::read(argument, object)?;
    let read: Result<Vec<f64>> = match numbers.shape() {
        [_] => Ok(numbers.values().to_vec()),
        shape => Err(Error::shape(
            argument,
            format!("an array of shape {shape:?}"),
            "a list of numbers for each axis",
        )),
    };
    read.map_err(|error| raised(&error))
}
