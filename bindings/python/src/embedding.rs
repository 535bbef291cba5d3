//! What follows a cage: forms exactly, points by their parameters.

use numpy::{PyArray1, PyArrayDyn, PyArrayMethods};
use pforms_kernel::Error;
use pforms_operators::{
    self as operators, Embedder, Embedding, Outside, Poles, Rest, Shape, Standing,
};
use pyo3::IntoPyObjectExt;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use crate::arguments::real;
use crate::arrays::Numbers;
use crate::errors::{done, fail, mistyped, raised};
use crate::form::PyForm;
use crate::immersed::PyImmersed;
use crate::operators::immersion_work;
use crate::outputs::{array, filled};
use crate::shapes::{self, is_shape, object};
use crate::sheet::sparse;
use crate::slices::{in_slices, require_feasible};

/// Points with their parameters in a cage: ``pf.embed(points, cage)``.
///
/// >>> square = pf.Form([[(0, 0), (0, 2)], [(2, 0), (2, 2)]])
/// >>> points = pf.embed([(1, 0.5), (3, 1)], square)
/// >>> points
/// <pforms.Embedding of 2 points, 1 inside>
/// >>> points.at(square.with_pole((1, 0), (4, 0)))
/// array([[1.75, 0.5 ],
///        [3.  , 1.  ]])
#[pyclass(frozen, module = "pforms", name = "Embedding", weakref)]
pub(crate) struct PyEmbedding {
    embedding: Embedding,
    /// Of the array of points, without the last axis.
    shape: Vec<usize>,
}

#[pymethods]
impl PyEmbedding {
    /// The parameters, shape (…, axes of the cage); where the cage begins for points that stay.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let lists = &self.embedding.parameters;
        let wide = self.wide(lists.len());
        filled(py, &wide, None, None, |out| {
            for (i, row) in out.chunks_exact_mut(lists.len()).enumerate() {
                for (t, list) in row.iter_mut().zip(lists) {
                    *t = list[i];
                }
            }
            Ok(())
        })
    }

    /// The points as they were given, shape (…, c).
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let wide = self.wide(self.embedding.parameters.len());
        array(py, &wide, self.embedding.points.clone())
    }

    /// Which points are in the cage, shape (…).
    #[getter]
    fn inside<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<bool>>> {
        self.truths(py, self.embedding.inside().collect())
    }

    /// Which points follow the cage continued beyond its window, shape (…).
    #[getter]
    fn extended<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<bool>>> {
        let standings = self.embedding.standings.iter();
        self.truths(py, standings.map(|standing| *standing == Standing::Extended).collect())
    }

    /// Distances between the points and the cage at the parameters, at most, shape (…): proved,
    /// rounding included; infinite for points that stay.
    #[getter]
    fn residual<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        array(py, &self.shape, self.embedding.residuals.clone())
    }

    /// How many places of the cage give each point, shape (…): more than one where it folds, of which
    /// the first is taken.
    #[getter]
    fn counts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<i64>>> {
        let counts = self.embedding.counts.iter().map(|count| *count as i64);
        PyArray1::from_iter(py, counts).reshape(self.shape.clone())
    }

    /// Is it proved that there are no other places, shape (…)?
    #[getter]
    fn complete<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<bool>>> {
        self.truths(py, self.embedding.complete.clone())
    }

    /// The points in another cage, or in the same with other poles.
    ///
    /// Points outside stay where they are, unless they were extended.
    ///
    /// Parameters
    /// ----------
    /// cage : Form or Spline
    ///     With as many axes, and the same window.
    /// out : ndarray, optional
    ///     Filled in place.
    ///
    /// Raises
    /// ------
    /// ShapeError, DomainError
    ///     For a cage of other axes, or of another space when points stay; where its weight
    ///     vanishes.
    #[pyo3(signature = (cage, *, out=None))]
    fn at<'py>(
        &self,
        cage: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let (py, cage) = (cage.py(), shapes::read("cage", cage)?);
        let cost = cage.net().homogeneous().len().saturating_mul(self.embedding.len());
        filled(py, &self.shape, Some(cage.net().ambient()), out, |numbers| {
            done(py, cost, || self.embedding.at_into(&cage, numbers))
        })
    }

    /// How each point follows each pole of a cage: the derivatives, a sparse matrix.
    ///
    /// Returns
    /// -------
    /// Sparse
    ///     A row for each point, a column for each pole; every coordinate of a pole moves that of the
    ///     point by the entry. Rows of points that stay are empty.
    ///
    /// Examples
    /// --------
    /// >>> square = pf.Form([[(0, 0), (0, 2)], [(2, 0), (2, 2)]])
    /// >>> pf.embed([(1, 0.5)], square).sensitivities(square).toarray()
    /// array([[0.375, 0.125, 0.375, 0.125]])
    #[pyo3(signature = (cage))]
    fn sensitivities<'py>(&self, cage: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let (py, cage) = (cage.py(), shapes::read("cage", cage)?);
        let orders = cage.net().pole_count().saturating_mul(self.embedding.len());
        let matrix = done(py, orders, || self.embedding.sensitivities(&cage))?;
        sparse(py, &matrix)
    }

    /// Determinants of the derivatives of a cage at the points, shape (…): where their signs differ
    /// it folds. 0 for points that stay.
    #[pyo3(signature = (cage))]
    fn jacobians<'py>(&self, cage: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let (py, cage) = (cage.py(), shapes::read("cage", cage)?);
        let cost = 8 * cage.net().homogeneous().len().saturating_mul(self.embedding.len());
        let found = done(py, cost, || self.embedding.jacobians(&cage))?;
        array(py, &self.shape, found)
    }

    fn __len__(&self) -> usize {
        self.embedding.len()
    }

    fn __repr__(&self) -> String {
        let inside = self.embedding.inside().filter(|inside| *inside).count();
        format!("<pforms.Embedding of {} points, {inside} inside>", self.embedding.len())
    }
}

impl PyEmbedding {
    fn wide(&self, width: usize) -> Vec<usize> {
        self.shape.iter().copied().chain([width]).collect()
    }

    fn truths<'py>(
        &self,
        py: Python<'py>,
        list: Vec<bool>,
    ) -> PyResult<Bound<'py, PyArrayDyn<bool>>> {
        PyArray1::from_vec(py, list).reshape(self.shape.clone())
    }
}

/// The parameters of points in a cage, so that they follow it when it is bent.
///
/// Every parameter found is proved right to its residual, and points outside are proved to be, or
/// called not complete. Of several places of a folded cage the first in the order of the parameters
/// is taken.
///
/// Parameters
/// ----------
/// points : array_like, shape (…, c)
///     In the space of the cage.
/// cage : Form or Spline
///     As many axes as coordinates, 4 at most: a volume in space, a surface in the plane.
/// accuracy : float, optional
///     In sizes of the cage: points so near to it count as in it.
/// outside : {"keep", "extend", "error"}
///     Points outside stay where they are, follow the cage continued beyond its window where that
///     can be found, or are refused.
///
/// Returns
/// -------
/// Embedding
///     Its ``parameters``, ``inside``, ``residual``, ``counts`` and ``complete``; ``at(cage)``.
///
/// Raises
/// ------
/// ShapeError, DomainError, DegenerateError
///     When dimensions do not fit; for points that are not finite, or outside and refused, and a
///     weight that vanishes in the window; for a cage of degree 0 along an axis.
///
/// Examples
/// --------
/// >>> cage = pf.Form([[(0, 0), (0, 1)], [(2, 0), (3, 3)]])
/// >>> pf.embed((1.1875, 0.75), cage).parameters
/// array([0.5  , 0.375])
#[pyfunction]
#[pyo3(
    signature = (points, cage, *, accuracy=None, outside="keep"),
    text_signature = "(points, cage, *, accuracy=1e-12, outside='keep')"
)]
pub(crate) fn embed(
    points: &Bound<'_, PyAny>,
    cage: &Bound<'_, PyAny>,
    accuracy: Option<&Bound<'_, PyAny>>,
    outside: &str,
) -> PyResult<PyEmbedding> {
    let numbers = Numbers::read("points", points)?;
    embedded(points.py(), &numbers, &shapes::read("cage", cage)?, accuracy, outside)
}

/// The default: far below what anything is built to, far above rounding.
const ACCURACY: f64 = 1e-12;

/// Multiplications for one point, about.
const COST: usize = 1 << 11;

/// Multiplications for a cage that is made ready, about.
const PREPARATION: usize = 1 << 20;

fn embedded(
    py: Python<'_>,
    points: &Numbers<'_>,
    cage: &Shape,
    accuracy: Option<&Bound<'_, PyAny>>,
    outside: &str,
) -> PyResult<PyEmbedding> {
    let accuracy = accuracy.map_or(Ok(ACCURACY), |given| real("accuracy", given))?;
    let outside = match outside {
        "keep" => Outside::Keep,
        "extend" => Outside::Extend,
        "error" => Outside::Refuse,
        other => {
            let expected = "\"keep\", \"extend\" or \"error\"";
            return fail(&Error::domain("outside", format!("{other:?}"), expected));
        }
    };
    let axes = cage.net().axes();
    let Some((_, shape)) = points.shape().split_last().filter(|(last, _)| **last == axes) else {
        let received = format!("an array of shape {:?}", points.shape());
        return fail(&Error::shape("points", received, format!("shape (…, {axes})")));
    };
    let embedder = done(py, PREPARATION, || Embedder::new(cage, accuracy, outside))?;
    let values = points.values();
    let mut all: Option<Embedding> = None;
    in_slices(py, values.len() / axes, COST, |range| {
        let part = embedder.embed(&values[range.start * axes..range.end * axes])?;
        match &mut all {
            None => all = Some(part),
            Some(all) => all.extend(part),
        }
        Ok(())
    })?;
    match all {
        Some(embedding) => Ok(PyEmbedding { embedding, shape: shape.to_vec() }),
        None => fail(&Error::shape("points", "none", "an array")),
    }
}

/// What lies in a cage follows it when it is bent.
///
/// Forms, splines and lists of them exactly, by an immersion; points, and the vertices of a mesh, by
/// their parameters in the cage at rest, as :func:`embed` finds them.
///
/// Parameters
/// ----------
/// object : Form, Spline, Immersed, Mesh, array_like of shape (…, c), or a list of forms and meshes
/// cage : Form or Spline
///     The bent cage, with as many parameters as the object has coordinates.
/// rest : pair of points, Form or Spline, optional
///     Two opposite corners of a box, or the cage at rest; without it coordinates are parameters.
///     For forms it must be a parallelepiped: from a bent cage only points can follow exactly.
/// accuracy, outside : optional
///     For points, as in :func:`embed`.
///
/// Returns
/// -------
/// The same kind as the object; a Spline if one of the two is.
///
/// Raises
/// ------
/// ShapeError, DomainError, DegenerateError, LimitError
///     When dimensions do not fit; for forms in a cage bent at rest; for a flat box; when poles are
///     too many.
///
/// Examples
/// --------
/// >>> box = [(0, 0), (4, 2)]
/// >>> sheared = pf.Form([[(0, 0), (1, 2)], [(4, 0), (5, 2)]])
/// >>> pf.deform(pf.Form([(0, 0), (4, 2)]), sheared, rest=box).poles
/// array([[0. , 0. ],
///        [2.5, 1. ],
///        [5. , 2. ]])
/// >>> pf.deform([(2.0, 1.0), (9.0, 1.0)], sheared, rest=box)
/// array([[2.5, 1. ],
///        [9. , 1. ]])
#[pyfunction]
#[pyo3(
    signature = (object, cage, *, rest=None, accuracy=None, outside="keep"),
    text_signature = "(object, cage, *, rest=None, accuracy=1e-12, outside='keep')"
)]
pub(crate) fn deform<'py>(
    object: &Bound<'py, PyAny>,
    cage: &Bound<'py, PyAny>,
    rest: Option<&Bound<'py, PyAny>>,
    accuracy: Option<&Bound<'py, PyAny>>,
    outside: &str,
) -> PyResult<Bound<'py, PyAny>> {
    let cage = shapes::read("cage", cage)?;
    let rest = match rest {
        None => Rest::Window,
        Some(given) => read_rest(given, cage.net().axes())?,
    };
    if outside != "keep" && (is_shape(object) || object.is_instance_of::<PyImmersed>()) {
        let expected = "\"keep\": a form is deformed whole, wherever its cage ends";
        return fail(&Error::domain("outside", format!("{outside:?}"), expected));
    }
    Deformation { cage, rest, accuracy, outside }.of(object)
}

/// A cage and where it rests.
struct Deformation<'a, 'py> {
    cage: Shape,
    rest: Rest,
    accuracy: Option<&'a Bound<'py, PyAny>>,
    outside: &'a str,
}

impl<'py> Deformation<'_, 'py> {
    fn of(&self, thing: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = thing.py();
        if is_shape(thing) {
            return object(py, self.bent(py, &shapes::read("object", thing)?)?);
        }
        if let Ok(lazy) = thing.cast::<PyImmersed>() {
            let immersed = &lazy.get().immersed;
            let form = done(py, usize::MAX, || immersed.expand())?;
            return object(py, self.bent(py, &form.into())?);
        }
        if thing.hasattr(intern!(py, "vertices"))? {
            return self.mesh(thing);
        }
        let listed = thing.is_instance_of::<PyList>() || thing.is_instance_of::<PyTuple>();
        let is_thing = |item: &Bound<'py, PyAny>| {
            is_shape(item)
                || item.is_instance_of::<PyImmersed>()
                || item.hasattr(intern!(py, "vertices")).unwrap_or(false)
        };
        if listed && thing.try_iter()?.any(|item| item.is_ok_and(|item| is_thing(&item))) {
            let moved =
                thing.try_iter()?.map(|item| self.of(&item?)).collect::<PyResult<Vec<_>>>()?;
            return PyList::new(py, moved)?.into_bound_py_any(py);
        }
        let points = Numbers::read("object", thing)
            .map_err(|_| mistyped("object", thing, "forms, a mesh or an array of points"))?;
        self.followed(py, &points)?.into_bound_py_any(py)
    }

    fn bent(&self, py: Python<'py>, object: &Shape) -> PyResult<Shape> {
        let work = bending_work(object, &self.cage)?;
        require_feasible("the deformation", work)?;
        let (cage, rest) = (&self.cage, &self.rest);
        done(py, usize::MAX, || operators::deform(object, cage, rest))
    }

    fn followed(
        &self,
        py: Python<'py>,
        points: &Numbers<'_>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let rest = self.rest.cage(&self.cage).map_err(|error| raised(&error))?;
        let found = embedded(py, points, &rest, self.accuracy, self.outside)?;
        let cost = self.cage.net().homogeneous().len().saturating_mul(found.embedding.len());
        let cage = &self.cage;
        filled(py, &found.shape, Some(cage.net().ambient()), None, |numbers| {
            done(py, cost, || found.embedding.at_into(cage, numbers))
        })
    }

    /// The same triangles between vertices that followed; normals have to be asked anew.
    fn mesh(&self, mesh: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = mesh.py();
        let vertices = mesh.getattr(intern!(py, "vertices"))?;
        let moved = self.followed(py, &Numbers::read("object", &vertices)?)?;
        let width = self.cage.net().ambient();
        let none = array(py, &[0, width], Vec::new())?;
        let Some(triangles) = mesh.getattr_opt(intern!(py, "triangles"))? else {
            return Err(mistyped("object", mesh, "a mesh with vertices and triangles"));
        };
        let class = py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Mesh"))?;
        class.call1((moved, none, triangles))
    }
}

/// Multiplications that an immersion of forms or splines takes, about.
pub(crate) fn bending_work(inner: &Shape, host: &Shape) -> PyResult<f64> {
    let pieces = |shape: &Shape| -> f64 {
        match shape {
            Shape::Form(_) => 1.0,
            Shape::Spline(spline) => spline.counts().iter().map(|n| *n as f64).product(),
        }
    };
    let first = |shape: &Shape| match shape {
        Shape::Form(form) => Ok(form.clone()),
        Shape::Spline(spline) => {
            spline.piece(&vec![0; spline.axes()]).map_err(|error| raised(&error))
        }
    };
    Ok(pieces(inner) * pieces(host) * immersion_work(&first(inner)?, &first(host)?))
}

/// Two corners, or a cage.
fn read_rest(given: &Bound<'_, PyAny>, axes: usize) -> PyResult<Rest> {
    if is_shape(given) {
        return Ok(Rest::Cage(shapes::read("rest", given)?));
    }
    let numbers = Numbers::read("rest", given)?;
    if *numbers.shape() != [2, axes] {
        let received = format!("an array of shape {:?}", numbers.shape());
        let expected = format!("two corners, shape (2, {axes}), or a cage");
        return fail(&Error::shape("rest", received, expected));
    }
    let (lower, upper) = numbers.values().split_at(axes);
    Ok(Rest::Box(lower.to_vec(), upper.to_vec()))
}

#[pymethods]
impl PyForm {
    /// The form in a bent cage, as :func:`deform`.
    ///
    /// >>> sheared = pf.Form([[(0, 0), (1, 2)], [(4, 0), (5, 2)]])
    /// >>> pf.Form([(0, 0), (1, 1)]).deform(sheared).poles[1]
    /// array([2.5, 1. ])
    #[pyo3(signature = (cage, *, rest=None))]
    fn deform<'py>(
        slf: &Bound<'py, Self>,
        cage: &Bound<'py, PyAny>,
        rest: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        deform(slf.as_any(), cage, rest, None, "keep")
    }
}

#[pymethods]
impl crate::spline::PySpline {
    /// The spline in a bent cage, as :func:`deform`.
    ///
    /// >>> sheared = pf.Form([[(0, 0), (1, 2)], [(4, 0), (5, 2)]])
    /// >>> pf.Form([(0, 0), (1, 1)]).subdivide(1).deform(sheared)
    /// <pforms.Spline of 2 pieces pL3 in 2D>
    #[pyo3(signature = (cage, *, rest=None))]
    fn deform<'py>(
        slf: &Bound<'py, Self>,
        cage: &Bound<'py, PyAny>,
        rest: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        deform(slf.as_any(), cage, rest, None, "keep")
    }
}
