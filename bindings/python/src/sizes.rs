//! Areas, volumes, centres, inertia, boxes; Jacobians, folds, slices.

use pforms_mesh::{Mesh, mesh_area, mesh_box, mesh_mass, mesh_volume};
use pforms_operators::{self as operators, Folding, Mass, Measure, Shape};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use crate::arguments::{axis_number, real, truth};
use crate::arrays::Numbers;
use crate::errors::{done, raised};
use crate::joining::{read_report, record};
use crate::outputs::array;
use crate::{meshes, shapes};

type Object<'py> = Bound<'py, PyAny>;

/// What is measured: forms and splines, or meshes.
enum Things {
    Shapes(Vec<Shape>),
    Meshes(Vec<Mesh>),
}

/// What is measured, and how well.
fn read(forms: &Bound<'_, PyTuple>, accuracy: Option<&Object<'_>>) -> PyResult<(Things, f64)> {
    let all = match meshes::several("forms", forms)? {
        Some(meshes) => Things::Meshes(meshes),
        None => Things::Shapes(shapes::read_several("forms", forms)?),
    };
    Ok((all, accuracy.map_or(Ok(1e-12), |given| real("accuracy", given))?))
}

fn mass_of(all: &Things, filled: bool, accuracy: f64) -> pforms_kernel::Result<Mass> {
    match all {
        Things::Shapes(all) => operators::mass(all, filled, accuracy),
        Things::Meshes(all) => mesh_mass(all, filled),
    }
}

fn is_true(name: &str, given: Option<&Object<'_>>) -> PyResult<bool> {
    given.map_or(Ok(false), |given| truth(name, given))
}

fn measured<'py>(
    py: Python<'py>,
    report: Option<&Object<'py>>,
    job: impl FnOnce() -> pforms_kernel::Result<Measure> + Send,
) -> PyResult<Object<'py>> {
    let report = read_report(report)?;
    let Measure { value, error } = done(py, usize::MAX, job)?;
    if report { record(py, "Measure", (value, error)) } else { value.into_bound_py_any(py) }
}

/// The area of surfaces, added up, or what closed curves in the plane enclose.
///
/// In any dimension, with a proved bound of the error. Without sign: what is folded over counts as
/// often as it covers.
///
/// Parameters
/// ----------
/// *forms : Form or Spline, or Mesh
///     One by one, or in a list; meshes by sums over their triangles.
/// signed : bool, optional
///     The integral of the determinant, for forms in the plane.
/// accuracy : float, optional
///     Relative to the area.
/// report : bool, optional
///     Return a :class:`Measure` of ``value`` and ``error``.
///
/// Raises
/// ------
/// ShapeError, DomainError
///     For what is no surface; for one that goes to infinity.
/// DegenerateError
///     When curves do not close up.
/// AccuracyError
///     When the accuracy cannot be had.
///
/// Examples
/// --------
/// >>> hypar = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
/// >>> round(pf.area(hypar), 12)
/// 1.280789275273
/// >>> abs(pf.area(pf.torus(3, 1)) / np.pi**2 - 12) < 1e-11
/// True
#[pyfunction]
#[pyo3(
    signature = (*forms, signed=None, accuracy=None, report=None),
    text_signature = "(*forms, signed=False, accuracy=1e-12, report=False)"
)]
pub(crate) fn area<'py>(
    py: Python<'py>,
    forms: &Bound<'py, PyTuple>,
    signed: Option<&Object<'py>>,
    accuracy: Option<&Object<'py>>,
    report: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let (all, accuracy) = read(forms, accuracy)?;
    let signed = is_true("signed", signed)?;
    measured(py, report, move || match (all, signed) {
        (Things::Meshes(all), _) => mesh_area(&all),
        (Things::Shapes(all), true) => operators::signed_area(&all, accuracy),
        (Things::Shapes(all), false) => operators::area(&all, accuracy),
    })
}

/// The volume of forms, added up, or of what a closed shell of surfaces encloses.
///
/// Forms with three axes or more: what they fill. Surfaces in space have to close up, in any order and
/// either way round. The error is proved.
///
/// Parameters
/// ----------
/// *forms : Form or Spline, or Mesh
///     One by one, or in a list; meshes by sums over their triangles.
/// signed : bool, optional
///     The integral of the determinant; of a shell, positive where the normal of the first patch
///     points outwards.
/// accuracy : float, optional
///     Relative to the volume.
/// report : bool, optional
///     Return a :class:`Measure` of ``value`` and ``error``.
///
/// Raises
/// ------
/// ShapeError, DomainError
///     For curves in space; for forms that go to infinity.
/// DegenerateError
///     For a shell or a mesh that is open, naming a border, or one-sided.
/// AccuracyError
///     When the accuracy cannot be had.
///
/// Examples
/// --------
/// >>> ball = pf.sphere(1)
/// >>> abs(pf.volume(ball) - 4 / 3 * np.pi) < 1e-12
/// True
/// >>> pf.volume(pf.sphere(1, part="half"))  # doctest: +ELLIPSIS
/// Traceback (most recent call last):
/// pforms.DegenerateError: patches: received an open border: ...
#[pyfunction]
#[pyo3(
    signature = (*forms, signed=None, accuracy=None, report=None),
    text_signature = "(*forms, signed=False, accuracy=1e-12, report=False)"
)]
pub(crate) fn volume<'py>(
    py: Python<'py>,
    forms: &Bound<'py, PyTuple>,
    signed: Option<&Object<'py>>,
    accuracy: Option<&Object<'py>>,
    report: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let (all, accuracy) = read(forms, accuracy)?;
    let signed = is_true("signed", signed)?;
    measured(py, report, move || match all {
        Things::Meshes(all) => mesh_volume(&all, signed),
        Things::Shapes(all) => operators::volume(&all, signed, accuracy),
    })
}

/// The centre of mass of curves, surfaces or solids of density 1, taken together.
///
/// Parameters
/// ----------
/// *forms : Form or Spline, or Mesh
///     One by one, or in a list; meshes by sums over their triangles.
/// filled : bool, optional
///     Take closed curves of the plane and closed surfaces for what they enclose.
/// accuracy : float, optional
///
/// Returns
/// -------
/// ndarray, shape (c,)
///
/// Raises
/// ------
/// DegenerateError
///     When there is no mass; as :func:`volume`.
/// ShapeError, DomainError, AccuracyError
///
/// Examples
/// --------
/// >>> half = pf.sphere(1, part="half")  # a shell: its centre is half way up
/// >>> np.abs(pf.centroid(half) - [0, 0.5, 0]).max() < 1e-12
/// np.True_
#[pyfunction]
#[pyo3(
    signature = (*forms, filled=None, accuracy=None),
    text_signature = "(*forms, filled=False, accuracy=1e-12)"
)]
pub(crate) fn centroid<'py>(
    py: Python<'py>,
    forms: &Bound<'py, PyTuple>,
    filled: Option<&Object<'py>>,
    accuracy: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let (all, accuracy) = read(forms, accuracy)?;
    let filled = is_true("filled", filled)?;
    let mass = done(py, usize::MAX, move || mass_of(&all, filled, accuracy))?;
    Ok(array(py, &[mass.centroid.len()], mass.centroid)?.into_any())
}

/// Measure, centre, tensor of inertia and principal axes, of density 1.
///
/// Parameters
/// ----------
/// *forms : Form or Spline, or Mesh
///     One by one, or in a list; meshes by sums over their triangles.
/// filled : bool, optional
///     Take closed curves of the plane and closed surfaces for what they enclose.
/// accuracy : float, optional
///
/// Returns
/// -------
/// Inertia
///     ``measure``, ``centroid`` and their errors, ``tensor`` about the centre, ``moments`` about the
///     principal ``axes``, and ``error`` of tensor and moments.
///
/// Raises
/// ------
/// DegenerateError
///     When there is no mass; as :func:`volume`.
/// ShapeError, DomainError, AccuracyError
///
/// Examples
/// --------
/// >>> plate = pf.Form([[(0, 0), (0, 1)], [(2, 0), (2, 1)]])
/// >>> pf.inertia(plate).moments.round(12)
/// array([0.16666667, 0.66666667])
#[pyfunction]
#[pyo3(
    signature = (*forms, filled=None, accuracy=None),
    text_signature = "(*forms, filled=False, accuracy=1e-12)"
)]
pub(crate) fn inertia<'py>(
    py: Python<'py>,
    forms: &Bound<'py, PyTuple>,
    filled: Option<&Object<'py>>,
    accuracy: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let (all, accuracy) = read(forms, accuracy)?;
    let filled = is_true("filled", filled)?;
    let mass = done(py, usize::MAX, move || mass_of(&all, filled, accuracy))?;
    let size = mass.centroid.len();
    let fields = (
        mass.measure.value,
        mass.measure.error,
        array(py, &[size], mass.centroid)?,
        mass.centroid_error,
        array(py, &[size, size], mass.inertia)?,
        array(py, &[size], mass.moments)?,
        array(py, &[size, size], mass.axes)?,
        mass.inertia_error,
    );
    record(py, "Inertia", fields)
}

/// The least box around forms, its sides along the axes of space: around points, not poles.
///
/// Parameters
/// ----------
/// *forms : Form or Spline, or Mesh
///     One by one, or in a list; meshes by sums over their triangles.
/// accuracy : float, optional
///     In sizes of the whole.
///
/// Returns
/// -------
/// Box
///     ``lower`` and ``upper``, outside of which there is nothing; ``error``, by which each face is
///     farther out than some point, at most; ``lowest`` and ``highest``, for each coordinate the number
///     of a form and the parameters of such a point; of a mesh, the number of its vertex.
///
/// Raises
/// ------
/// ShapeError, DomainError, AccuracyError
///     For different dimensions; for forms that go to infinity; when the accuracy cannot be had.
///
/// Examples
/// --------
/// >>> arch = pf.box(pf.Form([(0, 0), (1, 2), (2, 0)]))
/// >>> arch.upper.round(12), arch.highest[1]
/// (array([2., 1.]), (0, (0.5,)))
#[pyfunction]
#[pyo3(
    name = "box",
    signature = (*forms, accuracy=None),
    text_signature = "(*forms, accuracy=1e-12)"
)]
pub(crate) fn bounding_box<'py>(
    py: Python<'py>,
    forms: &Bound<'py, PyTuple>,
    accuracy: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let (all, accuracy) = read(forms, accuracy)?;
    let found = done(py, usize::MAX, move || match all {
        Things::Meshes(all) => mesh_box(&all),
        Things::Shapes(all) => operators::bounding_box(&all, accuracy),
    })?;
    let places = |list: Vec<(usize, Vec<f64>)>| -> PyResult<Bound<'py, PyTuple>> {
        let place = |(number, at): (usize, Vec<f64>)| -> PyResult<Object<'py>> {
            (number, PyTuple::new(py, at)?).into_bound_py_any(py)
        };
        PyTuple::new(py, list.into_iter().map(place).collect::<PyResult<Vec<_>>>()?)
    };
    let size = found.lower.len();
    let fields = (
        array(py, &[size], found.lower)?,
        array(py, &[size], found.upper)?,
        found.error,
        places(found.lowest)?,
        places(found.highest)?,
    );
    record(py, "Box", fields)
}

/// The Jacobian determinant of a form with as many axes as coordinates: a form in dimension 1, exact.
///
/// Of degrees d·n − 1; of a rational form (d + 1)·n. Of a spline a spline, with gaps where the
/// derivatives may jump.
///
/// Raises ShapeError for other forms, DegenerateError at infinity, LimitError.
///
/// >>> drawn = pf.Form([[(0, 0), (0, 1)], [(1, 0), (2, 2)]])
/// >>> pf.jacobian(drawn).poles[..., 0]
/// array([[1., 2.],
///        [2., 3.]])
#[pyfunction]
#[pyo3(signature = (form), text_signature = "(form)")]
pub(crate) fn jacobian<'py>(form: &Object<'py>) -> PyResult<Object<'py>> {
    let shape = shapes::read("form", form)?;
    let found = done(form.py(), usize::MAX, || operators::jacobian_shape(&shape))?;
    shapes::object(form.py(), found)
}

/// Is it proved that a form does not fold over?
///
/// ``True`` is a proof that its Jacobian determinant has one sign, ``False`` that it has both, ``None``
/// that it is so near 0 somewhere that nothing is proved.
///
/// Parameters
/// ----------
/// form : Form or Spline
///     With as many axes as coordinates.
/// accuracy : float, optional
///     Determinants that are smaller, relative to their mean, stay open.
/// report : bool, optional
///     Return a :class:`Folds`: where it has which sign, and more.
///
/// Raises
/// ------
/// ShapeError, DomainError
///     For other forms; for forms that go to infinity.
///
/// Examples
/// --------
/// >>> def drawn(x):
/// ...     return pf.Form([[(0, 0), (0, 1)], [(1, 0), (x, x)]])
/// >>> pf.is_injective(drawn(1)), pf.is_injective(drawn(0.4))
/// (True, False)
#[pyfunction]
#[pyo3(
    signature = (form, *, accuracy=None, report=None),
    text_signature = "(form, *, accuracy=1e-9, report=False)"
)]
pub(crate) fn is_injective<'py>(
    form: &Object<'py>,
    accuracy: Option<&Object<'py>>,
    report: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let py = form.py();
    let shape = shapes::read("form", form)?;
    let accuracy = accuracy.map_or(Ok(1e-9), |given| real("accuracy", given))?;
    let report = read_report(report)?;
    let found = done(py, usize::MAX, || operators::folds(&shape, accuracy))?;
    if !report {
        return match found.answer {
            Folding::None => true.into_bound_py_any(py),
            Folding::Folds => false.into_bound_py_any(py),
            Folding::Undecided => Ok(py.None().into_bound(py)),
        };
    }
    let place = |at: Option<Vec<f64>>| at.map(|at| PyTuple::new(py, at)).transpose();
    let corner = |at: &Vec<f64>| PyTuple::new(py, at);
    let boxes =
        found.undecided.iter().map(|[low, high]| (corner(low)?, corner(high)?).into_pyobject(py));
    let fields = (
        found.answer.name(),
        place(found.positive)?,
        place(found.negative)?,
        PyTuple::new(py, boxes.collect::<PyResult<Vec<_>>>()?)?,
        found.regular,
        found.injective,
    );
    record(py, "Folds", fields)
}

/// The form where parameter ``axis`` is ``t``, one axis less: a frame of a film, one of many designs.
///
/// As :meth:`Form.sub`; of several ``t`` a list. Raises ShapeError when there is no such axis, DomainError
/// for NaN.
///
/// >>> film = pf.stack(pf.Form([(0, 0), (1, 0)]), pf.Form([(0, 2), (1, 4)]))
/// >>> [frame.poles.tolist() for frame in pf.slice(film, 0, [0.5, 1])]
/// [[[0.0, 1.0], [1.0, 2.0]], [[0.0, 2.0], [1.0, 4.0]]]
#[pyfunction]
#[pyo3(signature = (form, axis, t), text_signature = "(form, axis, t)")]
pub(crate) fn slice<'py>(
    form: &Object<'py>,
    axis: &Object<'py>,
    t: &Object<'py>,
) -> PyResult<Object<'py>> {
    let py = form.py();
    let shape = shapes::read("form", form)?;
    let axis = axis_number(Some(axis))?;
    let at = |t: f64| -> PyResult<Object<'py>> {
        let frame = match &shape {
            Shape::Form(form) => operators::sub(form, axis, &t).map(Shape::Form),
            Shape::Spline(spline) => spline.sub(axis, &t).map(Shape::from),
        };
        shapes::object(py, frame.map_err(|error| raised(&error))?)
    };
    let times = Numbers::read("t", t)?;
    match (times.shape(), times.values()) {
        ([], [t]) => at(*t),
        (_, all) => {
            let frames = all.iter().map(|t| at(*t)).collect::<PyResult<Vec<_>>>()?;
            Ok(PyList::new(py, frames)?.into_any())
        }
    }
}
