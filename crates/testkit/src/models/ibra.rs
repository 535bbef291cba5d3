//! Geometry in JSON as `ANurbs` and Kratos exchange it (`.ibra`).
//!
//! The knot vectors are those of `openNURBS`: the first and the last knot are left out.

use serde_json::Value;

use super::{Patch, pole};
use crate::numbers;

/// Every NURBS curve and surface of the document, named by its key.
pub fn read(document: &Value) -> Vec<Patch> {
    let list = document.as_array().expect("a list");
    let is_spline = |entry: &&Value| entry["type"].as_str().is_some_and(|t| t.starts_with("Nurbs"));
    list.iter().filter(is_spline).map(patch).collect()
}

fn patch(entry: &Value) -> Patch {
    let axes: &[&str] = if entry.get("degree").is_some() { &[""] } else { &["_u", "_v"] };
    let of = |name: &str, axis: &str| &entry[format!("{name}{axis}")];
    let degrees: Vec<usize> =
        axes.iter().map(|axis| numbers(of("degree", axis))[0] as usize).collect();
    let knots = axes.iter().map(|axis| with_ends(&numbers(of("knots", axis)))).collect();
    let points: Vec<Vec<f64>> =
        entry["poles"].as_array().expect("poles").iter().map(numbers).collect();
    let weights = match &entry["weights"] {
        Value::Array(_) => numbers(&entry["weights"]),
        _ => vec![1.0; points.len()],
    };
    let poles: Vec<Vec<f64>> = points.iter().zip(weights).map(|(p, w)| pole(p, w)).collect();
    Patch::new(entry["key"].as_str().unwrap_or_default(), &degrees, knots, &poles)
}

/// The knots with the first and the last repeated once more: no pole depends on either.
fn with_ends(inner: &[f64]) -> Vec<f64> {
    let ends = [inner[0], inner[inner.len() - 1]];
    [&ends[..1], inner, &ends[1..]].concat()
}
