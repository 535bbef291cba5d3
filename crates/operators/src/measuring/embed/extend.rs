//! Points beyond the window, where the outermost pieces of the cage go on.

use pforms_kernel::Result;

use super::jet::Jet;
use super::matrix::inverse;
use super::{Embedder, NUMBERS, Place};

/// Newton's steps at most.
const STEPS: usize = 64;

/// No step is longer, in windows of a piece.
const LONGEST: f64 = 0.5;

/// The cage is not continued farther than this, in windows of its outermost pieces.
const FARTHEST: f64 = 8.0;

impl Embedder {
    /// Finds parameters for the points of rows that are outside, where it can.
    pub(super) fn extend(&self, points: &[f64], out: &mut [f64]) -> Result<()> {
        let axes = self.cage.axes();
        let mut placed = vec![0.0; axes];
        for (point, row) in points.chunks_exact(axes).zip(out.chunks_exact_mut(axes + NUMBERS)) {
            if row[axes + 1] == 0.0 {
                self.cage.place(point, &mut placed)?;
                self.continued(&placed, row);
            }
        }
        Ok(())
    }

    /// Newton's steps from the nearest box of the grid, from piece to piece.
    fn continued(&self, point: &[f64], row: &mut [f64]) {
        let (cage, axes) = (&self.cage, self.cage.axes());
        let (mut index, mut at) = self.beginning(point);
        let mut jet = Jet::new(cage);
        let size = point.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
        for _ in 0..STEPS {
            jet.at(cage, &cage.pieces[cage.number(&index)], &at, point);
            let left: f64 = jet.value.iter().map(|x| x.abs()).sum();
            if jet.weight.is_nan() || jet.weight <= 1e-3 * cage.least_weight {
                return;
            }
            let Some(slopes) = inverse(&jet.slopes, axes) else { return };
            let noise = cage.noise * size * growth(&cage.orders, &at);
            if left <= 4.0 * noise {
                for k in 0..axes {
                    row[k] = cage.continued_parameter(k, index[k], at[k]);
                }
                let residual = (left + noise) / jet.weight;
                row[axes] = cage.length(residual);
                row[axes + 1] = -1.0;
                return;
            }
            let step =
                |row: &[f64]| -> f64 { row.iter().zip(&jet.value).map(|(a, g)| a * g).sum() };
            let steps: Vec<f64> = slopes.chunks_exact(axes).map(step).collect();
            let longest = steps.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            let share = if longest > LONGEST { LONGEST / longest } else { 1.0 };
            for k in 0..axes {
                at[k] -= share * steps[k];
                self.hop(k, &mut index[k], &mut at[k]);
            }
            if at.iter().any(|t| !((-FARTHEST..=1.0 + FARTHEST).contains(t))) {
                return;
            }
        }
    }

    /// A piece and parameters to begin with.
    fn beginning(&self, point: &[f64]) -> (Vec<usize>, Vec<f64>) {
        let (cage, axes) = (&self.cage, self.cage.axes());
        let mut at = vec![0.5; axes];
        match self.guide.place(cage, self.guide.nearest(point)) {
            Place::Single(start) => {
                let mut whole = [0.0; 4];
                whole[..axes].copy_from_slice(&self.guide.within(point));
                at.iter_mut().zip(start.guess(&whole)).for_each(|(t, to)| *t = to.clamp(0.0, 1.0));
                (cage.index(start.piece), at)
            }
            _ => (cage.counts.iter().map(|count| count / 2).collect(), at),
        }
    }

    /// Goes over to the neighbour that a parameter lies in.
    fn hop(&self, axis: usize, piece: &mut usize, t: &mut f64) {
        let breaks = &self.cage.breaks[axis];
        let length = |piece: usize| breaks[piece + 1] - breaks[piece];
        if *t > 1.0 && *piece + 1 < self.cage.counts[axis] {
            *t = ((*t - 1.0) * length(*piece) / length(*piece + 1)).min(1.0);
            *piece += 1;
        } else if *t < 0.0 && *piece > 0 {
            *t = (1.0 + *t * length(*piece) / length(*piece - 1)).max(0.0);
            *piece -= 1;
        }
    }
}

/// By how much Bernstein polynomials, and the rounding of their sums, grow beyond the window.
fn growth(orders: &[usize], at: &[f64]) -> f64 {
    let factor = |(order, t): (&usize, &f64)| (t.abs() + (1.0 - t).abs()).powi(*order as i32 - 1);
    orders.iter().zip(at).map(factor).product()
}
