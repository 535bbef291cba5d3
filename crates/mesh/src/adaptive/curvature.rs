//! Second derivatives over a box of parameters, bounded by their poles.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::vectors::{Job, Simd, in_lanes};

use super::net::{Net, Quadruple, narrow};

/// Second derivatives of four functions on the unit box, as `mean ± spread`: `∂ᵤᵤ`, `∂ᵤᵥ`, `∂ᵥᵥ`.
pub(crate) struct Curvature {
    pub(crate) mean: [Quadruple; 3],
    pub(crate) spread: [Quadruple; 3],
}

/// Buffers that are used again.
#[derive(Default)]
pub(crate) struct Scratch {
    cell: Vec<Quadruple>,
    values: Vec<Quadruple>,
}

impl Scratch {
    /// The net that was looked at last.
    pub(crate) fn cell(&self) -> &[Quadruple] {
        &self.cell
    }
}

/// Takes the part of a net between two column parameters.
///
/// Returns the least and the greatest of its weights.
pub(crate) fn restrict(strip: &Net, columns: [f64; 2], scratch: &mut Scratch) -> [f64; 2] {
    in_lanes(Restriction { strip, columns, scratch })
}

/// The second derivatives of the functions whose values at a pole are `pole · columns`, on the
/// part taken last.
pub(crate) fn curvature(strip: &Net, columns: &[Quadruple; 4], scratch: &mut Scratch) -> Curvature {
    in_lanes(Measurement { strip, columns, scratch })
}

struct Restriction<'a> {
    strip: &'a Net,
    columns: [f64; 2],
    scratch: &'a mut Scratch,
}

impl Job for Restriction<'_> {
    type Output = [f64; 2];

    #[inline(always)]
    fn run<V: Simd>(self, _: V) -> [f64; 2] {
        restrict_here(self.strip, self.columns, self.scratch)
    }
}

struct Measurement<'a> {
    strip: &'a Net,
    columns: &'a [Quadruple; 4],
    scratch: &'a mut Scratch,
}

impl Job for Measurement<'_> {
    type Output = Curvature;

    #[inline(always)]
    fn run<V: Simd>(self, _: V) -> Curvature {
        curvature_here(self.strip, self.columns, self.scratch)
    }
}

/// [`restrict`] inside a job.
#[inline(always)]
pub(crate) fn restrict_here(strip: &Net, range: [f64; 2], scratch: &mut Scratch) -> [f64; 2] {
    let cell = &mut scratch.cell;
    cell.resize(strip.poles.len(), [0.0; 4]);
    // A constant width lets the compiler unroll what it knows, and keep a row in registers.
    match strip.columns {
        3 => narrow_rows::<3>(strip, range, cell),
        4 => narrow_rows::<4>(strip, range, cell),
        width => {
            cell.copy_from_slice(&strip.poles);
            for row in cell.chunks_exact_mut(width) {
                narrow(row, range);
            }
        }
    }
    let mut weights = [f64::INFINITY, f64::NEG_INFINITY];
    for pole in cell.iter() {
        weights = [weights[0].min(pole[3]), weights[1].max(pole[3])];
    }
    weights
}

#[inline(always)]
fn narrow_rows<const W: usize>(strip: &Net, range: [f64; 2], cell: &mut [Quadruple]) {
    let rows = strip.poles.as_chunks::<W>().0;
    for (to, from) in cell.as_chunks_mut::<W>().0.iter_mut().zip(rows) {
        let mut row = *from;
        narrow(&mut row, range);
        *to = row;
    }
}

/// [`curvature`] inside a job.
#[inline(always)]
pub(crate) fn curvature_here(
    strip: &Net,
    columns: &[Quadruple; 4],
    scratch: &mut Scratch,
) -> Curvature {
    let Scratch { cell, values } = scratch;
    let [a, b, c, d] = columns;
    values.resize(cell.len(), [0.0; 4]);
    for (value, [x, y, z, w]) in values.iter_mut().zip(cell.iter()) {
        for k in 0..4 {
            value[k] = (x * a[k] + y * b[k]) + (z * c[k] + w * d[k]);
        }
    }
    let mut ranges = Ranges([Range::EMPTY; 3]);
    match strip.columns {
        3 => ranges.include(values.as_chunks::<3>().0.iter().map(|row| &row[..])),
        4 => ranges.include(values.as_chunks::<4>().0.iter().map(|row| &row[..])),
        width => ranges.include(values.chunks_exact(width)),
    }
    ranges.curvature(strip)
}

/// Least and greatest second differences: down the columns, across, and along the rows.
struct Ranges([Range; 3]);

impl Ranges {
    #[inline(always)]
    fn include<'a>(&mut self, rows: impl Iterator<Item = &'a [Quadruple]> + Clone) {
        let [uu, uv, vv] = &mut self.0;
        for row in rows.clone() {
            for j in 2..row.len() {
                vv.include(&row[j], &row[j - 1], &row[j - 1], &row[j - 2]);
            }
        }
        for (row, next) in rows.clone().zip(rows.clone().skip(1)) {
            for j in 1..row.len().min(next.len()) {
                uv.include(&next[j], &next[j - 1], &row[j], &row[j - 1]);
            }
        }
        let second = rows.clone().skip(1);
        for ((row, next), last) in rows.clone().zip(second).zip(rows.skip(2)) {
            for j in 0..row.len().min(next.len()).min(last.len()) {
                uu.include(&last[j], &next[j], &next[j], &row[j]);
            }
        }
    }

    /// The second derivatives that belong to these differences.
    #[inline(always)]
    fn curvature(&self, net: &Net) -> Curvature {
        let [n, m] = [net.rows as f64 - 1.0, net.columns as f64 - 1.0];
        let factors = [n * (n - 1.0), n * m, m * (m - 1.0)];
        let mut curvature = Curvature { mean: [[0.0; 4]; 3], spread: [[0.0; 4]; 3] };
        for (kind, (range, factor)) in self.0.iter().zip(factors).enumerate() {
            // Without poles enough, the range is empty and the derivative vanishes.
            if factor > 0.0 {
                for k in 0..4 {
                    curvature.mean[kind][k] = 0.5 * factor * (range.low[k] + range.high[k]);
                    curvature.spread[kind][k] = 0.5 * factor * (range.high[k] - range.low[k]);
                }
            }
        }
        curvature
    }
}

impl Curvature {
    /// The second derivative along a step in the box, by the means.
    #[inline(always)]
    pub(crate) fn along(&self, [u, v]: [f64; 2]) -> Quadruple {
        combined(&self.mean, [u * u, 2.0 * u * v, v * v])
    }

    /// How far the second derivative along a step may be off.
    #[inline(always)]
    pub(crate) fn spread_along(&self, [u, v]: [f64; 2]) -> Quadruple {
        combined(&self.spread, [u * u, 2.0 * (u * v).abs(), v * v])
    }

    /// How far the sum of all second derivatives may be off.
    #[inline(always)]
    pub(crate) fn spread_sum(&self) -> Quadruple {
        combined(&self.spread, [1.0, 2.0, 1.0])
    }

    /// The largest second derivatives of one kind.
    #[inline(always)]
    pub(crate) fn largest(&self, kind: usize) -> Quadruple {
        let mut largest = self.spread[kind];
        for (sum, mean) in largest.iter_mut().zip(self.mean[kind]) {
            *sum += mean.abs();
        }
        largest
    }
}

#[inline(always)]
fn combined(of: &[Quadruple; 3], factors: [f64; 3]) -> Quadruple {
    let mut sum = [0.0; 4];
    for k in 0..4 {
        sum[k] = factors[0] * of[0][k] + factors[1] * of[1][k] + factors[2] * of[2][k];
    }
    sum
}

/// Least and greatest of some numbers, for four functions.
#[derive(Clone, Copy)]
struct Range {
    low: Quadruple,
    high: Quadruple,
}

impl Range {
    const EMPTY: Self = Self { low: [f64::INFINITY; 4], high: [f64::NEG_INFINITY; 4] };

    /// Includes `(a − b) − (c − d)`.
    #[inline(always)]
    fn include(&mut self, a: &Quadruple, b: &Quadruple, c: &Quadruple, d: &Quadruple) {
        for k in 0..4 {
            let value = (a[k] - b[k]) - (c[k] - d[k]);
            self.low[k] = if value < self.low[k] { value } else { self.low[k] };
            self.high[k] = if value > self.high[k] { value } else { self.high[k] };
        }
    }
}
