//! Conditions and truth.

use pforms_kernel::Rational;

use super::{Outcome, PLAIN};
use crate::operator::{Group, call};
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value};

const CONDITION: Operator = Operator { group: Group::Lists, gives: Takes::Boolean, ..PLAIN };

const TRUTHS: Parameter = Parameter::new(
    Takes::Boolean,
    words("conditions", "conditions"),
    words("Truths, lists of truths, ranges.", "Des vérités, des listes, des plages."),
)
.variadic();

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "if",
        english: &["IF"],
        french: &["SI"],
        summary: words(
            "One value or another, as a condition says.",
            "Une valeur ou une autre, selon une condition.",
        ),
        help: words(
            "An error in the value that is not chosen does no harm.",
            "Une erreur dans la valeur qui n'est pas choisie ne nuit pas.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Boolean,
                words("condition", "condition"),
                words("What decides.", "Ce qui décide."),
            ),
            Parameter::new(
                Takes::Any,
                words("then", "alors"),
                words("The value when it is true.", "La valeur si elle est vraie."),
            ),
            Parameter::new(
                Takes::Any,
                words("else", "sinon"),
                words("The value when it is false.", "La valeur si elle est fausse."),
            )
            .or_absent("nothing", "rien"),
        ],
        gives: Takes::Any,
        example: "=IF(1 < 2, \"yes\", \"no\")",
        see: &["iferror", "and"],
        takes_errors: true,
        call: call!(either),
        ..CONDITION
    },
    Operator {
        name: "iferror",
        english: &["IFERROR"],
        french: &["SIERREUR"],
        summary: words(
            "A value, or another one where it is an error.",
            "Une valeur, ou une autre si c'est une erreur.",
        ),
        help: words(
            "Every other operator passes an error on.",
            "Tout autre opérateur transmet une erreur.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Any,
                words("value", "valeur"),
                words("What is wanted.", "Ce qui est voulu."),
            ),
            Parameter::new(
                Takes::Any,
                words("otherwise", "sinon"),
                words("What stands in for an error.", "Ce qui remplace une erreur."),
            ),
        ],
        gives: Takes::Any,
        example: "=IFERROR(1/0, 0)",
        see: &["if"],
        takes_errors: true,
        call: call!(iferror),
        ..CONDITION
    },
    Operator {
        name: "and",
        english: &["AND"],
        french: &["ET"],
        summary: words("Are all conditions true?", "Toutes les conditions sont-elles vraies ?"),
        help: words("", ""),
        parameters: &[TRUTHS],
        example: "=AND(1 < 2, 2 < 3)",
        see: &["or", "not"],
        call: call!(and),
        ..CONDITION
    },
    Operator {
        name: "or",
        english: &["OR"],
        french: &["OU"],
        summary: words("Is one of the conditions true?", "L'une des conditions est-elle vraie ?"),
        help: words("", ""),
        parameters: &[TRUTHS],
        example: "=OR(1 > 2, 2 < 3)",
        see: &["and", "not"],
        call: call!(or),
        ..CONDITION
    },
    Operator {
        name: "not",
        english: &["NOT"],
        french: &["NON"],
        summary: words("True for false, false for true.", "Vrai pour faux, faux pour vrai."),
        help: words("", ""),
        parameters: &[Parameter { variadic: false, ..TRUTHS }],
        example: "=NOT(1 > 2)",
        see: &["and", "or"],
        call: call!(not),
        ..CONDITION
    },
];

fn either<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let condition = a.value(0);
    if condition.is_error() {
        return Ok(condition);
    }
    let chosen = if a.boolean(0)? { 1 } else { 2 };
    Ok(a.value(chosen))
}

fn iferror<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let value = a.value(0);
    Ok(if value.is_error() { a.value(1) } else { value })
}

fn and<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(Value::Boolean(truths(a)?.into_iter().all(|truth| truth)))
}

fn or<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(Value::Boolean(truths(a)?.into_iter().any(|truth| truth)))
}

fn not<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(Value::Boolean(!a.boolean(0)?))
}

fn truths<S: Arithmetic>(a: &Bound<S>) -> Result<Vec<bool>, Failure> {
    let mut truths = Vec::new();
    for value in a.all(0) {
        match value {
            Value::Boolean(truth) => truths.push(*truth),
            Value::Empty => {}
            other => return Err(a.mistyped(0, other)),
        }
    }
    Ok(truths)
}
