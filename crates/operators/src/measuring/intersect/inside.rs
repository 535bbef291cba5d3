//! Where curves meet inside a host: in its parameters, whatever the host does in space.

use pforms_kernel::{Error, Result};

use super::{Intersections, intersect};
use crate::{Poles, Shape};

/// Where two curves in the parameters of a host meet, as their immersions in it do: the book's
/// segments in surfaces are straight lines there (2234, remark 1).
///
/// Parameters are those of the two curves; points are points of the host. Where the host comes back to
/// the same point of space by other parameters the curves do not meet inside it.
///
/// Errors: `Shape` unless both have as many coordinates as the host has axes; `Domain` where a weight of
/// the host vanishes, and beyond the window of a spline; those of [`intersect`].
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::intersect_inside;
/// let facet: Form = Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 1., 1., 1., 0., 1., 1., 1., 0.], None)?;
/// let line = |ends: &[f64]| Form::from_points(&[2], 2, ends, None);
/// let (rising, falling) = (line(&[0., 0., 1., 1.])?, line(&[0., 1., 1., 0.])?);
/// let found = intersect_inside(&facet.into(), &rising.into(), &falling.into(), 1e-14)?;
/// assert_eq!(found.contacts[0].first, [0.5]);
/// assert_eq!(found.contacts[0].point, [0.5, 0.5, 0.5]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn intersect_inside(
    host: &Shape,
    first: &Shape,
    second: &Shape,
    accuracy: f64,
) -> Result<Intersections> {
    let axes = host.net().axes();
    for (name, shape) in [("first", first), ("second", second)] {
        let ambient = shape.net().ambient();
        if ambient != axes {
            let received = format!("a form in dimension {ambient}");
            let expected = format!("dimension {axes}, one for each axis of the host");
            return Err(Error::shape(name, received, expected));
        }
    }
    let mut found = intersect(first, second, accuracy)?;
    for contact in &mut found.contacts {
        contact.point = match host {
            Shape::Form(form) => form.at(&contact.point)?,
            Shape::Spline(spline) => spline.at(&contact.point)?,
        };
    }
    Ok(found)
}
