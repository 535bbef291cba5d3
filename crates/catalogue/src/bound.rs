//! Arguments that have found their parameters, read as what the operator needs.

use std::cell::Cell;

use pforms_kernel::{Error, Form};
use pforms_operators::Shape;

use crate::parameter::Fallback;
use crate::{Arithmetic, Failure, Language, Operator, Parameter, Takes, Value, Words};

/// The arguments of a call, one slot for each parameter. Readers convert, check the range the
/// catalogue states, and answer with an error that names the parameter.
#[doc(hidden)]
pub struct Bound<S> {
    operator: &'static Operator,
    slots: Vec<Vec<Value<S>>>,
    /// Which of them the operator has read.
    read: Vec<Cell<bool>>,
}

impl<S: Arithmetic> Bound<S> {
    pub(crate) fn new(operator: &'static Operator, slots: Vec<Vec<Value<S>>>) -> Self {
        let read = slots.iter().map(|_| Cell::new(false)).collect();
        Self { operator, slots, read }
    }

    /// Was the argument given? Asking that is not reading it.
    pub(crate) fn is_given(&self, index: usize) -> bool {
        !self.slots[index].is_empty()
    }

    /// The English name of a parameter.
    pub(crate) fn name(&self, index: usize) -> &'static str {
        self.parameter(index).name.en
    }

    /// Every value given for a parameter.
    pub(crate) fn all(&self, index: usize) -> &[Value<S>] {
        self.read[index].set(true);
        &self.slots[index]
    }

    /// The value given, or the default.
    pub(crate) fn value(&self, index: usize) -> Value<S> {
        if let Some(value) = self.all(index).first() {
            return value.clone();
        }
        match self.parameter(index).default {
            Fallback::Ratio(numerator, denominator) => {
                Value::Number(S::ratio(numerator, denominator))
            }
            Fallback::Text(text) => Value::Text(text.to_owned()),
            Fallback::Boolean(value) => Value::Boolean(value),
            Fallback::Required | Fallback::Absent(_) => Value::Empty,
        }
    }

    /// What a call gave and its operator never looked at is a mistake of the caller's, who believes
    /// that it counts: a tangent for natural ends, the order of a turn all the way round. FALSE asks
    /// for nothing, and what is exact keeps every accuracy.
    ///
    /// Errors: `Shape`, naming the first such argument.
    pub(crate) fn require_read(&self) -> Result<(), Failure> {
        let asks = |value: &Value<S>| !matches!(value, Value::Empty | Value::Boolean(false));
        let kept = |index: usize| matches!(self.name(index), "accuracy" | "tolerance");
        let unread = |index: &usize| {
            !self.read[*index].get() && !kept(*index) && self.slots[*index].iter().any(asks)
        };
        match (0..self.slots.len()).find(unread) {
            None => Ok(()),
            Some(index) => Err(self.idle(index)),
        }
    }

    /// The error for an argument that has no part in what the others ask for.
    pub(crate) fn idle(&self, index: usize) -> Failure {
        let en = "nothing: the other arguments leave it no part";
        let fr = "rien : les autres arguments ne lui laissent aucun rôle";
        self.explain(index, &self.value(index), shape, en, fr)
    }

    /// A form; a net of points becomes one, an immersed form is expanded.
    pub(crate) fn form(&self, index: usize) -> Result<Form<S>, Failure> {
        self.form_of(index, &self.value(index))
    }

    /// All forms of a parameter that takes several.
    pub(crate) fn forms(&self, index: usize) -> Result<Vec<Form<S>>, Failure> {
        self.all(index).iter().map(|value| self.form_of(index, value)).collect()
    }

    /// A form or a spline, for operators that take either.
    pub(crate) fn shape(&self, index: usize) -> Result<Shape<S>, Failure> {
        self.shape_of(index, &self.value(index))
    }

    /// All forms and splines of a parameter that takes several.
    pub(crate) fn shapes(&self, index: usize) -> Result<Vec<Shape<S>>, Failure> {
        self.all(index).iter().map(|value| self.shape_of(index, value)).collect()
    }

    pub(crate) fn shape_of(&self, index: usize, value: &Value<S>) -> Result<Shape<S>, Failure> {
        match value {
            Value::Spline(spline) => Ok(spline.clone().into()),
            other => Ok(self.form_of(index, other)?.into()),
        }
    }

    pub(crate) fn form_of(&self, index: usize, value: &Value<S>) -> Result<Form<S>, Failure> {
        match value {
            Value::Form(form) => Ok(form.clone()),
            Value::List(items) if !items.is_empty() => crate::net::form_of_list(items),
            Value::Immersed(lazy) => crate::cost::expanded(lazy),
            Value::Spline(_) => Err(self.no_form(index, value).with_hint(
                "NET(…) gives the poles of all pieces, PIECE(…) one of them",
                "RESEAU(…) donne les pôles de tous les morceaux, MORCEAU(…) l'un d'eux",
            )),
            Value::Number(_) => Err(self.no_form(index, value).with_hint(
                "a one-dimensional point is written (x,)",
                "un point à une dimension s'écrit (x,)",
            )),
            _ => Err(self.no_form(index, value)),
        }
    }

    /// A point: a form without axes.
    pub(crate) fn point(&self, index: usize) -> Result<Form<S>, Failure> {
        let value = self.value(index);
        match &value {
            Value::Form(form) if form.axes() == 0 => Ok(form.clone()),
            _ => Err(self.mistyped(index, &value)),
        }
    }

    /// A vector: the coordinates of a point or of a direction, or a list of numbers.
    pub(crate) fn vector(&self, index: usize) -> Result<Vec<S>, Failure> {
        match self.value(index) {
            Value::Form(form) if form.axes() == 0 => {
                let pole = form.homogeneous();
                let direction = pole[form.ambient()].is_zero();
                if direction { Ok(pole[..form.ambient()].to_vec()) } else { Ok(form.points()?) }
            }
            Value::List(items) => items.iter().map(|item| self.number_of(index, item)).collect(),
            other => Err(self.mistyped(index, &other)),
        }
    }

    /// A number within the stated range.
    pub(crate) fn number(&self, index: usize) -> Result<S, Failure> {
        self.number_of(index, &self.value(index))
    }

    pub(crate) fn number_of(&self, index: usize, value: &Value<S>) -> Result<S, Failure> {
        match value {
            Value::Number(x) => self.within_range(index, x).map(|()| x.clone()),
            _ => Err(self.mistyped(index, value)),
        }
    }

    /// A whole number, not negative and within the stated range.
    pub(crate) fn whole(&self, index: usize) -> Result<usize, Failure> {
        self.whole_of(index, &self.value(index))
    }

    pub(crate) fn whole_of(&self, index: usize, value: &Value<S>) -> Result<usize, Failure> {
        let number = self.number_of(index, value)?;
        match number.whole().and_then(|n| usize::try_from(n).ok()) {
            Some(n) => Ok(n),
            None => Err(self.refused(index, value, WHOLE)),
        }
    }

    /// Any whole number within the stated range.
    pub(crate) fn integer(&self, index: usize) -> Result<i64, Failure> {
        let value = self.value(index);
        let number = self.number_of(index, &value)?;
        number.whole().ok_or_else(|| self.refused(index, &value, WHOLE))
    }

    /// True or false.
    pub(crate) fn boolean(&self, index: usize) -> Result<bool, Failure> {
        match self.value(index) {
            Value::Boolean(value) => Ok(value),
            other => Err(self.mistyped(index, &other)),
        }
    }

    /// Text.
    pub(crate) fn text(&self, index: usize) -> Result<String, Failure> {
        match self.value(index) {
            Value::Text(text) => Ok(text),
            other => Err(self.mistyped(index, &other)),
        }
    }

    /// The English of the choice that was given in either language.
    pub(crate) fn choice(&self, index: usize) -> Result<&'static str, Failure> {
        self.choice_of(index, &self.value(index))
    }

    pub(crate) fn choice_of(
        &self,
        index: usize,
        value: &Value<S>,
    ) -> Result<&'static str, Failure> {
        let Value::Text(text) = value else { return Err(self.mistyped(index, value)) };
        let choices = self.parameter(index).choices;
        if let Some(choice) = choices.iter().find(|choice| choice.matches(text)) {
            return Ok(choice.en);
        }
        let list = |language: Language| {
            let quoted = choices.iter().map(|choice| format!("\"{}\"", choice.get(language)));
            quoted.collect::<Vec<_>>().join(", ")
        };
        let (en, fr) = (list(Language::English), list(Language::French));
        Err(self.explain(index, value, domain, &en, &fr))
    }

    /// A list.
    pub(crate) fn list(&self, index: usize) -> Result<Vec<Value<S>>, Failure> {
        match self.value(index) {
            Value::List(items) => Ok(items),
            other => Err(self.mistyped(index, &other)),
        }
    }

    /// One number for each of `axes`; a single number counts for all.
    pub(crate) fn numbers(&self, index: usize, axes: usize) -> Result<Vec<S>, Failure> {
        self.per_axis(index, axes, |value| self.number_of(index, value))
    }

    /// One whole number for each of `axes`; a single one counts for all.
    pub(crate) fn wholes(&self, index: usize, axes: usize) -> Result<Vec<usize>, Failure> {
        self.per_axis(index, axes, |value| self.whole_of(index, value))
    }

    fn per_axis<T: Clone>(
        &self,
        index: usize,
        axes: usize,
        read: impl Fn(&Value<S>) -> Result<T, Failure>,
    ) -> Result<Vec<T>, Failure> {
        let given = match self.all(index) {
            [Value::List(items)] => items.clone(),
            [] => vec![self.value(index)],
            values => values.to_vec(),
        };
        if let [single] = given.as_slice()
            && axes != 1
        {
            return Ok(vec![read(single)?; axes]);
        }
        if given.len() != axes {
            let (en, fr) = (format!("one, or {axes}"), format!("un, ou {axes}"));
            let list = Value::List(given);
            return Err(self.explain(index, &list, shape, &en, &fr));
        }
        given.iter().map(read).collect()
    }

    /// Every number given, lists taken apart.
    pub(crate) fn flat_numbers(&self, index: usize) -> Result<Vec<S>, Failure> {
        let mut numbers = Vec::new();
        for value in self.all(index) {
            self.flatten(index, value, &mut numbers)?;
        }
        Ok(numbers)
    }

    fn flatten(&self, index: usize, value: &Value<S>, into: &mut Vec<S>) -> Result<(), Failure> {
        match value {
            Value::List(items) => items.iter().try_for_each(|item| self.flatten(index, item, into)),
            Value::Empty => Ok(()),
            value => self.number_of(index, value).map(|x| into.push(x)),
        }
    }

    fn within_range(&self, index: usize, x: &S) -> Result<(), Failure> {
        let Some(range) = self.parameter(index).range else { return Ok(()) };
        if (range.least..=range.most).contains(&x.to_f64()) {
            return Ok(());
        }
        let (en, fr) = if range.most.is_finite() {
            (
                format!("a number from {} to {}", range.least, range.most),
                format!("un nombre de {} à {}", range.least, range.most),
            )
        } else {
            (
                format!("a number at least {}", range.least),
                format!("un nombre au moins égal à {}", range.least),
            )
        };
        Err(self.explain(index, &Value::Number(x.clone()), domain, &en, &fr))
    }

    /// The error for a value of the wrong kind.
    pub(crate) fn mistyped(&self, index: usize, value: &Value<S>) -> Failure {
        self.expected(index, value, self.parameter(index).takes)
    }

    fn expected(&self, index: usize, value: &Value<S>, takes: Takes) -> Failure {
        if let Value::Error(failure) = value {
            return failure.clone();
        }
        self.explain(index, value, shape, takes.words().en, takes.words().fr)
    }

    /// The error for a value that is no form, whatever else the parameter would take.
    fn no_form(&self, index: usize, value: &Value<S>) -> Failure {
        self.expected(index, value, Takes::Form)
    }

    /// The error for a value of the right kind that will not do.
    pub(crate) fn refused(&self, index: usize, value: &Value<S>, expected: Words) -> Failure {
        self.explain(index, value, domain, expected.en, expected.fr)
    }

    fn explain(
        &self,
        index: usize,
        value: &Value<S>,
        family: fn(&str, &str, &str) -> Error,
        en: &str,
        fr: &str,
    ) -> Failure {
        let name = self.parameter(index).name;
        let error = family(name.en, &value.said(Language::English), en);
        let received = value.said(Language::French);
        Failure::of(error, format!("{} : reçu {received}, attendu {fr}", name.fr))
    }

    fn parameter(&self, index: usize) -> &'static Parameter {
        &self.operator.parameters[index]
    }
}

const WHOLE: Words = Words { en: "a whole number from 0", fr: "un nombre entier à partir de 0" };

fn shape(argument: &str, received: &str, expected: &str) -> Error {
    Error::shape(argument, received, expected)
}

fn domain(argument: &str, received: &str, expected: &str) -> Error {
    Error::domain(argument, received, expected)
}
