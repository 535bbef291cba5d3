//! The net of poles, and normals as little lines.

use pforms_kernel::{Form, Result};

use crate::space::{embed, project, quadruples};
use crate::vector::{Vec3, add, scale};
use crate::{Polyline, Sampling, surface};

/// The lines that join neighbouring poles along every axis.
///
/// A line is cut at a pole at infinity; poles with no finite neighbour do not appear.
pub fn net(form: &Form) -> Result<Vec<Polyline>> {
    let form = embed(form)?;
    let poles = quadruples(&form);
    let mut lines = Vec::new();
    let mut stride = poles.len();
    for &order in form.orders() {
        let block = stride;
        stride /= order;
        for start in (0..poles.len()).filter(|start| start % block < stride) {
            let line: Vec<&[f64; 4]> = (0..order).map(|k| &poles[start + k * stride]).collect();
            let parts = line.split(|pole| pole[3] == 0.0).filter(|part| part.len() > 1);
            lines
                .extend(parts.map(|part| {
                    Polyline::through(part.iter().map(|pole| project(pole)).collect())
                }));
        }
    }
    Ok(lines)
}

/// A line of the given length along the normal at every sample of a surface.
///
/// Errors: those of [`surface`].
pub fn normals(form: &Form, sampling: &Sampling, length: f64) -> Result<Vec<Polyline>> {
    let mesh = surface(form, sampling)?;
    let line = |(from, normal): (&Vec3, &Vec3)| {
        Polyline::through(vec![*from, add(*from, scale(length, *normal))])
    };
    Ok(mesh.positions.iter().zip(&mesh.normals).map(line).collect())
}
