//! A piece of a line, cut where it goes over from one piece of the surface to another.

use pforms_kernel::{Error, Form, Result};

use super::super::atlas::Atlas;
use super::axis::SLACK;
use crate::stretch;

/// Shares of a piece of a line, and the piece of the surface they lie in.
pub(super) type Share = ([f64; 2], usize);

/// Halvings at a knot of the surface.
const DEPTH: u32 = 40;

/// The parts of a piece of a line, which lie in one piece of the surface each: halved until its poles do.
///
/// Errors: `Domain` where it leaves the window.
pub(super) fn parts(atlas: &Atlas, piece: &Form) -> Result<Vec<Share>> {
    let mut parts = Vec::new();
    halved(atlas, piece, [0.0, 1.0], DEPTH, &mut parts)?;
    Ok(parts)
}

fn halved(
    atlas: &Atlas,
    piece: &Form,
    part: [f64; 2],
    depth: u32,
    parts: &mut Vec<Share>,
) -> Result<()> {
    let points = stretch(piece, &[part[0]], &[part[1]])?.points()?;
    let mut index = [0; 2];
    let mut held = true;
    for (axis, index) in index.iter_mut().enumerate() {
        let breaks = &atlas.breaks[axis];
        let (first, last) = (breaks[0], breaks[breaks.len() - 1]);
        let slack = SLACK * (last - first);
        let values = points.iter().skip(axis).step_by(2);
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
        if high < first - slack || low > last + slack {
            let received = format!("a line that comes to {}", if low > last { low } else { high });
            return Err(Error::domain(
                "lines",
                received,
                format!("parameters from {first} to {last}"),
            ));
        }
        let middle = f64::midpoint(low, high);
        *index = breaks[1..breaks.len() - 1].iter().filter(|t| **t <= middle).count();
        held &= low >= breaks[*index] - slack && high <= breaks[*index + 1] + slack;
    }
    if !held && depth > 0 {
        let middle = f64::midpoint(part[0], part[1]);
        halved(atlas, piece, [part[0], middle], depth - 1, parts)?;
        return halved(atlas, piece, [middle, part[1]], depth - 1, parts);
    }
    let net = atlas.net_at(index);
    match parts.last_mut() {
        Some((before, same)) if *same == net => before[1] = part[1],
        _ => parts.push((part, net)),
    }
    Ok(())
}
