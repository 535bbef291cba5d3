//! Pieces brought to a size about 1 and seen from near, without loss.

use pforms_kernel::{Error, Form, Result, Scalar};

use crate::algebra::split;
use crate::measuring::about_one::with_weights_about_one;
use crate::measuring::scale::{in_units, unit};

/// Pieces in units of a power of two, seen from one point, their weights about 1.
pub(crate) struct Local {
    pub pieces: Vec<Form>,
    /// The same where they were given, free of rounding.
    pub given: Vec<Form>,
    /// The point they are seen from, in units.
    pub origin: Vec<f64>,
    /// What their lengths are to be multiplied by.
    pub unit: f64,
}

impl Local {
    /// Errors: `Domain` when a piece is at infinity.
    pub(crate) fn new(pieces: &[Form]) -> Result<Self> {
        let coarse = unit(pieces);
        let about_one = |piece: &Form| {
            require_weight(piece)?;
            with_weights_about_one(&in_units(piece, coarse)?)
        };
        let given = pieces.iter().map(about_one).collect::<Result<Vec<_>>>()?;
        let origin = given.first().map(heaviest).unwrap_or_default();
        let seen = given.iter().map(|piece| seen_from(piece, &origin));
        let seen = seen.collect::<Result<Vec<_>>>()?;
        let fine = unit(&seen);
        let in_fine = |list: &[Form]| -> Result<Vec<Form>> {
            list.iter().map(|piece| in_units(piece, fine)).collect()
        };
        Ok(Self {
            pieces: in_fine(&seen)?,
            given: in_fine(&given)?,
            origin: origin.iter().map(|x| x / fine).collect(),
            unit: coarse * fine,
        })
    }
}

/// The given form in numbers of more digits, seen from `origin`.
pub(super) fn sharply_seen<S: Scalar>(given: &Form, origin: &[f64]) -> Result<Form<S>> {
    let width = given.width();
    let exact = |x: f64| S::from_f64(x).unwrap_or_else(S::zero);
    let origin: Vec<S> = origin.iter().map(|x| exact(*x)).collect();
    let mut poles = Vec::with_capacity(given.homogeneous().len());
    for pole in given.homogeneous().chunks_exact(width) {
        let weight = exact(pole[width - 1]);
        let pairs = pole.iter().zip(&origin);
        poles.extend(pairs.map(|(x, o)| exact(*x) - o.clone() * weight.clone()));
        poles.push(weight);
    }
    Form::from_homogeneous(given.orders(), given.ambient(), poles)
}

/// The point of the heaviest pole.
pub(crate) fn heaviest(form: &Form) -> Vec<f64> {
    let ambient = form.ambient();
    let mut poles = form.homogeneous().chunks_exact(form.width());
    let first = poles.next().unwrap_or_default();
    let pole =
        poles.fold(first, |best, p| if p[ambient].abs() > best[ambient].abs() { p } else { best });
    pole[..ambient].iter().map(|x| x / pole[ambient]).collect()
}

/// The form moved so that `origin` is at 0; each number is rounded once, however far it is.
pub(crate) fn seen_from(form: &Form, origin: &[f64]) -> Result<Form> {
    let width = form.width();
    let mut poles = form.homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(width) {
        let weight = pole[width - 1];
        for (x, o) in pole.iter_mut().zip(origin) {
            let [product, rest] = product(*o, weight);
            *x = (*x - product) - rest;
        }
    }
    Form::from_homogeneous(form.orders(), form.ambient(), poles)
}

/// A product and what rounding took from it (Veltkamp and Dekker).
fn product(a: f64, b: f64) -> [f64; 2] {
    let halves = |x: f64| {
        let wide = x * (f64::from(1 << 27) + 1.0);
        let high = wide - (wide - x);
        [high, x - high]
    };
    let ([a1, a2], [b1, b2], whole) = (halves(a), halves(b), a * b);
    [whole, a2 * b2 - (((whole - a1 * b1) - a2 * b1) - a1 * b2)]
}

/// A lower bound of the weight over the window; 0 where it may vanish.
pub(crate) fn least_weight(piece: &Form) -> Result<f64> {
    /// Halvings after which a weight counts as one that may vanish.
    const HALVINGS: usize = 24;
    let mut parts = vec![(piece.clone(), 0)];
    let mut least = f64::INFINITY;
    while let Some((part, depth)) = parts.pop() {
        let here = part.weights().into_iter().fold(f64::INFINITY, f64::min);
        if here > 0.0 || part.axes() == 0 {
            least = least.min(here.max(0.0));
        } else if depth == HALVINGS * part.axes() {
            return Ok(0.0);
        } else {
            let (low, high) = split(&part, depth % part.axes(), &0.5)?;
            parts.extend([(high, depth + 1), (low, depth + 1)]);
        }
    }
    Ok(least)
}

fn require_weight(piece: &Form) -> Result<()> {
    if piece.weights().iter().all(|weight| *weight == 0.0) {
        return Err(infinite());
    }
    Ok(())
}

/// What is said of forms that leave every bound.
pub(crate) fn infinite() -> Error {
    Error::domain(
        "form",
        "a form that goes to infinity, where its weight vanishes",
        "a form of finite size",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn far_forms_keep_their_digits() {
        // (1/3, 2/3) of weight 3, seen from a far pole: the difference is right to its last digit.
        let x = 1e9 + 0.1;
        let form: Form =
            Form::from_homogeneous(&[2], 1, vec![x * 4.0, 4.0, x + 1e-6, 1.0]).unwrap();
        let seen = seen_from(&form, &[x]).unwrap();
        assert_eq!(seen.homogeneous()[0], 0.0);
        assert_eq!(seen.homogeneous()[2], (x + 1e-6) - x);
        let [high, low] = product(1.0 / 3.0, 0.1);
        assert!(low != 0.0 && low.abs() <= f64::EPSILON * high);
    }
}
