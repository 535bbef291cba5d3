//! Overdetermined linear systems, by orthogonal triangles (Householder).

use nalgebra::DMatrix;
use pforms_kernel::{Error, Result};

/// Minimises `|A·x − b|` for every column `b`.
///
/// No normal equations, so the error grows with the condition of `A`, not with its square.
///
/// Errors: `Degenerate` when there are fewer rows than unknowns, or the columns depend on each
/// other to working accuracy.
pub(crate) fn solve(matrix: DMatrix<f64>, mut columns: DMatrix<f64>) -> Result<DMatrix<f64>> {
    let (rows, unknowns) = matrix.shape();
    if rows < unknowns {
        return Err(Error::degenerate(
            "points",
            format!("{rows} points for {unknowns} poles"),
            "at least as many points as poles",
        ));
    }
    let factors = matrix.qr();
    factors.q_tr_mul(&mut columns);
    let triangle = factors.unpack_r();
    let diagonal = triangle.diagonal().map(f64::abs);
    let smallest = rows as f64 * f64::EPSILON * diagonal.max();
    let dependent = diagonal.iter().filter(|entry| **entry <= smallest).count();
    let mut solution = columns.rows(0, unknowns).into_owned();
    if dependent > 0 || !triangle.solve_upper_triangular_mut(&mut solution) {
        return Err(Error::degenerate(
            "parameters",
            format!("parameters that leave {dependent} of {unknowns} poles undetermined"),
            "more distinct parameters than the degree, on every axis",
        ));
    }
    Ok(solution)
}
