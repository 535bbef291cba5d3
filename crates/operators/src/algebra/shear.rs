//! Shear: layers slide over one another.

use pforms_kernel::{Error, Matrix, Result, Scalar};

use super::transform::{about, one_if, require_in_space};
use super::{Poles, transform};

/// The form with every point moved by `by` times its `coordinate`, counted from `centre`.
///
/// The layers on which that coordinate is constant slide as they are, so `by` has nothing along it,
/// and volumes stay. A shear along other planes is this one between two rotations. Exact.
///
/// Errors: `Shape` when there is no such coordinate or `by` or `centre` has another number of them;
/// `Domain` when `by[coordinate]` is not 0 or a number is not finite. Book 231.
///
/// ```
/// use pforms_kernel::Form;
/// let segment: Form = Form::from_points(&[2], 2, &[0., 0., 1., 2.], None)?;
/// let italic = pforms_operators::shear(&segment, 1, &[0.25, 0.], &[0., 0.])?;
/// assert_eq!(italic.points()?, [0., 0., 1.5, 2.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn shear<S: Scalar, P: Poles<S>>(
    form: &P,
    coordinate: usize,
    by: &[S],
    centre: &[S],
) -> Result<P> {
    require_in_space("by", by, form.net().ambient())?;
    transform(form, &shearing(coordinate, by, centre)?)
}

/// The matrix of [`shear`].
///
/// Errors: as [`shear`].
pub fn shearing<S: Scalar>(coordinate: usize, by: &[S], centre: &[S]) -> Result<Matrix<S>> {
    let Some(along) = by.get(coordinate) else {
        return Err(Error::shape(
            "coordinate",
            coordinate,
            format!("a coordinate of {}D: the first is 0", by.len()),
        ));
    };
    require_in_space("by", by, by.len())?;
    require_in_space("centre", centre, by.len())?;
    if !along.is_zero() {
        return Err(Error::domain(
            "by",
            format!("{along:?} along coordinate {coordinate}"),
            "0 there: a shear slides layers, it does not stretch (scale does)",
        ));
    }
    let slide = |row: usize, column: usize| {
        if column == coordinate && row != column { by[row].clone() } else { one_if(row == column) }
    };
    Ok(about(centre, slide))
}
