//! Frames of curves whose geometry is known.
#![allow(clippy::unwrap_used)]

mod common;

use common::{distance, family, quarter};
use pforms_kernel::Form;
use pforms_operators::{CurveFrame, FrameKind, curve_frame, curve_frames};

fn curve(ambient: usize, points: &[f64]) -> Form {
    Form::from_points(&[points.len() / ambient], ambient, points, None).unwrap()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn normal(frame: &CurveFrame) -> &[f64] {
    frame.normal.as_deref().unwrap()
}

/// A circle of radius `r` in the plane `z = height`, a quarter of it.
fn circle(r: f64, height: f64) -> Form {
    let poles = quarter().iter().flat_map(|[x, y, w]| [r * x, r * y, height * w, *w]).collect();
    Form::from_homogeneous(&[3], 3, poles).unwrap()
}

#[test]
fn a_circle() {
    let mut worst = 0.0_f64;
    for (r, height) in [(1.0, 0.0), (4.0, 3.0), (0.01, 7.0)] {
        for t in [-3.0, 0.0, 0.2, 0.5, 0.9, 1.0, 4.0] {
            let frame = curve_frame(&circle(r, height), t).unwrap();
            let inward = [-frame.point[0] / r, -frame.point[1] / r, 0.0];
            worst = worst.max((frame.curvature * r - 1.0).abs());
            assert!(distance(normal(&frame), &inward) < 2e-14 * (1.0 + height / r));
            let up = frame.binormal.as_ref().unwrap();
            assert!(distance(up, &[0.0, 0.0, 1.0]) < 1e-14);
            assert!(frame.torsion.unwrap().abs() < 1e-12 / r);
        }
    }
    println!("curvature of a circle: {worst:.1e}");
    assert!(worst < 1e-13);
}

#[test]
fn a_twisted_cubic() {
    // (t, t², t³): curvature and torsion in closed form.
    let third = 1.0 / 3.0;
    let cubic = curve(3, &[0., 0., 0., third, 0., 0., 2. * third, third, 0., 1., 1., 1.]);
    for t in [0.0, 0.25, 0.5, 1.0, 3.0, -2.0_f64] {
        let frame = curve_frame(&cubic, t).unwrap();
        let (a, b) = (1.0 + 4.0 * t * t + 9.0 * t.powi(4), 1.0 + 9.0 * t * t + 9.0 * t.powi(4));
        assert!((frame.curvature - 2.0 * (b / a.powi(3)).sqrt()).abs() < 1e-13);
        assert!((frame.torsion.unwrap() - 3.0 / b).abs() < 1e-12);
        assert!((frame.speed - a.sqrt()).abs() < 1e-13 * a);
        let natural = frame.unnormalised(FrameKind::Frenet);
        assert!(distance(&natural.tangent, &[1.0, 2.0 * t, 3.0 * t * t]) < 1e-13 * a);
        let area = [6.0 * t * t, -6.0 * t, 2.0];
        assert!(distance(&natural.binormal.unwrap(), &area) < 1e-13 * a);
    }
}

#[test]
fn plane_curves_have_a_sign() {
    let wave = curve(2, &[0., 0., 1., 2., 2., -2., 3., 0.]);
    let (left, middle, right) = (
        curve_frame(&wave, 0.9).unwrap(),
        curve_frame(&wave, 0.5).unwrap(),
        curve_frame(&wave, 0.1).unwrap(),
    );
    assert!(left.curvature > 0.0 && right.curvature < 0.0 && middle.curvature.abs() < 1e-15);
    for frame in [left, middle, right] {
        assert_eq!(normal(&frame), [-frame.tangent[1], frame.tangent[0]]);
        assert!(frame.binormal.is_none() && frame.torsion.is_none());
    }
}

#[test]
fn four_dimensions_have_a_normal_and_a_curvature() {
    let curve = curve(4, &[0., 0., 0., 0., 1., 0., 0., 0., 1., 1., 0., 0., 1., 1., 0., 5.]);
    let frame = curve_frame(&curve, 0.0).unwrap();
    assert_eq!(frame.tangent, [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(normal(&frame), [0.0, 1.0, 0.0, 0.0]);
    assert!((frame.curvature - 2.0 / 3.0).abs() < 1e-15 && frame.binormal.is_none());
}

#[test]
fn coincident_poles_use_the_next_derivative() {
    // First two poles and last two poles coincide.
    let eased = curve(3, &[0., 0., 0., 0., 0., 0., 1., 2., 0., 4., 0., 4., 4., 0., 4.]);
    let (first, last) = (curve_frame(&eased, 0.0).unwrap(), curve_frame(&eased, 1.0).unwrap());
    assert!(distance(&first.tangent, &[0.2_f64.sqrt(), 0.8_f64.sqrt(), 0.0]) < 1e-15);
    let way = [3.0, -2.0, 4.0].map(|x| x / 29.0_f64.sqrt());
    assert!(distance(&last.tangent, &way) < 1e-15);
    assert_eq!((first.speed, first.curvature), (0.0, f64::INFINITY));
    // The limits are those of frames close by.
    for (frame, near) in [(first, 1e-7), (last, 1.0 - 1e-7)] {
        let close = curve_frame(&eased, near).unwrap();
        assert!(distance(&frame.tangent, &close.tangent) < 1e-6);
        assert!(distance(normal(&frame), normal(&close)) < 1e-6);
        assert!(distance(&frame.binormal.unwrap(), &close.binormal.unwrap()) < 1e-6);
    }
}

#[test]
fn a_cusp_of_finite_curvature() {
    // (t², t⁴, t⁶): the parabola y = x², twice over, with a stop at its vertex.
    let stop = curve(
        3,
        &[
            0.,
            0.,
            0.,
            0.,
            0.,
            0.,
            1. / 15.,
            0.,
            0.,
            0.2,
            0.,
            0.,
            0.4,
            1. / 15.,
            0.,
            2. / 3.,
            1. / 3.,
            0.,
            1.,
            1.,
            1.,
        ],
    );
    let frame = curve_frame(&stop, 0.0).unwrap();
    assert!(distance(&frame.tangent, &[1.0, 0.0, 0.0]) < 1e-15);
    assert!((frame.curvature - 2.0).abs() < 1e-13);
    assert!((frame.torsion.unwrap() - 3.0).abs() < 1e-12);
}

#[test]
fn tangents_of_any_weights_point_forwards() {
    // ERRATA: the listing reverses T where neighbouring weights change sign.
    let poles = vec![0., 0., 0., 1., -1., 0., -1., -0.5, 2., 2., 0., 1., 4., 0., 1., 1.5];
    let curve = Form::from_homogeneous(&[4], 3, poles).unwrap();
    for t in [0.0, 0.05, 0.8, 0.95, 1.0 - 1e-6] {
        let h = 1e-6;
        let (a, b) = (curve.at(&[t]).unwrap(), curve.at(&[t + h]).unwrap());
        let chord: Vec<f64> = b.iter().zip(&a).map(|(b, a)| b - a).collect();
        let tangent = curve_frame(&curve, t).unwrap().tangent;
        assert!(dot(&tangent, &chord) / dot(&chord, &chord).sqrt() > 0.999);
    }
}

#[test]
fn frenet_flips_at_an_inflection_and_rotation_minimising_does_not() {
    let wave = curve(3, &[0., 0., 0., 1., 2., 0., 2., -2., 0., 3., 0., 0.]);
    let parameters: Vec<f64> = (0..=40).map(|i| f64::from(i) / 40.0).collect();
    let frenet = curve_frames(&wave, &parameters, FrameKind::Frenet, 0.0).unwrap();
    let steady = curve_frames(&wave, &parameters, FrameKind::RotationMinimising, 1e-9).unwrap();
    assert!(dot(normal(&frenet[10]), normal(&frenet[30])) < 0.0);
    for pair in steady.windows(2) {
        assert!(dot(normal(&pair[0]), normal(&pair[1])) > 0.9);
    }
    for (frame, other) in steady.iter().zip(&frenet) {
        // In a plane the normal stays in the plane: it is the principal normal but for its side.
        assert!((dot(normal(frame), normal(other)).abs() - 1.0).abs() < 1e-12);
        assert!(dot(normal(frame), &frame.tangent).abs() < 1e-14);
        assert!((dot(normal(frame), normal(frame)) - 1.0).abs() < 1e-14);
    }
}

#[test]
fn rotation_minimising_frames_turn_by_the_integral_of_torsion() {
    // The angle from the principal normal grows by −∫ τ ds.
    let third = 1.0 / 3.0;
    let cubic = curve(3, &[0., 0., 0., third, 0., 0., 2. * third, third, 0., 1., 1., 1.]);
    let steps = 400;
    let turn = |t: f64| {
        let frame = curve_frame(&cubic, t).unwrap();
        frame.torsion.unwrap() * frame.speed
    };
    let simpson: f64 = (0..steps)
        .map(|i| {
            let h = 1.0 / f64::from(steps);
            let a = f64::from(i) * h;
            h / 6.0 * (turn(a) + 4.0 * turn(a + h / 2.0) + turn(a + h))
        })
        .sum();
    for accuracy in [1e-4, 1e-7, 1e-10] {
        let kind = FrameKind::RotationMinimising;
        let steady = &curve_frames(&cubic, &[1.0], kind, accuracy).unwrap()[0];
        let frenet = curve_frame(&cubic, 1.0).unwrap();
        let (x, y) = (
            dot(normal(steady), normal(&frenet)),
            dot(normal(steady), frenet.binormal.as_ref().unwrap()),
        );
        let angle = y.atan2(x);
        println!("accuracy {accuracy:.0e}: error {:.1e}", angle + simpson);
        assert!((angle + simpson).abs() < accuracy);
    }
}

#[test]
fn the_answer_does_not_depend_on_the_company() {
    let curve = curve(3, &[0., 0., 0., 1., 2., 0., 2., -2., 3., 3., 0., 0., 5., 1., 1.]);
    let kind = FrameKind::RotationMinimising;
    let together = curve_frames(&curve, &[0.7, -0.5, 0.1, 1.2, 0.0], kind, 1e-9).unwrap();
    for frame in &together {
        let alone = &curve_frames(&curve, &[frame.parameter], kind, 1e-9).unwrap()[0];
        assert!(distance(normal(frame), normal(alone)) < 2e-9);
    }
    assert_eq!(normal(&together[4]), normal(&curve_frame(&curve, 0.0).unwrap()));
}

#[test]
fn straight_lines_and_points() {
    let line = curve(3, &[0., 0., 0., 1., 1., 1., 2., 2., 2.]);
    assert_eq!(family(curve_frame(&line, 0.3)), "Degenerate");
    let bare = &curve_frames(&line, &[0.3], FrameKind::Tangent, 0.0).unwrap()[0];
    assert_eq!((bare.curvature, bare.torsion, bare.normal.is_none()), (0.0, Some(0.0), true));
    let steady = curve_frames(&line, &[0.0, 1.0], FrameKind::RotationMinimising, 1e-9).unwrap();
    assert!(distance(normal(&steady[0]), normal(&steady[1])) < 1e-15);
    // Rounded data on a skew line, far from the origin: still a line.
    let skew: Vec<f64> = (0..5)
        .flat_map(|i| [1.0, 1.0 / 3.0, 0.7].map(|d| 100.0 + d * f64::from(i) / 7.0))
        .collect();
    assert_eq!(family(curve_frame(&curve(3, &skew), 0.4)), "Degenerate");
    assert_eq!(family(curve_frame(&curve(3, &[1.0; 9]), 0.5)), "Degenerate");
    assert_eq!(family(curve_frame(&curve(1, &[0.0, 1.0]), 0.5)), "Shape");
    assert_eq!(family(curve_frame(&line, f64::INFINITY)), "Domain");
    let kind = FrameKind::RotationMinimising;
    assert_eq!(family(curve_frames(&line, &[0.5], kind, 0.0)), "Domain");
    let jagged = curve(3, &[0., 0., 0., 9., 9., 0., -9., 9., 9., 1., 0., 0., 4., 4., 9.]);
    assert_eq!(family(curve_frames(&jagged, &[1.0], kind, 1e-300)), "Accuracy");
}

#[test]
fn dense_parameters_far_from_0_keep_their_accuracy_and_distant_ones_are_refused() {
    let curve: Form =
        Form::from_points(&[4], 3, &[0., 0., 0., 1., 2., 0., 2., -2., 1., 3., 0., 3.], None)
            .unwrap();
    let kind = FrameKind::RotationMinimising;
    let dense: Vec<f64> = (0..=20_000).map(|i| 0.5 + f64::from(i) / 40_000.0).collect();
    let frames = curve_frames(&curve, &dense, kind, 1e-9).unwrap();
    let alone = curve_frames(&curve, &[1.0], kind, 1e-9).unwrap();
    let (last, single) = (frames.last().unwrap(), &alone[0]);
    for (a, b) in last.normal.iter().flatten().zip(single.normal.iter().flatten()) {
        assert!((a - b).abs() <= 2e-9, "{a} for {b}");
    }
    for far in [5000.0, -1e9, f64::MAX] {
        assert_eq!(curve_frames(&curve, &[far], kind, 1e-3).unwrap_err().family(), "Domain");
    }
}

#[test]
fn many_parameters_do_not_make_minimising_frames_less_accurate() {
    let path = [0., 0., 0., 2., 0., 1., -1., 2., 0., 1., 2., 3., 0., 0., 2.];
    let path: Form = Form::from_points(&[5], 3, &path, None).unwrap();
    let kind = FrameKind::RotationMinimising;
    let dense: Vec<f64> = (0..=1000).map(|i| f64::from(i) / 1000.0).collect();
    let many = curve_frames(&path, &dense, kind, 1e-12).unwrap();
    let one = curve_frames(&path, &[1.0], kind, 1e-12).unwrap();
    // Each is within the accuracy of the true one.
    let (a, b) = (many[1000].normal.clone().unwrap(), one[0].normal.clone().unwrap());
    assert!(distance(&a, &b) < 2e-12, "{}", distance(&a, &b));
}
