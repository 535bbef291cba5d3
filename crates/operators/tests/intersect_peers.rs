//! Intersections of curves against those that other libraries find.
#![allow(clippy::unwrap_used)]

use pforms_operators::{Contact, ContactKind, Intersections, Shape, Spline, intersect};
use pforms_testkit::models::{document, plain};
use pforms_testkit::numbers;
use serde_json::Value;

fn curve(value: &Value) -> Shape {
    let patch = plain::read(value);
    Spline::new(patch.net.clone(), &patch.degrees, patch.knots.clone()).unwrap().into()
}

fn cases(prefix: &str) -> Vec<Value> {
    let all = document("../peers/intersections.json")["cases"].as_array().unwrap().clone();
    all.into_iter().filter(|case| case["id"].as_str().unwrap().starts_with(prefix)).collect()
}

fn met(case: &Value, accuracy: f64) -> Intersections {
    let input = &case["input"];
    let found = intersect(&curve(&input["form1"]), &curve(&input["form2"]), accuracy).unwrap();
    assert!(found.complete, "{}: {found:?}", case["id"]);
    found
}

/// Every pair of parameters that is expected, once each, and nothing else.
fn compare(case: &Value, expected: &[(f64, f64)], contacts: &[Contact], bound: f64) {
    let id = &case["id"];
    assert_eq!(contacts.len(), expected.len(), "{id}: {contacts:#?}");
    for (s, t) in expected {
        let gap = |c: &Contact| (c.first[0] - s).abs().max((c.second[0] - t).abs());
        let least = contacts.iter().map(gap).fold(f64::INFINITY, f64::min);
        assert!(least <= bound, "{id}: ({s}, {t}) missed by {least}");
    }
}

#[test]
fn cases_of_bezier() {
    let all = cases("bezier");
    assert_eq!(all.len(), 53);
    for case in &all {
        let found = met(case, 1e-14);
        let expected = &case["expected"];
        let (u, v) = (numbers(&expected["u1"]), numbers(&expected["u2"]));
        let pairs: Vec<(f64, f64)> = u.into_iter().zip(v).collect();
        let kind = expected["type"].as_str().unwrap();
        // Parts of one curve may also just cross, or meet end to end.
        if kind == "coincident" && !found.overlaps.is_empty() {
            assert_eq!((found.contacts.len(), found.overlaps.len()), (0, 1), "{found:#?}");
            let overlap = &found.overlaps[0];
            for (i, (s, t)) in pairs.iter().enumerate() {
                let gap = (overlap.first[i][0] - s).abs().max((overlap.second[i][0] - t).abs());
                assert!(gap <= 1e-12, "{}: {overlap:?}", case["id"]);
            }
            continue;
        }
        compare(case, &pairs, &found.contacts, case["tolerance"].as_f64().unwrap());
        if kind == "tangent" {
            let tangents = found.contacts.iter().filter(|c| c.kind == ContactKind::Tangent);
            assert_eq!(tangents.count(), 1, "{}: {:#?}", case["id"], found.contacts);
        }
    }
}

#[test]
fn cases_of_paperjs() {
    let all = cases("paperjs");
    assert_eq!(all.len(), 18);
    for case in &all {
        let expected = &case["expected"];
        let pairs = |list: &Value| -> Vec<(f64, f64)> {
            let pair = |x: &Value| (x["u1"].as_f64().unwrap(), x["u2"].as_f64().unwrap());
            list.as_array().unwrap().iter().map(pair).collect()
        };
        let (meetings, touches) = (pairs(&expected["reference"]), pairs(&expected["near_touch"]));
        let exact = met(case, 0.0);
        compare(case, &meetings, &exact.contacts, 1e-7);
        let found = met(case, 1e-9);
        compare(case, &[meetings, touches.clone()].concat(), &found.contacts, 1e-7);
        let told = found.contacts.iter().filter(|c| c.gap > 0.0).count();
        assert_eq!(told, touches.len(), "{}", case["id"]);
    }
}

#[test]
fn cases_of_verb() {
    for case in &cases("verb") {
        let list = case["expected"]["intersections"].as_array().unwrap();
        let pair = |x: &Value| (x["u1"].as_f64().unwrap(), x["u2"].as_f64().unwrap());
        let pairs: Vec<(f64, f64)> = list.iter().map(pair).collect();
        compare(case, &pairs, &met(case, 1e-14).contacts, 1e-4);
    }
}

#[test]
fn eleven_crossings_of_splines() {
    let all = cases("tigl-bspline");
    let list = all[0]["expected"]["reference"].as_array().unwrap();
    let pair = |x: &Value| (x["u1"].as_f64().unwrap(), x["u2"].as_f64().unwrap());
    let pairs: Vec<(f64, f64)> = list.iter().map(pair).collect();
    let found = met(&all[0], 1e-14);
    compare(&all[0], &pairs, &found.contacts, 1e-13);
    assert!(found.contacts.iter().all(|c| c.proved && c.kind == ContactKind::Crossing));
}

#[test]
fn curves_in_space() {
    let all = cases("tigl-curve-curve-3d");
    let found = met(&all[0], 1e-14);
    compare(&all[0], &[(0.816_227_766_016_838, 0.8)], &found.contacts, 1e-12);
}

#[test]
fn a_near_miss_is_a_touch_within_its_distance() {
    let case = &cases("tigl-near-miss")[0];
    for (distance, count) in [(0.1, 1), (0.07072, 1), (0.07071, 0)] {
        // Lengths of 0.95.
        let found = met(case, distance / 0.95);
        assert_eq!(found.contacts.len(), count, "{distance}: {found:#?}");
        for contact in &found.contacts {
            assert_eq!(contact.kind, ContactKind::Touch);
            assert_eq!((contact.first[0], contact.second[0]), (5.0, 5.0));
            assert!((contact.gap - 0.005_f64.sqrt()).abs() < 1e-15);
        }
    }
}

#[test]
fn a_curve_on_a_grid() {
    let case = &cases("anurbs")[0];
    let input = &case["input"];
    let whole = curve(&input["form"]);
    let line = |from: [f64; 2], to: [f64; 2]| -> Shape {
        let points = [from, to].concat();
        pforms_kernel::Form::from_points(&[2], 2, &points, None).unwrap().into()
    };
    let mut places = vec![1.0, 11.0];
    let columns = numbers(&input["x_lines"]).into_iter().map(|x| line([x, 0.0], [x, 20.0]));
    let rows = numbers(&input["y_lines"]).into_iter().map(|y| line([0.0, y], [20.0, y]));
    for line in columns.chain(rows) {
        let found = intersect(&whole, &line, 1e-14).unwrap();
        assert!(found.complete, "{found:?}");
        places.extend(found.contacts.iter().map(|c| c.first[0]));
    }
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| (*a - *b).abs() < 1e-7);
    let expected = numbers(&case["expected"]["u"]);
    assert_eq!(places.len(), expected.len(), "{places:?}");
    assert!(places.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-6), "{places:?}");
}
