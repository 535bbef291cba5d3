//! Several numbers at once, in the vectors of the machine.
//!
//! A [`Job`] is written once over [`Lanes`] of any instruction set `S`; [`in_lanes`] runs the copy
//! that was compiled for the widest one this machine has: AVX-512, AVX2, NEON, simd128 or plain
//! numbers. Nothing is fused and nothing reordered within a lane, so every machine gives the same
//! bits, the browser included.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider sets")]

use std::ops::{Add, Div, Mul, Neg, Sub};

use pulp::{Arch, WithSimd};

pub use pulp::Simd;

pub use crate::vector_rows::{bernstein, bernstein_slopes, line_sums};

/// The most lanes that any instruction set has.
pub const MOST: usize = 8;

/// As many numbers as a vector of `S` holds, side by side.
#[derive(Clone, Copy, Debug)]
pub struct Lanes<S: Simd> {
    simd: S,
    vector: S::f64s,
}

impl<S: Simd> Lanes<S> {
    /// How many numbers there are.
    pub const COUNT: usize = S::F64_LANES;

    /// The same number in every lane.
    #[inline(always)]
    pub fn splat(simd: S, x: f64) -> Self {
        Self { simd, vector: simd.splat_f64s(x) }
    }

    /// The first numbers of a list, which must have as many as there are lanes.
    #[inline(always)]
    pub fn load(simd: S, list: &[f64]) -> Self {
        let (vectors, _) = S::as_simd_f64s(&list[..S::F64_LANES]);
        Self { simd, vector: vectors[0] }
    }

    /// The first numbers of a list, and zeros where it is too short.
    #[inline(always)]
    pub fn load_some(simd: S, list: &[f64]) -> Self {
        if list.len() >= S::F64_LANES {
            return Self::load(simd, list);
        }
        Self { simd, vector: simd.partial_load_f64s(list) }
    }

    /// Writes the first numbers of a list, which must have as many as there are lanes.
    #[inline(always)]
    pub fn store(self, list: &mut [f64]) {
        let (vectors, _) = S::as_mut_simd_f64s(&mut list[..S::F64_LANES]);
        vectors[0] = self.vector;
    }

    /// The square roots.
    #[inline(always)]
    #[must_use]
    pub fn sqrt(self) -> Self {
        Self { vector: self.simd.sqrt_f64s(self.vector), ..self }
    }

    /// The absolute values.
    #[inline(always)]
    #[must_use]
    pub fn abs(self) -> Self {
        Self { vector: self.simd.abs_f64s(self.vector), ..self }
    }

    /// The larger of each pair; `other` where either is NaN.
    #[inline(always)]
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        self.if_above(other, self, other)
    }

    /// The smaller of each pair; `other` where either is NaN.
    #[inline(always)]
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        other.if_above(self, self, other)
    }

    /// Lane by lane `yes` where `self > least`, `no` elsewhere and for NaN.
    #[inline(always)]
    #[must_use]
    pub fn if_above(self, least: Self, yes: Self, no: Self) -> Self {
        let simd = self.simd;
        let mask = simd.greater_than_f64s(self.vector, least.vector);
        Self { simd, vector: simd.select_f64s(mask, yes.vector, no.vector) }
    }

    /// The numbers with other bits in the places of `mask`, which holds all of `bits`.
    #[inline(always)]
    #[must_use]
    pub fn with_bits(self, mask: u64, bits: u64) -> Self {
        let simd = self.simd;
        let kept = simd.and_u64s(simd.transmute_u64s_f64s(self.vector), simd.splat_u64s(!mask));
        let all = simd.or_u64s(kept, simd.splat_u64s(bits));
        Self { simd, vector: simd.transmute_f64s_u64s(all) }
    }

    /// The instruction set.
    #[inline(always)]
    pub fn simd(self) -> S {
        self.simd
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $vector:ident) => {
        impl<S: Simd> $trait for Lanes<S> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self { vector: self.simd.$vector(self.vector, other.vector), ..self }
            }
        }
    };
}

operator!(Add, add, add_f64s);
operator!(Sub, sub, sub_f64s);
operator!(Mul, mul, mul_f64s);
operator!(Div, div, div_f64s);

impl<S: Simd> Neg for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self { vector: self.simd.neg_f64s(self.vector), ..self }
    }
}

/// Work written over lanes of any instruction set.
///
/// `run` and all it calls must be `#[inline(always)]`: what is not inlined is compiled for the
/// narrowest vectors.
pub trait Job {
    /// What comes out.
    type Output;

    /// Does the work in vectors of `S`.
    fn run<S: Simd>(self, simd: S) -> Self::Output;
}

/// Does the work in the widest vectors of this machine.
///
/// ```
/// use pforms_kernel::vectors::{Job, Lanes, Simd, in_lanes};
///
/// struct Doubled<'a>(&'a mut [f64]);
///
/// impl Job for Doubled<'_> {
///     type Output = ();
///
///     #[inline(always)]
///     fn run<S: Simd>(self, simd: S) {
///         for part in self.0.chunks_exact_mut(Lanes::<S>::COUNT) {
///             (Lanes::load(simd, part) + Lanes::load(simd, part)).store(part);
///         }
///     }
/// }
///
/// let mut numbers = [1.0; 16];
/// in_lanes(Doubled(&mut numbers));
/// assert_eq!(numbers, [2.0; 16]);
/// ```
pub fn in_lanes<J: Job>(job: J) -> J::Output {
    #[cfg(test)]
    match WIDTH.get() {
        1 => return in_turn(job),
        #[cfg(target_arch = "x86_64")]
        4 => {
            if let Some(simd) = pulp::x86::V3::try_new() {
                return Simd::vectorize(simd, Compiled(job));
            }
        }
        _ => {}
    }
    // What a browser runs is compiled for vectors or not at all.
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    if let Some(simd) = pulp::wasm::Simd128::try_new() {
        return Simd::vectorize(simd, Compiled(job));
    }
    Arch::new().dispatch(Compiled(job))
}

/// Does the work with one number at a time, for scalars that no vector holds.
pub(crate) fn in_turn<J: Job>(job: J) -> J::Output {
    job.run(pulp::Scalar::new())
}

#[cfg(test)]
thread_local! {
    /// The width of vectors that a test asks for; the widest there are, unless it asks.
    pub(crate) static WIDTH: std::cell::Cell<usize> = const { std::cell::Cell::new(MOST) };
}

struct Compiled<J>(J);

impl<J: Job> WithSimd for Compiled<J> {
    type Output = J::Output;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> J::Output {
        self.0.run(simd)
    }
}
