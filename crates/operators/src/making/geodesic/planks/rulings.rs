//! The rulings of a plank: polynomials for the line, and for where the rulings go.

use pforms_kernel::{Error, Result};

use super::axis::Axis;
use super::nodes::{ORDER, Rule, value};
use super::spot::{Frame, Spot};
use crate::measuring::vector::{norm, plus};

/// A part of a plank; three numbers for a vector, one for each node.
pub(super) struct Piece {
    pub stretch: usize,
    pub from: f64,
    pub to: f64,
    pub point: [Vec<f64>; 3],
    pub tangent: [Vec<f64>; 3],
    pub across: [Vec<f64>; 3],
    /// How far the rulings go along the line for each length across; none where the surface is flat.
    pub slope: Option<Vec<f64>>,
    /// Normal curvatures.
    pub bends: Vec<f64>,
    /// The largest geodesic torsion at nodes and half way between.
    pub twist: f64,
    /// How far the polynomials were off, at most, where they were looked at: of the line, and of the rulings for
    /// each length across.
    pub errors: [f64; 2],
}

/// What a line is like as a whole.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Nature {
    /// The surface bends along it: the plank is its rectifying developable.
    Bent,
    /// It is straight in space and the tangent plane stays: the plank is a plane.
    Flat,
    /// It is straight in space and the tangent plane turns: the plank can only be twisted.
    Twisted,
}

/// Curvatures below this, for a surface of size 1, are rounding.
const FLAT: f64 = 1e-9;

/// Rulings that go so much more along the line than across it are taken to lie along it.
const STEEP: f64 = 1e6;

/// Rounding of a curvature.
const BLUR: f64 = 1e-12;

/// Stretches so short, in sizes of the surface, are left out: they are rounding beside a knot.
const CRUMB: f64 = 1e-10;

/// Places along a piece where its curvature is looked at.
const PLACES: usize = 64;

/// Nodes that have to be known for the others to be filled in.
const ENOUGH: usize = 5;

/// Halvings of a stretch, and pieces of a plank.
const DEPTH: u32 = 40;
const MOST: usize = 1 << 12;

pub(super) struct Fitter<'a> {
    pub axis: &'a Axis<'a>,
    pub rule: &'a Rule,
    /// Half the width of the plank.
    pub half: f64,
    /// How far the line may be off, and the edges.
    pub slack: f64,
    pub pieces: Vec<Piece>,
    /// Which of the lines it is, for errors.
    pub number: usize,
}

impl Fitter<'_> {
    /// Finds the pieces, and of what nature the line is.
    pub(super) fn run(&mut self) -> Result<Nature> {
        let nature = self.nature()?;
        for (k, stretch) in self.axis.stretches.iter().enumerate() {
            if stretch.to - stretch.from <= CRUMB {
                continue;
            }
            self.fit(nature, k, [stretch.from, stretch.to], DEPTH)?;
        }
        self.bridge();
        Ok(nature)
    }

    fn nature(&self) -> Result<Nature> {
        let (mut bend, mut twist, mut seen) = (0.0_f64, 0.0_f64, false);
        for (k, stretch) in self.axis.stretches.iter().enumerate() {
            for t in self.rule.nodes.iter().chain(&self.rule.middles) {
                let at = stretch.from + (stretch.to - stretch.from) * t;
                if let Some(frame) = self.axis.spot(k, at)?.frame {
                    seen = true;
                    bend = bend.max(frame.bend.abs());
                    twist = twist.max(frame.twist.abs());
                }
            }
        }
        if !seen {
            return Err(Error::degenerate(
                "lines",
                format!("line {} where the surface has no tangent plane", self.number + 1),
                "lines on a surface that has one",
            ));
        }
        Ok(if bend > FLAT.max(twist / STEEP) {
            Nature::Bent
        } else if twist > FLAT {
            Nature::Twisted
        } else {
            Nature::Flat
        })
    }

    /// Fits polynomials to a part of a stretch, or to its halves.
    fn fit(
        &mut self,
        nature: Nature,
        stretch: usize,
        [from, to]: [f64; 2],
        depth: u32,
    ) -> Result<()> {
        let spots = |places: &[f64]| -> Result<Vec<Spot>> {
            // The end itself, not what rounding makes of it.
            let at = |t: &f64| if *t == 1.0 { to } else { from + (to - from) * t };
            places.iter().map(|t| self.axis.spot(stretch, at(t))).collect()
        };
        let (nodes, middles) = (spots(&self.rule.nodes)?, spots(&self.rule.middles)?);
        let known: Vec<Option<f64>> = nodes.iter().map(|spot| slope_of(spot, nature)).collect();
        let between: Vec<Option<f64>> = middles.iter().map(|spot| slope_of(spot, nature)).collect();
        let count = known.iter().flatten().count();
        let frames = nodes.iter().filter(|spot| spot.frame.is_some()).count();
        let unruled = count == 0 && between.iter().flatten().count() == 0;
        if let Some(k) =
            known.iter().position(|slope| slope.is_some_and(|x| x.is_nan() || x.abs() > STEEP))
        {
            return Err(self.asymptotic(stretch, from + (to - from) * self.rule.nodes[k]));
        }
        if frames >= ENOUGH && (count >= ENOUGH || unruled) {
            let slope = (!unruled).then(|| self.rule.filled(&known));
            let piece = self.piece(stretch, [from, to], &nodes, slope);
            let piece = self.compared(piece, &middles, &between);
            if piece.errors[0] <= self.slack
                && piece.errors[1] * self.half.min(1.0)
                    <= self.slack + self.half.min(1.0) * blur(&nodes)
            {
                self.pieces.push(piece);
                return Ok(());
            }
        }
        let middle = f64::midpoint(from, to);
        if depth == 0 || self.pieces.len() >= MOST || middle <= from || middle >= to {
            return Err(self.rough(stretch, from, &nodes));
        }
        self.fit(nature, stretch, [from, middle], depth - 1)?;
        self.fit(nature, stretch, [middle, to], depth - 1)
    }

    fn piece(
        &self,
        stretch: usize,
        [from, to]: [f64; 2],
        nodes: &[Spot],
        slope: Option<Vec<f64>>,
    ) -> Piece {
        let vector = |part: &dyn Fn(&Frame) -> f64| {
            self.rule
                .filled(&nodes.iter().map(|spot| spot.frame.as_ref().map(part)).collect::<Vec<_>>())
        };
        Piece {
            stretch,
            from,
            to,
            point: [0, 1, 2].map(|k| nodes.iter().map(|spot| spot.point[k]).collect()),
            tangent: [0, 1, 2].map(|k| vector(&|frame| frame.tangent[k])),
            across: [0, 1, 2].map(|k| vector(&|frame| frame.across[k])),
            slope,
            bends: vector(&|frame| frame.bend),
            twist: 0.0,
            errors: [0.0; 2],
        }
        .with_largest(nodes)
    }

    /// Compares a piece with the line half way between the nodes.
    fn compared(&self, piece: Piece, middles: &[Spot], slopes: &[Option<f64>]) -> Piece {
        let there = |values: &[Vec<f64>; 3]| values.each_ref().map(|row| self.rule.at_middles(row));
        let (points, rulings) = (there(&piece.point), there(&piece.rulings()));
        let at = |rows: &[Vec<f64>; 3], i: usize| [rows[0][i], rows[1][i], rows[2][i]];
        let mut errors = [0.0_f64; 2];
        for (i, spot) in middles.iter().enumerate() {
            errors[0] = larger(errors[0], norm(&plus(&at(&points, i), -1.0, &spot.point)));
            let Some(frame) = &spot.frame else { continue };
            let slope = match (&piece.slope, slopes[i]) {
                (None, _) => 0.0,
                (Some(_), Some(slope)) => slope,
                (Some(_), None) => continue,
            };
            let ruling = plus(&frame.across, slope, &frame.tangent);
            errors[1] = larger(errors[1], norm(&plus(&at(&rulings, i), -1.0, &ruling)));
        }
        Piece { errors, ..piece }.with_largest(middles)
    }

    /// Where the surface is flat along a part of the line any rulings will do: they turn evenly from those before
    /// to those after.
    fn bridge(&mut self) {
        let mut index = 0;
        while index < self.pieces.len() {
            if self.pieces[index].slope.is_some() {
                index += 1;
                continue;
            }
            let end = (index..self.pieces.len())
                .find(|k| self.pieces[*k].slope.is_some())
                .unwrap_or(self.pieces.len());
            let before =
                index.checked_sub(1).and_then(|k| self.pieces[k].slope.as_ref()?.last().copied());
            let after =
                self.pieces.get(end).and_then(|piece| piece.slope.as_ref()?.first().copied());
            let (start, stop) = (self.pieces[index].from, self.pieces[end - 1].to);
            let (a, b) = (before.or(after).unwrap_or(0.0), after.or(before).unwrap_or(0.0));
            for piece in &mut self.pieces[index..end] {
                let slope = |t: &f64| {
                    let at = piece.from + (piece.to - piece.from) * t;
                    a + (b - a) * (at - start) / (stop - start)
                };
                piece.slope = Some(self.rule.nodes.iter().map(slope).collect());
            }
            index = end;
        }
    }

    /// The line and its place, for errors.
    pub(super) fn place(&self, stretch: usize, at: f64) -> String {
        let (number, on) = (self.number + 1, self.axis.parameters(stretch, at));
        let share = at / self.axis.length;
        match on[..] {
            [u, v] => {
                format!("line {number}, at {share:.3} of its length, parameters ({u:.6}, {v:.6})")
            }
            _ => format!("line {number}, at {share:.3} of its length"),
        }
    }

    fn asymptotic(&self, stretch: usize, at: f64) -> Error {
        Error::degenerate(
            "lines",
            format!(
                "{}, where the surface twists along it and does not bend",
                self.place(stretch, at)
            ),
            "lines that end before: there no plank lies along them, however narrow",
        )
    }

    /// What stopped the halving: rulings that come to lie along the line, or something rough.
    fn rough(&self, stretch: usize, at: f64, nodes: &[Spot]) -> Error {
        let frames: Vec<&Frame> = nodes.iter().filter_map(|spot| spot.frame.as_ref()).collect();
        let turned = frames.iter().any(|frame| frame.slope().abs() > 1e-3 * STEEP);
        if turned {
            return self.asymptotic(stretch, at);
        }
        let place = self.place(stretch, at);
        Error::accuracy(
            "accuracy",
            format!("a plank that takes more than {MOST} pieces: {place}"),
            "a smooth line and surface, or a larger number",
        )
    }
}

impl Piece {
    /// The vectors along the rulings: one length across.
    pub(super) fn rulings(&self) -> [Vec<f64>; 3] {
        [0, 1, 2].map(|k| {
            let pairs = self.across[k].iter().zip(&self.tangent[k]);
            match &self.slope {
                Some(slope) => pairs.zip(slope).map(|((b, t), x)| b + x * t).collect(),
                None => self.across[k].clone(),
            }
        })
    }

    /// How fast the slope of the rulings changes, at most: the places where the poles of its slope are largest
    /// over eighths of the piece bound it from above.
    pub(super) fn turning(&self, rule: &Rule) -> f64 {
        let Some(slope) = &self.slope else { return 0.0 };
        let poles = rule.poles(slope);
        let rate = (ORDER - 1) as f64 / (self.to - self.from);
        let mut parts =
            vec![poles.windows(2).map(|pair| rate * (pair[1] - pair[0])).collect::<Vec<_>>()];
        for _ in 0..3 {
            parts = parts.iter().flat_map(|part| halves(part)).collect();
        }
        parts.iter().flatten().fold(0.0, |most, x| larger(most, x.abs()))
    }

    /// The largest curvature square to the rulings at places along the piece, at the edge where they are closest.
    pub(super) fn sharpest(&self, rule: &Rule, half: f64) -> f64 {
        let Some(slope) = &self.slope else { return 0.0 };
        let (slopes, bends) = (rule.poles(slope), rule.poles(&self.bends));
        let by = (ORDER - 1) as f64 / (self.to - self.from);
        let rates: Vec<f64> = slopes.windows(2).map(|pair| by * (pair[1] - pair[0])).collect();
        let curvature = |k: usize| {
            let t = k as f64 / PLACES as f64;
            let (x, rate) = (value(&slopes, t), value(&rates, t));
            value(&bends, t).abs() * (1.0 + x * x) / (1.0 - half * rate.abs())
        };
        (0..=PLACES).map(curvature).fold(0.0, larger)
    }

    fn with_largest(mut self, spots: &[Spot]) -> Self {
        for frame in spots.iter().filter_map(|spot| spot.frame.as_ref()) {
            self.twist = self.twist.max(frame.twist.abs());
        }
        self
    }
}

/// The slope of the ruling at a spot; none where there is no frame, or nothing bends.
fn slope_of(spot: &Spot, nature: Nature) -> Option<f64> {
    let frame = spot.frame.as_ref()?;
    if nature != Nature::Bent {
        return Some(0.0);
    }
    let flat = frame.bend.abs() <= FLAT && frame.twist.abs() <= FLAT;
    (!flat).then(|| frame.slope())
}

/// How far rounding may turn rulings for each length across, where the surface hardly bends.
fn blur(nodes: &[Spot]) -> f64 {
    let bends = nodes.iter().filter_map(|spot| spot.frame.as_ref()).map(|frame| frame.bend.abs());
    BLUR / bends.fold(f64::INFINITY, f64::min).max(FLAT)
}

/// Of Bernstein poles, those of both halves.
fn halves(poles: &[f64]) -> [Vec<f64>; 2] {
    let mut row = poles.to_vec();
    let (mut first, mut second) = (Vec::new(), Vec::new());
    while let (Some(a), Some(b)) = (row.first().copied(), row.last().copied()) {
        first.push(a);
        second.push(b);
        row = row.windows(2).map(|pair| f64::midpoint(pair[0], pair[1])).collect();
    }
    second.reverse();
    [first, second]
}

/// The larger of two numbers, NaN if one is.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a >= b { a } else { b }
}
