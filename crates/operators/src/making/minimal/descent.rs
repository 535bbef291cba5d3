//! Descent on the area of a surface by its free poles.

use pforms_kernel::Result;

use super::history::History;
use super::metric::Metric;
use super::patch::Patch;
use super::system::Banded;
use crate::measuring::vector::dot;

/// Where a descent ended.
pub(super) struct Descent {
    /// The coordinates of all poles.
    pub coordinates: Vec<f64>,
    /// Steps taken.
    pub steps: usize,
}

/// Steps at most.
const STEPS: usize = 400;

/// Steps until the metric is looked at again.
const REFRESH: usize = 12;

/// Rounding of a sum of areas, as a part of it.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Pivots below this part of their diagonal are rounding: the matrix guides steps, and need not be exact.
pub(super) const FLOOR: f64 = 1e-13;

/// The area to be made least.
///
/// With the metric of the surface held fixed, the Dirichlet energy is at least the area of any other
/// surface, and equal to that of this one: the step to its least value never makes the area larger, as
/// U. Pinkall and K. Polthier do with triangles (1993). That step is the first; later ones learn from
/// those before them, and each is taken only if the area does not grow.
pub(super) struct Least<'a> {
    pub patch: &'a Patch,
    pub free: &'a [usize],
    pub ambient: usize,
    pub size: f64,
}

struct State {
    coordinates: Vec<f64>,
    area: f64,
    /// The least area so far.
    lowest: f64,
    slope: Vec<f64>,
}

impl Least<'_> {
    /// From these coordinates down, until the slope is at most `accuracy` or no step lowers the area.
    pub(super) fn descend(&self, coordinates: Vec<f64>, accuracy: f64) -> Result<Descent> {
        let mut state = self.state(coordinates);
        let mut history = History::default();
        let mut matrix = self.matrix(&state)?;
        let (mut steps, mut age) = (0, 0);
        let mut left = self.slope_size(&state, &matrix);
        while steps < STEPS && left > accuracy {
            let step = history.step(&state.slope, &matrix, self.ambient);
            let Some(next) = self.along(&state, &step) else {
                if age == 0 && history.is_empty() {
                    break;
                }
                history.clear();
                (matrix, age) = (self.matrix(&state)?, 0);
                continue;
            };
            history.push(
                difference(&self.taken(&next.coordinates), &self.taken(&state.coordinates)),
                difference(&next.slope, &state.slope),
            );
            state = next;
            (steps, age) = (steps + 1, age + 1);
            if age == REFRESH {
                (matrix, age) = (self.matrix(&state)?, 0);
            }
            left = self.slope_size(&state, &matrix);
        }
        Ok(Descent { coordinates: state.coordinates, steps })
    }

    /// The size of the slope as a part of the root of the area: `√(gᵀ·A⁻¹·g / area)`, with the matrix
    /// `A` of the Dirichlet energy in the metric of the surface. Half its square is the part of the
    /// area that the next step is expected to win.
    fn slope_size(&self, state: &State, matrix: &Banded<f64>) -> f64 {
        let mut solved = state.slope.clone();
        matrix.solve(&mut solved, self.ambient);
        let square = dot(&solved, &state.slope).max(0.0);
        if square == 0.0 || state.area <= 0.0 { 0.0 } else { (square / state.area).sqrt() }
    }

    /// The slope that is left at coordinates, without a step.
    pub(super) fn slope_at(&self, coordinates: &[f64]) -> Result<f64> {
        let state = self.state(coordinates.to_vec());
        Ok(self.slope_size(&state, &self.matrix(&state)?))
    }

    /// A state down along the step: the whole of it, or less of it.
    fn along(&self, state: &State, step: &[f64]) -> Option<State> {
        let fall = dot(step, &state.slope);
        if fall >= 0.0 {
            return None;
        }
        let mut share = 1.0;
        for _ in 0..24 {
            let coordinates = self.moved(&state.coordinates, step, share);
            let area = self.patch.area(&coordinates);
            let enough = area <= state.area + 1e-4 * share * fall;
            if enough || area <= (1.0 + ROUNDING) * state.lowest {
                let next = self.state(coordinates);
                // Where the area no longer tells, the slope does.
                if enough || dot(step, &next.slope).abs() <= -0.9 * fall {
                    return Some(State { lowest: area.min(state.lowest), ..next });
                }
            }
            share /= 2.0;
        }
        None
    }

    fn state(&self, coordinates: Vec<f64>) -> State {
        let area = self.patch.area(&coordinates);
        let slope = self.taken(&self.patch.slope(&coordinates, Metric::slope));
        State { coordinates, area, lowest: area, slope }
    }

    fn matrix(&self, state: &State) -> Result<Banded<f64>> {
        let rule = |metric: Metric| metric.softened(self.size);
        self.patch.matrix(&state.coordinates, self.free, rule).factored(&FLOOR, true)
    }

    /// The coordinates of free poles.
    fn taken(&self, all: &[f64]) -> Vec<f64> {
        let poles = self.free.iter().map(|&index| &all[index * self.ambient..][..self.ambient]);
        poles.flatten().copied().collect()
    }

    fn moved(&self, all: &[f64], step: &[f64], share: f64) -> Vec<f64> {
        let mut moved = all.to_vec();
        for (&index, by) in self.free.iter().zip(step.chunks_exact(self.ambient)) {
            let pole = &mut moved[index * self.ambient..][..self.ambient];
            pole.iter_mut().zip(by).for_each(|(x, by)| *x += share * by);
        }
        moved
    }
}

fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}
