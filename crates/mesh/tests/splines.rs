//! Splines: one line, patches without cracks, the faces of volumes.
#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use common::is_watertight;
use pforms_kernel::Form;
use pforms_mesh::{Sampling, chain, patches, surfaces};
use pforms_operators::Spline;

/// A closed tube of degree 3 round the z axis, its poles wavy: periodic knots in both directions.
fn torus() -> Spline {
    let (rows, columns, degree) = (9, 7, 3);
    let mut points = Vec::new();
    for i in 0..rows + degree {
        for j in 0..columns + degree {
            let turn = |k: usize, n: usize| (k % n) as f64 / n as f64 * std::f64::consts::TAU;
            let (u, v) = (turn(i, rows), turn(j, columns));
            let radius = 3.0 + v.cos() * (1.0 + 0.2 * (3.0 * u).sin());
            points.extend([radius * u.cos(), radius * u.sin(), v.sin()]);
        }
    }
    let net = Form::from_points(&[rows + degree, columns + degree], 3, &points, None).unwrap();
    let knots = |n: usize| (0..=n + 2 * degree).map(|k| k as f64).collect();
    Spline::new(net, &[degree, degree], vec![knots(rows), knots(columns)]).unwrap()
}

#[test]
fn a_closed_spline_has_no_cracks_at_any_tolerance() {
    let pieces = patches(&torus()).unwrap();
    assert_eq!(pieces.len(), 63);
    let uneven = Sampling::Fineness(vec![2, 3]);
    for sampling in [Sampling::Tolerance(0.1), Sampling::Tolerance(0.003), uneven] {
        let meshes = surfaces(&pieces, &sampling).unwrap();
        assert!(is_watertight(&meshes), "{sampling:?}");
    }
}

#[test]
fn a_curve_is_one_line_as_far_as_it_goes_on() {
    let net = Form::from_points(&[5], 2, &[0., 0., 1., 2., 3., 2., 4., 0., 6., 1.], None).unwrap();
    let knots = vec![vec![0.0, 0.0, 0.0, 1.0, 3.0, 4.0, 4.0, 4.0]];
    let spline = Spline::new(net.clone(), &[2], knots).unwrap();
    let line = chain(&spline, &Sampling::Segments(vec![4])).unwrap();
    assert_eq!(line.polylines.len(), 1);
    assert_eq!(line.polylines[0].points.len(), 3 * 4 + 1);
    assert_eq!(line.polylines[0].parameters[..9], [0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0]);
    let parted = vec![vec![0.0, 0.0, 1.0, 1.0, 2.0, 3.0, 3.0]];
    let broken = Spline::new(net, &[1], parted).unwrap();
    let lines = chain(&broken, &Sampling::Segments(vec![1])).unwrap().polylines;
    assert_eq!(lines.iter().map(|line| line.points.len()).collect::<Vec<_>>(), [2, 3]);
}

#[test]
fn a_volume_in_pieces_is_closed_by_its_outer_faces() {
    let mut points = Vec::new();
    for k in 0..27_i32 {
        let (i, j, l) = (f64::from(k / 9), f64::from(k / 3 % 3), f64::from(k % 3));
        points.extend([i + 0.3 * j * l, j + 0.2 * i, l - 0.1 * i * j]);
    }
    let net = Form::from_points(&[3, 3, 3], 3, &points, None).unwrap();
    let knots = |middle: f64| vec![0.0, 0.0, middle, 2.0, 2.0];
    let volume = Spline::new(net, &[1, 1, 1], vec![knots(1.0), knots(0.5), knots(1.5)]).unwrap();
    let faces = patches(&volume).unwrap();
    assert_eq!(faces.len(), 24);
    let meshes = surfaces(&faces, &Sampling::Tolerance(0.01)).unwrap();
    assert!(is_watertight(&meshes));
    let curve: Spline = Form::from_points(&[2], 1, &[0., 1.], None).unwrap().into();
    assert_eq!(patches(&curve).unwrap_err().family(), "Shape");
}
