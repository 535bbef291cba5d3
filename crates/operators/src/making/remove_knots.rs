//! The same spline with fewer knots.

use std::cmp::Ordering;

use pforms_kernel::{Error, Result, Scalar};

use crate::algebra::{Knots, Spline, Thinning};

/// A spline with fewer knots, and how far its poles are from those it replaces.
#[derive(Clone, Debug, PartialEq)]
pub struct Simplified<S = f64> {
    /// The spline with fewer knots.
    pub spline: Spline<S>,
    /// How far a homogeneous pole of the original is, at most, from what inserting the knots again
    /// would give; 0 when none of them was needed.
    pub error: S,
}

/// The spline without the given knots of `axis`, each once for every time it is given; `None` removes
/// every inner knot that can be spared. Knot insertion run backwards.
///
/// A knot can be spared when no homogeneous pole moves by more than `accuracy` times the largest of
/// their coordinates; the errors of all that are removed stay below that together, the smaller knots
/// first. With accuracy 0 in exact arithmetic only what was inserted is removed, and nothing changes.
/// The work grows with the number of poles.
///
/// Errors: `Shape` when there is no such axis; `Domain` for a negative accuracy and for what is no
/// inner knot; `Accuracy` when a given knot is needed.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Spline, remove_knots};
/// let arch: Spline = Form::from_points(&[3], 2, &[0., 0., 1., 2., 2., 0.], None)?.into();
/// let cut = arch.insert_knots(0, &[0.5, 0.5, 0.75])?;
/// assert_eq!(remove_knots(&cut, 0, None, &1e-12)?.spline.net().orders(), [3]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn remove_knots<S: Scalar>(
    spline: &Spline<S>,
    axis: usize,
    knots: Option<&[S]>,
    accuracy: &S,
) -> Result<Simplified<S>> {
    spline.net().require_axis(axis)?;
    if !accuracy.is_finite() || *accuracy < S::zero() {
        return Err(Error::domain("accuracy", format!("{accuracy:?}"), "a number of at least 0"));
    }
    let largest = spline.net().homogeneous().iter().map(absolute).fold(S::zero(), larger);
    let allowance = largest * accuracy.clone();
    let mut left = Left { thinning: Thinning::new(spline, axis)?, error: S::zero(), allowance };
    if let Some(list) = knots {
        for knot in sorted(list, &spline.knots()[axis])? {
            if left.thinning.advance(knot) == 0 {
                return Err(no_knot(knot, "an inner knot, no more often than the spline has it"));
            }
            if !left.spare(knot)? {
                return Err(Error::accuracy(
                    "knots",
                    format!("{knot:?}, which the spline needs"),
                    "knots at which it is smooth enough to do without",
                ));
            }
        }
    } else {
        let breaks = spline.knots()[axis].breaks();
        for knot in breaks.iter().skip(1).take(breaks.len().saturating_sub(2)) {
            while left.thinning.advance(knot) > 0 && left.spare(knot)? {}
        }
    }
    Ok(Simplified { spline: left.thinning.finish()?, error: left.error })
}

/// The knots in their order, if all are within the window.
fn sorted<'a, S: Scalar>(list: &'a [S], knots: &Knots<S>) -> Result<Vec<&'a S>> {
    let (from, to) = knots.window();
    if let Some(knot) = list.iter().find(|knot| !(from < *knot && *knot < to)) {
        return Err(no_knot(knot, &format!("an inner knot, between {from:?} and {to:?}")));
    }
    let mut sorted: Vec<&S> = list.iter().collect();
    sorted.sort_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
    Ok(sorted)
}

fn no_knot<S: Scalar>(knot: &S, expected: &str) -> Error {
    Error::domain("knots", format!("{knot:?}"), expected)
}

/// What is left of a spline, and what that has cost.
struct Left<'a, S> {
    thinning: Thinning<'a, S>,
    error: S,
    allowance: S,
}

impl<S: Scalar> Left<'_, S> {
    /// Removes a knot once, if that costs no more than is left of the allowance.
    fn spare(&mut self, knot: &S) -> Result<bool> {
        let found = self.thinning.without(knot)?;
        let error = self.error.clone() + found.defect.clone();
        let spared = error <= self.allowance;
        if spared {
            self.error = error;
            self.thinning.accept(found);
        }
        Ok(spared)
    }
}

fn absolute<S: Scalar>(x: &S) -> S {
    if *x < S::zero() { -x.clone() } else { x.clone() }
}

fn larger<S: Scalar>(a: S, b: S) -> S {
    if b > a { b } else { a }
}
