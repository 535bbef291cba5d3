//! The surface as pieces that know their neighbours: over knots, over seams, at collapsed edges.

use pforms_kernel::{Error, Form, Result};

use super::cap::Cap;
use super::metric::{MOST, Net};
use crate::Spline;
use crate::measuring::about_one::{shifted, unit_of, with_weights_about_one};
use crate::measuring::vector::{norm, plus};

/// Pieces of a surface, centred and in units of about its size.
pub(super) struct Atlas {
    pub nets: Vec<Net>,
    pub counts: [usize; 2],
    pub breaks: [Vec<f64>; 2],
    pub ambient: usize,
    /// Which opposite sides are one and the same line.
    seams: [Seam; 2],
    /// For each axis and side of the window whose edge collapses, the point it collapses to.
    pub caps: [[Edge; 2]; 2],
    centre: Vec<f64>,
    unit: i32,
}

/// How two opposite sides of the window meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Seam {
    Open,
    Closed,
    /// Closed with the other parameter turned round, as on a Möbius band.
    Twisted,
}

/// A side of the window.
pub(super) enum Edge {
    /// A curve.
    Line,
    /// A point with a tangent plane.
    Cap(Box<Cap>),
    /// A point without one, such as the apex of a cone.
    Apex(Vec<f64>),
}

/// What lies beyond a side of a piece.
pub(super) enum Beyond {
    Piece {
        net: usize,
        /// Is the other parameter turned round there?
        turned: bool,
    },
    /// Nothing: a side of the window.
    Border,
    /// The whole side is one point.
    Point,
}

/// Differences of coordinates that count as rounding, in sizes of the surface.
pub(super) const ROUNDING: f64 = 64.0 * f64::EPSILON;

impl Atlas {
    /// Errors: `Shape` unless it is a surface in dimension 2 or more, of degrees below 32; `Degenerate` when
    /// it is a single point; `Domain` when all its weights are 0.
    pub(super) fn new(surface: &Spline, cross_seams: bool) -> Result<Self> {
        let degrees = surface.degrees();
        if surface.axes() != 2 || surface.ambient() < 2 {
            return Err(Error::shape(
                "surface",
                format!("a form of {} axes in dimension {}", surface.axes(), surface.ambient()),
                "a surface in dimension 2 or more",
            ));
        }
        if degrees.iter().any(|degree| *degree >= MOST) {
            let received = format!("degrees {degrees:?}");
            return Err(Error::shape("surface", received, format!("degrees below {MOST}")));
        }
        let pieces = surface.pieces()?;
        let pieces: Vec<Form> = pieces.iter().map(with_weights_about_one).collect::<Result<_>>()?;
        let unit = unit_of(surface.net())?;
        let (centre, unit) = middle(&pieces, unit);
        if unit == i32::MIN {
            return Err(Error::degenerate("surface", "a single point", "a surface with an area"));
        }
        let nets = pieces.iter().map(|piece| seen_from(piece, &centre, unit)).collect();
        let breaks = surface.breaks();
        let counts = surface.counts();
        let mut atlas = Self {
            nets,
            counts: [counts[0], counts[1]],
            breaks: [breaks[0].clone(), breaks[1].clone()],
            ambient: surface.ambient(),
            seams: [Seam::Open; 2],
            caps: [[Edge::Line, Edge::Line], [Edge::Line, Edge::Line]],
            centre,
            unit,
        };
        if cross_seams {
            atlas.seams = [atlas.seam(0), atlas.seam(1)];
        }
        for (axis, side) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            if let Some(apex) = atlas.collapsed(axis, side) {
                let closed = atlas.seams[1 - axis] == Seam::Closed;
                atlas.caps[axis][side] = match Cap::new(&atlas, axis, side, &apex, closed) {
                    Some(cap) => Edge::Cap(Box::new(cap)),
                    None => Edge::Apex(apex),
                };
            }
        }
        Ok(atlas)
    }

    /// The cap at a side of the window, if there is one.
    pub(super) fn cap(&self, axis: usize, side: usize) -> Option<&Cap> {
        match &self.caps[axis][side] {
            Edge::Cap(cap) => Some(cap),
            Edge::Line | Edge::Apex(_) => None,
        }
    }

    /// Axes and sides of a piece that are points.
    pub(super) fn points_of(&self, net: usize) -> impl Iterator<Item = (usize, usize)> {
        let index = self.index(net);
        let is_point = move |&(axis, side): &(usize, usize)| {
            let end = if side == 0 { 0 } else { self.counts[axis] - 1 };
            index[axis] == end && !matches!(self.caps[axis][side], Edge::Line)
        };
        [(0, 0), (0, 1), (1, 0), (1, 1)].into_iter().filter(is_point)
    }

    /// The rounding of the coordinates of points, which may lie far from the origin.
    pub(super) fn grain(&self) -> f64 {
        self.length(f64::EPSILON * (1.0 + norm(&self.centre)))
    }

    /// The apex that a place is at, if it is at one.
    pub(super) fn at_apex(&self, net: usize, place: [f64; 2]) -> bool {
        self.points_of(net).any(|(axis, side)| {
            place[axis] == side as f64 && matches!(self.caps[axis][side], Edge::Apex(_))
        })
    }

    pub(super) fn index(&self, net: usize) -> [usize; 2] {
        [net / self.counts[1], net % self.counts[1]]
    }

    pub(super) fn net_at(&self, index: [usize; 2]) -> usize {
        index[0] * self.counts[1] + index[1]
    }

    /// A length of the surface from one in units.
    pub(super) fn length(&self, units: f64) -> f64 {
        shifted(units, self.unit)
    }

    /// A length in units.
    pub(super) fn in_units(&self, length: f64) -> f64 {
        shifted(length, -self.unit)
    }

    /// A point of the surface from one in units.
    pub(super) fn point(&self, point: &[f64]) -> Vec<f64> {
        let pairs = point.iter().zip(&self.centre);
        pairs.map(|(x, c)| shifted(*x + c, self.unit)).collect()
    }

    /// A point in units from one of the surface.
    pub(super) fn unplaced(&self, point: &[f64]) -> Vec<f64> {
        let pairs = point.iter().zip(&self.centre);
        pairs.map(|(x, c)| shifted(*x, -self.unit) - c).collect()
    }

    /// The piece that holds parameters of the surface, and the place in it.
    pub(super) fn locate(&self, parameters: [f64; 2]) -> (usize, [f64; 2]) {
        let mut index = [0; 2];
        let mut place = [0.0; 2];
        for axis in 0..2 {
            let breaks = &self.breaks[axis];
            let inner = &breaks[1..breaks.len() - 1];
            index[axis] = inner.iter().filter(|t| **t <= parameters[axis]).count();
            let (from, to) = (breaks[index[axis]], breaks[index[axis] + 1]);
            place[axis] = (parameters[axis] - from) / (to - from);
        }
        (self.net_at(index), place)
    }

    /// Parameters of the surface from a place in a piece.
    pub(super) fn parameters(&self, net: usize, place: [f64; 2]) -> [f64; 2] {
        let index = self.index(net);
        [0, 1].map(|axis| self.parameter(axis, index[axis], place[axis]))
    }

    /// Exact at both ends, so that neighbours agree.
    pub(super) fn parameter(&self, axis: usize, index: usize, share: f64) -> f64 {
        let (from, to) = (self.breaks[axis][index], self.breaks[axis][index + 1]);
        (1.0 - share) * from + share * to
    }

    /// Length of the window of a piece along an axis.
    pub(super) fn span(&self, net: usize, axis: usize) -> f64 {
        let index = self.index(net)[axis];
        self.breaks[axis][index + 1] - self.breaks[axis][index]
    }

    /// What lies beyond side `side` of `axis` of a piece.
    pub(super) fn beyond(&self, net: usize, axis: usize, side: usize) -> Beyond {
        let mut index = self.index(net);
        let last = self.counts[axis] - 1;
        if side == 0 && index[axis] > 0 {
            index[axis] -= 1;
            return Beyond::Piece { net: self.net_at(index), turned: false };
        }
        if side == 1 && index[axis] < last {
            index[axis] += 1;
            return Beyond::Piece { net: self.net_at(index), turned: false };
        }
        if !matches!(self.caps[axis][side], Edge::Line) {
            return Beyond::Point;
        }
        if self.seams[axis] == Seam::Open {
            return Beyond::Border;
        }
        let turned = self.seams[axis] == Seam::Twisted;
        index[axis] = last - index[axis];
        if turned {
            index[1 - axis] = self.counts[1 - axis] - 1 - index[1 - axis];
        }
        Beyond::Piece { net: self.net_at(index), turned }
    }

    /// Homogeneous poles of an edge of a piece, in the order of the other parameter.
    fn edge(&self, net: usize, axis: usize, side: usize) -> Vec<Vec<f64>> {
        let net = &self.nets[net];
        let at = if side == 0 { 0 } else { net.orders[axis] - 1 };
        (0..net.orders[1 - axis])
            .map(|k| {
                let (i, j) = if axis == 0 { (at, k) } else { (k, at) };
                (0..=net.ambient).map(|plane| net.pole(plane, i, j)).collect()
            })
            .collect()
    }

    /// The pieces along a side of the window.
    pub(super) fn along_side(&self, axis: usize, side: usize) -> Vec<usize> {
        let at = if side == 0 { 0 } else { self.counts[axis] - 1 };
        let nets = 0..self.counts[1 - axis];
        nets.map(|k| self.net_at(if axis == 0 { [at, k] } else { [k, at] })).collect()
    }

    /// The point that all poles of a side of the window are.
    fn collapsed(&self, axis: usize, side: usize) -> Option<Vec<f64>> {
        let nets = self.along_side(axis, side);
        point_of(&nets.iter().flat_map(|net| self.edge(*net, axis, side)).collect::<Vec<_>>())
    }

    fn seam(&self, axis: usize) -> Seam {
        let (low, high) = (self.along_side(axis, 0), self.along_side(axis, 1));
        let edges = |nets: &[usize], side| -> Vec<Vec<Vec<f64>>> {
            nets.iter().map(|net| self.edge(*net, axis, side)).collect()
        };
        let (low, mut high) = (edges(&low, 0), edges(&high, 1));
        if point_of(&low.concat()).is_some() {
            return Seam::Open;
        }
        if same(&low, &high) {
            return Seam::Closed;
        }
        high.reverse();
        for edge in &mut high {
            edge.reverse();
        }
        let breaks = &self.breaks[1 - axis];
        let (from, to) = (breaks[0], breaks[breaks.len() - 1]);
        let mirrored = breaks.iter().zip(breaks.iter().rev());
        let symmetric = mirrored
            .into_iter()
            .all(|(a, b)| ((a - from) - (to - b)).abs() <= ROUNDING * (to - from));
        if symmetric && same(&low, &high) { Seam::Twisted } else { Seam::Open }
    }
}

/// Are these edges, piece by piece, the same curves with the same parameter?
fn same(low: &[Vec<Vec<f64>>], high: &[Vec<Vec<f64>>]) -> bool {
    low.iter().zip(high).all(|(low, high)| {
        let weight = |pole: &[f64]| pole[pole.len() - 1];
        let heavy =
            low.iter().zip(high).max_by(|a, b| weight(a.0).abs().total_cmp(&weight(b.0).abs()));
        let factor = heavy.map_or(f64::NAN, |(a, b)| weight(a) / weight(b));
        factor.is_finite()
            && low.iter().zip(high).all(|(a, b)| {
                let close = |(x, y): (&f64, &f64)| (x - factor * y).abs() <= ROUNDING;
                a.iter().zip(b).all(close)
            })
    })
}

/// The point that all these poles are, those of weight 0 by vanishing.
fn point_of(poles: &[Vec<f64>]) -> Option<Vec<f64>> {
    let weight = |pole: &[f64]| pole[pole.len() - 1];
    let heaviest = poles.iter().max_by(|a, b| weight(a).abs().total_cmp(&weight(b).abs()))?;
    let (divisor, point) = heaviest.split_last()?;
    if *divisor == 0.0 {
        return None;
    }
    let point: Vec<f64> = point.iter().map(|x| x / divisor).collect();
    let close =
        |pole: &Vec<f64>| norm(&plus(&pole[..point.len()], -weight(pole), &point)) <= ROUNDING;
    poles.iter().all(close).then_some(point)
}

/// The middle of the poles in units of 2 to `unit`, and a unit that is about the largest distance from it;
/// `i32::MIN` when they are all in one place.
fn middle(pieces: &[Form], unit: i32) -> (Vec<f64>, i32) {
    let ambient = pieces.first().map_or(0, Form::ambient);
    let mut box_ = vec![[f64::INFINITY, f64::NEG_INFINITY]; ambient];
    let poles = || pieces.iter().flat_map(|piece| piece.homogeneous().chunks_exact(ambient + 1));
    for pole in poles().filter(|pole| is_near(pole)) {
        for (sides, x) in box_.iter_mut().zip(pole) {
            let x = shifted(*x, -unit) / pole[ambient];
            *sides = [sides[0].min(x), sides[1].max(x)];
        }
    }
    let centre: Vec<f64> = box_
        .iter()
        .map(|[low, high]| if low <= high { f64::midpoint(*low, *high) } else { 0.0 })
        .collect();
    let mut reach = 0.0_f64;
    for pole in poles().filter(|pole| is_near(pole)) {
        let weight = pole[ambient];
        let offsets = pole.iter().zip(&centre).map(|(x, c)| shifted(*x, -unit) / weight - c);
        reach = offsets.fold(reach, |most, x| most.max(x.abs()));
    }
    if reach <= ROUNDING * norm(&centre) || reach == 0.0 {
        return (centre, i32::MIN);
    }
    let finer = libm::ilogb(reach);
    (centre.iter().map(|c| shifted(*c, -finer)).collect(), unit + finer)
}

/// Weights below this of the largest belong to poles that say little about the place of the surface.
const LIGHT: f64 = 1e-3;

fn is_near(pole: &[f64]) -> bool {
    pole[pole.len() - 1].abs() >= LIGHT
}

fn seen_from(piece: &Form, centre: &[f64], unit: i32) -> Net {
    let ambient = piece.ambient();
    let uniform = piece.uniform_weight().copied();
    let mut poles = Vec::with_capacity(piece.homogeneous().len());
    for plane in 0..=ambient {
        for pole in piece.homogeneous().chunks_exact(ambient + 1) {
            let weight = pole[ambient];
            let x = if plane == ambient {
                weight
            } else {
                shifted(pole[plane], -unit) - centre[plane] * weight
            };
            poles.push(x / uniform.unwrap_or(1.0));
        }
    }
    let orders = [piece.orders()[0], piece.orders()[1]];
    Net { orders, ambient, rational: uniform.is_none(), poles }
}
