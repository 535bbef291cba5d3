//! Affine sweeps: a form of matrices applied to a form.
//!
//! `sweep(u, v) = AFFINE(u)·section(v)`, where `AFFINE` is a matrix whose entries are themselves a
//! form, of any number of axes (book 324, where it is a trail to explore). A matrix that acts on
//! homogeneous points counts up to a factor, as those points do. So `r × c` matrices are the poles of
//! a form of dimension `r·c − 1`: its homogeneous coordinates are the entries, row after row, and its
//! weight is the last of them, which is 1 for an affine matrix.

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use super::Spline;

/// The form that a form of matrices makes of a section: axes of the matrices first, then the
/// section's own.
///
/// The poles are the products of each matrix with each pole of the section: bilinear in both, so it
/// commutes with everything that combines poles alike, `stack` and `midpoint` first of all. Exact;
/// a curve of matrices sweeps a curve to a surface, a surface to a volume. The matrices need not be
/// square: 4×3 matrices carry a plane section into space. In `f64` a coordinate is a sum of as many
/// products as the section's poles have coordinates.
///
/// Errors: `Shape` unless the matrices have as many columns as the section's poles have homogeneous
/// coordinates, and two rows at least; `Domain` when a product overflows; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// // A half turn in two steps, about the origin of the plane, its weight in the lower right corner.
/// let quarter = [0., -1., 0., 1., 0., 0., 0., 0., 1.];
/// let half = [-1., 0., 0., 0., -1., 0., 0., 0., 1.];
/// let turns = Form::from_homogeneous(&[2], 8, [quarter, half].concat())?;
/// let spoke: Form = Form::from_points(&[2], 2, &[1., 0., 2., 0.], None)?;
/// let swept = pforms_operators::affine_sweep(&turns, &spoke)?;
/// assert_eq!(swept.points()?, [0., 1., 0., 2., -1., 0., -2., 0.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn affine_sweep<S: Scalar>(matrix: &Form<S>, section: &Form<S>) -> Result<Form<S>> {
    let columns = section.width();
    let rows = rows_of(matrix, section)?;
    let mut orders = matrix.orders().to_vec();
    orders.extend_from_slice(section.orders());
    let count = limit::check::<S>("the sweep", &orders, rows)?;
    let mut poles = Vec::with_capacity(count);
    for entries in matrix.homogeneous().chunks_exact(matrix.width()) {
        for pole in section.homogeneous().chunks_exact(columns) {
            poles.extend(entries.chunks_exact(columns).map(|row| product(row, pole)));
        }
    }
    Form::from_homogeneous(&orders, rows - 1, poles)
}

/// [`affine_sweep`] of splines: knots of the matrices, then those of the section. Exact: piece by
/// piece it is the sweep of the pieces.
///
/// Errors: as [`affine_sweep`].
pub fn affine_sweep_spline<S: Scalar>(
    matrix: &Spline<S>,
    section: &Spline<S>,
) -> Result<Spline<S>> {
    let net = affine_sweep(matrix.net(), section.net())?;
    Spline::on(net, [matrix.knots(), section.knots()].concat())
}

/// Rows of the matrices, when they fit the section.
fn rows_of<S: Scalar>(matrix: &Form<S>, section: &Form<S>) -> Result<usize> {
    let (entries, columns) = (matrix.width(), section.width());
    let rows = entries / columns;
    if rows >= 2 && entries == rows * columns {
        return Ok(rows);
    }
    Err(Error::shape(
        "matrix",
        format!("a {} of {entries} entries a pole", matrix.kind()),
        format!(
            "at least two rows of {columns} entries for a section in {}D: {}, {} or {} for results \
             in 1D, 2D or 3D",
            section.ambient(),
            2 * columns,
            3 * columns,
            4 * columns,
        ),
    ))
}

fn product<S: Scalar>(row: &[S], pole: &[S]) -> S {
    let mut sum = S::zero();
    for (entry, x) in row.iter().zip(pole) {
        sum += entry.clone() * x.clone();
    }
    sum
}
