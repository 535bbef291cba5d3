//! How far `f64` is from exact arithmetic: every operator's stated bound, up to degree 30.
//!
//! Bounds are relative to the largest pole, in units of `f64::EPSILON`. They follow from counting
//! roundings in sums of positive coefficients that add up to 1; outside the window they grow with
//! the extrapolation, as `stretch` states.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Form, Rational, Scalar};
use pforms_operators::{diagonal, elevate, immerse, split, stretch, sub, subdivide};
use pforms_testkit::{Random, Weights, relative_error};

const DEGREES: [usize; 5] = [1, 3, 8, 19, 30];

fn exact(form: &Form) -> Form<Rational> {
    form.exact().unwrap()
}

fn exact_number(x: f64) -> Rational {
    Scalar::from_f64(x).unwrap()
}

fn assert_close(computed: &Form, expected: &Form<Rational>, epsilons: f64, what: &str) {
    let error = relative_error(computed, expected).unwrap() / f64::EPSILON;
    assert!(error <= epsilons, "{what}: {error} eps, at most {epsilons} stated");
}

#[test]
fn evaluation_and_sub_forms() {
    for (seed, degree) in DEGREES.into_iter().enumerate() {
        let mut random = Random::new(seed as u64);
        let f = random.rough_form(&[degree + 1, degree + 1], 2, Weights::Positive);
        for _ in 0..4 {
            let (u, v) = (random.unit(), random.unit());
            let row = sub(&f, 0, &u).unwrap();
            let exact_row = sub(&exact(&f), 0, &exact_number(u)).unwrap();
            assert_close(&row, &exact_row, (2 * degree + 1) as f64, "sub");
            let point = Form::from_homogeneous(&[], 2, f.homogeneous_at(&[u, v]).unwrap());
            let exact_point = sub(&exact_row, 0, &exact_number(v)).unwrap();
            let bound = (4 * degree + 2) as f64 / smallness(&exact_point, &f);
            assert_close(&point.unwrap(), &exact_point, bound, "at");
        }
    }
}

/// Size of a point relative to the largest pole: bounds are relative to the latter.
fn smallness(point: &Form<Rational>, form: &Form) -> f64 {
    let largest = |list: Vec<f64>| list.into_iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let poles = largest(form.homogeneous().to_vec());
    largest(point.homogeneous().iter().map(Scalar::to_f64).collect()) / poles
}

#[test]
fn elevation_subdivision_stretching_and_splitting() {
    for (seed, degree) in DEGREES.into_iter().enumerate() {
        let mut random = Random::new(seed as u64 + 100);
        let f = random.rough_form(&[degree + 1, 2], 2, Weights::Positive);
        let by = [random.size(1, 30), 1];
        let raised = elevate(&f, &by).unwrap();
        assert_close(&raised, &elevate(&exact(&f), &by).unwrap(), 16.0, "elevate");

        let refined = subdivide(&f, &[2, 1]).unwrap();
        let exact_refined = subdivide(&exact(&f), &[2, 1]).unwrap();
        let bound = (3 * degree + 3) as f64;
        assert_close(refined.net(), exact_refined.net(), bound, "subdivide");

        let (a, b) = ([random.unit(), 0.0], [random.unit(), 1.0]);
        let window = stretch(&f, &a, &b).unwrap();
        let exact_window = stretch(&exact(&f), &a.map(exact_number), &b.map(exact_number)).unwrap();
        let bound = (2 * degree + 2) as f64 / smallness(&exact_window, &f);
        assert_close(&window, &exact_window, bound, "stretch");

        let t = random.unit();
        let (low, high) = split(&f, 0, &t).unwrap();
        let (exact_low, exact_high) = split(&exact(&f), 0, &exact_number(t)).unwrap();
        assert_close(&low, &exact_low, bound, "split, low");
        assert_close(&high, &exact_high, bound / smallness(&exact_high, &f), "split, high");
    }
}

/// Two ways to the same triangle: a half of a sum is the sum of the halves, to the bit.
#[test]
fn halves_are_the_parts_at_one_half_to_the_bit() {
    for (seed, order) in [2, 5, 60, 400].into_iter().enumerate() {
        let mut random = Random::new(seed as u64 + 600);
        let f = random.rough_form(&[order, 2], 2, Weights::Positive);
        let refined = subdivide(&f, &[1, 0]).unwrap();
        let (low, high) = split(&f, 0, &0.5).unwrap();
        assert_eq!(refined.pieces().unwrap(), [low.clone(), high]);
        let quarters = subdivide(&f, &[2, 0]).unwrap();
        assert_eq!(quarters.piece(&[0, 0]).unwrap(), split(&low, 0, &0.5).unwrap().0);
    }
}

#[test]
fn extrapolation_is_as_good_as_its_growth_allows() {
    for (seed, degree) in [1, 3, 8, 19].into_iter().enumerate() {
        let mut random = Random::new(seed as u64 + 200);
        let f = random.rough_form(&[degree + 1], 2, Weights::Positive);
        let (a, b) = (-0.25, 1.5);
        let growth = ((1.25_f64 + 0.25) * (0.5 + 1.5)).powi(degree as i32);
        let computed = stretch(&f, &[a], &[b]).unwrap();
        let expected = stretch(&exact(&f), &[exact_number(a)], &[exact_number(b)]).unwrap();
        let bound = (2 * degree + 2) as f64 * growth / smallness(&expected, &f);
        assert_close(&computed, &expected, bound, "stretch outside");
    }
}

#[test]
fn diagonals() {
    for (seed, degree) in DEGREES.into_iter().enumerate() {
        let mut random = Random::new(seed as u64 + 300);
        let f = random.rough_form(&[degree + 1, degree + 1], 3, Weights::Positive);
        let expected = diagonal(&exact(&f), 0, 1).unwrap();
        let bound = (degree + 6) as f64;
        assert_close(&diagonal(&f, 0, 1).unwrap(), &expected, bound, "diagonal");
    }
}

/// The form with numbers of 12 bits: its exact immersion takes a second, not a minute.
fn short(form: &Form) -> Form {
    form.map_scalar(|x| (x * 4096.0).round() / 4096.0).unwrap()
}

#[test]
fn immersion_keeps_13_digits_up_to_degree_27() {
    let cases: [(&[usize], &[usize]); 7] = [
        (&[4], &[10]),
        (&[4], &[4, 4]),
        (&[4], &[4, 4, 4]),
        (&[10], &[2, 2, 2]),
        (&[4, 4], &[4, 4]),
        (&[4, 4], &[4, 4, 4]),
        (&[2, 2, 2], &[4, 4, 4]),
    ];
    for (seed, (inner, host)) in cases.into_iter().enumerate() {
        for weights in [Weights::One, Weights::Positive] {
            let mut random = Random::new(seed as u64 + 400);
            let host = short(&random.rough_form(host, 3, weights));
            let rough = random.rough_form(inner, host.axes(), weights);
            let inner = short(&rough.map_scalar(|x| x.abs()).unwrap());
            let computed = immerse(&inner, &host).unwrap();
            let expected = immerse(&exact(&inner), &exact(&host)).unwrap();
            let error = relative_error(&computed, &expected).unwrap();
            assert!(error <= 1e-13, "{} in {}: {error:e}", inner.kind(), host.kind());
        }
    }
}

#[test]
fn a_power_of_two_changes_no_bit() {
    let mut random = Random::new(500);
    let f = random.rough_form(&[5, 4], 3, Weights::Positive);
    let scale = 2.0_f64.powi(300);
    let scaled = |g: &Form| g.map_scalar(|x| x * scale).unwrap();
    let g = scaled(&f);
    assert_eq!(diagonal(&g, 0, 1).unwrap(), scaled(&diagonal(&f, 0, 1).unwrap()));
    assert_eq!(elevate(&g, &[3, 2]).unwrap(), scaled(&elevate(&f, &[3, 2]).unwrap()));
    assert_eq!(sub(&g, 1, &0.3).unwrap(), scaled(&sub(&f, 1, &0.3).unwrap()));
    let line = random.rough_form(&[3], 2, Weights::Positive);
    assert_eq!(immerse(&line, &g).unwrap(), scaled(&immerse(&line, &f).unwrap()));
}
