//! What the formula bar shows while somebody types: proposals, help, and what is wrong.

use pforms_catalogue::{Language, complete, find, unknown};
use pforms_formula::{
    CallContext, Content, Context, Expression, Fault, Locale, Problem, Span, Tree, at,
    byte_from_utf16, classify,
};
use serde::Serialize;

use crate::OperatorHelp;
use crate::place::{Units, locale, spoken};

/// A text longer than this is not examined while it is typed; it is when it is accepted.
const EXAMINED: usize = 20_000;

/// What can be proposed, explained and complained about at a caret.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Assistance {
    /// Ways to complete the word under the caret, best first.
    pub proposals: Vec<Proposal>,
    /// First unit of that word.
    pub from: usize,
    /// One past its last unit.
    pub to: usize,
    /// The innermost call around the caret.
    pub call: Option<Call>,
    /// What is wrong, apart from what is still being typed.
    pub diagnostics: Vec<Diagnostic>,
}

/// A way to complete a word.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Proposal {
    /// What it is called.
    pub name: String,
    /// The text that replaces the word.
    pub insert: String,
    /// What it is, in a line.
    pub summary: String,
    /// How a call is written; empty for what is no operator.
    pub signature: String,
}

/// The call around the caret.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Call {
    /// The operator that is called.
    pub operator: OperatorHelp,
    /// The parameter being typed.
    pub argument: usize,
}

/// Something wrong at a place of the text.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Diagnostic {
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub hint: Option<String>,
    /// Where.
    #[serde(flatten)]
    pub place: Units,
}

/// Answers for a caret, counted in UTF-16 units. `names` are those of the sheet, with their targets.
pub(crate) fn assist<'a>(
    text: &str,
    caret: usize,
    language: Language,
    names: impl Iterator<Item = (&'a str, String)>,
) -> Assistance {
    if text.len() > EXAMINED {
        return Assistance {
            proposals: vec![],
            from: caret,
            to: caret,
            call: None,
            diagnostics: vec![],
        };
    }
    let caret = byte_from_utf16(text, caret);
    let context = at(text, caret, locale(language));
    let Units { from, to } = Units::of(text, context.word);
    Assistance {
        proposals: proposals(text, &context, language, names),
        from,
        to,
        call: context.call.as_ref().and_then(|call| explain(call, language)),
        diagnostics: diagnose(text, caret, language),
    }
}

fn proposals<'a>(
    text: &str,
    context: &Context,
    language: Language,
    names: impl Iterator<Item = (&'a str, String)>,
) -> Vec<Proposal> {
    let prefix = context.prefix.to_lowercase();
    if prefix.is_empty() || pforms_formula::Reference::read(&prefix).is_some() {
        return Vec::new();
    }
    let mut found = keywords(context, &prefix, language);
    let own = names.filter(|(name, _)| name.to_lowercase().starts_with(&prefix));
    found.extend(own.map(|(name, target)| Proposal {
        name: name.to_owned(),
        insert: name.to_owned(),
        summary: target,
        signature: String::new(),
    }));
    let open = if text[context.word.end..].starts_with('(') { "" } else { "(" };
    found.extend(complete(&prefix, language).into_iter().map(|completion| Proposal {
        name: completion.name.to_owned(),
        insert: format!("{}{open}", completion.name),
        summary: completion.operator.summary.get(language).to_owned(),
        signature: completion.operator.signature(language),
    }));
    found
}

/// Parameters of the call that can be given by name here.
fn keywords(context: &Context, prefix: &str, language: Language) -> Vec<Proposal> {
    let call = context.call.as_ref().filter(|_| context.starts_argument);
    let Some(operator) = call.and_then(|call| find(&call.name)) else { return Vec::new() };
    let named = operator.parameters.iter().filter(|one| !one.variadic);
    named
        .filter(|one| one.name.get(language).to_lowercase().starts_with(prefix))
        .map(|one| Proposal {
            name: format!("{}:", one.name.get(language)),
            insert: format!("{}: ", one.name.get(language)),
            summary: one.help.get(language).to_owned(),
            signature: String::new(),
        })
        .collect()
}

fn explain(call: &CallContext, language: Language) -> Option<Call> {
    let operator = find(&call.name)?;
    let by_name =
        |keyword: &String| operator.parameters.iter().position(|one| one.name.matches(keyword));
    let argument = call.keyword.as_ref().and_then(by_name).unwrap_or(call.argument);
    Some(Call { operator: OperatorHelp::of(operator, language), argument })
}

/// What is wrong before the caret: what is still being typed, such as an open bracket or a missing
/// end, is no mistake yet.
fn diagnose(text: &str, caret: usize, language: Language) -> Vec<Diagnostic> {
    let tree = match classify(text, locale(language)) {
        Content::Literal(tree) | Content::Formula(tree) => tree,
        Content::Empty | Content::Text(_) => return Vec::new(),
    };
    let typed = text[..caret].trim_end().len();
    let open = |(_, fault): &(Span, &Fault)| {
        matches!(fault.problem, Problem::Unclosed(_) | Problem::UnclosedText)
    };
    let broken = tree.errors().filter(|error| !open(error) && error.0.end < typed);
    let mut found: Vec<Diagnostic> = broken.map(|error| mistake(error, text, language)).collect();
    let end = Units::of(text, Span::new(0, typed)).to;
    found.extend(strangers(&tree, text, language).into_iter().filter(|one| one.place.to < end));
    found
}

/// Errors of the syntax, with their places in UTF-16 units.
pub(crate) fn mistakes(tree: &Tree, text: &str, language: Language) -> Vec<Diagnostic> {
    tree.errors().map(|error| mistake(error, text, language)).collect()
}

fn mistake((span, fault): (Span, &Fault), text: &str, language: Language) -> Diagnostic {
    let hint = fault.problem.hint(spoken(language));
    Diagnostic {
        message: fault.problem.message(spoken(language)),
        hint: Some(hint).filter(|hint| !hint.is_empty()),
        place: Units::of(text, span),
    }
}

/// Calls of operators that do not exist.
pub(crate) fn strangers(tree: &Tree, text: &str, language: Language) -> Vec<Diagnostic> {
    let calls = tree.nodes().iter().filter_map(|node| match &node.expression {
        Expression::Call(call) if find(&call.name).is_none() => Some(call),
        _ => None,
    });
    let diagnostic = |call: &pforms_formula::Call| {
        let failure = unknown(&call.name);
        Diagnostic {
            message: failure.message(language).to_owned(),
            hint: failure.hint(language).map(str::to_owned),
            place: Units::of(text, call.name_span),
        }
    };
    calls.map(diagnostic).collect()
}

/// The text of a file as a person of this language types it.
pub(crate) fn shown(source: &str, language: Language) -> String {
    pforms_formula::convert(source, Locale::DecimalPoint, locale(language))
}

/// What a person of this language typed, as files hold it.
pub(crate) fn filed(text: &str, language: Language) -> String {
    pforms_formula::convert(text, locale(language), Locale::DecimalPoint)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn help(text: &str, language: Language) -> Assistance {
        let names = [("octant", "A4".to_owned())];
        let caret = text.encode_utf16().count();
        assist(text, caret, language, names.iter().map(|(name, target)| (*name, target.clone())))
    }

    #[test]
    fn words_are_completed_from_the_catalogue_and_the_sheet() {
        let answer = help("=1 + di", Language::English);
        assert_eq!((answer.from, answer.to), (5, 7));
        assert!(answer.proposals.iter().any(|one| one.insert == "DIAG("));
        let answer = help("=oct", Language::English);
        assert_eq!(answer.proposals[0].summary, "A4");
        assert!(help("=A1", Language::English).proposals.is_empty());
    }

    #[test]
    fn the_call_around_the_caret_is_explained_in_the_language() {
        let call = help("=SUB(A1; 0; ", Language::French).call.unwrap();
        assert_eq!((call.operator.name, call.argument), ("SOUSFORME", 2));
    }

    #[test]
    fn an_unfinished_end_is_no_mistake_but_a_wrong_middle_is() {
        assert_eq!(help("=MIR(A1, ", Language::English).diagnostics, vec![]);
        let wrong = help("=DIAGG(A1) + 1", Language::English).diagnostics;
        assert_eq!(wrong[0].place, Units { from: 1, to: 6 });
        assert!(wrong[0].hint.as_deref().unwrap_or_default().contains("DIAG"));
    }

    #[test]
    fn a_monstrous_text_is_left_in_peace() {
        assert_eq!(
            help(&format!("={}", "(".repeat(100_000)), Language::English).diagnostics,
            vec![]
        );
    }
}
