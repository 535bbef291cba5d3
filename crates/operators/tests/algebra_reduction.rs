//! Reduction: exact on raised forms, the least-squares best on others, never beyond its bound.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Form, Rational, Scalar};
use pforms_operators::{elevate, elevation_matrix, reduce};
use pforms_testkit::{ROUNDS, Random, Weights, exact_forms};

type Exact = Form<Rational>;

#[test]
fn reduction_undoes_elevation_with_bound_zero() {
    for (f, mut random) in exact_forms(1..=3) {
        let by: Vec<usize> = (0..f.axes()).map(|_| random.size(0, 3)).collect();
        let reduction = reduce(&elevate(&f, &by).unwrap(), &by).unwrap();
        assert_eq!(reduction.form, f);
        assert_eq!(reduction.bound, 0.0);
    }
}

#[test]
fn reduction_stays_within_its_bound_and_is_the_least_squares_best() {
    let mut bounded = 0;
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let orders = [random.size(3, 7)];
        let f: Exact = random.form(&orders, 2, Weights::Positive);
        let Ok(reduction) = reduce(&f, &[1]) else { continue };
        bounded += 1;
        for k in 0..=20 {
            let t = [Rational::ratio(k, 20)];
            let gap: f64 = f
                .at(&t)
                .unwrap()
                .iter()
                .zip(reduction.form.at(&t).unwrap())
                .map(|(a, b)| (a - b).to_f64().powi(2))
                .sum::<f64>()
                .sqrt();
            assert!(gap <= reduction.bound, "{gap} > {}", reduction.bound);
        }
        // Best: the residue is orthogonal to everything that elevation reaches.
        let polynomial: Exact = random.form(&orders, 1, Weights::One);
        let best = reduce(&polynomial, &[1]).unwrap().form;
        let raised = elevate(&best, &[1]).unwrap();
        let degree = orders[0] - 2;
        let matrix = elevation_matrix::<Rational>(degree, 1).unwrap();
        for j in 0..=degree {
            let mut product: Rational = Scalar::zero();
            for i in 0..orders[0] {
                let residue =
                    polynomial.homogeneous()[2 * i].clone() - raised.homogeneous()[2 * i].clone();
                product += residue * matrix.row(i)[j].clone();
            }
            assert!(Scalar::is_zero(&product));
        }
    }
    assert!(bounded > 20, "{bounded} reductions with a bound");
}

#[test]
fn the_bound_of_a_reduction_has_the_scale_of_the_form() {
    let points = [0., 0., 1., 3., 2., -1., 3., 0.];
    let weights = [1., 0.7, 0.3, 2.];
    let plain: Form = Form::from_points(&[4], 2, &points, Some(&weights)).unwrap();
    let bound = reduce(&plain, &[1]).unwrap().bound;
    for power in [-560, -40, 40, 500] {
        let scale = 2_f64.powi(power);
        let weighty = plain.map_scalar(|x| x * scale).unwrap();
        assert_eq!(reduce(&weighty, &[1]).unwrap().bound, bound, "weights and all by 2^{power}");
        let far = points.map(|x| x * scale);
        let far: Form = Form::from_points(&[4], 2, &far, Some(&weights)).unwrap();
        assert_eq!(reduce(&far, &[1]).unwrap().bound, bound * scale, "points by 2^{power}");
    }
}

#[test]
fn weights_of_both_signs_reduce_where_the_weight_has_no_zero() {
    let points = [0., 0., 1., 1., 2., 0.];
    let positive: Form = Form::from_points(&[3], 2, &points, Some(&[1., -0.5, 1.])).unwrap();
    let reduction = reduce(&elevate(&positive, &[2]).unwrap(), &[2]).unwrap();
    assert!(reduction.bound < 1e-11, "{}", reduction.bound);
    let zero_inside: Form = Form::from_points(&[3], 2, &points, Some(&[1., -1., 1.])).unwrap();
    let error = reduce(&zero_inside, &[1]).unwrap_err();
    assert!(error.to_string().contains("vanishes in the window"), "{error}");
}
