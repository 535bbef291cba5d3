//! Real models as other programs write them, read into plain nets, degrees and knots.
//!
//! These readers understand what the files in `cases/models` contain, and stop at anything else:
//! they serve tests, not users.

pub mod bembel;
pub mod compas;
pub mod geomdl;
pub mod gismo;
pub mod ibra;
pub mod iges;
pub mod mfem;
mod mfem_elements;
mod mfem_mesh;
pub mod plain;

use std::path::Path;

use pforms_kernel::Form;

/// A tensor-product spline as a file gives it: nothing is checked but the number of poles.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    /// Its name or number in the file.
    pub name: String,
    /// The homogeneous poles, the last parameter fastest.
    pub net: Form,
    /// A degree for each parameter.
    pub degrees: Vec<usize>,
    /// All knots along each parameter: as many as poles, and a degree and one more.
    pub knots: Vec<Vec<f64>>,
}

impl Patch {
    /// A patch from homogeneous poles, the last parameter fastest.
    fn new(
        name: impl Into<String>,
        degrees: &[usize],
        knots: Vec<Vec<f64>>,
        poles: &[Vec<f64>],
    ) -> Self {
        let ambient = poles.first().expect("a pole").len() - 1;
        // A curve has the poles it has, even where its knots ask for another number of them.
        let orders = match knots.as_slice() {
            [_] => vec![poles.len()],
            many => many.iter().zip(degrees).map(|(list, d)| list.len() - d - 1).collect(),
        };
        let net = Form::from_homogeneous(&orders, ambient, poles.concat()).expect("a regular net");
        Self { name: name.into(), net, degrees: degrees.to_vec(), knots }
    }
}

/// The text of a file in `cases/models`.
pub fn text(file: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/models");
    std::fs::read_to_string(root.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// A JSON document in `cases/models`.
pub fn document(file: &str) -> serde_json::Value {
    serde_json::from_str(&text(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// A point and its weight, multiplied in: a pole.
fn pole(point: &[f64], weight: f64) -> Vec<f64> {
    point.iter().map(|x| x * weight).chain([weight]).collect()
}

/// Knots of one piece on [0, 1].
fn bezier_knots(degree: usize) -> Vec<f64> {
    [vec![0.0; degree + 1], vec![1.0; degree + 1]].concat()
}

/// All numbers in a text, whatever else separates them.
fn numbers(text: &str) -> Vec<f64> {
    let words = text.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty());
    words.map(|word| word.parse().unwrap_or_else(|_| panic!("{word:?} is no number"))).collect()
}

/// The list that ran through its first parameter fastest, the last one fastest.
fn last_fastest<T: Clone>(orders: &[usize], list: &[T]) -> Vec<T> {
    let count = orders.iter().product::<usize>();
    assert_eq!(list.len(), count, "poles of orders {orders:?}");
    let place = |mut flat: usize| {
        let mut there = 0;
        let mut stride = count;
        for &order in orders.iter().rev() {
            stride /= order;
            there += flat % order * stride;
            flat /= order;
        }
        there
    };
    (0..count).map(|flat| list[place(flat)].clone()).collect()
}

#[cfg(test)]
mod tests {
    use super::last_fastest;

    #[test]
    fn indices_are_turned_round() {
        // The entry says its own index.
        let mut first_fastest = Vec::new();
        for k in 0..4 {
            for j in 0..3 {
                first_fastest.extend((0..2).map(|i| (i, j, k)));
            }
        }
        let turned = last_fastest(&[2, 3, 4], &first_fastest);
        assert!(turned.is_sorted());
        assert_eq!(turned.len(), 24);
    }
}
