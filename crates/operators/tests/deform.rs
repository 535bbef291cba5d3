//! Deformation of forms: exact, in every scalar.
#![allow(clippy::unwrap_used)]

use pforms_kernel::{Form, Rational, Scalar};
use pforms_operators::{
    Poles, Rest, Shape, Spline, deform, diagonal, immerse, subdivide, tile, tile_shapes,
};
use pforms_testkit::{ROUNDS, Random, Weights};

type Q = Rational;

fn q(x: i64) -> Q {
    Scalar::from_integer(x)
}

/// The affine image of a lattice: a cage at rest, with its origin and edges.
fn parallelepiped(random: &mut Random, orders: &[usize]) -> Form<Q> {
    let axes = orders.len();
    loop {
        let frame: Vec<Vec<Q>> =
            (0..=axes).map(|_| (0..axes).map(|_| random.fraction()).collect()).collect();
        let mut points = Vec::new();
        for flat in 0..orders.iter().product::<usize>() {
            let mut rest = flat;
            let mut point = frame[axes].clone();
            for axis in (0..axes).rev() {
                let node = Q::ratio((rest % orders[axis]) as i64, orders[axis] as i64 - 1);
                rest /= orders[axis];
                Q::add_multiple(&mut point, &node, &frame[axis]);
            }
            points.extend(point);
        }
        let form = Form::from_points(orders, axes, &points, None).unwrap();
        let flat =
            deform(&form.clone().into(), &form.clone().into(), &Rest::Cage(form.clone().into()));
        if flat.is_ok() {
            return form;
        }
    }
}

#[test]
fn what_rests_in_its_cage_stays_where_it_is() {
    let mut random = Random::new(1);
    for round in 0..ROUNDS.min(30) as usize {
        let axes = 1 + round % 3;
        let orders: Vec<usize> = (0..axes).map(|_| random.size(2, 3)).collect();
        let cage = parallelepiped(&mut random, &orders);
        let object: Form<Q> = random.form(&[3], axes, [Weights::One, Weights::Positive][round % 2]);
        let rest = Rest::Cage(cage.clone().into());
        let same = deform(&object.clone().into(), &cage.into(), &rest).unwrap();
        let t = [random.parameter::<Q>()];
        let Shape::Form(same) = same else { panic!() };
        assert_eq!(same.at(&t).unwrap(), object.at(&t).unwrap());
    }
}

/// The point of the deformed form is that of the cage at the parameters the point had at rest.
#[test]
fn deforming_and_evaluating_commute() {
    let mut random = Random::new(2);
    for round in 0..ROUNDS.min(30) as usize {
        let axes = 1 + round % 3;
        let orders: Vec<usize> = (0..axes).map(|_| random.size(2, 3)).collect();
        let weights = [Weights::One, Weights::Positive][round / 2 % 2];
        let cage: Form<Q> = random.form(&orders, 3, weights);
        let object: Form<Q> = random.form(&[2, 2], axes, weights);
        let (lower, upper) = (vec![q(-3); axes], vec![q(5); axes]);
        let bent = deform(
            &object.clone().into(),
            &cage.clone().into(),
            &Rest::Box(lower.clone(), upper.clone()),
        );
        let Shape::Form(bent) = bent.unwrap() else { panic!() };
        let at = [random.parameter::<Q>(), random.parameter()];
        let inside: Vec<Q> =
            object.at(&at).unwrap().into_iter().map(|x| (x + q(3)) / q(8)).collect();
        match cage.at(&inside) {
            Ok(point) => assert_eq!(bent.at(&at).unwrap(), point),
            Err(_) => assert!(bent.at(&at).is_err()),
        }
    }
}

#[test]
fn coordinates_are_parameters_unless_the_rest_is_told() {
    let mut random = Random::new(3);
    let cage: Form<Q> = random.form(&[3, 2], 2, Weights::Positive);
    let object: Form<Q> = random.inner_form(&[4], 2, Weights::One);
    let bent = deform(&object.clone().into(), &cage.clone().into(), &Rest::Window).unwrap();
    assert_eq!(bent, immerse(&object, &cage).unwrap().into());
}

/// A spline cage, a spline at rest, and the window of a form bent by a spline.
#[test]
fn splines_bend_and_are_bent() {
    let mut random = Random::new(4);
    let cage: Form<Q> = random.form(&[3, 3], 2, Weights::One);
    let pieces: Shape<Q> = subdivide(&cage, &[1, 1]).unwrap().into();
    let object: Form<Q> = random.inner_form(&[3], 2, Weights::One);
    let rest = Rest::Box(vec![q(0), q(0)], vec![q(1), q(1)]);
    let whole = deform(&object.clone().into(), &cage.into(), &rest).unwrap().into_spline();
    // Crossings of knots must be fractions: a straight object.
    let straight = Form::from_points(&[2], 2, &[q(0), q(0), q(1), q(1)], None).unwrap();
    let cut = deform(&straight.into(), &pieces, &rest).unwrap();
    assert!(matches!(cut, Shape::Spline(_)));
    let spline: Shape<Q> = subdivide(&object, &[2]).unwrap().into();
    let Shape::Spline(bent) =
        deform(&spline, &random.form::<Q>(&[2, 2], 2, Weights::One).into(), &rest).unwrap()
    else {
        panic!()
    };
    assert_eq!(bent.counts(), [4]);
    assert_eq!(whole.axes(), 1);
    // A window other than from 0 to 1.
    let net = Form::from_points(&[3], 1, &[q(0), q(1), q(4)], None).unwrap();
    let host: Shape<Q> =
        Spline::new(net, &[1], vec![vec![q(2), q(2), q(3), q(4), q(4)]]).unwrap().into();
    let inner: Shape<Q> = Form::from_points(&[2], 1, &[q(0), q(10)], None).unwrap().into();
    let bent = deform(&inner, &host, &Rest::Box(vec![q(0)], vec![q(10)])).unwrap().into_spline();
    assert_eq!(bent.at(&[Q::ratio(3, 4)]).unwrap(), [Q::ratio(5, 2)]);
    let greville = Form::from_points(&[3], 1, &[q(0), q(5), q(10)], None).unwrap();
    let at_rest = Spline::new(greville, &[1], vec![vec![q(2), q(2), q(3), q(4), q(4)]]).unwrap();
    assert_eq!(deform(&inner, &host, &Rest::Cage(at_rest.into())).unwrap().into_spline(), bent);
}

/// The question of section 35: how many poles has the diagonal of a torus in a bent cube?
#[test]
fn the_diagonal_of_the_bent_torus_has_seventeen_poles() {
    let mut random = Random::new(5);
    let patch: Form<Q> = random.inner_form(&[3, 3], 3, Weights::Positive);
    let cube: Form<Q> = random.form(&[3, 2, 2], 3, Weights::One);
    let line = diagonal(&patch, 0, 1).unwrap();
    assert_eq!(line.orders(), [5]);
    let bent = deform(&line.into(), &cube.clone().into(), &Rest::Window).unwrap();
    assert_eq!(bent.net().orders(), [17]);
    let surface = deform(&patch.into(), &cube.into(), &Rest::Window).unwrap();
    let Shape::Form(surface) = surface else { panic!() };
    assert_eq!(surface.orders(), [9, 9]);
    let Shape::Form(bent) = bent else { panic!() };
    assert_eq!(diagonal(&surface, 0, 1).unwrap(), bent);
}

#[test]
fn what_cannot_be_is_named() {
    let square: Form =
        Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 1., 0., 1., 1.], None).unwrap();
    let cage: Shape = square.clone().into();
    let object: Shape = Form::from_points(&[2], 2, &[0., 0., 1., 1.], None).unwrap().into();
    let family = |object: &Shape, rest: Rest| deform(object, &cage, &rest).unwrap_err().family();
    let bent = square.with_pole(&[1, 1], &[2.0, 1.0, 1.0]).unwrap();
    assert_eq!(family(&object, Rest::Cage(bent.into())), "Domain");
    let rational = square.with_pole(&[1, 1], &[2.0, 2.0, 2.0]).unwrap();
    assert_eq!(family(&object, Rest::Cage(rational.into())), "Domain");
    let flat = Form::from_points(&[2, 2], 2, &[0., 0., 1., 1., 1., 1., 2., 2.], None).unwrap();
    assert_eq!(family(&object, Rest::Cage(flat.into())), "Degenerate");
    assert_eq!(family(&object, Rest::Box(vec![0., 0.], vec![1., 0.])), "Degenerate");
    assert_eq!(family(&object, Rest::Box(vec![0.], vec![1.])), "Shape");
    let space: Shape = Form::from_points(&[2], 3, &[0.0; 6], None).unwrap().into();
    assert_eq!(family(&space, Rest::Box(vec![0., 0.], vec![1., 1.])), "Shape");
    let line: Shape = Form::from_points(&[2], 1, &[0., 1.], None).unwrap().into();
    assert_eq!(family(&line, Rest::Window), "Shape");
}

/// A cage in pieces is tiled as the whole cage is.
#[test]
fn splines_are_tiled_over_their_windows() {
    let mut random = Random::new(6);
    let cage: Form<Q> = random.form(&[3, 2], 2, Weights::One);
    let pieces: Shape<Q> = subdivide(&cage, &[1, 1]).unwrap().into();
    let motif = Form::from_points(&[2], 2, &[q(0), q(0), q(1), q(1)], None).unwrap();
    let whole = tile(std::slice::from_ref(&motif), &cage, &[4, 2]).unwrap();
    let cut = tile_shapes(&[motif.clone().into()], &pieces, &[4, 2]).unwrap();
    assert_eq!(whole.len(), cut.len());
    for (one, other) in whole.iter().zip(cut) {
        let other = other.into_spline();
        let (from, to) = other.window(0).unwrap();
        for t in [Q::ratio(0, 1), Q::ratio(1, 3), Q::ratio(1, 1)] {
            let at = from.clone() + t.clone() * (to.clone() - from.clone());
            assert_eq!(one.at(&[t]).unwrap(), other.at(&[at]).unwrap());
        }
    }
    let family = |counts: &[usize]| {
        tile_shapes(&[motif.clone().into()], &pieces, counts).unwrap_err().family()
    };
    assert_eq!((family(&[0, 1]), family(&[1])), ("Shape", "Shape"));
}
