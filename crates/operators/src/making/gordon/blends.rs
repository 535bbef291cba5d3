//! Cardinal blends: the spline that is 1 at one parameter and 0 at the others.

use pforms_kernel::{Error, Matrix, Result, Scalar, limit};

use super::blend_degree;
use crate::algebra::Knots;

/// Knots of the blends at these places: inner ones are means of as many consecutive places as the
/// degree, so that there is one spline through any values there (*The NURBS Book*, 9.8).
pub(super) fn knots_at<S: Scalar>(places: &[S], window: &(S, S)) -> Result<Knots<S>> {
    let degree = blend_degree(places.len());
    let mut list = vec![window.0.clone(); degree + 1];
    if degree > 0 {
        let share = S::ratio(1, degree as i64);
        for j in 1..places.len() - degree {
            let own = places[j..j + degree].iter();
            list.push(own.fold(S::zero(), |sum, t| sum + t.clone() * share.clone()));
        }
    }
    list.extend(vec![window.1.clone(); degree + 1]);
    Knots::new(degree, list)
}

/// The matrix from the values at the places to the poles of the spline that has them.
pub(super) fn values_to_poles<S: Scalar>(knots: &Knots<S>, places: &[S]) -> Result<Matrix<S>> {
    let count = places.len();
    limit::check::<S>("the matrix of the blends", &[count, 2 * count], 1)?;
    let mut rows: Vec<Vec<S>> = Vec::with_capacity(count);
    for (i, t) in places.iter().enumerate() {
        let (first, factors) = knots.basis(t);
        let mut row = vec![S::zero(); 2 * count];
        row[first..first + factors.len()].clone_from_slice(&factors);
        row[count + i] = S::one();
        rows.push(row);
    }
    for column in 0..count {
        eliminate(&mut rows, column)?;
    }
    Matrix::from_rows(rows.into_iter().map(|row| row[count..].to_vec()).collect())
}

/// One step of Gauss and Jordan, the largest entry of the column as pivot.
fn eliminate<S: Scalar>(rows: &mut [Vec<S>], column: usize) -> Result<()> {
    let size = |x: &S| if *x < S::zero() { -x.clone() } else { x.clone() };
    let below = column + 1..rows.len();
    let pivot = below.fold(column, |best, row| {
        if size(&rows[row][column]) > size(&rows[best][column]) { row } else { best }
    });
    rows.swap(column, pivot);
    let head = rows[column][column].clone();
    if head.is_zero() {
        return Err(Error::degenerate(
            "parameters",
            "curves too close together",
            "distinct curves",
        ));
    }
    for x in &mut rows[column] {
        *x = x.clone() / head.clone();
    }
    let line = rows[column].clone();
    for (index, row) in rows.iter_mut().enumerate() {
        let factor = -row[column].clone();
        if index != column && !factor.is_zero() {
            S::add_multiple(row, &factor, &line);
        }
    }
    Ok(())
}
