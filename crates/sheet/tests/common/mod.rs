//! Little sheets, drawn as text: one line for each cell, `A1: source`.
#![allow(dead_code, unreachable_pub, reason = "each test file takes what it needs")]

use pforms_catalogue::{Arithmetic, Language};
use pforms_sheet::{Address, Sheet};

pub fn at(text: &str) -> Address {
    text.parse().unwrap()
}

pub fn drawn<S: Arithmetic>(lines: &str) -> Sheet<S> {
    let mut sheet = Sheet::new();
    for line in lines.lines().map(str::trim).filter(|line| !line.is_empty()) {
        let (cell, text) = line.split_once(':').unwrap();
        sheet.set(at(cell.trim()), text.trim());
    }
    sheet.recalculate_all();
    sheet
}

/// The sheet as text: address, short value; errors with their origin and hint.
pub fn shown<S: Arithmetic>(sheet: &Sheet<S>) -> Vec<String> {
    sheet.addresses().map(|at| format!("{at}: {}", text(sheet, &at.to_string()))).collect()
}

pub fn text<S: Arithmetic>(sheet: &Sheet<S>, cell: &str) -> String {
    let info = sheet.info(at(cell), Language::English);
    match info.error {
        Some(failure) => format!("! {failure}"),
        None => info.text,
    }
}

/// The gallery and the sheets of the tests.
pub fn gallery() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/sheets");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let sheets = files.filter(|path| path.extension().is_some_and(|end| end == "pfs"));
    let mut sheets: Vec<_> = sheets
        .map(|path| {
            let name = path.file_stem().unwrap().to_string_lossy().into_owned();
            (name, std::fs::read_to_string(path).unwrap())
        })
        .collect();
    sheets.sort();
    sheets
}
