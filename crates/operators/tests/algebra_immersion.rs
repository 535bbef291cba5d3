//! The immersion theorem, which the book leaves unproved, and what follows from it: in exact
//! arithmetic, with `==`.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use std::slice;

use pforms_kernel::{Error, Form, Rational, Scalar, Scaled, limit};
use pforms_operators::{
    Immersed, diagonal, elevate, forecast, immerse, immerse_points, polyline, segment, stack,
    stretch, sub, tile,
};
use pforms_testkit::{Random, Weights, relative_error};

type Exact = Form<Rational>;

fn integer(x: i64) -> Rational {
    Scalar::from_integer(x)
}

/// A random inner form (1 to 3 axes) and a host (1 to 4 axes) whose composition stays small.
fn pair(random: &mut Random) -> (Exact, Exact) {
    loop {
        let (inner_axes, host_axes) = (random.size(1, 3), random.size(1, 4));
        let inner_orders = random.orders(inner_axes, 3);
        let host_orders = random.orders(host_axes, 3);
        let ambient = random.size(1, 3);
        if forecast::<Rational>(&inner_orders, &host_orders, ambient).poles > 500 {
            continue;
        }
        let kinds = [Weights::One, Weights::Positive, Weights::Any];
        let (inside, outside) = (kinds[random.size(0, 1)], kinds[random.size(0, 2)]);
        let inner = random.inner_form(&inner_orders, host_axes, inside);
        let host = random.form(&host_orders, ambient, outside);
        return (inner, host);
    }
}

/// Parameters that decide a polynomial of the given orders: as many different numbers on each
/// axis as it has poles there.
fn unisolvent(orders: &[usize]) -> Vec<Vec<Rational>> {
    let mut grid = vec![Vec::new()];
    for &order in orders {
        grid = grid
            .iter()
            .flat_map(|prefix: &Vec<Rational>| {
                (0..order).map(move |i| {
                    let mut at = prefix.clone();
                    at.push(Rational::ratio(i as i64, order as i64));
                    at
                })
            })
            .collect();
    }
    grid
}

/// `host(inner(t))` in homogeneous coordinates: the product of the inner weight to the power of
/// the host's total degree and the host's homogeneous point.
fn composed_at(inner: &Exact, host: &Exact, t: &[Rational]) -> Option<Vec<Rational>> {
    let inside = inner.homogeneous_at(t).unwrap();
    let weight = &inside[inner.ambient()];
    if Scalar::is_zero(weight) {
        return None;
    }
    let at: Vec<Rational> = inside[..host.axes()].iter().map(|x| x / weight).collect();
    let degree = host.degrees().iter().sum();
    let scale = weight.power(degree);
    let point = host.homogeneous_at(&at).unwrap();
    Some(point.into_iter().map(|x| x * scale.clone()).collect())
}

fn assert_composition(result: &Exact, inner: &Exact, host: &Exact) {
    for t in unisolvent(result.orders()) {
        if let Some(expected) = composed_at(inner, host, &t) {
            assert_eq!(result.homogeneous_at(&t).unwrap(), expected);
        }
    }
}

#[test]
fn the_immersed_form_is_the_composition_and_has_the_orders_of_the_formula() {
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let (inner, host) = pair(&mut random);
        let result = immerse(&inner, &host).unwrap();
        let degree: usize = host.degrees().iter().sum();
        let formula: Vec<usize> = inner.degrees().iter().map(|q| degree * q + 1).collect();
        assert_eq!(result.orders(), formula);
        assert_composition(&result, &inner, &host);
    }
}

#[test]
fn the_orders_are_attained_by_generic_forms() {
    let mut random = Random::new(7);
    let host: Exact = random.form(&[3, 3], 1, Weights::One);
    let inner: Exact = random.inner_form(&[3], 2, Weights::One);
    let result = immerse(&inner, &host).unwrap();
    let top = pforms_operators::derivative(&result, &[8]).unwrap();
    assert_ne!(top.points().unwrap(), [integer(0)]);
}

#[test]
fn immersion_is_associative_and_commutes_with_the_other_operators() {
    for seed in 0..12 {
        let mut random = Random::new(seed);
        let curve: Exact = random.inner_form(&[2], 2, Weights::Positive);
        let surface: Exact = random.inner_form(&[2, 3], 2, Weights::One);
        let host: Exact = random.form(&[2, 2], 3, Weights::Positive);
        assert_eq!(
            immerse(&immerse(&curve, &surface).unwrap(), &host).unwrap(),
            immerse(&curve, &immerse(&surface, &host).unwrap()).unwrap()
        );
        let window = [Rational::ratio(-1, 3)];
        let end = [Rational::ratio(5, 4)];
        assert_eq!(
            immerse(&stretch(&curve, &window, &end).unwrap(), &host).unwrap(),
            stretch(&immerse(&curve, &host).unwrap(), &window, &end).unwrap()
        );
        assert_eq!(
            immerse(&curve, &elevate(&host, &[1, 0]).unwrap()).unwrap().at(&end).ok(),
            immerse(&curve, &host).unwrap().at(&end).ok()
        );
    }
}

#[test]
fn the_diagonal_is_the_immersed_diagonal_segment() {
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let orders = random.orders(2, 4);
        let host: Exact = random.form(&orders, 3, Weights::Positive);
        let across = segment(&host, &[integer(0), integer(0)], &[integer(1), integer(1)]).unwrap();
        assert_eq!(across, diagonal(&host, 0, 1).unwrap());
        let v = Rational::ratio(2, 7);
        let along = segment(&host, &[integer(0), v.clone()], &[integer(1), v.clone()]).unwrap();
        let by = [host.degrees()[1]];
        assert_eq!(along, elevate(&sub(&host, 1, &v).unwrap(), &by).unwrap());
    }
}

/// A quarter circle from (1, 0) to (0, 1): `(1 − t², 2t) / (1 + t²)`, and its angle's half in `t`.
fn quarter(x: &[i64; 3], y: &[i64; 3], z: &[i64; 3], w: &[i64; 3]) -> Exact {
    let poles = (0..3).flat_map(|i| [x[i], y[i], z[i], w[i]].map(integer));
    Form::from_homogeneous(&[3], 3, poles.collect()).unwrap()
}

const COSINE: [i64; 3] = [1, 1, 0];
const SINE: [i64; 3] = [0, 1, 2];
const ONE: [i64; 3] = [1, 1, 2];

/// The octant of the unit sphere `(cos a cos b, sin a cos b, sin b)`, `a` on axis 1, `b` on axis 0,
/// as MIR of three quarter circles.
fn octant() -> Exact {
    let rows: Vec<Exact> = (0..3)
        .map(|i| {
            let scaled = |list: &[i64; 3], k: i64| list.map(|x| x * k);
            quarter(
                &scaled(&COSINE, COSINE[i]),
                &scaled(&SINE, COSINE[i]),
                &scaled(&ONE, SINE[i]),
                &scaled(&ONE, ONE[i]),
            )
        })
        .collect();
    stack(&rows.iter().collect::<Vec<_>>()).unwrap()
}

#[test]
fn three_constructions_of_the_arc_of_viviani_agree() {
    let sphere = octant();
    let by_diagonal = diagonal(&sphere, 0, 1).unwrap();
    let by_segment =
        segment(&sphere, &[integer(0), integer(0)], &[integer(1), integer(1)]).unwrap();
    let scaled = |list: &[i64; 3]| {
        let poles = list.iter().flat_map(|&x| [integer(x), integer(1)]);
        let form: Exact = Form::from_homogeneous(&[3], 1, poles.collect()).unwrap();
        Scaled::from_form(&form).component(0)
    };
    let [c, s, w] = [scaled(&COSINE), scaled(&SINE), scaled(&ONE)];
    let product = |a: &Scaled<Rational>, b: &Scaled<Rational>| a.times(b).unwrap();
    let by_products = product(&c, &c)
        .beside(&product(&s, &c))
        .beside(&product(&s, &w))
        .beside(&product(&w, &w))
        .into_form()
        .unwrap();
    assert_eq!(by_diagonal.kind().to_string(), "pL5");
    assert_eq!(by_diagonal, by_segment);
    assert_eq!(by_diagonal, by_products);
    // On the sphere and on the cylinder (x − ½)² + y² = ¼.
    for i in 0..=8 {
        let point = by_diagonal.at(&[Rational::ratio(i, 8)]).unwrap();
        let [x, y, z] = [&point[0], &point[1], &point[2]];
        assert_eq!(x * x + y * y + z * z, integer(1));
        assert_eq!(x * x + y * y, *x);
    }
}

#[test]
fn a_lazy_immersion_has_the_points_and_derivatives_of_the_poles() {
    for seed in 0..12 {
        let mut random = Random::new(seed);
        let axes = random.size(1, 2);
        let orders = random.orders(axes, 3);
        let inner: Exact = random.inner_form(&orders, 2, Weights::Positive);
        let host: Exact = random.form(&[3, 2], 2, Weights::Positive);
        let lazy = Immersed::new(inner, host).unwrap();
        let expanded = lazy.expand().unwrap();
        assert_eq!(lazy.forecast().orders, expanded.orders());
        assert_eq!(lazy.forecast().poles, expanded.pole_count() as u128);
        let at = random.parameters::<Rational>(axes);
        assert_eq!(lazy.at(&at).unwrap(), expanded.at(&at).unwrap());
        for derivative in [vec![1; axes], vec![2; axes], vec![3; axes]] {
            assert_eq!(
                lazy.derivative_at(&at, &derivative).unwrap(),
                expanded.derivative_at(&at, &derivative).unwrap()
            );
        }
    }
    let line: Exact = Random::new(1).inner_form(&[3], 2, Weights::One);
    let host: Exact = Random::new(2).form(&[2, 2], 3, Weights::One);
    assert_eq!(Immersed::new(line, host).unwrap().kind(), "ipL3");
}

#[test]
fn polynomials_in_polynomials_keep_their_weight_to_the_bit() {
    let mut random = Random::new(3);
    let inner = random.rough_form(&[4], 2, Weights::One);
    let host = random.rough_form(&[5, 6], 3, Weights::One);
    let result = immerse(&inner, &host).unwrap();
    assert_eq!(result.uniform_weight(), Some(&1.0));
}

/// Every way through the counter: hosts without axes, with axes of one pole, with a last axis so
/// long that it is nested; inner points, curves, surfaces, volumes and beyond; wide poles.
#[test]
fn in_f64_it_is_what_it_is_in_fractions() {
    let cases: [(&[usize], &[usize], usize); 14] = [
        (&[3], &[], 2),
        (&[2, 2], &[1], 3),
        (&[], &[3, 2], 3),
        (&[1, 3], &[2, 3], 1),
        (&[5], &[7], 3),
        (&[3], &[1, 4, 1], 4),
        (&[2], &[3, 30], 2),
        (&[2, 2], &[2, 16], 3),
        (&[4, 2], &[3, 3], 5),
        (&[3, 4], &[4, 2], 7),
        (&[2, 2, 2], &[3, 3, 3], 3),
        (&[2, 3, 2], &[2, 3, 2], 2),
        (&[2, 2, 2, 2], &[2, 3], 3),
        (&[2, 2], &[2, 2, 2, 2, 2], 3),
    ];
    for (seed, (inner, host, ambient)) in cases.into_iter().enumerate() {
        for weights in [Weights::One, Weights::Positive] {
            let mut random = Random::new(seed as u64 + 800);
            let space = host.len().max(1);
            let inner: Exact = random.inner_form(inner, space, weights);
            let host: Exact = random.form(host, ambient, weights);
            let rough = |form: &Exact| form.map_scalar(Scalar::to_f64).unwrap();
            let (inner, host) = (rough(&inner), rough(&host));
            let computed = immerse(&inner, &host);
            let expected = immerse(&inner.exact().unwrap(), &host.exact().unwrap());
            let (Ok(computed), Ok(expected)) = (computed, expected) else {
                assert!(host.axes() == 0, "only a host without axes can refuse coordinates");
                continue;
            };
            let error = relative_error(&computed, &expected).unwrap();
            assert!(error < 1e-14, "{} in {}: {error:e}", inner.kind(), host.kind());
            for t in unisolvent(&vec![2; inner.axes()]) {
                let exact = (&inner.exact().unwrap(), &host.exact().unwrap());
                let point = composed_at(exact.0, exact.1, &t);
                assert_eq!(point, Some(expected.homogeneous_at(&t).unwrap()));
            }
        }
    }
}

#[test]
fn tiles_meet_at_their_faces() {
    let mut random = Random::new(11);
    let cage: Exact = random.form(&[3, 2], 3, Weights::Positive);
    let bar: Exact = Form::from_points(
        &[2],
        2,
        &[integer(0), Rational::ratio(1, 2), integer(1), Rational::ratio(1, 2)],
        None,
    )
    .unwrap();
    let copies = tile(&[bar], &cage, &[3, 2]).unwrap();
    assert_eq!(copies.len(), 6);
    let [zero, one] = [integer(0), integer(1)];
    for row in 0..2 {
        for column in 0..2 {
            let left = &copies[2 * row + column];
            let right = &copies[2 * (row + 1) + column];
            assert_eq!(left.at(slice::from_ref(&one)), right.at(slice::from_ref(&zero)));
        }
    }
}

#[test]
fn polylines_and_pointwise_images() {
    let mut random = Random::new(5);
    let host: Exact = random.form(&[3, 3], 2, Weights::Positive);
    let corners = [[0, 0], [1, 0], [1, 1]].map(|pair| pair.map(integer));
    let points: Vec<&[Rational]> = corners.iter().map(<[Rational; 2]>::as_slice).collect();
    let sides = polyline(&host, &points).unwrap();
    assert_eq!(sides.len(), 2);
    assert_eq!(sides[0].at(&[integer(1)]), sides[1].at(&[integer(0)]));
    let net: Exact = random.inner_form(&[2, 2], 2, Weights::Positive);
    let moved = immerse_points(&net, |point| host.at(point)).unwrap();
    assert_eq!(moved.weights(), net.weights());
    let first = net.points().unwrap();
    assert_eq!(moved.points().unwrap()[..2], host.at(&first[..2]).unwrap());
}

#[test]
fn what_does_not_fit_is_refused_with_the_sizes() {
    let mut random = Random::new(9);
    let host = random.rough_form(&[2, 2], 3, Weights::One);
    let deep = random.rough_form(&[2], 3, Weights::One);
    let error = immerse(&deep, &host).unwrap_err();
    assert_eq!(error.family(), "Shape");
    assert!(error.to_string().contains("inner"), "{error}");
    let flat = Form::from_points(&[2], 3, &[0., 0., 0., 1., 1., 0.], None).unwrap();
    assert_eq!(immerse(&flat, &host).unwrap(), diagonal(&host, 0, 1).unwrap());

    let line = random.rough_form(&[32], 2, Weights::One);
    let net = random.rough_form(&[40, 40], 3, Weights::One);
    let error = immerse(&line, &net).unwrap_err();
    assert_eq!(error.family(), "Accuracy");
    assert!(error.to_string().contains("received 2418"), "{error}");

    let large = random.rough_form(&[40, 40, 40], 3, Weights::One);
    let huge = random.rough_form(&[60, 60, 60], 3, Weights::One);
    let error = immerse(&large, &huge).unwrap_err();
    assert!(matches!(error, Error::Limit { cap, .. } if cap == u128::from(limit::cap())));
    assert!(error.to_string().contains("6904×6904×6904 poles"), "{error}");
}
