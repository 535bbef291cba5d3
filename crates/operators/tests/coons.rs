//! Coons patches: their faces, exactly, and between them the Boolean sum.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Error, Form, Rational, Result, Scalar};
use pforms_operators::{CoonsOptions, Poles, Spline, coons, coons_splines, raise_to, sub};
use pforms_testkit::{ROUNDS, Random, Weights, cases, models, net};

type Exact = Form<Rational>;

fn whole(number: i64) -> Rational {
    Rational::from_integer(number.into())
}

fn patch(faces: &[Exact]) -> Result<Exact> {
    coons(&faces.iter().collect::<Vec<_>>(), &CoonsOptions::default())
}

fn blended(faces: &[Exact]) -> Result<Exact> {
    let options = CoonsOptions { pointwise: true, ..CoonsOptions::default() };
    coons(&faces.iter().collect::<Vec<_>>(), &options)
}

/// The axis that each face stands across, and its side, in the order of the arguments.
fn places(axes: usize) -> Vec<(usize, Rational)> {
    let sides = |axis| [(axis, Rational::zero()), (axis, Rational::one())];
    (0..axes).rev().flat_map(sides).collect()
}

fn faces_of(form: &Exact) -> Vec<Exact> {
    places(form.axes()).iter().map(|(axis, t)| sub(form, *axis, t).unwrap()).collect()
}

fn random_box(random: &mut Random, axes: usize, weights: Weights) -> Exact {
    let orders: Vec<usize> = (0..axes).map(|_| random.size(2, 4)).collect();
    let ambient = random.size(1, 3);
    random.form(&orders, ambient, weights)
}

fn times(form: &Exact, factor: &Rational) -> Exact {
    let poles = form.homogeneous().iter().map(|x| x * factor).collect();
    Form::from_homogeneous(form.orders(), form.ambient(), poles).unwrap()
}

/// The same points at the same parameters of a curve, with one pole more and other weights.
fn weighted(curve: &Exact, start: i64, end: i64) -> Exact {
    let factor = Exact::from_homogeneous(&[2], 1, [start, 1, end, 1].map(whole).to_vec());
    let factor = pforms_kernel::Scaled::from_form(&factor.unwrap()).component(0);
    pforms_kernel::Scaled::from_form(curve).times(&factor).unwrap().into_form().unwrap()
}

/// The Boolean sum at a point, from the definition, on homogeneous poles or on points.
fn boolean_sum(faces: &[Exact], t: &[Rational], on_points: bool) -> Vec<Rational> {
    let axes = t.len();
    let mut sum: Option<Vec<Rational>> = None;
    for code in 1..3_usize.pow(axes as u32) {
        let side: Vec<usize> = (0..axes).map(|k| code / 3_usize.pow(k as u32) % 3).collect();
        let fixed: Vec<usize> = (0..axes).filter(|&k| side[k] > 0).collect();
        let (first, others) = fixed.split_last().unwrap();
        let mut part = faces[2 * (axes - 1 - first) + side[*first] - 1].clone();
        let mut factor = -Rational::one();
        for &k in &fixed {
            let blend = if side[k] == 2 { t[k].clone() } else { Rational::one() - &t[k] };
            factor = -factor * blend;
        }
        for &k in others.iter().rev() {
            part = sub(&part, k, &whole(side[k] as i64 - 1)).unwrap();
        }
        let free: Vec<Rational> =
            (0..axes).filter(|&k| side[k] == 0).map(|k| t[k].clone()).collect();
        let value =
            if on_points { part.at(&free).unwrap() } else { part.homogeneous_at(&free).unwrap() };
        let terms: Vec<Rational> = value.iter().map(|x| x * &factor).collect();
        sum = Some(match sum {
            None => terms,
            Some(sum) => sum.iter().zip(&terms).map(|(a, b)| a + b).collect(),
        });
    }
    sum.unwrap()
}

#[test]
fn a_patch_has_its_faces_exactly_in_every_dimension() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let axes = random.size(1, 4);
        let weights = [Weights::One, Weights::Positive][random.size(0, 1)];
        let faces = faces_of(&random_box(&mut random, axes, weights));
        let patch = patch(&faces).unwrap();
        assert_eq!(patch.axes(), axes);
        for (face, (axis, t)) in faces.iter().zip(places(axes)) {
            assert_eq!(sub(&patch, axis, &t).unwrap(), *face, "seed {seed}, axis {axis}");
        }
    }
}

#[test]
fn orders_that_differ_are_raised() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let whole = random_box(&mut random, 2, Weights::Positive);
        let mut faces = faces_of(&whole);
        for face in &mut faces {
            *face = raise_to(face, &[face.orders()[0] + random.size(0, 2)]).unwrap();
        }
        let patch = patch(&faces).unwrap();
        assert_eq!(patch.orders()[0], faces[0].orders()[0].max(faces[1].orders()[0]));
        assert_eq!(patch.orders()[1], faces[2].orders()[0].max(faces[3].orders()[0]));
        for (face, (axis, t)) in faces.iter().zip(places(2)) {
            let side = sub(&patch, axis, &t).unwrap();
            assert_eq!(side, raise_to(face, side.orders()).unwrap());
        }
    }
}

#[test]
fn inside_it_is_the_boolean_sum() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let axes = random.size(1, 4);
        let faces = faces_of(&random_box(&mut random, axes, Weights::Positive));
        let t = random.parameters(axes);
        let patch = patch(&faces).unwrap();
        assert_eq!(patch.homogeneous_at(&t).unwrap(), boolean_sum(&faces, &t, false));
    }
}

#[test]
fn pointwise_it_is_the_boolean_sum_of_points() {
    for seed in 0..ROUNDS / 4 {
        let mut random = Random::new(seed);
        let axes = random.size(1, 2);
        assert_pointwise(&random_box(&mut random, axes, Weights::Positive), &mut random);
    }
    // Twelve edges and six faces of other weights: the degrees add up, so small ones here.
    let mut random = Random::new(1);
    assert_pointwise(&random.form(&[2, 3, 2], 1, Weights::Positive), &mut random);
}

fn assert_pointwise(form: &Exact, random: &mut Random) {
    let axes = form.axes();
    let faces = faces_of(form);
    let t = random.parameters(axes);
    let patch = blended(&faces).unwrap();
    assert_eq!(patch.at(&t).unwrap(), boolean_sum(&faces, &t, true));
    for (face, (axis, side)) in faces.iter().zip(places(axes)) {
        let there = random.parameters(axes - 1);
        let edge = sub(&patch, axis, &side).unwrap();
        assert_eq!(edge.at(&there).unwrap(), face.at(&there).unwrap());
    }
}

#[test]
fn pointwise_and_homogeneous_agree_without_weights() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let axes = random.size(1, 3);
        let faces = faces_of(&random_box(&mut random, axes, Weights::One));
        assert_eq!(blended(&faces).unwrap(), patch(&faces).unwrap());
    }
}

#[test]
fn a_bilinear_or_trilinear_form_comes_back() {
    for axes in 1..=4 {
        let form = Random::new(7).form(&vec![2; axes], 3, Weights::Positive);
        assert_eq!(patch(&faces_of(&form)).unwrap(), form);
    }
}

#[test]
fn a_constant_factor_of_a_face_changes_nothing() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let axes = random.size(2, 3);
        let faces = faces_of(&random_box(&mut random, axes, Weights::Positive));
        let factor = |i: usize| Rational::ratio(i as i64 + 2, 3 - 6 * (i as i64 % 2));
        let mut scaled: Vec<Exact> =
            faces.iter().enumerate().map(|(i, face)| times(face, &factor(i))).collect();
        scaled[0] = faces[0].clone();
        assert_eq!(patch(&scaled).unwrap(), patch(&faces).unwrap());
    }
}

#[test]
fn curves_that_meet_with_other_weights_keep_their_points() {
    for seed in 0..ROUNDS / 4 {
        let mut random = Random::new(seed);
        let mut faces = faces_of(&random_box(&mut random, 2, Weights::Positive));
        faces[0] = weighted(&faces[0], 1, 2);
        faces[3] = weighted(&faces[3], 5, 3);
        let patch = patch(&faces).unwrap();
        for (face, (axis, side)) in faces.iter().zip(places(2)) {
            let edge = sub(&patch, axis, &side).unwrap();
            for t in [0, 1, 2, 5, 7].map(|i| [Rational::ratio(i, 7)]) {
                assert_eq!(edge.at(&t).unwrap(), face.at(&t).unwrap());
            }
        }
        let t = random.parameters(2);
        assert_eq!(patch.at(&t).unwrap(), boolean_sum(&faces, &t, true));
    }
}

#[test]
fn corners_at_infinity_and_weights_of_any_sign_are_blended_homogeneously() {
    let form = Exact::from_homogeneous(
        &[3, 2],
        2,
        [1, 0, 0, 0, 1, 0, 2, 1, -1, 3, 3, 1, 0, 4, 1, 5, 5, 1].map(whole).to_vec(),
    )
    .unwrap();
    let faces = faces_of(&form);
    let patch = patch(&faces).unwrap();
    for (face, (axis, t)) in faces.iter().zip(places(2)) {
        assert_eq!(sub(&patch, axis, &t).unwrap(), *face);
    }
    let Err(Error::Domain(fault)) = blended(&faces) else { panic!("a corner at infinity") };
    assert!(fault.received.contains("infinity"), "{fault:?}");
}

#[test]
fn in_floating_arithmetic_the_faces_are_kept_to_the_bit() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let form = random.rough_form(&[3, 4, 2], 3, Weights::Positive);
        let faces: Vec<Form> = (0..3)
            .rev()
            .flat_map(|axis| [0.0, 1.0].map(|t| sub(&form, axis, &t).unwrap()))
            .collect();
        let patch = coons(&faces.iter().collect::<Vec<_>>(), &CoonsOptions::default()).unwrap();
        for (index, face) in faces.iter().enumerate() {
            let side = sub(&patch, 2 - index / 2, &((index % 2) as f64)).unwrap();
            assert_eq!(side, *face);
        }
    }
}

#[test]
fn a_power_of_two_changes_no_bit() {
    let mut random = Random::new(3);
    let form = random.rough_form(&[4, 3], 3, Weights::One);
    let sides = |form: &Form| {
        let ends = |axis| [0.0, 1.0].map(|t| sub(form, axis, &t).unwrap());
        let faces: Vec<Form> = [1, 0].into_iter().flat_map(ends).collect();
        coons(&faces.iter().collect::<Vec<_>>(), &CoonsOptions::default()).unwrap()
    };
    let scaled = |form: &Form, by: f64| {
        let points: Vec<f64> = form.points().unwrap().iter().map(|x| x * by).collect();
        Form::from_points(form.orders(), 3, &points, None).unwrap()
    };
    for by in [2.0_f64.powi(480), 2.0_f64.powi(-480)] {
        assert_eq!(sides(&scaled(&form, by)), scaled(&sides(&form), by));
    }
}

#[test]
fn cases_of_the_original_system() {
    for case in cases("coons") {
        let curves: Vec<Form> =
            ["c0", "c1", "d0", "d1"].map(|name| net(&case.input[name])).to_vec();
        let patch = coons(&curves.iter().collect::<Vec<_>>(), &CoonsOptions::default()).unwrap();
        let expected: Form = net(&case.expected);
        assert_eq!(patch.orders(), expected.orders(), "{}", case.id);
        // Numbers kept to 15 digits, coordinates below 10.
        for (a, b) in patch.homogeneous().iter().zip(expected.homogeneous()) {
            assert!((a - b).abs() <= 1e-13, "{}: {a} for {b}", case.id);
        }
    }
}

fn curve(points: &[f64]) -> Form {
    Form::from_points(&[points.len() / 2], 2, points, None).unwrap()
}

fn square() -> Vec<Form> {
    [[0., 0., 1., 0.], [0., 1., 1., 1.], [0., 0., 0., 1.], [1., 0., 1., 1.]]
        .iter()
        .map(|points| curve(points))
        .collect()
}

fn refusal(faces: &[Form]) -> Error {
    coons(&faces.iter().collect::<Vec<_>>(), &CoonsOptions::default()).unwrap_err()
}

#[test]
fn a_gap_is_named_with_its_corner() {
    let mut faces = square();
    faces[3] = curve(&[1., 0., 4., 5.]);
    let Error::Domain(fault) = refusal(&faces) else { panic!("a gap") };
    assert_eq!(fault.received, "curve v=1 and curve u=1 5 apart at corner (u, v) = (1, 1)");
    let options = CoonsOptions { accuracy: 1.0, pointwise: false };
    assert!(coons(&faces.iter().collect::<Vec<_>>(), &options).is_ok(), "4 of 5 is within 1 of 5");
}

#[test]
fn surfaces_that_part_between_their_corners_are_named_with_their_edge() {
    let whole = Random::new(1).form::<Rational>(&[3, 3, 3], 3, Weights::One);
    let mut faces = faces_of(&whole);
    let mut pole = faces[4].pole(&[1, 0]).unwrap().to_vec();
    pole[0] += Rational::one();
    faces[4] = faces[4].with_pole(&[1, 0], &pole).unwrap();
    let Err(Error::Domain(fault)) = patch(&faces) else { panic!("a gap") };
    assert_eq!(fault.received, "surface w=0 and surface u=0 1 apart at edge w=0, u=0");
}

#[test]
fn wrong_counts_dimensions_and_accuracies_are_refused() {
    let faces = square();
    assert!(matches!(refusal(&faces[..3]), Error::Shape(_)));
    assert!(matches!(refusal(&[]), Error::Shape(_)));
    assert!(matches!(refusal(&faces[..2]), Error::Shape(_)));
    let mut mixed = faces.clone();
    mixed[1] = Form::from_points(&[2], 3, &[0., 1., 0., 1., 1., 0.], None).unwrap();
    assert!(matches!(refusal(&mixed), Error::Shape(_)));
    for accuracy in [f64::NAN, -1.0, f64::INFINITY] {
        let options = CoonsOptions { accuracy, pointwise: false };
        let answer = coons(&faces.iter().collect::<Vec<_>>(), &options);
        assert!(matches!(answer, Err(Error::Domain(_))));
    }
    let nowhere = Form::from_homogeneous(&[2], 2, vec![0., 0., 0., 1., 0., 1.]).unwrap();
    let mut undefined = faces;
    undefined[0] = nowhere;
    assert!(matches!(refusal(&undefined), Error::Domain(_)));
}

/// A spline over random knots, some of them repeated.
fn random_spline(random: &mut Random, axes: usize, weights: Weights) -> Spline<Rational> {
    let degrees: Vec<usize> = (0..axes).map(|_| random.size(1, 3)).collect();
    let knots: Vec<Vec<Rational>> = degrees
        .iter()
        .map(|&degree| {
            let inner = random.size(0, 2);
            let mut list = vec![whole(0); degree + 1];
            list.extend((0..inner).flat_map(|i| vec![whole(1 + i as i64); random.size(1, degree)]));
            list.extend(vec![whole(3); degree + 1]);
            list
        })
        .collect();
    let orders: Vec<usize> =
        knots.iter().zip(&degrees).map(|(list, degree)| list.len() - degree - 1).collect();
    let ambient = random.size(1, 3);
    Spline::new(random.form(&orders, ambient, weights), &degrees, knots).unwrap()
}

fn sides(spline: &Spline<Rational>) -> Vec<Spline<Rational>> {
    let ends = (0..spline.axes()).rev().flat_map(|axis| [(axis, whole(0)), (axis, whole(3))]);
    ends.map(|(axis, t)| spline.sub(axis, &t).unwrap()).collect()
}

fn spanned(faces: &[Spline<Rational>], pointwise: bool) -> Result<Spline<Rational>> {
    let options = CoonsOptions { pointwise, ..CoonsOptions::default() };
    coons_splines(&faces.iter().collect::<Vec<_>>(), &options)
}

#[test]
fn a_patch_of_splines_has_its_faces_exactly() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let axes = random.size(2, 3);
        let mut faces = sides(&random_spline(&mut random, axes, Weights::Positive));
        // Other degrees, other knots and another window change nothing.
        let last = faces.len() - 1;
        faces[last] = faces[last].elevate(&vec![1; axes - 1]).unwrap();
        faces[0] = faces[0].insert_knots(0, &[Rational::ratio(5, 3)]).unwrap();
        faces[1] = faces[1].on_window(0, &whole(-1), &whole(1)).unwrap();
        let patch = spanned(&faces, false).unwrap();
        for (index, face) in faces.iter().enumerate() {
            let (axis, end) = (axes - 1 - index / 2, whole(3 * (index as i64 % 2)));
            let side = patch.sub(axis, &end).unwrap();
            for _ in 0..4 {
                let t: Vec<Rational> =
                    (0..axes - 1).map(|_| whole(3) * random.parameter::<Rational>()).collect();
                let mut own = t.clone();
                if index == 1 {
                    own[0] = own[0].clone() * Rational::ratio(2, 3) - whole(1);
                }
                assert_eq!(
                    side.homogeneous_at(&t).unwrap(),
                    face.homogeneous_at(&own).unwrap(),
                    "seed {seed}, face {index}"
                );
            }
        }
    }
}

#[test]
fn between_splines_it_is_the_boolean_sum_with_and_without_weights() {
    for seed in 0..ROUNDS / 4 {
        let mut random = Random::new(seed);
        let faces = sides(&random_spline(&mut random, 2, Weights::Positive));
        let [u, v]: [Rational; 2] = [(); 2].map(|()| random.parameter());
        for pointwise in [false, true] {
            let patch = spanned(&faces, pointwise).unwrap();
            let at = |spline: &Spline<Rational>, t: &[Rational]| {
                if pointwise { spline.at(t).unwrap() } else { spline.homogeneous_at(t).unwrap() }
            };
            let [c0, c1] = [0, 1].map(|i| at(&faces[i], &[whole(3) * &u]));
            let [d0, d1] = [2, 3].map(|i| at(&faces[i], &[whole(3) * &v]));
            let corner = |i: usize, t: i64| at(&faces[i], &[whole(3 * t)]);
            let expected: Vec<Rational> = (0..c0.len())
                .map(|k| {
                    let (s, t) = (whole(1) - &u, whole(1) - &v);
                    let ruled = &t * &c0[k] + &v * &c1[k] + &s * &d0[k] + &u * &d1[k];
                    let facet = &s * (&t * &corner(0, 0)[k] + &v * &corner(1, 0)[k])
                        + &u * (&t * &corner(0, 1)[k] + &v * &corner(1, 1)[k]);
                    ruled - facet
                })
                .collect();
            assert_eq!(at(&patch, &[whole(3) * &u, whole(3) * &v]), expected, "seed {seed}");
        }
    }
}

#[test]
fn one_piece_of_a_spline_is_a_form() {
    let form = Random::new(2).form::<Rational>(&[3, 4], 3, Weights::Positive);
    let faces = faces_of(&form);
    let splines: Vec<Spline<Rational>> = faces.iter().cloned().map(Spline::from).collect();
    assert_eq!(spanned(&splines, false).unwrap(), patch(&faces).unwrap().into());
}

#[test]
fn splines_that_do_not_meet_are_named() {
    let spline = random_spline(&mut Random::new(4), 3, Weights::Positive);
    let mut faces = sides(&spline);
    let orders = faces[4].net().orders().to_vec();
    let index = [0, orders[1] - 1];
    let mut pole = faces[4].net().pole(&index).unwrap().to_vec();
    let weight = pole.last().unwrap().clone();
    pole[0] += weight;
    faces[4] = faces[4].with_net(faces[4].net().with_pole(&index, &pole).unwrap()).unwrap();
    let Err(Error::Domain(fault)) = spanned(&faces, false) else { panic!("a gap") };
    assert_eq!(
        fault.received,
        "surface w=1 and surface u=0 1 apart at corner (u, v, w) = (0, 0, 1)"
    );
}

#[test]
fn the_boundary_that_gismo_ships() {
    let file = models::text("gismo/curves3d-curve_boundary.xml");
    let curves = models::gismo::read(&file).into_iter();
    let curves = curves.map(|patch| Spline::new(patch.net, &patch.degrees, patch.knots).unwrap());
    let curves: Vec<Spline> = curves.collect();
    let [left, right, back, front] = &curves[..] else { panic!("four curves") };
    let patch = coons_splines(&[front, back, left, right], &CoonsOptions::default()).unwrap();
    assert_eq!(patch.degrees(), [2, 2]);
    for (curve, axis, end) in [(front, 1, 0.0), (back, 1, 1.0), (left, 0, 0.0), (right, 0, 1.0)] {
        assert_eq!(patch.sub(axis, &end).unwrap(), *curve);
    }
}
