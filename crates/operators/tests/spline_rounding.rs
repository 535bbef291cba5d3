//! Splines in floating point against exact fractions, over knots of every kind and size.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Form, Rational, Result, Scalar};
use pforms_operators::Spline;
use pforms_testkit::Random;

/// Random knots: close together, far apart, repeated, of any size, the ends repeated or not.
fn knots(count: usize, random: &mut Random) -> Vec<f64> {
    let size = [1.0, 1e-150, 1e150, 1e-12, 1e12][random.size(0, 4)];
    let start = [0.0, 0.0, 1e3, -1e6][random.size(0, 3)];
    let mut knot = || match random.size(0, 3) {
        0 => random.unit(),
        1 => random.size(0, 3) as f64,
        2 => random.size(0, 2) as f64 + 1e-13 * random.unit(),
        _ => 1e-9 * random.unit(),
    };
    let mut list: Vec<f64> = (0..count).map(|_| (knot() + start) * size).collect();
    list.sort_by(f64::total_cmp);
    list
}

/// A spline with weights of any sign, 0 among them; `None` where the knots are refused.
fn spline(random: &mut Random) -> Option<Spline> {
    let axes = random.size(1, 2);
    let degrees: Vec<usize> = (0..axes).map(|_| random.size(0, 7 - 2 * axes)).collect();
    let orders: Vec<usize> = degrees.iter().map(|degree| degree + 1 + random.size(0, 4)).collect();
    let knots =
        orders.iter().zip(&degrees).map(|(order, degree)| knots(order + degree + 1, random));
    let knots = knots.collect();
    let size = [1.0, 1e-150, 1e150][random.size(0, 2)];
    let pole = |_| {
        let weight = [0.0, -random.unit(), 1.0, random.unit()][random.size(0, 3)];
        [random.unit() * size, -random.unit() * size, weight]
    };
    let poles: Vec<f64> = (0..orders.iter().product::<usize>()).flat_map(pole).collect();
    Spline::new(Form::from_homogeneous(&orders, 2, poles).unwrap(), &degrees, knots).ok()
}

/// The spline itself and what leaves it as it is, by every road.
fn roads(spline: &Spline, place: &[f64]) -> Vec<(&'static str, Result<Spline>)> {
    let axes = spline.axes();
    let mut roads = vec![
        ("itself", Ok(spline.clone())),
        ("pieces", spline.bezier()),
        ("elevated", spline.elevate(&vec![1; axes])),
        ("elevated three times", spline.elevate(&vec![3; axes])),
    ];
    for (axis, t) in place.iter().enumerate() {
        let (from, to) = spline.window(axis).unwrap();
        let finer = spline.insert_knots(axis, std::slice::from_ref(t));
        if let Ok(finer) = &finer {
            let removed = finer.remove_knot(axis, t).map(|removal| removal.spline);
            roads.push(("knot removed", removed));
        }
        roads.push(("knot inserted", finer));
        roads.push(("window", spline.restrict(axis, &from, &to)));
    }
    roads
}

/// Poles are mixed with factors between 0 and 1, whatever the knots: an error is a few roundings of
/// the largest pole, and never a cancellation.
#[test]
fn every_road_is_right_to_a_few_roundings() {
    let mut taken = 0;
    for seed in 0..1500 {
        let mut random = Random::new(seed);
        let Some(spline) = spline(&mut random) else { continue };
        let fraction = |x: &f64| Rational::from_f64(*x).unwrap();
        let exact = spline.map_scalar(fraction).unwrap();
        let inside = |axis| {
            let (from, to) = spline.window(axis).unwrap();
            [from, to, from + (to - from) * random.unit()][random.size(0, 2)]
        };
        let place: Vec<f64> = (0..spline.axes()).map(inside).collect();
        let there = exact.homogeneous_at(&place.iter().map(fraction).collect::<Vec<_>>()).unwrap();
        let largest = |k: usize| {
            let numbers = spline.net().homogeneous().iter().skip(k).step_by(3);
            numbers.fold(0.0_f64, |most, x| most.max(x.abs()))
        };
        // An end of the window may have as many knots as it can; an end cannot be removed.
        for (road, same) in roads(&spline, &place) {
            let Ok(same) = same else { continue };
            let here = same.homogeneous_at(&place).unwrap();
            for (k, (x, y)) in here.iter().zip(&there).enumerate() {
                let error = (fraction(x) - y.clone()).to_f64().abs();
                assert!(error <= 3e-15 * largest(k), "{road}, seed {seed}: {error}");
            }
            taken += 1;
        }
    }
    assert!(taken > 5000, "{taken}");
}
