//! The one family of errors. Each names the argument, what came and what was expected.

use std::fmt;

/// The result of everything that can go wrong in pforms.
pub type Result<T> = std::result::Result<T, Error>;

/// An argument, what was received for it, and what was expected instead.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The argument's name, as the caller wrote it.
    pub argument: String,
    /// What came.
    pub received: String,
    /// What would have been right.
    pub expected: String,
}

/// A place in a text; both counts start at 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The line.
    pub line: usize,
    /// The column, in characters.
    pub column: usize,
}

/// What can go wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Error {
    /// Numbers of axes, orders or dimensions that do not fit together.
    Shape(Fault),
    /// A value outside the range where the answer exists: NaN, infinity, a vanishing weight.
    Domain(Fault),
    /// Data too special for the question: coincident points, a frame of a straight line.
    Degenerate(Fault),
    /// The accuracy asked for was not reached.
    Accuracy(Fault),
    /// A text or file that is not what it claims to be.
    Format {
        /// What was being read.
        what: String,
        /// Where it went wrong, when that is known.
        place: Option<Place>,
        /// What is wrong there.
        message: String,
    },
    /// A result larger than the cap on allocations.
    Limit {
        /// What would have been made, with its forecast size.
        what: String,
        /// Bytes it would have taken.
        bytes: u128,
        /// Bytes allowed.
        cap: u128,
    },
    /// Whoever had started the work stopped it; see [`crate::stopping`].
    Stopped,
}

impl Error {
    /// A [`Error::Shape`].
    pub fn shape(argument: &str, received: impl fmt::Display, expected: impl fmt::Display) -> Self {
        Self::Shape(Fault::new(argument, received, expected))
    }

    /// A [`Error::Domain`].
    pub fn domain(
        argument: &str,
        received: impl fmt::Display,
        expected: impl fmt::Display,
    ) -> Self {
        Self::Domain(Fault::new(argument, received, expected))
    }

    /// A [`Error::Degenerate`].
    pub fn degenerate(
        argument: &str,
        received: impl fmt::Display,
        expected: impl fmt::Display,
    ) -> Self {
        Self::Degenerate(Fault::new(argument, received, expected))
    }

    /// A [`Error::Accuracy`].
    pub fn accuracy(
        argument: &str,
        received: impl fmt::Display,
        expected: impl fmt::Display,
    ) -> Self {
        Self::Accuracy(Fault::new(argument, received, expected))
    }

    /// A [`Error::Format`] at a known place.
    pub fn format(what: &str, place: Option<Place>, message: impl fmt::Display) -> Self {
        Self::Format { what: what.to_owned(), place, message: message.to_string() }
    }

    /// The name of the variant, the same in every face: `Shape`, `Domain`, …
    pub fn family(&self) -> &'static str {
        match self {
            Self::Shape(_) => "Shape",
            Self::Domain(_) => "Domain",
            Self::Degenerate(_) => "Degenerate",
            Self::Accuracy(_) => "Accuracy",
            Self::Format { .. } => "Format",
            Self::Limit { .. } => "Limit",
            Self::Stopped => "Stopped",
        }
    }
}

impl Fault {
    fn new(argument: &str, received: impl fmt::Display, expected: impl fmt::Display) -> Self {
        Self {
            argument: argument.to_owned(),
            received: received.to_string(),
            expected: expected.to_string(),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { argument, received, expected } = self;
        write!(f, "{argument}: received {received}, expected {expected}")
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shape(fault)
            | Self::Domain(fault)
            | Self::Degenerate(fault)
            | Self::Accuracy(fault) => fault.fmt(f),
            Self::Format { what, place: Some(Place { line, column }), message } => {
                write!(f, "{what}, line {line}, column {column}: {message}")
            }
            Self::Format { what, message, .. } => write!(f, "{what}: {message}"),
            Self::Limit { what, bytes, cap } => write!(
                f,
                "{what}, {}: refused, the cap is {}",
                crate::limit::readable(*bytes),
                crate::limit::readable(*cap)
            ),
            Self::Stopped => write!(f, "stopped from outside"),
        }
    }
}

impl std::error::Error for Error {}
