//! How far a form strays from the flat facets between its samples.
//!
//! On a cell with sides `hᵢ`, a polynomial and its interpolation over any simplex inside differ by
//! at most `⅛ Σᵢⱼ hᵢ hⱼ max‖∂ᵢ∂ⱼ‖` (Filip, Magedson and Markot, *Surface algorithms using bounds
//! on derivatives*, 1986). A rational form `P/w` is compared with the facet point `P̃/w̃` of the
//! same parameters: `P/w − P̃/w̃ = ((P − P̃) − (w − w̃)·P̃/w̃) / w` (after Zheng and Sederberg,
//! *Estimating tessellation parameter intervals for rational curves and surfaces*, 2000).

use pforms_kernel::{Form, Result};

use crate::pieces::{Piece, ball};
use crate::space::{centred, derivative, quadruples};
use crate::vector::norm;

/// Bounds `D` such that cells with sides `hᵢ` stray by at most `⅛ Σᵢⱼ hᵢ hⱼ Dᵢⱼ`.
pub(crate) struct Deviation {
    axes: usize,
    bounds: Vec<f64>,
}

impl Deviation {
    /// The bounds that hold on all the pieces of a form.
    pub(crate) fn of(pieces: &[Piece], axes: usize) -> Result<Self> {
        let (centre, radius) = ball(pieces);
        let lightest = pieces
            .iter()
            .flat_map(|piece| quadruples(&piece.form))
            .fold(f64::INFINITY, |least, pole| least.min(pole[3].abs()));
        let mut bounds = vec![0.0_f64; axes * axes];
        for piece in pieces {
            let form = centred(&piece.form, centre)?;
            for first in 0..axes {
                for second in first..axes {
                    let halvings = piece.depths[first] + piece.depths[second];
                    let bound = 2.0_f64.powi(halvings as i32)
                        * second_derivative(&form, first, second, radius)?
                        / lightest;
                    for k in [first * axes + second, second * axes + first] {
                        bounds[k] = bounds[k].max(bound);
                    }
                }
            }
        }
        Ok(Self { axes, bounds })
    }

    /// Numbers of equal cells along each axis with which the form strays by at most `tolerance`.
    ///
    /// The sides are shared out by the share each axis has in the bound.
    pub(crate) fn segments(&self, tolerance: f64) -> Vec<f64> {
        let density: Vec<f64> =
            self.bounds.chunks_exact(self.axes).map(|row| row.iter().sum::<f64>().sqrt()).collect();
        let mut sum = 0.0;
        for (i, a) in density.iter().enumerate() {
            for (j, b) in density.iter().enumerate() {
                let bound = self.bounds[i * self.axes + j];
                sum += if bound > 0.0 { bound / (a * b) } else { 0.0 };
            }
        }
        let factor = (sum / (8.0 * tolerance)).sqrt();
        density.iter().map(|a| (a * factor).ceil().max(1.0)).collect()
    }
}

/// A bound on `‖∂∂P‖ + radius·|∂∂w|` over the window of one piece.
fn second_derivative(form: &Form, first: usize, second: usize, radius: f64) -> Result<f64> {
    let Some(once) = derivative(form, first)? else { return Ok(0.0) };
    let Some(twice) = derivative(&once, second)? else { return Ok(0.0) };
    let (mut points, mut weights) = (0.0_f64, 0.0_f64);
    for &[x, y, z, w] in quadruples(&twice) {
        points = points.max(norm([x, y, z]));
        weights = weights.max(w.abs());
    }
    Ok(points + radius * weights)
}
