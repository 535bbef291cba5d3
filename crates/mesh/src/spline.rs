//! Splines to lines and patches: their pieces, put together again.

use pforms_kernel::Form;
use pforms_kernel::Result;
use pforms_operators::Spline;

use crate::curve::{Curve, Polyline, curve};
use crate::space::require_axes;
use crate::vector::{add, unit};
use crate::volume::envelope;
use crate::{Sampling, require_room};

/// Samples a spline curve: every piece as a curve, and one polyline as far as they meet.
///
/// Parameters and gaps are those of the spline. The sampling counts for each piece.
///
/// Errors: as [`curve`].
pub fn chain(spline: &Spline, sampling: &Sampling) -> Result<Curve> {
    require_axes(spline.net(), 1, "a curve: one axis")?;
    let breaks = spline.breaks().concat();
    let mut whole = Curve::default();
    for (piece, ends) in spline.pieces()?.iter().zip(breaks.windows(2)) {
        let global = |t: &f64| if *t == 1.0 { ends[1] } else { ends[0] + t * (ends[1] - ends[0]) };
        let part = curve(piece, sampling)?;
        for mut line in part.polylines {
            line.parameters.iter_mut().for_each(|t| *t = global(t));
            match whole.polylines.last_mut() {
                Some(before) if before.meets(&line) => before.go_on(&line),
                _ => whole.polylines.push(line),
            }
        }
        whole.gaps.extend(part.gaps.iter().map(global));
        require_room(
            "the polyline",
            &[whole.polylines.iter().map(|line| line.points.len()).sum()],
        )?;
    }
    whole.gaps.dedup();
    Ok(whole)
}

/// The surfaces by which a spline is drawn: the pieces of a surface, and of a volume the outer faces
/// of its pieces, normals outwards. Those next to each other share the poles of their edges.
///
/// Errors: `Shape` unless it has two or three axes; `Limit`.
pub fn patches(spline: &Spline) -> Result<Vec<Form>> {
    if spline.axes() != 3 {
        require_axes(spline.net(), 2, "a surface or a volume")?;
        return spline.pieces();
    }
    let counts = spline.counts();
    let mut faces = Vec::new();
    for (number, piece) in spline.pieces()?.iter().enumerate() {
        let index =
            [number / (counts[1] * counts[2]), number / counts[2] % counts[1], number % counts[2]];
        let outer = |side: usize| {
            let (axis, high) = (side / 2, side % 2 == 1);
            index[axis] == if high { counts[axis] - 1 } else { 0 }
        };
        if (0..6).any(outer) {
            let own = envelope(piece)?.into_iter().enumerate();
            faces.extend(own.filter(|(side, _)| outer(*side)).map(|(_, face)| face));
        }
    }
    Ok(faces)
}

impl Polyline {
    fn meets(&self, next: &Self) -> bool {
        self.points.last() == next.points.first()
            && self.parameters.last() == next.parameters.first()
    }

    /// The next line from here; where the two meet at an angle the tangent is the mean.
    fn go_on(&mut self, next: &Self) {
        if let (Some(here), Some(there)) = (self.tangents.last_mut(), next.tangents.first()) {
            *here = unit(add(*here, *there)).unwrap_or(*here);
        }
        self.points.extend(&next.points[1..]);
        self.tangents.extend(&next.tangents[1..]);
        self.parameters.extend(&next.parameters[1..]);
    }
}
