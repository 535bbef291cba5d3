//! The same proof for several points at once: curves and surfaces in space, a point in each lane.
//!
//! From the nearest of the cells' middles Newton's steps lead to a foot. Cells whose balls are
//! farther are out of question; over the box of the others the margin is shown to be convex, or
//! to rise from the side on which the foot lies. Where that fails the search answers, point by
//! point. A lane never looks at another, so an answer does not depend on its neighbours.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

mod near;
mod newton;
mod proof;

use pforms_kernel::Result;
use pforms_kernel::vectors::{self, Job, Lanes, Simd};

use super::rows::Rows;
use super::search::Search;
use near::Near;
use newton::{Feet, Newton};
use proof::{Proof, Verdict};

/// Coefficients of a margin that is proved in lanes; with more of them cells are too few anyway.
const MOST: usize = 1 << 8;

/// Numbers of a form, arranged for lanes: a surface, or a curve as a surface of one column.
pub(super) struct Quick {
    orders: [usize; 2],
    counts: [usize; 2],
    rational: bool,
    /// Poles of four or, when all weights are equal, three coordinates.
    poles: Vec<f64>,
    /// Middles of the cells, three coordinates each.
    centres: Vec<f64>,
    /// Coefficients of `|X|²`, then of `X·W` for three coordinates, then of `W²`.
    squares: [Vec<f64>; 5],
}

impl Quick {
    /// The numbers, if the form is one for lanes.
    pub(super) fn new(search: &Search) -> Option<Self> {
        let form = &search.target.form;
        let pair = |list: &[usize]| match *list {
            [first] => Some([first, 1]),
            [first, second] => Some([first, second]),
            _ => None,
        };
        let (orders, counts) = (pair(form.orders())?, pair(&search.cells.counts)?);
        if form.ambient() > 3 || search.products.count() > MOST {
            return None;
        }
        let rational = form.is_rational();
        let ambient = form.ambient();
        let pole = |i: usize| &form.homogeneous()[i * (ambient + 1)..][..=ambient];
        let mut squares = [const { Vec::new() }; 5];
        let dot = |i: usize, j: usize| (0..ambient).map(|c| pole(i)[c] * pole(j)[c]).sum();
        search.products.sum(dot, &mut squares[0]);
        for (c, square) in squares[1..4].iter_mut().enumerate() {
            let mixed = |i: usize, j: usize| {
                0.5 * (pole(i)[c] * pole(j)[ambient] + pole(j)[c] * pole(i)[ambient])
            };
            search.products.sum(|i, j| if c < ambient { mixed(i, j) } else { 0.0 }, square);
        }
        search.products.sum(|i, j| pole(i)[ambient] * pole(j)[ambient], &mut squares[4]);
        let mut poles = Vec::new();
        for pole in form.homogeneous().chunks_exact(ambient + 1) {
            poles.extend((0..3).map(|c| if c < ambient { pole[c] } else { 0.0 }));
            poles.extend(rational.then_some(pole[ambient]));
        }
        let centres = search.cells.centres.chunks_exact(ambient);
        let centres = centres.flat_map(|x| (0..3).map(|c| x.get(c).copied().unwrap_or(0.0)));
        Some(Self { orders, counts, rational, poles, centres: centres.collect(), squares })
    }

    /// Is there no second parameter?
    fn is_curve(&self) -> bool {
        self.orders[1] == 1
    }
}

/// Points to be projected and the rows for their answers.
pub(super) struct Task<'a> {
    pub search: &'a Search,
    pub quick: &'a Quick,
    pub points: &'a [f64],
    pub out: &'a mut [f64],
    pub rows: Rows,
}

impl Job for Task<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Result<()> {
        if self.quick.rational {
            self.in_blocks::<S, 4>(simd)
        } else {
            self.in_blocks::<S, 3>(simd)
        }
    }
}

impl Task<'_> {
    #[inline(always)]
    fn in_blocks<S: Simd, const W: usize>(self, simd: S) -> Result<()> {
        let Self { search, quick, points, out, rows } = self;
        let ambient = search.target.form.ambient();
        let mut near = Near::new(simd, quick, search);
        let mut newton = Newton::<S, W>::new(simd, quick);
        let mut proof = Proof::<S, W>::new(simd, quick, search);
        let mut placed = vec![0.0; S::F64_LANES * ambient];
        let blocks = out.chunks_mut(S::F64_LANES * rows.width());
        for (points, block) in points.chunks(S::F64_LANES * ambient).zip(blocks) {
            let mut columns = [[0.0; vectors::MOST]; 3];
            for (k, place) in placed.chunks_exact_mut(ambient).enumerate() {
                // Lanes beyond the last point repeat it.
                let k_th = k.min(points.len() / ambient - 1);
                search.target.place(&points[k_th * ambient..][..ambient], place)?;
                for c in 0..ambient {
                    columns[c][k] = place[c];
                }
            }
            let [x, y, z] = &columns;
            let x = [Lanes::load(simd, x), Lanes::load(simd, y), Lanes::load(simd, z)];
            let start = near.start(&x);
            let feet = newton.descend(start, &x);
            let answers = Answers::new(start, &feet, &proof.of(&near, &x, &feet));
            for (k, row) in block.chunks_exact_mut(rows.width()).enumerate() {
                let parameters = &answers.parameters(k)[..search.target.live.len()];
                if answers.proved[k] > 0.0 {
                    let numbers = [answers.distance[k], answers.gap[k], 1.0];
                    rows.fill(&search.target, row, parameters, numbers);
                } else {
                    rows.search(search, row, &placed[k * ambient..][..ambient], parameters);
                }
            }
        }
        Ok(())
    }
}

/// What was found for the points in the lanes, point by point.
struct Answers {
    parameters: [[f64; vectors::MOST]; 2],
    distance: [f64; vectors::MOST],
    gap: [f64; vectors::MOST],
    proved: [f64; vectors::MOST],
}

impl Answers {
    /// The feet, or the start where descent did not end.
    #[inline(always)]
    fn new<S: Simd>(start: [Lanes<S>; 2], feet: &Feet<S>, verdict: &Verdict<S>) -> Self {
        let zero = Lanes::splat(feet.ended.simd(), 0.0);
        let [u, v] = feet.parameters;
        Self {
            parameters: [
                numbers(less(zero, feet.ended, u, start[0])),
                numbers(less(zero, feet.ended, v, start[1])),
            ],
            distance: numbers(feet.distance),
            gap: numbers(verdict.gap),
            proved: numbers(verdict.proved),
        }
    }

    /// The parameters of one point.
    #[inline(always)]
    fn parameters(&self, k: usize) -> [f64; 2] {
        [self.parameters[0][k], self.parameters[1][k]]
    }
}

/// The numbers in the lanes, and zeros.
#[inline(always)]
fn numbers<S: Simd>(lanes: Lanes<S>) -> [f64; vectors::MOST] {
    let mut numbers = [0.0; vectors::MOST];
    lanes.store(&mut numbers);
    numbers
}

/// `x` where `a` is less than `b`, else `y`.
#[inline(always)]
fn less<S: Simd>(a: Lanes<S>, b: Lanes<S>, x: Lanes<S>, y: Lanes<S>) -> Lanes<S> {
    b.if_above(a, x, y)
}

/// The lesser of each two, `a` where either is no number.
#[inline(always)]
fn least<S: Simd>(a: Lanes<S>, b: Lanes<S>) -> Lanes<S> {
    b.min(a)
}

/// The larger of each two, `a` where either is no number.
#[inline(always)]
fn most<S: Simd>(a: Lanes<S>, b: Lanes<S>) -> Lanes<S> {
    b.max(a)
}

/// `a − b`.
#[inline(always)]
fn difference<S: Simd>(a: &[Lanes<S>; 3], b: &[Lanes<S>; 3]) -> [Lanes<S>; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn dot<S: Simd>(a: &[Lanes<S>; 3], b: &[Lanes<S>; 3]) -> Lanes<S> {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
