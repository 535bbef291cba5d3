//! Addresses, and places in texts as a browser counts them.

use pforms_catalogue::Language;
use pforms_formula::{Address, Locale, Span, utf16_from_byte};
use serde::Serialize;

use crate::Problem;

/// A stretch of text in UTF-16 units, the way JavaScript counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Units {
    /// First unit.
    pub from: usize,
    /// One past the last unit.
    pub to: usize,
}

impl Units {
    pub(crate) fn of(source: &str, span: Span) -> Self {
        Self { from: utf16_from_byte(source, span.start), to: utf16_from_byte(source, span.end) }
    }
}

/// Reads `A1`.
pub(crate) fn address(text: &str, language: Language) -> Result<Address, Problem> {
    text.parse().map_err(|_| {
        let shown: String = text.chars().take(20).collect();
        Problem::new(
            language,
            format!("“{shown}” is no cell of a sheet"),
            format!("« {shown} » n'est pas une cellule"),
        )
    })
}

/// How a person of this language writes numbers.
pub(crate) fn locale(language: Language) -> Locale {
    match language {
        Language::English => Locale::DecimalPoint,
        Language::French => Locale::DecimalComma,
    }
}

/// The formula language speaks of languages by its own type.
pub(crate) fn spoken(language: Language) -> pforms_formula::Language {
    match language {
        Language::English => pforms_formula::Language::English,
        Language::French => pforms_formula::Language::French,
    }
}
