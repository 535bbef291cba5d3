//! The class `Form`: construction, what it is made of, and how Python sees it.

use std::hash::{DefaultHasher, Hash, Hasher};

use numpy::PyArrayDyn;
use pforms_kernel::{Error, Form, Result};
use pyo3::prelude::*;
use pyo3::types::{PyTuple, PyType};

use crate::arguments::{real, require_finite, wholes};
use crate::arrays::Numbers;
use crate::errors::{done, fail, renamed};
use crate::outputs::array;
use crate::view::view;

/// A tensor-product rational Bézier form: nothing but its poles.
///
/// Any number of axes (parameters) in a space of any dimension: a point, a curve, a surface, a
/// volume are all forms. Parameter ``k`` runs along array axis ``k``. A form never changes:
/// operators return new ones.
///
/// Parameters
/// ----------
/// poles : array_like, shape (n1, …, nd, c)
///     Points in ``c`` dimensions; shape ``(c,)`` makes a point, a form without axes.
/// weights : array_like, shape (n1, …, nd), optional
///     1 if absent. A weight may be negative, or 0: the pole is then a direction.
///
/// Raises
/// ------
/// ShapeError
///     For ragged lists, an empty array, or weights of another shape.
/// DomainError
///     For NaN and infinities.
///
/// Examples
/// --------
/// >>> import pforms as pf
/// >>> arc = pf.Form([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
/// >>> arc
/// <pforms.Form pL3 in 2D, rational>
/// >>> arc(0.5)
/// array([0.70710678, 0.70710678])
#[pyclass(frozen, module = "pforms", name = "Form", weakref)]
pub(crate) struct PyForm {
    pub(crate) form: Form,
}

impl From<Form> for PyForm {
    fn from(form: Form) -> Self {
        Self { form }
    }
}

#[pymethods]
impl PyForm {
    #[new]
    #[pyo3(signature = (poles, weights=None))]
    fn new(poles: &Bound<'_, PyAny>, weights: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let poles = Numbers::read("poles", poles)?;
        let weights = weights.map(|weights| Numbers::read("weights", weights)).transpose()?;
        from_euclidean("poles", &poles, weights.as_ref())
            .map(Self::from)
            .or_else(|error| fail(&error))
    }

    /// A form from homogeneous poles, the weight last and multiplied in.
    ///
    /// Parameters
    /// ----------
    /// array : array_like, shape (n1, …, nd, c+1)
    ///     The pole ``(x, y)`` of weight ``w`` is ``(x*w, y*w, w)``.
    ///
    /// Raises
    /// ------
    /// ShapeError, DomainError
    ///     As the constructor.
    ///
    /// Examples
    /// --------
    /// >>> pf.Form.from_homogeneous([(1, 0, 1), (1, 1, 2)]).poles
    /// array([[1. , 0. ],
    ///        [0.5, 0.5]])
    #[classmethod]
    fn from_homogeneous(_class: &Bound<'_, PyType>, array: &Bound<'_, PyAny>) -> PyResult<Self> {
        let numbers = Numbers::read("array", array)?;
        from_homogeneous("array", &numbers).map(Self::from).or_else(|error| fail(&error))
    }

    /// The euclidean poles, a new array of shape (n1, …, nd, c).
    ///
    /// A pole of weight 0 is a direction and is given as such, as the constructor takes it.
    ///
    /// >>> pf.Form([(0, 0), (1, 2)]).poles
    /// array([[0., 0.],
    ///        [1., 2.]])
    #[getter]
    fn poles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        poles(py, &self.form)
    }

    /// The weights, a new array of shape (n1, …, nd).
    ///
    /// >>> pf.Form([(0, 0), (1, 2)]).weights
    /// array([1., 1.])
    #[getter]
    fn weights<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        array(py, self.form.orders(), self.form.weights())
    }

    /// The homogeneous poles, shape (n1, …, nd, c+1), the weight last: the form's own, read-only.
    ///
    /// >>> pf.Form([(3, 4)], weights=[2]).homogeneous
    /// array([[6., 8., 2.]])
    #[getter]
    fn homogeneous<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        view(slf)
    }

    /// Number of poles along each axis.
    ///
    /// >>> pf.Form([[(0, 0), (1, 0)], [(0, 1), (1, 1)]]).orders
    /// (2, 2)
    #[getter]
    fn orders<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.form.orders())
    }

    /// Degree along each axis: the order less 1.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).degrees
    /// (2,)
    #[getter]
    fn degrees<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.form.degrees())
    }

    /// Number of axes, that is of parameters.
    ///
    /// >>> pf.Form((0, 0, 1)).axes
    /// 0
    #[getter]
    fn axes(&self) -> usize {
        self.form.axes()
    }

    /// Dimension of the space the form lies in.
    ///
    /// >>> pf.Form((0, 0, 1)).ambient
    /// 3
    #[getter]
    fn ambient(&self) -> usize {
        self.form.ambient()
    }

    /// The kind in the notation of the book: pP, pL4, pS34, pV222, pF[2,2,2,2,2].
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).kind
    /// 'pL3'
    #[getter]
    fn kind(&self) -> String {
        self.form.kind().to_string()
    }

    /// Do the weights differ?
    ///
    /// >>> pf.Form([(0, 0), (1, 2)], weights=[1, 2]).is_rational
    /// True
    #[getter]
    fn is_rational(&self) -> bool {
        self.form.is_rational()
    }

    /// The same form with one pole at another place.
    ///
    /// Parameters
    /// ----------
    /// index : int or tuple of int
    ///     One number for each axis, from 0.
    /// point : array_like, shape (c,), or Form
    ///     The new place, a direction when the weight is 0; or a point with a weight of its own.
    /// weight : float, optional
    ///     The new weight; the old one if absent.
    ///
    /// Raises
    /// ------
    /// ShapeError
    ///     When there is no such pole or the point has another dimension.
    ///
    /// Examples
    /// --------
    /// >>> pf.Form([(0, 0), (1, 2)]).with_pole(1, (5, 5)).poles[1]
    /// array([5., 5.])
    #[pyo3(signature = (index, point, *, weight=None))]
    fn with_pole(
        &self,
        py: Python<'_>,
        index: &Bound<'_, PyAny>,
        point: &Bound<'_, PyAny>,
        weight: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        with_pole(py, &self.form, index, point, weight).map(Self::from)
    }

    fn __repr__(&self) -> String {
        let rational = if self.form.is_rational() { ", rational" } else { "" };
        format!("<pforms.Form {} in {}D{rational}>", self.form.kind(), self.form.ambient())
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.form == other.form
    }

    fn __hash__(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.form.orders().hash(&mut hasher);
        for x in self.form.homogeneous() {
            // −0 equals 0, so they hash alike.
            (x + 0.0).to_bits().hash(&mut hasher);
        }
        hasher.finish()
    }

    fn __copy__(slf: PyRef<'_, Self>) -> PyRef<'_, Self> {
        slf
    }

    fn __deepcopy__<'py>(slf: PyRef<'py, Self>, _memo: &Bound<'py, PyAny>) -> PyRef<'py, Self> {
        slf
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let make = slf.get_type().getattr("from_homogeneous")?;
        Ok((make, PyTuple::new(slf.py(), [view(slf)?])?))
    }
}

impl PyForm {
    /// Shape of an array with `width` numbers for each pole.
    pub(crate) fn shape(&self, width: usize) -> Vec<usize> {
        self.form.orders().iter().copied().chain([width]).collect()
    }
}

/// The euclidean poles in an array; of weight 0 the direction.
pub(crate) fn poles<'py>(py: Python<'py>, form: &Form) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let euclidean = form.homogeneous().chunks_exact(form.width()).flat_map(|pole| {
        let (weight, point) = pole.split_last().unwrap_or((&1.0, pole));
        let divisor = if *weight == 0.0 { 1.0 } else { *weight };
        point.iter().map(move |x| x / divisor)
    });
    let shape: Vec<usize> = form.orders().iter().copied().chain([form.ambient()]).collect();
    array(py, &shape, euclidean.collect())
}

/// The form with one pole at another place.
pub(crate) fn with_pole(
    py: Python<'_>,
    form: &Form,
    index: &Bound<'_, PyAny>,
    point: &Bound<'_, PyAny>,
    weight: Option<&Bound<'_, PyAny>>,
) -> PyResult<Form> {
    let index = wholes("index", index, 1)?;
    if let Ok(point) = point.cast::<PyForm>() {
        let pole = point.get().form.homogeneous();
        return done(py, form.pole_count(), || form.with_pole(&index, pole));
    }
    let point = Numbers::read("point", point)?;
    if point.shape() != [form.ambient()] {
        let received = format!("an array of shape {:?}", point.shape());
        let expected = format!("a point of {} coordinates", form.ambient());
        return fail(&Error::shape("point", received, expected));
    }
    require_finite("point", point.values())?;
    let weight = weight.map(|weight| real("weight", weight)).transpose()?;
    require_finite("weight", weight.as_slice())?;
    let values = point.values();
    done(py, form.pole_count(), || {
        let old = form.pole(&index)?[form.ambient()];
        let pole = Form::from_points(&[], values.len(), values, Some(&[weight.unwrap_or(old)]))?;
        form.with_pole(&index, pole.homogeneous())
    })
}

/// A form from an array of points and one of weights.
pub(crate) fn from_euclidean(
    argument: &str,
    poles: &Numbers,
    weights: Option<&Numbers>,
) -> Result<Form> {
    let (orders, ambient) = split_shape(argument, poles)?;
    if let Some(weights) = weights
        && weights.shape() != orders
    {
        return Err(Error::shape(
            "weights",
            format!("an array of shape {:?}", weights.shape()),
            format!("shape {orders:?}, that of the poles"),
        ));
    }
    Form::from_points(orders, ambient, poles.values(), weights.map(Numbers::values))
        .map_err(|error| renamed(error, "poles", argument))
}

/// A form from an array of homogeneous poles.
pub(crate) fn from_homogeneous(argument: &str, poles: &Numbers) -> Result<Form> {
    let (orders, width) = split_shape(argument, poles)?;
    if width < 2 {
        return Err(Error::shape(
            argument,
            format!("{width} numbers a pole"),
            "at least a coordinate and a weight",
        ));
    }
    Form::from_homogeneous(orders, width - 1, poles.values().to_vec())
        .map_err(|error| renamed(error, "poles", argument))
}

fn split_shape<'a>(argument: &str, poles: &'a Numbers) -> Result<(&'a [usize], usize)> {
    match poles.shape().split_last() {
        Some((&width, orders)) if !poles.values().is_empty() => Ok((orders, width)),
        _ => Err(Error::shape(
            argument,
            format!("an array of shape {:?}", poles.shape()),
            "shape (n1, …, nd, coordinates) with at least one pole",
        )),
    }
}
