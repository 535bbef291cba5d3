//! Least squares against laws and exact arithmetic.
#![allow(clippy::unwrap_used)]

mod common;

use common::{distance, family};
use pforms_kernel::{Form, Rational, Scalar, bernstein_row};
use pforms_operators::{Fit, FitOptions, Nodes, Parameters, fit, interpolate};

/// A reproducible sequence of numbers in `[−1, 1]`.
fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 44) as f64 / f64::from(1 << 19) - 1.0
    }
}

fn random_form(seed: u64, orders: &[usize], ambient: usize) -> Form {
    let mut next = noise(seed);
    let count = orders.iter().product::<usize>() * ambient;
    let points: Vec<f64> = (0..count).map(|_| next()).collect();
    Form::from_points(orders, ambient, &points, None).unwrap()
}

fn spaced(count: usize) -> Vec<f64> {
    (0..count).map(|i| i as f64 / (count - 1) as f64).collect()
}

fn uniform(orders: &[usize]) -> FitOptions {
    FitOptions { parameters: Parameters::Uniform, ..FitOptions::new(orders) }
}

fn samples(form: &Form, counts: &[usize]) -> (Vec<f64>, Vec<usize>) {
    let lists: Vec<Vec<f64>> = counts.iter().map(|&count| spaced(count)).collect();
    let views: Vec<&[f64]> = lists.iter().map(Vec::as_slice).collect();
    let shape = counts.iter().copied().chain([form.ambient()]).collect();
    (form.grid(&views).unwrap(), shape)
}

fn assert_same(fitted: &Fit, form: &Form, bound: f64) {
    let gap = distance(fitted.form.homogeneous(), form.homogeneous());
    assert!(gap < bound, "{gap}");
    assert!(fitted.max_error < bound && fitted.rms_error <= fitted.max_error);
}

#[test]
fn samples_of_a_form_give_it_back() {
    for (orders, counts) in
        [(vec![6], vec![25]), (vec![3, 4], vec![7, 9]), (vec![2, 3, 4], vec![5, 5, 6])]
    {
        let form = random_form(1, &orders, 3);
        let (points, shape) = samples(&form, &counts);
        assert_same(&fit(&points, &shape, &uniform(&orders)).unwrap(), &form, 1e-13);
        let ends = FitOptions { ends: true, ..uniform(&orders) };
        assert_same(&fit(&points, &shape, &ends).unwrap(), &form, 1e-13);
    }
}

#[test]
fn scattered_points_give_it_back() {
    for orders in [vec![3, 4], vec![2, 3, 2]] {
        let form = random_form(2, &orders, 3);
        let mut next = noise(9);
        let lists: Vec<Vec<f64>> =
            orders.iter().map(|_| (0..60).map(|_| f64::midpoint(next(), 1.0)).collect()).collect();
        let views: Vec<&[f64]> = lists.iter().map(Vec::as_slice).collect();
        let points = form.scattered(&views).unwrap();
        let options =
            FitOptions { parameters: Parameters::Given(lists), ..FitOptions::new(&orders) };
        assert_same(&fit(&points, &[60, 3], &options).unwrap(), &form, 1e-12);
    }
}

#[test]
fn as_many_points_as_poles_is_interpolation() {
    let net = random_form(3, &[5, 4], 3);
    let fitted = fit(&net.points().unwrap(), &[5, 4, 3], &uniform(&[5, 4])).unwrap();
    assert_same(
        &Fit { max_error: 0.0, rms_error: 0.0, ..fitted },
        &interpolate(&net, &Nodes::Uniform).unwrap(),
        1e-13,
    );
}

/// The poles that make `Σ w·|f(t_i) − q_i|²` least, exactly, by the normal equations.
fn exact_fit(parameters: &[f64], values: &[f64], weights: &[f64], order: usize) -> Vec<Rational> {
    let exactly = |x: &f64| Rational::from_f64(*x).unwrap();
    let mut system = vec![vec![Rational::zero(); order + 1]; order];
    for ((t, q), w) in parameters.iter().zip(values).zip(weights) {
        let row = bernstein_row(order - 1, &exactly(t));
        for (i, line) in system.iter_mut().enumerate() {
            for (j, entry) in line.iter_mut().enumerate() {
                let right = if j < order { row[j].clone() } else { exactly(q) };
                *entry += exactly(w) * &row[i] * right;
            }
        }
    }
    for i in 0..order {
        let pivot = system[i][i].clone();
        system[i].iter_mut().for_each(|x| *x /= &pivot);
        let chosen = system[i].clone();
        for (k, line) in system.iter_mut().enumerate() {
            if k != i {
                let factor = line[i].clone();
                line.iter_mut().zip(&chosen).for_each(|(x, y)| *x -= &factor * y);
            }
        }
    }
    system.iter().map(|line| line[order].clone()).collect()
}

#[test]
fn agrees_with_exact_arithmetic() {
    for (order, weighted) in [(4, false), (8, true), (12, false)] {
        let mut next = noise(order as u64);
        let parameters: Vec<f64> = (0..=32).map(|i| f64::from(i) / 32.0).collect();
        let values: Vec<f64> = parameters.iter().map(|_| next()).collect();
        let weights: Vec<f64> =
            parameters.iter().map(|_| if weighted { next() + 2.0 } else { 1.0 }).collect();
        let options =
            FitOptions { weights: weighted.then(|| weights.clone()), ..uniform(&[order]) };
        let fitted = fit(&values, &[33, 1], &options).unwrap().form.points().unwrap();
        let exact = exact_fit(&parameters, &values, &weights, order);
        let size = exact.iter().fold(0.0_f64, |size, x| size.max(x.to_f64().abs()));
        let errors = fitted.iter().zip(&exact).map(|(a, b)| (a - b.to_f64()).abs() / size);
        let worst = errors.fold(0.0, f64::max);
        println!("order {order}: {worst:.1e}");
        // The condition of the Bernstein matrix doubles with each order.
        assert!(worst < 1e-15 * 2.0_f64.powi(order as i32));
    }
}

#[test]
fn a_weighted_grid_with_equal_weights_is_a_grid() {
    let mut next = noise(5);
    let points: Vec<f64> = (0..6 * 7 * 3).map(|_| next()).collect();
    let plain = fit(&points, &[6, 7, 3], &uniform(&[3, 4])).unwrap();
    let weights = Some(vec![4.0; 42]);
    let weighted = fit(&points, &[6, 7, 3], &FitOptions { weights, ..uniform(&[3, 4]) }).unwrap();
    assert!(distance(plain.form.homogeneous(), weighted.form.homogeneous()) < 1e-13);
    assert!(plain.max_error > plain.rms_error && plain.rms_error > 0.0);
}

#[test]
fn fixed_ends_are_exact() {
    let mut next = noise(6);
    let points: Vec<f64> = (0..20 * 2).map(|_| next()).collect();
    for parameters in [Parameters::Uniform, Parameters::Chord, Parameters::Centripetal] {
        let options = FitOptions { parameters, ends: true, ..FitOptions::new(&[6]) };
        let fitted = fit(&points, &[20, 2], &options).unwrap();
        let poles = fitted.form.points().unwrap();
        assert_eq!((&poles[..2], &poles[10..]), (&points[..2], &points[38..]));
    }
}

#[test]
fn an_order_of_one_is_the_mean() {
    let fitted = fit(&[1.0, 2.0, 6.0], &[3, 1], &uniform(&[1])).unwrap();
    assert!((fitted.form.points().unwrap()[0] - 3.0).abs() < 1e-15);
}

#[test]
fn bad_data_are_named() {
    let fails =
        |points: &[f64], shape: &[usize], options: &FitOptions| family(fit(points, shape, options));
    let ten = spaced(10);
    assert_eq!(fails(&ten, &[5, 2], &uniform(&[6])), "Degenerate");
    assert_eq!(
        fit(&ten, &[5, 2], &uniform(&[6])).unwrap_err().to_string(),
        "points: received 5 points for 6 poles along axis 0, expected at least as many points as poles"
    );
    let mut broken = ten.clone();
    broken[3] = f64::NAN;
    assert_eq!(fails(&broken, &[5, 2], &uniform(&[3])), "Domain");
    assert_eq!(fails(&ten, &[4, 2], &uniform(&[3])), "Shape");
    assert_eq!(fails(&ten, &[10], &uniform(&[3])), "Shape");
    assert_eq!(fails(&[], &[0, 2], &uniform(&[3])), "Shape");
    assert_eq!(fails(&ten, &[5, 2], &uniform(&[2, 2])), "Shape");
    assert_eq!(fails(&ten, &[5, 2], &uniform(&[0])), "Shape");
    let same =
        FitOptions { parameters: Parameters::Given(vec![vec![0.5; 5]]), ..FitOptions::new(&[3]) };
    assert_eq!(fails(&ten, &[5, 2], &same), "Degenerate");
    let negative = FitOptions { weights: Some(vec![-1.0; 5]), ..uniform(&[3]) };
    assert_eq!(fails(&ten, &[5, 2], &negative), "Domain");
    let coincident = FitOptions::new(&[3]);
    assert_eq!(fails(&[1.0; 10], &[5, 2], &coincident), "Degenerate");
    let late = FitOptions {
        parameters: Parameters::Given(vec![vec![0.1, 0.2, 0.3, 0.4, 1.0]]),
        ends: true,
        ..FitOptions::new(&[3])
    };
    assert_eq!(fails(&ten, &[5, 2], &late), "Domain");
}
