//! Points at scattered parameters: the sums of one point, with a point in every lane.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider sets")]

use crate::lanes::{Job, Lanes, bernstein};
use crate::lanes_basis::short_row;
use crate::planar::{BLOCK, Planar};
use crate::{Form, Result};

/// The points of a form at `parameters[axis][i]`, into `out`.
pub(crate) struct Scattered<'a> {
    pub form: &'a Form<f64>,
    pub parameters: &'a [&'a [f64]],
    pub out: &'a mut [f64],
}

impl Job for Scattered<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<const N: usize>(self) -> Result<()> {
        match *self.form.orders() {
            [2, 2] => self.write_blocks(SquareRows::<N, 2>::default()),
            [3, 3] => self.write_blocks(SquareRows::<N, 3>::default()),
            [4, 4] => self.write_blocks(SquareRows::<N, 4>::default()),
            [2, 2, 2] => self.write_blocks(CubeRows::<N, 2>::default()),
            [3, 3, 3] => self.write_blocks(CubeRows::<N, 3>::default()),
            [4, 4, 4] => self.write_blocks(CubeRows::<N, 4>::default()),
            ref orders => self.write_blocks(AnyRows::<N>::new(orders)),
        }
    }
}

impl Scattered<'_> {
    #[inline(always)]
    fn write_blocks<const N: usize>(self, mut rows: impl Rows<N>) -> Result<()> {
        let Self { form, parameters, out } = self;
        let mut planar = Planar::default();
        planar.begin(form);
        for (block, part) in out.chunks_mut(BLOCK * form.ambient()).enumerate() {
            let start = block * BLOCK;
            for at in (0..part.len() / form.ambient()).step_by(N) {
                rows.fill(|axis| Lanes::load_some(&parameters[axis][start + at..]));
                put_sums(form, rows.factors(), rows.last(), &mut planar, at);
            }
            planar.project(part)?;
        }
        Ok(())
    }
}

/// Basis values at `N` points: for the lines of poles along the last axis, and along that axis.
pub(crate) trait Rows<const N: usize> {
    /// Takes the values at parameters `t(axis)`.
    fn fill(&mut self, t: impl Fn(usize) -> Lanes<N>);

    /// For every line the product of the values along the axes before the last.
    fn factors(&self) -> &[Lanes<N>];

    /// The values along the last axis.
    fn last(&self) -> &[Lanes<N>];
}

/// Rows of a surface of the same order along both axes, known to the compiler: they stay in
/// registers.
struct SquareRows<const N: usize, const O: usize>([[Lanes<N>; O]; 2]);

impl<const N: usize, const O: usize> Default for SquareRows<N, O> {
    fn default() -> Self {
        Self([[Lanes::ZERO; O]; 2])
    }
}

impl<const N: usize, const O: usize> Rows<N> for SquareRows<N, O> {
    #[inline(always)]
    fn fill(&mut self, t: impl Fn(usize) -> Lanes<N>) {
        for (axis, row) in self.0.iter_mut().enumerate() {
            *row = short_row(t(axis));
        }
    }

    #[inline(always)]
    fn factors(&self) -> &[Lanes<N>] {
        &self.0[0]
    }

    #[inline(always)]
    fn last(&self) -> &[Lanes<N>] {
        &self.0[1]
    }
}

/// The same for a volume.
struct CubeRows<const N: usize, const O: usize> {
    factors: [[Lanes<N>; O]; O],
    last: [Lanes<N>; O],
}

impl<const N: usize, const O: usize> Default for CubeRows<N, O> {
    fn default() -> Self {
        Self { factors: [[Lanes::ZERO; O]; O], last: [Lanes::ZERO; O] }
    }
}

impl<const N: usize, const O: usize> Rows<N> for CubeRows<N, O> {
    #[inline(always)]
    fn fill(&mut self, t: impl Fn(usize) -> Lanes<N>) {
        let (first, second) = (short_row::<N, O>(t(0)), short_row::<N, O>(t(1)));
        self.factors = first.map(|a| second.map(|b| a * b));
        self.last = short_row(t(2));
    }

    #[inline(always)]
    fn factors(&self) -> &[Lanes<N>] {
        self.factors.as_flattened()
    }

    #[inline(always)]
    fn last(&self) -> &[Lanes<N>] {
        &self.last
    }
}

/// Rows of any number of axes of any order.
pub(crate) struct AnyRows<const N: usize> {
    orders: Vec<usize>,
    factors: Vec<Lanes<N>>,
    rows: Vec<Lanes<N>>,
}

impl<const N: usize> AnyRows<N> {
    pub(crate) fn new(orders: &[usize]) -> Self {
        let most = orders.iter().max().copied().unwrap_or(1);
        Self { orders: orders.to_vec(), factors: Vec::new(), rows: vec![Lanes::ONE; most] }
    }
}

impl<const N: usize> Rows<N> for AnyRows<N> {
    #[inline(always)]
    fn fill(&mut self, t: impl Fn(usize) -> Lanes<N>) {
        self.factors.clear();
        self.factors.push(Lanes::ONE);
        for (axis, &order) in self.orders.iter().enumerate() {
            let row = &mut self.rows[..order];
            bernstein(t(axis), row);
            if axis + 1 < self.orders.len() {
                spread(&mut self.factors, row);
            }
        }
    }

    #[inline(always)]
    fn factors(&self) -> &[Lanes<N>] {
        &self.factors
    }

    #[inline(always)]
    fn last(&self) -> &[Lanes<N>] {
        &self.rows[..self.orders.last().copied().unwrap_or(1)]
    }
}

/// Every factor becomes its products with the entries of a row, from the last on.
#[inline(always)]
fn spread<const N: usize>(factors: &mut Vec<Lanes<N>>, row: &[Lanes<N>]) {
    let count = factors.len();
    factors.resize(count * row.len(), Lanes::ZERO);
    for i in (0..count).rev() {
        let factor = factors[i];
        for (product, entry) in factors[i * row.len()..].iter_mut().zip(row) {
            *product = factor * *entry;
        }
    }
}

/// Sums the poles of a form for `N` points; the common widths are known to the compiler.
#[inline(always)]
fn put_sums<const N: usize>(
    form: &Form<f64>,
    factors: &[Lanes<N>],
    last: &[Lanes<N>],
    planar: &mut Planar,
    at: usize,
) {
    let poles = form.homogeneous();
    match (form.width(), planar.columns()) {
        (4, 4) => planar.put(0, at, &sums::<N, 4, 4>(poles, factors, last)),
        (4, 3) => planar.put(0, at, &sums::<N, 4, 3>(poles, factors, last)),
        (3, 3) => planar.put(0, at, &sums::<N, 3, 3>(poles, factors, last)),
        (3, 2) => planar.put(0, at, &sums::<N, 3, 2>(poles, factors, last)),
        (width, columns) => {
            for column in 0..columns {
                planar.put(column, at, &sum_column(poles, width, column, factors, last));
            }
        }
    }
}

/// `Σ factor · Σ row · pole` of the first `C` components of poles of `W` numbers.
#[inline(always)]
fn sums<const N: usize, const W: usize, const C: usize>(
    poles: &[f64],
    factors: &[Lanes<N>],
    last: &[Lanes<N>],
) -> [Lanes<N>; C] {
    let (poles, _) = poles.as_chunks::<W>();
    let mut total = [Lanes::ZERO; C];
    for (factor, line) in factors.iter().zip(poles.chunks_exact(last.len())) {
        let sum = line_sums::<N, W, C>(line, last);
        for c in 0..C {
            total[c] = total[c] + *factor * sum[c];
        }
    }
    total
}

/// `Σ row · pole` along a line of poles.
#[inline(always)]
pub(crate) fn line_sums<const N: usize, const W: usize, const C: usize>(
    line: &[[f64; W]],
    row: &[Lanes<N>],
) -> [Lanes<N>; C] {
    let mut sum = [Lanes::ZERO; C];
    for (entry, pole) in row.iter().zip(line) {
        for c in 0..C {
            sum[c] = sum[c] + *entry * Lanes::splat(pole[c]);
        }
    }
    sum
}

/// The same for one component of poles of any width.
#[inline(always)]
fn sum_column<const N: usize>(
    poles: &[f64],
    width: usize,
    column: usize,
    factors: &[Lanes<N>],
    last: &[Lanes<N>],
) -> [Lanes<N>; 1] {
    let mut total = Lanes::ZERO;
    for (factor, line) in factors.iter().zip(poles.chunks_exact(last.len() * width)) {
        let mut sum = Lanes::ZERO;
        for (entry, pole) in last.iter().zip(line.chunks_exact(width)) {
            sum = sum + *entry * Lanes::splat(pole[column]);
        }
        total = total + *factor * sum;
    }
    [total]
}
