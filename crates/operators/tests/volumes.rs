//! Volumes, centres and inertia against closed forms, with the bounds they claim.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use std::f64::consts::PI;

use pforms_kernel::{Form, Rational, Scalar};
use pforms_operators::{
    Mass, Measure, Part, Shape, mass, reverse, sphere, stack, sub, torus, volume, volume_exact,
};
use pforms_testkit::{truth, whole_sphere};

const ACCURACY: f64 = 1e-12;

fn assert_is(measured: Measure, expected: f64, what: &str) {
    let gap = (measured.value - expected).abs();
    assert!(gap <= measured.error, "{what}: {measured:?} {expected}");
    assert!(measured.error <= ACCURACY * expected.abs(), "{what}: {measured:?}");
}

fn solid(form: Form) -> Measure {
    volume(&[form.into()], false, ACCURACY).unwrap()
}

/// A box with these sides as a volume form, and its six faces.
fn brick(sides: [f64; 3]) -> Form {
    let corner = |k: usize| [(k >> 2 & 1) as f64, (k >> 1 & 1) as f64, (k & 1) as f64];
    let points: Vec<f64> =
        (0..8).flat_map(|k| corner(k).into_iter().zip(sides).map(|(x, side)| x * side)).collect();
    Form::from_points(&[2, 2, 2], 3, &points, None).unwrap()
}

fn faces(form: &Form) -> Vec<Shape> {
    let ends = (0..3).flat_map(|axis| [0.0, 1.0].map(|t| sub(form, axis, &t).unwrap().into()));
    ends.collect()
}

#[test]
fn solids_and_their_shells() {
    let brick = brick([1.0, 2.0, 3.0]);
    assert_is(solid(brick.clone()), 6.0, "brick");
    // The faces come in any order and either way round.
    let mut shell = faces(&brick);
    assert_is(volume(&shell, false, ACCURACY).unwrap(), 6.0, "shell");
    shell.swap(0, 3);
    if let Shape::Form(form) = &shell[1] {
        shell[1] = reverse(form, 1).unwrap().into();
    }
    assert_is(volume(&shell, false, ACCURACY).unwrap(), 6.0, "shell in disorder");
    let turned = volume(&[reverse(&brick, 2).unwrap().into()], true, ACCURACY).unwrap();
    assert_is(turned, -6.0, "left-handed");
}

#[test]
fn spheres_tori_and_spheroids() {
    let octants: Vec<Shape> = whole_sphere().into_iter().map(Shape::Form).collect();
    assert_is(volume(&octants, false, ACCURACY).unwrap(), 4.0 * PI / 3.0, "octants");
    for part in [Part::Whole, Part::Pieces] {
        let ball = volume(&[sphere(&2.0, part).unwrap()], false, ACCURACY);
        assert_is(ball.unwrap(), 32.0 * PI / 3.0, "ball");
        let ring = volume(&[torus(&3.0, &1.0, part).unwrap()], false, ACCURACY);
        assert_is(ring.unwrap(), truth("torus-3-1").value("volume"), "ring");
    }
    // The octant of the spheroid drawn to its centre: a volume form with a collapsed face.
    let truth = truth("spheroid-1-1-1/2");
    let octant = truth.form();
    let centre = octant.map_scalar(|_| 0.0).unwrap();
    let mut poles = centre.homogeneous().to_vec();
    for (pole, w) in poles.chunks_exact_mut(4).zip(octant.weights()) {
        pole[3] = w;
    }
    let centre = Form::from_homogeneous(octant.orders(), 3, poles).unwrap();
    let part = stack(&[&centre, &octant]).unwrap();
    assert_is(solid(part), truth.value("volume") / 8.0, "spheroid");
}

#[test]
fn more_dimensions() {
    let truth = truth("duocylinder-1-1");
    // A quarter disc, drawn from the centre; the product of two of them in four dimensions.
    let arc = Form::from_points(&[3], 2, &[1., 0., 1., 1., 0., 1.], Some(&[1., 1., 2.])).unwrap();
    let weights = arc.weights();
    let centre = Form::from_points(&[3], 2, &[0.0; 6], Some(&weights)).unwrap();
    let disc = stack(&[&centre, &arc]).unwrap();
    let product = product(&disc, &disc);
    let measured = volume(&[product.into()], false, ACCURACY).unwrap();
    assert_is(measured, truth.value("volume4") / 16.0, "duocylinder");
    let border = volume(&[self::product(&disc, &arc).into()], false, ACCURACY).unwrap();
    assert_is(border, truth.value("boundary3") / 32.0, "its border");
}

/// The form `(f(u), g(v))`.
fn product(f: &Form, g: &Form) -> Form {
    let (a, b) = (f.ambient(), g.ambient());
    let mut poles = Vec::new();
    for p in f.homogeneous().chunks_exact(a + 1) {
        for q in g.homogeneous().chunks_exact(b + 1) {
            poles.extend(p[..a].iter().map(|x| x * q[b]));
            poles.extend(q[..b].iter().map(|x| x * p[a]));
            poles.push(p[a] * q[b]);
        }
    }
    let orders = [f.orders(), g.orders()].concat();
    Form::from_homogeneous(&orders, a + b, poles).unwrap()
}

#[test]
fn plane_curves_enclose_areas() {
    let mirrored = |form: &Form, signs: [f64; 2]| -> Shape {
        let mut poles = form.homogeneous().to_vec();
        for pole in poles.chunks_exact_mut(3) {
            pole[0] *= signs[0];
            pole[1] *= signs[1];
        }
        Form::from_homogeneous(form.orders(), 2, poles).unwrap().into()
    };
    let all = [[1., 1.], [-1., 1.], [-1., -1.], [1., -1.]];
    for (id, value) in [("ellipse-3-2", "enclosed_area"), ("astroid-1", "area")] {
        let truth = truth(id);
        let whole = all.map(|signs| mirrored(&truth.form(), signs));
        assert_is(volume(&whole, false, ACCURACY).unwrap(), truth.value(value), id);
    }
}

#[test]
fn exact_volumes() {
    let fraction = |n: i64, d: i64| Rational::ratio(n, d);
    // z = x² + y² over a square of side 1, and its shadow: the volume between is 2/3.
    let grid = |top: bool| -> Form<Rational> {
        let mut points = Vec::new();
        for i in 0..3 {
            for j in 0..3 {
                let square = |k: i64| if k == 2 { fraction(1, 1) } else { fraction(0, 1) };
                let z = if top { square(i) + square(j) } else { fraction(0, 1) };
                points.extend([fraction(i, 2), fraction(j, 2), z]);
            }
        }
        Form::from_points(&[3, 3], 3, &points, None).unwrap()
    };
    let (top, bottom) = (grid(true), grid(false));
    let between = stack(&[&bottom, &top]).unwrap();
    assert_eq!(volume_exact(&[between.clone().into()], false).unwrap(), fraction(2, 3));
    let mut shell: Vec<Shape<Rational>> = Vec::new();
    for axis in 0..3 {
        for t in [0, 1] {
            shell.push(sub(&between, axis, &fraction(t, 1)).unwrap().into());
        }
    }
    assert_eq!(volume_exact(&shell, false).unwrap(), fraction(2, 3));
    let open = volume_exact(&shell[..5], false).unwrap_err();
    assert!(open.to_string().contains("open border"), "{open}");
}

fn assert_mass(mass: &Mass, centroid: &[f64], moments: &[f64], what: &str) {
    for (x, y) in mass.centroid.iter().zip(centroid) {
        assert!((x - y).abs() <= mass.centroid_error, "{what}: {mass:?} {centroid:?}");
    }
    assert!(mass.centroid_error < 1e-11, "{what}: {mass:?}");
    for (x, y) in mass.moments.iter().zip(moments) {
        assert!((x - y).abs() <= mass.inertia_error, "{what}: {mass:?} {moments:?}");
    }
}

#[test]
fn centres_and_inertia() {
    let brick = brick([1.0, 2.0, 3.0]);
    let inertia = [0.5 * (1. + 4.), 0.5 * (1. + 9.), 0.5 * (4. + 9.)];
    let filled = mass(&[brick.clone().into()], false, ACCURACY).unwrap();
    assert_mass(&filled, &[0.5, 1.0, 1.5], &inertia, "brick");
    let shell = mass(&faces(&brick), true, ACCURACY).unwrap();
    assert_mass(&shell, &[0.5, 1.0, 1.5], &inertia, "shell of the brick");
    // A ball, and a spherical shell of radius 2.
    let octants = sphere(&2.0, Part::Pieces).unwrap();
    let ball = mass(std::slice::from_ref(&octants), true, ACCURACY).unwrap();
    assert_mass(&ball, &[0.0; 3], &[0.4 * 4.0 * 32.0 * PI / 3.0; 3], "ball");
    let hollow = mass(&[octants], false, ACCURACY).unwrap();
    assert_mass(&hollow, &[0.0; 3], &[2.0 / 3.0 * 4.0 * 16.0 * PI; 3], "hollow");
    // A half circle: its centre is at 2/π.
    let arc = Form::from_points(&[3], 2, &[1., 0., 1., 1., 0., 1.], Some(&[1., 1., 2.])).unwrap();
    let quarter = mass(&[arc.into()], false, ACCURACY).unwrap();
    assert_mass(&quarter, &[2.0 / PI; 2], &[], "arc");
    let nothing = Form::from_points(&[2, 2], 3, &[1.0; 12], None).unwrap();
    assert_eq!(mass(&[nothing.into()], false, ACCURACY).unwrap_err().family(), "Degenerate");
}

#[test]
fn the_hull_of_wigley() {
    let truth = truth("wigley-1-1/10-1/16");
    let side = truth.form();
    // Between the hull and its middle plane: y from 0 to the hull.
    let mut poles = side.homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(4) {
        pole[1] = 0.0;
    }
    let middle = Form::from_homogeneous(side.orders(), 3, poles).unwrap();
    let half = stack(&[&middle, &side]).unwrap();
    let measured = mass(&[half.into()], false, ACCURACY).unwrap();
    assert_is(measured.measure, truth.value("volume") / 2.0, "half the hull");
    let z = truth.value("centre_of_volume_z");
    assert!((measured.centroid[2] - z).abs() <= measured.centroid_error);
    assert!(measured.centroid_error < 1e-12);
}

#[test]
fn shells_that_do_not_close() {
    let family = |shapes: &[Shape]| {
        let error = volume(shapes, false, ACCURACY).unwrap_err();
        (error.family(), error.to_string())
    };
    let shell = faces(&brick([1.0, 1.0, 1.0]));
    let (kind, text) = family(&shell[..5]);
    assert!(
        kind == "Degenerate" && text.contains("open border") && text.contains("patch"),
        "{text}"
    );
    // Two sides of a triangle.
    let curve = |points: &[f64]| Form::from_points(&[2], 2, points, None).unwrap().into();
    let (kind, _) = family(&[curve(&[0., 0., 1., 0.]), curve(&[1., 0., 1., 1.])]);
    assert_eq!(kind, "Degenerate");
    // Points are no shell; a curve in space encloses nothing.
    assert_eq!(family(&[Form::from_points(&[2], 3, &[0.; 6], None).unwrap().into()]).0, "Shape");
    // Doubled, with two faces on each other: flat, of volume 0.
    let square: Shape = shell[0].clone();
    let flat = volume(&[square.clone(), square], false, ACCURACY).unwrap();
    assert!(flat.value <= flat.error && flat.error < 1e-14, "{flat:?}");
}
