//! Reflection in a plane.

use pforms_kernel::{Matrix, Result, Scalar};

use super::homology::{homology, plane};
use super::transform::require_in_space;
use super::{Poles, transform};

/// The form seen in the mirror through `origin` at right angles to `normal`.
///
/// In 2D the mirror is a line, beyond 3D a hyperplane. The length of the normal does not matter.
/// Exact, for the normal need not be made a unit vector; its own inverse.
///
/// Errors: `Shape` unless normal and origin have as many coordinates as the space; `Degenerate` for
/// a zero normal; `Domain` when a number is not finite.
///
/// ```
/// use pforms_kernel::Form;
/// let segment: Form = Form::from_points(&[2], 2, &[0., 0., 1., 2.], None)?;
/// let image = pforms_operators::mirror(&segment, &[0., 1.], &[0., 1.])?;
/// assert_eq!(image.points()?, [0., 2., 1., 0.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn mirror<S: Scalar, P: Poles<S>>(form: &P, normal: &[S], origin: &[S]) -> Result<P> {
    require_in_space("normal", normal, form.net().ambient())?;
    transform(form, &reflection(normal, origin)?)
}

/// The matrix of [`mirror`].
///
/// Errors: as [`mirror`].
pub fn reflection<S: Scalar>(normal: &[S], origin: &[S]) -> Result<Matrix<S>> {
    let plane = plane(normal, origin)?;
    let mut direction = plane.clone();
    direction[normal.len()] = S::zero();
    homology(&plane, &direction, &S::from_integer(2), "normal")
}
