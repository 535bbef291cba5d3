//! Laws of the intersection of curves, and the hard ones: contacts of high order, curves that nearly
//! coincide, arcs in common, ends, other scales.
#![allow(clippy::unwrap_used)]

use pforms_kernel::{Error, Form};
use pforms_operators::{
    Contact, ContactKind, Intersections, Part, Spline, circle, elevate, intersect,
    intersect_inside, intersect_many, reverse, split, stretch, translate,
};
use pforms_testkit::Random;

fn plane(points: &[[f64; 2]]) -> Form {
    Form::from_points(&[points.len()], 2, points.as_flattened(), None).unwrap()
}

fn space(points: &[[f64; 3]]) -> Form {
    Form::from_points(&[points.len()], 3, points.as_flattened(), None).unwrap()
}

fn met(a: &Form, b: &Form, accuracy: f64) -> Intersections {
    let found = intersect(&a.clone().into(), &b.clone().into(), accuracy).unwrap();
    assert!(found.complete, "{found:#?}");
    found
}

fn places(found: &Intersections) -> Vec<(f64, f64, usize)> {
    found.contacts.iter().map(|c| (c.first[0], c.second[0], c.order)).collect()
}

/// Poles of the graph of a polynomial over `[from, to]`, from its coefficients on powers of `x`.
fn graph(coefficients: &[f64], from: f64, to: f64) -> Form {
    let degree = (coefficients.len() - 1).max(1);
    let binomial =
        |n: usize, k: usize| (0..k).fold(1.0, |b, i| b * (n - i) as f64 / (i + 1) as f64);
    // On t from 0 to 1 with x = from + t (to - from), then from powers to Bernstein.
    let length = to - from;
    let shifted: Vec<f64> = (0..=degree)
        .map(|k| {
            let terms = coefficients.iter().enumerate().skip(k);
            let sum: f64 = terms.map(|(n, c)| c * binomial(n, k) * from.powi((n - k) as i32)).sum();
            sum * length.powi(k as i32)
        })
        .collect();
    let pole = |i: usize| {
        let y: f64 = (0..=i).map(|k| shifted[k] * binomial(i, k) / binomial(degree, k)).sum();
        [from + length * i as f64 / degree as f64, y]
    };
    plane(&(0..=degree).map(pole).collect::<Vec<_>>())
}

#[test]
fn contacts_of_every_order_are_told_once() {
    for order in 2..=8_usize {
        // x^n over [-1, 1] and the axis: at one half, n times.
        let mut power = vec![0.0; order + 1];
        power[order] = 1.0;
        // Degrees whose poles are not exact in binary are scaled to be: 840 has them all.
        let curve = graph(&power, -1.0, 1.0);
        let points: Vec<f64> =
            curve.points().unwrap().iter().map(|x| (x * 840.0).round()).collect();
        let curve = Form::from_points(curve.orders(), 2, &points, None).unwrap();
        let line = plane(&[[-840.0, 0.0], [840.0, 0.0]]);
        for accuracy in [0.0, 1e-14] {
            let found = met(&curve, &line, accuracy);
            assert_eq!(places(&found), [(0.5, 0.5, order)], "{order}: {found:#?}");
            assert_eq!(found.contacts[0].kind, ContactKind::Tangent);
            assert!(found.contacts[0].proved);
        }
    }
}

#[test]
fn two_curves_with_a_contact_of_order_five() {
    // y = x² and y = x² + x⁵ over [-1, 1], the parabola raised to degree 2 only: they meet at 0, five times.
    let parabola = graph(&[0.0, 0.0, 1.0], -1.0, 1.0);
    let points = [-1.0, -0.6, -0.2, 0.2, 0.6, 1.0].map(|x| x * 5.0);
    // Bernstein coefficients of x² and x⁵ over [-1, 1] in degree 5, times 5.
    let square = [5.0, 1.0, -1.0, -1.0, 1.0, 5.0];
    let fifth = [-5.0, 5.0, -5.0, 5.0, -5.0, 5.0];
    let poles: Vec<[f64; 2]> = (0..6).map(|i| [points[i], square[i] + fifth[i]]).collect();
    let scaled: Vec<f64> = parabola.points().unwrap().iter().map(|x| x * 5.0).collect();
    let parabola = Form::from_points(&[3], 2, &scaled, None).unwrap();
    let found = met(&plane(&poles), &parabola, 0.0);
    assert_eq!(places(&found), [(0.5, 0.5, 5)], "{found:#?}");
}

#[test]
fn a_contact_up_to_rounding_is_one_tangent() {
    // The same turned by an angle, so that poles are rounded: exactly there may be 1, 3, 5 crossings.
    let (sine, cosine) = 0.7_f64.sin_cos();
    let turned = |form: &Form| {
        let points = form.points().unwrap();
        let turn = |p: &[f64]| [cosine * p[0] - sine * p[1], sine * p[0] + cosine * p[1]];
        plane(&points.chunks(2).map(turn).collect::<Vec<_>>())
    };
    for order in 2..=5 {
        let mut power = vec![0.0; order + 1];
        power[order] = 1.0;
        let curve = turned(&graph(&power, -1.0, 1.0));
        let line = turned(&plane(&[[-1.0, 0.0], [1.0, 0.0]]));
        let found = met(&curve, &line, 1e-14);
        assert_eq!(found.contacts.len(), 1, "{order}: {found:#?}");
        let contact = &found.contacts[0];
        assert_eq!((contact.kind, contact.order), (ContactKind::Tangent, order), "{contact:?}");
        // Far below the order-th root of a rounding, which moves the exact crossings.
        assert!((contact.first[0] - 0.5).abs() < 1e-6, "{order}: {contact:?}");
    }
}

/// Poles of the graph of a polynomial over `[0, 1]`, moved so that nothing is a round number.
#[test]
fn a_contact_at_a_third_is_blurred_by_rounding() {
    let line = plane(&[[0.0, 0.0], [1.0, 0.0]]);
    for order in 1..=7_usize {
        let mut power = vec![1.0];
        for _ in 0..order {
            let mut next = vec![0.0; power.len() + 1];
            for (i, c) in power.iter().enumerate() {
                next[i] -= 0.3 * c;
                next[i + 1] += c;
            }
            power = next;
        }
        let found = met(&graph(&power, 0.0, 1.0), &line, 1e-14);
        assert_eq!(found.contacts.len(), 1, "{order}: {found:#?}");
        let contact = &found.contacts[0];
        assert_eq!(contact.order, order, "{contact:?}");
        assert!((contact.first[0] - 0.3).abs() < 1e-9, "{order}: {contact:?}");
    }
}

#[test]
fn curves_that_nearly_coincide_cross_exactly_three_times() {
    let a = [[0.0, 0.0], [1.0, 2.0], [2.0, -1.0], [3.0, 1.0]];
    for gap in [1e-3, 1e-6, 1e-9, 1e-11] {
        // The difference of the ordinates is gap·(t − 1/4)(t − 1/2)(t − 3/4), up to rounding.
        let roots = [-3.0 / 32.0, 13.0 / 96.0, -13.0 / 96.0, 3.0 / 32.0];
        let b: Vec<[f64; 2]> = (0..4).map(|i| [a[i][0], a[i][1] + gap * roots[i]]).collect();
        let found = met(&plane(&a), &plane(&b), 1e-14);
        assert_eq!(found.contacts.len(), 3, "{gap}: {found:#?}");
        for (contact, expected) in found.contacts.iter().zip([0.25, 0.5, 0.75]) {
            assert_eq!((contact.kind, contact.proved), (ContactKind::Crossing, true));
            // Rounding of ordinates near 1 against a slope of gap/16.
            assert!((contact.first[0] - expected).abs() < 1e-14 / gap + 1e-12, "{contact:?}");
        }
    }
}

#[test]
fn arcs_in_common() {
    let whole = plane(&[[0.0, 0.0], [1.0, 3.0], [2.5, -2.0], [4.0, 1.0]]);
    let part = stretch(&whole, &[0.25], &[0.75]).unwrap();
    let raised = elevate(&reverse(&whole, 0).unwrap(), &[2]).unwrap();
    let (low, high) = split(&whole, 0, &0.5).unwrap();
    let overlapping = stretch(&whole, &[0.5], &[1.5]).unwrap();
    for (other, first, second) in [
        (&whole, [0.0, 1.0], [0.0, 1.0]),
        (&part, [0.25, 0.75], [0.0, 1.0]),
        (&raised, [0.0, 1.0], [1.0, 0.0]),
        (&overlapping, [0.5, 1.0], [0.0, 0.5]),
        (&stretch(&whole, &[0.6], &[0.1]).unwrap(), [0.1, 0.6], [1.0, 0.0]),
    ] {
        let found = met(&whole, other, 1e-14);
        assert_eq!((found.contacts.len(), found.overlaps.len()), (0, 1), "{found:#?}");
        let overlap = &found.overlaps[0];
        for i in 0..2 {
            assert!((overlap.first[i][0] - first[i]).abs() < 1e-12, "{overlap:?}");
            assert!((overlap.second[i][0] - second[i]).abs() < 1e-12, "{overlap:?}");
        }
    }
    // Halves meet end to end.
    let found = met(&low, &high, 1e-14);
    assert_eq!(found.overlaps.len(), 0);
    assert_eq!(places(&found), [(1.0, 0.0, 0)], "{found:#?}");
}

#[test]
fn arcs_of_one_circle() {
    let arc = |from: f64, to: f64| {
        let quarter = Form::from_points(
            &[3],
            2,
            &[1.0, 0.0, 1.0, 1.0, 0.0, 1.0],
            Some(&[1.0, 0.5_f64.sqrt(), 1.0]),
        );
        stretch(&quarter.unwrap(), &[from], &[to]).unwrap()
    };
    let found = met(&arc(0.0, 1.0), &arc(0.5, 1.25), 1e-14);
    assert_eq!((found.contacts.len(), found.overlaps.len()), (0, 1), "{found:#?}");
    let overlap = &found.overlaps[0];
    assert!((overlap.first[0][0] - 0.5).abs() < 1e-12 && overlap.first[1][0] == 1.0);
    // The same arc with weights 1, 1, 2: another parameter.
    let other: Form =
        Form::from_points(&[3], 2, &[1.0, 0.0, 1.0, 1.0, 0.0, 1.0], Some(&[1.0, 1.0, 2.0]))
            .unwrap();
    let found = met(&arc(0.0, 1.0), &other, 1e-14);
    assert_eq!((found.contacts.len(), found.overlaps.len()), (0, 1), "{found:#?}");
}

#[test]
fn ends_that_meet_are_told_once() {
    let first = plane(&[[0.0, 0.0], [1.0, 2.0], [3.0, 3.0]]);
    for (next, kind) in [
        (plane(&[[3.0, 3.0], [4.0, 1.0], [6.0, 0.0]]), ContactKind::Crossing),
        (plane(&[[3.0, 3.0], [5.0, 4.0], [6.0, 0.0]]), ContactKind::Tangent),
    ] {
        let found = met(&first, &next, 0.0);
        assert_eq!(found.contacts.len(), 1, "{found:#?}");
        let contact = &found.contacts[0];
        assert_eq!((contact.first[0], contact.second[0], contact.kind), (1.0, 0.0, kind));
    }
    // An end on the inside of another, exactly and up to rounding.
    let line = plane(&[[0.0, 0.0], [3.0, 3.0]]);
    assert_eq!(places(&met(&line, &plane(&[[1.0, 1.0], [0.0, 2.0]]), 0.0)), [(1.0 / 3.0, 0.0, 1)]);
    let nearly = plane(&[[1.0, 1.0 + 1e-15], [0.0, 2.0]]);
    assert_eq!(met(&line, &nearly, 0.0).contacts.len(), 0);
    let touch = met(&line, &nearly, 1e-14);
    assert_eq!(touch.contacts.len(), 1);
    assert_eq!(touch.contacts[0].kind, ContactKind::Touch);
}

#[test]
fn a_cusp_and_a_loop() {
    // (t², t³) around its cusp, and the axis through it.
    let cusp = plane(&[[1.0, -1.0], [-1.0 / 3.0, 1.0], [-1.0 / 3.0, -1.0], [1.0, 1.0]]);
    let cusp = plane(
        &cusp
            .points()
            .unwrap()
            .chunks(2)
            .map(|p| [(3.0 * p[0]).round(), 3.0 * p[1]])
            .collect::<Vec<_>>(),
    );
    let found = met(&cusp, &plane(&[[-1.0, -1.0], [1.0, 1.0]]), 0.0);
    // Through the cusp twice; and t² = t³ at t = 1 is outside.
    assert_eq!(places(&found), [(0.5, 0.5, 2)], "{found:#?}");
    // A line through the crossing point of a loop meets it there twice, at two parameters.
    let knot = plane(&[[-2.0, 0.0], [4.0, 4.0], [-4.0, 4.0], [2.0, 0.0]]);
    let found = met(&knot, &plane(&[[0.0, 0.0], [0.0, 8.0]]), 0.0);
    assert_eq!(found.contacts.len(), 3, "{found:#?}");
    assert!(found.contacts.iter().all(|c| c.order == 1));
}

#[test]
fn any_scale() {
    let a = [[0.0, 0.0], [1.0, 3.0], [2.5, -2.0], [4.0, 1.0]];
    let b = [[0.0, 1.0], [1.0, -0.5], [4.0, 0.0]];
    let expected = places(&met(&plane(&a), &plane(&b), 1e-14));
    assert!(!expected.is_empty());
    for exponent in [-150.0, -40.0, 40.0, 150.0] {
        let unit = 2.0_f64.powf(exponent * 10.0_f64.log2().floor());
        let scaled = |points: &[[f64; 2]]| -> Form {
            plane(&points.iter().map(|p| p.map(|x| x * unit)).collect::<Vec<_>>())
        };
        assert_eq!(places(&met(&scaled(&a), &scaled(&b), 1e-14)), expected);
    }
}

#[test]
fn curves_in_space_cross_or_pass() {
    let helix = space(&[[0.0, 0.0, 0.0], [1.0, 2.0, 1.0], [2.0, -2.0, 2.0], [3.0, 1.0, 3.0]]);
    let point = helix.at(&[0.3]).unwrap();
    for (lift, count) in [(0.0, 1), (1e-9, 0), (1e-3, 0)] {
        let line = space(&[
            [point[0] - 1.0, point[1] - 1.0, point[2] - 2.0 + lift],
            [point[0] + 1.0, point[1] + 1.0, point[2] + 2.0 + lift],
        ]);
        let found = met(&helix, &line, 1e-14);
        assert_eq!(found.contacts.len(), count, "{lift}: {found:#?}");
        for contact in &found.contacts {
            assert!((contact.first[0] - 0.3).abs() < 1e-13);
            assert_eq!(contact.kind, ContactKind::Crossing);
        }
    }
    // The same curve in space, and a part of it.
    let part = stretch(&helix, &[0.25], &[1.0]).unwrap();
    let found = met(&helix, &part, 1e-14);
    assert_eq!((found.contacts.len(), found.overlaps.len()), (0, 1), "{found:#?}");
}

#[test]
fn splines_tell_a_joint_once() {
    let zigzag: Spline = Spline::new(
        plane(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [3.0, 1.0]]),
        &[1],
        vec![vec![0.0, 0.0, 1.0, 2.0, 3.0, 3.0]],
    )
    .unwrap();
    let through = plane(&[[2.0, -1.0], [2.0, 1.0]]);
    let found = intersect(&zigzag.clone().into(), &through.into(), 1e-14).unwrap();
    assert_eq!(places(&found), [(2.0, 0.5, 1)], "{found:#?}");
    let along = plane(&[[0.0, 0.0], [0.5, 0.5]]);
    let found = intersect(&zigzag.into(), &along.into(), 1e-14).unwrap();
    assert_eq!((found.contacts.len(), found.overlaps.len()), (0, 1), "{found:#?}");
}

/// Crossings by sampling finely, for random curves whose crossings are clear.
#[test]
fn random_pairs_in_bulk_are_those_of_one_by_one() {
    let mut random = Random::new(36);
    let mut forms = Vec::new();
    for degree in [2, 3, 5] {
        for _ in 0..20 {
            for _ in 0..2 {
                let points: Vec<[f64; 2]> =
                    (0..=degree).map(|_| [2.0 * random.unit(), 2.0 * random.unit()]).collect();
                forms.push(plane(&points));
            }
        }
    }
    let pairs: Vec<(&Form, &Form)> = forms.chunks(2).map(|pair| (&pair[0], &pair[1])).collect();
    let all = intersect_many(&pairs, 1e-14).unwrap();
    assert!(all.complete.iter().all(|x| *x));
    let mut count = 0;
    for (i, (a, b)) in pairs.iter().enumerate() {
        let here = &all.parameters[2 * all.starts[i]..2 * all.starts[i + 1]];
        let alone: Vec<f64> = met(a, b, 1e-14)
            .contacts
            .iter()
            .flat_map(|c: &Contact| [c.first[0], c.second[0]])
            .collect();
        assert_eq!(here.len(), alone.len());
        assert!(here.iter().zip(&alone).all(|(x, y)| (x - y).abs() < 1e-9));
        for place in here.chunks(2) {
            let (p, q) = (a.at(&place[..1]).unwrap(), b.at(&place[1..]).unwrap());
            assert!((p[0] - q[0]).hypot(p[1] - q[1]) < 1e-13);
            count += 1;
        }
        // An odd number of crossings of the closed polygons' curves is not to be had: the chords decide
        // nothing; but what the other order of the pair finds is the same.
        assert_eq!(met(b, a, 1e-14).contacts.len(), here.len() / 2);
    }
    assert!(count > 40, "{count}");
}

#[test]
fn weights() {
    for part in [Part::Whole, Part::Pieces] {
        let one = circle(&1.0, part).unwrap();
        let moved = translate(&one, &[1.0, 0.0, 0.0]).unwrap();
        let found = intersect(&one, &moved, 1e-14).unwrap();
        assert!(found.complete && found.contacts.len() == 2, "{found:#?}");
        for contact in &found.contacts {
            assert!((contact.point[0] - 0.5).abs() < 1e-15, "{contact:?}");
            assert!((contact.point[1].abs() - 0.75_f64.sqrt()).abs() < 1e-15, "{contact:?}");
        }
        let beside = translate(&one, &[2.0, 0.0, 0.0]).unwrap();
        let found = intersect(&one, &beside, 1e-14).unwrap();
        assert!(found.complete && !found.contacts.is_empty(), "{found:#?}");
        for contact in &found.contacts {
            assert!((contact.point[0] - 1.0).abs() < 1e-7, "{found:#?}");
        }
        let same = intersect(&one, &one, 1e-14).unwrap();
        assert!(same.contacts.is_empty() && same.overlaps.len() == 1, "{same:#?}");
    }
    let infinite: Form =
        Form::from_points(&[2], 2, &[0.0, 0.0, 1.0, 0.0], Some(&[1.0, -1.0])).unwrap();
    let line = plane(&[[0.0, 1.0], [1.0, -1.0]]);
    let refused = intersect(&infinite.into(), &line.clone().into(), 1e-14);
    assert!(matches!(refused, Err(Error::Domain(_))));
    // Weights 1, -1/2, 1 stay positive in the window: 3t² − 3t + 1.
    let swung: Form =
        Form::from_points(&[3], 2, &[0.0, 0.0, 1.0, 1.0, 2.0, 0.0], Some(&[1.0, -0.5, 1.0]))
            .unwrap();
    let found = met(&swung, &plane(&[[-4.0, -0.5], [4.0, -0.5]]), 1e-14);
    assert_eq!(found.contacts.len(), 2, "{found:#?}");
}

#[test]
fn nonsense_is_refused() {
    let line = plane(&[[0.0, 1.0], [1.0, -1.0]]);
    let flat = space(&[[0.0, 1.0, 0.0], [1.0, -1.0, 0.0]]);
    let ask = |a: &Form, b: &Form, accuracy: f64| {
        intersect(&a.clone().into(), &b.clone().into(), accuracy).unwrap_err()
    };
    assert!(matches!(ask(&line, &flat, 1e-14), Error::Shape(_)));
    assert!(matches!(ask(&line, &line, f64::NAN), Error::Domain(_)));
    assert!(matches!(ask(&line, &line, -1.0), Error::Domain(_)));
    assert!(matches!(ask(&Form::point(&[1.0, 2.0]).unwrap(), &line, 0.0), Error::Shape(_)));
}

#[test]
fn segments_inside_a_host() {
    // A skew facet: its points are known at the crossing (3/8, 3/8) of two lines.
    let corners = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 0.0];
    let facet: Form = Form::from_points(&[2, 2], 3, &corners, None).unwrap();
    let (rising, falling) =
        (plane(&[[0.0, 0.0], [0.75, 0.75]]), plane(&[[0.0, 0.75], [0.75, 0.0]]));
    let (first, second) = (rising.into(), falling.into());
    let found = intersect_inside(&facet.clone().into(), &first, &second, 0.0).unwrap();
    assert_eq!(places(&found), [(0.5, 0.5, 1)]);
    assert_eq!(found.contacts[0].point, facet.at(&[0.375, 0.375]).unwrap());
    let line = plane(&[[0.0, 0.0], [1.0, 1.0]]);
    let refused = intersect_inside(&line.into(), &first, &second, 0.0);
    assert!(matches!(refused, Err(Error::Shape(_))));
}
