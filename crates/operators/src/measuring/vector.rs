//! Little vectors.

pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

pub(crate) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

pub(crate) fn scaled(a: &[f64], factor: f64) -> Vec<f64> {
    a.iter().map(|x| x * factor).collect()
}

pub(crate) fn unit(a: &[f64]) -> Vec<f64> {
    let length = norm(a);
    a.iter().map(|x| x / length).collect()
}

/// `a + factor·b`.
pub(crate) fn plus(a: &[f64], factor: f64, b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(x, y)| x + factor * y).collect()
}

/// The cross product of two vectors of dimension 3.
pub(crate) fn cross(a: &[f64], b: &[f64]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// A unit vector across the tangent: from the coordinate axis it leans on least.
pub(crate) fn any_normal(tangent: &[f64]) -> Vec<f64> {
    let least = (0..tangent.len())
        .min_by(|&i, &j| tangent[i].abs().total_cmp(&tangent[j].abs()))
        .unwrap_or(0);
    let mut axis = vec![0.0; tangent.len()];
    axis[least] = 1.0;
    unit(&plus(&axis, -dot(&axis, tangent), tangent))
}
