//! Least boxes against closed forms and samples.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use pforms_kernel::Form;
use pforms_operators::{
    BoundingBox, Part, Rotation, Shape, Spline, Turn, bounding_box, rotate, sphere, torus,
};
use pforms_testkit::{Random, truth};

const ACCURACY: f64 = 1e-12;

fn assert_is(found: &BoundingBox, lower: &[f64], upper: &[f64], what: &str) {
    let faces = found.lower.iter().zip(lower).chain(found.upper.iter().zip(upper));
    for (face, expected) in faces {
        assert!((face - expected).abs() <= found.error, "{what}: {found:?}");
    }
    // It contains what it is the box of, but for the rounding of the expected numbers.
    let slack = |x: &f64| 2.0 * f64::EPSILON * x.abs();
    assert!(found.lower.iter().zip(lower).all(|(face, x)| *face <= x + slack(x)), "{what}");
    assert!(found.upper.iter().zip(upper).all(|(face, x)| *face >= x - slack(x)), "{what}");
}

#[test]
fn closed_forms() {
    let of = |shape: Shape| bounding_box(&[shape], ACCURACY).unwrap();
    for part in [Part::Whole, Part::Pieces] {
        let ball = of(sphere(&2.0, part).unwrap());
        assert_is(&ball, &[-2.0; 3], &[2.0; 3], "sphere");
        assert!(ball.error < 1e-11);
        // The torus is highest along a whole circle: it does not take more boxes for that.
        let ring = of(torus(&3.0, &1.0, part).unwrap());
        assert_is(&ring, &[-4.0, -1.0, -4.0], &[4.0, 1.0, 4.0], "torus");
    }
    // An ellipse with half axes 3 and 2, turned: its box has half sides √(a²·cos² + b²·sin²).
    let ellipse = pforms_operators::ellipse(&3.0, &2.0, Part::Pieces).unwrap();
    let angle = 30.0_f64.to_radians();
    let turned =
        rotate(&ellipse, &Rotation::Plane(0, 1, Turn::radians(angle).unwrap()), &[0.0; 3]).unwrap();
    let side = |c: f64, s: f64| (9.0 * c * c + 4.0 * s * s).sqrt();
    let half = [side(angle.cos(), angle.sin()), side(angle.sin(), angle.cos()), 0.0];
    assert_is(&of(turned), &half.map(|x| -x), &half, "ellipse");
    let hypar = truth("hypar-1-1-1").form();
    assert_is(&of(hypar.into()), &[-1.0; 3], &[1.0; 3], "hypar");
}

#[test]
fn random_forms_and_splines_stay_inside_and_reach_out() {
    let mut random = Random::new(7);
    for orders in [&[5][..], &[4, 4], &[3, 2, 3]] {
        for round in 0..6 {
            let count: usize = orders.iter().product();
            let points: Vec<f64> = (0..3 * count).map(|_| 2.0 * random.unit() - 1.0).collect();
            let weights: Vec<f64> = (0..count).map(|_| 0.3 + 2.7 * random.unit()).collect();
            let weights = (round % 2 == 1).then_some(&weights[..]);
            let form = Form::from_points(orders, 3, &points, weights).unwrap();
            let found = bounding_box(&[form.clone().into()], ACCURACY).unwrap();
            let list: Vec<f64> = (0..=24).map(|i| f64::from(i) / 24.0).collect();
            let lists = vec![&list[..]; orders.len()];
            for point in form.grid(&lists).unwrap().chunks_exact(3) {
                let inside = |k: usize| found.lower[k] <= point[k] && point[k] <= found.upper[k];
                assert!((0..3).all(inside), "{found:?} {point:?}");
            }
            for k in 0..3 {
                let lowest = form.at(&found.lowest[k].1).unwrap()[k];
                let highest = form.at(&found.highest[k].1).unwrap()[k];
                assert!(lowest - found.lower[k] <= found.error + 1e-15);
                assert!(found.upper[k] - highest <= found.error + 1e-15);
            }
            assert!(found.error <= 4.0 * ACCURACY, "{}", found.error);
        }
    }
    // A spline curve: the parameters are its own.
    let net = Form::from_points(&[5], 2, &[0., 0., 1., 3., 2., -3., 3., 3., 4., 0.], None).unwrap();
    let spline = Spline::new(net, &[2], vec![vec![0., 0., 0., 2., 5., 9., 9., 9.]]).unwrap();
    let found = bounding_box(&[spline.clone().into()], ACCURACY).unwrap();
    let highest = spline.at(&found.highest[1].1).unwrap();
    assert!((highest[1] - found.upper[1]).abs() <= found.error);
}

#[test]
fn several_forms_and_bad_ones() {
    let point = |x: f64| Shape::Form(Form::point(&[x, 1.0]).unwrap());
    let both = bounding_box(&[point(1e9), point(-2.0)], ACCURACY).unwrap();
    assert_is(&both, &[-2.0, 1.0], &[1e9, 1.0], "points");
    assert_eq!((both.lowest[0].0, both.highest[0].0), (1, 0));
    let segment = |weights: &[f64]| -> Shape {
        Form::from_points(&[2], 1, &[0.0, 1.0], Some(weights)).unwrap().into()
    };
    let family = |shapes: &[Shape], accuracy| bounding_box(shapes, accuracy).unwrap_err().family();
    assert_eq!(family(&[segment(&[1.0, 0.0])], 1e-6), "Domain");
    assert_eq!(family(&[segment(&[1.0, -1.0])], 1e-6), "Domain");
    assert_eq!(family(&[segment(&[1.0, 1.0]), point(0.0)], 1e-6), "Shape");
    assert_eq!(family(&[], 1e-6), "Shape");
    assert_eq!(family(&[point(0.0)], 0.0), "Domain");
}

#[test]
fn axes_of_one_pole_cost_nothing() {
    let point: Form = Form::from_homogeneous(&[1; 60], 2, vec![3.0, 4.0, 1.0]).unwrap();
    let found = bounding_box(&[point.into()], 1e-12).unwrap();
    assert!(found.lower[0] <= 3.0 && found.upper[1] >= 4.0 && found.error < 1e-11);
}
