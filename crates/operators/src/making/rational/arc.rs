//! Arcs of a circle of any angle.

use std::f64::consts::PI;

use pforms_kernel::{Error, Result, limit};

use super::angles::{direction, direction_after};
use crate::algebra::arc_through;
use crate::{Shape, Spline};

/// The arc of a circle round the origin of the plane Oxy, from the angle `start` on through `angle`
/// radians (negative: clockwise), in pieces of 3, 4 or 5 poles.
///
/// One form as long as that is well conditioned, equal pieces end to end above:
///
/// | order | one form up to | pieces above | least weight |
/// |---|---|---|---|
/// | 3 | 120° | at most 90° | 1/2 |
/// | 4 | 180° | at most 180° | 1/3 |
/// | 5 | 270° | at most 180° | 0.38 |
///
/// Any number of turns. Every point lies within 4 roundings of the circle; in the first turn,
/// multiples of 15° are met to the bit, so that a right angle ends on Oy.
///
/// Errors: `Domain` unless the radius is positive, the order 3, 4 or 5 and the angles finite;
/// `Degenerate` when the angle is 0; `Limit`.
///
/// ```
/// use std::f64::consts::{PI, TAU};
/// use pforms_operators::{Poles, arc};
/// let half = arc(1.0, PI, 5, 0.0)?;
/// assert_eq!(half.net().pole(&[2])?, [0.0, 1.0, 0.0, 2.0 / 3.0]);
/// assert_eq!(arc(1.0, TAU, 3, 0.0)?.pieces()?.len(), 4);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn arc(radius: f64, angle: f64, order: usize, start: f64) -> Result<Shape> {
    require_finite("angle", angle)?;
    require_finite("start", start)?;
    if angle == 0.0 {
        return Err(Error::degenerate("angle", 0, "an angle other than 0"));
    }
    let (alone, piece, steps) = match order {
        3 => (2.0 * PI / 3.0, PI / 2.0, 2),
        4 => (PI, PI, 2),
        5 => (1.5 * PI, PI, 4),
        _ => return Err(Error::domain("order", order, "3, 4 or 5")),
    };
    let count = pieces(angle, alone, piece);
    limit::check::<f64>("the arc", &[count, order], 4)?;
    let step = angle / (count * steps) as f64;
    let [cosine, _] = direction(step);
    let forms = (0..count).map(|i| {
        let place = |j: usize| direction_after(start, step, i * steps + j);
        let directions: Vec<[f64; 2]> = (0..=steps).map(place).collect();
        arc_through(&radius, &directions, &cosine, order)
    });
    let mut forms = forms.collect::<Result<Vec<_>>>()?;
    if count == 1 {
        return Ok(Shape::Form(forms.swap_remove(0)));
    }
    let breaks: Vec<f64> = (0..=count).map(|i| i as f64 / count as f64).collect();
    Spline::end_to_end(&forms, 0, &breaks).map(Shape::Spline)
}

/// The fewest pieces that are short enough, an excess of two roundings forgiven.
fn pieces(angle: f64, alone: f64, piece: f64) -> usize {
    let slack = 1.0 + 4.0 * f64::EPSILON;
    if angle.abs() <= alone * slack {
        return 1;
    }
    libm::ceil(angle.abs() / (piece * slack)) as usize
}

fn require_finite(argument: &str, x: f64) -> Result<()> {
    if x.is_finite() { Ok(()) } else { Err(Error::domain(argument, x, "a finite angle")) }
}
