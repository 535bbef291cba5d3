//! Long work in slices, between which Python may interrupt it.

use std::ops::Range;

use pforms_kernel::Result;
use pyo3::prelude::*;

use crate::errors::{LimitError, done};
use crate::points::Points;

/// Multiplications in a slice: a tenth of a second at most, and mostly much less.
pub(crate) const SLICE: usize = 1 << 27;

/// Slices of so many points or a multiple of them fill whole blocks of lanes.
const BLOCK: usize = 64;

/// Multiplications allowed to what cannot be sliced: some ten seconds.
const MOST: f64 = 1e11;

/// Does a job for one range after another of `count` points of about `cost` multiplications each.
///
/// Errors: those of the job, and `KeyboardInterrupt` or whatever else a signal raises.
pub(crate) fn in_slices(
    py: Python<'_>,
    count: usize,
    cost: usize,
    mut job: impl FnMut(Range<usize>) -> Result<()> + Send,
) -> PyResult<()> {
    let step = slice_of(cost);
    let mut start = 0;
    loop {
        let end = count.min(start + step);
        done(py, cost.saturating_mul(end - start), || job(start..end))?;
        if end == count {
            return Ok(());
        }
        py.check_signals()?;
        start = end;
    }
}

/// Number of points in a slice.
pub(crate) fn slice_of(cost: usize) -> usize {
    match SLICE / cost.max(1) {
        few @ ..BLOCK => few.max(1),
        many => many / BLOCK * BLOCK,
    }
}

/// Fills `out` at scattered points, which `fill` is given in blocks.
pub(crate) fn fill_scattered(
    py: Python<'_>,
    points: &Points,
    cost: usize,
    out: &mut [f64],
    fill: &(impl Fn(&[&[f64]], &mut [f64]) -> Result<()> + Sync),
) -> PyResult<()> {
    let width = out.len() / points.count().max(1);
    in_slices(py, points.count(), cost, |range| {
        points.in_blocks(
            range.clone(),
            cost,
            &mut out[range.start * width..range.end * width],
            fill,
        )
    })
}

/// Refuses what could not be interrupted and would take too long.
///
/// Errors: `LimitError` above 1e11 multiplications.
pub(crate) fn require_feasible(what: &str, multiplications: f64) -> PyResult<()> {
    if multiplications <= MOST {
        return Ok(());
    }
    Err(LimitError::new_err(format!(
        "{what} would take about {multiplications:.0e} multiplications: refused, the cap is \
         {MOST:.0e}"
    )))
}
