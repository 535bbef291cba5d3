//! Parts of a spline, other windows, other orders of its axes.

use pforms_kernel::{Error, Form, Result, Scalar};

use super::Spline;
use crate::{reverse, transpose};

impl<S: Scalar> Spline<S> {
    /// The part of the spline from `a` to `b` along `axis`, which keeps its parameters. Beyond the
    /// window the outermost piece goes on. Exact.
    ///
    /// Errors: `Shape` when there is no such axis; `Domain` unless `a < b`, both finite.
    pub fn restrict(&self, axis: usize, a: &S, b: &S) -> Result<Self> {
        self.net.require_axis(axis)?;
        if !(a.is_finite() && b.is_finite() && a < b) {
            let received = format!("{a:?} to {b:?}");
            return Err(Error::domain("window", received, "two finite numbers, the first less"));
        }
        let mut knots = self.knots.clone();
        knots[axis] = knots[axis].restricted(a, b)?;
        self.refined(knots)
    }

    /// The spline on the windows from `from[k]` to `to[k]`, each counted from 0 to 1 again:
    /// restricted, extended or, for `from[k] > to[k]`, reversed. Exact but for the rounding of knots.
    ///
    /// Errors: `Shape` unless there is one number for each axis; `Domain` for numbers that are not
    /// finite, or two that are the same.
    pub fn stretch(&self, from: &[S], to: &[S]) -> Result<Self> {
        self.net.require_per_axis("a", from)?;
        self.net.require_per_axis("b", to)?;
        let mut result = self.clone();
        for (axis, (a, b)) in from.iter().zip(to).enumerate() {
            result = if a > b {
                result.restrict(axis, b, a)?.reverse(axis)?
            } else {
                result.restrict(axis, a, b)?
            };
            result = result.on_window(axis, &S::zero(), &S::one())?;
        }
        Ok(result)
    }

    /// The two parts before and after `t` along `axis`, each with its own parameters. Exact.
    ///
    /// Errors: `Shape` when there is no such axis; `Domain` unless `t` is inside the window.
    pub fn split(&self, axis: usize, t: &S) -> Result<(Self, Self)> {
        let (from, to) = self.window(axis)?;
        if !(from < *t && *t < to) {
            let expected = format!("a number between {from:?} and {to:?}");
            return Err(Error::domain("t", format!("{t:?}"), expected));
        }
        Ok((self.restrict(axis, &from, t)?, self.restrict(axis, t, &to)?))
    }

    /// The same spline with other parameters: `axis` runs from `a` to `b`, knots in proportion.
    ///
    /// Errors: `Shape` when there is no such axis; `Domain` unless `a < b` are far enough apart to
    /// tell the knots from one another.
    pub fn on_window(&self, axis: usize, a: &S, b: &S) -> Result<Self> {
        self.net.require_axis(axis)?;
        if !(a.is_finite() && b.is_finite() && a < b) {
            let received = format!("{a:?} to {b:?}");
            return Err(Error::domain("window", received, "two finite numbers, the first less"));
        }
        let mut knots = self.knots.clone();
        knots[axis] = knots[axis].on_window(a, b)?;
        Ok(Self { net: self.net.clone(), knots })
    }

    /// The spline run backwards along `axis`, over the same window. Exact but for the rounding of
    /// knots.
    ///
    /// Errors: `Shape` when there is no such axis; `Domain` when rounding would let knots fall
    /// together.
    pub fn reverse(&self, axis: usize) -> Result<Self> {
        let net = reverse(&self.net, axis)?;
        let mut knots = self.knots.clone();
        knots[axis] = knots[axis].reversed()?;
        Ok(Self { net, knots })
    }

    /// The spline with its axes in another order: axis `k` of the result is axis `axes[k]`.
    ///
    /// Errors: `Shape` unless `axes` is a permutation.
    pub fn transpose(&self, axes: &[usize]) -> Result<Self> {
        let net = transpose(&self.net, axes)?;
        Ok(Self { net, knots: axes.iter().map(|&axis| self.knots[axis].clone()).collect() })
    }

    /// The sub-spline (isoparametric spline) where parameter `axis` is `t`: one axis less. Exact.
    ///
    /// Errors: `Shape` when there is no such axis, `Domain` when `t` is not finite.
    pub fn sub(&self, axis: usize, t: &S) -> Result<Self> {
        self.net.require_axis(axis)?;
        if !t.is_finite() {
            return Err(Error::domain("t", format!("{t:?}"), "a finite number"));
        }
        let (first, factors) = self.knots[axis].basis(t);
        let mut row = vec![S::zero(); self.net.orders()[axis]];
        row[first..first + factors.len()].clone_from_slice(&factors);
        let net: Form<S> = self.net.contract(axis, &row)?;
        let net = match self.net.uniform_weight() {
            Some(weight) => net.with_uniform_weight(weight),
            None => net,
        };
        let mut knots = self.knots.clone();
        knots.remove(axis);
        Ok(Self { net, knots })
    }
}
