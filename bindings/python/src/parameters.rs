//! Parameters of a call: numbers and arrays, broadcast against one another as NumPy does.

use std::borrow::Cow;

use pforms_kernel::{Error, limit};
use pyo3::prelude::*;

use crate::arrays::Numbers;
use crate::errors::raised;

/// One array for each parameter, and the shape they have together.
pub(crate) struct Parameters<'py> {
    shape: Vec<usize>,
    lists: Vec<Numbers<'py>>,
}

impl<'py> Parameters<'py> {
    /// Reads parameters that broadcast.
    ///
    /// Errors: `ShapeError` when the shapes do not broadcast; those of [`Numbers::read`].
    pub(crate) fn read(arguments: &[Bound<'py, PyAny>]) -> PyResult<Self> {
        let lists: Vec<Numbers<'py>> = arguments
            .iter()
            .map(|argument| Numbers::read("parameters", argument))
            .collect::<PyResult<_>>()?;
        let shape = common_shape(&lists).map_err(|error| raised(&error))?;
        limit::check::<f64>("the points", &shape, 1).map_err(|error| raised(&error))?;
        Ok(Self { shape, lists })
    }

    /// The shape of the broadcast parameters; that of a number without any.
    pub(crate) fn shape(&self) -> &[usize] {
        &self.shape
    }

    /// Number of points asked for.
    pub(crate) fn count(&self) -> usize {
        self.shape.iter().product()
    }

    /// The parameters of a grid, if each of several varies along axes of its own.
    pub(crate) fn grid(&self) -> Option<Vec<&[f64]>> {
        let several = self.lists.len() > 1 && self.count() > 1;
        (several && self.is_grid()).then(|| self.lists.iter().map(Numbers::values).collect())
    }

    /// The value of each parameter, point after point.
    pub(crate) fn scattered(&self) -> Vec<Cow<'_, [f64]>> {
        let spread = |list| {
            if Numbers::shape(list) == self.shape {
                Cow::Borrowed(list.values())
            } else {
                Cow::Owned(spread(list, &self.shape))
            }
        };
        self.lists.iter().map(spread).collect()
    }

    /// Does every axis belong to one parameter, in the order of the parameters?
    fn is_grid(&self) -> bool {
        let mut free = 0;
        self.lists.iter().all(|list| {
            let start = self.shape.len() - list.shape().len();
            let mut own = list.shape().iter().enumerate().filter(|(_, count)| **count != 1);
            let first = own.next().map_or(free, |(axis, _)| start + axis);
            let last = own.next_back().map_or(first, |(axis, _)| start + axis);
            let after = first >= free;
            if list.values().len() != 1 {
                free = last + 1;
            }
            after
        })
    }
}

fn common_shape(lists: &[Numbers]) -> Result<Vec<usize>, Error> {
    let axes = lists.iter().map(|list| list.shape().len()).max().unwrap_or(0);
    let mut shape = vec![1; axes];
    for list in lists {
        let start = axes - list.shape().len();
        for (common, &own) in shape[start..].iter_mut().zip(list.shape()) {
            if *common == 1 {
                *common = own;
            } else if own != 1 && own != *common {
                let shapes: Vec<&[usize]> = lists.iter().map(Numbers::shape).collect();
                return Err(Error::shape(
                    "parameters",
                    format!("arrays of shapes {shapes:?}"),
                    "shapes that broadcast against one another",
                ));
            }
        }
    }
    Ok(shape)
}

/// The values repeated along the axes in which the array has length 1, or none.
fn spread(list: &Numbers, shape: &[usize]) -> Vec<f64> {
    let start = shape.len() - list.shape().len();
    let mut values = list.values().to_vec();
    let mut run = 1;
    for (axis, &count) in shape.iter().enumerate().rev() {
        let own = axis.checked_sub(start).map_or(1, |own| list.shape()[own]);
        if own == 1 && count != 1 {
            values = values.chunks_exact(run).flat_map(|part| part.repeat(count)).collect();
        }
        run *= count;
        if run == 0 {
            return Vec::new();
        }
    }
    values
}
