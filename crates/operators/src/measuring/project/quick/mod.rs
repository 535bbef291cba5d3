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
use pforms_kernel::lanes::{Job, Lanes};

use super::rows::Rows;
use super::search::Search;
use near::Near;
use newton::Newton;
use proof::Proof;

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
    fn run<const N: usize>(self) -> Result<()> {
        if self.quick.rational { self.in_blocks::<N, 4>() } else { self.in_blocks::<N, 3>() }
    }
}

impl Task<'_> {
    #[inline(always)]
    fn in_blocks<const N: usize, const W: usize>(self) -> Result<()> {
        let Self { search, quick, points, out, rows } = self;
        let ambient = search.target.form.ambient();
        let mut near = Near::<N>::new(quick, search);
        let mut newton = Newton::<N, W>::new(quick);
        let mut proof = Proof::<N, W>::new(quick, search);
        let mut placed = vec![0.0; N * ambient];
        let blocks = out.chunks_mut(N * rows.width());
        for (points, block) in points.chunks(N * ambient).zip(blocks) {
            let mut x = [Lanes::<N>::ZERO; 3];
            for (k, place) in placed.chunks_exact_mut(ambient).enumerate() {
                // Lanes beyond the last point repeat it.
                let k_th = k.min(points.len() / ambient - 1);
                search.target.place(&points[k_th * ambient..][..ambient], place)?;
                place.iter().zip(&mut x).for_each(|(from, x)| x.0[k] = *from);
            }
            let start = near.start(&x);
            let feet = newton.descend(start, &x);
            let verdict = proof.of(&near, &x, &feet);
            for (k, row) in block.chunks_exact_mut(rows.width()).enumerate() {
                let parameters = if feet.ended.0[k] > 0.0 { &feet.parameters } else { &start };
                let parameters = [parameters[0].0[k], parameters[1].0[k]];
                let parameters = &parameters[..search.target.live.len()];
                if verdict.proved.0[k] > 0.0 {
                    let numbers = [feet.distance.0[k], verdict.gap.0[k], 1.0];
                    rows.fill(&search.target, row, parameters, numbers);
                } else {
                    rows.search(search, row, &placed[k * ambient..][..ambient], parameters);
                }
            }
        }
        Ok(())
    }
}

/// Said in a loop, this keeps the compiler from putting successive turns into the lanes of a
/// register, for which it would take apart and transpose the points that are there.
#[inline(always)]
fn keep_lanes() {
    std::hint::black_box(());
}

/// `x` where `a` is less than `b`, else `y`.
#[inline(always)]
fn less<const N: usize>(a: Lanes<N>, b: Lanes<N>, x: Lanes<N>, mut y: Lanes<N>) -> Lanes<N> {
    for k in 0..N {
        y.0[k] = if a.0[k] < b.0[k] { x.0[k] } else { y.0[k] };
    }
    y
}

/// The lesser of each two.
#[inline(always)]
fn least<const N: usize>(a: Lanes<N>, b: Lanes<N>) -> Lanes<N> {
    a.zip(b, |a, b| if b < a { b } else { a })
}

/// The larger of each two.
#[inline(always)]
fn most<const N: usize>(a: Lanes<N>, b: Lanes<N>) -> Lanes<N> {
    a.zip(b, |a, b| if b > a { b } else { a })
}

/// `a − b`.
#[inline(always)]
fn difference<const N: usize>(a: &[Lanes<N>; 3], b: &[Lanes<N>; 3]) -> [Lanes<N>; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn dot<const N: usize>(a: &[Lanes<N>; 3], b: &[Lanes<N>; 3]) -> Lanes<N> {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
