//! Sums of the poles of a piece with rows of basis values and of their derivatives, in lanes.
//!
//! Pieces of one or two axes count as volumes with one layer of poles, or one line.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::vectors::{Lanes, Simd, bernstein, bernstein_slopes};

/// Rows along three axes.
pub(super) trait Rows<S: Simd> {
    /// Takes the values and derivatives at parameters, those of the last axes.
    fn fill<const D: usize>(&mut self, at: &[Lanes<S>; D]);

    /// Takes the values alone.
    fn fill_values<const D: usize>(&mut self, at: &[Lanes<S>; D]);

    /// The values and the derivatives along an axis.
    fn row(&self, axis: usize) -> (&[Lanes<S>], &[Lanes<S>]);

    /// The sums with the values, then with the derivatives along each axis.
    #[inline(always)]
    fn jet<const W: usize>(&self, poles: &[[f64; W]]) -> [[Lanes<S>; W]; 4] {
        let [(u, u1), (v, v1), (w, w1)] = [self.row(0), self.row(1), self.row(2)];
        let zero = Lanes::splat(u[0].simd(), 0.0);
        let mut all = [[zero; W]; 4];
        let layers = poles.chunks_exact(v.len() * w.len());
        for ((layer, u), u1) in layers.zip(u).zip(u1) {
            let mut part = [[zero; W]; 3];
            for ((line, v), v1) in layer.chunks_exact(w.len()).zip(v).zip(v1) {
                let (sum, slope) = line_jet(w, w1, line);
                for c in 0..W {
                    part[0][c] = part[0][c] + *v * sum[c];
                    part[1][c] = part[1][c] + *v1 * sum[c];
                    part[2][c] = part[2][c] + *v * slope[c];
                }
            }
            for c in 0..W {
                all[0][c] = all[0][c] + *u * part[0][c];
                all[1][c] = all[1][c] + *u1 * part[0][c];
                all[2][c] = all[2][c] + *u * part[1][c];
                all[3][c] = all[3][c] + *u * part[2][c];
            }
        }
        all
    }

    /// The sums with the values.
    #[inline(always)]
    fn value<const W: usize>(&self, poles: &[[f64; W]]) -> [Lanes<S>; W] {
        let [u, v, w] = [self.row(0).0, self.row(1).0, self.row(2).0];
        let zero = Lanes::splat(u[0].simd(), 0.0);
        let mut all = [zero; W];
        for (layer, u) in poles.chunks_exact(v.len() * w.len()).zip(u) {
            let mut part = [zero; W];
            for (line, v) in layer.chunks_exact(w.len()).zip(v) {
                let sum = line_sum(w, line);
                for c in 0..W {
                    part[c] = part[c] + *v * sum[c];
                }
            }
            for c in 0..W {
                all[c] = all[c] + *u * part[c];
            }
        }
        all
    }
}

#[inline(always)]
fn line_jet<S: Simd, const W: usize>(
    values: &[Lanes<S>],
    slopes: &[Lanes<S>],
    line: &[[f64; W]],
) -> ([Lanes<S>; W], [Lanes<S>; W]) {
    let simd = values[0].simd();
    let zero = Lanes::splat(simd, 0.0);
    let (mut sum, mut slope) = ([zero; W], [zero; W]);
    for ((pole, value), rise) in line.iter().zip(values).zip(slopes) {
        for c in 0..W {
            let x = Lanes::splat(simd, pole[c]);
            sum[c] = sum[c] + *value * x;
            slope[c] = slope[c] + *rise * x;
        }
    }
    (sum, slope)
}

#[inline(always)]
fn line_sum<S: Simd, const W: usize>(values: &[Lanes<S>], line: &[[f64; W]]) -> [Lanes<S>; W] {
    let simd = values[0].simd();
    let mut sum = [Lanes::splat(simd, 0.0); W];
    for (pole, value) in line.iter().zip(values) {
        for c in 0..W {
            sum[c] = sum[c] + *value * Lanes::splat(simd, pole[c]);
        }
    }
    sum
}

/// Rows of a volume of `O` poles along each axis, which stay in registers.
pub(super) struct Cube<S: Simd, const O: usize> {
    values: [[Lanes<S>; O]; 3],
    slopes: [[Lanes<S>; O]; 3],
}

impl<S: Simd, const O: usize> Cube<S, O> {
    #[inline(always)]
    pub(super) fn new(simd: S) -> Self {
        let zeros = [[Lanes::splat(simd, 0.0); O]; 3];
        Self { values: zeros, slopes: zeros }
    }
}

impl<S: Simd, const O: usize> Rows<S> for Cube<S, O> {
    #[inline(always)]
    fn fill<const D: usize>(&mut self, at: &[Lanes<S>; D]) {
        for k in 0..D {
            bernstein_slopes(at[k], &mut self.values[k], &mut self.slopes[k]);
        }
    }

    #[inline(always)]
    fn fill_values<const D: usize>(&mut self, at: &[Lanes<S>; D]) {
        for k in 0..D {
            bernstein(at[k], &mut self.values[k]);
        }
    }

    #[inline(always)]
    fn row(&self, axis: usize) -> (&[Lanes<S>], &[Lanes<S>]) {
        (&self.values[axis], &self.slopes[axis])
    }
}

/// Rows of any lengths.
pub(super) struct Any<S: Simd> {
    values: [Vec<Lanes<S>>; 3],
    slopes: [Vec<Lanes<S>>; 3],
}

impl<S: Simd> Any<S> {
    /// Along axes that are not there the only value is 1 and its derivative 0.
    #[inline(always)]
    pub(super) fn new(simd: S, orders: &[usize]) -> Self {
        let missing = 3 - orders.len().min(3);
        let order = |axis: usize| if axis < missing { 1 } else { orders[axis - missing] };
        let rows = |x: f64| [0, 1, 2].map(|axis| vec![Lanes::splat(simd, x); order(axis)]);
        Self { values: rows(1.0), slopes: rows(0.0) }
    }
}

impl<S: Simd> Rows<S> for Any<S> {
    #[inline(always)]
    fn fill<const D: usize>(&mut self, at: &[Lanes<S>; D]) {
        for k in 0..D {
            let axis = 3 - D + k;
            bernstein_slopes(at[k], &mut self.values[axis], &mut self.slopes[axis]);
        }
    }

    #[inline(always)]
    fn fill_values<const D: usize>(&mut self, at: &[Lanes<S>; D]) {
        for k in 0..D {
            bernstein(at[k], &mut self.values[3 - D + k]);
        }
    }

    #[inline(always)]
    fn row(&self, axis: usize) -> (&[Lanes<S>], &[Lanes<S>]) {
        (&self.values[axis], &self.slopes[axis])
    }
}
