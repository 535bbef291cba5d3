//! Volumes: envelopes, leaves, fibres; and nets.
#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use common::is_watertight;
use pforms_kernel::Form;
use pforms_mesh::{Sampling, Triangles, envelope, fibres, leaves, net, normals, poles, surfaces};
use pforms_operators::{Poles, Shape};

/// A box of sides 1, 2, 3 with `orders` poles along its axes, its last axis reversed if `mirrored`.
fn cuboid(orders: [usize; 3], mirrored: bool) -> Form {
    let mut points = Vec::new();
    for i in 0..orders[0] {
        for j in 0..orders[1] {
            for k in 0..orders[2] {
                let z = 3.0 * k as f64 / (orders[2] - 1) as f64;
                points.push(i as f64 / (orders[0] - 1) as f64);
                points.push(2.0 * j as f64 / (orders[1] - 1) as f64);
                points.push(if mirrored { 3.0 - z } else { z });
            }
        }
    }
    Form::from_points(&orders, 3, &points, None).unwrap()
}

fn joined(meshes: &[Triangles]) -> Triangles {
    let mut all = Triangles::default();
    for mesh in meshes {
        all.append(mesh);
    }
    all
}

#[test]
fn the_envelope_faces_outwards_either_way_round() {
    for mirrored in [false, true] {
        let faces = envelope(&cuboid([2, 3, 4], mirrored)).unwrap();
        let meshes = surfaces(&faces, &Sampling::Fineness(vec![2])).unwrap();
        assert!(is_watertight(&meshes));
        assert!((joined(&meshes).volume() - 6.0).abs() < 1e-12);
    }
}

#[test]
fn a_bent_envelope_is_watertight_within_a_tolerance() {
    let mut form = cuboid([3, 2, 4], false);
    form = form.with_pole(&[1, 1, 2], &[4.0, 5.0, 2.0, 1.0]).unwrap();
    form = form.with_pole(&[0, 0, 1], &[-2.0, 0.5, 1.0, 1.0]).unwrap();
    let meshes = surfaces(&envelope(&form).unwrap(), &Sampling::Tolerance(0.01)).unwrap();
    assert!(is_watertight(&meshes));
    let fine = surfaces(&envelope(&form).unwrap(), &Sampling::Tolerance(0.002)).unwrap();
    assert!((joined(&meshes).volume() - joined(&fine).volume()).abs() < 0.1);
}

#[test]
fn leaves_and_fibres_are_sub_forms() {
    let form = cuboid([2, 3, 4], false);
    let sections = leaves(&form.clone().into(), 2, 4).unwrap();
    let stack: Vec<Form> = sections.iter().map(|sheet| sheet.net().clone()).collect();
    assert_eq!(stack.len(), 4);
    assert_eq!(stack[0].orders(), [2, 3]);
    assert_eq!(stack[3].at(&[0.5, 0.5]).unwrap(), [0.5, 1.0, 3.0]);
    let form: Shape = form.into();
    let bundle = fibres(&form, 0, 3).unwrap();
    let bundle: Vec<Form> = bundle.iter().map(|fibre| fibre.net().clone()).collect();
    assert_eq!(bundle.len(), 9);
    assert!(bundle.iter().all(|fibre| fibre.orders() == [2]));
    let last = bundle[8].at(&[1.0]).unwrap();
    assert_eq!(last, [1.0, 2.0, 3.0]);
    assert_eq!(leaves(&form, 3, 4).unwrap_err().family(), "Shape");
    assert_eq!(leaves(&form, 0, 0).unwrap_err().family(), "Domain");
    assert_eq!(fibres(&form, 0, 1 << 17).unwrap_err().family(), "Domain");
    assert_eq!(envelope(&stack[0]).unwrap_err().family(), "Shape");
}

#[test]
fn the_net_joins_neighbours_and_stops_at_infinity() {
    let lines = net(&cuboid([2, 3, 4], false)).unwrap();
    assert_eq!(lines.len(), 3 * 4 + 2 * 4 + 2 * 3);
    let arc = vec![1., 0., 1., 0., 1., 0., -1., 0., 1., -2., 0., 1.];
    let form = Form::from_homogeneous(&[4], 2, arc).unwrap();
    assert_eq!(net(&form).unwrap()[0].points, [[-1.0, 0.0, 0.0], [-2.0, 0.0, 0.0]]);
    assert_eq!(poles(&form).unwrap().len(), 3);
}

#[test]
fn normals_are_lines_of_the_asked_length() {
    let facet = leaves(&cuboid([2, 2, 2], false).into(), 2, 2).unwrap()[0].net().clone();
    let facet = &facet;
    let lines = normals(facet, &Sampling::Fineness(vec![1]), 0.5).unwrap();
    assert_eq!(lines.len(), 9);
    assert_eq!(lines[0].points, [[0.0, 0.0, 0.0], [0.0, 0.0, 0.5]]);
}
