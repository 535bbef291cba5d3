//! Knots on a torus: straight lines in a space that is a torus (book 3133).

use std::f64::consts::TAU;

use pforms_kernel::{Error, Form, Result, limit};

use super::angles::direction;
use crate::algebra::{arc_through, require_positive, shifted};
use crate::{Poles, Shape, Spline, cross, diagonal};

/// The knot on the [`torus`](crate::torus) of radii `major` and `minor` that goes `p` times round its
/// axis and `q` times round its tube: a closed spline of `2·max(|p|, |q|)` diagonals, pL9.
///
/// Each piece is the diagonal of a patch of the torus, and lies on it exactly but for the rounding of
/// the patch's cosines. The trefoil, `p = 2` and `q = 3`, is the book's six diagonals. Negative numbers
/// turn the other way: the mirror image. Neighbours meet with a common tangent.
///
/// Errors: `Domain` unless the radii are positive and `p` and `q` have no common divisor; `Limit`.
///
/// ```
/// use pforms_operators::{Poles, torus_knot};
/// let trefoil = torus_knot(2, 3, 1.0, 0.5)?;
/// assert_eq!(trefoil.counts(), [6]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn torus_knot(p: i64, q: i64, major: f64, minor: f64) -> Result<Spline> {
    require_positive("major", &major)?;
    require_positive("minor", &minor)?;
    if num_integer::gcd(p.unsigned_abs(), q.unsigned_abs()) != 1 {
        let expected = "numbers of turns without a common divisor";
        return Err(Error::domain("p and q", format!("{p} and {q}"), expected));
    }
    let count = p.unsigned_abs().max(q.unsigned_abs()).saturating_mul(2) as usize;
    limit::check::<f64>("the knot", &[count, 9], 4)?;
    let pieces = (0..count).map(|i| {
        let tube = shifted(&piece(minor, q, i, count)?, &major)?;
        diagonal(cross(&tube, &piece(1.0, p, i, count)?)?.net(), 0, 1)
    });
    let breaks: Vec<f64> = (0..=count).map(|i| i as f64 / count as f64).collect();
    Spline::end_to_end(&pieces.collect::<Result<Vec<_>>>()?, 0, &breaks)
}

/// The arc number `i` of `count` that make so many turns, of five poles; no turn at all leaves a point.
fn piece(radius: f64, turns: i64, i: usize, count: usize) -> Result<Shape> {
    if turns == 0 {
        let point = vec![radius, 0.0, 0.0, 1.0];
        return Form::from_homogeneous(&[1], 3, point).map(Shape::Form);
    }
    // Reduced in whole numbers: where neighbours meet, they have the same poles to the bit.
    let steps = 4 * count as i64;
    let after = |k: i64| direction(TAU * ((turns * k).rem_euclid(steps) as f64 / steps as f64));
    let directions: Vec<[f64; 2]> = (0..=4).map(|j| after(4 * i as i64 + j)).collect();
    let [cosine, _] = after(1);
    arc_through(&radius, &directions, &cosine, 5).map(Shape::Form)
}
