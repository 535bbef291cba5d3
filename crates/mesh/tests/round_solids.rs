//! Round solids in every way they may be given: whole turns, seams, collapsed sides, splines.
#![allow(missing_docs, clippy::unwrap_used)]

use std::f64::consts::PI;

use pforms_kernel::Form;
use pforms_mesh::{Operation, Part as Surface, Solid, combine, solid};
use pforms_operators::{
    Axis, Part, Poles, Shape, circle, extrude_shapes, path_of, revolve, revolve_whole,
    ruled_shapes, sphere, torus,
};

/// The shape shrunk to its centre: all its poles there, with the same weights.
fn shrunk(shape: &Shape) -> Shape {
    let net = shape.net();
    let zeros = |pole: &[f64]| [0.0, 0.0, 0.0, pole[3]];
    let poles = net.homogeneous().chunks(4).flat_map(zeros).collect();
    shape.with_net(Form::from_homogeneous(net.orders(), 3, poles).unwrap()).unwrap()
}

fn in_space(shape: &Shape) -> Shape {
    let net = shape.net();
    let lifted = |pole: &[f64]| [pole[0], pole[1], 0.0, pole[2]];
    let poles = net.homogeneous().chunks(3).flat_map(lifted).collect();
    shape.with_net(Form::from_homogeneous(net.orders(), 3, poles).unwrap()).unwrap()
}

fn shifted(shape: &Shape, by: [f64; 3]) -> Shape {
    let net = shape.net();
    let moved = |pole: &[f64]| {
        let w = pole[3];
        [pole[0] + by[0] * w, pole[1] + by[1] * w, pole[2] + by[2] * w, w]
    };
    let poles = net.homogeneous().chunks(4).flat_map(moved).collect();
    shape.with_net(Form::from_homogeneous(net.orders(), 3, poles).unwrap()).unwrap()
}

/// The disc in the plane of x and y, from its centre to its rim.
fn disc(radius: f64, part: Part) -> Shape {
    let rim = circle(&radius, part).unwrap();
    let rim = if rim.net().ambient() == 2 { in_space(&rim) } else { rim };
    ruled_shapes(&shrunk(&rim), &rim).unwrap()
}

fn made(shape: &Shape, accuracy: f64) -> Solid {
    solid(&[Surface::Shape(shape.clone())], accuracy).unwrap()
}

/// Closed, and no farther from the volume than it says; returns the error and its bound.
fn checked(shape: &Shape, expected: f64, accuracy: f64) -> [f64; 2] {
    let made = made(shape, accuracy);
    assert!(made.mesh.is_closed());
    let off = (made.mesh.volume().unwrap() - expected).abs();
    let bound = made.volume_error;
    assert!(off <= bound, "{off:e} above {bound:e} at {accuracy:e}");
    [off, bound]
}

const PARTS: [Part; 2] = [Part::Whole, Part::Pieces];

#[test]
fn balls_however_they_are_given() {
    let volume = 4.0 / 3.0 * PI;
    for part in PARTS {
        let shell = sphere(&1.0, part).unwrap();
        let full = ruled_shapes(&shrunk(&shell), &shell).unwrap();
        for accuracy in [0.1, 1e-2, 1e-3] {
            for ball in [&shell, &full] {
                checked(ball, volume, accuracy);
            }
        }
    }
}

#[test]
fn the_bound_is_near_the_truth() {
    let shell = sphere(&1.0, Part::Pieces).unwrap();
    for (accuracy, most) in [(1e-2, 4.5), (1e-3, 2.5), (1e-4, 2.0)] {
        let [off, bound] = checked(&shell, 4.0 / 3.0 * PI, accuracy);
        assert!(bound <= most * off, "{bound:e} for {off:e} at {accuracy:e}");
    }
}

#[test]
fn a_half_disc_turns_into_a_ball() {
    // Between its diameter and half a circle: turned, the diameter becomes a face that is a line.
    let meridian = sphere(&1.0, Part::Whole).unwrap();
    let orders = meridian.net().orders().to_vec();
    let poles: Vec<f64> = (0..orders[0])
        .flat_map(|i| meridian.net().homogeneous()[4 * i * orders[1]..][..4].to_vec())
        .collect();
    let axis: Vec<f64> = poles.chunks(4).flat_map(|p| [0.0, p[1], 0.0, p[3]]).collect();
    let form = |poles| Shape::from(Form::from_homogeneous(&[orders[0]], 3, poles).unwrap());
    let half = ruled_shapes(&form(axis), &form(poles)).unwrap();
    let upright = Axis::with_length([0.0; 3], [0.0, 1.0, 0.0], &1.0).unwrap();
    for part in PARTS {
        let ball = revolve_whole(&half, &upright, part).unwrap();
        checked(&ball, 4.0 / 3.0 * PI, 1e-3);
    }
    // A quarter of it: two flat walls that do not meet.
    let quarter = revolve(&half, PI / 2.0, &upright, 3).unwrap();
    checked(&quarter, PI / 3.0, 1e-3);
    // All the way round by an angle: the seam is closed but for rounding.
    let turned = revolve(&half, 2.0 * PI, &upright, 5).unwrap();
    checked(&turned, 4.0 / 3.0 * PI, 1e-3);
}

#[test]
fn tori_of_skin_and_full() {
    let volume = 2.0 * PI * PI * 2.0 * 0.25;
    let upright = Axis::with_length([0.0; 3], [0.0, 1.0, 0.0], &1.0).unwrap();
    for part in PARTS {
        let skin = torus(&2.0, &0.5, part).unwrap();
        checked(&skin, volume, 1e-3);
        let full = revolve_whole(&shifted(&disc(0.5, part), [2.0, 0.0, 0.0]), &upright, part);
        checked(&full.unwrap(), volume, 1e-3);
        checked(&skin, volume, 0.1);
    }
}

#[test]
fn a_disc_pulled_along_is_a_cylinder() {
    for part in PARTS {
        let path = Shape::from(path_of(&[0.3, 0.2, 2.0], 3).unwrap());
        let cylinder = extrude_shapes(&disc(0.5, part), &path).unwrap();
        for accuracy in [0.1, 1e-2, 1e-4] {
            checked(&cylinder, PI / 2.0, accuracy);
        }
    }
}

#[test]
fn sides_may_collapse() {
    let volume = |corners: [[f64; 3]; 8]| {
        Shape::from(Form::from_points(&[2, 2, 2], 3, &corners.concat(), None).unwrap())
    };
    let [o, x, y, z] = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
    let xy = [1., 1., 0.];
    // A pyramid, a wedge whose top is an edge, and a tetrahedron.
    let pyramid = volume([o, z, y, z, x, z, xy, z]);
    let wedge = volume([o, z, y, [0., 1., 1.], x, z, xy, [0., 1., 1.]]);
    let tetrahedron = volume([o, z, y, z, x, z, x, z]);
    for (solid, expected) in [(pyramid, 1.0 / 3.0), (wedge, 0.5), (tetrahedron, 1.0 / 6.0)] {
        let made = made(&solid, 1e-3);
        assert!(made.mesh.is_closed());
        assert!((made.mesh.volume().unwrap() - expected).abs() < 1e-15);
    }
    // A lens: two faces meet along curved edges, four sides are curves.
    let arch = |height: f64| [0.0, height, 0.0, height, 2.0 * height, height, 0.0, height, 0.0];
    let sheet = |height: f64| {
        let rim = |k: usize| (k as f64 / 2.0).clamp(0.0, 1.0);
        let bulge = arch(height);
        let points: Vec<f64> = (0..9)
            .flat_map(|k| [rim(k / 3), rim(k % 3), if k == 4 { bulge[4] } else { 0.0 }])
            .collect();
        Shape::from(Form::from_points(&[3, 3], 3, &points, None).unwrap())
    };
    // The middle Bernstein product has the integral 1/9.
    checked(&ruled_shapes(&sheet(-1.0), &sheet(1.0)).unwrap(), 4.0 / 9.0, 1e-3);
}

#[test]
fn round_shafts_cross() {
    // Two shafts have the solid of Steinmetz in common, three one of twelve faces.
    let path = Shape::from(path_of(&[0.0, 0.0, 4.0], 3).unwrap());
    let shaft = shifted(&extrude_shapes(&disc(1.0, Part::Whole), &path).unwrap(), [0., 0., -2.]);
    let turned = |shape: &Shape, k: usize| {
        let turn = |p: &[f64]| [p[k % 3], p[(k + 1) % 3], p[(k + 2) % 3], p[3]];
        let poles = shape.net().homogeneous().chunks(4).flat_map(turn).collect();
        let net = Form::from_homogeneous(shape.net().orders(), 3, poles).unwrap();
        shape.with_net(net).unwrap()
    };
    let bodies: Vec<_> = (0..3).map(|k| vec![Surface::Shape(turned(&shaft, k))]).collect();
    let both = combine(Operation::Common, &bodies[..2], 1e-3).unwrap();
    let all = combine(Operation::Common, &bodies, 1e-3).unwrap();
    for (made, expected) in [(both, 16.0 / 3.0), (all, 8.0 * (2.0 - 2.0_f64.sqrt()))] {
        let off = (made.mesh.volume().unwrap() - expected).abs();
        assert!(off <= made.volume_error && made.volume_error < 12.0 * off);
    }
}
