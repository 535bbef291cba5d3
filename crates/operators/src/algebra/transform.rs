//! Affine and projective maps: one matrix acting on homogeneous poles.
//!
//! Every map of section 231 of the book is such a matrix, and the other files make it: translation,
//! rotation, scaling, shear, mirror, projection. A Bézier form is carried by its poles, so the image
//! of the form is the form of the images (*affine invariance*), and in homogeneous coordinates this
//! holds for projective maps too.

use pforms_kernel::{Error, Form, Matrix, Result, Scalar, limit};

use super::Poles;

/// The image under the map that takes the homogeneous pole `p` to `matrix · p`.
///
/// The matrix has `c + 1` columns for a form in `c` dimensions, the weight last, and any number of
/// rows from 2: with `c' + 1` rows the image lies in `c'` dimensions. A last row `(0, …, 0, 1)` makes
/// the map affine: weights stay as they are. Poles at infinity (weight 0) are carried like others.
///
/// Exact. In `f64` each coordinate is a sum of at most `c + 1` products, those with 0 left out and
/// those with 1 not rounded.
///
/// Errors: `Shape` when columns or rows do not fit; `Domain` when a number is not finite or the
/// result overflows. Book 231.
///
/// ```
/// use pforms_kernel::{Form, Matrix};
/// let segment: Form = Form::from_points(&[2], 2, &[0., 0., 1., 2.], None)?;
/// let swap = Matrix::from_rows(vec![vec![0., 1., 0.], vec![1., 0., 0.], vec![0., 0., 1.]])?;
/// assert_eq!(pforms_operators::transform(&segment, &swap)?.points()?, [0., 0., 2., 1.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn transform<S: Scalar, P: Poles<S>>(form: &P, matrix: &Matrix<S>) -> Result<P> {
    let net = form.net();
    require_fit(matrix, net)?;
    let rows = taps(matrix)?;
    let count = limit::check::<S>("the image", net.orders(), rows.len())?;
    let mut poles = Vec::with_capacity(count);
    for pole in net.homogeneous().chunks_exact(net.width()) {
        poles.extend(rows.iter().map(|row| sum(row, pole)));
    }
    form.with_net(Form::from_homogeneous(net.orders(), rows.len() - 1, poles)?)
}

fn require_fit<S: Scalar>(matrix: &Matrix<S>, net: &Form<S>) -> Result<()> {
    let (rows, columns) = (matrix.rows(), matrix.columns());
    if columns == net.width() && rows >= 2 {
        return Ok(());
    }
    Err(Error::shape(
        "matrix",
        format!("{rows} × {columns}"),
        format!(
            "{width} columns for a form in {}D (the weight is the last), and 2 rows at least; \
             {width} rows to stay there",
            net.ambient(),
            width = net.width(),
        ),
    ))
}

/// The entries of a row that count, with their columns.
type Taps<S> = Vec<(usize, S)>;

fn taps<S: Scalar>(matrix: &Matrix<S>) -> Result<Vec<Taps<S>>> {
    let row = |index: usize| {
        let row = matrix.row(index);
        if let Some(bad) = row.iter().find(|entry| !entry.is_finite()) {
            return Err(Error::domain("matrix", format!("{bad:?}"), "finite numbers"));
        }
        let entries = row.iter().cloned().enumerate();
        Ok(entries.filter(|(_, entry)| !entry.is_zero()).collect())
    };
    (0..matrix.rows()).map(row).collect()
}

fn sum<S: Scalar>(row: &[(usize, S)], pole: &[S]) -> S {
    let terms = row.iter().map(|(column, factor)| factor.clone() * pole[*column].clone());
    terms.fold(S::zero(), |sum, term| sum + term)
}

/// The square matrix of an affine map: `linear(row, column)` and, in the last column, `shift(row)`.
pub(super) fn affine<S: Scalar>(
    ambient: usize,
    linear: impl Fn(usize, usize) -> S,
    shift: impl Fn(usize) -> S,
) -> Matrix<S> {
    Matrix::from_rule(ambient + 1, ambient + 1, |row, column| match (row, column) {
        (row, column) if row < ambient && column < ambient => linear(row, column),
        (row, _) if row < ambient => shift(row),
        (_, column) => one_if(column == ambient),
    })
}

/// An affine map of which the point `centre` stays where it is.
pub(super) fn about<S: Scalar>(
    centre: &[S],
    linear: impl Fn(usize, usize) -> S + Copy,
) -> Matrix<S> {
    let shift = |row: usize| {
        let moved = centre.iter().enumerate().filter(|(_, x)| !x.is_zero());
        moved.fold(centre[row].clone(), |rest, (column, x)| rest - linear(row, column) * x.clone())
    };
    affine(centre.len(), linear, shift)
}

pub(super) fn one_if<S: Scalar>(condition: bool) -> S {
    if condition { S::one() } else { S::zero() }
}

/// Complains unless a point or a vector has as many finite coordinates as the space.
pub(super) fn require_in_space<S: Scalar>(
    argument: &str,
    coordinates: &[S],
    ambient: usize,
) -> Result<()> {
    if coordinates.len() != ambient {
        return Err(Error::shape(
            argument,
            format!("{} coordinates", coordinates.len()),
            format!("{ambient}, as many as the space of the form has"),
        ));
    }
    match coordinates.iter().find(|x| !x.is_finite()) {
        Some(bad) => Err(Error::domain(argument, format!("{bad:?}"), "finite numbers")),
        None => Ok(()),
    }
}
