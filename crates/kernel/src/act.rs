//! The loops behind acting along axes: block after block, so that what lies between two axes stays
//! in the cache.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider sets")]

use std::array::from_fn;
use std::ops::Range;

use smallvec::SmallVec;

use crate::threads::fill_parts;
use crate::vectors::{Job, Simd};
use crate::{Matrix, Result, Scalar};

/// Numbers that a group of blocks holds at most, unless a single one is larger.
const GROUP: usize = 1 << 12;

/// Matrices that act one after another on consecutive blocks of an array.
pub(crate) struct Steps<'a, S> {
    steps: SmallVec<[Step<'a, S>; 4]>,
    /// Numbers of a block before and after each step.
    sizes: SmallVec<[usize; 5]>,
}

/// A matrix and the number of numbers that belong to one index of its axis.
struct Step<'a, S> {
    matrix: &'a Matrix<S>,
    inner: usize,
    /// For every row the columns from its first entry that is not 0 to the last.
    spans: SmallVec<[Range<usize>; 8]>,
}

impl<'a, S: Scalar> Steps<'a, S> {
    /// Steps for blocks of so many numbers.
    pub(crate) fn new(block: usize) -> Self {
        Self { steps: SmallVec::new(), sizes: SmallVec::from_slice(&[block]) }
    }

    /// Acts along an axis too, when its matrix is applied `inner` numbers at a time.
    pub(crate) fn push(&mut self, matrix: &'a Matrix<S>, inner: usize) {
        let size = self.sizes[self.sizes.len() - 1] / matrix.columns() * matrix.rows();
        let spans = (0..matrix.rows()).map(|row| span(matrix.row(row))).collect();
        self.sizes.push(size);
        self.steps.push(Step { matrix, inner, spans });
    }

    /// Fills `out` with the blocks of `input` after all steps, of which there is at least one.
    pub(crate) fn run(&self, input: &[S], out: &mut [S]) -> Result<()> {
        let (Some(&before), Some(&after)) = (self.sizes.first(), self.sizes.last()) else {
            return Ok(());
        };
        let products = self.steps.iter().zip(&self.sizes[1..]);
        let cost: usize = products.map(|(step, size)| 2 * step.matrix.columns() * size).sum();
        fill_parts(out, after, cost, |blocks, out| {
            S::in_lanes(Part {
                steps: self,
                input: &input[blocks.start * before..blocks.end * before],
                out,
            });
            Ok(())
        })
    }
}

fn span<S: Scalar>(row: &[S]) -> Range<usize> {
    let first = row.iter().position(|entry| !entry.is_zero()).unwrap_or(0);
    let last = row.iter().rposition(|entry| !entry.is_zero()).unwrap_or(0);
    first..last + 1
}

/// Consecutive blocks, and the place for what becomes of them.
struct Part<'a, 'm, S> {
    steps: &'a Steps<'m, S>,
    input: &'a [S],
    out: &'a mut [S],
}

impl<S: Scalar> Job for Part<'_, '_, S> {
    type Output = ();

    #[inline(always)]
    fn run<V: Simd>(self, _: V) {
        let Steps { steps, sizes } = self.steps;
        let (Some((last, others)), before) = (steps.split_last(), sizes[0]) else { return };
        if others.is_empty() {
            return last.act(self.input, self.out);
        }
        let (between, after) = (&sizes[1..steps.len()], sizes[steps.len()]);
        let largest = between.iter().copied().max().unwrap_or(0).max(before).max(after);
        let group = (GROUP / largest).max(1);
        let room = group.min(self.out.len() / after) * largest;
        let (mut from, mut to) = (vec![S::zero(); room], vec![S::zero(); room]);
        let inputs = self.input.chunks(group * before);
        for (input, out) in inputs.zip(self.out.chunks_mut(group * after)) {
            let blocks = input.len() / before;
            let mut source = input;
            for (step, size) in others.iter().zip(between) {
                step.act(source, &mut to[..blocks * size]);
                std::mem::swap(&mut from, &mut to);
                source = &from[..blocks * size];
            }
            last.act(source, out);
        }
    }
}

impl<S: Scalar> Step<'_, S> {
    /// `out[a, r, k] = Σ_j M[r, j] · input[a, j, k]` for an array of shape `(·, columns, inner)`.
    #[inline(always)]
    fn act(&self, input: &[S], out: &mut [S]) {
        let (rows, columns) = (self.matrix.rows(), self.matrix.columns());
        let blocks = input.chunks_exact(columns * self.inner);
        for (block, part) in blocks.zip(out.chunks_exact_mut(rows * self.inner)) {
            match self.inner {
                3 => self.act_on_poles::<3>(block, part),
                4 => self.act_on_poles::<4>(block, part),
                _ => self.act_on_lines(block, part),
            }
        }
    }

    /// The same for a single block of poles.
    #[inline(always)]
    fn act_on_poles<const W: usize>(&self, block: &[S], out: &mut [S]) {
        let (poles, _) = block.as_chunks::<W>();
        let (places, _) = out.as_chunks_mut::<W>();
        for (row, (span, place)) in self.spans.iter().zip(places).enumerate() {
            let entries = &self.matrix.row(row)[span.clone()];
            *place = sum(entries, poles[span.clone()].iter());
        }
    }

    /// The same for a block of longer lines, a few numbers of each at a time.
    #[inline(always)]
    fn act_on_lines(&self, block: &[S], out: &mut [S]) {
        for (row, (span, line)) in
            self.spans.iter().zip(out.chunks_exact_mut(self.inner)).enumerate()
        {
            let entries = &self.matrix.row(row)[span.clone()];
            let lines = &block[span.start * self.inner..span.end * self.inner];
            let whole = self.inner / WIDE * WIDE;
            for at in (0..whole).step_by(WIDE) {
                let parts =
                    lines.chunks_exact(self.inner).filter_map(|line| line[at..].first_chunk());
                let total: [S; WIDE] = sum(entries, parts);
                line[at..at + WIDE].clone_from_slice(&total);
            }
            for at in whole..self.inner {
                let parts =
                    lines.chunks_exact(self.inner).filter_map(|line| line[at..].first_chunk());
                let [total] = sum(entries, parts);
                line[at] = total;
            }
        }
    }
}

/// Numbers summed at once: a register of the widest vectors, or a few of the others.
const WIDE: usize = 8;

/// `Σ entry · part`, from the first to the last.
#[inline(always)]
fn sum<'p, S: Scalar, const W: usize>(
    entries: &[S],
    mut parts: impl Iterator<Item = &'p [S; W]>,
) -> [S; W] {
    let Some(first) = parts.next() else { return from_fn(|_| S::zero()) };
    let mut total: [S; W] = from_fn(|k| entries[0].clone() * first[k].clone());
    for (entry, part) in entries[1..].iter().zip(parts) {
        for k in 0..W {
            total[k] += entry.clone() * part[k].clone();
        }
    }
    total
}
