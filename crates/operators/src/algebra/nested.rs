//! The poles of an immersion, by nested multiplication.
//!
//! With the inner form `(X₁, …, X_e, W)` and `S_j = W − X_j`, a host is contracted one axis after the
//! other, from the last: `Σ_k C(n,k)·S^{n−k}·X^k·p_k`, where every `p_k` is a pole or, on the axes
//! before, a contraction itself. On the last axis the `p_k` are numbers, and the polynomials
//! `C(n,k)·S^{n−k}·X^k` are made once. On the others the sum is nested, as Horner nests powers:
//! `(p₀·S + C(n,1)·X·p₁)·S + C(n,2)·X²·p₂ …`, so that what has grown is multiplied by nothing but the
//! inner form. A counter runs over the host's poles; where it carries, an axis is done.
//!
//! All in the scaled Bernstein basis, where nothing is subtracted but `W − X_j`.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider vectors")]

use std::cmp::Reverse;
use std::ops::Range;

use pforms_kernel::vectors::{Job, Simd};
use pforms_kernel::{Binomials, Flat, Form, Scalar, Tap};
use smallvec::SmallVec;

use super::immersion_factors::{Factors, products};
use super::immersion_shape::{Axis, Each, Shape};
use super::transpose;

/// The homogeneous poles of `host ∘ inner`, which has these orders and, if there is one, the
/// constant weight `weight`.
///
/// Beside the result, it needs room for less than another and a half of its size.
pub(super) fn compose<S: Scalar>(
    inner: &Form<S>,
    host: &Form<S>,
    orders: &[usize],
    weight: Option<&S>,
) -> Vec<S> {
    let width = host.width() - usize::from(weight.is_some());
    let axes = longest_first(host.orders());
    let turned = if axes.is_sorted() { None } else { transpose(host, &axes).ok() };
    let host = turned.as_ref().unwrap_or(host);
    let shape = Shape::of(inner.orders(), host.orders(), width);
    let room = Flat::<S>::room;
    let (basis, beside) = Factors::<S>::basis_room(&shape);
    let top = room(shape.axes[0].room);
    let rest = shape.rooms().map(room).sum::<usize>() + basis + beside;
    let count = |top: &mut [S], rest: &mut [S]| {
        S::in_lanes(Counter { shape: &shape, inner, host, axes: &axes, top, rest });
    };
    let poles = |top: &[S]| S::in_lanes(Poles { scaled: Flat::within(top), orders, width, weight });
    if S::EXACT || top + rest > FEW {
        let mut sum = vec![S::zero(); top];
        count(&mut sum, &mut vec![S::zero(); rest]);
        return poles(&sum);
    }
    let mut both: [S; FEW] = std::array::from_fn(|_| S::zero());
    let (sum, others) = both[..top + rest].split_at_mut(top);
    count(sum, others);
    poles(sum)
}

/// The axes of a host in the order in which they are best nested: what is made for each pole of the
/// axes before should be small.
fn longest_first(orders: &[usize]) -> Each {
    let mut axes: Each = (0..orders.len()).collect();
    if !orders.is_sorted_by(|a, b| a >= b) {
        axes.sort_by_key(|&axis| Reverse(orders[axis]));
    }
    axes
}

/// Numbers that are worked with on the stack.
const FEW: usize = 512;

/// Counts through the poles of the host and nests their sums.
struct Counter<'a, S> {
    shape: &'a Shape,
    inner: &'a Form<S>,
    host: &'a Form<S>,
    /// For each axis of the host, the coordinate of the inner form that is its parameter.
    axes: &'a [usize],
    top: &'a mut [S],
    rest: &'a mut [S],
}

/// The sums at work. Number `j` is the sum of axis `j`, and a term in that of the axis before.
struct Sums<'a, S> {
    shape: &'a Shape,
    factors: Factors<'a, S>,
    flats: SmallVec<[Flat<'a, S>; 4]>,
    /// How many poles each axis has seen.
    index: Each,
}

impl<S: Scalar> Sums<'_, S> {
    /// Takes the next pole of an axis; tells whether it was the last.
    #[inline(always)]
    fn take<V: Simd>(&mut self, simd: V, level: usize) -> bool {
        let axis = &self.shape.axes[level];
        if let Some(before) = self.index[level].checked_sub(1) {
            let factors = &self.factors;
            let factor = &factors.poles[axis.first_factor + before];
            let taps = |range: &Range<usize>| -> &[Tap<S>] { &factors.taps[range.clone()] };
            let (sums, terms) = self.flats.split_at_mut(level + 1);
            for _ in 0..factor.steps {
                terms[0].multiply(simd, taps(&factor.step));
            }
            sums[level].nest(simd, taps(&factor.own), &terms[0], taps(&factor.last));
        }
        let last = self.index[level] == axis.degree;
        self.index[level] = if last { 0 } else { self.index[level] + 1 };
        last
    }

    /// Makes the sum of the next axis a pole of this one.
    #[inline(always)]
    fn carry(&mut self, level: usize) {
        let axis = &self.shape.axes[level];
        let (sums, terms) = self.flats.split_at_mut(level + 1);
        if self.index[level] == 0 {
            sums[level].spread_from(&terms[0], &axis.rows, axis.run);
        } else {
            terms[0].spread(&axis.rows, axis.run);
        }
    }

    /// Room for the next pole of the innermost axis, zeros between its rows.
    #[inline(always)]
    fn next_pole(&mut self) -> (&Axis, &mut [S]) {
        let level = self.shape.axes.len() - 1;
        let axis = &self.shape.axes[level];
        let flat = &mut self.flats[level + usize::from(self.index[level] > 0)];
        flat.set_length(axis.rows.last().map_or(0, |start| start + axis.run));
        let target = flat.coefficients_mut();
        for pair in axis.rows.windows(2) {
            target[pair[0] + axis.run..pair[1]].fill(S::zero());
        }
        (axis, target)
    }

    /// Puts the poles of one line along the last axis, contracted with their polynomials.
    #[inline(always)]
    fn put_line(&mut self, line: &Line<'_, S>) {
        match line.width {
            1 => self.put_line_of::<1>(line),
            2 => self.put_line_of::<2>(line),
            3 => self.put_line_of::<3>(line),
            4 => self.put_line_of::<4>(line),
            _ => self.put_wide_line(line),
        }
    }

    /// The same with the width known to the compiler, so that a point stays in a register.
    #[inline(always)]
    fn put_line_of<const W: usize>(&mut self, line: &Line<'_, S>) {
        let (axis, target) = self.next_pole();
        let mut basis = line.basis.chunks_exact(line.order);
        for start in &axis.rows {
            let row = target[*start..][..axis.run].chunks_exact_mut(W);
            for (point, values) in row.zip(&mut basis) {
                let mut sum: [S; W] = std::array::from_fn(|_| S::zero());
                for (value, pole) in values.iter().zip(line.poles.chunks_exact(line.stride)) {
                    S::add_multiple(&mut sum, value, &pole[..W]);
                }
                point.clone_from_slice(&sum);
            }
        }
    }

    #[inline(always)]
    fn put_wide_line(&mut self, line: &Line<'_, S>) {
        let (axis, target) = self.next_pole();
        let mut basis = line.basis.chunks_exact(line.order);
        for start in &axis.rows {
            let row = target[*start..][..axis.run].chunks_exact_mut(line.width);
            for (point, values) in row.zip(&mut basis) {
                point.fill(S::zero());
                for (value, pole) in values.iter().zip(line.poles.chunks_exact(line.stride)) {
                    S::add_multiple(point, value, &pole[..line.width]);
                }
            }
        }
    }
}

/// Poles along the last axis and the values of their polynomials.
struct Line<'a, S> {
    poles: &'a [S],
    /// Numbers from one pole to the next.
    stride: usize,
    /// Numbers that are wanted of each.
    width: usize,
    /// For each coefficient the values of all polynomials.
    basis: &'a [S],
    order: usize,
}

impl<S: Scalar> Job for Counter<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run<V: Simd>(self, simd: V) {
        let Self { shape, inner, host, axes, top, rest } = self;
        let mut factors = Factors::new(inner, axes);
        factors.fill(shape);
        let (basis, beside) = Factors::<S>::basis_room(shape);
        let (values, rest) = rest.split_at_mut(basis);
        let (beside, mut rest) = rest.split_at_mut(beside);
        factors.basis(simd, shape, values, beside);
        let mut flats: SmallVec<[Flat<'_, S>; 4]> = SmallVec::new();
        flats.push(Flat::new(top));
        for length in shape.rooms() {
            let (first, others) = rest.split_at_mut(Flat::<S>::room(length));
            flats.push(Flat::new(first));
            rest = others;
        }
        let index = SmallVec::from_elem(0, shape.axes.len());
        let mut sums = Sums { shape, factors, flats, index };
        let (stride, width, order) = (host.width(), shape.width, shape.order);
        for poles in host.homogeneous().chunks_exact(order * stride) {
            sums.put_line(&Line { poles, stride, width, basis: Flat::within(values), order });
            let mut level = shape.axes.len() - 1;
            while sums.take(simd, level) && level > 0 {
                level -= 1;
                sums.carry(level);
            }
        }
    }
}

/// From scaled coefficients to poles.
struct Poles<'a, S> {
    scaled: &'a [S],
    orders: &'a [usize],
    width: usize,
    weight: Option<&'a S>,
}

impl<S: Scalar> Job for Poles<'_, S> {
    type Output = Vec<S>;

    #[inline(always)]
    fn run<V: Simd>(self, _: V) -> Vec<S> {
        match self.width {
            3 => self.divided::<3>(),
            4 => self.divided::<4>(),
            _ => self.divided::<1>(),
        }
    }
}

impl<S: Scalar> Poles<'_, S> {
    /// The coefficients divided by their binomials, `W` at a time, each point followed by the weight.
    #[inline(always)]
    fn divided<const W: usize>(&self) -> Vec<S> {
        let count = self.scaled.len() / self.width;
        let full = self.width + usize::from(self.weight.is_some());
        let mut poles = vec![S::zero(); count * full];
        let (last, outer) = match self.orders.split_last() {
            None => (1, products::<S>(&[])),
            Some((last, rest)) => (*last, products(rest)),
        };
        let inner = Binomials::<S>::of(last - 1);
        let mut parts = poles.chunks_exact_mut(full).zip(self.scaled.chunks_exact(self.width));
        for left in &outer {
            for (k, (pole, point)) in parts.by_ref().take(last).enumerate() {
                let divisor = left.clone() * inner.get(k);
                for (target, source) in pole.chunks_exact_mut(W).zip(point.chunks_exact(W)) {
                    let quotients: [S; W] =
                        std::array::from_fn(|k| source[k].clone() / divisor.clone());
                    target.clone_from_slice(&quotients);
                }
                if let Some(weight) = self.weight {
                    pole[full - 1] = weight.clone();
                }
            }
        }
        poles
    }
}
