//! Numbers that vary along a path: a tube's radius and twist.

use pforms_kernel::{Error, Form, Result};

use super::circle::circle;
use super::poly::Poly;
use crate::{Spline, stretch};

/// A number that may vary along a path. A form or spline runs over its whole window while the path
/// runs over its own.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    /// The same everywhere.
    Constant(f64),
    /// A polynomial curve in one dimension.
    Varying(Spline),
    /// `mean·(1 + amplitude·sin(2π·periods·t))`, with `t` from 0 to 1 along the path (book 324).
    Wave {
        /// What it waves about.
        mean: f64,
        /// Largest departure, as a share of the mean.
        amplitude: f64,
        /// How many waves there are.
        periods: f64,
    },
}

impl From<f64> for Law {
    fn from(value: f64) -> Self {
        Self::Constant(value)
    }
}

impl From<Form> for Law {
    fn from(form: Form) -> Self {
        Self::Varying(form.into())
    }
}

impl From<Spline> for Law {
    fn from(spline: Spline) -> Self {
        Self::Varying(spline)
    }
}

/// How often a law is halved to tell a value of 0 from one below.
const DEPTH: usize = 48;

impl Law {
    /// Complains about numbers that are not finite and about curves of the wrong kind.
    pub(super) fn check(&self, name: &str) -> Result<()> {
        match self {
            Self::Constant(value) => finite(name, &[*value]),
            Self::Wave { mean, amplitude, periods } => finite(name, &[*mean, *amplitude, *periods]),
            Self::Varying(curve) => {
                let net = curve.net();
                let polynomial = net.uniform_weight().is_some_and(|weight| *weight != 0.0);
                if net.axes() == 1 && net.ambient() == 1 && polynomial {
                    return self.require_no_jump(name);
                }
                Err(Error::shape(
                    name,
                    format!(
                        "a {}{} in {}D",
                        if polynomial { "" } else { "rational " },
                        net.kind(),
                        net.ambient()
                    ),
                    "a number, or a polynomial curve in 1D",
                ))
            }
        }
    }

    fn require_no_jump(&self, name: &str) -> Result<()> {
        let cuts = [vec![0.0], self.breaks(), vec![1.0]].concat();
        let pieces: Vec<Poly> = cuts
            .windows(2)
            .map(|ends| Ok(self.over(ends[0], ends[1])?.0))
            .collect::<Result<_>>()?;
        let size = pieces.iter().map(Poly::most).fold(0.0, f64::max);
        for (pair, t) in pieces.windows(2).zip(&cuts[1..]) {
            let jump = (pair[1].first() - pair[0].last()).abs();
            if jump > 1e-12 * size {
                let received = format!("a jump by {jump:e} at {t} of its length");
                return Err(Error::degenerate(name, received, "a curve in one piece"));
            }
        }
        Ok(())
    }

    /// The same law in another unit.
    pub(super) fn scaled(&self, factor: f64) -> Result<Self> {
        let in_range = |value: f64| {
            let product = value * factor;
            if product.is_finite() {
                return Ok(product);
            }
            Err(Error::domain("radius", value, "a radius within 1e300 times the path's size"))
        };
        Ok(match self {
            Self::Constant(value) => Self::Constant(in_range(*value)?),
            Self::Wave { mean, amplitude, periods } => {
                Self::Wave { mean: in_range(*mean)?, amplitude: *amplitude, periods: *periods }
            }
            Self::Varying(curve) => {
                let net = curve.net();
                let mut poles = net.homogeneous().to_vec();
                for pole in poles.chunks_exact_mut(2) {
                    pole[0] = in_range(pole[0])?;
                }
                let net = Form::from_homogeneous(net.orders(), 1, poles)?;
                Self::Varying(Spline::on(net, curve.knots().to_vec())?)
            }
        })
    }

    /// No value is further from 0.
    pub(super) fn most(&self) -> Result<f64> {
        let cuts = [vec![0.0], self.breaks(), vec![1.0]].concat();
        match self {
            Self::Constant(value) => Ok(value.abs()),
            Self::Wave { mean, amplitude, .. } => Ok(mean.abs() * (1.0 + amplitude.abs())),
            Self::Varying(_) => cuts.windows(2).try_fold(0.0_f64, |most, ends| {
                Ok(most.max(self.over(ends[0], ends[1])?.0.most()))
            }),
        }
    }

    /// Where its pieces meet, from 0 to 1.
    pub(super) fn breaks(&self) -> Vec<f64> {
        let Self::Varying(curve) = self else { return Vec::new() };
        let breaks = curve.breaks().swap_remove(0);
        let (first, last) = (breaks[0], breaks[breaks.len() - 1]);
        let inner = breaks[1..breaks.len() - 1].iter();
        inner.map(|t| (t - first) / (last - first)).collect()
    }

    /// A polynomial near the law on a part of the way between breaks, and by how much it may be off.
    pub(super) fn over(&self, from: f64, to: f64) -> Result<(Poly, f64)> {
        match self {
            Self::Constant(value) => Ok((Poly::constant(*value), 0.0)),
            Self::Wave { mean, amplitude, periods } => {
                let turn = std::f64::consts::TAU * periods;
                let (_, sine, error) = circle(&Poly(vec![turn * from, turn * to]));
                let wave = sine.scaled(mean * amplitude).plus(1.0, &Poly::constant(*mean));
                Ok((wave, (mean * amplitude).abs() * error))
            }
            Self::Varying(curve) => Ok((part(curve, from, to)?, 0.0)),
        }
    }

    /// Complains where the law is negative: decided by its Bernstein coefficients, so that no
    /// crossing however short is missed.
    pub(super) fn require_positive(&self, name: &str) -> Result<()> {
        let negative = |value: f64, t: f64| {
            let received = format!("{value} at {t} of the path's length in parameters");
            Err(Error::domain(name, received, "at least 0 all along"))
        };
        match self {
            Self::Constant(value) if *value < 0.0 => negative(*value, 0.0),
            Self::Constant(_) => Ok(()),
            Self::Wave { mean, amplitude, .. } => {
                let least = mean - (mean * amplitude).abs();
                if least < 0.0 { negative(least, 0.5) } else { Ok(()) }
            }
            Self::Varying(_) => {
                let cuts = [vec![0.0], self.breaks(), vec![1.0]].concat();
                for ends in cuts.windows(2) {
                    let piece = self.over(ends[0], ends[1])?.0;
                    let slack = 8.0 * f64::EPSILON * piece.most();
                    if let Some((value, t)) = below(&piece, -slack, DEPTH) {
                        return negative(value, ends[0] + t * (ends[1] - ends[0]));
                    }
                }
                Ok(())
            }
        }
    }
}

fn finite(name: &str, numbers: &[f64]) -> Result<()> {
    match numbers.iter().find(|x| !x.is_finite()) {
        None => Ok(()),
        Some(x) => Err(Error::domain(name, x, "finite numbers")),
    }
}

/// A value below a threshold and its parameter, if the polynomial has one.
fn below(piece: &Poly, threshold: f64, depth: usize) -> Option<(f64, f64)> {
    if piece.least() >= threshold {
        return None;
    }
    if piece.first() < threshold {
        return Some((piece.first(), 0.0));
    }
    if piece.last() < threshold {
        return Some((piece.last(), 1.0));
    }
    if depth == 0 {
        return None;
    }
    let (left, right) = piece.halves();
    let found = below(&left, threshold, depth - 1).map(|(value, t)| (value, t / 2.0));
    found.or_else(|| below(&right, threshold, depth - 1).map(|(value, t)| (value, 0.5 + t / 2.0)))
}

/// The curve on a part of its window, given as shares of it.
fn part(curve: &Spline, from: f64, to: f64) -> Result<Poly> {
    let breaks = curve.breaks().swap_remove(0);
    let (first, length) = (breaks[0], breaks[breaks.len() - 1] - breaks[0]);
    let middle = first + length * (0.5 * from + 0.5 * to);
    let index = breaks.partition_point(|t| *t <= middle).clamp(1, breaks.len() - 1) - 1;
    let (start, end) = (breaks[index], breaks[index + 1]);
    let local = |share: f64| (first + length * share - start) / (end - start);
    let piece = stretch(&curve.piece(&[index])?, &[local(from)], &[local(to)])?;
    Ok(Poly(piece.points()?))
}
