//! Numbers that know how much of them may be rounding.

use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use pforms_kernel::Scalar;

/// A value and the size of what went into it: its error is a few `ε` times the size.
///
/// Running error analysis (Wilkinson; Higham, *Accuracy and Stability of Numerical Algorithms*,
/// section 3.3). It decides "is this derivative zero?" at the scale of the data at hand, where a
/// fixed threshold would depend on the unit of length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Guarded {
    pub value: f64,
    pub size: f64,
}

/// Roundings that a value below its own noise may hold; generous, since sizes are bounds.
const ROUNDINGS: f64 = 32.0;

/// Is the vector more than rounding?
pub(crate) fn significant(vector: &[Guarded]) -> bool {
    let value = vector.iter().fold(0.0_f64, |most, x| most.max(x.value.abs()));
    let size = vector.iter().fold(0.0_f64, |most, x| most.max(x.size));
    value > ROUNDINGS * f64::EPSILON * size
}

pub(crate) fn values(vector: &[Guarded]) -> Vec<f64> {
    vector.iter().map(|x| x.value).collect()
}

impl From<f64> for Guarded {
    fn from(value: f64) -> Self {
        Self { value, size: value.abs() }
    }
}

impl PartialEq for Guarded {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl PartialOrd for Guarded {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl Add for Guarded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, size: self.size + other.size }
    }
}

impl AddAssign for Guarded {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Neg for Guarded {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, size: self.size }
    }
}

impl Sub for Guarded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Guarded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            size: self.value.abs() * other.size + self.size * other.value.abs(),
        }
    }
}

impl Div for Guarded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, size: (self.size + value.abs() * other.size) / other.value.abs() }
    }
}

impl Scalar for Guarded {
    const EXACT: bool = false;

    fn zero() -> Self {
        Self::from(0.0)
    }

    fn one() -> Self {
        Self::from(1.0)
    }

    fn from_integer(value: i64) -> Self {
        Self::from(value as f64)
    }

    fn from_f64(value: f64) -> Option<Self> {
        value.is_finite().then(|| Self::from(value))
    }

    fn to_f64(&self) -> f64 {
        self.value
    }

    fn is_finite(&self) -> bool {
        self.value.is_finite() && self.size.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_of_equals_is_noise_at_any_scale() {
        for scale in [1e-200, 1.0, 1e200] {
            let third = Guarded::from(scale) / Guarded::from(3.0);
            let rest = third + third + third - Guarded::from(scale * (1.0 + f64::EPSILON));
            assert!(!significant(&[rest]));
            assert!(significant(&[third - Guarded::from(scale * 0.3333)]));
        }
    }
}
