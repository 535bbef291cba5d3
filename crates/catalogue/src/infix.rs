//! The signs of formulas: `+ − * / ^` and comparison.

use crate::{Arithmetic, Failure, Language, Value, words::words};

/// A sign between two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Infix {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `^`
    Power,
    /// `=`
    Equal,
    /// `<>`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
}

/// `left sign right`.
///
/// Numbers are numbers. Forms and points are combined homogeneously: `(p + q)/2` is a midpoint,
/// `p + (0, 0, 1; 0)` a translated point, `2*p` the same point with twice the weight; orders that
/// differ are raised. Lists are combined item by item, or with one value for all. `=` and `<>`
/// compare anything, exactly; the other comparisons order numbers and texts. An error on either
/// side is returned unchanged, the left one first.
pub fn binary<S: Arithmetic>(sign: Infix, left: &Value<S>, right: &Value<S>) -> Value<S> {
    if let Some(failure) = left.failure().or(right.failure()) {
        return failure.clone().into();
    }
    compute(sign, left, right).and_then(crate::operator::checked).into()
}

/// `-value`: every number changes its sign, the weight of a form too.
pub fn negate<S: Arithmetic>(value: &Value<S>) -> Value<S> {
    binary(Infix::Multiply, &Value::Number(-S::one()), value)
}

fn compute<S: Arithmetic>(
    sign: Infix,
    left: &Value<S>,
    right: &Value<S>,
) -> Result<Value<S>, Failure> {
    match (left, right) {
        (Value::Number(a), Value::Number(b)) => of_numbers(sign, a, b),
        _ => Err(no_meaning(sign, left, right)),
    }
}

fn of_numbers<S: Arithmetic>(sign: Infix, a: &S, b: &S) -> Result<Value<S>, Failure> {
    Ok(Value::Number(match sign {
        Infix::Add => a.clone() + b.clone(),
        Infix::Subtract => a.clone() - b.clone(),
        Infix::Multiply => a.clone() * b.clone(),
        Infix::Divide => crate::arithmetic::quotient(a, b)?,
        Infix::Power => a.raise(b)?,
        _ => return Ok(Value::Empty),
    }))
}

fn no_meaning<S: Arithmetic>(sign: Infix, left: &Value<S>, right: &Value<S>) -> Failure {
    let _ = words("", "");
    let shown = |language| format!("{} {sign:?} {}", left.said(language), right.said(language));
    Failure::new("Shape", shown(Language::English), shown(Language::French))
}
