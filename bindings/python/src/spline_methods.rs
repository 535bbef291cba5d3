//! Functions on curves and splines, as methods of both classes.

use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::form::PyForm;
use crate::spline::PySpline;
use crate::{joining, lengths, sizes};

macro_rules! methods {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The same with more knots: :func:`insert_knots`.
            ///
            /// >>> line = pf.Form([(0,), (4,)]).insert_knots(0.25)
            /// >>> line.insert_knots([0.5, 0.75]).net.poles.ravel()
            /// array([0., 1., 2., 3., 4.])
            #[pyo3(signature = (knots, *, axis=None), text_signature = "($self, knots, *, axis=0)")]
            fn insert_knots(
                slf: &Bound<'_, Self>,
                knots: &Bound<'_, PyAny>,
                axis: Option<&Bound<'_, PyAny>>,
            ) -> PyResult<PySpline> {
                joining::insert_knots(slf, knots, axis)
            }

            /// The same without knots that it can spare: :func:`remove_knots`.
            ///
            /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(2).remove_knots()
            /// <pforms.Spline of 1 piece pL3 in 2D>
            #[pyo3(
                signature = (knots=None, *, axis=None, accuracy=None, report=None),
                text_signature = "($self, knots=None, *, axis=0, accuracy=1e-12, report=False)"
            )]
            fn remove_knots<'py>(
                slf: &Bound<'py, Self>,
                knots: Option<&Bound<'py, PyAny>>,
                axis: Option<&Bound<'py, PyAny>>,
                accuracy: Option<&Bound<'py, PyAny>>,
                report: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                joining::remove_knots(slf, knots, axis, accuracy, report)
            }

            /// How smoothly it meets another, or itself at its joints: :func:`continuity`.
            ///
            /// >>> halves = pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1)
            /// >>> [joint.geometric for t, joint in halves.continuity()]
            /// [2]
            #[pyo3(
                signature = (g=None, *, at=None, order=None, accuracy=None, axis=None),
                text_signature = "($self, g=None, *, at=None, order=2, accuracy=1e-9, axis=0)"
            )]
            fn continuity<'py>(
                slf: &Bound<'py, Self>,
                g: Option<&Bound<'py, PyAny>>,
                at: Option<&Bound<'py, PyAny>>,
                order: Option<&Bound<'py, PyAny>>,
                accuracy: Option<&Bound<'py, PyAny>>,
                axis: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                joining::continuity(slf, g, at, order, accuracy, axis)
            }

            /// The length of a curve: :func:`arc_length`.
            ///
            /// >>> pf.Form([(0, 0), (3, 4)]).arc_length()
            /// 5.0
            #[pyo3(
                signature = (a=None, b=None, *, accuracy=None, report=None),
                text_signature = "($self, a=None, b=None, *, accuracy=1e-12, report=False)"
            )]
            fn arc_length<'py>(
                slf: &Bound<'py, Self>,
                a: Option<&Bound<'py, PyAny>>,
                b: Option<&Bound<'py, PyAny>>,
                accuracy: Option<&Bound<'py, PyAny>>,
                report: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                lengths::arc_length(slf, a, b, accuracy, report)
            }

            /// The parameters of given lengths: :func:`parameter_at_length`.
            ///
            /// >>> pf.Form([(0, 0), (3, 4)]).parameter_at_length([0, 2.5])
            /// array([0. , 0.5])
            #[pyo3(
                signature = (length, *, accuracy=None),
                text_signature = "($self, length, *, accuracy=1e-12)"
            )]
            fn parameter_at_length<'py>(
                slf: &Bound<'py, Self>,
                length: &Bound<'py, PyAny>,
                accuracy: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                lengths::parameter_at_length(slf, length, accuracy)
            }

            /// The same curve at unit speed: :func:`by_arc_length`.
            ///
            /// >>> pf.Form([(0, 0), (3, 4)]).by_arc_length()(2.5)
            /// array([1.5, 2. ])
            #[pyo3(
                signature = (*, accuracy=None, report=None),
                text_signature = "($self, *, accuracy=1e-9, report=False)"
            )]
            fn by_arc_length<'py>(
                slf: &Bound<'py, Self>,
                accuracy: Option<&Bound<'py, PyAny>>,
                report: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                lengths::by_arc_length(slf, accuracy, report)
            }

            /// The area of a surface: :func:`area`.
            ///
            /// >>> pf.Form([[(0, 0), (0, 1)], [(2, 0), (2, 1)]]).area()
            /// 2.0
            #[pyo3(
                signature = (*, signed=None, accuracy=None, report=None),
                text_signature = "($self, *, signed=False, accuracy=1e-12, report=False)"
            )]
            fn area<'py>(
                slf: &Bound<'py, Self>,
                signed: Option<&Bound<'py, PyAny>>,
                accuracy: Option<&Bound<'py, PyAny>>,
                report: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                let alone = PyTuple::new(slf.py(), [slf])?;
                sizes::area(slf.py(), &alone, signed, accuracy, report)
            }

            /// The volume of a form or of a closed surface: :func:`volume`.
            ///
            /// >>> pf.cube(2, (1, 2, 3)).volume()
            /// 6.0
            #[pyo3(
                signature = (*, signed=None, accuracy=None, report=None),
                text_signature = "($self, *, signed=False, accuracy=1e-12, report=False)"
            )]
            fn volume<'py>(
                slf: &Bound<'py, Self>,
                signed: Option<&Bound<'py, PyAny>>,
                accuracy: Option<&Bound<'py, PyAny>>,
                report: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                let alone = PyTuple::new(slf.py(), [slf])?;
                sizes::volume(slf.py(), &alone, signed, accuracy, report)
            }

            /// The centre of mass: :func:`centroid`.
            ///
            /// >>> pf.Form([(0, 0), (2, 0)]).centroid()
            /// array([1., 0.])
            #[pyo3(
                signature = (*, filled=None, accuracy=None),
                text_signature = "($self, *, filled=False, accuracy=1e-12)"
            )]
            fn centroid<'py>(
                slf: &Bound<'py, Self>,
                filled: Option<&Bound<'py, PyAny>>,
                accuracy: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                sizes::centroid(slf.py(), &PyTuple::new(slf.py(), [slf])?, filled, accuracy)
            }

            /// Measure, centre, inertia and principal axes: :func:`inertia`.
            ///
            /// >>> pf.Form([(0, 0), (2, 0)]).inertia().moments.round(12)
            /// array([0.        , 0.66666667])
            #[pyo3(
                signature = (*, filled=None, accuracy=None),
                text_signature = "($self, *, filled=False, accuracy=1e-12)"
            )]
            fn inertia<'py>(
                slf: &Bound<'py, Self>,
                filled: Option<&Bound<'py, PyAny>>,
                accuracy: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                sizes::inertia(slf.py(), &PyTuple::new(slf.py(), [slf])?, filled, accuracy)
            }

            /// The least box around its points: :func:`box`.
            ///
            /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).box().upper.round(12)
            /// array([2., 1.])
            #[pyo3(
                name = "box",
                signature = (*, accuracy=None),
                text_signature = "($self, *, accuracy=1e-12)"
            )]
            fn bounding_box<'py>(
                slf: &Bound<'py, Self>,
                accuracy: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                sizes::bounding_box(slf.py(), &PyTuple::new(slf.py(), [slf])?, accuracy)
            }

            /// Its Jacobian determinant as a form: :func:`jacobian`.
            ///
            /// >>> pf.Form([(0,), (2,), (4,)]).jacobian().poles.ravel()
            /// array([4., 4.])
            fn jacobian<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
                sizes::jacobian(slf)
            }

            /// Is it proved that it does not fold over? :func:`is_injective`.
            ///
            /// >>> pf.Form([(0,), (2,), (1,)]).is_injective()
            /// False
            #[pyo3(
                signature = (*, accuracy=None, report=None),
                text_signature = "($self, *, accuracy=1e-9, report=False)"
            )]
            fn is_injective<'py>(
                slf: &Bound<'py, Self>,
                accuracy: Option<&Bound<'py, PyAny>>,
                report: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                sizes::is_injective(slf, accuracy, report)
            }

            /// One axis less, at one or several parameters: :func:`slice`.
            ///
            /// >>> pf.Form([[(0, 0), (0, 1)], [(2, 0), (2, 1)]]).slice(0, 0.5).poles.tolist()
            /// [[1.0, 0.0], [1.0, 1.0]]
            fn slice<'py>(
                slf: &Bound<'py, Self>,
                axis: &Bound<'py, PyAny>,
                t: &Bound<'py, PyAny>,
            ) -> PyResult<Bound<'py, PyAny>> {
                sizes::slice(slf, axis, t)
            }
        }
    };
}

methods!(PyForm);
methods!(PySpline);
