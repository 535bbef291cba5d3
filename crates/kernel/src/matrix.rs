//! Act along one axis: the move behind subdivision, elevation, stretching, interpolation, splines.

use smallvec::SmallVec;

use crate::act::Steps;
use crate::{Error, Form, Result, Scalar, limit};

/// A dense matrix, row after row.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix<S = f64> {
    rows: usize,
    columns: usize,
    entries: SmallVec<[S; 32]>,
}

impl<S: Scalar> Matrix<S> {
    /// A matrix from its rows, one after another.
    ///
    /// Errors: `Shape` when the rows have different lengths or there is none.
    pub fn from_rows(rows: Vec<Vec<S>>) -> Result<Self> {
        let columns = rows.first().map_or(0, Vec::len);
        if columns == 0 || rows.iter().any(|row| row.len() != columns) {
            let lengths: Vec<usize> = rows.iter().map(Vec::len).collect();
            return Err(Error::shape(
                "rows",
                format!("lengths {lengths:?}"),
                "rows of one length, at least 1",
            ));
        }
        Ok(Self { rows: rows.len(), columns, entries: rows.into_iter().flatten().collect() })
    }

    /// A matrix whose entry at `(row, column)` is given by a rule.
    pub fn from_rule(rows: usize, columns: usize, rule: impl Fn(usize, usize) -> S) -> Self {
        Self::from_writer(rows, columns, |row, entries| {
            for (column, entry) in entries.iter_mut().enumerate() {
                *entry = rule(row, column);
            }
        })
    }

    /// A matrix whose rows are written one by one, into zeros.
    pub fn from_writer(
        rows: usize,
        columns: usize,
        mut write: impl FnMut(usize, &mut [S]),
    ) -> Self {
        let mut matrix = Self { rows, columns, entries: SmallVec::new() };
        matrix.entries.resize(rows * columns, S::zero());
        for (index, row) in matrix.entries.chunks_exact_mut(columns).enumerate() {
            write(index, row);
        }
        matrix
    }

    /// Number of rows: the order after acting.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns: the order before acting.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Row `index`.
    pub fn row(&self, index: usize) -> &[S] {
        &self.entries[index * self.columns..][..self.columns]
    }

    /// The array `Σ_j M[r, j] · input[a, j, k]` for an array of shape `(·, columns, inner)`.
    ///
    /// Errors: none of its own.
    pub fn act(&self, input: &[S], inner: usize) -> Result<Vec<S>> {
        let mut out = vec![S::zero(); input.len() / self.columns * self.rows];
        let mut steps = Steps::new(self.columns * inner);
        steps.push(self, inner);
        steps.run(input, &mut out)?;
        Ok(out)
    }

    /// The product: what acting with `other` and then with this one does.
    ///
    /// Errors: `Shape` unless the columns of this one are the rows of the other.
    pub fn times(&self, other: &Self) -> Result<Self> {
        if self.columns != other.rows {
            return Err(Error::shape(
                "matrix",
                format!("{} rows", other.rows),
                format!("{}, the columns of the other", self.columns),
            ));
        }
        let entries = self.act(&other.entries, other.columns)?;
        Ok(Self { rows: self.rows, columns: other.columns, entries: entries.into() })
    }
}

impl<S: Scalar> Form<S> {
    /// The form whose poles along `axis` are the matrix times the old ones.
    ///
    /// Linear in the poles; acts on different axes commute. One pass over the array.
    ///
    /// Errors: `Shape` when there is no such axis or the columns are not its order; `Limit`.
    pub fn along(&self, axis: usize, matrix: &Matrix<S>) -> Result<Self> {
        let (orders, poles) = self.acted_on(&[(axis, matrix)])?;
        self.derived(&orders, poles)
    }

    /// [`Form::along`] for a matrix whose rows sum to 1: a polynomial form stays polynomial exactly.
    ///
    /// Errors: as [`Form::along`].
    pub fn along_affine(&self, axis: usize, matrix: &Matrix<S>) -> Result<Self> {
        self.along_all_affine(&[(axis, matrix)])
    }

    /// [`Form::along_affine`] along several axes in ascending order, in one pass over the array.
    ///
    /// Errors: as [`Form::along`]; `Shape` unless the axes ascend.
    pub fn along_all_affine(&self, acts: &[(usize, &Matrix<S>)]) -> Result<Self> {
        if acts.is_empty() {
            return Ok(self.clone());
        }
        let (orders, mut poles) = self.acted_on(acts)?;
        if let Some(weight) = self.uniform_weight() {
            for pole in poles.chunks_exact_mut(self.width()) {
                pole[self.ambient()] = weight.clone();
            }
        }
        self.derived(&orders, poles)
    }

    /// Orders and poles after matrices have acted along axes in ascending order.
    fn acted_on(&self, acts: &[(usize, &Matrix<S>)]) -> Result<(Vec<usize>, Vec<S>)> {
        let mut orders = self.orders().to_vec();
        let first = acts.first().map_or(0, |(axis, _)| *axis);
        for (k, &(axis, matrix)) in acts.iter().enumerate() {
            self.require_axis(axis)?;
            if acts[..k].iter().any(|(before, _)| *before >= axis) {
                return Err(Error::shape("axes", axis, "axes in ascending order"));
            }
            if matrix.columns() != self.orders()[axis] {
                return Err(Error::shape(
                    "matrix",
                    format!("{} columns", matrix.columns()),
                    format!("{}, the order of axis {axis}", self.orders()[axis]),
                ));
            }
            orders[axis] = matrix.rows();
        }
        let inner = |axis: usize| self.orders()[axis..].iter().product::<usize>() * self.width();
        let mut steps = Steps::new(inner(first));
        for &(axis, matrix) in acts {
            steps.push(matrix, inner(axis + 1));
        }
        let count = limit::check::<S>("the result", &orders, self.width())?;
        let mut poles = vec![S::zero(); count];
        steps.run(self.homogeneous(), &mut poles)?;
        Ok((orders, poles))
    }

    /// The form without `axis`: its poles contracted with one row of coefficients.
    ///
    /// Errors: as [`Form::along`].
    pub fn contract(&self, axis: usize, row: &[S]) -> Result<Self> {
        let matrix = Matrix::from_rows(vec![row.to_vec()])?;
        let flat = self.along(axis, &matrix)?;
        let mut orders = flat.orders().to_vec();
        orders.remove(axis);
        flat.reshape(&orders)
    }

    /// The same poles in an array of other orders with the same count.
    ///
    /// Errors: `Shape` when the counts differ.
    pub fn reshape(&self, orders: &[usize]) -> Result<Self> {
        self.derived(orders, self.homogeneous().to_vec())
    }
}
