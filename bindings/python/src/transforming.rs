//! Affine and projective maps of forms, splines, immersed forms, and of lists of them.

use pforms_kernel::{Form, Matrix, Result};
use pforms_operators::{self as operators, Poles, Rotation, Turn};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::PyList;

use crate::arguments::{real, reals, whole, wholes, word};
use crate::arrays::Numbers;
use crate::errors::{ShapeError, done, mistyped, raised};
use crate::form::PyForm;
use crate::immersed::PyImmersed;
use crate::spline::PySpline;

type Object<'py> = Bound<'py, PyAny>;

/// The image under a matrix that acts on homogeneous poles: any affine or projective map.
///
/// The matrix has ``c + 1`` columns for a form in ``c`` dimensions, the weight last; a last row
/// ``(0, …, 0, 1)`` makes it affine. With ``k + 1`` rows the image lies in ``k`` dimensions. Matrices
/// compose: ``pf.transform(f, b @ a)`` is ``f`` under ``a``, then under ``b``.
///
/// Parameters
/// ----------
/// form : Form, Spline, Immersed, or a sequence of them
///     Of an immersed form the host moves.
/// matrix : array_like, shape (k+1, c+1)
///
/// Returns
/// -------
/// The same kind of thing; a list for a sequence.
///
/// Raises
/// ------
/// ShapeError
///     When the columns are not as many as the homogeneous coordinates.
/// DomainError
///     For NaN, and when the result overflows.
///
/// Examples
/// --------
/// >>> pf.transform(pf.Form([(0, 0), (1, 2)]), [[0, 1, 0], [1, 0, 0], [0, 0, 1]]).poles
/// array([[0., 0.],
///        [2., 1.]])
#[pyfunction]
#[pyo3(signature = (form, matrix))]
pub(crate) fn transform<'py>(form: &Object<'py>, matrix: &Object<'py>) -> PyResult<Object<'py>> {
    let numbers = Numbers::read("matrix", matrix)?;
    let [_, columns] = *numbers.shape() else {
        let shape = numbers.shape();
        let message = format!("matrix: received an array of shape {shape:?}, expected two axes");
        return Err(ShapeError::new_err(message));
    };
    let rows = numbers.values().chunks(columns.max(1)).map(<[f64]>::to_vec).collect();
    let matrix = Matrix::from_rows(rows).map_err(|error| raised(&error))?;
    moved(form, &|net| operators::transform(net, &matrix))
}

/// The form moved by a vector; directions (weight 0) stay. Exact.
///
/// Parameters
/// ----------
/// form : Form, Spline, Immersed, or a sequence of them
/// by : sequence of float
///     One for each coordinate.
///
/// Raises
/// ------
/// ShapeError, DomainError
///     When their number is another; for NaN.
///
/// Examples
/// --------
/// >>> pf.translate(pf.Form([(0, 0), (1, 2)]), (3, 0)).poles
/// array([[3., 0.],
///        [4., 2.]])
#[pyfunction]
#[pyo3(signature = (form, by))]
pub(crate) fn translate<'py>(form: &Object<'py>, by: &Object<'py>) -> PyResult<Object<'py>> {
    let by = reals("by", by, 1)?;
    moved(form, &|net| operators::translate(net, &by))
}

/// The form turned by an angle.
///
/// In 2D from x toward y; in 3D about an axis, z unless given, counter-clockwise as seen from its tip;
/// in any dimension in a plane of two coordinates. Three angles are the book's: about x, then about
/// y **from x toward z** (against the usual sense), then about z.
///
/// Parameters
/// ----------
/// form : Form, Spline, Immersed, or a sequence of them
/// angle : float or three floats
/// axis : sequence of 3 floats, optional
///     The direction that stays, of any length.
/// centre : sequence of float, optional
///     The point that stays; the origin if absent.
/// plane : pair of int, optional
///     From the first coordinate toward the second; ``(0, 1)`` is from x toward y.
/// unit : "radians", "degrees" or "half tangent", optional
///     What angles are counted in. Multiples of 90 degrees are exact; the tangent ``t`` of half an
///     angle gives cosine ``(1-t*t)/(1+t*t)`` and sine ``2*t/(1+t*t)``.
///
/// Raises
/// ------
/// ShapeError
///     For an axis that is not in 3D, a plane that is none, no plane beyond 3D.
/// DegenerateError, DomainError
///     For an axis of length 0; for NaN.
///
/// Examples
/// --------
/// >>> pf.rotate(pf.Form([(1, 0), (2, 0)]), 90, unit="degrees").poles
/// array([[0., 1.],
///        [0., 2.]])
#[pyfunction]
#[pyo3(
    signature = (form, angle, axis=None, *, centre=None, plane=None, unit=None),
    text_signature = "(form, angle, axis=None, *, centre=None, plane=None, unit='radians')"
)]
pub(crate) fn rotate<'py>(
    form: &Object<'py>,
    angle: &Object<'py>,
    axis: Option<&Object<'py>>,
    centre: Option<&Object<'py>>,
    plane: Option<&Object<'py>>,
    unit: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let unit = unit.map_or(Ok("radians"), |unit| word("unit", unit, &UNITS))?;
    let rotation = match (&reals("angle", angle, 1)?[..], axis, plane) {
        ([x, y, z], None, None) => {
            Some(Rotation::Book([turn(*x, unit)?, turn(*y, unit)?, turn(*z, unit)?]))
        }
        ([one], Some(axis), None) => {
            let (axis, turn) = (reals("axis", axis, 1)?, turn(*one, unit)?);
            Some(Rotation::about(&axis, turn).map_err(|error| raised(&error))?)
        }
        ([one], None, Some(plane)) => {
            let [from, to] = wholes("plane", plane, 1)?[..] else {
                return Err(mistyped("plane", plane, "two coordinates"));
            };
            Some(Rotation::Plane(from, to, turn(*one, unit)?))
        }
        ([one], None, None) => Some(Rotation::Plane(0, 1, turn(*one, unit)?)),
        _ => None,
    };
    let Some(rotation) = rotation else {
        return Err(ShapeError::new_err(
            "angle: expected one angle with an axis or a plane, or three with neither",
        ));
    };
    let centre = centre.map(|centre| reals("centre", centre, 1)).transpose()?;
    let given = axis.is_some() || plane.is_some();
    moved(form, &|net| {
        if !given && net.ambient() > 3 {
            let expected = format!("two coordinates in {}D", net.ambient());
            return Err(pforms_kernel::Error::shape("plane", "nothing", expected));
        }
        operators::rotate(net, &rotation, &or_origin(centre.as_deref(), net))
    })
}

const UNITS: [&str; 3] = ["radians", "degrees", "half tangent"];

fn turn(angle: f64, unit: &str) -> PyResult<Turn> {
    let turn = match unit {
        "degrees" => Turn::degrees(angle),
        "half tangent" => Turn::half_tangent(&angle),
        _ => Turn::radians(angle),
    };
    turn.map_err(|error| raised(&error))
}

/// The form with its coordinates multiplied, counted from a centre.
///
/// Parameters
/// ----------
/// form : Form, Spline, Immersed, or a sequence of them
/// factors : float or sequence of float
///     For all coordinates, or one for each. Negative ones mirror, 0 flattens.
/// centre : sequence of float, optional
///     The point that stays; the origin if absent.
///
/// Raises
/// ------
/// ShapeError, DomainError
///     When their number is another; for NaN.
///
/// Examples
/// --------
/// >>> pf.scale(pf.Form([(0, 0), (1, 2)]), (0.5, 1), centre=(1, 0)).poles
/// array([[0.5, 0. ],
///        [1. , 2. ]])
#[pyfunction]
#[pyo3(signature = (form, factors, *, centre=None))]
pub(crate) fn scale<'py>(
    form: &Object<'py>,
    factors: &Object<'py>,
    centre: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let numbers = Numbers::read("factors", factors)?;
    let one = if numbers.shape().is_empty() { Some(real("factors", factors)?) } else { None };
    let list = reals("factors", factors, 1)?;
    let centre = centre.map(|centre| reals("centre", centre, 1)).transpose()?;
    moved(form, &|net| {
        let all = one.map_or_else(|| list.clone(), |factor| vec![factor; net.ambient()]);
        operators::scale(net, &all, &or_origin(centre.as_deref(), net))
    })
}

/// The form with every point moved by ``by`` times one of its coordinates: layers slide.
///
/// Parameters
/// ----------
/// form : Form, Spline, Immersed, or a sequence of them
/// coordinate : int
///     0 is x, 1 is y, 2 is z.
/// by : sequence of float
///     How far a layer slides for each unit of that coordinate; 0 along it.
/// centre : sequence of float, optional
///     A point of the layer that stays; the origin if absent.
///
/// Raises
/// ------
/// ShapeError
///     When there is no such coordinate, or another number of them.
/// DomainError
///     When ``by`` has something along the coordinate; for NaN.
///
/// Examples
/// --------
/// >>> pf.shear(pf.Form([(0, 0), (1, 2)]), 1, (0.25, 0)).poles
/// array([[0. , 0. ],
///        [1.5, 2. ]])
#[pyfunction]
#[pyo3(signature = (form, coordinate, by, *, centre=None))]
pub(crate) fn shear<'py>(
    form: &Object<'py>,
    coordinate: &Object<'py>,
    by: &Object<'py>,
    centre: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let (coordinate, by) = (whole("coordinate", coordinate)?, reals("by", by, 1)?);
    let centre = centre.map(|centre| reals("centre", centre, 1)).transpose()?;
    moved(form, &|net| operators::shear(net, coordinate, &by, &or_origin(centre.as_deref(), net)))
}

/// The form seen in the mirror at right angles to a direction: in 2D a line, in 3D a plane.
///
/// Parameters
/// ----------
/// form : Form, Spline, Immersed, or a sequence of them
/// normal : sequence of float
///     Of any length.
/// origin : sequence of float, optional
///     A point of the mirror.
///
/// Raises
/// ------
/// ShapeError, DegenerateError, DomainError
///     For another number of coordinates, a normal of length 0, NaN.
///
/// Examples
/// --------
/// >>> pf.mirror(pf.Form([(0, 0), (1, 2)]), (0, 1), origin=(0, 1)).poles
/// array([[0., 2.],
///        [1., 0.]])
#[pyfunction]
#[pyo3(signature = (form, normal, *, origin=None))]
pub(crate) fn mirror<'py>(
    form: &Object<'py>,
    normal: &Object<'py>,
    origin: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let normal = reals("normal", normal, 1)?;
    let origin = origin.map(|origin| reals("origin", origin, 1)).transpose()?;
    moved(form, &|net| operators::mirror(net, &normal, &or_origin(origin.as_deref(), net)))
}

/// The shadow of a form on a plane: orthogonal, by parallel rays, or from a lamp.
///
/// Exact. A central shadow changes the weights: that of a parabola may be any conic.
///
/// Parameters
/// ----------
/// form : Form, Spline, Immersed, or a sequence of them
/// normal : sequence of float
///     Of the plane, of any length.
/// origin : sequence of float, optional
///     A point of the plane.
/// direction : sequence of float, optional
///     Of parallel rays; the normal if absent.
/// lamp : sequence of float, optional
///     The point that rays come from, in place of a direction.
///
/// Raises
/// ------
/// ShapeError
///     For another number of coordinates, or both a direction and a lamp.
/// DegenerateError
///     For a normal of length 0, a lamp on the plane, rays along it.
///
/// Examples
/// --------
/// >>> above = pf.Form([(0, 0, 1), (1, 0, 2)])
/// >>> pf.project_to_plane(above, (0, 0, 1), lamp=(0, 0, 4)).poles
/// array([[0., 0., 0.],
///        [2., 0., 0.]])
#[pyfunction]
#[pyo3(signature = (form, normal, *, origin=None, direction=None, lamp=None))]
pub(crate) fn project_to_plane<'py>(
    form: &Object<'py>,
    normal: &Object<'py>,
    origin: Option<&Object<'py>>,
    direction: Option<&Object<'py>>,
    lamp: Option<&Object<'py>>,
) -> PyResult<Object<'py>> {
    let normal = reals("normal", normal, 1)?;
    let origin = origin.map(|origin| reals("origin", origin, 1)).transpose()?;
    let (mut from, weight) = match (direction, lamp) {
        (Some(_), Some(lamp)) => return Err(mistyped("lamp", lamp, "no lamp with a direction")),
        (None, Some(lamp)) => (reals("lamp", lamp, 1)?, 1.0),
        (Some(direction), None) => (reals("direction", direction, 1)?, 0.0),
        (None, None) => (normal.clone(), 0.0),
    };
    from.push(weight);
    moved(form, &|net| {
        operators::project_to_plane(net, &normal, &or_origin(origin.as_deref(), net), &from)
    })
}

fn or_origin(point: Option<&[f64]>, net: &Form) -> Vec<f64> {
    point.map_or_else(|| vec![0.0; net.ambient()], <[f64]>::to_vec)
}

/// Acts on the poles of a form or a spline, on those of the host of an immersed form, on each of a
/// list.
fn moved<'py>(
    object: &Object<'py>,
    act: &(dyn Fn(&Form) -> Result<Form> + Sync),
) -> PyResult<Object<'py>> {
    if let Some(moved) = one(object, act)? {
        return Ok(moved);
    }
    let Ok(items) = object.try_iter() else {
        return Err(mistyped("form", object, &format!("{ONE}, or a list of them")));
    };
    let each = |item: PyResult<Object<'py>>| {
        let item = item?;
        one(&item, act)?.ok_or_else(|| mistyped("form", &item, ONE))
    };
    Ok(PyList::new(object.py(), items.map(each).collect::<PyResult<Vec<_>>>()?)?.into_any())
}

const ONE: &str = "a pforms.Form, a Spline or an Immersed";

fn one<'py>(
    object: &Object<'py>,
    act: &(dyn Fn(&Form) -> Result<Form> + Sync),
) -> PyResult<Option<Object<'py>>> {
    if let Ok(form) = object.cast::<PyForm>() {
        return carried(object, &form.get().form, act, PyForm::from).map(Some);
    }
    if let Ok(spline) = object.cast::<PySpline>() {
        return carried(object, &spline.get().spline, act, PySpline::from).map(Some);
    }
    if let Ok(lazy) = object.cast::<PyImmersed>() {
        return carried(object, &lazy.get().immersed, act, PyImmersed::from).map(Some);
    }
    Ok(None)
}

fn carried<'py, P: Poles<f64> + Send + Sync, C: IntoPyObjectExt<'py>>(
    object: &Object<'py>,
    thing: &P,
    act: &(dyn Fn(&Form) -> Result<Form> + Sync),
    wrap: impl FnOnce(P) -> C,
) -> PyResult<Object<'py>> {
    let cost = thing.net().homogeneous().len() * thing.net().width();
    let moved = done(object.py(), cost, || thing.with_net(act(thing.net())?))?;
    wrap(moved).into_bound_py_any(object.py())
}

/// The functions of this file as methods.
macro_rules! methods {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The image under a matrix: :func:`pforms.transform`.
            ///
            /// >>> pf.Form([(1, 2)]).transform([[0, 1, 0], [1, 0, 0], [0, 0, 1]]).poles
            /// array([[2., 1.]])
            #[pyo3(name = "transform", signature = (matrix))]
            fn transformed<'py>(
                slf: &Bound<'py, Self>,
                matrix: &Object<'py>,
            ) -> PyResult<Object<'py>> {
                transform(slf.as_any(), matrix)
            }

            /// The same moved by a vector: :func:`pforms.translate`.
            ///
            /// >>> pf.Form([(0, 0), (1, 2)]).translate((3, 0)).poles
            /// array([[3., 0.],
            ///        [4., 2.]])
            #[pyo3(name = "translate", signature = (by))]
            fn translated<'py>(slf: &Bound<'py, Self>, by: &Object<'py>) -> PyResult<Object<'py>> {
                translate(slf.as_any(), by)
            }

            /// The same turned by an angle: :func:`pforms.rotate`.
            ///
            /// >>> pf.Form([(1, 0), (2, 0)]).rotate(90, unit="degrees").poles
            /// array([[0., 1.],
            ///        [0., 2.]])
            #[pyo3(name = "rotate")]
            #[pyo3(signature = (angle, axis=None, *, centre=None, plane=None, unit=None))]
            #[pyo3(text_signature = "($self, angle, axis=None, *, centre=None, plane=None, unit='radians')")]
            fn rotated<'py>(
                slf: &Bound<'py, Self>,
                angle: &Object<'py>,
                axis: Option<&Object<'py>>,
                centre: Option<&Object<'py>>,
                plane: Option<&Object<'py>>,
                unit: Option<&Object<'py>>,
            ) -> PyResult<Object<'py>> {
                rotate(slf.as_any(), angle, axis, centre, plane, unit)
            }

            /// The same with its coordinates multiplied: :func:`pforms.scale`.
            ///
            /// >>> pf.Form([(0, 0), (1, 2)]).scale((0.5, 1), centre=(1, 0)).poles
            /// array([[0.5, 0. ],
            ///        [1. , 2. ]])
            #[pyo3(name = "scale", signature = (factors, *, centre=None))]
            fn scaled<'py>(
                slf: &Bound<'py, Self>,
                factors: &Object<'py>,
                centre: Option<&Object<'py>>,
            ) -> PyResult<Object<'py>> {
                scale(slf.as_any(), factors, centre)
            }

            /// The same with its layers slid over one another: :func:`pforms.shear`.
            ///
            /// >>> pf.Form([(0, 0), (1, 2)]).shear(1, (0.25, 0)).poles
            /// array([[0. , 0. ],
            ///        [1.5, 2. ]])
            #[pyo3(name = "shear", signature = (coordinate, by, *, centre=None))]
            fn sheared<'py>(
                slf: &Bound<'py, Self>,
                coordinate: &Object<'py>,
                by: &Object<'py>,
                centre: Option<&Object<'py>>,
            ) -> PyResult<Object<'py>> {
                shear(slf.as_any(), coordinate, by, centre)
            }

            /// The same in a mirror: :func:`pforms.mirror`.
            ///
            /// >>> pf.Form([(0, 0), (1, 2)]).mirror((0, 1), origin=(0, 1)).poles
            /// array([[0., 2.],
            ///        [1., 0.]])
            #[pyo3(name = "mirror", signature = (normal, *, origin=None))]
            fn mirrored<'py>(
                slf: &Bound<'py, Self>,
                normal: &Object<'py>,
                origin: Option<&Object<'py>>,
            ) -> PyResult<Object<'py>> {
                mirror(slf.as_any(), normal, origin)
            }

            /// The shadow on a plane: :func:`pforms.project_to_plane`.
            ///
            /// >>> pf.Form([(0, 0, 1), (1, 0, 2)]).project_to_plane((0, 0, 1)).poles
            /// array([[0., 0., 0.],
            ///        [1., 0., 0.]])
            #[pyo3(name = "project_to_plane")]
            #[pyo3(signature = (normal, *, origin=None, direction=None, lamp=None))]
            fn projected_to_plane<'py>(
                slf: &Bound<'py, Self>,
                normal: &Object<'py>,
                origin: Option<&Object<'py>>,
                direction: Option<&Object<'py>>,
                lamp: Option<&Object<'py>>,
            ) -> PyResult<Object<'py>> {
                project_to_plane(slf.as_any(), normal, origin, direction, lamp)
            }
        }
    };
}

methods!(PyForm);
methods!(PySpline);
methods!(PyImmersed);
