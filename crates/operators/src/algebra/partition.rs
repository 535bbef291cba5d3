//! The dyadic partition of an interval.

use pforms_kernel::{Error, Result, Scalar, limit};

/// The `2^r + 1` numbers that halving `[a, b]` again and again, `r` times, leaves (wiki 10).
///
/// Number `k` is `((2^r − k)·a + k·b) / 2^r`; the ends are `a` and `b` to the bit.
///
/// Errors: `Domain` when `a` or `b` is not finite, `Limit` when the list is too long.
///
/// ```
/// assert_eq!(pforms_operators::partition(&0.0, &1.0, 2)?, [0.0, 0.25, 0.5, 0.75, 1.0]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn partition<S: Scalar>(a: &S, b: &S, r: u32) -> Result<Vec<S>> {
    for (name, end) in [("a", a), ("b", b)] {
        if !end.is_finite() {
            return Err(Error::domain(name, format!("{end:?}"), "a finite number"));
        }
    }
    let parts = parts("r", r)?;
    limit::check::<S>("the partition", &[parts + 1], 1)?;
    let fraction = |k: usize| S::ratio(k as i64, parts as i64);
    Ok((0..=parts).map(|k| fraction(parts - k) * a.clone() + fraction(k) * b.clone()).collect())
}

/// `2^r`, the number of parts after halving `r` times.
pub(super) fn parts(argument: &str, r: u32) -> Result<usize> {
    1usize
        .checked_shl(r)
        .filter(|parts| *parts as u64 <= 1 << 40)
        .ok_or_else(|| Error::domain(argument, r, "0 to 40 halvings"))
}
