//! Cylinder, cone and sphere about Oy: products of a profile and a circle (book 312).

use pforms_kernel::{Error, Form, Result, Scalar};

use super::arc::{meridian, quarter, quarters, require_positive};
use super::{Part, circle, cross};
use crate::Shape;

/// A cylinder about Oy from `y = 0` to `y = height`: axis 0 upwards, axis 1 round from x towards z.
///
/// [`Part::Whole`] (a pS25), [`Part::Pieces`] (four quarters) or [`Part::Quarter`] (a pS23).
///
/// Errors: `Domain` unless radius and height are positive; for other parts; for quarters in a field
/// without √2.
pub fn cylinder<S: Scalar>(radius: &S, height: &S, part: Part) -> Result<Shape<S>> {
    require_positive("radius", radius)?;
    require_positive("height", height)?;
    cross(&rising(radius, radius, height)?, &round(part, &ROUND)?)
}

/// A cone about Oy, from the radius `radius` at `y = 0` to the radius `top` at `y = height`, laid out as
/// a [`cylinder`]; `top` 0 makes an apex, where an edge is one point.
///
/// Errors: as [`cylinder`]; `Domain` when `top` is negative.
pub fn cone<S: Scalar>(radius: &S, height: &S, top: &S, part: Part) -> Result<Shape<S>> {
    require_positive("radius", radius)?;
    require_positive("height", height)?;
    if !(top.is_finite() && *top >= S::zero()) {
        return Err(Error::domain("top", format!("{:?}", top.to_f64()), "a number at least 0"));
    }
    cross(&rising(radius, top, height)?, &round(part, &ROUND)?)
}

/// A sphere round the origin: axis 0 along the meridians towards positive y, axis 1 round Oy from x
/// towards z. Edges at the poles are one point each.
///
/// [`Part::Whole`] is one pS45; [`Part::Pieces`] eight octants; [`Part::Half`] what lies above the
/// equator, a pS35; [`Part::Quarter`] a quarter turn from pole to pole, a pS43; [`Part::Octant`] the
/// book's pS33.
///
/// Errors: `Domain` unless the radius is positive; for other parts; for all but the whole in a field
/// without √2.
///
/// ```
/// use pforms_operators::{Part, Poles, sphere};
/// let whole = sphere(&2.0, Part::Whole)?;
/// assert_eq!(whole.net().kind().to_string(), "pS45");
/// assert_eq!(sphere(&2.0, Part::Pieces)?.pieces()?.len(), 8);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn sphere<S: Scalar>(radius: &S, part: Part) -> Result<Shape<S>> {
    let turn = round(part, &SPHERE)?;
    let up = match part {
        Part::Half | Part::Octant => quarter(radius, 0, &part.half_root()?)?.into(),
        Part::Pieces => quarters(radius, -1, 2, &part.half_root()?)?.into(),
        _ => meridian(radius)?.into(),
    };
    cross(&up, &turn)
}

const ROUND: [Part; 3] = [Part::Whole, Part::Pieces, Part::Quarter];
const SPHERE: [Part; 5] = [Part::Whole, Part::Pieces, Part::Half, Part::Quarter, Part::Octant];

/// The turn that a part needs, if it is one of those that are known.
pub(super) fn round<S: Scalar>(part: Part, known: &[Part]) -> Result<Shape<S>> {
    if !known.contains(&part) {
        return Err(part.absent(known));
    }
    match part {
        Part::Whole | Part::Half => circle(&S::one(), Part::Whole),
        Part::Pieces => circle(&S::one(), Part::Pieces),
        _ => Ok(quarter(&S::one(), 0, &part.half_root()?)?.into()),
    }
}

/// The segment from `(low, 0)` to `(high, height)`.
fn rising<S: Scalar>(low: &S, high: &S, height: &S) -> Result<Shape<S>> {
    let points = [low.clone(), S::zero(), high.clone(), height.clone()];
    Form::from_points(&[2], 2, &points, None).map(Shape::Form)
}
