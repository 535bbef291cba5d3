//! Splines through points.

use pforms_kernel::{Form, Rational};
use pforms_operators::{self as operators, Parameters, SplineEnds};

use super::Outcome;
use super::interpolating::lists_of;
use super::splining::{SPLINES, per_axis};
use crate::arithmetic::require_plain;
use crate::elementary::use_floating_mode;
use crate::operator::call;
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Elementary, Failure, Operator, Parameter, Takes, Value, Words};

const ENDS: &[Words] = &[
    words("natural", "naturels"),
    words("clamped", "tangents"),
    words("not-a-knot", "sans noeud"),
    words("periodic", "périodique"),
];

const PARAMETERS: &[Words] =
    &[words("chord", "corde"), words("uniform", "uniforme"), words("centripetal", "centripète")];

pub(super) static ENTRIES: &[Operator] = &[Operator {
    name: "interpolating_spline",
    english: &["SPLINE"],
    french: &["SPLINE"],
    summary: words(
        "A spline through points: the book's chains, or the smooth cubic.",
        "Une spline passant par des points : les chaînes du livre, ou la cubique lisse.",
    ),
    help: words(
        "The cubic is twice continuously differentiable; its ends are \"natural\", \"clamped\" with \
         tangents = [v, w], \"not-a-knot\" or \"periodic\". Degree 2, or a start, gives the chains of \
         the book: start is the pole before the first point, for degree 3 the two before it. circle = \
         TRUE makes arcs of the parabolas. The cubic chain multiplies errors by 3.73 from piece to \
         piece; the smooth cubic does not.",
        "La cubique est deux fois continûment dérivable ; ses bouts sont \"naturels\", \"tangents\" avec \
         tangentes = [v, w], \"sans noeud\" ou \"périodique\". Le degré 2, ou un départ, donne les \
         chaînes du livre : départ est le pôle d'avant le premier point, pour le degré 3 les deux \
         d'avant. cercle = VRAI fait des paraboles des arcs. La chaîne cubique multiplie les erreurs \
         par 3,73 d'un morceau à l'autre ; la cubique lisse non.",
    ),
    parameters: &[
        Parameter::new(
            Takes::Form,
            words("points", "points"),
            words("A row or a net of points.", "Une rangée ou un réseau de points."),
        ),
        Parameter::new(Takes::Whole, words("degree", "degré"), words("2 or 3.", "2 ou 3."))
            .range(2.0, 3.0)
            .or(Fallback::Ratio(3, 1)),
        Parameter::new(
            Takes::Form,
            words("start", "départ"),
            words(
                "The poles before the first point, for a chain.",
                "Les pôles d'avant le premier point, pour une chaîne.",
            ),
        )
        .or_absent(
            "the first point for degree 2, the smooth cubic for degree 3",
            "le premier point pour le degré 2, la cubique lisse pour le degré 3",
        ),
        Parameter::new(
            Takes::Any,
            words("ends", "bouts"),
            words("What the cubic does at its ends.", "Ce que fait la cubique à ses bouts."),
        )
        .choices(ENDS)
        .or(Fallback::Text("natural")),
        Parameter::new(
            Takes::Any,
            words("parameters", "paramètres"),
            words("Where on the cubic the points lie.", "À quels paramètres sont les points."),
        )
        .choices(PARAMETERS)
        .or(Fallback::Text("chord")),
        Parameter::new(
            Takes::Form,
            words("tangents", "tangentes"),
            words("The derivatives at both ends.", "Les dérivées aux deux bouts."),
        )
        .or_absent("none", "aucune"),
        Parameter::new(
            Takes::Boolean,
            words("circle", "cercle"),
            words("Arcs in place of parabolas.", "Des arcs au lieu de paraboles."),
        )
        .or(Fallback::Boolean(false)),
    ],
    example: "=SPLINE([(0, 0), (1, 1), (2, 0), (3, 1)], parameters=\"uniform\")",
    source: "book 342; The NURBS Book, 9.2",
    see: &["bspline", "interpolate", "continuity"],
    call: call!(interpolating_spline),
    ..SPLINES
}];

fn interpolating_spline<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let points = a.form(0)?;
    let start = if a.is_given(2) { Some(a.form(2)?) } else { None };
    let width = points.width();
    if a.whole(1)? == 2 {
        let factor =
            if a.boolean(6)? { S::apply(Elementary::Sqrt, &S::ratio(1, 2))? } else { S::one() };
        let start = start.unwrap_or_else(|| points.clone());
        let before = start.homogeneous().chunks(start.width()).next().unwrap_or_default();
        return Ok(operators::quadratic_chain(&points, before, &factor)?.into());
    }
    if let Some(start) = start {
        let poles: Vec<&[S]> = start.homogeneous().chunks(start.width()).collect();
        let [p, q] = poles[..] else {
            let expected = words("the two poles before the points", "les deux pôles d'avant");
            return Err(a.refused(2, &a.value(2), expected));
        };
        return Ok(operators::cubic_chain(&points, [p, q])?.into());
    }
    let clamped = || -> Result<SplineEnds<S>, Failure> {
        let tangents = a.form(5)?;
        let vectors: Vec<Vec<S>> = tangents.homogeneous().chunks(width).map(direction).collect();
        match <[Vec<S>; 2]>::try_from(vectors) {
            Ok([start, end]) if tangents.width() == width => Ok(SplineEnds::Clamped(start, end)),
            _ => Err(a.refused(5, &a.value(5), words("two vectors", "deux vecteurs"))),
        }
    };
    let end = |value: &Value<S>| match a.choice_of(3, value)? {
        "clamped" => clamped(),
        "not-a-knot" => Ok(SplineEnds::NotAKnot),
        "periodic" => Ok(SplineEnds::Periodic),
        _ => Ok(SplineEnds::Natural),
    };
    let ends = per_axis(a, 3, points.axes(), |_| true, end)?;
    let parameters = parameters(a, &points, &ends)?;
    Ok(operators::interpolating_spline(&points, &parameters, &ends)?.into())
}

/// A vector from a point or a direction: no weight of its own.
fn direction<S: Arithmetic>(pole: &[S]) -> Vec<S> {
    let mut vector = pole.to_vec();
    if let Some(weight) = vector.last_mut() {
        *weight = S::zero();
    }
    vector
}

fn parameters<S: Arithmetic>(
    a: &Bound<S>,
    points: &Form<S>,
    ends: &[SplineEnds<S>],
) -> Result<Vec<Vec<S>>, Failure> {
    let rule = match a.value(4) {
        Value::List(items) => return lists_of(a, 4, &items, points.axes()),
        _ => match a.choice(4)? {
            "uniform" => Parameters::Uniform,
            "centripetal" => Parameters::Centripetal,
            _ => Parameters::Chord,
        },
    };
    let periodic: Vec<bool> = ends.iter().map(|ends| *ends == SplineEnds::Periodic).collect();
    let rough = points.map_scalar(S::to_f64)?;
    let lists = operators::spline_parameters(&rough, &rule, &periodic)?;
    if rule == Parameters::Uniform {
        let even = |count: usize| {
            let last = count.saturating_sub(1).max(1) as i64;
            (0..count as i64).map(|i| S::ratio(i, last)).collect()
        };
        return Ok(lists.iter().map(|list| even(list.len())).collect());
    }
    if S::EXACT {
        let expected = words("\"uniform\" or a list in exact mode", "\"uniforme\" ou une liste");
        return Err(use_floating_mode(a.refused(4, &a.value(4), expected)));
    }
    require_plain(points.homogeneous())?;
    let number = |t: &f64| S::from_f64(*t).unwrap_or_else(S::zero);
    Ok(lists.iter().map(|list| list.iter().map(number).collect()).collect())
}
