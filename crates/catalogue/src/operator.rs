//! One entry of the catalogue: everything that is known about an operator.

use pforms_kernel::{Rational, Traced};
use serde::{Serialize, Serializer};

use crate::{Arguments, Arithmetic, Bound, Failure, Language, Parameter, Takes, Value, Words};

/// What computes a call: bound arguments in, a value out.
#[doc(hidden)]
pub type Routine<S> = fn(&Bound<S>) -> Result<Value<S>, Failure>;

/// The routine for each mode; an operator that needs roots has none in exact mode, one that searches
/// or approximates none for derivatives.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Call {
    pub(crate) floating: Routine<f64>,
    pub(crate) exact: Option<Routine<Rational>>,
    pub(crate) traced: Option<Routine<Traced>>,
}

/// A [`Call`] of one routine in both modes, or in floating mode alone.
macro_rules! call {
    ($routine:ident) => {
        crate::operator::Call {
            floating: $routine::<f64>,
            exact: Some($routine::<Rational>),
            traced: Some($routine::<pforms_kernel::Traced>),
        }
    };
    (floating $routine:expr) => {
        crate::operator::Call { floating: $routine, exact: None, traced: None }
    };
}
pub(crate) use call;

/// Chapter of the catalogue an operator belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Group {
    /// The primitive gestures: midpoint, stack, diagonal.
    Gestures,
    /// The fundamental operators: subdivision, elevation, frames.
    Fundamental,
    /// Interpolation and immersion.
    Interpolation,
    /// Transformations: one matrix on all poles.
    Transformations,
    /// Combinations of forms.
    Combinations,
    /// Rational forms: conics, quadrics, tori.
    Rational,
    /// Composed forms: products, sweeps, offsets.
    Composed,
    /// Splines and NURBS.
    Splines,
    /// Deformation and geometry inside forms.
    Inside,
    /// Poles, weights, orders, pieces.
    Forms,
    /// Elementary functions.
    Numbers,
    /// Lists, conditions, records.
    Lists,
}

impl Group {
    /// The heading of the chapter.
    pub fn title(self) -> Words {
        let (en, fr) = match self {
            Self::Gestures => ("Primitive gestures", "Gestes primitifs"),
            Self::Fundamental => ("Fundamental operators", "Opérateurs fondamentaux"),
            Self::Interpolation => ("Interpolation and immersion", "Interpolation et immersion"),
            Self::Transformations => ("Transformations", "Transformations"),
            Self::Combinations => ("Combinations", "Combinaisons"),
            Self::Rational => ("Rational forms", "Formes rationnelles"),
            Self::Composed => ("Composed forms", "Formes composées"),
            Self::Splines => ("Splines", "Splines"),
            Self::Inside => ("Geometry inside forms", "Géométrie dans les formes"),
            Self::Forms => ("Poles and pieces", "Pôles et morceaux"),
            Self::Numbers => ("Numbers", "Nombres"),
            Self::Lists => ("Lists and conditions", "Listes et conditions"),
        };
        Words { en, fr }
    }
}

/// Everything that is known about an operator, once: dispatch, completion, help, the reference
/// pages and the other faces read it here.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Operator {
    /// The name in Rust and Python.
    pub name: &'static str,
    /// Names in formulas, the usual one first.
    pub english: &'static [&'static str],
    /// Names in French formulas, the usual one first.
    pub french: &'static [&'static str],
    /// Where it stands in the catalogue.
    pub group: Group,
    /// What it does, in a line.
    pub summary: Words,
    /// What more there is to know: laws, costs, what can go wrong.
    pub help: Words,
    /// What it takes, in order.
    pub parameters: &'static [Parameter],
    /// What it gives.
    pub gives: Takes,
    /// A formula that can be typed as it stands.
    pub example: &'static str,
    /// Where the idea comes from.
    pub source: &'static str,
    /// Names of its relatives.
    pub see: &'static [&'static str],
    /// Does it look at errors instead of passing them on?
    pub takes_errors: bool,
    /// Does it work in exact mode?
    #[serde(rename = "exact", serialize_with = "is_exact")]
    #[doc(hidden)]
    pub call: Call,
}

fn is_exact<T: Serializer>(call: &Call, serializer: T) -> Result<T::Ok, T::Error> {
    serializer.serialize_bool(call.exact.is_some())
}

impl Operator {
    /// The usual name in formulas.
    pub fn formula_name(&self, language: Language) -> &'static str {
        match language {
            Language::English => self.english[0],
            Language::French => self.french[0],
        }
    }

    /// Every name by which a formula may call it, accents folded by [`crate::find`].
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        self.english.iter().chain(self.french).copied().chain([self.name])
    }

    /// How a call is written: `SUB(form, axis, t)`, `MI(forms, …)`; what may be left out stands in
    /// brackets.
    pub fn signature(&self, language: Language) -> String {
        let parameter = |parameter: &Parameter| {
            let dots = if parameter.variadic { ", …" } else { "" };
            let name = parameter.name.get(language);
            if parameter.is_required() {
                format!("{name}{dots}")
            } else {
                format!("[{name}{dots}]")
            }
        };
        let parameters: Vec<String> = self.parameters.iter().map(parameter).collect();
        format!("{}({})", self.formula_name(language), parameters.join(", "))
    }

    /// Calls the operator.
    ///
    /// The first error among the arguments is returned unchanged. What goes wrong here comes back
    /// as an error that names the operator, the argument, what came and what was expected.
    pub fn call<S: Arithmetic>(&'static self, arguments: Arguments<S>) -> Value<S> {
        if !self.takes_errors
            && let Some(failure) = arguments.first_failure()
        {
            return failure.clone().into();
        }
        let Some(routine) = S::routine(&self.call) else {
            return S::without_routine(self, &arguments);
        };
        match arguments.bind(self).and_then(|bound| self.run(routine, &bound)).and_then(checked) {
            Ok(value) => value,
            Err(failure) => failure.within(self).into(),
        }
    }

    /// A condition chooses what it looks at; any other operator looks at all that it is given.
    fn run<S: Arithmetic>(
        &self,
        routine: Routine<S>,
        bound: &Bound<S>,
    ) -> Result<Value<S>, Failure> {
        let value = routine(bound)?;
        if !self.takes_errors {
            bound.require_read()?;
        }
        Ok(value)
    }
}

/// No number that is not finite, and none of thousands of digits, leaves an operator.
pub(crate) fn checked<S: Arithmetic>(value: Value<S>) -> Result<Value<S>, Failure> {
    check(&value).map(|()| value)
}

fn check<S: Arithmetic>(value: &Value<S>) -> Result<(), Failure> {
    match value {
        Value::Number(x) => x.check(),
        Value::Form(form) if S::EXACT => form.homogeneous().iter().try_for_each(S::check),
        Value::List(items) => items.iter().try_for_each(check),
        _ => Ok(()),
    }
}
