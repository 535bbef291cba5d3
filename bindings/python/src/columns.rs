//! Named columns of numbers that grow point after point.

use numpy::PyArrayDyn;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::outputs::array;

/// Columns in the order of their first entry; each has one number or vector for each point.
pub(crate) struct Columns {
    shape: Vec<usize>,
    columns: Vec<Column>,
}

struct Column {
    name: &'static str,
    width: Option<usize>,
    values: Vec<f64>,
}

impl Columns {
    /// Columns for parameters of this shape.
    pub(crate) fn new(shape: &[usize]) -> Self {
        Self { shape: shape.to_vec(), columns: Vec::new() }
    }

    pub(crate) fn number(&mut self, name: &'static str, value: f64) {
        self.push(name, None, &[value]);
    }

    pub(crate) fn vector(&mut self, name: &'static str, vector: &[f64]) {
        self.push(name, Some(vector.len()), vector);
    }

    pub(crate) fn maybe_number(&mut self, name: &'static str, value: Option<f64>) {
        if let Some(value) = value {
            self.number(name, value);
        }
    }

    pub(crate) fn maybe_vector(&mut self, name: &'static str, vector: Option<&[f64]>) {
        if let Some(vector) = vector {
            self.vector(name, vector);
        }
    }

    fn push(&mut self, name: &'static str, width: Option<usize>, values: &[f64]) {
        match self.columns.iter_mut().find(|column| column.name == name) {
            Some(column) => column.values.extend_from_slice(values),
            None => self.columns.push(Column { name, width, values: values.to_vec() }),
        }
    }

    /// Forgets the entries, but not the names and widths of the columns.
    pub(crate) fn clear(&mut self) {
        self.columns.iter_mut().for_each(|column| column.values.clear());
    }

    /// Moves entry `i` of every complete column to place `places[i]`.
    pub(crate) fn rearrange(&mut self, places: &[usize]) {
        for Column { width, values, .. } in &mut self.columns {
            let width = width.unwrap_or(1);
            if values.len() == width * places.len() {
                let entries = values.clone();
                for (entry, place) in entries.chunks_exact(width).zip(places) {
                    values[place * width..][..width].copy_from_slice(entry);
                }
            }
        }
    }

    /// The numbers of the only column, an array of the parameters' shape.
    pub(crate) fn into_numbers(self, py: Python<'_>) -> PyResult<Bound<'_, PyArrayDyn<f64>>> {
        let values = self.columns.into_iter().next().map_or_else(Vec::new, |column| column.values);
        array(py, &self.shape, values)
    }

    /// A `pforms.Frame` of arrays; a column without an entry for every point is left out.
    pub(crate) fn into_frame(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        let named = PyDict::new(py);
        for Column { name, width, values } in self.columns {
            let shape: Vec<usize> = self.shape.iter().copied().chain(width).collect();
            if values.len() == shape.iter().product::<usize>() {
                named.set_item(name, array(py, &shape, values)?)?;
            }
        }
        let records = py.import(intern!(py, "pforms.records"))?;
        records.getattr(intern!(py, "Frame"))?.call1((named,))
    }
}
