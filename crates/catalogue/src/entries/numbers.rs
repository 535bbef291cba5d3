//! Elementary functions.

use pforms_kernel::Rational;

use crate::operator::{Group, call};
use crate::words::words;
use crate::{Arithmetic, Bound, Elementary, Failure, Operator, Parameter, Takes, Value};

const X: Parameter =
    Parameter::new(Takes::Number, words("x", "x"), words("The number.", "Le nombre."));

pub(super) static ENTRIES: &[Operator] = &[Operator {
    name: "sqrt",
    english: &["SQRT"],
    french: &["RACINE"],
    group: Group::Numbers,
    summary: words("The square root of a number.", "La racine carrée d'un nombre."),
    help: words(
        "Exact mode knows the roots of squares.",
        "Le mode exact connaît les racines des carrés.",
    ),
    parameters: &[X],
    gives: Takes::Number,
    example: "=SQRT(1/4)",
    source: "",
    see: &[],
    takes_errors: false,
    call: call!(sqrt),
}];

fn sqrt<S: Arithmetic>(a: &Bound<S>) -> Result<Value<S>, Failure> {
    S::apply(Elementary::Sqrt, &a.number(0)?).map(Value::Number)
}
