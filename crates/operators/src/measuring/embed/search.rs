//! Points that Newton's steps alone do not settle: all solutions, by the certified solver.

use pforms_kernel::Result;

use super::Embedder;
use super::cells::{restricted, slope_bounds};
use super::matrix::Between;
use crate::measuring::system::{Equations, Limits, Polynomial, Solutions, solve};
use crate::stretch_matrix;

/// Windows are searched this far beyond, so that what lies on a side is found.
const MARGIN: f64 = 1e-9;

/// Places nearer than this in windows of the cage are one.
const APART: f64 = 1e-8;

/// Boxes are no thinner, so that differences of their poles are above rounding.
const THIN: f64 = 1e-6;

/// A place that gives the point, or nearly.
struct Found {
    parameters: Vec<f64>,
    residual: f64,
}

impl Embedder {
    /// The row of a placed point.
    pub(super) fn search(&self, point: &[f64], row: &mut [f64]) -> Result<()> {
        let axes = self.cage.axes();
        self.put_outside(row);
        let Some((first, last)) = self.guide.find(point).and_then(|at| self.guide.range(at)) else {
            return Ok(());
        };
        let (mut places, mut complete, near) = (Vec::new(), true, self.near());
        for piece in 0..self.cage.pieces.len() {
            let Some(window) = self.window(piece, &first, &last) else { continue };
            let solutions = self.solutions(piece, &window, point)?;
            let local = |place: &[f64]| -> Vec<f64> {
                place.iter().zip(&window).map(|(t, (from, to))| from + t * (to - from)).collect()
            };
            let roots = solutions.roots.iter();
            places.extend(roots.map(|root| self.measured(piece, &local(&root.parameters), point)));
            for cluster in &solutions.clusters {
                let found = self.measured(piece, &local(&cluster.parameters), point);
                let (lower, upper) = (local(&cluster.lower), local(&cluster.upper));
                complete &= found.residual <= near && self.is_alone(piece, &lower, &upper, point);
                places.push(found);
            }
        }
        places.retain(|place| place.residual <= near);
        places.sort_by(|a, b| in_order(&a.parameters, &b.parameters));
        self.merge(&mut places);
        row[axes + 2] = f64::from(u8::from(complete));
        if let Some(place) = places.first() {
            row[..axes].copy_from_slice(&place.parameters);
            row[axes] = self.cage.length(place.residual);
            row[axes + 1] = places.len() as f64;
        }
        Ok(())
    }

    /// The part of a piece that the cells of a block cover, a little widened.
    fn window(&self, piece: usize, first: &[usize], last: &[usize]) -> Option<Vec<(f64, f64)>> {
        let index = self.cage.index(piece);
        let axis = |(k, own): (usize, &usize)| {
            let sides = self.guide.cells.sides[k][first[k]..=last[k]].iter();
            let mut own = sides.filter(|side| side.piece == *own);
            let lower = own.next()?;
            let upper = own.next_back().map_or(lower.upper, |side| side.upper);
            let (lower, upper) = (lower.lower.max(0.0), upper.min(1.0));
            (lower <= upper).then_some((lower - MARGIN, upper + MARGIN))
        };
        index.iter().enumerate().map(axis).collect()
    }

    /// All places in a window of a piece that give the point.
    fn solutions(&self, piece: usize, window: &[(f64, f64)], point: &[f64]) -> Result<Solutions> {
        let (cage, axes) = (&self.cage, self.cage.axes());
        let mut poles = cage.pieces[piece].clone();
        for (axis, (from, to)) in window.iter().enumerate() {
            let matrix = stretch_matrix(cage.orders[axis] - 1, from, to);
            poles = restricted(&poles, &cage.orders, axis, &matrix, cage.width);
        }
        let equation = |c: usize| {
            let coefficient =
                |pole: &[f64]| pole[c] - point[c] * pole.get(axes).copied().unwrap_or(1.0);
            Polynomial {
                orders: cage.orders.clone(),
                coefficients: poles.chunks_exact(cage.width).map(coefficient).collect(),
                noise: super::cells::MARGIN * cage.noise,
            }
        };
        let equations = Equations::new((0..axes).map(equation).collect())?;
        Ok(solve(&equations, &Limits { most: WORK, ..Limits::default() }))
    }

    /// Does at most one place of a box give the point? Its slopes say it even where the box is as thin
    /// as rounding along one axis.
    fn is_alone(&self, piece: usize, lower: &[f64], upper: &[f64], point: &[f64]) -> bool {
        let (cage, axes) = (&self.cage, self.cage.axes());
        let mut poles = cage.pieces[piece].clone();
        let mut lengths = Vec::with_capacity(axes);
        for axis in 0..axes {
            let margin = 0.1 * (upper[axis] - lower[axis]) + THIN;
            let (from, to) = (lower[axis] - margin, upper[axis] + margin);
            let matrix = stretch_matrix(cage.orders[axis] - 1, &from, &to);
            poles = restricted(&poles, &cage.orders, axis, &matrix, cage.width);
            lengths.push(to - from);
        }
        let left = |pole: &[f64]| -> Vec<f64> {
            let weight = pole.get(axes).copied().unwrap_or(1.0);
            (0..axes).map(|c| pole[c] - point[c] * weight).collect()
        };
        let poles: Vec<f64> = poles.chunks_exact(cage.width).flat_map(left).collect();
        let (mut low, mut high) = (vec![0.0; axes * axes], vec![0.0; axes * axes]);
        for (axis, length) in lengths.iter().enumerate() {
            let range = axis * axes..(axis + 1) * axes;
            let factor = (cage.orders[axis] - 1) as f64 / length;
            let (low, high) = (&mut low[range.clone()], &mut high[range]);
            slope_bounds(&poles, &cage.orders, axis, axes, factor, low, high);
            let noise = 2.0 * factor * super::cells::MARGIN * cage.noise;
            for (low, high) in low.iter_mut().zip(high) {
                *low -= noise;
                *high += noise;
            }
        }
        Between::new(&low, &high, axes).is_some_and(|slopes| slopes.is_invertible(axes))
    }

    /// A place within the window of its piece, and what is left there.
    fn measured(&self, piece: usize, at: &[f64], point: &[f64]) -> Found {
        let (cage, index) = (&self.cage, self.cage.index(piece));
        let at: Vec<f64> = at.iter().map(|t| t.clamp(0.0, 1.0)).collect();
        let mut jet = super::jet::Jet::new(cage);
        jet.at(cage, &cage.pieces[piece], &at, point);
        let left: f64 = jet.value.iter().map(|x| x.abs()).sum();
        let parameters = at.iter().enumerate().map(|(k, t)| cage.parameter(k, index[k], *t));
        Found {
            parameters: parameters.collect(),
            residual: (left + cage.noise) / cage.least_weight,
        }
    }

    /// Keeps one of those that are the same place, seen from two pieces.
    fn merge(&self, places: &mut Vec<Found>) {
        let lengths = self.cage.breaks.iter().map(|list| list[list.len() - 1] - list[0]);
        let near: Vec<f64> = lengths.map(|length| APART * length).collect();
        let same = |a: &Found, b: &Found| {
            let pairs = a.parameters.iter().zip(&b.parameters).zip(&near);
            pairs.into_iter().all(|((x, y), near)| (x - y).abs() <= *near)
        };
        let mut kept: Vec<Found> = Vec::with_capacity(places.len());
        for place in places.drain(..) {
            if !kept.iter().any(|other| same(other, &place)) {
                kept.push(place);
            }
        }
        *places = kept;
    }
}

/// Cells looked at for one point and piece.
const WORK: usize = 1 << 11;

fn in_order(a: &[f64], b: &[f64]) -> std::cmp::Ordering {
    let pairs = a.iter().zip(b).map(|(x, y)| x.total_cmp(y));
    pairs.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
}
