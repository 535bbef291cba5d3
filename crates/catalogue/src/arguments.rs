//! The arguments of a call, and how they find their parameters.

use pforms_kernel::Error;

use crate::catalogue::nearest;
use crate::{Arithmetic, Bound, Failure, Language, Operator, Parameter, Takes, Value};

/// The arguments of a call, as a formula gives them.
///
/// ```
/// use pforms_catalogue::{Arguments, Value, find};
/// let arguments = Arguments::new([Value::Number(4.0)]);
/// assert_eq!(find("racine").unwrap().call(arguments).display(Default::default()), "2");
/// ```
#[derive(Clone, Debug, Default)]
pub struct Arguments<S = f64> {
    positional: Vec<Positional<S>>,
    named: Vec<(String, Value<S>)>,
}

#[derive(Clone, Debug)]
struct Positional<S> {
    value: Value<S>,
    range: bool,
}

impl<S: Arithmetic> Arguments<S> {
    /// Arguments in order.
    pub fn new(values: impl IntoIterator<Item = Value<S>>) -> Self {
        let positional =
            values.into_iter().map(|value| Positional { value, range: false }).collect();
        Self { positional, named: Vec::new() }
    }

    /// Adds an argument.
    pub fn push(&mut self, value: Value<S>) {
        self.positional.push(Positional { value, range: false });
    }

    /// Adds a range of cells: one argument, or as many as there are cells for a parameter that
    /// takes several. A range of several rows gives its rows as lists. Empty cells are left out.
    pub fn push_range(&mut self, cells: Vec<Value<S>>) {
        let filled = cells.into_iter().filter(|value| !matches!(value, Value::Empty)).collect();
        self.positional.push(Positional { value: Value::list(filled), range: true });
    }

    /// Adds an argument `name = value`.
    pub fn push_named(&mut self, name: impl Into<String>, value: Value<S>) {
        self.named.push((name.into(), value));
    }

    /// The same arguments over another scalar; `None` when one has no value there.
    pub(crate) fn map<T: Arithmetic>(
        &self,
        convert: impl Fn(&Value<S>) -> Option<Value<T>>,
    ) -> Option<Arguments<T>> {
        let positional = self.positional.iter().map(|Positional { value, range }| {
            Some(Positional { value: convert(value)?, range: *range })
        });
        let named = self.named.iter().map(|(name, value)| Some((name.clone(), convert(value)?)));
        Some(Arguments {
            positional: positional.collect::<Option<_>>()?,
            named: named.collect::<Option<_>>()?,
        })
    }

    pub(crate) fn first_failure(&self) -> Option<&Failure> {
        let positional = self.positional.iter().map(|argument| &argument.value);
        positional.chain(self.named.iter().map(|(_, value)| value)).find_map(first_failure)
    }

    /// Gives every argument its parameter.
    ///
    /// Errors: an argument too many, one missing, a name that is unknown or given twice.
    pub(crate) fn bind(self, operator: &'static Operator) -> Result<Bound<S>, Failure> {
        let mut slots: Vec<Vec<Value<S>>> =
            operator.parameters.iter().map(|_| Vec::new()).collect();
        let given = self.positional.len();
        let mut positional = self.positional.into_iter();
        for (slot, parameter) in slots.iter_mut().zip(operator.parameters) {
            if parameter.variadic {
                *slot = values_of(parameter, positional.by_ref().collect());
            } else if let Some(argument) = positional.next() {
                slot.push(argument.value);
            }
        }
        if positional.next().is_some() {
            return Err(too_many(operator, given));
        }
        for (name, value) in self.named {
            let index = position_of(operator, &name)?;
            if !slots[index].is_empty() {
                return Err(given_twice(&operator.parameters[index]));
            }
            slots[index] = if operator.parameters[index].variadic {
                values_of(&operator.parameters[index], vec![Positional { value, range: true }])
            } else {
                vec![value]
            };
        }
        let missing = operator.parameters.iter().zip(&slots);
        match missing.into_iter().find(|(p, slot)| p.is_required() && slot.is_empty()) {
            Some((parameter, _)) => Err(not_given(operator, parameter)),
            None => Ok(Bound::new(operator, slots)),
        }
    }
}

fn first_failure<S: Arithmetic>(value: &Value<S>) -> Option<&Failure> {
    match value {
        Value::Error(failure) => Some(failure),
        Value::List(items) => items.iter().find_map(first_failure),
        _ => None,
    }
}

/// The values of a parameter that takes several; lists are taken apart unless it asks for them.
fn values_of<S: Arithmetic>(parameter: &Parameter, arguments: Vec<Positional<S>>) -> Vec<Value<S>> {
    match parameter.takes {
        Takes::List | Takes::Numbers => arguments.into_iter().map(|a| a.value).collect(),
        Takes::Solid => arguments.into_iter().flat_map(cells).collect(),
        _ => spread(arguments),
    }
}

/// The cells of a range, each a value; anything else as it is, lists too.
fn cells<S: Arithmetic>(argument: Positional<S>) -> Vec<Value<S>> {
    match argument.value {
        Value::List(items) if argument.range => items,
        value => vec![value],
    }
}

/// The values of a parameter that takes several: a range, and a list that comes alone, are taken
/// apart; lists side by side are nets of points, each a value of its own, unless they hold more.
fn spread<S: Arithmetic>(arguments: Vec<Positional<S>>) -> Vec<Value<S>> {
    let alone = arguments.len() == 1;
    let mut values = Vec::with_capacity(arguments.len());
    for argument in arguments {
        let whole = !argument.range && !alone && argument.value.is_points();
        match argument.value {
            Value::List(items) if !whole => values.extend(items),
            value => values.push(value),
        }
    }
    values
}

fn position_of(operator: &Operator, name: &str) -> Result<usize, Failure> {
    let found = operator.parameters.iter().position(|parameter| parameter.name.matches(name));
    found.ok_or_else(|| {
        let known = |language: Language| {
            operator.parameters.iter().map(move |p| p.name.get(language)).collect::<Vec<_>>()
        };
        let (en, fr) = (known(Language::English), known(Language::French));
        let failure = Failure::new(
            "Name",
            format!("unknown argument “{name}”, expected {}", en.join(", ")),
            format!("argument « {name} » inconnu, attendu {}", fr.join(", ")),
        );
        match nearest(name, en.iter().chain(&fr).copied()) {
            Some(near) => failure
                .with_hint(format!("did you mean {near}?"), format!("vouliez-vous dire {near} ?")),
            None => failure,
        }
    })
}

fn too_many(operator: &Operator, given: usize) -> Failure {
    let most = operator.parameters.len();
    let en = format!("at most {most}: {}", operator.signature(Language::English));
    let fr = format!("au plus {most} : {}", operator.signature(Language::French));
    let french = format!("arguments : reçu {given}, attendu {fr}");
    Failure::of(Error::shape("arguments", given, en), french)
}

fn given_twice(parameter: &Parameter) -> Failure {
    let error = Error::shape(parameter.name.en, "two values", "one");
    Failure::of(error, format!("{} : reçu deux valeurs, attendu une seule", parameter.name.fr))
}

fn not_given(operator: &Operator, parameter: &Parameter) -> Failure {
    let words = parameter.takes.words();
    let error = Error::shape(parameter.name.en, "nothing", words.en);
    Failure::of(error, format!("{} : rien reçu, attendu {}", parameter.name.fr, words.fr))
        .with_hint(operator.signature(Language::English), operator.signature(Language::French))
}
