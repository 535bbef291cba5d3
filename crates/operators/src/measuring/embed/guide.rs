//! Where to begin: a grid over the space of the cage, that knows which cells may hold a point.

use std::sync::OnceLock;

use super::cage::Cage;
use super::cells::{Cells, slope_bounds};
use super::jet::Jet;
use super::matrix::{Between, inverse};

/// What is known of the points in a box of the grid.
pub(super) enum Place {
    /// None of them is in the cage: proved.
    Outside,
    /// At most one parameter of the cells, ring included, gives each of them: proved. The way to it
    /// begins here.
    Single(Start),
    /// Nothing.
    Unknown,
}

/// A piece and a linear map from points to its parameters: four axes at most.
pub(super) struct Start {
    /// Number of the piece.
    pub piece: usize,
    origin: [f64; 4],
    inverse: [[f64; 4]; 4],
}

impl Start {
    /// Parameters near those of a point.
    pub(super) fn guess<const D: usize>(&self, point: &[f64; D]) -> [f64; D] {
        let mut at = [0.0; D];
        for (k, t) in at.iter_mut().enumerate() {
            *t = self.origin[k];
            for (c, x) in point.iter().enumerate() {
                *t += self.inverse[k][c] * x;
            }
        }
        at
    }
}

/// The grid.
pub(super) struct Guide {
    pub cells: Cells,
    lower: Vec<f64>,
    steps: Vec<f64>,
    /// Their inverses.
    rates: Vec<f64>,
    counts: Vec<usize>,
    /// For each box the first and the last cell that meet it, along each axis; first above last
    /// where none does.
    ranges: Vec<u16>,
    places: Vec<OnceLock<Place>>,
}

/// Boxes of the grid, about, by number of axes.
const BOXES: [usize; 4] = [256, 40, 12, 5];

/// Boxes along an axis for a cage of many pieces, at most.
const MOST: usize = 40;

impl Guide {
    /// `None` when there would be too many cells.
    pub(super) fn new(cage: &Cage, cuts: &[usize]) -> Option<Self> {
        let axes = cage.axes();
        let ringed = Cells::new(cage, cuts, true)?;
        let bounded = ringed.boxes.iter().all(|x| x.is_finite());
        let (cells, ring) = if bounded { (ringed, 1) } else { (Cells::new(cage, cuts, false)?, 0) };
        let mut guide = Self {
            lower: vec![f64::INFINITY; axes],
            steps: vec![0.0; axes],
            rates: vec![0.0; axes],
            counts: cells.counts().iter().map(|n| BOXES[axes - 1].max((*n).min(MOST))).collect(),
            ranges: Vec::new(),
            places: Vec::new(),
            cells,
        };
        guide.enclose(ring);
        guide.fill();
        Some(guide)
    }

    /// The grid covers the cells of the window.
    fn enclose(&mut self, ring: usize) {
        let axes = self.counts.len();
        let mut upper = vec![f64::NEG_INFINITY; axes];
        let (first, last) = (vec![ring; axes], self.cells.counts());
        let last: Vec<usize> = last.iter().map(|count| count - 1 - ring).collect();
        let (lower, boxes) = (&mut self.lower, &self.cells.boxes);
        self.cells.each_in(&first, &last, |cell| {
            let sides = &boxes[cell * 2 * axes..][..2 * axes];
            for k in 0..axes {
                lower[k] = lower[k].min(sides[k]);
                upper[k] = upper[k].max(sides[axes + k]);
            }
        });
        for (k, upper) in upper.iter().enumerate() {
            self.steps[k] = ((upper - self.lower[k]) / self.counts[k] as f64).max(1e-300);
            self.rates[k] = 1.0 / self.steps[k];
        }
    }

    /// Which cells meet which boxes.
    fn fill(&mut self) {
        let axes = self.counts.len();
        let total: usize = self.counts.iter().product();
        self.ranges = [vec![u16::MAX; axes], vec![0; axes]].concat().repeat(total);
        self.places.resize_with(total, OnceLock::new);
        let counts = self.cells.counts();
        let mut index = vec![0; axes];
        for cell in 0..counts.iter().product() {
            let mut rest: usize = cell;
            for (i, count) in index.iter_mut().zip(&counts).rev() {
                *i = rest % count;
                rest /= count;
            }
            let sides = &self.cells.boxes[cell * 2 * axes..][..2 * axes];
            let at = |x: f64, k: usize| ((x - self.lower[k]) * self.rates[k]).floor();
            let meets = |k: &usize| {
                at(sides[axes + k], *k) >= -1.0 && at(sides[*k], *k) <= self.counts[*k] as f64
            };
            if !(0..axes).all(|k| meets(&k)) {
                continue;
            }
            // One box more on each side, for rounding.
            let first: Vec<usize> = (0..axes)
                .map(|k| (at(sides[k] - 1e-9 * self.steps[k], k)).max(0.0) as usize)
                .collect();
            let last: Vec<usize> = (0..axes)
                .map(|k| (at(sides[axes + k] + 1e-9 * self.steps[k], k)).max(0.0) as usize)
                .zip(&self.counts)
                .map(|(i, count)| i.min(count - 1))
                .collect();
            if first.iter().zip(&last).any(|(first, last)| first > last) {
                continue;
            }
            let mut at = first.clone();
            loop {
                let place = at.iter().zip(&self.counts).fold(0, |flat, (i, n)| flat * n + i);
                let range = &mut self.ranges[place * 2 * axes..][..2 * axes];
                for (k, i) in index.iter().enumerate() {
                    range[k] = range[k].min(*i as u16);
                    range[axes + k] = range[axes + k].max(*i as u16);
                }
                let Some(axis) = (0..axes).rfind(|k| at[*k] < last[*k]) else { break };
                at[axis] += 1;
                at[axis + 1..].copy_from_slice(&first[axis + 1..]);
            }
        }
    }

    /// The box of a point; `None` for those beyond the grid.
    pub(super) fn find(&self, point: &[f64]) -> Option<usize> {
        let (mut place, mut is_within) = (0, true);
        let sides = self.lower.iter().zip(&self.rates).zip(&self.counts);
        for (x, ((low, rate), count)) in point.iter().zip(sides) {
            let at = (x - low) * rate;
            is_within &= at >= 0.0 && at <= *count as f64;
            place = place * count + (at as usize).min(count - 1);
        }
        is_within.then_some(place)
    }

    /// The point of the grid nearest to one.
    pub(super) fn within(&self, point: &[f64]) -> Vec<f64> {
        let sides = point.iter().zip(&self.lower).zip(self.steps.iter().zip(&self.counts));
        sides.map(|((x, low), (step, count))| x.clamp(*low, low + step * *count as f64)).collect()
    }

    /// The box that holds it, or one beside it.
    pub(super) fn nearest(&self, point: &[f64]) -> usize {
        let sides = point.iter().zip(&self.lower).zip(self.steps.iter().zip(&self.counts));
        sides.fold(0, |place, ((x, low), (step, count))| {
            let at = ((x - low) / step).max(0.0) as usize;
            place * count + at.min(count - 1)
        })
    }

    /// The largest coordinate of a point of the grid.
    pub(super) fn size(&self) -> f64 {
        let sides = self.lower.iter().zip(self.steps.iter().zip(&self.counts));
        let most =
            sides.map(|(low, (step, count))| low.abs().max((low + step * *count as f64).abs()));
        most.fold(0.0, f64::max)
    }

    /// The first and the last cells that may hold a point of a box.
    pub(super) fn range(&self, place: usize) -> Option<(Vec<usize>, Vec<usize>)> {
        let axes = self.counts.len();
        let range = &self.ranges[place * 2 * axes..][..2 * axes];
        let indices = |part: &[u16]| part.iter().map(|i| usize::from(*i)).collect::<Vec<_>>();
        (range[0] <= range[axes]).then(|| (indices(&range[..axes]), indices(&range[axes..])))
    }

    /// What is known of the points in a box, found out when it is first asked.
    pub(super) fn place(&self, cage: &Cage, place: usize) -> &Place {
        self.places[place].get_or_init(|| self.explored(cage, place))
    }

    fn explored(&self, cage: &Cage, place: usize) -> Place {
        let Some((first, last)) = self.range(place) else { return Place::Outside };
        let Some((lower, upper)) = self.corners(place) else { return Place::Unknown };
        if cage.parted || !self.is_single(cage, (&first, &last), (&lower, &upper)) {
            return Place::Unknown;
        }
        let centre: Vec<f64> = lower.iter().zip(&upper).map(|(a, b)| 0.5 * (a + b)).collect();
        match self.start(cage, &first, &last, &centre) {
            Some(start) => Place::Single(start),
            None => Place::Unknown,
        }
    }

    /// The corners of a box.
    fn corners(&self, place: usize) -> Option<(Vec<f64>, Vec<f64>)> {
        let mut rest = place;
        let mut corners = (self.lower.clone(), self.lower.clone());
        for k in (0..self.counts.len()).rev() {
            let i = rest % self.counts[k];
            rest /= self.counts[k];
            corners.0[k] += (i as f64 - 1e-6) * self.steps[k];
            corners.1[k] += (i as f64 + 1.0 + 1e-6) * self.steps[k];
        }
        corners.0.iter().chain(&corners.1).all(|x| x.is_finite()).then_some(corners)
    }

    /// Does no point of the box come from two parameters of the block?
    fn is_single(
        &self,
        cage: &Cage,
        block: (&[usize], &[usize]),
        corners: (&[f64], &[f64]),
    ) -> bool {
        let axes = cage.axes();
        let (mut low, mut high) = self.cells.slopes_over(block.0, block.1);
        if cage.is_rational() {
            (low, high) = less_weights(&low, &high, corners, axes);
        }
        Between::new(&low, &high, axes).is_some_and(|slopes| slopes.is_invertible(axes))
    }

    /// Two of Newton's steps from the middle of a block towards the middle of a box.
    fn start(&self, cage: &Cage, first: &[usize], last: &[usize], centre: &[f64]) -> Option<Start> {
        let axes = cage.axes();
        let mut index = vec![0; axes];
        let mut at = vec![0.0; axes];
        for k in 0..axes {
            let side = &self.cells.sides[k][usize::midpoint(first[k], last[k])];
            index[k] = side.piece;
            let odd = (first[k] + last[k]) % 2 == 1;
            at[k] = if odd { side.upper } else { 0.5 * (side.lower + side.upper) };
        }
        let piece = cage.number(&index);
        let mut jet = Jet::new(cage);
        let mut slopes = Vec::new();
        for step in 0..2 {
            jet.at(cage, &cage.pieces[piece], &at, centre);
            slopes = inverse(&jet.slopes, axes)?;
            if step == 0 {
                for k in 0..axes {
                    let row = &slopes[k * axes..][..axes];
                    let by: f64 = row.iter().zip(&jet.value).map(|(a, g)| a * g).sum();
                    at[k] = (at[k] - by).clamp(-1.0, 2.0);
                }
            }
        }
        // At the centre c the value is g and the slopes J: a point x has g + J·(t − at) = (x − c)·w.
        let mut start = Start { piece, origin: [0.0; 4], inverse: [[0.0; 4]; 4] };
        for k in 0..axes {
            let row = &mut slopes[k * axes..][..axes];
            let by: f64 = row.iter().zip(&jet.value).map(|(a, g)| a * g).sum();
            for a in row.iter_mut() {
                *a *= jet.weight;
            }
            let to: f64 = row.iter().zip(centre).map(|(a, x)| a * x).sum();
            start.origin[k] = at[k] - by - to;
            start.inverse[k][..axes].copy_from_slice(row);
        }
        let fine = start.origin.iter().chain(start.inverse.as_flattened()).all(|x| x.is_finite());
        fine.then_some(start)
    }
}

/// Bounds of `∂X − x·∂W` for points `x` in a box, from those of `∂X` and `∂W`.
fn less_weights(
    low: &[f64],
    high: &[f64],
    corners: (&[f64], &[f64]),
    axes: usize,
) -> (Vec<f64>, Vec<f64>) {
    let mut bounds = (Vec::with_capacity(axes * axes), Vec::with_capacity(axes * axes));
    for (low, high) in low.chunks_exact(axes + 1).zip(high.chunks_exact(axes + 1)) {
        for c in 0..axes {
            let ends = [corners.0[c], corners.1[c]];
            let terms = ends.map(|x| [x * low[axes], x * high[axes]]).concat();
            let least = terms.iter().fold(f64::INFINITY, |a, b| a.min(*b));
            let most = terms.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b));
            bounds.0.push(low[c] - most);
            bounds.1.push(high[c] - least);
        }
    }
    bounds
}

/// Bounds for Newton's steps in a piece and a ring around it, per unit of its parameters.
pub(super) struct Reach {
    /// How far beyond the window they hold.
    pub ring: f64,
    /// Of a derivative along each axis, in any coordinate, for points of the cage's box.
    pub slopes: Vec<f64>,
    /// Of all second derivatives.
    pub bend: f64,
}

impl Reach {
    /// Bounds over the window and `ring` beyond, for points no coordinate of which exceeds `size`.
    pub(super) fn new(cage: &Cage, poles: &[f64], ring: f64, size: f64) -> Self {
        let axes = cage.axes();
        let mut wide = poles.to_vec();
        for (axis, order) in cage.orders.iter().enumerate() {
            let matrix = crate::stretch_matrix(order - 1, &-ring, &(1.0 + ring));
            wide = super::cells::restricted(&wide, &cage.orders, axis, &matrix, cage.width);
        }
        let length = 1.0 + 2.0 * ring;
        let most = |poles: &[f64], orders: &[usize], axis: usize| -> f64 {
            let (mut low, mut high) = (vec![0.0; cage.width], vec![0.0; cage.width]);
            let factor = (orders[axis] - 1) as f64 / length;
            slope_bounds(poles, orders, axis, cage.width, factor, &mut low, &mut high);
            let bound = |c: usize| low[c].abs().max(high[c].abs());
            let weight = if cage.is_rational() { size * bound(axes) } else { 0.0 };
            (0..axes).map(|c| bound(c) + weight).fold(0.0, f64::max)
        };
        let slopes = (0..axes).map(|axis| most(&wide, &cage.orders, axis)).collect();
        let mut bend = 0.0_f64;
        for axis in 0..axes {
            let (differences, orders) = differences(&wide, &cage.orders, axis, cage.width, length);
            for other in axis..axes {
                if orders[other] > 1 {
                    bend = bend.max(most(&differences, &orders, other));
                }
            }
        }
        // Rounding of the poles themselves.
        Self { ring, slopes, bend: bend * (1.0 + 1e-9) }
    }
}

/// The derivative along `axis`, its poles and orders.
fn differences(
    poles: &[f64],
    orders: &[usize],
    axis: usize,
    width: usize,
    length: f64,
) -> (Vec<f64>, Vec<usize>) {
    let inner = orders[axis + 1..].iter().product::<usize>() * width;
    let factor = (orders[axis] - 1) as f64 / length;
    let mut result = Vec::with_capacity(poles.len());
    for block in poles.chunks_exact(inner * orders[axis]) {
        let pairs = block.iter().zip(&block[inner..]);
        result.extend(pairs.map(|(from, to)| factor * (to - from)));
    }
    let mut orders = orders.to_vec();
    orders[axis] -= 1;
    (result, orders)
}
