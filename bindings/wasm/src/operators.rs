//! The catalogue in one language.

use pforms_catalogue::{Fallback, Language, Operator, Parameter, Words, catalogue};
use pforms_formula::{Locale, convert};
use serde::Serialize;

use crate::place::locale;

/// One operator in one language.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OperatorHelp {
    /// Its usual name in formulas.
    pub name: &'static str,
    /// Its other names.
    pub aliases: Vec<&'static str>,
    /// The chapter it belongs to.
    pub group: &'static str,
    /// What it does, in a line.
    pub summary: &'static str,
    /// What more there is to know.
    pub help: &'static str,
    /// How a call is written.
    pub signature: String,
    /// What it takes.
    pub parameters: Vec<ParameterHelp>,
    /// A formula that can be typed as it stands.
    pub example: String,
}

/// One parameter in one language.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ParameterHelp {
    /// Its name.
    pub name: &'static str,
    /// What it does.
    pub help: &'static str,
    /// What may be given, its unit, range and default.
    pub detail: String,
    /// May it be left out?
    pub optional: bool,
    /// Does it take all that is left?
    pub variadic: bool,
}

/// Every operator, in the order of the book.
pub(crate) fn all(language: Language) -> Vec<OperatorHelp> {
    catalogue().iter().map(|operator| OperatorHelp::of(operator, language)).collect()
}

impl OperatorHelp {
    pub(crate) fn of(operator: &Operator, language: Language) -> Self {
        let name = operator.formula_name(language);
        let mut aliases: Vec<&str> = Vec::new();
        for other in operator.english.iter().chain(operator.french).copied() {
            if other != name && !aliases.contains(&other) {
                aliases.push(other);
            }
        }
        Self {
            name,
            aliases,
            group: operator.group.title().get(language),
            summary: operator.summary.get(language),
            help: operator.help.get(language),
            signature: operator.signature(language),
            parameters: operator.parameters.iter().map(|one| parameter(one, language)).collect(),
            example: convert(operator.example, Locale::DecimalPoint, locale(language)),
        }
    }
}

fn parameter(parameter: &Parameter, language: Language) -> ParameterHelp {
    ParameterHelp {
        name: parameter.name.get(language),
        help: parameter.help.get(language),
        detail: detail(parameter, language),
        optional: !parameter.is_required(),
        variadic: parameter.variadic,
    }
}

/// `a whole number, 0 to 20, in radians; 1 if left out`
fn detail(parameter: &Parameter, language: Language) -> String {
    let mut parts = vec![parameter.takes.words().get(language).to_owned()];
    if !parameter.choices.is_empty() {
        let choices: Vec<String> =
            parameter.choices.iter().map(|word| format!("“{}”", word.get(language))).collect();
        parts = vec![choices.join(" · ")];
    }
    parts.extend(parameter.range.map(|range| bounds(range.least, range.most, language)));
    parts.extend(parameter.unit.map(|unit| unit.get(language).to_owned()));
    let text = parts.join(", ");
    let fallback = match parameter.default {
        Fallback::Required => return text,
        Fallback::Absent(words) => words.get(language).to_owned(),
        Fallback::Boolean(value) => pick(language, truth(value)).to_owned(),
        ref other => other.to_string(),
    };
    let left_out = pick(language, Words { en: "if left out", fr: "par défaut" });
    let mark = pick(language, Words { en: ";", fr: " ;" });
    format!("{text}{mark} {fallback} {left_out}")
}

fn bounds(least: f64, most: f64, language: Language) -> String {
    let text = match (least.is_finite(), most.is_finite()) {
        (true, true) => format!("{least} … {most}"),
        (true, false) => format!("≥ {least}"),
        (false, true) => format!("≤ {most}"),
        (false, false) => String::new(),
    };
    match language {
        Language::English => text,
        Language::French => text.replace('.', ","),
    }
}

fn truth(value: bool) -> Words {
    if value { Words { en: "TRUE", fr: "VRAI" } } else { Words { en: "FALSE", fr: "FAUX" } }
}

fn pick(language: Language, words: Words) -> &'static str {
    words.get(language)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_operator_is_explained_in_both_languages() {
        for language in [Language::English, Language::French] {
            for operator in all(language) {
                assert!(operator.example.starts_with('='), "{}", operator.name);
                assert!(!operator.summary.is_empty(), "{}", operator.name);
                assert!(!operator.aliases.contains(&operator.name), "{}", operator.name);
            }
        }
    }

    #[test]
    fn a_default_is_told() {
        let diag = OperatorHelp::of(pforms_catalogue::find("DIAG").unwrap(), Language::English);
        assert!(!diag.parameters[0].optional);
        assert!(diag.parameters[1].optional);
        assert!(
            diag.parameters[1].detail.ends_with("if left out"),
            "{}",
            diag.parameters[1].detail
        );
    }
}
