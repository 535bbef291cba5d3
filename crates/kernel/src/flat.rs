//! Nested multiplication of polynomials: `sum ← s·sum + x·term`, in place.
//!
//! The coefficients of a polynomial in several variables, laid out with the strides of a larger one
//! and with zeros in the gaps, are those of a polynomial in one variable (Kronecker's substitution):
//! a product is a single convolution of contiguous numbers. [`Tap`]s say which; the zeros around a
//! [`Flat`] let whole vectors run over its ends.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use std::slice;

use crate::Scalar;
use crate::vectors::{Lanes, Simd};

/// Zeros kept before and after the coefficients: one block of vectors.
const GUARD: usize = 32;

/// One coefficient of a factor, and how many places it shifts what it multiplies.
#[derive(Clone, Debug)]
pub struct Tap<S> {
    /// Places towards the end.
    pub shift: usize,
    /// The coefficient.
    pub factor: S,
}

/// A polynomial laid out flat, zeros around it, in room for what it will grow to.
#[derive(Debug)]
pub struct Flat<'a, S> {
    array: &'a mut [S],
    length: usize,
}

impl<'a, S: Scalar> Flat<'a, S> {
    /// Numbers that an array needs to hold up to `length` coefficients.
    pub fn room(length: usize) -> usize {
        length + 2 * GUARD
    }

    /// The zero polynomial in an array of zeros that is [`Flat::room`] long.
    pub fn new(array: &'a mut [S]) -> Self {
        Self { array, length: 0 }
    }

    /// The coefficients in an array that is as long as they need.
    pub fn within(array: &[S]) -> &[S] {
        &array[GUARD..array.len() - GUARD]
    }

    /// The coefficients.
    #[inline(always)]
    pub fn coefficients(&self) -> &[S] {
        &self.array[GUARD..][..self.length]
    }

    /// The coefficients, to be changed.
    #[inline(always)]
    pub fn coefficients_mut(&mut self) -> &mut [S] {
        &mut self.array[GUARD..][..self.length]
    }

    /// Makes it the constant 1.
    #[inline(always)]
    pub fn set_one(&mut self) {
        self.set_length(1);
        self.array[GUARD] = S::one();
    }

    /// Gives it another number of coefficients, of which those before keep their values.
    #[inline(always)]
    pub fn set_length(&mut self, length: usize) {
        self.length = length;
        for zero in &mut self.array[GUARD + length..][..GUARD] {
            *zero = S::zero();
        }
    }

    /// Moves its rows, `run` coefficients each, apart to the given places, zeros between them.
    #[inline(always)]
    pub fn spread(&mut self, places: &[usize], run: usize) {
        let mut end = places.last().map_or(0, |last| last + run);
        self.set_length(end);
        let numbers = self.coefficients_mut();
        for (row, &place) in places.iter().enumerate().rev() {
            numbers[place + run..end].fill(S::zero());
            end = place;
            for k in (0..run).rev() {
                numbers[place + k] = numbers[row * run + k].clone();
            }
        }
    }

    /// Takes the rows of another polynomial, `run` coefficients each, to the given places.
    #[inline(always)]
    pub fn spread_from(&mut self, other: &Flat<'_, S>, places: &[usize], run: usize) {
        self.set_length(places.last().map_or(0, |last| last + run));
        let numbers = self.coefficients_mut();
        let mut end = 0;
        for (&place, row) in places.iter().zip(other.coefficients().chunks_exact(run)) {
            numbers[end..place].fill(S::zero());
            end = place + run;
            numbers[place..end].clone_from_slice(row);
        }
    }

    /// `self ← own·self + other·term`, each factor given by its taps in increasing order.
    ///
    /// `simd` is that of a [`crate::vectors::Job`].
    #[inline(always)]
    pub fn nest<V: Simd>(&mut self, simd: V, own: &[Tap<S>], term: &Flat<'_, S>, other: &[Tap<S>]) {
        let reach = |length: usize, taps: &[Tap<S>]| length + taps.last().map_or(0, |t| t.shift);
        let length = reach(self.length, own).max(reach(term.length, other));
        let term = Factored { array: term.array, length: term.length, taps: other };
        S::nest(simd, self.array, self.length, own, &term, length);
        self.set_length(length);
    }

    /// `self ← own·self`.
    #[inline(always)]
    pub fn multiply<V: Simd>(&mut self, simd: V, own: &[Tap<S>]) {
        let nothing = Flat { array: &mut [], length: 0 };
        self.nest(simd, own, &nothing, &[]);
    }
}

/// A flat polynomial and the taps of its factor.
#[derive(Clone, Copy, Debug)]
pub struct Factored<'a, S> {
    array: &'a [S],
    length: usize,
    taps: &'a [Tap<S>],
}

/// The definition of nesting, for any scalar: from the last coefficient to the first, since each
/// needs only those before it.
pub(crate) fn nest<S: Scalar>(
    array: &mut [S],
    before: usize,
    own: &[Tap<S>],
    term: &Factored<'_, S>,
    length: usize,
) {
    for k in (0..length).rev() {
        let mut sum = S::zero();
        let mut add = |array: &[S], length: usize, taps: &[Tap<S>]| {
            for tap in taps.iter().take_while(|tap| tap.shift <= k) {
                if k - tap.shift < length {
                    let coefficient = &array[GUARD + k - tap.shift];
                    let sum = slice::from_mut(&mut sum);
                    S::add_multiple(sum, &tap.factor, slice::from_ref(coefficient));
                }
            }
        };
        add(array, before, own);
        add(term.array, term.length, term.taps);
        array[GUARD + k] = sum;
    }
}

/// The same in vectors: four of 8 numbers, or eight of fewer, at a time.
#[inline(always)]
pub(crate) fn nest_in_lanes<V: Simd>(
    simd: V,
    array: &mut [f64],
    before: usize,
    own: &[Tap<f64>],
    term: &Factored<'_, f64>,
    length: usize,
) {
    match V::F64_LANES {
        8 => nest_in_blocks::<V, 4>(simd, array, before, own, term, length),
        _ => nest_in_blocks::<V, 8>(simd, array, before, own, term, length),
    }
}

#[inline(always)]
fn nest_in_blocks<V: Simd, const B: usize>(
    simd: V,
    array: &mut [f64],
    before: usize,
    own: &[Tap<f64>],
    term: &Factored<'_, f64>,
    length: usize,
) {
    let lanes = V::F64_LANES;
    let mut vectors = length.div_ceil(lanes);
    if !vectors.is_multiple_of(2) {
        vectors -= 1;
        block::<V, 1>(simd, array, before, own, term, vectors * lanes);
    }
    while !vectors.is_multiple_of(B) {
        vectors -= 2;
        block::<V, 2>(simd, array, before, own, term, vectors * lanes);
    }
    while vectors > 0 {
        vectors -= B;
        block::<V, B>(simd, array, before, own, term, vectors * lanes);
    }
}

/// `B` vectors of the result, from coefficient `at` on.
#[inline(always)]
fn block<V: Simd, const B: usize>(
    simd: V,
    array: &mut [f64],
    before: usize,
    own: &[Tap<f64>],
    term: &Factored<'_, f64>,
    at: usize,
) {
    let mut sum = [Lanes::splat(simd, 0.0); B];
    let itself = Factored { array, length: before, taps: own };
    add_taps(&mut sum, &itself, at);
    add_taps(&mut sum, term, at);
    let target = &mut array[GUARD + at..][..B * V::F64_LANES];
    for v in 0..B {
        sum[v].store(&mut target[v * V::F64_LANES..]);
    }
}

#[inline(always)]
fn add_taps<V: Simd, const B: usize>(
    sum: &mut [Lanes<V>; B],
    factored: &Factored<'_, f64>,
    at: usize,
) {
    let Factored { array, length, mut taps } = *factored;
    let (simd, lanes) = (sum[0].simd(), V::F64_LANES);
    while let [first, others @ ..] = taps
        && first.shift + length <= at
    {
        taps = others;
    }
    while let [others @ .., last] = taps
        && last.shift >= at + B * lanes
    {
        taps = others;
    }
    for tap in taps {
        let source = &array[GUARD + at - tap.shift..][..B * lanes];
        let factor = Lanes::splat(simd, tap.factor);
        for v in 0..B {
            sum[v] = sum[v] + factor * Lanes::load(simd, &source[v * lanes..]);
        }
    }
}
