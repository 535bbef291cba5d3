//! The triangles of one patch between given borders, and a proof of how far it strays from them.
//!
//! Rows of vertices at the same column parameters fill the inside; strips of triangles join
//! neighbouring rows, and the outer rows and columns to the borders. A border that has collapsed
//! to a point is the apex of a fan over a first row that reaches from border to border.

use pforms_kernel::Result;

use super::bound::{Facet, Seen, Stray, Unseen, fan_distance};
use super::curvature::{Scratch, restrict};
use super::field::{CELLS, Field, Profile, integral, spread, total};
use super::net::{Net, Quadruple, point_at};
use crate::require_room;
use crate::vector::{Vec3, dot, subtract};

/// More than this many tolerances off, a triangle does not tell how much finer it should be.
const TELLING: f64 = 4.0;

/// Growth of a density where the parameter runs too unevenly for the better bound.
const UNEVEN: f64 = 1.25;

/// Up to this many tolerances off, one axis can mend it.
const SMALL: f64 = 1.5;

/// Growth beyond what a distance asks for, lest it be asked again: the first time, and then.
const MARGINS: [f64; 2] = [1.01, 1.04];

/// What a patch is told about one of its borders `u = 0`, `u = 1`, `v = 0`, `v = 1`.
pub(crate) struct Border<'a> {
    /// Parameters from 0 to 1 and points, in the direction of the patch or against it.
    pub(crate) ticks: &'a [f64],
    pub(crate) points: &'a [Vec3],
    pub(crate) reversed: bool,
    pub(crate) collapsed: bool,
    /// Segments over those asked for.
    pub(crate) surplus: f64,
}

/// A mesh of one patch, and where it should be finer.
#[derive(Default)]
pub(crate) struct Draft {
    pub(crate) parameters: Vec<[f64; 2]>,
    pub(crate) places: Vec<Vec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// How far the surface strays from each triangle.
    pub(crate) strays: Vec<Stray>,
    /// The greatest distance from the surface, in tolerances.
    pub(crate) worst: f64,
    wishes: Wishes,
}

/// Factors for the profiles of a patch; 0 where nothing need change.
struct Wishes([Profile; 6]);

impl Default for Wishes {
    fn default() -> Self {
        Self([[0.0; CELLS]; 6])
    }
}

/// Places of the profiles of rows and columns; those of the borders follow.
const ROWS: usize = 0;
const COLUMNS: usize = 1;
const BORDERS: usize = 2;

impl Draft {
    /// Makes the densities those with which the mesh would have been right.
    ///
    /// Without `coarser`, no density falls.
    pub(crate) fn correct(&self, field: &mut Field, coarser: bool) {
        let least = if coarser { 0.3 } else { 1.0 };
        for (profile, wishes) in field.profiles().zip(&self.wishes.0) {
            for (density, wish) in profile.iter_mut().zip(wishes) {
                if *wish > 0.0 {
                    *density *= wish.max(least);
                }
            }
        }
    }
}

/// The profile that a density comes from, and segments over those it asked for.
#[derive(Clone, Copy)]
struct Source {
    profile: usize,
    surplus: f64,
}

/// A list of vertices along one axis.
struct Rim {
    vertices: Vec<u32>,
    source: Source,
}

/// A triangle of a strip, and how it hangs together with its neighbours.
struct Link {
    /// The distance, if it is not the one seen along the normal.
    unseen: Option<Unseen>,
    /// Boxes of parameters, along the rows' axis and the columns'.
    ranges: [[f64; 2]; 2],
    /// The corner that the triangle before lacks, and the one that the next lacks.
    fresh: u32,
    stale: u32,
    /// The edge shared with the next triangle; edge 0 is shared with the one before.
    exit: usize,
    sources: [Source; 2],
    beyond: Option<[Source; 2]>,
}

struct Layout<'a> {
    net: &'a Net,
    field: &'a Field,
    tolerance: f64,
    coarser: bool,
    draft: Draft,
    /// The net between two row parameters.
    strip: (Net, [f64; 2]),
    scratch: Scratch,
    basis: Vec<f64>,
    line: Vec<Quadruple>,
    /// Column parameters of the inner vertices.
    ticks: Vec<f64>,
    columns: Source,
    links: Vec<Link>,
    seen: Vec<Seen>,
}

/// Lays out one patch.
///
/// Errors: `Limit`.
pub(crate) fn layout(
    net: &Net,
    field: &Field,
    borders: &[Border; 4],
    tolerance: f64,
    coarser: bool,
) -> Result<Draft> {
    let mut layout = Layout {
        net,
        field,
        tolerance,
        coarser,
        draft: Draft::default(),
        strip: (Net::default(), [f64::NAN; 2]),
        scratch: Scratch::default(),
        basis: Vec::new(),
        line: Vec::new(),
        ticks: Vec::new(),
        columns: Source { profile: COLUMNS, surplus: 1.0 },
        links: Vec::new(),
        seen: Vec::new(),
    };
    layout.set_columns()?;
    let mut sides = layout.sides(borders);
    for side in 0..2 {
        if borders[side].collapsed && sides[2].vertices.len() > 2 && sides[3].vertices.len() > 2 {
            sides[side] = layout.fan(&mut sides, side, borders[side].points[0]);
        }
    }
    layout.fill(&sides)?;
    Ok(layout.draft)
}

impl Layout<'_> {
    fn set_columns(&mut self) -> Result<()> {
        let asked = total(&self.field.columns);
        let count = (asked.ceil() as usize).max(1);
        require_room("the mesh", &[count])?;
        spread(&self.field.columns, [0.0, 1.0], count, &mut self.ticks);
        self.columns.surplus = count as f64 / asked.max(f64::MIN_POSITIVE);
        Ok(())
    }

    fn push(&mut self, at: [f64; 2], place: Vec3) -> u32 {
        self.draft.parameters.push(at);
        self.draft.places.push(place);
        self.draft.places.len() as u32 - 1
    }

    fn at(&self, vertex: u32) -> [f64; 2] {
        self.draft.parameters[vertex as usize]
    }

    /// Puts down the vertices of the borders.
    fn sides(&mut self, borders: &[Border; 4]) -> [Rim; 4] {
        const ENDS: [[u32; 2]; 4] = [[0, 1], [2, 3], [0, 2], [1, 3]];
        for (corner, [first, second]) in [[0, 2], [0, 3], [1, 2], [1, 3]].into_iter().enumerate() {
            let [u, v] = [corner / 2, corner % 2];
            // A collapsed border is one point, whatever its poles say.
            let (side, end) = if borders[second].collapsed { (second, u) } else { (first, v) };
            let border = &borders[side];
            let last = if (end == 1) == border.reversed { 0 } else { border.points.len() - 1 };
            self.push([u as f64, v as f64], border.points[last]);
        }
        std::array::from_fn(|side| {
            let (border, fixed) = (&borders[side], (side % 2) as f64);
            let last = border.ticks.len() - 1;
            let mut vertices = vec![ENDS[side][0]];
            for k in 1..last {
                let (k, t) = if border.reversed {
                    (last - k, 1.0 - border.ticks[last - k])
                } else {
                    (k, border.ticks[k])
                };
                let at = if side < 2 { [fixed, t] } else { [t, fixed] };
                vertices.push(self.push(at, border.points[k]));
            }
            vertices.push(ENDS[side][1]);
            let source = Source { profile: BORDERS + side, surplus: border.surplus };
            Rim { vertices, source }
        })
    }

    /// A fan from a collapsed side to a row between the first vertices of the sides next to it,
    /// which is the side of what is left.
    fn fan(&mut self, sides: &mut [Rim; 4], side: usize, apex: Vec3) -> Rim {
        let [first, last] = [2, 3].map(|next: usize| {
            let list = &mut sides[next].vertices;
            if side == 0 {
                list.remove(0);
                list[0]
            } else {
                list.pop();
                list[list.len() - 1]
            }
        });
        let mut vertices = vec![first];
        vertices.extend(self.row([first, last].map(|vertex| self.at(vertex)[0])));
        vertices.push(last);
        for pair in vertices.windows(2) {
            let middle = pair.iter().map(|k| self.at(*k)[1]).sum::<f64>() / 2.0;
            let tip = self.push([side as f64, middle], apex);
            let pair = if side == 0 { [pair[0], pair[1]] } else { [pair[1], pair[0]] };
            self.fan_triangle([tip, pair[0], pair[1]], [sides[2].source, sides[3].source]);
        }
        Rim { vertices, source: self.columns }
    }

    /// The inner vertices of a row from `(a, 0)` to `(b, 1)`.
    fn row(&mut self, [a, b]: [f64; 2]) -> Vec<u32> {
        self.net.row_at(a, &mut self.basis, &mut self.line);
        let mut vertices = Vec::with_capacity(self.ticks.len());
        for k in 0..self.ticks.len() {
            let v = self.ticks[k];
            let u = if a == b { a } else { (1.0 - v) * a + v * b };
            if a != b {
                self.net.row_at(u, &mut self.basis, &mut self.line);
            }
            let place = point_at(&self.line, v, &mut self.basis);
            vertices.push(self.push([u, v], place));
        }
        vertices
    }

    /// Fills what lies between four sides.
    fn fill(&mut self, sides: &[Rim; 4]) -> Result<()> {
        let profile = &self.field.rows;
        let u = |side: usize| sides[side].vertices.iter().map(|&k| self.at(k)[0]);
        let range = [u(0).fold(0.0, f64::max), u(1).fold(1.0, f64::min)];
        let asked = integral(profile, range[1]) - integral(profile, range[0]);
        let count = (asked.ceil() as usize).max(1);
        require_room("the mesh", &[count, self.ticks.len() + 1])?;
        let plain =
            |first: usize| sides[first..].iter().take(2).all(|side| side.vertices.len() == 2);
        if count == 1 && plain(2) {
            self.zip(&sides[0], &sides[1], 1, sides[2].source);
            return Ok(());
        }
        if self.ticks.is_empty() && plain(0) {
            self.zip(&sides[2], &sides[3], 0, sides[0].source);
            return Ok(());
        }
        if self.ticks.is_empty() {
            self.ticks.push(0.5);
            self.columns.surplus *= 2.0;
        }
        let count = count.max(2);
        let rows = Source { profile: ROWS, surplus: count as f64 / asked.max(f64::MIN_POSITIVE) };
        let mut us = Vec::new();
        spread(profile, range, count, &mut us);
        let mut before: Option<Rim> = None;
        let mut ends = [Vec::new(), Vec::new()];
        for u in us {
            let row = Rim { vertices: self.row([u, u]), source: self.columns };
            ends[0].push(row.vertices[0]);
            ends[1].push(row.vertices[row.vertices.len() - 1]);
            self.zip(before.as_ref().unwrap_or(&sides[0]), &row, 1, rows);
            before = Some(row);
        }
        self.zip(before.as_ref().unwrap_or(&sides[0]), &sides[1], 1, rows);
        let [first, last] = ends.map(|vertices| Rim { vertices, source: rows });
        self.zip(&sides[2], &first, 0, self.columns);
        self.zip(&last, &sides[3], 0, self.columns);
        Ok(())
    }

    /// Triangles between two lists of vertices that run along `axis`, the first at lower
    /// parameters of the other axis, whose density comes from `across`.
    fn zip(&mut self, lower: &Rim, upper: &Rim, axis: usize, across: Source) {
        let (low, high) = (&lower.vertices, &upper.vertices);
        let (mut i, mut j) = (0, 0);
        while i + 1 < low.len() || j + 1 < high.len() {
            let step = j + 1 == high.len()
                || (i + 1 < low.len()
                    && self.is_shorter([low[i + 1], high[j]], [low[i], high[j + 1]], axis));
            let (fresh, stale, apex, base, other) = if step {
                (low[i + 1], low[i], high[j], lower, upper)
            } else {
                (high[j + 1], high[j], low[i], upper, lower)
            };
            let [from, to, top] = [stale, fresh, apex].map(|k| self.at(k)[axis]);
            // An apex beyond the base lies too far off by the density of its own side.
            let beyond = (!(from..=to).contains(&top)).then_some(other.source);
            let [a, b] = [low[i], high[j]];
            (i, j) = if step { (i + 1, j) } else { (i, j + 1) };
            let corners = if axis == 1 { [a, b, fresh] } else { [b, a, fresh] };
            let exit = if step == (axis == 1) { 1 } else { 2 };
            let place = |along| if axis == 1 { [across, along] } else { [along, across] };
            let (sources, beyond) = (place(base.source), beyond.map(place));
            let (ranges, unseen) = self.triangle(corners);
            self.links.push(Link { unseen, ranges, fresh, stale, exit, sources, beyond });
        }
        self.judge();
    }

    /// Takes note of how far the surface strays from the triangles of a strip.
    fn judge(&mut self) {
        let (links, seen) = (std::mem::take(&mut self.links), std::mem::take(&mut self.seen));
        for (k, (link, seen)) in links.iter().zip(&seen).enumerate() {
            let (off, growth) = if let Some(Unseen { distance, shares: [a, b] }) = link.unseen {
                (distance / self.tolerance, if a > b { [UNEVEN, 0.0] } else { [0.0, UNEVEN] })
            } else {
                let last = k.checked_sub(1).map(|k| links[k].stale);
                let next = links.get(k + 1).map(|next| next.fresh);
                self.off(seen, link.exit, [last, next])
            };
            self.note(off, growth, link.ranges, link.sources);
            if let Some(sources) = link.beyond {
                self.note(off, growth, link.ranges, sources);
            }
        }
        (self.links, self.seen) = (links, seen);
        self.links.clear();
    }

    /// How many tolerances off the surface is at most, and what would mend it; the neighbours over
    /// edge 0 and the exit are told by their third corners.
    fn off(&self, seen: &Seen, exit: usize, beside: [Option<u32>; 2]) -> (f64, [f64; 2]) {
        let mut far = (0.0_f64, 0);
        let enough = if self.coarser { 0.0 } else { self.tolerance };
        for (edge, apex) in [(0, beside[0]), (exit, beside[1]), (3 - exit, None)] {
            let mut distance = seen.alone(edge);
            // A neighbour can only help, and need not where all is well.
            if let Some(apex) = apex
                && distance > far.0.max(enough)
                && seen.reaches_over(edge)
            {
                distance = seen.beside(edge, self.draft.places[apex as usize]);
            }
            if distance > far.0 {
                far = (distance, edge);
            }
        }
        let off = far.0 / self.tolerance;
        (
            off,
            if off > 1.0 || self.coarser {
                shared(off.min(TELLING), seen.shares(far.1))
            } else {
                [0.0; 2]
            },
        )
    }

    /// Is the first diagonal shorter, by its parameters, or else in space?
    fn is_shorter(&self, first: [u32; 2], second: [u32; 2], axis: usize) -> bool {
        let skew = |[a, b]: [u32; 2]| (self.at(a)[axis] - self.at(b)[axis]).abs();
        let [one, two] = [skew(first), skew(second)];
        if (one - two).abs() > 0.25 * one.max(two) {
            return one < two;
        }
        let length = |[a, b]: [u32; 2]| {
            let way = subtract(self.draft.places[a as usize], self.draft.places[b as usize]);
            dot(way, way)
        };
        length(first) < length(second)
    }

    /// Adds a triangle unless two of its corners coincide, and a bound on how far the surface
    /// strays from it.
    fn triangle(&mut self, corners: [u32; 3]) -> ([[f64; 2]; 2], Option<Unseen>) {
        let places = corners.map(|k| self.draft.places[k as usize]);
        let broad = places[0] != places[1] && places[1] != places[2] && places[2] != places[0];
        let at = corners.map(|k| self.at(k));
        let ranges = [0, 1].map(|axis| range(at.map(|at| at[axis])));
        let [rows, columns] = ranges;
        self.restrict_rows(rows);
        let local = |t: f64, [a, b]: [f64; 2]| if b > a { (t - a) / (b - a) } else { 0.0 };
        let at = at.map(|[u, v]| [local(u, rows), local(v, columns)]);
        let facet = Facet { at, places };
        // One for each link, written where it stays.
        if self.seen.len() == self.links.len() {
            self.seen.push(Seen::default());
        }
        let seen = &mut self.seen[self.links.len()];
        let unseen = seen.look(&self.strip.0, columns, &facet, &mut self.scratch);
        if broad {
            self.draft.triangles.push(corners);
            self.draft.strays.push(match &unseen {
                Some(unseen) => Stray::any_way(unseen.distance),
                None => seen.stray(),
            });
        }
        (ranges, unseen)
    }

    /// Adds a triangle of a fan between two borders.
    fn fan_triangle(&mut self, corners: [u32; 3], borders: [Source; 2]) {
        let places = corners.map(|k| self.draft.places[k as usize]);
        self.draft.triangles.push(corners);
        let at = corners.map(|k| self.at(k));
        // The whole box between the two radii comes to lie over the triangle.
        let rows = range([at[0][0], at[1][0], at[2][0]]);
        let columns = [at[1][1].min(at[2][1]), at[1][1].max(at[2][1])];
        self.restrict_rows(rows);
        let weights = restrict(&self.strip.0, columns, &mut self.scratch);
        let ranges = [rows, columns];
        let distance = fan_distance(&self.strip.0, places, weights, &mut self.scratch);
        self.draft.strays.push(Stray::any_way(distance));
        let off = distance / self.tolerance;
        let growth = off.min(TELLING).sqrt();
        self.note(off, [growth; 2], ranges, [borders[0], self.columns]);
        self.note(off, [growth, 0.0], ranges, [borders[1], self.columns]);
    }

    /// Makes `strip` the net between two row parameters.
    fn restrict_rows(&mut self, rows: [f64; 2]) {
        if self.strip.1 != rows {
            self.net.rows_between(rows, &mut self.strip.0);
            self.strip.1 = rows;
        }
    }

    /// Asks for other densities in a box of parameters.
    fn note(&mut self, off: f64, growth: [f64; 2], ranges: [[f64; 2]; 2], sources: [Source; 2]) {
        let off = if off.is_finite() { off } else { f64::MAX };
        self.draft.worst = self.draft.worst.max(off);
        if off <= 1.0 && !self.coarser {
            return;
        }
        let margin = MARGINS[usize::from(!self.coarser)];
        for ((source, [a, b]), growth) in sources.into_iter().zip(ranges).zip(growth) {
            let wish = margin * growth * source.surplus;
            // A little overlap with the next interval asks for nothing there.
            let first = ((a * CELLS as f64 + 0.1) as usize).min(CELLS - 1);
            let last = ((b * CELLS as f64 - 0.1).ceil() as usize).clamp(first + 1, CELLS);
            for value in &mut self.draft.wishes.0[source.profile][first..last] {
                *value = value.max(wish);
            }
        }
    }
}

/// Factors for the two densities that divide a distance by `off`, in which the axes have these
/// parts; 0 where nothing need change. A small step is left to one axis.
fn shared(off: f64, [a, b]: [f64; 2]) -> [f64; 2] {
    let sum = a + b;
    if off <= 1.0 || !(sum > 0.0 && sum.is_finite()) {
        return [off.sqrt(); 2];
    }
    let [a, b] = [a / sum, b / sum];
    let alone = |part: f64, other: f64| (part / (1.0 / off - other)).sqrt();
    let both = [a, b].map(|part| (2.0 * off * part).sqrt());
    if both[0] < 1.1 {
        [0.0, alone(b, a)]
    } else if both[1] < 1.1 || (off < SMALL && a > b) {
        [alone(a, b), 0.0]
    } else if off < SMALL {
        [0.0, alone(b, a)]
    } else {
        both
    }
}

fn range([a, b, c]: [f64; 3]) -> [f64; 2] {
    [a.min(b).min(c), a.max(b).max(c)]
}
