//! Points of forms: calls, grids and derivatives.

use numpy::PyArrayDyn;
use pforms_kernel::{Form, Result, limit};
use pforms_operators::{Immersed, Spline};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arguments::wholes;
use crate::errors::raised;
use crate::form::PyForm;
use crate::immersed::spline_immersed;
use crate::operators::immersed;
use crate::outputs::filled;
use crate::parameters::Parameters;
use crate::sampling::Grids;
use crate::slices::fill_scattered;
use crate::spline::PySpline;

/// What has a point for every parameter.
pub(crate) trait Evaluate: Sync {
    /// Number of coordinates of a point.
    fn width(&self) -> usize;

    /// About how many multiplications a point takes.
    fn cost(&self) -> usize;

    /// Points, or derivatives of them, at scattered parameters.
    fn fill(&self, at: &[&[f64]], orders: Option<&[usize]>, out: &mut [f64]) -> Result<()>;

    /// The form, where there is a quicker way to the points of a grid than point after point.
    fn on_grids(&self) -> Option<&Form> {
        None
    }
}

impl Evaluate for Form {
    fn width(&self) -> usize {
        self.ambient()
    }

    fn cost(&self) -> usize {
        self.homogeneous().len()
    }

    fn fill(&self, at: &[&[f64]], orders: Option<&[usize]>, out: &mut [f64]) -> Result<()> {
        match orders {
            None => self.scattered_into(at, out),
            Some(orders) => self.scattered_derivative_into(at, orders, out),
        }
    }

    fn on_grids(&self) -> Option<&Form> {
        Some(self)
    }
}

impl Evaluate for Spline {
    fn width(&self) -> usize {
        self.ambient()
    }

    fn cost(&self) -> usize {
        let poles: usize = self.degrees().iter().map(|degree| degree + 1).product();
        // Each point finds its piece first.
        4 * poles * (self.width() + 1)
    }

    fn fill(&self, at: &[&[f64]], orders: Option<&[usize]>, out: &mut [f64]) -> Result<()> {
        match orders {
            None => self.scattered_into(at, out),
            Some(orders) => self.scattered_derivative_into(at, orders, out),
        }
    }
}

impl Evaluate for Immersed {
    fn width(&self) -> usize {
        self.host().ambient()
    }

    fn cost(&self) -> usize {
        let triangles: usize = self.host().orders().iter().sum();
        self.host().homogeneous().len() * triangles.max(1) + self.inner().homogeneous().len()
    }

    fn fill(&self, at: &[&[f64]], orders: Option<&[usize]>, out: &mut [f64]) -> Result<()> {
        self.inner().each_scattered(at, out, self.width(), |_, at, part| {
            let point = match orders {
                None => self.at(at)?,
                Some(orders) => self.derivative_at(at, orders)?,
            };
            part.copy_from_slice(&point);
            Ok(())
        })
    }
}

/// Points of anything at broadcast parameters, shape (…, c).
pub(crate) fn points<'py>(
    subject: &impl Evaluate,
    parameters: &Bound<'py, PyTuple>,
    orders: Option<&[usize]>,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let py = parameters.py();
    let parameters = Parameters::read(parameters)?;
    let cost = subject.cost();
    let (shape, width) = (parameters.shape(), Some(subject.width()));
    if let (None, Some(form)) = (orders, subject.on_grids())
        && let Some(lists) = parameters.grid()
    {
        let lists: Vec<&[f64]> = lists.iter().map(AsRef::as_ref).collect();
        return filled(py, shape, width, out, |numbers| {
            Grids::new(&[form], &lists, numbers)
                .fill(py, cost, &|part| form.grid_into(&part.lists, part.points))
        });
    }
    let points = parameters.scattered();
    // Products of truncated Taylor series take the square of their length.
    let series = |order: &usize| (order + 1).saturating_pow(2);
    let cost = orders.unwrap_or_default().iter().map(series).fold(cost, usize::saturating_mul);
    filled(py, shape, width, out, |numbers| {
        let fill = |lists: &[&[f64]], part: &mut [f64]| subject.fill(lists, orders, part);
        fill_scattered(py, &points, cost, numbers, &fill)
    })
}

/// The orders of a derivative; a single number is for a curve.
pub(crate) fn derivative_orders(object: &Bound<'_, PyAny>, form: &Form) -> PyResult<Vec<usize>> {
    let orders = wholes("derivative", object, 1)?;
    form.require_per_axis("derivative", &orders).map_err(|error| raised(&error))?;
    let terms: Vec<usize> = orders.iter().map(|order| order + 1).collect();
    limit::check::<f64>("the Taylor expansion", &terms, SLOWNESS).map_err(|e| raised(&e))?;
    Ok(orders)
}

/// A quotient of series takes the square of its length: this keeps it below seconds.
const SLOWNESS: usize = 1 << 14;

#[pymethods]
impl PyForm {
    /// Points at parameters, or the form drawn inside this one.
    ///
    /// ``f(u, v, …)`` takes one number or array for each axis; they broadcast, and the result has
    /// their shape and one more axis of ``c`` coordinates. Any real parameters are legal; [0, 1]
    /// is the usual window. ``host(inner)`` with a form is :func:`immerse`.
    ///
    /// Raises
    /// ------
    /// ShapeError
    ///     Unless there is one parameter for each axis and they broadcast.
    /// DomainError
    ///     Where the weight vanishes, and for NaN.
    ///
    /// Examples
    /// --------
    /// >>> segment = pf.Form([(0, 0), (2, 4)])
    /// >>> segment(0.5)
    /// array([1., 2.])
    /// >>> segment([[0, 0.25, 1]]).shape
    /// (1, 3, 2)
    #[pyo3(signature = (*parameters))]
    fn __call__<'py>(&self, parameters: &Bound<'py, PyTuple>) -> PyResult<Bound<'py, PyAny>> {
        let py = parameters.py();
        if parameters.len() == 1
            && let Ok(inner) = parameters.get_item(0)?.cast::<Self>()
        {
            let result = immersed(py, &inner.get().form, &self.form)?;
            return Ok(Bound::new(py, result)?.into_any());
        }
        if parameters.len() == 1 && parameters.get_item(0)?.is_instance_of::<PySpline>() {
            let host = PyForm::from(self.form.clone()).into_bound_py_any(py)?;
            return spline_immersed(&parameters.get_item(0)?, &host);
        }
        points(&self.form, parameters, None, None).map(Bound::into_any)
    }

    /// Points or derivatives at parameters, if wanted into an array of the caller's.
    ///
    /// Parameters
    /// ----------
    /// *parameters : array_like
    ///     One for each axis; they broadcast. The columns of a table are ``*table.T``, read in place.
    /// derivative : int or tuple of int, optional
    ///     Order of the partial derivative along each axis, exact, rational forms too.
    /// out : ndarray, optional
    ///     A C-contiguous float64 array of the result's shape.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (…, c)
    ///
    /// Raises
    /// ------
    /// ShapeError, DomainError
    ///     As a call, and when ``out`` does not fit.
    ///
    /// Examples
    /// --------
    /// >>> parabola = pf.Form([(0, 0), (1, 2), (2, 0)])
    /// >>> parabola.evaluate(0.5, derivative=1)
    /// array([2., 0.])
    #[pyo3(signature = (*parameters, derivative=None, out=None))]
    fn evaluate<'py>(
        &self,
        parameters: &Bound<'py, PyTuple>,
        derivative: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let orders = derivative.map(|d| derivative_orders(d, &self.form)).transpose()?;
        points(&self.form, parameters, orders.as_deref(), out)
    }
}
