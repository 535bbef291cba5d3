//! The elementary functions, the same to the bit on every platform.

use std::f64::consts::{LN_2, LN_10, PI};

use pforms_kernel::Error;

use crate::Failure;

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Elementary {
    /// Square root.
    Sqrt,
    /// Sine of an angle in radians.
    Sin,
    /// Cosine of an angle in radians.
    Cos,
    /// Tangent of an angle in radians.
    Tan,
    /// Arc sine, in radians.
    Asin,
    /// Arc cosine, in radians.
    Acos,
    /// Arc tangent, in radians.
    Atan,
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Decimal logarithm.
    Log10,
    /// Degrees to radians.
    Radians,
    /// Radians to degrees.
    Degrees,
}

impl Elementary {
    /// The value in floating arithmetic; not finite outside the domain.
    pub(crate) fn evaluate(self, x: f64) -> f64 {
        match self {
            Self::Sqrt => libm::sqrt(x),
            Self::Sin => libm::sin(x),
            Self::Cos => libm::cos(x),
            Self::Tan => libm::tan(x),
            Self::Asin => libm::asin(x),
            Self::Acos => libm::acos(x),
            Self::Atan => libm::atan(x),
            Self::Exp => libm::exp(x),
            Self::Ln => libm::log(x),
            Self::Log10 => libm::log10(x),
            Self::Radians => x / 180.0 * PI,
            Self::Degrees => x / PI * 180.0,
        }
    }

    /// The derivative.
    pub(crate) fn slope(self, x: f64) -> f64 {
        match self {
            Self::Sqrt => 0.5 / libm::sqrt(x),
            Self::Sin => libm::cos(x),
            Self::Cos => -libm::sin(x),
            Self::Tan => 1.0 + libm::tan(x).powi(2),
            Self::Asin => 1.0 / libm::sqrt((1.0 - x) * (1.0 + x)),
            Self::Acos => -1.0 / libm::sqrt((1.0 - x) * (1.0 + x)),
            Self::Atan => 1.0 / (1.0 + x * x),
            Self::Exp => libm::exp(x),
            Self::Ln => 1.0 / x,
            Self::Log10 => 1.0 / (x * LN_10),
            Self::Radians => PI / 180.0,
            Self::Degrees => 180.0 / PI,
        }
    }

    /// The name a formula calls it by.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sqrt => "SQRT",
            Self::Sin => "SIN",
            Self::Cos => "COS",
            Self::Tan => "TAN",
            Self::Asin => "ASIN",
            Self::Acos => "ACOS",
            Self::Atan => "ATAN",
            Self::Exp => "EXP",
            Self::Ln => "LN",
            Self::Log10 => "LOG",
            Self::Radians => "RADIANS",
            Self::Degrees => "DEGREES",
        }
    }

    /// The error for a number outside the domain.
    pub(crate) fn outside(self, received: &str) -> Failure {
        let (en, fr) = self.domain();
        Failure::of(Error::domain("x", received, en), format!("x : reçu {received}, attendu {fr}"))
    }

    /// The error for a value that exact mode cannot hold.
    pub(crate) fn irrational(self, received: &str) -> Failure {
        let call = format!("{}({received})", self.name());
        let error = Error::domain("x", received, format!("an x for which {call} is a fraction"));
        let french = format!("x : reçu {received}, attendu un x dont {call} soit une fraction");
        use_floating_mode(Failure::of(error, french))
    }

    fn domain(self) -> (String, String) {
        match self {
            Self::Sqrt => ("a number at least 0".into(), "un nombre au moins égal à 0".into()),
            Self::Ln | Self::Log10 => ("a number above 0".into(), "un nombre positif".into()),
            Self::Asin | Self::Acos => {
                ("a number from -1 to 1".into(), "un nombre de -1 à 1".into())
            }
            Self::Exp => {
                let top = 1024.0 * LN_2;
                (format!("a number below {top:.1}"), format!("un nombre inférieur à {top:.1}"))
            }
            _ => ("a smaller number".into(), "un nombre plus petit".into()),
        }
    }
}

/// Adds the advice that exact mode stops here.
pub(crate) fn use_floating_mode(failure: Failure) -> Failure {
    failure.with_hint(
        "exact mode has no irrational numbers; use floating mode",
        "le mode exact n'a pas de nombres irrationnels ; passez en mode flottant",
    )
}
