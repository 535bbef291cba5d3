//! Numbers that know how much of them may be rounding.

use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use pforms_kernel::Scalar;

/// A value and the size of what went into it: its error is a few `ε` times the size.
///
/// Running error analysis (Wilkinson; Higham, *Accuracy and Stability of Numerical Algorithms*,
/// section 3.3). It decides "is this derivative zero?" at the scale of the data at hand, where a
/// fixed threshold would depend on the unit of length.
///
/// The value may be of more digits than an `f64`; its `ε` is smaller then.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Guarded<V = f64> {
    pub value: V,
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

impl<V: Scalar> From<V> for Guarded<V> {
    fn from(value: V) -> Self {
        Self { size: value.to_f64().abs(), value }
    }
}

impl<V: Scalar> PartialEq for Guarded<V> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<V: Scalar> PartialOrd for Guarded<V> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<V: Scalar> Add for Guarded<V> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, size: self.size + other.size }
    }
}

impl<V: Scalar> AddAssign for Guarded<V> {
    fn add_assign(&mut self, other: Self) {
        self.value += other.value;
        self.size += other.size;
    }
}

impl<V: Scalar> Neg for Guarded<V> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, size: self.size }
    }
}

impl<V: Scalar> Sub for Guarded<V> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<V: Scalar> Mul for Guarded<V> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (one, two) = (self.value.to_f64().abs(), other.value.to_f64().abs());
        Self { value: self.value * other.value, size: one * other.size + self.size * two }
    }
}

impl<V: Scalar> Div for Guarded<V> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let below = other.value.to_f64().abs();
        let value = self.value / other.value;
        Self { size: (self.size + value.to_f64().abs() * other.size) / below, value }
    }
}

impl<V: Scalar> Scalar for Guarded<V> {
    const EXACT: bool = false;

    fn zero() -> Self {
        Self::from(V::zero())
    }

    fn one() -> Self {
        Self::from(V::one())
    }

    fn from_integer(value: i64) -> Self {
        Self::from(V::from_integer(value))
    }

    fn from_f64(value: f64) -> Option<Self> {
        V::from_f64(value).map(Self::from)
    }

    fn to_f64(&self) -> f64 {
        self.value.to_f64()
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
