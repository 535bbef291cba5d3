//! The pieces of a spline, and splines from pieces.

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use super::{Knots, Spline};
use crate::{elevate, raise_together};

/// The pieces of a spline, found once for all that are asked for.
#[derive(Clone, Debug)]
pub(crate) struct Pieces<'a, S = f64> {
    spline: &'a Spline<S>,
    spans: Vec<Vec<usize>>,
}

impl<'a, S: Scalar> Pieces<'a, S> {
    pub(crate) fn of(spline: &'a Spline<S>) -> Self {
        Self { spline, spans: spline.knots.iter().map(Knots::spans).collect() }
    }

    /// As [`Spline::piece`].
    pub(crate) fn piece(&self, index: &[usize]) -> Result<Form<S>> {
        self.spline.net.require_per_axis("index", index)?;
        let span = |(i, all): (&usize, &Vec<usize>)| all.get(*i).copied();
        let spans: Option<Vec<usize>> = index.iter().zip(&self.spans).map(span).collect();
        let spans = spans.ok_or_else(|| {
            let expected = format!("indices below {:?}", self.spline.counts());
            Error::shape("index", format!("{index:?}"), expected)
        })?;
        self.spline.over(&spans)
    }
}

impl<S: Scalar> Spline<S> {
    /// The piece at `index`, as a form on the window from 0 to 1. Exact: Bézier extraction.
    ///
    /// Errors: `Shape` when there is no such piece.
    pub fn piece(&self, index: &[usize]) -> Result<Form<S>> {
        Pieces::of(self).piece(index)
    }

    /// The piece over these spans.
    pub(super) fn over(&self, spans: &[usize]) -> Result<Form<S>> {
        let orders: Vec<usize> = self.knots.iter().map(|knots| knots.degree() + 1).collect();
        let mut poles = Vec::with_capacity(orders.iter().product::<usize>() * self.net.width());
        self.copy(spans, self.net.homogeneous(), &mut poles);
        let mut form = Form::from_homogeneous(&orders, self.net.ambient(), poles)?;
        for (axis, (knots, &span)) in self.knots.iter().zip(spans).enumerate() {
            if !knots.is_bezier_over(span) {
                form = form.along_affine(axis, &knots.extraction(span).1)?;
            }
        }
        Ok(form)
    }

    /// Copies the poles that count over the spans from a part of the net whose first axes are gone.
    pub(super) fn copy(&self, spans: &[usize], part: &[S], poles: &mut Vec<S>) {
        let axis = self.knots.len() - spans.len();
        let whole = |(knots, order): (&Knots<S>, &usize)| knots.degree() + 1 == *order;
        if self.knots[axis..].iter().zip(&self.net.orders()[axis..]).all(whole) {
            return poles.extend_from_slice(part);
        }
        let (degree, share) = (self.knots[axis].degree(), part.len() / self.net.orders()[axis]);
        for line in part.chunks_exact(share).skip(spans[0] - degree).take(degree + 1) {
            self.copy(&spans[1..], line, poles);
        }
    }

    /// All pieces, the last axis fastest.
    ///
    /// Errors: `Limit`.
    pub fn pieces(&self) -> Result<Vec<Form<S>>> {
        let bezier = self.bezier()?;
        let pieces = Pieces::of(&bezier);
        let sizes = [self.counts(), self.degrees().iter().map(|degree| degree + 1).collect()];
        limit::check::<S>("the pieces", &sizes.concat(), self.net.width())?;
        indices(&self.counts()).iter().map(|index| pieces.piece(index)).collect()
    }

    /// The same spline with every knot repeated until the pieces share no more than end poles: the
    /// control polygons of the pieces, put end to end. Exact.
    ///
    /// Errors: `Limit`.
    pub fn bezier(&self) -> Result<Self> {
        if self.is_bezier() {
            return Ok(self.clone());
        }
        let full = self.knots.iter().map(Knots::full).collect::<Result<Vec<_>>>()?;
        self.refined(full)
    }

    /// What `operator` makes of every piece, put together again over the same breaks.
    ///
    /// The operator gets the piece and the corners of its window. Where this spline is in one piece
    /// the results are taken to meet: the poles they share are those of the earlier.
    ///
    /// Errors: those of the operator; `Shape` when the results do not fit each other.
    pub fn map_pieces(
        &self,
        operator: impl Fn(&Form<S>, &[(S, S)]) -> Result<Form<S>>,
    ) -> Result<Self> {
        let (breaks, counts) = (self.breaks(), self.counts());
        let windows = indices(&counts).into_iter().map(|index| -> Vec<(S, S)> {
            let sides = index.iter().zip(&breaks);
            sides.map(|(&i, list)| (list[i].clone(), list[i + 1].clone())).collect()
        });
        let pieces = self.pieces()?;
        let results = pieces.iter().zip(windows).map(|(piece, window)| operator(piece, &window));
        let results = results.collect::<Result<Vec<_>>>()?;
        let parted = |knots: &Knots<S>| -> Vec<bool> {
            let breaks = knots.breaks();
            let inner = breaks.iter().skip(1).take(breaks.len().saturating_sub(2));
            inner.map(|t| knots.multiplicity(t) > knots.degree()).collect()
        };
        let gaps: Vec<Vec<bool>> = self.knots.iter().map(parted).collect();
        assembled(&results, &breaks, &gaps)
    }

    /// Forms laid end to end along `axis`, from break to break; degrees that differ are raised.
    ///
    /// Where the end of a form is the beginning of the next they share its poles; the weights of
    /// the next form are first scaled to agree, which leaves its points where they are. Where they
    /// differ, however little, the knot is repeated once more and the spline has a gap.
    ///
    /// Errors: `Shape` without forms, when their axes or dimensions differ, or unless there is one
    /// break more than forms; `Domain` unless the breaks grow.
    pub fn end_to_end(forms: &[Form<S>], axis: usize, breaks: &[S]) -> Result<Self> {
        let raised = raise_together(&forms.iter().collect::<Vec<_>>())?;
        raised[0].require_axis(axis)?;
        if breaks.len() != raised.len() + 1 {
            return Err(Error::shape(
                "breaks",
                format!("{} numbers", breaks.len()),
                format!("{}, one more than forms", raised.len() + 1),
            ));
        }
        let mut chain: Vec<Form<S>> = Vec::with_capacity(raised.len());
        let mut gaps = Vec::with_capacity(raised.len());
        for form in raised {
            let Some(before) = chain.last() else {
                chain.push(form);
                continue;
            };
            let (scaled, meets) = continued(before, &form, axis)?;
            gaps.push(!meets);
            chain.push(scaled);
        }
        let axes = chain[0].axes();
        let mut all_breaks = vec![vec![S::zero(), S::one()]; axes];
        let mut all_gaps = vec![Vec::new(); axes];
        (all_breaks[axis], all_gaps[axis]) = (breaks.to_vec(), gaps);
        assembled(&chain, &all_breaks, &all_gaps)
    }
}

/// `form` with weights that continue those of `before`, and whether the two meet.
fn continued<S: Scalar>(before: &Form<S>, form: &Form<S>, axis: usize) -> Result<(Form<S>, bool)> {
    let end = face(before, axis, before.orders()[axis] - 1)?;
    let start = face(form, axis, 0)?;
    if end == start {
        return Ok((form.clone(), true));
    }
    let width = form.width();
    let other = start.chunks_exact(width).zip(end.chunks_exact(width));
    let factor = other
        .map(|(from, to)| (from[width - 1].clone(), to[width - 1].clone()))
        .find(|(from, to)| !from.is_zero() && !to.is_zero())
        .map(|(from, to)| to / from);
    let Some(factor) = factor.filter(|factor| *factor != S::one()) else {
        return Ok((form.clone(), false));
    };
    let scaled = form.map_scalar(|x| x.clone() * factor.clone())?;
    if face(&scaled, axis, 0)? == end { Ok((scaled, true)) } else { Ok((form.clone(), false)) }
}

/// The homogeneous poles with index `at` along `axis`.
fn face<S: Scalar>(form: &Form<S>, axis: usize, at: usize) -> Result<Vec<S>> {
    form.require_axis(axis)?;
    let inner = form.orders()[axis + 1..].iter().product::<usize>() * form.width();
    let blocks = form.homogeneous().chunks_exact(inner * form.orders()[axis]);
    Ok(blocks.flat_map(|block| block[at * inner..(at + 1) * inner].to_vec()).collect())
}

/// A grid of forms, the last axis fastest, over `breaks`; `gaps` says at which inner breaks
/// neighbours keep their own end poles.
fn assembled<S: Scalar>(
    forms: &[Form<S>],
    breaks: &[Vec<S>],
    gaps: &[Vec<bool>],
) -> Result<Spline<S>> {
    let raised = raise_together(&forms.iter().collect::<Vec<_>>())?;
    let first = &raised[0];
    first.require_per_axis("breaks", breaks)?;
    let mut degrees = first.degrees();
    // Pieces of degree 0 share nothing unless they are all the same: they are raised to share.
    let by: Vec<usize> = (0..degrees.len())
        .map(|k| usize::from(degrees[k] == 0 && gaps[k].contains(&false)))
        .collect();
    let raised: Vec<Form<S>> = if by.contains(&1) {
        degrees.iter_mut().zip(&by).for_each(|(degree, more)| *degree += more);
        raised.iter().map(|form| elevate(form, &by)).collect::<Result<_>>()?
    } else {
        raised
    };
    let mut knots = Vec::with_capacity(degrees.len());
    let mut places = Vec::with_capacity(degrees.len());
    for ((&degree, list), gaps) in degrees.iter().zip(breaks).zip(gaps) {
        let mut vector = vec![list[0].clone(); degree + 1];
        let mut starts = vec![0];
        for (t, &gap) in list[1..].iter().zip(gaps) {
            vector.extend(vec![t.clone(); degree + usize::from(gap)]);
            starts.push(starts[starts.len() - 1] + degree + usize::from(gap));
        }
        vector.extend(vec![list[list.len() - 1].clone(); degree + 1]);
        knots.push(Knots::new(degree, vector)?);
        places.push(starts);
    }
    let orders: Vec<usize> = knots.iter().map(Knots::order).collect();
    let width = raised[0].width();
    let count = limit::check::<S>("the net of the spline", &orders, width)?;
    let counts: Vec<usize> = places.iter().map(Vec::len).collect();
    let mut net = vec![S::zero(); count];
    // Backwards, so that the earlier of two neighbours has the last word on what they share.
    for (form, index) in raised.iter().zip(indices(&counts)).rev() {
        let corner: Vec<usize> = index.iter().zip(&places).map(|(i, starts)| starts[*i]).collect();
        paste(form.homogeneous(), form.orders(), &corner, &orders, width, &mut net);
    }
    Spline::on(Form::from_homogeneous(&orders, raised[0].ambient(), net)?, knots)
}

/// Copies an array of poles into a larger one, at a corner.
fn paste<S: Scalar>(
    from: &[S],
    orders: &[usize],
    corner: &[usize],
    into_orders: &[usize],
    width: usize,
    into: &mut [S],
) {
    let Some((&order, rest)) = orders.split_first() else {
        return into[..width].clone_from_slice(from);
    };
    let (line, stride) = (from.len() / order, into.len() / into_orders[0]);
    for (i, part) in from.chunks_exact(line).enumerate() {
        let at = (corner[0] + i) * stride;
        paste(part, rest, &corner[1..], &into_orders[1..], width, &mut into[at..at + stride]);
    }
}

/// Every index below `counts`, the last fastest.
pub(in crate::algebra) fn indices(counts: &[usize]) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::with_capacity(counts.len())];
    for &count in counts {
        let prefixes = std::mem::take(&mut all);
        for prefix in prefixes {
            for i in 0..count {
                let mut index = prefix.clone();
                index.push(i);
                all.push(index);
            }
        }
    }
    all
}
