//! Parallels, shells, developable surfaces and unrolling.

use pforms_kernel::Error;
use pforms_operators::{
    self as operators, Distance, Parallel, ParallelOptions, Shape, Side, Spline,
};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyString, PyTuple};

use crate::arguments::{real, truth, word};
use crate::arrays::Numbers;
use crate::errors::{done, fail};
use crate::form::PyForm;
use crate::shapes;
use crate::spline::PySpline;

type Any<'a, 'py> = &'a Bound<'py, PyAny>;

/// What is given for a tolerance that is left out.
const TOLERANCE: f64 = 1e-6;

/// What is given for an accuracy that is left out.
const ACCURACY: f64 = 1e-12;

/// The curve or surface at a distance from another, within a tolerance.
///
/// Every point of the result lies on the true normal at its parameters; only the length of the normal
/// is approximated, and where that is a polynomial (planes, spheres, cylinders, cones, tori) not even
/// that. The distance is positive along ``tu × tv`` of a surface and to the left of a plane curve.
///
/// Parameters
/// ----------
/// form : Form or Spline
///     A surface in 3D, a curve in 2D, or a curve in 3D with a side.
/// distance : float or Form
///     A form in 1D over the same axes varies with the parameters.
/// tolerance : float, optional
///     How far any point may be from its true place, in the unit of the form.
/// side : array_like of 3 numbers or "principal", optional
///     Of a curve in 3D: the vector it is seen from, or the inside of its bend.
/// folds : bool, optional
///     Accept a result that turns back on itself, beyond the radius of curvature.
/// report : bool, optional
///     Return a :class:`Parallel` of ``spline``, ``error`` and ``gap``.
///
/// Returns
/// -------
/// Spline, or Parallel if report
///
/// Raises
/// ------
/// DegenerateError
///     Where the distance reaches the radius of curvature, and where there is no normal: it says where.
/// AccuracyError
///     For a tolerance below rounding, or one that takes too many pieces.
/// ShapeError, DomainError
///     For other forms; for a tolerance not above 0, and a weight that vanishes.
///
/// Examples
/// --------
/// >>> arch = pf.Form([(-1, 1), (0, -1), (1, 1)])
/// >>> found = pf.parallel(arch, 0.25, tolerance=1e-8, report=True)
/// >>> bool(abs(found.spline(0.5)[1] - 0.25) <= found.error < 1e-8)
/// True
#[pyfunction]
#[pyo3(
    signature = (form, distance, *, tolerance=None, side=None, folds=None, report=None),
    text_signature = "(form, distance, *, tolerance=1e-06, side=None, folds=False, report=False)"
)]
pub(crate) fn parallel<'py>(
    form: &Bound<'py, PyAny>,
    distance: &Bound<'py, PyAny>,
    tolerance: Option<&Bound<'py, PyAny>>,
    side: Option<&Bound<'py, PyAny>>,
    folds: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let asked = Asked::read(form, distance, tolerance, side, folds, report)?;
    asked.answer(form.py(), operators::parallel)
}

/// What lies between a form and its parallel: a volume for a surface, a strip for a curve.
///
/// Axis 0 goes from the form to the parallel along each normal. Arguments, answers and errors as
/// :func:`parallel`.
///
/// >>> facet = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
/// >>> plate = pf.shell(facet, 0.5)
/// >>> plate.net.orders, plate(1, 0, 0)[2]
/// ((2, 2, 2), np.float64(0.5))
#[pyfunction]
#[pyo3(
    signature = (form, distance, *, tolerance=None, side=None, folds=None, report=None),
    text_signature = "(form, distance, *, tolerance=1e-06, side=None, folds=False, report=False)"
)]
pub(crate) fn shell<'py>(
    form: &Bound<'py, PyAny>,
    distance: &Bound<'py, PyAny>,
    tolerance: Option<&Bound<'py, PyAny>>,
    side: Option<&Bound<'py, PyAny>>,
    folds: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let asked = Asked::read(form, distance, tolerance, side, folds, report)?;
    asked.answer(form.py(), operators::shell)
}

/// The poles moved by a distance along the normals: near the parallel, with the same orders.
///
/// Pole i of n takes the normal at the parameter i/(n − 1), in a spline at the mean of its knots.
/// Weights and knots stay; poles at infinity do not move.
///
/// Parameters
/// ----------
/// form : Form or Spline
///     As for :func:`parallel`, ``distance`` and ``side`` too.
///
/// Returns
/// -------
/// Form or Spline, as the form given
///
/// Raises
/// ------
/// DegenerateError, ShapeError, DomainError
///     Where there is no normal; for other forms; for a distance that is not finite.
///
/// Examples
/// --------
/// >>> pf.offset_poles(pf.Form([(0, 0), (3, 4), (6, 0)]), 5).poles
/// array([[-4.,  3.],
///        [ 3.,  9.],
///        [10.,  3.]])
#[pyfunction]
#[pyo3(signature = (form, distance, *, side=None))]
pub(crate) fn offset_poles<'py>(
    form: &Bound<'py, PyAny>,
    distance: &Bound<'py, PyAny>,
    side: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = form.py();
    let shape = shapes::read("form", form)?;
    let whole = matches!(shape, Shape::Form(_));
    let (distance, side) = (read_distance(distance)?, read_side(side)?);
    let spline = shape.into_spline();
    let moved = done(py, usize::MAX, || operators::offset_poles(spline, distance, &side))?;
    shapes::object(py, if whole { moved.net().clone().into() } else { moved.into() })
}

/// The surface of the tangents of a curve: the point plus ``u·length`` times the derivative.
///
/// Axis 0 runs along the tangents, axis 1 along the curve. Exact: a pS2n of a polynomial pLn, a
/// pS2(2n−1) of a rational one.
///
/// Parameters
/// ----------
/// curve : Form or Spline
///     In dimension 2 or more.
/// length : float, optional
///     How far to go along the derivative; negative: backwards.
///
/// Returns
/// -------
/// Form or Spline, as the curve given
///
/// Raises
/// ------
/// DegenerateError
///     For a straight curve, and for the length 0.
/// ShapeError, DomainError
///     For other forms; for a length that is not finite.
///
/// Examples
/// --------
/// >>> surface = pf.tangent_developable(pf.Form([(0, 0, 0), (1, 0, 0), (2, 1, 0), (3, 3, 1)]))
/// >>> surface.kind, surface.is_developable()
/// ('pS24', True)
#[pyfunction]
#[pyo3(signature = (curve, length=None), text_signature = "(curve, length=1.0)")]
pub(crate) fn tangent_developable<'py>(
    curve: &Bound<'py, PyAny>,
    length: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = curve.py();
    let length = length.map_or(Ok(1.0), |given| real("length", given))?;
    let shape = shapes::read("curve", curve)?;
    let surface = done(py, usize::MAX, || match shape {
        Shape::Form(curve) => operators::tangent_developable(&curve, &length).map(Shape::from),
        Shape::Spline(curve) => {
            operators::tangent_developable_of_spline(&curve, &length).map(Shape::from)
        }
    })?;
    shapes::object(py, surface)
}

/// Can a surface be laid out flat without stretching?
///
/// All coefficients of the numerator of its Gauss curvature are computed, with what rounding may have
/// done to each; where they are no more than that, again in exact arithmetic.
///
/// Parameters
/// ----------
/// form : Form or Spline
///     A surface in 3D.
/// report : bool, optional
///     Return a :class:`Developability` of ``developable``, ``exact``, ``gauss`` and ``parameters``.
///
/// Returns
/// -------
/// bool, or Developability if report
///
/// Raises
/// ------
/// DegenerateError, ShapeError
///     For a surface collapsed to a curve; for what is no surface in 3D.
///
/// Examples
/// --------
/// >>> pf.is_developable([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
/// False
#[pyfunction]
#[pyo3(signature = (form, *, report=None), text_signature = "(form, *, report=False)")]
pub(crate) fn is_developable<'py>(
    form: &Bound<'py, PyAny>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = form.py();
    let spline = shapes::read("form", form)?.into_spline();
    let report = flag("report", report)?;
    let found = done(py, usize::MAX, || operators::is_developable(spline))?;
    if !report {
        return Ok(found.developable.into_pyobject(py)?.to_owned().into_any());
    }
    let place = PyTuple::new(py, found.parameters)?;
    record(py, "Developability", (found.developable, found.exact, found.gauss, place))
}

/// A surface laid out flat, with what that does to it measured.
///
/// Developable surfaces keep lengths, angles and areas; others are stretched, and the report says by
/// how much at most. The result has the parameters of the surface.
///
/// Parameters
/// ----------
/// form : Form or Spline
///     A surface in 2D or 3D.
/// accuracy : float, optional
///     Of the polynomials of the result, in sizes of the surface.
/// report : bool, optional
///     Return an :class:`Unrolling` of ``spline``, ``length``, ``angle`` and ``area``.
///
/// Returns
/// -------
/// Spline, or Unrolling if report
///
/// Raises
/// ------
/// DegenerateError, ShapeError, DomainError
///     For a collapsed surface; for other forms; for an accuracy not above 0.
/// AccuracyError
///     When the accuracy takes too many pieces.
///
/// Examples
/// --------
/// >>> surface = pf.tangent_developable(pf.Form([(0, 0, 0), (1, 0, 0), (2, 1, 0), (3, 3, 1)]))
/// >>> flat = pf.unroll(surface, report=True)
/// >>> max(flat.length, flat.angle, flat.area) < 1e-9
/// True
#[pyfunction]
#[pyo3(
    signature = (form, *, accuracy=None, report=None),
    text_signature = "(form, *, accuracy=1e-12, report=False)"
)]
pub(crate) fn unroll<'py>(
    form: &Bound<'py, PyAny>,
    accuracy: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = form.py();
    let spline = shapes::read("form", form)?.into_spline();
    let accuracy = accuracy.map_or(Ok(ACCURACY), |given| real("accuracy", given))?;
    let report = flag("report", report)?;
    let found = done(py, usize::MAX, || operators::unroll(spline, accuracy))?;
    let flat = PySpline::from(found.spline);
    if !report {
        return Ok(flat.into_pyobject(py)?.into_any());
    }
    let operators::Distortion { length, angle, area } = found.distortion;
    record(py, "Unrolling", (flat, length, angle, area))
}

/// What a parallel is asked for.
struct Asked {
    spline: Spline,
    distance: Distance,
    options: ParallelOptions,
    report: bool,
}

impl Asked {
    fn read<'py>(
        form: Any<'_, 'py>,
        distance: Any<'_, 'py>,
        tolerance: Option<Any<'_, 'py>>,
        side: Option<Any<'_, 'py>>,
        folds: Option<Any<'_, 'py>>,
        report: Option<Any<'_, 'py>>,
    ) -> PyResult<Self> {
        let options = ParallelOptions {
            tolerance: tolerance.map_or(Ok(TOLERANCE), |given| real("tolerance", given))?,
            side: read_side(side)?,
            folds: flag("folds", folds)?,
        };
        Ok(Self {
            spline: shapes::read("form", form)?.into_spline(),
            distance: read_distance(distance)?,
            options,
            report: flag("report", report)?,
        })
    }

    fn answer(
        self,
        py: Python<'_>,
        operator: fn(Spline, Distance, &ParallelOptions) -> pforms_kernel::Result<Parallel>,
    ) -> PyResult<Bound<'_, PyAny>> {
        let Self { spline, distance, options, report } = self;
        let found = done(py, usize::MAX, || operator(spline, distance, &options))?;
        let spline = PySpline::from(found.spline);
        if report {
            return record(py, "Parallel", (spline, found.error, found.gap));
        }
        Ok(spline.into_pyobject(py)?.into_any())
    }
}

fn read_distance(distance: &Bound<'_, PyAny>) -> PyResult<Distance> {
    if let Ok(form) = distance.cast::<PyForm>() {
        return Ok(form.get().form.clone().into());
    }
    real("distance", distance).map(Distance::from)
}

fn read_side(side: Option<&Bound<'_, PyAny>>) -> PyResult<Side> {
    let Some(side) = side else {
        return Ok(Side::Natural);
    };
    if side.is_instance_of::<PyString>() {
        return word("side", side, &["principal"]).map(|_| Side::Principal);
    }
    let numbers = Numbers::read("side", side)?;
    match *numbers.values() {
        [x, y, z] => Ok(Side::Across([x, y, z])),
        ref other => fail(&Error::shape("side", format!("{} numbers", other.len()), "3 numbers")),
    }
}

fn flag(name: &str, given: Option<&Bound<'_, PyAny>>) -> PyResult<bool> {
    given.map_or(Ok(false), |given| truth(name, given))
}

fn record<'py, A>(py: Python<'py>, name: &str, fields: A) -> PyResult<Bound<'py, PyAny>>
where
    A: pyo3::call::PyCallArgs<'py>,
{
    py.import(intern!(py, "pforms.records"))?.getattr(name)?.call1(fields)
}

/// The operators as methods of a class.
macro_rules! methods {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The curve or surface at a distance from this one: see :func:`pforms.parallel`.
            ///
            /// >>> pf.Form([(0, 0), (4, 3)]).parallel(5)(0)
            /// array([-3.,  4.])
            #[pyo3(
                signature = (distance, *, tolerance=None, side=None, folds=None, report=None),
                text_signature = "($self, distance, *, tolerance=1e-06, side=None, folds=False, report=False)"
            )]
            fn parallel<'py>(
                slf: &Bound<'py, Self>,
                distance: &Bound<'py, PyAny>,
                tolerance: Option<&Bound<'py, PyAny>>,
                side: Option<&Bound<'py, PyAny>>,
                folds: Option<&Bound<'py, PyAny>>,
                report: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                parallel(slf.as_any(), distance, tolerance, side, folds, report)
            }

            /// What lies between this and its parallel: see :func:`pforms.shell`.
            ///
            /// >>> pf.Form([(0, 0), (4, 3)]).shell(5)(0.5, 0)
            /// array([-1.5,  2. ])
            #[pyo3(
                signature = (distance, *, tolerance=None, side=None, folds=None, report=None),
                text_signature = "($self, distance, *, tolerance=1e-06, side=None, folds=False, report=False)"
            )]
            fn shell<'py>(
                slf: &Bound<'py, Self>,
                distance: &Bound<'py, PyAny>,
                tolerance: Option<&Bound<'py, PyAny>>,
                side: Option<&Bound<'py, PyAny>>,
                folds: Option<&Bound<'py, PyAny>>,
                report: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                shell(slf.as_any(), distance, tolerance, side, folds, report)
            }

            /// The poles moved along the normals: see :func:`pforms.offset_poles`.
            ///
            /// >>> pf.Form([(0, 0), (4, 3)]).offset_poles(5).poles
            /// array([[-3.,  4.],
            ///        [ 1.,  7.]])
            #[pyo3(signature = (distance, *, side=None))]
            fn offset_poles<'py>(
                slf: &Bound<'py, Self>,
                distance: &Bound<'py, PyAny>,
                side: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                offset_poles(slf.as_any(), distance, side)
            }

            /// The surface of the tangents of this curve: see :func:`pforms.tangent_developable`.
            ///
            /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).tangent_developable(0.5)(1, 0)
            /// array([1., 2.])
            #[pyo3(signature = (length=None), text_signature = "($self, length=1.0)")]
            fn tangent_developable<'py>(
                slf: &Bound<'py, Self>,
                length: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                tangent_developable(slf.as_any(), length)
            }

            /// Can this surface be laid out flat? See :func:`pforms.is_developable`.
            ///
            /// >>> facet = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
            /// >>> facet.is_developable()
            /// False
            #[pyo3(signature = (*, report=None), text_signature = "($self, *, report=False)")]
            fn is_developable<'py>(
                slf: &Bound<'py, Self>,
                report: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                is_developable(slf.as_any(), report)
            }

            /// This surface laid out flat: see :func:`pforms.unroll`.
            ///
            /// >>> slope = pf.Form([[(0, 0, 0), (0, 3, 4)], [(1, 0, 0), (1, 3, 4)]])
            /// >>> np.allclose(slope.unroll()(1, 1), (1, 5))
            /// True
            #[pyo3(
                signature = (*, accuracy=None, report=None),
                text_signature = "($self, *, accuracy=1e-12, report=False)"
            )]
            fn unroll<'py>(
                slf: &Bound<'py, Self>,
                accuracy: Option<&Bound<'py, PyAny>>,
                report: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                unroll(slf.as_any(), accuracy, report)
            }
        }
    };
}

methods!(PyForm);
methods!(PySpline);
