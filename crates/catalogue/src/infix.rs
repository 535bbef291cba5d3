//! The signs of formulas: `+ − * / ^` and comparison.

use std::cmp::Ordering;

use pforms_kernel::Form;
use pforms_operators::{Spline, combine};

use crate::arithmetic::quotient;
use crate::cost::expanded;
use crate::{Arithmetic, Failure, Language, Value};

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

impl Infix {
    /// As it is written.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::Power => "^",
            Self::Equal => "=",
            Self::NotEqual => "<>",
            Self::Less => "<",
            Self::LessEqual => "<=",
            Self::Greater => ">",
            Self::GreaterEqual => ">=",
        }
    }
}

/// `left sign right`.
///
/// Numbers are numbers. Forms and points are combined homogeneously: `(p + q)/2` is a midpoint,
/// `p + (0, 0, 1; 0)` a translated point, `2*p` the same point with twice the weight; orders that
/// differ are raised. Lists are combined item by item, or with one value for all. `=` and `<>`
/// compare anything, exactly; the other comparisons order numbers and texts. An error on either
/// side is returned unchanged, the left one first.
///
/// ```
/// use pforms_catalogue::{Infix, Value, binary};
/// let [p, q]: [Value; 2] = [Value::point(&[0., 1.], None), Value::point(&[1., 2.], None)];
/// let middle = binary(Infix::Divide, &binary(Infix::Add, &p, &q), &Value::Number(2.0));
/// assert_eq!(middle.display(Default::default()), "(0.5, 1.5)");
/// ```
pub fn binary<S: Arithmetic>(sign: Infix, left: &Value<S>, right: &Value<S>) -> Value<S> {
    if let Some(failure) = left.failure().or(right.failure()) {
        return failure.clone().into();
    }
    compute(sign, left, right).and_then(crate::operator::checked).into()
}

/// `-value`: every number changes its sign, the weight of a form too, so a point stays where it
/// is and counts negatively in a sum.
pub fn negate<S: Arithmetic>(value: &Value<S>) -> Value<S> {
    binary(Infix::Multiply, &Value::Number(-S::one()), value)
}

type Outcome<S> = Result<Value<S>, Failure>;

fn compute<S: Arithmetic>(sign: Infix, left: &Value<S>, right: &Value<S>) -> Outcome<S> {
    match sign {
        Infix::Equal => Ok(Value::Boolean(same(left, right))),
        Infix::NotEqual => Ok(Value::Boolean(!same(left, right))),
        Infix::Less | Infix::LessEqual | Infix::Greater | Infix::GreaterEqual => {
            let order = order(left, right).ok_or_else(|| no_meaning(sign, left, right))?;
            Ok(Value::Boolean(match sign {
                Infix::Less => order.is_lt(),
                Infix::LessEqual => order.is_le(),
                Infix::Greater => order.is_gt(),
                _ => order.is_ge(),
            }))
        }
        _ => arithmetic(sign, left, right),
    }
}

fn same<S: Arithmetic>(left: &Value<S>, right: &Value<S>) -> bool {
    left == right || left.clone().settle() == right.clone().settle()
}

fn order<S: Arithmetic>(left: &Value<S>, right: &Value<S>) -> Option<Ordering> {
    match (left, right) {
        (Value::Number(a), Value::Number(b)) => a.partial_cmp(b),
        (Value::Text(a), Value::Text(b)) => Some(a.cmp(b)),
        _ => None,
    }
}

fn arithmetic<S: Arithmetic>(sign: Infix, left: &Value<S>, right: &Value<S>) -> Outcome<S> {
    match (left, right) {
        (Value::Number(a), Value::Number(b)) => of_numbers(sign, a, b).map(Value::Number),
        (Value::Immersed(lazy), other) => compute(sign, &Value::Form(expanded(lazy)?), other),
        (other, Value::Immersed(lazy)) => compute(sign, other, &Value::Form(expanded(lazy)?)),
        (Value::List(items), Value::Form(form)) if form.axes() > 0 && left.is_points() => {
            of_forms(sign, &crate::net::form_of_list(items)?, form, left, right)
        }
        (Value::Form(form), Value::List(items)) if form.axes() > 0 && right.is_points() => {
            of_forms(sign, form, &crate::net::form_of_list(items)?, left, right)
        }
        (Value::List(a), Value::List(b)) if left.is_points() && right.is_points() => {
            let (a, b) = (crate::net::form_of_list(a)?, crate::net::form_of_list(b)?);
            of_forms(sign, &a, &b, left, right)
        }
        (Value::List(a), Value::List(b)) if a.len() == b.len() => {
            let pairs = a.iter().zip(b);
            Ok(Value::list(pairs.map(|(a, b)| binary(sign, a, b)).collect()))
        }
        (Value::List(_), Value::List(_)) => Err(no_meaning(sign, left, right)),
        (Value::List(items), one) => {
            Ok(Value::list(items.iter().map(|item| binary(sign, item, one)).collect()))
        }
        (one, Value::List(items)) => {
            Ok(Value::list(items.iter().map(|item| binary(sign, one, item)).collect()))
        }
        (Value::Form(a), Value::Form(b)) => of_forms(sign, a, b, left, right),
        (Value::Form(form), Value::Number(k)) | (Value::Number(k), Value::Form(form)) => {
            let scaled = match (sign, left) {
                (Infix::Multiply, _) => combine(std::slice::from_ref(k), &[form])?,
                (Infix::Divide, Value::Form(_)) => divided(form, k)?,
                _ => return Err(no_meaning(sign, left, right)),
            };
            Ok(Value::Form(scaled))
        }
        (Value::Spline(pieces), other) if is_constant(other) => {
            let net = compute(sign, &Value::Form(pieces.net().clone()), other)?;
            in_pieces(net, pieces).ok_or_else(|| no_meaning(sign, left, right))
        }
        (other, Value::Spline(pieces)) if is_constant(other) => {
            let net = compute(sign, other, &Value::Form(pieces.net().clone()))?;
            in_pieces(net, pieces).ok_or_else(|| no_meaning(sign, left, right))
        }
        _ => Err(no_meaning(sign, left, right)),
    }
}

fn of_numbers<S: Arithmetic>(sign: Infix, a: &S, b: &S) -> Result<S, Failure> {
    Ok(match sign {
        Infix::Add => a.clone() + b.clone(),
        Infix::Subtract => a.clone() - b.clone(),
        Infix::Multiply => a.clone() * b.clone(),
        Infix::Divide => quotient(a, b)?,
        _ => a.raise(b)?,
    })
}

fn of_forms<S: Arithmetic>(
    sign: Infix,
    a: &Form<S>,
    b: &Form<S>,
    left: &Value<S>,
    right: &Value<S>,
) -> Outcome<S> {
    let factor = match sign {
        Infix::Add => S::one(),
        Infix::Subtract => -S::one(),
        _ => return Err(no_meaning(sign, left, right)),
    };
    Ok(Value::Form(combine(&[S::one(), factor], &[a, b])?))
}

fn divided<S: Arithmetic>(form: &Form<S>, k: &S) -> Result<Form<S>, Failure> {
    quotient(&S::one(), k)?;
    Ok(form.map_scalar(|x| x.clone() / k.clone())?)
}

/// The same at every parameter: a number or a point.
fn is_constant<S: Arithmetic>(value: &Value<S>) -> bool {
    match value {
        Value::Number(_) => true,
        Value::Form(form) => form.axes() == 0,
        _ => false,
    }
}

/// The pieces with another net of the same orders: what a number or a point does to all of them.
fn in_pieces<S: Arithmetic>(net: Value<S>, pieces: &Spline<S>) -> Option<Value<S>> {
    let Value::Form(net) = net else { return None };
    if net.orders() != pieces.net().orders() {
        return None;
    }
    let again = Spline::on(net, pieces.knots().to_vec());
    again.ok().map(Value::Spline)
}

fn no_meaning<S: Arithmetic>(sign: Infix, left: &Value<S>, right: &Value<S>) -> Failure {
    let shown =
        |language| format!("{} {} {}", left.said(language), sign.symbol(), right.said(language));
    let (en, fr) = (shown(Language::English), shown(Language::French));
    let error = pforms_kernel::Error::shape(sign.symbol(), &en, "values that go together");
    let french = format!("{} : reçu {en}, attendu des valeurs compatibles", sign.symbol());
    let failure = Failure::of(error, french.replace(&en, &fr));
    match (sign, left, right) {
        (Infix::Multiply, Value::Form(_), Value::Form(_)) => failure
            .with_hint("a form is multiplied by a number", "une forme se multiplie par un nombre"),
        (Infix::Add | Infix::Subtract, ..) => failure.with_hint(
            "a form moves by a direction such as (0, 0, 1; 0)",
            "une forme se déplace d'une direction telle que (0, 0, 1; 0)",
        ),
        _ => failure,
    }
}
