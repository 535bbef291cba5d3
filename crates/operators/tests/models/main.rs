//! Models of other programs: read, made into splines, measured, taken apart and put together again.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod bembel;
mod ffd;
mod geomdl;
mod gismo;
mod iges;
mod immersed;
mod inverted;
mod json;
mod laws;
mod lengths;
mod made;
mod measure;
mod mfem;
mod parallels;
mod peers;
mod proved;

use pforms_operators::Spline;
use pforms_testkit::models::Patch;

/// The spline that a patch describes.
fn spline(patch: &Patch) -> Spline {
    Spline::new(patch.net.clone(), &patch.degrees, patch.knots.clone())
        .unwrap_or_else(|error| panic!("{}: {error}", patch.name))
}

/// The largest difference of two lists of numbers.
fn gap(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len(), "{a:?} {b:?}");
    a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

/// The parameters at the given fractions of the windows.
fn at_fractions(spline: &Spline, fractions: &[f64]) -> Vec<f64> {
    let at = |(axis, share): (usize, &f64)| {
        let (from, to) = spline.window(axis).unwrap();
        from + share * (to - from)
    };
    fractions.iter().enumerate().map(at).collect()
}

/// The largest absolute coordinate of the poles, at least 1.
fn scale(spline: &Spline) -> f64 {
    pole_box(spline).concat().into_iter().fold(1.0, |most: f64, x| most.max(x.abs()))
}

/// The least box around the euclidean poles: the lower corner, the upper corner.
fn pole_box(spline: &Spline) -> [Vec<f64>; 2] {
    let points = spline.net().points().unwrap();
    let along = |pick: fn(f64, f64) -> f64| {
        let corner = |k: usize| points.iter().skip(k).step_by(spline.ambient()).copied();
        (0..spline.ambient()).map(|k| corner(k).reduce(pick).unwrap()).collect()
    };
    [along(f64::min), along(f64::max)]
}
