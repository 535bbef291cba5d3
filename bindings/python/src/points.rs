//! The parameters of many points; what does not lie in a row is gathered block by block.

use std::borrow::Cow;
use std::ops::Range;

use pforms_kernel::Result;
use pforms_kernel::threads::fill_parts;
use smallvec::SmallVec;

use crate::rows::Row;

/// Most points in a block: their parameters stay in the cache.
const BLOCK: usize = 1 << 14;

/// Most multiplications in a block: so few that the job begins no threads of its own.
const WORK: usize = 1 << 20;

/// Blocks hold a multiple of so many points.
const LANES: usize = 64;

/// A value of each parameter for each of so many points.
pub(crate) struct Points<'a> {
    rows: SmallVec<[Row<'a>; 4]>,
    count: usize,
}

impl<'a> Points<'a> {
    pub(crate) fn new(rows: SmallVec<[Row<'a>; 4]>, count: usize) -> Self {
        Self { rows, count }
    }

    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// The values of each parameter for all points.
    pub(crate) fn whole(self) -> Vec<Cow<'a, [f64]>> {
        let all = |row| match row {
            Row::Slice(values) => values,
            other => {
                let mut values = vec![0.0; self.count];
                other.gather(0..self.count, &mut values);
                values.into()
            }
        };
        self.rows.into_iter().map(all).collect()
    }

    /// Does a job of about `cost` multiplications a point for the points of a range: it is given
    /// their parameters and their part of `out`, all at once or, when parameters must be gathered,
    /// block after block.
    ///
    /// Without points it is done once, so that it can complain of what does not fit.
    pub(crate) fn in_blocks(
        &self,
        range: Range<usize>,
        cost: usize,
        out: &mut [f64],
        job: &(impl Fn(&[&[f64]], &mut [f64]) -> Result<()> + Sync),
    ) -> Result<()> {
        let width = out.len() / range.len().max(1);
        let step = (WORK / cost.max(1) / LANES * LANES).clamp(LANES, BLOCK);
        if range.is_empty() || self.rows.iter().all(|row| matches!(row, Row::Slice(_))) {
            return job(&self.lists(&range, &mut []), out);
        }
        fill_parts(out, width, 2 * cost, |part, out| {
            let mut buffer = vec![0.0; step.min(part.len()) * self.rows.len()];
            let blocks = out.chunks_mut(step * width).zip(part.clone().step_by(step));
            for (out, start) in blocks {
                let block = range.start + start..range.start + part.end.min(start + step);
                job(&self.lists(&block, &mut buffer), out)?;
            }
            Ok(())
        })
    }

    /// The values of each parameter for a range of points; `buffer` holds those gathered.
    fn lists<'b>(
        &'b self,
        range: &Range<usize>,
        mut buffer: &'b mut [f64],
    ) -> SmallVec<[&'b [f64]; 4]> {
        let list = |row: &'b Row<'a>| {
            if let Row::Slice(values) = row {
                return &values[range.clone()];
            }
            let (copy, rest) = std::mem::take(&mut buffer).split_at_mut(range.len());
            buffer = rest;
            row.gather(range.clone(), copy);
            &*copy
        };
        self.rows.iter().map(list).collect()
    }
}
