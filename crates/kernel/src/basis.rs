//! Rows of coefficients: Bernstein polynomials, their Taylor expansion, the blossom.

use crate::{Matrix, Scalar, pascal_row};

/// The Bernstein polynomials `B₀ … B_degree` at `t`, for any `t`.
///
/// By the triangle of de Casteljau run on the basis: in `[0, 1]` no term is subtracted, so each
/// value is within `2·degree` roundings of the exact one (Farin, *Curves and Surfaces for CAGD*,
/// section 5.1). Exact scalars, which need no such care, multiply the powers: `degree` products in
/// place of its square.
pub fn bernstein_row<S: Scalar>(degree: usize, t: &S) -> Vec<S> {
    let mut row = Vec::with_capacity(degree + 1);
    bernstein_row_into(degree, t, &mut row);
    row
}

/// [`bernstein_row`] into a buffer that is used again.
pub(crate) fn bernstein_row_into<S: Scalar>(degree: usize, t: &S, row: &mut Vec<S>) {
    row.clear();
    let s = S::one() - t.clone();
    if S::EXACT {
        row.extend(pascal_row::<S>(degree));
        multiply_by_powers(row.iter_mut(), t);
        multiply_by_powers(row.iter_mut().rev(), &s);
        return;
    }
    row.push(S::one());
    for _ in 0..degree {
        blend(row, &s, t);
    }
}

/// Multiplies the entries by `1, t, t², …`.
fn multiply_by_powers<'a, S: Scalar>(entries: impl Iterator<Item = &'a mut S>, t: &S) {
    let mut power = S::one();
    for entry in entries {
        *entry = entry.clone() * power.clone();
        power = power * t.clone();
    }
}

/// One step of the triangle: row `k` of the basis becomes row `k + 1`.
fn blend<S: Scalar>(row: &mut Vec<S>, s: &S, t: &S) {
    let mut left = S::zero();
    for entry in row.iter_mut() {
        let above = entry.clone();
        *entry = s.clone() * above.clone() + left;
        left = t.clone() * above;
    }
    row.push(left);
}

/// Coefficients of the poles in the blossom value `f[t₁, …, t_n]`, `n` the degree.
///
/// With all arguments equal this is [`bernstein_row`] (Ramshaw, *Blossoming*, 1987).
pub fn blossom_row<S: Scalar>(arguments: &[S]) -> Vec<S> {
    let mut row = Vec::with_capacity(arguments.len() + 1);
    row.push(S::one());
    for t in arguments {
        blend(&mut row, &(S::one() - t.clone()), t);
    }
    row
}

/// [`blossom_row`] with homogeneous arguments `[s, t]`: the parameter is `t / (s + t)`, so
/// `[1, 0]` is 0, `[0, 1]` is 1 and `[-1, 1]` is infinity.
pub fn projective_blossom_row<S: Scalar>(arguments: &[[S; 2]]) -> Vec<S> {
    let mut row = Vec::with_capacity(arguments.len() + 1);
    row.push(S::one());
    for [s, t] in arguments {
        blend(&mut row, s, t);
    }
    row
}

/// Rows 0 to `last` of Taylor coefficients at `t`: row `r` holds `B_j⁽ʳ⁾(t) / r!`.
///
/// Rows above the degree are zero.
pub fn taylor_rows<S: Scalar>(degree: usize, last: usize, t: &S) -> Matrix<S> {
    let choices = pascal_row::<S>(degree);
    let (mut row, mut rows) = (Vec::new(), Vec::new());
    for r in 0..=last {
        taylor_row_into(&choices, r, t, &mut row);
        rows.extend_from_slice(&row);
    }
    Matrix::from_rule(last + 1, degree + 1, |r, j| rows[r * (degree + 1) + j].clone())
}

/// Row `r` of [`taylor_rows`] into a buffer that is used again; `choices` is the row of Pascal.
pub(crate) fn taylor_row_into<S: Scalar>(choices: &[S], r: usize, t: &S, row: &mut Vec<S>) {
    let degree = choices.len() - 1;
    if r > degree {
        row.clear();
        row.resize(degree + 1, S::zero());
        return;
    }
    bernstein_row_into(degree - r, t, row);
    for _ in 0..r {
        difference(row);
    }
    for entry in row {
        *entry = choices[r].clone() * entry.clone();
    }
}

/// The coefficients `c` of `Σ c_j P_j` become those of `Σ c_j (P_{j+1} − P_j)`.
fn difference<S: Scalar>(row: &mut Vec<S>) {
    let mut left = S::zero();
    for entry in row.iter_mut() {
        let above = entry.clone();
        *entry = left - above.clone();
        left = above;
    }
    row.push(left);
}
