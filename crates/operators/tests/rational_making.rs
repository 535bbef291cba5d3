//! Arcs, quadrics, tori and knots of given angles in floating point; reference cases; bad input.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI, TAU};

use pforms_kernel::{Form, Scalar};
use pforms_operators::{
    Axis, Bicubic, Conic, Part, Poles, Shape, Spline, arc, arc_by_step, bezier_cone,
    bezier_cylinder, bezier_sphere, bezier_torus, circle, classify, cone, conic, cross, cylinder,
    ellipse, hyperbola, parabola, revolve, revolve_whole, sphere, torus, torus_knot, transpose,
    viviani,
};
use pforms_testkit::{Case, Root2, cases, net, numbers};

/// Four roundings, the bound of an exact construction.
const ULPS: f64 = 4.0 * f64::EPSILON;

fn points(shape: &Shape, steps: usize) -> Vec<Vec<f64>> {
    let axes = shape.net().axes();
    let mut all = Vec::new();
    for piece in shape.pieces().unwrap() {
        for flat in 0..(steps + 1).pow(axes as u32) {
            let mut rest = flat;
            let mut at = vec![0.0; axes];
            for x in &mut at {
                *x = (rest % (steps + 1)) as f64 / steps as f64;
                rest /= steps + 1;
            }
            all.push(piece.at(&at).unwrap());
        }
    }
    all
}

fn near(computed: &Form, expected: &Form, bound: f64, what: &str) {
    assert_eq!(computed.orders(), expected.orders(), "{what}");
    let size = expected.homogeneous().iter().fold(1.0_f64, |size, x| size.max(x.abs()));
    for (a, b) in computed.homogeneous().iter().zip(expected.homogeneous()) {
        assert!((a - b).abs() <= bound * size, "{what}: {a} for {b}");
    }
}

#[test]
fn arcs_of_any_angle_are_round_and_end_where_they_should() {
    let angles = [1e-6, 0.3, 1.0, FRAC_PI_2, 2.0, PI, 3.5, 4.5, 5.0, TAU, 7.0, 20.0, -1.0, -9.0];
    for order in [3, 4, 5] {
        for angle in angles {
            let (radius, start) = (2.5, 0.7);
            let curve = arc(radius, angle, order, start).unwrap();
            for point in points(&curve, 16) {
                let off = libm::hypot(point[0], point[1]) / radius - 1.0;
                assert!(off.abs() <= ULPS, "{order}, {angle}: {off:e}");
            }
            let all = curve.pieces().unwrap();
            for (form, t, place) in
                [(&all[0], 0.0, start), (&all[all.len() - 1], 1.0, start + angle)]
            {
                let point = form.at(&[t]).unwrap();
                let wanted = [radius * libm::cos(place), radius * libm::sin(place)];
                // The angle itself is rounded to half an ulp of its size.
                let bound = radius * f64::EPSILON * (4.0 + 2.0 * place.abs());
                assert!(
                    (point[0] - wanted[0]).abs() <= bound && (point[1] - wanted[1]).abs() <= bound
                );
            }
            let least = [0.5, 1.0 / 3.0, 0.38][order - 3];
            assert!(
                curve.net().weights().iter().all(|w| *w >= least * (1.0 - ULPS)),
                "{order} {angle}"
            );
        }
    }
}

#[test]
fn angles_of_the_book_take_one_form() {
    for (angle, order) in [(FRAC_PI_2, 3), (2.0 * PI / 3.0, 3), (PI, 4), (PI, 5), (1.5 * PI, 5)] {
        let one = arc(1.0, angle, order, 0.0).unwrap();
        assert!(matches!(one, Shape::Form(_)), "{angle} {order}");
    }
    for (angle, order, count) in
        [(PI, 3, 2), (TAU, 3, 4), (TAU, 4, 2), (TAU, 5, 2), (2.0 * TAU, 3, 8)]
    {
        assert_eq!(arc(1.0, angle, order, 0.0).unwrap().pieces().unwrap().len(), count);
    }
    let quarters = circle(&1.5, Part::Pieces).unwrap();
    assert_eq!(arc(1.5, TAU, 3, 0.0).unwrap(), quarters);
}

#[test]
fn floating_forms_are_the_exact_ones_rounded() {
    let [r, h] = [Root2::ratio(7, 4), Root2::ratio(5, 8)];
    for part in Part::ALL {
        let pairs = [
            (circle(&r, part), circle(&1.75, part)),
            (ellipse(&r, &h, part), ellipse(&1.75, &0.625, part)),
            (cylinder(&r, &h, part), cylinder(&1.75, &0.625, part)),
            (cone(&r, &h, &h, part), cone(&1.75, &0.625, &0.625, part)),
            (sphere(&r, part), sphere(&1.75, part)),
            (torus(&r, &h, part), torus(&1.75, &0.625, part)),
            (viviani(&r, part), viviani(&1.75, part)),
        ];
        for (exact, floating) in pairs {
            assert_eq!(exact.is_ok(), floating.is_ok());
            let (Ok(exact), Ok(floating)) = (exact, floating) else { continue };
            let rounded: Form = exact.net().map_scalar(Scalar::to_f64).unwrap();
            near(floating.net(), &rounded, ULPS, part.name());
        }
    }
}

#[test]
fn whole_forms_and_pieces_have_the_same_points() {
    let distance = |p: &[f64]| libm::hypot(libm::hypot(p[0], p[2]) - 2.0, p[1]);
    for part in [Part::Whole, Part::Pieces] {
        for point in points(&torus(&2.0, &0.5, part).unwrap(), 12) {
            assert!((distance(&point) - 0.5).abs() <= 4.0 * ULPS);
        }
        let sphere = points(&sphere(&3.0, part).unwrap(), 12);
        let lowest = sphere.iter().map(|p| p[1]).fold(0.0, f64::min);
        let back = sphere.iter().map(|p| p[0]).fold(0.0, f64::min);
        assert!((lowest + 3.0).abs() <= ULPS && (back + 3.0).abs() <= 8.0 * ULPS, "all of it");
    }
}

#[test]
fn rational_nets_of_the_original() {
    let params = |case: &Case, name: &str| numbers(&case.params[name])[0];
    for case in cases("rational") {
        let expected: Form = net(&case.expected);
        let computed = match case.params["shape"].as_str().unwrap() {
            "quarter circle, 3 poles" => {
                let r = params(&case, "r");
                let [p0, p1, p2] =
                    [[r, 0., 0.], [r, r, 0.], [0., r, 0.]].map(|p| Form::point(&p).unwrap());
                conic(&p0, &p1, &p2, &(params(&case, "coeff") * FRAC_1_SQRT_2)).unwrap()
            }
            "half circle, 4 poles" => arc(params(&case, "r"), PI, 4, 0.0).unwrap().net().clone(),
            "half circle, 5 poles" => arc(params(&case, "r"), PI, 5, 0.0).unwrap().net().clone(),
            "quarter cylinder about Oz" => {
                let shape =
                    cylinder(&params(&case, "R"), &params(&case, "H"), Part::Quarter).unwrap();
                moved(shape.net(), |[x, y, z, w]| [x, z, y, w])
            }
            _ => {
                let (major, minor) = (params(&case, "R1"), params(&case, "R2"));
                let part = if minor < 0.0 { Part::Inner } else { Part::Outer };
                let shape = torus(&major, &minor.abs(), part).unwrap();
                let turned = moved(shape.net(), |[x, y, z, w]| [z, y, -x, w]);
                transpose(&turned, &[1, 0]).unwrap()
            }
        };
        // The cases are kept to 15 digits.
        near(&computed, &expected, 1e-14, &case.id);
    }
}

fn moved(form: &Form, map: impl Fn([f64; 4]) -> [f64; 4]) -> Form {
    let poles = form.homogeneous().chunks_exact(4).flat_map(|p| map([p[0], p[1], p[2], p[3]]));
    Form::from_homogeneous(form.orders(), 3, poles.collect()).unwrap()
}

#[test]
fn products_of_the_original() {
    for case in cases("cross") {
        let part = |name: &str| Shape::Form(net(&case.input[name]));
        let surface = cross(&part("profile"), &part("section")).unwrap();
        near(surface.net(), &net(&case.expected), 1e-14, &case.id);
    }
}

#[test]
fn bicubic_patches_and_their_true_errors() {
    for case in cases("bicubic") {
        if case.params["printed"] == true {
            continue;
        }
        let number = |name: &str| numbers(&case.params[name])[0];
        let (patch, unit): (Bicubic, f64) = match case.params["surface"].as_str().unwrap() {
            "cylinder" => (bezier_cylinder(number("R"), number("H")).unwrap(), 1.0),
            "cone" => (bezier_cone(number("R"), number("H")).unwrap(), 1.0),
            "sphere" => (bezier_sphere(number("R")).unwrap(), 1.0),
            "torus outer" => {
                (bezier_torus(number("R1"), number("R2"), Part::Outer).unwrap(), number("R2"))
            }
            _ => (bezier_torus(number("R1"), number("R2"), Part::Inner).unwrap(), number("R2")),
        };
        near(&patch.form, &net(&case.expected), 1e-14, &case.id);
        // The measured errors come from a search that stopped at 1e-9 of the unit.
        assert!((patch.outside / unit - number("max_error")).abs() < 1e-9, "{} {patch:?}", case.id);
        assert!((patch.inside / unit + number("min_error")).abs() < 1e-9, "{} {patch:?}", case.id);
        assert_eq!(patch.error(), patch.outside.max(patch.inside));
    }
}

/// The reported error is reached on a fine grid, and not passed.
#[test]
fn errors_of_bicubic_patches_are_the_largest() {
    let (major, minor) = (3.0, 0.7);
    for part in [Part::Outer, Part::Inner] {
        let patch = bezier_torus(major, minor, part).unwrap();
        let off = points(&patch.form.clone().into(), 200)
            .into_iter()
            .map(|p| libm::hypot(libm::hypot(p[0], p[2]) - major, p[1]) - minor);
        let (low, high) = off.fold((0.0_f64, 0.0_f64), |(l, h), x| (l.min(x), h.max(x)));
        // Between neighbours of a grid of 200 steps the error changes by less than 1 % of itself.
        assert!(high <= patch.outside * (1.0 + 1e-12) + 1e-15 && high > 0.99 * patch.outside);
        assert!(-low <= patch.inside * (1.0 + 1e-12) + 1e-15 && -low >= 0.99 * patch.inside);
    }
    let patch = bezier_sphere(2.0).unwrap();
    let off = points(&patch.form.clone().into(), 200).into_iter();
    let most = off.map(|p| libm::hypot(libm::hypot(p[0], p[1]), p[2]) - 2.0).fold(0.0, f64::max);
    assert!(most <= patch.outside * (1.0 + 1e-12) && most > 0.999 * patch.outside);
}

#[test]
fn any_profile_turns_about_any_axis() {
    let axis = Axis::new([1.0, 2.0, -1.0], [3.0, -1.0, 2.0]).unwrap();
    let skew = [2.0, 0.0, 1.0, 2.0, 3.0, 3.0, 0.5, 2.0, 0.0];
    let skew: Form = Form::from_points(&[3], 3, &skew, Some(&[1.0, 0.5, 2.0])).unwrap();
    for angle in [0.4, PI, -2.0, TAU, 8.0] {
        let surface = revolve(&skew.clone().into(), angle, &axis, 3).unwrap();
        let all = surface.pieces().unwrap();
        let wanted = rotated(&skew.at(&[0.3]).unwrap(), angle);
        let came = all[all.len() - 1].at(&[0.3, 1.0]).unwrap();
        for (a, b) in came.iter().zip(&wanted) {
            assert!((a - b).abs() < 1e-14 * (4.0 + angle.abs()), "{angle}: {came:?}, {wanted:?}");
        }
    }
}

/// A point turned about the axis of the test above, by the formula of Rodrigues.
fn rotated(point: &[f64], angle: f64) -> Vec<f64> {
    let (origin, length) = ([1.0, 2.0, -1.0], 14.0_f64.sqrt());
    let n = [3.0, -1.0, 2.0].map(|x| x / length);
    let arm: Vec<f64> = point.iter().zip(origin).map(|(x, o)| x - o).collect();
    let height: f64 = arm.iter().zip(n).map(|(x, n)| x * n).sum();
    let side = |k: usize| n[(k + 1) % 3] * arm[(k + 2) % 3] - n[(k + 2) % 3] * arm[(k + 1) % 3];
    (0..3)
        .map(|k| {
            let across = arm[k] - height * n[k];
            origin[k] + height * n[k] + across * libm::cos(angle) + side(k) * libm::sin(angle)
        })
        .collect()
}

#[test]
fn a_profile_that_touches_the_axis_makes_a_closed_cap() {
    let profile = Form::from_points(&[3], 2, &[0., 0., 2., 0., 2., 1.], None).unwrap();
    let cap = revolve_whole(&profile.into(), &Axis::upright(), Part::Whole).unwrap();
    for j in 0..5 {
        let pole = cap.net().pole(&[0, j]).unwrap();
        assert_eq!(pole[..3], [0.0, 0.0, 0.0]);
    }
    assert!(points(&cap, 8).iter().flatten().copied().all(f64::is_finite));
}

#[test]
fn splines_turn_and_multiply_like_their_pieces() {
    let profile = arc(0.5, PI, 3, 0.0).unwrap();
    let Shape::Spline(curve) = &profile else { panic!("two quarters") };
    let surface = revolve(&profile, PI, &Axis::upright(), 3).unwrap();
    assert_eq!(surface.pieces().unwrap().len(), 4);
    let Shape::Spline(surface) = surface else { panic!("a spline") };
    assert_eq!(surface.counts(), [2, 2]);
    let there = surface.at(&[0.3, 0.0]).unwrap();
    let here = curve.at(&[0.3]).unwrap();
    assert!(there.iter().zip(&here).all(|(a, b)| (a - b).abs() <= ULPS));
}

#[test]
fn knots_lie_on_their_torus_wind_as_asked_and_close() {
    for (p, q) in [(2, 3), (3, 2), (5, -2), (1, 1), (1, 0), (0, -1), (-7, 4)] {
        let (major, minor) = (2.0, 0.6);
        let knot = torus_knot(p, q, major, minor).unwrap();
        let count = 2 * p.abs().max(q.abs()) as usize;
        assert_eq!(knot.counts(), [count]);
        let steps = 24 * count;
        let mut turns = [0.0, 0.0];
        let mut last: Option<[f64; 2]> = None;
        for i in 0..=steps {
            let point = knot.at(&[i as f64 / steps as f64]).unwrap();
            let out = libm::hypot(point[0], point[2]) - major;
            // Nine poles of a product of two rounded arcs.
            assert!((libm::hypot(out, point[1]) - minor).abs() < 64.0 * f64::EPSILON);
            let angles = [libm::atan2(point[2], point[0]), libm::atan2(point[1], out)];
            if let Some(last) = last {
                for k in 0..2 {
                    turns[k] += libm::remainder(angles[k] - last[k], TAU) / TAU;
                }
            }
            last = Some(angles);
        }
        assert!(
            (turns[0] - p as f64).abs() < 1e-9 && (turns[1] - q as f64).abs() < 1e-9,
            "{turns:?}"
        );
        assert!(closes_smoothly(&knot), "{p}, {q}");
    }
}

/// Every piece ends where, and in the direction in which, the next begins.
fn closes_smoothly(knot: &Spline) -> bool {
    let pieces = knot.pieces().unwrap();
    let leg = |form: &Form, i: usize| -> Vec<f64> {
        let [a, b] = [i, i + 1].map(|i| form.pole(&[i]).unwrap());
        (0..3).map(|k| b[k] / b[3] - a[k] / a[3]).collect()
    };
    (0..pieces.len()).all(|i| {
        let (one, next) = (&pieces[i], &pieces[(i + 1) % pieces.len()]);
        let order = one.orders()[0];
        let (a, b) = (leg(one, order - 2), leg(next, 0));
        let [end, start] = [one.at(&[1.0]).unwrap(), next.at(&[0.0]).unwrap()];
        let gaps = a.iter().zip(&b).chain(end.iter().zip(&start));
        gaps.into_iter().all(|(x, y)| (x - y).abs() < 1e-13)
    })
}

#[test]
fn weights_tell_the_kind_of_conic() {
    let corner = |w: f64| {
        let [p0, p1, p2] = [[1., 0.], [1., 1.], [0., 1.]].map(|p| Form::point(&p).unwrap());
        classify(&conic(&p0, &p1, &p2, &w).unwrap(), &1e-12).unwrap()
    };
    let kinds = [0.0, 0.5, FRAC_1_SQRT_2, -FRAC_1_SQRT_2, 1.0, 1.5, -2.0].map(corner);
    let expected = [
        Conic::Segment,
        Conic::Ellipse,
        Conic::Circle,
        Conic::Circle,
        Conic::Parabola,
        Conic::Hyperbola,
        Conic::Hyperbola,
    ];
    assert_eq!(kinds, expected);
    for scale in [1e-150, 1.0, 1e150] {
        let kind = |form: &Form| classify(form, &1e-12).unwrap();
        assert_eq!(kind(arc(scale, 2.0, 3, 0.3).unwrap().net()), Conic::Circle);
        assert_eq!(kind(&parabola(&scale, &scale).unwrap()), Conic::Parabola);
        assert_eq!(kind(&hyperbola(scale, 2.0 * scale, scale).unwrap()), Conic::Hyperbola);
    }
    let line: Form = Form::from_points(&[3], 2, &[0., 0., 1., 1., 5., 5.], None).unwrap();
    assert_eq!(classify(&line, &1e-12).unwrap(), Conic::Segment);
    let point: Form = Form::from_points(&[3], 1, &[4.0; 3], Some(&[1.0, 2.0, -1.0])).unwrap();
    assert_eq!(classify(&point, &1e-12).unwrap(), Conic::Point);
    let k = Root2::half_root().unwrap();
    let arc = arc_by_step(&Root2::ratio(1, 3), &[k.clone(), k], 3).unwrap();
    assert_eq!(classify(&arc, &Root2::zero()).unwrap(), Conic::Circle);
}

#[test]
fn bad_input_is_named() {
    let family = |result: pforms_kernel::Result<Shape>| result.unwrap_err().family();
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(family(arc(radius, 1.0, 3, 0.0)), "Domain");
        assert_eq!(family(circle(&radius, Part::Whole)), "Domain");
        assert_eq!(family(sphere(&radius, Part::Octant)), "Domain");
        assert_eq!(family(torus(&1.0, &radius, Part::Whole)), "Domain");
        assert_eq!(family(cylinder(&1.0, &radius, Part::Whole)), "Domain");
        assert_eq!(family(cone(&radius, &1.0, &0.0, Part::Whole)), "Domain");
        assert_eq!(family(ellipse(&1.0, &radius, Part::Whole)), "Domain");
        assert!(bezier_torus(radius, 1.0, Part::Outer).is_err());
        assert!(bezier_cylinder(1.0, radius).is_err() && bezier_cone(radius, 1.0).is_err());
        assert!(parabola(&radius, &1.0).is_err() && hyperbola(1.0, 1.0, radius).is_err());
    }
    assert_eq!(family(arc(1.0, 0.0, 3, 0.0)), "Degenerate");
    assert_eq!(family(arc(1.0, f64::NAN, 3, 0.0)), "Domain");
    assert_eq!(family(arc(1.0, 1.0, 6, 0.0)), "Domain");
    assert_eq!(family(arc(1.0, 1e300, 3, 0.0)), "Limit");
    assert_eq!(family(cone(&1.0, &1.0, &-0.5, Part::Whole)), "Domain");
    assert_eq!(family(sphere(&1.0, Part::Inner)), "Domain");
    assert_eq!(family(circle(&1.0, Part::Octant)), "Domain");
    assert_eq!(torus_knot(2, 4, 2.0, 1.0).unwrap_err().family(), "Domain");
    assert_eq!(torus_knot(0, 0, 2.0, 1.0).unwrap_err().family(), "Domain");
    assert_eq!(torus_knot(1, i64::MIN, 2.0, 1.0).unwrap_err().family(), "Limit");
    assert_eq!(bezier_torus(1.0, 1.5, Part::Inner).unwrap_err().family(), "Degenerate");
    assert_eq!(bezier_torus(1e150, 1e-150, Part::Outer).unwrap_err().family(), "Domain");
    assert_eq!(Axis::new([0.0; 3], [0.0; 3]).unwrap_err().family(), "Degenerate");
    assert_eq!(Axis::new([0.0; 3], [f64::NAN, 0.0, 1.0]).unwrap_err().family(), "Domain");
    let wide: Shape = Form::from_points(&[1], 4, &[1.0; 4], None).unwrap().into();
    assert_eq!(family(revolve(&wide, 1.0, &Axis::upright(), 3)), "Shape");
    assert_eq!(family(cross(&circle(&1.0, Part::Whole).unwrap(), &wide)), "Shape");
    let point = Form::point(&[1.0]).unwrap();
    assert_eq!(conic(&point, &point, &point, &f64::NAN).unwrap_err().family(), "Domain");
    assert_eq!(classify(&point, &0.0).unwrap_err().family(), "Shape");
}

/// Powers of two scale everything and change no bit.
#[test]
fn sizes_do_not_matter() {
    for scale in [2.0_f64.powi(-500), 2.0_f64.powi(500)] {
        let grown = |form: &Form, shape: &Shape| {
            let pairs = form.homogeneous().chunks(4).zip(shape.net().homogeneous().chunks(4));
            pairs.into_iter().all(|(a, b)| (0..3).all(|k| a[k] * scale == b[k]) && a[3] == b[3])
        };
        for part in [Part::Whole, Part::Pieces] {
            let unit = torus(&3.0, &1.0, part).unwrap();
            assert!(grown(unit.net(), &torus(&(3.0 * scale), &scale, part).unwrap()));
            assert!(grown(sphere(&1.0, part).unwrap().net(), &sphere(&scale, part).unwrap()));
        }
        let unit = arc(1.0, 5.0, 5, 0.3).unwrap();
        assert!(grown(unit.net(), &arc(scale, 5.0, 5, 0.3).unwrap()));
        let patch = bezier_torus(3.0, 1.0, Part::Inner).unwrap();
        let large = bezier_torus(3.0 * scale, scale, Part::Inner).unwrap();
        assert!(grown(&patch.form, &large.form.clone().into()));
        assert_eq!(patch.error() * scale, large.error());
    }
}

#[test]
fn huge_and_tiny_axes_are_axes() {
    for scale in [1e-160, 1e160] {
        let axis = Axis::new([0.0; 3], [0.0, scale, 0.0]).unwrap();
        assert_eq!(axis, Axis::upright());
    }
}
