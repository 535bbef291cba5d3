//! Spheres for points.

use pforms_kernel::{Error, Result};

use crate::vector::{Vec3, add, scale, unit};
use crate::{Triangles, require_room};

/// The six corners of an octahedron.
const CORNERS: [Vec3; 6] = [
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
];

/// Its faces, seen from outside.
const FACES: [[u32; 3]; 8] =
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];

/// A sphere: an octahedron whose faces are cut into four `fineness` times and blown up.
///
/// It has `8·4^fineness` triangles. Errors: `Domain` unless the radius is positive and the
/// fineness at most 8.
pub fn sphere(centre: Vec3, radius: f64, fineness: u32) -> Result<Triangles> {
    let mut mesh = Triangles::default();
    push_spheres(&mut mesh, &[centre], radius, fineness)?;
    Ok(mesh)
}

/// Adds a [`sphere`] about each of the points.
///
/// Errors: as [`sphere`], and `Limit`.
pub fn push_spheres(
    mesh: &mut Triangles,
    centres: &[Vec3],
    radius: f64,
    fineness: u32,
) -> Result<()> {
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(Error::domain("radius", radius, "a positive length"));
    }
    if fineness > 8 {
        return Err(Error::domain("fineness", fineness, "0 to 8"));
    }
    let (directions, faces) = ball(fineness);
    require_room("the spheres", &[centres.len(), directions.len()])?;
    for centre in centres {
        let first = mesh.positions.len() as u32;
        mesh.positions.extend(directions.iter().map(|way| add(*centre, scale(radius, *way))));
        mesh.normals.extend(&directions);
        mesh.indices.extend(faces.iter().map(|face| face.map(|vertex| vertex + first)));
    }
    Ok(())
}

/// Directions and faces of the unit sphere.
fn ball(fineness: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let (mut directions, mut faces) = (CORNERS.to_vec(), FACES.to_vec());
    for _ in 0..fineness {
        let mut middles = std::collections::HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let sum = add(directions[a as usize], directions[b as usize]);
                directions.push(unit(sum).unwrap_or(sum));
                directions.len() as u32 - 1
            })
        };
        let mut finer = Vec::with_capacity(faces.len() * 4);
        for [a, b, c] in faces {
            let [d, e, f] = [middle(a, b), middle(b, c), middle(c, a)];
            finer.extend([[a, d, f], [d, b, e], [f, e, c], [d, e, f]]);
        }
        faces = finer;
    }
    (directions, faces)
}
