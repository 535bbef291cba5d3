//! Boards laid along straight lines of surfaces.

use pforms_kernel::Error;
use pforms_operators::{self as operators, Mark, Plank, PlankOptions, Shape, Spline};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyString};

use crate::arguments::{real, truth};
use crate::arrays::Numbers;
use crate::errors::{done, fail, mistyped, raised};
use crate::form::{PyForm, from_euclidean};
use crate::outputs::array;
use crate::shapes;
use crate::spline::PySpline;

type Any<'a, 'py> = &'a Bound<'py, PyAny>;

/// Thin straight boards laid on a surface along its geodesics.
///
/// Each touches the surface along its line, is developable to within its error, and laid flat has two parallel
/// straight edges and ends cut along rulings. It may hang over the border of the surface.
///
/// Parameters
/// ----------
/// surface : Form or Spline
///     In space.
/// lines : Geodesic, Connection, Form or Spline, array_like of shape (n, 2), or a list of these
///     Straight lines of the surface: what :func:`geodesic` gives, or curves in the parameters.
/// width : float
///     Of the boards.
/// accuracy : float, optional
///     Of the strips, in sizes of the surface; lines count as straight that are so to within it.
/// marks : bool, optional
///     Look for crossings.
///
/// Returns
/// -------
/// Plank, or a list of them for a list of lines
///     ``strip`` in space, ``outline`` and ``axis`` laid flat, ``marks`` where others cross, ``bend``, ``twist``,
///     ``lift``, ``widest``, ``error`` and more.
///
/// Raises
/// ------
/// ShapeError, DomainError
///     For other forms; without lines, for lines that are not straight or leave the window, for a width not
///     above 0.
/// DegenerateError
///     For a width at which rulings cross (it says which would do), on kinks, and in asymptotic directions.
/// AccuracyError
///     When the accuracy takes too many pieces.
///
/// Examples
/// --------
/// >>> sphere = pf.sphere(2)
/// >>> board = pf.planks(sphere, pf.geodesic(sphere, (0.25, 0.1), (1, 0), np.pi), 0.5)
/// >>> np.allclose(board.outline.net.poles[:4], [(0, -0.25), (np.pi, -0.25), (np.pi, 0.25), (0, 0.25)])
/// True
#[pyfunction]
#[pyo3(
    signature = (surface, lines, width, *, accuracy=None, marks=None),
    text_signature = "(surface, lines, width, *, accuracy=1e-8, marks=True)"
)]
pub(crate) fn planks<'py>(
    surface: Any<'_, 'py>,
    lines: Any<'_, 'py>,
    width: Any<'_, 'py>,
    accuracy: Option<Any<'_, 'py>>,
    marks: Option<Any<'_, 'py>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = surface.py();
    let surface = shapes::read("surface", surface)?.into_spline();
    let mut all = Vec::new();
    let listed = collected(lines, &mut all)?;
    let width = real("width", width)?;
    let default = PlankOptions::default();
    let options = PlankOptions {
        accuracy: accuracy.map_or(Ok(default.accuracy), |given| real("accuracy", given))?,
        marks: marks.map_or(Ok(default.marks), |given| truth("marks", given))?,
    };
    let found = done(py, usize::MAX, || operators::planks(surface, &all, width, &options))?;
    let mut records = found.into_iter().map(|board| record(py, board));
    if listed {
        return Ok(PyList::new(py, records.collect::<PyResult<Vec<_>>>()?)?.into_any());
    }
    match records.next() {
        Some(record) => record,
        None => fail(&Error::domain("lines", "none", "a line or more")),
    }
}

/// Collects the lines of an object, and says whether it is a list of them.
fn collected(object: Any, into: &mut Vec<Spline>) -> PyResult<bool> {
    let net = match single(object)? {
        Some(shape) => Some(shape),
        None => Numbers::if_any("lines", object)?.as_ref().map(net).transpose()?,
    };
    if let Some(net) = net {
        let (lines, listed) = operators::plank_lines(net).map_err(|e| raised(&e))?;
        into.extend(lines);
        return Ok(listed);
    }
    let Some(items) = object.try_iter().ok().filter(|_| !object.is_instance_of::<PyString>())
    else {
        return Err(mistyped("lines", object, EXPECTED));
    };
    for item in items {
        let item = item?;
        let line = match single(&item)? {
            Some(line) => line,
            None => shapes::read("lines", &item)?,
        };
        into.push(line.into_spline());
    }
    Ok(true)
}

fn net(numbers: &Numbers) -> PyResult<Shape> {
    Ok(from_euclidean("lines", numbers, None).map_err(|e| raised(&e))?.into())
}

const EXPECTED: &str = "geodesics, or curves in the parameters of the surface";

/// A form, a spline, or the line in a record.
fn single(object: Any) -> PyResult<Option<Shape>> {
    let py = object.py();
    if shapes::is_shape(object) {
        return Ok(Some(shapes::read("lines", object)?));
    }
    if let Ok(geodesic) = object.getattr(intern!(py, "geodesic")) {
        // None for a point and itself; not looked into again, so that nothing goes round for ever.
        let parameters = geodesic.getattr(intern!(py, "parameters"));
        return match parameters.ok().and_then(|found| found.cast_into::<PySpline>().ok()) {
            Some(spline) => Ok(Some(spline.get().spline.clone().into())),
            None => Err(mistyped("lines", object, EXPECTED)),
        };
    }
    if let Ok(parameters) = object.getattr(intern!(py, "parameters")) {
        return match parameters.cast::<PySpline>() {
            Ok(spline) => Ok(Some(spline.get().spline.clone().into())),
            Err(_) => Err(mistyped("lines", object, EXPECTED)),
        };
    }
    Ok(None)
}

/// A `pforms.records.Plank`.
fn record(py: Python<'_>, board: Plank) -> PyResult<Bound<'_, PyAny>> {
    let records = py.import(intern!(py, "pforms.records"))?;
    let column = |of: fn(&Mark) -> f64| {
        array(py, &[board.marks.len()], board.marks.iter().map(of).collect::<Vec<f64>>())
    };
    let others: Vec<usize> = board.marks.iter().map(|mark| mark.other).collect();
    let marks = records.getattr(intern!(py, "Marks"))?.call1((
        others,
        column(|mark| mark.at)?,
        column(|mark| mark.other_at)?,
        column(|mark| mark.angle)?,
        column(|mark| mark.error)?,
    ))?;
    // More fields than a tuple of Rust may have.
    let fields = PyList::empty(py);
    fields.append(PySpline::from(board.strip))?;
    fields.append(PySpline::from(board.line))?;
    fields.append(PyForm::from(board.axis))?;
    fields.append(PySpline::from(board.outline))?;
    fields.append(board.length)?;
    fields.append(marks)?;
    fields.append(board.complete)?;
    fields.append(board.overlaps)?;
    for number in [board.bend, board.twist, board.slant, board.strain, board.lift, board.overhang] {
        fields.append(number)?;
    }
    fields.append(board.widest)?;
    fields.append(board.error)?;
    records.getattr(intern!(py, "Plank"))?.call1(fields.to_tuple())
}

/// The operator as a method of a class.
macro_rules! methods {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// Boards along lines of this surface: see :func:`pforms.planks`.
            ///
            /// >>> slope = pf.Form([[(0, 0, 0), (0, 3, 4)], [(1, 0, 0), (1, 3, 4)]])
            /// >>> round(slope.planks([(0, 0.2), (1, 0.5)], 0.1).length ** 2, 9)
            /// 3.25
            #[pyo3(
                        signature = (lines, width, *, accuracy=None, marks=None),
                        text_signature = "($self, lines, width, *, accuracy=1e-8, marks=True)"
                    )]
            fn planks<'py>(
                slf: &Bound<'py, Self>,
                lines: &Bound<'py, PyAny>,
                width: &Bound<'py, PyAny>,
                accuracy: Option<&Bound<'py, PyAny>>,
                marks: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                planks(slf.as_any(), lines, width, accuracy, marks)
            }
        }
    };
}

methods!(PyForm);
methods!(PySpline);
