//! One crossing: do the two curves meet there, with one weight?

use pforms_kernel::{Error, Result, Scalar};

/// Complains unless homogeneous points of curves `[j, i]` are one: no more than `gap` apart, with
/// weights that differ by no more than `accuracy`.
pub(super) fn require<S: Scalar>(
    a: &[S],
    b: &[S],
    [j, i]: [usize; 2],
    gap: &S,
    accuracy: &S,
) -> Result<()> {
    let size = |x: S| if x < S::zero() { -x } else { x };
    let last = a.len() - 1;
    let (weight, other) = (&a[last], &b[last]);
    let curves = format!("curve {j} of us and curve {i} of vs");
    if weight.is_zero() || other.is_zero() {
        let received = format!("{curves} crossing at infinity");
        return Err(Error::domain("us", received, "crossings at finite points"));
    }
    let mut distance = 0.0_f64;
    let mut apart = false;
    for (x, y) in a[..last].iter().zip(b) {
        let difference = size(x.clone() / weight.clone() - y.clone() / other.clone());
        apart |= !difference.is_finite() || difference > *gap;
        distance = distance.hypot(difference.to_f64());
    }
    if apart {
        let received = format!("{curves} {distance} apart");
        return Err(Error::domain("us", received, "curves that meet at their parameters"));
    }
    if size(weight.clone() - other.clone()) > accuracy.clone() * size(weight.clone()) {
        let received = format!("{curves} with weights {weight:?} and {other:?}");
        let expected = "weights that agree at all crossings, up to a factor for each curve";
        return Err(Error::degenerate("us", received, expected));
    }
    Ok(())
}
