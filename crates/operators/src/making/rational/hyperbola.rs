//! Arcs of a hyperbola of given height.

use pforms_kernel::{Form, Result};

use crate::algebra::{hyperbola_by, require_positive};

/// The arc of the hyperbola `x²/a² − y²/b² = 1` from `y = −h` to `y = h`, on the side of positive x: a
/// pL3 of weights `1, cosh, 1`, where `sinh = h/b`.
///
/// The root is rounded once, so the equation holds within a few roundings.
///
/// Errors: `Domain` unless all three are positive, and when the arc overflows.
///
/// ```
/// let arc = pforms_operators::hyperbola(3.0, 4.0, 3.0)?; // sinh 3/4, cosh 5/4
/// assert_eq!(arc.weights(), [1.0, 1.25, 1.0]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn hyperbola(a: f64, b: f64, height: f64) -> Result<Form> {
    require_positive("b", &b)?;
    require_positive("height", &height)?;
    let sinh = height / b;
    hyperbola_by(&a, &b, &[libm::hypot(1.0, sinh), sinh])
}
