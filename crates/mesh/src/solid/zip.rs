//! Borders that run along each other are joined: vertices that nearly meet become one, and one that
//! nearly lies on an edge becomes a corner of its triangle.

use std::collections::HashMap;

use super::skin::Skin;
use crate::edges::borders;
use crate::vector::{Vec3, add, dot, norm, scale, subtract};
use crate::weld::Near;

/// Vertices closer than this share of the gap were the same before they were rounded.
const SAME: f64 = 1.0 / 16.0;

/// Rounds before borders are left open: each triangle is cut along one side in a round.
const ROUNDS: usize = 24;

/// An edge of a border, and the triangle it belongs to.
type Side = ([u32; 2], usize);

/// Joins borders where they are not farther apart than `gap`.
pub(super) fn zip(skin: &mut Skin, gap: f64) {
    for round in 0..ROUNDS {
        let edges = borders(&skin.triangles);
        if edges.is_empty() {
            break;
        }
        let changed = match round {
            0 => merge(skin, &edges, SAME * gap),
            _ => cut(skin, &edges, gap) || merge(skin, &edges, gap),
        };
        if !changed && round > 0 {
            break;
        }
    }
}

/// The vertices of some edges, each once, and the mean length of these.
fn ends(places: &[Vec3], edges: &[Side]) -> (Vec<u32>, f64) {
    let mut vertices: Vec<u32> = edges.iter().flat_map(|(edge, _)| *edge).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let length = |([a, b], _): &Side| norm(subtract(places[*b as usize], places[*a as usize]));
    (vertices, edges.iter().map(length).sum::<f64>() / edges.len() as f64)
}

/// Makes vertices of borders one that are near each other; were there any?
fn merge(skin: &mut Skin, edges: &[Side], reach: f64) -> bool {
    let joint: std::collections::HashSet<[u32; 2]> =
        edges.iter().flat_map(|([a, b], _)| [[*a, *b], [*b, *a]]).collect();
    let (vertices, _) = ends(&skin.places, edges);
    let near = Near::new(&skin.places, vertices.clone(), reach);
    let mut same: Vec<u32> = (0..skin.places.len() as u32).collect();
    let mut changed = false;
    for vertex in vertices {
        if same[vertex as usize] != vertex {
            continue;
        }
        let barred = |other: u32| other < vertex || joint.contains(&[vertex, other]);
        if let Some((other, _)) = near.nearest(vertex, reach, barred)
            && same[other as usize] == other
        {
            same[other as usize] = vertex;
            changed = true;
        }
    }
    if changed {
        skin.join(&same);
    }
    changed
}

/// Where a border is to be cut: how far along it, how far away the vertex is, and which it is.
type Cut = (f64, f64, u32);

/// Cuts triangles along a border at the vertices of other borders that lie on it within the gap;
/// were there any?
fn cut(skin: &mut Skin, edges: &[Side], gap: f64) -> bool {
    let (vertices, length) = ends(&skin.places, edges);
    let near = Near::new(&skin.places, vertices, length.max(gap));
    // For each vertex the edge it is nearest to, with the distance and the place along it.
    let mut best: HashMap<u32, (f64, usize, f64)> = HashMap::new();
    for (number, ([a, b], _)) in edges.iter().enumerate() {
        let [from, to] = [*a, *b].map(|vertex| skin.places[vertex as usize]);
        let low = [0, 1, 2].map(|k| from[k].min(to[k]) - gap);
        let high = [0, 1, 2].map(|k| from[k].max(to[k]) + gap);
        for vertex in near.within(low, high) {
            if vertex == *a || vertex == *b {
                continue;
            }
            if let Some((distance, along)) = foot(skin.places[vertex as usize], from, to)
                && distance <= gap
                && best.get(&vertex).is_none_or(|known| distance < known.0)
            {
                best.insert(vertex, (distance, number, along));
            }
        }
    }
    let mut cuts: HashMap<usize, Vec<Cut>> = HashMap::new();
    for (vertex, (distance, number, along)) in best {
        cuts.entry(number).or_default().push((along, distance, vertex));
    }
    let mut cuts: Vec<(usize, Vec<Cut>)> = cuts.into_iter().collect();
    cuts.sort_by_key(|(number, _)| *number);
    let mut touched = std::collections::HashSet::new();
    let mut farthest = 0.0_f64;
    for (number, mut corners) in cuts {
        let (edge, triangle) = edges[number];
        if !touched.insert(triangle) {
            continue;
        }
        corners.sort_by(|x, y| x.0.total_cmp(&y.0).then(x.2.cmp(&y.2)));
        let moved = corners.iter().fold(0.0, |most, (_, distance, _)| distance.max(most));
        farthest = farthest.max(moved);
        skin.strays[triangle] = skin.strays[triangle].moved(moved);
        divide(skin, edge, triangle, &corners);
    }
    skin.moved += farthest;
    !touched.is_empty()
}

/// Makes a fan of a triangle, from the corner opposite its edge to the vertices along this.
fn divide(skin: &mut Skin, [a, b]: [u32; 2], triangle: usize, corners: &[Cut]) {
    let opposite = skin.triangles[triangle].into_iter().find(|vertex| *vertex != a && *vertex != b);
    let Some(apex) = opposite else { return };
    let mut from = a;
    let line = corners.iter().map(|(_, _, vertex)| *vertex).chain([b]);
    for (step, to) in line.filter(|vertex| *vertex != apex).enumerate() {
        if step == 0 {
            skin.triangles[triangle] = [from, to, apex];
        } else {
            skin.triangles.push([from, to, apex]);
            skin.strays.push(skin.strays[triangle]);
        }
        from = to;
    }
}

/// How far a point is from a segment and where along it, if its foot is not an end.
fn foot(point: Vec3, from: Vec3, to: Vec3) -> Option<(f64, f64)> {
    let side = subtract(to, from);
    let along = dot(subtract(point, from), side) / dot(side, side);
    if !(along > 0.0 && along < 1.0) {
        return None;
    }
    Some((norm(subtract(point, add(from, scale(along, side)))), along))
}
