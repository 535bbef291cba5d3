//! A line on a surface by its length: where it is after so much of it.

use std::ops::Range;

use pforms_kernel::{Error, Form, Result};

use super::super::atlas::Atlas;
use super::cut::parts;
use super::nodes::{ORDER, Rule, value};
use super::spot::{Spot, spot};
use crate::measuring::vector::{cross, dot, norm, plus, scaled};
use crate::{Spline, derivative, stretch};

/// A line on a surface, in units of the atlas.
pub(super) struct Axis<'a> {
    atlas: &'a Atlas,
    runs: Vec<Run>,
    cells: Vec<Cell>,
    /// Parts over which the line and the surface are smooth.
    pub stretches: Vec<Stretch>,
    /// Where it goes on with other parameters: over a seam, across a point.
    joints: Vec<f64>,
    pub length: f64,
}

/// A part of a piece of the line that stays in one piece of the surface.
struct Run {
    curve: Form,
    slope: Form,
    /// Parameters of the line.
    window: [f64; 2],
    net: usize,
    length: f64,
}

/// A part of a run over which its speed is a polynomial.
struct Cell {
    run: usize,
    /// Shares of the run.
    part: [f64; 2],
    from: f64,
    by: f64,
    /// Bernstein poles of the length.
    poles: Vec<f64>,
}

/// A smooth part of the line.
pub(super) struct Stretch {
    cells: Range<usize>,
    pub from: f64,
    pub to: f64,
    sign: f64,
    floor: f64,
}

/// Halvings of a run whose speed varies.
const DEPTH: u32 = 40;

/// Parameters that differ by less, in lengths of the window, are the same.
pub(super) const SLACK: f64 = 1e-9;

/// Lengths so small, in sizes of the surface, need no care, and shares of a length are rounding.
const SHORT: f64 = 1e-9;
const ROUNDING: f64 = 1e-13;

/// Cells of one line at most.
const MOST: usize = 1 << 16;

/// Beside a collapsed side a line may have short pieces, where it goes over a knot, that know their places and not
/// their directions: those below this share of a stretch.
const FRAGMENT: f64 = 5e-3;

/// Directions that differ by more make a corner of the line.
const CORNER: f64 = 1e-4;

/// Beside a collapsed edge directions are not trusted where the area is below this share of the largest.
const NEAR_POINT: f64 = 1e-3;

impl<'a> Axis<'a> {
    /// Errors: `Shape` unless the line is a curve in the plane of the parameters; `Domain` where it leaves the
    /// window or has a gap; `Degenerate` when it has no length.
    pub(super) fn new(atlas: &'a Atlas, rule: &Rule, line: &Spline) -> Result<Self> {
        if line.axes() != 1 || line.ambient() != 2 {
            return Err(Error::shape(
                "lines",
                format!("a form of {} axes in dimension {}", line.axes(), line.ambient()),
                "curves in the two parameters of the surface",
            ));
        }
        let mut axis = Self {
            atlas,
            runs: Vec::new(),
            cells: Vec::new(),
            stretches: Vec::new(),
            joints: Vec::new(),
            length: 0.0,
        };
        let breaks = line.breaks();
        for (piece, ends) in line.pieces()?.iter().zip(breaks[0].windows(2)) {
            axis.cut(piece, [ends[0], ends[1]])?;
        }
        for run in 0..axis.runs.len() {
            let start = axis.cells.len();
            let before = axis.length;
            axis.measure(rule, run, [0.0, 1.0], DEPTH)?;
            axis.runs[run].length = axis.length - before;
            axis.join(run, start);
        }
        if !(axis.length > SHORT && axis.length.is_finite()) {
            return Err(Error::degenerate(
                "lines",
                "a line without a length",
                "lines on the surface",
            ));
        }
        axis.oriented()?;
        Ok(axis)
    }

    /// Cuts a piece of the line where it goes over from one piece of the surface to another.
    fn cut(&mut self, piece: &Form, window: [f64; 2]) -> Result<()> {
        let weights = piece.weights();
        if weights.iter().any(|w| *w == 0.0 || w.signum() != weights[0].signum()) {
            return Err(Error::domain(
                "lines",
                "a weight that vanishes or changes sign",
                "weights above 0",
            ));
        }
        for (part, net) in parts(self.atlas, piece)? {
            let curve = stretch(piece, &[part[0]], &[part[1]])?;
            let at = |share: f64| (1.0 - share) * window[0] + share * window[1];
            let slope = derivative(&curve, &[1])?;
            self.runs.push(Run { curve, slope, window: part.map(at), net, length: 0.0 });
        }
        Ok(())
    }

    /// Place and velocity of a run at a share of it, in its piece of the surface.
    fn state(&self, run: &Run, share: f64) -> Result<([f64; 2], [f64; 2])> {
        let (at, by) = (run.curve.at(&[share])?, run.slope.at(&[share])?);
        let index = self.atlas.index(run.net);
        let start = |axis: usize| self.atlas.breaks[axis][index[axis]];
        let place =
            [0, 1].map(|k| ((at[k] - start(k)) / self.atlas.span(run.net, k)).clamp(0.0, 1.0));
        Ok((place, [0, 1].map(|k| by[k] / self.atlas.span(run.net, k))))
    }

    fn speed(&self, run: &Run, share: f64) -> Result<f64> {
        let (place, by) = self.state(run, share)?;
        let [_, u, v, ..] = self.atlas.nets[run.net].jet(place);
        Ok(norm(&u.iter().zip(&v).map(|(u, v)| u * by[0] + v * by[1]).collect::<Vec<_>>()))
    }

    fn speeds(&self, rule: &Rule, run: &Run, [a, b]: [f64; 2]) -> Result<Vec<f64>> {
        rule.nodes.iter().map(|t| Ok((b - a) * self.speed(run, a + (b - a) * t)?)).collect()
    }

    /// Lays cells over a part of a run.
    fn measure(&mut self, rule: &Rule, run: usize, part: [f64; 2], depth: u32) -> Result<()> {
        let middle = f64::midpoint(part[0], part[1]);
        let halves = [[part[0], middle], [middle, part[1]]];
        let whole = self.speeds(rule, &self.runs[run], part)?;
        let by = rule.integrals(&whole)[ORDER - 1];
        let mut sum = 0.0;
        for half in halves {
            sum += rule.integrals(&self.speeds(rule, &self.runs[run], half)?)[ORDER - 1];
        }
        if self.cells.len() > MOST {
            let received = format!("a line of more than {MOST} parts");
            return Err(Error::accuracy("lines", received, "smooth lines"));
        }
        if !by.is_finite() {
            return Err(Error::degenerate(
                "lines",
                "a line on which no length is found",
                "smooth lines",
            ));
        }
        if (by - sum).abs() > ROUNDING * by && by > SHORT && depth > 0 {
            self.measure(rule, run, halves[0], depth - 1)?;
            return self.measure(rule, run, halves[1], depth - 1);
        }
        if by > 0.0 {
            let mut poles = vec![0.0];
            for pole in rule.poles(&whole) {
                poles.push(poles[poles.len() - 1] + pole / ORDER as f64);
            }
            self.cells.push(Cell { run, part, from: self.length, by: poles[ORDER], poles });
            self.length += by;
        }
        Ok(())
    }

    /// Continues the last stretch by the cells of a run, or begins another where something is not smooth.
    fn join(&mut self, run: usize, start: usize) {
        let end = self.cells.len();
        if start == end {
            return;
        }
        let from = self.cells[start].from;
        let goes_on = start > 0 && {
            let (before, now) = (&self.runs[self.cells[start - 1].run], &self.runs[run]);
            let together = self.together(before, now);
            if !together {
                self.joints.push(from);
            }
            together && before.net == now.net && !self.turns(before, now)
                || self.at_point(before, now)
        };
        match self.stretches.last_mut() {
            Some(last) if goes_on => {
                last.cells.end = end;
                last.to = self.length;
            }
            _ => {
                let net = self.runs[run].net;
                let collapses = self.atlas.points_of(net).next().is_some();
                let floor = if collapses { NEAR_POINT * self.breadth(net) } else { 0.0 };
                let (cells, to) = (start..end, self.length);
                self.stretches.push(Stretch { cells, from, to, sign: 1.0, floor });
            }
        }
    }

    /// Are the parameters at the end of a run those at the beginning of another?
    fn together(&self, before: &Run, now: &Run) -> bool {
        let ends = before.curve.at(&[1.0]).ok().zip(now.curve.at(&[0.0]).ok());
        let close = |k: usize, a: &[f64], b: &[f64]| {
            let breaks = &self.atlas.breaks[k];
            (a[k] - b[k]).abs() <= SLACK * (breaks[breaks.len() - 1] - breaks[0])
        };
        ends.is_some_and(|(a, b)| (0..2).all(|k| close(k, &a, &b)))
    }

    /// Does the line go from one run to the other beside a collapsed side?
    fn at_point(&self, before: &Run, now: &Run) -> bool {
        [(before, 1.0), (now, 0.0)].into_iter().all(|(run, share)| {
            let near = |(place, _): ([f64; 2], [f64; 2])| {
                let [_, u, v, ..] = self.atlas.nets[run.net].jet(place);
                norm(&cross(&u, &v)) <= NEAR_POINT * self.breadth(run.net)
            };
            self.atlas.points_of(run.net).next().is_some() && self.state(run, share).is_ok_and(near)
        })
    }

    /// The largest `|f_u × f_v|` of a piece of the surface, about.
    fn breadth(&self, net: usize) -> f64 {
        let places = [0.0, 0.25, 0.5, 0.75, 1.0];
        let all = places.into_iter().flat_map(|u| places.map(|v| [u, v]));
        let area = |place: [f64; 2]| {
            let [_, u, v, ..] = self.atlas.nets[net].jet(place);
            norm(&cross(&u, &v))
        };
        all.map(area).filter(|area| area.is_finite()).fold(0.0, f64::max)
    }

    /// Does the line turn between two runs? Beside a point of the surface parameters do not tell.
    fn turns(&self, before: &Run, now: &Run) -> bool {
        let tangent = |run: &Run, share: f64| {
            let (place, velocity) = self.state(run, share).ok()?;
            spot(&self.atlas.nets[run.net], place, velocity, 1.0, 0.0).frame.map(|f| f.tangent)
        };
        let pair = tangent(before, 1.0).zip(tangent(now, 0.0));
        self.atlas.points_of(now.net).next().is_none()
            && pair.is_some_and(|(a, b)| norm(&plus(&a, -1.0, &b)) > CORNER)
    }

    /// Turns normals so that they go on over a twisted seam.
    fn oriented(&mut self) -> Result<()> {
        let mut before: Option<Vec<f64>> = None;
        for k in 0..self.stretches.len() {
            let Stretch { from, to, .. } = self.stretches[k];
            let ends =
                [self.spot(k, from)?, self.spot(k, to)?].map(|spot| spot.frame.map(|f| f.normal));
            if let (Some(before), Some(now)) = (&before, &ends[0])
                && dot(before, now) < 0.0
            {
                self.stretches[k].sign = -1.0;
            }
            let sign = self.stretches[k].sign;
            before = ends[1].as_ref().map(|normal| scaled(normal, sign));
        }
        Ok(())
    }

    pub(super) fn atlas(&self) -> &Atlas {
        self.atlas
    }

    /// The spot at a length, as a stretch sees it.
    pub(super) fn spot(&self, stretch: usize, at: f64) -> Result<Spot> {
        let Stretch { sign, floor, from, to, .. } = self.stretches[stretch];
        let (run, share) = self.found(stretch, at);
        let (place, velocity) = self.state(run, share)?;
        let mut spot = spot(&self.atlas.nets[run.net], place, velocity, sign, floor);
        if floor > 0.0 && run.length < FRAGMENT * (to - from) {
            spot.frame = None;
        }
        Ok(spot)
    }

    /// Its ends, and where its parameters jump, by their lengths and in space.
    pub(super) fn joints(&self) -> Result<Vec<(f64, Vec<f64>)>> {
        let all = [0.0].into_iter().chain(self.joints.iter().copied()).chain([self.length]);
        all.map(|at| {
            let stretch = self.stretches.partition_point(|one| one.from <= at).max(1) - 1;
            Ok((at, self.spot(stretch, at)?.point))
        })
        .collect()
    }

    /// Parameters on the surface at a length.
    pub(super) fn parameters(&self, stretch: usize, at: f64) -> Vec<f64> {
        let (run, share) = self.found(stretch, at);
        run.curve.at(&[share]).unwrap_or_default()
    }

    /// The run that holds a length of a stretch, and the share of it.
    fn found(&self, stretch: usize, at: f64) -> (&Run, f64) {
        let cells = &self.cells[self.stretches[stretch].cells.clone()];
        let index = cells.partition_point(|cell| cell.from <= at).max(1) - 1;
        let cell = &cells[index];
        let share = cell.share((at - cell.from).clamp(0.0, cell.by));
        (&self.runs[cell.run], cell.part[0] + (cell.part[1] - cell.part[0]) * share)
    }

    /// The length at a parameter of the line, and how much it grows with it.
    pub(super) fn length_at(&self, parameter: f64) -> Result<(f64, f64)> {
        let index = self.runs.partition_point(|run| run.window[0] <= parameter).max(1) - 1;
        let run = &self.runs[index];
        let span = run.window[1] - run.window[0];
        let share = ((parameter - run.window[0]) / span).clamp(0.0, 1.0);
        let mut cells = self.cells.iter().filter(|cell| cell.run == index);
        let cell = cells.clone().find(|cell| share <= cell.part[1]).or_else(|| cells.next_back());
        let rate = self.speed(run, share)? / span;
        Ok(match cell {
            Some(cell) => {
                let within = (share - cell.part[0]) / (cell.part[1] - cell.part[0]);
                (cell.from + value(&cell.poles, within), rate)
            }
            None => (
                self.cells
                    .iter()
                    .rfind(|cell| cell.run < index)
                    .map_or(0.0, |cell| cell.from + cell.by),
                rate,
            ),
        })
    }
}

impl Cell {
    /// The share of the cell after so much of its length.
    fn share(&self, length: f64) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        let mut at = length / self.by;
        for _ in 0..60 {
            let miss = value(&self.poles, at) - length;
            if miss == 0.0 {
                break;
            }
            *(if miss > 0.0 { &mut high } else { &mut low }) = at;
            let rises: Vec<f64> =
                self.poles.windows(2).map(|pair| ORDER as f64 * (pair[1] - pair[0])).collect();
            let next = at - miss / value(&rises, at);
            let inside = next > low && next < high;
            let next = if inside { next } else { f64::midpoint(low, high) };
            if (next - at).abs() <= f64::EPSILON * at {
                break;
            }
            at = next;
        }
        at.clamp(0.0, 1.0)
    }
}
