//! Shapes that the tests of frames know everything about.
#![allow(dead_code, clippy::unwrap_used)]

use pforms_kernel::{Form, Result};

/// A quarter of a circle as `(x·w, y·w, w)`.
pub(crate) fn quarter() -> [[f64; 3]; 3] {
    let s = 0.5_f64.sqrt();
    [[1.0, 0.0, 1.0], [s, s, s], [0.0, 1.0, 1.0]]
}

/// The surface of revolution of a profile `(radius·w, height·w, w)`, a quarter turn; axis 0 along
/// the profile.
pub(crate) fn revolved(profile: &[[f64; 3]]) -> Form {
    let poles = profile
        .iter()
        .flat_map(|p| {
            quarter().into_iter().flat_map(|s| [s[0] * p[0], s[1] * p[0], s[2] * p[1], s[2] * p[2]])
        })
        .collect();
    Form::from_homogeneous(&[profile.len(), 3], 3, poles).unwrap()
}

/// An octant of a sphere around the origin: edge `u = 1` is the pole `(0, 0, r)`.
pub(crate) fn octant(radius: f64) -> Form {
    revolved(&quarter().map(|[x, y, w]| [radius * x, radius * y, w]))
}

/// A patch of a torus: tube radius `r` around a circle of radius `big`, its outer upper quarter.
pub(crate) fn torus(big: f64, r: f64) -> Form {
    revolved(&quarter().map(|[x, y, w]| [big * w + r * x, r * y, w]))
}

/// The form moved by a vector.
pub(crate) fn moved(form: &Form, by: [f64; 3]) -> Form {
    let mut poles = form.homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(4) {
        for k in 0..3 {
            pole[k] += by[k] * pole[3];
        }
    }
    Form::from_homogeneous(form.orders(), 3, poles).unwrap()
}

pub(crate) fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}

pub(crate) fn family<T: std::fmt::Debug>(result: Result<T>) -> &'static str {
    result.unwrap_err().family()
}
