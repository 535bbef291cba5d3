//! Splines inside splines: the points are those of the composition, across every knot.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Error, Form, Rational, Scalar};
use pforms_operators::{Shape, Spline, immerse, immerse_spline};
use pforms_testkit::{Random, Weights};

type Q = Rational;

fn q(n: i64, d: i64) -> Q {
    Q::ratio(n, d)
}

fn knots(degree: usize, inner: &[(i64, i64)], times: usize) -> Vec<Q> {
    let inside = inner.iter().flat_map(|&(n, d)| vec![q(n, d); times]);
    let (from, to) = (vec![q(0, 1); degree + 1], vec![q(1, 1); degree + 1]);
    from.into_iter().chain(inside).chain(to).collect()
}

/// A surface of degrees 2 and 3 with two and three pieces.
fn host(random: &mut Random, weights: Weights, times: usize) -> Spline<Q> {
    let lists = vec![knots(2, &[(2, 5)], times), knots(3, &[(1, 4), (2, 3)], 1)];
    let orders = [lists[0].len() - 3, lists[1].len() - 4];
    Spline::new(random.form(&orders, 3, weights), &[2, 3], lists).unwrap()
}

fn image(host: &Spline<Q>, inner: &Spline<Q>, t: &[Q]) -> Vec<Q> {
    host.at(&inner.at(t).unwrap()).unwrap()
}

#[test]
fn a_segment_across_knots_is_exact() {
    let mut random = Random::new(5);
    for weights in [Weights::One, Weights::Positive] {
        let host = host(&mut random, weights, 1);
        let ends = [q(0, 1), q(1, 1), q(1, 1), q(0, 1)];
        let inner: Spline<Q> = Form::from_points(&[2], 2, &ends, None).unwrap().into();
        let line = immerse_spline(&inner.clone().into(), &host.clone().into()).unwrap();
        assert_eq!(line.breaks(), [[q(0, 1), q(1, 3), q(2, 5), q(3, 4), q(1, 1)]]);
        assert_eq!(line.degrees(), [5]);
        for k in 0..=30 {
            let t = [q(k, 30)];
            assert_eq!(line.at(&t).unwrap(), image(&host, &inner, &t));
        }
    }
}

#[test]
fn an_inner_spline_keeps_its_joints() {
    let mut random = Random::new(6);
    let host = host(&mut random, Weights::Positive, 1);
    let net = Form::from_points(
        &[4],
        2,
        &[q(0, 1), q(0, 1), q(1, 1), q(1, 4), q(1, 2), q(1, 1), q(0, 1), q(1, 2)],
        None,
    );
    let inner = Spline::new(net.unwrap(), &[1], vec![knots(1, &[(1, 2), (3, 4)], 1)]).unwrap();
    let curve = immerse_spline(&inner.clone().into(), &host.clone().into()).unwrap();
    for k in 0..=40 {
        let t = [q(k, 40)];
        assert_eq!(curve.at(&t).unwrap(), image(&host, &inner, &t));
    }
}

#[test]
fn surfaces_are_cut_along_their_own_lines() {
    let mut random = Random::new(7);
    let host = host(&mut random, Weights::One, 1);
    // u = 1 − s, v = t/2 + 1/4, and the host's parameters the other way round.
    let facet = |poles: [(i64, i64); 8]| {
        let points: Vec<Q> = poles.iter().map(|&(n, d)| q(n, d)).collect();
        Spline::from(Form::from_points(&[2, 2], 2, &points, None).unwrap())
    };
    let straight = facet([(1, 1), (1, 4), (1, 1), (3, 4), (0, 1), (1, 4), (0, 1), (3, 4)]);
    let surface = immerse_spline(&straight.clone().into(), &host.clone().into()).unwrap();
    assert_eq!(surface.counts(), [2, 2]);
    for i in 0..=6 {
        for j in 0..=6 {
            let at = [q(i, 6), q(j, 6)];
            assert_eq!(surface.at(&at).unwrap(), image(&host, &straight, &at));
        }
    }
    let aslant = facet([(0, 1), (0, 1), (1, 2), (1, 1), (1, 2), (0, 1), (1, 1), (1, 1)]);
    let refused = immerse_spline(&aslant.into(), &host.into());
    assert!(matches!(refused, Err(Error::Domain(_))), "{refused:?}");
}

#[test]
fn a_spline_in_a_form_is_immersed_piece_by_piece() {
    let mut random = Random::new(8);
    let host: Form<Q> = random.form(&[3, 2], 2, Weights::Positive);
    let inner =
        Spline::new(random.inner_form(&[4], 2, Weights::One), &[2], vec![knots(2, &[(1, 3)], 1)]);
    let inner = inner.unwrap();
    let curve = immerse_spline(&inner.clone().into(), &host.clone().into()).unwrap();
    assert_eq!(curve.breaks(), inner.breaks());
    for k in 0..=12 {
        let t = [q(k, 12)];
        assert_eq!(curve.at(&t).unwrap(), host.at(&inner.at(&t).unwrap()).unwrap());
    }
    let whole: Form<Q> = random.inner_form(&[3], 2, Weights::One);
    let one = immerse_spline(&whole.clone().into(), &host.clone().into()).unwrap();
    assert_eq!(one, Spline::from(immerse(&whole, &host).unwrap()));
}

#[test]
fn a_gap_of_the_host_is_one_of_the_curve() {
    let net = Form::from_points(&[4], 1, &[q(0, 1), q(1, 1), q(5, 1), q(6, 1)], None).unwrap();
    let host = Spline::new(net, &[1], vec![knots(1, &[(1, 2)], 2)]).unwrap();
    let line = |from: i64, to: i64| -> Form<Q> {
        Form::from_points(&[2], 1, &[q(from, 4), q(to, 4)], None).unwrap()
    };
    let inner = Spline::from(line(0, 4));
    let image = immerse_spline(&inner.into(), &host.clone().into()).unwrap();
    assert_eq!(image.at(&[q(1, 2)]).unwrap(), [q(5, 1)]);
    assert_eq!(image.at(&[q(49, 100)]).unwrap(), [q(49, 50)]);
    // A joint of the inner spline that lies on the gap.
    let breaks = [q(0, 1), q(1, 1), q(2, 1)];
    let bent = Spline::end_to_end(&[line(0, 2), line(2, 3)], 0, &breaks).unwrap();
    let image = immerse_spline(&bent.into(), &host.into()).unwrap();
    assert_eq!(image.at(&[q(1, 1)]).unwrap(), [q(5, 1)]);
    assert_eq!(image.piece(&[0]).unwrap().at(&[q(1, 1)]).unwrap(), [q(1, 1)]);
}

#[test]
fn touching_a_knot_from_either_side_is_no_crossing() {
    let mut random = Random::new(10);
    let host = host(&mut random, Weights::One, 1);
    for (low, high) in [(q(1, 5), q(3, 5)), (q(3, 5), q(1, 5))] {
        // u touches 2/5 in the middle of the parabola.
        let points = [low.clone(), q(0, 1), high, q(1, 8), low, q(1, 5)];
        let inner = Form::from_points(&[3], 2, &points, None).unwrap();
        let curve = immerse_spline(&inner.clone().into(), &host.clone().into()).unwrap();
        assert_eq!(curve.counts(), [1]);
        for k in 0..=10 {
            let t = [q(k, 10)];
            assert_eq!(curve.at(&t).unwrap(), host.at(&inner.at(&t).unwrap()).unwrap());
        }
    }
}

#[test]
fn crossings_that_are_no_fractions_are_refused_exactly_and_right_in_floating_point() {
    let mut random = Random::new(11);
    let host = host(&mut random, Weights::Positive, 1);
    let inner: Form<Q> =
        Form::from_points(&[3], 2, &[q(0, 1), q(0, 1), q(1, 10), q(1, 1), q(1, 1), q(1, 1)], None)
            .unwrap();
    let exact = immerse_spline(&inner.clone().into(), &host.clone().into());
    assert!(matches!(exact, Err(Error::Domain(_))), "{exact:?}");
    let floating = |x: &Q| x.to_f64();
    let host = host.map_scalar(floating).unwrap();
    let inner = inner.map_scalar(floating).unwrap();
    let curve = immerse_spline(&inner.clone().into(), &Shape::Spline(host.clone())).unwrap();
    assert_eq!(curve.counts(), [4]);
    for k in 0..=100 {
        let t = [f64::from(k) / 100.0];
        let (here, there) = (curve.at(&t).unwrap(), host.at(&inner.at(&t).unwrap()).unwrap());
        // Degree 10 over poles of size 4: some hundred roundings.
        assert!(here.iter().zip(&there).all(|(a, b)| (a - b).abs() < 1e-13), "{here:?} {there:?}");
    }
}
