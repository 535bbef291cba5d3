//! Meshes as records of arrays, both ways.

use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pforms_kernel::Error;
use pforms_mesh::Mesh;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use crate::arrays::Numbers;
use crate::errors::{done, fail, mistyped, raised};
use crate::tessellating::signed;

/// Is it a mesh: a `pforms.Mesh`, or somebody else's vertices and triangles (or faces)?
pub(crate) fn is_mesh(object: &Bound<'_, PyAny>) -> bool {
    let py = object.py();
    let has = |name| object.hasattr(name).unwrap_or(false);
    has(intern!(py, "vertices")) && (has(intern!(py, "triangles")) || has(intern!(py, "faces")))
}

/// Reads a mesh; in dimension 3, or as its vertices are.
///
/// Errors: `ShapeError`, `DomainError` for arrays that do not fit together.
pub(crate) fn read(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<Mesh> {
    let py = object.py();
    if !is_mesh(object) {
        return Err(mistyped(argument, object, "a pforms.Mesh"));
    }
    let vertices = object.getattr(intern!(py, "vertices"))?;
    let triangles = object
        .getattr(intern!(py, "triangles"))
        .or_else(|_| object.getattr(intern!(py, "faces")))?;
    of_arrays(&vertices, &triangles)
}

/// Meshes given one by one, or all in a list; nothing when the first is none.
///
/// Errors: as [`read`]; `ArgumentError` for anything else among them.
pub(crate) fn several(argument: &str, given: &Bound<'_, PyTuple>) -> PyResult<Option<Vec<Mesh>>> {
    let mut items: Vec<Bound<'_, PyAny>> = given.iter().collect();
    // A mesh is a named tuple itself.
    if let [single] = &items[..]
        && !is_mesh(single)
        && (single.is_instance_of::<PyList>() || single.is_instance_of::<PyTuple>())
    {
        items = single.try_iter()?.collect::<PyResult<_>>()?;
    }
    if !items.iter().any(is_mesh) {
        return Ok(None);
    }
    items.iter().map(|item| read(argument, item)).collect::<PyResult<_>>().map(Some)
}

fn of_arrays(vertices: &Bound<'_, PyAny>, triangles: &Bound<'_, PyAny>) -> PyResult<Mesh> {
    let (vertices, triangles) =
        (Numbers::read("vertices", vertices)?, Numbers::read("triangles", triangles)?);
    let [_, ambient] = vertices.shape() else {
        let received = format!("an array of shape {:?}", vertices.shape());
        return fail(&Error::shape("vertices", received, "shape (n, c)"));
    };
    if !matches!(triangles.shape(), [_, 3] | [0]) {
        let received = format!("an array of shape {:?}", triangles.shape());
        return fail(&Error::shape("triangles", received, "shape (m, 3)"));
    }
    let index = |x: &f64| {
        let whole = x.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(x);
        whole.then_some(*x as u32).ok_or_else(|| Error::domain("triangles", x, "indices from 0"))
    };
    let indices: Result<Vec<u32>, Error> = triangles.values().iter().map(index).collect();
    let made = indices.and_then(|indices| {
        let triangles = indices.as_chunks::<3>().0.to_vec();
        Mesh::new(*ambient, vertices.values().to_vec(), triangles)
    });
    made.map_err(|error| raised(&error))
}

/// The record in Python; it has no normals.
pub(crate) fn record<'py>(py: Python<'py>, mesh: &Mesh) -> PyResult<Bound<'py, PyAny>> {
    let shape = [mesh.vertex_count(), mesh.ambient()];
    let vertices = PyArray1::from_vec(py, mesh.vertices().to_vec()).reshape(shape)?;
    let none: Bound<'_, PyArray2<f64>> = PyArray2::zeros(py, [0, mesh.ambient()], false);
    py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Mesh"))?.call1((
        vertices,
        none,
        signed(py, mesh.triangles().to_vec())?,
    ))
}

/// The area of all triangles of a mesh.
#[pyfunction]
pub(crate) fn _mesh_area(mesh: &Bound<'_, PyAny>) -> PyResult<f64> {
    Ok(read("mesh", mesh)?.area())
}

/// The volume inside a closed mesh.
#[pyfunction]
pub(crate) fn _mesh_volume(mesh: &Bound<'_, PyAny>) -> PyResult<f64> {
    let closed = read("mesh", mesh)?;
    done(mesh.py(), usize::MAX, || closed.welded()?.volume())
}

/// Does every edge of a mesh have a triangle on either side?
#[pyfunction]
pub(crate) fn _mesh_is_closed(mesh: &Bound<'_, PyAny>) -> PyResult<bool> {
    let read = read("mesh", mesh)?;
    done(mesh.py(), usize::MAX, || Ok(read.welded()?.is_closed()))
}

/// A mesh of vertices and triangles, checked.
#[pyfunction]
pub(crate) fn _make_mesh<'py>(
    vertices: &Bound<'py, PyAny>,
    triangles: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    record(vertices.py(), &of_arrays(vertices, triangles)?)
}
