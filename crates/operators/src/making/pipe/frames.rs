//! The frames along a path, in parts on which each vector is nearly a polynomial.

use pforms_kernel::{Error, Result};

use super::path::Part;
use super::turning::{Turning, array};
use super::unit::unit_along;
use super::vector::Vector;
use crate::measuring::vector::{any_normal, cross, dot, norm, plus, unit};

/// A part of the path with its frame.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    pub part: Part,
    /// Polynomials near the normal and the binormal, and near the tangent when it is asked for.
    pub vectors: Vec<Vector>,
    /// How far each may be from the true vector.
    pub error: f64,
}

/// Parts that a tube may be cut into.
pub(super) const MOST_PARTS: usize = 1 << 14;

/// A part of which nothing can be proved after so many halvings holds a cusp.
const DEPTH: usize = 40;

/// A part however short may spend this share of the error: near a sharp bend rounding would spend
/// it anyway.
const LEAST_SHARE: f64 = 1.0 / 8192.0;

/// What frames are asked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wish {
    /// Largest distance of a vector from the true one.
    pub error: f64,
    /// Is the tangent wanted too?
    pub tangent: bool,
}

/// A part that waits, its share of the path, and how often it may still be halved.
struct Waiting {
    part: Part,
    share: f64,
    depth: usize,
}

fn waiting(parts: Vec<Part>) -> Vec<Waiting> {
    let share = 1.0 / parts.len() as f64;
    parts.into_iter().rev().map(|part| Waiting { part, share, depth: DEPTH }).collect()
}

/// Puts the halves of a part in its place.
fn halve(stack: &mut Vec<Waiting>, whole: &Waiting) {
    let (left, right) = whole.part.halves();
    let (share, depth) = (whole.share / 2.0, whole.depth - 1);
    stack.push(Waiting { part: right, share, depth });
    stack.push(Waiting { part: left, share, depth });
}

/// Rotation-minimising frames: their distance from the true ones adds up along the path.
pub(super) fn minimising(parts: Vec<Part>, wish: Wish) -> Result<Vec<Frame>> {
    let mut frames: Vec<Frame> = Vec::new();
    let mut stack = waiting(parts);
    let mut normals: Option<[[f64; 3]; 2]> = None;
    let (mut arrived, mut error) = (None, 0.0);
    while let Some(next) = stack.pop() {
        let Some(turning) = Turning::of(&next.part.direction) else {
            require_room(&next, frames.len(), || stop(&next.part))?;
            halve(&mut stack, &next);
            continue;
        };
        let [departs, arrives] = turning.tangents();
        let corner = arrived.map_or(0.0, |tangent: [f64; 3]| norm(&plus(&departs, -1.0, &tangent)));
        if corner > wish.error / 8.0 && corner > ROUNDING {
            return Err(bent(&next.part, corner));
        }
        let start = *normals.get_or_insert_with(|| first_normals(&next.part, departs));
        let carried = turning.carry(start);
        let tangent = if wish.tangent { unit_along(&next.part.direction) } else { None };
        let off = tangent.as_ref().map_or(0.0, |(_, off)| *off);
        if carried.error <= wish.error * (next.share / 2.0).max(LEAST_SHARE) && off <= wish.error {
            error += corner + carried.error + f64::EPSILON;
            let mut vectors = carried.normals.to_vec();
            vectors.extend(tangent.map(|(vector, _)| vector));
            frames.push(Frame { part: next.part, vectors, error: error.max(off) });
            normals = Some(carried.end);
            arrived = Some(arrives);
        } else {
            let sharp = carried.error.max(off) > SHARP;
            require_room(&next, frames.len(), || {
                if sharp { stop(&next.part) } else { too_fine(wish.error) }
            })?;
            halve(&mut stack, &next);
        }
    }
    Ok(frames)
}

/// The Frenet frame: each part for itself, and they must agree where they meet.
pub(super) fn frenet(parts: Vec<Part>, wish: Wish) -> Result<Vec<Frame>> {
    for part in &parts {
        if part.is_straight() {
            let received = format!("a straight stretch from {} to {}", part.from, part.to);
            return Err(Error::degenerate("path", received, NO_FRENET));
        }
    }
    let mut frames: Vec<Frame> = Vec::new();
    let mut stack = waiting(parts);
    let mut arrived: Option<[f64; 3]> = None;
    while let Some(next) = stack.pop() {
        let (tangent, binormal) = (&next.part.direction, &next.part.bend);
        let normal = binormal.cross(tangent);
        let found = [&normal, binormal, tangent].map(unit_along);
        let [Some(normal), Some(binormal), Some(tangent)] = found else {
            require_room(&next, frames.len(), || inflection(&next.part))?;
            halve(&mut stack, &next);
            continue;
        };
        let departs = normal.0.first();
        let jump = arrived.map_or(0.0, |vector| norm(&plus(&departs, -1.0, &vector)));
        if jump > wish.error / 8.0 && jump > SUDDEN {
            return Err(inflection(&next.part));
        }
        let error = normal.1.max(binormal.1).max(tangent.1) + jump;
        if error <= wish.error {
            arrived = Some(normal.0.last());
            let mut vectors = vec![normal.0, binormal.0];
            vectors.extend(wish.tangent.then_some(tangent.0));
            frames.push(Frame { part: next.part, vectors, error: error + f64::EPSILON });
        } else {
            require_room(&next, frames.len(), || {
                if error > SHARP { inflection(&next.part) } else { too_fine(wish.error) }
            })?;
            halve(&mut stack, &next);
        }
    }
    Ok(frames)
}

/// Unit tangents that differ by less come from rounding.
const ROUNDING: f64 = 1e-12;

/// The same for principal normals, which lose more.
const SUDDEN: f64 = 1e-8;

/// A frame that is so far off over a part too short to be halved turns at a single place; what is
/// less is rounding.
const SHARP: f64 = 1e-12;

const NO_FRENET: &str = "a curve that bends everywhere, or rotation-minimising frames";

/// The principal normal where there is one, else any; and what makes it a frame.
fn first_normals(part: &Part, tangent: [f64; 3]) -> [[f64; 3]; 2] {
    let normal = if part.is_straight() {
        array(&any_normal(&tangent))
    } else {
        let normal = cross(&part.bend.first(), &tangent);
        let normal = plus(&normal, -dot(&normal, &tangent), &tangent);
        array(&unit(&normal))
    };
    [normal, cross(&tangent, &normal)]
}

fn require_room(next: &Waiting, count: usize, error: impl FnOnce() -> Error) -> Result<()> {
    let room = next.depth > 0 && count < MOST_PARTS && next.part.is_divisible();
    if room { Ok(()) } else { Err(error()) }
}

fn stop(part: &Part) -> Error {
    let received = format!("a cusp or a stop near {}", part.from);
    Error::degenerate("path", received, "a curve that keeps moving")
}

fn bent(part: &Part, corner: f64) -> Error {
    let received = format!("a corner at {}: its tangents are {corner:.3} apart", part.from);
    Error::degenerate("path", received, "a curve without corners, or a pipe for each part")
}

fn inflection(part: &Part) -> Error {
    let received = format!("no principal normal, or one that jumps, near {}", part.from);
    Error::degenerate("path", received, NO_FRENET)
}

fn too_fine(wanted: f64) -> Error {
    let expected = "a larger one: rounding or the number of pieces stops here";
    Error::accuracy("tolerance", format!("vectors off by at most {wanted:e}"), expected)
}
