//! Scaling: coordinates grow away from a centre.

use pforms_kernel::{Error, Matrix, Result, Scalar};

use super::transform::{about, require_in_space};
use super::{Poles, transform};

/// The form with coordinate `k` multiplied by `factors[k]`, counted from `centre`.
///
/// A negative factor mirrors, 0 flattens, −1 for all coordinates is the symmetry about the centre.
/// Weights stay. Exact.
///
/// Errors: `Shape` unless factors and centre have as many numbers as the space; `Domain` when one is
/// not finite. Book 231.
///
/// ```
/// use pforms_kernel::Form;
/// let segment: Form = Form::from_points(&[2], 2, &[0., 0., 1., 2.], None)?;
/// let smaller = pforms_operators::scale(&segment, &[0.5, 1.], &[1., 0.])?;
/// assert_eq!(smaller.points()?, [0.5, 0., 1., 2.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn scale<S: Scalar, P: Poles<S>>(form: &P, factors: &[S], centre: &[S]) -> Result<P> {
    require_in_space("factors", factors, form.net().ambient())?;
    transform(form, &scaling(factors, centre)?)
}

/// The matrix of [`scale`].
///
/// Errors: `Shape` without factors or when the centre has another number of coordinates; `Domain`
/// when a number is not finite.
pub fn scaling<S: Scalar>(factors: &[S], centre: &[S]) -> Result<Matrix<S>> {
    if factors.is_empty() {
        return Err(Error::shape("factors", "none", "at least 1"));
    }
    require_in_space("factors", factors, factors.len())?;
    require_in_space("centre", centre, factors.len())?;
    Ok(about(centre, |row, column| if row == column { factors[row].clone() } else { S::zero() }))
}
