//! Sums of forms with coefficients, of their poles or of their points; forms that spread.

use pforms_operators::{self as operators, Poles, Shape};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arguments::{reals, truth, whole, wholes};
use crate::arrays::Numbers;
use crate::errors::{done, raised};
use crate::form::PyForm;
use crate::shapes;
use crate::slices::require_feasible;
use crate::spline::PySpline;

type Object<'py> = Bound<'py, PyAny>;

/// Σ kᵢ·fᵢ on the homogeneous poles, orders raised as needed; a point is the same everywhere.
///
/// ``Σk = 1`` gives points from points, ``Σk = 0`` directions. Splines are brought to common knots.
///
/// Parameters
/// ----------
/// k : sequence of float
/// *forms : Form or Spline
///     As many as numbers, one by one or in a list.
/// pointwise : bool, optional
///     Combine the points instead of the poles, whatever the weights: exact, and orders add where
///     weights differ by more than a factor. Forms of directions add their vectors.
///
/// Returns
/// -------
/// Form, or Spline if one of them is
///
/// Raises
/// ------
/// ShapeError, DomainError
///     When counts, axes, spaces or windows differ; for NaN.
/// LimitError
///     When the result is too large.
///
/// Examples
/// --------
/// >>> pf.combine([2, -1], pf.Form((0, 0)), pf.Form((1, 2))).poles
/// array([-1., -2.])
/// >>> heavy, light = pf.Form((0,), 3), pf.Form((4,))
/// >>> pf.combine([0.5, 0.5], heavy, light).poles
/// array([1.])
/// >>> pf.combine([0.5, 0.5], heavy, light, pointwise=True).poles
/// array([2.])
#[pyfunction]
#[pyo3(
    signature = (k, *forms, pointwise=None),
    text_signature = "(k, *forms, pointwise=False)"
)]
pub(crate) fn combine<'py>(
    k: &Object<'py>,
    forms: &Bound<'py, PyTuple>,
    pointwise: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let k = reals("k", k, 1)?;
    let pointwise = pointwise.map_or(Ok(false), |given| truth("pointwise", given))?;
    summed(&k, &shapes::several("forms", forms)?, pointwise, forms.py())
}

/// The form symmetric to another with respect to a third: ``2*middle - form``.
///
/// Parameters
/// ----------
/// middle, form : Form or Spline
/// pointwise : bool, optional
///     Take the points across, not the poles. Where weights are equal it is the same.
///
/// Raises
/// ------
/// ShapeError, LimitError
///     When axes, spaces or windows differ; when the result is too large.
///
/// Examples
/// --------
/// >>> pf.symmetric(pf.Form([(1, 0), (1, 2)]), pf.Form([(0, 0), (0, 1)])).poles
/// array([[2., 0.],
///        [2., 3.]])
#[pyfunction]
#[pyo3(
    signature = (middle, form, *, pointwise=None),
    text_signature = "(middle, form, *, pointwise=False)"
)]
pub(crate) fn symmetric<'py>(
    middle: &Object<'py>,
    form: &Object<'py>,
    pointwise: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let pointwise = pointwise.map_or(Ok(false), |given| truth("pointwise", given))?;
    let pair = [shapes::read("middle", middle)?, shapes::read("form", form)?];
    summed(&[2.0, -1.0], &pair, pointwise, form.py())
}

fn summed<'py>(
    k: &[f64],
    list: &[Shape],
    pointwise: bool,
    py: Python<'py>,
) -> PyResult<Object<'py>> {
    let size: usize = list.iter().map(|shape| shape.net().homogeneous().len()).sum();
    let nets: Vec<_> = list.iter().map(Poles::net).collect();
    let cost = if pointwise { operators::pointwise_work(&nets) } else { size as f64 };
    require_feasible("the combination", cost)?;
    let sum = done(py, cost as usize, || operators::combine_shapes(k, list, pointwise))?;
    shapes::object(py, sum)
}

/// A form carried along a vector or a path, and all it passes through.
///
/// The result is ``path(s) + form(t)``, axes of the path first; exact.
///
/// Parameters
/// ----------
/// form : Form or Spline
/// path : sequence of float, Form or Spline
///     A vector: the path is the segment from the origin. A form with axes: each of its points is a
///     vector.
///
/// Raises
/// ------
/// ShapeError, LimitError
///     When the spaces differ; when the result is too large.
///
/// Examples
/// --------
/// >>> arch = pf.Form([(0, 0, 0), (1, 0, 2), (2, 0, 0)])
/// >>> pf.extrude(arch, (0, 5, 0))(1, 0.5)
/// array([1., 5., 1.])
/// >>> pf.extrude(arch, pf.Form([(0, 0, 0), (0, 1, 1), (0, 2, 0)]))
/// <pforms.Form pS33 in 3D>
#[pyfunction]
#[pyo3(signature = (form, path))]
pub(crate) fn extrude<'py>(form: &Object<'py>, path: &Object<'py>) -> PyResult<Object<'py>> {
    let py = form.py();
    let shape = shapes::read("form", form)?;
    let vector = vector(path)?;
    let along = match vector {
        None => shapes::read("path", path)?,
        Some(by) => {
            let segment = operators::path_of(&by, shape.net().ambient());
            segment.map_err(|error| raised(&error))?.into()
        }
    };
    let cost = shape.net().homogeneous().len().saturating_mul(along.net().pole_count());
    shapes::object(py, done(py, cost, || operators::extrude_shapes(&shape, &along))?)
}

/// The numbers of a vector; `None` for a form with axes, and for a net.
fn vector(path: &Object<'_>) -> PyResult<Option<Vec<f64>>> {
    if path.is_instance_of::<PySpline>() {
        return Ok(None);
    }
    if let Ok(form) = path.cast::<PyForm>()
        && form.get().form.axes() > 0
    {
        return Ok(None);
    }
    let numbers = Numbers::read("path", path)?;
    Ok((numbers.shape().len() < 2).then(|| numbers.into_values()))
}

/// Straight lines from each point of a form to the same point of another: a new axis 0.
///
/// Two curves make a ruled surface, two surfaces a volume, a form and a point a cone.
///
/// Parameters
/// ----------
/// first, second : Form or Spline
///     Orders are raised and knots made common as needed.
///
/// Raises
/// ------
/// ShapeError, LimitError
///     When axes, spaces or windows differ; when the result is too large.
///
/// Examples
/// --------
/// >>> pf.ruled(pf.Form([(0, 0, 0), (1, 0, 1)]), pf.Form([(0, 1, 1), (1, 1, 0)]))(0.5, 0.5)
/// array([0.5, 0.5, 0.5])
/// >>> pf.ruled(pf.Form([(0, 0), (1, 1), (2, 0)]), pf.Form((1, 3)))
/// <pforms.Form pS23 in 2D>
#[pyfunction]
#[pyo3(signature = (first, second))]
pub(crate) fn ruled<'py>(first: &Object<'py>, second: &Object<'py>) -> PyResult<Object<'py>> {
    let py = first.py();
    let (a, b) = (shapes::read("first", first)?, shapes::read("second", second)?);
    let cost = 2 * (a.net().homogeneous().len() + b.net().homogeneous().len());
    shapes::object(py, done(py, cost, || operators::ruled_shapes(&a, &b))?)
}

/// A straight curve along x with poles at equal steps, centred on the origin.
///
/// Parameters
/// ----------
/// order : int, optional
///     How many poles.
/// size : float, optional
/// ambient : int, optional
///     The dimension of the space.
///
/// Raises
/// ------
/// DomainError, ShapeError, LimitError
///     For NaN; without a pole or a space; when too large.
///
/// Examples
/// --------
/// >>> pf.line(3, 2.0, ambient=1).poles.ravel()
/// array([-1.,  0.,  1.])
#[pyfunction]
#[pyo3(
    signature = (order=None, size=None, *, ambient=None),
    text_signature = "(order=2, size=1.0, *, ambient=None)"
)]
pub(crate) fn line(
    py: Python<'_>,
    order: Option<&Object<'_>>,
    size: Option<&Object<'_>>,
    ambient: Option<&Object<'_>>,
) -> PyResult<PyForm> {
    let order = order.map_or(Ok(2), |order| whole("order", order))?;
    regular(py, &[order], size, ambient)
}

/// A flat surface in the plane xy with poles at equal steps, centred on the origin.
///
/// Parameters
/// ----------
/// orders : int or pair of int, optional
///     How many poles along each axis; x runs along axis 0.
/// size : float or pair of float, optional
/// ambient : int, optional
///     The dimension of the space.
///
/// Raises
/// ------
/// DomainError, ShapeError, LimitError
///     For NaN; for other numbers of orders or sizes, or a space too small; when too large.
///
/// Examples
/// --------
/// >>> pf.facet((3, 4), 2.0)
/// <pforms.Form pS34 in 3D>
#[pyfunction]
#[pyo3(
    signature = (orders=None, size=None, *, ambient=None),
    text_signature = "(orders=2, size=1.0, *, ambient=None)"
)]
pub(crate) fn facet(
    py: Python<'_>,
    orders: Option<&Object<'_>>,
    size: Option<&Object<'_>>,
    ambient: Option<&Object<'_>>,
) -> PyResult<PyForm> {
    let orders = orders.map_or(Ok(vec![2; 2]), |orders| wholes("orders", orders, 2))?;
    if orders.len() != 2 {
        let received = format!("{} numbers", orders.len());
        return Err(raised(&pforms_kernel::Error::shape("orders", received, "one, or 2")));
    }
    regular(py, &orders, size, ambient)
}

/// A box with poles at equal steps, centred on the origin, of any number of axes.
///
/// Parameters
/// ----------
/// orders : int or sequence of int, optional
///     How many poles along each axis; a number stands for three axes. Coordinate k runs along axis k.
/// size : float or sequence of float, optional
/// ambient : int, optional
///     The dimension of the space: 3, or the number of axes if there are more.
///
/// Raises
/// ------
/// DomainError, ShapeError, LimitError
///     For NaN; for another number of sizes, or a space too small; when too large.
///
/// Examples
/// --------
/// >>> pf.cube((2, 2, 3), 2.0)
/// <pforms.Form pV223 in 3D>
/// >>> pf.cube((2, 2, 2, 2))
/// <pforms.Form pH2222 in 4D>
#[pyfunction]
#[pyo3(
    signature = (orders=None, size=None, *, ambient=None),
    text_signature = "(orders=2, size=1.0, *, ambient=None)"
)]
pub(crate) fn cube(
    py: Python<'_>,
    orders: Option<&Object<'_>>,
    size: Option<&Object<'_>>,
    ambient: Option<&Object<'_>>,
) -> PyResult<PyForm> {
    let orders = orders.map_or(Ok(vec![2; 3]), |orders| wholes("orders", orders, 3))?;
    regular(py, &orders, size, ambient)
}

fn regular(
    py: Python<'_>,
    orders: &[usize],
    size: Option<&Object<'_>>,
    ambient: Option<&Object<'_>>,
) -> PyResult<PyForm> {
    let axes = orders.len();
    let sizes = size.map_or(Ok(vec![1.0; axes]), |size| reals("size", size, axes))?;
    let ambient = ambient.map_or(Ok(axes.max(3)), |ambient| whole("ambient", ambient))?;
    let cost = orders.iter().fold(ambient, |cost, order| cost.saturating_mul(*order));
    done(py, cost, || operators::regular(orders, &sizes, ambient)).map(PyForm::from)
}

/// The functions of this file whose first argument is a form, as methods.
macro_rules! methods {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The form symmetric to another with respect to this one: :func:`pforms.symmetric`.
            ///
            /// >>> pf.Form([(1, 0), (1, 2)]).symmetric(pf.Form([(0, 0), (0, 1)])).poles
            /// array([[2., 0.],
            ///        [2., 3.]])
            #[pyo3(name = "symmetric")]
            #[pyo3(signature = (form, *, pointwise=None))]
            #[pyo3(text_signature = "($self, form, *, pointwise=False)")]
            fn symmetric_to<'py>(
                slf: &Bound<'py, Self>,
                form: &Object<'py>,
                pointwise: Option<&Object<'py>>,
            ) -> PyResult<Object<'py>> {
                symmetric(slf.as_any(), form, pointwise)
            }

            /// This carried along a vector or a path: :func:`pforms.extrude`.
            ///
            /// >>> pf.Form([(0, 0, 0), (1, 0, 0)]).extrude((0, 0, 2))
            /// <pforms.Form pS22 in 3D>
            #[pyo3(name = "extrude", signature = (path))]
            fn extruded<'py>(slf: &Bound<'py, Self>, path: &Object<'py>) -> PyResult<Object<'py>> {
                extrude(slf.as_any(), path)
            }

            /// Straight lines from this to another: :func:`pforms.ruled`.
            ///
            /// >>> pf.Form([(0, 0), (1, 1), (2, 0)]).ruled(pf.Form((1, 3)))
            /// <pforms.Form pS23 in 2D>
            #[pyo3(name = "ruled", signature = (second))]
            fn ruled_to<'py>(
                slf: &Bound<'py, Self>,
                second: &Object<'py>,
            ) -> PyResult<Object<'py>> {
                ruled(slf.as_any(), second)
            }
        }
    };
}

methods!(PyForm);
methods!(PySpline);
