//! What an operator does, printed as the book prints it; and the tables behind it.

use pforms_kernel::{Error, Form, Kind, Rational, bernstein_row, pascal_row};
use pforms_operators as operators;

use super::{Outcome, PLAIN, T, list_of_numbers};
use crate::cost::require_readable;
use crate::operator::{Group, call};
use crate::words::words;
use crate::{Arguments, Arithmetic, Bound, Operator, Parameter, Takes, Value};

/// Above this degree a table of Bernstein polynomials answers nobody's question.
const DEGREE_CAP: f64 = 1000.0;

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "explain",
        english: &["EXPLAIN"],
        french: &["EXPLIQUER"],
        group: Group::Gestures,
        summary: words(
            "The exact coefficients of each resulting pole, as the book prints them.",
            "Les coefficients exacts de chaque pôle obtenu, tels que le livre les imprime.",
        ),
        help: words(
            "Runs the operator in exact arithmetic on forms of the given kinds. Other arguments of \
             the operator follow in their order: EXPLAIN(\"SUB\", \"pL4\", 0, 1/2).",
            "Exécute l'opérateur en arithmétique exacte sur des formes des genres donnés. Ses autres \
             arguments suivent dans l'ordre : EXPLIQUER(\"SOUSFORME\", \"pL4\", 0, 1/2).",
        ),
        parameters: &[
            Parameter::new(
                Takes::Operator,
                words("operator", "opérateur"),
                words("The operator's name.", "Le nom de l'opérateur."),
            ),
            Parameter::new(
                Takes::Any,
                words("kinds", "genres"),
                words(
                    "A kind such as \"pS33\" for each form; numbers stay numbers.",
                    "Un genre tel que \"pS33\" pour chaque forme ; les nombres restent des nombres.",
                ),
            )
            .variadic(),
        ],
        gives: Takes::Text,
        example: "=EXPLAIN(\"DIAG\", \"pS33\")",
        source: "book 13",
        see: &["diagonal", "pascal"],
        call: call!(explain),
        ..PLAIN
    },
    Operator {
        name: "bernstein",
        english: &["BERNSTEIN"],
        french: &["BERNSTEIN"],
        group: Group::Fundamental,
        summary: words(
            "The value of a Bernstein polynomial: the part of pole i in the point at t.",
            "La valeur d'un polynôme de Bernstein : la part du pôle i dans le point en t.",
        ),
        help: words(
            "C(n, i)·t^i·(1-t)^(n-i), for any t. The n + 1 polynomials of degree n sum to 1.",
            "C(n, i)·t^i·(1-t)^(n-i), pour tout t. Les n + 1 polynômes de degré n ont pour somme 1.",
        ),
        parameters: &[
            Parameter::new(Takes::Whole, words("n", "n"), words("The degree.", "Le degré."))
                .range(0.0, DEGREE_CAP),
            Parameter::new(
                Takes::Whole,
                words("i", "i"),
                words("Which one, 0 to n.", "Lequel, de 0 à n."),
            )
            .range(0.0, DEGREE_CAP),
            T,
        ],
        gives: Takes::Number,
        example: "=BERNSTEIN(3, 1, 1/2)",
        source: "course, Bernstein polynomials",
        see: &["pascal", "blossom"],
        call: call!(bernstein),
        ..PLAIN
    },
    Operator {
        name: "pascal",
        english: &["PASCAL"],
        french: &["PASCAL"],
        group: Group::Fundamental,
        summary: words("A row of Pascal's triangle.", "Une ligne du triangle de Pascal."),
        help: words(
            "C(n, 0), …, C(n, n): the weights of MI for n + 1 forms.",
            "C(n, 0), …, C(n, n) : les poids de MI pour n + 1 formes.",
        ),
        parameters: &[
            Parameter::new(Takes::Whole, words("n", "n"), words("The row.", "La ligne."))
                .range(0.0, DEGREE_CAP),
        ],
        gives: Takes::List,
        example: "=PASCAL(4)",
        source: "book 11",
        see: &["midpoint", "bernstein", "binomial"],
        call: call!(pascal),
        ..PLAIN
    },
];

fn explain<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let name = a.text(0)?;
    let operator = crate::find(&name).ok_or_else(|| crate::unknown(&name))?;
    let mut kinds = Vec::new();
    let mut template = Vec::new();
    for value in a.all(1) {
        if let Some(kind) = kind_of(value) {
            kinds.push(kind);
            template.push(None);
        } else {
            template.push(Some(exactly(value).ok_or_else(|| a.mistyped(1, value))?));
        }
    }
    require_readable(&kinds)?;
    let run = |forms: &[Form<Rational>]| {
        let mut forms = forms.iter().cloned();
        let fill = |slot: &Option<Value<Rational>>| {
            slot.clone().or_else(|| forms.next().map(Value::Form)).unwrap_or_default()
        };
        let arguments = Arguments::new(template.iter().map(fill).collect::<Vec<_>>());
        form_of(operator.call(arguments))
    };
    Ok(Value::Text(operators::explain(&kinds, run)?))
}

fn kind_of<S>(value: &Value<S>) -> Option<Kind> {
    match value {
        Value::Text(text) => text.parse().ok(),
        _ => None,
    }
}

/// The value in exact arithmetic; `None` for what has no place among an operator's options.
fn exactly<S: Arithmetic>(value: &Value<S>) -> Option<Value<Rational>> {
    Some(match value {
        Value::Number(x) => Value::Number(x.to_exact()),
        Value::Text(text) => Value::Text(text.clone()),
        Value::Boolean(value) => Value::Boolean(*value),
        Value::List(items) => Value::list(items.iter().map(exactly).collect::<Option<_>>()?),
        _ => return None,
    })
}

fn form_of(value: Value<Rational>) -> pforms_kernel::Result<Form<Rational>> {
    match value.settle() {
        Value::Form(form) => Ok(form),
        Value::Spline(pieces) => Ok(pieces.net().clone()),
        Value::Error(failure) => Err(failure.to_error()),
        other => Err(Error::domain(
            "operator",
            format!("an operator that gives {}", other.kind(crate::Language::English)),
            "an operator that gives a form",
        )),
    }
}

fn bernstein<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let row = bernstein_row(a.whole(0)?, &a.number(2)?);
    let value = row.get(a.whole(1)?).cloned().map(Value::Number);
    value.ok_or_else(|| {
        let expected = words("a whole number from 0 to n", "un nombre entier de 0 à n");
        a.refused(1, &a.value(1), expected)
    })
}

fn pascal<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(list_of_numbers(pascal_row(a.whole(0)?)))
}
