//! The errors that geodesics report, against an integration that shares nothing with theirs: on the ellipsoid as an
//! implicit surface of space, by extrapolation.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_operators::{
    GeodesicOptions, Heading, Part, Spline, geodesic, geodesics, scale, sphere,
};
use pforms_testkit::Random;

/// Place and velocity.
type Orbit = [f64; 6];

/// `x″ = −(v·Av)/(Ax·Ax)·Ax` keeps `x·Ax = 1` with `A` the inverse squares of the half axes.
fn pull(axes: [f64; 3], at: &Orbit) -> Orbit {
    let inverse = axes.map(|a| 1.0 / (a * a));
    let normal = [0, 1, 2].map(|k| inverse[k] * at[k]);
    let bend: f64 = (0..3).map(|k| inverse[k] * at[3 + k] * at[3 + k]).sum();
    let square: f64 = normal.iter().map(|x| x * x).sum();
    let force = normal.map(|x| -bend / square * x);
    [at[3], at[4], at[5], force[0], force[1], force[2]]
}

fn moved(at: &Orbit, by: f64, slope: &Orbit) -> Orbit {
    std::array::from_fn(|k| at[k] + by * slope[k])
}

/// Gragg's rule with Bulirsch and Stoer's extrapolation, and how well it agrees with itself.
fn leap(axes: [f64; 3], from: &Orbit, by: f64) -> (Orbit, f64) {
    let mut table: Vec<Vec<Orbit>> = Vec::new();
    for (row, count) in (1..=8).map(|k| 2 * k).enumerate() {
        let h = by / f64::from(count);
        let (mut before, mut at) = (*from, moved(from, h, &pull(axes, from)));
        for _ in 1..count {
            (before, at) = (at, moved(&before, 2.0 * h, &pull(axes, &at)));
        }
        let ahead = moved(&at, h, &pull(axes, &at));
        let mut line = vec![std::array::from_fn(|k| 0.5 * (before[k] + ahead[k]))];
        for k in 1..=row {
            let ratio = (row + 1) as f64 / (row + 1 - k) as f64;
            let (fine, coarse): (&Orbit, &Orbit) = (&line[k - 1], &table[row - 1][k - 1]);
            line.push(std::array::from_fn(|i| {
                fine[i] + (fine[i] - coarse[i]) / (ratio * ratio - 1.0)
            }));
        }
        table.push(line);
    }
    let (best, other) = (table[7][7], table[7][6]);
    let miss = best.iter().zip(&other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    (best, miss)
}

fn followed(axes: [f64; 3], start: &Orbit, length: f64) -> Orbit {
    let (mut at, mut gone, mut by) = (*start, 0.0, 0.01);
    while gone < length {
        let step = f64::min(by, length - gone);
        let (next, miss) = leap(axes, &at, step);
        // Rounding of the extrapolation is about this large.
        if miss <= 1e-14 {
            (at, gone) = (next, gone + step);
            by = 1.5 * step;
        } else {
            by = 0.5 * step;
        }
    }
    at
}

fn ellipsoid(axes: [f64; 3]) -> Spline {
    scale(&sphere(&1.0, Part::Pieces).unwrap(), &axes, &[0.0; 3]).unwrap().into_spline()
}

fn norm(a: &[f64]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    norm(&a.iter().zip(b).map(|(x, y)| x - y).collect::<Vec<_>>())
}

/// A start on the surface, and a unit tangent there.
fn begin(surface: &Spline, axes: [f64; 3], random: &mut Random) -> ([f64; 2], Orbit) {
    let start = [0, 1].map(|axis| {
        let (from, to) = surface.window(axis).unwrap();
        from + (to - from) * random.unit()
    });
    let point = surface.at(&start).unwrap();
    let normal: Vec<f64> = (0..3).map(|k| point[k] / (axes[k] * axes[k])).collect();
    let raw: Vec<f64> = (0..3).map(|_| 2.0 * random.unit() - 1.0).collect();
    let inner: f64 = raw.iter().zip(&normal).map(|(a, b)| a * b).sum();
    let share = inner / norm(&normal).powi(2);
    let tangent: Vec<f64> = raw.iter().zip(&normal).map(|(a, b)| a - share * b).collect();
    let size = norm(&tangent);
    let state = std::array::from_fn(|k| if k < 3 { point[k] } else { tangent[k - 3] / size });
    (start, state)
}

/// Spheroids flat and long, and with three axes, with lengths that take them over rims and poles.
const SHAPES: [([f64; 3], f64); 8] = [
    ([1.0, 1.0, 1.0], 7.0),
    ([1.0, 0.3, 1.0], 7.0),
    ([1.0, 1.0, 0.1], 5.0),
    ([1.0, 0.1, 1.0], 5.0),
    ([1.0, 0.02, 1.0], 2.5),
    ([1.0, 2.0, 3.0], 12.0),
    ([1.0, 0.5, 0.2], 6.0),
    ([1.0, 20.0, 1.0], 45.0),
];

#[test]
fn bounds_hold_on_ellipsoids() {
    let mut random = Random::new(36);
    for (axes, length) in SHAPES {
        let surface = ellipsoid(axes);
        for accuracy in [1e-6, 1e-10] {
            let options = GeodesicOptions { accuracy, ..GeodesicOptions::default() };
            let begins: Vec<_> = (0..14).map(|_| begin(&surface, axes, &mut random)).collect();
            let starts: Vec<[f64; 2]> = begins.iter().map(|one| one.0).collect();
            let headings: Vec<Heading> =
                begins.iter().map(|one| Heading::Vector(one.1[3..].to_vec())).collect();
            let ends = geodesics(surface.clone(), &starts, &headings, &[length], &options).unwrap();
            for (k, (start, state)) in begins.iter().enumerate() {
                let line =
                    geodesic(surface.clone(), *start, &headings[k], length, &options).unwrap();
                let truth = followed(axes, state, length);
                // What the other integration may be off by: rounding, more where the surface bends much.
                let [most, least] =
                    [f64::max, f64::min].map(|pick| axes.into_iter().fold(1.0, pick));
                let own = 2e-12 * most / least;
                let miss = distance(&line.point, &truth[..3]);
                assert!(miss <= line.error + own, "{axes:?} {k}: {miss:e} {:e}", line.error);
                let miss = distance(&ends.points[3 * k..3 * k + 3], &truth[..3]);
                assert!(
                    miss <= ends.errors[k] + own,
                    "{axes:?} {k}: {miss:e} {:e}",
                    ends.errors[k]
                );
                assert!(line.error <= 4.0 * accuracy * axes[1].max(3.0));
            }
        }
    }
}

/// Distance from the axis times the direction around it.
fn clairaut(point: &[f64], direction: &[f64]) -> f64 {
    point[0] * direction[2] - point[2] * direction[0]
}

#[test]
fn clairaut_on_spheroids_flat_and_long() {
    let mut random = Random::new(7);
    for (thin, length) in [(0.1, 9.0), (0.01, 7.0), (1e-3, 5.0), (1e-4, 5.0), (100.0, 150.0)] {
        let axes = [1.0, thin, 1.0];
        let surface = ellipsoid(axes);
        for _ in 0..4 {
            let (start, state) = begin(&surface, axes, &mut random);
            let heading = Heading::Vector(state[3..].to_vec());
            // Twice past the tips of a needle neighbours part by a billion.
            let accuracy = if thin > 1.0 { 1e-8 } else { 1e-10 };
            let options = GeodesicOptions { accuracy, ..GeodesicOptions::default() };
            let line = geodesic(surface.clone(), start, &heading, length, &options).unwrap();
            let drift = clairaut(&state[..3], &state[3..]) - clairaut(&line.point, &line.direction);
            // Of a needle the size is 100, and so is that of its rounding.
            assert!(drift.abs() < 1e-10 * thin.max(1.0), "{thin}: {drift:e}");
        }
    }
}
