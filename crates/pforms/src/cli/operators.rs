//! `pforms operators`: what a formula can call.

use clap::Args;
use pforms_catalogue::{Language, Operator, catalogue, find, unknown};
use serde_json::json;

use super::{Lang, Outcome, print};

/// List the operators a formula can call, or tell all about some of them.
#[derive(Args)]
pub(crate) struct Operators {
    /// Operators to tell all about, by any of their names.
    names: Vec<String>,
    /// Print JSON.
    #[arg(long)]
    json: bool,
    /// Language of the answers.
    #[arg(long, value_enum, default_value_t)]
    lang: Lang,
}

impl Operators {
    pub(crate) fn run(self) -> Outcome {
        let language = self.lang.into();
        let chosen: Vec<&Operator> = if self.names.is_empty() {
            catalogue().iter().collect()
        } else {
            self.names
                .iter()
                .map(|name| find(name).ok_or_else(|| unknown(name)))
                .collect::<Result<_, _>>()?
        };
        print::lines(match (self.json, self.names.is_empty()) {
            (true, _) => vec![format!("{:#}", json!(chosen))],
            (false, true) => overview(&chosen, language),
            (false, false) => chosen.iter().flat_map(|operator| page(operator, language)).collect(),
        })?;
        Ok(true)
    }
}

/// One line for each operator, under the heading of its chapter.
fn overview(operators: &[&Operator], language: Language) -> Vec<String> {
    let mut lines = Vec::new();
    let chapters = operators.chunk_by(|a, b| a.group == b.group);
    for chapter in chapters {
        lines.push(chapter[0].group.title().get(language).to_owned());
        let row = |operator: &&Operator| {
            vec![operator.signature(language), operator.summary.get(language).to_owned()]
        };
        let rows: Vec<Vec<String>> = chapter.iter().map(row).collect();
        lines.extend(print::table(&rows).into_iter().map(|line| format!("  {line}")));
    }
    lines
}

/// All about one operator.
fn page(operator: &Operator, language: Language) -> Vec<String> {
    let mut lines = vec![
        operator.signature(language),
        format!("  {}", operator.summary.get(language)),
        format!("  {}", operator.help.get(language)),
    ];
    let row = |parameter: &pforms_catalogue::Parameter| {
        let takes = parameter.takes.words().get(language).to_owned();
        vec![
            parameter.name.get(language).to_owned(),
            takes,
            parameter.help.get(language).to_owned(),
        ]
    };
    let rows: Vec<Vec<String>> = operator.parameters.iter().map(row).collect();
    lines.extend(print::table(&rows).into_iter().map(|line| format!("    {line}")));
    lines.push(format!("  {}", operator.example));
    lines
}
