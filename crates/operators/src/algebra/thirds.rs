//! Thirds in place of halves.

use pforms_kernel::{Result, Scalar};

use super::{Shape, stack_shapes, sub};

/// The forms at 1/3 and 2/3 of the form that forms generate, as [`crate::midpoint`] is the one at 1/2.
///
/// Of two points the two that cut their segment in three. Exact; in `f64` rounded like any
/// sub-form. Book 37, remark 1.
///
/// Errors: as [`stack_shapes`].
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Poles, thirds};
/// let [p, q]: [Form; 2] = [Form::point(&[0., 3.])?, Form::point(&[3., 9.])?];
/// let [a, b] = thirds(&[p.into(), q.into()])?;
/// assert_eq!((a.net().points()?, b.net().points()?), (vec![1., 5.], vec![2., 7.]));
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn thirds<S: Scalar>(shapes: &[Shape<S>]) -> Result<[Shape<S>; 2]> {
    let whole = stack_shapes(shapes)?;
    let at = |t: S| -> Result<Shape<S>> {
        Ok(match &whole {
            Shape::Form(form) => sub(form, 0, &t)?.into(),
            Shape::Spline(spline) => spline.sub(0, &t)?.into(),
        })
    };
    Ok([at(S::ratio(1, 3))?, at(S::ratio(2, 3))?])
}
