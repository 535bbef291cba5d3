//! Proportions: the ratios of a control polygon, and the golden one.

use pforms_kernel::Traced;
use pforms_operators as operators;

use super::lists::entry;
use super::{AXIS, FORM, Outcome, PART, PLAIN, list_of_numbers};
use crate::operator::{Call, Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Operator, Parameter, Takes, Value};

pub(super) static ENTRIES: &[Operator] = &[RATIOS, GOLDEN];

const RATIOS: Operator = Operator {
    name: "ratios",
    english: &["RATIOS"],
    french: &["RAPPORTS"],
    group: Group::Inside,
    summary: words(
        "The sides of a control polygon and their ratios.",
        "Les côtés d'un polygone de contrôle et leurs rapports.",
    ),
    help: words(
        "A record of sides, ratios (each side by the one before), angles in radians, nearest (the known \
         ratio next to each: 1, 6/5, 5/4, 4/3, √2, 3/2, φ, 5/3, √3, 2, √5, 5/2, φ², 3, 4, or one by \
         it) and gaps. Of a surface, a list for each line along the axis. part = \"nearest\" takes one entry.",
        "Une fiche : côtés, rapports (de chaque côté au précédent), angles en radians, proches (le rapport \
         connu le plus proche : 1, 6/5, 5/4, 4/3, √2, 3/2, φ, 5/3, √3, 2, √5, 5/2, φ², 3, 4, ou \
         l'inverse) et écarts. D'une surface, une liste par ligne suivant l'axe. partie = \"proches\" en \
         prend une.",
    ),
    parameters: &[FORM, AXIS.or(Fallback::Ratio(0, 1)), PART],
    gives: Takes::Record,
    example: "=RATIOS([(0, 0), (2, 0), (2, 3)])",
    source: "book, conclusion 4",
    see: &["golden", "project"],
    call: call!(floating ratios),
    ..PLAIN
};

const GOLDEN: Operator = Operator {
    name: "golden",
    english: &["GOLDEN"],
    french: &["DOR"],
    group: Group::Inside,
    summary: words(
        "Between two points or forms, in the golden ratio.",
        "Entre deux points ou formes, dans le rapport d'or.",
    ),
    help: words(
        "The point that divides the way from the first to the second so that the whole is to the longer \
         part, which comes first, as that is to the shorter. Of forms, pole by pole.",
        "Le point qui partage le chemin du premier au second de sorte que le tout soit à la plus longue \
         partie, qui vient d'abord, ce qu'elle est à la plus courte. Pour des formes, pôle à pôle.",
    ),
    parameters: &[
        Parameter::new(
            Takes::Form,
            words("from", "de"),
            words("Where the longer part begins.", "Où commence la plus longue partie."),
        ),
        Parameter::new(
            Takes::Form,
            words("to", "à"),
            words("Where the shorter part ends.", "Où finit la plus courte partie."),
        ),
    ],
    example: "=GOLDEN((0, 0), (1, 0))",
    source: "book, conclusion 4; Euclid VI, 30",
    see: &["ratios", "midpoint"],
    call: Call { floating: golden::<f64>, exact: None, traced: Some(golden::<Traced>) },
    ..PLAIN
};

fn ratios(a: &Bound<f64>) -> Outcome<f64> {
    let form = a.form(0)?;
    let found = operators::ratios(&form, a.whole(1)?)?;
    // After a side that is a point no ratio is a number.
    let number = |x: f64| if x.is_finite() { Value::Number(x) } else { Value::Empty };
    let numbers = |lines: &[Vec<f64>]| {
        listed(form.axes(), lines, |line| Value::list(line.iter().copied().map(number).collect()))
    };
    let texts = |line: &Vec<String>| Value::list(line.iter().cloned().map(Value::Text).collect());
    let entries = vec![
        (
            words("sides", "côtés"),
            listed(form.axes(), &found.sides, |side| list_of_numbers(side.iter().copied())),
        ),
        (words("ratios", "rapports"), numbers(&found.ratios)),
        (words("angles", "angles"), numbers(&found.angles)),
        (words("nearest", "proches"), listed(form.axes(), &found.nearest, texts)),
        (words("gaps", "écarts"), numbers(&found.gaps)),
    ];
    if a.is_given(2) { entry(&entries, &a.text(2)?) } else { Ok(Value::Record(entries)) }
}

/// The line of a curve, or a list of lines.
fn listed<T>(axes: usize, lines: &[T], value: impl Fn(&T) -> Value<f64>) -> Value<f64> {
    match lines {
        [line] if axes == 1 => value(line),
        lines => Value::list(lines.iter().map(value).collect()),
    }
}

fn golden<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(Value::from(operators::golden(&a.shape(0)?, &a.shape(1)?)?))
}
