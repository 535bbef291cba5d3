//! Every operator, found by any of its names.

use std::collections::HashMap;
use std::sync::LazyLock;

use crate::words::fold;
use crate::{Failure, Language, Operator, entries};

static OPERATORS: LazyLock<Vec<Operator>> = LazyLock::new(entries::all);

static INDEX: LazyLock<HashMap<String, usize>> = LazyLock::new(|| {
    let names = OPERATORS.iter().enumerate();
    names.flat_map(|(index, operator)| operator.names().map(move |n| (fold(n), index))).collect()
});

/// Every operator, in the order of the book.
pub fn catalogue() -> &'static [Operator] {
    &OPERATORS
}

/// The operator of this name, English or French, whatever its case and accents.
///
/// ```
/// assert_eq!(pforms_catalogue::find("élévation").unwrap().name, "elevate");
/// ```
pub fn find(name: &str) -> Option<&'static Operator> {
    INDEX.get(&fold(name)).map(|&index| &OPERATORS[index])
}

/// The error for a name that no operator has, with the nearest one that has it.
pub fn unknown(name: &str) -> Failure {
    let failure = Failure::new(
        "Name",
        format!("there is no operator {name}"),
        format!("il n'y a pas d'opérateur {name}"),
    );
    let names = OPERATORS.iter().flat_map(Operator::names);
    match nearest(name, names) {
        Some(near) => failure
            .with_hint(format!("did you mean {near}?"), format!("vouliez-vous dire {near} ?")),
        None => failure,
    }
}

/// A proposal while somebody types: a name, and the operator it calls.
#[derive(Clone, Copy, Debug)]
pub struct Completion {
    /// The name to be inserted.
    pub name: &'static str,
    /// What it calls.
    pub operator: &'static Operator,
}

/// Operators with a name that begins so, each once, those of the language first.
pub fn complete(prefix: &str, language: Language) -> Vec<Completion> {
    let prefix = fold(prefix);
    let starts = |name: &&'static str| fold(name).starts_with(&prefix);
    let mut found: Vec<(bool, Completion)> = Vec::new();
    for operator in catalogue() {
        let own = match language {
            Language::English => operator.english,
            Language::French => operator.french,
        };
        if let Some(name) = own.iter().copied().find(starts) {
            found.push((false, Completion { name, operator }));
        } else if operator.names().any(|name| starts(&name)) {
            found.push((true, Completion { name: own[0], operator }));
        }
    }
    found.sort_by_key(|(foreign, completion)| (*foreign, completion.name));
    found.into_iter().map(|(_, completion)| completion).collect()
}

/// The name nearest to a mistyped one, if one is near: a third of the letters wrong at most.
pub(crate) fn nearest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let name: Vec<char> = fold(name).chars().take(40).collect();
    let most = (name.len() / 3).max(1);
    known
        .map(|candidate| (edits(&name, &fold(candidate).chars().collect::<Vec<_>>()), candidate))
        .filter(|(edits, candidate)| *edits <= most && *edits < candidate.len())
        .min_by_key(|(edits, _)| *edits)
        .map(|(_, candidate)| candidate)
}

/// Letters to insert, delete, replace or swap (Damerau, 1964).
fn edits(a: &[char], b: &[char]) -> usize {
    let mut table = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            if i == 0 || j == 0 {
                table[i][j] = i.max(j);
                continue;
            }
            let replaced = table[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = replaced.min(table[i - 1][j] + 1).min(table[i][j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(table[i - 2][j - 2] + 1);
            }
            table[i][j] = least;
        }
    }
    table[a.len()][b.len()]
}
