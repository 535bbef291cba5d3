//! What the last steps tell about the curvature of a function: the method of few memories (L-BFGS).

use super::system::Banded;
use crate::measuring::vector::dot;

/// Steps that are remembered.
const LENGTH: usize = 12;

/// The last steps and how the slope changed with them (Nocedal 1980).
#[derive(Default)]
pub(super) struct History {
    pairs: Vec<(Vec<f64>, Vec<f64>)>,
}

impl History {
    pub(super) fn clear(&mut self) {
        self.pairs.clear();
    }

    pub(super) fn is_empty(&self) -> bool {
        self.pairs.is_empty()
    }

    /// Remembers a step, unless the function bends down along it.
    pub(super) fn push(&mut self, step: Vec<f64>, change: Vec<f64>) {
        let bend = dot(&step, &change);
        if bend > f64::EPSILON * (dot(&step, &step) * dot(&change, &change)).sqrt() {
            if self.pairs.len() == LENGTH {
                self.pairs.remove(0);
            }
            self.pairs.push((step, change));
        }
    }

    /// The step from a slope to where it would vanish; `matrix` is what is known without history.
    pub(super) fn step(&self, slope: &[f64], matrix: &Banded<f64>, width: usize) -> Vec<f64> {
        let mut step: Vec<f64> = slope.iter().map(|x| -x).collect();
        let mut shares = Vec::with_capacity(self.pairs.len());
        for (s, y) in self.pairs.iter().rev() {
            let share = dot(s, &step) / dot(s, y);
            step.iter_mut().zip(y).for_each(|(x, y)| *x -= share * y);
            shares.push(share);
        }
        matrix.solve(&mut step, width);
        for ((s, y), share) in self.pairs.iter().zip(shares.iter().rev()) {
            let rest = share - dot(y, &step) / dot(s, y);
            step.iter_mut().zip(s).for_each(|(x, s)| *x += rest * s);
        }
        step
    }
}
