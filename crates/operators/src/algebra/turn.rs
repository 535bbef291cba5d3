//! How far to turn: an angle as its cosine and sine.

use std::f64::consts::PI;

use pforms_kernel::{Error, Result, Scalar};

/// An angle, held as cosine and sine: what a rotation is made of.
///
/// Angles are in **radians** wherever nothing else is said; [`Turn::degrees`] is for those of the
/// book. Quarter turns and half-angle tangents make turns that are exact in every scalar.
#[derive(Clone, Debug, PartialEq)]
pub struct Turn<S = f64> {
    cosine: S,
    sine: S,
}

impl<S: Scalar> Turn<S> {
    /// So many quarters of a turn; negative ones the other way. Exact.
    pub fn quarters(count: i64) -> Self {
        let (cosine, sine) = [(1, 0), (0, 1), (-1, 0), (0, -1)][count.rem_euclid(4) as usize];
        Self { cosine: S::from_integer(cosine), sine: S::from_integer(sine) }
    }

    /// The turn with cosine `(1 − t²)/(1 + t²)` and sine `2t/(1 + t²)`, `t` the tangent of half its
    /// angle. Exact: a fraction gives fractions, as `t = 1/2` gives 3/5 and 4/5.
    ///
    /// Errors: `Domain` when `t` is not finite.
    ///
    /// ```
    /// use pforms_kernel::{Rational, Scalar};
    /// use pforms_operators::Turn;
    /// let turn = Turn::<Rational>::half_tangent(&Rational::ratio(1, 2))?;
    /// assert_eq!(turn.cosine(), &Rational::ratio(3, 5));
    /// # Ok::<(), pforms_kernel::Error>(())
    /// ```
    pub fn half_tangent(t: &S) -> Result<Self> {
        if !t.is_finite() {
            return Err(Error::domain("half tangent", format!("{t:?}"), "a finite number"));
        }
        // From 1 on by the inverse of t, whose square cannot overflow.
        let one = S::one();
        let steep = one < *t || *t < -one.clone();
        let t = if steep { one.clone() / t.clone() } else { t.clone() };
        let square = t.clone() * t.clone();
        let whole = one.clone() + square.clone();
        let cosine = (one - square) / whole.clone();
        let sine = (t.clone() + t) / whole;
        Ok(Self { cosine: if steep { -cosine } else { cosine }, sine })
    }

    /// The turn with this cosine and sine, which the caller knows to lie on the unit circle.
    ///
    /// Errors: `Domain` when they are not finite, and in exact arithmetic unless the sum of their
    /// squares is 1.
    pub fn of(cosine: S, sine: S) -> Result<Self> {
        let norm = cosine.clone() * cosine.clone() + sine.clone() * sine.clone();
        if !norm.is_finite() || (S::EXACT && norm != S::one()) {
            return Err(Error::domain(
                "turn",
                format!("cosine {cosine:?}, sine {sine:?}"),
                "finite numbers whose squares add up to 1",
            ));
        }
        Ok(Self { cosine, sine })
    }

    /// Cosine of the angle.
    pub fn cosine(&self) -> &S {
        &self.cosine
    }

    /// Sine of the angle.
    pub fn sine(&self) -> &S {
        &self.sine
    }

    /// The same angle the other way.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { cosine: self.cosine.clone(), sine: -self.sine.clone() }
    }
}

impl Turn<f64> {
    /// An angle in radians; cosine and sine within an ulp, the same on every platform.
    ///
    /// Errors: `Domain` when it is not finite.
    pub fn radians(angle: f64) -> Result<Self> {
        require_finite(angle)?;
        Ok(Self { cosine: libm::cos(angle), sine: libm::sin(angle) })
    }

    /// An angle in degrees, first brought into one turn without rounding: multiples of 90 are exact.
    ///
    /// Errors: `Domain` when it is not finite.
    pub fn degrees(angle: f64) -> Result<Self> {
        require_finite(angle)?;
        let within = angle % 360.0;
        let quarters = libm::rint(within / 90.0);
        let rest = (within - 90.0 * quarters) / 180.0 * PI;
        let (c, s) = (libm::cos(rest), libm::sin(rest));
        let (cosine, sine) = match (quarters as i64).rem_euclid(4) {
            0 => (c, s),
            1 => (-s, c),
            2 => (-c, -s),
            _ => (s, -c),
        };
        Ok(Self { cosine, sine })
    }
}

fn require_finite(angle: f64) -> Result<()> {
    if angle.is_finite() {
        return Ok(());
    }
    Err(Error::domain("angle", angle, "a finite number"))
}
