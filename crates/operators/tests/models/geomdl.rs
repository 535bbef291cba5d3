//! Control points of the geomdl examples, against the points that geomdl itself evaluates.

use pforms_operators::Spline;
use pforms_testkit::models::{Patch, document, geomdl, text};
use pforms_testkit::numbers;
use serde_json::Value;

use crate::{gap, laws, scale, spline};

fn patch(model: &Value) -> Patch {
    let file = model["file"].as_str().unwrap();
    let weighted = file.ends_with('w');
    let text = text(&format!("geomdl/{file}"));
    let degrees: Vec<usize> = numbers(&model["degrees"]).iter().map(|x| *x as usize).collect();
    let knots = |axis: usize| Some(numbers(&model["knots"][axis]));
    match degrees.as_slice() {
        [degree] => geomdl::curve(&text, weighted, *degree, knots(0)),
        [u, v] => geomdl::surface(&text, weighted, [*u, *v], [knots(0), knots(1)]),
        _ => panic!("a curve or a surface"),
    }
}

fn models() -> Vec<(String, Value, Spline)> {
    let expected = document("geomdl/samples.json");
    let list = expected["models"].as_array().unwrap().clone();
    assert_eq!(list.len(), 13);
    let named = |model: Value| {
        (model["file"].as_str().unwrap().to_owned(), model.clone(), spline(&patch(&model)))
    };
    list.into_iter().map(named).collect()
}

#[test]
fn samples_are_those_of_geomdl() {
    for (file, model, spline) in models() {
        for sample in model["samples"].as_array().unwrap() {
            let point = spline.at(&numbers(&sample["u"])).unwrap();
            let gap = gap(&point, &numbers(&sample["point"]));
            assert!(gap <= 1e-14 * scale(&spline), "{file}: {gap} at {}", sample["u"]);
        }
    }
}

/// Where the examples leave the knots to geomdl, they are even and clamped.
#[test]
fn knots_by_default() {
    let model = document("geomdl/samples.json")["models"][0].clone();
    let by_default = geomdl::curve(&text("geomdl/ex_curve01.cpt"), false, 4, None);
    assert!(gap(&by_default.knots[0], &numbers(&model["knots"][0])) < 1e-15);
    let points = text("geomdl/ex_surface01.cpt");
    let surface = spline(&geomdl::surface(&points, false, [3, 3], [None, None]));
    assert_eq!(surface.counts(), [3, 3]);
}

/// The weights are √½ rounded to three digits in the circle, to four in the cylinder.
#[test]
fn circles_are_round_to_the_digits_of_their_weights() {
    for (file, digits) in [("ex_curve04.cptw", 3e-4), ("ex_cylinder.cptw", 2e-5)] {
        let (_, _, spline) = models().into_iter().find(|(name, ..)| name == file).unwrap();
        for i in 0..=40 {
            let t = f64::from(i) / 40.0;
            let place = if spline.axes() == 1 { vec![t] } else { vec![0.3, t] };
            let point = spline.at(&place).unwrap();
            let off = (point[0].hypot(point[1]) - 1.0).abs();
            assert!(off <= digits, "{file}: {off} at {t}");
        }
    }
}

#[test]
fn laws_hold_on_every_example() {
    for (file, _, spline) in models() {
        laws::hold(&file, &spline);
    }
}
