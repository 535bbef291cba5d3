//! The cases that the original system produced, as `cases/reference` keeps them.

use std::path::Path;

use pforms_kernel::{Form, Scalar};
use serde_json::Value;

/// One case: its name, its arguments, and the right answer.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its name in the series.
    pub id: String,
    /// The scalar arguments.
    pub params: Value,
    /// The net, or an object of several.
    pub input: Value,
    /// The answer, in the layout of the input.
    pub expected: Value,
}

/// The cases of `cases/reference/NAME.json`.
pub fn cases(name: &str) -> Vec<Case> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/reference");
    let text = std::fs::read_to_string(root.join(format!("{name}.json"))).expect("reference file");
    let document: Value = serde_json::from_str(&text).expect("JSON");
    let list = document["cases"].as_array().expect("a list of cases");
    assert!(!list.is_empty(), "{name} has no case");
    list.iter()
        .map(|case| Case {
            id: case["id"].as_str().expect("an id").to_owned(),
            params: case["params"].clone(),
            input: case["input"].clone(),
            expected: case["expected"].clone(),
        })
        .collect()
}

/// A form from nested lists of homogeneous poles.
pub fn net<S: Scalar>(nested: &Value) -> Form<S> {
    let mut orders = Vec::new();
    let mut level = nested;
    while let Some(list) = level.as_array() {
        orders.push(list.len());
        level = &list[0];
    }
    let width = orders.pop().expect("a pole at least");
    let poles = numbers(nested);
    let poles = poles.iter().map(|x| S::from_f64(*x).expect("finite"));
    Form::from_homogeneous(&orders, width - 1, poles.collect()).expect("a regular net")
}

/// All numbers of nested lists, in order; a bare number is a list of one, `"1/3"` is a fraction.
pub fn numbers(nested: &Value) -> Vec<f64> {
    match nested {
        Value::Array(list) => list.iter().flat_map(numbers).collect(),
        Value::String(text) => vec![fraction(text)],
        number => vec![number.as_f64().expect("a number")],
    }
}

fn fraction(text: &str) -> f64 {
    let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
    let parse = |part: &str| part.parse::<f64>().expect("a fraction");
    parse(numerator) / parse(denominator)
}
