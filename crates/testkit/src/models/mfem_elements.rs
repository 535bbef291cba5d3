//! How MFEM numbers the poles that patches share.
//!
//! A patch is a box with corners, edges, faces and an inside: its *cells*. The poles of a cell are
//! counted once for all patches, in a frame that the cell itself fixes: an edge runs from its lower
//! to its higher vertex, a face as the first patch that has it names its corners, the first axis
//! fastest; a mesh of curves counts the poles inside a curve from its end. Where a cell lies in a patch, and which way round, follows from where its frame's
//! vertices are among the corners of the patch.

use std::collections::HashMap;

use super::mfem_mesh::Mesh;

/// Along which axes each corner of a segment, square or cube lies at the end, in MFEM's order.
const CORNERS: [[usize; 3]; 8] =
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];

/// The faces of a cube in MFEM's order: origin, and the neighbours along the two axes of its frame.
const FACES: [[usize; 4]; 6] =
    [[3, 2, 1, 0], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]];

/// Poles inside a cell: the vertex its frame starts from, the vertices its axes lead to, and the
/// numbers of its poles, the first axis fastest.
struct Cell {
    origin: usize,
    towards: Vec<usize>,
    poles: Vec<usize>,
}

/// The poles of a mesh, by cell; a cell is known by its vertices in ascending order.
pub(super) struct Numbering<'a> {
    mesh: &'a Mesh,
    cells: HashMap<Vec<usize>, Cell>,
    count: usize,
}

impl<'a> Numbering<'a> {
    pub(super) fn new(mesh: &'a Mesh) -> Self {
        let mut all = Self { mesh, cells: HashMap::new(), count: mesh.vertices };
        for vertex in 0..mesh.vertices {
            let cell = Cell { origin: vertex, towards: Vec::new(), poles: vec![vertex] };
            all.cells.insert(vec![vertex], cell);
        }
        if mesh.dimension > 1 {
            for (_, [from, to]) in &mesh.edges {
                all.add(&[*from.min(to), *from.max(to)]);
            }
        }
        if mesh.dimension > 2 {
            for corners in &mesh.elements {
                for face in FACES {
                    all.add(&face.map(|corner| corners[corner]));
                }
            }
        }
        for corners in &mesh.elements {
            all.add(corners);
        }
        all
    }

    /// Number of poles.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// The knot vector of each axis of a patch.
    pub(super) fn axes(&self, patch: usize) -> Vec<usize> {
        let corners = &self.mesh.elements[patch];
        let ends = [1, 3, 4].map(|corner| corners.get(corner).copied());
        (0..self.mesh.dimension)
            .map(|axis| self.edge(corners[0], ends[axis].unwrap_or(corners[1])))
            .collect()
    }

    fn edge(&self, a: usize, b: usize) -> usize {
        let here = |(_, ends): &&(usize, [usize; 2])| *ends == [a, b] || *ends == [b, a];
        self.mesh.edges.iter().find(here).expect("an edge of the patch").0
    }

    /// Poles inside the edge between two vertices.
    fn inside(&self, a: usize, b: usize) -> usize {
        let (degree, knots) = &self.mesh.knots[self.edge(a, b)];
        knots.len() - degree - 3
    }

    /// Numbers the poles of a cell from its corners in MFEM's order, unless it has them already.
    fn add(&mut self, corners: &[usize]) {
        let mut key = corners.to_vec();
        key.sort_unstable();
        if self.cells.contains_key(&key) {
            return;
        }
        let towards: Vec<usize> = match corners.len() {
            2 => vec![corners[1]],
            4 => vec![corners[1], corners[3]],
            _ => vec![corners[1], corners[3], corners[4]],
        };
        let sizes: Vec<usize> = towards.iter().map(|to| self.inside(corners[0], *to)).collect();
        let size = sizes.iter().product::<usize>();
        let hanging = self.hanging(corners, &towards, &sizes);
        let poles = if hanging.is_empty() || size == 0 {
            self.count += size;
            let fresh = self.count - size..self.count;
            if self.mesh.dimension == 1 { fresh.rev().collect() } else { fresh.collect() }
        } else {
            assert_eq!(hanging.len(), size, "a vertex for every pole of {corners:?}");
            hanging
        };
        self.cells.insert(key, Cell { origin: corners[0], towards, poles });
    }

    /// The vertices of smaller neighbours that are the poles inside a cell, in order.
    fn hanging(&self, corners: &[usize], towards: &[usize], sizes: &[usize]) -> Vec<usize> {
        let mut found: Vec<(usize, usize)> = Vec::new();
        for (vertex, spans, host) in &self.mesh.hanging {
            if corners.iter().all(|corner| host.contains(corner)) {
                let place = self.place(spans, host, corners[0], towards, sizes);
                found.extend(place.map(|place| (place, *vertex)));
            }
        }
        found.sort_unstable();
        found.into_iter().map(|(_, vertex)| vertex).collect()
    }

    /// Where knot spans of a host lie inside one of its cells, if they do.
    fn place(
        &self,
        spans: &[usize],
        host: &[usize],
        origin: usize,
        towards: &[usize],
        sizes: &[usize],
    ) -> Option<usize> {
        let pieces: Vec<usize> = (0..spans.len()).map(|axis| self.pieces(host, axis)).collect();
        let frame = frame(host, origin, towards);
        let start = corner(host, origin);
        // Along the axes that the cell has not: at the end where it lies.
        let across = |axis: &usize| frame.iter().all(|(own, _)| own != axis);
        let mut others = (0..spans.len()).filter(across);
        if !others.all(|axis| spans[axis] == start[axis] * pieces[axis]) {
            return None;
        }
        let along = |&(axis, forwards): &(usize, bool)| {
            if forwards { spans[axis] } else { pieces[axis] - spans[axis] }
        };
        let index: Vec<usize> = frame.iter().map(along).collect();
        let inside = index.iter().zip(sizes).all(|(i, size)| (1..=*size).contains(i));
        inside.then(|| flat(&index, sizes))
    }

    /// Knot spans along an axis of a face or an edge.
    fn pieces(&self, host: &[usize], axis: usize) -> usize {
        let to = if axis == 0 { host[1] } else { host[3] };
        self.inside(host[0], to) + 1
    }

    /// The numbers of all poles of a patch, the last axis fastest.
    pub(super) fn poles(&self, patch: usize) -> Vec<usize> {
        let corners = &self.mesh.elements[patch];
        let orders: Vec<usize> = self
            .axes(patch)
            .iter()
            .map(|axis| self.mesh.knots[*axis].1.len() - self.mesh.knots[*axis].0 - 1)
            .collect();
        let count = orders.iter().product::<usize>();
        let index = |flat: usize| {
            let mut rest = flat;
            let mut index: Vec<usize> =
                orders.iter().rev().map(|order| (rest % order, rest /= order).0).collect();
            index.reverse();
            index
        };
        (0..count).map(|flat| self.number(corners, &orders, &index(flat))).collect()
    }

    /// The number of one pole: that of its cell, in the frame of the cell.
    fn number(&self, corners: &[usize], orders: &[usize], index: &[usize]) -> usize {
        let axes = orders.len();
        let end = |axis: usize| index[axis] + 1 == orders[axis];
        let inner = |axis: usize| index[axis] > 0 && !end(axis);
        let on_cell = |at: &[usize; 3]| {
            (0..axes).all(|axis| inner(axis) || at[axis] == usize::from(end(axis)))
        };
        let mut key: Vec<usize> = corners.to_vec();
        key.retain(|vertex| on_cell(&corner(corners, *vertex)));
        key.sort_unstable();
        let cell = &self.cells[&key];
        let frame = frame(corners, cell.origin, &cell.towards);
        let sizes: Vec<usize> = frame.iter().map(|(axis, _)| orders[*axis] - 2).collect();
        let along = |&(axis, forwards): &(usize, bool)| {
            if forwards { index[axis] } else { orders[axis] - 1 - index[axis] }
        };
        let inside: Vec<usize> = frame.iter().map(along).collect();
        cell.poles[flat(&inside, &sizes)]
    }
}

/// Which corner a vertex is.
fn corner(corners: &[usize], vertex: usize) -> [usize; 3] {
    let number = corners.iter().position(|corner| *corner == vertex);
    CORNERS[number.expect("a corner of the patch")]
}

/// The axes of a cell as those of the patch it is seen from, and whether they run forwards there.
fn frame(corners: &[usize], origin: usize, towards: &[usize]) -> Vec<(usize, bool)> {
    let start = corner(corners, origin);
    let axis = |to: &usize| {
        let end = corner(corners, *to);
        let axis = (0..3).find(|axis| end[*axis] != start[*axis]).expect("a neighbour");
        (axis, start[axis] == 0)
    };
    towards.iter().map(axis).collect()
}

/// The place of an index, counted from 1, among the poles inside a cell: the first axis fastest.
fn flat(index: &[usize], sizes: &[usize]) -> usize {
    index.iter().zip(sizes).rev().fold(0, |flat, (i, size)| flat * size + i - 1)
}
