//! Exact mode: fractions of whole numbers of any size.

use num_bigint::{BigInt, Sign};
use num_traits::{One, Signed, ToPrimitive, Zero};
use pforms_kernel::{Error, Rational, Scalar};

use crate::arithmetic::{no_power, not_a_number};
use crate::elementary::use_floating_mode;
use crate::operator::{Call, Routine};
use crate::{Arguments, Arithmetic, Elementary, Failure, Operator, Value};

/// Digits of numerator and denominator together, in bits, before a number is refused.
pub const BITS_CAP: u64 = 1 << 16;

/// The largest power of ten in a literal.
const EXPONENT_CAP: i64 = 5_000;

impl Arithmetic for Rational {
    fn read(text: &str) -> Result<Self, Failure> {
        let (digits, exponent) = split_exponent(text).ok_or_else(|| not_a_number(text))?;
        let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
        let all: BigInt = format!("{whole}{decimals}").parse().map_err(|_| not_a_number(text))?;
        let exponent = exponent.saturating_sub(decimals.len() as i64);
        if exponent.abs() > EXPONENT_CAP {
            return Err(too_long(exponent.unsigned_abs()));
        }
        let scale = BigInt::from(10).pow(exponent.unsigned_abs() as u32);
        let value =
            if exponent < 0 { Self::new(all, scale) } else { Self::from_integer(all * scale) };
        value.checked()
    }

    fn write(&self) -> String {
        self.to_string()
    }

    fn json(&self) -> serde_json::Value {
        self.write().into()
    }

    fn apply(function: Elementary, x: &Self) -> Result<Self, Failure> {
        use Elementary::{Acos, Asin, Atan, Cos, Degrees, Exp, Ln, Log10, Radians, Sin, Sqrt, Tan};
        let value = match function {
            Sqrt if x.is_negative() => return Err(function.outside(&x.write())),
            Ln | Log10 if !x.is_positive() => return Err(function.outside(&x.write())),
            Asin | Acos if x.abs() > <Self as One>::one() => {
                return Err(function.outside(&x.write()));
            }
            Sqrt => root(x, 2),
            Sin | Tan | Asin | Atan | Radians | Degrees if Zero::is_zero(x) => Some(x.clone()),
            Cos | Exp if Zero::is_zero(x) => Some(<Self as One>::one()),
            Acos | Ln if One::is_one(x) => Some(<Self as Zero>::zero()),
            Log10 => decimal_logarithm(x),
            _ => None,
        };
        value.ok_or_else(|| function.irrational(&x.write()))
    }

    fn raise(&self, exponent: &Self) -> Result<Self, Failure> {
        let none = || use_floating_mode(no_power(self, exponent));
        let degree = exponent.denom().to_u32().ok_or_else(none)?;
        let base = if degree == 1 { self.clone() } else { root(self, degree).ok_or_else(none)? };
        let times = exponent.numer().abs().to_u64().ok_or_else(none)?;
        let bits = length(&base).saturating_mul(times);
        if Zero::is_zero(&base) && exponent.is_negative() {
            return Err(no_power(self, exponent));
        }
        if bits > BITS_CAP && !One::is_one(&base.abs()) && !Zero::is_zero(&base) {
            return Err(too_long(bits));
        }
        let power = base.power(times as usize);
        Ok(if exponent.is_negative() { power.recip() } else { power })
    }

    fn angle(y: &Self, x: &Self) -> Result<Self, Failure> {
        if Zero::is_zero(y) && !x.is_negative() {
            return Ok(<Self as Zero>::zero());
        }
        Err(Elementary::Atan.irrational(&format!("{y}, {x}")))
    }

    fn pi() -> Result<Self, Failure> {
        let error = Error::domain("PI", "exact mode", "floating mode");
        Err(use_floating_mode(Failure::of(error, "PI : reçu mode exact, attendu mode flottant")))
    }

    fn floor(&self) -> Self {
        Rational::floor(self)
    }

    fn whole(&self) -> Option<i64> {
        if self.is_integer() { self.numer().to_i64() } else { None }
    }

    fn to_exact(&self) -> Rational {
        self.clone()
    }

    fn bits(&self) -> f64 {
        (self.numer().bits() + self.denom().bits()) as f64
    }

    fn check(&self) -> Result<(), Failure> {
        let bits = length(self);
        if bits <= BITS_CAP { Ok(()) } else { Err(too_long(bits)) }
    }

    fn routine(call: &Call) -> Option<Routine<Self>> {
        call.exact
    }

    fn without_routine(operator: &'static Operator, _: &Arguments<Self>) -> Value<Self> {
        let error = Error::domain("mode", "exact mode", "floating mode");
        let french = "mode : reçu mode exact, attendu mode flottant";
        use_floating_mode(Failure::of(error, french)).within(operator).into()
    }
}

/// `"1.5e-3"` to `("1.5", -3)`; `None` unless there is a digit and nothing foreign.
fn split_exponent(text: &str) -> Option<(&str, i64)> {
    let (digits, exponent) = match text.split_once(['e', 'E']) {
        Some((digits, exponent)) => (digits, exponent.parse().ok()?),
        None => (text, 0),
    };
    let unsigned = digits.strip_prefix(['-', '+']).unwrap_or(digits);
    let plain = unsigned.chars().all(|c| c.is_ascii_digit() || c == '.');
    let some = unsigned.chars().any(|c| c.is_ascii_digit());
    (plain && some && digits.matches('.').count() <= 1).then_some((digits, exponent))
}

fn length(x: &Rational) -> u64 {
    x.numer().bits() + x.denom().bits()
}

/// The exact root of a fraction, if it is one.
fn root(x: &Rational, degree: u32) -> Option<Rational> {
    Some(Rational::new(whole_root(x.numer(), degree)?, whole_root(x.denom(), degree)?))
}

fn whole_root(x: &BigInt, degree: u32) -> Option<BigInt> {
    if degree == 0 || (x.sign() == Sign::Minus && degree.is_multiple_of(2)) {
        return None;
    }
    if u64::from(degree) > x.bits() && x.abs() > BigInt::one() {
        return None;
    }
    let root = x.nth_root(degree);
    (root.pow(degree) == *x).then_some(root)
}

fn decimal_logarithm(x: &Rational) -> Option<Rational> {
    let (whole, sign) = if x.is_integer() { (x.numer(), 1) } else { (x.denom(), -1) };
    if !x.is_integer() && !x.numer().is_one() {
        return None;
    }
    let digits = whole.to_string();
    let zeros = digits.strip_prefix('1')?;
    zeros.chars().all(|c| c == '0').then(|| Scalar::from_integer(sign * zeros.len() as i64))
}

fn too_long(bits: u64) -> Failure {
    Failure::new(
        "Limit",
        format!("a number of {bits} bits: refused, the cap is {BITS_CAP}"),
        format!("un nombre de {bits} bits : refusé, le plafond est {BITS_CAP}"),
    )
}
