//! Control points as text, as the examples of geomdl have them: `.cpt` and `.cptw`.
//!
//! The files hold no degrees and no knots. In a `.cptw` the weight is multiplied in.

use super::{Patch, numbers, pole};

/// How often a knot vector repeats its ends so that the form begins at its first pole: geomdl's own.
///
/// Degree and one zeros, even steps, degree and one ones.
fn clamped(order: usize, degree: usize) -> Vec<f64> {
    let pieces = order - degree;
    let inner = (1..pieces).map(|i| i as f64 / pieces as f64);
    let ends = |value: f64| std::iter::repeat_n(value, degree + 1);
    ends(0.0).chain(inner).chain(ends(1.0)).collect()
}

/// The poles of a file: a row for each line, poles of a row parted by semicolons.
///
/// Lines that do not begin with a number are captions.
pub fn poles(text: &str, weighted: bool) -> Vec<Vec<Vec<f64>>> {
    let caption = |line: &&str| !line.trim_start().starts_with('"') && !line.trim().is_empty();
    let read = |part: &str| {
        let list = numbers(part);
        if weighted { list } else { pole(&list, 1.0) }
    };
    text.lines().filter(caption).map(|line| line.split(';').map(read).collect()).collect()
}

/// A curve with the poles of a file, even knots by default.
pub fn curve(text: &str, weighted: bool, degree: usize, knots: Option<Vec<f64>>) -> Patch {
    let poles = poles(text, weighted).concat();
    let knots = knots.unwrap_or_else(|| clamped(poles.len(), degree));
    Patch::new("", &[degree], vec![knots], &poles)
}

/// A surface with the poles of a file, even knots by default; a line is a row of the second parameter.
pub fn surface(
    text: &str,
    weighted: bool,
    degrees: [usize; 2],
    knots: [Option<Vec<f64>>; 2],
) -> Patch {
    let rows = poles(text, weighted);
    let orders = [rows.len(), rows[0].len()];
    let [u, v] = knots;
    let u = u.unwrap_or_else(|| clamped(orders[0], degrees[0]));
    let v = v.unwrap_or_else(|| clamped(orders[1], degrees[1]));
    Patch::new("", &degrees, vec![u, v], &rows.concat())
}
