//! Solve `Σ_j B_j(x_i) p_j = q_i` in `O(n²)` operations per line, to high relative accuracy.
//!
//! Neville elimination of the Bernstein–Vandermonde matrix, whose multipliers and pivots are
//! known products of differences of nodes (Marco and Martínez, *A fast and accurate algorithm for
//! solving Bernstein–Vandermonde linear systems*, Linear Algebra Appl. 422, 2007). Nothing is
//! subtracted but nodes and data, so the computed poles satisfy
//! `|p̂ − p| ≤ c·ε·|A⁻¹|·|q|` in each component: as right as the data themselves. The factors are
//! powers and long products, so they are made in twofold precision and rounded once.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider vectors")]

use pforms_kernel::vectors::{Job, Simd};
use pforms_kernel::{Scalar, pascal_row};

use crate::measuring::twofold::Twofold;

/// The factors of one axis: computed once, applied to every line.
#[derive(Debug)]
pub(crate) struct Vandermonde<S> {
    /// Column `j`, from row `j + 1` on, of what eliminates below the diagonal; one after another.
    below: Vec<S>,
    pivots: Vec<S>,
    /// The same for the transposed matrix.
    above: Vec<S>,
}

/// Strictly increasing nodes and a window that holds them.
pub(crate) struct Window<S> {
    pub nodes: Vec<S>,
    pub start: S,
    pub end: S,
}

impl<S: Scalar> Window<S> {
    /// `x_i` less the start of the window.
    fn left(&self, i: usize) -> S {
        self.nodes[i].clone() - self.start.clone()
    }

    /// The end of the window less `x_i`.
    fn right(&self, i: usize) -> S {
        self.end.clone() - self.nodes[i].clone()
    }

    fn gap(&self, i: usize, k: usize) -> S {
        self.nodes[i].clone() - self.nodes[k].clone()
    }

    /// `((end − x_i) / (end − x_{i−1}))^degree`, then the products that follow it. A node at the
    /// end of the window is the last: its row of the matrix has a single entry.
    fn multipliers_below(&self, i: usize, degree: usize) -> Vec<S> {
        if i == 0 {
            return Vec::new();
        }
        let (here, before) = (self.right(i), self.right(i - 1));
        if here.is_zero() {
            return vec![S::zero(); i];
        }
        let mut multiplier = (here.clone() / before.clone()).power(degree);
        let mut row = vec![multiplier.clone()];
        for j in 1..i {
            let slope = before.clone() / here.clone();
            let reach = self.right(i - j - 1) / self.right(i - j);
            let gaps = self.gap(i, i - j) / self.gap(i - 1, i - j - 1);
            multiplier = multiplier * slope * reach * gaps;
            row.push(multiplier.clone());
        }
        row
    }

    fn multipliers_above(&self, i: usize, degree: usize) -> Vec<S> {
        let odds = |j: usize| self.left(j) / self.right(j);
        (0..i).map(|j| S::ratio((degree - i + 1) as i64, i as i64) * odds(j)).collect()
    }

    fn pivots(&self, choices: &[S]) -> Vec<S> {
        let degree = choices.len() - 1;
        let span = self.end.clone() - self.start.clone();
        let pivot = |(i, choices): (usize, &S)| {
            let start = choices.clone() * (self.right(i) / span.clone()).power(degree - i);
            (0..i).fold(start, |pivot, k| pivot * (self.gap(i, k) / self.right(k)))
        };
        choices.iter().enumerate().map(pivot).collect()
    }
}

impl<S: Scalar> Vandermonde<S> {
    /// The factors for as many poles as there are nodes.
    pub(crate) fn new(window: &Window<Twofold<S>>) -> Self {
        let degree = window.nodes.len() - 1;
        let choices = pascal_row(degree);
        let rounded = |row: Vec<Twofold<S>>| row.iter().map(Twofold::to_plain).collect::<Vec<S>>();
        let rows = |multipliers: &dyn Fn(usize) -> Vec<Twofold<S>>| -> Vec<Vec<S>> {
            (0..=degree).map(|i| rounded(multipliers(i))).collect()
        };
        Self {
            below: columns(&rows(&|i| window.multipliers_below(i, degree))),
            pivots: rounded(window.pivots(&choices)),
            above: columns(&rows(&|i| window.multipliers_above(i, degree))),
        }
    }

    /// Replaces the points of an array of shape `(·, order, inner)` by poles, in place.
    ///
    /// Many short lines are laid side by side before, so that they are solved together.
    pub(crate) fn solve(&self, array: &mut [S], inner: usize) {
        let block = self.pivots.len() * inner;
        if inner >= SHORT || array.len() == block {
            for block in array.chunks_exact_mut(block) {
                S::in_lanes(Elimination { factors: self, block, inner });
            }
            return;
        }
        let count = array.len() / block;
        let mut together = vec![S::zero(); array.len()];
        for (line, point) in array.chunks_exact(inner).enumerate() {
            let place = (line % self.pivots.len() * count + line / self.pivots.len()) * inner;
            together[place..][..inner].clone_from_slice(point);
        }
        S::in_lanes(Elimination { factors: self, block: &mut together, inner: count * inner });
        for (line, point) in array.chunks_exact_mut(inner).enumerate() {
            let place = (line % self.pivots.len() * count + line / self.pivots.len()) * inner;
            point.clone_from_slice(&together[place..][..inner]);
        }
    }
}

/// Numbers that fill a vector of any machine.
const SHORT: usize = 8;

/// The columns of a lower triangle, without its diagonal, one after another.
fn columns<S: Clone>(rows: &[Vec<S>]) -> Vec<S> {
    (0..rows.len()).flat_map(|j| rows[j + 1..].iter().map(move |row| row[j].clone())).collect()
}

/// The elimination of one block of lines of `inner` numbers.
struct Elimination<'a, S> {
    factors: &'a Vandermonde<S>,
    block: &'a mut [S],
    inner: usize,
}

impl<S: Scalar> Job for Elimination<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run<V: Simd>(self, _: V) {
        match self.inner {
            3 => self.eliminate::<3>(),
            4 => self.eliminate::<4>(),
            _ => self.eliminate::<0>(),
        }
    }
}

impl<S: Scalar> Elimination<'_, S> {
    /// The same with the length of a line known to the compiler, unless it is 0.
    #[inline(always)]
    fn eliminate<const W: usize>(self) {
        let Self { factors, block, inner } = self;
        let order = factors.pivots.len();
        let mut start = 0;
        for j in 0..order - 1 {
            let column = &factors.below[start..][..order - 1 - j];
            for (i, factor) in (j + 1..order).zip(column).rev() {
                let (before, here) = block.split_at_mut(i * inner);
                subtract::<S, W>(&mut here[..inner], factor, &before[(i - 1) * inner..]);
            }
            start += column.len();
        }
        for (line, pivot) in block.chunks_exact_mut(inner).zip(&factors.pivots) {
            for x in line {
                *x = x.clone() / pivot.clone();
            }
        }
        for j in (0..order - 1).rev() {
            start -= order - 1 - j;
            let column = &factors.above[start..][..order - 1 - j];
            for (i, factor) in (j + 1..order).zip(column) {
                let (before, here) = block.split_at_mut(i * inner);
                subtract::<S, W>(&mut before[(i - 1) * inner..], factor, &here[..inner]);
            }
        }
    }
}

/// `target −= factor · source`, over the first `W` numbers, or over all.
#[inline(always)]
fn subtract<S: Scalar, const W: usize>(target: &mut [S], factor: &S, source: &[S]) {
    match W {
        _ if factor.is_zero() => {}
        0 => S::add_multiple(target, &-factor.clone(), source),
        _ => S::add_multiple(&mut target[..W], &-factor.clone(), &source[..W]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pforms_kernel::{Rational, bernstein_row};

    fn check(nodes: Vec<Rational>, start: Rational, end: Rational) {
        let poles: Vec<Rational> =
            (0..nodes.len() as i64).map(|k| Rational::ratio(k * k - 5 * k + 1, k + 2)).collect();
        let span = end.clone() - start.clone();
        let mut values: Vec<Rational> = nodes
            .iter()
            .map(|x| {
                let t = (x.clone() - start.clone()) / span.clone();
                let row = bernstein_row(nodes.len() - 1, &t);
                row.iter().zip(&poles).fold(Rational::zero(), |sum, (b, p)| sum + b * p)
            })
            .collect();
        let plain = Twofold::from_plain;
        let nodes = nodes.into_iter().map(plain).collect();
        Vandermonde::new(&Window { nodes, start: plain(start), end: plain(end) })
            .solve(&mut values, 1);
        assert_eq!(values, poles);
    }

    #[test]
    fn inverts_the_dense_matrix_exactly() {
        for order in 2..9 {
            let nodes = |shift: i64, whole: i64| {
                (0..order).map(|i| Rational::ratio(i + shift, whole)).collect::<Vec<_>>()
            };
            let (zero, one) = (Rational::from_integer(0.into()), Rational::from_integer(1.into()));
            check(nodes(0, order - 1), zero.clone(), one.clone());
            check(nodes(1, order + 3), zero.clone(), one.clone());
            check(nodes(0, order + 1), zero.clone(), one.clone());
            check(nodes(1, order), zero, one);
            check(nodes(-2, 3), Rational::ratio(-2, 3), Rational::from_integer(9.into()));
        }
    }
}
