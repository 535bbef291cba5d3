//! Where the values of a parameter lie, point after point.

use std::borrow::Cow;
use std::ops::Range;

use numpy::ndarray::{ArrayView1, ArrayViewD, ArrayViewMut1, Axis, Ix1, Slice};

use crate::arrays::Shape;

/// The values of one parameter.
pub(crate) enum Row<'a> {
    Same(f64),
    Slice(Cow<'a, [f64]>),
    /// At equal steps in somebody's array, such as a column of a table.
    Strided(ArrayView1<'a, f64>),
    /// Those of an array in the places of a shape, repeated along the axes it lacks.
    Spread(ArrayViewD<'a, f64>, Shape),
}

/// Shorter lines of an array are copied all at once, since finding them takes as long.
const LONG: usize = 32;

impl<'a> Row<'a> {
    /// The numbers of an array, repeated along the axes that it lacks in a shape.
    pub(crate) fn spread(array: &ArrayViewD<'a, f64>, shape: &[usize]) -> Self {
        if let (1, Some(number)) = (array.len(), array.first()) {
            return Self::Same(*number);
        }
        if array.len() == shape.iter().product::<usize>()
            && let Some(line) = in_line(array.clone())
        {
            return Self::Strided(line);
        }
        if shape.last().is_some_and(|last| *last >= LONG) {
            return Self::Spread(array.clone(), shape.into());
        }
        let wide = array.broadcast(shape);
        Self::Slice(wide.iter().flat_map(|wide| wide.rows()).flatten().copied().collect())
    }

    /// Copies the values of a range of points.
    pub(crate) fn gather(&self, range: Range<usize>, copy: &mut [f64]) {
        match self {
            Self::Same(number) => copy.fill(*number),
            Self::Slice(values) => copy.copy_from_slice(&values[range]),
            Self::Strided(line) => copy_from(line, range.start, copy),
            Self::Spread(array, shape) => {
                let length = shape[shape.len() - 1];
                let (mut at, mut rest) = (range.start, copy);
                while !rest.is_empty() {
                    let column = at % length;
                    let (part, others) = rest.split_at_mut(rest.len().min(length - column));
                    match line_of(array, &shape[..shape.len() - 1], at / length) {
                        Some(line) if line.len() > 1 => copy_from(&line, column, part),
                        Some(line) => part.fill(line[0]),
                        None => {}
                    }
                    at += part.len();
                    rest = others;
                }
            }
        }
    }
}

fn copy_from(line: &ArrayView1<f64>, start: usize, copy: &mut [f64]) {
    let part = line.slice_axis(Axis(0), Slice::from(start..start + copy.len()));
    ArrayViewMut1::from(copy).assign(&part);
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

/// Line `number` along the last axis, counted in the shape of all axes before it.
fn line_of<'a>(
    array: &ArrayViewD<'a, f64>,
    outer: &[usize],
    number: usize,
) -> Option<ArrayView1<'a, f64>> {
    let mut line = array.clone();
    let lacking = outer.len() + 1 - array.ndim();
    let mut rest = number;
    for (axis, count) in outer.iter().enumerate().skip(lacking).rev() {
        let own = Axis(axis - lacking);
        line.collapse_axis(own, (rest % count).min(line.len_of(own) - 1));
        rest /= count;
    }
    in_line(line)
}
