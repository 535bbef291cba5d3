//! Jacobian determinants as forms, and proofs that nothing folds.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use pforms_kernel::{Form, Rational, Scalar};
use pforms_operators::{
    Folding, Part, Shape, Spline, derivative, folds, jacobian, jacobian_shape, stack,
};
use pforms_testkit::{Random, Weights, truth};

/// The determinant of the derivatives at parameters, by the derivatives themselves.
fn determinant(form: &Form<Rational>, at: &[Rational]) -> Rational {
    let axes = form.axes();
    let mut rows = Vec::new();
    for axis in 0..axes {
        let mut orders = vec![0; axes];
        orders[axis] = 1;
        rows.push(derivative(form, &orders).unwrap().at(at).unwrap());
    }
    expand(&rows)
}

fn expand(rows: &[Vec<Rational>]) -> Rational {
    let Some((first, others)) = rows.split_first() else { return Rational::one() };
    let mut sum = Rational::zero();
    for (k, x) in first.iter().enumerate() {
        let without: Vec<Vec<Rational>> = others
            .iter()
            .map(|row| {
                row.iter().enumerate().filter(|(j, _)| *j != k).map(|(_, x)| x.clone()).collect()
            })
            .collect();
        let term = x.clone() * expand(&without);
        sum += if k % 2 == 0 { term } else { -term };
    }
    sum
}

/// The form of determinants is the determinant of the derivatives, exactly, and of the stated degrees.
#[test]
fn the_determinant_of_the_derivatives() {
    let mut random = Random::new(3);
    let all = [Weights::One, Weights::Positive, Weights::Any];
    let kinds = [&[4][..], &[2, 3], &[3, 3], &[1, 3], &[2, 2, 3], &[3, 2, 2]];
    for (weights, orders) in all.into_iter().flat_map(|w| kinds.map(|orders| (w, orders))) {
        let form: Form<Rational> = random.form(orders, orders.len(), weights);
        let found = jacobian(&form).unwrap();
        let axes = orders.len();
        for (order, own) in found.orders().iter().zip(orders) {
            let expected = match weights {
                _ if orders.contains(&1) => continue,
                Weights::One => axes * (own - 1) - 1,
                _ => (axes + 1) * (own - 1),
            };
            assert_eq!(*order, expected + 1, "{} {}", form.kind(), found.kind());
        }
        for k in 1..4 {
            let at = |axis: usize| Rational::ratio(k + axis as i64, 7);
            let at: Vec<Rational> = (0..axes).map(at).collect();
            if let Ok(value) = found.at(&at) {
                assert_eq!(value[0], determinant(&form, &at), "{}", form.kind());
            }
        }
    }
}

#[test]
fn splines_have_jacobians_over_their_own_windows() {
    // (s², t) on s from 0 to 1 and (2s − 1, t) from 1 to 3: 2s, then 2; all over t from 0 to 2.
    let points = [0., 0., 0., 1., 0., 0., 0., 1., 1., 0., 1., 1., 3., 0., 3., 1., 5., 0., 5., 1.];
    let net = Form::from_points(&[5, 2], 2, &points, None).unwrap();
    let knots = vec![vec![0., 0., 0., 1., 1., 3., 3., 3.], vec![0., 0., 2., 2.]];
    let spline = Spline::new(net, &[2, 1], knots).unwrap();
    let Shape::Spline(found) = jacobian_shape(&spline.into()).unwrap() else { panic!("a spline") };
    for (s, expected) in [(0.0, 0.0), (0.25, 0.25), (0.75, 0.75), (2.0, 1.0), (3.0, 1.0)] {
        assert_eq!(found.at(&[s, 0.7]).unwrap(), [expected], "{s}");
    }
}

fn square(corner: f64) -> Shape {
    Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 1., 0., corner, corner], None).unwrap().into()
}

#[test]
fn folds_are_found_or_excluded() {
    let none = folds(&square(1.0), 1e-9).unwrap();
    assert_eq!(none.answer, Folding::None);
    assert!(none.regular && none.injective && none.undecided.is_empty());
    assert!(none.positive.is_some() && none.negative.is_none());
    // The determinant is 1 + (c − 1)·(u + v): it vanishes in a corner for c = 1/2.
    let touching = folds(&square(0.5), 1e-9).unwrap();
    assert_eq!(touching.answer, Folding::None);
    assert!(!touching.regular && !touching.injective);
    let folded = folds(&square(0.4), 1e-9).unwrap();
    assert_eq!(folded.answer, Folding::Folds);
    for (place, sign) in [(folded.positive.unwrap(), 1.0), (folded.negative.unwrap(), -1.0)] {
        let Shape::Form(form) = square(0.4) else { panic!("a form") };
        let value = jacobian(&form).unwrap().at(&place).unwrap()[0];
        assert!(value * sign > 0.0);
    }
    // Just above and just below.
    assert_eq!(folds(&square(0.5 + 1e-12), 1e-9).unwrap().answer, Folding::None);
    assert_eq!(folds(&square(0.5 - 1e-12), 1e-9).unwrap().answer, Folding::Folds);
}

#[test]
fn what_touches_inside_stays_open() {
    // x = (2u − 1)³: the derivative is 0 in the middle, and nowhere negative.
    let cubic: Form = Form::from_points(&[4], 1, &[-1., 1., -1., 1.], None).unwrap();
    let open = folds(&cubic.into(), 1e-6).unwrap();
    assert_eq!(open.answer, Folding::Undecided);
    let [low, high] = &open.undecided[0];
    assert!(low[0] <= 0.5 && 0.5 <= high[0] && high[0] - low[0] < 1e-2);
    assert!(open.negative.is_none() && open.positive.is_some());
    // All on a line: there is no sign at all.
    let flat: Form =
        Form::from_points(&[2, 2], 2, &[0., 0., 1., 1., 2., 2., 3., 3.], None).unwrap();
    assert_eq!(folds(&flat.into(), 1e-6).unwrap().answer, Folding::Undecided);
}

#[test]
fn rational_forms_and_volumes() {
    let arc = truth("ellipse-3-2").form();
    let centre = Form::from_points(&[3], 2, &[0.0; 6], Some(&arc.weights())).unwrap();
    let disc: Shape = stack(&[&centre, &arc]).unwrap().into();
    let found = folds(&disc, 1e-9).unwrap();
    assert_eq!(found.answer, Folding::None);
    assert!(!found.regular, "the centre is an edge");
    let ring = pforms_operators::circle(&1.0, Part::Pieces).unwrap();
    assert_eq!(folds(&ring, 1e-9).unwrap_err().family(), "Shape");
    let infinite: Form = Form::from_points(&[2], 1, &[0.0, 1.0], Some(&[1.0, -1.0])).unwrap();
    assert_eq!(folds(&infinite.into(), 1e-9).unwrap_err().family(), "Domain");
    let unit: Form = Form::from_points(&[2], 1, &[0.0, 1.0], None).unwrap();
    assert_eq!(folds(&unit.into(), 0.0).unwrap_err().family(), "Domain");
}
