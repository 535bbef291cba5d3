//! Translation: every point moves by the same vector.

use pforms_kernel::{Error, Matrix, Result, Scalar};

use super::transform::{affine, one_if, require_in_space};
use super::{Poles, transform};

/// The form moved by the vector `by`: a pole `(x, w)` becomes `(x + w·by, w)`.
///
/// Exact. Poles at infinity are directions and stay; the original, which divides by their weight,
/// loses them.
///
/// Errors: `Shape` unless `by` has as many coordinates as the space; `Domain` when one is not finite.
/// Book 231.
///
/// ```
/// use pforms_kernel::Form;
/// let segment: Form = Form::from_points(&[2], 2, &[0., 0., 1., 2.], None)?;
/// assert_eq!(pforms_operators::translate(&segment, &[3., 0.])?.points()?, [3., 0., 4., 2.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn translate<S: Scalar, P: Poles<S>>(form: &P, by: &[S]) -> Result<P> {
    require_in_space("by", by, form.net().ambient())?;
    transform(form, &translation(by)?)
}

/// The matrix of [`translate`].
///
/// Errors: `Shape` without coordinates; `Domain` when one is not finite.
pub fn translation<S: Scalar>(by: &[S]) -> Result<Matrix<S>> {
    if by.is_empty() {
        return Err(Error::shape("by", "no coordinates", "at least 1"));
    }
    require_in_space("by", by, by.len())?;
    Ok(affine(by.len(), |row, column| one_if(row == column), |row| by[row].clone()))
}
