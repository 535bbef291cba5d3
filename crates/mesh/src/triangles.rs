//! A triangle mesh.

use crate::vector::{Vec3, cross, scale, subtract, unit};

/// Triangles that share vertices, each with a unit normal.
///
/// Seen from the side the normals point to, the corners of a triangle run counter-clockwise (in a
/// right-handed picture).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangles {
    /// The vertices.
    pub positions: Vec<Vec3>,
    /// The unit normal at each vertex.
    pub normals: Vec<Vec3>,
    /// Three vertices for each triangle.
    pub indices: Vec<[u32; 3]>,
}

impl Triangles {
    /// The corners of triangle `index`.
    pub fn corners(&self, index: usize) -> [Vec3; 3] {
        self.indices[index].map(|vertex| self.positions[vertex as usize])
    }

    /// Twice the area of a triangle, along its normal.
    pub fn facet(&self, index: usize) -> Vec3 {
        let [a, b, c] = self.corners(index);
        cross(subtract(b, a), subtract(c, a))
    }

    /// The same triangles, each with vertices of its own and the normal of its plane.
    #[must_use]
    pub fn flat(&self) -> Self {
        let mut flat = Self::default();
        for index in 0..self.indices.len() {
            let Some(normal) = unit(self.facet(index)) else { continue };
            let first = flat.positions.len() as u32;
            flat.positions.extend(self.corners(index));
            flat.normals.extend([normal; 3]);
            flat.indices.push([first, first + 1, first + 2]);
        }
        flat
    }

    /// Adds the triangles of another mesh; no vertices are shared between the two.
    pub fn append(&mut self, other: &Self) {
        let shift = self.positions.len() as u32;
        self.positions.extend_from_slice(&other.positions);
        self.normals.extend_from_slice(&other.normals);
        self.indices.extend(other.indices.iter().map(|corners| corners.map(|i| i + shift)));
    }

    /// Adds a triangle, unless two of its corners are the same point.
    pub(crate) fn push(&mut self, corners: [u32; 3]) {
        let [a, b, c] = corners.map(|vertex| self.positions[vertex as usize]);
        if a != b && b != c && c != a {
            self.indices.push(corners);
        }
    }

    /// Adds the two triangles of a quadrangle, cut along its shorter diagonal.
    pub(crate) fn push_quad(&mut self, [a, b, c, d]: [u32; 4]) {
        let [p, q, r, s] = [a, b, c, d].map(|vertex| self.positions[vertex as usize]);
        let length = |from: Vec3, to: Vec3| {
            let [x, y, z] = subtract(to, from);
            x * x + y * y + z * z
        };
        if length(p, r) <= length(q, s) {
            self.push([a, b, c]);
            self.push([a, c, d]);
        } else {
            self.push([a, b, d]);
            self.push([b, c, d]);
        }
    }

    /// The area of all triangles.
    pub fn area(&self) -> f64 {
        (0..self.indices.len()).map(|k| crate::vector::norm(self.facet(k)) / 2.0).sum()
    }

    /// The volume inside a closed mesh whose normals point outwards.
    pub fn volume(&self) -> f64 {
        let cone = |k: usize| {
            let [a, b, c] = self.corners(k);
            crate::vector::dot(a, cross(b, c)) / 6.0
        };
        (0..self.indices.len()).map(cone).sum()
    }

    /// The other side: corners the other way round, normals reversed.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self {
            positions: self.positions.clone(),
            normals: self.normals.iter().map(|normal| scale(-1.0, *normal)).collect(),
            indices: self.indices.iter().map(|&[a, b, c]| [a, c, b]).collect(),
        }
    }
}
