//! Several numbers at once: plain arithmetic, compiled for every instruction set.
//!
//! A [`Job`] is written once over [`Lanes`]; [`in_lanes`] runs the copy of it that was compiled for
//! the widest vectors of the machine it finds itself on. Nothing is fused and nothing reordered
//! within a lane, so every machine gives the same bits, the browser included.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use std::ops::{Add, Div, Mul, Neg, Sub};

#[cfg(not(target_arch = "wasm32"))]
use pulp::{Arch, Simd, WithSimd};

pub use crate::lanes_basis::{bernstein, bernstein_slopes};

/// The most lanes that any instruction set has.
pub const MOST: usize = 8;

/// `N` numbers side by side: 2 in a register of SSE2 or NEON, 4 of AVX2, 8 of AVX-512; 4 in two of
/// WebAssembly.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Lanes<const N: usize>(pub [f64; N]);

impl<const N: usize> Lanes<N> {
    /// Zeros.
    pub const ZERO: Self = Self([0.0; N]);

    /// Ones.
    pub const ONE: Self = Self([1.0; N]);

    /// The same number in every lane.
    #[inline(always)]
    pub fn splat(x: f64) -> Self {
        Self([x; N])
    }

    /// The first `N` numbers of a list, which must have so many.
    #[inline(always)]
    pub fn load(list: &[f64]) -> Self {
        let mut lanes = [0.0; N];
        lanes.copy_from_slice(&list[..N]);
        Self(lanes)
    }

    /// [`Lanes::load`], with the last number again where the list is too short; it is not empty.
    #[inline(always)]
    pub fn load_some(list: &[f64]) -> Self {
        if list.len() >= N {
            return Self::load(list);
        }
        let mut lanes = [list[list.len() - 1]; N];
        lanes[..list.len()].copy_from_slice(list);
        Self(lanes)
    }

    /// Writes the first `N` numbers of a list, which must have so many.
    #[inline(always)]
    pub fn store(self, list: &mut [f64]) {
        list[..N].copy_from_slice(&self.0);
    }

    /// A function of each lane.
    #[inline(always)]
    #[must_use]
    pub fn map(mut self, function: impl Fn(f64) -> f64) -> Self {
        for k in 0..N {
            self.0[k] = function(self.0[k]);
        }
        self
    }

    /// A function of the same lane of two.
    #[inline(always)]
    #[must_use]
    pub fn zip(mut self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self {
        for k in 0..N {
            self.0[k] = function(self.0[k], other.0[k]);
        }
        self
    }

    /// The square roots.
    #[inline(always)]
    #[must_use]
    pub fn sqrt(self) -> Self {
        #[cfg(target_arch = "wasm32")]
        if N.is_multiple_of(2) {
            return crate::simd128::sqrt(self);
        }
        self.map(f64::sqrt)
    }
}

impl<const N: usize> Add for Lanes<N> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        #[cfg(target_arch = "wasm32")]
        if N.is_multiple_of(2) {
            return crate::simd128::add(self, other);
        }
        self.zip(other, |a, b| a + b)
    }
}

impl<const N: usize> Sub for Lanes<N> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        #[cfg(target_arch = "wasm32")]
        if N.is_multiple_of(2) {
            return crate::simd128::sub(self, other);
        }
        self.zip(other, |a, b| a - b)
    }
}

impl<const N: usize> Mul for Lanes<N> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        #[cfg(target_arch = "wasm32")]
        if N.is_multiple_of(2) {
            return crate::simd128::mul(self, other);
        }
        self.zip(other, |a, b| a * b)
    }
}

impl<const N: usize> Div for Lanes<N> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        #[cfg(target_arch = "wasm32")]
        if N.is_multiple_of(2) {
            return crate::simd128::div(self, other);
        }
        self.zip(other, |a, b| a / b)
    }
}

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

/// Work written over lanes of any width.
///
/// `run` and all it calls must be `#[inline(always)]`: what is not inlined is compiled for the
/// narrowest vectors.
pub trait Job {
    /// What comes out.
    type Output;

    /// Does the work, `N` numbers at a time.
    fn run<const N: usize>(self) -> Self::Output;
}

/// Does the work in the widest vectors of this machine.
///
/// ```
/// use pforms_kernel::lanes::{Job, Lanes, in_lanes};
///
/// struct Doubled<'a>(&'a mut [f64]);
///
/// impl Job for Doubled<'_> {
///     type Output = ();
///
///     #[inline(always)]
///     fn run<const N: usize>(self) {
///         for part in self.0.chunks_exact_mut(N) {
///             (Lanes::<N>::load(part) * Lanes::splat(2.0)).store(part);
///         }
///     }
/// }
///
/// let mut numbers = [1.0; 16];
/// in_lanes(Doubled(&mut numbers));
/// assert_eq!(numbers, [2.0; 16]);
/// ```
pub fn in_lanes<J: Job>(job: J) -> J::Output {
    // A browser compiles for its machine itself; two vectors at a time keep it busy.
    #[cfg(target_arch = "wasm32")]
    return job.run::<4>();
    #[cfg(not(target_arch = "wasm32"))]
    Arch::new().dispatch(Compiled(job))
}

#[cfg(not(target_arch = "wasm32"))]
struct Compiled<J>(J);

#[cfg(not(target_arch = "wasm32"))]
impl<J: Job> WithSimd for Compiled<J> {
    type Output = J::Output;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> J::Output {
        match S::F64_LANES {
            8 => self.0.run::<8>(),
            4 => self.0.run::<4>(),
            _ => self.0.run::<2>(),
        }
    }
}
