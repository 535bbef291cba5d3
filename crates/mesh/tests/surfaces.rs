//! Surfaces against closed forms, and against themselves sampled densely.
#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use common::{edge_counts, is_watertight, to_mesh};
use pforms_kernel::{Error, Form};
use pforms_mesh::vector::{dot, norm};
use pforms_mesh::{Sampling, Triangles, surface, surfaces};
use pforms_testkit::{Random, Weights, octant, whole_sphere};
use proptest::prelude::*;
use std::f64::consts::PI;

fn total(meshes: &[Triangles], measure: fn(&Triangles) -> f64) -> f64 {
    meshes.iter().map(measure).sum()
}

#[test]
fn octant_lies_on_the_sphere_with_its_exact_normals() {
    for sampling in [Sampling::Fineness(vec![5]), Sampling::Tolerance(1e-4)] {
        let mesh = surface(&octant([1.0; 3]), &sampling).unwrap();
        for (point, normal) in mesh.positions.iter().zip(&mesh.normals) {
            assert!((norm(*point) - 1.0).abs() < 1e-15);
            assert!((dot(*point, *normal).abs() - 1.0).abs() < 1e-14, "at {point:?}: {normal:?}");
        }
        assert!((mesh.area() - PI / 2.0).abs() < 2e-3);
    }
}

#[test]
fn normals_at_the_collapsed_edge_are_the_limit() {
    let mesh = surface(&octant([1.0; 3]), &Sampling::Fineness(vec![3])).unwrap();
    let pole = mesh.positions.iter().zip(&mesh.normals).filter(|(p, _)| **p == [0.0, 0.0, 1.0]);
    let normals: Vec<_> = pole.map(|(_, normal)| *normal).collect();
    assert_eq!(normals.len(), 9);
    assert!(normals.iter().all(|n| (n[2].abs() - 1.0).abs() < 1e-14));
}

#[test]
fn a_cone_keeps_one_normal_for_each_of_its_lines() {
    // Straight lines from a quarter circle to the apex (0, 0, 1).
    let w = 0.5_f64.sqrt();
    let points = [1., 0., 0., 1., 1., 0., 0., 1., 0., 0., 0., 1., 0., 0., 1., 0., 0., 1.];
    let cone = Form::from_points(&[2, 3], 3, &points, Some(&[1., w, 1., 1., w, 1.])).unwrap();
    let mesh = surface(&cone, &Sampling::Fineness(vec![0, 4])).unwrap();
    for k in 0..17 {
        let (base, apex) = (mesh.normals[k], mesh.normals[17 + k]);
        assert!((dot(base, apex) - 1.0).abs() < 1e-14, "{base:?} against {apex:?}");
    }
    assert_eq!(mesh.indices.len(), 16, "the other half has no area");
}

#[test]
fn eight_octants_are_a_watertight_ball() {
    let meshes = surfaces(&whole_sphere(), &Sampling::Tolerance(1e-3)).unwrap();
    assert!(is_watertight(&meshes));
    assert!((total(&meshes, Triangles::area) - 4.0 * PI).abs() < 0.02);
}

#[test]
fn neighbours_of_different_fineness_meet_without_cracks() {
    // A flat patch beside a steep one that shares its edge, run the other way.
    let flat: Vec<f64> = (0..2)
        .flat_map(|i| {
            (0..3).flat_map(move |j| [f64::from(i), f64::from(j), if j == 1 { 1.0 } else { 0.0 }])
        })
        .collect();
    let steep: Vec<f64> = (0..3)
        .flat_map(|i| {
            (0..3).rev().flat_map(move |j| {
                let bump = if i == 1 { 40.0 } else { 0.0 };
                [1.0 + f64::from(i), f64::from(j), if j == 1 { 1.0 } else { 0.0 } + bump]
            })
        })
        .collect();
    let forms = [
        Form::from_points(&[2, 3], 3, &flat, None).unwrap(),
        Form::from_points(&[3, 3], 3, &steep, None).unwrap(),
    ];
    let meshes = surfaces(&forms, &Sampling::Tolerance(0.01)).unwrap();
    let alone = surface(&forms[0], &Sampling::Tolerance(0.01)).unwrap();
    assert_ne!(meshes[0].indices.len(), alone.indices.len(), "the edge was refined");
    let open = edge_counts(&meshes).into_iter().filter(|(_, count)| *count == 1);
    for ([a, b], _) in open {
        let both = |x: f64| [a, b].iter().all(|p| f64::from_bits(p[0]) == x);
        assert!(!both(1.0), "a crack along the common edge");
    }
    assert!((total(&meshes[..1], Triangles::area) - alone.area()).abs() < 0.02 * alone.area());
    for (mesh, expected) in meshes.iter().zip([alone.normals[0], meshes[1].normals[0]]) {
        let turned = (0..mesh.indices.len()).filter(|&k| {
            let normal = mesh.normals[mesh.indices[k][0] as usize];
            dot(mesh.facet(k), normal) <= 0.0
        });
        assert_eq!(turned.count(), 0, "every facet faces its normals, {expected:?}");
    }
}

#[test]
fn size_changes_no_triangle() {
    let sphere = whole_sphere();
    let meshes = surfaces(&sphere, &Sampling::Tolerance(0.01)).unwrap();
    for unit in [2.0_f64.powi(-400), 2.0_f64.powi(400)] {
        let scaled = sphere.iter().map(|form| {
            let poles = form.homogeneous().chunks(4);
            let poles = poles.flat_map(|p| [p[0] * unit, p[1] * unit, p[2] * unit, p[3]]);
            Form::from_homogeneous(form.orders(), 3, poles.collect()).unwrap()
        });
        let scaled: Vec<Form> = scaled.collect();
        let other = surfaces(&scaled, &Sampling::Tolerance(0.01 * unit)).unwrap();
        for (mesh, other) in meshes.iter().zip(&other) {
            assert_eq!(mesh.indices, other.indices);
            assert_eq!(
                mesh.positions.concat(),
                other.positions.concat().iter().map(|x| x / unit).collect::<Vec<_>>()
            );
        }
    }
}

#[test]
fn a_plane_takes_two_triangles_however_it_is_parametrised() {
    // Along a straight line at uneven speed, and in other places across it.
    let rows = [[0., 0.], [0.4, 0.], [1.0, 0.]].map(|[x, _]| [[x, 0., 0.], [x, 1., 0.]].concat());
    let form = Form::from_points(&[3, 2], 3, &rows.concat(), None).unwrap();
    assert_eq!(surface(&form, &Sampling::Tolerance(1e-6)).unwrap().indices.len(), 2);
}

#[test]
fn segments_are_counted_and_none_is_dropped() {
    let mesh = surface(&octant([1.0; 3]), &Sampling::Segments(vec![3, 5])).unwrap();
    assert_eq!((mesh.positions.len(), mesh.indices.len()), (24, 30));
    let refuse = |counts| surface(&octant([1.0; 3]), &Sampling::Segments(counts)).unwrap_err();
    assert_eq!(refuse(vec![0]).family(), "Domain");
    assert_eq!(refuse(vec![1, 2, 3]).family(), "Shape");
    assert_eq!(refuse(vec![usize::MAX]).family(), "Limit");
}

#[test]
fn flat_shading_gives_each_facet_its_own_normal() {
    let smooth = surface(&octant([1.0; 3]), &Sampling::Fineness(vec![2])).unwrap();
    let flat = smooth.flat();
    assert_eq!(flat.positions.len(), 3 * smooth.indices.len());
    assert!(flat.normals.chunks(3).all(|n| n[0] == n[1] && (norm(n[0]) - 1.0).abs() < 1e-15));
}

#[test]
fn a_weight_that_vanishes_inside_is_named() {
    let weights = [1.0, 1.0, -1.0, -1.0];
    let points = [0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 0.];
    let form = Form::from_points(&[2, 2], 3, &points, Some(&weights)).unwrap();
    for sampling in [Sampling::Fineness(vec![1]), Sampling::Tolerance(0.1)] {
        let error = surface(&form, &sampling).unwrap_err();
        assert!(matches!(error, Error::Domain(_)));
        assert!(error.to_string().contains("0.5"), "{error}");
    }
}

#[test]
fn poles_at_infinity_are_welcome_where_the_form_is_finite() {
    // A half cylinder: the middle pole of its arc is a direction.
    let arc = |z: f64| [[1., 0., z, 1.], [0., 1., 0., 0.], [-1., 0., z, 1.]].concat();
    let form = Form::from_homogeneous(&[2, 3], 3, [arc(0.0), arc(2.0)].concat()).unwrap();
    let mesh = surface(&form, &Sampling::Tolerance(1e-4)).unwrap();
    assert!((mesh.area() - 2.0 * PI).abs() < 1e-3);
    assert!(mesh.positions.iter().all(|p| (p[0].hypot(p[1]) - 1.0).abs() < 1e-14));
}

#[test]
fn a_surface_that_is_a_line_or_a_point_has_normals_all_the_same() {
    for points in [[1.0; 12].to_vec(), (0..4).flat_map(|k| [f64::from(k), 0., 0.]).collect()] {
        let form = Form::from_points(&[2, 2], 3, &points, None).unwrap();
        let mesh = surface(&form, &Sampling::Fineness(vec![2])).unwrap();
        assert!(mesh.normals.iter().all(|n| (norm(*n) - 1.0).abs() < 1e-12));
        assert!(surface(&form, &Sampling::Tolerance(1e-3)).unwrap().area() == 0.0);
    }
    // From a point to a point along a line.
    let spindle = [0., 0., 0., 0., 0., 0., 1., 0., 0., 1., 0., 0.];
    let form = Form::from_points(&[2, 2], 3, &spindle, None).unwrap();
    assert!(surface(&form, &Sampling::Tolerance(1e-3)).unwrap().area() == 0.0);
}

#[test]
fn absurd_wishes_are_refused() {
    let form = octant([1.0; 3]);
    let refuse = |sampling: Sampling| surface(&form, &sampling).unwrap_err().family();
    assert_eq!(refuse(Sampling::Fineness(vec![25])), "Domain");
    assert_eq!(refuse(Sampling::Fineness(vec![20])), "Limit");
    assert_eq!(refuse(Sampling::Fineness(vec![1, 2, 3])), "Shape");
    assert_eq!(refuse(Sampling::Fineness(vec![])), "Shape");
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(refuse(Sampling::Tolerance(tolerance)), "Domain");
    }
    assert_eq!(refuse(Sampling::Tolerance(1e-300)), "Limit");
    let curve = Form::point(&[1.0]).unwrap();
    assert_eq!(surface(&curve, &Sampling::default()).unwrap_err().family(), "Shape");
}

#[test]
fn other_dimensions_are_embedded_or_projected() {
    let plane = Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 1., 0., 1., 1.], None).unwrap();
    let mesh = surface(&plane, &Sampling::Fineness(vec![1])).unwrap();
    assert!(mesh.positions.iter().all(|p| p[2] == 0.0));
    let points: Vec<f64> = (0..20).map(f64::from).collect();
    let high = Form::from_points(&[2, 2], 5, &points, None).unwrap();
    let mesh = surface(&high, &Sampling::Fineness(vec![0])).unwrap();
    assert_eq!(mesh.positions[1], [5.0, 6.0, 7.0]);
}

fn rational_patch() -> impl Strategy<Value = Form> {
    (2usize..5, 2usize..5).prop_flat_map(|(m, n)| {
        let points = prop::collection::vec(-1.0..1.0, m * n * 3);
        let weights = prop::collection::vec(0.3..3.0, m * n);
        (points, weights).prop_map(move |(points, weights)| {
            Form::from_points(&[m, n], 3, &points, Some(&weights)).unwrap()
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_tolerance_is_kept(form in rational_patch(), tolerance in 0.02..0.3) {
        let mesh = surface(&form, &Sampling::Tolerance(tolerance)).unwrap();
        for i in 0..=14 {
            for j in 0..=14 {
                let point = form.at(&[f64::from(i) / 14.0, f64::from(j) / 14.0]).unwrap();
                let distance = to_mesh([point[0], point[1], point[2]], &mesh);
                prop_assert!(distance <= tolerance, "{distance} at {i}, {j}");
            }
        }
    }

    #[test]
    fn normals_agree_with_the_derivatives(form in rational_patch()) {
        let mesh = surface(&form, &Sampling::Fineness(vec![2])).unwrap();
        for (k, normal) in mesh.normals.iter().enumerate() {
            let at = [(k / 5) as f64 / 4.0, (k % 5) as f64 / 4.0];
            for orders in [[1, 0], [0, 1]] {
                let d = form.derivative_at(&at, &orders).unwrap();
                let d = [d[0], d[1], d[2]];
                prop_assert!(dot(d, *normal).abs() <= 1e-9 * norm(d).max(1e-3));
            }
        }
    }
}

#[test]
fn thin_and_wild_nets_have_meshes_too() {
    let mut random = Random::new(5);
    for round in 0..10 {
        let weights = if round % 2 == 0 { Weights::One } else { Weights::Positive };
        let patch = random.rough_form(&[2, 5], 3, weights);
        let mesh = surface(&patch, &Sampling::Tolerance(1e-2)).unwrap();
        assert!(!mesh.indices.is_empty());
        assert!(mesh.normals.iter().flatten().all(|x| x.is_finite()));
    }
    let steep = random.rough_form(&[4, 4], 3, Weights::One);
    assert!(surface(&steep, &Sampling::Tolerance(1e-3)).is_ok());
    // A line has no normals but those of triangles that rounding has made.
    let line = random.rough_form(&[1, 4], 3, Weights::One);
    match surface(&line, &Sampling::Tolerance(0.1)) {
        Ok(mesh) => assert!(mesh.normals.iter().flatten().all(|x| x.is_finite())),
        Err(error) => assert!(["Degenerate", "Limit"].contains(&error.family())),
    }
}
