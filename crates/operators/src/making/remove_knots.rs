//! The same spline with fewer knots.

use pforms_kernel::{Error, Result, Scalar};

use crate::algebra::Spline;

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
/// their coordinates; the errors of all that are removed stay below that together. With accuracy 0 in
/// exact arithmetic only what was inserted is removed, and nothing changes.
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
    let mut result = Simplified { spline: spline.clone(), error: S::zero() };
    if let Some(list) = knots {
        for knot in list {
            if !result.spare(axis, knot, &allowance)? {
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
            while result.spline.knots()[axis].multiplicity(knot) > 0
                && result.spare(axis, knot, &allowance)?
            {}
        }
    }
    Ok(result)
}

impl<S: Scalar> Simplified<S> {
    /// Removes a knot once, if that costs no more than is left of the allowance.
    fn spare(&mut self, axis: usize, knot: &S, allowance: &S) -> Result<bool> {
        let removal = self.spline.remove_knot(axis, knot)?;
        let error = self.error.clone() + removal.defect;
        let spared = error <= *allowance;
        if spared {
            *self = Self { spline: removal.spline, error };
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
