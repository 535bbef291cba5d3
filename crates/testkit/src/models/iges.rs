//! Rational B-spline curves (entity 126) and surfaces (entity 128) of an IGES file.
//!
//! Trimming, transformations and every other entity are passed over.

use std::collections::BTreeMap;

use super::{Patch, last_fastest, pole};

/// The splines of the file in the order of its directory, named by entity and number there.
pub fn read(text: &str) -> Vec<Patch> {
    let mut entities: BTreeMap<usize, String> = BTreeMap::new();
    for line in text.lines().filter(|line| line.get(72..73) == Some("P")) {
        let number = line[64..72].trim().parse().expect("a pointer into the directory");
        entities.entry(number).or_default().push_str(&line[..64]);
    }
    entities.iter().filter_map(|(number, record)| entity(*number, record)).collect()
}

fn entity(number: usize, record: &str) -> Option<Patch> {
    let record = record.split(';').next().unwrap_or_default();
    let axes = match record.split(',').next()?.trim() {
        "126" => 1,
        "128" => 2,
        _ => return None,
    };
    let mut fields = record.split(',').skip(1).map(|field| field.trim().replace('D', "E"));
    let mut take = |count: usize| -> Vec<f64> {
        let parsed = fields.by_ref().take(count).map(|field| field.parse().expect("a number"));
        parsed.collect()
    };
    let orders: Vec<usize> = take(axes).iter().map(|last| *last as usize + 1).collect();
    let degrees: Vec<usize> = take(axes).iter().map(|degree| *degree as usize).collect();
    // Planar, closed, polynomial, periodic: nothing that the rest does not say.
    take(if axes == 1 { 4 } else { 5 });
    let knots = orders.iter().zip(&degrees).map(|(order, degree)| take(order + degree + 1));
    let knots: Vec<Vec<f64>> = knots.collect();
    let count = orders.iter().product::<usize>();
    let weights = take(count);
    let points = take(3 * count);
    let poles: Vec<Vec<f64>> = points.chunks(3).zip(weights).map(|(p, w)| pole(p, w)).collect();
    let name = format!("{} {number}", if axes == 1 { 126 } else { 128 });
    Some(Patch::new(name, &degrees, knots, &last_fastest(&orders, &poles)))
}
