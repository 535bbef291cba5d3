//! Small matrices: a left inverse that always exists.

use super::{Each, MOST_UNKNOWNS};

/// A matrix `M` of `axes` rows with `M·J ≈ 1`, for the `rows × axes` matrix of slopes `J`: the
/// pseudo-inverse, from `J = Q·R` by Gram and Schmidt, twice over.
///
/// Columns that depend on others get a tiny pivot: then a row of `M` is huge, and says in which
/// combination of the equations the unknown hardly counts. Any `M` is good for a proof; this one
/// for success. Row `k` of the answer belongs to unknown `k`; all of length `rows`.
pub(super) fn left_inverse(slopes: &[Each], axes: usize, inverse: &mut Vec<f64>) {
    let rows = slopes.len();
    let mut basis = vec![0.0; axes * rows];
    let mut triangle = [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS];
    for k in 0..axes {
        let (before, rest) = basis.split_at_mut(k * rows);
        let column = &mut rest[..rows];
        column.iter_mut().zip(slopes).for_each(|(x, slope)| *x = slope[k]);
        let size = norm(column);
        for _ in 0..2 {
            for (j, other) in before.chunks_exact(rows).enumerate() {
                let along = dot(column, other);
                triangle[j][k] += along;
                column.iter_mut().zip(other).for_each(|(x, y)| *x -= along * y);
            }
        }
        let length = norm(column);
        if length > f64::EPSILON * size {
            divide(column, length);
            triangle[k][k] = length;
        } else {
            complete(before, column);
            triangle[k][k] = if size > 0.0 { f64::EPSILON * size } else { TINY };
        }
    }
    inverse.clear();
    inverse.resize(axes * rows, 0.0);
    // R·M = Qᵀ, from the last row up.
    for k in (0..axes).rev() {
        for r in 0..rows {
            let known: f64 = (k + 1..axes).map(|j| triangle[k][j] * inverse[j * rows + r]).sum();
            inverse[k * rows + r] = (basis[k * rows + r] - known) / triangle[k][k];
        }
    }
}

/// The pivot of an unknown that no equation depends on.
const TINY: f64 = 1e-30;

/// A unit vector across those of `before`.
fn complete(before: &[f64], column: &mut [f64]) {
    let rows = column.len();
    for start in 0..rows {
        column.iter_mut().enumerate().for_each(|(i, x)| *x = f64::from(u8::from(i == start)));
        for _ in 0..2 {
            for other in before.chunks_exact(rows) {
                let along = dot(column, other);
                column.iter_mut().zip(other).for_each(|(x, y)| *x -= along * y);
            }
        }
        let length = norm(column);
        // Some unit vector is this far from a subspace that is not all.
        if length * length * 2.0 * rows as f64 >= 1.0 {
            divide(column, length);
            return;
        }
    }
}

fn divide(column: &mut [f64], length: f64) {
    for x in column {
        *x /= length;
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
