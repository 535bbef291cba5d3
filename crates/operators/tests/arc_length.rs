//! Lengths against closed forms, and the way back from lengths to parameters.
#![allow(clippy::unwrap_used)]

mod common;

use std::f64::consts::PI;

use common::family;
use pforms_kernel::Form;
use pforms_operators::{ArcLength, KnotRule, bspline, elevate, stretch};
use pforms_testkit::{ROUNDS, Random, Weights};

const ACCURACY: f64 = 1e-13;

fn plane(points: &[[f64; 2]], weights: Option<&[f64]>) -> Form {
    Form::from_points(&[points.len()], 2, points.as_flattened(), weights).unwrap()
}

fn length(curve: &Form) -> f64 {
    ArcLength::new(curve.clone(), ACCURACY).unwrap().length()
}

/// The true length lies within the reported error, and that within the accuracy.
fn agrees(curve: &Form, wanted: f64) {
    let measured = ArcLength::new(curve.clone(), ACCURACY).unwrap();
    let off = (measured.length() - wanted).abs();
    assert!(off <= measured.error(), "{off} > {}", measured.error());
    assert!(measured.error() <= 2.0 * ACCURACY * wanted, "{}", measured.error());
}

#[test]
fn closed_forms() {
    agrees(&plane(&[[0.0, 0.0], [3.0, 4.0]], None), 5.0);
    agrees(&plane(&[[0.0, 0.0], [0.0, 0.0], [3.0, 4.0]], None), 5.0);
    // (t, t²)
    let parabola = plane(&[[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]], None);
    agrees(&parabola, 0.5 * 5.0_f64.sqrt() + 0.25 * 2.0_f64.asinh());
    agrees(&elevate(&parabola, &[30]).unwrap(), 0.5 * 5.0_f64.sqrt() + 0.25 * 2.0_f64.asinh());
    // (t², t³) from −1 to 1 has a cusp inside; from 0 to 1 at its end.
    let semicubical = plane(&[[0.0, 0.0], [0.0, 0.0], [1.0 / 3.0, 0.0], [1.0, 1.0]], None);
    let branch = (13.0 * 13.0_f64.sqrt() - 8.0) / 27.0;
    agrees(&semicubical, branch);
    agrees(&stretch(&semicubical, &[-1.0], &[1.0]).unwrap(), 2.0 * branch);
}

#[test]
fn circles_of_every_kind() {
    let w = 0.5_f64.sqrt();
    let quarter = plane(&[[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], Some(&[1.0, w, 1.0]));
    agrees(&quarter, PI / 2.0);
    let negative = plane(&[[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], Some(&[-1.0, -w, -1.0]));
    agrees(&negative, PI / 2.0);
    // The other arc of the same circle has a negative weight.
    let rest = plane(&[[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], Some(&[1.0, -w, 1.0]));
    agrees(&rest, 3.0 * PI / 2.0);
    // A half circle by a pole at infinity.
    let half = plane(&[[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]], Some(&[1.0, 0.0, 1.0]));
    agrees(&half, PI);
}

#[test]
fn a_line_run_there_and_back_counts_both_ways() {
    agrees(&plane(&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]], None), 1.0);
}

#[test]
fn powers_of_two_change_no_bit_and_extremes_do_no_harm() {
    let mut random = Random::new(31);
    let form = random.form::<f64>(&[5], 3, Weights::Positive);
    let scaled = |factor: f64| {
        let mut poles = form.homogeneous().to_vec();
        poles.chunks_exact_mut(4).for_each(|p| p[..3].iter_mut().for_each(|x| *x *= factor));
        Form::from_homogeneous(form.orders(), 3, poles).unwrap()
    };
    let one = length(&form);
    for exponent in [-500, -3, 7, 500] {
        let factor = 2.0_f64.powi(exponent);
        assert_eq!(length(&scaled(factor)), one * factor);
    }
}

#[test]
fn parts_make_the_whole_and_the_way_back_is_found() {
    let mut random = Random::new(7);
    for round in 0..ROUNDS {
        let form = random.form::<f64>(
            &[2 + round as usize % 7],
            2 + round as usize % 3,
            Weights::Positive,
        );
        let whole = ArcLength::new(form.clone(), ACCURACY).unwrap();
        let (low, high) = pforms_operators::split(&form, 0, &0.375).unwrap();
        let sum = length(&low) + length(&high);
        assert!((sum - whole.length()).abs() <= 4.0 * whole.error());
        assert!((whole.up_to(0.375).unwrap() - length(&low)).abs() <= 4.0 * whole.error());
        for share in [0.0, 0.1, 0.5, 0.9, 1.0] {
            let there = whole.parameter(share * whole.length()).unwrap();
            let back = whole.up_to(there).unwrap();
            assert!(
                (back - share * whole.length()).abs() <= 4.0 * whole.error(),
                "{round} {share}"
            );
        }
    }
}

#[test]
fn what_has_no_length() {
    let line = plane(&[[0.0, 0.0], [1.0, 0.0]], None);
    for accuracy in [0.0, -1.0, 1.0, f64::NAN] {
        assert_eq!(family(ArcLength::new(line.clone(), accuracy)), "Domain");
    }
    assert_eq!(family(ArcLength::new(line.clone(), 1e-17)), "Accuracy");
    let hyperbola = plane(&[[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], Some(&[1.0, -2.0, 1.0]));
    assert_eq!(family(ArcLength::new(hyperbola, 1e-9)), "Domain");
    // The weight is (1 − 2t)² and (1 − 2t)·(1 + t).
    for weights in [[1.0, -1.0, 1.0], [1.0, 0.25, -2.0]] {
        let gone = plane(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]], Some(&weights));
        assert_eq!(family(ArcLength::new(gone, 1e-12)), "Domain");
    }
    let infinite_end = plane(&[[0.0, 0.0], [1.0, 1.0]], Some(&[1.0, 0.0]));
    assert_eq!(family(ArcLength::new(infinite_end, 1e-9)), "Domain");
    let facet = Form::from_points(&[2, 2], 1, &[0.0; 4], None).unwrap();
    assert_eq!(family(ArcLength::new(facet, 1e-9)), "Shape");
    let still = ArcLength::new(plane(&[[1.0, 2.0]; 3], None), 1e-9).unwrap();
    assert_eq!(still.length(), 0.0);
    assert_eq!(still.parameter(0.0).unwrap(), 0.0);
    let measured = ArcLength::new(line.clone(), 1e-9).unwrap();
    assert_eq!(family(measured.up_to(1.5)), "Domain");
    assert_eq!(family(measured.up_to(f64::NAN)), "Domain");
    assert_eq!(family(measured.parameter(2.0)), "Domain");
    assert_eq!(family(measured.parameter(-0.1)), "Domain");
}

/// More pieces than stretches that one curve of few pieces may take, and a sum of as many lengths.
#[test]
fn a_hundred_thousand_poles_are_measured_to_the_full_accuracy() {
    let mut random = Random::new(101);
    let (mut x, mut points) = (0.0, vec![0.0, 0.0]);
    for _ in 1..100_000 {
        x += 0.5 + random.unit();
        points.extend([x, 0.0]);
    }
    let net: Form = Form::from_points(&[100_000], 2, &points, None).unwrap();
    let straight = |degree| bspline(&net, &[degree], &[KnotRule::Clamped], &[false]).unwrap();
    let measured = ArcLength::new(straight(1), 1e-12).unwrap();
    let gap = (measured.length() - x).abs();
    assert!(gap <= measured.error() && measured.error() <= 2e-12 * x, "{gap}");
    let half = measured.parameter(0.5 * x).unwrap();
    assert!((measured.up_to(half).unwrap() - 0.5 * x).abs() <= 2e-12 * x);
    let measured = ArcLength::new(straight(3), 1e-12).unwrap();
    let gap = (measured.length() - x).abs();
    assert!(gap <= measured.error() && measured.error() <= 2e-12 * x, "{gap}");
}
