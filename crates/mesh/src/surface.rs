//! Surfaces to triangles, without cracks between patches.

use std::collections::HashMap;

use pforms_kernel::{Error, Form, Result};

use crate::edge::{Edge, Key};
use crate::normal::Surface;
use crate::pieces::{ball, finite_pieces};
use crate::room::require_room;
use crate::space::{embed, require_axes, ticks};
use crate::vector::Vec3;
use crate::{Sampling, Triangles};

/// Samples a surface: exact points, exact unit normals `∂ᵤ × ∂ᵥ`.
///
/// Where the normal vanishes (at the pole of a sphere, along a collapsed edge) the limit from
/// inside the window stands in its place. Triangles without area are left out.
///
/// Errors: `Shape` unless the form has two axes; those of [`Sampling::segments`]; `Domain`, naming
/// the parameters, where the weight vanishes.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_mesh::{Sampling, surface};
/// let facet = Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 0.], None)?;
/// let mesh = surface(&facet, &Sampling::Fineness(vec![2]))?;
/// assert_eq!((mesh.positions.len(), mesh.indices.len()), (25, 32));
/// assert_eq!(mesh.normals[0], [0.0, 0.0, 1.0]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn surface(form: &Form, sampling: &Sampling) -> Result<Triangles> {
    Ok(surfaces(std::slice::from_ref(form), sampling)?.pop().unwrap_or_default())
}

/// Samples patches that fit together.
///
/// Patches with a common edge (the same homogeneous poles, in either direction) get the same
/// points on it, to the last bit, so a closed surface gives a watertight mesh.
///
/// Errors: those of [`surface`].
pub fn surfaces(forms: &[Form], sampling: &Sampling) -> Result<Vec<Triangles>> {
    if let Sampling::Tolerance(tolerance) = sampling {
        return crate::adaptive::within(forms, *tolerance);
    }
    let patches: Vec<Patch> =
        forms.iter().map(|form| Patch::new(form, sampling)).collect::<Result<_>>()?;
    let samples = patches.iter().map(|patch| patch.segments.map(|count| count + 1));
    let total = samples.map(|[rows, columns]| rows * columns).sum();
    require_room("the mesh", &[total])?;
    let mut demands: HashMap<Key, usize> = HashMap::new();
    for (edge, segments) in patches.iter().flat_map(Patch::demands) {
        let demand = demands.entry(edge.key()).or_default();
        *demand = segments.max(*demand);
    }
    patches.iter().map(|patch| patch.mesh(&demands)).collect()
}

/// A patch, its edges `u = 0, u = 1, v = 0, v = 1`, and how many cells it needs.
struct Patch {
    surface: Surface,
    edges: [Edge; 4],
    segments: [usize; 2],
}

/// A border of the patch while its vertices are put down.
struct Border {
    points: Vec<Vec3>,
    /// Number of cells.
    segments: usize,
}

/// Which ends of the borders meet in the corners: `(side, at its end)`, twice.
const CORNERS: [[(usize, bool); 2]; 4] = [
    [(0, false), (2, false)],
    [(0, true), (3, false)],
    [(1, false), (2, true)],
    [(1, true), (3, true)],
];

impl Patch {
    fn new(form: &Form, sampling: &Sampling) -> Result<Self> {
        require_axes(form, 2, "a surface: two axes")?;
        let form = embed(form)?;
        let segments = sampling.segments(&form)?;
        let (centre, radius) = ball(&finite_pieces(&form)?);
        Ok(Self {
            surface: Surface::new(&form, centre, radius)?,
            edges: [(0, false), (0, true), (1, false), (1, true)]
                .map(|(fixed, high)| Edge::of(&form, fixed, high)),
            segments: [segments[0], segments[1]],
        })
    }

    /// The cells each edge needs, seen from this patch alone.
    fn demands(&self) -> impl Iterator<Item = (&Edge, usize)> {
        let [across, down] = self.segments;
        self.edges.iter().zip([down, down, across, across])
    }

    fn mesh(&self, demands: &HashMap<Key, usize>) -> Result<Triangles> {
        let mut borders = Vec::with_capacity(4);
        for (edge, own) in self.demands() {
            let segments = demands.get(&edge.key()).copied().unwrap_or(own);
            borders.push(Border { points: edge.points(segments)?, segments });
        }
        self.join_corners(&mut borders);
        let own = self.demands().map(|(_, own)| own);
        if borders.iter().map(|border| border.segments).eq(own) {
            self.plain(&borders)
        } else {
            self.stitched(&borders)
        }
    }

    /// Gives the borders next to a collapsed edge exactly its point.
    fn join_corners(&self, borders: &mut [Border]) {
        let mut copy = |(from, end): (usize, bool), (to, at): (usize, bool)| {
            let index = if end { borders[from].points.len() - 1 } else { 0 };
            let point = borders[from].points[index];
            let index = if at { borders[to].points.len() - 1 } else { 0 };
            borders[to].points[index] = point;
        };
        for [first, second] in CORNERS {
            if self.edges[second.0].single_point().is_some() {
                copy(second, first);
            } else {
                copy(first, second);
            }
        }
    }

    /// One grid, its border points those of the edges.
    fn plain(&self, borders: &[Border]) -> Result<Triangles> {
        let [across, down] = self.segments;
        let grid = self.surface.grid(&ticks(across), &ticks(down))?;
        let mut mesh = Triangles {
            positions: grid.positions,
            normals: grid.normals,
            indices: Vec::with_capacity(2 * across * down),
        };
        for j in 0..=down {
            mesh.positions[j] = borders[0].points[j];
            mesh.positions[across * (down + 1) + j] = borders[1].points[j];
        }
        for i in 0..=across {
            mesh.positions[i * (down + 1)] = borders[2].points[i];
            mesh.positions[i * (down + 1) + down] = borders[3].points[i];
        }
        push_cells(&mut mesh, 0, across, down)?;
        Ok(mesh)
    }

    /// A smaller grid inside, and four strips from its border to the finer edges.
    fn stitched(&self, borders: &[Border]) -> Result<Triangles> {
        let [across, down] = self.segments.map(|count| count.max(2));
        let inner = |count: usize| ticks(count)[1..count].to_vec();
        let grid = self.surface.grid(&inner(across), &inner(down))?;
        let mut mesh =
            Triangles { positions: grid.positions, normals: grid.normals, indices: Vec::new() };
        push_cells(&mut mesh, 0, across - 2, down - 2)?;
        for (side, border) in borders.iter().enumerate() {
            let free = ticks(border.segments);
            let fixed = [if side % 2 == 0 { 0.0 } else { 1.0 }];
            let line = if side < 2 {
                self.surface.grid(&fixed, &free)?
            } else {
                self.surface.grid(&free, &fixed)?
            };
            let first = mesh.positions.len() as u32;
            mesh.positions.extend(&border.points);
            mesh.normals.extend(line.normals);
            let outer: Vec<u32> = (first..=first + border.segments as u32).collect();
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

/// The cells of a grid with vertices from `first` on.
fn push_cells(mesh: &mut Triangles, first: u32, across: usize, down: usize) -> Result<()> {
    if mesh.positions.len() > u32::MAX as usize {
        return Err(Error::shape("mesh", mesh.positions.len(), "fewer than 2³² vertices"));
    }
    let row = down as u32 + 1;
    for i in 0..across as u32 {
        for j in 0..down as u32 {
            let a = first + i * row + j;
            mesh.push_quad([a, a + row, a + row + 1, a + 1]);
        }
    }
    Ok(())
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
