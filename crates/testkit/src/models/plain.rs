//! A form as the measured numbers beside the models give it: degrees, points, weights, knots.

use serde_json::Value;

use super::{Patch, bezier_knots, pole};
use crate::numbers;

/// A spline from euclidean points, the last parameter fastest; without knots it is one piece on [0, 1].
pub fn read(form: &Value) -> Patch {
    let degrees: Vec<usize> =
        numbers(&form["degrees"]).iter().map(|degree| *degree as usize).collect();
    let points: Vec<Vec<f64>> =
        form["points"].as_array().expect("points").iter().map(numbers).collect();
    let weights = match &form["weights"] {
        Value::Null => vec![1.0; points.len()],
        list => numbers(list),
    };
    let knots = match &form["knots"] {
        Value::Null => degrees.iter().map(|degree| bezier_knots(*degree)).collect(),
        lists => lists.as_array().expect("knot vectors").iter().map(numbers).collect(),
    };
    let poles: Vec<Vec<f64>> = points.iter().zip(weights).map(|(p, w)| pole(p, w)).collect();
    Patch::new("", &degrees, knots, &poles)
}
