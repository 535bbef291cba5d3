//! Small square matrices, and matrices known within bounds.

/// The inverse, rows one after another; `None` when it is singular as far as rounding tells.
pub(super) fn inverse(matrix: &[f64], size: usize) -> Option<Vec<f64>> {
    let mut left = matrix.to_vec();
    let mut right: Vec<f64> =
        (0..size * size).map(|k| if k / size == k % size { 1.0 } else { 0.0 }).collect();
    for column in 0..size {
        let pivot = (column..size).max_by(|i, j| {
            left[i * size + column].abs().total_cmp(&left[j * size + column].abs())
        })?;
        let head = left[pivot * size + column];
        if head == 0.0 || !head.is_finite() {
            return None;
        }
        for k in 0..size {
            left.swap(pivot * size + k, column * size + k);
            right.swap(pivot * size + k, column * size + k);
        }
        for k in 0..size {
            left[column * size + k] /= head;
            right[column * size + k] /= head;
        }
        for row in (0..size).filter(|row| *row != column) {
            let factor = left[row * size + column];
            for k in 0..size {
                left[row * size + k] -= factor * left[column * size + k];
                right[row * size + k] -= factor * right[column * size + k];
            }
        }
    }
    right.iter().all(|x| x.is_finite()).then_some(right)
}

/// A matrix whose entries lie between bounds, `[column][row]`, and how it differs from its middle.
pub(super) struct Between {
    /// Bounds of `inverse · matrix − 1`, entry by entry, with the inverse of the middle.
    departure: Vec<f64>,
}

impl Between {
    /// `None` when the middle has no inverse.
    pub(super) fn new(low: &[f64], high: &[f64], size: usize) -> Option<Self> {
        let mut middle = vec![0.0; size * size];
        for row in 0..size {
            for column in 0..size {
                let k = column * size + row;
                middle[row * size + column] = 0.5 * low[k] + 0.5 * high[k];
            }
        }
        let inverse = inverse(&middle, size)?;
        let mut departure = vec![0.0; size * size];
        for i in 0..size {
            for j in 0..size {
                let (mut centre, mut size_of, mut spread) = (0.0, 0.0, 0.0);
                for c in 0..size {
                    let factor = inverse[i * size + c];
                    let term = factor * middle[c * size + j];
                    centre += term;
                    size_of += term.abs();
                    spread += factor.abs() * 0.5 * (high[j * size + c] - low[j * size + c]);
                }
                let one = if i == j { 1.0 } else { 0.0 };
                departure[i * size + j] = (centre - one).abs() + spread + 1e-14 * size_of;
            }
        }
        Some(Self { departure })
    }

    /// Is every matrix between the bounds invertible? Then a map with such slopes over a convex
    /// window takes no value twice: its differences are such a matrix times those of the parameters.
    pub(super) fn is_invertible(&self, size: usize) -> bool {
        self.departure.chunks_exact(size).all(|row| row.iter().sum::<f64>() < LEAST)
    }
}

/// Below 1 by more than rounding.
const LEAST: f64 = 0.999;

/// The determinant.
pub(super) fn determinant(mut matrix: Vec<f64>, size: usize) -> f64 {
    let mut product = 1.0;
    for column in 0..size {
        let largest = |i: &usize, j: &usize| {
            matrix[i * size + column].abs().total_cmp(&matrix[j * size + column].abs())
        };
        let pivot = (column..size).max_by(largest).unwrap_or(column);
        let head = matrix[pivot * size + column];
        if head == 0.0 {
            return 0.0;
        }
        if pivot != column {
            product = -product;
            for k in 0..size {
                matrix.swap(pivot * size + k, column * size + k);
            }
        }
        product *= head;
        for row in column + 1..size {
            let factor = matrix[row * size + column] / head;
            for k in column..size {
                matrix[row * size + k] -= factor * matrix[column * size + k];
            }
        }
    }
    product
}
