//! Dual numbers: a value and its derivative in one direction.

use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use crate::Scalar;

/// `value + slope·ε` with `ε² = 0`. Running an operator on dual poles gives, exactly, the
/// derivative of its result in the direction of the slopes.
///
/// Comparison looks at both parts for `==` and at the value alone for `<`.
///
/// ```
/// use pforms_kernel::{Dual, Form};
/// let moving = Form::from_homogeneous(&[2], 1, vec![
///     Dual::constant(0.0), Dual::constant(1.0),
///     Dual { value: 1.0, slope: 1.0 }, Dual::constant(1.0),
/// ])?;
/// let point = moving.at(&[Dual::constant(0.25)])?;
/// assert_eq!(point[0].slope, 0.25); // the point follows the moved pole by B₁(1/4)
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Dual<S = f64> {
    /// The number itself.
    pub value: S,
    /// Its derivative in the chosen direction.
    pub slope: S,
}

impl<S: Scalar> Dual<S> {
    /// A number that does not move.
    pub fn constant(value: S) -> Self {
        Dual { value, slope: S::zero() }
    }
}

impl<S: Scalar> PartialOrd for Dual<S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<S: Scalar> Add for Dual<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Dual { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl<S: Scalar> AddAssign for Dual<S> {
    fn add_assign(&mut self, other: Self) {
        self.value += other.value;
        self.slope += other.slope;
    }
}

impl<S: Scalar> Sub for Dual<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Dual { value: self.value - other.value, slope: self.slope - other.slope }
    }
}

impl<S: Scalar> Mul for Dual<S> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Dual {
            slope: self.slope * other.value.clone() + self.value.clone() * other.slope,
            value: self.value * other.value,
        }
    }
}

impl<S: Scalar> Div for Dual<S> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value.clone();
        Dual { slope: (self.slope - value.clone() * other.slope) / other.value, value }
    }
}

impl<S: Scalar> Neg for Dual<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Dual { value: -self.value, slope: -self.slope }
    }
}

impl<S: Scalar> Scalar for Dual<S> {
    const EXACT: bool = S::EXACT;

    fn zero() -> Self {
        Self::constant(S::zero())
    }

    fn one() -> Self {
        Self::constant(S::one())
    }

    fn from_integer(value: i64) -> Self {
        Self::constant(S::from_integer(value))
    }

    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::constant(S::ratio(numerator, denominator))
    }

    fn from_f64(value: f64) -> Option<Self> {
        S::from_f64(value).map(Self::constant)
    }

    fn to_f64(&self) -> f64 {
        self.value.to_f64()
    }

    fn half_root() -> Option<Self> {
        S::half_root().map(Self::constant)
    }

    fn is_finite(&self) -> bool {
        self.value.is_finite() && self.slope.is_finite()
    }
}
