//! The shadow of a form on a plane, by parallel rays or by a lamp.

use pforms_kernel::{Matrix, Result, Scalar};

use super::homology::{homology, plane};
use super::transform::require_in_space;
use super::{Poles, transform};

/// The shadow of a form on the plane through `origin` at right angles to `normal`.
///
/// `from` is what the rays come from, in homogeneous coordinates: a point `(x, …, w)` casts a central
/// shadow (a perspective), a direction `(x, …, 0)` a parallel one, and `(normal, 0)` the orthogonal
/// one. In 2D the plane is a line, beyond 3D a hyperplane.
///
/// Exact: a central shadow changes the weights, so that of a polynomial form is rational, and conics
/// come out as shadows of parabolas (book 3111). Points of the plane stay, with their weights. A pole level
/// with the lamp goes to infinity (weight 0), one behind it gets a weight of the other sign; the pole
/// that is the lamp itself has no shadow and becomes 0 throughout.
///
/// Errors: `Shape` when the numbers of coordinates do not fit; `Degenerate` for a zero normal, and
/// when `from` lies on the plane or is parallel to it; `Domain` when a number is not finite.
///
/// ```
/// use pforms_kernel::Form;
/// let segment: Form = Form::from_points(&[2], 2, &[1., 1., 3., 3.], None)?;
/// let lamp = [0., 4., 1.];
/// let shadow = pforms_operators::project_to_plane(&segment, &[0., 1.], &[0., 0.], &lamp)?;
/// assert_eq!(shadow.points()?, [4. / 3., 0., 12., 0.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn project_to_plane<S: Scalar, P: Poles<S>>(
    form: &P,
    normal: &[S],
    origin: &[S],
    from: &[S],
) -> Result<P> {
    require_in_space("normal", normal, form.net().ambient())?;
    transform(form, &projection(normal, origin, from)?)
}

/// The matrix of [`project_to_plane`].
///
/// Errors: as [`project_to_plane`].
pub fn projection<S: Scalar>(normal: &[S], origin: &[S], from: &[S]) -> Result<Matrix<S>> {
    let plane = plane(normal, origin)?;
    require_in_space("from", from, plane.len())?;
    homology(&plane, from, &S::one(), "from")
}
