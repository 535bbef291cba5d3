//! What a number must be able to do to be a coordinate.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider vectors")]

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use crate::flat::{self, Factored, Tap};
use crate::vectors::{self, Job, Simd};

/// A field with an order and a way to and from `f64`.
///
/// Algebra is written once over this trait and runs in `f64` for use, in [`crate::Rational`] for
/// proofs and teaching, and in [`crate::Dual`] for derivatives.
pub trait Scalar:
    Clone
    + Debug
    + PartialEq
    + PartialOrd
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
{
    /// Does arithmetic never round?
    const EXACT: bool;

    /// The neutral element of addition.
    fn zero() -> Self;

    /// The neutral element of multiplication.
    fn one() -> Self;

    /// An integer; exact up to 2⁵³ in `f64`.
    fn from_integer(value: i64) -> Self;

    /// The fraction `numerator / denominator`; `denominator` must not be 0.
    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::from_integer(numerator) / Self::from_integer(denominator)
    }

    /// The same number, exactly; `None` for NaN and infinities.
    fn from_f64(value: f64) -> Option<Self>;

    /// The nearest `f64`.
    fn to_f64(&self) -> f64;

    /// The root of one half, cosine and sine of half a right angle, if the field has it: with it a
    /// quarter circle has three poles.
    fn half_root() -> Option<Self> {
        None
    }

    /// Is this exactly 0?
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }

    /// Is this a number, neither NaN nor infinite?
    fn is_finite(&self) -> bool;

    /// `self` to a whole power; `0⁰ = 1`.
    #[must_use]
    fn power(&self, exponent: usize) -> Self {
        let mut result = Self::one();
        let mut square = self.clone();
        let mut rest = exponent;
        while rest > 0 {
            if rest & 1 == 1 {
                result = result * square.clone();
            }
            rest >>= 1;
            if rest > 0 {
                square = square.clone() * square;
            }
        }
        result
    }

    /// `target[i] += factor * source[i]`: the inner loop of every move.
    #[inline(always)]
    fn add_multiple(target: &mut [Self], factor: &Self, source: &[Self]) {
        for (sum, term) in target.iter_mut().zip(source) {
            *sum += factor.clone() * term.clone();
        }
    }

    /// Does work whose inner loops are over numbers of this kind: `f64` in the widest vectors of
    /// the machine, others one after another.
    fn in_lanes<J: Job>(job: J) -> J::Output {
        vectors::in_turn(job)
    }

    /// The inner loop of [`Flat::nest`](crate::Flat::nest).
    #[doc(hidden)]
    #[inline(always)]
    fn nest<V: Simd>(
        _: V,
        array: &mut [Self],
        before: usize,
        own: &[Tap<Self>],
        term: &Factored<'_, Self>,
        length: usize,
    ) {
        flat::nest(array, before, own, term, length);
    }
}

impl Scalar for f64 {
    const EXACT: bool = false;

    fn zero() -> Self {
        0.0
    }

    fn one() -> Self {
        1.0
    }

    fn from_integer(value: i64) -> Self {
        value as f64
    }

    fn from_f64(value: f64) -> Option<Self> {
        value.is_finite().then_some(value)
    }

    fn to_f64(&self) -> f64 {
        *self
    }

    fn half_root() -> Option<Self> {
        Some(std::f64::consts::FRAC_1_SQRT_2)
    }

    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }

    fn in_lanes<J: Job>(job: J) -> J::Output {
        vectors::in_lanes(job)
    }

    #[inline(always)]
    fn nest<V: Simd>(
        simd: V,
        array: &mut [Self],
        before: usize,
        own: &[Tap<Self>],
        term: &Factored<'_, Self>,
        length: usize,
    ) {
        flat::nest_in_lanes(simd, array, before, own, term, length);
    }
}
