//! Shapes and measures that several tests use.
#![allow(dead_code, missing_docs, unreachable_pub, clippy::unwrap_used)]

use std::collections::HashMap;

use pforms_mesh::Triangles;
use pforms_mesh::vector::{Vec3, add, cross, dot, norm, scale, subtract};

/// How often each undirected edge occurs, by the bits of its ends.
pub fn edge_counts(meshes: &[Triangles]) -> HashMap<[[u64; 3]; 2], usize> {
    let mut counts = HashMap::new();
    for mesh in meshes {
        for k in 0..mesh.indices.len() {
            let corners = mesh.corners(k).map(|p| p.map(|x| (x + 0.0).to_bits()));
            for i in 0..3 {
                let mut edge = [corners[i], corners[(i + 1) % 3]];
                edge.sort_unstable();
                *counts.entry(edge).or_default() += 1;
            }
        }
    }
    counts
}

/// Is every edge shared by exactly two triangles?
pub fn is_watertight(meshes: &[Triangles]) -> bool {
    edge_counts(meshes).values().all(|&count| count == 2)
}

/// Distance of a point from a segment.
pub fn to_segment(p: Vec3, a: Vec3, b: Vec3) -> f64 {
    let along = subtract(b, a);
    let length = dot(along, along);
    let t = if length > 0.0 { (dot(subtract(p, a), along) / length).clamp(0.0, 1.0) } else { 0.0 };
    norm(subtract(p, add(a, scale(t, along))))
}

/// Distance of a point from a triangle.
pub fn to_triangle(p: Vec3, [a, b, c]: [Vec3; 3]) -> f64 {
    let normal = cross(subtract(b, a), subtract(c, a));
    let inside = |from, to| dot(cross(subtract(to, from), subtract(p, from)), normal) >= 0.0;
    if norm(normal) > 0.0 && inside(a, b) && inside(b, c) && inside(c, a) {
        return dot(subtract(p, a), normal).abs() / norm(normal);
    }
    to_segment(p, a, b).min(to_segment(p, b, c)).min(to_segment(p, c, a))
}

/// Distance of a point from a mesh.
pub fn to_mesh(p: Vec3, mesh: &Triangles) -> f64 {
    (0..mesh.indices.len()).map(|k| to_triangle(p, mesh.corners(k))).fold(f64::INFINITY, f64::min)
}
