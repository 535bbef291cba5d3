//! The parameters of many points, read in blocks: what lies scattered is gathered block by block.

use std::borrow::Cow;
use std::ops::Range;

use numpy::ndarray::{ArrayView1, ArrayViewD, ArrayViewMut1, Axis, Ix1, Slice};
use pforms_kernel::Result;
use smallvec::SmallVec;

/// Points in a block: their parameters stay in the nearest memory, and full blocks of lanes.
const BLOCK: usize = 1 << 12;

/// Multiplications in a block, unless its points are fewer: little enough for one thread.
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

    fn gather(&self, range: Range<usize>, buffer: &mut Vec<f64>) {
        match self {
            Self::Same(number) => buffer.resize(buffer.len() + range.len(), *number),
            Self::Slice(values) => buffer.extend_from_slice(&values[range]),
            Self::Strided(line) => {
                let start = buffer.len();
                buffer.resize(start + range.len(), 0.0);
                let part = line.slice_axis(Axis(0), Slice::from(range));
                ArrayViewMut1::from(&mut buffer[start..]).assign(&part);
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
                let mut values = Vec::new();
                other.gather(0..self.count, &mut values);
                values.into()
            }
        };
        self.rows.into_iter().map(all).collect()
    }

    /// Does a job of about `cost` multiplications a point for the points of a range in blocks: it
    /// is given the parameters of a block and its part of `out`.
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
        let mut buffer = Vec::new();
        let mut start = range.start;
        loop {
            let end = range.end.min(start + step);
            let part = (start - range.start) * width..(end - range.start) * width;
            job(&self.lists(start..end, &mut buffer), &mut out[part])?;
            if end == range.end {
                return Ok(());
            }
            start = end;
        }
    }

    /// The values of each parameter for a range of points; `buffer` holds those gathered.
    fn lists<'b>(
        &'b self,
        range: Range<usize>,
        buffer: &'b mut Vec<f64>,
    ) -> SmallVec<[&'b [f64]; 4]> {
        buffer.clear();
        let elsewhere = self.rows.iter().filter(|row| !matches!(row, Row::Slice(_)));
        elsewhere.for_each(|row| row.gather(range.clone(), buffer));
        let buffer: &'b [f64] = buffer;
        let mut gathered = (0..).map(|k| k * range.len());
        let list = |row: &'b Row<'a>| {
            if let Row::Slice(values) = row {
                return &values[range.clone()];
            }
            let place = gathered.next().unwrap_or_default();
            &buffer[place..][..range.len()]
        };
        self.rows.iter().map(list).collect()
    }
}
