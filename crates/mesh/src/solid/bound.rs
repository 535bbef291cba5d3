//! How much the volume can differ when every point of a surface is near its mesh.

use std::f64::consts::PI;

use crate::vector::{Vec3, cross, norm, subtract};

/// Roundings of a volume, in units of size times area.
const ROUNDINGS: f64 = 1e-14;

/// The volume of all points within `distance` of the triangles, at most: slabs over the triangles,
/// cylinders round the edges, balls round the vertices.
///
/// A surface that is moved onto its mesh along the shortest ways passes no other point, so no other
/// point changes sides.
pub(super) fn volume_error(places: &[Vec3], triangles: &[[u32; 3]], distance: f64) -> f64 {
    let (mut area, mut length) = (0.0, 0.0);
    for corners in triangles {
        let [a, b, c] = corners.map(|vertex| places[vertex as usize]);
        area += norm(cross(subtract(b, a), subtract(c, a))) / 2.0;
        length += norm(subtract(b, a)) + norm(subtract(c, b)) + norm(subtract(a, c));
    }
    let balls = 4.0 / 3.0 * distance * places.len() as f64;
    let near = distance * (2.0 * area + PI * distance * (length / 2.0 + balls));
    near + ROUNDINGS * size(places) * area
}

/// The diagonal of the box round all points.
pub(super) fn size(places: &[Vec3]) -> f64 {
    let (low, high) = corners(places);
    if places.is_empty() { 0.0 } else { norm(subtract(high, low)) }
}

/// The lowest and the highest corner of that box.
pub(super) fn corners(places: &[Vec3]) -> (Vec3, Vec3) {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for place in places {
        for k in 0..3 {
            (low[k], high[k]) = (low[k].min(place[k]), high[k].max(place[k]));
        }
    }
    (low, high)
}
