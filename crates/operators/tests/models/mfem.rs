//! NURBS meshes of MFEM: measures as MFEM itself integrates them, closed forms, shared borders.

use std::f64::consts::PI;

use pforms_operators::Spline;
use pforms_testkit::models::{document, mfem, text};

use crate::measure::{measure, total};
use crate::{at_fractions, gap, laws, scale, spline};

fn splines(file: &str) -> Vec<Spline> {
    mfem::read(&text(&format!("mfem/{file}"))).iter().map(spline).collect()
}

fn models() -> Vec<serde_json::Value> {
    let expected = document("mfem/expected.json");
    let list = expected["models"].as_array().unwrap();
    assert_eq!(list.len(), 19);
    list.clone()
}

#[test]
fn measures_are_those_mfem_integrates() {
    for model in models() {
        let file = model["file"].as_str().unwrap();
        let splines = splines(file);
        for spline in &splines {
            assert_eq!(spline.axes() as u64, model["dimension"], "{file}");
            assert_eq!(spline.ambient() as u64, model["space_dimension"], "{file}");
        }
        let pieces: usize =
            splines.iter().map(|spline| spline.counts().iter().product::<usize>()).sum();
        assert_eq!(pieces as u64, model["elements"], "{file}");
        // The rule of order 40 has 21 nodes; its own sum carries some hundred roundings.
        let sum = total(&splines, 21);
        let value = model["measure"].as_f64().unwrap();
        let uncertain = model["measure_uncertainty"].as_f64().unwrap();
        assert!((sum - value).abs() <= uncertain + 2e-14 * value, "{file}: {sum} {value}");
    }
}

#[test]
fn closed_forms() {
    for (file, value, bound) in [
        ("ball-nurbs.mesh", 4.0 * PI / 3.0, 2e-13),
        ("disc-nurbs.mesh", 8.0 * PI, 1e-14),
        ("pipe-nurbs-2d.mesh", 0.75 * PI, 1e-14),
        ("cube-nurbs.mesh", 1.0, 1e-14),
        ("beam-hex-nurbs.mesh", 8.0, 1e-14),
        ("nc-nurbs3d.mesh", 16.0, 1e-14),
        ("square-nurbs-pw.mesh", 1.0, 1e-14),
        // Nine digits in the file.
        ("square-disc-nurbs.mesh", 1.0 - PI / 25.0, 1e-9),
    ] {
        let sum = total(&splines(file), 21);
        assert!((sum - value).abs() <= bound * value, "{file}: {sum} {value}");
    }
}

/// The poles of the patches would be in disorder if the numbering were misread, and patches folded.
#[test]
fn no_patch_is_folded() {
    for model in models() {
        let file = model["file"].as_str().unwrap();
        if model["dimension"] != model["space_dimension"] {
            continue;
        }
        for spline in splines(file) {
            let whole = measure(&spline, 21);
            assert!(
                (whole.signed.abs() - whole.size).abs() <= 1e-12 * whole.size,
                "{file}: {whole:?}"
            );
        }
    }
}

/// Every border of the six outer patches of the ball that is on the sphere stays on it.
#[test]
fn the_ball_ends_on_the_unit_sphere() {
    let steps = [0.0, 0.13, 0.5, 0.77, 1.0];
    let mut faces = 0;
    for spline in splines("ball-nurbs.mesh") {
        for axis in 0..3 {
            for end in [0.0, 1.0] {
                let border = spline.sub(axis, &end).unwrap();
                let points = border.grid(&[&steps, &steps]).unwrap();
                let radii = points.as_chunks::<3>().0.iter().map(|[x, y, z]| x.hypot(*y).hypot(*z));
                let far = radii.map(|r| (r - 1.0).abs()).fold(0.0, f64::max);
                // Coordinates and weights in the file have 13 or 14 digits.
                faces += usize::from(far <= 1e-13);
            }
        }
    }
    assert_eq!(faces, 6);
}

/// Numbered once for all: neighbours have the same points on their common border.
#[test]
fn neighbours_meet() {
    for (file, joints) in [("ball-nurbs.mesh", 18), ("disc-nurbs.mesh", 8), ("pipe-nurbs.mesh", 4)]
    {
        let borders: Vec<Vec<Vec<f64>>> = splines(file).iter().flat_map(borders).collect();
        let met = |a: &Vec<Vec<f64>>| {
            let found = |p: &Vec<f64>, b: &[Vec<f64>]| b.iter().any(|q| gap(p, q) < 1e-13);
            let meets = |b: &&Vec<Vec<f64>>| a.iter().all(|p| found(p, b));
            borders.iter().filter(meets).count() - 1
        };
        assert_eq!(borders.iter().map(met).sum::<usize>(), 2 * joints, "{file}");
    }
}

/// Points of every border of a patch, symmetric about its middle.
fn borders(spline: &Spline) -> Vec<Vec<Vec<f64>>> {
    let mut all = Vec::new();
    for axis in 0..spline.axes() {
        for end in [0.0, 1.0] {
            let border = spline.sub(axis, &at_fractions(spline, &vec![end; spline.axes()])[axis]);
            let border = border.unwrap();
            let steps = |axis| [0.0, 0.25, 0.5, 0.75, 1.0].map(|t| fraction(&border, axis, t));
            let lists: Vec<[f64; 5]> = (0..border.axes()).map(steps).collect();
            let lists: Vec<&[f64]> = lists.iter().map(<[f64; 5]>::as_slice).collect();
            let points = border.grid(&lists).unwrap();
            all.push(points.chunks(spline.ambient()).map(<[f64]>::to_vec).collect());
        }
    }
    all
}

fn fraction(spline: &Spline, axis: usize, share: f64) -> f64 {
    let (from, to) = spline.window(axis).unwrap();
    from + share * (to - from)
}

/// A mesh of three curves in both writings: weights apart, and multiplied in.
#[test]
fn plain_control_points_are_homogeneous() {
    let (apart, multiplied) =
        (splines("nurbs-segments3d.mesh"), splines("nurbs-segments3d-patches.mesh"));
    assert_eq!(apart[0], multiplied[0]);
    let point = apart[1].net().points().unwrap()[3..6].to_vec();
    let pole = multiplied[1].net().pole(&[1]).unwrap();
    assert_eq!(pole[..3], point);
    assert_eq!(pole[3], apart[1].net().weights()[1]);
}

#[test]
fn laws_hold_on_every_patch() {
    for model in models() {
        let file = model["file"].as_str().unwrap();
        for spline in splines(file) {
            assert!(scale(&spline) > 0.0);
            laws::hold(file, &spline);
        }
    }
}
