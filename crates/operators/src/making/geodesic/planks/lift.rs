//! How far the edges of planks stand off the surface, and beyond its border.

use pforms_kernel::Result;

use super::super::atlas::Atlas;
use super::Plank;
use super::board::Board;
use crate::measuring::vector::{cross, dot, norm, plus};
use crate::{Spline, SplineProjector};

/// Of the feet, in sizes of the surface.
const ACCURACY: f64 = 1e-9;

/// What an edge goes beyond the border, in sizes of the surface: less is that of the feet.
const LEAST: f64 = 1e-7;

/// Measures the edges of all planks at the nodes of their pieces.
///
/// From the nearest point of the surface, the part along its normal is the lift; what is left over lies beyond the
/// border, where alone the nearest point is not a foot.
pub(super) fn measured(
    surface: &Spline,
    atlas: &Atlas,
    boards: &[Board],
    planks: &mut [Plank],
) -> Result<()> {
    let projector = SplineProjector::new(surface, ACCURACY)?;
    for (board, plank) in boards.iter().zip(planks) {
        let points: Vec<Vec<f64>> = board
            .pieces
            .iter()
            .flat_map(|piece| board.edges(piece).concat())
            .map(|point| atlas.point(&point))
            .collect();
        let found = projector.project(&points.concat())?;
        let feet = found.points.chunks_exact(3).zip(found.parameters.chunks_exact(2));
        for (point, (foot, at)) in points.iter().zip(feet) {
            let away = plus(&atlas.unplaced(point), -1.0, &atlas.unplaced(foot));
            let (net, place) = atlas.locate([at[0], at[1]]);
            let (off, over) = parted(atlas, net, place, &away);
            plank.lift = plank.lift.max(atlas.length(off));
            if over > LEAST {
                plank.overhang = plank.overhang.max(atlas.length(over));
            }
        }
    }
    Ok(())
}

/// The parts of a vector along the normal of the surface and in its tangent plane; where there is none, all is along
/// the normal.
fn parted(atlas: &Atlas, net: usize, place: [f64; 2], away: &[f64]) -> (f64, f64) {
    let [_, u, v, ..] = atlas.nets[net].jet(place.map(|t| t.clamp(0.0, 1.0)));
    let normal = cross(&u, &v);
    let area = norm(&normal);
    let stands = area > ACCURACY * norm(&u) * norm(&v);
    if !stands {
        return (norm(away), 0.0);
    }
    let off = dot(away, &normal) / area;
    (off.abs(), norm(&plus(away, -off / area, &normal)))
}
