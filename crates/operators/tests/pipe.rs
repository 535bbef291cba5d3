//! Tubes against the true ones, which are computed point by point from frames of another making.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

mod common;

use common::{distance, family};
use pforms_kernel::Form;
use pforms_operators::{FrameKind, Law, Pipe, PipeOptions, Spline, curve_frames, pipe, stretch};
use pforms_testkit::{Random, Weights};

/// The whole unit circle as one rational quartic, in rational numbers: `exp(4i·atan(2t − 1))`.
fn circle() -> Form {
    let points = [-1., 0., 0., -1., 3., 0., 0., 1., -1., 0.];
    Form::from_points(&[5], 2, &points, Some(&[1., 0., 1. / 3., 0., 1.])).unwrap()
}

fn curve(points: &[[f64; 3]]) -> Form {
    Form::from_points(&[points.len()], 3, &points.concat(), None).unwrap()
}

fn s_curve() -> Form {
    curve(&[[0., 0., 0.], [2., 0., 0.], [-1., 2., 0.], [1., 2., 0.]])
}

fn tube(path: &Form, section: &Form, options: &PipeOptions) -> Pipe {
    pipe(&path.clone().into(), &section.clone().into(), options).unwrap()
}

fn refused(path: &Form, section: &Form, options: &PipeOptions) -> &'static str {
    family(pipe(&path.clone().into(), &section.clone().into(), options))
}

fn of(radius: f64) -> PipeOptions {
    PipeOptions { radius: radius.into(), ..PipeOptions::default() }
}

/// Parameters across a window, denser than the pieces of any tube here.
fn parameters(count: usize) -> Vec<f64> {
    (0..=count).map(|i| i as f64 / count as f64).collect()
}

/// The largest distance at samples from the tube that frames make point by point.
fn measured(
    path: &Form,
    section: &Form,
    tube: &Pipe,
    kind: FrameKind,
    radius: impl Fn(f64) -> f64,
    twist: impl Fn(f64) -> f64,
) -> f64 {
    let us = parameters(331);
    let frames = curve_frames(path, &us, kind, 1e-12).unwrap();
    let mut worst = 0.0_f64;
    for (u, frame) in us.iter().zip(frames) {
        let (normal, binormal) = (frame.normal.unwrap(), frame.binormal.unwrap());
        let (sine, cosine) = twist(*u).sin_cos();
        for v in parameters(13) {
            let mut s = section.at(&[v]).unwrap();
            s.resize(3, 0.0);
            let [x, y] = [cosine * s[0] - sine * s[1], sine * s[0] + cosine * s[1]];
            let point: Vec<f64> = (0..3)
                .map(|k| {
                    frame.point[k]
                        + radius(*u) * (normal[k] * x + binormal[k] * y + frame.tangent[k] * s[2])
                })
                .collect();
            worst = worst.max(distance(&point, &tube.spline.at(&[*u, v]).unwrap()));
        }
    }
    worst
}

#[test]
fn the_reported_error_bounds_the_true_one_and_meets_the_tolerance() {
    for seed in 0..10 {
        let mut random = Random::new(seed);
        let weights = [Weights::One, Weights::Positive][seed as usize % 2];
        let order = random.size(3, 6);
        let path: Form = random.form(&[order], 3, weights);
        for tolerance in [1e-2, 1e-5, 1e-9] {
            let options = PipeOptions { tolerance: Some(tolerance), ..of(0.3) };
            let tube = tube(&path, &circle(), &options);
            let kind = FrameKind::RotationMinimising;
            let off = measured(&path, &circle(), &tube, kind, |_| 0.3, |_| 0.0);
            // The frames they are compared with are 1e-12 off themselves.
            assert!(off <= tube.error + 1e-12, "{seed} {tolerance}: {off} > {}", tube.error);
            assert!(tube.error <= tolerance, "{seed}: {}", tube.error);
        }
    }
}

/// A curve in space that bends to one side: the Frenet frame exists everywhere.
fn bending_curve() -> Form {
    curve(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.5], [0., 1., 1.5]])
}

#[test]
fn frenet_frames_too() {
    for tolerance in [1e-3, 1e-6, 1e-10] {
        let options =
            PipeOptions { tolerance: Some(tolerance), frame: FrameKind::Frenet, ..of(0.25) };
        let tube = tube(&bending_curve(), &circle(), &options);
        let kind = FrameKind::Frenet;
        let off = measured(&bending_curve(), &circle(), &tube, kind, |_| 0.25, |_| 0.0);
        assert!(off <= tube.error && tube.error <= tolerance, "{off} {}", tube.error);
    }
}

#[test]
fn radius_and_twist_vary_by_laws() {
    let radius = Form::from_points(&[3], 1, &[0.1, 0.5, 0.2], None).unwrap();
    let twist = Form::from_points(&[2], 1, &[0.0, 9.0], None).unwrap();
    let square = Form::from_points(&[2], 2, &[-1., -1., 1., -1.], None).unwrap();
    for tolerance in [1e-3, 1e-7] {
        let options = PipeOptions {
            radius: radius.clone().into(),
            twist: twist.clone().into(),
            tolerance: Some(tolerance),
            ..PipeOptions::default()
        };
        let tube = tube(&bending_curve(), &square, &options);
        let kind = FrameKind::RotationMinimising;
        let width = |u: f64| radius.at(&[u]).unwrap()[0];
        let off = measured(&bending_curve(), &square, &tube, kind, width, |u| 9.0 * u);
        assert!(off <= tube.error && tube.error <= tolerance, "{off} {}", tube.error);
    }
    let wave = Law::Wave { mean: 0.2, amplitude: 0.5, periods: 5.0 };
    let options = PipeOptions { radius: wave, twist: Law::Constant(1.0), ..PipeOptions::default() };
    let tube = tube(&bending_curve(), &square, &options);
    let width = |u: f64| 0.2 * (1.0 + 0.5 * (std::f64::consts::TAU * 5.0 * u).sin());
    let kind = FrameKind::RotationMinimising;
    let off = measured(&bending_curve(), &square, &tube, kind, width, |_| 1.0);
    assert!(off <= tube.error && tube.error <= 1e-6, "{off} {}", tube.error);
}

#[test]
fn sections_may_leave_their_plane_and_have_any_axes() {
    let helix: Form =
        Form::from_points(&[3], 3, &[0.1, 0., 0., 0., 0.1, 0.1, -0.1, 0., 0.3], None).unwrap();
    let bent = tube(&bending_curve(), &helix, &of(1.0));
    let kind = FrameKind::RotationMinimising;
    let off = measured(&bending_curve(), &helix, &bent, kind, |_| 1.0, |_| 0.0);
    assert!(off <= bent.error && bent.error < 1e-6);

    let point: Form = Form::point(&[0.2, 0.1]).unwrap();
    assert_eq!(tube(&bending_curve(), &point, &of(1.0)).spline.axes(), 1);
    let disc: Form =
        Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 1., 0., 1., 1.], None).unwrap();
    assert_eq!(tube(&bending_curve(), &disc, &of(0.1)).spline.axes(), 3);
    let flat: Form =
        Form::from_points(&[3], 3, &[1., 0., 0., 0., 0., 1., -1., 0., 0.], None).unwrap();
    assert_eq!(refused(&bending_curve(), &flat, &of(0.1)), "Degenerate");
    let lonely: Form = Form::from_points(&[2], 1, &[1., 2.], None).unwrap();
    assert_eq!(refused(&bending_curve(), &lonely, &of(0.1)), "Shape");
}

#[test]
fn a_straight_pipe_is_exact_and_its_path_always() {
    let line = curve(&[[0., 0., 0.], [0., 0., 1.], [0., 0., 3.]]);
    let straight = tube(&line, &circle(), &of(2.0));
    assert_eq!(straight.spline.counts(), [1, 1]);
    assert_eq!(straight.spline.degrees(), [2, 4]);
    let p = straight.spline.at(&[0.5, 0.3]).unwrap();
    assert!((p[0].hypot(p[1]) - 2.0).abs() < 1e-15 && (p[2] - 1.25).abs() < 1e-15, "{p:?}");

    let centre: Form = Form::point(&[0., 0.]).unwrap();
    let mut random = Random::new(3);
    for weights in [Weights::One, Weights::Positive] {
        let path: Form = random.form(&[5], 3, weights);
        let along = tube(&path, &centre, &PipeOptions { tolerance: Some(1e-3), ..of(1.0) });
        for u in parameters(50) {
            let gap = distance(&along.spline.at(&[u]).unwrap(), &path.at(&[u]).unwrap());
            assert!(gap < 1e-14 * 10.0, "rounding of degree 10: {gap}");
        }
    }
}

/// The vector from the path to the section's first point.
fn spoke(tube: &Pipe, path: &Form, u: f64) -> Vec<f64> {
    let (a, b) = (tube.spline.at(&[u, 0.0]).unwrap(), path.at(&[u]).unwrap());
    a.iter().zip(&b).map(|(a, b)| a - b).collect()
}

fn turn_over(tube: &Pipe, path: &Form) -> f64 {
    let us = parameters(2000);
    let spokes: Vec<Vec<f64>> = us.iter().map(|u| spoke(tube, path, *u)).collect();
    let turns = spokes.windows(2).map(|pair| distance(&pair[0], &pair[1]));
    turns.fold(0.0, f64::max)
}

#[test]
fn nothing_turns_over_at_an_inflection_or_along_a_straight_stretch() {
    let path = s_curve();
    let tube_ = tube(&path, &circle(), &of(0.2));
    // The tangent turns by about two radians in all, faster where the path is slow.
    assert!(turn_over(&tube_, &path) < 0.2 * 0.05, "{}", turn_over(&tube_, &path));
    let frenet = PipeOptions { frame: FrameKind::Frenet, ..of(0.2) };
    assert_eq!(refused(&path, &circle(), &frenet), "Degenerate");

    let bend = [
        curve(&[[0., 0., 0.], [1., 0., 0.], [2., 0., 0.], [3., 0., 0.]]),
        curve(&[[3., 0., 0.], [4., 0., 0.], [5., 0., 0.], [6., 1., 0.]]),
        curve(&[[6., 1., 0.], [7., 2., 0.], [8., 2., 0.], [9., 2., 1.]]),
    ];
    let path = Spline::end_to_end(&bend, 0, &[0., 1., 2., 3.]).unwrap();
    let along = pipe(&path, &circle().into(), &of(0.2)).unwrap();
    assert!(along.error < 2e-7);
    let mut before: Option<Vec<f64>> = None;
    for u in parameters(3000).iter().map(|u| 3.0 * u) {
        let centre = path.at(&[u]).unwrap();
        let rim = along.spline.at(&[u, 0.25]).unwrap();
        assert!((distance(&centre, &rim) - 0.2).abs() < 1e-6);
        let spoke: Vec<f64> = rim.iter().zip(&centre).map(|(a, b)| a - b).collect();
        if let Some(before) = before.replace(spoke.clone()) {
            assert!(distance(&before, &spoke) < 0.01, "{u}");
        }
    }
    let family = family(pipe(&path, &circle().into(), &frenet));
    assert_eq!(family, "Degenerate");
}

/// The trefoil's sister: a closed curve out of every plane, by periodic windows of a cubic.
fn closed_path() -> Spline {
    let corners = [[2., 0., 0.5], [1., 2., -0.7], [-1., 1.5, 0.9], [-2., 0., -0.4], [0., -2., 0.8]];
    let count = corners.len();
    let net: Vec<f64> = (0..count + 3).flat_map(|i| corners[i % count]).collect();
    let knots = (0..count + 7).map(|i| i as f64).collect();
    let net = Form::from_points(&[count + 3], 3, &net, None).unwrap();
    Spline::new(net, &[3], vec![knots]).unwrap()
}

#[test]
fn closed_paths_make_closed_tubes() {
    let path = closed_path();
    let (from, to) = path.window(0).unwrap();
    let ring = pipe(&path, &circle().into(), &of(0.3)).unwrap();
    assert!(ring.closing.abs() > 0.01, "{}", ring.closing);
    for v in parameters(20) {
        let [a, b] = [from, to].map(|u| ring.spline.at(&[u, v]).unwrap());
        assert!(distance(&a, &b) < 1e-14, "the same poles");
    }
    let open = PipeOptions { closed: Some(false), ..of(0.3) };
    let open = pipe(&path, &circle().into(), &open).unwrap();
    assert!(open.closing.abs() == 0.0);
    let [a, b] = [from, to].map(|u| open.spline.at(&[u, 0.0]).unwrap());
    // What is left open is the closing angle, seen from the radius.
    let chord = 2.0 * 0.3 * (ring.closing / 2.0).sin().abs();
    assert!((distance(&a, &b) - chord).abs() < 1e-6);
    let turned = PipeOptions {
        twist: Form::from_points(&[2], 1, &[0., std::f64::consts::TAU], None).unwrap().into(),
        ..of(0.3)
    };
    let turned = pipe(&path, &circle().into(), &turned).unwrap();
    let [a, b] = [from, to].map(|u| turned.spline.at(&[u, 0.25]).unwrap());
    assert!(distance(&a, &b) < 1e-14, "a whole turn closes");
    let line = curve(&[[0., 0., 0.], [1., 0., 0.]]);
    let closed = PipeOptions { closed: Some(true), ..of(0.1) };
    assert_eq!(refused(&line, &circle(), &closed), "Degenerate");
}

#[test]
fn a_torus_is_a_pipe() {
    let flat = circle();
    let poles: Vec<f64> =
        flat.homogeneous().chunks_exact(3).flat_map(|p| [2. * p[0], 2. * p[1], 0., p[2]]).collect();
    let path = Form::from_homogeneous(&[5], 3, poles).unwrap();
    for frame in [FrameKind::Frenet, FrameKind::RotationMinimising] {
        let options = PipeOptions { frame, tolerance: Some(1e-9), ..of(0.5) };
        let ring = tube(&path, &circle(), &options);
        assert!(ring.error <= 1e-9);
        for u in parameters(40) {
            for v in parameters(40) {
                let p = ring.spline.at(&[u, v]).unwrap();
                let from_rim = (p[0].hypot(p[1]) - 2.0).hypot(p[2]);
                assert!((from_rim - 0.5).abs() <= ring.error);
            }
        }
        // The inner equator: 0.5 against a radius of curvature of 2.
        assert!((ring.bending - 0.25).abs() < 1e-3, "{}", ring.bending);
        let fat = tube(&path, &circle(), &PipeOptions { frame, ..of(3.0) });
        assert!(fat.bending > 1.0, "said to run into itself: {}", fat.bending);
    }
}

#[test]
fn poles_that_repeat_are_passed_and_cusps_are_not() {
    // Twice the same pole at either end: the path starts and stops without speed.
    let lazy = curve(&[[0., 0., 0.], [0., 0., 0.], [1., 2., 0.], [3., 1., 1.], [3., 1., 1.]]);
    for frame in [FrameKind::Frenet, FrameKind::RotationMinimising] {
        let tube = tube(&lazy, &circle(), &PipeOptions { frame, ..of(0.1) });
        assert!(tube.error < 2e-7);
        for u in parameters(20) {
            let gap = distance(&tube.spline.at(&[u, 0.2]).unwrap(), &lazy.at(&[u]).unwrap());
            assert!((gap - 0.1).abs() < 1e-6, "{u}: {gap}");
        }
    }
    let cusp = curve(&[[0., 0., 0.], [1., 1., 0.], [0., 1., 0.], [1., 0., 0.]]);
    assert_eq!(refused(&cusp, &circle(), &of(0.1)), "Degenerate");
    let askew = stretch(&cusp, &[0.1], &[0.97]).unwrap();
    assert_eq!(refused(&askew, &circle(), &of(0.1)), "Degenerate");
    let still = curve(&[[1., 1., 1.], [1., 1., 1.], [1., 1., 1.]]);
    assert_eq!(refused(&still, &circle(), &of(0.1)), "Degenerate");
    let corner = [curve(&[[0., 0., 0.], [1., 0., 0.]]), curve(&[[1., 0., 0.], [1., 1., 0.]])];
    let corner = Spline::end_to_end(&corner, 0, &[0., 1., 2.]).unwrap();
    assert_eq!(family(pipe(&corner, &circle().into(), &of(0.1))), "Degenerate");
    let gap = [curve(&[[0., 0., 0.], [1., 0., 0.]]), curve(&[[2., 0., 0.], [3., 0., 0.]])];
    let gap = Spline::end_to_end(&gap, 0, &[0., 1., 2.]).unwrap();
    assert_eq!(family(pipe(&gap, &circle().into(), &of(0.1))), "Degenerate");
}

#[test]
fn a_radius_may_touch_zero_and_not_cross_it() {
    let law = |values: &[f64]| PipeOptions {
        radius: Form::from_points(&[values.len()], 1, values, None).unwrap().into(),
        ..PipeOptions::default()
    };
    let path = bending_curve();
    let spindle = tube(&path, &circle(), &law(&[0.0, 0.5, 0.0]));
    assert!(distance(&spindle.spline.at(&[0.0, 0.3]).unwrap(), &[0., 0., 0.]) == 0.0);
    // (2u − 1)² touches 0 half-way; a little less crosses it.
    tube(&path, &circle(), &law(&[1.0, -1.0, 1.0]));
    assert_eq!(refused(&path, &circle(), &law(&[1.0, -1.0001, 1.0])), "Domain");
    assert_eq!(refused(&path, &circle(), &law(&[0.1, -0.1])), "Domain");
    assert_eq!(refused(&path, &circle(), &of(-1.0)), "Domain");
    assert_eq!(refused(&path, &circle(), &of(f64::NAN)), "Domain");
    let wave = Law::Wave { mean: 1.0, amplitude: 1.5, periods: 2.0 };
    let wave = PipeOptions { radius: wave, ..PipeOptions::default() };
    assert_eq!(refused(&path, &circle(), &wave), "Domain");
    let plane: Form = Form::from_points(&[2], 2, &[1., 0., 1., 1.], None).unwrap();
    let plane = PipeOptions { radius: plane.into(), ..PipeOptions::default() };
    assert_eq!(refused(&path, &circle(), &plane), "Shape");
}

#[test]
fn sizes_do_not_matter() {
    let bending = tube(&bending_curve(), &circle(), &of(0.2)).bending;
    for scale in [1e-290, 1e-200, 1e-160, 1e-150, 1e-9, 1e9, 1e150, 1e200, 1e290] {
        let path = bending_curve();
        let scaled: Vec<f64> = path.points().unwrap().iter().map(|x| x * scale).collect();
        let path = Form::from_points(&[4], 3, &scaled, None).unwrap();
        let tube = tube(&path, &circle(), &of(0.2 * scale));
        assert!(tube.error < 0.2 * scale * 1e-6 && tube.error > 0.0, "{}", tube.error);
        assert!((tube.bending - bending).abs() < 1e-9, "{}", tube.bending);
        let p = tube.spline.at(&[0.4, 0.6]).unwrap();
        let unscaled = |point: &[f64]| point.iter().map(|x| x / scale).collect::<Vec<_>>();
        let gap = distance(&unscaled(&path.at(&[0.4]).unwrap()), &unscaled(&p));
        assert!((gap - 0.2).abs() < 1e-6, "{gap}");
        // A small section instead of a small radius.
        let points: Vec<f64> =
            [-1., 0., 0., -1., 3., 0., 0., 1., -1., 0.].map(|x| x * scale).into();
        let small = Form::from_points(&[5], 2, &points, Some(&[1., 0., 1. / 3., 0., 1.])).unwrap();
        let same = pipe(&path.clone().into(), &small.into(), &of(0.2)).unwrap();
        assert!((same.bending - bending).abs() < 1e-9 && same.error > 0.0);
    }
}

#[test]
fn far_from_the_origin_it_is_as_good_as_the_numbers_are() {
    let path = bending_curve();
    let moved: Vec<f64> = path.points().unwrap().iter().map(|x| x + 1e6).collect();
    let path = Form::from_points(&[4], 3, &moved, None).unwrap();
    let tube = tube(&path, &circle(), &of(0.2));
    let gap = distance(&path.at(&[0.4]).unwrap(), &tube.spline.at(&[0.4, 0.6]).unwrap());
    assert!((gap - 0.2).abs() < 1e-6 && tube.error < 1e-6, "{gap} {}", tube.error);
}

#[test]
fn unreasonable_wishes_are_refused() {
    let path = bending_curve();
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let options = PipeOptions { tolerance: Some(tolerance), ..of(0.1) };
        assert_eq!(refused(&path, &circle(), &options), "Domain");
    }
    let options = PipeOptions { tolerance: Some(1e-30), ..of(0.1) };
    assert_eq!(refused(&path, &circle(), &options), "Accuracy");
    let options = PipeOptions { frame: FrameKind::Tangent, ..of(0.1) };
    assert_eq!(refused(&path, &circle(), &options), "Domain");
    let surface: Form = Form::from_points(&[2, 2], 3, &[0.; 12], None).unwrap();
    assert_eq!(refused(&surface, &circle(), &of(0.1)), "Shape");
    let far = Form::from_points(&[2], 3, &[0., 0., 0., 1., 0., 0.], Some(&[1., -1.])).unwrap();
    assert_eq!(refused(&far, &circle(), &of(0.1)), "Domain");
    let open: Form = Form::from_points(&[2], 2, &[1., 0., 1., 1.], Some(&[1., -1.])).unwrap();
    assert_eq!(refused(&path, &open, &of(0.1)), "Domain");
}
