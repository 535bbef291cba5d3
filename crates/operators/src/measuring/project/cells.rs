//! The window cut into cells, each part of the form in a ball.

use pforms_kernel::{Form, Matrix, Result};

use crate::stretch_matrix;

/// Cells of one form, in C order.
pub(super) struct Cells {
    /// Cells along each axis.
    pub counts: Vec<usize>,
    /// Middles of the cells: a point of the form for each.
    pub centres: Vec<f64>,
    /// Radii of the balls around them.
    pub radii: Vec<f64>,
}

/// Cells of one form at most; a power of two.
pub(super) const MOST: usize = 1 << 10;

/// Poles of all cells at most.
const POLES: usize = 1 << 18;

impl Cells {
    /// As many cells as pay: three or four for each degree along an axis, fewer in volumes.
    ///
    /// Errors: those of evaluation, which a form with a positive weight does not meet.
    pub(super) fn new(form: &Form) -> Result<Self> {
        let axes = form.axes();
        let most = MOST.min(POLES / form.pole_count()) as f64;
        let share = most.powf(1.0 / axes as f64).floor().max(1.0) as usize;
        let per_degree = if axes == 1 { 16 } else { 4 };
        let counts: Vec<usize> =
            form.orders().iter().map(|order| (per_degree * (order - 1)).clamp(1, share)).collect();
        let middles: Vec<Vec<f64>> = counts
            .iter()
            .map(|count| (0..*count).map(|i| (i as f64 + 0.5) / *count as f64).collect())
            .collect();
        let lists: Vec<&[f64]> = middles.iter().map(Vec::as_slice).collect();
        let centres = form.grid(&lists)?;
        let mut net = form.clone();
        for (axis, count) in counts.iter().enumerate() {
            net = net.along(axis, &cutting_matrix(form.orders()[axis] - 1, *count))?;
        }
        let radii = radii(&net, form, &counts, &centres);
        Ok(Self { counts, centres, radii })
    }

    /// Parameters of the middle of the cell whose middle is nearest to a point.
    pub(super) fn nearest(&self, point: &[f64]) -> Vec<f64> {
        let mut nearest = (0, f64::INFINITY);
        for (place, centre) in self.centres.chunks_exact(point.len()).enumerate() {
            let square = square_distance(point, centre);
            if square < nearest.1 {
                nearest = (place, square);
            }
        }
        let index = self.index(nearest.0);
        index.iter().zip(&self.counts).map(|(i, count)| (*i as f64 + 0.5) / *count as f64).collect()
    }

    /// The least box of cells outside of which the form is farther than `reach`.
    pub(super) fn within(&self, point: &[f64], reach: f64) -> (Vec<f64>, Vec<f64>) {
        let axes = self.counts.len();
        let (mut lower, mut upper) = (vec![usize::MAX; axes], vec![0; axes]);
        let cells = self.centres.chunks_exact(point.len()).zip(&self.radii);
        for (place, (centre, radius)) in cells.enumerate() {
            let bound = (reach + radius) * (1.0 + SLACK);
            // Written so that a ball without bound counts.
            let outside = square_distance(point, centre) > bound * bound;
            if !outside {
                for (axis, i) in self.index(place).into_iter().enumerate() {
                    lower[axis] = lower[axis].min(i);
                    upper[axis] = upper[axis].max(i + 1);
                }
            }
        }
        if upper.contains(&0) {
            return (vec![0.0; axes], vec![1.0; axes]);
        }
        let share = |(i, count): (usize, &usize)| i as f64 / *count as f64;
        let lower = lower.into_iter().zip(&self.counts).map(share).collect();
        (lower, upper.into_iter().zip(&self.counts).map(share).collect())
    }

    fn index(&self, mut place: usize) -> Vec<usize> {
        let mut index = vec![0; self.counts.len()];
        for (i, count) in index.iter_mut().zip(&self.counts).rev() {
            *i = place % count;
            place /= count;
        }
        index
    }
}

/// Above what rounding does to a distance.
pub(super) const SLACK: f64 = 1e-13;

/// The matrix that takes poles to those of all cells along an axis, one cell after another.
fn cutting_matrix(degree: usize, count: usize) -> Matrix {
    let at = |i: usize| i as f64 / count as f64;
    let cells: Vec<Matrix> =
        (0..count).map(|i| stretch_matrix(degree, &at(i), &at(i + 1))).collect();
    let order = degree + 1;
    Matrix::from_rule(count * order, order, |i, j| cells[i / order].row(i % order)[j])
}

/// Of the balls around the middles of cells that hold all their poles, and so the form there.
fn radii(net: &Form, form: &Form, counts: &[usize], centres: &[f64]) -> Vec<f64> {
    let (ambient, axes) = (form.ambient(), form.axes());
    let mut squares = vec![0.0_f64; counts.iter().product()];
    let run = form.orders().last().map_or(1, |order| *order);
    for (chunk, poles) in net.homogeneous().chunks_exact(run * (ambient + 1)).enumerate() {
        let mut rest = chunk * run;
        let (mut place, mut stride) = (0, 1);
        for axis in (0..axes).rev() {
            let length = net.orders()[axis];
            place += rest % length / form.orders()[axis] * stride;
            rest /= length;
            stride *= counts[axis];
        }
        let centre = &centres[place * ambient..][..ambient];
        for pole in poles.chunks_exact(ambient + 1) {
            let weight = pole[ambient];
            let offsets = pole.iter().zip(centre).map(|(x, c)| x / weight - c);
            let square: f64 = offsets.map(|x| x * x).sum();
            squares[place] = if weight > 0.0 { squares[place].max(square) } else { f64::INFINITY };
        }
    }
    squares.into_iter().map(f64::sqrt).collect()
}

fn square_distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum()
}
