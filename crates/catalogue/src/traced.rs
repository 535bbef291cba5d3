//! Traced mode: floating numbers that remember what they come from, for derivatives.

use pforms_kernel::{Error, Form, Rational, Scalar, Traced};
use pforms_operators::{Immersed, Poles};

use crate::arithmetic::no_power;
use crate::operator::{Call, Routine};
use crate::{Arguments, Arithmetic, Elementary, Failure, Language, Operator, Value};

impl Arithmetic for Traced {
    fn read(text: &str) -> Result<Self, Failure> {
        f64::read(text).map(Self::constant)
    }

    fn write(&self) -> String {
        self.value().write()
    }

    fn json(&self) -> serde_json::Value {
        self.value().json()
    }

    fn apply(function: Elementary, x: &Self) -> Result<Self, Failure> {
        let value = f64::apply(function, &x.value())?;
        Self::function(value, &[(function.slope(x.value()), x)]).checked()
    }

    fn raise(&self, exponent: &Self) -> Result<Self, Failure> {
        let (x, y) = (self.value(), exponent.value());
        let value = x.raise(&y)?;
        let along = if y == 0.0 { 0.0 } else { y * libm::pow(x, y - 1.0) };
        let mut partial = vec![(along, self)];
        if !exponent.is_constant() {
            partial.push((value * libm::log(x), exponent));
        }
        let smooth =
            partial.iter().all(|(slope, number)| slope.is_finite() || number.is_constant());
        if smooth { Ok(Self::function(value, &partial)) } else { Err(no_power(&x, &y)) }
    }

    fn angle(y: &Self, x: &Self) -> Result<Self, Failure> {
        let (a, b) = (y.value(), x.value());
        let square = a * a + b * b;
        Self::function(f64::angle(&a, &b)?, &[(b / square, y), (-a / square, x)]).checked()
    }

    fn pi() -> Result<Self, Failure> {
        f64::pi().map(Self::constant)
    }

    fn floor(&self) -> Self {
        Self::constant(f64::floor(self.value()))
    }

    /// A number that moves counts nothing.
    fn whole(&self) -> Option<i64> {
        if self.is_constant() { self.value().whole() } else { None }
    }

    fn plain(&self) -> Result<f64, Failure> {
        if self.is_constant() {
            return Ok(self.value());
        }
        let error = Error::domain("source", "a number whose derivative is lost here", "another");
        Err(Failure::of(
            error,
            "source : reçu un nombre dont la dérivée se perd ici, attendu un autre",
        ))
    }

    fn to_exact(&self) -> Rational {
        self.value().to_exact()
    }

    fn bits(&self) -> f64 {
        0.0
    }

    fn check(&self) -> Result<(), Failure> {
        self.value().check()
    }

    fn routine(call: &Call) -> Option<Routine<Self>> {
        call.traced
    }

    /// What moves nothing is computed without traces.
    fn without_routine(operator: &'static Operator, arguments: &Arguments<Self>) -> Value<Self> {
        match arguments.map(plain) {
            Some(arguments) => traced(&operator.call(arguments)),
            None => no_derivative().within(operator).into(),
        }
    }
}

fn no_derivative() -> Failure {
    let error = Error::domain("source", "a cell this depends on", "one it does not depend on");
    let french = "source : reçu une cellule dont ceci dépend, attendu une dont il ne dépend pas";
    Failure::of(error, french).with_hint(
        "this operator measures or approximates: it does not hand derivatives on",
        "cet opérateur mesure ou approche : il ne transmet pas les dérivées",
    )
}

/// The same values with sources for numbers, and how many these are: of a number itself, of a form or
/// spline the coordinates and the weight of each pole, of a list those of its items.
///
/// Errors: `Shape` for a value that holds no numbers.
pub fn sources(values: &[&Value]) -> Result<(Vec<Value<Traced>>, usize), Failure> {
    let mut count = 0;
    let seeded = values.iter().map(|value| seed(value, &mut count)).collect::<Result<_, _>>()?;
    Ok((seeded, count))
}

fn seed(value: &Value, count: &mut usize) -> Result<Value<Traced>, Failure> {
    let mut source = |x: f64| {
        *count += 1;
        Traced::source(x, *count - 1)
    };
    Ok(match value {
        Value::Number(x) => Value::Number(source(*x)),
        Value::Form(form) => Value::Form(seed_poles(form, source)?),
        Value::Spline(spline) => {
            let net = seed_poles(spline.net(), source)?;
            let convert = |x: &f64| Traced::constant(*x);
            Value::Spline(spline.map_scalar(convert)?.with_net(net)?)
        }
        Value::Immersed(lazy) => seed(&Value::Form(lazy.expand()?), count)?,
        Value::List(items) => {
            Value::List(items.iter().map(|item| seed(item, count)).collect::<Result<_, _>>()?)
        }
        Value::Error(failure) => return Err(failure.clone()),
        other => return Err(no_numbers("source", other)),
    })
}

/// Poles whose coordinates and weights are sources; a direction has those of its vector.
fn seed_poles(form: &Form, mut source: impl FnMut(f64) -> Traced) -> Result<Form<Traced>, Failure> {
    let mut poles = Vec::with_capacity(form.homogeneous().len());
    for pole in form.homogeneous().chunks_exact(form.width()) {
        let (numbers, w) = (&pole[..form.ambient()], pole[form.ambient()]);
        let scale = if w == 0.0 { 1.0 } else { w };
        let coordinates: Vec<Traced> = numbers.iter().map(|x| source(x / scale)).collect();
        let weight = source(w);
        for (x, number) in coordinates.iter().zip(numbers) {
            let partial: &[_] =
                if w == 0.0 { &[(1.0, x)] } else { &[(w, x), (x.value(), &weight)] };
            poles.push(Traced::function(*number, partial));
        }
        poles.push(weight);
    }
    Ok(Form::from_homogeneous(form.orders(), form.ambient(), poles)?)
}

/// The numbers of a value, those that [`sources`] would give it.
///
/// Errors: `Shape` for a value that holds no numbers, the failure in it if it is one.
pub fn numbers(value: &Value<Traced>) -> Result<Vec<Traced>, Failure> {
    Ok(match value {
        Value::Number(x) => vec![x.clone()],
        Value::Form(form) => pole_numbers(form),
        Value::Spline(spline) => pole_numbers(spline.net()),
        Value::Immersed(lazy) => pole_numbers(&lazy.expand()?),
        Value::List(items) => {
            let lists: Vec<Vec<Traced>> = items.iter().map(numbers).collect::<Result<_, _>>()?;
            lists.concat()
        }
        Value::Error(failure) => return Err(failure.clone()),
        other => return Err(no_numbers("result", other)),
    })
}

fn pole_numbers(form: &Form<Traced>) -> Vec<Traced> {
    let mut found = Vec::with_capacity(form.homogeneous().len());
    for pole in form.homogeneous().chunks_exact(form.width()) {
        let (numbers, w) = (&pole[..form.ambient()], &pole[form.ambient()]);
        let coordinate =
            |x: &Traced| if w.value() == 0.0 { x.clone() } else { x.clone() / w.clone() };
        found.extend(numbers.iter().map(coordinate));
        found.push(w.clone());
    }
    found
}

fn no_numbers<S: Arithmetic>(argument: &str, value: &Value<S>) -> Failure {
    let (en, fr) = (value.kind(Language::English), value.kind(Language::French));
    let error = Error::shape(argument, en, "numbers, points, forms or lists of these");
    let french = if argument == "source" { "source" } else { "résultat" };
    let french =
        format!("{french} : reçu {fr}, attendu des nombres, points, formes ou leurs listes");
    Failure::of(error, french)
}

/// The same value, with numbers that do not move.
pub fn traced(value: &Value) -> Value<Traced> {
    value.map_scalar(&|x| Some(Traced::constant(*x))).unwrap_or_default()
}

/// The value, if none of its numbers moves.
fn plain(value: &Value<Traced>) -> Option<Value> {
    value.map_scalar(&|x| x.is_constant().then(|| x.value()))
}

impl<S: Arithmetic> Value<S> {
    /// The same value over another scalar; `None` when a number has none there.
    pub fn map_scalar<T: Arithmetic>(
        &self,
        convert: &impl Fn(&S) -> Option<T>,
    ) -> Option<Value<T>> {
        Some(match self {
            Self::Empty => Value::Empty,
            Self::Number(x) => Value::Number(convert(x)?),
            Self::Boolean(value) => Value::Boolean(*value),
            Self::Text(text) => Value::Text(text.clone()),
            Self::Form(form) => Value::Form(mapped(form, convert)?),
            Self::Spline(spline) => {
                let known = spline.net().homogeneous().iter().all(|x| convert(x).is_some())
                    && spline
                        .knots()
                        .iter()
                        .flat_map(pforms_operators::Knots::as_slice)
                        .all(|x| convert(x).is_some());
                let or_zero = |x: &S| convert(x).unwrap_or_else(T::zero);
                Value::Spline(known.then(|| spline.map_scalar(or_zero).ok()).flatten()?)
            }
            Self::Immersed(lazy) => {
                let (inner, host) = (mapped(lazy.inner(), convert)?, mapped(lazy.host(), convert)?);
                Value::Immersed(Immersed::new(inner, host).ok()?)
            }
            Self::Mesh(mesh) => Value::Mesh(mesh.clone()),
            Self::List(items) => Value::List(
                items.iter().map(|item| item.map_scalar(convert)).collect::<Option<_>>()?,
            ),
            Self::Record(entries) => {
                let entry = |(name, value): &(_, Self)| Some((*name, value.map_scalar(convert)?));
                Value::Record(entries.iter().map(entry).collect::<Option<_>>()?)
            }
            Self::Error(failure) => Value::Error(failure.clone()),
        })
    }
}

fn mapped<S: Scalar, T: Scalar>(
    form: &Form<S>,
    convert: &impl Fn(&S) -> Option<T>,
) -> Option<Form<T>> {
    let poles: Option<Vec<T>> = form.homogeneous().iter().map(convert).collect();
    Form::from_homogeneous(form.orders(), form.ambient(), poles?).ok()
}
