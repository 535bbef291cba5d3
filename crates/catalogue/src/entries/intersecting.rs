//! Where forms meet.

use pforms_operators::{self as operators, ContactKind, Intersections, Overlap, Poles};

use super::lists::entry;
use super::{Outcome, PART, PLAIN, list_of_numbers};
use crate::cost::require_points;
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Bound, Operator, Parameter, Takes, Value, Words};

pub(super) static ENTRIES: &[Operator] = &[Operator {
    name: "intersect",
    english: &["INTERSECT"],
    french: &["INTERSECTION"],
    group: Group::Inside,
    summary: words(
        "Where two curves, a curve and a surface, or two surfaces meet.",
        "Où se rencontrent deux courbes, une courbe et une surface, ou deux surfaces.",
    ),
    help: words(
        "A record: points; first, second: their parameters in the two forms; kinds: crossing, tangent or \
         touch; orders: how many crossings fall together; gaps; overlaps: arcs in common; curves, of two \
         surfaces; complete: is that surely all? part = \"points\" takes one entry.",
        "Une fiche : points ; premiers, seconds : leurs paramètres dans les deux formes ; genres : \
         croisement, tangence ou effleurement ; ordres : combien de croisements s'y confondent ; écarts ; \
         communs : arcs partagés ; courbes, de deux surfaces ; complet : est-ce sûrement tout ? partie = \
         \"points\" prend une entrée.",
    ),
    parameters: &[
        Parameter::new(
            Takes::Form,
            words("first", "première"),
            words("A curve or a surface.", "Une courbe ou une surface."),
        ),
        Parameter::new(Takes::Form, words("second", "seconde"), words("Another.", "Une autre.")),
        PART,
        Parameter::new(
            Takes::Number,
            words("accuracy", "précision"),
            words(
                "In sizes of the forms: what is nearer and does not meet is a touch.",
                "En tailles des formes : ce qui est plus proche sans se rencontrer s'effleure.",
            ),
        )
        .range(0.0, 1.0)
        .or(Fallback::Ratio(1, 100_000_000_000_000)),
        Parameter::new(
            Takes::Form,
            words("host", "hôte"),
            words(
                "What the two are immersed in: they are curves in its parameters.",
                "Où les deux sont immergées : ce sont des courbes dans ses paramètres.",
            ),
        )
        .or_absent("none", "aucun"),
    ],
    gives: Takes::Record,
    example: "=INTERSECT([(-1, 1), (0, -1), (1, 1)], [(-1, 1/4), (1, 1/4)])",
    source: "catalogue 7; book 36 and 2234, remark 1; Sederberg and Nishita 1990",
    see: &["project", "immerse", "item"],
    call: call!(floating intersect),
    ..PLAIN
}];

/// Work of one pair of pieces, in evaluations, about.
const EVALUATIONS: usize = 1 << 10;

fn intersect(a: &Bound<f64>) -> Outcome<f64> {
    let (first, second) = (a.shape(0)?, a.shape(1)?);
    for shape in [&first, &second] {
        require_points(shape.net(), EVALUATIONS, 0.0)?;
    }
    let accuracy = a.number(3)?;
    let found = if a.is_given(4) {
        operators::intersect_inside(&a.shape(4)?, &first, &second, accuracy)?
    } else {
        operators::intersect(&first, &second, accuracy)?
    };
    let entries = entries(&found);
    if a.is_given(2) { entry(&entries, &a.text(2)?) } else { Ok(Value::Record(entries)) }
}

/// A list with one value for each contact.
fn each(found: &Intersections, value: impl Fn(&operators::Contact) -> Value) -> Value {
    Value::list(found.contacts.iter().map(value).collect())
}

fn entries(found: &Intersections) -> Vec<(Words, Value)> {
    let curves = found.branches.iter().map(|branch| branch.curve.clone().into());
    vec![
        (words("points", "points"), each(found, |c| Value::point(&c.point, None))),
        (words("first", "premiers"), each(found, |c| parameters(&c.first))),
        (words("second", "seconds"), each(found, |c| parameters(&c.second))),
        (words("kinds", "genres"), each(found, |c| Value::Text(kind(c.kind).to_owned()))),
        (words("orders", "ordres"), each(found, |c| Value::Number(c.order as f64))),
        (words("gaps", "écarts"), each(found, |c| Value::Number(c.gap))),
        (words("overlaps", "communs"), Value::list(found.overlaps.iter().map(shared).collect())),
        (words("curves", "courbes"), Value::list(curves.collect())),
        (words("complete", "complet"), Value::Boolean(found.complete)),
    ]
}

/// The name, the same in both languages as all texts that are values.
fn kind(kind: ContactKind) -> &'static str {
    kind.name()
}

/// A number for a curve, a list for a surface.
fn parameters(list: &[f64]) -> Value {
    match list {
        [t] => Value::Number(*t),
        _ => list_of_numbers(list.iter().copied()),
    }
}

/// From and to in the first form, from and to in the second.
fn shared(overlap: &Overlap) -> Value {
    let ends = |pair: &[Vec<f64>; 2]| Value::list(pair.iter().map(|t| parameters(t)).collect());
    Value::list(vec![ends(&overlap.first), ends(&overlap.second)])
}
