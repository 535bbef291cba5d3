//! One point, many points, derivatives: all the same answers.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{
    Dual, Form, Rational, Scalar, bernstein_row, binomial, pascal_row, taylor_rows,
};
use pforms_testkit::{Random, Weights};

#[test]
fn bernstein_polynomials_are_a_partition_of_unity_with_the_known_values() {
    let mut random = Random::new(1);
    for degree in 0..=12 {
        let t: Rational = random.fraction();
        let row = bernstein_row(degree, &t);
        let one = <Rational as Scalar>::one();
        let sum = row.iter().fold(<Rational as Scalar>::zero(), |sum, b| sum + b);
        assert_eq!(sum, one);
        for (i, b) in row.iter().enumerate() {
            let s = one.clone() - t.clone();
            let known = binomial::<Rational>(degree, i) * t.power(i) * s.power(degree - i);
            assert_eq!(*b, known);
        }
    }
}

#[test]
fn rows_of_pascal() {
    assert_eq!(pascal_row::<f64>(5), [1., 5., 10., 10., 5., 1.]);
    assert_eq!(binomial::<f64>(56, 28), 7_648_690_600_760_440.0);
    assert_eq!(binomial::<f64>(3, 4), 0.0);
}

#[test]
fn taylor_rows_rebuild_the_polynomial() {
    let mut random = Random::new(2);
    let f: Form<Rational> = random.form(&[6], 1, Weights::One);
    let (t, h): (Rational, Rational) = (random.fraction(), random.fraction());
    let local = f.along(0, &taylor_rows(5, 7, &t)).unwrap();
    let series = local.homogeneous().chunks(2).enumerate();
    let value =
        series.fold(<Rational as Scalar>::zero(), |sum, (r, x)| sum + x[0].clone() * h.power(r));
    assert_eq!(value, f.homogeneous_at(&[t + h]).unwrap()[0]);
}

#[test]
fn grids_and_batches_agree_with_single_points() {
    for (axes, ambient) in [(0, 3), (1, 1), (1, 2), (2, 3), (3, 2), (4, 4)] {
        let mut random = Random::new(axes as u64);
        let orders = random.orders(axes, 5);
        let f = random.rough_form(&orders, ambient, Weights::Positive);
        let lists: Vec<Vec<f64>> =
            (0..axes).map(|axis| (0..axis + 2).map(|_| random.unit()).collect()).collect();
        let borrowed: Vec<&[f64]> = lists.iter().map(Vec::as_slice).collect();
        let grid = f.grid(&borrowed).unwrap();
        let mut index = vec![0; axes];
        for point in grid.chunks(ambient) {
            let at: Vec<f64> = (0..axes).map(|axis| lists[axis][index[axis]]).collect();
            let single = f.at(&at).unwrap();
            let same: Vec<&[f64]> = at.iter().map(std::slice::from_ref).collect();
            let batch = f.scattered(&same).unwrap();
            for k in 0..ambient {
                assert!((single[k] - point[k]).abs() <= 16.0 * f64::EPSILON, "grid");
                assert!((single[k] - batch[k]).abs() <= 16.0 * f64::EPSILON, "batch");
            }
            advance(&mut index, &lists);
        }
    }
}

fn advance(index: &mut [usize], lists: &[Vec<f64>]) {
    for axis in (0..index.len()).rev() {
        index[axis] += 1;
        if index[axis] < lists[axis].len() {
            return;
        }
        index[axis] = 0;
    }
}

#[test]
fn blocks_of_lanes_agree_with_single_points() {
    for (axes, ambient) in [(1, 1), (1, 3), (2, 2), (2, 3), (3, 3), (3, 4), (4, 3), (2, 6)] {
        let mut random = Random::new(axes as u64 + 10);
        let orders = random.orders(axes, 5);
        let f = random.rough_form(&orders, ambient, Weights::Positive);
        let lists: Vec<Vec<f64>> =
            (0..axes).map(|_| (0..21).map(|_| random.unit()).collect()).collect();
        let borrowed: Vec<&[f64]> = lists.iter().map(Vec::as_slice).collect();
        let batch = f.scattered(&borrowed).unwrap();
        for (i, point) in batch.chunks(ambient).enumerate() {
            let at: Vec<f64> = lists.iter().map(|list| list[i]).collect();
            for (x, y) in f.at(&at).unwrap().iter().zip(point) {
                assert!((x - y).abs() <= 16.0 * f64::EPSILON, "{} in {ambient}D", f.kind());
            }
        }
    }
    // A weight that vanishes in any lane is an error of the batch.
    let f = Form::from_points(&[2], 1, &[1.0, 1.0], Some(&[1.0, -1.0])).unwrap();
    let mut list = [0.25; 16];
    assert!(f.scattered(&[&list]).is_ok());
    list[11] = 0.5;
    assert_eq!(f.scattered(&[&list]).unwrap_err().family(), "Domain");
}

#[test]
fn wrong_batches_are_refused() {
    let f = Random::new(3).rough_form(&[3, 3], 3, Weights::One);
    let mut out = [0.0; 5];
    for error in [
        f.grid(&[&[0.5]]).unwrap_err(),
        f.scattered(&[&[0.5], &[0.5, 0.5]]).unwrap_err(),
        f.grid_into(&[&[0.5], &[0.5]], &mut out).unwrap_err(),
        f.at(&[0.5]).unwrap_err(),
        f.derivative_at(&[0.5, 0.5], &[1]).unwrap_err(),
    ] {
        assert_eq!(error.family(), "Shape");
    }
    for error in [
        f.grid(&[&[0.5], &[f64::NAN]]).unwrap_err(),
        f.scattered(&[&[f64::INFINITY], &[0.5]]).unwrap_err(),
        f.at(&[0.5, f64::NAN]).unwrap_err(),
    ] {
        assert_eq!(error.family(), "Domain");
    }
    assert!(f.grid(&[&[], &[0.5]]).unwrap().is_empty());
}

#[test]
fn derivatives_in_bulk_are_those_of_single_points() {
    let mut random = Random::new(4);
    let f = random.rough_form(&[4, 3], 3, Weights::Positive);
    let (u, v) = ([0.1, 0.7, 1.0], [0.0, 0.4, 0.9]);
    let mut out = [0.0; 9];
    f.scattered_derivative_into(&[&u, &v], &[1, 1], &mut out).unwrap();
    for i in 0..3 {
        let single = f.derivative_at(&[u[i], v[i]], &[1, 1]).unwrap();
        for k in 0..3 {
            // A few roundings of numbers below 100.
            assert!((out[3 * i + k] - single[k]).abs() <= 1e4 * f64::EPSILON);
        }
    }
}

/// The derivative of a rational point with respect to its parameter, three ways.
#[test]
fn dual_numbers_differentiate_exactly() {
    let mut random = Random::new(5);
    for _ in 0..20 {
        let f: Form<Rational> = random.form(&[3, 2], 2, Weights::Positive);
        let at = random.parameters::<Rational>(2);
        let dual = f.map_scalar(|x| Dual::constant(x.clone())).unwrap();
        let moving = Dual { value: at[0].clone(), slope: Scalar::one() };
        let point = dual.at(&[moving, Dual::constant(at[1].clone())]).unwrap();
        let slopes: Vec<Rational> = point.into_iter().map(|x| x.slope).collect();
        assert_eq!(slopes, f.derivative_at(&at, &[1, 0]).unwrap());
    }
}

#[test]
fn evaluation_at_high_degree_keeps_its_stated_bound() {
    let mut random = Random::new(6);
    for degree in [5, 17, 30] {
        let f = random.rough_form(&[degree + 1], 1, Weights::One);
        let exact = f.exact().unwrap();
        for _ in 0..10 {
            let t = random.unit();
            let computed = f.homogeneous_at(&[t]).unwrap()[0];
            let t = <Rational as Scalar>::from_f64(t).unwrap();
            let expected = exact.homogeneous_at(&[t]).unwrap()[0].to_f64();
            let bound = (2 * degree + 1) as f64 * f64::EPSILON;
            assert!((computed - expected).abs() <= bound, "{computed} for {expected}");
        }
    }
}

/// Far outside the window the basis adds up to 1 only after cancellation: the weight of a
/// polynomial form must not be taken from that sum.
#[test]
fn far_outside_the_window_a_polynomial_form_keeps_its_weight() {
    let parabola: Form = Form::from_points(&[3], 2, &[0., 0., 1., 2., 2., 0.], None).unwrap();
    for t in [1e8, -3e9, 1e12, 1e100] {
        let exact = [2.0 * t, 4.0 * t * (1.0 - t)];
        let list = [t; 9];
        let everywhere = [
            parabola.at(&[t]).unwrap(),
            parabola.grid(&[&list]).unwrap(),
            parabola.scattered(&[&list]).unwrap(),
        ];
        for point in everywhere.iter().flat_map(|points| points.chunks_exact(2)) {
            for (x, y) in point.iter().zip(exact) {
                assert!((x - y).abs() <= 8.0 * f64::EPSILON * t * t, "{t}: {x} for {y}");
            }
        }
        let mut fall = [0.0; 2];
        parabola.scattered_derivative_into(&[&[t]], &[2], &mut fall).unwrap();
        assert_eq!(fall.to_vec(), parabola.derivative_at(&[t], &[2]).unwrap());
        assert_eq!(fall, [0.0, -8.0]);
    }
}

#[test]
fn a_point_beyond_the_largest_number_is_refused() {
    for weights in [None, Some(&[1.0, -0.5, 1.0][..])] {
        let f: Form = Form::from_points(&[3], 2, &[0., 0., 1., 2., 2., 0.], weights).unwrap();
        let list = [1e200; 9];
        let mut slope = [0.0; 18];
        let refusals = [
            f.at(&[1e200]).unwrap_err(),
            f.grid(&[&list]).unwrap_err(),
            f.scattered(&[&list]).unwrap_err(),
            f.scattered(&[&list[..1]]).unwrap_err(),
        ];
        for error in refusals {
            assert!(error.to_string().contains("beyond the largest"), "{error}");
        }
        assert!(f.scattered_derivative_into(&[&list], &[0], &mut slope).is_err());
    }
    let circle: Form =
        Form::from_points(&[3], 2, &[1., 0., 1., 1., 0., 1.], Some(&[1., 0.5, 1.])).unwrap();
    assert!(circle.derivative_at(&[0.3], &[200]).is_err());
}
