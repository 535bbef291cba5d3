//! How far a line is from straight when the surface along it is laid flat.

use super::nodes::{ORDER, Rule};
use super::rulings::{Piece, larger};
use crate::measuring::vector::dot;

/// The largest distance of the line laid flat from the segment between its ends: twice the integral of its geodesic
/// curvature, and of the corners between pieces.
pub(super) fn departure(pieces: &[Piece], rule: &Rule) -> f64 {
    let (mut angle, mut at) = (0.0_f64, [0.0_f64; 2]);
    let mut places = vec![at];
    let mut before: Option<[[f64; 3]; 2]> = None;
    for piece in pieces {
        if let Some([tangent, across]) = before {
            let now = vector(&piece.tangent, 0);
            angle += libm::atan2(dot(&now, &across), dot(&now, &tangent));
        }
        let by = piece.to - piece.from;
        let slopes = piece.tangent.each_ref().map(|row| rule.slopes(row));
        let turns: Vec<f64> =
            (0..ORDER).map(|k| dot(&vector(&slopes, k), &vector(&piece.across, k))).collect();
        let angles: Vec<f64> = rule.integrals(&turns).iter().map(|turn| angle + turn).collect();
        let along: Vec<f64> = angles.iter().map(|angle| libm::cos(*angle)).collect();
        let aside: Vec<f64> = angles.iter().map(|angle| libm::sin(*angle)).collect();
        let (along, aside) = (rule.integrals(&along), rule.integrals(&aside));
        places.extend((0..ORDER).map(|k| [at[0] + by * along[k], at[1] + by * aside[k]]));
        angle = angles[ORDER - 1];
        at = places[places.len() - 1];
        before = Some([vector(&piece.tangent, ORDER - 1), vector(&piece.across, ORDER - 1)]);
    }
    let chord = libm::hypot(at[0], at[1]);
    let aside = |[x, y]: &[f64; 2]| ((x * at[1] - y * at[0]) / chord).abs();
    places.iter().map(aside).fold(0.0, larger)
}

/// The vector at a node.
pub(super) fn vector(rows: &[Vec<f64>; 3], node: usize) -> [f64; 3] {
    [rows[0][node], rows[1][node], rows[2][node]]
}
