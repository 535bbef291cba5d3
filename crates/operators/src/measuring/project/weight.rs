//! A form has distances only where its weight does not vanish: this is proved first.

use pforms_kernel::{Error, Form, Result};

use crate::split;

/// What is known of the weights over the window, and the box of the form.
pub(in crate::measuring) struct Weights {
    /// The sign of all of them.
    pub sign: f64,
    /// A positive lower bound of their absolute values.
    pub least: f64,
    /// Their largest absolute value at a pole.
    pub largest: f64,
    /// Least coordinates of the form.
    pub lower: Vec<f64>,
    /// Largest coordinates.
    pub upper: Vec<f64>,
}

/// Parts that a window is cut into before a weight counts as vanishing.
const PARTS: usize = 1 << 12;

/// Weights of one sign over the whole window, by cutting it until every part has poles of that
/// sign, which bound the part too.
///
/// Errors: `Domain` where the weight vanishes or changes sign, or comes so near to it that no proof
/// is found; when a pole overflows.
pub(in crate::measuring) fn positive_weights(form: &Form) -> Result<Weights> {
    let ambient = form.ambient();
    let sign = form.homogeneous()[ambient].signum();
    let mut found = Weights {
        sign,
        least: f64::INFINITY,
        largest: form.weights().iter().fold(0.0, |most, w| most.max(w.abs())),
        lower: vec![f64::INFINITY; ambient],
        upper: vec![f64::NEG_INFINITY; ambient],
    };
    let window = (vec![0.0; form.axes()], vec![1.0; form.axes()]);
    let mut parts = vec![(form.clone(), window)];
    let mut count = 1;
    while let Some((part, (lower, upper))) = parts.pop() {
        if part.weights().iter().all(|weight| weight * sign > 0.0) {
            found.include(&part)?;
            continue;
        }
        if let Some(corner) = vanishing_corner(&part, sign, &lower, &upper) {
            return Err(vanishes(&corner));
        }
        count += 1;
        if count > PARTS {
            return Err(vanishes(&lower));
        }
        let axis = widest(&lower, &upper, form.orders());
        let middle = 0.5 * (lower[axis] + upper[axis]);
        let (left, right) = split(&part, axis, &0.5)?;
        let (mut before, mut after) = (upper.clone(), lower.clone());
        (before[axis], after[axis]) = (middle, middle);
        parts.extend([(left, (lower, before)), (right, (after, upper))]);
    }
    Ok(found)
}

impl Weights {
    /// Widens the box by the poles of a part whose weights have one sign.
    fn include(&mut self, part: &Form) -> Result<()> {
        let ambient = part.ambient();
        for pole in part.homogeneous().chunks_exact(ambient + 1) {
            self.least = self.least.min(pole[ambient].abs());
            for (k, x) in pole[..ambient].iter().enumerate() {
                let x = x / pole[ambient];
                if !x.is_finite() {
                    return Err(Error::domain("form", "a pole that overflows", "finite poles"));
                }
                self.lower[k] = self.lower[k].min(x);
                self.upper[k] = self.upper[k].max(x);
            }
        }
        Ok(())
    }
}

/// A corner of the part where the weight has not the sign.
fn vanishing_corner(part: &Form, sign: f64, lower: &[f64], upper: &[f64]) -> Option<Vec<f64>> {
    let axes = part.axes();
    (0..1_usize << axes.min(20)).find_map(|choice| {
        let far = |axis: usize| choice >> axis & 1 == 1;
        let index: Vec<usize> =
            (0..axes).map(|k| if far(k) { part.orders()[k] - 1 } else { 0 }).collect();
        let pole = part.pole(&index).ok()?;
        let place = |k: usize| if far(k) { upper[k] } else { lower[k] };
        (pole[part.ambient()] * sign <= 0.0).then(|| (0..axes).map(place).collect())
    })
}

fn widest(lower: &[f64], upper: &[f64], orders: &[usize]) -> usize {
    let width = |axis: &usize| if orders[*axis] > 1 { upper[*axis] - lower[*axis] } else { -1.0 };
    let axes = 0..orders.len();
    axes.fold(0, |best, axis| if width(&axis) > width(&best) { axis } else { best })
}

fn vanishes(at: &[f64]) -> Error {
    let received = if at.is_empty() {
        "weight 0".to_owned()
    } else {
        format!("a weight that vanishes or changes sign near {at:?}")
    };
    Error::domain("form", received, "weights of one sign over the window, 0 to 1 on each axis")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(weights: &[f64]) -> Form {
        let poles = weights.iter().enumerate().flat_map(|(i, w)| [i as f64 * w, *w]).collect();
        Form::from_homogeneous(&[weights.len()], 1, poles).unwrap()
    }

    #[test]
    fn a_negative_pole_is_no_vanishing_weight() {
        let found = positive_weights(&curve(&[1.0, -0.5, 1.0])).unwrap();
        assert!(found.least > 0.0 && found.least <= 0.25);
        assert_eq!(found.sign, 1.0);
        assert_eq!(positive_weights(&curve(&[-1.0, -2.0])).unwrap().sign, -1.0);
    }

    #[test]
    fn a_weight_that_vanishes_is_named() {
        for weights in [&[1.0, -1.0][..], &[1.0, -1.0, 1.0], &[0.0, 1.0], &[1.0, -2.0, 1.0]] {
            let error = positive_weights(&curve(weights)).err().unwrap();
            assert!(error.to_string().contains("vanishes"), "{error}");
        }
        let point: Form = Form::from_homogeneous(&[], 1, vec![1.0, 0.0]).unwrap();
        assert!(positive_weights(&point).is_err());
    }
}
