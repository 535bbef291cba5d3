//! Lengths of curves and the way back, as other libraries find them and as closed forms say.

use pforms_operators::{ArcLength, Spline};
use pforms_testkit::models::{document, plain};
use serde_json::Value;

use crate::spline;

fn cases(kind: &str, count: usize) -> Vec<Value> {
    let mut list = document("../peers/lengths.json")["cases"].as_array().unwrap().clone();
    list.retain(|case| case["kind"] == kind);
    assert_eq!(list.len(), count, "{kind}");
    list
}

fn curve(case: &Value) -> Spline {
    spline(&plain::read(&case["input"]["form"]))
}

/// A bound that asks for no less than the accuracy the curve was measured with.
fn bound(case: &Value, length: f64) -> f64 {
    case["tolerance"].as_f64().unwrap().max(2e-13 * length)
}

#[test]
fn lengths() {
    for case in cases("arc_length", 36) {
        let measured = ArcLength::new(curve(&case), 1e-13).unwrap();
        let length = match case["input"]["upto"].as_f64() {
            Some(t) => measured.up_to(t.min(measured.window().1)).unwrap(),
            None => measured.length(),
        };
        let off = (length - case["expected"]["length"].as_f64().unwrap()).abs();
        assert!(off <= bound(&case, measured.length()), "{}: {off}", case["id"]);
    }
}

#[test]
fn parameters_at_lengths() {
    for case in cases("param_at_length", 25) {
        let measured = ArcLength::new(curve(&case), 1e-12).unwrap();
        let wanted = case["input"]["length"].as_f64().unwrap();
        let there = measured.parameter(wanted).unwrap();
        let back = measured.up_to(there).unwrap();
        assert!((back - wanted).abs() <= 1e-12 * measured.length(), "{}", case["id"]);
        // Their search stops at a thousandth.
        let off = (there - case["expected"]["u"].as_f64().unwrap()).abs();
        assert!(off <= case["tolerance"].as_f64().unwrap(), "{}: {off}", case["id"]);
    }
}

#[test]
fn parts_of_equal_length() {
    for case in cases("divide_by_length", 4) {
        let measured = ArcLength::new(curve(&case), 1e-12).unwrap();
        for sample in case["expected"]["samples"].as_array().unwrap() {
            let length = sample["length"].as_f64().unwrap();
            let off = measured.parameter(length).unwrap() - sample["u"].as_f64().unwrap();
            assert!(off.abs() <= case["tolerance"].as_f64().unwrap(), "{}", case["id"]);
        }
    }
}
