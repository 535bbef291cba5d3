//! The normals of one piece as polynomial vectors.

use pforms_kernel::{Error, Form, Matrix, Result, Scalar, pascal_row};

use super::Side;
use crate::measuring::about_one::{seen_locally, with_weights_about_one};
use crate::measuring::guarded::{Guarded, significant};
use crate::{normal_form, reduce, tangent_form};

/// A piece, and vectors along its normals.
pub(super) struct Field {
    /// The piece, weights about 1.
    pub piece: Form,
    /// The piece seen from one of its points, in units that make it about 1.
    pub local: Form<Guarded>,
    /// Polynomial vectors along the normals, which vanish on no side of the window.
    pub normal: Form,
}

impl Field {
    /// Errors: `Shape` when forms of this kind have no normals on that side; `Degenerate` when there
    /// are none anywhere.
    pub(super) fn new(piece: &Form, side: &Side, unit: i32) -> Result<Self> {
        let piece = with_weights_about_one(piece)?;
        let local = seen_locally(&piece, unit)?;
        let normal = lowered(stripped(vectors(&local, side)?)?)?;
        Ok(Self { normal: normal.map_scalar(|x| x.value)?, piece, local })
    }

    /// By which power of its length the vectors shrink when a window grows.
    pub(super) fn power(side: &Side) -> i32 {
        if *side == Side::Principal { 4 } else { 1 }
    }
}

fn vectors(piece: &Form<Guarded>, side: &Side) -> Result<Form<Guarded>> {
    match (side, piece.axes(), piece.ambient()) {
        (Side::Natural, 1, 2) | (Side::Natural, 2, 3) | (Side::Principal, 1, 3) => {
            normal_form(piece)
        }
        (Side::Across(k), 1, 3) => across(&tangent_form(piece, 0)?, k),
        (Side::Natural, 1, 3) => Err(Error::shape(
            "side",
            "a curve in space without a side",
            "the vector it is seen from, or the principal normal",
        )),
        _ => Err(Error::shape(
            "form",
            format!("a {} in dimension {}", piece.kind(), piece.ambient()),
            "a surface in dimension 3 or a curve in dimension 2 or 3 (a side only for the latter)",
        )),
    }
}

/// `k × tangent`.
fn across(tangent: &Form<Guarded>, k: &[f64; 3]) -> Result<Form<Guarded>> {
    let size = k.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    if !size.is_finite() || size == 0.0 {
        return Err(Error::domain("side", format!("{k:?}"), "a finite vector that is not 0"));
    }
    let k = k.map(|x| Guarded::from(x / size));
    let poles = tangent.homogeneous().chunks_exact(4).flat_map(|t| {
        [(1, 2), (2, 0), (0, 1)].map(|(i, j)| k[i] * t[j] - k[j] * t[i]).into_iter().chain([t[3]])
    });
    Form::from_homogeneous(tangent.orders(), 3, poles.collect())
}

/// The field divided by `t` or `1 − t` as often as it vanishes on a side: at a collapsed edge the
/// direction stays, the length becomes that of the next derivative.
fn stripped(mut field: Form<Guarded>) -> Result<Form<Guarded>> {
    let any = field.homogeneous().chunks_exact(field.width());
    let any: Vec<Guarded> = any.flat_map(|pole| pole[..field.ambient()].to_vec()).collect();
    if !significant(&any) {
        return Err(Error::degenerate(
            "form",
            "a form without normals: it is straight, or collapsed",
            "a form that has normals",
        ));
    }
    for axis in 0..field.axes() {
        for far in [false, true] {
            while field.orders()[axis] > 1 && !significant(&layer(&field, axis, far)) {
                field = divided(&field, axis, far)?;
            }
        }
    }
    Ok(field)
}

/// The field in as few poles as it needs: those of a plane are one vector.
fn lowered(mut field: Form<Guarded>) -> Result<Form<Guarded>> {
    for axis in 0..field.axes() {
        while field.orders()[axis] > 1 {
            let row = pascal_row::<Guarded>(field.orders()[axis] - 1).into_iter().enumerate();
            let row = row.map(|(i, c)| if i % 2 == 0 { c } else { -c });
            let top = field.contract(axis, &row.collect::<Vec<_>>())?;
            let top = top.homogeneous().chunks_exact(top.width());
            if significant(
                &top.flat_map(|pole| pole[..pole.len() - 1].to_vec()).collect::<Vec<_>>(),
            ) {
                break;
            }
            let mut by = vec![0; field.axes()];
            by[axis] = 1;
            field = reduce(&field, &by)?.form;
        }
    }
    Ok(field)
}

/// The vectors on one side of the window.
pub(super) fn layer(field: &Form<Guarded>, axis: usize, far: bool) -> Vec<Guarded> {
    let order = field.orders()[axis];
    let inner = field.orders()[axis + 1..].iter().product::<usize>();
    let wanted = if far { order - 1 } else { 0 };
    let poles = field.homogeneous().chunks_exact(field.width()).enumerate();
    let here = poles.filter(|(flat, _)| flat / inner % order == wanted);
    here.flat_map(|(_, pole)| pole[..field.ambient()].to_vec()).collect()
}

/// The field over `t`, or over `1 − t`: its first, or last, poles along the axis are 0.
pub(super) fn divided(field: &Form<Guarded>, axis: usize, far: bool) -> Result<Form<Guarded>> {
    let order = field.orders()[axis];
    let degree = order as i64 - 1;
    let matrix = Matrix::from_rule(order - 1, order, |row, column| match (far, column) {
        (false, c) if c == row + 1 => Guarded::ratio(degree, row as i64 + 1),
        (true, c) if c == row => Guarded::ratio(degree, degree - row as i64),
        _ => Guarded::zero(),
    });
    Ok(field.along(axis, &matrix)?.with_uniform_weight(&Guarded::one()))
}
