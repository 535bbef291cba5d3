//! Forms to JSON.

use std::fmt::Write;

use pforms_operators::{Knots, Shape};
use serde_json::Value;

use super::Number;
use super::read::VERSION;
use crate::Named;

/// Writes forms, one pole a line; reading gives back every number to the last bit.
pub fn write<S: Number>(forms: &[Named<S>]) -> Vec<u8> {
    let mut text = format!("{{\n  \"pforms\": {VERSION},\n  \"forms\": [");
    for (index, named) in forms.iter().enumerate() {
        text.push_str(if index == 0 { "\n    {\n" } else { ",\n    {\n" });
        if let Some(name) = &named.name {
            line(&mut text, "name", &Value::from(name.as_str()));
        }
        let form = named.net();
        line(&mut text, "orders", &Value::from(form.orders()));
        line(&mut text, "ambient", &Value::from(form.ambient()));
        if let Shape::Spline(spline) = &named.shape {
            line(&mut text, "degrees", &Value::from(spline.degrees()));
            let list = |knots: &Knots<S>| -> Vec<Value> {
                knots.as_slice().iter().map(S::to_json).collect()
            };
            line(&mut text, "knots", &spline.knots().iter().map(list).collect());
        }
        text.push_str("      \"poles\": [");
        for (index, pole) in form.homogeneous().chunks_exact(form.width()).enumerate() {
            let numbers: Vec<String> = pole.iter().map(|x| x.to_json().to_string()).collect();
            text.push_str(if index == 0 { "\n" } else { ",\n" });
            text.push_str("        [");
            text.push_str(&numbers.join(", "));
            text.push(']');
        }
        text.push_str("\n      ]\n    }");
    }
    text.push_str(if forms.is_empty() { "]\n}\n" } else { "\n  ]\n}\n" });
    text.into_bytes()
}

fn line(text: &mut String, key: &str, value: &Value) {
    let spaced = value.to_string().replace(',', ", ");
    let value = if value.is_array() { spaced } else { value.to_string() };
    // Writing to a string cannot fail.
    let _ = writeln!(text, "      \"{key}\": {value},");
}
