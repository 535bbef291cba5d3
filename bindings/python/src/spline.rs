//! The class `Spline`: forms end to end, with knots.

use std::hash::{DefaultHasher, Hash, Hasher};

use numpy::PyArrayDyn;
use pforms_kernel::{Error, Form};
use pforms_operators::{Poles, Spline};
use pyo3::prelude::*;
use pyo3::types::{PyIterator, PyList, PyTuple, PyType};

use crate::arguments::{reals, whole, wholes};
use crate::arrays::Numbers;
use crate::errors::{done, fail, mistyped, raised};
use crate::evaluation::{derivative_orders, points};
use crate::form::{PyForm, from_homogeneous, poles};
use crate::forms::Forms;
use crate::immersed::spline_immersed;
use crate::outputs::array;
use crate::shapes;
use crate::view::view;

/// A B-spline form of any number of axes (NURBS): poles, and along each axis a degree and knots.
///
/// It evaluates as one form and unpacks into its Bézier pieces, the last axis fastest.
///
/// Parameters
/// ----------
/// net : Form or array_like, shape (n1, …, nd, c)
///     The poles; a form brings their weights.
/// degrees : int or sequence of int
///     The degree of every piece along each axis.
/// knots : sequence of sequences of float
///     For each axis a full knot vector of n + degree + 1 numbers; for a curve a plain one will do.
///
/// Raises
/// ------
/// ShapeError
///     When the numbers of poles, degrees and knots do not fit.
/// DomainError
///     When knots decrease, more than degree + 1 coincide, or the window is empty.
///
/// Examples
/// --------
/// >>> curve = pf.Spline([(0, 0), (0, 2), (2, 2), (2, 0)], 2, [0, 1, 2, 3, 4, 5, 6])
/// >>> curve(3)
/// array([1., 2.])
/// >>> low, high = curve
/// >>> low.poles
/// array([[0., 1.],
///        [0., 2.],
///        [1., 2.]])
#[pyclass(frozen, module = "pforms", name = "Spline", weakref)]
pub(crate) struct PySpline {
    pub(crate) spline: Spline,
}

impl From<Spline> for PySpline {
    fn from(spline: Spline) -> Self {
        Self { spline }
    }
}

#[pymethods]
impl PySpline {
    #[new]
    #[pyo3(signature = (net, degrees, knots))]
    fn new(
        net: &Bound<'_, PyAny>,
        degrees: &Bound<'_, PyAny>,
        knots: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let net = shapes::read("net", net)?.net().clone();
        let degrees = wholes("degrees", degrees, net.axes())?;
        let knots = knot_lists(knots, net.axes())?;
        Spline::new(net, &degrees, knots).map(Self::from).map_err(|error| raised(&error))
    }

    /// A spline from homogeneous poles, the weight last and multiplied in.
    ///
    /// Raises ShapeError and DomainError as the constructor.
    ///
    /// >>> pf.Spline.from_homogeneous([(1, 0, 1), (1, 1, 2), (0, 1, 1)], 1, [0, 0, 1, 2, 2])
    /// <pforms.Spline of 2 pieces pL2 in 2D, rational>
    #[classmethod]
    fn from_homogeneous(
        _class: &Bound<'_, PyType>,
        array: &Bound<'_, PyAny>,
        degrees: &Bound<'_, PyAny>,
        knots: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let net = from_homogeneous("array", &Numbers::read("array", array)?);
        let net: Form = net.map_err(|error| raised(&error))?;
        let degrees = wholes("degrees", degrees, net.axes())?;
        let knots = knot_lists(knots, net.axes())?;
        Spline::new(net, &degrees, knots).map(Self::from).map_err(|error| raised(&error))
    }

    /// Forms laid end to end along ``axis``, from break to break.
    ///
    /// Degrees that differ are raised. Where the end of a form is the beginning of the next they
    /// share poles (weights are scaled to agree), elsewhere the spline has a gap. Without breaks
    /// these are 0, 1, 2, …
    ///
    /// Raises
    /// ------
    /// ShapeError, DomainError
    ///     Without forms, when their axes or spaces differ, unless there is one break more than
    ///     forms, and unless the breaks grow.
    ///
    /// Examples
    /// --------
    /// >>> a, b = pf.Form([(0, 0), (1, 2), (2, 0)]), pf.Form([(2, 0), (4, 0)])
    /// >>> pf.Spline.end_to_end([a, b]).knots
    /// (array([0., 0., 0., 1., 1., 2., 2., 2.]),)
    #[classmethod]
    #[pyo3(signature = (forms, breaks=None, axis=None), text_signature = "(forms, breaks=None, axis=0)")]
    fn end_to_end(
        _class: &Bound<'_, PyType>,
        forms: &Bound<'_, PyAny>,
        breaks: Option<&Bound<'_, PyAny>>,
        axis: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let list = Forms::read("forms", forms)?.cloned();
        let breaks = match breaks {
            Some(breaks) => reals("breaks", breaks, 1)?,
            None => (0..=list.len()).map(|i| i as f64).collect(),
        };
        let axis = axis.map_or(Ok(0), |axis| whole("axis", axis))?;
        let cost = list.iter().map(|form| form.homogeneous().len()).sum();
        done(forms.py(), cost, || Spline::end_to_end(&list, axis, &breaks)).map(Self::from)
    }

    /// The knots of each axis.
    ///
    /// >>> pf.Spline([(0,), (1,), (3,)], 1, [0, 0, 1, 2, 2]).knots
    /// (array([0., 0., 1., 2., 2.]),)
    #[getter]
    fn knots<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let lists = self.spline.knots().iter().map(|knots| knots.as_slice().to_vec());
        let arrays: Vec<_> =
            lists.map(|list| array(py, &[list.len()], list)).collect::<PyResult<_>>()?;
        PyTuple::new(py, arrays)
    }

    /// The homogeneous poles, shape (n1, …, c+1), read-only.
    ///
    /// >>> pf.Form([(0,), (2,)]).subdivide(1).homogeneous
    /// array([[0., 1.],
    ///        [1., 1.],
    ///        [2., 1.]])
    #[getter]
    fn homogeneous<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        view(&Bound::new(py, self.net())?)
    }

    /// The euclidean poles, a new array of shape (n1, …, nd, c); directions where the weight is 0.
    ///
    /// >>> pf.Form([(0,), (2,)]).subdivide(1).poles[:, 0]
    /// array([0., 1., 2.])
    #[getter]
    fn poles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        poles(py, self.spline.net())
    }

    /// The weights, a new array of shape (n1, …, nd).
    ///
    /// >>> pf.Form([(0,), (2,)]).subdivide(1).weights
    /// array([1., 1., 1.])
    #[getter]
    fn weights<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        array(py, self.spline.net().orders(), self.spline.net().weights())
    }

    /// Number of poles along each axis, those of all pieces.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).orders
    /// (5,)
    #[getter]
    fn orders<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.spline.net().orders())
    }

    /// The kind of its pieces, in the notation of the book.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).kind
    /// 'pL3'
    #[getter]
    fn kind(&self) -> String {
        self.piece_kind()
    }

    /// Do the weights differ?
    ///
    /// >>> pf.Form([(0, 0), (1, 2)]).subdivide(1).is_rational
    /// False
    #[getter]
    fn is_rational(&self) -> bool {
        self.spline.net().is_rational()
    }

    /// Where the parameter of each axis begins and ends.
    ///
    /// >>> pf.Spline([(0,), (1,), (3,)], 1, [0, 1, 2, 3, 4]).window
    /// ((1.0, 3.0),)
    #[getter]
    fn window<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let windows = (0..self.spline.axes()).map(|axis| self.spline.window(axis));
        let windows = windows.collect::<pforms_kernel::Result<Vec<_>>>();
        PyTuple::new(py, windows.map_err(|error| raised(&error))?)
    }

    /// The poles as a form: the control net, not the same points.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).net
    /// <pforms.Form pL5 in 2D>
    #[getter]
    fn net(&self) -> PyForm {
        self.spline.net().clone().into()
    }

    /// The pieces as forms, the last axis fastest.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).pieces
    /// [<pforms.Form pL3 in 2D>, <pforms.Form pL3 in 2D>]
    #[getter]
    fn pieces<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let pieces = done(py, self.spline.net().homogeneous().len(), || self.spline.pieces())?;
        PyList::new(py, pieces.into_iter().map(PyForm::from))
    }

    /// Along each axis, the parameters where pieces begin and end.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).breaks
    /// (array([0. , 0.5, 1. ]),)
    #[getter]
    fn breaks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let lists = self.spline.breaks().into_iter();
        let arrays: Vec<_> =
            lists.map(|list| array(py, &[list.len()], list)).collect::<PyResult<_>>()?;
        PyTuple::new(py, arrays)
    }

    /// Degree of every piece along each axis.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).degrees
    /// (2,)
    #[getter]
    fn degrees<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.spline.degrees())
    }

    /// Number of pieces along each axis.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(3).counts
    /// (8,)
    #[getter]
    fn counts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.spline.counts())
    }

    /// Number of axes.
    ///
    /// >>> pf.Form([(0, 0), (1, 2)]).subdivide(1).axes
    /// 1
    #[getter]
    fn axes(&self) -> usize {
        self.spline.net().axes()
    }

    /// Dimension of the space the pieces lie in.
    ///
    /// >>> pf.Form([(0, 0), (1, 2)]).subdivide(1).ambient
    /// 2
    #[getter]
    fn ambient(&self) -> usize {
        self.spline.net().ambient()
    }

    /// Points at broadcast parameters, as :meth:`Form.__call__`; of a form or a spline in its
    /// parameter space the immersion, see :func:`immerse`.
    ///
    /// Each piece counts from its break up to the next; outside the window the outermost go on.
    ///
    /// >>> curve = pf.Spline([(0, 0), (0, 2), (2, 2), (2, 0)], 2, [0, 1, 2, 3, 4, 5, 6])
    /// >>> curve([2, 3, 4])
    /// array([[0., 1.],
    ///        [1., 2.],
    ///        [2., 1.]])
    #[pyo3(signature = (*parameters))]
    fn __call__<'py>(
        this: &Bound<'py, Self>,
        parameters: &Bound<'py, PyTuple>,
    ) -> PyResult<Bound<'py, PyAny>> {
        if let Ok(inner) = parameters.get_item(0)
            && (inner.is_instance_of::<PyForm>() || inner.is_instance_of::<Self>())
        {
            return spline_immersed(&inner, this.as_any());
        }
        points(&this.get().spline, parameters, None, None).map(Bound::into_any)
    }

    /// Points or derivatives at parameters, as :meth:`Form.evaluate`.
    ///
    /// >>> curve = pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1)
    /// >>> curve.evaluate([0.25, 0.75], derivative=1)
    /// array([[ 2.,  2.],
    ///        [ 2., -2.]])
    #[pyo3(signature = (*parameters, derivative=None, out=None))]
    fn evaluate<'py>(
        &self,
        parameters: &Bound<'py, PyTuple>,
        derivative: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let orders = derivative.map(|d| derivative_orders(d, self.spline.net())).transpose()?;
        points(&self.spline, parameters, orders.as_deref(), out)
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        self.pieces(py)?.try_iter()
    }

    fn __len__(&self) -> usize {
        self.spline.counts().iter().product()
    }

    fn __repr__(&self) -> String {
        let counts: Vec<String> = self.spline.counts().iter().map(usize::to_string).collect();
        let one = self.spline.counts().iter().all(|count| *count == 1);
        let rational = if self.is_rational() { ", rational" } else { "" };
        format!(
            "<pforms.Spline of {} {} {} in {}D{rational}>",
            if one { "1".to_owned() } else { counts.join("×") },
            if one { "piece" } else { "pieces" },
            self.piece_kind(),
            self.spline.ambient()
        )
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.spline == other.spline
    }

    fn __hash__(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.spline.net().orders().hash(&mut hasher);
        let knots = self.spline.knots().iter().flat_map(pforms_operators::Knots::as_slice);
        for x in self.spline.net().homogeneous().iter().chain(knots) {
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

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Restored<'py>)> {
        let make = py.get_type::<Self>().getattr("from_homogeneous")?;
        let knots = self.spline.knots().iter().map(|knots| knots.as_slice().to_vec());
        Ok((make, (self.homogeneous(py)?, self.spline.degrees(), knots.collect())))
    }
}

impl PySpline {
    fn piece_kind(&self) -> String {
        let orders: Vec<usize> = self.spline.degrees().iter().map(|degree| degree + 1).collect();
        pforms_kernel::Kind::new(&orders).to_string()
    }

    /// About how many multiplications an operator that passes once over each axis takes.
    pub(crate) fn cost(&self) -> usize {
        let degrees = self.spline.degrees().into_iter();
        let numbers = self.spline.net().homogeneous().len();
        degrees.fold(numbers, |cost, degree| cost.saturating_mul(degree + 1))
    }
}

/// A list of knots for each axis; of a curve a plain list of numbers.
pub(crate) fn knot_lists(object: &Bound<'_, PyAny>, axes: usize) -> PyResult<Vec<Vec<f64>>> {
    if axes == 1
        && let Ok(numbers) = Numbers::read("knots", object)
        && numbers.shape().len() == 1
    {
        return Ok(vec![numbers.into_values()]);
    }
    let Ok(lists) = object.try_iter() else {
        return Err(mistyped("knots", object, "a sequence of numbers for each axis"));
    };
    lists
        .map(|list| {
            let numbers = Numbers::read("knots", &list?)?;
            match numbers.shape() {
                [_] => Ok(numbers.into_values()),
                shape => fail(&Error::shape(
                    "knots",
                    format!("an array of shape {shape:?} for one axis"),
                    "a sequence of numbers for each axis",
                )),
            }
        })
        .collect()
}

/// Net, degrees and knots, as they are pickled.
type Restored<'py> = (Bound<'py, PyArrayDyn<f64>>, Vec<usize>, Vec<Vec<f64>>);
