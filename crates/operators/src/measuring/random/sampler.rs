//! Points by rejection: boxes of parameters with a proved bound of the element of size on each.

use std::collections::BinaryHeap;

use pforms_kernel::{Error, Form, Result};

use super::generator::Generator;
use crate::algebra::tangent_minors;
use crate::measuring::vector::norm;
use crate::measuring::{in_units, unit};
use crate::{Shape, split};

/// Boxes at most.
const BOXES: usize = 1 << 12;

/// Boxes are halved until this share of what is drawn is kept, as far as can be told from their middles.
const KEPT: f64 = 0.8;

/// Draws for one point before the density counts as 0.
const TRIES: usize = 1 << 20;

/// A box of parameters of a piece.
struct Cell {
    piece: usize,
    low: Vec<f64>,
    high: Vec<f64>,
    /// The numerators of the element and the form, on this box.
    numerators: Form,
    form: Form,
    /// What the element is at most, times the size of the box; about what it is in the mean.
    most: f64,
    about: f64,
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        let excess = |cell: &Self| cell.most - cell.about;
        excess(self).total_cmp(&excess(other)).then_with(|| other.piece.cmp(&self.piece)).then_with(
            || other.low.iter().partial_cmp(&self.low).unwrap_or(std::cmp::Ordering::Equal),
        )
    }
}

/// What is known of a piece.
struct Piece {
    form: Form,
    numerators: Form,
    power: i32,
}

pub(super) struct Sampler {
    pieces: Vec<Piece>,
    cells: Vec<Cell>,
    /// The sums of `most` up to each box, itself included.
    sums: Vec<f64>,
}

impl Sampler {
    pub(super) fn new(shape: &Shape) -> Result<Self> {
        let forms = shape.pieces()?;
        let size = unit(&forms);
        let mut pieces = Vec::with_capacity(forms.len());
        let mut waiting = BinaryHeap::new();
        for (number, form) in forms.into_iter().enumerate() {
            let small = in_units(&form, size)?;
            let minors = tangent_minors(&small)?;
            let power = minors.power as i32;
            let numerators = minors.into_vectors()?;
            let axes = form.axes();
            let whole = Cell {
                piece: number,
                low: vec![0.0; axes],
                high: vec![1.0; axes],
                numerators: numerators.clone(),
                form: small.clone(),
                most: 0.0,
                about: 0.0,
            };
            waiting.push(whole.measured(power)?);
            pieces.push(Piece { form, numerators, power });
        }
        refine(&mut waiting, &pieces)?;
        let mut cells: Vec<Cell> = waiting.into_vec();
        cells.sort_by(|a, b| {
            (a.piece, &a.low).partial_cmp(&(b.piece, &b.low)).unwrap_or(std::cmp::Ordering::Equal)
        });
        let mut sum = 0.0;
        let sums: Vec<f64> = cells
            .iter()
            .map(|cell| {
                sum += cell.most;
                sum
            })
            .collect();
        if !sum.is_finite() {
            return Err(Error::domain("form", "a weight that vanishes", "a form that is finite"));
        }
        if sum <= 0.0 {
            return Err(Error::degenerate("form", "one without size", "a form to draw points of"));
        }
        Ok(Self { pieces, cells, sums })
    }

    /// A point: a box by its share, a place in it, kept as often as the element asks for.
    pub(super) fn draw(&self, random: &mut Generator) -> Result<Vec<f64>> {
        let total = self.sums.last().copied().unwrap_or(0.0);
        for _ in 0..TRIES {
            let share = random.unit() * total;
            let number = self.sums.partition_point(|sum| *sum <= share).min(self.cells.len() - 1);
            let cell = &self.cells[number];
            let sides = cell.low.iter().zip(&cell.high);
            let at: Vec<f64> = sides.map(|(a, b)| a + (b - a) * random.unit()).collect();
            let volume: f64 = cell.low.iter().zip(&cell.high).map(|(a, b)| b - a).product();
            let piece = &self.pieces[cell.piece];
            if random.unit() * cell.most < piece.element(&at)? * volume {
                return piece.form.at(&at);
            }
        }
        Err(Error::degenerate("form", "one almost without size", "a form to draw points of"))
    }
}

impl Piece {
    fn element(&self, at: &[f64]) -> Result<f64> {
        let length = norm(&self.numerators.at(at)?);
        if self.power == 0 {
            return Ok(length);
        }
        let weight = weight_at(&self.form, at);
        Ok(length / weight.abs().powi(self.power))
    }
}

/// The weight at a place: that of the sum of the poles.
fn weight_at(form: &Form, at: &[f64]) -> f64 {
    let mut weights = form.weights();
    for (axis, t) in at.iter().enumerate() {
        let inner: usize = form.orders()[axis + 1..].iter().product();
        let row = pforms_kernel::bernstein_row(form.orders()[axis] - 1, t);
        let mut sum = vec![0.0; inner];
        for (factor, line) in row.iter().zip(weights.chunks_exact(inner)) {
            sum.iter_mut().zip(line).for_each(|(sum, x)| *sum += factor * x);
        }
        weights = sum;
    }
    weights.first().copied().unwrap_or(1.0)
}

impl Cell {
    /// Bounds the element: the longest numerator over the least weight, of the poles on this box.
    fn measured(mut self, power: i32) -> Result<Self> {
        let volume: f64 = self.low.iter().zip(&self.high).map(|(a, b)| b - a).product();
        let width = self.numerators.width();
        let poles = self.numerators.homogeneous().chunks_exact(width);
        let longest = poles.map(|pole| norm(&pole[..width - 1])).fold(0.0, f64::max);
        let weights = self.form.weights();
        let (low, high) = weights
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), w| (a.min(*w), b.max(*w)));
        let least = if low > 0.0 { low } else { -high };
        let middle = vec![0.5; self.form.axes()];
        let length = norm(&self.numerators.at(&middle)?);
        if power == 0 {
            (self.most, self.about) = (longest * volume, length * volume);
        } else if least > 0.0 {
            let weight = weight_at(&self.form, &middle).abs();
            self.most = longest / least.powi(power) * volume;
            self.about = length / weight.powi(power) * volume;
        } else if longest > 0.0 {
            (self.most, self.about) = (f64::INFINITY, 0.0);
        }
        // A rounding more: the bound is above every value that is computed.
        self.most *= 1.0 + 1e-12;
        Ok(self)
    }

    /// The longest side in two: that along which the form is longest, by its poles.
    fn halves(&self, power: i32) -> Result<[Self; 2]> {
        let axis = self.longest();
        let (low, high) = split(&self.numerators, axis, &0.5)?;
        let (first, second) = split(&self.form, axis, &0.5)?;
        let middle = f64::midpoint(self.low[axis], self.high[axis]);
        let half = |numerators: Form, form: Form, end: usize| {
            let mut cell = Self {
                piece: self.piece,
                low: self.low.clone(),
                high: self.high.clone(),
                numerators,
                form,
                most: 0.0,
                about: 0.0,
            };
            if end == 0 {
                cell.high[axis] = middle;
            } else {
                cell.low[axis] = middle;
            }
            cell.measured(power)
        };
        Ok([half(low, first, 0)?, half(high, second, 1)?])
    }

    /// The axis along which the box was halved least.
    fn longest(&self) -> usize {
        let side = |axis: &usize| self.high[*axis] - self.low[*axis];
        (0..self.low.len()).rev().max_by(|a, b| side(a).total_cmp(&side(b))).unwrap_or(0)
    }
}

/// Halves the boxes whose bounds are worst.
fn refine(waiting: &mut BinaryHeap<Cell>, pieces: &[Piece]) -> Result<()> {
    loop {
        let most: f64 = waiting.iter().map(|cell| cell.most).sum();
        let about: f64 = waiting.iter().map(|cell| cell.about).sum();
        if about >= KEPT * most || waiting.len() >= BOXES {
            return Ok(());
        }
        // As many at a time as an eighth of them: the sums are not made anew for each.
        for _ in 0..(waiting.len() / 8).max(1) {
            let Some(worst) = waiting.pop() else { return Ok(()) };
            waiting.extend(worst.halves(pieces[worst.piece].power)?);
        }
    }
}
