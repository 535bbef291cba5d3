//! Traced numbers: their derivatives are those of dual numbers, forwards and backwards.
#![allow(missing_docs, clippy::unwrap_used)]

use pforms_kernel::{Dual, Form, Scalar, Traced, derivatives, gradient};
use pforms_testkit::Random;

/// A rational curve through the numbers, evaluated and differenced: every operation occurs.
fn computed<S: Scalar>(numbers: &[S]) -> Vec<S> {
    let form = Form::from_points(&[3], 1, &numbers[..3], Some(&numbers[3..6])).unwrap();
    let mut found = form.at(&[S::ratio(1, 3)]).unwrap();
    found.push(-(found[0].clone() - numbers[1].clone()) * numbers[4].clone());
    let mut sum = S::zero();
    S::add_multiple(std::slice::from_mut(&mut sum), &found[1], &[found[0].clone()]);
    sum += numbers[0].clone() / numbers[5].clone();
    found.push(sum);
    found.push(S::from_integer(7));
    found
}

#[test]
fn forwards_backwards_and_dual_numbers_agree() {
    let mut random = Random::new(5);
    for _ in 0..50 {
        let values: Vec<f64> = (0..6).map(|_| 0.5 + 1.5 * random.unit()).collect();
        let traced: Vec<Traced> =
            values.iter().enumerate().map(|(i, x)| Traced::source(*x, i)).collect();
        let results = computed(&traced);
        let matrix = derivatives(&results, 6).unwrap().dense().unwrap();
        for moved in 0..6 {
            let dual =
                |(i, x): (usize, &f64)| Dual { value: *x, slope: f64::from(u8::from(i == moved)) };
            let duals: Vec<Dual> = values.iter().enumerate().map(dual).collect();
            for (row, result) in computed(&duals).iter().enumerate() {
                assert_eq!(results[row].value(), result.value);
                // The same products and sums, in another order: some roundings of numbers below 10.
                assert!((matrix.row(row)[moved] - result.slope).abs() < 1e-14);
            }
        }
        let weights = [2.0, -1.0, 0.5, 3.0];
        let gradient = gradient(&results, &weights, 6).unwrap();
        for (moved, found) in gradient.iter().enumerate() {
            let sum: f64 = (0..4).map(|row| weights[row] * matrix.row(row)[moved]).sum();
            assert!((found - sum).abs() < 1e-13);
        }
    }
}

#[test]
fn constants_have_no_derivative_and_sources_their_own() {
    let (x, c) = (Traced::source(2.0, 1), Traced::constant(3.0));
    let results =
        [c.clone(), x.clone(), x.clone() * c.clone(), x.clone() - x.clone(), c.clone() + c];
    let matrix = derivatives(&results, 2).unwrap();
    assert_eq!(matrix.starts(), [0, 0, 1, 2, 2, 2]);
    assert_eq!((matrix.places(), matrix.entries()), (&[1, 1][..], &[1.0, 3.0][..]));
    assert!(results[0].is_constant() && !results[3].is_constant());
    assert_ne!(results[3], Traced::zero());
    assert!(derivatives(&results, 1).is_err() && gradient(&results, &[1.0; 5], 1).is_err());
    assert!(gradient(&results, &[1.0; 4], 2).is_err());
    assert!(derivatives(&[x / Traced::zero()], 2).is_err());
}

#[test]
fn a_million_steps_are_followed_and_forgotten() {
    let mut sum = Traced::source(1.0, 0);
    for _ in 0..1_000_000 {
        sum = sum * Traced::constant(0.999_999);
    }
    let found = gradient(std::slice::from_ref(&sum), &[1.0], 1).unwrap();
    assert_eq!(found[0], sum.value());
}
