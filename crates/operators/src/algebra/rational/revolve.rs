//! Surfaces, and forms of any dimension, of revolution.

use pforms_kernel::{Result, Scalar};

use super::cross::{product, require_space};
use super::{Axis, Part, circle};
use crate::Shape;

/// The form that a profile leaves behind as it is moved by a plane curve `turn` about an axis: the
/// axes of the profile first, that of the turn last.
///
/// The point `(a, b)` of `turn` keeps distances along the axis and does to the planes across it what
/// the complex number `a + i·b` does: an arc of the unit circle turns by its angle, right-handed. The
/// third coordinate of `turn` is not looked at. Exact, rational or not, for a form or a spline of
/// any number of axes, flat or not, on whichever side of the axis; where it touches the axis the
/// result has an edge that is one point.
///
/// Errors: `Shape` unless both lie in two or three dimensions; `Limit`.
pub fn revolve_along<S: Scalar>(
    profile: &Shape<S>,
    turn: &Shape<S>,
    axis: &Axis<S>,
) -> Result<Shape<S>> {
    require_space("profile", profile)?;
    require_space("turn", turn)?;
    let times = |a: &S, b: &S| a.clone() * b.clone();
    product(profile, turn, |p, s| {
        let ([cosine, sine, _, weight], [.., pw]) = (s, p);
        let from = |k: usize| p[k].clone() - times(&axis.through[k], pw);
        let arm = [from(0), from(1), from(2)];
        let n = &axis.direction;
        let height = times(&arm[0], &n[0]) + times(&arm[1], &n[1]) + times(&arm[2], &n[2]);
        let moved = |k: usize| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let along = times(&height, &n[k]);
            let across = arm[k].clone() - along.clone();
            let side = times(&n[i], &arm[j]) - times(&n[j], &arm[i]);
            let still = along + times(&axis.through[k], pw);
            times(&still, weight) + times(&across, cosine) + times(&side, sine)
        };
        [moved(0), moved(1), moved(2), times(pw, weight)]
    })
}

/// [`revolve_along`] the whole unit circle, all the way round in one form ([`Part::Whole`]) or in
/// four quarters ([`Part::Pieces`]).
///
/// Errors: as [`revolve_along`] and [`circle`].
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Axis, Part, Poles, revolve_whole};
/// let segment = Form::from_points(&[2], 2, &[1., 0., 1., 3.], None)?;
/// let cylinder = revolve_whole(&segment.into(), &Axis::upright(), Part::Whole)?;
/// assert_eq!(cylinder.net().orders(), [2, 5]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn revolve_whole<S: Scalar>(
    profile: &Shape<S>,
    axis: &Axis<S>,
    part: Part,
) -> Result<Shape<S>> {
    revolve_along(profile, &circle(&S::one(), part)?, axis)
}
