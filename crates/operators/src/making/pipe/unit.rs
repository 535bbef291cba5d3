//! Unit vectors along polynomial ones, near enough polynomials themselves.

use super::poly::Poly;
use super::vector::Vector;
use crate::measuring::vector::{dot, norm, plus, scaled};

/// A polynomial near `G / |G|` on `[0, 1]` and a bound on its distance, when `|G|` is proved to stay
/// away from 0.
///
/// The polynomial `p` of degree 5 has the values and first two derivatives of the unit vector at
/// both ends. Its part across `G` is `|p × G| / |G|`, and its part along `G`, if positive, differs
/// from 1 by at most `| |p|² − 1 |` and the square of the other.
pub(super) fn unit_along(direction: &Vector) -> Option<(Vector, f64)> {
    let square = direction.dot(direction);
    let least = square.least();
    if least.is_nan() || least <= 0.0 {
        return None;
    }
    if direction.degree() == 0 {
        let value = direction.first();
        return Some((Vector::constant(value.map(|x| x / norm(&value))), 0.0));
    }
    let derivatives =
        [direction.clone(), direction.derivative(), direction.derivative().derivative()];
    let start = unit_jet(derivatives.each_ref().map(Vector::first));
    let end = unit_jet(derivatives.each_ref().map(Vector::last));
    let near = Vector::hermite(start, end);
    if near.dot(direction).least() <= 0.0 {
        return Some((near, f64::INFINITY));
    }
    let across = near.cross(direction).most() / least.sqrt();
    let along = near.dot(&near).plus(-1.0, &Poly::constant(1.0)).most() + across * across;
    Some((near, across.hypot(along)))
}

/// Value, first and second derivative of `G / |G|` from those of `G`.
fn unit_jet([g, d, dd]: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let length = norm(&g);
    let u = scaled(&g, 1.0 / length);
    let growth = dot(&u, &d);
    let du = scaled(&plus(&d, -growth, &u), 1.0 / length);
    let bend = dot(&du, &d) + dot(&u, &dd);
    let rest = plus(&plus(&dd, -bend, &u), -2.0 * growth, &du);
    let ddu = scaled(&rest, 1.0 / length);
    [u, du, ddu].map(|vector| [vector[0], vector[1], vector[2]])
}
