//! Grids of parameters, on one form or on many at once, in parts that Python may interrupt.

use pforms_kernel::{Form, Result};
use pyo3::prelude::*;
use smallvec::SmallVec;

use crate::errors::done;
use crate::slices::SLICE;

/// A grid for each form, and the places for its numbers; those not wanted are empty.
pub(crate) struct Grids<'a> {
    pub(crate) forms: &'a [&'a Form],
    pub(crate) lists: SmallVec<[&'a [f64]; 4]>,
    pub(crate) points: &'a mut [f64],
    pub(crate) normals: &'a mut [f64],
}

impl<'a> Grids<'a> {
    pub(crate) fn new(forms: &'a [&'a Form], lists: &[&'a [f64]], points: &'a mut [f64]) -> Self {
        Self { forms, lists: lists.into(), points, normals: &mut [] }
    }

    /// Does a job that takes about `cost` multiplications a point, in parts if that is long.
    pub(crate) fn fill(
        self,
        py: Python<'_>,
        cost: usize,
        job: &(impl Fn(Grids) -> Result<()> + Sync),
    ) -> PyResult<()> {
        let counts = self.lists.iter().map(|list| list.len());
        let points = counts.fold(self.forms.len(), usize::saturating_mul);
        let work = points.saturating_mul(cost);
        if work <= SLICE || points < 2 {
            return done(py, work, || job(self));
        }
        let (low, high) = self.halves();
        low.fill(py, cost, job)?;
        py.check_signals()?;
        high.fill(py, cost, job)
    }

    /// Half of the forms, or half of the first axis, and the rest.
    fn halves(self) -> (Self, Self) {
        let Self { forms, lists, points, normals } = self;
        let axis = lists.iter().position(|list| list.len() > 1).filter(|_| forms.len() < 2);
        let count = axis.map_or(forms.len(), |axis| lists[axis].len());
        let half = count / 2;
        let (mut start, mut end) = (lists.clone(), lists);
        let (few, rest) = match axis {
            None => forms.split_at(half),
            Some(axis) => {
                (start[axis], end[axis]) = start[axis].split_at(half);
                (forms, forms)
            }
        };
        let split = |numbers: &'a mut [f64]| numbers.split_at_mut(numbers.len() / count * half);
        let ((low, high), (left, right)) = (split(points), split(normals));
        (
            Self { forms: few, lists: start, points: low, normals: left },
            Self { forms: rest, lists: end, points: high, normals: right },
        )
    }
}
