//! Geodesics where they are hard: poles, apexes, corners, kinks, folds, odd weights, odd scales.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use std::f64::consts::{FRAC_PI_2, PI};

use pforms_kernel::{Error, Form};
use pforms_operators::{
    Ending, Geodesic, GeodesicOptions, Heading, Minimality, Part, Shape, Spline, cone, geodesic,
    geodesic_between, scale, shortest_geodesic, sphere, torus, translate,
};

fn to(accuracy: f64) -> GeodesicOptions {
    GeodesicOptions { accuracy, ..GeodesicOptions::default() }
}

fn whole(shape: Shape) -> Spline {
    shape.into_spline()
}

fn along(u: f64, v: f64) -> Heading {
    Heading::Parameters([u, v])
}

fn vector(x: f64, y: f64, z: f64) -> Heading {
    Heading::Vector(vec![x, y, z])
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}

fn run(surface: &Spline, start: [f64; 2], heading: &Heading, length: f64) -> Geodesic {
    geodesic(surface.clone(), start, heading, length, &to(1e-10)).unwrap()
}

fn flat(points: &[f64], orders: [usize; 2]) -> Spline {
    let form: Form =
        Form::from_points(&orders, points.len() / orders[0] / orders[1], points, None).unwrap();
    form.into()
}

#[test]
fn starts_at_a_pole() {
    for part in [Part::Whole, Part::Pieces] {
        let surface = whole(sphere(&1.0, part).unwrap());
        let pole = [surface.window(0).unwrap().1, 0.3];
        for [x, z] in [[1.0, 0.0], [0.6, -0.8], [-1.0, 1e-9]] {
            // What points out of the surface does not count.
            let line = run(&surface, pole, &vector(x, 0.4, z), 2.0);
            let size = f64::hypot(x, z);
            let truth = [2.0_f64.sin() * x / size, 2.0_f64.cos(), 2.0_f64.sin() * z / size];
            assert!(distance(&line.point, &truth) <= line.error);
        }
        // Along the edge that is the pole there is no direction, nor along the normal.
        for heading in [along(0.0, 1.0), vector(0.0, 1.0, 0.0), Heading::Angle(0.5)] {
            let found = geodesic(surface.clone(), pole, &heading, 1.0, &to(1e-10));
            assert!(matches!(found, Err(Error::Degenerate { .. })), "{heading:?}");
        }
    }
}

#[test]
fn the_pole_of_an_eighth() {
    let surface = whole(sphere(&1.0, Part::Octant).unwrap());
    let pole = [1.0, 0.3];
    for [x, z] in [[1.0, 1.0], [1.0, 0.0], [0.0, 1.0]] {
        let line = run(&surface, pole, &vector(x, 0.0, z), 9.0);
        assert_eq!(line.ending, Ending::Border);
        assert!((line.length - FRAC_PI_2).abs() <= line.error);
    }
    let out = geodesic(surface.clone(), pole, &vector(-1.0, 0.0, -1.0), 2.0, &to(1e-10));
    assert!(matches!(out, Err(Error::Degenerate { .. })));
    // Beside the edge by little: never endless, and on the edge as long as nobody can tell.
    for aside in [1e-14, 1e-12, 1e-11, 1e-10, 1e-9, 1e-7, 1e-4] {
        match geodesic(surface.clone(), pole, &vector(-aside, 0.0, 1.0), 2.0, &to(1e-10)) {
            Ok(line) => assert!(line.length <= FRAC_PI_2 + 1e-9, "{aside}"),
            Err(error) => assert!(matches!(error, Error::Degenerate { .. }), "{error}"),
        }
    }
}

/// A cone laid flat is a sector: a line that passes the apex at a distance goes on straight there.
#[test]
fn beside_the_apex_of_a_cone() {
    let surface = whole(cone(&1.0, &2.0, &0.0, Part::Whole).unwrap());
    let line = run(&surface, [0.2, 0.2], &along(1.0, 0.0), 9.0);
    assert_eq!(line.ending, Ending::Collapsed);
    assert!((line.length - 0.8 * 5.0_f64.sqrt()).abs() < 1e-9);
    for aside in [1e-3, 1e-5, 1e-6, 1e-7, 1e-9, 1e-12] {
        let line = geodesic(surface.clone(), [0.2, 0.2], &along(1.0, aside), 3.0, &to(1e-9));
        match line {
            // Through the apex for all one can tell, or past it and down again.
            Ok(line) if line.ending == Ending::Collapsed => {
                assert!(aside <= 1e-7 && distance(&line.point, &[0.0, 2.0, 0.0]) <= line.error);
            }
            Ok(line) => {
                assert!(line.ending == Ending::Length && line.point[1] < 1.2, "{aside}");
            }
            Err(error) => assert!(matches!(error, Error::Accuracy { .. }), "{aside}: {error}"),
        }
    }
    // Rulings leave the apex; other directions say nothing there.
    let line = run(&surface, [1.0, 0.2], &along(-1.0, 0.0), 9.0);
    assert!((line.length - 5.0_f64.sqrt()).abs() <= line.error);
    let lost = geodesic(surface.clone(), [1.0, 0.2], &vector(1.0, -1.0, 0.0), 9.0, &to(1e-10));
    assert!(matches!(lost, Err(Error::Degenerate { .. })));
    let up = shortest_geodesic(surface.clone(), [0.2, 0.2], [1.0, 0.7], None, &to(1e-10)).unwrap();
    assert_eq!(up.unwrap().minimality, Minimality::Proved);
    let down = geodesic_between(surface, [1.0, 0.2], [0.2, 0.7], None, &to(1e-10));
    assert!(matches!(down, Err(Error::Degenerate { .. })));
}

#[test]
fn through_corners_and_along_borders() {
    let square = flat(&[0., 0., 0., 1., 1., 0., 1., 1.], [2, 2]);
    for heading in [along(1.0, 1.0), vector2(1.0, 1.0 + 1e-15)] {
        let line = run(&square, [0.2, 0.2], &heading, 9.0);
        assert!(line.ending == Ending::Border && distance(&line.end, &[1.0, 1.0]) < 1e-12);
    }
    for (start, end) in [([0.0, 0.0], [1.0, 0.0]), ([0.0, 1.0], [1.0, 1.0])] {
        let line = run(&square, start, &vector2(1.0, 0.0), 9.0);
        assert!(line.ending == Ending::Border && distance(&line.end, &end) < 1e-12);
    }
    let out = geodesic(square, [1.0, 1.0], &vector2(1.0, 1.0), 9.0, &to(1e-10));
    assert!(matches!(out, Err(Error::Degenerate { .. })));
}

fn vector2(x: f64, y: f64) -> Heading {
    Heading::Vector(vec![x, y])
}

/// Two planes that meet at a right angle: over the ridge as on a sheet laid flat.
#[test]
fn over_a_kink() {
    let left: Form =
        Form::from_points(&[2, 2], 3, &[-1., 0., 0., -1., 1., 0., 0., 0., 0., 0., 1., 0.], None)
            .unwrap();
    let right: Form =
        Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 1., 0., 0., 0., -2., 0., 1., -2.], None)
            .unwrap();
    let roof = Spline::end_to_end(&[left, right], 0, &[0.0, 1.0, 2.0]).unwrap();
    let line = run(&roof, [0.5, 0.1], &vector(1.0, 0.5, 0.0), 1.0);
    let speed = 1.0 / 1.25_f64.sqrt();
    let truth = [0.0, 0.1 + 0.5 * speed, -(speed - 0.5)];
    assert!(distance(&line.point, &truth) <= line.error);
    assert!((line.crease - FRAC_PI_2).abs() < 1e-12);
    let way = shortest_geodesic(roof, [0.5, 0.1], [1.25, 0.9], None, &to(1e-10)).unwrap().unwrap();
    assert!((way.geodesic.length - f64::hypot(1.0, 0.8)).abs() < 1e-9);
}

#[test]
fn at_any_scale() {
    for exponent in [-300, -150, -100, 0, 100, 150, 300] {
        let size = 10.0_f64.powi(exponent);
        let ball = sphere(&1.0, Part::Pieces).unwrap();
        let surface = whole(scale(&ball, &[size; 3], &[0.0; 3]).unwrap());
        let line = run(&surface, [0.5, 0.25], &vector(0.0, 1.0, 0.0), 1.5 * size);
        assert!((line.point[1] / size - 1.5_f64.sin()).abs() < 1e-10, "{exponent}");
        assert!(line.error < 1e-9 * size);
        let [p, q] = [[0.4, 0.3], [0.5, 0.3]];
        let chord = distance(
            &surface.at(&p).unwrap().iter().map(|x| x / size).collect::<Vec<_>>(),
            &surface.at(&q).unwrap().iter().map(|x| x / size).collect::<Vec<_>>(),
        );
        let way = shortest_geodesic(surface, p, q, None, &to(1e-10)).unwrap().unwrap();
        assert!((way.geodesic.length / size - 2.0 * (0.5 * chord).asin()).abs() < 1e-9);
    }
    // A length that moves nothing.
    let surface = whole(sphere(&1.0, Part::Whole).unwrap());
    for length in [1e-300, 1e-17, 1e-9] {
        let line = run(&surface, [0.3, 0.2], &along(1.0, 1.0), length);
        assert!(line.ending == Ending::Length && line.length == length);
    }
    // Far away the rounding of coordinates is part of the error.
    let far = translate(&sphere(&1.0, Part::Whole).unwrap(), &[1e8, 0.0, 0.0]).unwrap();
    let line = run(&whole(far), [0.3, 0.2], &along(1.0, 1.0), 1.0);
    assert!(line.error > 1e-8 && line.error < 1e-7);
}

/// The rest of a circle has the same poles with a negative weight between: a cylinder over it has helices.
#[test]
fn weights_below_nothing_and_nothing() {
    let weight = -0.5_f64.sqrt();
    let points = [1., 0., 0., 1., 1., 0., 0., 1., 0., 1., 0., 1., 1., 1., 1., 0., 1., 1.];
    let weights = [1.0, weight, 1.0, 1.0, weight, 1.0];
    let surface: Form = Form::from_points(&[2, 3], 3, &points, Some(&weights)).unwrap();
    let line = run(&surface.clone().into(), [0.0, 0.0], &vector(0.0, -1.0, 0.1), 9.0);
    assert_eq!(line.ending, Ending::Border);
    assert!((line.length - 1.5 * PI * 1.01_f64.sqrt()).abs() <= line.error);
    assert!((line.point[2] - 0.15 * PI).abs() <= line.error);
    // A pole without weight: half an ellipse, whose ends are the other two.
    let weights = [1.0, 0.0, 1.0, 1.0, 0.0, 1.0];
    let poles = [1., 0., 0., 1., 0., 1., 0., 0., -1., 0., 0., 1.];
    let raised = [1., 0., 1., 1., 0., 1., 0., 0., -1., 0., 1., 1.];
    let poles: Vec<f64> = poles.iter().chain(&raised).copied().collect();
    let half: Form = Form::from_homogeneous(&[2, 3], 3, poles).unwrap();
    assert_eq!(half.weights(), weights);
    let line = run(&half.into(), [0.5, 0.0], &along(0.0, 1.0), 9.0);
    assert!(line.ending == Ending::Border && distance(&line.point, &[-1.0, 0.0, 0.5]) < 1e-9);
}

/// Parameters turn back on a sheet: it ends there, soon, and says so.
#[test]
fn folds_and_cusps() {
    let sheet =
        flat(&[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 0., 0., 0., 0., 0., 1., 0.], [3, 2]);
    let line = run(&sheet, [0.2, 0.2], &along(1.0, 0.3), 9.0);
    assert_eq!(line.ending, Ending::Singular);
    assert!(distance(&line.point[..1], &[0.5]) < 1e-6);
    let cusp = [
        0., 0., 0., 0., 0., 1., 1., 1., 0., 1., 1., 1., 0., 1., 0., 0., 1., 1., 1., 0., 0., 1., 0.,
        1.,
    ];
    let line = run(&flat(&cusp, [4, 2]), [0.1, 0.2], &along(1.0, 0.5), 9.0);
    assert_eq!(line.ending, Ending::Singular);
    assert!(distance(&line.point[..2], &[0.5, 0.75]) < 1e-6);
    // A plane that is folded over a curve.
    let fold = [0., 0., 0., 1., 1., 1., 1., 2., 0., 1., 0., 2., 1., 0., 1., 1.];
    match geodesic(flat(&fold, [4, 2]), [0.1, 0.2], &along(1.0, 0.0), 9.0, &to(1e-10)) {
        Ok(line) => assert!(matches!(line.ending, Ending::Singular | Ending::Border)),
        Err(error) => assert!(matches!(error, Error::Accuracy { .. }), "{error}"),
    }
}

#[test]
fn more_than_rounding_allows() {
    let surface = whole(sphere(&1.0, Part::Whole).unwrap());
    let line = geodesic(surface, [0.3, 0.2], &along(1.0, 1.0), 1.0, &to(1e-15));
    assert!(matches!(line, Err(Error::Accuracy { .. })));
    let long =
        whole(scale(&sphere(&1.0, Part::Pieces).unwrap(), &[100., 1., 1.], &[0.; 3]).unwrap());
    for start in [[0.712_890_262_566_568, 0.847_624_380_254_534], [0.39, 0.798]] {
        let heading = vector(0.421_131, -1.054_841, -1.272_078);
        let line = geodesic(long.clone(), start, &heading, 100.0, &to(1e-9)).unwrap();
        assert!(line.ending == Ending::Length && line.error <= 4e-7 && line.steps < 20_000);
    }
}

fn between(
    surface: &Spline,
    p: [f64; 2],
    q: [f64; 2],
    longest: Option<f64>,
) -> Vec<(f64, Minimality)> {
    let ways = geodesic_between(surface.clone(), p, q, longest, &to(1e-10)).unwrap();
    assert!(ways.iter().all(|way| way.gap <= 4e-10));
    let first = shortest_geodesic(surface.clone(), p, q, longest, &to(1e-10)).unwrap();
    let lengths =
        (first.map(|way| way.geodesic.length), ways.first().map(|way| way.geodesic.length));
    match lengths {
        (Some(one), Some(other)) => assert!((one - other).abs() < 1e-9, "{one} {other}"),
        (one, other) => assert_eq!(one, other),
    }
    ways.into_iter().map(|way| (way.geodesic.length, way.minimality)).collect()
}

#[test]
fn between_points_near_far_and_opposite() {
    let surface = whole(sphere(&1.0, Part::Pieces).unwrap());
    assert!(between(&surface, [0.4, 0.0], [0.4, 1.0], None).is_empty());
    assert!(between(&surface, [1.0, 0.2], [1.0, 0.9], None).is_empty());
    let point = |at: [f64; 2]| surface.at(&at).unwrap();
    for by in [1e-4, 1e-9, 1e-12] {
        let [p, q] = [[0.4, 0.8], [0.4, 0.8 + by]];
        let angle = 2.0 * (0.5 * distance(&point(p), &point(q))).asin();
        assert!((between(&surface, p, q, None)[0].0 - angle).abs() < 1e-10);
    }
    // Over the seam, and the long way round.
    let [p, q] = [[0.4, 0.98], [0.45, 0.03]];
    let angle = 2.0 * (0.5 * distance(&point(p), &point(q))).asin();
    let ways = between(&surface, p, q, Some(7.0));
    assert!((ways[0].0 - angle).abs() < 1e-9 && ways[0].1 == Minimality::Local);
    assert!((ways[1].0 - (2.0 * PI - angle)).abs() < 1e-9 && ways[1].1 == Minimality::Not);
    // From pole to pole, and from one point to its opposite: as many as there are directions.
    for (p, q) in [([1.0, 0.3], [0.0, 0.8]), ([0.5, 0.25], [0.5, 0.75])] {
        let ways = between(&surface, p, q, Some(4.0));
        assert!((ways[0].0 - PI).abs() < 1e-9 && ways[0].1 == Minimality::Family);
    }
    // Almost opposite: the short way is the shortest, the long one is not.
    let ways = between(&surface, [0.5, 0.25], [0.5, 0.75 + 1e-4], Some(4.0));
    assert_eq!(
        ways.iter().map(|way| way.1).collect::<Vec<_>>(),
        [Minimality::Local, Minimality::Not]
    );
}

#[test]
fn between_points_of_a_torus_over_its_seams() {
    let surface = whole(torus(&3.0, &1.0, Part::Whole).unwrap());
    let ways = between(&surface, [0.01, 0.02], [0.98, 0.97], Some(9.0));
    assert!(ways[0].0 < 1.0 && ways[0].1 == Minimality::Local);
    let way = shortest_geodesic(surface, [0.01, 0.02], [0.98, 0.97], None, &to(1e-10));
    assert!((way.unwrap().unwrap().geodesic.length - ways[0].0).abs() < 1e-9);
}

/// A quarter of a ring: past the hole there is no straight way.
#[test]
fn points_that_no_line_joins() {
    let root = 0.5_f64.sqrt();
    let points = [1., 0., 2., 0., 1., 1., 2., 2., 0., 1., 0., 2.];
    let weights = [1.0, 1.0, root, root, 1.0, 1.0];
    let ring: Spline = Form::from_points(&[3, 2], 2, &points, Some(&weights)).unwrap().into();
    let lost = geodesic_between(ring.clone(), [0.0, 0.05], [1.0, 0.05], None, &to(1e-10));
    assert!(matches!(lost, Err(Error::Degenerate { .. })));
    let ways = between(&ring, [0.0, 1.0], [1.0, 1.0], None);
    assert!((ways[0].0 - 8.0_f64.sqrt()).abs() < 1e-9 && ways[0].1 == Minimality::Proved);
}
