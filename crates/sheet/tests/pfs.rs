//! The file format: what we write comes back, and what is damaged is named by line and column.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on must stop")]

use std::path::PathBuf;

use pforms_kernel::Error;
use pforms_sheet::{Document, Edit, Sheet, Target, pfs};
use proptest::prelude::*;

fn gallery() -> Vec<(PathBuf, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/sheets");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let sheets = files.filter(|path| path.extension().is_some_and(|end| end == "pfs"));
    sheets.map(|path| (path.clone(), std::fs::read_to_string(path).unwrap())).collect()
}

#[test]
fn the_gallery_comes_back_byte_for_byte() {
    let sheets = gallery();
    assert!(!sheets.is_empty());
    for (path, text) in sheets {
        let document = pfs::read(&text).unwrap_or_else(|error| panic!("{path:?}: {error}"));
        assert_eq!(pfs::write(&document), text, "{path:?}");
    }
}

/// Reads a damaged sheet and says where and why it was refused.
fn refusal(text: &str) -> (usize, usize, String) {
    match pfs::read(text) {
        Err(Error::Format { place: Some(place), message, .. }) => {
            (place.line, place.column, message)
        }
        other => panic!("{text:?}: {other:?}"),
    }
}

#[test]
fn damage_is_named_by_line_and_column() {
    let cases = [
        ("", 1, 1, "pfs = 1"),
        ("title = \"x\"\n", 1, 1, "pfs = 1"),
        ("pfs = 2\n", 1, 7, "version 2"),
        ("pfs = 99999999999999999999\n", 1, 7, "version of the format"),
        ("pfs = -1\n", 1, 7, "version of the format"),
        ("pfs = \"1\"\n", 1, 7, "version of the format"),
        ("pfs = 1\n\ncels = 3\n", 3, 1, "unknown key \"cels\""),
        ("pfs = 1\n[cells]\nA1 = [1]\n", 3, 6, "found array"),
        ("pfs = 1\n[cells]\nA1 = 1\nA1 = 2\n", 4, 1, "duplicate"),
        ("pfs = 1\n[cells]\nA1 = 1\na1 = 2\n", 4, 1, "A1 is given twice"),
        ("pfs = 1\n[cells]\nA9999999 = 1\n", 3, 1, "no address"),
        ("pfs = 1\n[cells]\n\"=é\" = 1\n", 3, 1, "no address"),
        ("pfs = 1\n[cells]\nA1 = 2020-01-01\n", 3, 6, "found datetime"),
        ("pfs = 1\n[names]\nA2 = \"A1\"\n", 3, 1, "cannot be a name"),
        ("pfs = 1\n[names]\nx = \"A1+1\"\n", 3, 5, "no cell or range"),
        ("pfs = 1\n[names]\nx = \"A1\"\nX = \"A2\"\n", 4, 1, "given twice"),
        ("pfs = 1\n[camera]\nzoom = nan\n", 3, 8, "not finite"),
        ("pfs = 1\n[camera]\nzoom = 99999999999999999999\n", 3, 8, "too large"),
        ("pfs = 1\nnotes = 3\n", 2, 9, "expected tables"),
        ("pfs = 1\nshow = \"A1\"\n", 2, 8, "expected a table"),
        ("pfs = 1\n[cells]\nA1 = \"(1, 2", 3, 12, "invalid basic string"),
    ];
    for (text, line, column, part) in cases {
        let (at_line, at_column, message) = refusal(text);
        assert!(message.contains(part), "{text:?}: {message:?}");
        assert_eq!((at_line, at_column), (line, column), "{text:?}: {message:?}");
    }
}

#[test]
fn columns_count_characters() {
    let (line, column, _) = refusal("pfs = 1\n[camera]\nv = { \"é\" = 1979-05-27 }\n");
    assert_eq!((line, column), (3, 13));
    let bytes = b"pfs = 1\n[cells]\nA1 = \"\xff\"";
    let error = pfs::read_bytes(bytes).unwrap_err().to_string();
    assert_eq!(error, "sheet, line 3, column 7: not a text in UTF-8");
}

#[test]
fn hostile_nesting_is_refused() {
    for text in [
        format!("pfs = 1\n[camera]\nx = {}", "[".repeat(100_000)),
        format!("pfs = 1\n[camera]\nx = {}1{}", "[".repeat(60), "]".repeat(60)),
        format!("pfs = 1\n[camera]\na{} = 1", ".a".repeat(100_000)),
        format!("pfs = 1\n[a{}]", ".a".repeat(100_000)),
        "[".repeat(1_000_000),
        "\0".repeat(1000),
    ] {
        assert!(pfs::read(&text).is_err());
    }
}

#[test]
fn every_truncation_of_a_sheet_is_read_or_refused() {
    let text = pfs::write(&pfs::read(&gallery()[0].1).unwrap());
    for end in (0..text.len()).filter(|end| text.is_char_boundary(*end)) {
        if let Err(error) = pfs::read(&text[..end]) {
            assert!(matches!(error, Error::Format { place: Some(_), .. }), "{error:?}");
        }
    }
}

#[test]
fn numbers_given_without_quotes_are_kept() {
    let document = pfs::read("pfs = 1\n[cells]\nA1 = 3\nA2 = 0.25\nA3 = 0x10\n").unwrap();
    let texts: Vec<&str> = document.cells().map(|(_, text)| text).collect();
    assert_eq!(texts, ["3", "0.25", "16"]);
}

proptest! {
    #[test]
    fn any_document_comes_back(
        cells in proptest::collection::btree_map((1u32..80, 1u32..2000), any::<String>(), 0..12),
        title in any::<String>(),
        keys in proptest::collection::vec(any::<String>(), 0..4),
        numbers in proptest::collection::vec(any::<f64>().prop_filter("finite", |x| x.is_finite()), 0..4),
        integer in any::<i64>(),
    ) {
        let mut document = Document::default();
        for ((column, row), text) in cells {
            let at = pforms_formula::Address::new(column, row).unwrap();
            document.apply(Edit::Cell { at, text: Some(text) });
        }
        document.apply(Edit::Title { key: "title_fr".into(), text: Some(title) });
        let target = Some(Target::read("B2:C3").unwrap());
        document.apply(Edit::Name { name: "Été".into(), target });
        let mut settings = pforms_sheet::Settings::new();
        settings.insert("numbers".into(), numbers.into());
        settings.insert("integer".into(), integer.into());
        for key in keys {
            settings.insert(key.clone(), serde_json::json!({ key.clone(): [key, true] }));
        }
        document.apply(Edit::Show { at: "B7".parse().unwrap(), settings: Some(settings.clone()) });
        document.apply(Edit::Camera { settings: settings.clone() });
        document.apply(Edit::Notes { notes: vec![settings.clone(), settings] });
        let text = pfs::write(&document);
        let again = pfs::read(&text).unwrap();
        prop_assert_eq!(&again, &document);
        prop_assert_eq!(pfs::write(&again), text);
    }

    #[test]
    fn any_text_is_read_or_refused(text in any::<String>()) {
        let _ = pfs::read(&text);
        let _ = pfs::read(&format!("pfs = 1\n[cells]\n{text}"));
    }
}

const COMMENTED: &str = r##"# A sheet by hand.
#
# Two lines on top.
pfs = 1  # the version
title = "A # is no comment"  # but this is

# The cells
[cells]  # of the sheet
# Above A1
A1 = "(0, 0)"  # beside A1
A2 = "=\"#\""

[show.A1]  # how it is drawn
draw = ["points"]  # as points

# The note
[[notes]]
text = "say"  # what

# The end.
"##;

#[test]
fn comments_stay_where_they_were() {
    let document = pfs::read(COMMENTED).unwrap();
    assert_eq!(pfs::write(&document), COMMENTED);
}

#[test]
fn comments_in_other_layouts_are_moved_but_none_is_lost() {
    let text = "pfs=1#a\n[camera]\nview = [ # b\n 1, # c\n 2 ] # d\n\
        long = \"\"\"x # no\n y\"\"\" # e\n'q#' = 'z#\\' # f\n[cells] # g\n\na1 = 3 # h\n[names] # i\n";
    let written = pfs::write(&pfs::read(text).unwrap());
    for comment in ["a", "b", "c", "d", "e", "f", "g", "h", "i"] {
        let found = written.lines().filter(|line| {
            line.trim_end().ends_with(&format!("#{comment}"))
                || line.ends_with(&format!("# {comment}"))
        });
        assert_eq!(found.count(), 1, "{comment} in {written}");
    }
    assert!(!written.contains("# no\n") && written.contains("A1 = \"3\"  # h"), "{written}");
    assert_eq!(pfs::write(&pfs::read(&written).unwrap()), written);
}

#[test]
fn comments_go_with_their_cells() {
    let mut sheet = Sheet::<f64>::open(COMMENTED).unwrap();
    sheet.insert_rows(1, 2).unwrap();
    assert!(
        sheet.save().contains("# Above A1\nA3 = \"(0, 0)\"  # beside A1\n"),
        "{}",
        sheet.save()
    );
    sheet.undo();
    assert_eq!(sheet.save(), COMMENTED);
    // Without its cell a comment waits at the end; with it, it is back in its place.
    sheet.set("A1".parse().unwrap(), "");
    assert!(sheet.save().ends_with("# Above A1\n# beside A1\n# The end.\n"), "{}", sheet.save());
    sheet.undo();
    assert_eq!(sheet.save(), COMMENTED);
}
