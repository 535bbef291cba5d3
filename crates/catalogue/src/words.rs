//! Everything said to a person is said in two languages.

use serde::Serialize;

/// A language people are spoken to in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// French.
    French,
}

/// One fixed text in both languages.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
pub struct Words {
    /// The English.
    pub en: &'static str,
    /// The French.
    pub fr: &'static str,
}

impl Words {
    /// The text in one of the languages.
    pub fn get(&self, language: Language) -> &'static str {
        match language {
            Language::English => self.en,
            Language::French => self.fr,
        }
    }

    /// Is this the text, in either language, whatever its case and accents?
    pub fn matches(&self, text: &str) -> bool {
        let text = fold(text);
        fold(self.en) == text || fold(self.fr) == text
    }
}

/// Pairs a text with its translation.
pub(crate) const fn words(en: &'static str, fr: &'static str) -> Words {
    Words { en, fr }
}

/// One composed text in both languages.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Message {
    /// The English.
    pub en: String,
    /// The French.
    pub fr: String,
}

impl Message {
    /// Pairs a text with its translation.
    pub fn new(en: impl Into<String>, fr: impl Into<String>) -> Self {
        Self { en: en.into(), fr: fr.into() }
    }

    /// The text in one of the languages.
    pub fn get(&self, language: Language) -> &str {
        match language {
            Language::English => &self.en,
            Language::French => &self.fr,
        }
    }
}

impl From<Words> for Message {
    fn from(words: Words) -> Self {
        Self::new(words.en, words.fr)
    }
}

/// Names are compared in this shape: capitals, without accents.
pub fn fold(name: &str) -> String {
    name.chars().flat_map(char::to_uppercase).map(without_accent).collect()
}

fn without_accent(letter: char) -> char {
    match letter {
        'À' | 'Â' | 'Ä' => 'A',
        'Ç' => 'C',
        'É' | 'È' | 'Ê' | 'Ë' => 'E',
        'Î' | 'Ï' => 'I',
        'Ô' | 'Ö' => 'O',
        'Ù' | 'Û' | 'Ü' => 'U',
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn case_and_accents_do_not_matter() {
        assert_eq!(fold("Élévation"), "ELEVATION");
        assert!(words("elevate", "élévation").matches("ELEVATION"));
    }
}
