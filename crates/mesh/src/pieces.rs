//! Where the weight keeps its sign: pieces of the window on which a form is surely finite.

use pforms_kernel::{Error, Form, Result};

use crate::space::{quadruples, window};
use crate::vector::{Vec3, norm, subtract};

/// Pieces examined before a weight is taken to vanish: far more than a regular form needs.
const MOST_PIECES: usize = 4096;

/// Halvings of one axis before a zero of the weight counts as found: 2⁻⁴⁰ of the window.
const FINEST: u32 = 40;

/// A part of the window whose pole weights all have one sign.
pub(crate) struct Piece {
    pub(crate) form: Form,
    /// Halvings along each axis.
    pub(crate) depths: Vec<u32>,
    /// Lower corner in the parameters of the whole.
    corner: Vec<f64>,
}

/// What halving found out about a form.
pub(crate) struct Pieces {
    pub(crate) finite: Vec<Piece>,
    /// Parameters within 2⁻⁴⁰ of which the weight vanishes; adjoining ones follow each other.
    pub(crate) zeros: Vec<Vec<f64>>,
}

/// Halves the form (in space) until the weight keeps its sign on every piece.
///
/// With `patient` off, the first zero found ends the search.
pub(crate) fn pieces(form: &Form, patient: bool) -> Result<Pieces> {
    if quadruples(form).iter().all(|pole| pole[3] == 0.0) {
        return Err(Error::domain("weights", "0 at every pole", "a form with finite points"));
    }
    let axes = form.axes();
    let mut waiting =
        vec![Piece { form: form.clone(), depths: vec![0; axes], corner: vec![0.0; axes] }];
    let mut found = Pieces { finite: Vec::new(), zeros: Vec::new() };
    while let Some(piece) = waiting.pop() {
        if piece.keeps_sign() {
            found.finite.push(piece);
        } else if let Some(axis) = piece.axis_to_halve() {
            waiting.extend(piece.halves(axis)?);
        } else {
            found.zeros.push(piece.corner);
        }
        let hopeless = found.finite.len() + waiting.len() > MOST_PIECES;
        if hopeless || (!patient && !found.zeros.is_empty()) {
            let near = found.zeros.pop().or_else(|| waiting.pop().map(|piece| piece.corner));
            return Err(vanishing(&near.unwrap_or_default()));
        }
    }
    Ok(found)
}

impl Piece {
    fn keeps_sign(&self) -> bool {
        let poles = quadruples(&self.form);
        poles.iter().all(|pole| pole[3] > 0.0) || poles.iter().all(|pole| pole[3] < 0.0)
    }

    /// The least halved axis, as long as it may be halved again.
    fn axis_to_halve(&self) -> Option<usize> {
        let axes = (0..self.depths.len()).filter(|&axis| self.form.orders()[axis] > 1);
        axes.min_by_key(|&axis| self.depths[axis]).filter(|&axis| self.depths[axis] < FINEST)
    }

    /// The upper half first, so that a stack hands out the lower one next.
    fn halves(&self, axis: usize) -> Result<[Self; 2]> {
        let half = |a: f64, b: f64| -> Result<Self> {
            let mut depths = self.depths.clone();
            let mut corner = self.corner.clone();
            corner[axis] += a * 0.5_f64.powi(depths[axis] as i32);
            depths[axis] += 1;
            Ok(Self { form: window(&self.form, axis, a, b)?, depths, corner })
        };
        Ok([half(0.5, 1.0)?, half(0.0, 0.5)?])
    }
}

/// The pieces of a form that must be finite all over its window.
///
/// Errors: `Domain`, naming the parameter, where the weight vanishes.
pub(crate) fn finite_pieces(form: &Form) -> Result<Vec<Piece>> {
    Ok(pieces(form, false)?.finite)
}

/// Complains unless a form is finite all over its window.
///
/// Errors: as [`finite_pieces`].
pub(crate) fn require_finite(form: &Form) -> Result<()> {
    if quadruples(form).iter().all(|pole| pole[3] > 0.0) {
        return Ok(());
    }
    finite_pieces(form).map(|_| ())
}

/// The same pieces, halved further along every axis as often as `times`: poles of smaller pieces
/// lie closer to the form and bound it better.
pub(crate) fn refined(pieces: Vec<Piece>, times: u32) -> Result<Vec<Piece>> {
    let mut pieces = pieces;
    let axes = pieces.first().map_or(0, |piece| piece.depths.len());
    for axis in (0..times).flat_map(|_| 0..axes) {
        let mut finer = Vec::with_capacity(2 * pieces.len());
        for piece in pieces {
            if piece.form.orders()[axis] > 2 {
                finer.extend(piece.halves(axis)?);
            } else {
                finer.push(piece);
            }
        }
        pieces = finer;
    }
    Ok(pieces)
}

/// Centre of the box round all poles of the pieces, and the greatest distance of a pole from it.
///
/// The convex hull of the poles holds the form, so that distance bounds the form's too.
pub(crate) fn ball(pieces: &[Piece]) -> (Vec3, f64) {
    let points =
        || pieces.iter().flat_map(|piece| quadruples(&piece.form)).map(crate::space::project);
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for point in points() {
        for k in 0..3 {
            low[k] = low[k].min(point[k]);
            high[k] = high[k].max(point[k]);
        }
    }
    let centre = std::array::from_fn(|k| low[k] / 2.0 + high[k] / 2.0);
    (centre, points().map(|point| norm(subtract(point, centre))).fold(0.0, f64::max))
}

fn vanishing(parameters: &[f64]) -> Error {
    let list: Vec<String> = parameters.iter().map(|t| format!("{t:.6}")).collect();
    Error::domain(
        "parameters",
        format!("a weight that vanishes near ({})", list.join(", ")),
        "a weight that keeps its sign inside the window (draw a part of it instead)",
    )
}
