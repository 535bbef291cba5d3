//! Surfaces of little area on a boundary.

use pforms_operators::{self as operators, Functional, MinimalOptions, Poles};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arguments::{real, reals, truth, wholes, word};
use crate::errors::{done, mistyped};
use crate::shapes;

/// A surface of little area on a given boundary.
///
/// Parameters
/// ----------
/// *boundary : Form, Spline or array
///     One form, whose inner poles are not looked at; or faces in the order of :func:`coons`, one by one or
///     in a list.
/// kind : str, optional
///     What the inner poles make least: ``"dirichlet"``, ½∫|∇S|²; ``"harmonic"``, ½∫|ΔS|²;
///     ``"laplace"``, half the squares of the sides of the net, so that each pole is the mean of its
///     neighbours; or ``"area"``, going down on the area itself from the best of the Coons patch and
///     surfaces of least Dirichlet energy.
/// orders : int or sequence of int, optional
///     Orders to raise the boundary to, so that more poles move.
/// sides : float or sequence of float, optional
///     Lengths of the sides of the box of parameters; those of the window.
/// keep : sequence of places, optional
///     Inner poles that stay where they are: ``[(i, j), …]``.
/// accuracy : float, optional
///     Of ``"area"``: the slope at which the descent ends.
/// report : bool, optional
///     Return a :class:`Minimal` of the surface, its area and what else is known.
///
/// Returns
/// -------
/// Form, or Spline if a part of the boundary is one; or Minimal if report
///
/// Raises
/// ------
/// DomainError
///     Where faces do not meet: the message names corner and gap. For weights that change sign, for
///     orders below those of the boundary, for arguments that the kind does not know.
/// ShapeError
///     For faces that do not fit together; for reports and areas of anything but surfaces.
///
/// Examples
/// --------
/// >>> arch, roof = [[(0, y, 0), (1, y, 2), (2, y, 0)] for y in (0, 3)]
/// >>> left, right = [[(x, 0, 0), (x, 3, 0)] for x in (0, 2)]
/// >>> film = pf.minimal(arch, roof, left, right, kind="area", orders=4, report=True)
/// >>> film.surface, film.area < film.coons_area
/// (<pforms.Form pS44 in 3D>, True)
/// >>> net = pf.Form([[(x, y, x * y) for y in (0, 1, 3)] for x in (0, 1, 3)])
/// >>> pf.minimal(net, kind="laplace").poles[1, 1]
/// array([1.25, 1.25, 1.5 ])
#[pyfunction]
#[pyo3(
    signature = (*boundary, kind=None, orders=None, sides=None, keep=None, accuracy=None, report=None),
    text_signature = "(*boundary, kind='dirichlet', orders=None, sides=None, keep=None, \
                      accuracy=1e-09, report=False)"
)]
pub(crate) fn minimal<'py>(
    boundary: &Bound<'py, PyTuple>,
    kind: Option<&Bound<'py, PyAny>>,
    orders: Option<&Bound<'py, PyAny>>,
    sides: Option<&Bound<'py, PyAny>>,
    keep: Option<&Bound<'py, PyAny>>,
    accuracy: Option<&Bound<'py, PyAny>>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = boundary.py();
    let shapes = shapes::read_several("boundary", boundary)?;
    let axes = if shapes.len() == 1 { shapes[0].net().axes() } else { shapes.len() / 2 };
    let options = MinimalOptions {
        orders: orders.map_or(Ok(Vec::new()), |given| wholes("orders", given, axes))?,
        sides: sides.map_or(Ok(Vec::new()), |given| reals("sides", given, axes))?,
        keep: keep.map_or(Ok(Vec::new()), |given| places(given, axes))?,
    };
    let kinds = ["dirichlet", "harmonic", "laplace", "area"];
    let functional = match kind.map_or(Ok("dirichlet"), |given| word("kind", given, &kinds))? {
        "dirichlet" => Some(Functional::Dirichlet),
        "harmonic" => Some(Functional::Harmonic),
        "laplace" => Some(Functional::Laplace),
        _ => None,
    };
    if let (Some(accuracy), Some(_)) = (accuracy, functional) {
        return Err(mistyped("accuracy", accuracy, "none, as this kind is a linear system"));
    }
    let accuracy = accuracy.map_or(Ok(1e-9), |given| real("accuracy", given))?;
    let report = report.map_or(Ok(false), |given| truth("report", given))?;
    let polynomial = shapes.iter().all(|shape| shape.net().uniform_weight().is_some());
    if let Some(functional) = functional
        && polynomial
        && !report
    {
        let work = || operators::extremal(&shapes, functional, &options);
        return shapes::object(py, done(py, usize::MAX, work)?);
    }
    let found =
        done(py, usize::MAX, || operators::minimal(&shapes, functional, &options, accuracy))?;
    let surface = shapes::object(py, found.surface)?;
    if !report {
        return Ok(surface);
    }
    let class = py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Minimal"))?;
    class.call1((
        surface,
        found.area,
        found.error,
        found.coons_area,
        found.energy,
        found.laplacian,
        found.curvature,
        found.slope,
        found.steps,
    ))
}

/// A place for each row.
fn places(given: &Bound<'_, PyAny>, axes: usize) -> PyResult<Vec<Vec<usize>>> {
    let Ok(items) = given.try_iter() else {
        return Err(mistyped("keep", given, "a list of places in the net"));
    };
    items.map(|item| wholes("keep", &item?, axes)).collect()
}
