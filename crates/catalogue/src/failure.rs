//! What went wrong, as a value that flows through a sheet.

use pforms_kernel::Error;

use crate::{Language, Message, Operator};

/// An error on its way through the cells: said in both languages, with the cell it came from and
/// what to do about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure(Box<Parts>);

#[derive(Clone, Debug, PartialEq)]
struct Parts {
    family: &'static str,
    message: Message,
    hint: Option<Message>,
    origin: Option<String>,
    error: Option<Error>,
}

impl Failure {
    /// A failure that is not one of the kernel's: `family` is a short English word such as
    /// `"Name"`, `"Cycle"` or `"Formula"`.
    pub fn new(family: &'static str, en: impl Into<String>, fr: impl Into<String>) -> Self {
        let message = Message::new(en, fr);
        Self(Box::new(Parts { family, message, hint: None, origin: None, error: None }))
    }

    /// An error of the kernel's family with its message in French.
    pub fn of(error: Error, fr: impl Into<String>) -> Self {
        let message = Message::new(error.to_string(), fr);
        let family = error.family();
        Self(Box::new(Parts { family, message, hint: None, origin: None, error: Some(error) }))
    }

    /// Adds what to do about it; a hint already there stays.
    #[must_use]
    pub fn with_hint(mut self, en: impl Into<String>, fr: impl Into<String>) -> Self {
        self.0.hint.get_or_insert_with(|| Message::new(en, fr));
        self
    }

    /// Names the cell it came from; an origin already there stays, being nearer the cause.
    #[must_use]
    pub fn at(mut self, cell: impl Into<String>) -> Self {
        self.0.origin.get_or_insert_with(|| cell.into());
        self
    }

    /// Puts the operator in which it happened before the message; in French, its parameter too
    /// goes by its French name.
    #[must_use]
    pub(crate) fn within(mut self, operator: &Operator) -> Self {
        let [en, fr] = [Language::English, Language::French].map(|l| operator.formula_name(l));
        let Message { en: english, fr: french } = &self.0.message;
        let renamed = operator.parameters.iter().find_map(|parameter| {
            let rest = french.strip_prefix(parameter.name.en)?.strip_prefix(" : ")?;
            Some(format!("{} : {rest}", parameter.name.fr))
        });
        let french = renamed.as_ref().unwrap_or(french);
        self.0.message = Message::new(format!("{en}, {english}"), format!("{fr}, {french}"));
        self.0.error = self.0.error.take().map(|error| prefixed(error, en));
        self
    }

    /// The family, the same word in every face: `Shape`, `Domain`, `Degenerate`, `Accuracy`,
    /// `Format`, `Limit`, or what [`Failure::new`] was given.
    pub fn family(&self) -> &'static str {
        self.0.family
    }

    /// What happened.
    pub fn message(&self, language: Language) -> &str {
        self.0.message.get(language)
    }

    /// What to do about it, when that is known.
    pub fn hint(&self, language: Language) -> Option<&str> {
        self.0.hint.as_ref().map(|hint| hint.get(language))
    }

    /// The cell it came from.
    pub fn origin(&self) -> Option<&str> {
        self.0.origin.as_deref()
    }

    /// The same as an error of the kernel's family, for a face that raises errors.
    ///
    /// The origin and the hint go along in English.
    pub fn to_error(&self) -> Error {
        let Some(error) = &self.0.error else {
            return Error::format(self.origin().unwrap_or("formula"), None, self.with_advice());
        };
        match self.origin() {
            Some(cell) => prefixed(error.clone(), cell),
            None => error.clone(),
        }
    }

    fn with_advice(&self) -> String {
        match &self.0.hint {
            Some(hint) => format!("{} ({})", self.0.message.en, hint.en),
            None => self.0.message.en.clone(),
        }
    }
}

/// The error with a name before the argument it speaks of.
fn prefixed(mut error: Error, name: &str) -> Error {
    let subject = match &mut error {
        Error::Shape(fault)
        | Error::Domain(fault)
        | Error::Degenerate(fault)
        | Error::Accuracy(fault) => &mut fault.argument,
        Error::Format { what, .. } | Error::Limit { what, .. } => what,
        Error::Stopped => return error,
    };
    *subject = format!("{name}, {subject}");
    error
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        let french = crate::french::of_error(&error);
        Self::of(error, french)
    }
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.0.origin {
            Some(cell) => write!(f, "{cell}: {}", self.with_advice()),
            None => f.write_str(&self.with_advice()),
        }
    }
}

impl std::error::Error for Failure {}
