//! What a call could not do, said to a person.

use pforms_catalogue::{Failure, Language};
use pforms_kernel::Error;
use serde::Serialize;

/// A refusal: the sheet is as it was.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Problem {
    /// What happened.
    pub message: String,
    /// What to do about it.
    pub hint: Option<String>,
    /// Always false: the engine can go on. A fault of the program is reported by the page itself.
    pub fatal: bool,
}

impl Problem {
    /// The problem as it is told in a language.
    pub(crate) fn of(failure: &Failure, language: Language) -> Self {
        Self {
            message: failure.message(language).to_owned(),
            hint: failure.hint(language).map(str::to_owned),
            fatal: false,
        }
    }

    /// An error of the kernel's family as it is told in a language.
    pub(crate) fn error(error: Error, language: Language) -> Self {
        Self::of(&Failure::from(error), language)
    }

    /// A problem that belongs to this face.
    pub(crate) fn new(language: Language, en: impl Into<String>, fr: impl Into<String>) -> Self {
        let message = match language {
            Language::English => en.into(),
            Language::French => fr.into(),
        };
        Self { message, hint: None, fatal: false }
    }
}
