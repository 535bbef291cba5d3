//! Points on grids: the net is contracted axis after axis, and the last axis runs in lanes.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider sets")]

use crate::basis::bernstein_row_into;
use crate::planar::{BLOCK, Planar};
use crate::vector_rows::column_sum;
use crate::vectors::{Job, Lanes, MOST, Simd, bernstein, line_sums};
use crate::{Form, Result, bernstein_row};

/// Numbers in a table of basis values at most: they stay in the second cache.
const TABLE: usize = 1 << 14;

/// The points of forms on the grid of `parameters`, one list for each axis: a grid for each form.
pub(crate) struct Grids<'a> {
    pub forms: &'a [&'a Form<f64>],
    pub parameters: &'a [&'a [f64]],
    pub out: &'a mut [f64],
}

impl Job for Grids<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Result<()> {
        let points: usize = self.parameters.iter().map(|list| list.len()).product();
        let mut rest = self.out;
        let mut plan: Option<Plan<S>> = None;
        for form in self.forms {
            let (part, others) = rest.split_at_mut(points * form.ambient());
            rest = others;
            let plan = match &mut plan {
                Some(plan) if plan.orders == form.orders() => plan,
                plan => plan.insert(Plan::new(simd, form, self.parameters)),
            };
            plan.write(form, part)?;
        }
        Ok(())
    }
}

/// Tables and buffers for the grids of forms of the same orders.
struct Plan<'a, S: Simd> {
    orders: Vec<usize>,
    leading: Vec<Leading<'a>>,
    last: Last<'a, S>,
    planar: Planar,
}

impl<'a, S: Simd> Plan<'a, S> {
    fn new(simd: S, form: &Form<f64>, parameters: &[&'a [f64]]) -> Self {
        let mut axes = parameters.iter().zip(form.orders());
        let last = axes.next_back().map_or((&[0.0][..], 1), |(list, order)| (*list, *order));
        Self {
            orders: form.orders().to_vec(),
            leading: axes.map(|(list, order)| Leading::new(list, *order)).collect(),
            last: Last::new(simd, last.0, last.1),
            planar: Planar::default(),
        }
    }

    #[inline(always)]
    fn write(&mut self, form: &Form<f64>, out: &mut [f64]) -> Result<()> {
        let Self { leading, last, planar, .. } = self;
        planar.begin(form);
        let (ambient, length) = (form.ambient(), last.list.len());
        let lines: usize = leading.iter().map(|axis| axis.list.len()).product();
        for tile in 0..length.div_ceil(last.tile) {
            let samples = last.fill(tile);
            let together = if samples == length { BLOCK / length } else { 1 };
            for first in (0..lines).step_by(together) {
                let group = first..lines.min(first + together);
                for (place, line) in group.clone().enumerate() {
                    let anew = tile == 0 && line == 0;
                    let poles = contract_leading(last.simd, form, leading, line, anew);
                    last.put(poles, form.width(), planar, place * samples);
                }
                let start = (first * length + tile * last.tile) * ambient;
                planar.project(&mut out[start..][..group.len() * samples * ambient])?;
            }
        }
        Ok(())
    }
}

/// An axis that is contracted for one sample after another.
struct Leading<'a> {
    list: &'a [f64],
    order: usize,
    /// The basis values of all samples, where they are few.
    table: Vec<f64>,
    row: Vec<f64>,
    /// The poles contracted along this axis and those before it, at sample `at`.
    line: Vec<f64>,
    at: usize,
}

impl<'a> Leading<'a> {
    fn new(list: &'a [f64], order: usize) -> Self {
        let few = list.len().saturating_mul(order) <= TABLE;
        let samples = if few { list } else { &[] };
        let table = samples.iter().flat_map(|t| bernstein_row(order - 1, t)).collect();
        Self { list, order, table, row: Vec::new(), line: Vec::new(), at: 0 }
    }

    /// Contracts the poles with the basis values at a sample.
    #[inline(always)]
    fn contract<S: Simd>(&mut self, simd: S, poles: &[f64], at: usize) {
        self.at = at;
        let row = if self.table.is_empty() {
            bernstein_row_into(self.order - 1, &self.list[at], &mut self.row);
            &self.row[..]
        } else {
            &self.table[at * self.order..][..self.order]
        };
        let inner = poles.len() / self.order;
        self.line.resize(inner, 0.0);
        combine(simd, row, poles, &mut self.line);
    }
}

/// The poles at sample `line` of the leading axes, the last of which runs fastest. Only what has
/// changed since the line before is contracted again, or everything `anew`.
#[inline(always)]
fn contract_leading<'a, S: Simd>(
    simd: S,
    form: &'a Form<f64>,
    leading: &'a mut [Leading],
    line: usize,
    anew: bool,
) -> &'a [f64] {
    let mut stride: usize = leading.iter().map(|axis| axis.list.len()).product();
    let mut changed = anew;
    for k in 0..leading.len() {
        let (before, here) = leading.split_at_mut(k);
        let poles = before.last().map_or(form.homogeneous(), |axis| &axis.line);
        stride /= here[0].list.len();
        let at = line / stride % here[0].list.len();
        changed |= here[0].at != at;
        if changed {
            here[0].contract(simd, poles, at);
        }
    }
    leading.last().map_or(form.homogeneous(), |axis| &axis.line)
}

/// `line = Σ row · poles`, lines of poles.
#[inline(always)]
fn combine<S: Simd>(simd: S, row: &[f64], poles: &[f64], line: &mut [f64]) {
    let inner = line.len();
    let whole = inner / S::F64_LANES * S::F64_LANES;
    for start in (0..whole).step_by(S::F64_LANES) {
        let mut sum = Lanes::splat(simd, 0.0);
        for (entry, pole) in row.iter().zip(poles.chunks_exact(inner)) {
            sum = sum + Lanes::splat(simd, *entry) * Lanes::load(simd, &pole[start..]);
        }
        sum.store(&mut line[start..]);
    }
    for k in whole..inner {
        let terms = row.iter().zip(poles.chunks_exact(inner));
        line[k] = terms.fold(0.0, |sum, (entry, pole)| sum + entry * pole[k]);
    }
}

/// The last axis: its samples in tiles, and the basis values of a tile.
struct Last<'a, S: Simd> {
    simd: S,
    list: &'a [f64],
    order: usize,
    /// Samples of a tile.
    tile: usize,
    /// The tile whose basis values these are: a row for each vector of samples.
    filled: Option<usize>,
    rows: Vec<Lanes<S>>,
}

impl<'a, S: Simd> Last<'a, S> {
    fn new(simd: S, list: &'a [f64], order: usize) -> Self {
        let most = (TABLE / order / MOST * MOST).clamp(MOST, BLOCK);
        let tile = list.len().min(most);
        Self { simd, list, order, tile, filled: None, rows: Vec::new() }
    }

    /// Makes the rows of a tile, unless they are there; tells the number of samples.
    #[inline(always)]
    fn fill(&mut self, tile: usize) -> usize {
        let list = &self.list[tile * self.tile..];
        let list = &list[..list.len().min(self.tile)];
        if self.filled != Some(tile) {
            self.filled = Some(tile);
            let zero = Lanes::splat(self.simd, 0.0);
            self.rows.resize(list.len().div_ceil(S::F64_LANES) * self.order, zero);
            let samples = list.chunks(S::F64_LANES);
            for (samples, row) in samples.zip(self.rows.chunks_exact_mut(self.order)) {
                bernstein(Lanes::load_some(self.simd, samples), row);
            }
        }
        list.len()
    }

    /// Puts down the points of a line of poles at the samples of the tile, from `place` on.
    #[inline(always)]
    fn put(&self, line: &[f64], width: usize, planar: &mut Planar, place: usize) {
        match (width, planar.summed()) {
            (4, 4) => self.put_all::<4, 4>(line, planar, place),
            (4, 3) => self.put_all::<4, 3>(line, planar, place),
            (3, 3) => self.put_all::<3, 3>(line, planar, place),
            (3, 2) => self.put_all::<3, 2>(line, planar, place),
            (width, columns) => {
                for column in 0..columns {
                    self.put_column(&line[column..], width, planar, column, place);
                }
            }
        }
    }

    /// The same with the width of the poles, and the components to sum, known to the compiler.
    #[inline(always)]
    fn put_all<const W: usize, const C: usize>(
        &self,
        line: &[f64],
        planar: &mut Planar,
        place: usize,
    ) {
        let (poles, _) = line.as_chunks::<W>();
        for (group, row) in self.rows.chunks_exact(self.order).enumerate() {
            planar.put(0, place + group * S::F64_LANES, &line_sums::<S, W, C>(row, poles));
        }
    }

    /// The same for the first component of poles of any width.
    #[inline(always)]
    fn put_column(
        &self,
        line: &[f64],
        width: usize,
        planar: &mut Planar,
        column: usize,
        place: usize,
    ) {
        for (group, row) in self.rows.chunks_exact(self.order).enumerate() {
            let sum = column_sum(row, line, width);
            planar.put(column, place + group * S::F64_LANES, &[sum]);
        }
    }
}
