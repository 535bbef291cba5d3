//! Which part of a closed rational form is wanted, and in which dress.

use pforms_kernel::{Error, Result, Scalar};

/// A part of a circle, a quadric or a torus.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Part {
    /// All of it in one form. Two of the five poles round a circle are directions (weight 0), and
    /// no number is irrational.
    #[default]
    Whole,
    /// All of it as a spline of quarter turns, all weights positive.
    Pieces,
    /// The half above the middle, all the way round.
    Half,
    /// A quarter turn of it.
    Quarter,
    /// An eighth of a sphere.
    Octant,
    /// A quarter turn of the outer upper quarter of a torus.
    Outer,
    /// A quarter turn of the inner upper quarter of a torus.
    Inner,
}

impl Part {
    /// Every part.
    pub const ALL: [Self; 7] = [
        Self::Whole,
        Self::Pieces,
        Self::Half,
        Self::Quarter,
        Self::Octant,
        Self::Outer,
        Self::Inner,
    ];

    /// The name: `"whole"`, `"pieces"`, …
    pub fn name(self) -> &'static str {
        match self {
            Self::Whole => "whole",
            Self::Pieces => "pieces",
            Self::Half => "half",
            Self::Quarter => "quarter",
            Self::Octant => "octant",
            Self::Outer => "outer",
            Self::Inner => "inner",
        }
    }

    /// The part of this name.
    ///
    /// Errors: `Domain` when there is none.
    pub fn named(name: &str) -> Result<Self> {
        Self::ALL.into_iter().find(|part| part.name() == name).ok_or_else(|| {
            let names = Self::ALL.map(|part| format!("{:?}", part.name()));
            Error::domain("part", format!("{name:?}"), names.join(", "))
        })
    }

    /// The error for a part that a form does not have.
    pub(crate) fn absent(self, known: &[Self]) -> Error {
        let names: Vec<String> = known.iter().map(|part| format!("{:?}", part.name())).collect();
        Error::domain("part", format!("{:?}", self.name()), names.join(", "))
    }

    /// Cosine and sine of 45 degrees, of which quarter turns are made.
    ///
    /// Errors: `Domain` in fields without `√½`.
    pub(crate) fn half_root<S: Scalar>(self) -> Result<S> {
        S::half_root().ok_or_else(|| {
            Error::domain(
                "part",
                format!("{:?} in fractions, which have no √2", self.name()),
                "\"whole\", or floating arithmetic",
            )
        })
    }
}
