//! Patches of BEMBEL (`.dat`, "nurbs mesh v.2.1") and Newell's `.bpt`.

use super::{Patch, bezier_knots, last_fastest, numbers};

/// The patches of a `.dat` file: degrees, counts, two knot vectors, and rows of `x·w`, `y·w`, `z·w`
/// and `w`, the first parameter fastest.
pub fn read(text: &str) -> Vec<Patch> {
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().starts_with('#')).collect();
    let patches = lines.split(|line| line.starts_with("PATCH"));
    patches.skip(1).enumerate().map(|(index, lines)| patch(index, lines)).collect()
}

fn patch(index: usize, lines: &[&str]) -> Patch {
    let rows: Vec<Vec<f64>> =
        lines.iter().map(|line| numbers(line)).filter(|row| !row.is_empty()).collect();
    let [degrees, orders, u, v, coordinates @ ..] = rows.as_slice() else {
        panic!("patch {index} is cut short")
    };
    let whole = |row: &[f64]| row.iter().map(|x| *x as usize).collect::<Vec<usize>>();
    let poles: Vec<Vec<f64>> = (0..coordinates[0].len())
        .map(|pole| coordinates.iter().map(|row| row[pole]).collect())
        .collect();
    let poles = last_fastest(&whole(orders), &poles);
    Patch::new(index.to_string(), &whole(degrees), vec![u.clone(), v.clone()], &poles)
}

/// The patches of a `.bpt` file: two degrees and the points of each, the second parameter fastest.
pub fn read_bpt(text: &str) -> Vec<Patch> {
    let list = numbers(text);
    let (count, mut rest) = (list[0] as usize, &list[1..]);
    let mut patches = Vec::new();
    for index in 0..count {
        let degrees = [rest[0] as usize, rest[1] as usize];
        let (points, after) = rest[2..].split_at((degrees[0] + 1) * (degrees[1] + 1) * 3);
        let poles: Vec<Vec<f64>> = points.chunks(3).map(|point| super::pole(point, 1.0)).collect();
        let knots = degrees.map(bezier_knots).to_vec();
        patches.push(Patch::new(index.to_string(), &degrees, knots, &poles));
        rest = after;
    }
    assert!(rest.is_empty(), "{} numbers after {count} patches", rest.len());
    patches
}
