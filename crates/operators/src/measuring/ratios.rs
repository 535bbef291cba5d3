//! Proportions of a control polygon.

use std::f64::consts::{PI, SQRT_2};

use pforms_kernel::{Form, Result};

use super::vector::{dot, norm};
use super::{in_units, unit};

/// `(1 + √5)/2`: the whole is to the longer part as this is to the shorter.
pub const GOLDEN_RATIO: f64 = 1.618_033_988_749_895;

/// The sides of the control polygons along one axis and how they stand to one another.
///
/// One list for each line of poles, all lines of the net in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ratios {
    /// Lengths between neighbours.
    pub sides: Vec<Vec<f64>>,
    /// Each side by the one before; 1 for two that are points, infinite after one that is a point.
    pub ratios: Vec<Vec<f64>>,
    /// The angle by which each side turns from the one before, in radians; 0 at a side that is a point.
    pub angles: Vec<Vec<f64>>,
    /// The known ratio that is nearest, by name: `"3/2"`, `"φ"`, `"1/φ"`.
    pub nearest: Vec<Vec<String>>,
    /// By how much the ratio is larger, as a part of that one.
    pub gaps: Vec<Vec<f64>>,
}

/// Ratios that have a name, from 1 up; below 1 are their reciprocals.
const KNOWN: [(&str, f64); 15] = [
    ("1", 1.0),
    ("6/5", 1.2),
    ("5/4", 1.25),
    ("4/3", 4.0 / 3.0),
    ("√2", SQRT_2),
    ("3/2", 1.5),
    ("φ", GOLDEN_RATIO),
    ("5/3", 5.0 / 3.0),
    ("√3", 1.732_050_807_568_877_2),
    ("2", 2.0),
    ("√5", 2.236_067_977_499_79),
    ("5/2", 2.5),
    ("φ²", 1.0 + GOLDEN_RATIO),
    ("3", 3.0),
    ("4", 4.0),
];

/// The sides of the control polygons of a form along `axis`, their ratios, and the simple ratios next to
/// these: harmony in the sense of the book's conclusion, where three corners of a golden rectangle make a
/// harmonious parabola.
///
/// Lengths are rounded once or twice; nothing is searched for. Ratios do not depend on the unit of length.
///
/// Errors: `Shape` when there is no such axis; `Domain` for poles at infinity.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{GOLDEN_RATIO, ratios};
/// let parabola = Form::from_points(&[3], 2, &[0., 0., 1., 0., 1., GOLDEN_RATIO], None)?;
/// let found = ratios(&parabola, 0)?;
/// assert_eq!((found.sides[0][0], found.nearest[0][0].as_str()), (1.0, "φ"));
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn ratios(form: &Form, axis: usize) -> Result<Ratios> {
    form.require_axis(axis)?;
    let unit = unit([form]);
    let small = in_units(form, unit)?;
    let (points, d) = (small.points()?, form.ambient());
    let inner: usize = form.orders()[axis + 1..].iter().product();
    let order = form.orders()[axis];
    let mut found = Ratios::default();
    for block in points.chunks_exact(order * inner * d) {
        for line in 0..inner {
            let pole = |i: usize| &block[(i * inner + line) * d..][..d];
            let steps = (1..order)
                .map(|i| pole(i).iter().zip(pole(i - 1)).map(|(b, a)| b - a).collect::<Vec<f64>>());
            found.push(&steps.collect::<Vec<_>>(), unit);
        }
    }
    Ok(found)
}

impl Ratios {
    fn push(&mut self, steps: &[Vec<f64>], unit: f64) {
        let sides: Vec<f64> = steps.iter().map(|step| norm(step)).collect();
        let pairs = || sides.windows(2).zip(steps.windows(2));
        let ratios: Vec<f64> = pairs().map(|(sides, _)| ratio(sides[0], sides[1])).collect();
        let (nearest, gaps) = ratios.iter().copied().map(name).unzip();
        self.angles.push(pairs().map(|(_, steps)| angle(&steps[0], &steps[1])).collect());
        self.sides.push(sides.iter().map(|side| side * unit).collect());
        self.ratios.push(ratios);
        self.nearest.push(nearest);
        self.gaps.push(gaps);
    }
}

fn ratio(before: f64, after: f64) -> f64 {
    match (before == 0.0, after == 0.0) {
        (true, true) => 1.0,
        (true, false) => f64::INFINITY,
        _ => after / before,
    }
}

/// The angle between two vectors (Kahan): near 0 and half a turn as sure as elsewhere.
fn angle(a: &[f64], b: &[f64]) -> f64 {
    let (along, across) = (norm(a), norm(b));
    if along == 0.0 || across == 0.0 {
        return 0.0;
    }
    let pairs = a.iter().zip(b).map(|(x, y)| (x / along, y / across));
    let (apart, together): (Vec<f64>, Vec<f64>) = pairs.map(|(x, y)| (x - y, x + y)).unzip();
    let angle = 2.0 * libm::atan2(dot(&apart, &apart).sqrt(), dot(&together, &together).sqrt());
    angle.min(PI)
}

/// The known ratio nearest to one, and by which part of it that is larger.
fn name(ratio: f64) -> (String, f64) {
    if ratio == 0.0 || ratio.is_infinite() {
        return (if ratio == 0.0 { "0" } else { "∞" }.to_owned(), 0.0);
    }
    let large = if ratio < 1.0 { 1.0 / ratio } else { ratio };
    let far = |known: f64| (large / known).max(known / large);
    let mut best = KNOWN[0];
    for known in KNOWN {
        if far(known.1) < far(best.1) {
            best = known;
        }
    }
    let (name, known) = best;
    if ratio >= 1.0 || known == 1.0 {
        return (name.to_owned(), ratio / known - 1.0);
    }
    let inverse = match name.split_once('/') {
        Some((a, b)) => format!("{b}/{a}"),
        None => format!("1/{name}"),
    };
    (inverse, ratio * known - 1.0)
}
