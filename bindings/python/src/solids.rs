//! Union, difference and common part of solids.

use pforms_mesh::{Operation, Part, combine};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arguments::{real, truth};
use crate::errors::{done, mistyped};
use crate::{meshes, shapes};

/// What is given for an accuracy that is left out.
const ACCURACY: f64 = 1e-3;

/// Everything that is in one of some solids, as a closed mesh.
///
/// Parameters
/// ----------
/// *solids : Form, Spline, Mesh, or sequence of them
///     Each a closed surface, a list of the patches of one, a volume or a closed mesh; of a list that
///     holds several shells, all that is inside any of them. Patches are glued where they meet;
///     which way round they are given does not matter. Somebody else's mesh with ``vertices`` and
///     ``triangles`` or ``faces`` will do.
/// accuracy : float, optional
///     How far a mesh may be from its surface, in diagonals of the box round the solid.
/// report : bool, optional
///     Return a :class:`Solid` of ``mesh``, ``volume``, ``error`` and ``distance``.
///
/// Returns
/// -------
/// Mesh, or Solid if report
///     Closed, and empty if there is nothing.
///
/// Raises
/// ------
/// ShapeError
///     For a shell that is open, telling where, for one with a single side, and for what is no solid.
/// DegenerateError
///     For a shell without a volume.
/// DomainError
///     For an accuracy that is not above 0 and at most 0.1.
/// LimitError
///     When the meshes would be too large.
///
/// Examples
/// --------
/// >>> box = pf.cube((2, 2, 2))
/// >>> both = pf.union(box, pf.translate(box, (0.5, 0, 0)))
/// >>> both.is_closed, round(both.volume, 12)
/// (True, 1.5)
#[pyfunction]
#[pyo3(signature = (*solids, accuracy=None, report=None), text_signature = "(*solids, accuracy=0.001, report=False)")]
pub(crate) fn union<'py>(
    solids: &Bound<'py, PyTuple>,
    accuracy: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    answer(Operation::Union, solids, accuracy, report)
}

/// The first of some solids without the others, as a closed mesh.
///
/// Arguments, answers and errors as :func:`union`.
///
/// >>> box = pf.cube((2, 2, 2))
/// >>> round(pf.difference(box, pf.translate(box, (0.5, 0, 0))).volume, 12)
/// 0.5
#[pyfunction]
#[pyo3(signature = (*solids, accuracy=None, report=None), text_signature = "(*solids, accuracy=0.001, report=False)")]
pub(crate) fn difference<'py>(
    solids: &Bound<'py, PyTuple>,
    accuracy: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    answer(Operation::Difference, solids, accuracy, report)
}

/// What is in all of some solids, as a closed mesh.
///
/// Arguments, answers and errors as :func:`union`.
///
/// >>> ball = pf.sphere(1)
/// >>> lens = pf.common(ball, pf.translate(ball, (1, 0, 0)), report=True)
/// >>> bool(abs(lens.volume - 5 * np.pi / 12) <= lens.error)
/// True
#[pyfunction]
#[pyo3(signature = (*solids, accuracy=None, report=None), text_signature = "(*solids, accuracy=0.001, report=False)")]
pub(crate) fn common<'py>(
    solids: &Bound<'py, PyTuple>,
    accuracy: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    answer(Operation::Common, solids, accuracy, report)
}

fn answer<'py>(
    operation: Operation,
    solids: &Bound<'py, PyTuple>,
    accuracy: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = solids.py();
    let bodies: Vec<Vec<Part>> =
        solids.iter().map(|solid| body(&solid)).collect::<PyResult<_>>()?;
    let accuracy = accuracy.map_or(Ok(ACCURACY), |given| real("accuracy", given))?;
    let report = report.map_or(Ok(false), |given| truth("report", given))?;
    let (solid, volume) = done(py, usize::MAX, || {
        let solid = combine(operation, &bodies, accuracy)?;
        let volume = if report { solid.mesh.volume()? } else { 0.0 };
        Ok((solid, volume))
    })?;
    let mesh = meshes::record(py, &solid.mesh)?;
    if !report {
        return Ok(mesh);
    }
    let records = py.import(intern!(py, "pforms.records"))?;
    let record = records.getattr(intern!(py, "Solid"))?;
    record.call1((mesh, volume, solid.volume_error, solid.distance))
}

/// The parts of a solid: one, or those of the items of a list.
fn body(object: &Bound<'_, PyAny>) -> PyResult<Vec<Part>> {
    if shapes::is_shape(object) {
        return Ok(vec![Part::Shape(shapes::read("solids", object)?)]);
    }
    if meshes::is_mesh(object) {
        return Ok(vec![Part::Mesh(meshes::read("solids", object)?)]);
    }
    let expected = "forms, splines and meshes, or lists of them";
    let items = object.try_iter().map_err(|_| mistyped("solids", object, expected))?;
    let mut parts = Vec::new();
    for item in items {
        let item = item?;
        if !shapes::is_shape(&item) && !meshes::is_mesh(&item) {
            return Err(mistyped("solids", &item, expected));
        }
        parts.extend(body(&item)?);
    }
    Ok(parts)
}
