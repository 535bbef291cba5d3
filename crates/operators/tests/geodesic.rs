//! Geodesics against closed forms.
#![allow(clippy::unwrap_used)]

use std::f64::consts::PI;

use pforms_kernel::Form;
use pforms_operators::{
    Ending, Geodesic, GeodesicOptions, Heading, Minimality, Part, Shape, Spline, SplineProjector,
    cone, cylinder, geodesic, geodesic_between, geodesics, scale, sphere, torus,
};
use serde_json::Value;

fn truth(id: &str) -> Value {
    let text = include_str!("../../../cases/truth/closed-forms.json");
    let all: Value = serde_json::from_str(text).unwrap();
    all["items"].as_array().unwrap().iter().find(|item| item["id"] == id).unwrap().clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().or_else(|| value.as_str().and_then(|text| text.parse().ok())).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn to(accuracy: f64) -> GeodesicOptions {
    GeodesicOptions { accuracy, ..GeodesicOptions::default() }
}

fn whole(shape: Shape) -> Spline {
    shape.into_spline()
}

/// The splines agree with each other and with the surface.
fn check_drawing(surface: &Spline, line: &Geodesic) {
    for k in 0..=100 {
        let at = line.length * f64::from(k) / 100.0;
        let place = line.parameters.at(&[at]).unwrap();
        let on = surface.at(&place).unwrap();
        let point = line.spline.at(&[at]).unwrap();
        assert!(distance(&on, &point) <= line.error + 1e-14, "{at}: {:e}", distance(&on, &point));
    }
}

/// y up: the axes of our torus are x, z, y of the truth.
#[test]
fn torus_of_the_truth() {
    for id in ["torus-geodesic-R3-r1-30deg-L5", "torus-geodesic-R3-r1-70deg-L8"] {
        let item = truth(id);
        for part in [Part::Whole, Part::Pieces] {
            let surface = whole(torus(&3.0, &1.0, part).unwrap());
            let angle = number(&item["input"]["alpha_deg"]).to_radians();
            // The start (4, 0, 0) is at the beginning of a turn and of the tube.
            let start = surface.window(0).unwrap().0;
            let start = [start, surface.window(1).unwrap().0];
            let point = surface.at(&start).unwrap();
            assert!(distance(&point, &[4.0, 0.0, 0.0]) < 1e-14, "{point:?}");
            let heading = Heading::Vector(vec![0.0, angle.sin(), angle.cos()]);
            for accuracy in [1e-6, 1e-9, 1e-12] {
                let length = number(&item["input"]["length"]);
                let line =
                    geodesic(surface.clone(), start, &heading, length, &to(accuracy)).unwrap();
                let end = numbers(&item["values"]["end"]);
                let end = [end[0], end[2], end[1]];
                let miss = distance(&line.point, &end);
                assert!(
                    miss <= line.error && line.error <= accuracy * 4.0,
                    "{miss:e} {:e}",
                    line.error
                );
                assert_eq!(line.ending, Ending::Length);
                check_drawing(&surface, &line);
            }
        }
    }
}

#[test]
fn great_circles_across_the_poles() {
    for part in [Part::Whole, Part::Pieces] {
        let surface = whole(sphere(&2.0, part).unwrap());
        for start in [[0.3, 0.2], [0.9, 0.7], [1.0, 0.3]] {
            let windows = [0, 1].map(|axis| surface.window(axis).unwrap());
            let start = [0, 1].map(|k| windows[k].0 + (windows[k].1 - windows[k].0) * start[k]);
            let point = surface.at(&start).unwrap();
            // Straight over the pole, past it by very little, and aslant.
            let up = [0.0, 1.0, 0.0];
            let round = [-point[2], 0.0, point[0]];
            for lean in [0.0, 1e-12, 1e-3, 1.0] {
                let heading: Vec<f64> = up.iter().zip(&round).map(|(a, b)| a + lean * b).collect();
                let vector =
                    if point[0].hypot(point[2]) < 1e-9 { vec![1.0, 0.0, 0.7] } else { heading };
                let inner = dot(&vector, &point) / 4.0;
                let tangent: Vec<f64> =
                    vector.iter().zip(&point).map(|(a, b)| a - inner * b).collect();
                let size = dot(&tangent, &tangent).sqrt();
                let length = 13.0;
                let heading = Heading::Vector(vector);
                let line = geodesic(surface.clone(), start, &heading, length, &to(1e-10)).unwrap();
                assert_eq!(line.ending, Ending::Length);
                let (s, c) = (length / 2.0_f64).sin_cos();
                let end: Vec<f64> =
                    point.iter().zip(&tangent).map(|(p, t)| c * p + 2.0 * s * t / size).collect();
                let miss = distance(&line.point, &end);
                assert!(miss <= line.error + 1e-15, "{start:?} {lean} {miss:e} {:e}", line.error);
                assert!((line.conjugate.unwrap() - 2.0 * PI).abs() < 1e-2);
                check_drawing(&surface, &line);
            }
        }
    }
}

#[test]
fn clairaut_on_a_torus_for_long() {
    let surface = whole(torus(&3.0, &1.0, Part::Pieces).unwrap());
    let heading = Heading::Vector(vec![0.0, 1.0, 1.0]);
    let start = [surface.window(0).unwrap().0, surface.window(1).unwrap().0];
    let line = geodesic(surface, start, &heading, 200.0, &to(1e-10)).unwrap();
    let constant =
        |point: &[f64], direction: &[f64]| point[0] * direction[2] - point[2] * direction[0];
    assert!((constant(&line.point, &line.direction) - 8.0_f64.sqrt()).abs() < 1e-10);
}

#[test]
fn flat_spheroids() {
    for thin in [0.01, 1e-4] {
        let surface =
            scale(&sphere(&1.0, Part::Pieces).unwrap(), &[1.0, thin, 1.0], &[0.0; 3]).unwrap();
        let surface = whole(surface);
        let windows = [0, 1].map(|axis| surface.window(axis).unwrap());
        let start = [0, 1].map(|k| windows[k].0 + (windows[k].1 - windows[k].0) * [0.6, 0.1][k]);
        let point = surface.at(&start).unwrap();
        let heading = Heading::Vector(vec![1.0, 0.1, 0.3]);
        let line = geodesic(surface.clone(), start, &heading, 6.0, &to(1e-8)).unwrap();
        let finer = geodesic(surface.clone(), start, &heading, 6.0, &to(1e-10)).unwrap();
        assert!(distance(&finer.point, &line.point) <= line.error + finer.error);
        // Clairaut: the distance from the axis times the direction around it.
        let begin = line.spline.derivative(&[1]).unwrap().at(&[0.0]).unwrap();
        let clairaut = |p: &[f64], d: &[f64]| p[0] * d[2] - p[2] * d[0];
        let drift = clairaut(&point, &begin) - clairaut(&line.point, &line.direction);
        assert!(drift.abs() < 1e-10, "{thin}: {drift:e}");
    }
}

#[test]
fn flat_torus_in_four_dimensions() {
    let item = truth("flat-torus-in-4-space-1-1");
    let weights = numbers(&item["form"]["weights"]);
    let points: Vec<f64> =
        item["form"]["points"].as_array().unwrap().iter().flat_map(numbers).collect();
    let surface: Form = Form::from_points(&[3, 3], 4, &points, Some(&weights)).unwrap();
    let heading = Heading::Vector(vec![0.0, 1.0, 0.0, 1.0]);
    let line = geodesic(surface.clone(), [0.0, 0.0], &heading, 10.0, &to(1e-11)).unwrap();
    assert_eq!(line.ending, Ending::Border);
    assert!((line.length - number(&item["values"]["corner_geodesic"])).abs() <= line.error);
}

#[test]
fn cones_and_cylinders() {
    let surface = whole(cylinder(&2.0, &3.0, Part::Whole).unwrap());
    let line =
        geodesic(surface.clone(), [0.0, 0.0], &Heading::Vector(vec![0., 1., 3.]), 50.0, &to(1e-10))
            .unwrap();
    assert_eq!(line.ending, Ending::Border);
    assert!((line.length - 3.0 * 10.0_f64.sqrt()).abs() <= line.error);
    check_drawing(&surface, &line);
    let surface = whole(cone(&1.0, &2.0, &0.0, Part::Pieces).unwrap());
    let line =
        geodesic(surface.clone(), [0.0, 0.6], &Heading::Parameters([1., 0.]), 50.0, &to(1e-10))
            .unwrap();
    assert_eq!(line.ending, Ending::Collapsed);
    assert!((line.length - 5.0_f64.sqrt()).abs() <= line.error);
}

#[test]
fn many_at_once_as_one_by_one() {
    let surfaces = [
        whole(torus(&3.0, &1.0, Part::Pieces).unwrap()),
        whole(torus(&3.0, &1.0, Part::Quarter).unwrap()),
        whole(sphere(&1.0, Part::Pieces).unwrap()),
        whole(cone(&1.0, &2.0, &0.0, Part::Whole).unwrap()),
    ];
    for surface in surfaces {
        let windows = [0, 1].map(|axis| surface.window(axis).unwrap());
        let mut starts = Vec::new();
        let mut headings = Vec::new();
        let mut lengths = Vec::new();
        for k in 0..40 {
            let share = [f64::from(k * 7 % 40) / 40.0, f64::from(k * 11 % 40) / 40.0];
            starts.push(
                [0, 1].map(|k| {
                    windows[k].0 + (windows[k].1 - windows[k].0) * (0.05 + 0.9 * share[k])
                }),
            );
            headings.push(Heading::Angle(f64::from(k) * 0.37));
            lengths.push(f64::from(k % 9));
        }
        let ends = geodesics(surface.clone(), &starts, &headings, &lengths, &to(1e-9)).unwrap();
        for k in 0..40 {
            let point = &ends.points[3 * k..3 * k + 3];
            if lengths[k] == 0.0 {
                assert!(distance(point, &surface.at(&starts[k]).unwrap()) < 1e-14);
                continue;
            }
            let line =
                geodesic(surface.clone(), starts[k], &headings[k], lengths[k], &to(1e-11)).unwrap();
            let miss = distance(point, &line.point);
            assert!(miss <= ends.errors[k] + line.error, "{k} {miss:e} {:e}", ends.errors[k]);
            assert_eq!(line.ending, ends.endings[k], "{k}");
            assert!((line.length - ends.lengths[k]).abs() <= ends.errors[k] + line.error);
        }
    }
}

/// Parameters of a point of a whole surface, by projection.
fn parameters(surface: &Spline, point: &[f64]) -> [f64; 2] {
    let found = SplineProjector::new(surface, 1e-12).unwrap().project(point).unwrap();
    assert!(found.distances[0] < 1e-12);
    [found.parameters[0], found.parameters[1]]
}

#[test]
fn shortest_ways_of_the_truth() {
    let item = truth("cylinder-geodesic-2-120-3");
    let surface = whole(cylinder(&2.0, &3.0, Part::Pieces).unwrap());
    let p = parameters(&surface, &[2.0, 0.0, 0.0]);
    let q = numbers(&item["input"]["p2"]);
    let q = parameters(&surface, &[q[0], q[2], q[1]]);
    let lines = geodesic_between(surface, p, q, None, &to(1e-10)).unwrap();
    let first = &lines[0];
    assert!((first.geodesic.length - number(&item["values"]["length"])).abs() < 1e-9);
    assert_eq!(first.minimality, Minimality::Local);

    let item = truth("sphere-geodesic-1-10-20-50-110");
    let surface = whole(sphere(&1.0, Part::Pieces).unwrap());
    let [p, q] = ["p1", "p2"].map(|name| {
        let point = numbers(&item["input"][name]);
        parameters(&surface, &[point[0], point[2], point[1]])
    });
    let lines = geodesic_between(surface, p, q, None, &to(1e-10)).unwrap();
    assert!((lines[0].geodesic.length - number(&item["values"]["length"])).abs() < 1e-9);
    assert!(lines[0].gap <= 1e-10);

    let item = truth("cone-geodesic-30-2-3-90");
    let (sine, cosine) = (0.5, 0.75_f64.sqrt());
    // The apex up: half-angle 30°, points 2 and 3 from it.
    let surface = whole(cone(&(4.0 * sine), &(4.0 * cosine), &0.0, Part::Pieces).unwrap());
    let place =
        |slant: f64, x: f64, z: f64| [slant * sine * x, (4.0 - slant) * cosine, slant * sine * z];
    let p = parameters(&surface, &place(2.0, 1.0, 0.0));
    let q = parameters(&surface, &place(3.0, 0.0, 1.0));
    let lines = geodesic_between(surface, p, q, None, &to(1e-10)).unwrap();
    assert!((lines[0].geodesic.length - number(&item["values"]["length"])).abs() < 1e-9);
}

#[test]
fn opposite_points_and_the_same() {
    let surface = whole(sphere(&1.0, Part::Pieces).unwrap());
    let p = parameters(&surface, &[1.0, 0.0, 0.0]);
    let q = parameters(&surface, &[-1.0, 0.0, 0.0]);
    let lines = geodesic_between(surface.clone(), p, q, Some(4.0), &to(1e-9)).unwrap();
    assert!((lines[0].geodesic.length - PI).abs() < 1e-8);
    assert_eq!(lines[0].minimality, Minimality::Family);
    assert!(geodesic_between(surface, p, p, None, &to(1e-9)).unwrap().is_empty());
}
