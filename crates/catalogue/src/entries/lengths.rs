//! Lengths of curves, and curves by their length.

use pforms_operators::{self as operators, ArcLength, Spline};

use super::splining::SPLINES;
use super::{Outcome, list_of_numbers, part};
use crate::operator::call;
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Bound, Failure, Operator, Parameter, Takes, Value, Words};

const CURVE: Parameter = Parameter::new(
    Takes::Form,
    words("curve", "courbe"),
    words("A curve, or a spline curve.", "Une courbe, ou une courbe spline."),
);

const ACCURACY: Parameter = Parameter::new(
    Takes::Number,
    words("accuracy", "précision"),
    words("Relative to the length.", "Relative à la longueur."),
)
.or(Fallback::Ratio(1, 1_000_000_000_000));

const PARTS: &[Words] = &[words("length", "longueur"), words("error", "écart")];

const CURVE_PARTS: &[Words] =
    &[words("curve", "courbe"), words("error", "écart"), words("length", "longueur")];

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "arc_length",
        english: &["LENGTH"],
        french: &["LONGUEUR"],
        summary: words("The length of a curve.", "La longueur d'une courbe."),
        help: words(
            "Gauss with 16 points on windows where the speed is shown to be analytic; the error is \
             bounded, part = \"error\" gives the bound. a and b: from one parameter to another; beyond \
             the window the curve goes on.",
            "Gauss à 16 points sur des fenêtres où la vitesse est prouvée analytique ; l'erreur est \
             majorée, partie = \"écart\" donne le majorant. a et b : d'un paramètre à un autre ; au-delà \
             de la fenêtre la courbe continue.",
        ),
        parameters: &[
            CURVE,
            Parameter::new(
                Takes::Number,
                words("a", "a"),
                words("Where to begin.", "Où commencer."),
            )
            .or_absent("the start of the curve", "le début de la courbe")
            .unit("parameter", "paramètre"),
            Parameter::new(Takes::Number, words("b", "b"), words("Where to end.", "Où finir."))
                .or_absent("the end of the curve", "la fin de la courbe")
                .unit("parameter", "paramètre"),
            ACCURACY,
            part("length", PARTS),
        ],
        gives: Takes::Number,
        example: "=LENGTH([(0, 0), (1, 2), (2, 0)])",
        source: "course 3",
        see: &["by_arc_length", "parameter_at_length"],
        call: call!(floating arc_length),
        ..SPLINES
    },
    Operator {
        name: "parameter_at_length",
        english: &["ATLENGTH"],
        french: &["ALONGUEUR"],
        summary: words(
            "The parameter to which a curve has gone a given length.",
            "Le paramètre où une courbe a parcouru une longueur donnée.",
        ),
        help: words(
            "From its start. Lengths may be a list: parameters of points at equal distances along it.",
            "Depuis son début. Les longueurs peuvent être une liste : les paramètres de points \
             également espacés le long de la courbe.",
        ),
        parameters: &[
            CURVE,
            Parameter::new(
                Takes::Any,
                words("length", "longueur"),
                words("A length, or a list of lengths.", "Une longueur, ou une liste."),
            ),
            ACCURACY,
        ],
        gives: Takes::Number,
        example: "=ATLENGTH([(0, 0), (1, 2), (2, 0)], 1)",
        source: "course 3",
        see: &["arc_length", "by_arc_length"],
        call: call!(floating parameter_at_length),
        ..SPLINES
    },
    Operator {
        name: "by_arc_length",
        english: &["BYLENGTH"],
        french: &["PARLONGUEUR"],
        summary: words(
            "The same curve run through at unit speed, as a spline of its length.",
            "La même courbe parcourue à vitesse 1, en spline de sa longueur.",
        ),
        help: words(
            "Every point stays on the curve; the speed differs from 1 by no more than accuracy. Its \
             degree is 5 times that of the curve. part = \"error\" tells by how much the speed differs.",
            "Chaque point reste sur la courbe ; la vitesse ne s'écarte pas de 1 de plus que la \
             précision. Son degré est 5 fois celui de la courbe. partie = \"écart\" dit de combien.",
        ),
        parameters: &[
            CURVE,
            Parameter::new(
                Takes::Number,
                words("accuracy", "précision"),
                words("By how much the speed may differ.", "De combien la vitesse peut différer."),
            )
            .or(Fallback::Ratio(1, 1_000_000_000)),
            part("curve", CURVE_PARTS),
        ],
        example: "=BYLENGTH([(0, 0), (1, 2), (2, 0)], 1/1000)",
        source: "course 3",
        see: &["arc_length", "parameter_at_length"],
        call: call!(floating by_arc_length),
        ..SPLINES
    },
];

fn arc_length(a: &Bound<f64>) -> Outcome<f64> {
    let curve = a.shape(0)?.into_spline();
    let accuracy = a.number(3)?;
    let wanted = a.choice(4)?;
    let Some(part) = part_of(a, curve)? else { return Ok(Value::Number(0.0)) };
    let measured = ArcLength::new(part, accuracy)?;
    let value = if wanted == "error" { measured.error() } else { measured.length() };
    Ok(Value::Number(value))
}

/// The curve from `a` to `b`, in either direction; `None` when they are the same.
fn part_of(a: &Bound<f64>, curve: Spline) -> Result<Option<Spline>, Failure> {
    if !a.is_given(1) && !a.is_given(2) || curve.axes() != 1 {
        return Ok(Some(curve));
    }
    let (start, end) = curve.window(0)?;
    let from = if a.is_given(1) { a.number(1)? } else { start };
    let to = if a.is_given(2) { a.number(2)? } else { end };
    if from == to {
        return Ok(None);
    }
    Ok(Some(curve.restrict(0, &from.min(to), &from.max(to))?))
}

fn parameter_at_length(a: &Bound<f64>) -> Outcome<f64> {
    let measured = ArcLength::new(a.shape(0)?, a.number(2)?)?;
    match a.value(1) {
        Value::List(_) => {
            let lengths = a.flat_numbers(1)?.into_iter();
            let found = lengths.map(|length| measured.parameter(length));
            Ok(list_of_numbers(found.collect::<Result<Vec<_>, _>>()?))
        }
        other => Ok(Value::Number(measured.parameter(a.number_of(1, &other)?)?)),
    }
}

fn by_arc_length(a: &Bound<f64>) -> Outcome<f64> {
    let wanted = a.choice(2)?;
    let even = operators::by_arc_length(a.shape(0)?, a.number(1)?)?;
    Ok(match wanted {
        "error" => Value::Number(even.error),
        "length" => Value::Number(even.length),
        _ => even.spline.into(),
    })
}
