//! What other libraries say of the same splines.

use pforms_kernel::Form;
use pforms_operators::{Spline, immerse_spline};
use pforms_testkit::models::{Patch, document, plain};
use pforms_testkit::numbers;
use serde_json::Value;

use crate::measure::total;
use crate::{gap, pole_box, spline};

/// The cases of some kinds, as many as there should be.
fn cases(kinds: &[&str], count: usize) -> Vec<Value> {
    let all = document("../peers/splines.json");
    let mut list = all["cases"].as_array().unwrap().clone();
    list.retain(|case| kinds.contains(&case["kind"].as_str().unwrap()));
    assert_eq!(list.len(), count, "{kinds:?}");
    for case in &mut list {
        if case["input"]["form"]["points_ref"] == "volume_points" {
            case["input"]["form"]["points"] = all["volume_points"].clone();
        }
    }
    list
}

fn form(value: &Value) -> Spline {
    spline(&plain::read(value))
}

/// Two numbers of a case are as near as it says, and no test asks for less than rounding allows.
fn near(case: &Value, here: &[f64], there: &[f64]) {
    let size = there.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
    let bound = case["tolerance"].as_f64().unwrap().max(1e-14 * size);
    let gap = gap(here, there);
    assert!(gap <= bound, "{}: {gap}\n{here:?}\n{there:?}", case["id"]);
}

/// The same net and knots.
fn same(case: &Value, here: &Spline, there: &Value) {
    let there: Patch = plain::read(there);
    assert_eq!(here.degrees(), there.degrees, "{}", case["id"]);
    near(case, here.net().homogeneous(), there.net.homogeneous());
    for (knots, list) in here.knots().iter().zip(&there.knots) {
        near(case, knots.as_slice(), list);
    }
}

#[test]
fn points() {
    let kinds = ["curve_eval", "curve_eval_polynomial", "surface_eval", "volume_eval"];
    for case in cases(&kinds, 110) {
        let point = form(&case["input"]["form"]).at(&numbers(&case["input"]["u"])).unwrap();
        near(&case, &point, &numbers(&case["expected"]["point"]));
    }
}

#[test]
fn derivatives() {
    for case in cases(&["curve_derivatives"], 32) {
        let curve = form(&case["input"]["form"]);
        for (order, value) in case["expected"]["derivatives"].as_array().unwrap().iter().enumerate()
        {
            let derivative = curve.derivative(&[order]).unwrap();
            let vector = derivative.at(&numbers(&case["input"]["u"])).unwrap();
            near(&case, &vector, &numbers(value));
        }
    }
    for case in cases(&["surface_derivatives"], 13) {
        let surface = form(&case["input"]["form"]);
        for (i, row) in case["expected"]["derivatives"].as_array().unwrap().iter().enumerate() {
            for (j, value) in row.as_array().unwrap().iter().enumerate() {
                let derivative = surface.derivative(&[i, j]).unwrap();
                let vector = derivative.at(&numbers(&case["input"]["u"])).unwrap();
                near(&case, &vector, &numbers(value));
            }
        }
    }
}

#[test]
fn knots_degrees_and_parts() {
    let axis = |case: &Value| case["input"]["direction"].as_u64().unwrap() as usize;
    for case in cases(&["knot_insertion"], 12) {
        let knots = numbers(&case["input"]["knots"]);
        let finer = form(&case["input"]["form"]).insert_knots(axis(&case), &knots).unwrap();
        same(&case, &finer, &case["expected"]["form"]);
    }
    for case in cases(&["degree_elevation"], 3) {
        let curve = form(&case["input"]["form"]);
        let by = case["input"]["to_degree"].as_u64().unwrap() as usize - curve.degrees()[0];
        same(&case, &curve.elevate(&[by]).unwrap(), &case["expected"]["form"]);
    }
    for case in cases(&["split"], 7) {
        let whole = form(&case["input"]["form"]);
        let (low, high) = whole.split(axis(&case), &case["input"]["at"].as_f64().unwrap()).unwrap();
        same(&case, &low, &case["expected"]["parts"][0]);
        same(&case, &high, &case["expected"]["parts"][1]);
    }
    for case in cases(&["bezier_extraction"], 1) {
        let pieces = form(&case["input"]["form"]).pieces().unwrap();
        let segments = case["expected"]["segments"].as_array().unwrap();
        assert_eq!(pieces.len(), segments.len());
        for (piece, segment) in pieces.iter().zip(segments) {
            near(&case, piece.homogeneous(), plain::read(segment).net.homogeneous());
        }
    }
}

/// The spline whose poles are the unit vectors: its coordinates are the basis functions.
fn basis(degree: usize, knots: &[f64]) -> Spline {
    let count = knots.len() - degree - 1;
    let unit = |i: usize| (0..count).map(move |k| f64::from(u8::from(i == k)));
    let points: Vec<f64> = (0..count).flat_map(unit).collect();
    let net = Form::from_points(&[count], count, &points, None).unwrap();
    Spline::new(net, &[degree], vec![knots.to_vec()]).unwrap()
}

#[test]
fn basis_functions() {
    for case in cases(&["basis"], 1) {
        let input = &case["input"];
        let basis = basis(input["degree"].as_u64().unwrap() as usize, &numbers(&input["knots"]));
        let mut values = basis.at(&numbers(&input["u"])).unwrap();
        values.retain(|value| *value != 0.0);
        near(&case, &values, &numbers(&case["expected"]["nonzero"]));
    }
    for case in cases(&["basis_derivatives"], 1) {
        let input = &case["input"];
        let degree = input["degree"].as_u64().unwrap() as usize;
        let first = input["span"].as_u64().unwrap() as usize - degree;
        let basis = basis(degree, &numbers(&input["knots"]));
        for (order, row) in case["expected"]["values"].as_array().unwrap().iter().enumerate() {
            let values = basis.derivative(&[order]).unwrap().at(&numbers(&input["u"])).unwrap();
            near(&case, &values[first..=first + degree], &numbers(row));
        }
    }
    for case in cases(&["greville"], 1) {
        // The points that make a line of the parameter itself.
        let input = &case["input"];
        let (degree, knots) =
            (input["degree"].as_u64().unwrap() as usize, numbers(&input["knots"]));
        let points = numbers(&case["expected"]["greville"]);
        let net = Form::from_points(&[points.len()], 1, &points, None).unwrap();
        let line = Spline::new(net, &[degree], vec![knots]).unwrap();
        for t in [0.0, 0.2, 0.5, 0.6, 1.0] {
            near(&case, &line.at(&[t]).unwrap(), &[t]);
        }
    }
}

#[test]
fn tensor_basis_functions() {
    for case in cases(&["tensor_basis"], 10) {
        let patch = plain::read(&case["input"]["form"]);
        let count = patch.net.pole_count();
        let unit = |i: usize| (0..count).map(move |k| f64::from(u8::from(i == k)));
        let points: Vec<f64> = (0..count).flat_map(unit).collect();
        let weights = patch.net.weights();
        let net = Form::from_points(patch.net.orders(), count, &points, Some(&weights)).unwrap();
        let basis = Spline::new(net, &patch.degrees, patch.knots).unwrap();
        let mut values = basis.at(&numbers(&case["input"]["u"])).unwrap();
        let there = numbers(&case["expected"]["nonzero_sorted"]);
        values.sort_by(f64::total_cmp);
        let zeros = values.len() - there.len();
        near(&case, &values[zeros..], &there);
        assert!(values[..zeros].iter().all(|value| *value == 0.0), "{}", case["id"]);
    }
}

#[test]
fn measures_and_boxes() {
    for case in cases(&["measure", "area"], 5) {
        let spline = form(&case["input"]["form"]);
        let expected = &case["expected"];
        let there = expected["measure"].as_f64().or(expected["area"].as_f64()).unwrap();
        let raised = spline.elevate(&vec![2; spline.axes()]).unwrap();
        let (from, to) = spline.window(0).unwrap();
        let finer = spline.insert_knots(0, &[0.7 * from + 0.3 * to]).unwrap();
        for same in [spline, raised, finer] {
            near(&case, &[total(&[same], 30)], &[there]);
        }
    }
    for case in cases(&["control_bbox"], 8) {
        let bounds = numbers(&case["expected"]["bounds"]);
        near(&case, &pole_box(&form(&case["input"]["form"])).concat(), &bounds);
    }
}

#[test]
fn compositions() {
    for case in cases(&["composition"], 5) {
        let (outer, inner) = (form(&case["input"]["outer"]), form(&case["input"]["inner"]));
        let composed = immerse_spline(&inner.into(), &outer.into()).unwrap();
        let degrees: Vec<usize> =
            numbers(&case["expected"]["degrees"]).iter().map(|x| *x as usize).collect();
        assert_eq!(composed.degrees(), degrees, "{}", case["id"]);
        for sample in case["expected"]["samples"].as_array().unwrap() {
            near(&case, &composed.at(&numbers(&sample["u"])).unwrap(), &numbers(&sample["point"]));
        }
    }
}

#[test]
fn half_a_sphere_in_one_patch() {
    for case in cases(&["surface_is_sphere"], 1) {
        let half = form(&case["input"]["form"]);
        let steps: Vec<f64> = (0..=16).map(|i| f64::from(i) / 16.0).collect();
        for point in half.grid(&[&steps, &steps]).unwrap().as_chunks::<3>().0 {
            let radius = point[0].hypot(point[1]).hypot(point[2]);
            near(&case, &[radius], &[1.0]);
        }
        // The integrand is a quotient that 30 nodes know to this.
        let area = case["expected"]["area"].as_f64().unwrap();
        assert!((total(&[half], 60) - area).abs() < 1e-9);
    }
}

/// Extraction operators are what the pieces of the basis are made of; nets of elements are pieces.
#[test]
fn extraction_operators() {
    let all = document("../peers/extraction.json");
    for case in all["cases"].as_array().unwrap() {
        let patch = plain::read(&case["input"]["form"]);
        for (axis, spans) in case["expected"]["operators"].as_array().unwrap().iter().enumerate() {
            let degree = patch.degrees[axis];
            let pieces = basis(degree, &patch.knots[axis]).pieces().unwrap();
            assert_eq!(pieces.len(), spans.as_array().unwrap().len());
            for (piece, operator) in pieces.iter().zip(spans.as_array().unwrap()) {
                let rows: Vec<Vec<f64>> =
                    operator.as_array().unwrap().iter().map(numbers).collect();
                let points = piece.points().unwrap();
                let first = points.iter().position(|x| *x != 0.0).unwrap();
                for (j, point) in points.chunks(piece.ambient()).enumerate() {
                    let column: Vec<f64> = rows.iter().map(|row| row[j]).collect();
                    near(case, &point[first..=first + degree], &column);
                }
            }
        }
        let pieces = spline(&patch).pieces().unwrap();
        for element in case["expected"]["elements"].as_array().unwrap() {
            let net = numbers(&element["points"]);
            let found = |piece: &&Form| gap(&piece.points().unwrap(), &net) <= 1e-12;
            assert_eq!(pieces.iter().filter(found).count(), 1, "{}", case["id"]);
        }
    }
}
