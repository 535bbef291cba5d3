//! The polynomial cubic that comes near a quarter circle (page on bicubic patches).

use pforms_kernel::{Form, Result, Scalar};

/// The cubic from `(1, 0)` to `(0, 1)` whose inner poles lie `4/3·(√2 − 1)` along the tangents: it
/// meets the unit circle at its ends and in its middle and is nowhere inside.
///
/// `half_root` is `√½`.
pub(crate) fn quarter_cubic<S: Scalar>(half_root: &S) -> Result<Form<S>> {
    let (one, zero) = (S::one, S::zero);
    let factor = S::ratio(4, 3) * (half_root.clone() + half_root.clone() - one());
    let points = [one(), zero(), one(), factor.clone(), factor, one(), zero(), one()];
    Form::from_points(&[4], 2, &points, None)
}
