//! Frames and interpolations of the original system, checked there against exact arithmetic.
#![allow(clippy::unwrap_used)]

mod common;

use common::distance;
use pforms_kernel::Form;
use pforms_operators::{Nodes, curve_frame, interpolate_homogeneous, surface_frame, volume_frame};
use serde_json::Value;

fn cases(name: &str) -> Vec<Value> {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/reference/");
    let text = std::fs::read_to_string(format!("{root}{name}.json")).unwrap();
    let mut file: Value = serde_json::from_str(&text).unwrap();
    std::mem::take(file["cases"].as_array_mut().unwrap())
}

fn numbers(value: &Value, out: &mut Vec<f64>) {
    match value {
        Value::Array(list) => list.iter().for_each(|inner| numbers(inner, out)),
        number => out.push(number.as_f64().unwrap()),
    }
}

fn flat(value: &Value) -> Vec<f64> {
    let mut out = Vec::new();
    numbers(value, &mut out);
    out
}

fn form(net: &Value, axes: usize) -> Form {
    let mut orders = Vec::new();
    let mut level = net;
    for _ in 0..axes {
        orders.push(level.as_array().unwrap().len());
        level = &level[0];
    }
    Form::from_homogeneous(&orders, 3, flat(net)).unwrap()
}

fn close(found: &[f64], expected: &[f64], case: &Value) {
    let size = 1.0 + expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    let error = distance(found, expected);
    assert!(error < 1e-12 * size, "{}: {found:?} for {expected:?}", case["id"]);
}

fn close_to(found: &[f64], case: &Value, name: &str) {
    close(found, &flat(&case["expected"][name]), case);
}

#[test]
fn curves() {
    for case in cases("frame_curve") {
        let curve = form(&case["input"], 1);
        let frame = curve_frame(&curve, case["params"]["at"].as_f64().unwrap()).unwrap();
        close_to(&frame.point, &case, "point");
        close_to(&frame.tangent, &case, "tangent");
        close_to(&frame.normal.unwrap(), &case, "normal");
        close_to(&frame.binormal.unwrap(), &case, "binormal");
    }
}

#[test]
fn surfaces() {
    for case in cases("frame_surface") {
        let surface = form(&case["input"], 2);
        let at = flat(&case["params"]["at"]);
        let frame = surface_frame(&surface, at[0], at[1]).unwrap();
        close_to(&frame.point, &case, "point");
        close_to(&frame.tangents[0], &case, "tu");
        close_to(&frame.tangents[1], &case, "tv");
        close_to(&frame.normal.unwrap(), &case, "normal");
    }
}

#[test]
fn volumes() {
    for case in cases("frame_volume") {
        let volume = form(&case["input"], 3);
        let frame = volume_frame(&volume, &flat(&case["params"]["at"])).unwrap();
        close_to(&frame.point, &case, "point");
        for (tangent, name) in frame.tangents.iter().zip(["tu", "tv", "tw"]) {
            close_to(tangent, &case, name);
        }
    }
}

#[test]
fn interpolations() {
    for (name, axes) in [("interpolation_curve", 1), ("interpolation_surface", 2)] {
        let mut worst = 0.0_f64;
        for case in cases(name) {
            let net = form(&case["input"], axes);
            let found = interpolate_homogeneous(&net, &Nodes::Uniform).unwrap();
            let expected = flat(&case["expected"]);
            let size = expected.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
            for (found, expected) in found.homogeneous().iter().zip(&expected) {
                worst = worst.max((found - expected).abs() / size);
                assert!((found - expected).abs() < 1e-12 * size, "{}", case["id"]);
            }
        }
        println!("{name}: {worst:.1e}");
    }
}
