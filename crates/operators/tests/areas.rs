//! Areas and other measures against closed forms, with the bounds they claim.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use std::f64::consts::PI;

use pforms_kernel::Form;
use pforms_operators::{Measure, Part, Shape, area, cone, cylinder, measure, sphere, torus};
use pforms_testkit::{truth, whole_sphere};

const ACCURACY: f64 = 1e-12;

fn of(form: Form) -> Measure {
    area(&[form.into()], ACCURACY).unwrap()
}

/// The value is right within the error it claims, and the error is no larger than was asked for.
fn assert_is(measured: Measure, expected: f64, what: &str) {
    let gap = (measured.value - expected).abs();
    eprintln!("{what}: {} off by {gap:.1e}, bound {:.1e}", measured.value, measured.error);
    assert!(gap <= measured.error, "{what}: {measured:?} {expected}");
    assert!(measured.error <= ACCURACY * expected, "{what}: {measured:?}");
}

#[test]
fn closed_forms() {
    for (id, value, share) in [
        ("spheroid-1-1-1/2", "area", 8.0),
        ("torus-3-1", "piece_area", 1.0),
        ("enneper-order1-1", "area", 1.0),
        ("enneper-order2-1/2", "area", 1.0),
        ("hypar-1-1-1", "area", 1.0),
        ("paraboloid-1", "area", 1.0),
        ("wigley-1-1/10-1/16", "wetted_area", 2.0),
        ("flat-torus-in-4-space-1-1", "piece_area", 1.0),
    ] {
        let truth = truth(id);
        assert_is(of(truth.form()), truth.value(value) / share, id);
    }
}

#[test]
fn lengths_are_measures_too() {
    for (id, value) in [
        ("parabola-arc-1", "length"),
        ("parabola-arc-2", "length"),
        ("ellipse-3-2", "quarter"),
        ("viviani-1", "quarter"),
        ("cardioid-1", "length_0_90"),
        ("astroid-1", "length"),
        ("tschirnhausen-1", "length"),
        ("twisted-cubic-1", "length"),
    ] {
        let truth = truth(id);
        let measured = measure(&[truth.form().into()], ACCURACY).unwrap();
        assert_is(measured, truth.value(value), id);
    }
}

#[test]
fn surfaces_of_revolution() {
    for part in [Part::Whole, Part::Pieces] {
        let list = |shape: Shape| area(&[shape], ACCURACY).unwrap();
        assert_is(list(sphere(&2.0, part).unwrap()), 16.0 * PI, "sphere");
        assert_is(list(torus(&3.0, &1.0, part).unwrap()), 12.0 * PI * PI, "torus");
        assert_is(list(cylinder(&1.0, &3.0, part).unwrap()), 6.0 * PI, "cylinder");
        assert_is(list(cone(&3.0, &4.0, &0.0, part).unwrap()), 15.0 * PI, "cone");
    }
    let octants: Vec<Shape> = whole_sphere().into_iter().map(Shape::Form).collect();
    assert_is(area(&octants, ACCURACY).unwrap(), 4.0 * PI, "octants");
}

/// A paraboloid's patch far away, tiny and huge: relative bounds stay, powers of two change no digit.
#[test]
fn size_and_place_do_not_matter() {
    let form = truth("paraboloid-1").form();
    let scaled = |factor: f64, shift: f64| {
        let mut poles = form.homogeneous().to_vec();
        for pole in poles.chunks_exact_mut(4) {
            pole[..3].iter_mut().for_each(|x| *x = *x * factor + shift);
        }
        Form::from_homogeneous(form.orders(), 3, poles).unwrap()
    };
    let here = of(form.clone());
    for exponent in [-300, -40, 1, 300] {
        let factor = libm::ldexp(1.0, exponent);
        let there = of(scaled(factor, 0.0));
        assert_eq!(there.value, here.value * factor * factor, "2^{exponent}");
        assert_eq!(there.error, here.error * factor * factor, "2^{exponent}");
    }
    // Poles at multiples of 1/2 lose nothing on their way to 2^40.
    let far = of(scaled(1.0, libm::ldexp(1.0, 40)));
    assert!((far.value - here.value).abs() <= here.error + far.error);
    let huge = area(&[scaled(libm::ldexp(1.0, 600), 0.0).into()], ACCURACY).unwrap_err();
    assert_eq!(huge.family(), "Domain");
}

/// Surfaces that are curves or points have area 0, and say how sure that is.
#[test]
fn zero_areas() {
    let line: Vec<f64> =
        (0..9).flat_map(|k| [f64::from(k) / 3.0, 0.1 * f64::from(k), 7.0]).collect();
    let flat = of(Form::from_points(&[3, 3], 3, &line, None).unwrap());
    assert!(flat.value <= flat.error && flat.error < 1e-12, "{flat:?}");
    let point = of(Form::from_points(&[2, 2], 3, &[0.1; 12], None).unwrap());
    assert_eq!((point.value, point.error), (0.0, 0.0));
    // An axis of order 1 is no extension at all.
    let thin =
        of(Form::from_points(&[3, 1], 3, &[0., 0., 0., 1., 0., 0., 1., 1., 0.], None).unwrap());
    assert_eq!((thin.value, thin.error), (0.0, 0.0));
}

#[test]
fn bad_input_is_named() {
    let family = |form: Form, accuracy: f64| area(&[form.into()], accuracy).unwrap_err().family();
    let square = |weights: &[f64]| {
        let corners = [0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 0.];
        Form::from_points(&[2, 2], 3, &corners, Some(weights)).unwrap()
    };
    assert_eq!(family(square(&[1., 1., 1., 0.]), 1e-6), "Domain", "infinite corner");
    assert_eq!(family(square(&[1., 1., 1., -1.]), 1e-6), "Domain", "across infinity");
    assert_eq!(family(square(&[0.; 4]), 1e-6), "Domain", "all at infinity");
    for accuracy in [0.0, 1.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(family(square(&[1.; 4]), accuracy), "Domain");
    }
    assert_eq!(family(square(&[1.; 4]), 1e-16), "Accuracy");
    assert_eq!(family(Form::from_points(&[2], 3, &[0.; 6], None).unwrap(), 1e-6), "Shape");
    assert_eq!(family(Form::from_points(&[2, 2], 1, &[0.; 4], None).unwrap(), 1e-6), "Shape");
    assert_eq!(area(&[], 1e-6).unwrap_err().family(), "Shape");
}
