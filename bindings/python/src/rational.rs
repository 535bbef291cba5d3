//! Rational forms: conics, circles, quadrics, tori; and polynomial patches near them.

use pforms_kernel::{Error, Form};
use pforms_operators::{self as operators, Bicubic, Part, Shape};
use pyo3::prelude::*;
use pyo3::{IntoPyObjectExt, intern};

use crate::arguments::{real, whole};
use crate::errors::{done, fail, mistyped};
use crate::form::PyForm;
use crate::shapes::{self, object};
use crate::spline::PySpline;

/// Multiplications of a few poles: not worth giving the lock away.
const LITTLE: usize = 0;

/// The conic from ``p0`` to ``p2`` whose tangents there meet in ``p1``, which gets the weight ``w``.
///
/// Below 1 it is an arc of an ellipse, at 1 of a parabola, above of a hyperbola; 0 leaves the chord,
/// a negative weight takes the complementary arc. Exact.
///
/// Parameters
/// ----------
/// p0, p1, p2 : Form or array_like
///     Points, ``p1`` maybe a direction; or forms of one number of axes, between which the conic is a
///     new axis 0.
/// w : float, optional
///
/// Raises
/// ------
/// ShapeError, DomainError
///     When axes or spaces differ; when the weight is not finite.
///
/// Examples
/// --------
/// >>> arc = pf.conic((1, 0), (1, 1), (0, 1), 0.5**0.5)
/// >>> np.hypot(*arc(0.3)).round(15)
/// np.float64(1.0)
#[pyfunction]
#[pyo3(signature = (p0, p1, p2, w=None), text_signature = "(p0, p1, p2, w=1.0)")]
pub(crate) fn conic(
    p0: &Bound<'_, PyAny>,
    p1: &Bound<'_, PyAny>,
    p2: &Bound<'_, PyAny>,
    w: Option<&Bound<'_, PyAny>>,
) -> PyResult<PyForm> {
    let forms = [plain("p0", p0)?, plain("p1", p1)?, plain("p2", p2)?];
    let w = w.map_or(Ok(1.0), |w| real("w", w))?;
    let [a, b, c] = &forms;
    done(p0.py(), a.homogeneous().len(), || operators::conic(a, b, c, &w)).map(PyForm::from)
}

/// A form or an array of its poles, but no spline.
fn plain(argument: &str, given: &Bound<'_, PyAny>) -> PyResult<Form> {
    match shapes::read(argument, given)? {
        Shape::Form(form) => Ok(form),
        Shape::Spline(_) => Err(mistyped(argument, given, "a pforms.Form or an array")),
    }
}

/// An arc of a circle round the origin, in the plane Oxy, from x towards y.
///
/// One form as long as that is well conditioned, up to 120, 180 and 270 degrees for the orders 3, 4
/// and 5; beyond, a spline of equal pieces. Exact but for four roundings.
///
/// Parameters
/// ----------
/// radius : float
/// angle : float
///     In radians, any number of turns; negative turns back.
/// order : 3, 4 or 5, optional
///     Poles of every piece.
/// start : float, optional
///     Where it begins.
///
/// Returns
/// -------
/// Form or Spline
///
/// Raises
/// ------
/// DegenerateError, DomainError, LimitError
///     For the angle 0; for a radius that is not positive and other orders; for too many pieces.
///
/// Examples
/// --------
/// >>> pf.arc(2, np.pi / 2)
/// <pforms.Form pL3 in 3D, rational>
/// >>> len(pf.arc(2, 2 * np.pi))
/// 4
#[pyfunction]
#[pyo3(
    signature = (radius, angle, order=None, *, start=None),
    text_signature = "(radius, angle, order=3, *, start=0.0)"
)]
pub(crate) fn arc<'py>(
    radius: &Bound<'py, PyAny>,
    angle: &Bound<'py, PyAny>,
    order: Option<&Bound<'py, PyAny>>,
    start: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = radius.py();
    let (radius, angle) = (real("radius", radius)?, real("angle", angle)?);
    let order = order.map_or(Ok(3), |order| whole("order", order))?;
    let start = start.map_or(Ok(0.0), |start| real("start", start))?;
    object(py, done(py, LITTLE, || operators::arc(radius, angle, order, start))?)
}

/// What may be given for `part`, and the default.
fn part(given: Option<&Bound<'_, PyAny>>, default: Part) -> PyResult<Part> {
    let Some(given) = given else { return Ok(default) };
    let names = Part::ALL.map(Part::name);
    let name = crate::arguments::word("part", given, &names)?;
    Part::named(name).map_err(|error| crate::errors::raised(&error))
}

/// A circle round the origin, in the plane Oxy, from x towards y. Exact.
///
/// Parameters
/// ----------
/// radius : float
/// part : "whole" or "pieces", optional
///     All of it in one form of five poles, two of them directions; or four quarters end to end, all
///     weights positive.
///
/// Returns
/// -------
/// Form or Spline
///
/// Raises
/// ------
/// DomainError
///     For a radius that is not positive, and other parts.
///
/// Examples
/// --------
/// >>> pf.circle(1).weights * 3
/// array([3., 0., 1., 0., 3.])
/// >>> len(pf.circle(1, part="pieces"))
/// 4
#[pyfunction]
#[pyo3(signature = (radius, *, part=None), text_signature = "(radius, *, part='whole')")]
pub(crate) fn circle<'py>(
    radius: &Bound<'py, PyAny>,
    part: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (py, part) = (radius.py(), self::part(part, Part::Whole)?);
    let radius = real("radius", radius)?;
    object(py, done(py, LITTLE, || operators::circle(&radius, part))?)
}

/// An ellipse round the origin, half axis ``a`` along x and ``b`` along y: a scaled :func:`circle`.
///
/// Raises DomainError for half axes that are not positive, and for other parts.
///
/// >>> pf.ellipse(2, 1)(0.25)
/// array([0.56, 0.96, 0.  ])
#[pyfunction]
#[pyo3(signature = (a, b, *, part=None), text_signature = "(a, b, *, part='whole')")]
pub(crate) fn ellipse<'py>(
    a: &Bound<'py, PyAny>,
    b: &Bound<'py, PyAny>,
    part: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (py, part) = (a.py(), self::part(part, Part::Whole)?);
    let (a, b) = (real("a", a)?, real("b", b)?);
    object(py, done(py, LITTLE, || operators::ellipse(&a, &b, part))?)
}

/// The arc of the hyperbola x²/a² − y²/b² = 1 from y = -height to y = height, where x is positive.
///
/// Raises DomainError unless all three are positive.
///
/// >>> pf.hyperbola(3, 4, 3).weights
/// array([1.  , 1.25, 1.  ])
#[pyfunction]
#[pyo3(signature = (a, b, height))]
pub(crate) fn hyperbola(
    a: &Bound<'_, PyAny>,
    b: &Bound<'_, PyAny>,
    height: &Bound<'_, PyAny>,
) -> PyResult<PyForm> {
    let py = a.py();
    let (a, b, height) = (real("a", a)?, real("b", b)?, real("height", height)?);
    done(py, LITTLE, || operators::hyperbola(a, b, height)).map(PyForm::from)
}

/// The arc of the parabola y² = 4·focal·x from y = -height to y = height. Polynomial.
///
/// Raises DomainError unless both are positive.
///
/// >>> pf.parabola(1, 2).poles
/// array([[ 1., -2.,  0.],
///        [-1.,  0.,  0.],
///        [ 1.,  2.,  0.]])
#[pyfunction]
#[pyo3(signature = (focal, height))]
pub(crate) fn parabola(focal: &Bound<'_, PyAny>, height: &Bound<'_, PyAny>) -> PyResult<PyForm> {
    let py = focal.py();
    let (focal, height) = (real("focal", focal)?, real("height", height)?);
    done(py, LITTLE, || operators::parabola(&focal, &height)).map(PyForm::from)
}

/// A cylinder about Oy from y = 0 to y = height: axis 0 upwards, axis 1 round from x towards z. Exact.
///
/// Parameters
/// ----------
/// radius, height : float
/// part : "whole", "pieces" or "quarter", optional
///     One form; a spline of quarters, all weights positive; one quarter.
///
/// Returns
/// -------
/// Form or Spline
///
/// Raises
/// ------
/// DomainError
///     For lengths that are not positive, and other parts.
///
/// Examples
/// --------
/// >>> pf.cylinder(1, 2)
/// <pforms.Form pS25 in 3D, rational>
#[pyfunction]
#[pyo3(signature = (radius, height, *, part=None), text_signature = "(radius, height, *, part='whole')")]
pub(crate) fn cylinder<'py>(
    radius: &Bound<'py, PyAny>,
    height: &Bound<'py, PyAny>,
    part: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (py, part) = (radius.py(), self::part(part, Part::Whole)?);
    let (radius, height) = (real("radius", radius)?, real("height", height)?);
    object(py, done(py, LITTLE, || operators::cylinder(&radius, &height, part))?)
}

/// A cone about Oy, of ``radius`` at y = 0 and ``top`` at y = height, laid out as :func:`cylinder`.
///
/// Raises DomainError for lengths that are not positive, a negative top, and other parts.
///
/// >>> pf.cone(1, 2)(1, 0.3)
/// array([0., 2., 0.])
#[pyfunction]
#[pyo3(
    signature = (radius, height, *, top=None, part=None),
    text_signature = "(radius, height, *, top=0.0, part='whole')"
)]
pub(crate) fn cone<'py>(
    radius: &Bound<'py, PyAny>,
    height: &Bound<'py, PyAny>,
    top: Option<&Bound<'py, PyAny>>,
    part: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (py, part) = (radius.py(), self::part(part, Part::Whole)?);
    let (radius, height) = (real("radius", radius)?, real("height", height)?);
    let top = top.map_or(Ok(0.0), |top| real("top", top))?;
    object(py, done(py, LITTLE, || operators::cone(&radius, &height, &top, part))?)
}

/// A sphere round the origin: axis 0 along the meridians towards y, axis 1 round from x towards z.
/// Exact.
///
/// Parameters
/// ----------
/// radius : float
/// part : "whole", "pieces", "half", "quarter" or "octant", optional
///     One form; a spline of eight octants, all weights positive; what lies above the equator; a
///     quarter turn; the book's pS33.
///
/// Returns
/// -------
/// Form or Spline
///
/// Raises
/// ------
/// DomainError
///     For a radius that is not positive, and other parts.
///
/// Examples
/// --------
/// >>> pf.sphere(1), pf.sphere(1, part="octant")
/// (<pforms.Form pS45 in 3D, rational>, <pforms.Form pS33 in 3D, rational>)
#[pyfunction]
#[pyo3(signature = (radius, *, part=None), text_signature = "(radius, *, part='whole')")]
pub(crate) fn sphere<'py>(
    radius: &Bound<'py, PyAny>,
    part: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (py, part) = (radius.py(), self::part(part, Part::Whole)?);
    let radius = real("radius", radius)?;
    object(py, done(py, LITTLE, || operators::sphere(&radius, part))?)
}

/// A torus about Oy: axis 0 round the tube, outermost first and then up, axis 1 round Oy. Exact.
///
/// Parameters
/// ----------
/// major, minor : float
///     Radius of the circle that the tube follows, and of the tube.
/// part : "whole", "pieces", "quarter", "outer" or "inner", optional
///     One form; a spline of sixteen patches, all weights positive; a quarter turn; the book's
///     sixteenths.
///
/// Returns
/// -------
/// Form or Spline
///
/// Raises
/// ------
/// DomainError
///     For radii that are not positive, and other parts.
///
/// Examples
/// --------
/// >>> pf.torus(2, 1)(0, 0)
/// array([3., 0., 0.])
#[pyfunction]
#[pyo3(signature = (major, minor, *, part=None), text_signature = "(major, minor, *, part='whole')")]
pub(crate) fn torus<'py>(
    major: &Bound<'py, PyAny>,
    minor: &Bound<'py, PyAny>,
    part: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (py, part) = (major.py(), self::part(part, Part::Whole)?);
    let (major, minor) = (real("major", major)?, real("minor", minor)?);
    object(py, done(py, LITTLE, || operators::torus(&major, &minor, part))?)
}

/// Viviani's curve, where longitude and latitude on the sphere of this radius are equal. Exact.
///
/// With ``part="octant"`` the diagonal of an octant of sphere; with ``"whole"`` the closed curve, the
/// same on the whole line of parameters, in three pieces. Raises DomainError for a radius that is not
/// positive, and other parts.
///
/// >>> pf.viviani(1)
/// <pforms.Form pL5 in 3D, rational>
/// >>> closed = pf.viviani(1, part="whole")
/// >>> np.abs(closed(0) - closed(1)).max() < 1e-15
/// np.True_
#[pyfunction]
#[pyo3(signature = (radius, *, part=None), text_signature = "(radius, *, part='octant')")]
pub(crate) fn viviani<'py>(
    radius: &Bound<'py, PyAny>,
    part: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (py, part) = (radius.py(), self::part(part, Part::Octant)?);
    let radius = real("radius", radius)?;
    object(py, done(py, LITTLE, || operators::viviani(&radius, part))?)
}

/// The knot on a torus that goes ``p`` times round its axis Oy and ``q`` times round its tube.
///
/// A closed spline of ``2·max(|p|, |q|)`` diagonals of patches, which lie on the torus exactly;
/// ``torus_knot(2, 3, …)`` is the trefoil. Negative numbers make mirror images.
///
/// Parameters
/// ----------
/// p, q : int
///     Without a common divisor.
/// major, minor : float
///     Radii of the torus.
///
/// Raises
/// ------
/// DomainError, LimitError
///     For turns with a common divisor and radii that are not positive; for too many turns.
///
/// Examples
/// --------
/// >>> len(pf.torus_knot(2, 3, 1, 0.5))
/// 6
#[pyfunction]
#[pyo3(signature = (p, q, major, minor))]
pub(crate) fn torus_knot(
    p: &Bound<'_, PyAny>,
    q: &Bound<'_, PyAny>,
    major: &Bound<'_, PyAny>,
    minor: &Bound<'_, PyAny>,
) -> PyResult<PySpline> {
    let py = p.py();
    let (p, q) = (turns("p", p)?, turns("q", q)?);
    let (major, minor) = (real("major", major)?, real("minor", minor)?);
    let cost = p.unsigned_abs().max(q.unsigned_abs()).saturating_mul(1 << 10);
    done(py, cost as usize, || operators::torus_knot(p, q, major, minor)).map(PySpline::from)
}

/// A whole number of turns, of either sign.
fn turns(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<i64> {
    let number = real(argument, object)?;
    if number.fract() == 0.0 && number.abs() <= 1e9 {
        return Ok(number as i64);
    }
    fail(&Error::domain(argument, number, "a whole number of turns"))
}

/// A polynomial patch near a quarter of the :func:`cylinder` of this radius and height.
///
/// Returns a :class:`Bicubic` of ``form``, ``error``, ``outside`` and ``inside``. Raises DomainError for
/// lengths that are not positive.
///
/// >>> round(pf.bezier_cylinder(1, 2).error, 8)
/// 0.00027253
#[pyfunction]
#[pyo3(signature = (radius, height))]
pub(crate) fn bezier_cylinder<'py>(
    radius: &Bound<'py, PyAny>,
    height: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = radius.py();
    let (radius, height) = (real("radius", radius)?, real("height", height)?);
    reported(py, done(py, LITTLE, || operators::bezier_cylinder(radius, height))?)
}

/// A polynomial patch near a quarter of the :func:`cone` of this radius and height.
///
/// Returns a :class:`Bicubic`; its errors are those of the radius at one height. Raises DomainError
/// for lengths that are not positive.
///
/// >>> pf.bezier_cone(1, 2).form
/// <pforms.Form pS44 in 3D>
#[pyfunction]
#[pyo3(signature = (radius, height))]
pub(crate) fn bezier_cone<'py>(
    radius: &Bound<'py, PyAny>,
    height: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = radius.py();
    let (radius, height) = (real("radius", radius)?, real("height", height)?);
    reported(py, done(py, LITTLE, || operators::bezier_cone(radius, height))?)
}

/// A polynomial patch near an octant of the :func:`sphere` of this radius.
///
/// Returns a :class:`Bicubic`. Raises DomainError for a radius that is not positive.
///
/// >>> round(pf.bezier_sphere(1).error, 8)
/// 0.00051667
#[pyfunction]
#[pyo3(signature = (radius))]
pub(crate) fn bezier_sphere<'py>(radius: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let py = radius.py();
    let radius = real("radius", radius)?;
    reported(py, done(py, LITTLE, || operators::bezier_sphere(radius))?)
}

/// A polynomial patch near the outer or inner upper sixteenth of a :func:`torus`.
///
/// Returns a :class:`Bicubic`. Raises DomainError for radii that are not positive, DegenerateError for
/// the inner side of a tube thicker than its circle.
///
/// >>> patch = pf.bezier_torus(1, 0.25, side="inner")
/// >>> round(patch.outside, 6), round(patch.inside, 6)
/// (6.8e-05, 0.000204)
#[pyfunction]
#[pyo3(signature = (major, minor, *, side=None), text_signature = "(major, minor, *, side='outer')")]
pub(crate) fn bezier_torus<'py>(
    major: &Bound<'py, PyAny>,
    minor: &Bound<'py, PyAny>,
    side: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = major.py();
    let side = match side {
        None => Part::Outer,
        Some(side) => match crate::arguments::word("side", side, &["outer", "inner"])? {
            "inner" => Part::Inner,
            _ => Part::Outer,
        },
    };
    let (major, minor) = (real("major", major)?, real("minor", minor)?);
    reported(py, done(py, LITTLE, || operators::bezier_torus(major, minor, side))?)
}

fn reported(py: Python<'_>, patch: Bicubic) -> PyResult<Bound<'_, PyAny>> {
    let error = patch.error();
    let class = py.import(intern!(py, "pforms.records"))?.getattr(intern!(py, "Bicubic"))?;
    let form = PyForm::from(patch.form).into_bound_py_any(py)?;
    class.call1((form, error, patch.outside, patch.inside))
}

/// Which conic a curve of three poles is: "circle", "ellipse", "parabola", "hyperbola", "segment" or
/// "point".
///
/// Parameters
/// ----------
/// curve : Form or array_like
/// accuracy : float, optional
///     Numbers that differ by less, relative to their size, are the same.
///
/// Raises
/// ------
/// ShapeError, DomainError
///     For another form than a pL3; for a negative accuracy.
///
/// Examples
/// --------
/// >>> pf.classify(pf.arc(1, 1)), pf.classify([(0, 0), (1, 2), (2, 0)])
/// ('circle', 'parabola')
#[pyfunction]
#[pyo3(signature = (curve, *, accuracy=None), text_signature = "(curve, *, accuracy=1e-12)")]
pub(crate) fn classify(
    curve: &Bound<'_, PyAny>,
    accuracy: Option<&Bound<'_, PyAny>>,
) -> PyResult<&'static str> {
    let form = plain("curve", curve)?;
    let accuracy = accuracy.map_or(Ok(1e-12), |x| real("accuracy", x))?;
    done(curve.py(), LITTLE, || operators::classify(&form, &accuracy)).map(operators::Conic::name)
}
