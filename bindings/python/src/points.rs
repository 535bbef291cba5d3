//! The parameters of many points; what does not lie in a row is gathered block by block.

use std::borrow::Cow;
use std::ops::Range;

use numpy::ndarray::{ArrayView1, ArrayViewD, ArrayViewMut1, Axis, Ix1, Slice};
use pforms_kernel::Result;
use pforms_kernel::threads::fill_parts;
use smallvec::SmallVec;

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

/// The values of one parameter.
pub(crate) enum Row<'a> {
    Same(f64),
    Slice(Cow<'a, [f64]>),
    /// At equal steps in somebody's array, such as a column of a table.
    Strided(ArrayView1<'a, f64>),
}

impl<'a> Row<'a> {
    /// The numbers of an array, repeated along the axes that it lacks in a shape.
    pub(crate) fn spread(array: &ArrayViewD<'a, f64>, shape: &[usize]) -> Self {
        if let (1, Some(number)) = (array.len(), array.first()) {
            return Self::Same(*number);
        }
        let Some(wide) = array.broadcast(shape) else { return Self::Slice(Cow::default()) };
        if wide.len() == array.len()
            && let Some(line) = in_line(array.clone())
        {
            return Self::Strided(line);
        }
        Self::Slice(wide.rows().into_iter().flatten().copied().collect())
    }

    /// Copies the values of a range of points.
    fn gather(&self, range: Range<usize>, copy: &mut [f64]) {
        match self {
            Self::Same(number) => copy.fill(*number),
            Self::Slice(values) => copy.copy_from_slice(&values[range]),
            Self::Strided(line) => {
                ArrayViewMut1::from(copy).assign(&line.slice_axis(Axis(0), Slice::from(range)));
            }
        }
    }
}

/// The numbers of an array as a line, if they lie at equal steps.
fn in_line(mut array: ArrayViewD<f64>) -> Option<ArrayView1<f64>> {
    let last = array.ndim().checked_sub(1)?;
    let merged = (0..last).rev().all(|axis| array.merge_axes(Axis(axis), Axis(last)));
    if !merged || array.is_empty() {
        return None;
    }
    while array.ndim() > 1 {
        array = array.index_axis_move(Axis(0), 0);
    }
    array.into_dimensionality::<Ix1>().ok()
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
