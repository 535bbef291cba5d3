//! What one number and several side by side have in common, so that the equations are written once.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider sets")]

use std::ops::{Add, Div, Mul, Neg, Sub};

use pforms_kernel::vectors::{Lanes, Simd};

pub(super) trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A constant, as wide as this number.
    fn like(self, x: f64) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn like(self, x: f64) -> Self {
        x
    }
}

impl<S: Simd> Number for Lanes<S> {
    #[inline(always)]
    fn like(self, x: f64) -> Self {
        Self::splat(self.simd(), x)
    }
}
