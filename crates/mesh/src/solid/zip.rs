//! Borders that run along each other are joined: vertices that nearly meet become one, and one that
//! nearly lies on an edge becomes a corner of its triangle.

use std::collections::HashMap;

use crate::edges::borders;
use crate::vector::{Vec3, add, dot, norm, scale, subtract};
use crate::weld::{Near, joined};

/// Vertices closer than this share of the gap were the same before they were rounded.
const SAME: f64 = 1.0 / 16.0;

/// Rounds before borders are left open: each triangle is cut along one side in a round.
const ROUNDS: usize = 24;

/// The mesh with its borders joined where they are not farther apart than `gap`, and how far a
/// vertex or an edge was moved.
pub(super) fn zipped(
    mut places: Vec<Vec3>,
    mut triangles: Vec<[u32; 3]>,
    gap: f64,
) -> (Vec<Vec3>, Vec<[u32; 3]>, f64) {
    let mut moved = 0.0_f64;
    for round in 0..ROUNDS {
        let edges = borders(&triangles);
        if edges.is_empty() {
            break;
        }
        let reach = if round == 0 { SAME * gap } else { gap };
        let cut = if round == 0 { None } else { cut(&places, &mut triangles, &edges, gap) };
        let step = match cut {
            Some(distance) => Some(distance),
            None => merge(&mut places, &mut triangles, &edges, reach),
        };
        match step {
            Some(distance) => moved = moved.max(distance),
            None if round > 0 => break,
            None => {}
        }
    }
    (places, triangles, moved)
}

/// The vertices of some edges, each once, and the mean length of these.
fn ends(places: &[Vec3], edges: &[([u32; 2], usize)]) -> (Vec<u32>, f64) {
    let mut vertices: Vec<u32> = edges.iter().flat_map(|(edge, _)| *edge).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let length =
        |([a, b], _): &([u32; 2], usize)| norm(subtract(places[*b as usize], places[*a as usize]));
    (vertices, edges.iter().map(length).sum::<f64>() / edges.len() as f64)
}

/// Makes vertices of borders one that are near each other; `None` when there are none.
fn merge(
    places: &mut Vec<Vec3>,
    triangles: &mut Vec<[u32; 3]>,
    edges: &[([u32; 2], usize)],
    reach: f64,
) -> Option<f64> {
    let joint: std::collections::HashSet<[u32; 2]> =
        edges.iter().flat_map(|([a, b], _)| [[*a, *b], [*b, *a]]).collect();
    let (vertices, _) = ends(places, edges);
    let near = Near::new(places, vertices.clone(), reach);
    let mut same: Vec<u32> = (0..places.len() as u32).collect();
    let mut moved = None;
    for vertex in vertices {
        if same[vertex as usize] != vertex {
            continue;
        }
        let barred = |other: u32| other < vertex || joint.contains(&[vertex, other]);
        if let Some((other, distance)) = near.nearest(vertex, reach, barred)
            && same[other as usize] == other
        {
            same[other as usize] = vertex;
            moved = Some(distance.max(moved.unwrap_or(0.0)));
        }
    }
    if moved.is_some() {
        (*places, *triangles) = joined(places, triangles, &same);
    }
    moved
}

/// Cuts triangles along a border at the vertices of other borders that lie on it within the gap;
/// `None` when there are none.
fn cut(
    places: &[Vec3],
    triangles: &mut Vec<[u32; 3]>,
    edges: &[([u32; 2], usize)],
    gap: f64,
) -> Option<f64> {
    let (vertices, length) = ends(places, edges);
    let near = Near::new(places, vertices, length.max(gap));
    // For each vertex the edge it is nearest to, with the distance and the place along it.
    let mut best: HashMap<u32, (f64, usize, f64)> = HashMap::new();
    for (number, ([a, b], _)) in edges.iter().enumerate() {
        let [from, to] = [*a, *b].map(|vertex| places[vertex as usize]);
        let low = [0, 1, 2].map(|k| from[k].min(to[k]) - gap);
        let high = [0, 1, 2].map(|k| from[k].max(to[k]) + gap);
        for vertex in near.within(low, high) {
            if vertex == *a || vertex == *b {
                continue;
            }
            if let Some((distance, along)) = foot(places[vertex as usize], from, to)
                && distance <= gap
                && best.get(&vertex).is_none_or(|known| distance < known.0)
            {
                best.insert(vertex, (distance, number, along));
            }
        }
    }
    let mut cuts: HashMap<usize, Vec<(f64, u32)>> = HashMap::new();
    let mut moved = None;
    for (vertex, (distance, number, along)) in best {
        cuts.entry(number).or_default().push((along, vertex));
        moved = Some(distance.max(moved.unwrap_or(0.0)));
    }
    let mut cuts: Vec<(usize, Vec<(f64, u32)>)> = cuts.into_iter().collect();
    cuts.sort_by_key(|(number, _)| *number);
    let mut touched = std::collections::HashSet::new();
    for (number, mut corners) in cuts {
        let ([a, b], triangle) = edges[number];
        if !touched.insert(triangle) {
            continue;
        }
        corners.sort_by(|x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
        let apex = triangles[triangle].into_iter().find(|vertex| *vertex != a && *vertex != b)?;
        let mut from = a;
        let line = corners.into_iter().map(|(_, vertex)| vertex).chain([b]);
        for (step, to) in line.filter(|vertex| *vertex != apex).enumerate() {
            if step == 0 {
                triangles[triangle] = [from, to, apex];
            } else {
                triangles.push([from, to, apex]);
            }
            from = to;
        }
    }
    moved
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
