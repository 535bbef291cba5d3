//! Tangents and normals that are forms: exact laws.
#![allow(clippy::unwrap_used)]

use pforms_kernel::{Form, Rational, Scalar};
use pforms_operators::{binormal_form, normal_form, tangent_form};

fn random(seed: i64, orders: &[usize], ambient: usize, rational: bool) -> Form<Rational> {
    let count: usize = orders.iter().product();
    let number = |k: i64| Rational::ratio((k * k * 7 + k * 13 + seed * 31) % 97 - 48, 16);
    let points: Vec<Rational> = (0..(count * ambient) as i64).map(number).collect();
    let weight = |k: i64| Rational::ratio(if rational { (k * 5 + seed) % 7 + 3 } else { 6 }, 4);
    let weights: Vec<Rational> = (0..count as i64).map(weight).collect();
    Form::from_points(orders, ambient, &points, Some(&weights)).unwrap()
}

fn at() -> [Rational; 2] {
    [Rational::ratio(2, 7), Rational::ratio(-3, 5)]
}

fn cross(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    [(1, 2), (2, 0), (0, 1)].iter().map(|&(i, j)| &a[i] * &b[j] - &a[j] * &b[i]).collect()
}

fn times(vector: &[Rational], factor: &Rational) -> Vec<Rational> {
    vector.iter().map(|x| x * factor).collect()
}

#[test]
fn tangents_are_derivatives_times_the_square_of_the_weight() {
    for rational in [false, true] {
        for (orders, axis) in [(vec![5], 0), (vec![3, 4], 0), (vec![3, 4], 1), (vec![2, 1], 1)] {
            let form = random(1, &orders, 3, rational);
            let tangent = tangent_form(&form, axis).unwrap();
            let at = &at()[..orders.len()];
            let weight = form.homogeneous_at(at).unwrap().pop().unwrap();
            let mut order = vec![0; orders.len()];
            order[axis] = 1;
            let expected = times(&form.derivative_at(at, &order).unwrap(), &weight.power(2));
            assert_eq!(tangent.at(at).unwrap(), expected);
            assert!(tangent.weights().iter().all(|w| *w == Rational::one()));
        }
    }
}

#[test]
fn degrees_are_the_least_possible() {
    let kinds = |form: Form<Rational>| {
        (tangent_form(&form, 0).unwrap().degrees(), normal_form(&form).unwrap().degrees())
    };
    assert_eq!(kinds(random(2, &[4, 3], 3, true)), (vec![4, 4], vec![7, 4]));
    assert_eq!(kinds(random(2, &[4, 3], 3, false)), (vec![2, 2], vec![5, 3]));
    assert_eq!(kinds(random(2, &[5], 3, true)), (vec![6], vec![12]));
    assert_eq!(kinds(random(2, &[5], 3, false)), (vec![3], vec![8]));
    assert_eq!(kinds(random(2, &[5], 2, true)), (vec![6], vec![6]));
}

#[test]
fn normals_of_surfaces() {
    for rational in [false, true] {
        for orders in [[2, 2], [3, 4], [4, 2]] {
            let form = random(3, &orders, 3, rational);
            let weight = form.homogeneous_at(&at()).unwrap().pop().unwrap();
            let u = form.derivative_at(&at(), &[1, 0]).unwrap();
            let v = form.derivative_at(&at(), &[0, 1]).unwrap();
            let expected = times(&cross(&u, &v), &weight.power(3));
            assert_eq!(normal_form(&form).unwrap().at(&at()).unwrap(), expected);
        }
    }
}

#[test]
fn normals_and_binormals_of_curves() {
    for rational in [false, true] {
        for order in [2, 3, 4, 6] {
            let form = random(4, &[order], 3, rational);
            let at = &at()[..1];
            let weight = form.homogeneous_at(at).unwrap().pop().unwrap();
            let first = form.derivative_at(at, &[1]).unwrap();
            let area = cross(&first, &form.derivative_at(at, &[2]).unwrap());
            let binormal = binormal_form(&form).unwrap().at(at).unwrap();
            assert_eq!(binormal, times(&area, &weight.power(3)));
            let normal = normal_form(&form).unwrap().at(at).unwrap();
            assert_eq!(normal, times(&cross(&area, &first), &weight.power(5)));
        }
    }
    let plane = random(5, &[4], 2, true);
    let tangent = tangent_form(&plane, 0).unwrap().at(&at()[..1]).unwrap();
    let normal = normal_form(&plane).unwrap().at(&at()[..1]).unwrap();
    assert_eq!(normal, [-tangent[1].clone(), tangent[0].clone()]);
}

#[test]
fn the_tip_of_the_tangent_runs_on_a_form() {
    // Book 326: on a curve of order n, the ends of its tangents make a curve of order n.
    let curve = random(6, &[4], 3, false);
    assert_eq!(tangent_form(&curve, 0).unwrap().kind().to_string(), "pL3");
}

#[test]
fn points_at_infinity_everywhere_do_no_harm() {
    let directions = Form::from_homogeneous(
        &[3],
        3,
        [1, 2, 3, 0].repeat(3).into_iter().map(<Rational as Scalar>::from_integer).collect(),
    );
    let directions = directions.unwrap();
    assert!(tangent_form(&directions, 0).is_ok() && normal_form(&directions).is_ok());
}

#[test]
fn refusals() {
    assert_eq!(tangent_form(&random(7, &[3], 2, true), 1).unwrap_err().family(), "Shape");
    assert_eq!(normal_form(&random(7, &[2, 2], 4, true)).unwrap_err().family(), "Shape");
    assert_eq!(binormal_form(&random(7, &[3], 2, true)).unwrap_err().family(), "Shape");
}
