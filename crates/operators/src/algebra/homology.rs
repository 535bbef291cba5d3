//! Maps that leave every point of a plane and one more point where they are.
//!
//! With the plane as a covector `π = (n, −n·o)` and the fixed point `E` in homogeneous coordinates,
//! all of them are `p − k·(π·p)/(π·E)·E`: `k = 1` projects from `E`, `k = 2` mirrors. A point on the
//! plane has `π·p = 0` and stays, weight and all; a weight 0 makes `E` a direction.

use pforms_kernel::{Error, Matrix, Result, Scalar};

use super::transform::{one_if, require_in_space};

/// A plane (a line in 2D, a hyperplane beyond) as `π = (n, −n·o)`.
pub(super) fn plane<S: Scalar>(normal: &[S], origin: &[S]) -> Result<Vec<S>> {
    if normal.is_empty() {
        return Err(Error::shape("normal", "no coordinates", "at least 1"));
    }
    require_in_space("normal", normal, normal.len())?;
    require_in_space("origin", origin, normal.len())?;
    if normal.iter().all(Scalar::is_zero) {
        return Err(Error::degenerate("normal", "a zero vector", "a direction"));
    }
    let normal = scaled_down(normal);
    let offset = -dot(&normal, origin);
    Ok(normal.into_iter().chain([offset]).collect())
}

/// The matrix `I − k·E·πᵀ/(π·E)`.
///
/// Errors: `Degenerate` when `E` lies on the plane; `Domain` when a number overflows.
pub(super) fn homology<S: Scalar>(
    plane: &[S],
    centre: &[S],
    k: &S,
    argument: &str,
) -> Result<Matrix<S>> {
    let centre = scaled_down(centre);
    let height = dot(plane, &centre);
    if height.is_zero() {
        return Err(Error::degenerate(
            argument,
            "a point or direction of the plane itself",
            "one off the plane",
        ));
    }
    let width = plane.len();
    Ok(Matrix::from_rule(width, width, |row, column| {
        let taken = k.clone() * (centre[row].clone() * plane[column].clone() / height.clone());
        one_if::<S>(row == column) - taken
    }))
}

/// The same ray with numbers near 1: their products neither overflow nor vanish.
///
/// By a power of two, so that no bit of `f64` is lost; exact numbers have no need of it.
fn scaled_down<S: Scalar>(vector: &[S]) -> Vec<S> {
    let largest = vector.iter().fold(0.0_f64, |largest, x| largest.max(x.to_f64().abs()));
    if S::EXACT || largest == 0.0 {
        return vector.to_vec();
    }
    let exponent = -libm::ilogb(largest).clamp(-MOST, MOST);
    let factor = S::from_f64(libm::scalbn(1.0, exponent)).unwrap_or_else(S::one);
    vector.iter().map(|x| x.clone() * factor.clone()).collect()
}

/// Exponents whose power of two and its inverse are both numbers.
const MOST: i32 = 1000;

fn dot<S: Scalar>(a: &[S], b: &[S]) -> S {
    a.iter().zip(b).fold(S::zero(), |sum, (x, y)| sum + x.clone() * y.clone())
}
