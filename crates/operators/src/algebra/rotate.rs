//! Rotation: in a plane of coordinates, about an axis of 3D, or by three angles as in the book.

use pforms_kernel::{Error, Matrix, Result, Scalar};

use super::transform::{about, one_if, require_in_space};
use super::{Poles, Turn, transform};

/// What turns, and what stays where it is.
#[derive(Clone, Debug, PartialEq)]
pub enum Rotation<S = f64> {
    /// In the plane of two coordinates, from the first toward the second, in any dimension.
    Plane(usize, usize, Turn<S>),
    /// About a unit direction of 3D, counter-clockwise as seen from its tip.
    Axis([S; 3], Turn<S>),
    /// By three angles of 3D as in the book: about x from y toward z, then about y **from x toward
    /// z**, then about z from x toward y. The second goes against the right-handed rule.
    Book([Turn<S>; 3]),
}

impl Rotation<f64> {
    /// About a direction of 3D of any length.
    ///
    /// Errors: `Shape` unless it has 3 coordinates, `Degenerate` when they are all 0, `Domain` when
    /// one is not finite.
    pub fn about(axis: &[f64], turn: Turn) -> Result<Self> {
        Self::about_by(axis, turn, |square| Ok::<_, Error>(libm::sqrt(*square)))
    }
}

impl<S: Scalar> Rotation<S> {
    /// About a direction of 3D of any length, which the square root of its square has to tell: in
    /// exact arithmetic it may be no fraction.
    ///
    /// Errors: as [`Rotation::about`], and those of `root`.
    pub fn about_by<E: From<Error>>(
        axis: &[S],
        turn: Turn<S>,
        root: impl FnOnce(&S) -> std::result::Result<S, E>,
    ) -> std::result::Result<Self, E> {
        require_in_space("axis", axis, 3)?;
        let size = |x: &S| if *x < S::zero() { -x.clone() } else { x.clone() };
        let largest = axis.iter().map(size).fold(S::zero(), |a, b| if a < b { b } else { a });
        if largest.is_zero() {
            return Err(Error::degenerate("axis", "a zero vector", "a direction").into());
        }
        // Squares of numbers up to 1 do not overflow.
        let scaled = [0, 1, 2].map(|k: usize| axis[k].clone() / largest.clone());
        let square = scaled.iter().fold(S::zero(), |sum, x| sum + x.clone() * x.clone());
        let length = root(&square)?;
        Ok(Self::Axis(scaled.map(|x| x / length.clone()), turn))
    }
}

/// The form turned about `centre`.
///
/// Exact when the turn is, see [`Turn`]; otherwise as good as its cosine and sine. Lengths are kept
/// to as many roundings. Weights stay.
///
/// Errors: `Shape` when the rotation or the centre does not fit the space: an axis and the three
/// angles need 3D, a plane two different coordinates; `Domain` when a number is not finite. Book 231.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Rotation, Turn, rotate};
/// let segment: Form = Form::from_points(&[2], 2, &[1., 0., 2., 0.], None)?;
/// let turned = rotate(&segment, &Rotation::Plane(0, 1, Turn::degrees(90.)?), &[1., 0.])?;
/// assert_eq!(turned.points()?, [1., 0., 1., 1.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn rotate<S: Scalar, P: Poles<S>>(form: &P, rotation: &Rotation<S>, centre: &[S]) -> Result<P> {
    require_in_space("centre", centre, form.net().ambient())?;
    transform(form, &rotation_matrix(rotation, centre)?)
}

/// The matrix of [`rotate`].
///
/// Errors: as [`rotate`].
pub fn rotation_matrix<S: Scalar>(rotation: &Rotation<S>, centre: &[S]) -> Result<Matrix<S>> {
    require_in_space("centre", centre, centre.len())?;
    match rotation {
        Rotation::Plane(from, to, turn) => in_plane(*from, *to, turn, centre),
        Rotation::Axis(axis, turn) => {
            require_space(centre)?;
            require_in_space("axis", axis, 3)?;
            Ok(about(centre, |row, column| rodrigues(axis, turn, row, column)))
        }
        Rotation::Book([x, y, z]) => {
            require_space(centre)?;
            let origin = [S::zero(), S::zero(), S::zero()];
            let first = in_plane(1, 2, x, &origin)?;
            let second = in_plane(0, 2, y, &origin)?.times(&first)?;
            let all = in_plane(0, 1, z, &origin)?.times(&second)?;
            Ok(about(centre, |row, column| all.row(row)[column].clone()))
        }
    }
}

fn in_plane<S: Scalar>(from: usize, to: usize, turn: &Turn<S>, centre: &[S]) -> Result<Matrix<S>> {
    if from == to || from.max(to) >= centre.len() {
        return Err(Error::shape(
            "plane",
            format!("coordinates {from} and {to}"),
            format!("two different coordinates of {}D: the first is 0", centre.len()),
        ));
    }
    Ok(about(centre, |row, column| match (row, column) {
        _ if row == column && (row == from || row == to) => turn.cosine().clone(),
        _ if (row, column) == (to, from) => turn.sine().clone(),
        _ if (row, column) == (from, to) => -turn.sine().clone(),
        _ => one_if(row == column),
    }))
}

fn require_space<S>(centre: &[S]) -> Result<()> {
    if centre.len() == 3 {
        return Ok(());
    }
    Err(Error::shape(
        "form",
        format!("one in {}D", centre.len()),
        "one in 3D (in other dimensions a plane of two coordinates turns)",
    ))
}

/// An entry of `k·kᵀ + cosine·(I − k·kᵀ) + sine·[k]×`, the matrix of Rodrigues.
fn rodrigues<S: Scalar>(k: &[S; 3], turn: &Turn<S>, row: usize, column: usize) -> S {
    let along = k[row].clone() * k[column].clone();
    let across = one_if::<S>(row == column) - along.clone();
    let kept = along + turn.cosine().clone() * across;
    // [k]× has −k₂ at (0, 1), k₁ at (0, 2), and so on round.
    match (3 + column - row) % 3 {
        1 => kept - turn.sine().clone() * k[(row + 2) % 3].clone(),
        2 => kept + turn.sine().clone() * k[(row + 1) % 3].clone(),
        _ => kept,
    }
}
