//! What an operator takes, described once for dispatch, completion, help and documentation.

use std::fmt;

use serde::{Serialize, Serializer};

use crate::Words;
use crate::words::words;

/// What may be given for a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Takes {
    /// A number.
    Number,
    /// A whole number.
    Whole,
    /// One number for each axis; a single one counts for all axes.
    Numbers,
    /// One whole number for each axis; a single one counts for all axes.
    Wholes,
    /// True or false.
    Boolean,
    /// Text.
    Text,
    /// A point.
    Point,
    /// A form, or a nested list of points.
    Form,
    /// A closed surface, a list of its patches, a volume or a mesh.
    Solid,
    /// A list.
    List,
    /// A record.
    Record,
    /// The name of an operator.
    Operator,
    /// Any value.
    Any,
}

impl Takes {
    /// In words, with the article: `a form or a net of points`.
    pub fn words(self) -> Words {
        match self {
            Self::Number => words("a number", "un nombre"),
            Self::Whole => words("a whole number", "un nombre entier"),
            Self::Numbers => words("a number, or one for each axis", "un nombre, ou un par axe"),
            Self::Wholes => {
                words("a whole number, or one for each axis", "un nombre entier, ou un par axe")
            }
            Self::Boolean => words("TRUE or FALSE", "VRAI ou FAUX"),
            Self::Text => words("a text", "un texte"),
            Self::Point => words("a point", "un point"),
            Self::Form => words("a form or a net of points", "une forme ou un réseau de points"),
            Self::Solid => words(
                "a closed surface, a list of its patches, a volume or a mesh",
                "une surface fermée, une liste de ses carreaux, un volume ou un maillage",
            ),
            Self::List => words("a list", "une liste"),
            Self::Record => words("a record", "une fiche"),
            Self::Operator => words("the name of an operator", "le nom d'un opérateur"),
            Self::Any => words("any value", "une valeur quelconque"),
        }
    }
}

/// What stands for an argument that is not given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fallback {
    /// The argument must be given.
    Required,
    /// This fraction.
    Ratio(i64, i64),
    /// This text.
    Text(&'static str),
    /// This truth.
    Boolean(bool),
    /// What the words say; the operator sees that nothing was given.
    Absent(Words),
}

impl fmt::Display for Fallback {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Required => Ok(()),
            Self::Ratio(numerator, 1) => write!(f, "{numerator}"),
            Self::Ratio(numerator, denominator) => write!(f, "{numerator}/{denominator}"),
            Self::Text(text) => write!(f, "\"{text}\""),
            Self::Boolean(true) => f.write_str("TRUE"),
            Self::Boolean(false) => f.write_str("FALSE"),
            Self::Absent(words) => f.write_str(words.en),
        }
    }
}

impl Serialize for Fallback {
    fn serialize<T: Serializer>(&self, serializer: T) -> Result<T::Ok, T::Error> {
        match self {
            Self::Required => serializer.serialize_none(),
            Self::Absent(words) => words.serialize(serializer),
            other => serializer.collect_str(other),
        }
    }
}

/// Bounds of a number, both included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Range {
    /// The least.
    pub least: f64,
    /// The most; `null` in JSON when there is no bound.
    pub most: f64,
}

/// One parameter of an operator.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Parameter {
    /// Its name, by which it may be given as `name = value`.
    pub name: Words,
    /// What may be given.
    pub takes: Takes,
    /// What it stands for when it is not given; `null` in JSON when it must be.
    pub default: Fallback,
    /// Does it take all the arguments that are left?
    pub variadic: bool,
    /// The unit of a number that has one.
    pub unit: Option<Words>,
    /// Bounds of a number that has some.
    pub range: Option<Range>,
    /// The words a text may be, when only some are known.
    pub choices: &'static [Words],
    /// What it does, in a sentence.
    pub help: Words,
}

impl Parameter {
    pub(crate) const fn new(takes: Takes, name: Words, help: Words) -> Self {
        Self {
            name,
            takes,
            default: Fallback::Required,
            variadic: false,
            unit: None,
            range: None,
            choices: &[],
            help,
        }
    }

    pub(crate) const fn or(mut self, default: Fallback) -> Self {
        self.default = default;
        self
    }

    pub(crate) const fn or_absent(self, en: &'static str, fr: &'static str) -> Self {
        self.or(Fallback::Absent(words(en, fr)))
    }

    pub(crate) const fn variadic(mut self) -> Self {
        self.variadic = true;
        self
    }

    pub(crate) const fn unit(mut self, en: &'static str, fr: &'static str) -> Self {
        self.unit = Some(words(en, fr));
        self
    }

    pub(crate) const fn range(mut self, least: f64, most: f64) -> Self {
        self.range = Some(Range { least, most });
        self
    }

    pub(crate) const fn choices(mut self, choices: &'static [Words]) -> Self {
        self.choices = choices;
        self
    }

    /// Must it be given?
    pub fn is_required(&self) -> bool {
        self.default == Fallback::Required
    }
}
