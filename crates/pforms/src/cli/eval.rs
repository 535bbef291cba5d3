//! `pforms eval`: the cells of a sheet, computed.

use std::path::PathBuf;

use clap::Args;
use pforms_catalogue::{Arithmetic, Language, Value};
use pforms_kernel::{Error, Rational};
use pforms_sheet::{Address, Sheet, Target, pfs};
use serde_json::{Map, json};

use super::{Lang, Outcome, files, poles, print};

/// Compute a sheet and print its cells.
///
/// Without CELL, every cell: address, kind and short value. With CELL (an address, a range or a
/// name), the value in full, with its poles. The exit code is 1 if a cell asked for is an error.
#[derive(Args)]
pub(crate) struct Eval {
    /// A .pfs file; - reads standard input.
    file: PathBuf,
    /// Cells, ranges or names to print in full.
    cells: Vec<String>,
    /// Compute with exact fractions.
    #[arg(long)]
    exact: bool,
    /// Print JSON.
    #[arg(long)]
    json: bool,
    /// Language of the answers.
    #[arg(long, value_enum, default_value_t)]
    lang: Lang,
}

impl Eval {
    pub(crate) fn run(self) -> Outcome {
        if self.exact { self.compute::<Rational>() } else { self.compute::<f64>() }
    }

    fn compute<S: Arithmetic>(&self) -> Outcome {
        let document = pfs::read_bytes(&files::read(&self.file)?);
        let document =
            document.map_err(|error| files::in_file(&self.file.display().to_string(), error))?;
        let mut sheet = Sheet::<S>::from(document);
        sheet.recalculate_all();
        let language = self.lang.into();
        let asked = self.asked(&sheet)?;
        let lines = match (self.json, self.cells.is_empty()) {
            (true, true) => vec![format!("{:#}", sheet.to_json(language))],
            (true, false) => vec![format!("{:#}", chosen(&sheet, &asked, language))],
            (false, true) => overview(&sheet, language),
            (false, false) => asked.iter().flat_map(|at| in_full(&sheet, *at, language)).collect(),
        };
        print::lines(lines)?;
        Ok(self.cells.is_empty() || !asked.iter().any(|at| sheet.value(*at).is_error()))
    }

    /// The cells that were asked for, in that order.
    fn asked<S: Arithmetic>(&self, sheet: &Sheet<S>) -> Result<Vec<Address>, Error> {
        let mut asked = Vec::new();
        for place in &self.cells {
            match sheet.locate(place)? {
                Target::Cell(at) => asked.push(at),
                Target::Cells(range) => {
                    asked.extend(sheet.addresses().filter(|at| range.contains(*at)));
                }
            }
        }
        Ok(asked)
    }
}

/// One line for each cell: address, kind, short value.
fn overview<S: Arithmetic>(sheet: &Sheet<S>, language: Language) -> Vec<String> {
    let row = |at: Address| {
        let info = sheet.info(at, language);
        let text = match &info.error {
            Some(failure) => poles::complaint(failure, language),
            None => without_kind(&info.text, &info.kind).to_owned(),
        };
        vec![at.to_string(), info.kind, text]
    };
    print::table(&sheet.addresses().map(row).collect::<Vec<_>>())
}

/// The short value without the kind it begins with, which has a column of its own.
fn without_kind<'a>(text: &'a str, kind: &str) -> &'a str {
    text.strip_prefix(kind).and_then(|rest| rest.strip_prefix(" · ")).unwrap_or(text)
}

fn chosen<S: Arithmetic>(
    sheet: &Sheet<S>,
    asked: &[Address],
    language: Language,
) -> serde_json::Value {
    let cells = asked.iter().map(|at| (at.to_string(), sheet.cell_to_json(*at, language)));
    json!({ "cells": cells.collect::<Map<_, _>>() })
}

/// A cell with its source, its value and, of a form, all poles.
fn in_full<S: Arithmetic>(sheet: &Sheet<S>, at: Address, language: Language) -> Vec<String> {
    let info = sheet.info(at, language);
    let mut lines = vec![format!("{at}  {}", info.source)];
    match sheet.value(at) {
        Value::Error(failure) => lines.push(format!("  {}", poles::complaint(failure, language))),
        value => {
            let own = poles::lines(value, language);
            lines.extend(own.into_iter().map(|line| format!("  {line}")));
        }
    }
    lines
}
