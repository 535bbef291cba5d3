//! By how much the volume of a combination may differ.
//!
//! Move every point of a surface along the normal of its triangle onto the plane of that: what is
//! swept over is `∫ |height| |J| ≤ Σ heightₖ · areaₖ` with the areas of the surface over each
//! triangle, whose sum is known. What is still missing is near the edges. Only points swept over
//! change sides, and of these only those that count: a point inside another solid is in a union
//! whatever happens to it.

use std::f64::consts::PI;

use pforms_kernel::{Result, stopping};

use super::near::Tree;
use super::{Operation, Shell};
use crate::adaptive::Stray;
use crate::vector::{Vec3, cross, norm, subtract};

/// Roundings of a volume, in units of size times area.
const ROUNDINGS: f64 = 1e-14;

/// Parts of a shell that are looked at one by one: of more, all are taken to count.
const PARTS: usize = 64;

/// The volume of all points that may change sides when every surface becomes its mesh.
///
/// Errors: `Stopped`.
pub(super) fn changed(operation: Operation, bodies: &[Vec<Shell>]) -> Result<f64> {
    let shells: Vec<Seen> = bodies
        .iter()
        .enumerate()
        .flat_map(|(body, shells)| shells.iter().map(move |shell| (body, shell)))
        .map(|(body, shell)| Seen { body, shell, reach: shell.reach() })
        .collect();
    if shells.iter().all(|seen| seen.reach == 0.0) {
        return Ok(shells.iter().map(|seen| roundings(seen.shell)).sum());
    }
    let trees: Vec<Tree> =
        shells.iter().map(|seen| Tree::new(&seen.shell.places, &seen.shell.triangles)).collect();
    let mut sum = 0.0;
    for (number, seen) in shells.iter().enumerate() {
        sum += roundings(seen.shell);
        if seen.reach > 0.0 {
            let counted = counted(operation, number, &shells, &trees, bodies.len())?;
            sum += swept(seen.shell, &counted);
        }
    }
    Ok(sum)
}

struct Seen<'a> {
    body: usize,
    shell: &'a Shell,
    /// How far its surface strays at most.
    reach: f64,
}

/// Which triangles of a shell may have points near them that count: those near another shell, and
/// those that are on the right side of all others.
fn counted(
    operation: Operation,
    number: usize,
    shells: &[Seen],
    trees: &[Tree],
    bodies: usize,
) -> Result<Vec<bool>> {
    let own = &shells[number];
    let Shell { places, triangles, .. } = own.shell;
    let mut counted = vec![false; triangles.len()];
    let others = || (0..shells.len()).filter(|other| *other != number);
    for (triangle, near) in triangles.iter().zip(&mut counted) {
        stopping::check()?;
        let corners = triangle.map(|vertex| places[vertex as usize]);
        *near = others().any(|k| trees[k].is_near(corners, own.reach + shells[k].reach));
    }
    let (part, first) = parts(places.len(), triangles, &counted);
    if first.len() > PARTS {
        return Ok(vec![true; triangles.len()]);
    }
    let mut counts = Vec::with_capacity(first.len());
    for vertex in first {
        stopping::check()?;
        let inside = |k: usize| trees[k].winding(places[vertex as usize]) > 0.5;
        let mut within = vec![false; bodies];
        let mut covered = false;
        for k in others().filter(|k| inside(*k)) {
            covered |= shells[k].body == own.body;
            within[shells[k].body] = true;
        }
        let elsewhere = (0..bodies).filter(|body| *body != own.body);
        counts.push(!covered && operation.is_decided_by(own.body, elsewhere, &within));
    }
    for (counted, part) in counted.iter_mut().zip(part) {
        *counted |= part.is_some_and(|part| counts[part]);
    }
    Ok(counted)
}

impl Operation {
    /// Does a point that is in some `others` belong to the result or not as it is in this body?
    fn is_decided_by(
        self,
        own: usize,
        mut others: impl Iterator<Item = usize>,
        within: &[bool],
    ) -> bool {
        others.all(|other| match self {
            Self::Union => !within[other],
            Self::Common => within[other],
            Self::Difference => within[other] == (other == 0 && own != 0),
        })
    }
}

/// The part each triangle belongs to, of those that hang together without the ones that are `left`
/// out, and a vertex of each part.
fn parts(vertices: usize, triangles: &[[u32; 3]], left: &[bool]) -> (Vec<Option<usize>>, Vec<u32>) {
    let mut root: Vec<u32> = (0..vertices as u32).collect();
    let find = |root: &mut Vec<u32>, mut vertex: u32| {
        while root[vertex as usize] != vertex {
            root[vertex as usize] = root[root[vertex as usize] as usize];
            vertex = root[vertex as usize];
        }
        vertex
    };
    let used =
        || triangles.iter().zip(left).filter(|(_, left)| !**left).map(|(corners, _)| corners);
    for &[a, b, c] in used() {
        let [a, b, c] = [a, b, c].map(|vertex| find(&mut root, vertex));
        root[b as usize] = a;
        root[c as usize] = a;
    }
    let mut first: Vec<u32> = used().map(|corners| find(&mut root, corners[0])).collect();
    first.sort_unstable();
    first.dedup();
    let part = triangles.iter().zip(left).map(|(corners, left)| {
        let own = find(&mut root, corners[0]);
        if *left { None } else { first.binary_search(&own).ok() }
    });
    (part.collect(), first)
}

/// The volume that is swept over near the triangles that count.
///
/// The surface over a triangle, seen along the normal, covers it but for strips as wide as the
/// edges are off: no area is less than that, so what any of them exceeds it by is known from all.
fn swept(shell: &Shell, counted: &[bool]) -> f64 {
    let (mut slabs, mut area, mut strips, mut balls) = (0.0, 0.0, 0.0, 0.0);
    let mut highest = 0.0_f64;
    let mut edges = Vec::new();
    for ((corners, stray), counted) in shell.triangles.iter().zip(&shell.strays).zip(counted) {
        let own = Facet::of(&shell.places, *corners);
        area += own.area;
        strips += stray.over * own.perimeter;
        highest = highest.max(stray.height);
        if !counted {
            continue;
        }
        slabs += stray.height * own.area;
        let square = stray.reach() * stray.reach();
        balls += 4.0 * PI * square * stray.reach();
        let [a, b, c] = *corners;
        edges.extend([[a, b], [b, c], [c, a]].map(|[a, b]| ([a.min(b), a.max(b)], square)));
    }
    if !counted.contains(&true) {
        return 0.0;
    }
    edges.sort_unstable_by(|x, y| x.0.cmp(&y.0).then(y.1.total_cmp(&x.1)));
    edges.dedup_by_key(|(edge, _)| *edge);
    let length =
        |[a, b]: [u32; 2]| norm(subtract(shell.places[b as usize], shell.places[a as usize]));
    let tubes: f64 = edges.iter().map(|(edge, square)| PI * square * length(*edge)).sum();
    // Without the area of the surface: what is swept over lies within the height, on either side.
    let excess = shell.area.map_or(slabs, |all| highest * ((all - area).max(0.0) + strips));
    slabs + excess + tubes + balls
}

fn roundings(shell: &Shell) -> f64 {
    let (low, high) = corners(&shell.places);
    if shell.places.is_empty() {
        return 0.0;
    }
    let farthest = low.iter().chain(&high).fold(0.0_f64, |most, x| most.max(x.abs()));
    let size = ROUNDINGS * norm(subtract(high, low)) + 4.0 * f64::EPSILON * farthest;
    size * shell.triangles.iter().map(|own| Facet::of(&shell.places, *own).area).sum::<f64>()
}

struct Facet {
    area: f64,
    perimeter: f64,
}

impl Facet {
    fn of(places: &[Vec3], corners: [u32; 3]) -> Self {
        let [a, b, c] = corners.map(|vertex| places[vertex as usize]);
        let [p, q, r] = [subtract(b, a), subtract(c, b), subtract(a, c)];
        Self { area: norm(cross(p, q)) / 2.0, perimeter: norm(p) + norm(q) + norm(r) }
    }
}

impl Shell {
    /// How far the surface strays from its triangles at most.
    fn reach(&self) -> f64 {
        self.strays.iter().copied().map(Stray::reach).fold(0.0, f64::max)
    }
}

/// The diagonal of the box round all points.
pub(super) fn size(places: &[Vec3]) -> f64 {
    let (low, high) = corners(places);
    if places.is_empty() { 0.0 } else { norm(subtract(high, low)) }
}

/// The lowest and the highest corner of that box.
pub(super) fn corners(places: &[Vec3]) -> (Vec3, Vec3) {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for place in places {
        for k in 0..3 {
            (low[k], high[k]) = (low[k].min(place[k]), high[k].max(place[k]));
        }
    }
    (low, high)
}
