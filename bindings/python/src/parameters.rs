//! Parameters of a call: numbers and arrays, broadcast against one another as NumPy does.

use std::borrow::Cow;

use numpy::ndarray::ArrayViewD;
use numpy::{
    PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArray, PyUntypedArrayMethods,
};
use pforms_kernel::{Error, limit};
use pyo3::prelude::*;
use smallvec::{SmallVec, smallvec};

use crate::arrays::{Numbers, Shape};
use crate::errors::raised;
use crate::points::Points;
use crate::rows::Row;

/// One array for each parameter, and the shape they have together.
pub(crate) struct Parameters<'py> {
    shape: Shape,
    lists: SmallVec<[Given<'py>; 4]>,
}

/// The array of one parameter.
enum Given<'py> {
    Dense(Numbers<'py>),
    /// The caller's own, whose numbers do not follow one another: a column of a table.
    Strided(PyReadonlyArrayDyn<'py, f64>),
}

impl<'py> Parameters<'py> {
    /// Reads parameters that broadcast.
    ///
    /// Errors: `ShapeError` when the shapes do not broadcast; those of [`Numbers::read`].
    pub(crate) fn read(arguments: impl IntoIterator<Item = Bound<'py, PyAny>>) -> PyResult<Self> {
        let given = arguments.into_iter().map(|argument| Given::read(&argument));
        let lists: SmallVec<_> = given.collect::<PyResult<_>>()?;
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
    ///
    /// A single one that varies makes a grid too if it is the last, along which grids are quick.
    pub(crate) fn grid(&self) -> Option<Vec<Cow<'_, [f64]>>> {
        let vary = |list: &Given| list.shape().iter().any(|count| *count != 1);
        let varying = self.lists.iter().filter(|list| vary(list)).count();
        let last = matches!(self.lists.last(), Some(list @ Given::Dense(_)) if vary(list));
        let several = varying > 1 || (last && self.lists.len() > 1);
        (several && self.is_grid()).then(|| self.lists.iter().map(Given::values).collect())
    }

    /// The value of each parameter, point after point.
    pub(crate) fn scattered(&self) -> Points<'_> {
        let rows = self.lists.iter().map(|list| match list {
            Given::Dense(numbers) if numbers.shape() == self.shape() => {
                Row::Slice(Cow::Borrowed(numbers.values()))
            }
            other => Row::spread(&other.view(), &self.shape),
        });
        Points::new(rows.collect(), self.count())
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
            if list.shape().iter().any(|count| *count != 1) {
                free = last + 1;
            }
            after
        })
    }
}

impl<'py> Given<'py> {
    fn read(object: &Bound<'py, PyAny>) -> PyResult<Self> {
        if object.is_exact_instance_of::<PyUntypedArray>()
            && let Ok(array) = object.cast::<PyArrayDyn<f64>>()
            && array.is_aligned()
            && !array.is_c_contiguous()
        {
            return Ok(Self::Strided(array.try_readonly()?));
        }
        Numbers::read("parameters", object).map(Self::Dense)
    }

    fn shape(&self) -> &[usize] {
        match self {
            Self::Dense(numbers) => numbers.shape(),
            Self::Strided(array) => array.shape(),
        }
    }

    /// All numbers, one after another.
    fn values(&self) -> Cow<'_, [f64]> {
        match self {
            Self::Dense(numbers) => Cow::Borrowed(numbers.values()),
            Self::Strided(array) => array.as_array().iter().copied().collect(),
        }
    }

    fn view(&self) -> ArrayViewD<'_, f64> {
        match self {
            Self::Dense(numbers) => numbers.view(),
            Self::Strided(array) => array.as_array(),
        }
    }
}

fn common_shape(lists: &[Given]) -> Result<Shape, Error> {
    let axes = lists.iter().map(|list| list.shape().len()).max().unwrap_or(0);
    let mut shape = smallvec![1; axes];
    for list in lists {
        let start = axes - list.shape().len();
        for (common, &own) in shape[start..].iter_mut().zip(list.shape()) {
            if *common == 1 {
                *common = own;
            } else if own != 1 && own != *common {
                let shapes: Vec<&[usize]> = lists.iter().map(Given::shape).collect();
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
