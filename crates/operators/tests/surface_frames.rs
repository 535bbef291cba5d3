//! Frames, normals and curvatures of surfaces whose geometry is known.
#![allow(clippy::unwrap_used)]

mod common;

use common::{distance, family, moved, octant, torus};
use pforms_kernel::Form;
use pforms_operators::{
    Curvature, curvature, normal_grid_into, normals_into, surface_frame, volume_frame,
};

const STEPS: [f64; 9] = [0.0, 1e-13, 1e-6, 0.1, 0.3, 0.5, 0.8, 1.0 - 1e-9, 1.0];

#[test]
fn a_sphere_bends_the_same_everywhere() {
    for (radius, centre) in [(1.0, [0.0; 3]), (3.0, [0.0; 3]), (3.0, [5.0, -7.0, 11.0])] {
        let sphere = moved(&octant(radius), centre);
        let gauss = 1.0 / (radius * radius);
        let (mut worst_gauss, mut worst_mean, mut worst_normal) = (0.0_f64, 0.0_f64, 0.0_f64);
        for u in STEPS {
            for v in STEPS {
                let frame = surface_frame(&sphere, u, v).unwrap();
                let bend = frame.curvature.unwrap();
                let outward: Vec<f64> =
                    (0..3).map(|k| (frame.point[k] - centre[k]) / radius).collect();
                worst_normal = worst_normal.max(distance(
                    &frame.normal.unwrap(),
                    &outward.iter().map(|x| -x).collect::<Vec<_>>(),
                ));
                worst_gauss = worst_gauss.max((bend.gauss / gauss - 1.0).abs());
                worst_mean = worst_mean.max((bend.mean * radius - 1.0).abs());
            }
        }
        println!(
            "r={radius} c={centre:?}: gauss {worst_gauss:.1e}, mean {worst_mean:.1e}, normal {worst_normal:.1e}"
        );
        assert!(worst_gauss < 1e-14 && worst_mean < 1e-14 && worst_normal < 1e-15);
    }
}

#[test]
fn normals_in_bulk_agree_with_frames_and_reach_the_pole() {
    for surface in [octant(1.0), moved(&octant(2.0), [1.0, 2.0, -9.0]), torus(3.0, 1.0)] {
        let mut grid = vec![0.0; STEPS.len() * STEPS.len() * 3];
        normal_grid_into(&surface, &[&STEPS, &STEPS], &mut grid).unwrap();
        let us: Vec<f64> = STEPS.iter().flat_map(|u| [*u; 9]).collect();
        let vs: Vec<f64> = STEPS.repeat(STEPS.len());
        let mut scattered = vec![0.0; grid.len()];
        normals_into(&surface, &[&us, &vs], &mut scattered).unwrap();
        assert_eq!(grid, scattered);
        for (i, normal) in grid.chunks_exact(3).enumerate() {
            let frame = surface_frame(&surface, us[i], vs[i]).unwrap();
            assert!(distance(normal, &frame.normal.unwrap()) < 1e-14);
        }
    }
}

#[test]
fn normals_do_not_depend_on_the_size() {
    let unit = octant(1.0);
    let mut expected = [0.0; 4 * 3];
    normal_grid_into(&unit, &[&[0.0, 0.3], &[0.4, 1.0]], &mut expected).unwrap();
    for exponent in [-1000, -500, -300, 300, 500, 1000] {
        let scale = 2.0_f64.powi(exponent);
        let poles = unit.homogeneous().chunks(4);
        let poles = poles.flat_map(|p| [p[0] * scale, p[1] * scale, p[2] * scale, p[3]]).collect();
        let surface: Form = Form::from_homogeneous(unit.orders(), 3, poles).unwrap();
        let mut normals = [0.0; 4 * 3];
        normal_grid_into(&surface, &[&[0.0, 0.3], &[0.4, 1.0]], &mut normals).unwrap();
        assert_eq!(normals, expected, "2^{exponent}");
    }
}

#[test]
fn a_torus_bends_as_its_angle_says() {
    let (big, small) = (3.0, 1.0);
    let surface = torus(big, small);
    for u in [0.0, 0.2, 0.5, 0.9, 1.0] {
        for v in [0.0, 0.37, 1.0] {
            let frame = surface_frame(&surface, u, v).unwrap();
            let bend = frame.curvature.unwrap();
            let away = frame.point[0].hypot(frame.point[1]);
            let cosine = (away - big) / small;
            let along = cosine / away;
            assert!((bend.gauss - along / small).abs() < 1e-14);
            assert!((bend.mean - f64::midpoint(1.0 / small, along)).abs() < 1e-14);
            assert!((bend.principal[0] - 1.0 / small).abs() < 1e-14);
            assert!((bend.principal[1] - along).abs() < 1e-14);
            // The tube bends most around itself: along axis 0.
            let [most, least] = bend.directions.unwrap();
            let cosine = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
            assert!((cosine(&most, &frame.tangents[0]).abs() - 1.0).abs() < 1e-14);
            assert!((cosine(&least, &frame.tangents[1]).abs() - 1.0).abs() < 1e-14);
            assert!(frame.first[1].abs() < 1e-13);
            assert!((frame.area * frame.area - frame.first[0] * frame.first[2]).abs() < 1e-12);
        }
    }
}

#[test]
fn a_cone_has_no_normal_change_along_its_rules_and_an_infinite_tip() {
    // Profile from the tip (0, 0, 1) to (1, 0, 0).
    let cone = common::revolved(&[[0.0, 1.0, 1.0], [1.0, 0.0, 1.0]]);
    for v in [0.0, 0.25, 1.0] {
        let tip = surface_frame(&cone, 0.0, v).unwrap();
        let foot = surface_frame(&cone, 0.7, v).unwrap();
        assert!(distance(&tip.tangents[0], &foot.tangents[0]) < 1e-15);
        assert_eq!(tip.lengths[1], 0.0);
        assert!(tip.curvature.unwrap().mean.is_infinite());
        assert!(foot.curvature.unwrap().gauss.abs() < 1e-15);
    }
    let tip = surface_frame(&cone, 0.0, 0.0).unwrap().normal.unwrap();
    let s = 0.5_f64.sqrt();
    assert!(distance(&tip, &[s, 0.0, s]) < 1e-15);
}

#[test]
fn signs_follow_the_true_point_when_weights_change_sign() {
    // The same plane patch with one negative weight: derivatives of euclidean points decide.
    let weights = [1.0, -0.5, 1.0, 1.0];
    let points = [0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 0.];
    let patch = Form::from_points(&[2, 2], 3, &points, Some(&weights)).unwrap();
    let (u, v, h) = (0.2, 0.3, 1e-7);
    let frame = surface_frame(&patch, u, v).unwrap();
    let here = patch.at(&[u, v]).unwrap();
    let there = patch.at(&[u, v + h]).unwrap();
    let difference: Vec<f64> = there.iter().zip(&here).map(|(a, b)| (a - b) / h).collect();
    assert!((distance(&difference, &[0.0; 3]) / frame.lengths[1] - 1.0).abs() < 1e-5);
    assert!(difference.iter().zip(&frame.tangents[1]).map(|(a, b)| a * b).sum::<f64>() > 0.0);
}

#[test]
fn planes_of_dimension_two_have_area_but_no_normal() {
    let facet: Form =
        Form::from_points(&[2, 2], 2, &[0., 0., 0., 2., 3., 0., 3., 2.], None).unwrap();
    let frame = surface_frame(&facet, 0.5, 0.5).unwrap();
    assert_eq!((frame.area, frame.normal.is_none()), (6.0, true));
    assert_eq!(volume_frame(&facet, &[0.5, 0.5]).unwrap().jacobian, Some(6.0));
}

#[test]
fn scale_by_a_power_of_two_changes_only_exponents() {
    let (large, small) = (octant(2.0_f64.powi(60)), octant(1.0));
    for (u, v) in [(0.3, 0.4), (1.0, 0.2)] {
        let a = surface_frame(&large, u, v).unwrap();
        let b = surface_frame(&small, u, v).unwrap();
        assert_eq!(a.normal, b.normal);
        assert_eq!(a.curvature.unwrap().mean * 2.0_f64.powi(60), b.curvature.unwrap().mean);
    }
}

#[test]
fn refusals() {
    let collapsed: Form = Form::from_points(&[2, 2], 3, &[1.0; 12], None).unwrap();
    assert_eq!(family(surface_frame(&collapsed, 0.5, 0.5)), "Degenerate");
    let line: Form =
        Form::from_points(&[2, 2], 3, &[0., 0., 0., 1., 0., 0., 1., 0., 0., 2., 0., 0.], None)
            .unwrap();
    assert_eq!(family(surface_frame(&line, 0.5, 0.5)), "Degenerate");
    assert_eq!(family(normals_into(&line, &[&[0.5], &[0.5]], &mut [0.0; 3])), "Degenerate");
    assert_eq!(family(surface_frame(&octant(1.0), f64::NAN, 0.5)), "Domain");
    let vanishing: Form =
        Form::from_homogeneous(&[2, 2], 3, [1., 0., 0., 1., 0., 1., 0., -1.].repeat(2)).unwrap();
    assert_eq!(family(surface_frame(&vanishing, 0.5, 0.5)), "Domain");
    assert_eq!(family(curvature(&collapsed, &[0.5])), "Shape");
    let Curvature::Surface(bend) = curvature(&octant(2.0), &[0.5, 0.5]).unwrap() else {
        panic!("a surface")
    };
    assert!((bend.gauss - 0.25).abs() < 1e-15);
}

/// The patches of a `.bpt` file: a count, then for each its degrees and its points.
fn patches(name: &str) -> Vec<Form> {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/models/");
    let text = std::fs::read_to_string(format!("{root}{name}.bpt")).unwrap();
    let mut numbers = text.split_whitespace().map(|word| word.parse::<f64>().unwrap());
    let count = numbers.next().unwrap() as usize;
    (0..count)
        .map(|_| {
            let orders = [0, 1].map(|_| numbers.next().unwrap() as usize + 1);
            let points: Vec<f64> = numbers.by_ref().take(orders[0] * orders[1] * 3).collect();
            Form::from_points(&orders, 3, &points, None).unwrap()
        })
        .collect()
}

#[test]
fn every_point_of_the_tea_set_has_a_normal() {
    let steps = [0.0, 1e-9, 0.25, 0.5, 0.9, 1.0];
    for name in ["newell-teapot32", "newell-teacup26", "newell-teaspoon16"] {
        for (index, patch) in patches(name).iter().enumerate() {
            let mut normals = vec![0.0; 36 * 3];
            let done = normal_grid_into(patch, &[&steps, &steps], &mut normals);
            assert!(done.is_ok(), "{name} {index}: {done:?}");
            // On an edge and next to it: the same to the eye.
            let (edge, near) = (&normals[3..18], &normals[18 + 3..36]);
            assert!(distance(edge, near) < 1e-6, "{name} {index}: {edge:?} {near:?}");
        }
    }
}
