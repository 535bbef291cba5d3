//! Revolution by any angle.

use pforms_kernel::Result;

use super::arc;
use crate::{Axis, Shape, revolve_along};

/// The form that a profile leaves behind as it turns about an axis by `angle` radians, right-handed:
/// the axes of the profile first, the turn last, in pieces of 3, 4 or 5 poles as an [`arc`] has.
///
/// Exact for a rational profile of any number of axes, form or spline, flat or not: all that is
/// rounded are the cosines of the turn. For all the way round in one form see
/// [`revolve_whole`](crate::revolve_whole).
///
/// Errors: as [`arc`] and [`revolve_along`].
///
/// ```
/// use std::f64::consts::PI;
/// use pforms_kernel::Form;
/// use pforms_operators::{Axis, Poles, revolve};
/// let profile = Form::from_points(&[2], 3, &[1., 0., 0., 1., 2., 1.], None)?;
/// let patch = revolve(&profile.into(), PI / 2.0, &Axis::upright(), 3)?;
/// assert_eq!(patch.net().kind().to_string(), "pS23");
/// assert_eq!(patch.net().pole(&[0, 2])?, [0.0, 0.0, -1.0, 1.0]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn revolve(profile: &Shape, angle: f64, axis: &Axis, order: usize) -> Result<Shape> {
    revolve_along(profile, &arc(1.0, angle, order, 0.0)?, axis)
}
