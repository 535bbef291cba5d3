//! Geodesics of the book's series of measurements, and those whose closed form is on file.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::Form;
use pforms_operators::{
    Ending, GeodesicOptions, Heading, Minimality, Part, Spline, SplineProjector, cone, geodesic,
    geodesic_between, torus,
};
use pforms_testkit::{Case, Truth, cases, net, numbers, truth};

fn to(accuracy: f64) -> GeodesicOptions {
    GeodesicOptions { accuracy, ..GeodesicOptions::default() }
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}

/// A derivative of a surface, as a vector.
fn slope(surface: &Form, steps: [usize; 2], at: &[f64]) -> Vec<f64> {
    Spline::from(surface.clone()).derivative(&steps).unwrap().at(at).unwrap()
}

/// The exact points of the reference, as far as the line stays on the window.
fn check_book(case: &Case) -> usize {
    let surface: Form = net(&case.input);
    let start = numbers(&case.params["start"]);
    let angle = case.params["angle_degrees"].as_f64().unwrap().to_radians();
    let dt = case.params["dt"].as_f64().unwrap();
    let points: Vec<Vec<f64>> = case.expected.as_array().unwrap().iter().map(numbers).collect();
    assert!(distance(&points[0], &surface.at(&start).unwrap()) < 1e-12, "{}", case.id);
    // u′ = cos A, v′ = sin A·|f_u|/|f_v|: the speed, which it keeps.
    let (u, v) = (slope(&surface, [1, 0], &start), slope(&surface, [0, 1], &start));
    let size = |x: &[f64]| distance(x, &vec![0.0; x.len()]);
    let ratio = size(&u) / size(&v);
    let velocity: Vec<f64> =
        u.iter().zip(&v).map(|(u, v)| angle.cos() * u + angle.sin() * ratio * v).collect();
    let speed = size(&velocity);
    let length = speed * dt * (points.len() - 1) as f64;
    let start = [start[0], start[1]];
    let line = geodesic(surface, start, &Heading::Angle(angle), length, &to(1e-10)).unwrap();
    let mut compared = 0;
    for (i, point) in points.iter().enumerate() {
        let at = speed * dt * i as f64;
        if at <= line.length {
            let found = line.spline.at(&[at.min(line.length)]).unwrap();
            // The nets have 15 digits, and the points too.
            assert!(distance(&found, point) < 1e-8, "{} at {i}: {found:?} {point:?}", case.id);
            compared += 1;
        } else {
            assert_eq!(line.ending, Ending::Border, "{}", case.id);
        }
    }
    compared
}

#[test]
fn the_book_s_series() {
    let compared: Vec<usize> = cases("geodesic").iter().map(check_book).collect();
    assert_eq!(compared.len(), 7);
    assert!(compared.iter().all(|count| *count > 20), "{compared:?}");
}

#[test]
fn axes_of_enneper_s_surfaces() {
    for id in ["enneper-order1-1", "enneper-order2-1/2"] {
        let item = truth(id);
        let length = item.value("axis_length");
        for (start, end, heading) in
            [([0.0, 0.5], [1.0, 0.5], [1.0, 0.0]), ([0.5, 0.0], [0.5, 1.0], [0.0, 1.0])]
        {
            let heading = Heading::Parameters(heading);
            let line = geodesic(item.form(), start, &heading, 9.0, &to(1e-11)).unwrap();
            assert_eq!(line.ending, Ending::Border, "{id}");
            assert!((line.length - length).abs() <= line.error, "{id} {:e}", line.error);
            assert!(distance(&line.end, &end) < 1e-10);
            let ways = geodesic_between(item.form(), start, end, None, &to(1e-10)).unwrap();
            assert!(ways.iter().any(|way| (way.geodesic.length - length).abs() < 1e-9), "{id}");
        }
    }
}

#[test]
fn rulings_of_a_hypar() {
    let item = truth("hypar-1-1-1");
    let surface = item.form();
    for k in 0..=10 {
        let t = f64::from(k) / 10.0;
        for (start, end) in [([0.0, t], [1.0, t]), ([t, 1.0], [t, 0.0])] {
            let [p, q] = [start, end].map(|at| surface.at(&at).unwrap());
            let heading = Heading::Parameters([end[0] - start[0], end[1] - start[1]]);
            let line = geodesic(surface.clone(), start, &heading, 9.0, &to(1e-12)).unwrap();
            assert_eq!(line.ending, Ending::Border);
            assert!((line.length - distance(&p, &q)).abs() <= line.error);
            assert!(distance(&line.point, &q) <= line.error && line.error < 1e-11);
            // Straight in space: no way is shorter.
            let way = geodesic_between(surface.clone(), start, end, None, &to(1e-10)).unwrap();
            assert_eq!(way[0].minimality, Minimality::Proved, "{start:?} {end:?}");
            if k == 0 || k == 10 {
                let length = item.value("diagonal_ruling_length");
                assert!((way[0].geodesic.length - length).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn from_corner_to_corner_of_a_flat_torus() {
    let item = truth("flat-torus-in-4-space-1-1");
    for (p, q) in [([0.0, 0.0], [1.0, 1.0]), ([1.0, 0.0], [0.0, 1.0])] {
        let way = geodesic_between(item.form(), p, q, None, &to(1e-10)).unwrap();
        assert!((way[0].geodesic.length - item.value("corner_geodesic")).abs() < 1e-9);
        assert_eq!(way[0].minimality, Minimality::Local);
    }
}

/// Parameters of a point, by projection.
fn parameters(surface: &Spline, point: &[f64]) -> [f64; 2] {
    let found = SplineProjector::new(surface, 1e-12).unwrap().project(point).unwrap();
    assert!(found.distances[0] < 1e-12);
    [found.parameters[0], found.parameters[1]]
}

#[test]
fn how_near_a_geodesic_of_a_cone_comes_to_its_apex() {
    let item = truth("cone-geodesic-30-2-3-90");
    let (sine, cosine) = (0.5, 0.75_f64.sqrt());
    let surface = cone(&(4.0 * sine), &(4.0 * cosine), &0.0, Part::Pieces).unwrap().into_spline();
    let place =
        |slant: f64, x: f64, z: f64| [slant * sine * x, (4.0 - slant) * cosine, slant * sine * z];
    let p = parameters(&surface, &place(2.0, 1.0, 0.0));
    let q = parameters(&surface, &place(3.0, 0.0, 1.0));
    let ways = geodesic_between(surface.clone(), q, p, None, &to(1e-11)).unwrap();
    let way = &ways[0].geodesic;
    assert!((way.length - item.value("length")).abs() < 1e-9);
    // It comes nearest a little beyond the point that it joins.
    let heading = Heading::Vector(way.spline.derivative(&[1]).unwrap().at(&[0.0]).unwrap());
    let line = geodesic(surface, q, &heading, way.length + 0.5, &to(1e-11)).unwrap().spline;
    let apex = [0.0, 4.0 * cosine, 0.0];
    let nearest = (0..=10_000)
        .map(|k| distance(&line.at(&[way.length + 0.5e-4 * f64::from(k)]).unwrap(), &apex))
        .fold(f64::INFINITY, f64::min);
    // Half of the way between two places, squared.
    assert!((nearest - item.value("closest_approach_to_apex")).abs() < 1e-9);
}

#[test]
fn angles_and_clairaut_s_constant_of_a_torus() {
    for id in ["torus-geodesic-R3-r1-30deg-L5", "torus-geodesic-R3-r1-70deg-L8"] {
        let item = truth(id);
        let number = |name: &str| item.input[name].as_f64().unwrap();
        let angle = number("alpha_deg").to_radians();
        let surface = torus(&3.0, &1.0, Part::Pieces).unwrap().into_spline();
        let start = [0, 1].map(|axis| surface.window(axis).unwrap().0);
        // Our axis is y.
        let heading = Heading::Vector(vec![0.0, angle.sin(), angle.cos()]);
        let line = geodesic(surface, start, &heading, number("length"), &to(1e-12)).unwrap();
        check_torus(&item, &line.point, &line.direction);
    }
}

fn check_torus(item: &Truth, point: &[f64], direction: &[f64]) {
    let (x, y, z) = (point[0], point[2], point[1]);
    let (u, v) = (y.atan2(x), z.atan2(x.hypot(y) - 3.0));
    let same = |a: f64, b: f64| {
        let turn = (a - b).rem_euclid(std::f64::consts::TAU);
        turn.min(std::f64::consts::TAU - turn) < 1e-11
    };
    assert!(same(u, item.value("end_u")) && same(v, item.value("end_v")), "{}", item.id);
    let clairaut = x * direction[2] - y * direction[0];
    assert!((clairaut - item.value("clairaut")).abs() < 1e-11, "{}", item.id);
    let speed = distance(direction, &[0.0; 3]);
    assert!((speed - item.value("speed_check")).abs() < 1e-14);
}
