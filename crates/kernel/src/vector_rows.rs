//! Rows of basis values at several parameters at once, and sums of poles with them.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; components are counted"
)]

use crate::vectors::{Lanes, Simd};

/// The Bernstein polynomials of degree `row.len() − 1` at the parameters of the lanes, by the
/// triangle of de Casteljau; up to degree 7 in registers.
#[inline(always)]
pub fn bernstein<S: Simd>(t: Lanes<S>, row: &mut [Lanes<S>]) {
    match row.len() {
        2 => row.copy_from_slice(&short_row::<S, 2>(t)),
        3 => row.copy_from_slice(&short_row::<S, 3>(t)),
        4 => row.copy_from_slice(&short_row::<S, 4>(t)),
        5 => row.copy_from_slice(&short_row::<S, 5>(t)),
        6 => row.copy_from_slice(&short_row::<S, 6>(t)),
        7 => row.copy_from_slice(&short_row::<S, 7>(t)),
        8 => row.copy_from_slice(&short_row::<S, 8>(t)),
        _ => triangle(t, row),
    }
}

/// [`bernstein`] and the derivatives `B_j′ = n·(B_{j−1} − B_j)`, from the row of degree `n − 1`.
#[inline(always)]
pub fn bernstein_slopes<S: Simd>(t: Lanes<S>, row: &mut [Lanes<S>], slopes: &mut [Lanes<S>]) {
    let degree = row.len() - 1;
    let zero = Lanes::splat(t.simd(), 0.0);
    slopes[degree] = zero;
    if degree > 0 {
        bernstein(t, &mut slopes[..degree]);
        let factor = Lanes::splat(t.simd(), degree as f64);
        let mut left = zero;
        for slope in &mut slopes[..degree] {
            let here = factor * *slope;
            *slope = left - here;
            left = here;
        }
        slopes[degree] = left;
    }
    bernstein(t, row);
}

/// [`bernstein`] in an array of the right length.
#[inline(always)]
pub(crate) fn short_row<S: Simd, const O: usize>(t: Lanes<S>) -> [Lanes<S>; O] {
    let mut row = [t; O];
    triangle(t, &mut row);
    row
}

#[inline(always)]
fn triangle<S: Simd>(t: Lanes<S>, row: &mut [Lanes<S>]) {
    let one = Lanes::splat(t.simd(), 1.0);
    let s = one - t;
    row[0] = one;
    for degree in 1..row.len() {
        let mut left = t * row[0];
        row[0] = s * row[0];
        for entry in &mut row[1..degree] {
            let above = *entry;
            *entry = s * above + left;
            left = t * above;
        }
        row[degree] = left;
    }
}

/// `Σ value · pole` of the first `C` components along a line of poles, which is not empty.
#[inline(always)]
pub fn line_sums<S: Simd, const W: usize, const C: usize>(
    values: &[Lanes<S>],
    line: &[[f64; W]],
) -> [Lanes<S>; C] {
    let simd = values[0].simd();
    let mut sum = [values[0]; C];
    for c in 0..C {
        sum[c] = values[0] * Lanes::splat(simd, line[0][c]);
    }
    for (value, pole) in values[1..].iter().zip(&line[1..]) {
        for c in 0..C {
            sum[c] = sum[c] + *value * Lanes::splat(simd, pole[c]);
        }
    }
    sum
}

/// [`line_sums`] for the first component of poles of any `width`.
#[inline(always)]
pub(crate) fn column_sum<S: Simd>(values: &[Lanes<S>], line: &[f64], width: usize) -> Lanes<S> {
    let simd = values[0].simd();
    let mut sum = values[0] * Lanes::splat(simd, line[0]);
    for (value, pole) in values[1..].iter().zip(line[width.min(line.len())..].chunks(width)) {
        sum = sum + *value * Lanes::splat(simd, pole[0]);
    }
    sum
}
