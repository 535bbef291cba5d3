//! Points of a spline by the thousand: each piece is taken out once and evaluated as a form.

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use super::{Knots, Spline};

impl Spline<f64> {
    /// Points at every combination of the `parameters`, a list for each axis: shape
    /// `(m₁, …, m_d, c)`, the last axis fastest. Each piece is evaluated at once, as a form.
    ///
    /// Errors: as [`Form::grid`].
    pub fn grid(&self, parameters: &[&[f64]]) -> Result<Vec<f64>> {
        self.net().require_per_axis("parameters", parameters)?;
        let sizes: Vec<usize> = parameters.iter().map(|list| list.len()).collect();
        let count = limit::check::<f64>("the grid", &sizes, self.ambient())?;
        let mut points = vec![0.0; count];
        self.grid_into(parameters, &mut points)?;
        Ok(points)
    }

    /// [`Spline::grid`] into an array of the caller's.
    ///
    /// Errors: as there, and `Shape` when the array does not fit.
    pub fn grid_into(&self, parameters: &[&[f64]], out: &mut [f64]) -> Result<()> {
        self.each_on_grid(parameters, out, Form::grid_into)
    }

    /// Does a job for the part of a grid on each piece, and puts its answers, `ambient` numbers a
    /// point, in their places.
    ///
    /// Errors: `Shape` when parameters or array do not fit; those of the job.
    pub(crate) fn each_on_grid(
        &self,
        parameters: &[&[f64]],
        out: &mut [f64],
        job: impl Fn(&Form, &[&[f64]], &mut [f64]) -> Result<()>,
    ) -> Result<()> {
        self.net().require_per_axis("parameters", parameters)?;
        let width = self.ambient();
        let sizes: Vec<usize> = parameters.iter().map(|list| list.len()).collect();
        require_room(out, sizes.iter().product::<usize>() * width)?;
        let groups: Vec<Vec<Group>> =
            self.knots().iter().zip(parameters).map(|(knots, list)| groups(knots, list)).collect();
        let counts: Vec<usize> = groups.iter().map(Vec::len).collect();
        for index in super::indices(&counts) {
            let chosen: Vec<&Group> = index.iter().zip(&groups).map(|(i, all)| &all[*i]).collect();
            let spans: Vec<usize> = chosen.iter().map(|group| group.span).collect();
            let lists: Vec<&[f64]> = chosen.iter().map(|group| group.local.as_slice()).collect();
            let size: usize = lists.iter().map(|list| list.len()).product();
            let mut part = vec![0.0; size * width];
            job(&self.over(&spans)?, &lists, &mut part)?;
            for (place, point) in part.chunks_exact(width).enumerate() {
                let target = target(&chosen, &sizes, place);
                out[target * width..(target + 1) * width].copy_from_slice(point);
            }
        }
        Ok(())
    }

    /// Points at scattered parameters, lists of one length, one for each axis: shape `(m, c)`.
    ///
    /// Errors: as [`Form::scattered`].
    pub fn scattered(&self, parameters: &[&[f64]]) -> Result<Vec<f64>> {
        let count = parameters.first().map_or(1, |list| list.len());
        let mut points = vec![0.0; limit::check::<f64>("the batch", &[count], self.ambient())?];
        self.scattered_into(parameters, &mut points)?;
        Ok(points)
    }

    /// [`Spline::scattered`] into an array of the caller's.
    ///
    /// Errors: as there, and `Shape` when the array does not fit.
    pub fn scattered_into(&self, parameters: &[&[f64]], out: &mut [f64]) -> Result<()> {
        self.each_scattered(parameters, out, |piece, _, lists, part| {
            piece.scattered_into(lists, part)
        })
    }

    /// Derivatives `∂^orders` of the points at scattered parameters, into `out`.
    ///
    /// Errors: as [`Spline::scattered_into`], and `Shape` unless there is one order for each axis.
    pub fn scattered_derivative_into(
        &self,
        parameters: &[&[f64]],
        orders: &[usize],
        out: &mut [f64],
    ) -> Result<()> {
        self.net().require_per_axis("derivative", orders)?;
        self.each_scattered(parameters, out, |piece, lengths, lists, part| {
            piece.scattered_derivative_into(lists, orders, part)?;
            let powers = lengths.iter().zip(orders).map(|(length, &k)| length.powi(k as i32));
            let divisor: f64 = powers.product();
            for x in part.iter_mut() {
                *x /= divisor;
            }
            Ok(())
        })
    }

    /// Does a job for all points on each piece: it is given the piece, the lengths of its window,
    /// the parameters in it and the places for `ambient` numbers a point.
    ///
    /// Errors: `Shape` when lists or array do not fit; those of the job.
    pub(crate) fn each_scattered(
        &self,
        parameters: &[&[f64]],
        out: &mut [f64],
        mut job: impl FnMut(&Form, &[f64], &[&[f64]], &mut [f64]) -> Result<()>,
    ) -> Result<()> {
        self.net().require_per_axis("parameters", parameters)?;
        let count = parameters.first().map_or(1, |list| list.len());
        if let Some(list) = parameters.iter().find(|list| list.len() != count) {
            let received = format!("{} and {count} numbers", list.len());
            return Err(Error::shape("parameters", received, "lists of one length"));
        }
        let width = self.ambient();
        require_room(out, count * width)?;
        let places = Places::new(self, parameters);
        let mut sorted = if places.in_order { Vec::new() } else { vec![0.0; out.len()] };
        let mut locals: Vec<Vec<f64>> = vec![Vec::new(); parameters.len()];
        let mut done = 0;
        for group in places.order.chunk_by(|a, b| a.0 == b.0) {
            let spans = places.spans(group[0].0);
            for (axis, local) in locals.iter_mut().enumerate() {
                let knots = &self.knots()[axis];
                let list = group.iter().map(|(_, i)| parameters[axis][*i]);
                local.clear();
                local.extend(list.map(|t| knots.local(spans[axis], t)));
            }
            let lists: Vec<&[f64]> = locals.iter().map(Vec::as_slice).collect();
            let lengths: Vec<f64> =
                spans.iter().zip(self.knots()).map(|(&span, knots)| knots.length(span)).collect();
            let range = done * width..(done + group.len()) * width;
            let part = if places.in_order { &mut out[range] } else { &mut sorted[range] };
            job(&self.over(&spans)?, &lengths, &lists, part)?;
            done += group.len();
        }
        for ((_, i), point) in places.order.iter().zip(sorted.chunks_exact(width)) {
            out[i * width..(i + 1) * width].copy_from_slice(point);
        }
        Ok(())
    }
}

/// Which piece each of many points is on.
struct Places {
    /// For each axis the spans that are not empty.
    spans: Vec<Vec<usize>>,
    /// The number of the piece and that of the point, piece after piece.
    order: Vec<(usize, usize)>,
    in_order: bool,
}

impl Places {
    fn new(spline: &Spline, parameters: &[&[f64]]) -> Self {
        let count = parameters.first().map_or(1, |list| list.len());
        let mut order: Vec<(usize, usize)> = (0..count).map(|i| (0, i)).collect();
        let mut spans = Vec::with_capacity(parameters.len());
        for (knots, list) in spline.knots().iter().zip(parameters) {
            let own = knots.spans();
            let starts: Vec<f64> = own.iter().map(|&span| knots.as_slice()[span]).collect();
            for ((piece, _), t) in order.iter_mut().zip(*list) {
                let number = starts.partition_point(|start| start <= t).saturating_sub(1);
                *piece = *piece * own.len() + number;
            }
            spans.push(own);
        }
        let in_order = order.is_sorted();
        if !in_order {
            order.sort_unstable();
        }
        Self { spans, order, in_order }
    }

    fn spans(&self, piece: usize) -> Vec<usize> {
        let mut rest = piece;
        let mut spans: Vec<usize> = self
            .spans
            .iter()
            .rev()
            .map(|own| {
                let span = own[rest % own.len()];
                rest /= own.len();
                span
            })
            .collect();
        spans.reverse();
        spans
    }
}

/// Parameters of one axis that fall on one piece, with their places in the list.
struct Group {
    span: usize,
    places: Vec<usize>,
    local: Vec<f64>,
}

fn groups(knots: &Knots<f64>, parameters: &[f64]) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    for (place, &t) in parameters.iter().enumerate() {
        let span = knots.span(&t);
        let known = groups.iter().rposition(|group| group.span == span);
        let which = known.unwrap_or_else(|| {
            groups.push(Group { span, places: Vec::new(), local: Vec::new() });
            groups.len() - 1
        });
        groups[which].places.push(place);
        groups[which].local.push(knots.local(span, t));
    }
    groups
}

/// Where point number `place` of the groups stands in a grid of these sizes.
fn target(groups: &[&Group], sizes: &[usize], place: usize) -> usize {
    let (mut rest, mut target, mut stride) = (place, 0, 1);
    for (group, size) in groups.iter().zip(sizes).rev() {
        target += group.places[rest % group.places.len()] * stride;
        rest /= group.places.len();
        stride *= size;
    }
    target
}

fn require_room(out: &[f64], numbers: usize) -> Result<()> {
    if out.len() == numbers {
        return Ok(());
    }
    Err(Error::shape("out", format!("{} numbers", out.len()), format!("{numbers}")))
}

impl<S: Scalar> Knots<S> {
    /// The parameter of the piece over `span` that corresponds to `t`.
    pub(super) fn local(&self, span: usize, t: S) -> S {
        let from = &self.as_slice()[span];
        (t - from.clone()) / self.length(span)
    }

    /// How long the window of the piece over `span` is.
    pub(super) fn length(&self, span: usize) -> S {
        let (from, to) = (&self.as_slice()[span], &self.as_slice()[span + 1]);
        to.clone() - from.clone()
    }
}
