//! Combinations and products of points, nets, extrusions and ruled forms: laws with `==`.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use std::slice::from_ref;

use pforms_kernel::{Form, Rational, Result, Scalar};
use pforms_operators::{
    Poles, Shape, Spline, combine, combine_pointwise, combine_shapes, extrude, extrude_along,
    extrude_shapes, multiply, regular, ruled, ruled_shapes, symmetric, translate,
};
use pforms_testkit::{ROUNDS, Random, Weights, cases, net, numbers};

type Exact = Form<Rational>;

fn ratio(a: i64, b: i64) -> Rational {
    Rational::ratio(a, b)
}

fn family<T: std::fmt::Debug>(result: Result<T>) -> &'static str {
    result.unwrap_err().family()
}

/// Forms of the same axes in the same space, some polynomial, some rational.
fn forms(random: &mut Random, count: usize) -> Vec<Exact> {
    let (axes, ambient) = (random.size(0, 2), random.size(1, 3));
    let one = |random: &mut Random| {
        let weights = [Weights::One, Weights::Positive][random.size(0, 1)];
        let orders = random.orders(axes, 3);
        random.form(&orders, ambient, weights)
    };
    (0..count).map(|_| one(random)).collect()
}

fn at(shape: &Shape<Rational>, t: &[Rational]) -> Vec<Rational> {
    shape.clone().into_spline().at(t).unwrap()
}

/// A random spline of degree 2 over [0, 3] along its first axis.
fn spline(random: &mut Random, weights: Weights, inner: &[i64]) -> Spline<Rational> {
    let knots: Vec<Rational> =
        [&[0, 0, 0], inner, &[3, 3, 3]].concat().into_iter().map(|k| ratio(k, 1)).collect();
    let net = random.form(&[inner.len() + 3], 2, weights);
    Spline::new(net, &[2], vec![knots]).unwrap()
}

#[test]
fn a_pointwise_combination_combines_points() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let count = random.size(1, 4);
        let mut all = forms(&mut random, count);
        if random.size(0, 1) == 1 {
            // One that shares its weights with the first, but for a factor.
            all.push(combine(&[ratio(-3, 2)], &[&all[0]]).unwrap());
        }
        let k: Vec<Rational> = all.iter().map(|_| random.fraction()).collect();
        let refs: Vec<&Exact> = all.iter().collect();
        let sum = combine_pointwise(&k, &refs).unwrap();
        let t = random.parameters(all[0].axes());
        let mut expected = vec![<Rational as Scalar>::zero(); all[0].ambient()];
        for (k, form) in k.iter().zip(&all) {
            Rational::add_multiple(&mut expected, k, &form.at(&t).unwrap());
        }
        assert_eq!(sum.at(&t).unwrap(), expected, "{seed}");
    }
}

#[test]
fn proportional_weights_are_counted_once() {
    let mut random = Random::new(5);
    let arc: Exact = random.form(&[3], 2, Weights::Positive);
    let twin = translate(&combine(&[ratio(2, 1)], &[&arc]).unwrap(), &[ratio(1, 1), ratio(0, 1)]);
    let other: Exact = random.form(&[3], 2, Weights::Positive);
    let line: Exact = random.form(&[2], 2, Weights::One);
    let k = [ratio(1, 2), ratio(1, 3), ratio(1, 6)];
    let orders =
        |forms: &[&Exact]| combine_pointwise(&k[..forms.len()], forms).unwrap().orders().to_vec();
    let twin = twin.unwrap();
    assert_eq!(orders(&[&arc, &twin]), [3]);
    assert_eq!(orders(&[&arc, &other]), [5]);
    assert_eq!(orders(&[&arc, &twin, &line]), [4]);
    assert_eq!(orders(&[&line, &line]), [2]);
}

#[test]
fn directions_add_as_vectors() {
    let point: Form = Form::from_points(&[2], 2, &[1., 2., 3., 4.], Some(&[2., 2.])).unwrap();
    let vector = Form::from_points(&[2], 2, &[1., 0., 0., 1.], Some(&[0., 0.])).unwrap();
    let sum = combine_pointwise(&[1., 10.], &[&point, &vector]).unwrap();
    assert_eq!(sum.points().unwrap(), [11., 2., 3., 14.]);
    let only = combine_pointwise(&[2.], &[&vector]).unwrap();
    assert_eq!(only.homogeneous(), [2., 0., 0., 0., 2., 0.]);
}

#[test]
fn splines_combine_on_their_common_knots() {
    let mut random = Random::new(7);
    let a: Shape<Rational> = spline(&mut random, Weights::Positive, &[1]).into();
    let b: Shape<Rational> = spline(&mut random, Weights::Positive, &[1, 2, 2]).into();
    let c: Shape<Rational> = spline(&mut random, Weights::One, &[2]).into();
    let p: Shape<Rational> = Form::point(&[ratio(1, 3), ratio(5, 1)]).unwrap().into();
    let shapes = [a, p, b, c];
    let k = [ratio(1, 2), ratio(2, 1), ratio(-1, 3), ratio(1, 5)];
    let points = combine_shapes(&k, &shapes, true).unwrap();
    let poles = combine_shapes(&k, &shapes, false).unwrap();
    for t in 0..=12 {
        let t = [ratio(t, 4)];
        let mut expected = vec![ratio(0, 1); 2];
        let mut homogeneous = vec![ratio(0, 1); 3];
        for (k, shape) in k.iter().zip(&shapes) {
            let (point, pole) = match shape {
                Shape::Form(point) => (point.points().unwrap(), point.homogeneous().to_vec()),
                Shape::Spline(spline) => {
                    (spline.at(&t).unwrap(), spline.homogeneous_at(&t).unwrap())
                }
            };
            Rational::add_multiple(&mut expected, k, &point);
            Rational::add_multiple(&mut homogeneous, k, &pole);
        }
        assert_eq!(at(&points, &t), expected);
        assert_eq!(poles.clone().into_spline().homogeneous_at(&t).unwrap(), homogeneous);
    }
}

#[test]
fn a_product_multiplies_values() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let axes = random.size(0, 2);
        let [u, v] = [random.orders(axes, 3), random.orders(axes, 4)];
        let kinds = [Weights::One, Weights::Positive];
        let [first, second] = [0, 1].map(|_| kinds[random.size(0, 1)]);
        let ambient = random.size(1, 3);
        let [f, g]: [Exact; 2] = [random.form(&u, 1, first), random.form(&v, ambient, second)];
        let t = random.parameters(axes);
        let factor = &f.at(&t).unwrap()[0];
        let expected: Vec<Rational> = g.at(&t).unwrap().iter().map(|x| factor * x).collect();
        assert_eq!(multiply(&f, &g).unwrap().at(&t).unwrap(), expected);
        assert_eq!(multiply(&g, &f).unwrap().at(&t).unwrap(), expected);
    }
}

#[test]
fn symmetric_surfaces_of_the_original() {
    for case in cases("symmetric") {
        let [middle, form] =
            ["s1", "s2"].map(|name| Shape::from(net::<Rational>(&case.input[name])));
        let expected: Exact = net(&case.expected);
        assert_eq!(symmetric(&middle, &form, false).unwrap().net(), &expected, "{}", case.id);
    }
}

#[test]
fn a_symmetric_form_lies_across_its_middle() {
    let mut random = Random::new(3);
    let middle: Exact = random.form(&[3, 2], 3, Weights::Positive);
    let form: Exact = random.form(&[2, 2], 3, Weights::Positive);
    let other = symmetric(&middle.clone().into(), &form.clone().into(), true).unwrap();
    for _ in 0..8 {
        let t = random.parameters(2);
        let (m, p) = (middle.at(&t).unwrap(), form.at(&t).unwrap());
        let expected: Vec<Rational> = m.iter().zip(&p).map(|(m, p)| ratio(2, 1) * m - p).collect();
        assert_eq!(other.net().at(&t).unwrap(), expected);
    }
}

#[test]
fn regular_nets_of_the_original() {
    // 1e-14: the original steps by additions, and keeps 15 digits.
    for case in cases("regular_nets") {
        let orders: Vec<usize> =
            numbers(&case.params["orders"]).iter().map(|x| *x as usize).collect();
        let size = numbers(&case.params["size"])[0];
        let computed = regular(&orders, &vec![size; orders.len()], 3).unwrap();
        let expected: Form = net(&case.expected);
        assert_eq!(computed.orders(), expected.orders());
        for (a, b) in computed.homogeneous().iter().zip(expected.homogeneous()) {
            assert!((a - b).abs() <= 1e-14, "{}: {a} for {b}", case.id);
        }
    }
}

#[test]
fn a_regular_net_is_the_identity_up_to_scale() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let axes = random.size(0, 4);
        let orders: Vec<usize> = (0..axes).map(|_| random.size(2, 4)).collect();
        let sizes: Vec<Rational> = (0..axes).map(|_| random.fraction()).collect();
        let ambient = axes + random.size(1, 2);
        let cube = regular(&orders, &sizes, ambient).unwrap();
        let t = random.parameters(axes);
        let mut expected = vec![ratio(0, 1); ambient];
        for k in 0..axes {
            expected[k] = &sizes[k] * (&t[k] - ratio(1, 2));
        }
        assert_eq!(cube.at(&t).unwrap(), expected);
    }
    assert_eq!(regular::<f64>(&[1], &[2.0], 1).unwrap().points().unwrap(), [0.0]);
}

#[test]
fn an_extrusion_adds_path_and_form() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let weights = [Weights::One, Weights::Positive][random.size(0, 1)];
        let ambient = random.size(1, 3);
        let [axes, along] = [0, 1].map(|_| random.size(0, 2));
        let [u, v] = [random.orders(axes, 3), random.orders(along, 3)];
        let form: Exact = random.form(&u, ambient, weights);
        let path: Exact = random.form(&v, ambient, Weights::Positive);
        let all = extrude_along(&form, &path).unwrap();
        let (t, s) = (random.parameters(axes), random.parameters(along));
        let pairs = form.at(&t).unwrap().into_iter().zip(path.at(&s).unwrap());
        let expected: Vec<Rational> = pairs.map(|(x, q)| x + q).collect();
        assert_eq!(all.at(&[s, t].concat()).unwrap(), expected);
    }
}

#[test]
fn an_extrusion_ends_at_the_translated_form() {
    let mut random = Random::new(8);
    let form: Exact = random.form(&[3, 2], 3, Weights::Any);
    let by = [ratio(1, 2), ratio(-3, 1), ratio(0, 1)];
    let prism = extrude(&form, &by).unwrap();
    assert_eq!(pforms_operators::sub(&prism, 0, &ratio(0, 1)).unwrap(), form);
    let end = pforms_operators::sub(&prism, 0, &ratio(1, 1)).unwrap();
    assert_eq!(end, translate(&form, &by).unwrap());
}

#[test]
fn splines_extrude_and_rule_with_their_knots() {
    let mut random = Random::new(9);
    let a = spline(&mut random, Weights::Positive, &[1]);
    let b = spline(&mut random, Weights::Positive, &[2, 2]);
    let point: Exact = Form::point(&[ratio(1, 1), ratio(7, 1)]).unwrap();
    let sum = extrude_shapes(&a.clone().into(), &b.clone().into()).unwrap();
    let strip = ruled_shapes(&a.clone().into(), &b.clone().into()).unwrap();
    let cone = ruled_shapes(&a.clone().into(), &point.clone().into()).unwrap();
    for k in 0..=9 {
        let (s, t) = (ratio(k, 3), ratio(9 - k, 3));
        let (p, q) = (a.at(from_ref(&t)).unwrap(), b.at(from_ref(&s)).unwrap());
        let expected: Vec<Rational> = p.iter().zip(&q).map(|(x, y)| x + y).collect();
        assert_eq!(at(&sum, &[s, t.clone()]), expected);
        let (p, q) =
            (a.homogeneous_at(from_ref(&t)).unwrap(), b.homogeneous_at(from_ref(&t)).unwrap());
        let half = ratio(1, 2);
        let middle: Vec<Rational> = p.iter().zip(&q).map(|(x, y)| (x + y) * &half).collect();
        let strip = strip.clone().into_spline();
        assert_eq!(strip.homogeneous_at(&[half, t.clone()]).unwrap(), middle);
        assert_eq!(at(&cone, &[ratio(1, 1), t]), point.points().unwrap());
    }
}

#[test]
fn a_ruled_form_holds_the_segments() {
    let mut random = Random::new(4);
    let a: Exact = random.form(&[3], 3, Weights::Any);
    let b: Exact = random.form(&[2], 3, Weights::Any);
    let surface = ruled(&a, &b).unwrap();
    assert_eq!(surface.orders(), [2, 3]);
    for _ in 0..8 {
        let [s, t]: [Rational; 2] = [random.parameter(), random.parameter()];
        let (p, q) = (a.homogeneous_at(from_ref(&t)).unwrap(), b.homogeneous_at(from_ref(&t)));
        let q = q.unwrap();
        let expected: Vec<Rational> =
            p.iter().zip(&q).map(|(x, y)| (ratio(1, 1) - &s) * x + &s * y).collect();
        assert_eq!(surface.homogeneous_at(&[s, t]).unwrap(), expected);
    }
}

#[test]
fn what_does_not_fit_is_said() {
    let plane: Form = Form::from_points(&[2], 2, &[0., 0., 1., 1.], None).unwrap();
    let space: Form = Form::from_points(&[2], 3, &[0., 0., 0., 1., 1., 1.], None).unwrap();
    let surface = regular(&[2, 2], &[1., 1.], 2).unwrap();
    assert_eq!(family(combine_pointwise(&[1.], &[&plane, &plane])), "Shape");
    assert_eq!(family(combine_pointwise(&[1., f64::NAN], &[&plane, &plane])), "Domain");
    assert_eq!(family(combine_pointwise(&[1., 1.], &[&plane, &space])), "Shape");
    assert_eq!(family(combine_pointwise(&[1., 1.], &[&plane, &surface])), "Shape");
    assert_eq!(family(combine_pointwise::<f64>(&[], &[])), "Shape");
    assert_eq!(family(multiply(&plane, &plane)), "Shape");
    let ramp: Form = Form::from_points(&[2], 1, &[0., 1.], None).unwrap();
    assert_eq!(family(multiply(&ramp, &surface)), "Shape");
    assert_eq!(family(extrude(&plane, &[0., 0., 1.])), "Shape");
    assert_eq!(family(extrude(&plane, &[0., f64::INFINITY])), "Domain");
    assert_eq!(family(extrude_along(&plane, &space)), "Shape");
    assert_eq!(family(ruled(&plane, &space)), "Shape");
    assert_eq!(family(ruled(&plane, &surface)), "Shape");
    assert_eq!(family(regular(&[2, 2], &[1.], 3)), "Shape");
    assert_eq!(family(regular(&[2, 2], &[1., 1.], 1)), "Shape");
    assert_eq!(family(regular(&[2], &[f64::NAN], 1)), "Domain");
    assert_eq!(family(regular(&[2, 0], &[1., 1.], 2)), "Shape");
    assert_eq!(family(regular::<f64>(&[1 << 12; 3], &[1.; 3], 3)), "Limit");
}
