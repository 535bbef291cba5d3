//! Curves, curves through infinity, and tubes about them.
#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use common::{is_watertight, to_segment};
use pforms_kernel::Form;
use pforms_mesh::vector::{dot, norm, subtract};
use pforms_mesh::{Sampling, curve, points, sphere, tube};
use proptest::prelude::*;
use std::f64::consts::PI;

/// The whole unit circle with five poles, two of them directions.
fn circle() -> Form {
    let poles = vec![-1., 0., 1., 0., -1., 0., 1., 0., 1. / 3., 0., 1., 0., -1., 0., 1.];
    Form::from_homogeneous(&[5], 2, poles).unwrap()
}

#[test]
fn a_circle_is_a_circle() {
    let drawn = curve(&circle(), &Sampling::Tolerance(1e-5)).unwrap();
    assert!(drawn.gaps.is_empty());
    let line = &drawn.polylines[0];
    assert!(line.is_closed());
    let length: f64 = line.points.windows(2).map(|p| norm(subtract(p[1], p[0]))).sum();
    assert!((length - 2.0 * PI).abs() < 1e-4, "{length}");
    for (point, tangent) in line.points.iter().zip(&line.tangents) {
        assert!(dot(*point, *tangent).abs() < 1e-14);
        assert!((norm(*tangent) - 1.0).abs() < 1e-14);
    }
}

#[test]
fn a_cusp_has_the_tangent_of_the_way_out() {
    // The semicubical parabola (t², t³), its cusp at the beginning, then at the end.
    let poles = [[0., 0.], [0., 0.], [1. / 3., 0.], [1., 1.]];
    let form = Form::from_points(&[4], 2, &poles.concat(), None).unwrap();
    let line = &curve(&form, &Sampling::Fineness(vec![3])).unwrap().polylines[0];
    assert_eq!(line.tangents[0], [1.0, 0.0, 0.0]);
    let backwards: Vec<f64> = poles.iter().rev().flatten().copied().collect();
    let form = Form::from_points(&[4], 2, &backwards, None).unwrap();
    let line = &curve(&form, &Sampling::Fineness(vec![3])).unwrap().polylines[0];
    assert_eq!(line.tangents.last(), Some(&[-1.0, 0.0, 0.0]));
}

#[test]
fn a_hyperbola_is_cut_at_infinity() {
    // x·y = 1 through both branches: (t − 1/3, 1/(t − 1/3)).
    let a = 1.0 / 3.0;
    let poles = [[a * a, 1.0, -a], [a * a - a, 1.0, 0.5 - a], [(1. - a) * (1. - a), 1.0, 1. - a]];
    let form = Form::from_homogeneous(&[3], 2, poles.concat()).unwrap();
    for sampling in [Sampling::Fineness(vec![5]), Sampling::Tolerance(0.01)] {
        let drawn = curve(&form, &sampling).unwrap();
        assert_eq!(drawn.gaps.len(), 1);
        assert!((drawn.gaps[0] - a).abs() < 1e-9);
        assert_eq!(drawn.polylines.len(), 2);
        for p in drawn.polylines.iter().flat_map(|line| &line.points) {
            assert!((p[0] * p[1] - 1.0).abs() < 1e-9, "{p:?}");
        }
    }
}

#[test]
fn a_ray_ends_before_infinity_and_a_vanishing_curve_is_refused() {
    let ray = Form::from_homogeneous(&[2], 2, vec![0., 0., 1., 1., 1., 0.]).unwrap();
    let drawn = curve(&ray, &Sampling::Fineness(vec![4])).unwrap();
    assert_eq!((drawn.gaps.len(), drawn.polylines.len()), (1, 1));
    assert!(drawn.polylines[0].points.iter().flatten().all(|x| x.is_finite()));
    let nowhere = Form::from_homogeneous(&[2], 1, vec![1., 0., 2., 0.]).unwrap();
    assert_eq!(curve(&nowhere, &Sampling::default()).unwrap_err().family(), "Domain");
}

#[test]
fn a_curve_shrunk_to_a_point_has_no_nan() {
    let form = Form::from_points(&[3], 1, &[2.0; 3], None).unwrap();
    let line = &curve(&form, &Sampling::Fineness(vec![2])).unwrap().polylines[0];
    assert!(line.tangents.iter().all(|t| (norm(*t) - 1.0).abs() < 1e-15));
    assert!(tube(line, 0.1, 8).unwrap().indices.is_empty());
}

#[test]
fn tubes_are_solids_of_the_right_size() {
    let torus =
        tube(&curve(&circle(), &Sampling::Tolerance(1e-5)).unwrap().polylines[0], 0.1, 64).unwrap();
    assert!(is_watertight(std::slice::from_ref(&torus)));
    assert!((torus.volume() - 2.0 * PI * PI * 0.01).abs() < 1e-3, "{}", torus.volume());
    let segment = Form::from_points(&[2], 3, &[0., 0., 0., 1., 2., 2.], None).unwrap();
    let line = &curve(&segment, &Sampling::Fineness(vec![3])).unwrap().polylines[0];
    let cylinder = tube(line, 0.5, 64).unwrap();
    assert!(is_watertight(std::slice::from_ref(&cylinder)));
    assert!((cylinder.volume() - 3.0 * PI * 0.25).abs() < 0.01, "{}", cylinder.volume());
}

#[test]
fn the_rings_of_a_tube_do_not_flip() {
    // An S-curve, whose Frenet frame turns over at the inflection.
    let form = Form::from_points(&[4], 2, &[0., 0., 1., 2., 2., -2., 3., 0.], None).unwrap();
    let line = &curve(&form, &Sampling::Fineness(vec![6])).unwrap().polylines[0];
    let mesh = tube(line, 0.1, 8).unwrap();
    for ring in 0..64 {
        let turn = dot(mesh.normals[ring * 8], mesh.normals[(ring + 1) * 8]);
        assert!(turn > 0.9, "{turn} at ring {ring}");
    }
}

#[test]
fn spheres_are_closed_and_round() {
    let mesh = sphere([1.0, 2.0, 3.0], 0.5, 4).unwrap();
    assert!(is_watertight(std::slice::from_ref(&mesh)));
    assert!((mesh.volume() - PI / 6.0).abs() < 0.01);
    assert_eq!(sphere([0.0; 3], -1.0, 2).unwrap_err().family(), "Domain");
    assert_eq!(sphere([0.0; 3], 1.0, 9).unwrap_err().family(), "Domain");
}

#[test]
fn a_hypercube_is_a_cloud() {
    let corners: Vec<f64> =
        (0..16).flat_map(|k| [0, 1, 2, 3].map(|bit| f64::from(k >> (3 - bit) & 1))).collect();
    let form = Form::from_points(&[2, 2, 2, 2], 4, &corners, None).unwrap();
    let cloud = points(&form, &Sampling::Fineness(vec![2, 3, 3, 3])).unwrap();
    assert_eq!(cloud.len(), 5 * 9 * 9 * 9);
    assert_eq!(cloud[9 * 9 * 9], [0.25, 0.0, 0.0]);
    let single = points(&Form::point(&[1.0, 2.0]).unwrap(), &Sampling::default()).unwrap();
    assert_eq!(single, [[1.0, 2.0, 0.0]]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_tolerance_is_kept(
        points in prop::collection::vec(-1.0..1.0, 15),
        weights in prop::collection::vec(0.2..5.0, 5),
        tolerance in 1e-4..0.2,
    ) {
        let form = Form::from_points(&[5], 3, &points, Some(&weights)).unwrap();
        let line = &curve(&form, &Sampling::Tolerance(tolerance)).unwrap().polylines[0];
        for i in 0..=200 {
            let at = form.at(&[f64::from(i) / 200.0]).unwrap();
            let at = [at[0], at[1], at[2]];
            let distances = line.points.windows(2).map(|p| to_segment(at, p[0], p[1]));
            prop_assert!(distances.fold(f64::INFINITY, f64::min) <= tolerance);
        }
    }
}
