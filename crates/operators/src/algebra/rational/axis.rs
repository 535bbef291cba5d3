//! An axis to turn about.

use pforms_kernel::{Error, Result, Scalar};

/// A line with a direction: through a point, along a unit vector.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis<S = f64> {
    pub(super) through: [S; 3],
    pub(super) direction: [S; 3],
}

impl<S: Scalar> Axis<S> {
    /// The axis Oy, upright in the book.
    pub fn upright() -> Self {
        let (one, zero) = (S::one, S::zero);
        Self { through: [zero(), zero(), zero()], direction: [zero(), one(), zero()] }
    }

    /// The axis through a point along a direction, given with its length.
    ///
    /// Errors: `Degenerate` when the length is 0, `Domain` when a number is not finite and, in exact
    /// arithmetic, when the length is not that of the direction.
    pub fn with_length(through: [S; 3], direction: [S; 3], length: &S) -> Result<Self> {
        if through.iter().chain(&direction).any(|x| !x.is_finite()) {
            let received = format!("{through:?}, {direction:?}");
            return Err(Error::domain("axis", received, "finite numbers"));
        }
        if length.is_zero() {
            return Err(Error::degenerate("axis", "a direction of length 0", "a direction"));
        }
        let [x, y, z] = &direction;
        let square = |x: &S| x.clone() * x.clone();
        if S::EXACT && square(x) + square(y) + square(z) != square(length) {
            return Err(Error::domain("axis", format!("the length {length:?}"), "its length"));
        }
        let direction = direction.map(|x| x / length.clone());
        Ok(Self { through, direction })
    }
}

impl Axis {
    /// The axis through a point along a direction of any length.
    ///
    /// Errors: as [`Axis::with_length`].
    pub fn new(through: [f64; 3], direction: [f64; 3]) -> Result<Self> {
        // Scaled first, so that no square overflows or vanishes.
        let size = direction.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let scaled = if size > 0.0 { direction.map(|x| x / size) } else { direction };
        let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
        Self::with_length(through, scaled, &length)
    }
}
