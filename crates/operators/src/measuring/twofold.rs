//! Numbers of twice the precision, for the few factors on which many roundings would pile up.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use pforms_kernel::Scalar;

/// The unevaluated sum `high + low`, `low` below half a unit of `high`.
///
/// Over `f64` about 106 bits (Dekker, *A floating-point technique for extending the available
/// precision*, Numer. Math. 18, 1971); over exact scalars `low` is 0 and nothing is gained or lost.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(crate) struct Twofold<S = f64> {
    high: S,
    low: S,
}

impl<S: Scalar> Twofold<S> {
    /// A number of the plain scalar, unchanged.
    pub(crate) fn from_plain(value: S) -> Self {
        Self { high: value, low: S::zero() }
    }

    /// The nearest number of the plain scalar.
    pub(crate) fn to_plain(&self) -> S {
        self.high.clone()
    }

    /// `a + b` and its rounding error (Knuth).
    fn sum(a: S, b: S) -> Self {
        let high = a.clone() + b.clone();
        if S::EXACT {
            return Self::from_plain(high);
        }
        let part = high.clone() - a.clone();
        let low = (a - (high.clone() - part.clone())) + (b - part);
        Self { high, low }
    }

    /// `a·b` and its rounding error (Dekker).
    fn product(a: &S, b: &S) -> Self {
        let high = a.clone() * b.clone();
        if S::EXACT {
            return Self::from_plain(high);
        }
        let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
        let rest = a1.clone() * b1.clone() - high.clone();
        let low = rest + a1 * b2.clone() + a2.clone() * b1 + a2 * b2;
        Self { high, low }
    }

    fn plus_small(self, small: S) -> Self {
        Self::sum(self.high, self.low + small)
    }
}

/// A number of 53 bits as the sum of two of 26 (Veltkamp).
fn halves<S: Scalar>(a: &S) -> (S, S) {
    let shifted = S::from_integer((1 << 27) + 1) * a.clone();
    let high = shifted.clone() - (shifted - a.clone());
    (high.clone(), a.clone() - high)
}

impl<S: Scalar> Add for Twofold<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let lows = Self::sum(self.low, other.low);
        let total = Self::sum(self.high, other.high).plus_small(lows.high);
        total.plus_small(lows.low)
    }
}

impl<S: Scalar> AddAssign for Twofold<S> {
    fn add_assign(&mut self, other: Self) {
        *self = self.clone() + other;
    }
}

impl<S: Scalar> Neg for Twofold<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl<S: Scalar> Sub for Twofold<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<S: Scalar> Mul for Twofold<S> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let crossed = self.high.clone() * other.low + self.low * other.high.clone();
        Self::product(&self.high, &other.high).plus_small(crossed)
    }
}

impl<S: Scalar> Div for Twofold<S> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let mut rest = self;
        let mut quotient = Self::zero();
        for _ in 0..3 {
            let digit = Self::from_plain(rest.high.clone() / other.high.clone());
            rest = rest - digit.clone() * other.clone();
            quotient += digit;
        }
        quotient
    }
}

/// An integer without these fits the 53 bits of an `f64`.
const LAST_BITS: i64 = 1 << 11;

impl<S: Scalar> Scalar for Twofold<S> {
    const EXACT: bool = S::EXACT;

    fn zero() -> Self {
        Self::from_plain(S::zero())
    }

    fn one() -> Self {
        Self::from_plain(S::one())
    }

    fn from_integer(value: i64) -> Self {
        let low = value % LAST_BITS;
        Self::sum(S::from_integer(value - low), S::from_integer(low))
    }

    fn from_f64(value: f64) -> Option<Self> {
        S::from_f64(value).map(Self::from_plain)
    }

    fn to_f64(&self) -> f64 {
        self.high.to_f64()
    }

    fn is_finite(&self) -> bool {
        self.high.is_finite() && self.low.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pforms_kernel::Rational;

    #[test]
    fn a_third_to_thirty_digits() {
        let third = Twofold::<f64>::ratio(1, 3);
        let exact = |x: f64| Rational::from_f64(x).unwrap();
        let error = exact(third.high) + exact(third.low) - Rational::ratio(1, 3);
        assert!(error.to_f64().abs() < 1e-32);
        let nothing = third * Twofold::from_integer(3) - Twofold::one();
        assert!(nothing.high.abs() < 1e-31);
        let power = third.power(40);
        let error = exact(power.high) + exact(power.low) - Rational::ratio(1, 3).power(40);
        assert!((error / Rational::ratio(1, 3).power(40)).to_f64().abs() < 1e-29);
    }

    #[test]
    fn integers_are_exact() {
        for value in [i64::MAX, i64::MIN, (1 << 53) + 1, -7, 0] {
            let twofold = Twofold::<f64>::from_integer(value);
            let parts = [twofold.high, twofold.low].map(|x| Rational::from_f64(x).unwrap());
            let [high, low] = parts;
            assert_eq!(high + low, <Rational as Scalar>::from_integer(value));
        }
    }
}
