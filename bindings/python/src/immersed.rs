//! The class `Immersed`: host and inner side by side, until someone asks for poles.

use numpy::PyArrayDyn;
use pforms_kernel::threads::fill_parts;
use pforms_kernel::{Form, Kind};
use pforms_operators::{self as operators, Forecast, Immersed, Poles};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString, PyTuple};

use crate::arguments::{form, truth, whole};
use crate::errors::{done, raised};
use crate::evaluation::{derivative_orders, points};
use crate::form::PyForm;
use crate::forms::Forms;
use crate::operators::{immersed, immersion_work};
use crate::shapes;
use crate::slices::{in_slices, require_feasible};
use crate::spline::PySpline;

/// An immersed form without its poles: ``pf.immerse(inner, host, lazy=True)``.
///
/// Degrees multiply under immersion and evaluation does not need them. Points and derivatives are
/// exact; :meth:`expand` makes the poles, :meth:`forecast` tells what that would cost.
///
/// >>> host = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
/// >>> lazy = pf.immerse(pf.Form([(0, 0), (1, 1)]), host, lazy=True)
/// >>> lazy
/// <pforms.Immersed ipL2 in pS22, 3D>
/// >>> lazy(0.5)
/// array([0.5, 0.5, 0.5])
#[pyclass(frozen, module = "pforms", name = "Immersed", weakref)]
pub(crate) struct PyImmersed {
    pub(crate) immersed: Immersed,
}

impl From<Immersed> for PyImmersed {
    fn from(immersed: Immersed) -> Self {
        Self { immersed }
    }
}

/// Immerses with or without poles.
///
/// The inner form lives in the parameter space of the host: its coordinate ``k`` is parameter
/// ``k``. Any dimensions, polynomial or rational on either side. Along inner axis ``k`` of order
/// ``q`` the result has order ``(Σ (m - 1))·(q - 1) + 1`` for host orders ``m``.
///
/// Parameters
/// ----------
/// inner : Form, Spline or sequence of Form
/// host : Form or Spline
///     The inner form is cut where it crosses a knot of a spline, and the result is a spline.
/// lazy : bool, optional
///     Keep host and inner side by side: no poles until :meth:`Immersed.expand`.
///
/// Returns
/// -------
/// Form, or Immersed if lazy; Spline if one of them is; a list for a sequence of forms
///
/// Raises
/// ------
/// ShapeError
///     When the inner coordinates do not fit the axes of the host.
/// DomainError
///     When a surface crosses a knot of the host aslant: it cannot be cut into tensor products.
/// LimitError
///     With the forecast size, or above 1e11 multiplications: lazily there is no limit.
///
/// Examples
/// --------
/// >>> host = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
/// >>> diagonal = pf.Form([(0, 0), (1, 1)])
/// >>> pf.immerse(diagonal, host) == host.diagonal()
/// True
/// >>> pf.immerse([diagonal, diagonal], host)
/// [<pforms.Form pL3 in 3D>, <pforms.Form pL3 in 3D>]
#[pyfunction]
#[pyo3(signature = (inner, host, lazy=None), text_signature = "(inner, host, lazy=False)")]
pub(crate) fn immerse<'py>(
    inner: &Bound<'py, PyAny>,
    host: &Bound<'py, PyAny>,
    lazy: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = inner.py();
    let lazy = lazy.map_or(Ok(false), |lazy| truth("lazy", lazy))?;
    if !lazy && (inner.is_instance_of::<PySpline>() || host.is_instance_of::<PySpline>()) {
        return spline_immersed(inner, host);
    }
    let host = form("host", host)?;
    let Ok(one) = inner.cast::<PyForm>() else {
        let list = Forms::read("inner", inner)?;
        return if lazy {
            let kept = list.cloned().into_iter().map(|inner| kept(inner, host.clone()));
            kept.collect::<PyResult<Vec<_>>>()?.into_bound_py_any(py)
        } else {
            all_immersed(py, &list.refs(), &host)?.into_bound_py_any(py)
        };
    };
    let inner = &one.get().form;
    if lazy {
        return kept(inner.clone(), host)?.into_bound_py_any(py);
    }
    immersed(py, inner, &host)?.into_bound_py_any(py)
}

/// `host ∘ inner` when one of them is a spline.
pub(crate) fn spline_immersed<'py>(
    inner: &Bound<'py, PyAny>,
    host: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = inner.py();
    let (inner, host) = (shapes::read("inner", inner)?, shapes::read("host", host)?);
    let cost = inner.net().homogeneous().len().saturating_mul(host.net().homogeneous().len());
    done(py, cost, || operators::immerse_spline(&inner, &host))
        .map(PySpline::from)?
        .into_bound_py_any(py)
}

fn kept(inner: Form, host: Form) -> PyResult<PyImmersed> {
    Immersed::new(inner, host).map(PyImmersed::from).map_err(|error| raised(&error))
}

/// `host ∘ inner` for each inner form, in slices and on all threads.
fn all_immersed(py: Python<'_>, inners: &[&Form], host: &Form) -> PyResult<Vec<PyForm>> {
    let work = inners.iter().map(|inner| immersion_work(inner, host)).fold(0.0, f64::max);
    require_feasible("each immersion", work)?;
    let cost = work as usize;
    let mut forms = vec![None; inners.len()];
    in_slices(py, inners.len(), cost, |range| {
        fill_parts(&mut forms[range.clone()], 1, 2 * cost, |part, forms| {
            for (form, inner) in forms.iter_mut().zip(&inners[range.clone()][part]) {
                *form = Some(operators::immerse(inner, host)?);
            }
            Ok(())
        })
    })?;
    Ok(forms.into_iter().flatten().map(PyForm::from).collect())
}

/// What an immersion would cost: a dict of ``orders``, ``poles`` and ``bytes``. Nothing is made.
///
/// Parameters
/// ----------
/// inner, host : str or Form
///     Kinds such as "pL3", or forms.
/// ambient : int, optional
///     Dimension of the space of a host given by its kind.
///
/// Raises
/// ------
/// ShapeError
///     For a text that is no kind.
///
/// Examples
/// --------
/// >>> pf.forecast("pL3", "pS33")
/// {'orders': (9,), 'poles': 9, 'bytes': 288}
#[pyfunction]
#[pyo3(signature = (inner, host, ambient=None), text_signature = "(inner, host, ambient=3)")]
pub(crate) fn forecast<'py>(
    inner: &Bound<'py, PyAny>,
    host: &Bound<'py, PyAny>,
    ambient: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let ambient = match (host.cast::<PyForm>(), ambient) {
        (Ok(host), _) => host.get().form.ambient(),
        (_, Some(ambient)) => whole("ambient", ambient)?,
        (_, None) => 3,
    };
    let (py, inner, host) = (inner.py(), orders("inner", inner)?, orders("host", host)?);
    told(py, operators::forecast::<f64>(&inner, &host, ambient))
}

fn orders(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<Vec<usize>> {
    match object.cast::<PyString>() {
        Err(_) => Ok(form(argument, object)?.orders().to_vec()),
        Ok(text) => match text.to_string_lossy().parse::<Kind>() {
            Ok(kind) => Ok(kind.orders().to_vec()),
            Err(error) => Err(raised(&error)),
        },
    }
}

fn told(py: Python<'_>, forecast: Forecast) -> PyResult<Bound<'_, PyDict>> {
    let answer = PyDict::new(py);
    answer.set_item("orders", PyTuple::new(py, forecast.orders)?)?;
    answer.set_item("poles", forecast.poles)?;
    answer.set_item("bytes", forecast.bytes)?;
    Ok(answer)
}

#[pymethods]
impl PyImmersed {
    #[new]
    #[pyo3(signature = (inner, host))]
    fn new(inner: &Bound<'_, PyAny>, host: &Bound<'_, PyAny>) -> PyResult<Self> {
        kept(form("inner", inner)?, form("host", host)?)
    }

    /// The form in whose parameters the inner one lives.
    ///
    /// >>> pf.Immersed(pf.Form([(0,), (1,)]), pf.Form([(0, 0), (1, 2)])).host
    /// <pforms.Form pL2 in 2D>
    #[getter]
    fn host(&self) -> PyForm {
        self.immersed.host().clone().into()
    }

    /// The form inside.
    ///
    /// >>> pf.Immersed(pf.Form([(0,), (1,)]), pf.Form([(0, 0), (1, 2)])).inner
    /// <pforms.Form pL2 in 1D>
    #[getter]
    fn inner(&self) -> PyForm {
        self.immersed.inner().clone().into()
    }

    /// The kind as the book writes it, with an ``i``.
    ///
    /// >>> pf.Immersed(pf.Form([(0,), (1,)]), pf.Form([(0, 0), (1, 2)])).kind
    /// 'ipL2'
    #[getter]
    fn kind(&self) -> String {
        self.immersed.kind()
    }

    /// Number of axes: that of the inner form.
    ///
    /// >>> pf.Immersed(pf.Form([(0,), (1,)]), pf.Form([(0, 0), (1, 2)])).axes
    /// 1
    #[getter]
    fn axes(&self) -> usize {
        self.immersed.inner().axes()
    }

    /// Dimension of the space: that of the host.
    ///
    /// >>> pf.Immersed(pf.Form([(0,), (1,)]), pf.Form([(0, 0), (1, 2)])).ambient
    /// 2
    #[getter]
    fn ambient(&self) -> usize {
        self.immersed.host().ambient()
    }

    /// What :meth:`expand` would cost: a dict of ``orders``, ``poles`` and ``bytes``.
    ///
    /// >>> pf.Immersed(pf.Form([(0,), (1,)]), pf.Form([(0, 0), (1, 2)])).forecast()
    /// {'orders': (2,), 'poles': 2, 'bytes': 48}
    fn forecast<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        told(py, self.immersed.forecast())
    }

    /// The form with its poles, as :func:`immerse`. Raises LimitError with the forecast size.
    ///
    /// >>> pf.Immersed(pf.Form([(0,), (1,)]), pf.Form([(0, 0), (1, 2)])).expand()
    /// <pforms.Form pL2 in 2D>
    fn expand(&self, py: Python<'_>) -> PyResult<PyForm> {
        immersed(py, self.immersed.inner(), self.immersed.host())
    }

    /// Points at broadcast parameters, as :meth:`Form.__call__`.
    #[pyo3(signature = (*parameters))]
    fn __call__<'py>(
        &self,
        parameters: &Bound<'py, PyTuple>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        self.evaluate(parameters, None, None)
    }

    /// Points or derivatives, as :meth:`Form.evaluate`.
    ///
    /// >>> lazy = pf.Immersed(pf.Form([(0,), (1,)]), pf.Form([(0, 0), (1, 2)]))
    /// >>> lazy.evaluate(0.5, derivative=1)
    /// array([1., 2.])
    #[pyo3(signature = (*parameters, derivative=None, out=None))]
    fn evaluate<'py>(
        &self,
        parameters: &Bound<'py, PyTuple>,
        derivative: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let inner = self.immersed.inner();
        let orders = derivative.map(|d| derivative_orders(d, inner)).transpose()?;
        points(&self.immersed, parameters, orders.as_deref(), out)
    }

    fn __repr__(&self) -> String {
        let (kind, host) = (self.immersed.kind(), self.immersed.host());
        format!("<pforms.Immersed {kind} in {}, {}D>", host.kind(), host.ambient())
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.immersed == other.immersed
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> (Bound<'py, PyAny>, (PyForm, PyForm)) {
        (py.get_type::<Self>().into_any(), (self.inner(), self.host()))
    }
}
