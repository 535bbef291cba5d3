//! Straight lines on surfaces.

use numpy::PyArray1;
use pforms_kernel::Error;
use pforms_operators::{
    self as operators, Arrivals, Connection, Ending, Geodesic, GeodesicOptions, Heading,
    Minimality, Spline,
};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::PyList;

use crate::arguments::{real, reals, truth};
use crate::arrays::Numbers;
use crate::errors::{done, fail};
use crate::form::PyForm;
use crate::outputs::array;
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
/// start : array_like, shape (2) or (…, 2)
///     Parameters; of many starts only the ends are found, all in one go.
/// direction : float, two floats, or a vector; for many starts one, or one for each
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
/// Geodesic, or Geodesics for many starts
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
    let starts = Numbers::read("start", start)?;
    if starts.shape().len() > 1 {
        return many(py, &surface, &starts, direction, length, options(accuracy, seams)?);
    }
    let start = pair("start", start)?;
    let heading = heading(direction, &surface)?;
    let length = real("length", length)?;
    let options = options(accuracy, seams)?;
    let found =
        done(py, usize::MAX, || operators::geodesic(surface, start, &heading, length, &options))?;
    record(py, found)
}

/// The ends of many.
fn many<'py>(
    py: Python<'py>,
    surface: &Spline,
    starts: &Numbers<'py>,
    direction: Any<'_, 'py>,
    length: Any<'_, 'py>,
    options: GeodesicOptions,
) -> PyResult<Bound<'py, PyAny>> {
    let Some((2, lead)) = starts.shape().split_last().map(|(last, lead)| (*last, lead)) else {
        let received = format!("an array of shape {:?}", starts.shape());
        return fail(&Error::shape("start", received, "shape (…, 2)"));
    };
    let places: Vec<[f64; 2]> = starts.values().chunks_exact(2).map(|p| [p[0], p[1]]).collect();
    let headings = headings(direction, lead, surface.ambient())?;
    let lengths = Numbers::read("length", length)?;
    if !(lengths.shape().is_empty() || lengths.shape() == lead) {
        let received = format!("an array of shape {:?}", lengths.shape());
        return fail(&Error::shape("length", received, format!("a number, or shape {lead:?}")));
    }
    let lengths = lengths.values().to_vec();
    if lead.contains(&0) {
        return arrivals(py, lead, surface.ambient(), Arrivals::default());
    }
    let found = done(py, usize::MAX, || {
        operators::geodesics(surface.clone(), &places, &headings, &lengths, &options)
    })?;
    arrivals(py, lead, surface.ambient(), found)
}

/// One heading for all, or one for each start.
fn headings(object: Any, lead: &[usize], ambient: usize) -> PyResult<Vec<Heading>> {
    let numbers = Numbers::read("direction", object)?;
    let (shape, values) = (numbers.shape(), numbers.values());
    if shape.is_empty() || shape == lead && ![2, ambient].contains(&lead[lead.len() - 1]) {
        return Ok(values.iter().map(|angle| Heading::Angle(*angle)).collect());
    }
    let each = shape.split_last().filter(|(_, first)| first.is_empty() || *first == lead);
    match each.map(|(last, _)| *last) {
        Some(2) if ambient != 2 => {
            Ok(values.chunks_exact(2).map(|p| Heading::Parameters([p[0], p[1]])).collect())
        }
        Some(width) if width == ambient => {
            Ok(values.chunks_exact(width).map(|v| Heading::Vector(v.to_vec())).collect())
        }
        _ => {
            let received = format!("an array of shape {shape:?}");
            let expected =
                format!("an angle, (u', v') or {ambient} numbers, one or for each start");
            fail(&Error::shape("direction", received, expected))
        }
    }
}

/// A `pforms.records.Geodesics` of arrays whose first axes are those of the starts.
fn arrivals<'py>(
    py: Python<'py>,
    lead: &[usize],
    ambient: usize,
    found: Arrivals,
) -> PyResult<Bound<'py, PyAny>> {
    let wide = |width: usize| -> Vec<usize> { lead.iter().copied().chain([width]).collect() };
    let endings: Vec<&str> = found.endings.into_iter().map(ending).collect();
    let fields = (
        array(py, &wide(2), found.parameters)?,
        array(py, &wide(ambient), found.points)?,
        array(py, &wide(ambient), found.directions)?,
        array(py, lead, found.lengths)?,
        array(py, lead, found.errors)?,
        endings,
        found.steps,
    );
    py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Geodesics"))?.call1(fields)
}

/// The straight line of a surface from one of its points to another.
///
/// Directions all around the first point are tried; of the lines that are found the shortest is given. That
/// there is none shorter is proved only where ``minimality`` says so.
///
/// Parameters
/// ----------
/// surface : Form or Spline
///     In 2D or more.
/// p, q : two floats
///     Parameters.
/// longest : float, optional
///     Lines up to this length are sought; otherwise up to one and a half times that of the segment
///     between the parameters.
/// all : bool, optional
///     Return a list of all lines found, the shortest first.
/// accuracy : float, optional
///     Of the points, in sizes of the surface.
/// seams : bool, optional
///     Go over sides of the window that are one and the same line.
///
/// Returns
/// -------
/// Connection, or a list of them if all
///     ``geodesic``, ``length``, ``gap`` and ``minimality``: "proved" (it is straight), "local" (shorter
///     than lines near it), "family" (the points are conjugate: there may be many), "not".
///
/// Raises
/// ------
/// ShapeError, DomainError
///     For other forms; for parameters outside the window, and a length or accuracy not above 0.
/// DegenerateError
///     When no line within the window is found.
///
/// Examples
/// --------
/// >>> slope = pf.Form([[(0, 0, 0), (0, 3, 4)], [(12, 0, 0), (12, 3, 4)]])
/// >>> way = pf.geodesic_between(slope, (0, 0), (1, 1))
/// >>> round(way.length, 9), way.minimality
/// (13.0, 'proved')
#[pyfunction]
#[pyo3(
    signature = (surface, p, q, *, longest=None, all=None, accuracy=None, seams=None),
    text_signature = "(surface, p, q, *, longest=None, all=False, accuracy=1e-10, seams=True)"
)]
pub(crate) fn geodesic_between<'py>(
    surface: Any<'_, 'py>,
    p: Any<'_, 'py>,
    q: Any<'_, 'py>,
    longest: Option<Any<'_, 'py>>,
    all: Option<Any<'_, 'py>>,
    accuracy: Option<Any<'_, 'py>>,
    seams: Option<Any<'_, 'py>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = surface.py();
    let surface = shapes::read("surface", surface)?.into_spline();
    let (p, q) = (pair("p", p)?, pair("q", q)?);
    let longest = longest.map(|given| real("longest", given)).transpose()?;
    let all = all.map_or(Ok(false), |given| truth("all", given))?;
    let options = options(accuracy, seams)?;
    if all {
        let lines =
            done(py, usize::MAX, || operators::geodesic_between(surface, p, q, longest, &options))?;
        let lines = lines.into_iter().map(|line| connection(py, line));
        return Ok(PyList::new(py, lines.collect::<PyResult<Vec<_>>>()?)?.into_any());
    }
    let line =
        done(py, usize::MAX, || operators::shortest_geodesic(surface, p, q, longest, &options))?;
    match line {
        Some(line) => connection(py, line),
        None => named(py, (py.None(), 0.0, 0.0, "proved")),
    }
}

fn connection(py: Python<'_>, line: Connection) -> PyResult<Bound<'_, PyAny>> {
    let minimality = match line.minimality {
        Minimality::Proved => "proved",
        Minimality::Local => "local",
        Minimality::Family => "family",
        Minimality::Not => "not",
    };
    let length = line.geodesic.length;
    named(py, (record(py, line.geodesic)?, length, line.gap, minimality))
}

/// A `pforms.records.Connection`.
fn named<'py, A: pyo3::call::PyCallArgs<'py>>(
    py: Python<'py>,
    fields: A,
) -> PyResult<Bound<'py, PyAny>> {
    py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Connection"))?.call1(fields)
}

fn pair(argument: &str, object: Any) -> PyResult<[f64; 2]> {
    match reals(argument, object, 2)?[..] {
        [u, v] => Ok([u, v]),
        ref numbers => {
            fail(&Error::shape(argument, format!("{} numbers", numbers.len()), "2 parameters"))
        }
    }
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
