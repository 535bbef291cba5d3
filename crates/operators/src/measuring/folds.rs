//! Does a form fold over? The sign of its Jacobian determinant, proved.

use pforms_kernel::{Form, Result};

use super::integral::noisy_determinant;
use super::patches::{Patch, patches};
use crate::algebra::{Poles, Shape, derivative, require_square, split};

/// What is known of the sign of a Jacobian determinant over the whole window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Folding {
    /// It has one sign, proved: nothing folds. It may vanish on the border or on lines between pieces.
    None,
    /// It has both signs.
    Folds,
    /// It is so near 0 somewhere that its sign stays open.
    Undecided,
}

impl Folding {
    /// Its name: none, folds, undecided.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Folds => "folds",
            Self::Undecided => "undecided",
        }
    }
}

/// The answer to whether a form folds over.
#[derive(Clone, Debug, PartialEq)]
pub struct Folds {
    /// The answer.
    pub answer: Folding,
    /// Parameters where the determinant is positive, if any were found.
    pub positive: Option<Vec<f64>>,
    /// Parameters where it is negative, if any were found.
    pub negative: Option<Vec<f64>>,
    /// Boxes of parameters, from corner to corner, where its sign is open.
    pub undecided: Vec<[Vec<f64>; 2]>,
    /// Does no determinant vanish anywhere, border and all?
    pub regular: bool,
    /// Is it proved that no two parameters give one point?
    pub injective: bool,
}

/// Boxes at most.
const CELLS: usize = 1 << 14;

/// Open boxes that are reported; more of them are put together in the last.
const REPORTED: usize = 16;

/// Does a form fold over: has its Jacobian determinant both signs?
///
/// Bernstein's coefficients of the determinant are computed with a bound of their rounding, and halved
/// until each box has one sign. Where all values of a box are at most `accuracy` times the mean of the
/// determinant, or the boxes get too many, its sign stays open.
///
/// [`Folding::None`] says that the form is one-to-one near every parameter inside; the whole is one-to-one
/// if besides its border meets itself nowhere (Meisters and Olech, 1963). `injective` is proved apart:
/// where `A·J`, with `A` the inverse of the mean of the derivatives `J`, stays within 1 of the unit
/// matrix, two different parameters have two different points.
///
/// Errors: `Shape` without as many axes as coordinates; `Domain` when `accuracy` is not between 0 and 1
/// or the form is at infinity.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Folding, folds};
/// let square = |far: f64| -> pforms_kernel::Result<Form> {
///     Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 1., 0., far, far], None)
/// };
/// assert_eq!(folds(&square(1.0)?.into(), 1e-9)?.answer, Folding::None);
/// assert_eq!(folds(&square(0.4)?.into(), 1e-9)?.answer, Folding::Folds); // a corner drawn in too far
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn folds(shape: &Shape, accuracy: f64) -> Result<Folds> {
    let net = shape.net();
    require_square(net.axes(), net.ambient(), net)?;
    super::integral::require_accuracy(accuracy)?;
    let pieces = patches(shape)?;
    let mut search = Search::default();
    for piece in &pieces {
        search.piece(piece, accuracy)?;
    }
    let both = search.positive.is_some() && search.negative.is_some();
    let answer = match (both, search.undecided.is_empty()) {
        (true, _) => Folding::Folds,
        (false, false) => Folding::Undecided,
        (false, true) if search.positive.is_none() && search.negative.is_none() => {
            Folding::Undecided
        }
        (false, true) => Folding::None,
    };
    let regular = answer == Folding::None && !search.vanishes;
    Ok(Folds {
        answer,
        positive: search.positive,
        negative: search.negative,
        undecided: search.undecided,
        regular,
        injective: regular && is_near_linear(&pieces)?,
    })
}

/// What has been found so far.
#[derive(Default)]
struct Search {
    positive: Option<Vec<f64>>,
    negative: Option<Vec<f64>>,
    undecided: Vec<[Vec<f64>; 2]>,
    /// May the determinant vanish on some border?
    vanishes: bool,
    cells: usize,
}

/// A box and the coefficients of the determinant there; as weights, how wrong they may be.
struct Cell {
    determinant: Form,
    low: Vec<f64>,
    high: Vec<f64>,
}

impl Search {
    fn piece(&mut self, piece: &Patch, accuracy: f64) -> Result<()> {
        let determinant = noisy_determinant(&piece.form)?;
        let poles = determinant.homogeneous();
        let mean = poles.iter().step_by(2).map(|x| x.abs()).sum::<f64>() / (poles.len() / 2) as f64;
        let axes = piece.form.axes();
        let whole = Cell { determinant, low: vec![0.0; axes], high: vec![1.0; axes] };
        let mut waiting = std::collections::VecDeque::from([whole]);
        while let Some(cell) = waiting.pop_front() {
            pforms_kernel::stopping::check()?;
            self.cells += 1;
            if self.settles(&cell, piece) {
                continue;
            }
            if self.positive.is_some() && self.negative.is_some() {
                return Ok(());
            }
            let largest = cell.determinant.homogeneous().iter().step_by(2);
            let largest = largest.fold(0.0_f64, |most, x| most.max(x.abs()));
            let Some(axis) =
                cell.longest().filter(|_| largest > accuracy * mean && self.cells < CELLS)
            else {
                self.leave(&cell, piece);
                continue;
            };
            waiting.extend(cell.halves(axis)?);
        }
        Ok(())
    }

    /// Has the box one sign? Signs at its corners are taken down.
    fn settles(&mut self, cell: &Cell, piece: &Patch) -> bool {
        let poles = cell.determinant.homogeneous().as_chunks::<2>().0;
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut sure = 0.0_f64;
        for [x, noise] in poles {
            least = least.min(x - noise);
            most = most.max(x + noise);
            sure = if x.abs() > *noise && x.abs() > sure.abs() { *x } else { sure };
        }
        for (corner, place) in cell.corners() {
            let [x, noise] = poles[place];
            let found = if x > noise {
                &mut self.positive
            } else if x < -noise {
                &mut self.negative
            } else {
                continue;
            };
            found.get_or_insert_with(|| piece.whole(&corner));
        }
        if least > 0.0 || most < 0.0 {
            return true;
        }
        // Coefficients that are exactly 0 on one side of all others: no sign but at the border.
        let (zero_below, zero_above) = (least >= 0.0, most <= 0.0);
        if (zero_below || zero_above) && sure != 0.0 {
            self.vanishes = true;
            let found = if sure > 0.0 { &mut self.positive } else { &mut self.negative };
            found.get_or_insert_with(|| piece.whole(&cell.middle()));
            return true;
        }
        false
    }

    fn leave(&mut self, cell: &Cell, piece: &Patch) {
        let (low, high) = (piece.whole(&cell.low), piece.whole(&cell.high));
        if self.undecided.len() < REPORTED {
            self.undecided.push([low, high]);
        } else if let Some([lower, upper]) = self.undecided.last_mut() {
            lower.iter_mut().zip(low).for_each(|(a, b)| *a = a.min(b));
            upper.iter_mut().zip(high).for_each(|(a, b)| *a = a.max(b));
        }
    }
}

impl Cell {
    /// The axis along which the determinant varies most, among those that can be halved.
    fn longest(&self) -> Option<usize> {
        let poles = self.determinant.homogeneous().as_chunks::<2>().0;
        let orders = self.determinant.orders();
        let variation = |axis: usize| {
            let inner: usize = orders[axis + 1..].iter().product();
            let inside = |place: &usize| place / inner % orders[axis] + 1 < orders[axis];
            let steps = (0..poles.len()).filter(inside);
            steps.map(|place| (poles[place + inner][0] - poles[place][0]).abs()).fold(0.0, f64::max)
        };
        let wide = |axis: &usize| self.high[*axis] - self.low[*axis] > WIDTH;
        let axes = (0..orders.len()).rev().filter(wide);
        axes.map(|axis| (variation(axis), axis))
            .max_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, axis)| axis)
    }

    fn halves(&self, axis: usize) -> Result<[Self; 2]> {
        let middle = f64::midpoint(self.low[axis], self.high[axis]);
        let (low, high) = split(&self.determinant, axis, &0.5)?;
        let (mut upper, mut lower) = (self.high.clone(), self.low.clone());
        (upper[axis], lower[axis]) = (middle, middle);
        let first = Self { determinant: unsure(&low)?, low: self.low.clone(), high: upper };
        let second = Self { determinant: unsure(&high)?, low: lower, high: self.high.clone() };
        Ok([first, second])
    }

    fn middle(&self) -> Vec<f64> {
        self.low.iter().zip(&self.high).map(|(low, high)| f64::midpoint(*low, *high)).collect()
    }

    /// The corners, and the places of their coefficients.
    fn corners(&self) -> impl Iterator<Item = (Vec<f64>, usize)> {
        let orders = self.determinant.orders();
        (0..1_usize << orders.len()).map(|bits| {
            let far = |axis: usize| bits >> axis & 1 == 1;
            let place = orders.iter().enumerate().fold(0, |place, (axis, order)| {
                place * order + if far(axis) { order - 1 } else { 0 }
            });
            let at = |axis| if far(axis) { self.high[axis] } else { self.low[axis] };
            ((0..orders.len()).map(at).collect(), place)
        })
    }
}

/// Boxes are not halved below it.
const WIDTH: f64 = 1e-12;

/// Coefficients that were halved once more: each of the steps rounded.
fn unsure(halved: &Form) -> Result<Form> {
    let poles = halved.homogeneous().as_chunks::<2>().0;
    let largest = poles.iter().fold(0.0_f64, |most, [x, _]| most.max(x.abs()));
    let steps = halved.orders().iter().max().copied().unwrap_or(1) as f64;
    let more = steps * f64::EPSILON * largest;
    let grown = poles.iter().flat_map(|[x, noise]| {
        // What is 0 since all that it is made of are 0 is sure.
        [*x, if *x == 0.0 && *noise == 0.0 { 0.0 } else { noise + more }]
    });
    Form::from_homogeneous(halved.orders(), 1, grown.collect())
}

/// Is `A·J` everywhere within 1 of the unit matrix, `A` the inverse of the mean of `J`?
fn is_near_linear(pieces: &[Patch]) -> Result<bool> {
    let Some(first) = pieces.first() else { return Ok(false) };
    let size = first.form.axes();
    // All poles of all derivatives: the entries of J lie in their boxes.
    let mut boxes = vec![[f64::INFINITY, f64::NEG_INFINITY]; size * size];
    for piece in pieces {
        for axis in 0..size {
            let mut orders = vec![0; size];
            orders[axis] = 1;
            let slope = derivative(&piece.form, &orders)?;
            if !slope.weights().iter().all(|weight| *weight > 0.0) {
                return Ok(false);
            }
            let side = piece.window[axis].1 - piece.window[axis].0;
            for point in slope.points()?.chunks_exact(size) {
                for (row, x) in point.iter().enumerate() {
                    let range = &mut boxes[row * size + axis];
                    *range = [range[0].min(x / side), range[1].max(x / side)];
                }
            }
        }
    }
    let mean: Vec<f64> = boxes.iter().map(|[low, high]| f64::midpoint(*low, *high)).collect();
    let Some(inverse) = inverted(&mean, size) else { return Ok(false) };
    let mut squares = 0.0;
    for row in 0..size {
        for column in 0..size {
            let spread: f64 = (0..size)
                .map(|k| {
                    let [low, high] = boxes[k * size + column];
                    inverse[row * size + k].abs() * 0.5 * (high - low)
                })
                .sum();
            squares += spread * spread;
        }
    }
    Ok(squares < NEAR)
}

/// Below 1 by what rounding of a well-conditioned inverse may do.
const NEAR: f64 = 0.99;

/// The inverse of a small matrix, by elimination with pivots; `None` where it is singular or nearly so.
fn inverted(matrix: &[f64], size: usize) -> Option<Vec<f64>> {
    /// Pivots smaller than this share of the largest entry are not trusted.
    const PIVOT: f64 = 1e-6;
    let largest = matrix.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let width = 2 * size;
    let mut rows: Vec<Vec<f64>> = (0..size)
        .map(|i| {
            let unit = (0..size).map(|j| if i == j { 1.0 } else { 0.0 });
            matrix[i * size..(i + 1) * size].iter().copied().chain(unit).collect()
        })
        .collect();
    for column in 0..size {
        let pivot = (column..size)
            .max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()))?;
        if rows[pivot][column].abs() <= PIVOT * largest {
            return None;
        }
        rows.swap(column, pivot);
        let head: Vec<f64> = rows[column].iter().map(|x| x / rows[column][column]).collect();
        rows[column].clone_from(&head);
        for (place, row) in rows.iter_mut().enumerate().filter(|(place, _)| *place != column) {
            debug_assert!(place != column);
            let factor = row[column];
            (0..width).for_each(|k| row[k] -= factor * head[k]);
        }
    }
    Some(rows.iter().flat_map(|row| row[size..].to_vec()).collect())
}
