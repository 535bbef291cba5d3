//! Ruled forms: straight lines from each point of one form to the same point of another.

use pforms_kernel::{Form, Result, Scalar};

use super::combine::{on_window_of, spread};
use super::{Knots, Shape, Spline, stack};

/// The form of all segments from `a(t)` to `b(t)`: a new axis 0 of two poles.
///
/// Between two curves a ruled surface, between two surfaces a volume; with a point a cone. It is the
/// book's MIR of two forms, orders raised as needed. Exact. Where the weights of the two differ the
/// segments are straight all the same, and run at another speed.
///
/// Errors: `Shape` when axes or spaces differ; `Limit`. Book 12, 332.
///
/// ```
/// use pforms_kernel::Form;
/// let base: Form = Form::from_points(&[3], 2, &[0., 0., 1., 0., 2., 0.], None)?;
/// let cone = pforms_operators::ruled(&base, &Form::point(&[1., 3.])?)?;
/// assert_eq!(cone.at(&[1.0, 0.25])?, [1., 3.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn ruled<S: Scalar>(a: &Form<S>, b: &Form<S>) -> Result<Form<S>> {
    let pair = spread(&[a, b])?;
    stack(&[&pair[0], &pair[1]])
}

/// [`ruled`] between forms and splines: with a spline, on their common knots.
///
/// Errors: as [`ruled`]; `Shape` when the windows of splines differ.
pub fn ruled_shapes<S: Scalar>(a: &Shape<S>, b: &Shape<S>) -> Result<Shape<S>> {
    let first = match (a, b) {
        (Shape::Form(a), Shape::Form(b)) => return Ok(ruled(a, b)?.into()),
        (Shape::Spline(spline), _) | (_, Shape::Spline(spline)) => spline,
    };
    let pair = Spline::on_common_knots(&[on_window_of(a, first)?, on_window_of(b, first)?])?;
    let net = stack(&[pair[0].net(), pair[1].net()])?;
    let across = Knots::new(1, [0, 0, 1, 1].map(S::from_integer).to_vec())?;
    let mut knots = vec![across];
    knots.extend_from_slice(pair[0].knots());
    Ok(Spline::on(net, knots)?.into())
}
