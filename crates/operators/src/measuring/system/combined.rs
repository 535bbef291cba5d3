//! The equations of a cell, combined so that each is nearly one unknown and a constant.

use super::cell::{Cell, largest_step, range};
use super::linear::left_inverse;
use super::{Each, Equations, MOST_UNKNOWNS};

/// `G = M·F` over a cell, in its own units, `M` the inverse of the mean slopes: `G_k = u_k + E_k`.
pub(super) struct Combined {
    axes: usize,
    orders: Vec<usize>,
    count: usize,
    /// `M`, in units of the cell: `axes × number`.
    pub matrix: Vec<f64>,
    /// `E`, the left-over: coefficients, one unknown after another.
    rest: Vec<f64>,
    /// Noise of the coefficients of each `G_k`, tolerances included.
    noise: Each,
    /// The same, and what changes beyond the border of the window.
    slack: Each,
    /// Largest coefficient of each `G_k`.
    size: Each,
    /// How far beyond its ends the cell is taken to reach, along each axis.
    reach: [[f64; 2]; MOST_UNKNOWNS],
    /// Does some `G_k` keep one sign?
    free: bool,
}

/// A cell is called noise when no combined equation exceeds this many times its own.
const NOISE: f64 = 8.0;

/// Cells are taken to be larger by this part of their sides when a map is shown to contract, so
/// that a solution on the border has room for its ball.
pub(super) const MARGIN: f64 = 1.0 / 256.0;

/// A cell is not narrowed at once to less than this part of a side.
const LEAST: f64 = 1.0 / 256.0;

impl Combined {
    pub(super) fn new(equations: &Equations) -> Self {
        Self {
            axes: equations.axes(),
            orders: equations.orders().to_vec(),
            count: equations.count(),
            matrix: Vec::new(),
            rest: vec![0.0; equations.count() * equations.axes()],
            noise: [0.0; MOST_UNKNOWNS],
            slack: [0.0; MOST_UNKNOWNS],
            size: [0.0; MOST_UNKNOWNS],
            reach: [[0.0; 2]; MOST_UNKNOWNS],
            free: false,
        }
    }

    /// Combines the equations over a cell.
    pub(super) fn prepare(&mut self, equations: &Equations, cell: &Cell) {
        let slopes: Vec<Each> = cell.each().map(|values| self.mean_slopes(values)).collect();
        left_inverse(&slopes, self.axes, &mut self.matrix);
        let number = equations.number();
        let tolerance = equations.tolerance();
        self.free = false;
        for (axis, reach) in self.reach.iter_mut().enumerate().take(self.axes) {
            *reach = cell.reach(axis);
        }
        for k in 0..self.axes {
            let row = &self.matrix[k * number..(k + 1) * number];
            let rest = &mut self.rest[k * self.count..(k + 1) * self.count];
            rest.fill(0.0);
            let (mut noise, mut border, mut terms) = (0.0, 0.0, 0.0);
            for (i, (factor, values)) in row.iter().zip(cell.each()).enumerate() {
                for (sum, x) in rest.iter_mut().zip(values) {
                    *sum += factor * x;
                }
                let (low, high) = range(values);
                noise += factor.abs() * (cell.noise[i] + tolerance[i]);
                border += factor.abs() * (cell.slack[i] - cell.noise[i]);
                terms += factor.abs() * high.max(-low);
            }
            // Rounding of the sums, and of what is subtracted below.
            noise += f64::EPSILON * (number as f64 * terms + 2.0);
            let (low, high) = range(rest);
            let slack = noise + border;
            self.free |= low > slack || high < -slack;
            (self.noise[k], self.slack[k]) = (noise, slack);
            self.size[k] = high.max(-low);
            subtract_unknown(rest, &self.orders, k);
        }
    }

    /// The mean of the derivatives over the cell: the difference of the means over opposite faces.
    fn mean_slopes(&self, values: &[f64]) -> Each {
        let mut slopes = [0.0; MOST_UNKNOWNS];
        let mut inner = self.count;
        for (axis, order) in self.orders.iter().enumerate() {
            inner /= order;
            let difference: f64 = values
                .chunks_exact(inner * order)
                .map(|block| {
                    let last: f64 = block[inner * (order - 1)..].iter().sum();
                    last - block[..inner].iter().sum::<f64>()
                })
                .sum();
            slopes[axis] = difference * *order as f64 / self.count as f64;
        }
        slopes
    }

    /// Where in the cell solutions can be, in its units: `u_k = −E_k` lies in the range of `−E_k`.
    /// None if nowhere.
    pub(super) fn solutions_within(&self) -> Option<[(f64, f64); MOST_UNKNOWNS]> {
        if self.free {
            return None;
        }
        let mut within = [(0.0, 1.0); MOST_UNKNOWNS];
        for (k, rest) in self.rest.chunks_exact(self.count).enumerate() {
            let (low, high) = range(rest);
            let (from, to) = (-high - self.slack[k], -low + self.slack[k]);
            if from > 1.0 + self.reach[k][1] || to < -self.reach[k][0] {
                return None;
            }
            // A comparison with what is not a number is false, and leaves the cell as it is.
            let from = if from > 0.0 { from.min(1.0) } else { 0.0 };
            let to = if to < 1.0 { to.max(0.0) } else { 1.0 };
            // Not so narrow that a solution on its border would leave no room for a proof.
            let slack = (0.5 * (LEAST - (to - from))).max(8.0 * f64::EPSILON);
            let (from, to) = ((from - slack).max(0.0), (to + slack).min(1.0));
            within[k] = (from, to);
        }
        Some(within)
    }

    /// A Lipschitz constant of `u ↦ u − G(u)` over the cell and a margin around it, for the largest
    /// coordinate: below 1 there is at most one solution there.
    pub(super) fn contraction(&self) -> f64 {
        let degrees: i32 = self.orders.iter().map(|order| *order as i32 - 1).sum();
        // Coefficients over the larger cell are sums of those over the cell with weights that add
        // up, in absolute value, to this.
        let margin = (1.0 + 2.0 * MARGIN).powi(degrees);
        let sums = self.rest.chunks_exact(self.count).zip(&self.noise).map(|(rest, noise)| {
            let slopes = (0..self.axes).map(|axis| {
                let degree = (self.orders[axis] - 1) as f64;
                degree * (largest_step(rest, &self.orders, axis) + 2.0 * noise)
            });
            slopes.sum::<f64>()
        });
        let most = sums.fold(0.0_f64, |most, x| if x <= most { most } else { x });
        margin * most
    }

    /// Is a combination of the equations that counts for one unknown nothing but noise?
    pub(super) fn is_noise(&self) -> bool {
        (0..self.axes).any(|k| self.size[k] <= NOISE * self.noise[k])
    }

    /// The axis along which halving helps most: along which the left-over varies most, of sides that
    /// are not much shorter than others.
    pub(super) fn axis_to_cut(&self, cell: &Cell) -> usize {
        let longest = cell.width();
        let mut best = (0, -1.0);
        for axis in 0..self.axes {
            let side = cell.side(axis) / longest;
            if side > 0.25 && side > best.1 {
                best = (axis, side);
            }
        }
        best.0
    }
}

/// Takes the linear function `u_axis` away: its coefficients are `i / degree`.
fn subtract_unknown(rest: &mut [f64], orders: &[usize], axis: usize) {
    let inner: usize = orders[axis + 1..].iter().product();
    let degree = (orders[axis] - 1) as f64;
    for block in rest.chunks_exact_mut(inner * orders[axis]) {
        for (i, line) in block.chunks_exact_mut(inner).enumerate() {
            let share = i as f64 / degree;
            for x in line {
                *x -= share;
            }
        }
    }
}
