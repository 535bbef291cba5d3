//! A part of the window, with the equations over it.

use super::{Each, Equations, MOST_UNKNOWNS};

/// A box of parameters, and the equations in Bernstein form over it.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    pub lower: Each,
    pub upper: Each,
    pub values: Vec<f64>,
    /// No coefficient of an equation is wrong by more.
    pub noise: Vec<f64>,
    axes: usize,
    orders: [usize; MOST_UNKNOWNS],
}

impl Cell {
    /// The window and a little more.
    pub(super) fn whole(equations: &Equations, border: f64) -> Self {
        let axes = equations.axes();
        let mut orders = [1; MOST_UNKNOWNS];
        orders[..axes].copy_from_slice(equations.orders());
        let mut cell = Self {
            lower: [0.0; MOST_UNKNOWNS],
            upper: [1.0; MOST_UNKNOWNS],
            values: equations.coefficients().to_vec(),
            noise: equations.noise().to_vec(),
            axes,
            orders,
        };
        for axis in 0..axes {
            cell.restrict(axis, -border, 1.0 + border);
        }
        cell
    }

    /// Does an equation keep one sign over the cell, by more than its noise and tolerance?
    pub(super) fn is_free(&self, equations: &Equations) -> bool {
        let slack = self.noise.iter().zip(equations.tolerance()).map(|(a, b)| a + b);
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

    /// Its corners.
    pub(super) fn bounds(&self) -> (Vec<f64>, Vec<f64>) {
        let inside =
            |corner: &Each| corner[..self.axes].iter().map(|t| t.clamp(0.0, 1.0)).collect();
        (inside(&self.lower), inside(&self.upper))
    }

    /// Narrows one side to a part of it, in units of the side.
    pub(super) fn restrict(&mut self, axis: usize, from: f64, to: f64) {
        self.note_rounding(axis);
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
    }

    /// The two halves along an axis.
    pub(super) fn halves(mut self, axis: usize) -> (Self, Self) {
        self.note_rounding(axis);
        let mut high = self.clone();
        let middle = f64::midpoint(self.lower[axis], self.upper[axis]);
        (self.upper[axis], high.lower[axis]) = (middle, middle);
        self.lines(axis, |line, order, inner| keep_left(line, order, inner, 0.5));
        high.lines(axis, |line, order, inner| keep_right(line, order, inner, 0.5));
        (self, high)
    }

    /// Two passes of as many means as the degree, each with roundings of what it averages.
    fn note_rounding(&mut self, axis: usize) {
        let factor = 4.0 * f64::EPSILON * (self.orders[axis] - 1) as f64;
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
