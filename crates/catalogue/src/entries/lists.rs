//! Lists and records.

use pforms_kernel::{Error, Form, Rational};

use super::{Outcome, PLAIN, number};
use crate::operator::{Group, call};
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, LIST_CAP, Operator, Parameter, Takes, Value, Words};

const OF_LISTS: Operator = Operator { group: Group::Lists, gives: Takes::List, ..PLAIN };

const LIST: Parameter =
    Parameter::new(Takes::List, words("list", "liste"), words("The list.", "La liste."));

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "item",
        english: &["ITEM"],
        french: &["ELEMENT"],
        summary: words(
            "An item of a list, or an entry of a record.",
            "Un élément d'une liste, ou une entrée d'une fiche.",
        ),
        help: words(
            "Indices start at 0; negative ones count from the end. An entry of a record goes by its \
             name: ITEM(FRAME(f, 1/2), \"tangent\"). The items of a curve are its poles.",
            "Les indices commencent à 0 ; négatifs, ils comptent depuis la fin. Une entrée de fiche se \
             prend par son nom : ELEMENT(REPERE(f, 1/2), \"tangente\"). Les éléments d'une courbe sont \
             ses pôles.",
        ),
        parameters: &[
            Parameter { takes: Takes::Any, ..LIST },
            Parameter::new(
                Takes::Any,
                words("index", "indice"),
                words("A whole number, or a name.", "Un nombre entier, ou un nom."),
            ),
        ],
        gives: Takes::Any,
        example: "=ITEM([10, 20, 30], 1)",
        see: &["count", "pole"],
        call: call!(item),
        ..OF_LISTS
    },
    Operator {
        name: "count",
        english: &["COUNT"],
        french: &["NB", "NOMBRE"],
        summary: words("How many items a list has.", "Combien d'éléments a une liste."),
        help: words("Of a form, the number of its poles.", "D'une forme, le nombre de ses pôles."),
        parameters: &[Parameter { takes: Takes::Any, ..LIST }],
        gives: Takes::Number,
        example: "=COUNT([10, 20, 30])",
        see: &["item", "orders"],
        call: call!(count),
        ..OF_LISTS
    },
    Operator {
        name: "join",
        english: &["JOIN"],
        french: &["JOINT", "JOINDRE"],
        summary: words("One list after another.", "Une liste après l'autre."),
        help: words(
            "What is no list counts as a list of one.",
            "Ce qui n'est pas une liste en vaut une d'un seul élément.",
        ),
        parameters: &[Parameter::new(
            Takes::List,
            words("lists", "listes"),
            words("The lists.", "Les listes."),
        )
        .variadic()],
        example: "=JOIN([1, 2], [3])",
        see: &["sequence"],
        call: call!(join),
        ..OF_LISTS
    },
    Operator {
        name: "sequence",
        english: &["SEQUENCE"],
        french: &["SUITE"],
        summary: words("Numbers at equal steps.", "Des nombres à pas égaux."),
        help: words(
            "From first to last, both included; without a count the steps are 1.",
            "Du premier au dernier, compris ; sans nombre, le pas est 1.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Number,
                words("first", "premier"),
                words("The first number.", "Le premier nombre."),
            ),
            Parameter::new(
                Takes::Number,
                words("last", "dernier"),
                words("The last number.", "Le dernier nombre."),
            ),
            Parameter::new(
                Takes::Whole,
                words("count", "nombre"),
                words("How many numbers.", "Combien de nombres."),
            )
            .range(1.0, LIST_CAP as f64)
            .or_absent("steps of 1", "des pas de 1"),
        ],
        example: "=SEQUENCE(0, 1, 5)",
        see: &["partition"],
        call: call!(sequence),
        ..OF_LISTS
    },
];

fn item<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    match (a.value(0), a.value(1)) {
        (Value::List(items), Value::Number(_)) => Ok(items[position(a, items.len())?].clone()),
        (Value::Record(entries), Value::Text(name)) => entry(&entries, &name),
        (Value::Form(form), Value::Number(_)) if form.axes() > 0 => {
            let row = form.orders()[0];
            let index = position(a, row)?;
            let length = form.homogeneous().len() / row;
            let poles = form.homogeneous()[index * length..][..length].to_vec();
            Ok(Form::from_homogeneous(&form.orders()[1..], form.ambient(), poles)?.into())
        }
        (Value::List(_) | Value::Form(_) | Value::Record(_), index) => {
            let expected =
                words("an index, or the name of an entry", "un indice, ou le nom d'une entrée");
            Err(a.refused(1, &index, expected))
        }
        (other, _) => Err(a.refused(
            0,
            &other,
            words("a list, a form or a record", "une liste, une forme ou une fiche"),
        )),
    }
}

/// The entry of this name, in either language.
pub(super) fn entry<S: Arithmetic>(entries: &[(Words, Value<S>)], name: &str) -> Outcome<S> {
    let found = entries.iter().find(|(known, _)| known.matches(name));
    found.map(|(_, value)| value.clone()).ok_or_else(|| no_entry(entries, name))
}

/// The place of the index in a list of `length`, counted from the end when it is negative.
fn position<S: Arithmetic>(a: &Bound<S>, length: usize) -> Result<usize, Failure> {
    let index = a.integer(1)?;
    let place = if index < 0 { index.checked_add(length as i64) } else { Some(index) };
    match place.and_then(|place| usize::try_from(place).ok()) {
        Some(place) if place < length => Ok(place),
        _ => {
            let error = Error::shape(
                "index",
                index,
                format!("{} to {}", -(length as i64), length as i64 - 1),
            );
            let french = format!(
                "indice : reçu {index}, attendu de {} à {}",
                -(length as i64),
                length as i64 - 1
            );
            Err(Failure::of(error, french))
        }
    }
}

fn no_entry<S>(entries: &[(Words, Value<S>)], name: &str) -> Failure {
    let names = |pick: fn(&Words) -> &'static str| {
        entries.iter().map(|(known, _)| pick(known)).collect::<Vec<_>>().join(", ")
    };
    let error = Error::shape("entry", format!("“{name}”"), names(|known| known.en));
    Failure::of(error, format!("entrée : reçu « {name} », attendu {}", names(|known| known.fr)))
}

fn count<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(number(match a.value(0) {
        Value::List(items) => items.len(),
        Value::Form(form) => form.pole_count(),
        Value::Spline(pieces) => pieces.net().pole_count(),
        Value::Record(entries) => entries.len(),
        Value::Empty => 0,
        _ => 1,
    }))
}

fn join<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let mut all = Vec::new();
    for value in a.all(0) {
        match value {
            Value::List(items) => all.extend(items.iter().cloned()),
            Value::Empty => {}
            other => all.push(other.clone()),
        }
    }
    Ok(Value::list(all))
}

fn sequence<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let (first, last) = (a.number(0)?, a.number(1)?);
    if a.is_given(2) {
        let count = a.whole(2)? as i64;
        let steps = (count - 1).max(1);
        let at =
            |k: i64| S::ratio(steps - k, steps) * first.clone() + S::ratio(k, steps) * last.clone();
        return Ok(super::list_of_numbers((0..count).map(at)));
    }
    let length = (last.clone() - first.clone()).floor().to_f64();
    if length >= LIST_CAP as f64 {
        let error = Error::domain("last", last.write(), format!("fewer than {LIST_CAP} numbers"));
        let french =
            format!("dernier : reçu {}, attendu moins de {LIST_CAP} nombres", last.write());
        return Err(Failure::of(error, french));
    }
    let steps = 0..=(length.max(-1.0) as i64);
    Ok(super::list_of_numbers(steps.map(|k| first.clone() + S::from_integer(k))))
}
