//! Hosts as spaces to draw in: segments, polylines, tiles, and any map of the poles.

use pforms_kernel::{Error, Form};
use pforms_operators::{self as operators, Poles};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arguments::{form, reals, require_finite, wholes};
use crate::arrays::Numbers;
use crate::embedding::bending_work;
use crate::errors::{done, fail, mistyped, raised};
use crate::form::PyForm;
use crate::immersed::spline_immersed;
use crate::shapes;
use crate::slices::require_feasible;
use crate::spline::PySpline;

/// The immersed segment from parameter point ``a`` to parameter point ``b`` of the host.
///
/// Its order is ``Σ (m - 1) + 1`` for host orders ``m``; exact.
///
/// Parameters
/// ----------
/// host : Form or Spline
///     In a spline the segment is a spline, cut where it crosses the knots.
/// a, b : sequence of float
///     One parameter for each axis of the host.
///
/// Raises
/// ------
/// ShapeError, DomainError, LimitError
///     For a wrong count of parameters, for NaN, and for too many poles.
///
/// Examples
/// --------
/// >>> host = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
/// >>> pf.segment(host, (0, 0), (1, 1)) == host.diagonal()
/// True
#[pyfunction]
#[pyo3(signature = (host, a, b))]
pub(crate) fn segment<'py>(
    host: &Bound<'py, PyAny>,
    a: &Bound<'py, PyAny>,
    b: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let (from, to) = (reals("a", a, 1)?, reals("b", b, 1)?);
    require_finite("a", &from)?;
    require_finite("b", &to)?;
    if let Ok(spline) = host.cast::<PySpline>() {
        let net = spline.get().spline.net();
        net.require_per_axis("a", &from).map_err(|error| raised(&error))?;
        net.require_per_axis("b", &to).map_err(|error| raised(&error))?;
        let line = Form::from_points(&[2], from.len(), &[from, to].concat(), None);
        let line = PyForm::from(line.map_err(|error| raised(&error))?);
        return spline_immersed(Bound::new(host.py(), line)?.as_any(), host);
    }
    let form = form("host", host)?;
    let cost = form.homogeneous().len().saturating_mul(form.axes() + 1);
    let curve = done(host.py(), cost, || operators::segment(&form, &from, &to))?;
    Ok(Bound::new(host.py(), PyForm::from(curve))?.into_any())
}

/// The immersed segments from each parameter point to the next: a list of curves.
///
/// Parameters
/// ----------
/// host : Form
/// points : array_like, shape (m, axes of the host)
///
/// Raises
/// ------
/// ShapeError, DomainError, LimitError
///     As :func:`segment`.
///
/// Examples
/// --------
/// >>> host = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
/// >>> len(pf.polyline(host, [(0, 0), (1, 0), (1, 1)]))
/// 2
#[pyfunction]
#[pyo3(signature = (host, points))]
pub(crate) fn polyline(
    host: &Bound<'_, PyAny>,
    points: &Bound<'_, PyAny>,
) -> PyResult<Vec<PyForm>> {
    let form = form("host", host)?;
    let points = Numbers::read("points", points)?;
    let [count, width] = *points.shape() else {
        let received = format!("an array of shape {:?}", points.shape());
        return fail(&Error::shape("points", received, format!("shape (m, {})", form.axes())));
    };
    require_finite("points", points.values())?;
    let lists: Vec<&[f64]> = match width {
        0 => vec![&[]; count],
        _ => points.values().chunks_exact(width).collect(),
    };
    let cost = form.homogeneous().len().saturating_mul(count);
    let curves = done(host.py(), cost, || operators::polyline(&form, &lists))?;
    Ok(curves.into_iter().map(PyForm::from).collect())
}

/// Forms of a cell, drawn in the unit cube of the cage's parameters, repeated and immersed.
///
/// Parameters
/// ----------
/// cells : Form, Spline or a sequence of them
///     With one coordinate for each axis of the cage.
/// cage : Form or Spline
///     A motif is cut where it crosses a knot of a spline, and becomes one.
/// counts : int or sequence of int
///     Repetitions along each parameter.
///
/// Returns
/// -------
/// list of Form, or of Spline
///     Cell by cell, the last parameter fastest, and within a cell in the given order.
///
/// Raises
/// ------
/// ShapeError, DomainError, LimitError
///     When dimensions do not fit or a count is 0; a negative count; when all is too large.
///
/// Examples
/// --------
/// >>> cage = pf.Form([[(0, 0), (0, 1)], [(1, 0), (1, 1)]])
/// >>> strut = pf.Form([(0, 0), (1, 1)])
/// >>> [form.poles[0].tolist() for form in pf.tile([strut], cage, 2)]
/// [[0.0, 0.0], [0.0, 0.5], [0.5, 0.0], [0.5, 0.5]]
#[pyfunction]
#[pyo3(signature = (cells, cage, counts))]
pub(crate) fn tile<'py>(
    cells: &Bound<'py, PyAny>,
    cage: &Bound<'py, PyAny>,
    counts: &Bound<'py, PyAny>,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let py = cells.py();
    let cage = shapes::read("cage", cage)?;
    let list = shapes::list("cells", cells)?;
    let counts = wholes("counts", counts, cage.net().axes())?;
    let copies: f64 = counts.iter().map(|&count| count as f64).product();
    let mut work = 0.0;
    for cell in &list {
        work += bending_work(cell, &cage)?;
    }
    require_feasible("the tiling", copies * work)?;
    let tiles = done(py, usize::MAX, || operators::tile_shapes(&list, &cage, &counts))?;
    tiles.into_iter().map(|tile| shapes::object(py, tile)).collect()
}

/// Pointwise immersion: the images of the poles of a form under any map, as a form.
///
/// Not the immersion: the result is near the mapped form only where the map is nearly affine.
///
/// Parameters
/// ----------
/// map : callable
///     Called once for each pole with its coordinates, ``map(x, y, …)``; returns a point. A host
///     form is such a map.
/// form : Form
///     Without poles at infinity; its weights are kept.
///
/// Raises
/// ------
/// DomainError
///     When a pole is at infinity or an image is not finite.
/// ShapeError
///     When images have different dimensions.
///
/// Examples
/// --------
/// >>> curve = pf.Form([(0, 0), (1, 2), (2, 0)])
/// >>> pf.immerse_points(lambda x, y: (x, y, x * y), curve).poles
/// array([[0., 0., 0.],
///        [1., 2., 2.],
///        [2., 0., 0.]])
#[pyfunction]
#[pyo3(signature = (map, form))]
pub(crate) fn immerse_points(map: &Bound<'_, PyAny>, form: &Bound<'_, PyAny>) -> PyResult<PyForm> {
    if !map.is_callable() {
        return Err(mistyped("map", map, "something to call"));
    }
    let form = crate::arguments::form("form", form)?;
    let mut failure = None;
    let images = operators::immerse_points(&form, |point| {
        image(map, point).map_err(|error| {
            failure = Some(error);
            Error::domain("map", "an exception", "a point")
        })
    });
    match (images, failure) {
        (_, Some(error)) => Err(error),
        (images, None) => images.map(PyForm::from).map_err(|error| raised(&error)),
    }
}

fn image(map: &Bound<'_, PyAny>, point: &[f64]) -> PyResult<Vec<f64>> {
    let answer = map.call1(PyTuple::new(map.py(), point)?)?;
    let numbers = Numbers::read("map", &answer)?;
    match numbers.shape() {
        [_] => Ok(numbers.values().to_vec()),
        shape => {
            let received = format!("an image of shape {shape:?}");
            fail(&Error::shape("map", received, "a point, an array of shape (c,)"))
        }
    }
}
