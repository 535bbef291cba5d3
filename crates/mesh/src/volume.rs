//! What is drawn of a volume: its six faces, a stack of leaves, a bundle of fibres.

use pforms_kernel::{Error, Form, Result, bernstein_row};
use pforms_operators::{Poles, Shape};

use crate::require_room;
use crate::space::{embed, project, quadruples, require_axes, tensor};
use crate::vector::{cross, dot};

/// Samples along each axis that decide on which side of its faces a volume lies.
const PROBES: [f64; 3] = [0.25, 0.5, 0.75];

/// The six faces of a volume as surfaces whose normals point outwards.
///
/// A volume that folds over has no outside everywhere; then most of it decides.
///
/// Errors: `Shape` unless the form has three axes.
pub fn envelope(form: &Form) -> Result<Vec<Form>> {
    require_axes(form, 3, "a volume: three axes")?;
    let mirrored = is_mirrored(form)?;
    let mut faces = Vec::with_capacity(6);
    for axis in 0..3 {
        for high in [false, true] {
            let face = section(form, axis, if high { 1.0 } else { 0.0 })?;
            // The axes left, in their order, make ∂ × ∂ point along axis 0 and 2, against axis 1.
            let along = (axis != 1) != mirrored;
            faces.push(if along == high { face } else { transposed(&face)? });
        }
    }
    Ok(faces)
}

/// `count` leaves of a volume at equal parameters of `axis`, the first and the last its faces.
///
/// Of any form or spline, the parts at these parameters. A single leaf is the one in the middle.
///
/// Errors: `Shape` when there is no such axis; `Domain` for no leaf at all.
pub fn leaves(shape: &Shape, axis: usize, count: usize) -> Result<Vec<Shape>> {
    require_count(count)?;
    let spline = match shape {
        Shape::Form(form) => {
            return parameters(count).map(|t| Ok(section(form, axis, t)?.into())).collect();
        }
        Shape::Spline(spline) => spline.bezier()?,
    };
    let (from, to) = spline.window(axis)?;
    let place = |t: f64| if t == 1.0 { to } else { from + t * (to - from) };
    parameters(count).map(|t| Ok(spline.sub(axis, &place(t))?.into())).collect()
}

/// `count × count` curves of a volume along `axis`; of a surface, `count` curves.
///
/// Errors: as [`leaves`].
pub fn fibres(shape: &Shape, axis: usize, count: usize) -> Result<Vec<Shape>> {
    require_count(count)?;
    shape.net().require_axis(axis)?;
    let mut fibres = vec![shape.clone()];
    for other in (0..shape.net().axes()).rev().filter(|&other| other != axis) {
        require_room("the bundle", &[fibres.len(), count])?;
        let parts: Result<Vec<_>> = fibres.iter().map(|part| leaves(part, other, count)).collect();
        fibres = parts?.concat();
    }
    Ok(fibres)
}

fn require_count(count: usize) -> Result<()> {
    if (1..=1 << 16).contains(&count) {
        return Ok(());
    }
    Err(Error::domain("count", count, "1 to 65536"))
}

fn parameters(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |i| if count == 1 { 0.5 } else { i as f64 / (count - 1) as f64 })
}

fn section(form: &Form, axis: usize, t: f64) -> Result<Form> {
    form.require_axis(axis)?;
    form.contract(axis, &bernstein_row(form.orders()[axis] - 1, &t))
}

/// The surface with its two axes exchanged.
fn transposed(face: &Form) -> Result<Form> {
    let (rows, columns, width) = (face.orders()[0], face.orders()[1], face.width());
    let mut poles = Vec::with_capacity(face.homogeneous().len());
    for j in 0..columns {
        for i in 0..rows {
            poles.extend_from_slice(&face.homogeneous()[(i * columns + j) * width..][..width]);
        }
    }
    Form::from_homogeneous(&[columns, rows], face.ambient(), poles)
}

/// Does the volume turn its parameters round, seen as a whole: is its Jacobian mostly negative?
fn is_mirrored(form: &Form) -> Result<bool> {
    let form = embed(form)?;
    let at: [&[f64]; 3] = [&PROBES; 3];
    let points = tensor(&form, &at, None)?;
    let derived: Vec<Form> =
        (0..3).map(|axis| tensor(&form, &at, Some(axis))).collect::<Result<_>>()?;
    let mut sum = 0.0;
    for (k, point) in quadruples(&points).iter().enumerate().filter(|(_, point)| point[3] != 0.0) {
        let place = project(point);
        let [du, dv, dw] = [0, 1, 2].map(|axis| {
            let [x, y, z, w] = quadruples(&derived[axis])[k];
            [x - w * place[0], y - w * place[1], z - w * place[2]].map(|d| d / point[3])
        });
        sum += dot(du, cross(dv, dw));
    }
    Ok(sum < 0.0)
}
