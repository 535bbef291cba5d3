//! What the poles of a host are multiplied by when a form is immersed in it.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider vectors")]

use std::ops::Range;
use std::slice;

use pforms_kernel::vectors::Simd;
use pforms_kernel::{Binomials, Flat, Form, Scalar, Tap};
use smallvec::SmallVec;

use super::immersion_shape::{Axis, Shape};

/// A list that is short for small forms.
pub(super) type Short<S> = SmallVec<[S; 32]>;

/// The polynomials `X_j` and `S_j = W − X_j` of an inner form, and what is made from them.
pub(super) struct Factors<'a, S> {
    inner: &'a Form<S>,
    /// For each axis of the host, the coordinate that is its parameter.
    axes: &'a [usize],
    /// The binomials that scale each pole.
    scales: Short<S>,
    pub taps: SmallVec<[Tap<S>; 64]>,
    /// For each axis of the host but the last, the factors of all poles but the first.
    pub poles: SmallVec<[Factor; 12]>,
}

/// Coefficients from which on a product is better added up in memory than number by number.
const MANY: usize = 32;

/// What one pole of an axis is multiplied by, as ranges of taps.
pub(super) struct Factor {
    /// `S`: what the sum before is multiplied by.
    pub own: Range<usize>,
    /// `X`: what the pole is multiplied by first, `steps` times.
    pub step: Range<usize>,
    pub steps: usize,
    /// `C(n,k)·X` after that, or `C(n,k)·X^k` at once.
    pub last: Range<usize>,
}

impl<'a, S: Scalar> Factors<'a, S> {
    #[inline(always)]
    pub(super) fn new(inner: &'a Form<S>, axes: &'a [usize]) -> Self {
        let (taps, poles) = (SmallVec::new(), SmallVec::new());
        Self { inner, axes, scales: products(inner.orders()), taps, poles }
    }

    /// Makes the factors of all axes but the last.
    #[inline(always)]
    pub(super) fn fill(&mut self, shape: &Shape) {
        for (j, axis) in shape.axes.iter().enumerate() {
            if axis.degree > 0 {
                self.add_axis(j, axis, shape.width);
            }
        }
    }

    #[inline(always)]
    fn add_axis(&mut self, j: usize, axis: &Axis, width: usize) {
        let start = self.taps.len();
        let count = axis.places.len();
        for complement in [true, false] {
            for (i, place) in axis.places.iter().enumerate() {
                let factor = self.coefficient(i, j, complement);
                self.taps.push(Tap { shift: place * width, factor });
            }
        }
        let (own, step) = (start..start + count, start + count..start + 2 * count);
        let mut power: Short<S> = SmallVec::new();
        for (k, choices) in Binomials::<S>::of(axis.degree).iter().enumerate().skip(1) {
            let at_once = axis.powers[k - 1];
            let begin = self.taps.len();
            if k > 1 && at_once {
                power = self.times_step(&power, axis, step.clone());
                self.add_power(&power, &choices, width);
            } else {
                self.add_multiple(step.clone(), &choices);
            }
            let steps = if at_once { 0 } else { k - 1 };
            let last = begin..self.taps.len();
            self.poles.push(Factor { own: own.clone(), step: step.clone(), steps, last });
        }
    }

    /// Coefficient `i` of `X`, or of its complement `S`, for axis `j` of the host.
    #[inline(always)]
    fn coefficient(&self, i: usize, j: usize, complement: bool) -> S {
        let pole = &self.inner.homogeneous()[i * self.inner.width()..][..self.inner.width()];
        let x = pole[self.axes[j]].clone();
        let value = if complement { pole[self.inner.ambient()].clone() - x } else { x };
        self.scales[i].clone() * value
    }

    /// Other taps once more, times a number.
    #[inline(always)]
    fn add_multiple(&mut self, range: Range<usize>, factor: &S) {
        for index in range {
            let tap = &self.taps[index];
            let tap = Tap { shift: tap.shift, factor: factor.clone() * tap.factor.clone() };
            self.taps.push(tap);
        }
    }

    /// The power of `X` after this one, flat; `X²` after nothing.
    #[inline(always)]
    fn times_step(&self, power: &[S], axis: &Axis, step: Range<usize>) -> Short<S> {
        let taps = &self.taps[step];
        let mut first: Short<S> = SmallVec::new();
        if power.is_empty() {
            first.resize(axis.places.last().map_or(0, |last| last + 1), S::zero());
            for (place, tap) in axis.places.iter().zip(taps) {
                first[*place] = tap.factor.clone();
            }
        }
        let power = if power.is_empty() { &first } else { power };
        let reach = axis.places.last().map_or(0, |last| last + power.len());
        let mut product = Short::new();
        if power.len() > MANY {
            product.resize(reach, S::zero());
            for (place, tap) in axis.places.iter().zip(taps) {
                S::add_multiple(&mut product[*place..][..power.len()], &tap.factor, power);
            }
            return product;
        }
        for k in 0..reach {
            let mut sum = S::zero();
            for (place, tap) in axis.places.iter().zip(taps) {
                if let Some(x) = k.checked_sub(*place).and_then(|index| power.get(index)) {
                    S::add_multiple(slice::from_mut(&mut sum), &tap.factor, slice::from_ref(x));
                }
            }
            product.push(sum);
        }
        product
    }

    /// Its coefficients as taps, no zeros but the last.
    #[inline(always)]
    fn add_power(&mut self, power: &[S], factor: &S, width: usize) {
        for (place, x) in power.iter().enumerate() {
            if place + 1 == power.len() || !x.is_zero() {
                let factor = factor.clone() * x.clone();
                self.taps.push(Tap { shift: place * width, factor });
            }
        }
    }

    /// Numbers that [`Factors::basis`] needs, for the basis and beside it.
    pub(super) fn basis_room(shape: &Shape) -> (usize, usize) {
        let room = Flat::<S>::room;
        (room(shape.basis_room * shape.order), room(shape.basis_room))
    }

    /// Makes the polynomials `C(n,k)·S^{n−k}·X^k` of the last axis, flat: for each coefficient the
    /// values of all.
    ///
    /// Row by row of their triangle: each is `X` times its left neighbour of the row above, which
    /// lies one place before; the first is a power of `S`.
    #[inline(always)]
    pub(super) fn basis<V: Simd>(
        &self,
        simd: V,
        shape: &Shape,
        values: &mut [S],
        beside: &mut [S],
    ) {
        let order = shape.order;
        let axis = shape.axes.len();
        let mut own: SmallVec<[Tap<S>; 16]> = SmallVec::new();
        let mut right = own.clone();
        if order > 1 {
            for (i, &shift) in shape.basis_places.iter().enumerate() {
                own.push(Tap { shift, factor: self.coefficient(i, axis, true) });
                let factor = self.coefficient(i, axis, false);
                right.push(Tap { shift: shift * order + 1, factor });
            }
        }
        let (mut power, mut values) = (Flat::new(beside), Flat::new(values));
        power.set_one();
        values.set_one();
        for _ in 1..order {
            power.multiply(simd, &own);
            values.multiply(simd, &right);
            let rows = values.coefficients_mut().iter_mut().step_by(order);
            for (value, power) in rows.zip(power.coefficients()) {
                value.clone_from(power);
            }
        }
        let choices = Binomials::<S>::of(order - 1);
        for row in values.coefficients_mut().chunks_exact_mut(order) {
            for (k, value) in row.iter_mut().enumerate() {
                *value = choices.get(k) * value.clone();
            }
        }
    }
}

/// The products of the binomials of several axes, in C order.
#[inline(always)]
pub(super) fn products<S: Scalar>(orders: &[usize]) -> Short<S> {
    let mut all: Short<S> = SmallVec::new();
    all.push(S::one());
    for order in orders.iter().rev() {
        let row = Binomials::<S>::of(order - 1);
        let known = all.len();
        for k in 1..*order {
            for i in 0..known {
                all.push(all[i].clone() * row.get(k));
            }
        }
    }
    all
}
