//! Values known in closed form, as `cases/truth` keeps them.

use std::path::Path;

use pforms_kernel::Form;
use serde_json::Value;

use crate::numbers;

/// An item of `cases/truth/closed-forms.json`.
#[derive(Clone, Debug)]
pub struct Truth {
    /// Its name.
    pub id: String,
    /// The values by their names, decimal strings.
    pub values: Value,
    /// What they are the values of, where it is a form.
    pub form: Option<Form>,
    /// Otherwise the numbers it is made of.
    pub input: Value,
}

impl Truth {
    /// A value, rounded to `f64`.
    pub fn value(&self, name: &str) -> f64 {
        let text = self.values[name].as_str().unwrap_or_else(|| panic!("{}: {name}", self.id));
        text.parse().unwrap_or_else(|_| panic!("{}: {text}", self.id))
    }

    /// Its form.
    pub fn form(&self) -> Form {
        self.form.clone().unwrap_or_else(|| panic!("{} has no form", self.id))
    }
}

/// All items.
pub fn truths() -> Vec<Truth> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/truth");
    let text = std::fs::read_to_string(root.join("closed-forms.json")).expect("closed forms");
    let document: Value = serde_json::from_str(&text).expect("JSON");
    let items = document["items"].as_array().expect("items").iter();
    items
        .map(|item| Truth {
            id: item["id"].as_str().expect("an id").to_owned(),
            values: item["values"].clone(),
            form: item.get("form").map(form),
            input: item["input"].clone(),
        })
        .collect()
}

/// The item of this name.
pub fn truth(id: &str) -> Truth {
    truths().into_iter().find(|truth| truth.id == id).unwrap_or_else(|| panic!("{id}"))
}

fn form(value: &Value) -> Form {
    let orders: Vec<usize> = numbers(&value["degrees"]).iter().map(|d| *d as usize + 1).collect();
    let points = numbers(&value["points"]);
    let weights = value.get("weights").map(numbers);
    let ambient = value["points"][0].as_array().expect("a point").len();
    Form::from_points(&orders, ambient, &points, weights.as_deref()).expect("a regular form")
}
