//! Operators on one spline, as methods.

use numpy::PyArrayDyn;
use pforms_kernel::{Error, Result};
use pforms_operators::{Poles, Removal, Spline};
use pyo3::prelude::*;
use pyo3::types::{PyString, PyTuple};

use crate::arguments::{axis, level, real, reals, whole, wholes};
use crate::errors::{done, fail, raised};
use crate::files::save;
use crate::form::{PyForm, with_pole};
use crate::measuring::{curvature, frame, normals};
use crate::operators::check_derivative;
use crate::shapes::object;
use crate::spline::PySpline;

#[pymethods]
impl PySpline {
    /// The piece at an index along each axis, as a form. Raises ShapeError when there is none.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(2).piece(3)
    /// <pforms.Form pL3 in 2D>
    #[pyo3(signature = (*index))]
    fn piece(&self, index: &Bound<'_, PyTuple>) -> PyResult<PyForm> {
        let list: Vec<usize> = index.iter().map(|i| whole("index", &i)).collect::<PyResult<_>>()?;
        done(index.py(), self.cost(), || self.spline.piece(&list)).map(PyForm::from)
    }

    /// The same spline with every knot repeated until the pieces share no more than end poles.
    ///
    /// Its poles are the control polygons of the pieces, end to end. Exact.
    ///
    /// >>> pf.Spline([(0,), (2,), (2,), (4,)], 2, range(7)).bezier().poles[:, 0]
    /// array([1., 2., 2., 2., 3.])
    fn bezier(&self, py: Python<'_>) -> PyResult<Self> {
        self.worked(py, Spline::bezier)
    }

    /// The spline with the knot ``t`` of ``axis`` once less, and how far a pole is off.
    ///
    /// Returns
    /// -------
    /// (Spline, float)
    ///     The largest distance, in a homogeneous coordinate, between a pole and what inserting the
    ///     knot again gives: 0, or rounding, where the knot was not needed.
    ///
    /// Raises
    /// ------
    /// ShapeError, DomainError
    ///     Without such an axis, and unless ``t`` is an inner knot.
    ///
    /// Examples
    /// --------
    /// >>> curve = pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1)
    /// >>> less, error = curve.remove_knot(0, 0.5)
    /// >>> less.orders, error
    /// ((4,), 0.0)
    #[pyo3(signature = (axis, t))]
    fn remove_knot(&self, axis: &Bound<'_, PyAny>, t: &Bound<'_, PyAny>) -> PyResult<(Self, f64)> {
        let (k, t) = (self.axis(axis)?, real("t", t)?);
        let Removal { spline, defect } =
            done(axis.py(), self.cost(), || self.spline.remove_knot(k, &t))?;
        Ok((spline.into(), defect))
    }

    /// The same spline with its degree raised by ``by`` along each axis, as smooth as before.
    ///
    /// Raises ShapeError and DomainError for a wrong count and negative numbers.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).elevate(1).kind
    /// 'pL4'
    #[pyo3(signature = (by))]
    fn elevate(&self, by: &Bound<'_, PyAny>) -> PyResult<Self> {
        let steps = wholes("by", by, self.spline.axes())?;
        self.worked(by.py(), |spline| spline.elevate(&steps))
    }

    /// Every piece halved ``r`` times along each axis. Raises as :meth:`Form.subdivide`.
    ///
    /// >>> pf.Spline([(0,), (2,), (2,), (4,)], 2, range(7)).subdivide(1)
    /// <pforms.Spline of 4 pieces pL3 in 1D>
    #[pyo3(signature = (r))]
    fn subdivide(&self, r: &Bound<'_, PyAny>) -> PyResult<Self> {
        let levels = wholes("r", r, self.spline.axes())?;
        let levels: Vec<u32> =
            levels.into_iter().map(|r| level("r", r)).collect::<PyResult<_>>()?;
        self.worked(r.py(), |spline| spline.subdivide(&levels))
    }

    /// The two parts before and after ``t`` along ``axis``, each with its own parameters. Exact.
    ///
    /// Raises ShapeError without such an axis, DomainError unless ``t`` is inside the window.
    ///
    /// >>> low, high = pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).split(0, 0.25)
    /// >>> low.window, high.breaks
    /// (((0.0, 0.25),), (array([0.25, 0.5 , 1.  ]),))
    #[pyo3(signature = (axis, t))]
    fn split(&self, axis: &Bound<'_, PyAny>, t: &Bound<'_, PyAny>) -> PyResult<(Self, Self)> {
        let (k, t) = (self.axis(axis)?, real("t", t)?);
        let (low, high) = done(axis.py(), self.cost(), || self.spline.split(k, &t))?;
        Ok((low.into(), high.into()))
    }

    /// The part from ``a`` to ``b`` along ``axis``, which keeps its parameters. Exact.
    ///
    /// Beyond the window the outermost piece goes on. Raises ShapeError without such an axis,
    /// DomainError unless a < b.
    ///
    /// >>> pf.Form([(0,), (4,)]).subdivide(1).restrict(0, 0.25, 2).poles[:, 0]
    /// array([1., 2., 8.])
    #[pyo3(signature = (axis, a, b))]
    fn restrict(
        &self,
        axis: &Bound<'_, PyAny>,
        a: &Bound<'_, PyAny>,
        b: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let (k, a, b) = (self.axis(axis)?, real("a", a)?, real("b", b)?);
        self.worked(axis.py(), |spline| spline.restrict(k, &a, &b))
    }

    /// The spline on the window [a, b], its parameters counted from 0 to 1 again.
    ///
    /// As :meth:`Form.stretch`: restricted, extended or, for a > b, reversed. Raises ShapeError for
    /// a wrong count, DomainError for NaN and for a = b.
    ///
    /// >>> pf.Form([(0,), (4,)]).subdivide(1).stretch(0.25, 1).breaks
    /// (array([0.        , 0.33333333, 1.        ]),)
    #[pyo3(signature = (a, b))]
    fn stretch(&self, a: &Bound<'_, PyAny>, b: &Bound<'_, PyAny>) -> PyResult<Self> {
        let axes = self.spline.axes();
        let (from, to) = (reals("a", a, axes)?, reals("b", b, axes)?);
        self.worked(a.py(), |spline| spline.stretch(&from, &to))
    }

    /// The same points with other parameters: ``axis`` runs from ``a`` to ``b``, knots in
    /// proportion.
    ///
    /// Raises ShapeError without such an axis, DomainError unless a < b, far enough apart to tell
    /// the knots from one another.
    ///
    /// >>> pf.Form([(0,), (4,)]).subdivide(1).on_window(0, 10, 20).breaks
    /// (array([10., 15., 20.]),)
    #[pyo3(signature = (axis, a, b))]
    fn on_window(
        &self,
        axis: &Bound<'_, PyAny>,
        a: &Bound<'_, PyAny>,
        b: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let (k, a, b) = (self.axis(axis)?, real("a", a)?, real("b", b)?);
        self.worked(axis.py(), |spline| spline.on_window(k, &a, &b))
    }

    /// The spline run backwards along ``axis``, over the same window.
    ///
    /// Raises ShapeError when there is no such axis.
    ///
    /// >>> pf.Spline([(0,), (1,), (3,)], 1, [0, 0, 1, 4, 4]).reverse(0).knots
    /// (array([0., 0., 3., 4., 4.]),)
    #[pyo3(signature = (axis))]
    fn reverse(&self, axis: &Bound<'_, PyAny>) -> PyResult<Self> {
        let k = self.axis(axis)?;
        self.worked(axis.py(), |spline| spline.reverse(k))
    }

    /// The axes in another order, as :meth:`Form.transpose`.
    ///
    /// >>> facet = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
    /// >>> facet.subdivide((1, 2)).transpose().counts
    /// (4, 2)
    #[pyo3(signature = (axes=None))]
    fn transpose(&self, py: Python<'_>, axes: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let axes = match axes {
            Some(axes) => wholes("axes", axes, 1)?,
            None => (0..self.spline.axes()).rev().collect(),
        };
        self.worked(py, |spline| spline.transpose(&axes))
    }

    /// The sub-spline where parameter ``axis`` is ``t``: one axis less; of a curve a point.
    ///
    /// Raises ShapeError when there is no such axis, DomainError for NaN.
    ///
    /// >>> facet = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]]).subdivide(1)
    /// >>> facet.sub(0, 0.25)
    /// <pforms.Spline of 2 pieces pL2 in 3D>
    /// >>> facet.sub(0, 0.25).sub(0, 0.5).poles
    /// array([0.25, 0.5 , 0.5 ])
    #[pyo3(signature = (axis, t))]
    fn sub<'py>(
        &self,
        axis: &Bound<'py, PyAny>,
        t: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (k, t) = (self.axis(axis)?, real("t", t)?);
        let spline = done(axis.py(), self.cost(), || self.spline.sub(k, &t))?;
        object(axis.py(), spline.into())
    }

    /// The derivative as a spline of vectors: ``orders[k]`` times along axis ``k``, exact.
    ///
    /// Raises as :meth:`Form.derivative`.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).derivative(1)(0.25)
    /// array([2., 2.])
    #[pyo3(signature = (orders))]
    fn derivative(&self, orders: &Bound<'_, PyAny>) -> PyResult<Self> {
        let steps = wholes("orders", orders, 1)?;
        self.require_differentiable(&steps)?;
        self.worked(orders.py(), |spline| spline.derivative(&steps))
    }

    /// The first derivative along ``axis``. Raises ShapeError without such an axis.
    ///
    /// Where it may jump the pieces keep their own poles.
    ///
    /// >>> pf.Spline([(0,), (1,), (3,)], 1, [0, 0, 1, 2, 2]).hodograph().poles[:, 0]
    /// array([1., 2.])
    #[pyo3(signature = (axis=None), text_signature = "($self, axis=0)")]
    fn hodograph(&self, py: Python<'_>, axis: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let k = axis.map_or(Ok(0), |axis| self.axis(axis))?;
        self.worked(py, |spline| spline.hodograph(k))
    }

    /// Identifies two axes of one window, as :meth:`Form.diagonal`.
    ///
    /// >>> facet = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
    /// >>> facet.subdivide(1).diagonal()
    /// <pforms.Spline of 2 pieces pL3 in 3D>
    #[pyo3(signature = (axes=None))]
    fn diagonal(&self, py: Python<'_>, axes: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let last = self.spline.axes().saturating_sub(1);
        let Some(axes) = axes else {
            return self.worked(py, |spline| spline.diagonal(last.saturating_sub(1), last));
        };
        if axes.cast::<PyString>().is_ok_and(|text| text.to_string_lossy() == "all") {
            return self.worked(py, |spline| {
                let mut merged = spline.clone();
                while merged.axes() > 1 {
                    merged = merged.diagonal(0, 1)?;
                }
                Ok(merged)
            });
        }
        match *wholes("axes", axes, 1)? {
            [first, second] => self.worked(py, |spline| spline.diagonal(first, second)),
            ref other => fail(&Error::shape("axes", format!("{other:?}"), "two axes, or \"all\"")),
        }
    }

    /// The tangent along ``axis`` as a spline of vectors, as :meth:`Form.tangent_form`.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).tangent_form()(0.25)
    /// array([2., 2.])
    #[pyo3(signature = (axis=None), text_signature = "($self, axis=0)")]
    fn tangent_form(&self, py: Python<'_>, axis: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let k = axis.map_or(Ok(0), |axis| self.axis(axis))?;
        self.worked(py, |spline| spline.tangent_form(k))
    }

    /// The normal as a spline of vectors, as :meth:`Form.normal_form`.
    ///
    /// >>> pf.Form([(0, 0), (2, 4), (4, 0)]).subdivide(1).normal_form()(0)
    /// array([-8.,  4.])
    fn normal_form(&self, py: Python<'_>) -> PyResult<Self> {
        self.worked(py, Spline::normal_form)
    }

    /// The binormal of a curve in 3D as a spline of vectors, as :meth:`Form.binormal_form`.
    ///
    /// >>> pf.Form([(0, 0, 0), (1, 0, 0), (2, 2, 0)]).subdivide(1).binormal_form()(0.5)
    /// array([0., 0., 8.])
    fn binormal_form(&self, py: Python<'_>) -> PyResult<Self> {
        self.worked(py, Spline::binormal_form)
    }

    /// The same spline with one pole at another place, as :meth:`Form.with_pole`.
    ///
    /// >>> pf.Form([(0, 0), (2, 0)]).subdivide(1).with_pole(1, (1, 5))(0.5)
    /// array([1., 5.])
    #[pyo3(signature = (index, point, *, weight=None))]
    fn with_pole(
        &self,
        py: Python<'_>,
        index: &Bound<'_, PyAny>,
        point: &Bound<'_, PyAny>,
        weight: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let net = with_pole(py, self.spline.net(), index, point, weight)?;
        self.worked(py, |spline| spline.with_net(net))
    }

    /// Unit normals of a surface in space, as :meth:`Form.normals`.
    ///
    /// >>> floor = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    /// >>> floor.subdivide(1).normals(0.75, 0.25)
    /// array([0., 0., 1.])
    #[pyo3(signature = (u, v, *, out=None))]
    fn normals<'py>(
        &self,
        u: &Bound<'py, PyAny>,
        v: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        normals(&self.spline, u, v, out)
    }

    /// The moving frame at parameters, as :meth:`Form.frame`; at a break that of the next piece.
    ///
    /// A rotation-minimising normal is carried from the beginning of the window through the pieces.
    ///
    /// >>> curve = pf.Form([(0, 0, 0), (1, 0, 0), (2, 2, 0)]).subdivide(2)
    /// >>> frame = curve.frame(0)
    /// >>> frame.normal, frame.speed.item()
    /// (array([0., 1., 0.]), 2.0)
    #[pyo3(
        signature = (*parameters, kind=None, unit=None, accuracy=None),
        text_signature = "($self, *parameters, kind='frenet', unit=True, accuracy=1e-10)"
    )]
    fn frame<'py>(
        &self,
        parameters: &Bound<'py, PyTuple>,
        kind: Option<&Bound<'py, PyAny>>,
        unit: Option<&Bound<'py, PyAny>>,
        accuracy: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        frame(&self.spline, parameters, kind, unit, accuracy)
    }

    /// The curvature at parameters, as :meth:`Form.curvature`.
    ///
    /// >>> pf.Form([(0, 0), (1, 0), (2, 2)]).subdivide(3).curvature(0).item()
    /// 1.0
    #[pyo3(signature = (*parameters))]
    fn curvature<'py>(&self, parameters: &Bound<'py, PyTuple>) -> PyResult<Bound<'py, PyAny>> {
        curvature(&self.spline, parameters)
    }

    /// Writes the spline into a ``.json`` file, exactly. Raises as :meth:`Form.save`.
    ///
    /// >>> curve = pf.Spline([(0, 0), (0, 2), (2, 2), (2, 0)], 2, range(7))
    /// >>> curve.save("spline.json")
    /// >>> pf.load("spline.json") == curve
    /// True
    fn save(&self, path: &Bound<'_, PyAny>) -> PyResult<()> {
        save(self.spline.clone().into(), path)
    }
}

impl PySpline {
    fn axis(&self, object: &Bound<'_, PyAny>) -> PyResult<usize> {
        axis(self.spline.net(), object)
    }

    /// Differentiating a quotient adds a degree of the weight each time: this refuses in time.
    fn require_differentiable(&self, orders: &[usize]) -> PyResult<()> {
        let origin = vec![0; self.spline.axes()];
        let piece = self.spline.piece(&origin).map_err(|error| raised(&error))?;
        check_derivative(&piece, orders)
    }

    pub(crate) fn worked(
        &self,
        py: Python<'_>,
        operator: impl FnOnce(&Spline) -> Result<Spline> + Send,
    ) -> PyResult<Self> {
        done(py, self.cost(), || operator(&self.spline)).map(Self::from)
    }
}
