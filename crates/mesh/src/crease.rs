//! Normals of a mesh that knows none: smooth over flat angles, sharp over others.

use std::collections::HashMap;

use crate::Triangles;
use crate::vector::{Vec3, add, cross, dot, norm, scale, subtract, unit};

/// The cosine of 30°: facets that meet at less share their light.
const CREASE: f64 = 0.866_025_403_784_438_6;

/// Triangles with the mean normal of the facets round each corner that lie nearly as theirs does.
pub(crate) fn shaded(places: &[Vec3], triangles: &[[u32; 3]]) -> Triangles {
    let facets: Vec<Option<Vec3>> = triangles.iter().map(|t| facet(places, *t)).collect();
    let (starts, around) = fans(places.len(), triangles);
    let mut mesh = Triangles::default();
    let mut known: HashMap<(u32, [u64; 3]), u32> = HashMap::new();
    for (corners, own) in triangles.iter().zip(&facets) {
        let Some(own) = *own else { continue };
        let corners = corners.map(|vertex| {
            let fan = &around[starts[vertex as usize]..starts[vertex as usize + 1]];
            let near = |number: &&u32| {
                facets[**number as usize].is_some_and(|other| dot(own, other) > CREASE)
            };
            let sum = fan.iter().filter(near).fold([0.0; 3], |sum, number| {
                add(sum, weighted(places, triangles[*number as usize], vertex))
            });
            let normal = unit(sum).unwrap_or(own);
            *known.entry((vertex, normal.map(f64::to_bits))).or_insert_with(|| {
                mesh.positions.push(places[vertex as usize]);
                mesh.normals.push(normal);
                mesh.positions.len() as u32 - 1
            })
        });
        mesh.indices.push(corners);
    }
    mesh
}

/// The triangles round each vertex, in one list, and where each vertex begins in it.
fn fans(count: usize, triangles: &[[u32; 3]]) -> (Vec<usize>, Vec<u32>) {
    let mut starts = vec![0; count + 1];
    for vertex in triangles.as_flattened() {
        starts[*vertex as usize + 1] += 1;
    }
    for k in 0..count {
        starts[k + 1] += starts[k];
    }
    let mut place = starts.clone();
    let mut around = vec![0; 3 * triangles.len()];
    for (number, corners) in triangles.iter().enumerate() {
        for vertex in corners {
            around[place[*vertex as usize]] = number as u32;
            place[*vertex as usize] += 1;
        }
    }
    (starts, around)
}

fn facet(places: &[Vec3], corners: [u32; 3]) -> Option<Vec3> {
    let [a, b, c] = corners.map(|vertex| places[vertex as usize]);
    unit(cross(subtract(b, a), subtract(c, a)))
}

/// The normal of a triangle times its angle at a vertex: how it is cut up does not matter.
fn weighted(places: &[Vec3], corners: [u32; 3], vertex: u32) -> Vec3 {
    let at = corners.iter().position(|corner| *corner == vertex).unwrap_or(0);
    let [here, next, last] = [0, 1, 2].map(|k| places[corners[(at + k) % 3] as usize]);
    let (p, q) = (subtract(next, here), subtract(last, here));
    let normal = cross(p, q);
    let angle = libm::atan2(norm(normal), dot(p, q));
    unit(normal).map_or([0.0; 3], |normal| scale(angle, normal))
}
