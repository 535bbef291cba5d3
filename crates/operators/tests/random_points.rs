//! Random points: even by length, area and volume, tested on fixed seeds.
#![allow(missing_docs, clippy::unwrap_used)]

use std::f64::consts::PI;

use pforms_kernel::Form;
use pforms_operators::{Part, Shape, Spread, random_points, sphere, torus};

const COUNT: usize = 20_000;

fn cloud(shape: &Shape, seed: u64) -> Vec<f64> {
    random_points(shape, COUNT, Spread::Uniform, seed).unwrap()
}

/// χ² of counts against equal shares. At a significance of 10⁻⁴ it lies below
/// `d + 3.72·√(2d) + 6` for `d` degrees of freedom from 20 to 200 (Wilson and Hilferty).
fn is_even(counts: &[usize]) -> bool {
    let expected = COUNT as f64 / counts.len() as f64;
    let square: f64 = counts.iter().map(|n| (*n as f64 - expected).powi(2) / expected).sum();
    let freedom = counts.len() as f64 - 1.0;
    square < freedom + 3.72 * (2.0 * freedom).sqrt() + 6.0
}

fn counted(places: impl Iterator<Item = usize>, cells: usize) -> Vec<usize> {
    let mut counts = vec![0; cells];
    for place in places {
        counts[place.min(cells - 1)] += 1;
    }
    counts
}

/// The turn about Oy, from 0 to 1.
fn turn(p: &[f64]) -> f64 {
    p[2].atan2(p[0]) / (2.0 * PI) + 0.5
}

#[test]
fn a_sphere_is_covered_evenly_by_area() {
    // Archimedes: equal heights have equal areas. One rational form, collapsed at its poles.
    for part in [Part::Whole, Part::Pieces] {
        let points = cloud(&sphere(&1.0, part).unwrap(), 7);
        for p in points.chunks(3) {
            assert!((p.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-12);
        }
        let cell = |p: &[f64]| {
            let (row, column) = (4.0 * (p[1] + 1.0), 12.0 * turn(p));
            (row as usize).min(7) * 12 + (column as usize).min(11)
        };
        assert!(is_even(&counted(points.chunks(3).map(cell), 96)));
    }
}

#[test]
fn a_torus_is_covered_evenly_by_area() {
    // The area up to the angle v of the tube is proportional to v + sin(v)/2 for radii 2 and 1.
    let points = cloud(&torus(&2.0, &1.0, Part::Whole).unwrap(), 3);
    let cell = |p: &[f64]| {
        let v = p[1].atan2(p[0].hypot(p[2]) - 2.0);
        let share = (v + v.sin() / 2.0) / (2.0 * PI) + 0.5;
        (8.0 * share) as usize * 10 + ((10.0 * turn(p)) as usize).min(9)
    };
    assert!(is_even(&counted(points.chunks(3).map(cell), 80)));
}

#[test]
fn a_curve_is_covered_evenly_by_length() {
    // A straight line at uneven speed: a Kolmogorov–Smirnov distance below 1.95/√n (10⁻³).
    let line = Form::from_points(&[4], 1, &[0., 0., 0., 1.], None).unwrap();
    let mut points = cloud(&line.into(), 11);
    points.sort_by(f64::total_cmp);
    let off = points.iter().enumerate().map(|(k, x)| (x - (k as f64 + 0.5) / COUNT as f64).abs());
    assert!(off.fold(0.0, f64::max) < 1.95 / (COUNT as f64).sqrt());
    // There and back again: covered twice, evenly all the same.
    let back = Form::from_points(&[3], 1, &[0., 1., 0.], None).unwrap();
    let points = cloud(&back.into(), 11);
    assert!(is_even(&counted(points.iter().map(|x| (2.0 * x * 40.0) as usize), 40)));
}

#[test]
fn a_volume_is_covered_evenly() {
    // A square pyramid, a box with a face at a point: z = 1 − c has c³ of the volume above it.
    let mut points = Vec::new();
    for (x, y) in [(0., 0.), (0., 1.), (1., 0.), (1., 1.)] {
        points.extend([x, y, 0., 0.5, 0.5, 1.]);
    }
    let pyramid = Form::from_points(&[2, 2, 2], 3, &points, None).unwrap();
    let points = cloud(&pyramid.into(), 5);
    let cell = |p: &[f64]| (50.0 * (1.0 - p[2]).powi(3)) as usize;
    assert!(is_even(&counted(points.chunks(3).map(cell), 50)));
}

#[test]
fn splines_are_covered_by_length_over_all_pieces() {
    use pforms_operators::Spline;
    let net = Form::from_points(&[3], 1, &[0., 1., 4.], None).unwrap();
    let path = Spline::new(net, &[1], vec![vec![0., 0., 5., 6., 6.]]).unwrap();
    let points = cloud(&path.into(), 2);
    assert!(is_even(&counted(points.iter().map(|x| (10.0 * x) as usize), 40)));
}

#[test]
fn the_middle_is_crowded() {
    let line: Shape = Form::from_points(&[2], 1, &[0., 1.], None).unwrap().into();
    let points = random_points(&line, COUNT, Spread::Gaussian, 1).unwrap();
    let mean = points.iter().sum::<f64>() / COUNT as f64;
    let spread = points.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / COUNT as f64;
    // Cut off at three standard deviations the variance is 0.9733 of 1/36.
    assert!((mean - 0.5).abs() < 4.0 / 6.0 / (COUNT as f64).sqrt());
    assert!((36.0 * spread - 0.9733).abs() < 0.04);
}

#[test]
fn a_seed_gives_the_same_points_always() {
    let line: Shape = Form::from_points(&[2], 1, &[0., 1.], None).unwrap().into();
    let [a, b, c] = [(5, 9), (5, 9), (5, 10)]
        .map(|(count, seed)| random_points(&line, count, Spread::Uniform, seed).unwrap());
    assert_eq!(a, b);
    assert_ne!(a, c);
    // More points begin with those of fewer.
    assert_eq!(random_points(&line, 9, Spread::Uniform, 9).unwrap()[..5], a);
}

#[test]
fn what_has_no_size_is_named() {
    let refuse =
        |form: Form| random_points(&form.into(), 3, Spread::Uniform, 0).unwrap_err().family();
    assert_eq!(refuse(Form::point(&[1.0, 2.0]).unwrap()), "Shape");
    assert_eq!(refuse(Form::from_points(&[2, 2], 1, &[0., 1., 2., 3.], None).unwrap()), "Shape");
    assert_eq!(refuse(Form::from_points(&[2], 1, &[1., 1.], None).unwrap()), "Degenerate");
    let flat = [0., 0., 0., 1., 1., 1., 2., 2., 2., 3., 3., 3.];
    assert_eq!(refuse(Form::from_points(&[2, 2], 3, &flat, None).unwrap()), "Degenerate");
    let infinite = Form::from_points(&[2], 1, &[0., 1.], Some(&[1., -1.])).unwrap();
    assert_eq!(refuse(infinite), "Domain");
    let line: Shape = Form::from_points(&[2], 1, &[0., 1.], None).unwrap().into();
    let much = random_points(&line, usize::MAX, Spread::Uniform, 0).unwrap_err();
    assert_eq!(much.family(), "Limit");
}
