//! Where planks cross one another.

use pforms_kernel::Result;

use super::super::atlas::Atlas;
use super::board::Board;
use super::{Mark, Plank};
use crate::measuring::vector::{dot, norm, plus};
use crate::{Shape, Spline, intersect};

/// Lines that come as close as this in the parameters, in sizes of their extent, cross.
const ACCURACY: f64 = 1e-12;

/// Ends of pieces that are as close as this in space are one point, and crossings are one, in sizes of the surface.
const CLOSE: f64 = 1e-8;

/// Marks on every plank where the lines of others cross its own.
///
/// Lines are compared in the parameters, where all their crossings are found. The same point of space has other
/// parameters on both sides of a seam and about a collapsed edge; lines that go over one there are cut, so the ends
/// of their pieces are compared in space.
pub(super) fn marked(
    atlas: &Atlas,
    lines: &[Spline],
    boards: &[Board],
    planks: &mut [Plank],
) -> Result<()> {
    let shapes: Vec<Shape> = lines.iter().map(|line| Shape::from(line.clone())).collect();
    let joints: Vec<_> = boards.iter().map(|board| board.axis.joints()).collect::<Result<_>>()?;
    for i in 0..lines.len() {
        for j in i + 1..lines.len() {
            let found = intersect(&shapes[i], &shapes[j], ACCURACY)?;
            let mut places = Vec::with_capacity(found.contacts.len());
            for contact in &found.contacts {
                let (one, rate) = boards[i].axis.length_at(contact.first[0])?;
                let (other, second) = boards[j].axis.length_at(contact.second[0])?;
                places.push([one, other, contact.error * rate, contact.error * second]);
            }
            for a in &joints[i] {
                for b in &joints[j] {
                    let away = norm(&plus(&a.1, -1.0, &b.1));
                    if away <= CLOSE {
                        places.push([a.0, b.0, away, away]);
                    }
                }
            }
            if !found.complete {
                planks[i].complete = false;
                planks[j].complete = false;
            }
            if !found.overlaps.is_empty() {
                planks[i].overlaps.push(j);
                planks[j].overlaps.push(i);
            }
            for [one, other, error, second] in distinct(places) {
                let angle = between(&boards[i], one, &boards[j], other);
                let lengths = [one, other, error, second].map(|x| atlas.length(x));
                let [at, other_at, error, second] = lengths;
                planks[i].marks.push(Mark { other: j, at, other_at, angle, error });
                let (at, other_at, error) = (other_at, at, second);
                planks[j].marks.push(Mark { other: i, at, other_at, angle: -angle, error });
            }
        }
    }
    for plank in planks {
        plank.marks.sort_by(|a, b| a.at.total_cmp(&b.at).then(a.other.cmp(&b.other)));
    }
    Ok(())
}

/// Each crossing once: one on a seam is found on both of its sides.
fn distinct(mut places: Vec<[f64; 4]>) -> Vec<[f64; 4]> {
    places.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut kept: Vec<[f64; 4]> = Vec::with_capacity(places.len());
    for place in places {
        let near = |old: &&[f64; 4]| (0..2).all(|k| (old[k] - place[k]).abs() <= CLOSE);
        if !kept.iter().rev().take_while(|old| place[0] - old[0] <= CLOSE).any(|old| near(&old)) {
            kept.push(place);
        }
    }
    kept
}

/// The angle from one axis to another where they cross. Two boards see the same normal.
fn between(one: &Board, at: f64, other: &Board, there: f64) -> f64 {
    let ([tangent, across], [direction, _]) = (one.directions(at), other.directions(there));
    libm::atan2(dot(&direction, &across), dot(&direction, &tangent))
}
