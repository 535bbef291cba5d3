//! Many knots of one axis taken out, in time that grows with their number and not with its square.

use std::mem;

use pforms_kernel::{Form, Result, Scalar};

use super::removal::{farthest, removal};
use super::rows::{Row, Rows};
use super::{Knots, Spline};

/// A spline that loses knots of one axis, from the first to the last.
///
/// What a knot decides lies within a degree of it. So the knots and the lines of poles stand in two
/// stacks, before the place that is looked at and after it, and only their ends are touched.
pub(crate) struct Thinning<'a, S> {
    spline: &'a Spline<S>,
    axis: usize,
    before: Stack<S>,
    /// The first one last.
    after: Stack<S>,
    /// Of all poles, if there is one.
    weight: Option<S>,
}

struct Stack<S> {
    knots: Vec<S>,
    /// The poles of one index along the axis, for as many indices as there are.
    lines: Vec<Vec<S>>,
}

/// A knot taken out: the lines of poles nearby, and how far they are from those that were there.
pub(crate) struct Spared<S> {
    lines: Vec<Vec<S>>,
    /// As many of them as belong before the knot.
    before: usize,
    /// The number of lines that they replace.
    replaced: usize,
    pub defect: S,
}

impl<'a, S: Scalar> Thinning<'a, S> {
    /// Errors: `Shape` when there is no such axis.
    pub(crate) fn new(spline: &'a Spline<S>, axis: usize) -> Result<Self> {
        spline.net.require_axis(axis)?;
        let (mut knots, mut lines) = (spline.knots[axis].list.clone(), lines(&spline.net, axis));
        knots.reverse();
        lines.reverse();
        let before = Stack { knots: Vec::new(), lines: Vec::new() };
        let weight = spline.net.uniform_weight().cloned();
        Ok(Self { spline, axis, before, after: Stack { knots, lines }, weight })
    }

    /// Goes on to the knots from `t` on; how many of them are equal to it?
    pub(crate) fn advance(&mut self, t: &S) -> usize {
        while self.after.knots.last().is_some_and(|knot| knot < t) {
            self.before.knots.extend(self.after.knots.pop());
            self.before.lines.extend(self.after.lines.pop());
        }
        self.times(t)
    }

    fn times(&self, t: &S) -> usize {
        self.after.knots.iter().rev().take_while(|knot| *knot == t).count()
    }

    /// What it costs to take out the knot `t` once, to which it was [`Thinning::advance`]d.
    ///
    /// Errors: `Domain` unless `t` is an inner knot.
    pub(crate) fn without(&self, t: &S) -> Result<Spared<S>> {
        let times = self.times(t);
        let degree = self.spline.knots[self.axis].degree;
        // A degree on either side takes part, and one more makes it stand as in the whole.
        let near = 2 * degree + 2;
        let before = self.before.knots.len().min(near);
        let after = self.after.knots.len().min(near + times);
        let tail = &self.before.knots[self.before.knots.len() - before..];
        let head = self.after.knots.iter().rev().take(after);
        let knots = Knots { degree, list: tail.iter().chain(head).cloned().collect() };
        let count = knots.list.len().saturating_sub(degree + 1);
        let tail = self.before.lines.iter().skip(self.before.lines.len() - before);
        let head = self.after.lines.iter().rev().take(count.saturating_sub(before));
        let here: Vec<S> = tail.chain(head).flatten().cloned().collect();
        let inner = self.before.lines.last().or(self.after.lines.last()).map_or(1, Vec::len);

        let fewer = knots.without(t)?;
        // Other poles are not moved by the knot; those at the ends of this part look as if cut off.
        let moved = (before + times).saturating_sub(degree + 1)..before;
        let row = |i: usize| match i {
            i if moved.contains(&i) => fewer.refined_pole(&knots, i),
            i => Row::unit(if i < before { i } else { i - 1 }),
        };
        let insertion = Rows::new((0..count).map(row).collect());
        let mut poles = Vec::with_capacity(here.len());
        removal(&insertion, count - 1).mix(&here, inner, &mut poles);
        self.weigh(&mut poles);
        let mut again = Vec::with_capacity(here.len());
        insertion.mix(&poles, inner, &mut again);
        self.weigh(&mut again);
        let defect = farthest(&again, &here);
        let lines = poles.chunks_exact(inner).map(<[S]>::to_vec).collect();
        Ok(Spared { lines, before, replaced: count, defect })
    }

    /// Equal weights are carried over, as everywhere.
    fn weigh(&self, poles: &mut [S]) {
        let Some(weight) = &self.weight else { return };
        for pole in poles.chunks_exact_mut(self.spline.net.width()) {
            if let Some(last) = pole.last_mut() {
                last.clone_from(weight);
            }
        }
    }

    /// Takes out what was asked for last.
    pub(crate) fn accept(&mut self, mut spared: Spared<S>) {
        self.after.knots.pop();
        let kept = self.after.lines.len() - (spared.replaced - spared.before);
        self.after.lines.truncate(kept);
        self.after.lines.extend(spared.lines.drain(spared.before..).rev());
        self.before.lines.truncate(self.before.lines.len() - spared.before);
        self.before.lines.append(&mut spared.lines);
    }

    /// The spline with the knots that are left.
    pub(crate) fn finish(mut self) -> Result<Spline<S>> {
        let mut list = mem::take(&mut self.before.knots);
        list.extend(self.after.knots.drain(..).rev());
        let mut lines = mem::take(&mut self.before.lines);
        lines.extend(self.after.lines.drain(..).rev());
        let mut knots = self.spline.knots.clone();
        knots[self.axis] = Knots::new(knots[self.axis].degree, list)?;
        let net = net(&self.spline.net, self.axis, &lines)?;
        Spline::on(net, knots)
    }
}

/// The poles of each index along `axis`.
fn lines<S: Scalar>(net: &Form<S>, axis: usize) -> Vec<Vec<S>> {
    let count = net.orders()[axis];
    let inner = net.orders()[axis + 1..].iter().product::<usize>() * net.width();
    let mut lines = vec![Vec::with_capacity(net.homogeneous().len() / count); count];
    for block in net.homogeneous().chunks_exact(count * inner) {
        for (line, part) in lines.iter_mut().zip(block.chunks_exact(inner)) {
            line.extend_from_slice(part);
        }
    }
    lines
}

/// The net of these lines, otherwise like another.
fn net<S: Scalar>(like: &Form<S>, axis: usize, lines: &[Vec<S>]) -> Result<Form<S>> {
    let mut orders = like.orders().to_vec();
    orders[axis] = lines.len();
    let inner = orders[axis + 1..].iter().product::<usize>() * like.width();
    let outer: usize = orders[..axis].iter().product();
    let mut poles = Vec::with_capacity(outer * lines.len() * inner);
    for block in 0..outer {
        for line in lines {
            poles.extend_from_slice(&line[block * inner..(block + 1) * inner]);
        }
    }
    let net = Form::from_homogeneous(&orders, like.ambient(), poles)?;
    Ok(match like.uniform_weight() {
        Some(weight) => net.with_uniform_weight(weight),
        None => net,
    })
}
