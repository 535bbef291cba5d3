//! Points on their way out: homogeneous coordinates in columns, a few hundred points at a time.
//!
//! Sums over poles leave a vector of lanes for each coordinate; what is wanted are points, one
//! after another, divided by their weights. Through columns that stay in the first cache both loops
//! run over contiguous numbers.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider sets")]

use crate::jet::unreachable;
use crate::lanes::{Lanes, MOST};
use crate::{Form, Result};

/// Points held at most.
pub(crate) const BLOCK: usize = 256;

/// Length of a column: the last lanes may stand over.
const COLUMN: usize = BLOCK + MOST;

/// Columns of homogeneous coordinates: the weight last, or not at all when all poles share one.
#[derive(Default)]
pub(crate) struct Planar {
    numbers: Vec<f64>,
    ambient: usize,
    uniform: Option<f64>,
}

impl Planar {
    /// Makes room for the points of a form.
    pub(crate) fn begin(&mut self, form: &Form<f64>) {
        self.ambient = form.ambient();
        self.uniform = form.uniform_weight().copied();
        let columns = form.width() - usize::from(self.uniform.is_some());
        self.numbers.resize(columns * COLUMN, 0.0);
    }

    /// Number of columns: the components of a pole that have to be summed.
    #[inline(always)]
    pub(crate) fn columns(&self) -> usize {
        self.numbers.len() / COLUMN
    }

    /// Puts down some components of `N` points, from point `at` on; the block ends at [`BLOCK`].
    #[inline(always)]
    pub(crate) fn put<const N: usize, const C: usize>(
        &mut self,
        first: usize,
        at: usize,
        components: &[Lanes<N>; C],
    ) {
        for (component, column) in
            components.iter().zip(self.numbers.chunks_exact_mut(COLUMN).skip(first))
        {
            component.store(&mut column[at..]);
        }
    }

    /// Projects as many points as `out` has room for, which are held from the first on.
    ///
    /// Errors: `Domain` when the weight vanishes at one of them or a coordinate overflows.
    #[inline(always)]
    pub(crate) fn project(&self, out: &mut [f64]) -> Result<()> {
        match self.ambient {
            1 => self.project_in::<1>(out),
            2 => self.project_in::<2>(out),
            3 => self.project_in::<3>(out),
            _ => self.project_any(out),
        }
    }

    /// The same with the dimension known to the compiler, which interleaves the columns then.
    #[inline(always)]
    fn project_in<const C: usize>(&self, out: &mut [f64]) -> Result<()> {
        let (points, _) = out.as_chunks_mut::<C>();
        let (columns, _) = self.numbers.as_chunks::<COLUMN>();
        let (points, columns) = (&mut points[..], &columns[..self.columns()]);
        assert!(points.len() <= BLOCK && columns.len() >= C);
        let mut doubts = 0;
        match self.uniform {
            Some(1.0) => {
                for (i, point) in points.iter_mut().enumerate() {
                    for c in 0..C {
                        point[c] = columns[c][i];
                        doubts |= doubt(point[c]);
                    }
                }
            }
            Some(weight) => {
                for (i, point) in points.iter_mut().enumerate() {
                    for c in 0..C {
                        point[c] = columns[c][i] / weight;
                        doubts |= doubt(point[c]);
                    }
                }
            }
            None => {
                let weights = &columns[C];
                for (i, point) in points.iter_mut().enumerate() {
                    doubts |= doubt(weights[i]);
                    for c in 0..C {
                        point[c] = columns[c][i] / weights[i];
                        doubts |= doubt(point[c]);
                    }
                }
            }
        }
        self.certify(doubts, out)
    }

    fn project_any(&self, out: &mut [f64]) -> Result<()> {
        let mut doubts = 0;
        for (i, point) in out.chunks_exact_mut(self.ambient).enumerate() {
            let weight = self.weight(i);
            doubts |= doubt(weight);
            for (x, column) in point.iter_mut().zip(self.numbers.chunks_exact(COLUMN)) {
                *x = column[i] / weight;
                doubts |= doubt(*x);
            }
        }
        self.certify(doubts, out)
    }

    fn weight(&self, i: usize) -> f64 {
        self.uniform.unwrap_or_else(|| self.numbers[self.ambient * COLUMN + i])
    }

    /// Complains about the first point that is not finite.
    #[inline(always)]
    fn certify(&self, doubts: u64, out: &[f64]) -> Result<()> {
        if doubts == 0 { Ok(()) } else { self.complain(out) }
    }

    #[cold]
    fn complain(&self, out: &[f64]) -> Result<()> {
        let points =
            out.chunks_exact(self.ambient).map(|point| point.iter().all(|x| x.is_finite()));
        let finite = |(i, finite): (usize, bool)| finite && self.weight(i).is_finite();
        match points.enumerate().position(|pair| !finite(pair)) {
            Some(i) => Err(unreachable(&self.weight(i))),
            None => Ok(()),
        }
    }
}

/// Zero for a finite number; a sum of these bits can be taken in vectors.
#[allow(clippy::eq_op, reason = "infinity less infinity is NaN")]
#[inline(always)]
fn doubt(x: f64) -> u64 {
    (x - x).to_bits()
}
