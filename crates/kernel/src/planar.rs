//! Points on their way out: homogeneous coordinates in columns, a few hundred points at a time.
//!
//! Sums over poles leave a vector of lanes for each coordinate; what is wanted are points, one
//! after another, divided by their weights. Through columns that stay in the first cache both loops
//! run over contiguous numbers.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; columns are counted, not iterated"
)]

use crate::jet::unreachable;
use crate::vectors::{Lanes, MOST, Simd};
use crate::{Form, Result};

/// Points held at most.
pub(crate) const BLOCK: usize = 256;

/// Length of a column: the last lanes may stand over.
const COLUMN: usize = BLOCK + MOST;

/// Columns of homogeneous coordinates, the weight last.
#[derive(Default)]
pub(crate) struct Planar {
    columns: Vec<[f64; COLUMN]>,
    summed: usize,
}

impl Planar {
    /// Makes room for the points of a form. A weight that all poles have is put down once.
    pub(crate) fn begin(&mut self, form: &Form<f64>) {
        self.columns.resize(form.width(), [0.0; COLUMN]);
        self.summed = form.width();
        if let (Some(weight), Some(weights)) = (form.uniform_weight(), self.columns.last_mut()) {
            weights.fill(*weight);
            self.summed = form.ambient();
        }
    }

    /// Number of components of a pole that have to be summed.
    #[inline(always)]
    pub(crate) fn summed(&self) -> usize {
        self.summed
    }

    /// Puts down some components of the points in the lanes, from point `at` on; the block ends at
    /// [`BLOCK`].
    #[inline(always)]
    pub(crate) fn put<S: Simd, const C: usize>(
        &mut self,
        first: usize,
        at: usize,
        components: &[Lanes<S>; C],
    ) {
        assert!(at <= BLOCK);
        let Some(columns) = self.columns[first..].first_chunk_mut::<C>() else { return };
        for c in 0..C {
            components[c].store(&mut columns[c][at..]);
        }
    }

    /// Projects as many points as `out` has room for, which are held from the first on.
    ///
    /// Errors: `Domain` when the weight vanishes at one of them or a coordinate overflows.
    #[inline(always)]
    pub(crate) fn project(&self, out: &mut [f64]) -> Result<()> {
        let doubts = match self.columns.len() {
            2 => self.divide::<1>(out),
            3 => self.divide::<2>(out),
            4 => self.divide::<3>(out),
            _ => self.divide_any(out),
        };
        if doubts == 0 { Ok(()) } else { self.complain(out) }
    }

    /// Divides by the weights. The dimension is known to the compiler, which interleaves the
    /// columns then; gathers the doubts about the results.
    #[inline(always)]
    fn divide<const C: usize>(&self, out: &mut [f64]) -> u64 {
        let (points, _) = out.as_chunks_mut::<C>();
        let columns = &self.columns;
        assert!(points.len() <= BLOCK && columns.len() == C + 1);
        let mut doubts = 0;
        for (i, point) in points.iter_mut().enumerate() {
            let weight = columns[C][i];
            doubts |= doubt(weight);
            for c in 0..C {
                point[c] = columns[c][i] / weight;
                doubts |= doubt(point[c]);
            }
        }
        doubts
    }

    /// The same in any dimension.
    fn divide_any(&self, out: &mut [f64]) -> u64 {
        let Some((weights, columns)) = self.columns.split_last() else { return 0 };
        let mut doubts = 0;
        for (i, point) in out.chunks_exact_mut(columns.len()).enumerate() {
            doubts |= doubt(weights[i]);
            for (x, column) in point.iter_mut().zip(columns) {
                *x = column[i] / weights[i];
                doubts |= doubt(*x);
            }
        }
        doubts
    }

    /// Complains about the first point that is not finite.
    #[cold]
    fn complain(&self, out: &[f64]) -> Result<()> {
        let Some((weights, columns)) = self.columns.split_last() else { return Ok(()) };
        let points = out.chunks_exact(columns.len()).zip(weights);
        let doubtful = |(point, weight): &(&[f64], &f64)| {
            !weight.is_finite() || point.iter().any(|x| !x.is_finite())
        };
        points.into_iter().find(doubtful).map_or(Ok(()), |(_, weight)| Err(unreachable(weight)))
    }
}

/// Zero for a finite number; a sum of these bits can be taken in vectors.
#[allow(clippy::eq_op, reason = "infinity less infinity is NaN")]
#[inline(always)]
pub(crate) fn doubt(x: f64) -> u64 {
    (x - x).to_bits()
}
