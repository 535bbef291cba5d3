//! What differs between floating and exact mode: reading, writing and the elementary functions.

use pforms_kernel::{Error, Rational, Scalar};

use crate::operator::{Call, Routine};
use crate::{Arguments, Elementary, Failure, Operator, Value};

/// A scalar that a sheet can compute with: `f64`, `Rational`, or `Traced` for derivatives.
pub trait Arithmetic: Scalar {
    /// Reads a decimal literal such as `0.1` or `1e-3`; exactly, if numbers are exact.
    ///
    /// Errors: `Format` when it is none; `Limit` when it is too large or too small to hold.
    fn read(text: &str) -> Result<Self, Failure>;

    /// The shortest text that reads back as the same number: `0.1`, `1e-9`, `1/3`.
    fn write(&self) -> String;

    /// A JSON number in floating mode, a string such as `"1/3"` in exact mode.
    fn json(&self) -> serde_json::Value;

    /// The value of an elementary function.
    ///
    /// Errors: `Domain` outside its domain, and in exact mode when the value is no fraction.
    fn apply(function: Elementary, x: &Self) -> Result<Self, Failure>;

    /// `self` to the power `exponent`; `0⁰ = 1`.
    ///
    /// Errors: as [`Arithmetic::apply`].
    fn raise(&self, exponent: &Self) -> Result<Self, Failure>;

    /// The angle of the direction `(x, y)`, from −π to π.
    ///
    /// Errors: as [`Arithmetic::apply`].
    fn angle(y: &Self, x: &Self) -> Result<Self, Failure>;

    /// The ratio of a circle's circumference to its diameter.
    ///
    /// Errors: `Domain` in exact mode.
    fn pi() -> Result<Self, Failure>;

    /// The greatest whole number not above `self`.
    #[must_use]
    fn floor(&self) -> Self;

    /// The number as a small whole number, if it is one.
    fn whole(&self) -> Option<i64>;

    /// The number as an `f64`, for work that is done in these alone.
    ///
    /// Errors: `Domain` where that would lose what the number carries.
    fn plain(&self) -> Result<f64, Failure> {
        Ok(self.to_f64())
    }

    /// The simple fraction that this number stands for.
    ///
    /// `0.1` in `f64` becomes `1/10` in exact mode and the quotient `1.0/3.0` becomes `1/3`, not the
    /// binary fraction next to it.
    fn to_exact(&self) -> Rational;

    /// Bits of its digits where numbers grow; 0 where they all have one size.
    fn bits(&self) -> f64;

    /// May this number flow on?
    ///
    /// Errors: `Domain` when it is not finite; `Limit` when it has too many digits.
    fn check(&self) -> Result<(), Failure>;

    /// The number itself, checked.
    ///
    /// Errors: as [`Arithmetic::check`].
    fn checked(self) -> Result<Self, Failure> {
        self.check().map(|()| self)
    }

    #[doc(hidden)]
    fn routine(call: &Call) -> Option<Routine<Self>>;

    /// What an operator without a routine for these numbers answers.
    #[doc(hidden)]
    fn without_routine(operator: &'static Operator, arguments: &Arguments<Self>) -> Value<Self>;
}

impl Arithmetic for f64 {
    fn read(text: &str) -> Result<Self, Failure> {
        text.parse::<f64>().map_err(|_| not_a_number(text))?.checked()
    }

    fn write(&self) -> String {
        let size = self.abs();
        if size == 0.0 {
            "0".to_owned()
        } else if (1e-6..1e16).contains(&size) {
            self.to_string()
        } else {
            format!("{self:e}")
        }
    }

    fn json(&self) -> serde_json::Value {
        (*self).into()
    }

    fn apply(function: Elementary, x: &Self) -> Result<Self, Failure> {
        let value = function.evaluate(*x);
        if value.is_finite() { Ok(value) } else { Err(function.outside(&x.write())) }
    }

    fn raise(&self, exponent: &Self) -> Result<Self, Failure> {
        let value = libm::pow(*self, *exponent);
        if value.is_finite() { Ok(value) } else { Err(no_power(self, exponent)) }
    }

    fn angle(y: &Self, x: &Self) -> Result<Self, Failure> {
        Ok(libm::atan2(*y, *x))
    }

    fn pi() -> Result<Self, Failure> {
        Ok(std::f64::consts::PI)
    }

    fn floor(&self) -> Self {
        libm::floor(*self)
    }

    fn whole(&self) -> Option<i64> {
        (libm::floor(*self) == *self && self.abs() <= 2f64.powi(53)).then_some(*self as i64)
    }

    fn to_exact(&self) -> Rational {
        simplest(*self).unwrap_or_default()
    }

    fn bits(&self) -> f64 {
        0.0
    }

    fn check(&self) -> Result<(), Failure> {
        if self.is_finite() {
            return Ok(());
        }
        let error = Error::domain("result", self, "a finite number");
        Err(Failure::of(error, format!("résultat : reçu {self}, attendu un nombre fini")))
    }

    fn routine(call: &Call) -> Option<Routine<Self>> {
        Some(call.floating)
    }

    fn without_routine(_: &'static Operator, _: &Arguments<Self>) -> Value<Self> {
        Value::Empty
    }
}

/// The first convergent of the continued fraction of `x` that is `x` once rounded.
///
/// Convergents are the best approximations for their denominators (Hardy and Wright, *An
/// Introduction to the Theory of Numbers*, chapter X). `None` for what is not finite.
fn simplest(x: f64) -> Option<Rational> {
    let mut rest = Rational::from_f64(x)?;
    let one = <Rational as Scalar>::one();
    let zero = <Rational as Scalar>::zero();
    let (mut last, mut above) = ((zero.clone(), one.clone()), (one, zero));
    loop {
        let whole = rest.floor();
        let next = (&whole * &above.0 + last.0, &whole * &above.1 + last.1);
        let convergent = &next.0 / &next.1;
        rest -= whole;
        if convergent.to_f64() == x || Scalar::is_zero(&rest) {
            return Some(convergent);
        }
        rest = rest.recip();
        (last, above) = (above, next);
    }
}

pub(crate) fn not_a_number(text: &str) -> Failure {
    let shown: String = text.chars().take(40).collect();
    Failure::of(
        Error::format("number", None, format!("“{shown}” is not a number")),
        format!("« {shown} » n'est pas un nombre"),
    )
}

pub(crate) fn no_power<S: Arithmetic>(base: &S, exponent: &S) -> Failure {
    let received = format!("{} ^ {}", base.write(), exponent.write());
    let french = format!("puissance : reçu {received}, attendu une puissance qui existe");
    Failure::of(Error::domain("power", received, "a power that exists"), french)
}

/// Passes if work in `f64` alone loses nothing that the numbers carry, see [`Arithmetic::plain`].
pub(crate) fn require_plain<S: Arithmetic>(numbers: &[S]) -> Result<(), Failure> {
    numbers.iter().try_for_each(|x| x.plain().map(drop))
}

/// `a / b`.
///
/// Errors: `Domain` when `b` is 0 or the quotient is not finite.
pub(crate) fn quotient<S: Arithmetic>(a: &S, b: &S) -> Result<S, Failure> {
    if b.is_zero() {
        let error = Error::domain("divisor", 0, "a number other than 0");
        return Err(Failure::of(error, "diviseur : reçu 0, attendu un nombre non nul"));
    }
    (a.clone() / b.clone()).checked()
}
