//! NURBS data of the examples of `compas_nurbs`: JSON whose points have their weights multiplied in.

use serde_json::Value;

use super::Patch;
use crate::numbers;

/// The curve or surface of the document.
pub fn read(document: &Value) -> Patch {
    let degrees: Vec<usize> =
        numbers(&document["degree"]).iter().map(|degree| *degree as usize).collect();
    let knots = match (&document["knot_vector"], degrees.len()) {
        (vector, 1) => vec![numbers(vector)],
        (vectors, _) => vectors.as_array().expect("knot vectors").iter().map(numbers).collect(),
    };
    let points = numbers(&document["control_points"]);
    let weights = match &document["weights"] {
        Value::Null => vec![1.0; points.len() / 3],
        list => numbers(list),
    };
    assert_eq!(points.len(), 3 * weights.len(), "points in space");
    let poles: Vec<Vec<f64>> =
        points.chunks(3).zip(weights).map(|(point, w)| [point, &[w]].concat()).collect();
    Patch::new("", &degrees, knots, &poles)
}
