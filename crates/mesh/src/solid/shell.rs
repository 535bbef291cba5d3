//! Patches and meshes to closed shells that know their outside.

use pforms_kernel::{Error, Form, Result};

use super::Solid;
use super::bound::volume_error;
use super::zip::zipped;
use crate::edges::{borders, open, oriented};
use crate::mesh::volume_in_units;
use crate::pieces::{ball, finite_pieces};
use crate::space::embed;
use crate::vector::{Vec3, cross, norm, subtract};
use crate::weld::welded;
use crate::{Mesh, Sampling, facets, poles, require_room};

/// A volume below this share of size times area is nothing but rounding.
const FLAT: f64 = 1e-13;

/// Poles this near a line, in sizes of the shell, are on it but for their rounding.
const ON_A_LINE: f64 = 1e-14;

/// What a sample takes while solids are combined, in samples of a drawing.
const WORK: usize = 16;

/// The shell of patches that meet within half the accuracy, meshed within the other half.
pub(super) fn of_patches(patches: &[Form], accuracy: f64, name: &str) -> Result<Solid> {
    let mut pieces = Vec::new();
    for patch in patches {
        pieces.extend(finite_pieces(&embed(patch)?)?);
    }
    let (_, radius) = ball(&pieces);
    if radius == 0.0 {
        return Err(Error::degenerate(name, "a single point", "a shell with a volume"));
    }
    let tolerance = accuracy * radius;
    let sampling = Sampling::Tolerance(tolerance);
    let mut broad = Vec::with_capacity(patches.len());
    for patch in patches {
        if !is_line(patch, radius)? {
            broad.push(patch.clone());
        }
    }
    let patches = &broad[..];
    let mut samples = 0_usize;
    for patch in patches {
        samples = samples.saturating_add(sampling.segments(patch)?.iter().product());
    }
    require_room("the solid", &[WORK, samples])?;
    let meshes = facets(patches, &sampling)?;
    let (mut places, mut triangles) = (Vec::new(), Vec::new());
    for mesh in meshes {
        let shift = places.len() as u32;
        places.extend(mesh.positions);
        triangles.extend(mesh.indices.iter().map(|corners| corners.map(|k| k + shift)));
    }
    let (places, triangles) = welded(&places, &triangles);
    let (places, mut triangles, moved) = zipped(places, triangles, tolerance);
    require_closed(&places, &borders(&triangles), tolerance, name)?;
    let Some(parts) = oriented(&mut triangles) else {
        return Err(Error::shape(name, "a surface of one side", "a shell with an inside"));
    };
    for part in parts {
        let own: Vec<[u32; 3]> = part.iter().map(|number| triangles[*number]).collect();
        // What is open by itself is a wall between two parts, such as the ends of a full turn: it
        // stays as it was given.
        if open(&own).is_empty() && volume_in_units(&places, &own).0 < 0.0 {
            for number in part {
                triangles[number].swap(1, 2);
            }
        }
    }
    require_closed(&places, &open(&triangles), tolerance, name)?;
    require_volume(&places, &triangles, name)?;
    let distance = tolerance + moved;
    let volume_error = volume_error(&places, &triangles, distance);
    Ok(Solid { mesh: Mesh::of_space(places, triangles)?, distance, volume_error })
}

/// Do all poles lie on a line, as those of a face that turns on an axis do? It has no area, and its
/// neighbours on both sides meet without it.
fn is_line(patch: &Form, radius: f64) -> Result<bool> {
    let places = poles(patch)?;
    let Some(first) = places.first() else { return Ok(false) };
    let away = |place: &Vec3| subtract(*place, *first).map(|x| x / radius);
    let far = places.iter().map(away).max_by(|a, b| norm(*a).total_cmp(&norm(*b)));
    let side = far.unwrap_or_default();
    Ok(places.iter().all(|place| norm(cross(away(place), side)) <= ON_A_LINE * norm(side)))
}

/// The shell of a mesh; nothing for an empty one.
///
/// Hollows, which are turned inwards, stay hollow; a mesh that is inside out as a whole is turned.
pub(super) fn of_mesh(mesh: &Mesh, name: &str) -> Result<Option<Solid>> {
    if mesh.ambient() != 3 {
        let received = format!("a mesh in dimension {}", mesh.ambient());
        return Err(Error::shape(name, received, "a closed mesh in space"));
    }
    if mesh.vertex_count() == 0 {
        return Ok(None);
    }
    if mesh.is_cloud() {
        return Err(Error::shape(name, "a cloud of points", "a closed mesh in space"));
    }
    let (places, mut triangles) = welded(&mesh.places(), mesh.triangles());
    require_closed(&places, &borders(&triangles), 0.0, name)?;
    if !open(&triangles).is_empty() && oriented(&mut triangles).is_none() {
        return Err(Error::shape(name, "a surface of one side", "a shell with an inside"));
    }
    require_closed(&places, &open(&triangles), 0.0, name)?;
    if volume_in_units(&places, &triangles).0 < 0.0 {
        for corners in &mut triangles {
            corners.swap(1, 2);
        }
    }
    require_volume(&places, &triangles, name)?;
    let volume_error = volume_error(&places, &triangles, 0.0);
    Ok(Some(Solid { mesh: Mesh::of_space(places, triangles)?, distance: 0.0, volume_error }))
}

/// Complains about edges without a neighbour, telling how many there are and where one is.
fn require_closed(places: &[Vec3], open: &[([u32; 2], usize)], gap: f64, name: &str) -> Result<()> {
    let Some(([a, b], _)) = open.first() else { return Ok(()) };
    let [a, b] = [*a, *b].map(|vertex| places[vertex as usize]);
    let middle = [0, 1, 2].map(|k| format!("{:.4}", a[k] / 2.0 + b[k] / 2.0)).join(", ");
    let received =
        format!("an open shell: {} edges without a neighbour, one near ({middle})", open.len());
    let within =
        if gap > 0.0 { format!(", patches that meet within {gap:.1e}") } else { String::new() };
    Err(Error::shape(name, received, format!("a closed shell{within}")))
}

fn require_volume(places: &[Vec3], triangles: &[[u32; 3]], name: &str) -> Result<()> {
    let (volume, unit) = volume_in_units(places, triangles);
    let area = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|vertex| places[vertex as usize].map(|x| x / unit));
        norm(cross(subtract(b, a), subtract(c, a))) / 2.0
    };
    if volume.abs() > FLAT * triangles.iter().map(area).sum::<f64>() {
        return Ok(());
    }
    Err(Error::degenerate(name, "a shell without a volume", "one that holds something"))
}
