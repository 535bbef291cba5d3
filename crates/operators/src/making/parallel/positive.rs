//! Is a polynomial positive on the whole window, and if not, where?

use pforms_kernel::{Form, Result};

use crate::split;

/// Parts looked at before the one in doubt counts as not positive.
const MOST: usize = 1 << 13;

/// Parameters where a function is not above `noise`, if it is not above it everywhere.
///
/// The coefficients bound it from below on every part; those at the corners are its values. A part
/// halved `depth` times that is still in doubt counts as not positive.
pub(super) fn refuted(function: &Form, noise: f64, depth: usize) -> Result<Option<Vec<f64>>> {
    let (axes, deepest) = (function.axes(), depth);
    let mut seen = 0;
    let mut parts = vec![(function.clone(), vec![0.0; axes], vec![1.0; axes], 0)];
    while let Some((part, low, high, depth)) = parts.pop() {
        let values = part.points()?;
        seen += 1;
        if values.iter().all(|value| *value > noise) {
            continue;
        }
        if let Some(corner) = worst_corner(&part, &values, &low, &high, noise) {
            return Ok(Some(corner));
        }
        if depth >= deepest || seen > MOST {
            return Ok(Some(low.iter().zip(&high).map(|(a, b)| f64::midpoint(*a, *b)).collect()));
        }
        let axis = widest(&part, &low, &high);
        let (first, second) = split(&part, axis, &0.5)?;
        let middle = f64::midpoint(low[axis], high[axis]);
        let (mut upper, mut lower) = (high.clone(), low.clone());
        upper[axis] = middle;
        lower[axis] = middle;
        parts.push((first, low, upper, depth + 1));
        parts.push((second, lower, high, depth + 1));
    }
    Ok(None)
}

/// The corner with the smallest value, if that is not above `noise`.
fn worst_corner(
    part: &Form,
    values: &[f64],
    low: &[f64],
    high: &[f64],
    noise: f64,
) -> Option<Vec<f64>> {
    let corners = (0..1_usize << part.axes()).map(|bits| {
        let far = |axis: usize| bits >> axis & 1 == 1;
        let flat =
            part.orders().iter().enumerate().fold(0, |flat, (axis, order)| {
                flat * order + if far(axis) { order - 1 } else { 0 }
            });
        let at = (0..part.axes()).map(|axis| if far(axis) { high[axis] } else { low[axis] });
        (values[flat], at.collect::<Vec<f64>>())
    });
    let worst = corners.min_by(|a, b| a.0.total_cmp(&b.0))?;
    (worst.0 <= noise).then_some(worst.1)
}

fn widest(part: &Form, low: &[f64], high: &[f64]) -> usize {
    let width =
        |axis: &usize| if part.orders()[*axis] > 1 { high[*axis] - low[*axis] } else { 0.0 };
    (0..part.axes()).max_by(|a, b| width(a).total_cmp(&width(b))).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dip_below_zero_is_found() {
        // (t − 1/3)² + c
        let dip = |c: f64| {
            let values = [1.0 / 9.0 + c, -2.0 / 9.0 + c, 4.0 / 9.0 + c];
            Form::from_points(&[3], 1, &values, None).unwrap()
        };
        assert_eq!(refuted(&dip(1e-3), 0.0, 14).unwrap(), None);
        let place = refuted(&dip(-1e-3), 0.0, 14).unwrap().unwrap();
        assert!((place[0] - 1.0 / 3.0).abs() < 0.04);
    }
}
