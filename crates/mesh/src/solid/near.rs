//! Which triangles of a mesh are near another one, and which points inside it.

use crate::vector::{Vec3, cross, dot, norm, subtract};

/// Triangles in a box that is not divided any more.
const LEAF: usize = 8;

/// The triangles of a closed mesh in boxes of boxes.
pub(super) struct Tree<'a> {
    places: &'a [Vec3],
    triangles: &'a [[u32; 3]],
    order: Vec<u32>,
    nodes: Vec<Node>,
}

struct Node {
    low: Vec3,
    high: Vec3,
    first: usize,
    count: usize,
    /// The second of two boxes inside, the first of which is next; 0 if there are none.
    second: usize,
}

impl<'a> Tree<'a> {
    pub(super) fn new(places: &'a [Vec3], triangles: &'a [[u32; 3]]) -> Self {
        let order = (0..triangles.len() as u32).collect();
        let mut tree = Self { places, triangles, order, nodes: Vec::new() };
        tree.grow(0, triangles.len());
        tree
    }

    fn corners(&self, triangle: u32) -> [Vec3; 3] {
        self.triangles[triangle as usize].map(|vertex| self.places[vertex as usize])
    }

    /// Puts some triangles in a box, and halves of them in boxes inside it.
    fn grow(&mut self, first: usize, count: usize) {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for triangle in &self.order[first..first + count] {
            for corner in self.corners(*triangle) {
                for k in 0..3 {
                    (low[k], high[k]) = (low[k].min(corner[k]), high[k].max(corner[k]));
                }
            }
        }
        let number = self.nodes.len();
        self.nodes.push(Node { low, high, first, count, second: 0 });
        if count <= LEAF {
            return;
        }
        let width = |k: &usize| high[*k] / 2.0 - low[*k] / 2.0;
        let axis = (0..3).max_by(|a, b| width(a).total_cmp(&width(b))).unwrap_or(0);
        let (places, triangles) = (self.places, self.triangles);
        let middle = |triangle: &u32| {
            let corners = triangles[*triangle as usize];
            corners.map(|vertex| places[vertex as usize][axis] / 3.0).iter().sum::<f64>()
        };
        let half = count / 2;
        self.order[first..first + count]
            .select_nth_unstable_by(half, |a, b| middle(a).total_cmp(&middle(b)));
        self.grow(first, half);
        self.nodes[number].second = self.nodes.len();
        self.grow(first + half, count - half);
    }

    /// May any triangle be within `margin` of this one?
    pub(super) fn is_near(&self, corners: [Vec3; 3], margin: f64) -> bool {
        let low =
            [0, 1, 2].map(|k| corners.iter().fold(f64::INFINITY, |m, c| m.min(c[k])) - margin);
        let high =
            [0, 1, 2].map(|k| corners.iter().fold(f64::NEG_INFINITY, |m, c| m.max(c[k])) + margin);
        let mut waiting = vec![0];
        while let Some(number) = waiting.pop() {
            let node = &self.nodes[number];
            if (0..3).any(|k| node.low[k] > high[k] || node.high[k] < low[k]) {
                continue;
            }
            if node.second > 0 {
                waiting.extend([number + 1, node.second]);
                continue;
            }
            let own = &self.order[node.first..node.first + node.count];
            if own.iter().any(|triangle| {
                let other = self.corners(*triangle);
                !is_beyond(corners, other, margin) && !is_beyond(other, corners, margin)
            }) {
                return true;
            }
        }
        false
    }

    /// How often the mesh is wound round a point that is not on it: the solid angles under which its
    /// triangles are seen (van Oosterom and Strackee, 1983).
    pub(super) fn winding(&self, point: Vec3) -> f64 {
        let angle = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|vertex| subtract(self.places[vertex as usize], point));
            let [p, q, r] = [norm(a), norm(b), norm(c)];
            let [a, b, c] = [a.map(|x| x / p), b.map(|x| x / q), c.map(|x| x / r)];
            2.0 * libm::atan2(dot(a, cross(b, c)), 1.0 + dot(a, b) + dot(b, c) + dot(c, a))
        };
        self.triangles.iter().map(angle).sum::<f64>() / (4.0 * std::f64::consts::PI)
    }
}

/// Does the plane of a triangle keep another one farther away than `margin`?
fn is_beyond([a, b, c]: [Vec3; 3], other: [Vec3; 3], margin: f64) -> bool {
    let unit = norm(subtract(b, a)).max(norm(subtract(c, a)));
    let [p, q] = [b, c].map(|corner| subtract(corner, a).map(|x| x / unit));
    let normal = cross(p, q);
    let size = norm(normal);
    let heights = other.map(|corner| dot(subtract(corner, a), normal));
    heights.iter().all(|height| *height > margin * size)
        || heights.iter().all(|height| *height < -margin * size)
}
