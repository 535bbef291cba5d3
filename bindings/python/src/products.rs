//! Products of curves: revolution, and any profile with any section.

use pforms_kernel::{Error, Form};
use pforms_operators::{self as operators, Axis, Part, Shape};
use pyo3::prelude::*;

use crate::arguments::{real, require_idle, whole};
use crate::arrays::Numbers;
use crate::errors::{done, fail, raised};
use crate::form::PyForm;
use crate::shapes::{object, read};
use crate::spline::PySpline;

/// The form that a profile leaves behind as it turns about an axis: the profile's axes, then the turn.
///
/// Exact, for rational and skew profiles, for surfaces, and where they touch the axis.
///
/// Parameters
/// ----------
/// profile : Form, Spline or array_like
///     In the plane Oxy or in space.
/// angle : float, optional
///     In radians, right-handed. Without it all the way round in one form, with two of five poles of
///     the turn at infinity; with it in pieces as :func:`arc`, all weights positive.
/// axis, through : sequence of float, optional
///     Direction of the axis, Oy, and a point of it, the origin.
/// order : 3, 4 or 5, optional
///     Poles of every piece of the turn.
///
/// Returns
/// -------
/// Form or Spline
///
/// Raises
/// ------
/// ShapeError, DegenerateError, DomainError, LimitError
///     For a profile on a line or in four dimensions; for an axis of length 0 and the angle 0; for
///     NaN; when too large.
///
/// Examples
/// --------
/// >>> pf.revolve([(1, 0), (2, 1)])
/// <pforms.Form pS25 in 3D, rational>
/// >>> pf.revolve([(1, 0), (2, 1)], np.pi / 2)(0, 1)
/// array([ 0.,  0., -1.])
#[pyfunction]
#[pyo3(
    signature = (profile, angle=None, *, axis=None, through=None, order=None),
    text_signature = "(profile, angle=None, *, axis=(0, 1, 0), through=(0, 0, 0), order=3)"
)]
pub(crate) fn revolve<'py>(
    profile: &Bound<'py, PyAny>,
    angle: Option<&Bound<'py, PyAny>>,
    axis: Option<&Bound<'py, PyAny>>,
    through: Option<&Bound<'py, PyAny>>,
    order: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = profile.py();
    let profile = read("profile", profile)?;
    let axis = read_axis(axis, through)?;
    if angle.is_none() {
        require_idle("order", order, "all the way round takes 5 poles; an angle gives it a part")?;
    }
    let order = order.map_or(Ok(3), |order| whole("order", order))?;
    let angle = angle.map(|angle| real("angle", angle)).transpose()?;
    let turned = done(py, cost(&profile, 1 << 6), || match angle {
        None => operators::revolve_whole(&profile, &axis, Part::Whole),
        Some(angle) => operators::revolve(&profile, angle, &axis, order),
    })?;
    object(py, turned)
}

/// The product of a profile and a section about Oy: the profile's axes first.
///
/// The section says what becomes of the direction x: its point (a, b) turns and stretches the
/// horizontal plane as the complex number a + ib does to x + iz; a third coordinate lifts. A circle
/// turns the profile, from x towards z. Exact.
///
/// Parameters
/// ----------
/// profile, section : Form, Spline or array_like
///     In the plane or in space.
///
/// Returns
/// -------
/// Form or Spline
///
/// Raises
/// ------
/// ShapeError, LimitError
///     For a form on a line or in four dimensions; when too large.
///
/// Examples
/// --------
/// >>> pf.cross([(1, 0), (2, 1)], pf.circle(1))
/// <pforms.Form pS25 in 3D, rational>
#[pyfunction]
#[pyo3(signature = (profile, section))]
pub(crate) fn cross<'py>(
    profile: &Bound<'py, PyAny>,
    section: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = profile.py();
    let (profile, section) = (read("profile", profile)?, read("section", section)?);
    let work = cost(&profile, poles(&section));
    object(py, done(py, work, || operators::cross(&profile, &section))?)
}

fn poles(shape: &Shape) -> usize {
    operators::Poles::net(shape).homogeneous().len()
}

fn cost(profile: &Shape, times: usize) -> usize {
    poles(profile).saturating_mul(times)
}

fn read_axis(
    direction: Option<&Bound<'_, PyAny>>,
    through: Option<&Bound<'_, PyAny>>,
) -> PyResult<Axis> {
    let direction = direction.map_or(Ok([0.0, 1.0, 0.0]), |given| vector("axis", given))?;
    let through = through.map_or(Ok([0.0; 3]), |given| vector("through", given))?;
    Axis::new(through, direction).map_err(|error| raised(&error))
}

/// Three coordinates, or a point in space.
fn vector(argument: &str, given: &Bound<'_, PyAny>) -> PyResult<[f64; 3]> {
    let pole: Vec<f64> = match given.cast::<PyForm>() {
        Ok(form) => point(&form.get().form),
        Err(_) => Numbers::read(argument, given)?.values().to_vec(),
    };
    match *pole {
        [x, y, z] => Ok([x, y, z]),
        _ => fail(&Error::shape(argument, format!("{} numbers", pole.len()), "three coordinates")),
    }
}

/// The coordinates of a point or of a direction; empty for other forms.
fn point(form: &Form) -> Vec<f64> {
    match form.homogeneous() {
        &[x, y, z, w] => {
            let divisor = if w == 0.0 { 1.0 } else { w };
            vec![x / divisor, y / divisor, z / divisor]
        }
        _ => Vec::new(),
    }
}

#[pymethods]
impl PyForm {
    /// The form that this profile leaves behind as it turns about an axis; see :func:`revolve`.
    ///
    /// >>> pf.Form([(1, 0), (2, 1)]).revolve(np.pi / 2)
    /// <pforms.Form pS23 in 3D, rational>
    #[pyo3(
        name = "revolve",
        signature = (angle=None, *, axis=None, through=None, order=None),
        text_signature = "($self, angle=None, *, axis=(0, 1, 0), through=(0, 0, 0), order=3)"
    )]
    fn revolved<'py>(
        slf: &Bound<'py, Self>,
        angle: Option<&Bound<'py, PyAny>>,
        axis: Option<&Bound<'py, PyAny>>,
        through: Option<&Bound<'py, PyAny>>,
        order: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        revolve(slf, angle, axis, through, order)
    }

    /// The product of this profile and a section about Oy; see :func:`cross`.
    ///
    /// >>> pf.Form([(1, 0), (2, 1)]).cross(pf.circle(1))
    /// <pforms.Form pS25 in 3D, rational>
    #[pyo3(name = "cross")]
    fn crossed<'py>(
        slf: &Bound<'py, Self>,
        section: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        cross(slf, section)
    }

    /// Which conic this curve of three poles is; see :func:`classify`.
    ///
    /// >>> pf.parabola(1, 2).classify()
    /// 'parabola'
    #[pyo3(
        name = "classify",
        signature = (*, accuracy=None),
        text_signature = "($self, *, accuracy=1e-12)"
    )]
    fn classified(
        slf: &Bound<'_, Self>,
        accuracy: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<&'static str> {
        crate::rational::classify(slf, accuracy)
    }
}

#[pymethods]
impl PySpline {
    /// The spline that this profile leaves behind as it turns about an axis; see :func:`revolve`.
    ///
    /// >>> pf.arc(1, np.pi).revolve(np.pi).counts
    /// (2, 2)
    #[pyo3(
        name = "revolve",
        signature = (angle=None, *, axis=None, through=None, order=None),
        text_signature = "($self, angle=None, *, axis=(0, 1, 0), through=(0, 0, 0), order=3)"
    )]
    fn revolved<'py>(
        slf: &Bound<'py, Self>,
        angle: Option<&Bound<'py, PyAny>>,
        axis: Option<&Bound<'py, PyAny>>,
        through: Option<&Bound<'py, PyAny>>,
        order: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        revolve(slf, angle, axis, through, order)
    }

    /// The product of this profile and a section about Oy; see :func:`cross`.
    ///
    /// >>> pf.arc(1, np.pi).cross(pf.circle(1)).counts
    /// (2, 1)
    #[pyo3(name = "cross")]
    fn crossed<'py>(
        slf: &Bound<'py, Self>,
        section: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        cross(slf, section)
    }
}
