//! Round tubes about polylines.

use pforms_kernel::{Error, Result};

use crate::vector::{Vec3, add, cross, dot, norm, perpendicular, scale, subtract, unit};
use crate::{Polyline, Triangles, require_room};

/// A round tube about a polyline, closed at both ends by flat discs, or in itself.
///
/// The rings are carried along without turning about the line, by double reflection (Wang,
/// Jüttler, Zheng and Liu, *Computation of rotation minimizing frames*, 2008). In a closed line
/// what is missing to a full turn is spread over its length.
///
/// Errors: `Domain` unless the radius is positive and there are 3 to 4096 sides; `Limit`.
pub fn tube(line: &Polyline, radius: f64, sides: usize) -> Result<Triangles> {
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(Error::domain("radius", radius, "a positive length"));
    }
    if !(3..=4096).contains(&sides) {
        return Err(Error::domain("sides", sides, "3 to 4096"));
    }
    require_room("the tube", &[line.points.len(), sides])?;
    let line = distinct(line);
    let mut mesh = Triangles::default();
    if line.points.len() < 2 {
        return Ok(mesh);
    }
    let closed = line.is_closed();
    let mut across = transported(&line);
    if closed {
        untwist(&line, &mut across);
    }
    let rings = if closed { line.points.len() - 1 } else { line.points.len() };
    for (ring, across) in across.iter().enumerate().take(rings) {
        push_ring(&mut mesh, line.points[ring], line.tangents[ring], *across, radius, sides);
    }
    let (sides, rings) = (sides as u32, rings as u32);
    for ring in 0..if closed { rings } else { rings - 1 } {
        let (near, far) = (ring * sides, (ring + 1) % rings * sides);
        for side in 0..sides {
            let next = (side + 1) % sides;
            mesh.push_quad([near + side, near + next, far + next, far + side]);
        }
    }
    if !closed {
        let last = line.points.len() - 1;
        push_disc(&mut mesh, 0, sides, line.points[0], scale(-1.0, line.tangents[0]));
        push_disc(&mut mesh, (rings - 1) * sides, sides, line.points[last], line.tangents[last]);
    }
    Ok(mesh)
}

/// The line without points that repeat the one before.
fn distinct(line: &Polyline) -> Polyline {
    let mut kept = Polyline::default();
    for (k, point) in line.points.iter().enumerate() {
        if kept.points.last() != Some(point) {
            kept.points.push(*point);
            kept.tangents.push(line.tangents[k]);
            kept.parameters.push(line.parameters[k]);
        }
    }
    kept
}

/// A direction across the line at every point, carried along by double reflection.
fn transported(line: &Polyline) -> Vec<Vec3> {
    let mut across = vec![perpendicular(line.tangents[0])];
    for k in 1..line.points.len() {
        let step = subtract(line.points[k], line.points[k - 1]);
        let carried = reflected(across[k - 1], step);
        let tangent = reflected(line.tangents[k - 1], step);
        let carried = reflected(carried, subtract(line.tangents[k], tangent));
        across.push(orthogonal(carried, line.tangents[k]));
    }
    across
}

/// `vector` mirrored in the plane at right angles to `normal`.
fn reflected(vector: Vec3, normal: Vec3) -> Vec3 {
    match unit(normal) {
        Some(normal) if norm(normal) > 0.0 => {
            subtract(vector, scale(2.0 * dot(vector, normal), normal))
        }
        _ => vector,
    }
}

/// `vector` made orthogonal to `tangent` again, against rounding.
fn orthogonal(vector: Vec3, tangent: Vec3) -> Vec3 {
    let rest = subtract(vector, scale(dot(vector, tangent), tangent));
    unit(rest).unwrap_or_else(|| perpendicular(tangent))
}

/// Turns the rings of a closed line so that the last falls on the first.
fn untwist(line: &Polyline, across: &mut [Vec3]) {
    let last = across.len() - 1;
    let sine = dot(cross(across[last], across[0]), line.tangents[0]);
    let missing = libm::atan2(sine, dot(across[last], across[0]));
    for (k, direction) in across.iter_mut().enumerate() {
        let angle = missing * k as f64 / last as f64;
        let side = cross(line.tangents[k], *direction);
        *direction = add(scale(libm::cos(angle), *direction), scale(libm::sin(angle), side));
    }
}

fn push_ring(
    mesh: &mut Triangles,
    centre: Vec3,
    tangent: Vec3,
    across: Vec3,
    radius: f64,
    sides: usize,
) {
    let side = cross(tangent, across);
    for k in 0..sides {
        let angle = std::f64::consts::TAU * k as f64 / sides as f64;
        let normal = add(scale(libm::cos(angle), across), scale(libm::sin(angle), side));
        mesh.positions.push(add(centre, scale(radius, normal)));
        mesh.normals.push(normal);
    }
}

/// Closes the ring that begins at vertex `ring` with a disc that faces `normal`.
fn push_disc(mesh: &mut Triangles, ring: u32, sides: u32, centre: Vec3, normal: Vec3) {
    let first = mesh.positions.len() as u32;
    mesh.positions.push(centre);
    for side in 0..sides {
        mesh.positions.push(mesh.positions[(ring + side) as usize]);
    }
    mesh.normals.extend(std::iter::repeat_n(normal, sides as usize + 1));
    for side in 0..sides {
        let corners = [first, first + 1 + side, first + 1 + (side + 1) % sides];
        // The end disc faces along the line, the first one backwards.
        let [a, b, c] = corners;
        mesh.push(if ring == 0 { [a, c, b] } else { [a, b, c] });
    }
}
