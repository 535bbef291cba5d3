//! Bernstein polynomials at several parameters at once.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider sets")]

use crate::lanes::Lanes;

/// The Bernstein polynomials of degree `row.len() − 1` at `N` parameters, by the triangle of
/// de Casteljau; up to degree 7 in registers.
#[inline(always)]
pub fn bernstein<const N: usize>(t: Lanes<N>, row: &mut [Lanes<N>]) {
    match row.len() {
        2 => row.copy_from_slice(&short_row::<N, 2>(t)),
        3 => row.copy_from_slice(&short_row::<N, 3>(t)),
        4 => row.copy_from_slice(&short_row::<N, 4>(t)),
        5 => row.copy_from_slice(&short_row::<N, 5>(t)),
        6 => row.copy_from_slice(&short_row::<N, 6>(t)),
        7 => row.copy_from_slice(&short_row::<N, 7>(t)),
        8 => row.copy_from_slice(&short_row::<N, 8>(t)),
        _ => triangle(t, row),
    }
}

/// [`bernstein`] and the derivatives `B_j′ = n·(B_{j−1} − B_j)`, from the row of degree `n − 1`.
#[inline(always)]
pub fn bernstein_slopes<const N: usize>(
    t: Lanes<N>,
    row: &mut [Lanes<N>],
    slopes: &mut [Lanes<N>],
) {
    let degree = row.len() - 1;
    slopes[0] = Lanes::ZERO;
    if degree > 0 {
        bernstein(t, &mut slopes[..degree]);
        let factor = Lanes::splat(degree as f64);
        let mut left = Lanes::ZERO;
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
pub(crate) fn short_row<const N: usize, const O: usize>(t: Lanes<N>) -> [Lanes<N>; O] {
    let mut row = [Lanes::ZERO; O];
    triangle(t, &mut row);
    row
}

#[inline(always)]
fn triangle<const N: usize>(t: Lanes<N>, row: &mut [Lanes<N>]) {
    let s = Lanes::ONE - t;
    row[0] = Lanes::ONE;
    for degree in 1..row.len() {
        let mut left = Lanes::ZERO;
        for entry in &mut row[..degree] {
            let above = *entry;
            *entry = s * above + left;
            left = t * above;
        }
        row[degree] = left;
    }
}
