//! Operators on one form, as methods; the package offers each as a function of the same name too.

use numpy::PyArrayDyn;
use pforms_kernel::{Error, Form, limit};
use pforms_operators::{self as operators, Reduction};
use pyo3::prelude::*;
use pyo3::types::{PyString, PyTuple};

use crate::arguments::{axis, level, real, reals, wholes};
use crate::arrays::Numbers;
use crate::errors::{done, fail, raised};
use crate::form::PyForm;
use crate::outputs::array;
use crate::slices::require_feasible;
use crate::spline::PySpline;

#[pymethods]
impl PyForm {
    /// Identifies two axes: orders m and n become m + n − 1.
    ///
    /// Parameters
    /// ----------
    /// axes : None, (int, int) or "all", optional
    ///     The last two axes if None; with "all" every axis, down to the curve.
    ///
    /// Raises
    /// ------
    /// ShapeError
    ///     When the axes are the same or not there.
    ///
    /// Examples
    /// --------
    /// >>> facet = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
    /// >>> facet.diagonal()
    /// <pforms.Form pL3 in 3D>
    #[pyo3(signature = (axes=None))]
    fn diagonal(&self, py: Python<'_>, axes: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let form = &self.form;
        let cost = form.homogeneous().len();
        let Some(axes) = axes else {
            let last = form.axes().saturating_sub(1);
            return done(py, cost, || operators::diagonal(form, last.saturating_sub(1), last))
                .map(Self::from);
        };
        if axes.cast::<PyString>().is_ok_and(|text| text.to_string_lossy() == "all") {
            return done(py, cost, || operators::diagonal_all(form)).map(Self::from);
        }
        match *wholes("axes", axes, 1)? {
            [first, second] => {
                done(py, cost, || operators::diagonal(form, first, second)).map(Self::from)
            }
            ref other => fail(&Error::shape("axes", format!("{other:?}"), "two axes, or \"all\"")),
        }
    }

    /// The sub-form (isoparametric form) where parameter ``axis`` is ``t``: one axis less.
    ///
    /// Any real ``t``. Raises ShapeError when there is no such axis, DomainError for NaN.
    ///
    /// >>> facet = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
    /// >>> facet.sub(0, 0.5).poles
    /// array([[0.5, 0. , 0.5],
    ///        [0.5, 1. , 0.5]])
    #[pyo3(signature = (axis, t))]
    fn sub(&self, axis: &Bound<'_, PyAny>, t: &Bound<'_, PyAny>) -> PyResult<Self> {
        let (k, t) = (self.axis(axis)?, real("t", t)?);
        self.worked(axis.py(), |form| operators::sub(form, k, &t))
    }

    /// The two parts at parameter ``t`` of ``axis``: windows [0, t] and [t, 1].
    ///
    /// Any real ``t``. Raises ShapeError when there is no such axis, DomainError for NaN.
    ///
    /// >>> low, high = pf.Form([(0, 0), (1, 2), (2, 0)]).split(0, 0.5)
    /// >>> high.poles
    /// array([[1. , 1. ],
    ///        [1.5, 1. ],
    ///        [2. , 0. ]])
    #[pyo3(signature = (axis, t))]
    fn split(&self, axis: &Bound<'_, PyAny>, t: &Bound<'_, PyAny>) -> PyResult<(Self, Self)> {
        let (k, t) = (self.axis(axis)?, real("t", t)?);
        let (low, high) = done(axis.py(), self.cost(), || operators::split(&self.form, k, &t))?;
        Ok((low.into(), high.into()))
    }

    /// The refined net after halving the window ``r`` times: a piecewise form that is this form.
    ///
    /// Parameters
    /// ----------
    /// r : int or sequence of int
    ///     Levels, for all axes or one for each.
    ///
    /// Raises
    /// ------
    /// ShapeError, DomainError, LimitError
    ///     For a wrong number of levels, negative ones, and too many.
    ///
    /// Examples
    /// --------
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1)
    /// <pforms.Spline of 2 pieces pL3 in 2D>
    /// >>> facet = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
    /// >>> low_low, low_high, high_low, high_high = facet.subdivide(1)
    #[pyo3(signature = (r))]
    fn subdivide(&self, r: &Bound<'_, PyAny>) -> PyResult<PySpline> {
        let levels = wholes("r", r, self.form.axes())?;
        let levels: Vec<u32> =
            levels.into_iter().map(|r| level("r", r)).collect::<PyResult<_>>()?;
        done(r.py(), self.cost(), || operators::subdivide(&self.form, &levels)).map(PySpline::from)
    }

    /// The forms that generate this one along axis 0: :func:`stack` undone.
    ///
    /// So one array holds many forms, and operators that leave axis 0 alone act on all at once:
    /// ``by=(0, 1, 1)``. Raises ShapeError for a point.
    ///
    /// >>> surfaces = pf.Form(np.zeros((10000, 4, 4, 3)))
    /// >>> raised = surfaces.elevate((0, 1, 1)).unstack()
    /// >>> len(raised), raised[0]
    /// (10000, <pforms.Form pS55 in 3D>)
    fn unstack(&self, py: Python<'_>) -> PyResult<Vec<Self>> {
        let forms = done(py, self.cost(), || operators::unstack(&self.form))?;
        Ok(forms.into_iter().map(Self::from).collect())
    }

    /// The same form with more poles: ``by`` more along each axis.
    ///
    /// Parameters
    /// ----------
    /// by : int or sequence of int
    ///     For all axes or one for each, at least 0.
    ///
    /// Raises
    /// ------
    /// ShapeError, DomainError, LimitError
    ///     For a wrong count, a negative number, and too many poles.
    ///
    /// Examples
    /// --------
    /// >>> pf.Form([(0, 0), (3, 3), (6, 0)]).elevate(1).poles
    /// array([[0., 0.],
    ///        [2., 2.],
    ///        [4., 2.],
    ///        [6., 0.]])
    #[pyo3(signature = (by))]
    fn elevate(&self, by: &Bound<'_, PyAny>) -> PyResult<Self> {
        let steps = wholes("by", by, self.form.axes())?;
        self.worked(by.py(), |form| operators::elevate(form, &steps))
    }

    /// The nearest form with ``by`` poles less along each axis, and how far it is at most.
    ///
    /// Returns
    /// -------
    /// (Form, float)
    ///     No point of the window moves by more than the bound.
    ///
    /// Raises
    /// ------
    /// ShapeError, DomainError
    ///     When no pole would be left, and for a negative number.
    /// DegenerateError
    ///     When the weight vanishes in the window, so that no bound can be promised.
    ///
    /// Examples
    /// --------
    /// >>> form, bound = pf.Form([(0, 0), (2, 2), (4, 2), (6, 0)]).reduce(1)
    /// >>> form.kind, bound < 1e-12
    /// ('pL3', True)
    #[pyo3(signature = (by))]
    fn reduce(&self, by: &Bound<'_, PyAny>) -> PyResult<(Self, f64)> {
        let steps = wholes("by", by, self.form.axes())?;
        let Reduction { form, bound } =
            done(by.py(), self.cost(), || operators::reduce(&self.form, &steps))?;
        Ok((form.into(), bound))
    }

    /// The form on the window [a, b]: restricted, extended or, for a > b, reversed.
    ///
    /// Parameters
    /// ----------
    /// a, b : float or sequence of float
    ///     For all axes or one for each; any real numbers.
    ///
    /// Raises
    /// ------
    /// ShapeError, DomainError
    ///     For a wrong count, and for NaN and infinities.
    ///
    /// Examples
    /// --------
    /// >>> pf.Form([(0, 0), (1, 2)]).stretch(-1, 2).poles
    /// array([[-1., -2.],
    ///        [ 2.,  4.]])
    #[pyo3(signature = (a, b))]
    fn stretch(&self, a: &Bound<'_, PyAny>, b: &Bound<'_, PyAny>) -> PyResult<Self> {
        let axes = self.form.axes();
        let (from, to) = (reals("a", a, axes)?, reals("b", b, axes)?);
        self.worked(a.py(), |form| operators::stretch(form, &from, &to))
    }

    /// The form run backwards along ``axis``. Raises ShapeError when there is no such axis.
    ///
    /// >>> pf.Form([(0, 0), (1, 2)]).reverse(0).poles
    /// array([[1., 2.],
    ///        [0., 0.]])
    #[pyo3(signature = (axis))]
    fn reverse(&self, axis: &Bound<'_, PyAny>) -> PyResult<Self> {
        let k = self.axis(axis)?;
        self.worked(axis.py(), |form| operators::reverse(form, k))
    }

    /// The axes in another order: axis ``k`` of the result is axis ``axes[k]`` of this form.
    ///
    /// Without ``axes`` the order is turned round. Raises ShapeError unless it is a permutation.
    ///
    /// >>> pf.Form([[(0, 0), (1, 0), (2, 0)], [(0, 1), (1, 1), (2, 1)]]).transpose((1, 0)).kind
    /// 'pS32'
    #[pyo3(signature = (axes=None))]
    fn transpose(&self, py: Python<'_>, axes: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let axes = match axes {
            Some(axes) => wholes("axes", axes, 1)?,
            None => (0..self.form.axes()).rev().collect(),
        };
        self.worked(py, |form| operators::transpose(form, &axes))
    }

    /// A projective change of parameter: the same points and ends, other weights.
    ///
    /// Pole ``i`` is multiplied by ``c**i``. For c < 0 the form runs through infinity: the other
    /// arc of a conic. Raises ShapeError when there is no such axis, DegenerateError for c = 0.
    ///
    /// >>> pf.Form([(1, 0), (1, 1), (0, 1)], [1, 1, 2]).reparametrise(0, 0.5).weights
    /// array([1. , 0.5, 0.5])
    #[pyo3(signature = (axis, c))]
    fn reparametrise(&self, axis: &Bound<'_, PyAny>, c: &Bound<'_, PyAny>) -> PyResult<Self> {
        let (k, c) = (self.axis(axis)?, real("c", c)?);
        self.worked(axis.py(), |form| operators::reparametrise(form, k, &c))
    }

    /// The whole projective line of ``axis`` as three forms: [−∞, 0], [0, 1] and [1, +∞].
    ///
    /// Raises ShapeError when there is no such axis.
    ///
    /// >>> quarter = pf.Form([(1, 0), (1, 1), (0, 1)], [1, 1, 2])
    /// >>> [part.kind for part in quarter.whole_line(0)]
    /// ['pL3', 'pL3', 'pL3']
    #[pyo3(signature = (axis=None), text_signature = "($self, axis=0)")]
    fn whole_line(&self, py: Python<'_>, axis: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<Self>> {
        let k = self.first_axis_or(axis)?;
        let parts = done(py, self.cost(), || operators::whole_line(&self.form, k))?;
        Ok(parts.into_iter().map(Self::from).collect())
    }

    /// The derivative as a form: ``orders[k]`` times along axis ``k``, rational forms too.
    ///
    /// Parameters
    /// ----------
    /// orders : int or sequence of int
    ///     One for each axis; a single number is for a curve.
    ///
    /// Raises
    /// ------
    /// ShapeError, DomainError, LimitError
    ///     For a wrong count, a negative number, and orders beyond reason.
    ///
    /// Examples
    /// --------
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).derivative(2).poles
    /// array([[ 0., -8.]])
    #[pyo3(signature = (orders))]
    fn derivative(&self, orders: &Bound<'_, PyAny>) -> PyResult<Self> {
        let steps = wholes("orders", orders, 1)?;
        check_derivative(&self.form, &steps)?;
        self.worked(orders.py(), |form| operators::derivative(form, &steps))
    }

    /// The first derivative along ``axis``, as a form. Raises ShapeError without such an axis.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).hodograph(0).poles
    /// array([[ 2.,  4.],
    ///        [ 2., -4.]])
    #[pyo3(signature = (axis=None), text_signature = "($self, axis=0)")]
    fn hodograph(&self, py: Python<'_>, axis: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let k = self.first_axis_or(axis)?;
        self.worked(py, |form| operators::hodograph(form, k))
    }

    /// The blossom (polar form): for each axis as many arguments as its degree.
    ///
    /// Symmetric and affine in each argument; with all arguments equal it is the point.
    ///
    /// Parameters
    /// ----------
    /// *arguments : sequence of float
    ///     One list for each axis; for a curve the numbers themselves will do.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (c+1,)
    ///     The homogeneous point, the weight last.
    ///
    /// Raises
    /// ------
    /// ShapeError, DomainError
    ///     When the number of arguments is not the degree, and for NaN.
    ///
    /// Examples
    /// --------
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).blossom([0, 1])
    /// array([1., 2., 1.])
    #[pyo3(signature = (*arguments))]
    fn blossom<'py>(
        &self,
        arguments: &Bound<'py, PyTuple>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let lists: Vec<Numbers<'py>> = arguments
            .iter()
            .map(|list| Numbers::read("arguments", &list))
            .collect::<PyResult<_>>()?;
        let numbers: Vec<f64> = lists.iter().flat_map(Numbers::values).copied().collect();
        let lists: Vec<&[f64]> = if lists.iter().all(|list| list.shape().is_empty()) {
            if self.form.axes() == 0 { Vec::new() } else { vec![&numbers] }
        } else {
            lists.iter().map(Numbers::values).collect()
        };
        let py = arguments.py();
        let point = done(py, self.cost(), || operators::blossom(&self.form, &lists))?;
        array(py, &[self.form.width()], point)
    }
}

impl PyForm {
    fn axis(&self, object: &Bound<'_, PyAny>) -> PyResult<usize> {
        axis(&self.form, object)
    }

    /// Axis 0 when none is named.
    pub(crate) fn first_axis_or(&self, object: Option<&Bound<'_, PyAny>>) -> PyResult<usize> {
        object.map_or(Ok(0), |axis| self.axis(axis))
    }

    /// About how many multiplications an operator that passes once over each axis takes.
    fn cost(&self) -> usize {
        let orders = self.form.orders().iter();
        orders.fold(self.form.homogeneous().len(), |cost, order| cost.saturating_mul(*order))
    }

    pub(crate) fn worked(
        &self,
        py: Python<'_>,
        operator: impl FnOnce(&Form) -> pforms_kernel::Result<Form> + Send,
    ) -> PyResult<Self> {
        done(py, self.cost(), || operator(&self.form)).map(Self::from)
    }
}

/// Differentiating a quotient adds a degree of the weight each time: this refuses in time.
pub(crate) fn check_derivative(form: &Form, orders: &[usize]) -> PyResult<()> {
    let steps = orders.iter().fold(0_usize, |sum, order| sum.saturating_add(*order));
    if !form.is_rational() || steps == 0 {
        return Ok(());
    }
    let degrees = form.orders().iter().map(|order| order - 1);
    let grown: Vec<usize> = degrees
        .map(|degree| degree.saturating_mul(steps.saturating_add(1)).saturating_add(1))
        .collect();
    let work = steps.saturating_mul(form.homogeneous().len());
    limit::check::<f64>("the derivative", &grown, work).map(|_| ()).map_err(|e| raised(&e))
}

/// `host ∘ inner`.
///
/// Errors: `LimitError` when that would take too long.
pub(crate) fn immersed(py: Python<'_>, inner: &Form, host: &Form) -> PyResult<PyForm> {
    let work = immersion_work(inner, host);
    require_feasible("the immersion", work)?;
    done(py, work as usize, || operators::immerse(inner, host)).map(PyForm::from)
}

/// About how many multiplications an immersion takes: the axes of the host are contracted one by
/// one, with polynomials of ever higher degree.
pub(crate) fn immersion_work(inner: &Form, host: &Form) -> f64 {
    let size = |degree: usize| -> f64 {
        inner.orders().iter().map(|order| (degree * (order - 1) + 1) as f64).product()
    };
    let mut degree = 0;
    let mut work = 0.0;
    for (axis, order) in host.orders().iter().enumerate().rev() {
        let products: f64 = host.orders()[..=axis].iter().map(|&order| order as f64).product();
        work += products * size(degree) * size(order - 1) * host.width() as f64;
        degree += order - 1;
    }
    work
}
