//! `a + b`, `2*a - b`, `a/2`: homogeneous combinations; `f*a`: a function times a form.

use pforms_kernel::{Error, Form, Result};
use pforms_operators::{self as operators, Poles, Shape, combine_shapes};
use pyo3::prelude::*;
use pyo3::types::PyNotImplemented;

use crate::arguments::{real, require_finite};
use crate::errors::done;
use crate::form::PyForm;
use crate::shapes::object;
use crate::slices::require_feasible;
use crate::spline::PySpline;

#[pymethods]
impl PyForm {
    /// NumPy leaves arithmetic with forms to the forms.
    #[classattr]
    #[pyo3(name = "__array_ufunc__")]
    fn array_ufunc() -> Option<bool> {
        None
    }

    fn __add__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.plus(1.0, other)
    }

    fn __sub__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.plus(-1.0, other)
    }

    fn __mul__<'py>(&self, factor: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.times(factor)
    }

    fn __rmul__<'py>(&self, factor: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.times(factor)
    }

    fn __truediv__<'py>(&self, divisor: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = divisor.py();
        let Some(divisor) = number(divisor) else { return Ok(not_implemented(py)) };
        require_finite("divisor", &[divisor])?;
        let quotient = done(py, self.form.pole_count(), || divided(&self.form, divisor))?;
        Ok(Bound::new(py, Self::from(quotient))?.into_any())
    }

    fn __neg__(&self, py: Python<'_>) -> PyResult<Self> {
        combined(py, &[-1.0], &[&self.form])
    }

    fn __pos__(slf: PyRef<'_, Self>) -> PyRef<'_, Self> {
        slf
    }
}

impl PyForm {
    fn plus<'py>(&self, sign: f64, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = other.py();
        // A spline answers for both.
        let Ok(other) = other.cast::<Self>() else { return Ok(not_implemented(py)) };
        let sum = combined(py, &[1.0, sign], &[&self.form, &other.get().form])?;
        Ok(Bound::new(py, sum)?.into_any())
    }

    fn times<'py>(&self, factor: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = factor.py();
        if let Ok(other) = factor.cast::<Self>() {
            return self.times_form(&other.get().form, py);
        }
        let Some(factor) = number(factor) else { return Ok(not_implemented(py)) };
        require_finite("factor", &[factor])?;
        Ok(Bound::new(py, combined(py, &[factor], &[&self.form])?)?.into_any())
    }
}

/// The net with every number divided, as a quotient of one rounding.
fn divided(net: &Form, divisor: f64) -> Result<Form> {
    if divisor == 0.0 {
        return Err(Error::domain("divisor", "0", "another number"));
    }
    let poles = net.homogeneous().iter().map(|x| x / divisor).collect();
    Form::from_homogeneous(net.orders(), net.ambient(), poles)
}

#[pymethods]
impl PySpline {
    /// NumPy leaves arithmetic with splines to the splines.
    #[classattr]
    #[pyo3(name = "__array_ufunc__")]
    fn array_ufunc() -> Option<bool> {
        None
    }

    fn __add__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.mixed([1.0, 1.0], other)
    }

    fn __radd__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.mixed([1.0, 1.0], other)
    }

    fn __sub__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.mixed([1.0, -1.0], other)
    }

    fn __rsub__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.mixed([-1.0, 1.0], other)
    }

    fn __mul__<'py>(&self, factor: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = factor.py();
        let Some(factor) = number(factor) else { return Ok(not_implemented(py)) };
        require_finite("factor", &[factor])?;
        Ok(Bound::new(py, self.multiplied(py, factor)?)?.into_any())
    }

    fn __rmul__<'py>(&self, factor: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.__mul__(factor)
    }

    fn __truediv__<'py>(&self, divisor: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = divisor.py();
        let Some(divisor) = number(divisor) else { return Ok(not_implemented(py)) };
        require_finite("divisor", &[divisor])?;
        let quotient =
            self.worked(py, |spline| spline.with_net(divided(spline.net(), divisor)?))?;
        Ok(Bound::new(py, quotient)?.into_any())
    }

    fn __neg__(&self, py: Python<'_>) -> PyResult<Self> {
        self.multiplied(py, -1.0)
    }

    fn __pos__(slf: PyRef<'_, Self>) -> PyRef<'_, Self> {
        slf
    }
}

impl PySpline {
    /// `k₀·self + k₁·other` with another spline, or a form.
    fn mixed<'py>(&self, k: [f64; 2], other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = other.py();
        let other = if let Ok(spline) = other.cast::<Self>() {
            Shape::from(spline.get().spline.clone())
        } else if let Ok(form) = other.cast::<PyForm>() {
            Shape::from(form.get().form.clone())
        } else {
            return Ok(not_implemented(py));
        };
        let shapes = [self.spline.clone().into(), other];
        object(py, done(py, self.cost(), || combine_shapes(&k, &shapes, false))?)
    }

    fn multiplied(&self, py: Python<'_>, factor: f64) -> PyResult<Self> {
        self.worked(py, |spline| spline.with_net(operators::combine(&[factor], &[spline.net()])?))
    }
}

impl PyForm {
    /// A product of values: one of the two is a function, a form in one dimension.
    fn times_form<'py>(&self, other: &Form, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        if self.form.ambient() > 1 && other.ambient() > 1 {
            return Ok(not_implemented(py));
        }
        let cost = self.form.homogeneous().len().saturating_mul(other.homogeneous().len());
        require_feasible("the product", cost as f64)?;
        let product = done(py, cost, || operators::multiply(&self.form, other))?;
        Ok(Bound::new(py, Self::from(product))?.into_any())
    }
}

pub(crate) fn combined(py: Python<'_>, k: &[f64], forms: &[&Form]) -> PyResult<PyForm> {
    let cost = forms.iter().map(|form| form.homogeneous().len()).sum();
    done(py, cost, || operators::combine(k, forms)).map(PyForm::from)
}

/// A number, if it is one; arrays and forms are left to other rules.
fn number(object: &Bound<'_, PyAny>) -> Option<f64> {
    let listed = object.len().is_ok() || object.is_none() || object.is_instance_of::<PyForm>();
    if listed { None } else { real("factor", object).ok() }
}

fn not_implemented(py: Python<'_>) -> Bound<'_, PyAny> {
    PyNotImplemented::get(py).to_owned().into_any()
}
