//! Gordon surfaces: every curve of the network, exactly where parameters are given.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Error, Form, Rational, Scalar};
use pforms_operators::{CoonsOptions, Network, Spline, coons_splines, gordon, gordon_network};
use pforms_testkit::{ROUNDS, Random, Weights, models, numbers};
use serde_json::Value;

fn whole(number: i64) -> Rational {
    Rational::from_integer(number.into())
}

/// Parameters that grow from 0 to 1.
fn places(random: &mut Random, count: usize) -> Vec<Rational> {
    let steps: Vec<i64> = (1..count).map(|_| random.integer(1, 5)).collect();
    let sum: i64 = steps.iter().sum();
    let mut at = 0;
    let mut list = vec![whole(0)];
    for step in steps {
        at += step;
        list.push(Rational::ratio(at, sum));
    }
    list
}

/// Curves of a surface at parameters of both axes.
fn curves(
    surface: &Spline<Rational>,
    u: &[Rational],
    v: &[Rational],
) -> [Vec<Spline<Rational>>; 2] {
    let along = v.iter().map(|t| surface.sub(1, t).unwrap()).collect();
    [along, u.iter().map(|t| surface.sub(0, t).unwrap()).collect()]
}

fn spanned(
    us: &[Spline<Rational>],
    vs: &[Spline<Rational>],
    u: &[Rational],
    v: &[Rational],
) -> Spline<Rational> {
    gordon(us, vs, u, v, &whole(0)).unwrap()
}

#[test]
fn the_surface_has_every_curve_exactly() {
    for seed in 0..ROUNDS / 2 {
        let mut random = Random::new(seed);
        let (m, n) = (random.size(1, 6), random.size(1, 6));
        let (u, v) = (places(&mut random, m), places(&mut random, n));
        let orders = [random.size(2, 6), random.size(2, 6)];
        let weights = [Weights::One, Weights::Positive][random.size(0, 1)];
        let form = random.form::<Rational>(&orders, 2, weights);
        let whole_surface = Spline::from(form).insert_knots(0, &[Rational::ratio(1, 3)]).unwrap();
        let [mut us, vs] = curves(&whole_surface, &u, &v);
        us[0] = us[0].elevate(&[1]).unwrap();
        let surface = spanned(&us, &vs, &u, &v);
        for t in [0, 1, 3, 5, 7, 8].map(|i| Rational::ratio(i, 8)) {
            for (curve, at) in us.iter().zip(&v) {
                let point = surface.homogeneous_at(&[t.clone(), at.clone()]).unwrap();
                assert_eq!(
                    point,
                    curve.homogeneous_at(std::slice::from_ref(&t)).unwrap(),
                    "seed {seed}"
                );
            }
            for (curve, at) in vs.iter().zip(&u) {
                let point = surface.homogeneous_at(&[at.clone(), t.clone()]).unwrap();
                assert_eq!(
                    point,
                    curve.homogeneous_at(std::slice::from_ref(&t)).unwrap(),
                    "seed {seed}"
                );
            }
        }
    }
}

#[test]
fn two_by_two_curves_make_the_coons_patch() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let form = random.form::<Rational>(&[4, 3], 3, Weights::Positive);
        let ends = [whole(0), whole(1)];
        let [us, vs] = curves(&form.into(), &ends, &ends);
        let faces: Vec<&Spline<Rational>> = us.iter().chain(&vs).collect();
        let patch = coons_splines(&faces, &CoonsOptions::default()).unwrap();
        assert_eq!(spanned(&us, &vs, &ends, &ends), patch);
    }
}

#[test]
fn a_bicubic_form_comes_back_from_four_by_four_of_its_curves() {
    let mut random = Random::new(5);
    let (u, v) = (places(&mut random, 4), places(&mut random, 4));
    let form = random.form::<Rational>(&[4, 4], 3, Weights::Positive);
    let [us, vs] = curves(&form.clone().into(), &u, &v);
    assert_eq!(spanned(&us, &vs, &u, &v), form.into());
}

#[test]
fn a_factor_of_a_curve_changes_nothing() {
    let mut random = Random::new(6);
    let (u, v) = (places(&mut random, 3), places(&mut random, 4));
    let form = random.form::<Rational>(&[3, 5], 3, Weights::Positive);
    let [us, vs] = curves(&form.into(), &u, &v);
    let times = |curve: &Spline<Rational>, factor: i64| {
        let net = curve.net();
        let poles = net.homogeneous().iter().map(|x| x * whole(factor)).collect();
        let net = Form::from_homogeneous(net.orders(), net.ambient(), poles).unwrap();
        Spline::on(net, curve.knots().to_vec()).unwrap()
    };
    let scaled: Vec<_> = vs.iter().zip([3, -2, 7]).map(|(curve, k)| times(curve, k)).collect();
    assert_eq!(spanned(&us, &scaled, &u, &v), spanned(&us, &vs, &u, &v));
}

#[test]
fn one_family_alone_is_lofted() {
    let mut random = Random::new(7);
    let v = places(&mut random, 6);
    let us: Vec<Spline<Rational>> =
        (0..6).map(|_| random.form(&[3], 3, Weights::One).into()).collect();
    let surface = spanned(&us, &[], &[], &v);
    assert_eq!(surface.degrees(), [2, 3]);
    for (curve, at) in us.iter().zip(&v) {
        assert_eq!(surface.sub(1, at).unwrap(), *curve);
    }
}

#[test]
fn curves_that_do_not_meet_are_named_with_their_gap() {
    let mut random = Random::new(8);
    let (u, v) = (places(&mut random, 2), places(&mut random, 3));
    let form = random.form::<Rational>(&[3, 3], 2, Weights::One);
    let [mut us, vs] = curves(&form.into(), &u, &v);
    let net = us[1].net().clone();
    let last = net.orders()[0] - 1;
    let mut pole = net.pole(&[last]).unwrap().to_vec();
    pole[0] += whole(2);
    us[1] = Spline::on(net.with_pole(&[last], &pole).unwrap(), us[1].knots().to_vec()).unwrap();
    let answer = gordon(&us, &vs, &u, &v, &whole(0));
    let Err(Error::Domain(fault)) = answer else { panic!("a gap") };
    assert_eq!(fault.received, "curve 1 of us and curve 1 of vs 2 apart");
}

#[test]
fn what_does_not_fit_is_refused() {
    let line = |a: [f64; 2], b: [f64; 2]| -> Spline {
        Form::from_points(&[2], 2, &[a, b].concat(), None).unwrap().into()
    };
    let us = [line([0., 0.], [1., 0.]), line([0., 1.], [1., 1.])];
    let vs = [line([0., 0.], [0., 1.]), line([1., 0.], [1., 1.])];
    let call = |u: &[f64], v: &[f64]| gordon(&us, &vs, u, v, &1e-9);
    assert!(call(&[0., 1.], &[0., 1.]).is_ok());
    assert!(matches!(call(&[0.], &[0., 1.]), Err(Error::Shape(_))));
    assert!(matches!(call(&[1., 0.], &[0., 1.]), Err(Error::Domain(_))));
    assert!(matches!(call(&[0., f64::NAN], &[0., 1.]), Err(Error::Domain(_))));
    assert!(matches!(call(&[0., 2.], &[0., 1.]), Err(Error::Domain(_))));
    assert!(matches!(gordon::<f64>(&[], &[], &[], &[], &0.0), Err(Error::Shape(_))));
    assert!(matches!(gordon_network(&us, &[], 1e-6), Err(Error::Shape(_))));
    assert!(matches!(gordon_network(&us, &vs, 0.0), Err(Error::Domain(_))));
    let away = [line([0., 0.], [0., 1.]), line([5., 0.], [5., 1.])];
    let Err(Error::Domain(fault)) = gordon_network(&us, &away, 1e-6) else { panic!("a gap") };
    assert!(fault.received.starts_with("curve 0 of us and curve 1 of vs 4"), "{fault:?}");
}

fn spline(record: &Value) -> Spline {
    let patch = models::plain::read(record);
    Spline::new(patch.net, &patch.degrees, patch.knots).unwrap()
}

fn splines(records: &Value) -> Vec<Spline> {
    records.as_array().unwrap().iter().map(spline).collect()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum: f64, (x, y)| sum.hypot(x - y))
}

/// Distance from a point to a polygon.
fn to_polygon(point: &[f64], corners: &[f64]) -> f64 {
    let to_segment = |pair: &[f64]| {
        let (a, b) = pair.split_at(3);
        let (mut along, mut squares) = (0.0, 0.0);
        for k in 0..3 {
            along += (point[k] - a[k]) * (b[k] - a[k]);
            squares += (b[k] - a[k]).powi(2);
        }
        let share = if squares > 0.0 { (along / squares).clamp(0.0, 1.0) } else { 0.0 };
        let off = |k: usize| point[k] - a[k] - share * (b[k] - a[k]);
        (0..3).map(|k| off(k).powi(2)).sum::<f64>().sqrt()
    };
    let pairs = (0..corners.len() / 3 - 1).map(|i| &corners[3 * i..3 * i + 6]);
    pairs.map(to_segment).fold(f64::INFINITY, f64::min)
}

const NETWORKS: [&str; 9] = [
    "bellyfairing",
    "ffd",
    "full_nacelle",
    "fuselage1",
    "nacelle",
    "spiralwing",
    "test_surface4",
    "wing2",
    "wing3",
];

/// The curves of the spiral wing miss each other by 10⁻⁴, those of the others by 10⁻⁷ of their size.
fn accuracy(name: &str) -> f64 {
    if name == "spiralwing" { 2e-4 } else { 1e-6 }
}

#[test]
fn networks_of_aircraft_are_interpolated_within_the_accuracy() {
    for name in NETWORKS {
        let file = models::document(&format!("tigl/{name}.json"));
        let [us, vs] = ["profiles", "guides"].map(|family| splines(&file[family]));
        let all = || us.iter().chain(&vs);
        let size = all().flat_map(|curve| curve.net().points().unwrap());
        let size = size.fold(0.0, |size: f64, x| size.max(x.abs()));
        let accuracy = accuracy(name);
        let found = gordon_network(&us, &vs, accuracy).unwrap_or_else(|e| panic!("{name}: {e}"));
        let listed = file["max_gap_of_listed_intersections"].as_f64().unwrap();
        assert!(found.gap <= 1.001 * listed + 1e-12 * size, "{name}: {} {listed}", found.gap);
        // Curves are followed within a quarter of the accuracy, and gaps add to that.
        let allowed = accuracy * size;
        assert!(found.error <= allowed, "{name}: {} of {allowed}", found.error);
        assert_eq!((found.u.len(), found.v.len()), (vs.len(), us.len()));
        assert_on_surface(name, &us, &found, 1, size);
        assert_on_surface(name, &vs, &found, 0, size);
    }
}

/// As point sets: points of the curves, and how far they are from the nearest of the polygons that
/// lie in the surface where the curves should.
fn assert_on_surface(name: &str, curves: &[Spline], found: &Network, axis: usize, size: f64) {
    const SIDES: u32 = 2000;
    let fine: Vec<f64> = (0..=SIDES).map(|i| f64::from(i) / f64::from(SIDES)).collect();
    let at = if axis == 1 { &found.v } else { &found.u };
    let isocurve = |t| found.spline.sub(axis, t).unwrap().scattered(&[&fine]).unwrap();
    let lines: Vec<Vec<f64>> = at.iter().map(isocurve).collect();
    for curve in curves {
        let (from, to) = curve.window(0).unwrap();
        let middle = 0.5 * (from + to);
        // Ends that stick out of the network are cut off; its middle never is.
        let reach = if name == "test_surface4" { 0.01 } else { 0.49 } * (to - from);
        let points: Vec<Vec<f64>> =
            (-3..=3).map(|i| curve.at(&[middle + reach * f64::from(i) / 3.0]).unwrap()).collect();
        let off = |line: &Vec<f64>| {
            points.iter().map(|point| to_polygon(point, line)).fold(0.0, f64::max)
        };
        let nearest = lines.iter().map(off).fold(f64::INFINITY, f64::min);
        // A polygon of 2000 sides leaves its curve by some millionths of the size.
        assert!(nearest <= found.error + 1e-5 * size, "{name}: {nearest}");
    }
}

fn peer(id: &str) -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/peers/gordon.json");
    let file: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let cases = file["cases"].as_array().unwrap();
    cases.iter().find(|case| case["id"] == id).unwrap().clone()
}

fn assert_samples(case: &Value, point: impl Fn(&[f64]) -> Vec<f64>) {
    let tolerance = case["tolerance"].as_f64().unwrap();
    let samples = case["expected"]["samples"].as_array().unwrap();
    assert!(samples.len() > 50);
    for sample in samples {
        let off = distance(&point(&numbers(&sample["u"])), &numbers(&sample["point"]));
        assert!(off <= tolerance, "{sample}: {off}");
    }
}

#[test]
fn the_trough_of_tigl() {
    let case = peer("tigl-gordon-parabolic-trough");
    let input = &case["input"];
    let [us, vs] = ["u_curves", "v_curves"].map(|family| splines(&input[family]));
    let [u, v] = ["u_params_of_v_curves", "v_params_of_u_curves"].map(|name| numbers(&input[name]));
    let given = gordon(&us, &vs, &u, &v, &1e-12).unwrap();
    assert_samples(&case, |t| given.at(t).unwrap());
    let found = gordon_network(&us, &vs, 1e-6).unwrap();
    assert!(found.error < 1e-12 && found.gap < 1e-12, "{found:?}");
    // A parameter is found as well as rounding lets the nearest points be told apart.
    assert!(distance(&found.u, &u) < 1e-7 && distance(&found.v, &v) < 1e-7);
}

#[test]
fn the_skin_of_tigl_over_two_curves() {
    let case = peer("tigl-skin-two-curves");
    let us = ["curve0", "curve1"].map(|name| spline(&case["input"][name]));
    let skin = gordon(&us, &[], &[], &[0.0, 1.0], &0.0).unwrap();
    assert_samples(&case, |t| skin.at(t).unwrap());
}

#[test]
fn closed_profiles_with_their_seam_guide_twice_close_the_surface() {
    let file = models::document("tigl/wing3.json");
    let [us, vs] = ["profiles", "guides"].map(|family| splines(&file[family]));
    let found = gordon_network(&us, &vs, 1e-6).unwrap();
    for i in 0..=20 {
        let v = f64::from(i) / 20.0;
        let [a, b] = [0.0, 1.0].map(|u| found.spline.at(&[u, v]).unwrap());
        assert!(distance(&a, &b) < 1e-9, "{v}");
    }
}

#[test]
fn order_and_directions_of_curves_are_found() {
    let form: Form = Random::new(11).rough_form(&[3, 4], 3, Weights::One);
    let surface = Spline::from(form);
    let (u, v) = ([0.0, 0.4, 1.0], [0.0, 0.3, 0.6, 1.0]);
    let us = v.map(|t| surface.sub(1, &t).unwrap());
    let vs = u.map(|t| surface.sub(0, &t).unwrap());
    let turned = |curve: &Spline| curve.reverse(0).unwrap();
    let mixed_us = [us[0].clone(), turned(&us[2]), us[3].clone(), turned(&us[1])];
    let mixed_vs = [vs[0].clone(), turned(&vs[2]), turned(&vs[1])];
    let found = gordon_network(&mixed_us, &mixed_vs, 1e-6).unwrap();
    assert!(distance(&found.u, &u) < 1e-7 && distance(&found.v, &v) < 1e-7);
    for t in [[0.1, 0.9], [0.5, 0.5], [0.8, 0.2]] {
        let off = distance(&found.spline.at(&t).unwrap(), &surface.at(&t).unwrap());
        assert!(off < 1e-6, "{off}");
    }
}

#[test]
fn curves_that_cross_at_unequal_parameters_are_followed() {
    // Lines of a plane run through at other speeds: the surface is the plane, its border the square.
    let rational = |points: [[f64; 2]; 3], weight: f64| -> Spline {
        let form = Form::from_points(&[3], 2, &points.concat(), Some(&[1.0, weight, 1.0]));
        form.unwrap().into()
    };
    let us = [
        rational([[0., 0.], [0.3, 0.], [1., 0.]], 2.0),
        rational([[0., 1.], [0.9, 1.], [1., 1.]], 1.0),
    ];
    let vs = [
        rational([[0., 0.], [0., 0.6], [0., 1.]], 1.0),
        rational([[0.5, 0.], [0.5, 0.6], [0.5, 1.]], 1.0),
        rational([[1., 0.], [1., 0.5], [1., 1.]], 0.5),
    ];
    let found = gordon_network(&us, &vs, 1e-7).unwrap();
    assert!(found.error < 1e-7 && found.gap < 1e-12, "{} {}", found.error, found.gap);
    for i in 0..=10 {
        let t = 0.1 * f64::from(i);
        assert!(found.spline.at(&[t, 0.0]).unwrap()[1].abs() < 1e-7);
        assert!((found.spline.at(&[found.u[1], t]).unwrap()[0] - 0.5).abs() < 1e-7);
    }
}

#[test]
fn a_power_of_two_changes_no_bit() {
    let file = models::document("tigl/test_surface4.json");
    let [us, vs] = ["profiles", "guides"].map(|family| splines(&file[family]));
    let plain = gordon_network(&us, &vs, 1e-6).unwrap();
    for by in [2.0_f64.powi(600), 2.0_f64.powi(-600)] {
        let times = |curve: &Spline| {
            let points: Vec<f64> = curve.net().points().unwrap().iter().map(|x| x * by).collect();
            let net = Form::from_points(curve.net().orders(), 3, &points, None).unwrap();
            Spline::on(net, curve.knots().to_vec()).unwrap()
        };
        let [large_us, large_vs] = [&us, &vs].map(|all| all.iter().map(times).collect::<Vec<_>>());
        let scaled = gordon_network(&large_us, &large_vs, 1e-6).unwrap();
        assert_eq!(scaled.spline, times(&plain.spline));
        assert_eq!((scaled.error, scaled.gap), (plain.error * by, plain.gap * by));
    }
}

#[test]
fn a_curve_may_be_a_point_but_not_all_of_them() {
    let curve = |points: [[f64; 3]; 2]| -> Spline {
        Form::from_points(&[2], 3, &points.concat(), None).unwrap().into()
    };
    let nose = curve([[0., 0., 2.]; 2]);
    let base = curve([[-1., 0., 0.], [1., 0., 0.]]);
    let vs = [-1.0, 0.25, 1.0].map(|x| curve([[0., 0., 2.], [x, 0., 0.]]));
    for us in [[nose.clone(), base.clone()], [base, nose.clone()]] {
        let found = gordon_network(&us, &vs, 1e-6).unwrap();
        assert!(found.error < 1e-12 && found.gap < 1e-12, "{} {}", found.error, found.gap);
        assert!((found.u[1] - 0.625).abs() < 1e-9);
        let middle = found.spline.at(&[0.3, 0.5]).unwrap();
        assert!(distance(&middle, &[-0.2, 0.0, 1.0]) < 1e-9, "{middle:?}");
    }
    let answer = gordon_network(&[nose.clone(), nose], &vs[..1], 1e-6);
    assert!(matches!(answer, Err(Error::Degenerate(_))), "{answer:?}");
}
