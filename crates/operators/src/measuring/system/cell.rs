//! A part of the window, with the equations over it.

use super::{Each, Equations, MOST_UNKNOWNS};

/// Where a side is cut.
const CUT: f64 = 15.0 / 32.0;

/// A box of parameters, and the equations in Bernstein form over it.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    pub lower: Each,
    pub upper: Each,
    pub values: Vec<f64>,
    /// No coefficient of an equation is wrong by more.
    pub noise: Vec<f64>,
    /// The noise, and what an equation may change between the cell and where the window is looked at
    /// beyond its border.
    pub slack: Vec<f64>,
    /// How far beyond its lower and its upper ends the cell reaches: those on the window's border.
    beyond: [Each; 2],
    axes: usize,
    orders: [usize; MOST_UNKNOWNS],
}

impl Cell {
    /// The window, with so much more beyond its border.
    pub(super) fn whole(equations: &Equations, border: f64) -> Self {
        let axes = equations.axes();
        let mut orders = [1; MOST_UNKNOWNS];
        orders[..axes].copy_from_slice(equations.orders());
        let mut cell = Self {
            lower: [0.0; MOST_UNKNOWNS],
            upper: [1.0; MOST_UNKNOWNS],
            values: equations.coefficients().to_vec(),
            noise: equations.noise().to_vec(),
            slack: equations.noise().to_vec(),
            beyond: [[border; MOST_UNKNOWNS]; 2],
            axes,
            orders,
        };
        cell.note_border();
        cell
    }

    /// Does an equation keep one sign over the cell, by more than its noise and tolerance?
    pub(super) fn is_free(&self, equations: &Equations) -> bool {
        let slack = self.slack.iter().zip(equations.tolerance()).map(|(a, b)| a + b);
        self.each().zip(slack).any(|(values, slack)| {
            let (low, high) = range(values);
            low > slack || high < -slack
        })
    }

    /// The coefficients of each equation.
    pub(super) fn each(&self) -> std::slice::ChunksExact<'_, f64> {
        self.values.chunks_exact(self.values.len() / self.noise.len())
    }

    pub(super) fn width(&self) -> f64 {
        (0..self.axes).map(|axis| self.side(axis)).fold(0.0, f64::max)
    }

    pub(super) fn side(&self, axis: usize) -> f64 {
        self.upper[axis] - self.lower[axis]
    }

    /// How far it reaches beyond the ends of a side, in units of the side.
    pub(super) fn reach(&self, axis: usize) -> [f64; 2] {
        self.beyond.map(|end| end[axis] / self.side(axis))
    }

    /// Bounds of the equations beyond the border, from their slopes.
    fn note_border(&mut self) {
        self.slack.clone_from(&self.noise);
        let count = self.values.len() / self.noise.len();
        for axis in 0..self.axes {
            let [low, high] = self.reach(axis);
            let reach = low.max(high);
            if reach == 0.0 {
                continue;
            }
            let degree = (self.orders[axis] - 1) as f64;
            for (slack, values) in self.slack.iter_mut().zip(self.values.chunks_exact(count)) {
                let step = largest_step(values, &self.orders[..self.axes], axis);
                // Slopes grow by less than this, so little beyond the border.
                *slack += 1.5 * reach * degree * step;
            }
        }
    }

    /// Its corners.
    pub(super) fn bounds(&self) -> (Vec<f64>, Vec<f64>) {
        let inside =
            |corner: &Each| corner[..self.axes].iter().map(|t| t.clamp(0.0, 1.0)).collect();
        (inside(&self.lower), inside(&self.upper))
    }

    /// Narrows one side to a part of it, in units of the side.
    pub(super) fn restrict(&mut self, axis: usize, from: f64, to: f64) {
        let passes = f64::from(u8::from(from != 0.0)) + f64::from(u8::from(to != 1.0));
        self.note_rounding(axis, 1.5 * passes);
        let low = if to == 1.0 { from } else { from / to };
        self.lines(axis, |line, order, inner| {
            if to != 1.0 {
                keep_left(line, order, inner, to);
            }
            if low != 0.0 {
                keep_right(line, order, inner, low);
            }
        });
        let (start, side) = (self.lower[axis], self.side(axis));
        self.lower[axis] = start + from * side;
        self.upper[axis] = start + to * side;
        for (end, inner) in self.beyond.iter_mut().zip([from != 0.0, to != 1.0]) {
            if inner {
                end[axis] = 0.0;
            }
        }
        self.note_border();
    }

    /// Two parts along an axis, not quite halves: what is symmetric has solutions in the middle, and
    /// those on the border of a cell are the hardest to prove.
    pub(super) fn parts(mut self, axis: usize) -> (Self, Self) {
        self.note_rounding(axis, 1.0);
        let mut high = self.clone();
        (self.beyond[1][axis], high.beyond[0][axis]) = (0.0, 0.0);
        let middle = self.lower[axis] + CUT * self.side(axis);
        (self.upper[axis], high.lower[axis]) = (middle, middle);
        self.lines(axis, |line, order, inner| keep_left(line, order, inner, CUT));
        high.lines(axis, |line, order, inner| keep_right(line, order, inner, CUT));
        self.note_border();
        high.note_border();
        (self, high)
    }

    /// As many means as the degree, each with so many roundings of what it averages.
    fn note_rounding(&mut self, axis: usize, each: f64) {
        let factor = each * f64::EPSILON * (self.orders[axis] - 1) as f64;
        let count = self.values.len() / self.noise.len();
        for (noise, values) in self.noise.iter_mut().zip(self.values.chunks_exact(count)) {
            let (low, high) = range(values);
            *noise += factor * high.max(-low);
        }
    }

    /// Applies `change(block, order, inner)` to blocks of lines along an axis.
    fn lines(&mut self, axis: usize, change: impl Fn(&mut [f64], usize, usize)) {
        let inner: usize = self.orders[axis + 1..self.axes].iter().product();
        let order = self.orders[axis];
        for block in self.values.chunks_exact_mut(order * inner) {
            change(block, order, inner);
        }
    }
}

/// The least and the greatest.
pub(super) fn range(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
        (if *x < low { *x } else { low }, if *x > high { *x } else { high })
    })
}

/// The largest difference of coefficients that follow one another along an axis.
pub(super) fn largest_step(values: &[f64], orders: &[usize], axis: usize) -> f64 {
    let inner: usize = orders[axis + 1..].iter().product();
    let mut most = 0.0_f64;
    for block in values.chunks_exact(inner * orders[axis]) {
        for (a, b) in block.iter().zip(&block[inner..]) {
            let step = (b - a).abs();
            most = if step <= most { most } else { step };
        }
    }
    most
}

/// De Casteljau: the part from 0 to `t`.
fn keep_left(block: &mut [f64], order: usize, inner: usize, t: f64) {
    let s = 1.0 - t;
    if inner == 1 {
        for r in 1..order {
            for i in (r..order).rev() {
                block[i] = s * block[i - 1] + t * block[i];
            }
        }
        return;
    }
    for r in 1..order {
        for i in (r..order).rev() {
            let (low, high) = block[(i - 1) * inner..(i + 1) * inner].split_at_mut(inner);
            for (a, b) in low.iter().zip(high) {
                *b = s * a + t * *b;
            }
        }
    }
}

/// De Casteljau: the part from `t` to 1.
fn keep_right(block: &mut [f64], order: usize, inner: usize, t: f64) {
    let s = 1.0 - t;
    if inner == 1 {
        for r in 1..order {
            for i in 0..order - r {
                block[i] = s * block[i] + t * block[i + 1];
            }
        }
        return;
    }
    for r in 1..order {
        for i in 0..order - r {
            let (low, high) = block[i * inner..(i + 2) * inner].split_at_mut(inner);
            for (a, b) in low.iter_mut().zip(high.iter()) {
                *a = s * *a + t * b;
            }
        }
    }
}
