//! Poles mixed from a few neighbours each.

use pforms_kernel::{Form, Result, Scalar, limit};

/// A matrix of which each row has but a few entries that are not 0, side by side.
///
/// What knots do to poles is of this kind: work and memory grow with the number of poles, not with
/// its square.
pub(super) struct Rows<S> {
    rows: Vec<Row<S>>,
}

/// The entries of a row from the first that is not 0 to the last.
#[derive(Clone)]
pub(super) struct Row<S> {
    first: usize,
    entries: Vec<S>,
}

impl<S: Scalar> Row<S> {
    /// A row from its entries, of which the outermost may be 0.
    pub(super) fn new(first: usize, mut entries: Vec<S>) -> Self {
        let last = entries.iter().rposition(|entry| !entry.is_zero()).map_or(0, |last| last + 1);
        entries.truncate(last);
        let zeros = entries.iter().take_while(|entry| entry.is_zero()).count();
        Self { first: first + zeros, entries: entries.split_off(zeros) }
    }

    /// The row that takes pole `index` as it is.
    pub(super) fn unit(index: usize) -> Self {
        Self { first: index, entries: vec![S::one()] }
    }

    /// The entry in a column.
    pub(super) fn entry(&self, column: usize) -> S {
        let index = column.checked_sub(self.first);
        index.and_then(|index| self.entries.get(index)).cloned().unwrap_or_else(S::zero)
    }

    /// `(self + factor · other) / divisor`.
    pub(super) fn with_multiple(&self, factor: &S, other: &Self, divisor: &S) -> Self {
        let end = |row: &Self| row.first + row.entries.len();
        let (first, last) = (self.first.min(other.first), end(self).max(end(other)));
        let entry =
            |column| (self.entry(column) + factor.clone() * other.entry(column)) / divisor.clone();
        Self::new(first, (first..last).map(entry).collect())
    }
}

impl<S: Scalar> Rows<S> {
    pub(super) fn new(rows: Vec<Row<S>>) -> Self {
        Self { rows }
    }

    /// One of the rows.
    pub(super) fn row(&self, index: usize) -> &Row<S> {
        &self.rows[index]
    }

    /// Mixes the poles along `axis`; the entries of a row sum to 1, so one weight for all stays.
    ///
    /// Errors: `Limit`.
    pub(super) fn act(&self, net: &Form<S>, axis: usize) -> Result<Form<S>> {
        let mut orders = net.orders().to_vec();
        let inner = orders[axis + 1..].iter().product::<usize>() * net.width();
        let block = orders[axis] * inner;
        orders[axis] = self.rows.len();
        let count = limit::check::<S>("the net of the spline", &orders, net.width())?;
        let mut poles = Vec::with_capacity(count);
        for lines in net.homogeneous().chunks_exact(block) {
            self.mix(lines, inner, &mut poles);
        }
        let mixed = Form::from_homogeneous(&orders, net.ambient(), poles)?;
        Ok(match net.uniform_weight() {
            Some(weight) => mixed.with_uniform_weight(weight),
            None => mixed,
        })
    }

    /// Appends a mixture of lines of `inner` numbers each for every row.
    pub(super) fn mix(&self, lines: &[S], inner: usize, out: &mut Vec<S>) {
        for row in &self.rows {
            row.mix(lines, inner, out);
        }
    }
}

impl<S: Scalar> Row<S> {
    /// Appends the mixture of lines of `inner` numbers each.
    fn mix(&self, lines: &[S], inner: usize, out: &mut Vec<S>) {
        let mut lines = lines[self.first * inner..].chunks_exact(inner);
        let start = out.len();
        match (self.entries.first(), lines.next()) {
            (Some(entry), Some(line)) if *entry == S::one() => out.extend_from_slice(line),
            (Some(entry), Some(line)) => out.extend(line.iter().map(|x| entry.clone() * x.clone())),
            _ => out.resize(start + inner, S::zero()),
        }
        for (entry, line) in self.entries.iter().skip(1).zip(lines) {
            S::add_multiple(&mut out[start..], entry, line);
        }
    }
}
