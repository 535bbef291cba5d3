//! Intersections: where curves and surfaces meet, and whether that is all.
//!
//! Curves meet in points, or share arcs: [`curves`]. A curve meets a surface in points, or has an arc in
//! it: `curve_surface`. Surfaces meet in curves: [`surfaces`]. Splines are met piece by piece.

mod answer;
mod curve_surface;
mod curves;
mod exact;
mod inside;
mod pieces;
mod surfaces;

use pforms_kernel::{Error, Result};

pub use answer::{Branch, Contact, ContactKind, Intersections, Overlap, Undecided};
pub use curves::{Crossings, intersect_many};
pub use inside::intersect_inside;

use crate::{Poles, Shape};

/// Where two curves, a curve and a surface, or two surfaces meet.
///
/// All places over the windows of both are found, or it is said where more may be: `undecided`,
/// without which the answer is `complete`. The numbers of the forms are taken at their word: a crossing
/// or a tangent that is `proved` is one of the exact forms. What comes nearer than `accuracy` times
/// the size of the forms and does not meet is a touch; crossings between which the forms stay nearer
/// than that are one tangent, and arcs that do are an overlap. An accuracy of 0 leaves all that out.
///
/// Errors: `Shape` for forms in spaces of different dimension, or with no axis or more than two;
/// `Domain` for a weight that vanishes in the window, or an accuracy not between 0 and 1; `Limit`
/// for degrees beyond what is provided for.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{ContactKind, intersect};
/// let parabola: Form = Form::from_points(&[3], 2, &[-1., 1., 0., -1., 1., 1.], None)?;
/// let line = Form::from_points(&[2], 2, &[-1., 0.25, 1., 0.25], None)?;
/// let found = intersect(&parabola.into(), &line.into(), 1e-14)?;
/// assert!(found.complete && found.contacts.len() == 2);
/// assert_eq!(found.contacts[0].kind, ContactKind::Crossing);
/// assert!((found.contacts[0].first[0] - 0.25).abs() <= found.contacts[0].error);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn intersect(first: &Shape, second: &Shape, accuracy: f64) -> Result<Intersections> {
    if !(0.0..=1.0).contains(&accuracy) {
        return Err(Error::domain("accuracy", accuracy, "a number from 0 to 1"));
    }
    let (a, b) = (first.net(), second.net());
    if a.ambient() != b.ambient() {
        let received = format!("a form in dimension {}", b.ambient());
        return Err(Error::shape("second", received, format!("dimension {}", a.ambient())));
    }
    match (a.axes(), b.axes()) {
        (1, 1) => curves::intersect_curves(first, second, accuracy),
        (1, 2) => {
            let margin = curves::margin(&[a, b], accuracy);
            pieces::pairwise(first, second, margin, |a, b| {
                curve_surface::curve_surface(a, b, accuracy)
            })
        }
        (2, 1) => intersect(second, first, accuracy).map(Intersections::swapped),
        (2, 2) => surfaces::surface_surface(first, second, accuracy),
        (1 | 2, _) => Err(Error::shape("second", b.kind(), "a curve or a surface")),
        _ => Err(Error::shape("first", a.kind(), "a curve or a surface")),
    }
}
