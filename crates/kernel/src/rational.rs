//! Exact fractions of big integers: the scalar of proofs, teaching and `explain`.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use crate::Scalar;

/// An exact fraction of two integers of any size, always in lowest terms.
pub type Rational = BigRational;

impl Scalar for Rational {
    const EXACT: bool = true;

    fn zero() -> Self {
        Zero::zero()
    }

    fn one() -> Self {
        One::one()
    }

    fn from_integer(value: i64) -> Self {
        BigRational::from_integer(BigInt::from(value))
    }

    fn ratio(numerator: i64, denominator: i64) -> Self {
        BigRational::new(BigInt::from(numerator), BigInt::from(denominator))
    }

    fn from_f64(value: f64) -> Option<Self> {
        BigRational::from_float(value)
    }

    fn to_f64(&self) -> f64 {
        ToPrimitive::to_f64(self).unwrap_or(f64::NAN)
    }

    fn is_zero(&self) -> bool {
        Zero::is_zero(self)
    }

    fn is_finite(&self) -> bool {
        true
    }

    fn add_multiple(target: &mut [Self], factor: &Self, source: &[Self]) {
        for (sum, term) in target.iter_mut().zip(source) {
            if !Zero::is_zero(term) {
                *sum += factor * term;
            }
        }
    }
}
