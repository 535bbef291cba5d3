//! Two parameters of a spline become one.

use pforms_kernel::{Error, Form, Result, Scalar};

use super::{Knots, Spline};
use crate::diagonal;

impl<S: Scalar> Spline<S> {
    /// The spline on the diagonal of two axes, as [`crate::diagonal`]: its breaks are those of both,
    /// its degree the sum of theirs. Exact.
    ///
    /// Errors: `Shape` when the axes are the same or not there, or when their windows differ;
    /// `Limit`.
    pub fn diagonal(&self, first: usize, second: usize) -> Result<Self> {
        if first == second {
            return Err(Error::shape("axes", format!("({first}, {second})"), "two different axes"));
        }
        let windows = (self.window(first)?, self.window(second)?);
        if windows.0 != windows.1 {
            return Err(Error::shape(
                "axes",
                format!("windows {:?} and {:?}", windows.0, windows.1),
                "two axes with one window (see on_window)",
            ));
        }
        let (low, high) = (first.min(second), first.max(second));
        let (own, other) = (&self.knots[low], &self.knots[high]);
        let mut knots = self.knots.clone();
        knots[low] = own.cut_at(&other.breaks())?;
        knots[high] = other.cut_at(&own.breaks())?;
        let fine = self.refined(knots)?;
        let breaks = fine.knots[low].breaks();
        let mut nets: Vec<Form<S>> = Vec::with_capacity(breaks.len());
        for pair in breaks.windows(2) {
            let part = fine.restrict(low, &pair[0], &pair[1])?;
            let part = part.restrict(high, &pair[0], &pair[1])?;
            nets.push(diagonal(part.net(), low, high)?);
        }
        let joined = Self::end_to_end(&nets, low, &breaks)?;
        let mut knots = self.knots.clone();
        knots.remove(high);
        knots[low] = joined.knots[low].clone();
        Self::on(joined.net, knots)
    }
}

impl<S: Scalar> Knots<S> {
    /// Pieces that share no more than end poles, cut at these places of the window too.
    fn cut_at(&self, places: &[S]) -> Result<Self> {
        let full = self.full()?;
        let (from, to) = full.window();
        let inner = places.iter().filter(|t| *t > from && *t < to);
        let lacking = |t: &S| {
            full.degree()
                .saturating_sub(full.multiplicity(t))
                .max(usize::from(full.multiplicity(t) == 0))
        };
        let more: Vec<S> = inner.flat_map(|t| vec![t.clone(); lacking(t)]).collect();
        full.with(&more)
    }
}
