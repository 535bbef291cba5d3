//! Derivatives of any cell in any other.

use pforms_kernel::Error;

use super::{Outcome, PLAIN};
use crate::operator::{Group, call};
use crate::words::words;
use crate::{Bound, Failure, Language, Operator, Parameter, Takes};

pub(super) static ENTRIES: &[Operator] = &[Operator {
    name: "sensitivities",
    english: &["D", "SENSITIVITIES"],
    french: &["D", "SENSIBILITES"],
    group: Group::Inside,
    summary: words(
        "The exact derivatives of a result in the numbers of a cell, through all cells between.",
        "Les dérivées exactes d'un résultat par rapport aux nombres d'une cellule, à travers toutes \
         les cellules qui les séparent.",
    ),
    help: words(
        "The result is any formula; the source is a cell, a name or a range. The numbers of a form are \
         the coordinates and the weight of each pole, in order. A list for each number of the result, \
         with the derivative in each number of the source; of a single number no list is made. \
         Operators that measure or approximate do not hand derivatives on: they are an error when they \
         stand between.",
        "Le résultat est une formule quelconque ; la source une cellule, un nom ou une plage. Les nombres \
         d'une forme sont les coordonnées et le poids de chaque pôle, dans l'ordre. Une liste par nombre \
         du résultat, avec la dérivée par rapport à chaque nombre de la source ; un nombre seul n'en \
         fait pas. Les opérateurs qui mesurent ou approchent ne transmettent pas les dérivées : c'est \
         une erreur quand il y en a entre les deux.",
    ),
    parameters: &[
        Parameter::new(
            Takes::Any,
            words("result", "résultat"),
            words("What is differentiated.", "Ce que l'on dérive."),
        ),
        Parameter::new(
            Takes::Any,
            words("source", "source"),
            words("The cell or range that moves.", "La cellule ou la plage qui bouge."),
        ),
    ],
    gives: Takes::List,
    example: "=D(MI(A1, A2), A1)",
    source: "catalogue 7; Griewank and Walther 2008",
    see: &["explain", "derivative"],
    call: call!(floating sensitivities),
    ..PLAIN
}];

/// Only a sheet knows what lies between two cells.
fn sensitivities(a: &Bound<f64>) -> Outcome<f64> {
    let source = a.value(1);
    let (en, fr) = (source.kind(Language::English), source.kind(Language::French));
    let error = Error::shape("source", format!("a {en}"), "a cell, a name or a range");
    let french = format!("source : reçu {fr}, attendu une cellule, un nom ou une plage");
    Err(Failure::of(error, french))
}
