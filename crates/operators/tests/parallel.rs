//! Parallel curves and surfaces, shells, and poles moved along normals.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use pforms_kernel::{Error, Form};
use pforms_operators::{
    Distance, FrameKind, Parallel, ParallelOptions, Part, Shape, Side, Spline, curve_frames,
    offset_poles, parallel, shell, sphere, surface_frame, torus,
};
use pforms_testkit::{Random, Weights, cases, net, octant};

fn plain(tolerance: f64) -> ParallelOptions {
    ParallelOptions::new(tolerance)
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}

/// The largest distance from the true parallel at a grid of points, off the corners of pieces too.
fn true_error(form: &Form, found: &Parallel, by: impl Fn(&[f64]) -> f64) -> f64 {
    let list: Vec<f64> = (0..=60).map(|i| f64::from(i) / 60.0).collect();
    let mut worst = 0.0_f64;
    if form.axes() == 1 {
        for &t in &list {
            let frame = &curve_frames(form, &[t], FrameKind::Tangent, 0.0).unwrap()[0];
            let d = by(&[t]);
            let wanted =
                [frame.point[0] - d * frame.tangent[1], frame.point[1] + d * frame.tangent[0]];
            worst = worst.max(distance(&found.spline.at(&[t]).unwrap(), &wanted));
        }
        return worst;
    }
    for &u in list.iter().step_by(3) {
        for &v in list.iter().step_by(3) {
            let frame = surface_frame(form, u, v).unwrap();
            let (normal, d) = (frame.normal.unwrap(), by(&[u, v]));
            let wanted: Vec<f64> =
                frame.point.iter().zip(&normal).map(|(x, n)| x + d * n).collect();
            worst = worst.max(distance(&found.spline.at(&[u, v]).unwrap(), &wanted));
        }
    }
    worst
}

fn curve(points: &[f64]) -> Form {
    Form::from_points(&[points.len() / 2], 2, points, None).unwrap()
}

fn saddle() -> Form {
    let points = [
        0., 0., 0., 0., 1., 0.5, 0., 2., 0., 1., 0., 0.5, 1., 1., 0., 1., 2., 0.5, 2., 0., 0., 2.,
        1., 0.5, 2., 2., 0.,
    ];
    Form::from_points(&[3, 3], 3, &points, None).unwrap()
}

#[test]
fn curves_keep_what_they_promise_at_every_tolerance() {
    let cubic = curve(&[0., 0., 1., 2., 3., -2., 4., 1.]);
    for tolerance in [1e-2, 1e-4, 1e-8, 1e-12] {
        for d in [0.1, -0.2] {
            let found = parallel(cubic.clone(), d, &plain(tolerance)).unwrap();
            assert!(found.error <= tolerance && found.gap == 0.0);
            let worst = true_error(&cubic, &found, |_| d);
            assert!(worst <= found.error, "{worst:e} {:e}", found.error);
        }
    }
}

#[test]
fn surfaces_keep_what_they_promise() {
    let mut random = Random::new(5);
    let weights = (0..9).map(|_| 0.5 + random.unit()).collect::<Vec<_>>();
    let rational =
        Form::from_points(&[3, 3], 3, &saddle().points().unwrap(), Some(&weights)).unwrap();
    for form in [saddle(), rational] {
        for (d, tolerance) in [(0.1, 1e-3), (-0.15, 1e-6)] {
            let found = parallel(form.clone(), d, &plain(tolerance)).unwrap();
            assert!(found.error <= tolerance && found.gap == 0.0);
            let worst = true_error(&form, &found, |_| d);
            assert!(worst <= found.error, "{worst:e} {:e}", found.error);
        }
    }
}

#[test]
fn every_point_lies_on_the_normal() {
    let found = parallel(saddle(), 0.2, &plain(1e-2)).unwrap();
    for (u, v) in [(0.1, 0.3), (0.5, 0.5), (0.9, 0.2)] {
        let frame = surface_frame(&saddle(), u, v).unwrap();
        let normal = frame.normal.unwrap();
        let step: Vec<f64> = found
            .spline
            .at(&[u, v])
            .unwrap()
            .iter()
            .zip(&frame.point)
            .map(|(x, y)| x - y)
            .collect();
        let along: f64 = step.iter().zip(&normal).map(|(x, y)| x * y).sum();
        // Only rounding takes it off: the direction is not approximated.
        assert!((along.abs() - distance(&step, &[0.0; 3])).abs() < 1e-14);
    }
}

#[test]
fn planes_spheres_and_circles_are_met_exactly() {
    let plane =
        Form::from_points(&[2, 2], 3, &[0., 0., 1., 0., 3., 1., 2., 0., 1., 2., 3., 1.], None);
    let found = parallel(plane.unwrap(), 0.5, &plain(1e-13)).unwrap();
    assert_eq!(found.spline.counts(), [1, 1]);
    for (u, v) in [(0.0, 0.0), (0.3, 0.9)] {
        assert!((found.spline.at(&[u, v]).unwrap()[2] - 1.5).abs() <= found.error);
    }
    // An octant, with its collapsed edge: the parallel is a sphere, in one piece.
    for d in [0.25, -0.5, 3.0] {
        let normal = surface_frame(&octant([1.0; 3]), 0.5, 0.5).unwrap().normal.unwrap();
        let out = d * normal[0].signum();
        let found = parallel(octant([1.0; 3]), out, &plain(1e-12)).unwrap();
        assert_eq!(found.spline.counts(), [1, 1]);
        for i in 0..=20 {
            for j in 0..=20 {
                let at = [f64::from(i) / 20.0, f64::from(j) / 20.0];
                let p = found.spline.at(&at).unwrap();
                assert!((distance(&p, &[0.0; 3]) - (1.0 + d)).abs() <= found.error, "{p:?}");
            }
        }
    }
    let arc = [1., 0., 1., FRAC_1_SQRT_2, FRAC_1_SQRT_2, FRAC_1_SQRT_2, 0., 1., 1.];
    let arc = Form::from_homogeneous(&[3], 2, arc.to_vec()).unwrap();
    let found = parallel(arc, 0.75, &plain(1e-13)).unwrap(); // left: inwards
    assert_eq!(found.spline.counts(), [1]);
    for t in [0.0, 0.2, 1.0] {
        let p = found.spline.at(&[t]).unwrap();
        assert!((p[0].hypot(p[1]) - 0.25).abs() <= found.error);
    }
}

#[test]
fn a_cubic_with_a_pythagorean_hodograph_has_an_exact_parallel() {
    // x′ = a² − b², y′ = 2ab with a = 1 + t, b = 1 − 2t: |c′| = a² + b².
    let integral = |p: [f64; 3]| [0., p[0] / 3., (p[0] + p[1]) / 3., (p[0] + p[1] + p[2]) / 3.];
    let (x, y) = (integral([0., 3., 3.]), integral([2., 1., -4.]));
    let points: Vec<f64> = x.iter().zip(&y).flat_map(|(x, y)| [*x, *y]).collect();
    let found = parallel(curve(&points), 0.05, &plain(1e-13)).unwrap();
    assert_eq!(found.spline.counts(), [1]);
}

#[test]
fn a_torus_is_parallel_to_a_torus() {
    let (big, small, step) = (2.0, 0.5, 0.25);
    let torus = |small: f64| {
        let w = FRAC_1_SQRT_2;
        let arc = [[1., 0., 1.], [w, w, w], [0., 1., 1.]];
        let mut poles = Vec::new();
        for [a, b, p] in arc {
            for [c, s, q] in arc {
                let r = big * p + small * a;
                poles.extend([r * c, r * s, small * b * q, p * q]);
            }
        }
        Form::from_homogeneous(&[3, 3], 3, poles).unwrap()
    };
    let frame = surface_frame(&torus(small), 0.5, 0.5).unwrap();
    let inwards = frame.normal.unwrap()[2] < 0.0;
    let found = parallel(torus(small), if inwards { -step } else { step }, &plain(1e-12)).unwrap();
    assert_eq!(found.spline.counts(), [1, 1]);
    let other = torus(small + step);
    for at in [[0.1, 0.7], [0.5, 0.5], [1.0, 0.0]] {
        assert!(distance(&found.spline.at(&at).unwrap(), &other.at(&at).unwrap()) <= found.error);
    }
}

#[test]
fn beyond_the_radius_of_curvature_is_refused_and_says_where() {
    let parabola = curve(&[-1., 1., 0., -1., 1., 1.]); // y = x², radius ½ in the middle
    assert!(parallel(parabola.clone(), 0.49, &plain(1e-6)).is_ok());
    let error = parallel(parabola.clone(), 0.51, &plain(1e-6)).unwrap_err();
    assert!(matches!(error, Error::Degenerate(_)));
    let text = error.to_string();
    let place: f64 = text[text.find('[').unwrap() + 1..text.find(']').unwrap()].parse().unwrap();
    assert!((place - 0.5).abs() < 0.06, "{text}");
    let folds = ParallelOptions { folds: true, ..plain(1e-6) };
    let found = parallel(parabola.clone(), 2.0, &folds).unwrap();
    assert!(true_error(&parabola, &found, |_| 2.0) <= found.error);
    // The other side has no centres.
    assert!(parallel(parabola, -50.0, &plain(1e-6)).is_ok());
    // A sphere shrunk to its centre, and beyond.
    let inwards = -surface_frame(&octant([1.0; 3]), 0.5, 0.5).unwrap().normal.unwrap()[0].signum();
    for d in [1.0, 1.5] {
        let error = parallel(octant([1.0; 3]), inwards * d, &plain(1e-6)).unwrap_err();
        assert!(matches!(error, Error::Degenerate(_)), "{error}");
    }
    assert!(parallel(octant([1.0; 3]), inwards * 0.999, &plain(1e-6)).is_ok());
}

#[test]
fn the_distance_may_vary() {
    let cubic = curve(&[0., 0., 1., 2., 3., -2., 4., 1.]);
    let law = Form::from_points(&[3], 1, &[-0.1, 0.3, 0.], Some(&[1., 2., 1.])).unwrap();
    let found = parallel(cubic.clone(), law.clone(), &plain(1e-8)).unwrap();
    assert!(true_error(&cubic, &found, |t| law.at(t).unwrap()[0]) <= found.error);
    let law = Form::from_points(&[2, 2], 1, &[0., 0.1, -0.1, 0.], None).unwrap();
    let found = parallel(saddle(), law.clone(), &plain(1e-6)).unwrap();
    assert!(true_error(&saddle(), &found, |t| law.at(t).unwrap()[0]) <= found.error);
    let refused =
        parallel(saddle(), Form::from_points(&[2], 1, &[0., 1.], None).unwrap(), &plain(1e-6));
    assert!(matches!(refused, Err(Error::Shape(_))));
}

#[test]
fn curves_in_space_state_their_side() {
    let flat = [0., 0., 1., 2., 3., -2., 4., 1.];
    let lifted: Vec<f64> = flat.chunks(2).flat_map(|p| [p[0], p[1], 7.0]).collect();
    let lifted = Form::from_points(&[4], 3, &lifted, None).unwrap();
    let across = ParallelOptions { side: Side::Across([0., 0., 2.]), ..plain(1e-8) };
    let (high, low) =
        (parallel(lifted.clone(), 0.1, &across), parallel(curve(&flat), 0.1, &across));
    assert!(matches!(low, Err(Error::Shape(_))));
    let low = parallel(curve(&flat), 0.1, &plain(1e-8)).unwrap();
    let high = high.unwrap();
    for t in [0.0, 0.4, 1.0] {
        let (p, q) = (high.spline.at(&[t]).unwrap(), low.spline.at(&[t]).unwrap());
        assert!(distance(&p, &[q[0], q[1], 7.0]) <= high.error + low.error);
    }
    assert!(matches!(parallel(lifted, 0.1, &plain(1e-8)), Err(Error::Shape(_))));
    let twisted =
        Form::from_points(&[4], 3, &[0., 0., 0., 1., 0., 0., 1., 1., 0., 1., 1., 1.], None);
    let inside = ParallelOptions { side: Side::Principal, ..plain(1e-8) };
    let found = parallel(twisted.clone().unwrap(), 0.1, &inside).unwrap();
    for t in [0.0, 0.3, 1.0] {
        let frame =
            &curve_frames(twisted.as_ref().unwrap(), &[t], FrameKind::Frenet, 0.0).unwrap()[0];
        let normal = frame.normal.as_ref().unwrap();
        let wanted: Vec<f64> = frame.point.iter().zip(normal).map(|(x, n)| x + 0.1 * n).collect();
        assert!(distance(&found.spline.at(&[t]).unwrap(), &wanted) <= found.error);
    }
}

#[test]
fn splines_stay_joined_where_they_are_smooth() {
    let net = Form::from_points(&[5], 2, &[0., 0., 1., 1., 2., 0., 3., 1., 4., 0.], None).unwrap();
    let knots = vec![vec![0., 0., 0., 1., 3., 4., 4., 4.]];
    let smooth = Spline::new(net.clone(), &[2], knots).unwrap();
    let found = parallel(smooth, 0.1, &plain(1e-7)).unwrap();
    assert_eq!(found.gap, 0.0);
    assert_eq!(
        found.spline.net().orders()[0],
        found.spline.degrees()[0] * found.spline.counts()[0] + 1
    );
    let corner = Spline::joined(net, &[2], &[vec![0., 1., 2.]]).unwrap();
    let found = parallel(corner, 0.1, &plain(1e-7)).unwrap();
    assert!(found.gap > 0.01, "a corner parts the parallel");
}

#[test]
fn scale_and_place_do_not_matter() {
    let mut random = Random::new(8);
    let form = random.rough_form(&[4], 2, Weights::Positive);
    let folds = |tolerance| ParallelOptions { folds: true, ..plain(tolerance) };
    let one = parallel(form.clone(), 0.125, &folds(1e-6)).unwrap();
    for exponent in [-120_i32, 90] {
        let scale = 2.0_f64.powi(exponent);
        let poles =
            form.homogeneous().chunks_exact(3).flat_map(|p| [p[0] * scale, p[1] * scale, p[2]]);
        let scaled = Form::from_homogeneous(&[4], 2, poles.collect()).unwrap();
        let other = parallel(scaled, 0.125 * scale, &folds(1e-6 * scale)).unwrap();
        assert_eq!(one.spline.counts(), other.spline.counts());
        assert!((other.error / scale / one.error - 1.0).abs() < 1e-9);
    }
}

#[test]
fn a_shell_has_the_volume_that_steiner_says() {
    // Between spheres of radius 1 and 1 + d: an eighth of 4π/3·((1+d)³ − 1).
    let out = surface_frame(&octant([1.0; 3]), 0.5, 0.5).unwrap().normal.unwrap()[0].signum();
    let d = 0.5;
    let found = shell(octant([1.0; 3]), out * d, &plain(1e-9)).unwrap();
    assert_eq!((found.spline.axes(), found.spline.degrees()[0]), (3, 1));
    for at in [[0.3, 0.6], [0.9, 0.1]] {
        for depth in [0.0, 0.5, 1.0] {
            let p = found.spline.at(&[depth, at[0], at[1]]).unwrap();
            assert!((distance(&p, &[0.0; 3]) - (1.0 + depth * d)).abs() < 1e-12);
        }
    }
    let exact = PI / 6.0 * ((1.0 + d).powi(3) - 1.0);
    let volume = volume(&found.spline);
    assert!((volume - exact).abs() < 1e-6, "{volume} {exact}");
    assert!(matches!(shell(saddle(), 0.0, &plain(1e-6)), Err(Error::Degenerate(_))));
    let strip = shell(curve(&[0., 0., 1., 1., 2., 0.]), 0.1, &plain(1e-6)).unwrap();
    assert_eq!(strip.spline.axes(), 2);
}

/// By the formula of Gauss over three points in each of 8×8×8 boxes; derivatives from pieces.
fn volume(shape: &Spline) -> f64 {
    let piece = shape.piece(&[0, 0, 0]).unwrap();
    assert_eq!(shape.counts(), [1, 1, 1]);
    let offset = 0.6_f64.sqrt() / 2.0;
    let nodes: Vec<(f64, f64)> = (0..8)
        .flat_map(|i| {
            [(-offset, 5.0), (0.0, 8.0), (offset, 5.0)]
                .map(|(x, w)| ((f64::from(i) + 0.5 + x) / 8.0, w / 18.0 / 8.0))
        })
        .collect();
    let mut sum = 0.0;
    for &(a, wa) in &nodes[..3] {
        for &(b, wb) in &nodes {
            for &(c, wc) in &nodes {
                let frame = pforms_operators::volume_frame(&piece, &[a * 8.0, b, c]).unwrap();
                sum += 8.0 * wa * wb * wc * frame.jacobian.unwrap().abs();
            }
        }
    }
    sum
}

#[test]
fn the_poles_of_the_original_are_moved_as_the_reference_says() {
    for case in cases("offset_poles") {
        let (input, expected): (Form, Form) = (net(&case.input), net(&case.expected));
        let by = case.params["distance"].as_f64().unwrap();
        let moved = offset_poles(input.clone(), by, &Side::Natural).unwrap();
        assert_eq!(moved.net().orders(), input.orders());
        for (x, y) in moved.net().homogeneous().iter().zip(expected.homogeneous()) {
            assert!((x - y).abs() <= 1e-12 * y.abs().max(1.0), "{}: {x} {y}", case.id);
        }
    }
}

#[test]
fn moved_poles_are_the_parallel_of_a_plane_and_keep_the_knots() {
    let plane =
        Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 0.], None);
    let moved = offset_poles(plane.unwrap(), 2.0, &Side::Natural).unwrap();
    assert!(moved.net().points().unwrap().chunks(3).all(|p| p[2] == 2.0));
    let net = Form::from_points(&[4], 2, &[0., 0., 1., 0., 2., 0., 3., 0.], None).unwrap();
    let line = Spline::new(net, &[2], vec![vec![0., 1., 2., 3., 4., 5., 6.]]).unwrap();
    let law = Form::from_points(&[2], 1, &[0., 1.], None).unwrap();
    let moved = offset_poles(line.clone(), Distance::from(law), &Side::Natural).unwrap();
    assert_eq!(moved.knots(), line.knots());
    // Greville's parameters 1.5, …, 4.5 of the window 2 to 4, kept inside it.
    let heights: Vec<f64> = moved.net().points().unwrap().chunks(2).map(|p| p[1]).collect();
    assert_eq!(heights, [0.0, 0.25, 0.75, 1.0]);
    let _ = Shape::from(moved);
}

#[test]
fn what_has_no_parallel_is_refused() {
    let bad = |form: Form, d: f64, tolerance: f64| {
        parallel(form, d, &plain(tolerance)).unwrap_err().family()
    };
    let arch = || curve(&[0., 0., 1., 1., 2., 0.]);
    assert_eq!(bad(arch(), 0.1, 0.0), "Domain");
    assert_eq!(bad(arch(), 0.1, f64::NAN), "Domain");
    assert_eq!(bad(arch(), f64::INFINITY, 1e-6), "Domain");
    assert_eq!(bad(arch(), 0.1, 1e-30), "Accuracy");
    assert_eq!(bad(curve(&[1., 1., 1., 1.]), 0.1, 1e-6), "Degenerate");
    assert_eq!(bad(Form::point(&[0., 0.]).unwrap(), 0.1, 1e-6), "Shape");
    // A cusp in the middle.
    assert_eq!(bad(curve(&[0., 0., 1., 1., 0., 1., 1., 0.]), 0.1, 1e-6), "Degenerate");
    let pole = Form::from_homogeneous(&[2], 2, vec![0., 0., 1., 1., 0., -1.]).unwrap();
    assert_eq!(bad(pole, 0.1, 1e-6), "Domain");
    let line =
        Form::from_points(&[2, 2], 3, &[0., 0., 0., 1., 1., 1., 2., 2., 2., 3., 3., 3.], None);
    assert_eq!(bad(line.unwrap(), 0.1, 1e-6), "Degenerate");
    // Repeated poles at an end have a tangent all the same.
    let slow = curve(&[0., 0., 0., 0., 2., 1.]);
    assert!(parallel(slow.clone(), 0.1, &plain(1e-6)).is_ok());
    // 0 is the form itself.
    assert_eq!(parallel(slow.clone(), 0.0, &plain(1e-6)).unwrap().spline, slow.into());
}

#[test]
fn whole_spheres_and_tori_have_parallels() {
    let forms = [
        (sphere(&1.0, Part::Whole).unwrap(), 1.0),
        (sphere(&1.0, Part::Quarter).unwrap(), 1.0),
        (torus(&2.0, &0.5, Part::Whole).unwrap(), 0.5),
    ];
    for (surface, radius) in forms {
        for by in [0.2, -0.2, 1e-3] {
            let found = parallel(surface.clone().into_spline(), by, &plain(1e-6)).unwrap();
            for i in 0..=20 {
                for j in 0..=20 {
                    let at = [f64::from(i) / 20.0, f64::from(j) / 20.0];
                    let p = found.spline.at(&at).unwrap();
                    let round = p[0].hypot(p[2]);
                    let middle = if radius < 1.0 { round - 2.0 } else { round };
                    let off = (middle.hypot(p[1]) - radius).abs() - by.abs();
                    assert!(off.abs() < 1e-6, "{off} at {at:?}");
                }
            }
        }
    }
}
