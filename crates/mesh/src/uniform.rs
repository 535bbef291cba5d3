//! Patches on even grids, without cracks between them.

use std::collections::HashMap;

use pforms_kernel::threads::fill_parts;
use pforms_kernel::{Error, Form, Result};

use crate::edge::{Edge, Key};
use crate::pieces::require_finite;
use crate::room::require_room;
use crate::sample::{Sample, Sampled};
use crate::space::{embed, quadruples, require_axes, ticks};
use crate::vector::{Vec3, norm, subtract};
use crate::{Sampling, Triangles};

/// About how many operations a vertex and its two triangles take.
const COST: usize = 200;

/// Meshes patches on the grids of a sampling; with a tolerance, those that surely keep it.
///
/// Every patch has the rows it asks for; an edge has the most that a patch next to it asks for.
pub(crate) fn uniform(
    forms: &[Form],
    sampling: &Sampling,
    normals: bool,
) -> Result<Vec<Triangles>> {
    let mut lines = Vec::new();
    let mut known = HashMap::new();
    let patches: Vec<Patch> = forms
        .iter()
        .map(|form| Patch::new(form, sampling, &mut lines, &mut known))
        .collect::<Result<_>>()?;
    let samples: usize = patches.iter().map(Patch::vertices).sum();
    require_room("the mesh", &[samples])?;
    for line in &mut lines {
        line.points = line.edge.points(&ticks(line.segments))?;
    }
    let mut meshes = vec![Triangles::default(); patches.len()];
    let cost = COST * samples / patches.len().max(1);
    fill_parts(&mut meshes, 1, cost, |range, meshes| {
        for (patch, mesh) in patches[range].iter().zip(meshes) {
            *mesh = patch.mesh(&lines, sampling, normals)?;
        }
        Ok(())
    })?;
    Ok(meshes)
}

/// An edge that patches may share, sampled evenly in its own direction.
struct Line {
    edge: Edge,
    segments: usize,
    points: Vec<Vec3>,
}

/// A patch, and how many cells it needs.
struct Patch {
    form: Form,
    segments: [usize; 2],
    /// The lines of the edges `u = 0, u = 1, v = 0, v = 1`, and whether the patch runs against them.
    sides: [(usize, bool); 4],
}

/// Which ends of the borders meet in the corners: `(side, at its end)`, twice.
const CORNERS: [[(usize, bool); 2]; 4] = [
    [(0, false), (2, false)],
    [(0, true), (3, false)],
    [(1, false), (2, true)],
    [(1, true), (3, true)],
];

impl Patch {
    fn new(
        form: &Form,
        sampling: &Sampling,
        lines: &mut Vec<Line>,
        known: &mut HashMap<Key, usize>,
    ) -> Result<Self> {
        require_axes(form, 2, "a surface: two axes")?;
        let form = embed(form)?;
        require_finite(&form)?;
        let segments = sampling.segments(&form)?;
        let [across, down] = [segments[0], segments[1]];
        let sides = [(0, false), (0, true), (1, false), (1, true)].map(|(fixed, high)| {
            let edge = Edge::of(&form, fixed, high);
            let reversed = edge.is_reversed();
            let line = *known.entry(edge.key()).or_insert_with(|| {
                lines.push(Line { edge, segments: 0, points: Vec::new() });
                lines.len() - 1
            });
            let cells = &mut lines[line].segments;
            *cells = (*cells).max(if fixed == 0 { down } else { across });
            (line, reversed)
        });
        Ok(Self { form, segments: [across, down], sides })
    }

    fn vertices(&self) -> usize {
        (self.segments[0] + 1) * (self.segments[1] + 1)
    }

    fn mesh(&self, lines: &[Line], sampling: &Sampling, normals: bool) -> Result<Triangles> {
        let mut borders = self.sides.map(|(line, reversed)| {
            let mut points = lines[line].points.clone();
            if reversed {
                points.reverse();
            }
            points
        });
        let collapsed = self.sides.map(|(line, _)| lines[line].edge.single_point().is_some());
        join_corners(&mut borders, collapsed);
        let [across, down] = self.segments;
        let every = matches!(sampling, Sampling::Segments(_));
        if [0, 1, 2, 3].map(|side| borders[side].len() - 1) == [down, down, across, across] {
            self.plain(&borders, collapsed, normals, every)
        } else {
            self.stitched(&borders, collapsed, normals)
        }
    }

    /// One grid, its border points those of the edges; `every` triangle, or those with an area.
    fn plain(
        &self,
        borders: &[Vec<Vec3>; 4],
        collapsed: [bool; 4],
        normals: bool,
        every: bool,
    ) -> Result<Triangles> {
        let sampled = Sampled { form: &self.form, collapsed };
        let [across, down] = self.segments;
        let Sample { mut positions, normals } =
            sampled.grid(&ticks(across), &ticks(down), normals)?;
        let last = across * (down + 1);
        positions[..=down].copy_from_slice(&borders[0]);
        positions[last..].copy_from_slice(&borders[1]);
        for (i, (first, end)) in borders[2].iter().zip(&borders[3]).enumerate() {
            positions[i * (down + 1)] = *first;
            positions[i * (down + 1) + down] = *end;
        }
        let mut mesh = Triangles { positions, normals, indices: Vec::new() };
        mesh.indices = grid_cells(&mesh, across, down, self.is_cut_along_first())?;
        if !every && collapsed.contains(&true) {
            let positions = &mesh.positions;
            mesh.indices.retain(|corners| has_area(positions, corners));
        }
        Ok(mesh)
    }

    /// Are all cells cut from `(0, 0)` to `(1, 1)`: is that diagonal of the patch the shorter one?
    ///
    /// One way for all cells: the triangles of a patch that is dragged stay what they are.
    fn is_cut_along_first(&self) -> bool {
        let poles = quadruples(&self.form);
        let [rows, columns] = [self.form.orders()[0], self.form.orders()[1]];
        let [a, b, c, d] = [0, (rows - 1) * columns, rows * columns - 1, columns - 1]
            .map(|k| crate::space::project(&poles[k]));
        norm(subtract(a, c)) <= norm(subtract(b, d)) * (1.0 + 1e-9)
    }

    /// A smaller grid inside, and four strips from its border to the finer edges.
    fn stitched(
        &self,
        borders: &[Vec<Vec3>; 4],
        collapsed: [bool; 4],
        normals: bool,
    ) -> Result<Triangles> {
        let sampled = Sampled { form: &self.form, collapsed };
        let [across, down] = self.segments.map(|count| count.max(2));
        let inner = |count: usize| ticks(count)[1..count].to_vec();
        let grid = sampled.grid(&inner(across), &inner(down), normals)?;
        let mut mesh =
            Triangles { positions: grid.positions, normals: grid.normals, indices: Vec::new() };
        mesh.indices = grid_cells(&mesh, across - 2, down - 2, self.is_cut_along_first())?;
        for (side, border) in borders.iter().enumerate() {
            let free = ticks(border.len() - 1);
            let fixed = [if side % 2 == 0 { 0.0 } else { 1.0 }];
            let line = if side < 2 {
                sampled.grid(&fixed, &free, normals)?
            } else {
                sampled.grid(&free, &fixed, normals)?
            };
            let first = mesh.positions.len() as u32;
            mesh.positions.extend(border);
            mesh.normals.extend(line.normals);
            let outer: Vec<u32> = (first..first + border.len() as u32).collect();
            let (rows, columns) = (across as u32 - 1, down as u32 - 1);
            let inside: Vec<u32> = match side {
                0 => (0..columns).collect(),
                1 => (0..columns).map(|j| (rows - 1) * columns + j).collect(),
                2 => (0..rows).map(|i| i * columns).collect(),
                _ => (0..rows).map(|i| i * columns + columns - 1).collect(),
            };
            push_strip(&mut mesh, &outer, &inside, side == 0 || side == 3);
        }
        Ok(mesh)
    }
}

/// Gives the borders next to a collapsed edge exactly its point.
fn join_corners(borders: &mut [Vec<Vec3>; 4], collapsed: [bool; 4]) {
    let mut copy = |(from, end): (usize, bool), (to, at): (usize, bool)| {
        let index = if end { borders[from].len() - 1 } else { 0 };
        let point = borders[from][index];
        let index = if at { borders[to].len() - 1 } else { 0 };
        borders[to][index] = point;
    };
    for [first, second] in CORNERS {
        if collapsed[second.0] {
            copy(second, first);
        } else {
            copy(first, second);
        }
    }
}

/// Are the three corners three points?
fn has_area(positions: &[Vec3], corners: &[u32; 3]) -> bool {
    let [a, b, c] = corners.map(|vertex| positions[vertex as usize]);
    a != b && b != c && c != a
}

/// The triangles of a grid whose vertices are the first of a mesh.
fn grid_cells(mesh: &Triangles, across: usize, down: usize, first: bool) -> Result<Vec<[u32; 3]>> {
    if mesh.positions.len() > u32::MAX as usize {
        return Err(Error::shape("mesh", mesh.positions.len(), "fewer than 2³² vertices"));
    }
    let mut indices = vec![[0; 3]; 2 * across * down];
    let row = down as u32 + 1;
    for (i, line) in indices.chunks_exact_mut((2 * down).max(1)).enumerate() {
        let start = i as u32 * row;
        for (a, pair) in (start..).zip(line.as_chunks_mut::<2>().0) {
            let [b, c, d] = [a + row, a + row + 1, a + 1];
            *pair = if first { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
        }
    }
    Ok(indices)
}

/// Triangles between a border of `outer` points at equal parameters and the inner line one cell
/// away, whose points are at `1/n, 2/n, … (n−1)/n`.
///
/// Every border segment goes to the inner point nearest to its middle, so no triangle is longer
/// than a cell. `turned` tells that the inside lies to the right of the border.
fn push_strip(mesh: &mut Triangles, outer: &[u32], inside: &[u32], turned: bool) {
    let cells = inside.len() + 1;
    let segments = outer.len() - 1;
    let mut push = |[a, b, c]: [u32; 3]| mesh.push(if turned { [b, a, c] } else { [a, b, c] });
    let mut reached = 0;
    for (i, pair) in outer.windows(2).enumerate() {
        // Nearest inner point to (i + ½)/segments: index round(cells·(i + ½)/segments) − 1.
        let nearest = ((2 * i + 1) * cells + segments) / (2 * segments);
        let target = nearest.clamp(1, inside.len()) - 1;
        while reached < target {
            push([pair[0], inside[reached + 1], inside[reached]]);
            reached += 1;
        }
        push([pair[0], pair[1], inside[reached]]);
    }
    while reached + 1 < inside.len() {
        push([outer[segments], inside[reached + 1], inside[reached]]);
        reached += 1;
    }
}
