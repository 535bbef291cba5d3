//! Pascal's triangle.

use crate::Scalar;

/// Row `degree` of Pascal's triangle: `C(degree, 0), …, C(degree, degree)`.
///
/// Exact for rationals; in `f64` exact up to degree 56, and within `degree` roundings above.
pub fn pascal_row<S: Scalar>(degree: usize) -> Vec<S> {
    let mut row = Vec::with_capacity(degree + 1);
    row.push(S::one());
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
