//! Embedding: the parameters of points in a cage, so that they follow it when it is bent.
//!
//! A point `x` has the parameters `t` in the cage `X/W` when `X(t) − x·W(t) = 0`. The window of the
//! cage is cut into cells, with a ring of them around it; a grid over space knows which cells may
//! hold its points. Where the slopes of the cage over these cells are all near one invertible matrix,
//! no point comes from two places: Newton's steps find the only one, a point in each lane, and what
//! the last step leaves out is bounded by the second derivatives. The few points where that fails,
//! and those of a cage that folds, are given to the solver that finds all solutions.

mod cage;
mod cells;
mod extend;
mod follow;
mod guide;
mod jet;
mod lanes;
mod matrix;
mod search;
mod sums;

use pforms_kernel::vectors::in_lanes;
use pforms_kernel::{Error, Result, limit, threads};

use crate::Shape;
use cage::Cage;
use cells::Cells;
pub use follow::{Embedding, Standing};
use guide::{Guide, Place, Reach};
use lanes::{Queue, Task};

/// What becomes of points that are not in the cage.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Outside {
    /// They stay where they are.
    #[default]
    Keep,
    /// They follow the cage continued beyond its window, where Newton's steps find them there.
    Extend,
    /// They are refused.
    Refuse,
}

/// The parameters of points in a cage, a form or a spline with as many axes as coordinates.
///
/// A point that is nearer to the cage than `accuracy` times its size counts as in it; residuals tell.
/// Of several places that a folded cage takes to one point the first in the order of the parameters
/// is taken; [`Embedding::counts`] and [`Embedding::complete`] tell that there are others.
///
/// Errors: `Shape` when coordinates or axes do not fit, or there are more than 4; `Domain` for points
/// that are not finite or out of all proportion, a weight that vanishes in the window, an accuracy
/// not between 0 and 1, and for points outside if they are refused; `Degenerate` for a cage of
/// degree 0 along an axis; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Outside, embed};
/// // A unit square whose upper corner is pulled out.
/// let cage: Form = Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 1., 0., 3., 3.], None)?;
/// let points = [1.0, 1.0, 2.0, 0.0];
/// let embedding = embed(&cage.clone().into(), &points, 1e-12, Outside::Keep)?;
/// let inside: Vec<bool> = embedding.inside().collect();
/// assert_eq!(inside, [true, false]);
/// let moved = cage.with_pole(&[0, 0], &[-1.0, 0.0, 1.0])?;
/// let followed = embedding.at(&moved.into())?;
/// assert!(followed[0] < 1.0 && followed[2..] == [2.0, 0.0]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn embed(cage: &Shape, points: &[f64], accuracy: f64, outside: Outside) -> Result<Embedding> {
    Embedder::new(cage, accuracy, outside)?.embed(points)
}

/// A cage made ready for embedding.
pub struct Embedder {
    cage: Cage,
    guide: Guide,
    reaches: Vec<Reach>,
    accuracy: f64,
    outside: Outside,
}

/// Cells along each axis of the whole cage, about, by number of axes.
const CUTS: [usize; 4] = [64, 12, 8, 2];

/// Multiplications for one point, about.
const COST: usize = 1 << 11;

impl Embedder {
    /// Makes a cage ready.
    ///
    /// Errors: those of [`embed`] that are not of its points.
    pub fn new(cage: &Shape, accuracy: f64, outside: Outside) -> Result<Self> {
        if !(0.0..=1.0).contains(&accuracy) {
            return Err(Error::domain("accuracy", accuracy, "a number from 0 to 1"));
        }
        let cage = Cage::new(cage)?;
        if cage.axes() > CUTS.len() {
            let expected = format!("at most {}", CUTS.len());
            return Err(Error::shape("cage", format!("{} axes", cage.axes()), expected));
        }
        let cuts: Vec<usize> =
            cage.counts.iter().map(|count| CUTS[cage.axes() - 1].div_ceil(*count)).collect();
        let guide = guided(&cage, &cuts)?;
        let ring = 1.0 / cuts.iter().fold(1.0_f64, |most, cuts| most.max(*cuts as f64));
        let size = guide.size();
        let reaches =
            cage.pieces.iter().map(|poles| Reach::new(&cage, poles, ring, size)).collect();
        Ok(Self { cage, guide, reaches, accuracy, outside })
    }

    /// [`embed`] in this cage.
    ///
    /// Errors: those of [`embed`] that are of its points.
    pub fn embed(&self, points: &[f64]) -> Result<Embedding> {
        let axes = self.cage.axes();
        if !points.len().is_multiple_of(axes) {
            let expected = format!("{axes} for each point");
            return Err(Error::shape("points", format!("{} numbers", points.len()), expected));
        }
        let width = axes + NUMBERS;
        let count = limit::check::<f64>("the embedding", &[points.len() / axes], width)?;
        let mut rows = vec![0.0; count];
        threads::fill_parts(&mut rows, width, COST, |range, out| {
            self.fill(&points[range.start * axes..range.end * axes], out)
        })?;
        let embedding = Embedding::from_rows(&rows, points, axes);
        if self.outside == Outside::Refuse
            && let Some(first) = embedding.inside().position(|inside| !inside)
        {
            let point = &points[first * axes..(first + 1) * axes];
            let received = format!("{point:?} outside the cage, at index {first}");
            return Err(Error::domain("points", received, "points in the cage"));
        }
        Ok(embedding)
    }

    /// The rows of some points, a block after the other.
    fn fill(&self, points: &[f64], out: &mut [f64]) -> Result<()> {
        let axes = self.cage.axes();
        let mut queues: Vec<Queue> = Vec::new();
        queues.resize_with(self.cage.pieces.len(), Queue::default);
        let block = BLOCK * self.cage.pieces.len();
        let blocks = out.chunks_mut(block * (axes + NUMBERS));
        for (points, out) in points.chunks(block * axes).zip(blocks) {
            let mut hard = match axes {
                1 => self.queue::<1>(points, out, &mut queues)?,
                2 => self.queue::<2>(points, out, &mut queues)?,
                3 => self.queue::<3>(points, out, &mut queues)?,
                _ => (0..points.len() / axes).collect(),
            };
            self.work_off(&mut queues, out, &mut hard);
            let mut placed = vec![0.0; axes];
            for number in hard {
                self.cage.place(&points[number * axes..][..axes], &mut placed)?;
                self.search(&placed, &mut out[number * (axes + NUMBERS)..][..axes + NUMBERS])?;
            }
            if self.outside == Outside::Extend {
                self.extend(points, out)?;
            }
        }
        Ok(())
    }

    /// Queues the points of which at most one place is possible; gives the numbers of those of which
    /// nothing is known.
    fn queue<const D: usize>(
        &self,
        points: &[f64],
        out: &mut [f64],
        queues: &mut [Queue],
    ) -> Result<Vec<usize>> {
        let mut hard = Vec::new();
        let mut placed = [0.0; D];
        for (number, point) in points.as_chunks::<D>().0.iter().enumerate() {
            self.cage.place(point, &mut placed)?;
            let place = self.guide.find(&placed).map(|at| self.guide.place(&self.cage, at));
            match place {
                Some(Place::Single(start)) => {
                    queues[start.piece].push(number, &placed, &start.guess(&placed));
                }
                Some(Place::Unknown) => hard.push(number),
                _ => self.put_outside(&mut out[number * (D + NUMBERS)..][..D + NUMBERS]),
            }
        }
        Ok(hard)
    }

    /// Newton's steps for what is queued; what they do not settle becomes hard.
    fn work_off(&self, queues: &mut [Queue], out: &mut [f64], hard: &mut Vec<usize>) {
        // A point at a break may be handed over to the piece beyond, and from there on.
        for _ in 0..ROUNDS {
            let mut handed = Vec::new();
            for (piece, queue) in queues.iter_mut().enumerate() {
                if !queue.numbers.is_empty() {
                    let (cage, poles) = (&self.cage, &self.cage.pieces[piece][..]);
                    let reach = &self.reaches[piece];
                    in_lanes(Task { cage, poles, reach, queue: &mut *queue });
                    self.settle(piece, queue, out, hard, &mut handed);
                    queue.clear();
                }
            }
            if handed.is_empty() {
                return;
            }
            for Handed { piece, number, point, at } in handed {
                queues[piece].push(number, &point, &at);
            }
        }
        for queue in queues {
            hard.extend(queue.numbers.iter().map(|number| *number as usize));
            queue.clear();
        }
    }

    /// Writes what was found in a piece.
    fn settle(
        &self,
        piece: usize,
        queue: &Queue,
        out: &mut [f64],
        hard: &mut Vec<usize>,
        handed: &mut Vec<Handed>,
    ) {
        let axes = self.cage.axes();
        let index = self.cage.index(piece);
        let near = self.near();
        for (i, number) in queue.numbers.iter().enumerate() {
            let number = *number as usize;
            if !queue.left[i].is_finite() {
                hard.push(number);
                continue;
            }
            let row = &mut out[number * (axes + NUMBERS)..][..axes + NUMBERS];
            let mut left = queue.left[i] + self.cage.noise;
            for k in 0..axes {
                let t = queue.at[k][i];
                let inner = t.clamp(0.0, 1.0);
                row[k] = self.cage.parameter(k, index[k], inner);
                left += axes as f64 * self.reaches[piece].slopes[k] * (t - inner).abs();
            }
            let residual = left / self.cage.least_weight;
            if residual <= near {
                row[axes..].copy_from_slice(&[self.cage.length(residual), 1.0, 1.0]);
            } else if let Some(next) = self.handed(number, &index, queue, i) {
                handed.push(next);
            } else {
                self.put_outside(row);
            }
        }
    }

    /// A point that lies beyond its piece, but not beyond the cage.
    fn handed(&self, number: usize, index: &[usize], queue: &Queue, i: usize) -> Option<Handed> {
        let axes = index.len();
        let is_beyond = |k: &usize| {
            let t = queue.at[*k][i];
            (t < -HANDED && index[*k] > 0)
                || (t > 1.0 + HANDED && index[*k] + 1 < self.cage.counts[*k])
        };
        let axis = (0..axes).find(is_beyond)?;
        let is_up = queue.at[axis][i] > 1.0;
        let mut next = index.to_vec();
        next[axis] = if is_up { index[axis] + 1 } else { index[axis] - 1 };
        let mut at: Vec<f64> = (0..axes).map(|k| queue.at[k][i].clamp(0.0, 1.0)).collect();
        at[axis] = if is_up { 0.0 } else { 1.0 };
        let point = (0..axes).map(|k| queue.points[k][i]).collect();
        Some(Handed { piece: self.cage.number(&next), number, point, at })
    }

    /// What is nearer to the cage counts as in it.
    fn near(&self) -> f64 {
        (2.0 * self.accuracy * self.cage.half).max(4.0 * self.cage.noise / self.cage.least_weight)
    }

    /// A point that is proved to be outside.
    fn put_outside(&self, row: &mut [f64]) {
        let axes = self.cage.axes();
        for (k, t) in row[..axes].iter_mut().enumerate() {
            *t = self.cage.breaks[k][0];
        }
        row[axes..].copy_from_slice(&[f64::INFINITY, 0.0, 1.0]);
    }
}

/// Points of each piece that are on their way at once.
const BLOCK: usize = 512;

/// Numbers of a row after the parameters: residual, count, complete.
const NUMBERS: usize = 3;

/// Points that are farther beyond their piece are handed on.
const HANDED: f64 = 1e-12;

/// Pieces that a point is handed through at most.
const ROUNDS: usize = 8;

/// A point that turned out to be in another piece.
struct Handed {
    piece: usize,
    number: usize,
    point: Vec<f64>,
    at: Vec<f64>,
}

/// The guide with so many cells, or fewer if these are too many.
fn guided(cage: &Cage, cuts: &[usize]) -> Result<Guide> {
    let single = vec![1; cuts.len()];
    Guide::new(cage, cuts).or_else(|| Guide::new(cage, &single)).ok_or_else(|| Error::Limit {
        what: format!("the cells of a cage of {} pieces", cage.pieces.len()),
        bytes: cage.pieces.len() as u128 * size_of::<Cells>() as u128,
        cap: u128::from(limit::cap()),
    })
}
