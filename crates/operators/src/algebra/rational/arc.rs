//! Arcs of a circle: powers of a complex line.
//!
//! With `z(t) = (1 − t) + t·e^{iφ}` the homogeneous curve `(z², |z|²)` is an arc of `2φ` and `(z⁴, |z|⁴)`
//! one of `4φ`. Their poles are `e^{ijφ}` as they stand, of weights `1, c, 1` and
//! `1, c, (1 + 2c²)/3, c, 1`, with `c = cos φ` (book 311).

use pforms_kernel::{Error, Form, Result, Scalar};

use super::Part;
use crate::{Shape, Spline, elevate};

/// An arc round the origin of the plane Oxy, from the positive x axis towards the positive y axis,
/// by the direction `step = (cos φ, sin φ)` from each pole to the next.
///
/// Order 3 spans `2φ`, order 4 is order 3 raised, order 5 spans `4φ`. For `φ` of 45 degrees these are
/// the quarter and half circles of the book; for 90 degrees and order 5 the full circle. The
/// equation `x² + y² = r²·w²` holds as an identity in any field that `step` lies in.
///
/// Errors: `Domain` unless the radius is positive, the order 3, 4 or 5, and, in exact arithmetic,
/// `step` on the unit circle.
///
/// ```
/// use pforms_kernel::{Rational, Scalar};
/// use pforms_operators::arc_by_step;
/// let step = [Rational::ratio(4, 5), Rational::ratio(3, 5)];
/// let arc = arc_by_step(&Rational::ratio(1, 1), &step, 3)?;
/// let end = [Rational::ratio(7, 25), Rational::ratio(24, 25), Rational::ratio(0, 1)];
/// assert_eq!(arc.at(&[Rational::ratio(1, 1)])?, end);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn arc_by_step<S: Scalar>(radius: &S, step: &[S; 2], order: usize) -> Result<Form<S>> {
    let [c, s] = step;
    let norm = c.clone() * c.clone() + s.clone() * s.clone();
    if S::EXACT && norm != S::one() {
        return Err(Error::domain("step", format!("{step:?}"), "a point of the unit circle"));
    }
    let mut directions = vec![[S::one(), S::zero()]];
    for j in 1..=steps(order)? {
        let [x, y] = &directions[j - 1];
        directions.push([
            x.clone() * c.clone() - y.clone() * s.clone(),
            x.clone() * s.clone() + y.clone() * c.clone(),
        ]);
    }
    arc_through(radius, &directions, c, order)
}

/// Steps from pole to pole before any elevation.
pub(crate) fn steps(order: usize) -> Result<usize> {
    match order {
        3 | 4 => Ok(2),
        5 => Ok(4),
        _ => Err(Error::domain("order", order, "3, 4 or 5")),
    }
}

/// The arc whose poles point in these directions, `cosine` between neighbours.
pub(crate) fn arc_through<S: Scalar>(
    radius: &S,
    directions: &[[S; 2]],
    cosine: &S,
    order: usize,
) -> Result<Form<S>> {
    require_positive("radius", radius)?;
    let c = || cosine.clone();
    let middle = (S::one() + (c() + c()) * c()) / S::from_integer(3);
    let weights = match directions.len() {
        3 => vec![S::one(), c(), S::one()],
        _ => vec![S::one(), c(), middle, c(), S::one()],
    };
    let mut poles = Vec::with_capacity(4 * weights.len());
    for ([x, y], weight) in directions.iter().zip(weights) {
        let scaled = |x: &S| radius.clone() * x.clone();
        poles.extend([scaled(x), scaled(y), S::zero(), weight]);
    }
    let arc = Form::from_homogeneous(&[directions.len()], 3, poles)?;
    if order == 4 { elevate(&arc, &[1]) } else { Ok(arc) }
}

/// A circle round the origin of the plane Oxy, from the positive x axis towards the positive y axis.
///
/// [`Part::Whole`] is one form of five poles, weights `1, 0, 1/3, 0, 1`: the half circle of five
/// poles on the window `[−√½, 1 + √½]` (book 311), begun where x is largest; all its numbers are
/// fractions of the radius. [`Part::Pieces`] is four quarters of three poles end to end.
///
/// Errors: `Domain` unless the radius is positive; for other parts; for pieces in a field without
/// √2.
///
/// ```
/// use pforms_operators::{Part, Poles, circle};
/// let whole = circle(&1.0, Part::Whole)?;
/// assert_eq!(whole.net().weights(), [1.0, 0.0, 1.0 / 3.0, 0.0, 1.0]);
/// assert_eq!(circle(&1.0, Part::Pieces)?.pieces()?.len(), 4);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn circle<S: Scalar>(radius: &S, part: Part) -> Result<Shape<S>> {
    match part {
        Part::Whole => whole_circle(radius).map(Shape::Form),
        Part::Pieces => quarters(radius, 0, 4, &part.half_root()?).map(Shape::Spline),
        _ => Err(part.absent(&[Part::Whole, Part::Pieces])),
    }
}

/// The whole circle in one form of five poles.
pub(super) fn whole_circle<S: Scalar>(radius: &S) -> Result<Form<S>> {
    arc_by_step(radius, &[S::zero(), S::one()], 5)
}

/// The half circle from the negative to the positive y axis over the positive x axis: the meridian
/// of a sphere in four poles, all fractions.
pub(super) fn meridian<S: Scalar>(radius: &S) -> Result<Form<S>> {
    let directions = [-1, 0, 1].map(turned_right_angles);
    arc_through(radius, &directions, &S::zero(), 4)
}

/// `count` quarter circles end to end, the first of which begins after `first` right angles.
pub(super) fn quarters<S: Scalar>(
    radius: &S,
    first: i64,
    count: i64,
    half_root: &S,
) -> Result<Spline<S>> {
    let pieces = (0..count).map(|i| quarter(radius, first + i, half_root));
    let pieces: Vec<Form<S>> = pieces.collect::<Result<_>>()?;
    let breaks: Vec<S> = (0..=count).map(|i| S::ratio(i, count)).collect();
    Spline::end_to_end(&pieces, 0, &breaks)
}

/// The quarter circle that begins after `first` right angles.
pub(super) fn quarter<S: Scalar>(radius: &S, first: i64, half_root: &S) -> Result<Form<S>> {
    let [from, to]: [[S; 2]; 2] = [turned_right_angles(first), turned_right_angles(first + 1)];
    let between = |k: usize| (from[k].clone() + to[k].clone()) * half_root.clone();
    let middle = [between(0), between(1)];
    arc_through(radius, &[from, middle, to], half_root, 3)
}

/// The direction of the x axis turned by right angles.
fn turned_right_angles<S: Scalar>(count: i64) -> [S; 2] {
    let (one, zero) = (S::one(), S::zero());
    match count.rem_euclid(4) {
        0 => [one, zero],
        1 => [zero, one],
        2 => [-one, zero],
        _ => [zero, -one],
    }
}

/// Passes a positive number.
pub(crate) fn require_positive<S: Scalar>(argument: &str, x: &S) -> Result<()> {
    if x.is_finite() && *x > S::zero() {
        return Ok(());
    }
    Err(Error::domain(argument, format!("{:?}", x.to_f64()), "a positive number"))
}
