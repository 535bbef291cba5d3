//! XML of G+Smo, as that library and splinepy write it.
//!
//! A geometry is a `TensorBSpline` or `TensorNurbs` of any number of parameters: knots by axis,
//! weights, and euclidean coefficients whose first index runs fastest. Numbers stand as text or as
//! the bytes of little-endian `f64` in base64.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use roxmltree::{Document, Node};

use super::{Patch, last_fastest, numbers, pole};

/// Every geometry in the document, in order; named by its `id` where it has one.
///
/// Patches of a `MultiPatch` are geometries of the document themselves; other blocks are passed over.
pub fn read(text: &str) -> Vec<Patch> {
    // Some files have a remark before the declaration, which XML does not allow.
    let start = text.find("<?xml").and_then(|at| Some(at + text[at..].find("?>")? + 2));
    let document = Document::parse(&text[start.unwrap_or(0)..]).expect("well-formed XML");
    document.descendants().filter(|node| node.has_tag_name("Geometry")).map(geometry).collect()
}

fn geometry(node: Node<'_, '_>) -> Patch {
    let (mut degrees, mut knots) = (Vec::new(), Vec::new());
    for vector in node.descendants().filter(|node| node.has_tag_name("KnotVector")) {
        let degree = vector.attribute("degree").expect("a degree");
        degrees.push(degree.parse().expect("a whole number"));
        knots.push(values(vector));
    }
    let orders: Vec<usize> = knots.iter().zip(&degrees).map(|(k, d)| k.len() - d - 1).collect();
    let coefficients = find(node, "coefs").expect("coefficients");
    let width: usize = coefficients.attribute("geoDim").expect("geoDim").parse().expect("a number");
    let points = values(coefficients);
    let count = points.len() / width;
    let weights = find(node, "weights").map_or_else(|| vec![1.0; count], values);
    assert_eq!(weights.len(), count, "a weight for each coefficient");
    let poles: Vec<Vec<f64>> =
        points.chunks(width).zip(weights).map(|(point, weight)| pole(point, weight)).collect();
    let poles = if orders.len() == 1 { poles } else { last_fastest(&orders, &poles) };
    Patch::new(node.attribute("id").unwrap_or_default(), &degrees, knots, &poles)
}

fn find<'a, 'input>(node: Node<'a, 'input>, name: &str) -> Option<Node<'a, 'input>> {
    node.descendants().find(|node| node.has_tag_name(name))
}

/// The numbers of an element, in the writing it declares.
fn values(node: Node<'_, '_>) -> Vec<f64> {
    let text = node.text().unwrap_or_default();
    match node.attribute("format") {
        None | Some("ASCII") => numbers(text),
        Some("B64Float64") => {
            let bytes = STANDARD.decode(text.trim()).expect("base64");
            let (words, rest) = bytes.as_chunks::<8>();
            assert!(rest.is_empty(), "whole numbers of 8 bytes");
            words.iter().map(|word| f64::from_le_bytes(*word)).collect()
        }
        Some(other) => panic!("numbers written as {other}"),
    }
}
