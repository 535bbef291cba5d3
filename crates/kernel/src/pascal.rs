//! Pascal's triangle.

use crate::Scalar;

/// Row `degree` of Pascal's triangle: `C(degree, 0), …, C(degree, degree)`.
///
/// Exact for rationals, by `C(n, k+1) = C(n, k)·(n−k)/(k+1)`; in `f64`, where that would round, by
/// the triangle: exact up to degree 56, and within `degree` roundings above.
pub fn pascal_row<S: Scalar>(degree: usize) -> Vec<S> {
    let mut row = Vec::with_capacity(degree + 1);
    row.push(S::one());
    if S::EXACT {
        for k in 0..degree {
            row.push(row[k].clone() * S::ratio((degree - k) as i64, k as i64 + 1));
        }
        return row;
    }
    for _ in 0..degree {
        let mut left = S::zero();
        for entry in &mut row {
            let above = entry.clone();
            *entry += left;
            left = above;
        }
        row.push(S::one());
    }
    row
}

/// The binomial coefficient `C(n, k)`; 0 when `k > n`.
pub fn binomial<S: Scalar>(n: usize, k: usize) -> S {
    if k > n {
        return S::zero();
    }
    pascal_row::<S>(n).swap_remove(k)
}
