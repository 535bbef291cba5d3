//! Nearest points of a form.

use numpy::{PyArray1, PyArrayMethods};
use pforms_kernel::Error;
use pforms_operators::{Projection, Projector};
use pyo3::intern;
use pyo3::prelude::*;

use crate::arguments::real;
use crate::arrays::Numbers;
use crate::errors::{done, fail};
use crate::form::PyForm;
use crate::outputs::array;
use crate::slices::in_slices;

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
        let py = points.py();
        let points = Numbers::read("points", points)?;
        let accuracy = accuracy.map_or(Ok(ACCURACY), |given| real("accuracy", given))?;
        let ambient = self.form.ambient();
        let Some((_, shape)) = points.shape().split_last().filter(|(last, _)| **last == ambient)
        else {
            let received = format!("an array of shape {:?}", points.shape());
            return fail(&Error::shape("points", received, format!("shape (…, {ambient})")));
        };
        let cost = PREPARATION * self.form.homogeneous().len();
        let projector = done(py, cost, || Projector::new(&self.form, accuracy))?;
        let mut found = Projection::default();
        let values = points.values();
        in_slices(py, values.len() / ambient, COST, |range| {
            let part = &values[range.start * ambient..range.end * ambient];
            found.extend(projector.project(part)?);
            Ok(())
        })?;
        record(py, shape, &self.form, found)
    }
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
    form: &pforms_kernel::Form,
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
