//! Nearest points of a form.

use numpy::{PyArray1, PyArrayDyn, PyArrayMethods};
use pforms_kernel::{Error, Form, Result};
use pforms_operators::{
    Doubt, Feet, Inversion, Inverter, Poles, Projection, Projector, Shape, SplineProjector,
    project_all,
};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arguments::real;
use crate::arrays::Numbers;
use crate::errors::{done, fail};
use crate::form::PyForm;
use crate::outputs::array;
use crate::slices::in_slices;
use crate::spline::PySpline;

#[pymethods]
impl PyForm {
    /// The nearest points of the form to some points, with the proof that they are.
    ///
    /// Every answer is proved over the window, 0 to 1 on each axis: no point of the form is nearer by
    /// more than the gap. Where feet fill a curve or more (the centre of a sphere), or the form is
    /// singular there, the gap grows from rounding to ``accuracy``; it says so itself.
    ///
    /// Parameters
    /// ----------
    /// points : array_like, shape (…, c)
    ///     The points, in the dimension of the form.
    /// accuracy : float, optional
    ///     In sizes of the form: feet whose distances differ by less are at the same distance, of
    ///     which the first in the order of the parameters is taken.
    /// all : bool, optional
    ///     All feet instead of the nearest: the places from which no way within the window leads
    ///     nearer at first order. These are the local nearest points, those at the ends too, and
    ///     inside the saddles and places of greatest distance.
    ///
    /// Returns
    /// -------
    /// Projection
    ///     ``parameters`` (…, axes), ``points`` (…, c), ``distances`` (…), ``gaps`` (…) and
    ///     ``unique`` (…).
    /// Feet
    ///     With ``all``: for k feet of n points ``parameters`` (k, axes), ``points`` (k, c),
    ///     ``distances``, ``kinds``, ``errors``, ``proved``; ``starts`` (n + 1): those of point i are
    ///     ``starts[i]:starts[i + 1]``; ``complete`` (…), ``doubts`` (j, 2, axes), ``doubtful`` (j).
    ///
    /// Raises
    /// ------
    /// ShapeError
    ///     When the points have another dimension than the form.
    /// DomainError
    ///     For points that are not finite or out of all proportion, and for a form whose weight
    ///     vanishes or changes sign in the window.
    ///
    /// Examples
    /// --------
    /// >>> parabola = pf.Form([(-1, 1), (0, -1), (1, 1)])
    /// >>> foot = parabola.project([(0, -1), (0, 3)])
    /// >>> foot.points[0], foot.distances[0]
    /// (array([0., 0.]), np.float64(1.0))
    /// >>> foot.unique  # (0, 3) is as near to both branches
    /// array([ True, False])
    /// >>> feet = parabola.project((0, 0.75), all=True)
    /// >>> feet.parameters.T, feet.kinds
    /// (array([[0.25, 0.5 , 0.75]]), ('minimum', 'maximum', 'minimum'))
    #[pyo3(
        signature = (points, *, accuracy=None, all=false),
        text_signature = "($self, points, *, accuracy=1e-12, all=False)"
    )]
    fn project<'py>(
        &self,
        points: &Bound<'py, PyAny>,
        accuracy: Option<&Bound<'py, PyAny>>,
        all: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        if all {
            return all_feet(&self.form.clone().into(), points, accuracy);
        }
        projected(&self.form, points, accuracy, |accuracy| {
            let projector = Projector::new(&self.form, accuracy)?;
            Ok(move |part: &[f64]| projector.project(part))
        })
    }

    /// All parameters at which the form goes through points.
    ///
    /// Every place over the window whose distance from the point is no more than ``accuracy``, each proved
    /// to be alone within its error. What cannot be proved, where the form is folded, runs over
    /// itself or has a collapsed edge, is a doubt: a box of parameters, with the best place in it.
    ///
    /// Parameters
    /// ----------
    /// points : array_like, shape (…, c)
    ///     The points, in the dimension of the form.
    /// accuracy : float, optional
    ///     In sizes of the form: points no farther from it are on it.
    ///
    /// Returns
    /// -------
    /// Inversion
    ///     For k places of n points ``parameters`` (k, axes), ``distances``, ``errors``, ``proved``;
    ///     ``starts`` (n + 1): those of point i are ``starts[i]:starts[i + 1]``; ``inside`` (…),
    ///     ``complete`` (…), ``doubts`` (j, 2, axes), ``doubtful`` (j).
    ///
    /// Raises
    /// ------
    /// ShapeError
    ///     When the points have another dimension, or there are more axes than that has or four.
    /// DomainError
    ///     For points that are not finite, and for an accuracy not from 0 to 1.
    ///
    /// Examples
    /// --------
    /// >>> patch = pf.Form([[(0, 0), (0, 2)], [(4, 0), (4, 2)]])
    /// >>> found = patch.invert([(1, 1), (5, 0)])
    /// >>> found.parameters, found.inside
    /// (array([[0.25, 0.5 ]]), array([ True, False]))
    /// >>> found.complete.all()
    /// np.True_
    #[pyo3(signature = (points, *, accuracy=None), text_signature = "($self, points, *, accuracy=1e-12)")]
    fn invert<'py>(
        &self,
        points: &Bound<'py, PyAny>,
        accuracy: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        inverted(&self.form.clone().into(), points, accuracy)
    }
}

#[pymethods]
impl PySpline {
    /// The nearest points of the spline to some points, with the proof that they are.
    ///
    /// As :meth:`Form.project`, over the window of the spline: the nearest of the feet on its
    /// pieces, and the gap counts them all.
    ///
    /// >>> curve = pf.Spline([(0, 0), (2, 0), (2, 2), (0, 2)], 1, [0, 0, 1, 2, 3, 3])
    /// >>> foot = curve.project((3, 1))
    /// >>> foot.parameters, foot.points, foot.unique.item()
    /// (array([1.5]), array([2., 1.]), True)
    #[pyo3(
        signature = (points, *, accuracy=None, all=false),
        text_signature = "($self, points, *, accuracy=1e-12, all=False)"
    )]
    fn project<'py>(
        &self,
        points: &Bound<'py, PyAny>,
        accuracy: Option<&Bound<'py, PyAny>>,
        all: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        if all {
            return all_feet(&self.spline.clone().into(), points, accuracy);
        }
        projected(self.spline.net(), points, accuracy, |accuracy| {
            let projector = SplineProjector::new(&self.spline, accuracy)?;
            Ok(move |part: &[f64]| projector.project(part))
        })
    }

    /// All parameters at which the spline goes through points.
    ///
    /// Every place over the window whose distance from the point is no more than ``accuracy``, each proved
    /// to be alone within its error. What cannot be proved, where the spline is folded, runs over
    /// itself or has a collapsed edge, is a doubt: a box of parameters, with the best place in it.
    ///
    /// Parameters
    /// ----------
    /// points : array_like, shape (…, c)
    ///     The points, in the dimension of the spline.
    /// accuracy : float, optional
    ///     In sizes of the spline: points no farther from it are on it.
    ///
    /// Returns
    /// -------
    /// Inversion
    ///     For k places of n points ``parameters`` (k, axes), ``distances``, ``errors``, ``proved``;
    ///     ``starts`` (n + 1): those of point i are ``starts[i]:starts[i + 1]``; ``inside`` (…),
    ///     ``complete`` (…), ``doubts`` (j, 2, axes), ``doubtful`` (j).
    ///
    /// Raises
    /// ------
    /// ShapeError
    ///     When the points have another dimension, or there are more axes than that has or four.
    /// DomainError
    ///     For points that are not finite, and for an accuracy not from 0 to 1.
    ///
    /// Examples
    /// --------
    /// >>> curve = pf.Spline([(0, 0), (2, 0), (2, 2), (0, 2)], 1, [0, 0, 1, 2, 3, 3])
    /// >>> curve.invert((2, 1)).parameters
    /// array([[1.5]])
    #[pyo3(signature = (points, *, accuracy=None), text_signature = "($self, points, *, accuracy=1e-12)")]
    fn invert<'py>(
        &self,
        points: &Bound<'py, PyAny>,
        accuracy: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        inverted(&self.spline.clone().into(), points, accuracy)
    }
}

/// Makes a projector ready and answers for all points.
fn projected<'py, P: Fn(&[f64]) -> Result<Projection> + Send + Sync>(
    net: &Form,
    points: &Bound<'py, PyAny>,
    accuracy: Option<&Bound<'py, PyAny>>,
    ready: impl FnOnce(f64) -> Result<P> + Send,
) -> PyResult<Bound<'py, PyAny>> {
    let py = points.py();
    let (ambient, accuracy) = (net.ambient(), accuracy_of(accuracy)?);
    let points = in_space(points, ambient)?;
    let shape = &points.shape()[..points.shape().len() - 1];
    let cost = PREPARATION * net.homogeneous().len();
    let project = done(py, cost, || ready(accuracy))?;
    let mut found = Projection::default();
    let values = points.values();
    in_slices(py, values.len() / ambient, COST, |range| {
        found.extend(project(&values[range.start * ambient..range.end * ambient])?);
        Ok(())
    })?;
    record(py, shape, net, found)
}

fn accuracy_of(given: Option<&Bound<'_, PyAny>>) -> PyResult<f64> {
    given.map_or(Ok(ACCURACY), |given| real("accuracy", given))
}

/// Points of a dimension: an array of shape (…, c).
fn in_space<'py>(points: &Bound<'py, PyAny>, ambient: usize) -> PyResult<Numbers<'py>> {
    let points = Numbers::read("points", points)?;
    if points.shape().last() == Some(&ambient) {
        return Ok(points);
    }
    let received = format!("an array of shape {:?}", points.shape());
    fail(&Error::shape("points", received, format!("shape (…, {ambient})")))
}

/// All parameters of points, as a `pforms.records.Inversion`.
fn inverted<'py>(
    host: &Shape,
    points: &Bound<'py, PyAny>,
    accuracy: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = points.py();
    let (net, accuracy) = (host.net(), accuracy_of(accuracy)?);
    let points = in_space(points, net.ambient())?;
    let cost = PREPARATION * net.homogeneous().len();
    let inverter = done(py, cost, || Inverter::new(host, accuracy))?;
    let mut found: Vec<Inversion> = Vec::new();
    let (values, ambient) = (points.values(), net.ambient());
    in_slices(py, values.len() / ambient, COST * net.axes(), |range| {
        found.extend(inverter.invert(&values[range.start * ambient..range.end * ambient])?);
        Ok(())
    })?;
    let shape = &points.shape()[..points.shape().len() - 1];
    let axes = net.axes();
    let all: Vec<_> = found.iter().flat_map(|one| &one.solutions).collect();
    let doubts: Vec<&[Doubt]> = found.iter().map(|one| &one.doubts[..]).collect();
    let (boxes, of) = doubtful(py, axes, &doubts)?;
    let fields = (
        array(py, &[all.len(), axes], all.iter().flat_map(|s| s.parameters.clone()).collect())?,
        array(py, &[all.len()], all.iter().map(|s| s.distance).collect())?,
        array(py, &[all.len()], all.iter().map(|s| s.error).collect())?,
        PyArray1::from_vec(py, all.iter().map(|s| s.proved).collect()),
        starts(py, found.iter().map(|one| one.solutions.len())),
        PyArray1::from_vec(py, found.iter().map(Inversion::inside).collect()).reshape(shape)?,
        PyArray1::from_vec(py, found.iter().map(Inversion::complete).collect()).reshape(shape)?,
        boxes,
        of,
    );
    py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Inversion"))?.call1(fields)
}

/// All feet of points, as a `pforms.records.Feet`.
fn all_feet<'py>(
    form: &Shape,
    points: &Bound<'py, PyAny>,
    accuracy: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = points.py();
    let (net, accuracy) = (form.net(), accuracy_of(accuracy)?);
    let points = in_space(points, net.ambient())?;
    let mut found: Vec<Feet> = Vec::new();
    let (values, ambient, axes) = (points.values(), net.ambient(), net.axes());
    in_slices(py, values.len() / ambient, PREPARATION * net.homogeneous().len(), |range| {
        let part = &values[range.start * ambient..range.end * ambient];
        found.extend(project_all(form, part, accuracy)?);
        Ok(())
    })?;
    let shape = &points.shape()[..points.shape().len() - 1];
    let all: Vec<_> = found.iter().flat_map(|one| &one.feet).collect();
    let doubts: Vec<&[Doubt]> = found.iter().map(|one| &one.doubts[..]).collect();
    let (boxes, of) = doubtful(py, axes, &doubts)?;
    let kinds = PyTuple::new(py, all.iter().map(|foot| foot.kind.name()))?;
    let fields = (
        array(py, &[all.len(), axes], all.iter().flat_map(|f| f.parameters.clone()).collect())?,
        array(py, &[all.len(), ambient], all.iter().flat_map(|f| f.point.clone()).collect())?,
        array(py, &[all.len()], all.iter().map(|f| f.distance).collect())?,
        kinds,
        array(py, &[all.len()], all.iter().map(|f| f.error).collect())?,
        PyArray1::from_vec(py, all.iter().map(|f| f.proved).collect()),
        starts(py, found.iter().map(|one| one.feet.len())),
        PyArray1::from_vec(py, found.iter().map(Feet::complete).collect()).reshape(shape)?,
        boxes,
        of,
    );
    py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Feet"))?.call1(fields)
}

/// Where the answers of each point begin, and where the last end.
fn starts(py: Python<'_>, counts: impl Iterator<Item = usize>) -> Bound<'_, PyArray1<i64>> {
    let mut starts = vec![0];
    let mut end = 0;
    for count in counts {
        end += count as i64;
        starts.push(end);
    }
    PyArray1::from_vec(py, starts)
}

type Boxes<'py> = (Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArray1<i64>>);

/// Boxes of doubt, shape (j, 2, axes), and the point of each.
fn doubtful<'py>(py: Python<'py>, axes: usize, doubts: &[&[Doubt]]) -> PyResult<Boxes<'py>> {
    let of = doubts.iter().enumerate().flat_map(|(i, list)| vec![i as i64; list.len()]).collect();
    let corners: Vec<f64> = doubts
        .iter()
        .flat_map(|list| list.iter())
        .flat_map(|doubt| [doubt.lower.clone(), doubt.upper.clone()].concat())
        .collect();
    let count = corners.len() / (2 * axes).max(1);
    Ok((array(py, &[count, 2, axes], corners)?, PyArray1::from_vec(py, of)))
}

/// The default: far below what anything is built to, far above rounding.
const ACCURACY: f64 = 1e-12;

/// Multiplications for one point, about, when it is an easy one.
const COST: usize = 1 << 12;

/// Multiplications for each number of a form that is made ready.
const PREPARATION: usize = 1 << 10;

/// A `pforms.records.Projection` of arrays whose first axes are those of the points.
fn record<'py>(
    py: Python<'py>,
    shape: &[usize],
    form: &Form,
    found: Projection,
) -> PyResult<Bound<'py, PyAny>> {
    let wide = |width: usize| -> Vec<usize> { shape.iter().copied().chain([width]).collect() };
    let unique = PyArray1::from_vec(py, found.unique).reshape(shape.to_vec())?;
    let fields = (
        array(py, &wide(form.axes()), found.parameters)?,
        array(py, &wide(form.ambient()), found.points)?,
        array(py, shape, found.distances)?,
        array(py, shape, found.gaps)?,
        unique,
    );
    py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Projection"))?.call1(fields)
}
