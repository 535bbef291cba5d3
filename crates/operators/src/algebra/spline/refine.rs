//! More knots, more degrees: the same spline with more poles.

use pforms_kernel::{Error, Result, Scalar};

use super::{Knots, Spline};
use crate::elevate;

impl<S: Scalar> Spline<S> {
    /// The same spline with more knots along `axis`, a repeated one as often as it is given. Exact.
    ///
    /// Boehm's knot insertion, all at once. *The NURBS Book*, section 5.2.
    ///
    /// Errors: `Shape` when there is no such axis; as [`Knots::with`]; `Limit`.
    ///
    /// ```
    /// use pforms_kernel::Form;
    /// use pforms_operators::Spline;
    /// let line: Form = Form::from_points(&[2], 1, &[0., 4.], None)?;
    /// let cut = Spline::from(line).insert_knots(0, &[0.25])?;
    /// assert_eq!(cut.net().points()?, [0., 1., 4.]);
    /// # Ok::<(), pforms_kernel::Error>(())
    /// ```
    pub fn insert_knots(&self, axis: usize, more: &[S]) -> Result<Self> {
        self.net.require_axis(axis)?;
        let mut knots = self.knots.clone();
        knots[axis] = knots[axis].with(more)?;
        self.refined(knots)
    }

    /// The same spline over other knots of the same degrees, which hold its own.
    pub(super) fn refined(&self, finer: Vec<Knots<S>>) -> Result<Self> {
        let mut net = self.net.clone();
        for (axis, (old, new)) in self.knots.iter().zip(&finer).enumerate() {
            if old != new {
                net = old.refinement(new)?.act(&net, axis)?;
            }
        }
        Ok(Self { net, knots: finer })
    }

    /// The same spline with its degree raised by `by[k]` along each axis `k`: every knot is
    /// repeated as many times more, so it is as smooth as before. Exact.
    ///
    /// Errors: `Shape` unless there is one number for each axis; `Limit`.
    pub fn elevate(&self, by: &[usize]) -> Result<Self> {
        self.net.require_per_axis("by", by)?;
        let mut result = self.clone();
        for (axis, &more) in by.iter().enumerate() {
            if result.knots[axis].is_one_piece() {
                // As a form: a triangle less for every pole.
                let mut along = vec![0; by.len()];
                along[axis] = more;
                result.net = elevate(&result.net, &along)?;
                let (from, to) = result.knots[axis].window();
                let ends = [from.clone(), to.clone()];
                let degree = result.knots[axis].degree() + more;
                result.knots[axis] = Knots::of_breaks(degree, &ends, degree)?;
                continue;
            }
            for _ in 0..more {
                let raised = result.knots[axis].raised()?;
                result.net = result.knots[axis].elevation(&raised)?.act(&result.net, axis)?;
                result.knots[axis] = raised;
            }
        }
        Ok(result)
    }

    /// The same splines with the same degrees and knots, so that their poles correspond. Exact.
    ///
    /// Degrees are raised to the largest and the knots of all are inserted into each.
    ///
    /// Errors: `Shape` when their axes, dimensions or windows differ; `Limit`.
    pub fn on_common_knots(splines: &[Self]) -> Result<Vec<Self>> {
        let Some(first) = splines.first() else {
            return Err(Error::shape("splines", "none", "at least one spline"));
        };
        for (index, spline) in splines.iter().enumerate() {
            if (spline.axes(), spline.ambient()) != (first.axes(), first.ambient()) {
                return Err(Error::shape(
                    "splines",
                    format!("{} axes in {}D as spline {index}", spline.axes(), spline.ambient()),
                    format!("{} axes in {}D like the first", first.axes(), first.ambient()),
                ));
            }
        }
        let axes = 0..first.axes();
        let most = |axis: usize| {
            let degrees = splines.iter().map(|spline| spline.knots[axis].degree());
            degrees.max().unwrap_or(0)
        };
        let degrees: Vec<usize> = axes.clone().map(most).collect();
        let mut raised = Vec::with_capacity(splines.len());
        for spline in splines {
            let by = degrees.iter().zip(&spline.knots).map(|(to, knots)| to - knots.degree());
            let spline = spline.elevate(&by.collect::<Vec<_>>())?;
            let clamped = spline.knots.iter().map(Knots::clamped).collect::<Result<Vec<_>>>()?;
            raised.push(spline.refined(clamped)?);
        }
        let common: Vec<Knots<S>> = axes
            .map(|axis| {
                let (head, rest) = raised.split_at(1);
                let first = head[0].knots[axis].clone();
                rest.iter().try_fold(first, |all, spline| all.united(&spline.knots[axis]))
            })
            .collect::<Result<_>>()?;
        raised.iter().map(|spline| spline.refined(common.clone())).collect()
    }
}

impl<S: Scalar> Knots<S> {
    /// The same window with ends repeated `degree + 1` times.
    fn clamped(&self) -> Result<Self> {
        let (from, to) = self.window();
        self.restricted(from, to)
    }

    /// Every knot as often as in the one or the other, whichever has more.
    fn united(&self, other: &Self) -> Result<Self> {
        if self.window() != other.window() {
            return Err(Error::shape(
                "window",
                format!("{:?}", other.window()),
                format!("{:?}, as the others have (see on_window)", self.window()),
            ));
        }
        let missing = |knot: &S| other.multiplicity(knot).saturating_sub(self.multiplicity(knot));
        let mut different = other.as_slice().to_vec();
        different.dedup();
        let more = different.iter().flat_map(|knot| vec![knot.clone(); missing(knot)]);
        self.with(&more.collect::<Vec<_>>())
    }
}
