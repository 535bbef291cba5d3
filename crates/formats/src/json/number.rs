//! A coordinate in a file: an `f64`, or an exact fraction as a string.

use pforms_kernel::{Rational, Scalar};
use serde_json::Value;

/// Digits a fraction may have: more than any computed by hand, too few to stall a reader.
const MOST_DIGITS: usize = 10_000;

/// A scalar that a file can hold.
pub trait Number: Scalar {
    /// From a JSON number.
    fn from_float(number: f64) -> Option<Self>;

    /// From an exact fraction.
    fn from_fraction(fraction: Rational) -> Self;

    /// The number as it is written.
    fn to_json(&self) -> Value;
}

impl Number for f64 {
    fn from_float(number: f64) -> Option<Self> {
        Some(number)
    }

    fn from_fraction(fraction: Rational) -> Self {
        fraction.to_f64()
    }

    fn to_json(&self) -> Value {
        Value::from(*self)
    }
}

impl Number for Rational {
    fn from_float(number: f64) -> Option<Self> {
        Self::from_f64(number)
    }

    fn from_fraction(fraction: Rational) -> Self {
        fraction
    }

    fn to_json(&self) -> Value {
        Value::from(self.to_string())
    }
}

/// Reads `-7` or `22/7`.
pub(crate) fn fraction(text: &str) -> Option<Rational> {
    let digits = |part: &str| {
        let digits = part.strip_prefix('-').unwrap_or(part);
        !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
    };
    let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
    let plain = text.len() <= MOST_DIGITS && digits(numerator) && digits(denominator);
    let nonzero = denominator.bytes().any(|digit| !matches!(digit, b'0' | b'-'));
    if plain && nonzero { text.parse().ok() } else { None }
}
