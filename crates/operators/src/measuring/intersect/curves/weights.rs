//! Curves whose weights have not one sign, cut until they do: then a part lies in the hull of its
//! poles.

use pforms_kernel::{Error, Form, Result};

use crate::{Shape, Spline, split};

/// Halvings before a weight counts as vanishing.
const DEPTH: u32 = 24;

/// The same curve in parts with weights of one sign.
///
/// Errors: `Domain` where the weight vanishes in the window: the curve goes to infinity.
pub(super) fn positive(name: &str, form: &Form) -> Result<Shape> {
    if has_one_sign(form) {
        return Ok(form.clone().into());
    }
    let (mut parts, mut breaks) = (Vec::new(), vec![0.0]);
    cut(name, form, (0.0, 1.0), DEPTH, &mut parts, &mut breaks)?;
    Ok(Spline::end_to_end(&parts, 0, &breaks)?.into())
}

fn has_one_sign(form: &Form) -> bool {
    let weights = form.weights();
    weights.iter().all(|w| *w > 0.0) || weights.iter().all(|w| *w < 0.0)
}

fn cut(
    name: &str,
    form: &Form,
    (from, to): (f64, f64),
    depth: u32,
    parts: &mut Vec<Form>,
    breaks: &mut Vec<f64>,
) -> Result<()> {
    if has_one_sign(form) {
        parts.push(form.clone());
        breaks.push(to);
        return Ok(());
    }
    let weights = form.weights();
    let ends = weights[0] * weights[weights.len() - 1];
    if depth == 0 || ends <= 0.0 || ends.is_nan() {
        let received = format!("a weight that vanishes near {from}");
        return Err(Error::domain(name, received, "a curve that stays finite"));
    }
    let middle = 0.5 * (from + to);
    let (low, high) = split(form, 0, &0.5)?;
    cut(name, &low, (from, middle), depth - 1, parts, breaks)?;
    cut(name, &high, (middle, to), depth - 1, parts, breaks)
}
