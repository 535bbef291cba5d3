//! The field of √2: numbers `a + b·√2` with fractions `a`, `b`, in which quarter circles are exact.

use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use pforms_kernel::{Rational, Scalar};

/// `rational + irrational·√2`, never rounded.
///
/// The poles of arcs of 90 and 45 degrees lie in this field, so an implicit equation of a rational
/// form built from them vanishes to the letter, or does not.
#[derive(Clone, Debug, PartialEq)]
pub struct Root2 {
    /// What is not multiplied by √2.
    pub rational: Rational,
    /// What is.
    pub irrational: Rational,
}

impl Root2 {
    /// A fraction.
    pub fn fraction(rational: Rational) -> Self {
        Self { rational, irrational: Scalar::zero() }
    }

    /// Negative, zero or positive, decided exactly: where the two parts disagree, the larger square
    /// wins.
    fn sign(&self) -> Ordering {
        let zero: Rational = Scalar::zero();
        let (a, b) = (self.rational.cmp(&zero), self.irrational.cmp(&zero));
        if a == b || b == Ordering::Equal {
            return a;
        }
        if a == Ordering::Equal {
            return b;
        }
        let squares = [
            self.rational.power(2),
            <Rational as Scalar>::from_integer(2) * self.irrational.power(2),
        ];
        if squares[0] > squares[1] { a } else { b }
    }
}

impl PartialOrd for Root2 {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some((self.clone() - other.clone()).sign())
    }
}

impl Add for Root2 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            rational: self.rational + other.rational,
            irrational: self.irrational + other.irrational,
        }
    }
}

impl AddAssign for Root2 {
    fn add_assign(&mut self, other: Self) {
        self.rational += other.rational;
        self.irrational += other.irrational;
    }
}

impl Sub for Root2 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Root2 {
    type Output = Self;
    fn neg(self) -> Self {
        Self { rational: -self.rational, irrational: -self.irrational }
    }
}

impl Mul for Root2 {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let two: Rational = Scalar::from_integer(2);
        Self {
            rational: &self.rational * &other.rational
                + two * (&self.irrational * &other.irrational),
            irrational: self.rational * other.irrational + self.irrational * other.rational,
        }
    }
}

impl Div for Root2 {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let two: Rational = Scalar::from_integer(2);
        let norm = other.rational.power(2) - two * other.irrational.power(2);
        let conjugate =
            Self { rational: other.rational / norm.clone(), irrational: -other.irrational / norm };
        self * conjugate
    }
}

impl Scalar for Root2 {
    const EXACT: bool = true;

    fn zero() -> Self {
        Self::fraction(Scalar::zero())
    }

    fn one() -> Self {
        Self::fraction(Scalar::one())
    }

    fn from_integer(value: i64) -> Self {
        Self::fraction(Scalar::from_integer(value))
    }

    fn from_f64(value: f64) -> Option<Self> {
        <Rational as Scalar>::from_f64(value).map(Self::fraction)
    }

    fn to_f64(&self) -> f64 {
        self.rational.to_f64() + self.irrational.to_f64() * std::f64::consts::SQRT_2
    }

    fn half_root() -> Option<Self> {
        Some(Self { rational: Scalar::zero(), irrational: Scalar::ratio(1, 2) })
    }

    fn is_finite(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_of_a_half_squares_to_a_half() {
        let k = Root2::half_root().unwrap();
        assert_eq!(k.clone() * k.clone(), Root2::ratio(1, 2));
        assert_eq!(Root2::one() / k.clone(), k.clone() + k.clone());
        assert!((k.to_f64() - std::f64::consts::FRAC_1_SQRT_2).abs() < 1e-16);
    }

    #[test]
    fn order_is_that_of_the_numbers() {
        let k = Root2::half_root().unwrap();
        assert!(k > Root2::ratio(7071, 10_000) && k < Root2::ratio(7072, 10_000));
        assert!(-k.clone() < Root2::zero() && k.clone() - Root2::one() < Root2::zero());
        assert!(k.is_finite() && !k.is_zero() && (k.clone() - k).is_zero());
    }
}
