//! Nearest points of a form.

use numpy::{PyArray1, PyArrayMethods};
use pforms_kernel::{Error, Form, Result};
use pforms_operators::{Projection, Projector, SplineProjector};
use pyo3::intern;
use pyo3::prelude::*;

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
    ///
    /// Returns
    /// -------
    /// Projection
    ///     ``parameters`` (…, axes), ``points`` (…, c), ``distances`` (…), ``gaps`` (…) and
    ///     ``unique`` (…).
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
    #[pyo3(signature = (points, *, accuracy=None), text_signature = "($self, points, *, accuracy=1e-12)")]
    fn project<'py>(
        &self,
        points: &Bound<'py, PyAny>,
        accuracy: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        projected(&self.form, points, accuracy, |accuracy| {
            let projector = Projector::new(&self.form, accuracy)?;
            Ok(move |part: &[f64]| projector.project(part))
        })
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
    #[pyo3(signature = (points, *, accuracy=None), text_signature = "($self, points, *, accuracy=1e-12)")]
    fn project<'py>(
        &self,
        points: &Bound<'py, PyAny>,
        accuracy: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        projected(self.spline.net(), points, accuracy, |accuracy| {
            let projector = SplineProjector::new(&self.spline, accuracy)?;
            Ok(move |part: &[f64]| projector.project(part))
        })
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
    let points = Numbers::read("points", points)?;
    let accuracy = accuracy.map_or(Ok(ACCURACY), |given| real("accuracy", given))?;
    let ambient = net.ambient();
    let Some((_, shape)) = points.shape().split_last().filter(|(last, _)| **last == ambient) else {
        let received = format!("an array of shape {:?}", points.shape());
        return fail(&Error::shape("points", received, format!("shape (…, {ambient})")));
    };
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
