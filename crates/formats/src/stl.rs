//! The triangles of a drawn scene as binary STL.

use pforms_kernel::{Error, Result};
use pforms_mesh::vector::{Vec3, cross, subtract, unit};
use pforms_scene::Scene;

use crate::solid::{all_triangles, single};

/// Writes all triangles; colours and names are lost.
///
/// Points that are the same in the mesh stay the same, so what is closed stays closed. Triangles
/// that single precision shrinks to a line are left out.
///
/// Errors: `Domain` for coordinates beyond single precision; `Limit` above 2³² triangles.
pub fn write(scene: &Scene) -> Result<Vec<u8>> {
    let mut facets = Vec::new();
    let mut count = 0_usize;
    for item in &scene.items {
        let mesh = all_triangles(item)?;
        for index in 0..mesh.indices.len() {
            let mut corners = [[0.0_f32; 3]; 3];
            for (corner, point) in corners.iter_mut().zip(mesh.corners(index)) {
                for (x, coordinate) in corner.iter_mut().zip(point) {
                    // Adding 0 turns −0 into 0: the same place must have the same bits.
                    *x = single(coordinate)? + 0.0;
                }
            }
            let [a, b, c] = corners;
            if a == b || b == c || c == a {
                continue;
            }
            push(&mut facets, corners);
            count += 1;
        }
    }
    let count = u32::try_from(count).map_err(|_| Error::Limit {
        what: format!("an STL file of {count} triangles"),
        bytes: count as u128 * 50,
        cap: u128::from(u32::MAX) * 50,
    })?;
    let mut file = b"pforms".to_vec();
    file.resize(80, b' ');
    file.extend(count.to_le_bytes());
    file.extend(facets);
    Ok(file)
}

fn push(facets: &mut Vec<u8>, corners: [[f32; 3]; 3]) {
    let [a, b, c]: [Vec3; 3] = corners.map(|corner| corner.map(f64::from));
    let normal = unit(cross(subtract(b, a), subtract(c, a))).unwrap_or_default();
    for x in normal.map(|x| x as f32).iter().chain(corners.as_flattened()) {
        facets.extend(x.to_le_bytes());
    }
    facets.extend(0u16.to_le_bytes());
}
