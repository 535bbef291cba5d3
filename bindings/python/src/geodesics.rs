//! Straight lines on surfaces.

use numpy::PyArray1;
use pforms_kernel::Error;
use pforms_operators::{self as operators, Ending, Geodesic, GeodesicOptions, Heading, Spline};
use pyo3::intern;
use pyo3::prelude::*;

use crate::arguments::{real, reals, truth};
use crate::arrays::Numbers;
use crate::errors::{done, fail};
use crate::form::PyForm;
use crate::shapes;
use crate::spline::PySpline;

type Any<'a, 'py> = &'a Bound<'py, PyAny>;

/// The straight line of a surface that starts at parameters in a direction.
///
/// It goes on over knots, closed seams and collapsed edges where the surface is smooth, such as the poles of
/// a sphere, until it has the length asked for or leaves the window.
///
/// Parameters
/// ----------
/// surface : Form or Spline
///     In 2D or more.
/// start : two floats
///     Parameters.
/// direction : float, two floats, or a vector
///     ``(u', v')``, a vector in space, of which the part in the tangent plane counts, or an angle ``A`` in
///     radians: ``u' = cos A, v' = sin A * |f_u|/|f_v|``.
/// length : float
///     How long it becomes, at most.
/// accuracy : float, optional
///     Of its points, in sizes of the surface.
/// seams : bool, optional
///     Go on over sides of the window that are one and the same line.
///
/// Returns
/// -------
/// Geodesic
///     ``spline`` in space and ``parameters`` on the surface, both over their length; ``length``, ``error``,
///     ``ending``, ``end``, ``point``, ``direction``, ``conjugate``, ``crease``, ``steps``.
///
/// Raises
/// ------
/// ShapeError, DomainError
///     For other forms and directions; for a start outside the window, and for a length or an accuracy not
///     above 0.
/// DegenerateError
///     Where the surface has no tangent plane, for a direction along its normal, or out of the window.
/// AccuracyError
///     When rounding does not allow the accuracy asked for.
///
/// Examples
/// --------
/// >>> saddle = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
/// >>> line = pf.geodesic(saddle, (0, 0), (1, 1), 10)  # over the saddle, from corner to corner
/// >>> line.ending, np.allclose(line.end, (1, 1)), line.error < 1e-9
/// ('border', True, True)
#[pyfunction]
#[pyo3(
    signature = (surface, start, direction, length, *, accuracy=None, seams=None),
    text_signature = "(surface, start, direction, length, *, accuracy=1e-10, seams=True)"
)]
pub(crate) fn geodesic<'py>(
    surface: Any<'_, 'py>,
    start: Any<'_, 'py>,
    direction: Any<'_, 'py>,
    length: Any<'_, 'py>,
    accuracy: Option<Any<'_, 'py>>,
    seams: Option<Any<'_, 'py>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = surface.py();
    let surface = shapes::read("surface", surface)?.into_spline();
    let start = pair("start", start)?;
    let heading = heading(direction, &surface)?;
    let length = real("length", length)?;
    let options = options(accuracy, seams)?;
    let found =
        done(py, usize::MAX, || operators::geodesic(surface, start, &heading, length, &options))?;
    record(py, found)
}

fn pair(argument: &str, object: Any) -> PyResult<[f64; 2]> {
    let numbers = reals(argument, object, 2)?;
    Ok([numbers[0], numbers[1]])
}

fn options(accuracy: Option<Any>, seams: Option<Any>) -> PyResult<GeodesicOptions> {
    let default = GeodesicOptions::default();
    Ok(GeodesicOptions {
        accuracy: accuracy.map_or(Ok(default.accuracy), |given| real("accuracy", given))?,
        seams: seams.map_or(Ok(default.seams), |given| truth("seams", given))?,
    })
}

/// An angle, a direction in the parameters, or one in space.
fn heading(object: Any, surface: &Spline) -> PyResult<Heading> {
    let numbers = Numbers::read("direction", object)?;
    let ambient = surface.ambient();
    match (numbers.shape(), numbers.values()) {
        ([], [angle]) => Ok(Heading::Angle(*angle)),
        ([2], [u, v]) if ambient != 2 => Ok(Heading::Parameters([*u, *v])),
        ([count], vector) if *count == ambient => Ok(Heading::Vector(vector.to_vec())),
        (shape, _) => {
            let received = format!("an array of shape {shape:?}");
            let expected = format!("an angle, (u', v') or {ambient} numbers");
            fail(&Error::shape("direction", received, expected))
        }
    }
}

/// The English name of an ending.
pub(crate) fn ending(ending: Ending) -> &'static str {
    match ending {
        Ending::Length => "length",
        Ending::Border => "border",
        Ending::Collapsed => "collapsed",
        Ending::Singular => "singular",
        Ending::Torn => "torn",
    }
}

/// A `pforms.records.Geodesic`.
fn record(py: Python<'_>, found: Geodesic) -> PyResult<Bound<'_, PyAny>> {
    let fields = (
        PySpline::from(found.spline),
        PySpline::from(found.parameters),
        found.length,
        found.error,
        ending(found.ending),
        PyArray1::from_vec(py, found.end.to_vec()),
        PyArray1::from_vec(py, found.point),
        PyArray1::from_vec(py, found.direction),
        found.conjugate,
        found.crease,
        found.steps,
    );
    py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Geodesic"))?.call1(fields)
}

/// The operators as methods of a class.
macro_rules! methods {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The straight line of this surface from a start in a direction: see :func:`pforms.geodesic`.
            ///
            /// >>> slope = pf.Form([[(0, 0, 0), (0, 3, 4)], [(1, 0, 0), (1, 3, 4)]])
            /// >>> np.allclose(slope.geodesic((0.5, 0), (0, 1), 2.5).point, (0.5, 1.5, 2))
            /// True
            #[pyo3(
                signature = (start, direction, length, *, accuracy=None, seams=None),
                text_signature = "($self, start, direction, length, *, accuracy=1e-10, seams=True)"
            )]
            fn geodesic<'py>(
                slf: &Bound<'py, Self>,
                start: &Bound<'py, PyAny>,
                direction: &Bound<'py, PyAny>,
                length: &Bound<'py, PyAny>,
                accuracy: Option<&Bound<'py, PyAny>>,
                seams: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                geodesic(slf.as_any(), start, direction, length, accuracy, seams)
            }
        }
    };
}

methods!(PyForm);
methods!(PySpline);
