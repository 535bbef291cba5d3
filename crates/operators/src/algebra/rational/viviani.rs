//! Viviani's window: where a sphere meets the cylinder on half its radius (book 3131).

use pforms_kernel::{Result, Scalar};

use super::{Part, sphere};
use crate::{Poles, Shape, Spline, diagonal, whole_line};

/// Viviani's curve on the sphere of this radius round the origin: where latitude and longitude are
/// equal, `x = r·cos²φ`, `y = r·sin φ`, `z = r·cos φ·sin φ`.
///
/// [`Part::Octant`] is the diagonal of an octant, a pL5 from `φ = 0` to a right angle: the book's arc.
/// [`Part::Whole`] is that curve on the whole projective line, closed, a spline of three pieces.
///
/// Errors: `Domain` unless the radius is positive, for other parts, and in a field without √2.
///
/// ```
/// use pforms_operators::{Part, Poles, viviani};
/// assert_eq!(viviani(&1.0, Part::Octant)?.net().kind().to_string(), "pL5");
/// assert_eq!(viviani(&1.0, Part::Whole)?.pieces()?.len(), 3);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn viviani<S: Scalar>(radius: &S, part: Part) -> Result<Shape<S>> {
    let arc = diagonal(sphere(radius, Part::Octant)?.net(), 0, 1)?;
    match part {
        Part::Octant => Ok(Shape::Form(arc)),
        Part::Whole => {
            let breaks: Vec<S> = (0..=3).map(|i| S::ratio(i, 3)).collect();
            Spline::end_to_end(&whole_line(&arc, 0)?, 0, &breaks).map(Shape::Spline)
        }
        _ => Err(part.absent(&[Part::Octant, Part::Whole])),
    }
}
