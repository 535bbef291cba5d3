//! Forms as triangles and lines in arrays.

use numpy::{PyArray1, PyArrayMethods};
use pforms_kernel::{Error, Result};
use pforms_mesh::{Curve, Sampling, Triangles, chain, curve, envelope, facets, patches, surfaces};
use pforms_operators::{Poles, Shape};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::PyList;

use crate::arguments::{level, real, truth, wholes};
use crate::errors::{ArgumentError, done, fail};
use crate::shapes;

/// Forms as triangles, within a tolerance or in equal cells.
///
/// A surface becomes a :class:`Mesh`, a volume the mesh of its six faces, normals outwards, and a
/// curve a :class:`Polyline`. Surfaces of one call that have a common edge (the same homogeneous
/// poles, in either direction) get the same vertices on it, to the last bit: a closed surface is
/// watertight. Normals are unit vectors everywhere; where the surface has none, at the pole of a
/// sphere say, the limit from inside.
///
/// Parameters
/// ----------
/// forms : Form, Spline or sequence of them
///     Curves, surfaces and volumes in any dimension; of more than three coordinates the first
///     three are taken. A spline becomes one mesh of all its pieces, or one line; the sampling
///     counts for each piece.
/// tolerance : float, optional
///     No point of the form is farther from its mesh than this, in the units of the form. It is
///     proven for every point, not sampled, and the triangles are few: small where the surface
///     bends, large where it is flat.
/// segments : int or sequence of int, optional
///     So many equal cells along each axis, each of two triangles: ``(n + 1)²`` vertices in C
///     order.
/// fineness : int or sequence of int, optional
///     ``2**fineness`` cells along each axis; triangles without area are left out.
/// normals : bool, optional
///     Without, the arrays of normals and tangents are empty.
/// joined : bool, optional
///     Return one mesh for all forms; vertices on common edges stay apart.
///
/// Returns
/// -------
/// Mesh or Polyline, or a list of them for a list of forms
///
/// Raises
/// ------
/// ArgumentError
///     Unless one of ``tolerance``, ``segments`` and ``fineness`` is given.
/// ShapeError
///     For forms without axes or with more than three, and for curves to be joined.
/// DomainError
///     For a tolerance that is not positive, 0 segments, and where a weight vanishes.
/// LimitError
///     When the mesh would be too large for the cap.
///
/// Examples
/// --------
/// >>> saddle = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
/// >>> mesh = pf.tessellate(saddle, tolerance=0.01)
/// >>> mesh.vertices.shape == mesh.normals.shape, mesh.triangles.dtype
/// (True, dtype('int32'))
/// >>> vertices, normals, triangles = pf.tessellate(saddle, segments=64)
/// >>> len(vertices), len(triangles)
/// (4225, 8192)
#[pyfunction]
#[pyo3(
    signature = (forms, *, tolerance=None, segments=None, fineness=None, normals=None, joined=None),
    text_signature = "(forms, *, tolerance=None, segments=None, fineness=None, normals=True, joined=False)"
)]
pub(crate) fn tessellate<'py>(
    forms: &Bound<'py, PyAny>,
    tolerance: Option<&Bound<'py, PyAny>>,
    segments: Option<&Bound<'py, PyAny>>,
    fineness: Option<&Bound<'py, PyAny>>,
    normals: Option<&Bound<'py, PyAny>>,
    joined: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = forms.py();
    let list = shapes::list("forms", forms)?;
    let sampling = sampling(tolerance, segments, fineness)?;
    let wish =
        |name, object: Option<_>, usual| object.map_or(Ok(usual), |given| truth(name, given));
    let (normals, joined) = (wish("normals", normals, true)?, wish("joined", joined, false)?);
    let drawn = done(py, usize::MAX, || tessellated(&list, &sampling, normals))?;
    if joined {
        return join(py, drawn);
    }
    let mut records = drawn.into_iter().map(|one| one.record(py));
    match records.next() {
        Some(record) if shapes::is_shape(forms) => record,
        first => {
            let all: Vec<_> = first.into_iter().chain(records).collect::<PyResult<_>>()?;
            Ok(PyList::new(py, all)?.into_any())
        }
    }
}

/// What was asked for, which must be one of the three.
fn sampling(
    tolerance: Option<&Bound<'_, PyAny>>,
    segments: Option<&Bound<'_, PyAny>>,
    fineness: Option<&Bound<'_, PyAny>>,
) -> PyResult<Sampling> {
    match (tolerance, segments, fineness) {
        (Some(tolerance), None, None) => real("tolerance", tolerance).map(Sampling::Tolerance),
        (None, Some(segments), None) => wholes("segments", segments, 1).map(Sampling::Segments),
        (None, None, Some(fineness)) => {
            let levels = wholes("fineness", fineness, 1)?.into_iter();
            let levels = levels.map(|count| level("fineness", count));
            levels.collect::<PyResult<_>>().map(Sampling::Fineness)
        }
        _ => Err(ArgumentError::new_err(
            "tessellate: expected one of tolerance, segments and fineness",
        )),
    }
}

/// What a form has become.
enum Drawn {
    Mesh(Triangles),
    Lines(Curve),
}

/// Tessellates all surfaces, pieces and faces of volumes together.
fn tessellated(shapes: &[Shape], sampling: &Sampling, normals: bool) -> Result<Vec<Drawn>> {
    let mut all = Vec::new();
    let mut counts = Vec::with_capacity(shapes.len());
    for shape in shapes {
        let before = all.len();
        if shape.net().axes() == 3 {
            require_one_number(sampling)?;
        }
        match (shape.net().axes(), shape) {
            (1, _) => {}
            (2, Shape::Form(form)) => all.push(form.clone()),
            (3, Shape::Form(form)) => all.extend(envelope(form)?),
            (2 | 3, Shape::Spline(spline)) => all.extend(patches(spline)?),
            _ => {
                let received = shape.net().kind();
                return Err(Error::shape("forms", received, "curves, surfaces or volumes"));
            }
        }
        counts.push(all.len() - before);
    }
    let mesh = if normals { surfaces } else { facets };
    let mut meshes = mesh(&all, sampling)?.into_iter();
    let draw = |(shape, count): (&Shape, usize)| {
        if count == 0 {
            let mut line = match shape {
                Shape::Form(form) => curve(form, sampling)?,
                Shape::Spline(spline) => chain(spline, sampling)?,
            };
            if !normals {
                line.polylines.iter_mut().for_each(|part| part.tangents.clear());
            }
            return Ok(Drawn::Lines(line));
        }
        let mut whole = meshes.next().unwrap_or_default();
        for face in meshes.by_ref().take(count - 1) {
            whole.append(&face);
        }
        Ok(Drawn::Mesh(whole))
    };
    shapes.iter().zip(counts).map(draw).collect()
}

/// The faces of a volume do not run along its axes in order.
fn require_one_number(sampling: &Sampling) -> Result<()> {
    let (name, count) = match sampling {
        Sampling::Segments(counts) => ("segments", counts.len()),
        Sampling::Fineness(levels) => ("fineness", levels.len()),
        Sampling::Tolerance(_) => return Ok(()),
    };
    if count == 1 {
        return Ok(());
    }
    Err(Error::shape(name, format!("{count} numbers"), "one number, for a volume"))
}

fn join(py: Python<'_>, all: Vec<Drawn>) -> PyResult<Bound<'_, PyAny>> {
    let mut whole = Triangles::default();
    for one in all {
        match one {
            Drawn::Mesh(mesh) if whole.positions.is_empty() => whole = mesh,
            Drawn::Mesh(mesh) => whole.append(&mesh),
            Drawn::Lines(_) => {
                return fail(&Error::shape(
                    "forms",
                    "a curve",
                    "surfaces or volumes, to be joined",
                ));
            }
        }
    }
    Drawn::Mesh(whole).record(py)
}

impl Drawn {
    /// The record in Python; its arrays take over what was computed.
    fn record(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        let records = py.import(intern!(py, "pforms.records"))?;
        match self {
            Self::Mesh(mesh) => records.getattr(intern!(py, "Mesh"))?.call1((
                rows(py, mesh.positions)?,
                rows(py, mesh.normals)?,
                signed(py, mesh.indices)?,
            )),
            Self::Lines(curve) => {
                let (mut points, mut tangents, mut lines) = (Vec::new(), Vec::new(), Vec::new());
                for line in curve.polylines {
                    let first = points.len() as u32;
                    let last = first + line.points.len() as u32 - 1;
                    lines.extend((first..last).map(|k| [k, k + 1]));
                    points.extend(line.points);
                    tangents.extend(line.tangents);
                }
                records.getattr(intern!(py, "Polyline"))?.call1((
                    rows(py, points)?,
                    rows(py, tangents)?,
                    signed(py, lines)?,
                ))
            }
        }
    }
}

/// An array of shape (n, 3).
pub(crate) fn rows(py: Python<'_>, list: Vec<[f64; 3]>) -> PyResult<Bound<'_, PyAny>> {
    let shape = [list.len(), 3];
    Ok(PyArray1::from_vec(py, list.into_flattened()).reshape(shape)?.into_any())
}

/// An array of signed numbers of shape (n, N): their bits are the same below 2³¹.
pub(crate) fn signed<const N: usize>(
    py: Python<'_>,
    list: Vec<[u32; N]>,
) -> PyResult<Bound<'_, PyAny>> {
    let shape = [list.len(), N];
    let array = PyArray1::from_vec(py, list.into_flattened()).reshape(shape)?;
    array.call_method1(intern!(py, "view"), (intern!(py, "int32"),))
}
