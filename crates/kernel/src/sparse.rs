//! Matrices of which few entries are kept: derivatives of many results in many poles.

use crate::{Error, Matrix, Result, Scalar, limit};

/// A sparse matrix, row after row (compressed sparse rows); the columns of a row ascend.
///
/// ```
/// use pforms_kernel::Sparse;
/// let rows = [vec![(0, 0.75), (2, 0.25)], vec![(1, 2.0)]];
/// let matrix = Sparse::from_rows(3, rows)?;
/// assert_eq!(matrix.apply(&[4.0, 1.0, 0.0])?, [3.0, 2.0]);
/// assert_eq!(matrix.transposed(&[1.0, 10.0])?, [0.75, 20.0, 0.25]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Sparse<S = f64> {
    columns: usize,
    /// Where each row begins in the arrays below, and where the last one ends.
    starts: Vec<usize>,
    places: Vec<usize>,
    entries: Vec<S>,
}

impl<S: Scalar> Sparse<S> {
    /// A matrix from the entries of its rows, each a column and a number, columns ascending.
    ///
    /// Errors: `Shape` for a column that does not ascend or is not one of `columns`.
    pub fn from_rows(
        columns: usize,
        rows: impl IntoIterator<Item = Vec<(usize, S)>>,
    ) -> Result<Self> {
        let (mut starts, mut places, mut entries) = (vec![0], Vec::new(), Vec::new());
        for row in rows {
            for (place, entry) in row {
                let first = places.len() == starts[starts.len() - 1];
                let ascends = first || places.last().is_none_or(|last| *last < place);
                if place >= columns || !ascends {
                    let expected = format!("columns that ascend, below {columns}");
                    return Err(Error::shape("rows", format!("column {place}"), expected));
                }
                places.push(place);
                entries.push(entry);
            }
            starts.push(places.len());
        }
        Ok(Self { columns, starts, places, entries })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.starts.len() - 1
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Where each row begins among the entries, and where the last one ends.
    pub fn starts(&self) -> &[usize] {
        &self.starts
    }

    /// The column of each entry.
    pub fn places(&self) -> &[usize] {
        &self.places
    }

    /// The entries, row after row.
    pub fn entries(&self) -> &[S] {
        &self.entries
    }

    /// The entries of a row with their columns.
    pub fn row(&self, index: usize) -> impl Iterator<Item = (usize, &S)> {
        let range = self.starts[index]..self.starts[index + 1];
        self.places[range.clone()].iter().copied().zip(&self.entries[range])
    }

    /// The matrix times a vector: how the results follow when all sources move a little.
    ///
    /// Errors: `Shape` unless the vector has a number for each column.
    pub fn apply(&self, vector: &[S]) -> Result<Vec<S>> {
        require_length(vector, self.columns, "columns")?;
        let row = |index| {
            let mut sum = S::zero();
            for (place, entry) in self.row(index) {
                sum += entry.clone() * vector[place].clone();
            }
            sum
        };
        Ok((0..self.rows()).map(row).collect())
    }

    /// The transpose times a vector: how much each source counts for a weighted sum of the results.
    ///
    /// Errors: `Shape` unless the vector has a number for each row.
    pub fn transposed(&self, vector: &[S]) -> Result<Vec<S>> {
        require_length(vector, self.rows(), "rows")?;
        let mut sums = vec![S::zero(); self.columns];
        for (index, factor) in vector.iter().enumerate() {
            for (place, entry) in self.row(index) {
                sums[place] += entry.clone() * factor.clone();
            }
        }
        Ok(sums)
    }

    /// All entries, zeros too.
    ///
    /// Errors: `Limit` when they do not fit; `Shape` when there are none.
    pub fn dense(&self) -> Result<Matrix<S>> {
        limit::check::<S>("the matrix", &[self.rows(), self.columns], 1)?;
        if self.rows() == 0 || self.columns == 0 {
            let received = format!("{} × {}", self.rows(), self.columns);
            return Err(Error::shape("matrix", received, "rows and columns"));
        }
        Ok(Matrix::from_writer(self.rows(), self.columns, |index, row| {
            for (place, entry) in self.row(index) {
                row[place] = entry.clone();
            }
        }))
    }
}

fn require_length<S>(vector: &[S], length: usize, what: &str) -> Result<()> {
    if vector.len() == length {
        return Ok(());
    }
    let received = format!("{} numbers", vector.len());
    Err(Error::shape("vector", received, format!("{length}, one for each of the {what}")))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn columns_outside_or_out_of_order_are_refused() {
        assert!(Sparse::from_rows(2, [vec![(2, 1.0)]]).is_err());
        assert!(Sparse::from_rows(2, [vec![(1, 1.0), (0, 1.0)]]).is_err());
        assert!(Sparse::from_rows(2, [vec![(1, 1.0), (1, 1.0)]]).is_err());
        let matrix = Sparse::from_rows(2, [vec![(1, 1.0)], vec![], vec![(0, 2.0)]]).unwrap();
        assert_eq!(matrix.dense().unwrap().row(2), [2.0, 0.0]);
        assert!(matrix.apply(&[1.0]).is_err() && matrix.transposed(&[1.0]).is_err());
    }
}
