//! The cap on what a drawing may occupy, counted in samples.

use pforms_kernel::{Error, Result, limit};

/// Bytes of a sample: its point, its normal and its share of the triangles.
const BYTES: u128 = 64;

/// Complains when something with `factors[0] × factors[1] × …` samples would exceed the cap.
///
/// Errors: `Limit`.
pub fn require_room(what: &str, factors: &[usize]) -> Result<()> {
    let samples = factors.iter().fold(1_u128, |product, &n| product.saturating_mul(n as u128));
    let (bytes, cap) = (samples.saturating_mul(BYTES), u128::from(limit::cap()));
    if bytes <= cap {
        return Ok(());
    }
    let factors: Vec<String> = factors.iter().map(usize::to_string).collect();
    let what = format!("{what} would have {} samples", factors.join("×"));
    Err(Error::Limit { what, bytes, cap })
}
