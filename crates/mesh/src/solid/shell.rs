//! Patches and meshes to closed shells that know their outside.

use pforms_kernel::{Error, Form, Result};
use pforms_operators::{Shape, area};

use super::faces::{Face, align, ball, without_walls};
use super::skin::Skin;
use super::zip::zip;
use crate::adaptive::{Stray, scaled, told};
use crate::edges::{borders, open, oriented};
use crate::mesh::volume_in_units;
use crate::space::centred;
use crate::vector::{Vec3, cross, norm, subtract};
use crate::weld::welded;
use crate::{Mesh, Sampling, require_room};

/// A volume below this share of size times area is nothing but rounding.
const FLAT: f64 = 1e-13;

/// What a sample takes while solids are combined, in samples of a drawing.
const WORK: usize = 16;

/// How well the area of a surface has to be known.
const AREA: f64 = 1e-2;

/// A closed shell, its triangles counter-clockwise seen from outside.
pub(super) struct Shell {
    pub(super) places: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// How far the surface strays from each triangle.
    pub(super) strays: Vec<Stray>,
    /// No point of the surface is farther from the mesh than this.
    pub(super) distance: f64,
    /// The area of the surface at most, where that is known.
    pub(super) area: Option<f64>,
}

/// The shell of the faces of a volume, some of which may lie inside it.
pub(super) fn of_volume(faces: &[Form], accuracy: f64, name: &str) -> Result<Shell> {
    let faces = faces.iter().map(Face::of).collect::<Result<_>>()?;
    of_faces(without_walls(faces), accuracy, name)
}

/// The shell of patches that meet within half the accuracy, meshed within the other half.
pub(super) fn of_patches(patches: &[Form], accuracy: f64, name: &str) -> Result<Shell> {
    of_faces(patches.iter().map(Face::of).collect::<Result<_>>()?, accuracy, name)
}

fn of_faces(mut faces: Vec<Face>, accuracy: f64, name: &str) -> Result<Shell> {
    let (centre, radius) = ball(&faces);
    // Without any face left, all of them were walls.
    if faces.is_empty() || radius == 0.0 {
        return Err(Error::degenerate(name, "a single point", "a shell with a volume"));
    }
    let tolerance = accuracy * radius;
    faces.retain(|face| !face.is_curve(centre, radius));
    let aligned = align(&mut faces, radius)?;
    let patches: Vec<Form> = faces.into_iter().map(|face| face.form).collect();
    let sampling = Sampling::Tolerance(tolerance);
    let mut samples = 0_usize;
    for patch in &patches {
        samples = samples.saturating_add(sampling.segments(patch)?.iter().product());
    }
    require_room("the solid", &[WORK, samples])?;
    let mut skin = Skin::of(told(&patches, tolerance, false)?);
    zip(&mut skin, tolerance);
    let Skin { places, mut triangles, strays, moved } = skin;
    require_closed(&places, &borders(&triangles), tolerance, name)?;
    let Some(parts) = oriented(&mut triangles) else {
        return Err(Error::shape(name, "a surface of one side", "a shell with an inside"));
    };
    for part in parts {
        let own: Vec<[u32; 3]> = part.iter().map(|number| triangles[*number]).collect();
        // What is open by itself is a wall between two parts: it stays as it was given.
        if open(&own).is_empty() && volume_in_units(&places, &own).0 < 0.0 {
            for number in part {
                triangles[number].swap(1, 2);
            }
        }
    }
    require_closed(&places, &open(&triangles), tolerance, name)?;
    require_volume(&places, &triangles, name)?;
    let area = area_at_most(&patches, centre, radius)?;
    let strays = strays.into_iter().map(|stray| stray.moved(aligned)).collect();
    Ok(Shell { places, triangles, strays, distance: tolerance + moved + aligned, area })
}

/// The area of patches from above, if it can be had.
fn area_at_most(patches: &[Form], centre: Vec3, radius: f64) -> Result<Option<f64>> {
    // Near the origin nothing cancels; squares of areas neither overflow nor vanish in units of the
    // size.
    let unit = libm::ldexp(1.0, libm::frexp(radius).1.clamp(-1000, 1000));
    let shapes: Vec<Shape> = patches
        .iter()
        .map(|patch| Ok(scaled(&centred(patch, centre)?, 1.0 / unit)?.into()))
        .collect::<Result<_>>()?;
    let measured = area(&shapes, AREA).ok();
    Ok(measured.map(|area| (area.value + area.error) * unit * unit))
}

/// The shell of a mesh; nothing for an empty one.
///
/// Hollows, which are turned inwards, stay hollow; a mesh that is inside out as a whole is turned.
pub(super) fn of_mesh(mesh: &Mesh, name: &str) -> Result<Option<Shell>> {
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
    let strays = vec![Stray::default(); triangles.len()];
    Ok(Some(Shell { places, triangles, strays, distance: 0.0, area: None }))
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
