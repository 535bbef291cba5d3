//! The form symmetric to another with respect to a third.

use pforms_kernel::{Result, Scalar};

use super::{Shape, combine_shapes};

/// `2·middle − form`: every point of `form` on the other side of the corresponding one of `middle`.
///
/// On homogeneous poles, as in the book, this is a symmetry of the points where the weights of the two
/// are equal; with `pointwise` it always is, and orders add, see
/// [`combine_pointwise`](super::combine_pointwise). Exact.
///
/// Errors: `Shape` when axes, spaces or windows differ; `Limit`. Book 33.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Poles, symmetric};
/// let middle: Form = Form::from_points(&[2], 1, &[1., 2.], None)?;
/// let form = Form::from_points(&[2], 1, &[0., 0.], None)?;
/// let other = symmetric(&middle.into(), &form.into(), false)?;
/// assert_eq!(other.net().points()?, [2., 4.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn symmetric<S: Scalar>(
    middle: &Shape<S>,
    form: &Shape<S>,
    pointwise: bool,
) -> Result<Shape<S>> {
    let k = [S::from_integer(2), -S::one()];
    combine_shapes(&k, &[middle.clone(), form.clone()], pointwise)
}
