//! The signs of formulas: `+ − * / ^` and comparison.

use std::cmp::Ordering;

use pforms_kernel::Form;
use pforms_operators::{Poles, Shape, combine, combine_shapes, multiply};

use crate::arithmetic::quotient;
use crate::cost::{expanded, require_product};
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
/// differ are raised, and splines brought to common knots. A form in one dimension is a function and
/// multiplies another form value by value. Lists are combined item by item, or with one value for all. `=` and `<>`
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
        (Value::List(items), other) if left.is_points() && is_extended(other) => {
            compute(sign, &crate::net::form_of_list(items)?.into(), other)
        }
        (other, Value::List(items)) if right.is_points() && is_extended(other) => {
            compute(sign, other, &crate::net::form_of_list(items)?.into())
        }
        (Value::List(a), Value::List(b)) if left.is_points() && right.is_points() => {
            let (a, b) = (crate::net::form_of_list(a)?, crate::net::form_of_list(b)?);
            of_shapes(sign, &a.into(), &b.into()).ok_or_else(|| no_meaning(sign, left, right))?
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
        (one, Value::Number(k)) | (Value::Number(k), one) => {
            let shape = shape_of(one).ok_or_else(|| no_meaning(sign, left, right))?;
            let net = match (sign, right) {
                (Infix::Multiply, _) => combine(std::slice::from_ref(k), &[shape.net()])?,
                (Infix::Divide, Value::Number(_)) => divided(shape.net(), k)?,
                _ => return Err(no_meaning(sign, left, right)),
            };
            Ok(shape.with_net(net)?.into())
        }
        (a, b) => {
            let (Some(a), Some(b)) = (shape_of(a), shape_of(b)) else {
                return Err(no_meaning(sign, left, right));
            };
            of_shapes(sign, &a, &b).ok_or_else(|| no_meaning(sign, left, right))?
        }
    }
}

/// A form or a spline.
fn shape_of<S: Arithmetic>(value: &Value<S>) -> Option<Shape<S>> {
    match value {
        Value::Form(form) => Some(form.clone().into()),
        Value::Spline(spline) => Some(spline.clone().into()),
        _ => None,
    }
}

/// A form with axes or a spline: what makes a form of a list of points beside it.
fn is_extended<S: Arithmetic>(value: &Value<S>) -> bool {
    matches!(value, Value::Spline(_)) || matches!(value, Value::Form(form) if form.axes() > 0)
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

/// `a + b`, `a − b`, and `a · b` where one is a function; `None` for signs that mean nothing here.
fn of_shapes<S: Arithmetic>(sign: Infix, a: &Shape<S>, b: &Shape<S>) -> Option<Outcome<S>> {
    let factor = match (sign, a, b) {
        (Infix::Add, ..) => S::one(),
        (Infix::Subtract, ..) => -S::one(),
        (Infix::Multiply, Shape::Form(f), Shape::Form(g))
            if f.ambient() == 1 || g.ambient() == 1 =>
        {
            return Some(product(f, g));
        }
        _ => return None,
    };
    let sum = combine_shapes(&[S::one(), factor], &[a.clone(), b.clone()], false);
    Some(sum.map(Value::from).map_err(Failure::from))
}

fn product<S: Arithmetic>(f: &Form<S>, g: &Form<S>) -> Outcome<S> {
    require_product(f, g)?;
    Ok(multiply(f, g)?.into())
}

fn divided<S: Arithmetic>(form: &Form<S>, k: &S) -> Result<Form<S>, Failure> {
    quotient(&S::one(), k)?;
    Ok(form.map_scalar(|x| x.clone() / k.clone())?)
}

fn no_meaning<S: Arithmetic>(sign: Infix, left: &Value<S>, right: &Value<S>) -> Failure {
    let shown =
        |language| format!("{} {} {}", left.said(language), sign.symbol(), right.said(language));
    let (en, fr) = (shown(Language::English), shown(Language::French));
    let error = pforms_kernel::Error::shape(sign.symbol(), &en, "values that go together");
    let french = format!("{} : reçu {en}, attendu des valeurs compatibles", sign.symbol());
    let failure = Failure::of(error, french.replace(&en, &fr));
    match (sign, left, right) {
        (Infix::Multiply, Value::Form(_), Value::Form(_)) => failure.with_hint(
            "a form is multiplied by a number, or by a form of 1D",
            "une forme se multiplie par un nombre, ou par une forme à une dimension",
        ),
        (Infix::Add | Infix::Subtract, ..) => failure.with_hint(
            "a form moves by a direction such as (0, 0, 1; 0)",
            "une forme se déplace d'une direction telle que (0, 0, 1; 0)",
        ),
        _ => failure,
    }
}
