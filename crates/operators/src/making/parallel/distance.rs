//! How far a parallel is away.

use pforms_kernel::{Error, Form, Result, Scaled};

use crate::stretch;

/// A signed distance: the same everywhere, or a form in dimension 1 with the axes of the original.
#[derive(Clone, Debug, PartialEq)]
pub enum Distance {
    /// One number.
    Constant(f64),
    /// A function over the window of the original, whatever that is, taken from 0 to 1.
    Varying(Form),
}

impl From<f64> for Distance {
    fn from(distance: f64) -> Self {
        Self::Constant(distance)
    }
}

impl From<Form> for Distance {
    fn from(distance: Form) -> Self {
        Self::Varying(distance)
    }
}

/// The distance on one cell, as a quotient of polynomials.
pub(super) struct Quotient {
    pub above: Scaled,
    pub below: Scaled,
    /// The largest absolute value it may have.
    pub most: f64,
}

impl Distance {
    pub(super) fn is_zero(&self) -> bool {
        match self {
            Self::Constant(distance) => *distance == 0.0,
            Self::Varying(form) => {
                form.homogeneous().chunks_exact(form.width()).all(|pole| pole[0] == 0.0)
            }
        }
    }

    /// Errors: `Shape` unless it fits a form of so many axes; `Domain` when it is not finite
    /// everywhere.
    pub(in crate::making) fn check(&self, axes: usize) -> Result<()> {
        match self {
            Self::Constant(distance) if distance.is_finite() => Ok(()),
            Self::Constant(distance) => Err(Error::domain("distance", distance, "a finite number")),
            Self::Varying(form) if form.axes() != axes || form.ambient() != 1 => Err(Error::shape(
                "distance",
                format!("a {} in dimension {}", form.kind(), form.ambient()),
                format!("a number, or a form of {axes} axes in dimension 1"),
            )),
            Self::Varying(form) if form.weights().iter().any(|w| *w <= 0.0) => Err(Error::domain(
                "distance",
                "a form with weights that are not positive",
                "positive weights",
            )),
            Self::Varying(_) => Ok(()),
        }
    }

    /// The distance on the part from `a` to `b` of the window.
    pub(super) fn on(&self, a: &[f64], b: &[f64]) -> Result<Quotient> {
        match self {
            Self::Constant(distance) => Ok(Quotient {
                above: Scaled::constant(a.len(), &[*distance]),
                below: Scaled::constant(a.len(), &[1.0]),
                most: distance.abs(),
            }),
            Self::Varying(form) => {
                let part = stretch(form, a, b)?;
                let values = part.points()?;
                let scaled = Scaled::from_form(&part);
                Ok(Quotient {
                    above: scaled.component(0),
                    below: match part.uniform_weight() {
                        Some(weight) => Scaled::constant(a.len(), &[*weight]),
                        None => scaled.component(1),
                    },
                    most: values.iter().fold(0.0, |most, x| most.max(x.abs())),
                })
            }
        }
    }
}

impl Distance {
    /// The distance at parameters of the window, taken from 0 to 1.
    pub(in crate::making) fn at(&self, shares: &[f64]) -> Result<f64> {
        match self {
            Self::Constant(distance) => Ok(*distance),
            Self::Varying(form) => Ok(form.at(shares)?[0]),
        }
    }
}
