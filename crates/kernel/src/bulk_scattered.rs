//! Points at scattered parameters: the sums of one point, with a point in every lane.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use crate::planar::{BLOCK, Planar};
use crate::vector_rows::{column_sum, short_row};
use crate::vectors::{Job, Lanes, Simd, bernstein, line_sums};
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
    fn run<S: Simd>(self, simd: S) -> Result<()> {
        match *self.form.orders() {
            [2, 2] => self.write(simd, SquareRows::<S, 2>::new(simd)),
            [3, 3] => self.write(simd, SquareRows::<S, 3>::new(simd)),
            [4, 4] => self.write(simd, SquareRows::<S, 4>::new(simd)),
            [2, 2, 2] => self.write(simd, CubeRows::<S, 2>::new(simd)),
            [3, 3, 3] => self.write(simd, CubeRows::<S, 3>::new(simd)),
            [4, 4, 4] => self.write(simd, CubeRows::<S, 4>::new(simd)),
            ref orders => self.write(simd, AnyRows::new(simd, orders)),
        }
    }
}

impl Scattered<'_> {
    /// Goes on with the width of the poles, and the components to be summed, known to the compiler.
    #[inline(always)]
    fn write<S: Simd>(self, simd: S, rows: impl Rows<S>) -> Result<()> {
        let mut planar = Planar::default();
        planar.begin(self.form);
        match (self.form.width(), planar.summed()) {
            (4, 4) => self.write_blocks::<S, 4, 4>(simd, rows, planar),
            (4, 3) => self.write_blocks::<S, 4, 3>(simd, rows, planar),
            (3, 3) => self.write_blocks::<S, 3, 3>(simd, rows, planar),
            (3, 2) => self.write_blocks::<S, 3, 2>(simd, rows, planar),
            _ => self.write_any_width(simd, rows, planar),
        }
    }

    #[inline(always)]
    fn write_blocks<S: Simd, const W: usize, const C: usize>(
        self,
        simd: S,
        mut rows: impl Rows<S>,
        mut planar: Planar,
    ) -> Result<()> {
        let (poles, _) = self.form.homogeneous().as_chunks::<W>();
        let ambient = W - 1;
        for (block, out) in self.out.chunks_mut(BLOCK * ambient).enumerate() {
            let start = block * BLOCK;
            for at in (0..out.len() / ambient).step_by(S::F64_LANES) {
                rows.fill(|axis| Lanes::load_some(simd, &self.parameters[axis][start + at..]));
                planar.put(0, at, &rows.sums::<W, C>(poles));
            }
            planar.project(out)?;
        }
        Ok(())
    }

    /// The same for poles of any width, one component after another.
    fn write_any_width<S: Simd>(
        self,
        simd: S,
        mut rows: impl Rows<S>,
        mut planar: Planar,
    ) -> Result<()> {
        let Self { form, parameters, out } = self;
        for (block, out) in out.chunks_mut(BLOCK * form.ambient()).enumerate() {
            let start = block * BLOCK;
            for at in (0..out.len() / form.ambient()).step_by(S::F64_LANES) {
                rows.fill(|axis| Lanes::load_some(simd, &parameters[axis][start + at..]));
                for column in 0..planar.summed() {
                    let poles = &form.homogeneous()[column..];
                    planar.put(column, at, &[sum_column(poles, form.width(), &rows)]);
                }
            }
            planar.project(out)?;
        }
        Ok(())
    }
}

/// Basis values at `N` points: for the lines of poles along the last axis, and along that axis.
trait Rows<S: Simd> {
    /// Takes the values at parameters `t(axis)`.
    fn fill(&mut self, t: impl Fn(usize) -> Lanes<S>);

    /// For every line the product of the values along the axes before the last.
    fn factors(&self) -> &[Lanes<S>];

    /// The values along the last axis.
    fn last(&self) -> &[Lanes<S>];

    /// `Σ factor · Σ value · pole` of the first `C` components of all poles.
    #[inline(always)]
    fn sums<const W: usize, const C: usize>(&self, poles: &[[f64; W]]) -> [Lanes<S>; C] {
        let last = self.last();
        let mut total = [Lanes::splat(last[0].simd(), 0.0); C];
        for (factor, line) in self.factors().iter().zip(poles.chunks_exact(last.len())) {
            add_line(&mut total, *factor, last, line);
        }
        total
    }
}

/// Rows of a surface of the same order along both axes, known to the compiler: they stay in
/// registers.
struct SquareRows<S: Simd, const O: usize>([[Lanes<S>; O]; 2]);

impl<S: Simd, const O: usize> SquareRows<S, O> {
    #[inline(always)]
    fn new(simd: S) -> Self {
        Self([[Lanes::splat(simd, 0.0); O]; 2])
    }
}

impl<S: Simd, const O: usize> Rows<S> for SquareRows<S, O> {
    #[inline(always)]
    fn fill(&mut self, t: impl Fn(usize) -> Lanes<S>) {
        for (axis, row) in self.0.iter_mut().enumerate() {
            *row = short_row(t(axis));
        }
    }

    #[inline(always)]
    fn factors(&self) -> &[Lanes<S>] {
        &self.0[0]
    }

    #[inline(always)]
    fn last(&self) -> &[Lanes<S>] {
        &self.0[1]
    }

    #[inline(always)]
    fn sums<const W: usize, const C: usize>(&self, poles: &[[f64; W]]) -> [Lanes<S>; C] {
        let (lines, _) = poles.as_chunks::<O>();
        assert!(lines.len() >= O);
        let mut total = [Lanes::splat(self.0[0][0].simd(), 0.0); C];
        for i in 0..O {
            add_line(&mut total, self.0[0][i], &self.0[1], &lines[i]);
        }
        total
    }
}

/// The same for a volume.
struct CubeRows<S: Simd, const O: usize> {
    factors: [[Lanes<S>; O]; O],
    last: [Lanes<S>; O],
}

impl<S: Simd, const O: usize> CubeRows<S, O> {
    #[inline(always)]
    fn new(simd: S) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        Self { factors: [[zero; O]; O], last: [zero; O] }
    }
}

impl<S: Simd, const O: usize> Rows<S> for CubeRows<S, O> {
    #[inline(always)]
    fn fill(&mut self, t: impl Fn(usize) -> Lanes<S>) {
        let (first, second) = (short_row::<S, O>(t(0)), short_row::<S, O>(t(1)));
        for i in 0..O {
            for j in 0..O {
                self.factors[i][j] = first[i] * second[j];
            }
        }
        self.last = short_row(t(2));
    }

    #[inline(always)]
    fn factors(&self) -> &[Lanes<S>] {
        self.factors.as_flattened()
    }

    #[inline(always)]
    fn last(&self) -> &[Lanes<S>] {
        &self.last
    }
}

/// Rows of any number of axes of any order.
struct AnyRows<S: Simd> {
    simd: S,
    orders: Vec<usize>,
    factors: Vec<Lanes<S>>,
    rows: Vec<Lanes<S>>,
}

impl<S: Simd> AnyRows<S> {
    fn new(simd: S, orders: &[usize]) -> Self {
        let most = orders.iter().max().copied().unwrap_or(1);
        let rows = vec![Lanes::splat(simd, 1.0); most];
        Self { simd, orders: orders.to_vec(), factors: Vec::new(), rows }
    }
}

impl<S: Simd> Rows<S> for AnyRows<S> {
    #[inline(always)]
    fn fill(&mut self, t: impl Fn(usize) -> Lanes<S>) {
        self.factors.clear();
        self.factors.push(Lanes::splat(self.simd, 1.0));
        for (axis, &order) in self.orders.iter().enumerate() {
            let row = &mut self.rows[..order];
            bernstein(t(axis), row);
            if axis + 1 < self.orders.len() {
                spread(&mut self.factors, row);
            }
        }
    }

    #[inline(always)]
    fn factors(&self) -> &[Lanes<S>] {
        &self.factors
    }

    #[inline(always)]
    fn last(&self) -> &[Lanes<S>] {
        &self.rows[..self.orders.last().copied().unwrap_or(1)]
    }
}

/// Every factor becomes its products with the entries of a row, from the last on.
#[inline(always)]
fn spread<S: Simd>(factors: &mut Vec<Lanes<S>>, row: &[Lanes<S>]) {
    let count = factors.len();
    factors.resize(count * row.len(), row[0]);
    for i in (0..count).rev() {
        let factor = factors[i];
        for (product, entry) in factors[i * row.len()..].iter_mut().zip(row) {
            *product = factor * *entry;
        }
    }
}

/// `total += factor · Σ value · pole` along a line of poles.
#[inline(always)]
fn add_line<S: Simd, const W: usize, const C: usize>(
    total: &mut [Lanes<S>; C],
    factor: Lanes<S>,
    values: &[Lanes<S>],
    line: &[[f64; W]],
) {
    let sum = line_sums::<S, W, C>(values, line);
    for c in 0..C {
        total[c] = total[c] + factor * sum[c];
    }
}

/// [`Rows::sums`] for the first component of poles of any width.
#[inline(always)]
fn sum_column<S: Simd>(poles: &[f64], width: usize, rows: &impl Rows<S>) -> Lanes<S> {
    let last = rows.last();
    let mut total = Lanes::splat(last[0].simd(), 0.0);
    for (factor, line) in rows.factors().iter().zip(poles.chunks(last.len() * width)) {
        total = total + *factor * column_sum(last, line, width);
    }
    total
}
