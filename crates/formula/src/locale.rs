//! How numbers are written, and in which language people are spoken to.

/// How decimals and separators are written. Files always hold [`Locale::DecimalPoint`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Locale {
    /// `(1.5, 2; 0.5)`: the point marks decimals, `,` separates, `;` sets off a weight.
    #[default]
    DecimalPoint,
    /// `(1,5; 2 | 0,5)`: the comma marks decimals, `;` separates, `|` sets off a weight.
    DecimalComma,
}

impl Locale {
    pub(crate) fn mark(self) -> char {
        match self {
            Self::DecimalPoint => '.',
            Self::DecimalComma => ',',
        }
    }

    pub(crate) fn separator(self) -> char {
        match self {
            Self::DecimalPoint => ',',
            Self::DecimalComma => ';',
        }
    }

    pub(crate) fn weight_mark(self) -> &'static str {
        match self {
            Self::DecimalPoint => ";",
            Self::DecimalComma => " |",
        }
    }
}

/// Language of messages and of the words for true and false.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// French.
    French,
}

impl Language {
    pub(crate) fn boolean(self, value: bool) -> &'static str {
        match (self, value) {
            (Self::English, true) => "TRUE",
            (Self::English, false) => "FALSE",
            (Self::French, true) => "VRAI",
            (Self::French, false) => "FAUX",
        }
    }
}

/// Reads the words for true and false in either language, in capitals or not.
pub(crate) fn read_boolean(word: &str) -> Option<bool> {
    let is = |value| {
        [Language::English, Language::French]
            .iter()
            .any(|l| l.boolean(value).eq_ignore_ascii_case(word))
    };
    if is(true) {
        return Some(true);
    }
    is(false).then_some(false)
}
