//! Surfaces that meet: lengths known in closed form, every way to touch, and what must not be said.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use pforms_kernel::{Form, Result};
use pforms_operators::{
    Branch, ContactKind, Intersections, Part, Poles, Shape, cone, cylinder, intersect, scale,
    sphere, stretch, torus, translate,
};

const ACCURACY: f64 = 1e-10;

/// Lengths are off by no more than a share of this size: far more than the error of the curves.
const LENGTH: f64 = 1e-9;

fn meet(a: &Shape, b: &Shape) -> Result<Intersections> {
    let found = intersect(a, b, ACCURACY)?;
    found.branches.iter().for_each(|branch| check(branch, a, b));
    Ok(found)
}

/// All three curves are the same points, and have unit speed nearly.
fn check(branch: &Branch, a: &Shape, b: &Shape) {
    let breaks = &branch.curve.breaks()[0];
    let at = |shape: &Shape, x: &[f64]| match shape {
        Shape::Form(form) => form.at(x).unwrap(),
        Shape::Spline(spline) => spline.at(x).unwrap(),
    };
    let apart =
        |p: &[f64], q: &[f64]| p.iter().zip(q).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt();
    let rounding =
        1e-14 * branch.curve.net().points().unwrap().iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for ends in breaks.windows(2) {
        for i in 0..=6 {
            let t = ends[0] + (ends[1] - ends[0]) * (0.001 + 0.998 * f64::from(i) / 6.0);
            let p = branch.curve.at(&[t]).unwrap();
            let (u, v) = (branch.first.at(&[t]).unwrap(), branch.second.at(&[t]).unwrap());
            let off = apart(&p, &at(a, &u)).max(apart(&p, &at(b, &v)));
            assert!(off <= branch.error + rounding, "{off:e} above {:e} at {t}", branch.error);
        }
    }
}

fn length(branch: &Branch) -> f64 {
    branch.curve.breaks()[0].last().copied().unwrap()
}

fn total(found: &Intersections) -> f64 {
    found.branches.iter().map(length).sum()
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= LENGTH * expected, "{found}, not {expected}");
}

/// The facet `origin ± u ± v`.
fn plane(origin: [f64; 3], u: [f64; 3], v: [f64; 3]) -> Shape {
    let corner = |a: f64, b: f64| (0..3).map(move |k| origin[k] + a * u[k] + b * v[k]);
    let points: Vec<f64> = [(-1., -1.), (-1., 1.), (1., -1.), (1., 1.)]
        .iter()
        .flat_map(|(a, b)| corner(*a, *b))
        .collect();
    Form::from_points(&[2, 2], 3, &points, None).unwrap().into()
}

fn moved(shape: &Shape, by: [f64; 3]) -> Shape {
    translate(shape, &by).unwrap()
}

/// Coordinates moved on by one place.
fn turned(shape: &Shape) -> Shape {
    let net = shape.net();
    let poles = net.homogeneous().chunks_exact(4).flat_map(|p| [p[2], p[0], p[1], p[3]]).collect();
    shape.with_net(Form::from_homogeneous(net.orders(), 3, poles).unwrap()).unwrap()
}

/// A closed form of `cases/truth`.
fn truth(id: &str, value: &str) -> f64 {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/truth/closed-forms.json");
    let all: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let items = all["items"].as_array().unwrap();
    let item = items.iter().find(|item| item["id"] == id).unwrap();
    item["values"][value].as_str().unwrap().parse().unwrap()
}

const PARTS: [Part; 2] = [Part::Whole, Part::Pieces];

fn pipe(radius: f64, part: Part) -> Shape {
    moved(&cylinder(&radius, &6.0, part).unwrap(), [0.0, -3.0, 0.0])
}

#[test]
fn two_spheres_meet_in_a_circle() {
    let expected = truth("two-spheres-1-1-1", "circle_length");
    for part in PARTS {
        let ball = sphere(&1.0, part).unwrap();
        for by in [
            [1., 0., 0.],
            [0., 1., 0.],
            [0., 0., 1.],
            [0.3, 0.4, 0.75_f64.sqrt()],
            [0.2, 0.0, 0.96_f64.sqrt()],
        ] {
            let found = meet(&ball, &moved(&ball, by)).unwrap();
            assert_eq!(found.branches.len(), 1, "{part:?} {by:?}");
            assert!(found.branches[0].closed && !found.branches[0].tangent);
            assert!(found.contacts.is_empty());
            near(total(&found), expected);
        }
    }
}

#[test]
fn a_cylinder_through_the_centre_of_a_sphere() {
    let expected = truth("coaxial-sphere-cylinder-2-1", "total_length");
    for part in PARTS {
        let found = meet(&sphere(&2.0, part).unwrap(), &pipe(1.0, part)).unwrap();
        assert!(found.complete);
        assert_eq!(found.branches.len(), 2);
        assert!(found.branches.iter().all(|branch| branch.closed));
        near(total(&found), expected);
    }
}

#[test]
fn equal_cylinders_cross_in_two_ellipses_with_two_nodes() {
    let expected = truth("two-cylinders-1", "ellipse_perimeter");
    for part in PARTS {
        let upright = pipe(1.0, part);
        let found = meet(&upright, &turned(&upright)).unwrap();
        assert_eq!(found.branches.len(), 2);
        found.branches.iter().for_each(|branch| {
            assert!(branch.closed && !branch.tangent);
            near(length(branch), expected);
        });
        assert_eq!(found.contacts.len(), 2);
        assert!(found.contacts.iter().all(|c| c.kind == ContactKind::Tangent && c.order == 2));
    }
}

#[test]
fn nearly_equal_cylinders_cross_in_two_loops() {
    for more in [1e-3, 1e-6] {
        let found =
            meet(&pipe(1.0, Part::Pieces), &turned(&pipe(1.0 + more, Part::Pieces))).unwrap();
        assert!(found.complete && found.contacts.is_empty());
        assert_eq!(found.branches.len(), 2);
        assert!(found.branches.iter().all(|branch| branch.closed));
    }
}

#[test]
fn villarceau_circles_cross_in_two_nodes() {
    let expected = truth("villarceau-2-1", "total_length");
    for part in PARTS {
        let ring = torus(&2.0, &1.0, part).unwrap();
        let (sine, cosine) = (0.5, 0.75_f64.sqrt());
        let tilted = plane([0.; 3], [4. * cosine, 4. * sine, 0.], [0., 0., 4.]);
        let found = meet(&ring, &tilted).unwrap();
        assert_eq!((found.branches.len(), found.contacts.len()), (2, 2));
        found.branches.iter().for_each(|branch| near(length(branch), expected / 2.0));
    }
}

#[test]
fn a_plane_that_touches_a_torus_inside_gives_a_lemniscate() {
    let expected = truth("torus-tangent-plane-2-1", "whole_length");
    for part in PARTS {
        let ring = torus(&2.0, &1.0, part).unwrap();
        let found = meet(&ring, &plane([1., 0., 0.], [0., 4., 0.], [0., 0., 4.])).unwrap();
        assert_eq!(found.contacts.len(), 1);
        let node = &found.contacts[0].point;
        assert!(node.iter().zip([1.0, 0.0, 0.0]).all(|(x, y)| (x - y).abs() < 1e-9));
        near(total(&found), expected);
    }
}

#[test]
fn a_torus_that_lies_on_a_plane_touches_it_along_a_circle() {
    let ring = torus(&2.0, &1.0, Part::Whole).unwrap();
    let found = meet(&ring, &plane([0., 1., 0.], [4., 0., 0.], [0., 0., 4.])).unwrap();
    assert_eq!(found.branches.len(), 1);
    assert!(found.branches[0].closed && found.branches[0].tangent);
    assert!(!found.complete, "touching along a curve is seen, not proved");
    near(total(&found), 4.0 * std::f64::consts::PI);
}

#[test]
fn a_cylinder_that_touches_a_plane_or_a_cylinder_along_a_line() {
    let upright = pipe(1.0, Part::Pieces);
    let found = meet(&upright, &plane([1., 0., 0.], [0., 2., 0.], [0., 0., 2.])).unwrap();
    assert!(found.branches.len() == 1 && found.branches[0].tangent && !found.complete);
    near(total(&found), 4.0);
    let found = meet(&upright, &moved(&upright, [2.0, 0.5, 0.0])).unwrap();
    assert!(found.branches.len() == 1 && found.branches[0].tangent && !found.complete);
    near(total(&found), 5.5);
}

#[test]
fn a_sphere_and_a_plane_at_every_distance() {
    let ball = sphere(&1.0, Part::Whole).unwrap();
    let wall = |x: f64| plane([x, 0., 0.], [0., 2., 0.1], [0., 0., 2.]);
    let found = meet(&ball, &wall(1.0)).unwrap();
    assert_eq!((found.contacts.len(), found.branches.len()), (1, 0));
    assert_eq!(found.contacts[0].kind, ContactKind::Tangent);
    for gap in [1e-1_f64, 1e-3, 1e-6, 1e-9] {
        let outside = meet(&ball, &wall(1.0 + gap)).unwrap();
        assert!(outside.complete && outside.branches.is_empty() && outside.contacts.is_empty());
        let inside = meet(&ball, &wall(1.0 - gap)).unwrap();
        assert_eq!(inside.branches.len(), 1, "{gap}");
        let radius = (gap * (2.0 - gap)).sqrt();
        // The plane is given to one rounding, which moves a small circle by more.
        let off = 1e-15 / gap;
        let expected = 2.0 * std::f64::consts::PI * radius;
        assert!((total(&inside) - expected).abs() <= 2e-9 + off * expected, "{gap}");
    }
}

#[test]
fn through_the_poles_of_a_sphere_and_the_apex_of_a_cone() {
    for part in PARTS {
        let ball = sphere(&1.0, part).unwrap();
        let found = meet(&ball, &plane([0.; 3], [0., 2., 0.], [2., 0., 0.3])).unwrap();
        assert_eq!(found.branches.len(), 1);
        assert!(found.branches[0].closed && found.contacts.is_empty());
        near(total(&found), 2.0 * std::f64::consts::PI);
    }
    let ball = sphere(&1.0, Part::Whole).unwrap();
    let found = meet(&ball, &plane([0., 1., 0.], [2., 0., 0.], [0., 0., 2.])).unwrap();
    assert_eq!((found.contacts.len(), found.branches.len()), (1, 0), "touching at the pole");
    let hat = cone(&1.0, &2.0, &0.0, Part::Pieces).unwrap();
    let found = meet(&hat, &plane([0.; 3], [0., 3., 0.], [2., 0., 0.3])).unwrap();
    near(total(&found), 2.0 * 5.0_f64.sqrt());
    let found = meet(&hat, &plane([0., 2., 0.], [2., 0., 0.], [0., 0., 2.])).unwrap();
    assert_eq!((found.contacts.len(), found.branches.len()), (1, 0), "touching at the apex");
}

/// A bicubic graph over the square from 0 to 3.
fn graph(seed: u64, tilt: f64) -> Form {
    let mut state = seed;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / f64::from(1_u32 << 31) - 0.5
    };
    let points: Vec<f64> = (0..16)
        .flat_map(|k| {
            let (x, y) = (f64::from(k / 4), f64::from(k % 4));
            [x, y, 0.8 * next() + tilt * (x - 1.5)]
        })
        .collect();
    Form::from_points(&[4, 4], 3, &points, None).unwrap()
}

#[test]
fn graphs_cross_where_their_difference_changes_sign() {
    for seed in 0..20 {
        let (a, b) = (graph(seed, 0.0), graph(seed + 100, 0.4));
        let found = meet(&a.clone().into(), &b.clone().into()).unwrap();
        assert!(found.complete, "{seed}");
        // Along every border and many lines the crossings of the curves are the changes of sign.
        let height = |form: &Form, u: f64, v: f64| form.at(&[u, v]).unwrap()[2];
        for i in 0..=10 {
            let u = f64::from(i) / 10.0;
            let sides: Vec<bool> = (0..=400)
                .map(|j| f64::from(j) / 400.0)
                .map(|v| height(&a, u, v) > height(&b, u, v))
                .collect();
            let expected = sides.windows(2).filter(|pair| pair[0] != pair[1]).count();
            let passed: usize = found.branches.iter().map(|branch| passes(branch, u)).sum();
            assert_eq!(passed, expected, "seed {seed}, u = {u}");
        }
    }
}

/// How often the first parameter of a branch passes a value, its ends counted.
fn passes(branch: &Branch, value: f64) -> usize {
    let breaks = &branch.first.breaks()[0];
    let last = breaks[breaks.len() - 1];
    let count = 40 * breaks.len();
    let sides: Vec<bool> = (0..=count)
        .map(|i| branch.first.at(&[last * i as f64 / count as f64]).unwrap()[0])
        .map(|u| if value < 0.5 { u > value + 1e-12 } else { u < value - 1e-12 })
        .collect();
    sides.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

#[test]
fn size_and_place_do_not_matter() {
    let (a, b): (Shape, Shape) = (graph(5, 0.0).into(), graph(8, 0.5).into());
    let expected = total(&meet(&a, &b).unwrap());
    for factor in [1e-150, 1e-8, 1e8, 1e150] {
        let scaled = |shape: &Shape| scale(shape, &[factor; 3], &[0.0; 3]).unwrap();
        near(total(&meet(&scaled(&a), &scaled(&b)).unwrap()) / factor, expected);
    }
    let far = |shape: &Shape| moved(shape, [1e6, -1e6, 1e6]);
    near(total(&meet(&far(&a), &far(&b)).unwrap()), expected);
}

#[test]
fn surfaces_that_coincide_are_told_at_once() {
    let form = graph(5, 0.2);
    let whole: Shape = form.clone().into();
    let found = meet(&whole, &whole).unwrap();
    assert!(!found.complete && found.overlaps.len() == 1 && found.branches.is_empty());
    assert_eq!(found.overlaps[0].first, [vec![0.0, 0.0], vec![1.0, 1.0]]);
    let part = stretch(&form, &[0.3, 0.2], &[0.9, 0.8]).unwrap();
    let found = meet(&whole, &part.into()).unwrap();
    assert!(!found.complete && found.overlaps.len() == 1 && found.branches.is_empty());
    let [lower, upper] = &found.overlaps[0].first;
    assert!(lower[0] <= 0.3 && lower[1] <= 0.2 && upper[0] >= 0.9 && upper[1] >= 0.8);
    let facet = |x: f64, y: f64| plane([x, y, 0.], [1., 0., 0.], [0., 1., 0.]);
    let found = meet(&facet(0., 0.), &facet(0.7, 0.6)).unwrap();
    assert!(!found.complete && found.overlaps.len() == 1);
    let found = meet(&facet(0., 0.), &facet(2.0, 0.0)).unwrap();
    assert!(!found.complete, "coplanar facets that share an edge");
}

#[test]
fn a_border_in_the_other_surface_is_a_branch() {
    let facet = plane([0.; 3], [1., 0., 0.], [0., 1., 0.]);
    for (shift, expected) in [(0.0, 2.0), (0.5, 1.5)] {
        let found = meet(&facet, &plane([1., shift, 1.], [0., 0., 1.], [0., 1., 0.])).unwrap();
        assert_eq!(found.branches.len(), 1);
        assert!(!found.complete);
        near(total(&found), expected);
    }
}

#[test]
fn a_corner_on_a_surface_is_a_contact() {
    let facet = plane([0.; 3], [1., 0., 0.], [0., 1., 0.]);
    let found = meet(&facet, &plane([0., 0., 1.], [0.5, 0., 0.5], [0., 0.5, 0.5])).unwrap();
    assert_eq!((found.contacts.len(), found.branches.len()), (1, 0));
    assert_eq!(found.contacts[0].kind, ContactKind::Crossing);
    let corner = [-0.5, -0.5, 0.0];
    assert!(found.contacts[0].point.iter().zip(corner).all(|(x, y)| (x - y).abs() < 1e-12));
}

#[test]
fn what_is_no_surface_is_refused() {
    let line: Shape =
        Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 0., 0., 1., 2., 3., 1., 2., 3.], None)
            .unwrap()
            .into();
    let facet = plane([0.; 3], [1., 0., 0.], [0., 1., 0.]);
    let error = intersect(&facet, &line, ACCURACY).unwrap_err();
    assert_eq!(error.family(), "Degenerate");
    let flat: Shape = Form::from_points(&[1, 3], 3, &[0.5; 9], None).unwrap().into();
    assert_eq!(intersect(&flat, &facet, ACCURACY).unwrap_err().family(), "Degenerate");
}
