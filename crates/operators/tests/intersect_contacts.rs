//! Contacts of known order at known places, made by construction: the second curve is the first one plus
//! `(t − a)ᵏ` times a direction that is never along it. Rounding of the poles blurs them.
#![allow(clippy::unwrap_used)]

use pforms_kernel::Form;
use pforms_operators::{ContactKind, Intersections, Poles, Shape, Spline, intersect};
use pforms_testkit::Random;

const ACCURACY: f64 = 1e-14;

fn met(a: &Form, b: &Form, accuracy: f64) -> Intersections {
    let found = intersect(&a.clone().into(), &b.clone().into(), accuracy).unwrap();
    assert!(found.complete, "{found:#?}");
    found
}

fn between(random: &mut Random, from: f64, to: f64) -> f64 {
    from + random.unit() * (to - from)
}

/// The Bernstein coefficients of `(t − a)ᵏ` in a degree: those of the polar form, whose arguments are `i`
/// ones among zeros.
fn power(a: f64, k: usize, degree: usize) -> Vec<f64> {
    let binomial =
        |n: usize, r: usize| -> f64 { (0..r).map(|i| (n - i) as f64 / (i + 1) as f64).product() };
    // Of k arguments drawn from i ones and the rest zeros: j ones, in so many ways.
    let pole = |i: usize| -> f64 {
        (0..=k.min(i))
            .filter(|j| k - j <= degree - i)
            .map(|j| {
                let ways = binomial(i, j) * binomial(degree - i, k - j) / binomial(degree, k);
                ways * (1.0 - a).powi(j as i32) * (-a).powi((k - j) as i32)
            })
            .sum()
    };
    (0..=degree).map(pole).collect()
}

/// Two curves that have a contact of order `k` at `a` and nothing else: graphs over the same
/// abscissa, turned by an angle.
fn pair(
    numbers: &mut Random,
    degree: usize,
    k: usize,
    a: f64,
    rational: bool,
    dimension: usize,
) -> [Form; 2] {
    let weights: Vec<f64> =
        (0..=degree).map(|_| if rational { between(numbers, 0.5, 2.0) } else { 1.0 }).collect();
    let steps: Vec<f64> = (0..=degree).map(|_| between(numbers, 0.3, 1.0)).collect();
    let total: f64 = steps[1..].iter().sum();
    let (sine, cosine) = between(numbers, 0.0, 6.0).sin_cos();
    let up = between(numbers, 0.5, 2.0);
    let bump = power(a, k, degree);
    let mut points = [Vec::new(), Vec::new()];
    for i in 0..=degree {
        let x = steps[1..=i].iter().sum::<f64>() / total;
        let y = between(numbers, -0.5, 0.5);
        let z = between(numbers, -0.5, 0.5);
        for (list, y) in points.iter_mut().zip([y, y + up * bump[i] / weights[i]]) {
            list.extend([cosine * x - sine * y, sine * x + cosine * y]);
            if dimension == 3 {
                list.push(z + 0.25 * x);
            }
        }
    }
    let weights = rational.then_some(&weights[..]);
    points.map(|list| Form::from_points(&[degree + 1], dimension, &list, weights).unwrap())
}

fn check(numbers: &mut Random, degree: usize, k: usize, a: f64, rational: bool, dimension: usize) {
    let [first, second] = pair(numbers, degree, k, a, rational, dimension);
    let found = met(&first, &second, ACCURACY);
    let name = format!("degree {degree}, order {k} at {a}, {dimension}D, rational: {rational}");
    assert_eq!((found.contacts.len(), found.overlaps.len()), (1, 0), "{name}: {found:#?}");
    let contact = &found.contacts[0];
    assert_eq!(contact.order, k, "{name}: {contact:?}");
    for t in [contact.first[0], contact.second[0]] {
        assert!((t - a).abs() <= contact.error + 1e-15, "{name}: {contact:?}");
        // Roots are blurred by the k-th root of a rounding, their mean by some roundings.
        assert!((t - a).abs() <= 1e-9, "{name}: {contact:?}");
    }
}

#[test]
fn orders_one_to_seven_at_any_place() {
    let mut numbers = Random::new(1);
    for k in 1..=7_usize {
        for degree in [k.max(3), k.max(3) + 2] {
            let a = between(&mut numbers, 0.1, 0.9);
            check(&mut numbers, degree, k, a, false, 2);
        }
    }
}

#[test]
fn at_ends() {
    let mut numbers = Random::new(2);
    for k in 1..=5_usize {
        for a in [0.0, 1.0] {
            check(&mut numbers, k.max(3) + 1, k, a, false, 2);
        }
    }
}

#[test]
fn of_rational_curves() {
    let mut numbers = Random::new(3);
    for k in 1..=5_usize {
        let a = between(&mut numbers, 0.1, 0.9);
        check(&mut numbers, k.max(3) + 1, k, a, true, 2);
    }
}

#[test]
fn of_high_degree() {
    let mut numbers = Random::new(4);
    for (degree, k) in [(11, 3), (12, 5)] {
        let a = between(&mut numbers, 0.1, 0.9);
        check(&mut numbers, degree, k, a, false, 2);
    }
}

#[test]
fn in_space() {
    let mut numbers = Random::new(5);
    for k in 1..=5_usize {
        let a = between(&mut numbers, 0.1, 0.9);
        check(&mut numbers, k.max(3), k, a, false, 3);
    }
}

#[test]
fn in_space_proved() {
    // (t, t², t³) and the same with t⁴ added to the last: poles are whole numbers over 4.
    let cubic = [0., 0., 0., 3., 0., 0., 6., 2., 0., 9., 6., 3., 12., 12., 12.];
    let mut other = cubic;
    other[14] += 4.0;
    let form = |points: &[f64]| Form::from_points(&[5], 3, points, None).unwrap();
    let found = met(&form(&cubic), &form(&other), 0.0);
    assert_eq!(found.contacts.len(), 1, "{found:#?}");
    let contact = &found.contacts[0];
    assert_eq!((contact.first[0], contact.second[0], contact.order), (0.0, 0.0, 4), "{contact:?}");
    assert!(contact.proved);
}

#[test]
fn three_crossings_of_nearly_coincident_curves() {
    // In the plane and in space; the difference is gap·(t − 1/4)(t − 1/2)(t − 3/4).
    let a = [[0.0, 0.0, 0.5], [1.0, 2.0, -0.5], [2.0, -1.0, 0.25], [3.0, 1.0, 0.75]];
    let roots = [-3.0 / 32.0, 13.0 / 96.0, -13.0 / 96.0, 3.0 / 32.0];
    for dimension in [2, 3] {
        for gap in [1e-3, 1e-6, 1e-9, 1e-12] {
            let curve = |gap: f64| {
                let pole = |i: usize| [a[i][0], a[i][1] + gap * roots[i], a[i][2]];
                let points: Vec<f64> = (0..4).flat_map(|i| pole(i)[..dimension].to_vec()).collect();
                Form::from_points(&[4], dimension, &points, None).unwrap()
            };
            let found = met(&curve(0.0), &curve(gap), ACCURACY);
            let name = format!("{gap} in {dimension}D");
            assert_eq!(found.contacts.len(), 3, "{name}: {found:#?}");
            for (contact, expected) in found.contacts.iter().zip([0.25, 0.5, 0.75]) {
                assert_eq!(contact.kind, ContactKind::Crossing, "{name}: {contact:?}");
                // Rounding of ordinates near 1 against a slope of gap/16.
                let bound = 1e-14 / gap + 1e-12;
                assert!((contact.first[0] - expected).abs() < bound, "{name}: {contact:?}");
            }
        }
    }
}

/// The unit circle once around from (1, 0), in four arcs.
fn circle() -> Shape {
    let half = 0.5_f64.sqrt();
    let at = [
        [1., 0.],
        [1., 1.],
        [0., 1.],
        [-1., 1.],
        [-1., 0.],
        [-1., -1.],
        [0., -1.],
        [1., -1.],
        [1., 0.],
    ];
    let weights: Vec<f64> = (0..9).map(|i| if i % 2 == 0 { 1.0 } else { half }).collect();
    let net = Form::from_points(&[9], 2, at.as_flattened(), Some(&weights)).unwrap();
    let knots = vec![vec![0., 0., 0., 1., 1., 2., 2., 3., 3., 4., 4., 4.]];
    Spline::new(net, &[2], knots).unwrap().into()
}

#[test]
fn the_seam_of_a_closed_curve_is_one_place() {
    let segment =
        |points: &[f64]| -> Shape { Form::from_points(&[2], 2, points, None).unwrap().into() };
    for (other, kind) in [
        (segment(&[1., -1., 1., 1.]), ContactKind::Tangent),
        (segment(&[0.5, 0., 1.5, 0.]), ContactKind::Crossing),
    ] {
        let found = intersect(&circle(), &other, ACCURACY).unwrap();
        assert!(found.complete && found.contacts.len() == 1, "{found:#?}");
        let contact = &found.contacts[0];
        assert_eq!((contact.first[0], contact.second[0], contact.kind), (0.0, 0.5, kind));
        let turned = intersect(&other, &circle(), ACCURACY).unwrap();
        assert_eq!(turned.contacts.len(), 1, "{turned:#?}");
        assert_eq!(turned.contacts[0].second[0], 0.0);
    }
    // Two circles that touch at both seams.
    let circle = circle();
    let net = circle.net();
    let moved: Vec<f64> =
        net.homogeneous().chunks(3).flat_map(|p| [2.0 * p[2] - p[0], p[1], p[2]]).collect();
    let net = Form::from_homogeneous(net.orders(), 2, moved).unwrap();
    let other = circle.with_net(net).unwrap();
    let found = intersect(&circle, &other, ACCURACY).unwrap();
    assert!(found.complete && found.contacts.len() == 1, "{found:#?}");
    assert_eq!((found.contacts[0].order, found.contacts[0].kind), (2, ContactKind::Tangent));
    assert_eq!((found.contacts[0].first[0], found.contacts[0].second[0]), (0.0, 0.0));
}

#[test]
fn a_loop_with_itself_and_with_a_part_of_itself() {
    // Poles (0, 0), (3, 3), (−2, 3), (1, 0): symmetric about x = 1/2, it crosses itself where
    // x = 9t − 24t² + 16t³ = 1/2 besides t = 1/2, that is where 16t² − 16t + 1 = 0.
    let whole = Form::from_points(&[4], 2, &[0., 0., 3., 3., -2., 3., 1., 0.], None).unwrap();
    let root = 0.5 - 3.0_f64.sqrt() / 4.0;
    let found = met(&whole, &whole, ACCURACY);
    assert_eq!((found.overlaps.len(), found.contacts.len()), (1, 2), "{found:#?}");
    for (contact, s) in found.contacts.iter().zip([root, 1.0 - root]) {
        assert!((contact.first[0] - s).abs() < 1e-12, "{contact:?}");
        assert!((contact.second[0] - (1.0 - s)).abs() < 1e-12, "{contact:?}");
        assert_eq!(contact.kind, ContactKind::Crossing);
    }
    // The first half of it meets the second half in the node, and where they join.
    let (low, high) = pforms_operators::split(&whole, 0, &0.5).unwrap();
    let found = met(&low, &high, ACCURACY);
    assert_eq!((found.overlaps.len(), found.contacts.len()), (0, 2), "{found:#?}");
    assert!((found.contacts[0].first[0] - 2.0 * root).abs() < 1e-12, "{found:#?}");
    assert_eq!((found.contacts[1].first[0], found.contacts[1].second[0]), (1.0, 0.0));
}

/// What a curve that stops and goes back shares with its carrier is not claimed to be known.
#[test]
fn an_arc_to_and_fro_is_left_open() {
    let line = Form::from_points(&[2], 2, &[0., 0., 1., 0.], None).unwrap();
    let there_and_back = Form::from_points(&[3], 2, &[0.25, 0., 1.25, 0., 0.25, 0.], None).unwrap();
    let twice = Form::from_points(&[4], 2, &[0., 0., 2., 0., -1., 0., 1., 0.], None).unwrap();
    for back in [there_and_back, twice] {
        for (a, b) in [(&line, &back), (&back, &line)] {
            let found = intersect(&a.clone().into(), &b.clone().into(), 1e-10).unwrap();
            assert!(!found.complete && !found.undecided.is_empty());
        }
    }
}
