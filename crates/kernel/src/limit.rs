//! The cap on what one result may occupy: checked before anything is allocated.

use std::sync::atomic::{AtomicU64, Ordering};

use crate::{Error, Result, Scalar};

/// The cap that holds until somebody changes it: 1 GiB for one result.
pub const DEFAULT_CAP: u64 = 1 << 30;

static CAP: AtomicU64 = AtomicU64::new(DEFAULT_CAP);

/// Bytes that one result may occupy.
pub fn cap() -> u64 {
    CAP.load(Ordering::Relaxed)
}

/// Changes the cap for the whole process; takes effect at the next allocation.
pub fn set_cap(bytes: u64) {
    CAP.store(bytes, Ordering::Relaxed);
}

/// Number of scalars in an array of these orders and this width, and their bytes, or a
/// [`Error::Limit`] when that is above the [`cap`].
///
/// `what` completes the sentence "… would have 27×27×27 poles".
pub fn check<S>(what: &str, orders: &[usize], width: usize) -> Result<usize> {
    let poles = orders
        .iter()
        .try_fold(1u128, |product, &order| product.checked_mul(order as u128))
        .unwrap_or(u128::MAX);
    let bytes = poles.saturating_mul(width as u128).saturating_mul(size_of::<S>() as u128);
    let cap = u128::from(cap());
    if bytes <= cap {
        return Ok(poles as usize * width);
    }
    let orders: Vec<String> = orders.iter().map(usize::to_string).collect();
    Err(Error::Limit { what: format!("{what} would have {} poles", orders.join("×")), bytes, cap })
}

/// The highest degree whose binomials are all finite `f64`s: `C(1029, 514)` is the last.
pub const HIGHEST_FLOATING_DEGREE: usize = 1029;

/// Complains about a degree whose binomials overflow; exact arithmetic has no such limit.
///
/// Errors: `Accuracy` above [`HIGHEST_FLOATING_DEGREE`].
pub fn check_degree<S: Scalar>(degree: usize) -> Result<()> {
    if S::EXACT || degree <= HIGHEST_FLOATING_DEGREE {
        return Ok(());
    }
    Err(Error::accuracy(
        "degree",
        degree,
        format!("at most {HIGHEST_FLOATING_DEGREE} in floating arithmetic"),
    ))
}

/// A size a person can read: `630 kB`, `84 GB`.
pub fn readable(bytes: u128) -> String {
    const UNITS: [&str; 6] = ["B", "kB", "MB", "GB", "TB", "PB"];
    let mut size = bytes as f64;
    let mut unit = 0;
    while size >= 1000.0 && unit + 1 < UNITS.len() {
        size /= 1000.0;
        unit += 1;
    }
    if size >= 1e6 {
        return format!("{size:.1e} {}", UNITS[unit]);
    }
    if size < 10.0 && unit > 0 {
        format!("{size:.1} {}", UNITS[unit])
    } else {
        format!("{size:.0} {}", UNITS[unit])
    }
}
