//! Parameters of points: everywhere, twice, nowhere, along a whole edge.
#![allow(clippy::unwrap_used)]

use pforms_kernel::Form;
use pforms_operators::{Inversion, Part, Shape, Spline, invert, sphere};
use pforms_testkit::{Random, Weights};

fn preimages(host: &Shape, point: &[f64]) -> Inversion {
    invert(host, point, 1e-12).unwrap().remove(0)
}

#[test]
fn a_loop_passes_twice() {
    // x = t − t³ scaled, y = t²: passes through one point at two parameters, symmetric to a half.
    let fold: Form = Form::from_points(&[4], 2, &[0., 0., 3., 2., -2., 2., 1., 0.], None).unwrap();
    // The crossing solves x(t) = x(1 − t): 10·t² − 10·t + 1 … its x is that of the middle.
    let x = |t: f64| fold.at(&[t]).unwrap();
    let (mut low, mut high) = (0.01_f64, 0.49_f64);
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if (x(middle)[0] - 0.5) * (x(low)[0] - 0.5) > 0.0 { low = middle } else { high = middle }
    }
    let found = preimages(&fold.clone().into(), &x(low));
    assert_eq!(found.solutions.len(), 2, "{found:?}");
    assert!(found.complete(), "{found:?}");
    assert!((found.solutions[0].parameters[0] - low).abs() < 1e-14);
    assert!((found.solutions[1].parameters[0] - (1.0 - low)).abs() < 1e-13, "{found:?}");
}

#[test]
fn random_hosts_give_their_parameters_back() {
    let mut random = Random::new(3);
    for (orders, ambient) in
        [(&[5][..], 2), (&[4], 3), (&[4, 4], 2), (&[3, 4], 3), (&[3, 3, 3], 3), (&[2, 2, 2, 2], 4)]
    {
        for _ in 0..10 {
            let host: Form = random.rough_form(orders, ambient, Weights::Positive);
            let at: Vec<f64> = orders.iter().map(|_| random.unit()).collect();
            let found = preimages(&host.clone().into(), &host.at(&at).unwrap());
            let hit = found.solutions.iter().any(|solution| {
                let pairs = solution.parameters.iter().zip(&at);
                let gap = pairs.fold(0.0_f64, |most, (s, t)| most.max((s - t).abs()));
                gap <= solution.error + 1e-14 && gap < 1e-10
            });
            assert!(hit, "{orders:?} {at:?}: {found:?}");
            assert!(found.complete(), "{orders:?} {at:?}: {found:?}");
        }
    }
}

#[test]
fn points_outside_have_no_parameters() {
    let square: Form =
        Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 1., 0., 1.5, 1.5], None).unwrap();
    let square: Shape = square.into();
    for (point, inside) in [
        ([0.5, 0.5], true),
        ([-1e-9, 0.5], false),
        ([0.0, 0.0], true),
        ([1.5, 1.5], true),
        ([1.4, 1.5], false),
        ([1e200, 0.0], false),
    ] {
        let found = preimages(&square, &point);
        assert_eq!(found.inside(), inside, "{point:?} {found:?}");
        assert!(found.complete());
    }
    let corner = preimages(&square, &[1.5, 1.5]);
    assert_eq!(corner.solutions[0].parameters, [1.0, 1.0]);
}

#[test]
fn the_pole_of_a_sphere_is_a_whole_edge() {
    let octant = sphere(&1.0, Part::Octant).unwrap();
    let found = preimages(&octant, &[0.0, 1.0, 0.0]);
    assert!(!found.complete() && found.inside(), "{found:?}");
    let doubt = &found.doubts[0];
    let sides: Vec<f64> = doubt.lower.iter().zip(&doubt.upper).map(|(a, b)| b - a).collect();
    assert!(sides.contains(&1.0), "{doubt:?}");
    assert!(sides.iter().any(|side| *side < 1e-6), "{doubt:?}");
}

#[test]
fn a_fold_is_a_doubt_of_its_size() {
    // (u, v) ↦ ((2u − 1)², v): folded along u = 1/2.
    let fold: Form =
        Form::from_points(&[3, 2], 2, &[1., 0., 1., 1., -1., 0., -1., 1., 1., 0., 1., 1.], None)
            .unwrap();
    let fold: Shape = fold.into();
    let twice = preimages(&fold, &[0.25, 0.5]);
    assert!(twice.complete() && twice.solutions.len() == 2, "{twice:?}");
    let once = preimages(&fold, &[0.0, 0.5]);
    assert!(!once.complete() && once.doubts.len() == 1, "{once:?}");
    assert!((once.solutions[0].parameters[0] - 0.5).abs() < 1e-7);
    assert!(once.solutions[0].error < 1e-6, "{once:?}");
    assert!(!preimages(&fold, &[-1e-12, 0.5]).inside());
}

#[test]
fn a_curve_that_runs_back_over_itself() {
    let back: Form = Form::from_points(&[3], 2, &[0., 0., 1., 1., 0., 0.], None).unwrap();
    let found = preimages(&back.into(), &[0.25, 0.25]);
    assert_eq!(found.solutions.len(), 2, "{found:?}");
    let point: Form = Form::from_points(&[3], 2, &[1., 2., 1., 2., 1., 2.], None).unwrap();
    let found = preimages(&point.into(), &[1., 2.]);
    assert_eq!((found.doubts[0].lower[0], found.doubts[0].upper[0]), (0.0, 1.0), "{found:?}");
}

#[test]
fn pieces_meet_once() {
    let net: Form = Form::from_points(&[4], 2, &[0., 0., 0., 2., 2., 2., 2., 0.], None).unwrap();
    let spline = Spline::new(net, &[2], vec![vec![0., 1., 2., 3., 4., 5., 6.]]).unwrap();
    let found = preimages(&spline.into(), &[1.0, 2.0]);
    assert_eq!(found.solutions.len(), 1, "{found:?}");
    assert_eq!(found.solutions[0].parameters, [3.0]);
}

#[test]
fn size_does_not_matter() {
    for scale in [1e-150, 1.0, 1e150] {
        let points: Vec<f64> =
            [0., 0., 0., 1., 1., 0., 1.5, 1.5].iter().map(|x| x * scale).collect();
        let square: Form = Form::from_points(&[2, 2], 2, &points, None).unwrap();
        let point = square.at(&[0.25, 0.625]).unwrap();
        let found = preimages(&square.into(), &point);
        assert_eq!(found.solutions.len(), 1, "{scale}");
        assert!((found.solutions[0].parameters[1] - 0.625).abs() < 1e-15);
    }
}

#[test]
fn bad_input_is_named() {
    let line: Form = Form::from_points(&[2], 2, &[0., 0., 4., 0.], None).unwrap();
    let line: Shape = line.into();
    assert_eq!(invert(&line, &[0.], 1e-12).unwrap_err().family(), "Shape");
    assert_eq!(invert(&line, &[0., f64::NAN], 1e-12).unwrap_err().family(), "Domain");
    assert_eq!(invert(&line, &[0., 0.], -1.0).unwrap_err().family(), "Domain");
    let flat: Form = Form::from_points(&[2, 2], 1, &[0., 1., 2., 3.], None).unwrap();
    assert_eq!(invert(&flat.into(), &[0.], 1e-12).unwrap_err().family(), "Shape");
}
