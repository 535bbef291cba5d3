//! A drawn value as triangles only: spheres for points, tubes for lines.

use pforms_kernel::{Error, Result};
use pforms_mesh::{Triangles, push_spheres, tube};
use pforms_scene::{Item, Part};

/// Sides of a tube.
const SIDES: usize = 12;

/// Above so many points, their spheres are coarser.
const MANY: usize = 2000;

/// The triangles of one part.
///
/// Errors: `Limit`; `Domain` for coordinates that single precision cannot hold.
pub(crate) fn triangles(part: &Part) -> Result<Triangles> {
    let mut mesh = Triangles::default();
    match part {
        Part::Triangles(triangles) => mesh = triangles.clone(),
        Part::Points { positions, radius } => {
            let fineness = if positions.len() > MANY { 1 } else { 2 };
            push_spheres(&mut mesh, positions, *radius, fineness)?;
        }
        Part::Lines { polylines, radius } => {
            for line in polylines {
                mesh.append(&tube(line, *radius, SIDES)?);
            }
        }
    }
    Ok(mesh)
}

/// All triangles of a drawn value.
pub(crate) fn all_triangles(item: &Item) -> Result<Triangles> {
    let mut all = Triangles::default();
    for part in &item.parts {
        all.append(&triangles(part)?);
    }
    Ok(all)
}

/// The number in single precision.
///
/// Errors: `Domain` beyond its range.
pub(crate) fn single(x: f64) -> Result<f32> {
    let rounded = x as f32;
    if rounded.is_finite() {
        return Ok(rounded);
    }
    Err(Error::domain("coordinate", x, "at most 3.4e38: the format stores single precision"))
}
