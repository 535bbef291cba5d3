//! The knots of one axis, and the rows of numbers by which they mix poles.

use std::cmp::Ordering;
use std::ops::Range;

use pforms_kernel::{Error, Matrix, Result, Scalar, limit};

use super::rows::{Row, Rows};

/// A degree and a knot vector: how one axis of a [`Spline`](super::Spline) is cut into pieces.
///
/// `n` poles of degree `p` have `n + p + 1` knots `u_0 ≤ u_1 ≤ …`; the window is `[u_p, u_n]`. A knot
/// may be repeated `p + 1` times at most: `p` times lets the pieces meet in a pole, `p + 1` times
/// lets them part. Full vectors are used, as in *The NURBS Book*: ends repeated `p + 1` times make
/// the spline begin and end in its first and last pole.
#[derive(Clone, Debug, PartialEq)]
pub struct Knots<S = f64> {
    pub(super) degree: usize,
    pub(super) list: Vec<S>,
}

impl<S: Scalar> Knots<S> {
    /// A knot vector of a degree.
    ///
    /// Errors: `Shape` for fewer than `2·degree + 2` knots; `Domain` when a knot is not finite or
    /// less than the one before, when more than `degree + 1` coincide, when the window is empty, or
    /// when the difference of two knots is not finite.
    pub fn new(degree: usize, list: Vec<S>) -> Result<Self> {
        let least = degree.saturating_mul(2).saturating_add(2);
        if list.len() < least {
            return Err(Error::shape(
                "knots",
                format!("{} knots", list.len()),
                format!("at least {least} for degree {degree}: poles + degree + 1"),
            ));
        }
        if let Some(at) = list.iter().position(|knot| !knot.is_finite()) {
            let received = format!("{:?} as knot {at}", list[at]);
            return Err(Error::domain("knots", received, "finite numbers"));
        }
        if let Some(at) = list.windows(2).position(|pair| pair[1] < pair[0]) {
            return Err(Error::domain(
                "knots",
                format!("{:?} before {:?}, knots {at} and {}", list[at], list[at + 1], at + 1),
                "knots that do not decrease",
            ));
        }
        let (first, last) = (&list[0], &list[list.len() - 1]);
        if !(last.clone() - first.clone()).is_finite() {
            let received = format!("{first:?} to {last:?}");
            return Err(Error::domain("knots", received, "knots whose differences are finite"));
        }
        if let Some(at) = (0..list.len() - degree - 1).find(|&i| list[i] == list[i + degree + 1]) {
            return Err(Error::domain(
                "knots",
                format!("{:?} repeated more than {} times", list[at], degree + 1),
                format!("at most {} equal knots for degree {degree}", degree + 1),
            ));
        }
        let (from, to) = (&list[degree], &list[list.len() - degree - 1]);
        if from == to {
            return Err(Error::domain(
                "knots",
                format!("the window from {from:?} to {to:?}"),
                format!("knot {degree} less than knot {}", list.len() - degree - 1),
            ));
        }
        Ok(Self { degree, list })
    }

    /// Pieces that meet in a pole at each of the inner `breaks`; ends repeated `degree + 1` times.
    pub(super) fn of_breaks(degree: usize, breaks: &[S], inner: usize) -> Result<Self> {
        let ends = [0, breaks.len() - 1];
        let times = |index: usize| if ends.contains(&index) { degree + 1 } else { inner };
        let repeated = breaks.iter().enumerate().map(|(i, t)| vec![t.clone(); times(i)]);
        Self::new(degree, repeated.flatten().collect())
    }

    /// The degree.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The whole vector.
    pub fn as_slice(&self) -> &[S] {
        &self.list
    }

    /// Number of poles they mix.
    pub fn order(&self) -> usize {
        self.list.len() - self.degree - 1
    }

    /// Where the spline begins and ends.
    pub fn window(&self) -> (&S, &S) {
        (&self.list[self.degree], &self.list[self.order()])
    }

    /// The different knots of the window, ends included: where pieces begin and end.
    pub fn breaks(&self) -> Vec<S> {
        let mut breaks: Vec<S> = self.list[self.degree..=self.order()].to_vec();
        breaks.dedup();
        breaks
    }

    /// How many knots are equal to `t`.
    pub fn multiplicity(&self, t: &S) -> usize {
        let before = self.list.partition_point(|knot| knot < t);
        self.list[before..].iter().take_while(|knot| *knot == t).count()
    }

    /// The last `i` of the window with `u_i ≤ t` and `u_i < u_{i+1}`; before the window the first.
    pub(super) fn span(&self, t: &S) -> usize {
        let (first, last) = (self.degree, self.order());
        let after = self.list[first..last].partition_point(|knot| knot <= t);
        self.span_from(first + after.saturating_sub(1))
    }

    /// The span at or next to index `i`: the spans before it are empty.
    fn span_from(&self, i: usize) -> usize {
        let nonempty = |i: &usize| self.list[*i] < self.list[*i + 1];
        let (first, last) = (self.degree, self.order());
        (i..last).find(nonempty).or_else(|| (first..i).rev().find(nonempty)).unwrap_or(first)
    }

    /// The spans that are not empty, in order.
    pub(super) fn spans(&self) -> Vec<usize> {
        (self.degree..self.order()).filter(|&i| self.list[i] < self.list[i + 1]).collect()
    }

    /// The blossom of the piece over `span` at `arguments`, as factors of poles `span − p … span`.
    ///
    /// De Boor's triangle run on numbers: each step shares a factor between two neighbours. With
    /// arguments in the window and span all factors are between 0 and 1.
    pub(super) fn blossom(&self, span: usize, arguments: &[S]) -> Vec<S> {
        let degree = self.degree;
        let mut factors = vec![S::zero(); degree + 1];
        factors[degree] = S::one();
        // The last step of the triangle first: at `step` the values left are `degree − step + 1 …`.
        for (step, t) in (1..=degree).rev().zip(arguments) {
            for i in step..=degree {
                let low = &self.list[span - degree + i];
                let high = &self.list[span + 1 + i - step];
                let share = (t.clone() - low.clone()) / (high.clone() - low.clone());
                let whole = factors[i].clone();
                factors[i - 1] += (S::one() - share.clone()) * whole.clone();
                factors[i] = share * whole;
            }
        }
        factors
    }

    /// The values at `t` of the basis functions that do not vanish there, and the first of them.
    pub(crate) fn basis(&self, t: &S) -> (usize, Vec<S>) {
        let span = self.span(t);
        (span - self.degree, self.blossom(span, &vec![t.clone(); self.degree]))
    }

    /// The matrix from the poles over these knots to those over `finer` ones, by blossoms: pole `j`
    /// is the blossom at `finer[j+1 … j+p]` (Goldman and Lyche; the Oslo algorithm).
    ///
    /// `finer` holds every knot of the inside of its own window at least as often as `self`.
    pub(super) fn refinement(&self, finer: &Self) -> Result<Rows<S>> {
        self.rows_over(finer, |span, arguments| self.blossom(span, arguments))
    }

    /// The matrix to the poles of one degree more over `raised` knots: the blossom of degree
    /// `p + 1` is the mean of those of degree `p` with one argument left out.
    pub(super) fn elevation(&self, raised: &Self) -> Result<Rows<S>> {
        let share = S::ratio(1, self.degree as i64 + 1);
        self.rows_over(raised, |span, arguments| {
            let mut sum = vec![S::zero(); self.degree + 1];
            for k in 0..arguments.len() {
                let others = [&arguments[..k], &arguments[k + 1..]].concat();
                S::add_multiple(&mut sum, &share, &self.blossom(span, &others));
            }
            sum
        })
    }

    /// A single row of the [`refinement`](Self::refinement).
    pub(super) fn refined_pole(&self, finer: &Self, j: usize) -> Row<S> {
        self.row_over(finer, j, |span, arguments| self.blossom(span, arguments))
    }

    fn rows_over(&self, new: &Self, row: impl Fn(usize, &[S]) -> Vec<S>) -> Result<Rows<S>> {
        limit::check::<S>("the refined knots", &[new.order(), self.degree + 1], 1)?;
        Ok(Rows::new((0..new.order()).map(|j| self.row_over(new, j, &row)).collect()))
    }

    fn row_over(&self, new: &Self, j: usize, row: impl Fn(usize, &[S]) -> Vec<S>) -> Row<S> {
        let mut within = j.max(new.degree)..=(j + new.degree).min(new.order() - 1);
        let start = *within.start();
        let piece = within.find(|&i| new.list[i] < new.list[i + 1]);
        let span = self.span(&new.list[piece.unwrap_or(start)]);
        // From the span outwards, knots before it backwards: then every step of the triangle lies
        // between its ends, and nothing large cancels.
        let mut arguments = new.list[j + 1..=j + new.degree].to_vec();
        let before = arguments.partition_point(|knot| *knot <= self.list[span]);
        arguments[..before].reverse();
        Row::new(span - self.degree, row(span, &arguments))
    }

    /// The matrix from the poles to the Bézier poles of the piece over `span`.
    pub(super) fn extraction(&self, span: usize) -> (Range<usize>, Matrix<S>) {
        let (from, to) = (&self.list[span], &self.list[span + 1]);
        let degree = self.degree;
        let matrix = Matrix::from_writer(degree + 1, degree + 1, |i, entries| {
            let mut arguments = vec![from.clone(); degree - i];
            arguments.resize(degree, to.clone());
            entries.clone_from_slice(&self.blossom(span, &arguments));
        });
        (span - degree..span + 1, matrix)
    }

    /// For each piece its length, the first function that is not 0 on it, and a row for each of its
    /// Bézier poles: those of the `p + 1` functions there.
    pub(crate) fn bezier_rows(&self) -> impl Iterator<Item = (S, usize, Vec<Vec<S>>)> {
        self.spans().into_iter().map(|span| {
            let (poles, matrix) = self.extraction(span);
            let rows = (0..matrix.rows()).map(|i| matrix.row(i).to_vec()).collect();
            (self.list[span + 1].clone() - self.list[span].clone(), poles.start, rows)
        })
    }

    /// Do the poles `span − p … span` belong to the piece as they are?
    pub(super) fn is_bezier_over(&self, span: usize) -> bool {
        let degree = self.degree;
        self.list[span + 1 - degree..=span].iter().all(|knot| *knot == self.list[span])
            && self.list[span + 1..=span + degree].iter().all(|knot| *knot == self.list[span + 1])
    }

    /// Is there one piece, which has the poles as they are?
    pub(super) fn is_one_piece(&self) -> bool {
        self.order() == self.degree + 1 && self.is_bezier_over(self.degree)
    }

    /// These knots with more of them.
    ///
    /// Errors: `Domain` for a knot outside the window, or one more often than `degree + 1` times.
    pub fn with(&self, more: &[S]) -> Result<Self> {
        let (from, to) = self.window();
        if let Some(knot) = more.iter().find(|t| !t.is_finite() || *t < from || *t > to) {
            return Err(Error::domain(
                "knots",
                format!("{knot:?}"),
                format!("knots in the window from {from:?} to {to:?}"),
            ));
        }
        let mut list = [self.list.as_slice(), more].concat();
        list.sort_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
        Self::new(self.degree, list)
    }

    /// Every break as often as lets the pieces meet in a pole, knots that part pieces left alone.
    pub(super) fn full(&self) -> Result<Self> {
        let breaks = self.breaks();
        let last = breaks.len() - 1;
        let times = |(index, t): (usize, &S)| match index {
            0 => self.degree + 1,
            index if index == last => self.degree + 1,
            _ => self.multiplicity(t).max(self.degree),
        };
        let repeated = breaks.iter().enumerate().map(|pair| vec![pair.1.clone(); times(pair)]);
        Self::new(self.degree, repeated.flatten().collect())
    }

    /// The knots of one degree more: every knot once more, those no longer needed dropped.
    pub(super) fn raised(&self) -> Result<Self> {
        let mut list = Vec::with_capacity(2 * self.list.len());
        for (index, knot) in self.list.iter().enumerate() {
            list.push(knot.clone());
            if self.list.get(index + 1) != Some(knot) {
                list.push(knot.clone());
            }
        }
        let (from, to) = self.window();
        let needed = self.degree + 2;
        let spare_before = list.partition_point(|knot| knot <= from) - needed;
        let spare_after = list.len() - list.partition_point(|knot| knot < to) - needed;
        list.truncate(list.len() - spare_after);
        Self::new(self.degree + 1, list.split_off(spare_before))
    }

    /// The knots of the part from `a` to `b`, which becomes the window.
    pub(super) fn restricted(&self, a: &S, b: &S) -> Result<Self> {
        let (from, to) = self.window();
        let inside = self.list.iter().filter(|t| *t > a && *t < b && *t > from && *t < to);
        let mut list = vec![a.clone(); self.degree + 1];
        list.extend(inside.cloned());
        list.extend(vec![b.clone(); self.degree + 1]);
        Self::new(self.degree, list)
    }

    /// The knots run backwards, over the same window.
    ///
    /// Errors: `Domain` when rounding would let knots fall together.
    pub(super) fn reversed(&self) -> Result<Self> {
        let (from, to) = self.window();
        let turned = |knot: &S| {
            if knot == from {
                return to.clone();
            }
            let turned = from.clone() + (to.clone() - knot.clone());
            // Rounding must not let an inner knot pass the end.
            if knot > from && turned > *to { to.clone() } else { turned }
        };
        Self::new(self.degree, self.list.iter().rev().map(turned).collect())
    }

    /// The knots on another window, all at the same relative places.
    ///
    /// Errors: `Domain` when the window is empty or so small that knots fall together.
    pub(super) fn on_window(&self, a: &S, b: &S) -> Result<Self> {
        let (from, to) = self.window();
        let length = to.clone() - from.clone();
        let moved = |knot: &S| {
            if knot == to {
                return b.clone();
            }
            let share = (knot.clone() - from.clone()) / length.clone();
            a.clone() + share * (b.clone() - a.clone())
        };
        Self::new(self.degree, self.list.iter().map(moved).collect())
    }
}
