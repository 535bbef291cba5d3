//! Splines used as forms: mixed, cut, evaluated by the thousand, framed, projected on.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Form, Rational, Scalar};
use pforms_operators::{
    FrameKind, Poles, Projector, Shape, Spline, SplineProjector, combine, combine_shapes,
    curve_frames, derivative, midpoint_shapes, stack_shapes, subdivide, surface_frame,
};

type Q = Rational;

fn q(n: i64, d: i64) -> Q {
    Q::ratio(n, d)
}

/// A cubic plane curve over four windows of different lengths, weights 1 or not.
fn curve<S: Scalar>(rational: bool) -> Spline<S> {
    let point = |i: i64| [S::ratio(i * i % 7, 2), S::ratio(i * 3 % 5, 1)];
    let points: Vec<S> = (0..7).flat_map(point).collect();
    let weights: Vec<S> =
        (0..7).map(|i| if rational { S::ratio(1 + i % 3, 2) } else { S::one() }).collect();
    let net = Form::from_points(&[7], 2, &points, Some(&weights)).unwrap();
    let knots = [0, 0, 0, 0, 1, 4, 5, 6, 6, 6, 7].map(|i| S::ratio(i, 2)).to_vec();
    Spline::new(net, &[3], vec![knots]).unwrap()
}

/// A surface of degrees 2 and 1 in space.
fn surface<S: Scalar>() -> Spline<S> {
    let point = |k: i64| [S::ratio(k / 4, 1), S::ratio(k % 4, 1), S::ratio(k * k % 5, 3)];
    let points: Vec<S> = (0..20).flat_map(point).collect();
    let weights: Vec<S> = (0..20).map(|k| S::ratio(2 + k % 4, 3)).collect();
    let net = Form::from_points(&[5, 4], 3, &points, Some(&weights)).unwrap();
    let knots = vec![
        [0, 1, 2, 4, 5, 6, 8, 9].map(|i| S::ratio(i, 1)).to_vec(),
        [0, 0, 1, 2, 3, 3].map(|i| S::ratio(i, 1)).to_vec(),
    ];
    Spline::new(net, &[2, 1], knots).unwrap()
}

#[test]
fn stretching_is_a_change_of_parameter() {
    let spline = curve::<Q>(true);
    for (a, b) in [(q(1, 3), q(2, 1)), (q(5, 2), q(0, 1)), (q(-1, 1), q(4, 1)), (q(4, 1), q(-1, 2))]
    {
        let part = spline.stretch(std::slice::from_ref(&a), std::slice::from_ref(&b)).unwrap();
        for k in [0, 1, 2, 5, 7] {
            let t = q(k, 7);
            let there = a.clone() + t.clone() * (b.clone() - a.clone());
            assert_eq!(part.at(&[t]).unwrap(), spline.at(&[there]).unwrap());
        }
    }
    assert_eq!(spline.stretch(&[q(1, 1)], &[q(1, 1)]).unwrap_err().family(), "Domain");
}

#[test]
fn sums_are_sums_of_points_with_their_weights() {
    let (a, form) = (
        curve::<Q>(true),
        subdivide(
            &Form::from_points(&[2], 2, &[q(1, 1), q(2, 1), q(0, 1), q(5, 1)], None).unwrap(),
            &[2],
        )
        .unwrap(),
    );
    let b = form.on_window(0, &q(0, 1), &q(3, 1)).unwrap();
    let point: Form<Q> = Form::point(&[q(1, 3), q(2, 1)]).unwrap();
    let shapes = [a.clone().into(), b.clone().into(), point.clone().into()];
    let k = [q(2, 1), q(-1, 2), q(3, 1)];
    let Shape::Spline(sum) = combine_shapes(&k, &shapes, false).unwrap() else { panic!() };
    for t in [q(0, 1), q(1, 5), q(1, 2), q(2, 1), q(3, 1)] {
        let part = |spline: &Spline<Q>| {
            Form::from_homogeneous(&[], 2, spline.homogeneous_at(std::slice::from_ref(&t)).unwrap())
                .unwrap()
        };
        let expected = combine(&k, &[&part(&a), &part(&b), &point]).unwrap();
        assert_eq!(sum.homogeneous_at(std::slice::from_ref(&t)).unwrap(), expected.homogeneous());
    }
    let far = form.on_window(0, &q(0, 1), &q(9, 1)).unwrap();
    let error = combine_shapes(&[q(1, 1), q(1, 1)], &[a.into(), far.into()], false).unwrap_err();
    assert_eq!(error.family(), "Shape");
}

#[test]
fn the_middle_is_the_middle_of_the_stack() {
    let a = curve::<Q>(false);
    let b = a.with_net(a.net().with_pole(&[3], &[q(9, 1), q(9, 1), q(1, 1)]).unwrap()).unwrap();
    let shapes = [a.clone().into(), b.clone().into(), a.into()];
    let Shape::Spline(stack) = stack_shapes(&shapes).unwrap() else { panic!() };
    assert_eq!(stack.degrees(), [2, 3]);
    assert_eq!(stack.window(0).unwrap(), (q(0, 1), q(1, 1)));
    let Shape::Spline(middle) = midpoint_shapes(&shapes).unwrap() else { panic!() };
    assert_eq!(stack.sub(0, &q(1, 2)).unwrap(), middle);
    assert_eq!(
        stack.sub(0, &q(1, 1)).unwrap().net(),
        &stack.sub(0, &q(0, 1)).unwrap().net().clone()
    );
}

#[test]
fn halved_pieces_are_the_same_spline() {
    let spline = surface::<Q>();
    let fine = spline.subdivide(&[1, 2]).unwrap();
    assert_eq!(fine.counts(), [2 * spline.counts()[0], 4 * spline.counts()[1]]);
    assert!(fine.is_bezier());
    for (s, t) in [(q(2, 1), q(0, 1)), (q(7, 3), q(5, 4)), (q(6, 1), q(3, 1))] {
        let at = [s, t];
        assert_eq!(fine.at(&at).unwrap(), spline.at(&at).unwrap());
    }
    let form = Form::from_points(&[3], 1, &[q(0, 1), q(2, 1), q(1, 1)], None).unwrap();
    let whole: Spline<Q> = form.clone().into();
    assert_eq!(whole.subdivide(&[3]).unwrap(), subdivide(&form, &[3]).unwrap());
}

#[test]
fn the_piece_at_a_parameter_holds_its_point() {
    let spline = surface::<Q>();
    for at in [
        [q(2, 1), q(0, 1)],
        [q(4, 1), q(1, 1)],
        [q(9, 2), q(11, 4)],
        [q(6, 1), q(3, 1)],
        [q(9, 1), q(-1, 1)],
    ] {
        let place = spline.locate(&at).unwrap();
        assert_eq!(place.piece.at(&place.parameters).unwrap(), spline.at(&at).unwrap());
        assert_eq!(spline.piece(&place.index).unwrap(), place.piece);
    }
    assert_eq!(spline.locate(&[q(1, 1)]).unwrap_err().family(), "Shape");
}

#[test]
fn a_thousand_points_are_those_one_by_one() {
    let spline = surface::<f64>();
    let list = |scale: f64, start: f64| -> Vec<f64> {
        (0..1000).map(|i| start + scale * f64::from(i * 389 % 1000) / 999.0).collect()
    };
    // The last parameters lie beyond the window.
    let (u, v) = (list(5.0, 2.0), list(3.5, -0.25));
    let points = spline.scattered(&[&u, &v]).unwrap();
    let mut slopes = vec![0.0; points.len()];
    spline.scattered_derivative_into(&[&u, &v], &[1, 0], &mut slopes).unwrap();
    let hodograph = spline.hodograph(0).unwrap();
    for i in 0..u.len() {
        let at = [u[i], v[i]];
        // A few roundings of numbers below 10 through another order of sums.
        close(&points[3 * i..3 * i + 3], &spline.at(&at).unwrap(), 1e-13);
        close(&slopes[3 * i..3 * i + 3], &hodograph.at(&at).unwrap(), 1e-12);
    }
    let (rows, columns) = ([2.0, 5.5, 4.0, 6.0], [0.0, 2.5, 1.0]);
    let grid = spline.grid(&[&rows, &columns]).unwrap();
    for (k, point) in grid.chunks_exact(3).enumerate() {
        close(point, &spline.at(&[rows[k / 3], columns[k % 3]]).unwrap(), 1e-13);
    }
    assert_eq!(spline.scattered(&[&u, &v[1..]]).unwrap_err().family(), "Shape");
    assert_eq!(spline.scattered(&[&[f64::NAN], &[0.0]]).unwrap_err().family(), "Domain");
}

fn close(a: &[f64], b: &[f64], bound: f64) {
    assert_eq!(a.len(), b.len());
    for (x, y) in a.iter().zip(b) {
        assert!((x - y).abs() <= bound * (1.0 + y.abs()), "{a:?} {b:?}");
    }
}

/// An arch in space and its pieces, on another window.
fn arch() -> (Form, Spline) {
    let points = [0., 0., 0., 1., 3., 0., 3., -1., 2., 4., 2., 1., 5., 5., -2.];
    let form = Form::from_points(&[5], 3, &points, Some(&[1., 0.7, 1.5, 1., 2.])).unwrap();
    let spline = subdivide(&form, &[2]).unwrap().on_window(0, &10.0, &14.0).unwrap();
    (form, spline)
}

#[test]
fn frames_are_those_of_the_form_but_slower() {
    let (form, spline) = arch();
    let list: Vec<f64> = vec![0.0, 0.9, 0.25, 0.5, 0.61, 1.0];
    let there: Vec<f64> = list.iter().map(|t| 10.0 + 4.0 * t).collect();
    for kind in [FrameKind::Frenet, FrameKind::Tangent, FrameKind::RotationMinimising] {
        let whole = curve_frames(&form, &list, kind, 1e-9).unwrap();
        let parts = spline.curve_frames(&there, kind, 1e-9).unwrap();
        for (a, b) in whole.iter().zip(&parts) {
            close(&a.point, &b.point, 1e-13);
            close(&a.tangent, &b.tangent, 1e-13);
            // Both normals are within 1e-9 of the true one; Frenet's are exact to rounding.
            close(a.normal.as_deref().unwrap_or(&[]), b.normal.as_deref().unwrap_or(&[]), 3e-9);
            close(&[a.speed, a.bend], &[4.0 * b.speed, 16.0 * b.bend], 1e-11);
            close(&[a.curvature, a.torsion.unwrap()], &[b.curvature, b.torsion.unwrap()], 1e-9);
        }
    }
}

#[test]
fn a_carried_normal_turns_the_corner() {
    // Along x, then up: the normal y stays, and what pointed up points back.
    let legs = [
        Form::from_points(&[2], 3, &[0., 0., 0., 1., 0., 0.], None).unwrap(),
        Form::from_points(&[2], 3, &[1., 0., 0., 1., 0., 1.], None).unwrap(),
    ];
    let path = Spline::end_to_end(&legs, 0, &[0.0, 1.0, 2.0]).unwrap();
    let frames = path.curve_frames(&[0.5, 1.5], FrameKind::RotationMinimising, 1e-9).unwrap();
    let normals = frames.iter().map(|frame| frame.normal.clone().unwrap());
    let [before, after] = normals.collect::<Vec<_>>().try_into().unwrap();
    close(&[after[0], after[1], after[2]], &[-before[2], before[1], before[0]], 1e-14);
}

#[test]
fn surface_frames_are_those_of_the_piece() {
    let spline = surface::<f64>();
    let place = spline.locate(&[3.0, 1.25]).unwrap();
    let here = spline.surface_frame(3.0, 1.25).unwrap();
    let piece = surface_frame(&place.piece, place.parameters[0], place.parameters[1]).unwrap();
    assert_eq!((&here.tangents, &here.curvature), (&piece.tangents, &piece.curvature));
    let d =
        |k: usize| derivative(&place.piece, &[1 - k, k]).unwrap().at(&place.parameters).unwrap();
    let length = |v: Vec<f64>| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    close(&here.lengths, &[length(d(0)) / 2.0, length(d(1))], 1e-13);
    let normals = {
        let mut out = [0.0; 6];
        spline.normal_grid_into(&[&[3.0, 5.0], &[1.25]], &mut out).unwrap();
        out
    };
    close(&normals[..3], here.normal.as_deref().unwrap(), 1e-13);
    let volume = spline.volume_frame(&[3.0, 1.25]).unwrap();
    close(&volume.lengths, &here.lengths, 1e-13);
}

#[test]
fn the_foot_is_the_nearest_of_all_pieces() {
    let (form, spline) = arch();
    let points: Vec<f64> = (0..60).map(|i| f64::from(i * 37 % 61) / 8.0 - 2.0).collect();
    let whole = Projector::new(&form, 1e-12).unwrap().project(&points).unwrap();
    let parts = SplineProjector::new(&spline, 1e-12).unwrap().project(&points).unwrap();
    // The sizes are below 10, the gaps a few roundings of them.
    close(&whole.distances, &parts.distances, 1e-13);
    for i in 0..20 {
        assert!(parts.gaps[i] < 1e-12);
        if whole.unique[i] {
            close(&[10.0 + 4.0 * whole.parameters[i]], &[parts.parameters[i]], 1e-6);
        }
    }
    // Straight through a corner: the foot is the corner, once.
    let corner = Spline::joined(
        Form::from_points(&[3], 2, &[0., 0., 1., 0., 1., 1.], None).unwrap(),
        &[1],
        &[vec![0.0, 1.0, 2.0]],
    )
    .unwrap();
    let foot =
        SplineProjector::new(&corner, 1e-12).unwrap().project(&[3.0, -2.0, 0.0, 1.0]).unwrap();
    assert_eq!((foot.parameters[0], foot.unique[0]), (1.0, true));
    // As near to both sides.
    assert!(!foot.unique[1]);
    assert_eq!(foot.distances[1], 1.0);
}

#[test]
fn the_diagonal_runs_through_both_parameters() {
    let spline = surface::<Q>().on_window(0, &q(0, 1), &q(3, 1)).unwrap();
    let curve = spline.diagonal(1, 0).unwrap();
    assert_eq!(curve.degrees(), [3]);
    for t in [q(0, 1), q(1, 2), q(1, 1), q(5, 3), q(9, 4), q(3, 1)] {
        let there = spline.at(&[t.clone(), t.clone()]).unwrap();
        assert_eq!(curve.at(&[t]).unwrap(), there);
    }
    let stack: Spline<Q> = Spline::new(spline.net().reshape(&[5, 4, 1]).unwrap(), &[2, 1, 0], {
        let lists = spline.knots().iter().map(|knots| knots.as_slice().to_vec());
        lists.chain([vec![q(0, 1), q(3, 1)]]).collect()
    })
    .unwrap();
    let merged = stack.diagonal(1, 2).unwrap();
    assert_eq!(merged.degrees(), [2, 1]);
    let at = [q(2, 3), q(7, 4)];
    assert_eq!(merged.at(&at).unwrap(), spline.at(&at).unwrap());
    assert_eq!(spline.diagonal(0, 0).unwrap_err().family(), "Shape");
    assert_eq!(surface::<Q>().diagonal(0, 1).unwrap_err().family(), "Shape");
}
