//! Answers as rows of numbers, so that one buffer serves all threads.

use pforms_kernel::{Form, Result};

use super::Projection;
use super::search::{Answer, Search};
use super::target::Target;

/// What stands in the row of one point: parameters, distance, gap, unique (0 or 1).
#[derive(Clone, Copy)]
pub(super) struct Rows {
    /// Axes of the form that was given.
    pub axes: usize,
}

impl Rows {
    /// Numbers in a row.
    pub(super) fn width(self) -> usize {
        self.axes + 3
    }

    /// Searches for the answer, from a start, and writes it.
    pub(super) fn search(self, search: &Search, row: &mut [f64], placed: &[f64], start: &[f64]) {
        let Answer { foot, gap, unique } = search.answer(placed, start.to_vec());
        let numbers = [foot.distance, gap, f64::from(unique)];
        self.fill(&search.target, row, &foot.parameters, numbers);
    }

    /// Writes an answer in the coordinates of the form.
    pub(super) fn fill(
        self,
        target: &Target,
        row: &mut [f64],
        parameters: &[f64],
        [distance, gap, unique]: [f64; 3],
    ) {
        let (all, rest) = row.split_at_mut(self.axes);
        for (axis, t) in target.live.iter().zip(parameters) {
            all[*axis] = *t;
        }
        rest[0] = target.length(distance);
        // Nothing is nearer than the point itself, whatever a bound says that overflowed.
        rest[1] = target.length(if gap < distance { gap } else { distance });
        // Along an axis of one pole nothing changes: then no parameters are the only ones.
        rest[2] = if target.live.len() == self.axes { unique } else { 0.0 };
    }

    /// Sorts the rows into columns, and evaluates the form.
    ///
    /// Errors: those of evaluation, which a form with a positive weight does not meet.
    pub(super) fn columns(self, form: &Form, numbers: &[f64]) -> Result<Projection> {
        let rows = || numbers.chunks_exact(self.width());
        let column = |k: usize| -> Vec<f64> { rows().map(|row| row[k]).collect() };
        let lists: Vec<Vec<f64>> = (0..self.axes).map(column).collect();
        let lists: Vec<&[f64]> = lists.iter().map(Vec::as_slice).collect();
        let points = match self.axes {
            0 => rows().map(|_| form.at(&[])).collect::<Result<Vec<_>>>()?.concat(),
            _ => form.scattered(&lists)?,
        };
        Ok(Projection {
            parameters: rows().flat_map(|row| &row[..self.axes]).copied().collect(),
            points,
            distances: column(self.axes),
            gaps: column(self.axes + 1),
            unique: rows().map(|row| row[self.axes + 2] > 0.0).collect(),
        })
    }
}
