//! Continuity at joints, forms made to meet, and curves at unit speed.
#![allow(clippy::unwrap_used)]

mod common;

use common::family;
use pforms_kernel::Form;
use pforms_operators::{
    ContinuityOptions, FormEnd, KnotRule, Poles, Shape, Smoothness, Spline, bspline, by_arc_length,
    continuity, elevate, join_forms, joints, reparametrise, reverse, split,
};
use pforms_testkit::{Random, Weights};

const THROUGH: [FormEnd; 2] = [FormEnd { axis: 0, far: true }, FormEnd { axis: 0, far: false }];

fn up_to(order: usize) -> ContinuityOptions {
    ContinuityOptions { order, accuracy: 1e-9 }
}

fn shape(form: &Form) -> Shape {
    form.clone().into()
}

#[test]
fn halves_of_a_curve_are_as_smooth_as_one_asks() {
    let mut random = Random::new(71);
    for _ in 0..10 {
        let curve = random.form::<f64>(&[5], 3, Weights::Positive);
        let (low, high) = split(&curve, 0, &0.5).unwrap();
        let joint = continuity(&shape(&low), &shape(&high), THROUGH, up_to(4)).unwrap();
        assert_eq!((joint.parametric, joint.geometric), (Some(4), Some(4)), "{joint:?}");
        assert_eq!((joint.parametric_gaps.len(), joint.geometric_gaps.len()), (5, 5));
        // At another point the speeds differ by a factor, the images do not.
        let (low, high) = split(&curve, 0, &0.25).unwrap();
        let joint = continuity(&shape(&low), &shape(&high), THROUGH, up_to(4)).unwrap();
        assert_eq!((joint.parametric, joint.geometric), (Some(0), Some(4)), "{joint:?}");
        // A change of parameter that is not affine, and both run the other way.
        let moved = reparametrise(&high, 0, &3.0).unwrap();
        let ends = [FormEnd::start(0), FormEnd::end(0)];
        let (a, b) = (reverse(&low, 0).unwrap(), reverse(&moved, 0).unwrap());
        let joint = continuity(&shape(&a), &shape(&b), ends, up_to(3)).unwrap();
        assert_eq!(joint.geometric, Some(3), "{joint:?}");
    }
}

#[test]
fn gaps_are_measured() {
    let line =
        |points: &[f64]| shape(&Form::from_points(&[points.len() / 2], 2, points, None).unwrap());
    let f = line(&[0., 0., 1., 0.]);
    let apart = continuity(&f, &line(&[1., 0.5, 2., 0.5]), THROUGH, up_to(1)).unwrap();
    assert_eq!((apart.parametric, apart.geometric), (None, None));
    assert_eq!(apart.parametric_gaps[0], 0.5);
    let corner = continuity(&f, &line(&[1., 0., 1., 1.]), THROUGH, up_to(2)).unwrap();
    assert_eq!((corner.parametric, corner.geometric), (Some(0), Some(0)));
    assert!((corner.geometric_gaps[1] - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    // Back the way it came is no tangent continuity.
    let cusp = continuity(&f, &line(&[1., 0., 0., 0.]), THROUGH, up_to(1)).unwrap();
    assert_eq!(cusp.geometric, Some(0));
    // A line into a unit circle: the curvature jumps by 1.
    let w = 0.5_f64.sqrt();
    let arc = Form::from_points(&[3], 2, &[1., 0., 2., 0., 2., 1.], Some(&[1., w, 1.])).unwrap();
    let joint = continuity(&f, &shape(&arc), THROUGH, up_to(2)).unwrap();
    assert_eq!(joint.geometric, Some(1));
    assert!((joint.geometric_gaps[2] - 1.0).abs() < 1e-14);
    // Where a curve stands still only its derivatives are compared.
    let still = continuity(&f, &line(&[1., 0., 1., 0., 2., 1.]), THROUGH, up_to(2)).unwrap();
    assert_eq!((still.parametric, still.geometric), (Some(0), Some(0)));
    assert_eq!(still.geometric_gaps.len(), 1);
}

#[test]
fn scale_changes_nothing() {
    let mut random = Random::new(73);
    let curve = random.form::<f64>(&[5], 3, Weights::Positive);
    let (low, high) = split(&curve, 0, &0.25).unwrap();
    let scaled = |form: &Form, factor: f64| {
        let mut poles = form.homogeneous().to_vec();
        poles.chunks_exact_mut(4).for_each(|p| p[..3].iter_mut().for_each(|x| *x *= factor));
        shape(&Form::from_homogeneous(form.orders(), 3, poles).unwrap())
    };
    for exponent in [-500, 500] {
        let factor = 2.0_f64.powi(exponent);
        let joint = continuity(&scaled(&low, factor), &scaled(&high, factor), THROUGH, up_to(2));
        assert_eq!(joint.unwrap().geometric, Some(2));
    }
}

#[test]
fn joints_of_uniform_splines() {
    let mut random = Random::new(79);
    for degree in 1..=4 {
        let poles = random.form::<f64>(&[7], 3, Weights::Positive);
        let closed = bspline(&poles, &[degree], &[KnotRule::Uniform], &[true]).unwrap();
        let found = joints(&closed, 0, up_to(degree)).unwrap();
        assert_eq!(found.len(), 7, "six breaks and the joint where it closes");
        for (_, joint) in &found {
            assert_eq!(joint.parametric, Some(degree - 1), "{joint:?}");
        }
        let open = bspline(&poles, &[degree], &[KnotRule::Clamped], &[false]).unwrap();
        assert_eq!(joints(&open, 0, up_to(1)).unwrap().len(), 7 - degree - 1);
    }
}

#[test]
fn surfaces_meet_along_edges() {
    let mut random = Random::new(83);
    let surface = random.form::<f64>(&[4, 3], 3, Weights::Positive);
    let (low, high) = split(&surface, 0, &0.25).unwrap();
    let joint = continuity(&shape(&low), &shape(&high), THROUGH, up_to(2)).unwrap();
    assert_eq!((joint.parametric, joint.geometric), (Some(0), Some(2)), "{joint:?}");
    // The edge runs the other way, on another axis, and more poles than before.
    let other = elevate(&reverse(&high, 1).unwrap(), &[1, 2]).unwrap();
    let other = pforms_operators::transpose(&other, &[1, 0]).unwrap();
    let at = [FormEnd::end(0), FormEnd::start(1)];
    let joint = continuity(&shape(&low), &shape(&other), at, up_to(2)).unwrap();
    assert_eq!(joint.geometric, Some(2), "{joint:?}");
    // The same surface again is folded back along the edge.
    let at = [FormEnd::end(0), FormEnd::end(0)];
    let joint = continuity(&shape(&low), &shape(&low), at, up_to(2)).unwrap();
    assert_eq!(joint.geometric, Some(0));
    assert!((joint.geometric_gaps[1] - std::f64::consts::PI).abs() < 1e-7);
    // A whole spline surface, and a volume.
    let net = random.form::<f64>(&[6, 5], 3, Weights::One);
    let rules = [KnotRule::Uniform, KnotRule::Uniform];
    let spline = bspline(&net, &[3, 2], &rules, &[false; 2]).unwrap();
    for (axis, smooth) in [(0, 2), (1, 1)] {
        for (_, joint) in joints(&spline, axis, up_to(2)).unwrap() {
            assert_eq!((joint.parametric, joint.geometric), (Some(smooth), Some(smooth)));
        }
    }
    let volume = random.form::<f64>(&[3, 2, 3], 3, Weights::One);
    let (low, high) = split(&volume, 1, &0.5).unwrap();
    let at = [FormEnd::end(1), FormEnd::start(1)];
    let joint = continuity(&shape(&low), &shape(&high), at, up_to(2)).unwrap();
    assert_eq!((joint.parametric, joint.geometric), (Some(2), Some(0)));
}

#[test]
fn forms_are_joined_as_smoothly_as_asked() {
    let mut random = Random::new(89);
    for order in 0..=2 {
        for smoothness in [Smoothness::Parametric(order), Smoothness::Geometric(order)] {
            for moving in [[order + 1, order + 1], [0, order + 1], [order + 1, 0]] {
                for (orders, weights) in [(vec![5], Weights::Positive), (vec![4, 3], Weights::One)]
                {
                    let f = random.form::<f64>(&orders, 3, weights);
                    let g = random.form::<f64>(&orders, 3, weights);
                    let joined =
                        join_forms(&shape(&f), &shape(&g), THROUGH, smoothness, moving).unwrap();
                    let joint = continuity(&joined.f, &joined.g, THROUGH, up_to(2)).unwrap();
                    let reached = match smoothness {
                        Smoothness::Parametric(_) => joint.parametric,
                        Smoothness::Geometric(_) => joint.geometric,
                    };
                    assert!(reached >= Some(order), "{smoothness:?} {moving:?} {joint:?}");
                    assert!(joined.moved > 0.0);
                    assert_eq!(moving[0] == 0, *joined.f.net() == f);
                }
            }
        }
    }
}

#[test]
fn what_cannot_be_joined() {
    let f = shape(&Form::from_points(&[3], 2, &[0., 0., 1., 1., 2., 1.], None).unwrap());
    let g = shape(&Form::from_points(&[3], 2, &[2., 1.5, 3., 2., 4., 0.], None).unwrap());
    let join = |smoothness, moving| family(join_forms(&f, &g, THROUGH, smoothness, moving));
    assert_eq!(join(Smoothness::Parametric(1), [0, 1]), "Degenerate");
    assert_eq!(join(Smoothness::Parametric(0), [0, 0]), "Degenerate");
    assert_eq!(join(Smoothness::Parametric(1), [0, 9]), "Shape");
    assert_eq!(join(Smoothness::Geometric(3), [1, 1]), "Domain");
    let still = shape(&Form::from_points(&[3], 2, &[2., 1., 2., 1., 4., 0.], None).unwrap());
    let tangent = join_forms(&f, &still, THROUGH, Smoothness::Geometric(1), [2, 2]);
    assert_eq!(family(tangent), "Degenerate");
    let solid = shape(&Form::from_points(&[3], 3, &[0.0; 9], None).unwrap());
    assert_eq!(family(join_forms(&f, &solid, THROUGH, Smoothness::Parametric(0), [1, 1])), "Shape");
    assert_eq!(family(continuity(&f, &solid, THROUGH, up_to(1))), "Shape");
    let ends = [FormEnd::end(1), FormEnd::start(0)];
    assert_eq!(family(continuity(&f, &g, ends, up_to(1))), "Shape");
    assert_eq!(family(continuity(&f, &g, THROUGH, up_to(99))), "Domain");
    let loose = ContinuityOptions { order: 1, accuracy: f64::NAN };
    assert_eq!(family(continuity(&f, &g, THROUGH, loose)), "Domain");
}

#[test]
fn unit_speed_stays_on_the_curve() {
    let w = 0.5_f64.sqrt();
    let arc = Form::from_points(&[3], 2, &[2., 0., 2., 2., 0., 2.], Some(&[1., w, 1.])).unwrap();
    for accuracy in [1e-6, 1e-9, 1e-12] {
        let even = by_arc_length(arc.clone(), accuracy).unwrap();
        assert!(even.error <= accuracy);
        assert!((even.length - std::f64::consts::PI).abs() < 1e-13);
        for i in 0..=20 {
            let s = even.length * f64::from(i) / 20.0;
            let point = even.spline.at(&[s]).unwrap();
            assert!((point[0].hypot(point[1]) - 2.0).abs() < 1e-13);
            // The length is the angle times the radius.
            assert!((point[1].atan2(point[0]) - 0.5 * s).abs() <= 2.0 * accuracy + 1e-13);
        }
    }
}

#[test]
fn a_spline_at_unit_speed() {
    let mut random = Random::new(97);
    let poles = random.form::<f64>(&[6], 3, Weights::One);
    let spline = bspline(&poles, &[3], &[KnotRule::Uniform], &[false]).unwrap();
    let even = by_arc_length(spline.clone(), 1e-8).unwrap();
    let slope = even.spline.derivative(&[1]).unwrap();
    for i in 1..50 {
        let speed = slope.at(&[even.length * (f64::from(i) + 0.5) / 51.0]).unwrap();
        let speed = speed.iter().fold(0.0_f64, |sum, x| sum.hypot(*x));
        assert!((speed - 1.0).abs() < 2e-8, "{speed}");
    }
    let (from, to) = spline.window(0).unwrap();
    for (t, s) in [(from, 0.0), (to, even.length)] {
        let (a, b) = (spline.at(&[t]).unwrap(), even.spline.at(&[s]).unwrap());
        assert!(a.iter().zip(&b).all(|(x, y)| (x - y).abs() < 1e-14));
    }
}

/// A closed cubic through nine poles of a smooth but lively figure, as peers make them at random.
fn lively(random: &mut Random) -> Spline {
    let poles: Vec<f64> = (0..18).map(|_| random.unit() + random.unit() - 1.0).collect();
    let poles = Form::from_points(&[9], 2, &poles, None).unwrap();
    bspline(&poles, &[3], &[KnotRule::Uniform], &[true]).unwrap()
}

#[test]
fn unit_speed_to_twelve_digits() {
    let mut random = Random::new(12);
    for _ in 0..3 {
        let curve = lively(&mut random);
        let even = by_arc_length(curve.clone(), 1e-12).unwrap();
        assert!(even.error <= 1e-12);
        assert_eq!(even.spline.window(0).unwrap().1, even.length);
        let slopes = even.spline.derivative(&[1]).unwrap();
        let knots = &even.spline.breaks()[0];
        let size = curve.net().homogeneous().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        for pair in knots.windows(2).step_by(7) {
            let step = pair[1] - pair[0];
            // Poles of degree 15 and knots are rounded: that is felt in short pieces.
            let rounding = 64.0 * f64::EPSILON * (size + even.length) / step;
            for share in [0.1, 0.37, 0.6, 0.93] {
                let slope = slopes.at(&[pair[0] + share * step]).unwrap();
                let speed = slope[0].hypot(slope[1]);
                assert!((speed - 1.0).abs() <= even.error + rounding, "{speed} {step}");
            }
        }
    }
}

#[test]
fn what_has_no_unit_speed() {
    let cusp = Form::from_points(&[4], 2, &[0., 0., 0., 0., 1., 0., 1., 1.], None).unwrap();
    assert_eq!(family(by_arc_length(cusp, 1e-6)), "Degenerate");
    let still = Form::from_points(&[2], 2, &[1.0; 4], None).unwrap();
    assert_eq!(family(by_arc_length(still, 1e-6)), "Degenerate");
    let line = Form::from_points(&[2], 2, &[0., 0., 3., 4.], None).unwrap();
    assert_eq!(family(by_arc_length(line.clone(), 0.0)), "Domain");
    let even = by_arc_length(line, 1e-12).unwrap();
    assert_eq!((even.length, even.spline.counts()), (5.0, vec![1]));
    let facet = Form::from_points(&[2, 2], 1, &[0.0; 4], None).unwrap();
    assert_eq!(family(by_arc_length(Spline::from(facet), 1e-6)), "Shape");
}

#[test]
fn a_form_of_many_axes_has_too_many_joints() {
    let form: Form = Form::from_homogeneous(&[1; 30], 1, vec![1.0; 2]).unwrap();
    let refused = joints(&form.into(), 0, up_to(2)).unwrap_err();
    assert_eq!(refused.family(), "Limit");
}
