//! The window of a cage in cells: where each may lie, and how the cage may slope there.

use pforms_kernel::{Matrix, limit};

use super::cage::Cage;
use crate::stretch_matrix;

/// One of the intervals that an axis is cut into.
pub(super) struct Side {
    /// The piece of the cage, along this axis.
    pub piece: usize,
    /// Where it begins, as the piece counts.
    pub lower: f64,
    /// Where it ends.
    pub upper: f64,
    matrix: Matrix<f64>,
}

/// Boxes and slopes of all cells, the last axis fastest.
pub(super) struct Cells {
    /// The intervals along each axis; with a ring the outermost lie beyond the window.
    pub sides: Vec<Vec<Side>>,
    /// For each cell the least and then the largest coordinates.
    pub boxes: Vec<f64>,
    /// For each cell the least and then the largest derivatives of the homogeneous coordinates
    /// along each axis, in windows of the cage.
    slopes: Vec<f64>,
    slope_width: usize,
}

/// Cells at most.
const MOST: usize = 1 << 15;

impl Cells {
    /// `cuts` cells along each axis of a piece, and a ring of them around the window on request.
    pub(super) fn new(cage: &Cage, cuts: &[usize], ring: bool) -> Option<Self> {
        let sides: Vec<Vec<Side>> =
            (0..cage.axes()).map(|axis| sides(cage, axis, cuts[axis], ring)).collect();
        let counts: Vec<usize> = sides.iter().map(Vec::len).collect();
        let count = counts.iter().try_fold(1_usize, |all, n| all.checked_mul(*n))?;
        if count > MOST.max(cage.pieces.len() * 8) || limit::check::<f64>("", &counts, 64).is_err()
        {
            return None;
        }
        let axes = cage.axes();
        let slope_width = 2 * axes * cage.width;
        let mut cells = Self {
            sides,
            boxes: vec![0.0; count * 2 * axes],
            slopes: vec![0.0; count * slope_width],
            slope_width,
        };
        for (number, poles) in cage.pieces.iter().enumerate() {
            let index = cage.index(number);
            cells.fill(cage, &index, 0, poles, 0);
        }
        Some(cells)
    }

    /// Number of cells along each axis.
    pub(super) fn counts(&self) -> Vec<usize> {
        self.sides.iter().map(Vec::len).collect()
    }

    /// Cuts a piece along `axis` and the later ones; `cell` numbers those along the earlier.
    fn fill(&mut self, cage: &Cage, piece: &[usize], axis: usize, poles: &[f64], cell: usize) {
        if axis == cage.axes() {
            return self.measure(cage, piece, poles, cell);
        }
        let sides = &self.sides[axis];
        let count = sides.len();
        let own: Vec<usize> = (0..count).filter(|i| sides[*i].piece == piece[axis]).collect();
        for i in own {
            let part =
                restricted(poles, &cage.orders, axis, &self.sides[axis][i].matrix, cage.width);
            self.fill(cage, piece, axis + 1, &part, cell * count + i);
        }
    }

    /// Bounds of a cell from its poles.
    fn measure(&mut self, cage: &Cage, piece: &[usize], poles: &[f64], cell: usize) {
        let axes = cage.axes();
        let (lower, upper) = self.boxes[cell * 2 * axes..][..2 * axes].split_at_mut(axes);
        bounds(poles, cage, lower, upper);
        let mut index = cell;
        let mut place = vec![0; axes];
        for (i, sides) in place.iter_mut().zip(&self.sides).rev() {
            *i = index % sides.len();
            index /= sides.len();
        }
        let slopes = &mut self.slopes[cell * self.slope_width..][..self.slope_width];
        let (low, high) = slopes.split_at_mut(axes * cage.width);
        for axis in 0..axes {
            let side = &self.sides[axis][place[axis]];
            let length = (side.upper - side.lower) * cage.share(axis, piece[axis]);
            let factor = (cage.orders[axis] - 1) as f64 / length;
            let range = axis * cage.width..(axis + 1) * cage.width;
            let (low, high) = (&mut low[range.clone()], &mut high[range]);
            slope_bounds(poles, &cage.orders, axis, cage.width, factor, low, high);
        }
    }

    /// Least and largest derivatives over a block of cells, `[axis][coordinate]`.
    pub(super) fn slopes_over(&self, first: &[usize], last: &[usize]) -> (Vec<f64>, Vec<f64>) {
        let half = self.slope_width / 2;
        let mut found = (vec![f64::INFINITY; half], vec![f64::NEG_INFINITY; half]);
        self.each_in(first, last, |cell| {
            let (low, high) = self.slopes[cell * self.slope_width..][..2 * half].split_at(half);
            for k in 0..half {
                found.0[k] = found.0[k].min(low[k]);
                found.1[k] = found.1[k].max(high[k]);
            }
        });
        found
    }

    /// Calls `visit` with every cell of a block.
    pub(super) fn each_in(&self, first: &[usize], last: &[usize], mut visit: impl FnMut(usize)) {
        let mut index = first.to_vec();
        loop {
            let sides = index.iter().zip(&self.sides);
            visit(sides.fold(0, |cell, (i, sides)| cell * sides.len() + i));
            let Some(axis) = (0..index.len()).rfind(|k| index[*k] < last[*k]) else { return };
            index[axis] += 1;
            index[axis + 1..].copy_from_slice(&first[axis + 1..]);
        }
    }
}

fn sides(cage: &Cage, axis: usize, cuts: usize, ring: bool) -> Vec<Side> {
    let degree = cage.orders[axis] - 1;
    let step = 1.0 / cuts as f64;
    let side = |piece, lower: f64, upper: f64| Side {
        piece,
        lower,
        upper,
        matrix: stretch_matrix(degree, &lower, &upper),
    };
    let last = cage.counts[axis] - 1;
    let mut all = Vec::new();
    all.extend(ring.then(|| side(0, -step, 0.0)));
    for piece in 0..=last {
        for i in 0..cuts {
            let upper = if i + 1 == cuts { 1.0 } else { (i + 1) as f64 * step };
            all.push(side(piece, i as f64 * step, upper));
        }
    }
    all.extend(ring.then(|| side(last, 1.0, 1.0 + step)));
    all
}

/// The poles over a part of the window along `axis`.
pub(super) fn restricted(
    poles: &[f64],
    orders: &[usize],
    axis: usize,
    matrix: &Matrix<f64>,
    width: usize,
) -> Vec<f64> {
    let inner = orders[axis + 1..].iter().product::<usize>() * width;
    let mut result = vec![0.0; poles.len()];
    let blocks = poles.chunks_exact(inner * orders[axis]);
    for (block, out) in blocks.zip(result.chunks_exact_mut(inner * orders[axis])) {
        for (i, line) in out.chunks_exact_mut(inner).enumerate() {
            for (factor, from) in matrix.row(i).iter().zip(block.chunks_exact(inner)) {
                for (sum, x) in line.iter_mut().zip(from) {
                    *sum += factor * x;
                }
            }
        }
    }
    result
}

/// A box around the points with these poles, rounding included: the whole space unless all weights
/// are positive.
fn bounds(poles: &[f64], cage: &Cage, lower: &mut [f64], upper: &mut [f64]) {
    let axes = cage.axes();
    lower.fill(f64::INFINITY);
    upper.fill(f64::NEG_INFINITY);
    for pole in poles.chunks_exact(cage.width) {
        let weight = pole.get(axes).copied().unwrap_or(1.0);
        for k in 0..axes {
            let x = pole[k] / weight;
            lower[k] = lower[k].min(x);
            upper[k] = upper[k].max(x);
        }
        if weight.is_nan() || weight <= 0.0 {
            lower.fill(f64::NEG_INFINITY);
            upper.fill(f64::INFINITY);
            return;
        }
    }
    let margin = MARGIN * cage.noise;
    for (low, high) in lower.iter_mut().zip(upper) {
        *low -= margin;
        *high += margin;
    }
}

/// Rounding of poles cut out, in units of that of points.
pub(super) const MARGIN: f64 = 64.0;

/// The least and the largest derivative along `axis` in each homogeneous coordinate.
pub(super) fn slope_bounds(
    poles: &[f64],
    orders: &[usize],
    axis: usize,
    width: usize,
    factor: f64,
    low: &mut [f64],
    high: &mut [f64],
) {
    let inner = orders[axis + 1..].iter().product::<usize>() * width;
    low.fill(f64::INFINITY);
    high.fill(f64::NEG_INFINITY);
    for block in poles.chunks_exact(inner * orders[axis]) {
        for (from, to) in block.chunks_exact(inner).zip(block[inner..].chunks_exact(inner)) {
            for (from, to) in from.chunks_exact(width).zip(to.chunks_exact(width)) {
                for c in 0..width {
                    let slope = factor * (to[c] - from[c]);
                    low[c] = low[c].min(slope);
                    high[c] = high[c].max(slope);
                }
            }
        }
    }
}
