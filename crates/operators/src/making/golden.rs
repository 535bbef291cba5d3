//! Division in extreme and mean ratio.

use pforms_kernel::{Result, Scalar};

use crate::algebra::{Shape, combine_shapes};
use crate::measuring::GOLDEN_RATIO;

/// The form whose poles divide the way from those of `a` to those of `b` in the golden ratio, the longer
/// part first; of two points a point.
///
/// Orders may differ, and splines are brought to common knots, as with [`combine_shapes`]. The
/// ratio is no fraction, so it is that of `f64` in any arithmetic.
///
/// Errors: as [`combine_shapes`].
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{GOLDEN_RATIO, Poles, golden};
/// let [a, b] = [Form::point(&[0.0])?, Form::point(&[GOLDEN_RATIO])?];
/// let point = golden(&a.into(), &b.into())?;
/// assert!((point.net().points()?[0] - 1.0).abs() < 1e-15);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn golden<S: Scalar>(a: &Shape<S>, b: &Shape<S>) -> Result<Shape<S>> {
    let longer = S::from_f64(GOLDEN_RATIO - 1.0).unwrap_or_else(S::one);
    let shorter = S::one() - longer.clone();
    combine_shapes(&[shorter, longer], &[a.clone(), b.clone()], false)
}
