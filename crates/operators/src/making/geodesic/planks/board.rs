//! A board: the strip in space and the outline in the plane, from the rulings.

use pforms_kernel::{Error, Form, Result};

use super::super::atlas::Atlas;
use super::axis::Axis;
use super::fall::{departure, vector};
use super::nodes::{ORDER, Rule};
use super::rulings::{Fitter, Nature, Piece, larger};
use super::{Mark, Plank};
use crate::Spline;
use crate::measuring::vector::{cross, norm, plus};

/// A board in units of the atlas.
pub(super) struct Board<'a> {
    pub axis: &'a Axis<'a>,
    rule: &'a Rule,
    pub pieces: Vec<Piece>,
    nature: Nature,
    half: f64,
    /// How fast the slope of the rulings changes, at most.
    turning: f64,
    error: f64,
}

/// Shares of the accuracy for the polynomials, and for gaps between them.
const DRAWN: f64 = 0.1;

/// Normals that differ by more have a kink between them.
const KINK: f64 = 1e-5;

impl<'a> Board<'a> {
    pub(super) fn new(
        axis: &'a Axis<'a>,
        rule: &'a Rule,
        half: f64,
        accuracy: f64,
        number: usize,
    ) -> Result<Self> {
        let slack = DRAWN * accuracy;
        let mut fitter = Fitter { axis, rule, half, slack, pieces: Vec::new(), number };
        let nature = fitter.run()?;
        if fitter.pieces.is_empty() {
            let received = format!("line {}, too short to be one", number + 1);
            return Err(Error::degenerate("lines", received, "lines with a length"));
        }
        let departure = departure(&fitter.pieces, rule);
        // Written so that NaN is refused.
        let straight = departure <= accuracy;
        if !straight {
            return Err(Error::domain(
                "lines",
                format!(
                    "line {} that, laid flat, is off straight by {departure:.1e} sizes of the surface",
                    number + 1
                ),
                "geodesics, or a larger accuracy",
            ));
        }
        let gap = meeting(&fitter, accuracy)?;
        let turning = turning(&fitter)?;
        let drawn =
            fitter.pieces.iter().map(|p| p.errors[0] + half * p.errors[1]).fold(0.0, larger);
        let pieces = fitter.pieces;
        Ok(Self { axis, rule, pieces, nature, half, turning, error: drawn + gap + departure })
    }

    /// The edges of a piece at its nodes: on the right, on the left.
    pub(super) fn edges(&self, piece: &Piece) -> [Vec<[f64; 3]>; 2] {
        let rulings = piece.rulings();
        [-self.half, self.half].map(|aside| {
            let edge = |k: usize| {
                let (p, d) = (vector(&piece.point, k), vector(&rulings, k));
                [0, 1, 2].map(|i| p[i] + aside * d[i])
            };
            (0..ORDER).map(edge).collect()
        })
    }

    /// Tangent and the direction to its left at a length.
    pub(super) fn directions(&self, at: f64) -> [[f64; 3]; 2] {
        let index = self.pieces.partition_point(|piece| piece.from <= at).max(1) - 1;
        let piece = &self.pieces[index];
        let share = ((at - piece.from) / (piece.to - piece.from)).clamp(0.0, 1.0);
        [&piece.tangent, &piece.across].map(|rows| [0, 1, 2].map(|k| self.rule.at(&rows[k], share)))
    }

    pub(super) fn plank(&self, atlas: &Atlas) -> Result<Plank> {
        let (strip, line) = self.drawn(atlas)?;
        let length = atlas.length(self.axis.length);
        let end = |piece: Option<&Piece>, node: usize| {
            piece.and_then(|piece| piece.slope.as_ref()).map_or(0.0, |slope| slope[node])
        };
        let (first, last) = (end(self.pieces.first(), 0), end(self.pieces.last(), ORDER - 1));
        let half = atlas.length(self.half);
        let corners = [
            [-half * first, -half],
            [length - half * last, -half],
            [length + half * last, half],
            [half * first, half],
        ];
        let steepest = self.slopes().fold(0.0_f64, |most, x| most.max(x.abs()));
        let sharpest =
            self.pieces.iter().map(|p| p.sharpest(self.rule, self.half)).fold(0.0, f64::max);
        let bend = if self.nature == Nature::Bent { sharpest } else { 0.0 };
        let twist = self.pieces.iter().fold(0.0_f64, |most, piece| most.max(piece.twist));
        let stretched = self.half * twist;
        Ok(Plank {
            strip,
            line,
            axis: Form::from_points(&[2], 2, &[0.0, 0.0, length, 0.0], None)?,
            outline: closed(&corners)?,
            length,
            marks: Vec::<Mark>::new(),
            complete: true,
            overlaps: Vec::new(),
            bend: per_length(atlas, bend),
            twist: per_length(atlas, twist),
            slant: libm::atan(steepest),
            strain: if self.nature == Nature::Twisted {
                stretched * stretched / (1.0 + libm::hypot(1.0, stretched))
            } else {
                0.0
            },
            lift: 0.0,
            overhang: 0.0,
            widest: (self.turning > ROUNDING).then(|| atlas.length(2.0 / self.turning)),
            error: atlas.length(self.error),
        })
    }

    fn slopes(&self) -> impl Iterator<Item = &f64> {
        self.pieces.iter().filter_map(|piece| piece.slope.as_ref()).flatten()
    }

    /// The strip and its axis in space.
    fn drawn(&self, atlas: &Atlas) -> Result<(Spline, Spline)> {
        let (mut strips, mut lines) = (Vec::new(), Vec::new());
        let mut breaks = vec![0.0];
        let mut last: Option<[Vec<f64>; 3]> = None;
        for piece in &self.pieces {
            let [right, left] = self.edges(piece);
            let middle: Vec<[f64; 3]> = (0..ORDER).map(|k| vector(&piece.point, k)).collect();
            let mut rows = [&right, &left, &middle].map(|row| self.poles(atlas, row));
            // Neighbours share their ends: they were found to differ by less than the accuracy.
            for (row, before) in rows.iter_mut().zip(last.iter().flatten()) {
                row[..3].copy_from_slice(before);
            }
            last = Some(rows.each_ref().map(|row| row[3 * (ORDER - 1)..].to_vec()));
            let [right, left, middle] = rows;
            let both: Vec<f64> =
                right.chunks(3).zip(left.chunks(3)).flat_map(|(a, b)| [a, b].concat()).collect();
            strips.push(Form::from_points(&[ORDER, 2], 3, &both, None)?);
            lines.push(Form::from_points(&[ORDER], 3, &middle, None)?);
            breaks.push(atlas.length(piece.to));
        }
        Ok((Spline::end_to_end(&strips, 0, &breaks)?, Spline::end_to_end(&lines, 0, &breaks)?))
    }

    /// Poles of a curve through points at the nodes, in the units of the surface.
    fn poles(&self, atlas: &Atlas, nodes: &[[f64; 3]]) -> Vec<f64> {
        let rows =
            [0, 1, 2].map(|k| self.rule.poles(&nodes.iter().map(|p| p[k]).collect::<Vec<_>>()));
        (0..ORDER).flat_map(|k| atlas.point(&vector(&rows, k))).collect()
    }
}

/// Slopes that change by less, in units, do not: rulings that meet beyond a million sizes of the surface.
const ROUNDING: f64 = 1e-6;

/// A curvature of the surface from one in units.
fn per_length(atlas: &Atlas, x: f64) -> f64 {
    x / atlas.length(1.0)
}

/// How far the ends of neighbouring pieces are apart at the edges, at most.
///
/// Errors: `Degenerate` where that is more than the accuracy.
fn meeting(fitter: &Fitter, accuracy: f64) -> Result<f64> {
    let mut most = 0.0_f64;
    for pair in fitter.pieces.windows(2) {
        let end = |rows: &[Vec<f64>; 3]| vector(rows, ORDER - 1);
        let (a, b) = (end(&pair[0].point), vector(&pair[1].point, 0));
        let (c, d) = (end(&pair[0].rulings()), vector(&pair[1].rulings(), 0));
        let jump = norm(&plus(&a, -1.0, &b));
        let gap = jump + fitter.half * norm(&plus(&c, -1.0, &d));
        most = larger(most, gap);
        let meets = gap <= accuracy;
        if meets {
            continue;
        }
        let place = fitter.place(pair[0].stretch, pair[0].to);
        if jump > accuracy {
            return Err(Error::domain("lines", format!("{place}, a gap"), "lines without gaps"));
        }
        let before = cross(&end(&pair[0].tangent), &end(&pair[0].across));
        let after = cross(&vector(&pair[1].tangent, 0), &vector(&pair[1].across, 0));
        let what = if norm(&plus(&before, -1.0, &after)) > KINK {
            "where the surface has a kink"
        } else {
            "where the curvature of the surface jumps, and the rulings with it"
        };
        return Err(Error::degenerate("lines", format!("{place}, {what}"), "lines that end there"));
    }
    Ok(most)
}

/// How fast the slope of the rulings changes, at most.
///
/// Errors: `Degenerate` when rulings cross on the board.
fn turning(fitter: &Fitter) -> Result<f64> {
    let mut most = (0.0_f64, 0);
    for (index, piece) in fitter.pieces.iter().enumerate() {
        let turning = piece.turning(fitter.rule);
        if turning > most.0 || turning.is_nan() {
            most = (turning, index);
        }
    }
    let fits = fitter.half * most.0 < 1.0;
    if !fits {
        let (atlas, piece) = (fitter.axis.atlas(), &fitter.pieces[most.1]);
        let place = fitter.place(piece.stretch, f64::midpoint(piece.from, piece.to));
        return Err(Error::degenerate(
            "width",
            format!(
                "{:e}: the rulings of {place}, cross on the board",
                atlas.length(2.0 * fitter.half)
            ),
            format!("a width below {:.6e}", atlas.length(2.0 / most.0)),
        ));
    }
    Ok(most.0)
}

/// The closed line through corners.
fn closed(corners: &[[f64; 2]; 4]) -> Result<Spline> {
    let round = corners.iter().chain([&corners[0]]).flatten().copied().collect::<Vec<f64>>();
    let net = Form::from_points(&[5], 2, &round, None)?;
    Spline::joined(net, &[1], &[vec![0.0, 1.0, 2.0, 3.0, 4.0]])
}
