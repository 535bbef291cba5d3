//! Undo, redo, gestures, and what survives a crash.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on must stop")]

mod common;

use common::{at, drawn};
use pforms_catalogue::Language;
use pforms_sheet::{Entry, Range, Settings, Sheet, Snapshot, Target};
use proptest::prelude::*;

fn range(text: &str) -> Range {
    match Target::read(text).unwrap() {
        Target::Cells(range) => range,
        Target::Cell(at) => Range { first: at.into(), last: at.into() },
    }
}

fn style(count: i64) -> Settings {
    let mut settings = Settings::new();
    settings.insert("count".into(), count.into());
    settings
}

/// Something a person does, some of it refused.
#[derive(Clone, Debug)]
enum Gesture {
    Set(u32, u32, String),
    Clear(u32),
    Name(u8, u32),
    Rename(u8, u8),
    Show(u32, Option<i64>),
    Camera(i64),
    Notes(i64),
    Title(String),
    InsertRows(u32),
    InsertColumns(u32),
    Paste(u32, u32),
    Fill(u32),
    Drag(u32, Vec<i8>),
    Undo,
    Redo,
}

fn gestures() -> impl Strategy<Value = Vec<Gesture>> {
    let sources = ["1", "", "=A1+1", "=B2:C3", "(1, 2)", "[(0,0),(1,1)]", "=x1a", "text", "=$A$1"];
    let text = prop::sample::select(sources.to_vec()).prop_map(str::to_owned);
    let place = 1u32..5;
    let one = prop_oneof![
        6 => (place.clone(), place.clone(), text).prop_map(|(c, r, t)| Gesture::Set(c, r, t)),
        1 => place.clone().prop_map(Gesture::Clear),
        1 => (0u8..3, place.clone()).prop_map(|(n, r)| Gesture::Name(n, r)),
        1 => (0u8..3, 0u8..3).prop_map(|(a, b)| Gesture::Rename(a, b)),
        1 => (place.clone(), prop::option::of(0i64..3)).prop_map(|(r, s)| Gesture::Show(r, s)),
        1 => (0i64..3).prop_map(Gesture::Camera),
        1 => (0i64..3).prop_map(Gesture::Notes),
        1 => "[a-b]{0,2}".prop_map(Gesture::Title),
        1 => place.clone().prop_map(Gesture::InsertRows),
        1 => place.clone().prop_map(Gesture::InsertColumns),
        1 => (place.clone(), place.clone()).prop_map(|(c, r)| Gesture::Paste(c, r)),
        1 => place.clone().prop_map(Gesture::Fill),
        1 => (place, prop::collection::vec(any::<i8>(), 0..4)).prop_map(|(r, m)| Gesture::Drag(r, m)),
        2 => Just(Gesture::Undo),
        1 => Just(Gesture::Redo),
    ];
    prop::collection::vec(one, 0..30)
}

fn act(sheet: &mut Sheet, gesture: Gesture) {
    let cell = |column, row| pforms_sheet::Address::new(column, row).unwrap();
    let name = |n: u8| ["x1a", "Été", "X1A"][usize::from(n)];
    match gesture {
        Gesture::Set(column, row, text) => sheet.set(cell(column, row), &text),
        Gesture::Clear(row) => sheet.clear(&range(&format!("A{row}:C9"))),
        Gesture::Name(n, row) => sheet.set_name(name(n), &format!("A{row}")).unwrap(),
        Gesture::Rename(a, b) => drop(sheet.rename(name(a), name(b))),
        Gesture::Show(row, count) => sheet.set_show(cell(1, row), count.map(style)).unwrap(),
        Gesture::Camera(count) => sheet.set_camera(style(count)).unwrap(),
        Gesture::Notes(count) => sheet.set_notes(vec![style(count)]).unwrap(),
        Gesture::Title(text) => sheet.set_title("fr", &text).unwrap(),
        Gesture::InsertRows(before) => sheet.insert_rows(before, 1).unwrap(),
        Gesture::InsertColumns(before) => sheet.insert_columns(before, 2).unwrap(),
        Gesture::Paste(column, row) => {
            let clip = sheet.copy(&range("A1:B2"));
            drop(sheet.paste(&clip, cell(column, row)));
        }
        Gesture::Fill(row) => drop(sheet.fill(cell(1, row), &range("B1:B4"))),
        Gesture::Drag(row, moves) => {
            sheet.begin_gesture();
            for x in moves {
                drop(sheet.move_pole(cell(1, row), &[], &[f64::from(x), 0.5]));
                sheet.recalculate_all();
            }
            sheet.end_gesture();
        }
        Gesture::Undo => drop(sheet.undo()),
        Gesture::Redo => drop(sheet.redo()),
    }
}

/// All that is shown, to compare a sheet with one computed from its file.
fn everything(sheet: &mut Sheet) -> serde_json::Value {
    sheet.recalculate_all();
    let mut json = sheet.to_json(Language::English);
    for cell in json["cells"].as_object_mut().unwrap().values_mut() {
        cell["cost"]["seconds"] = serde_json::Value::Null;
    }
    json
}

proptest! {
    #[test]
    fn undo_all_is_the_beginning_and_redo_all_the_end(first in gestures(), then in gestures()) {
        let mut sheet = Sheet::new();
        for gesture in first {
            act(&mut sheet, gesture);
        }
        let mut sheet = Sheet::<f64>::open(&sheet.save()).unwrap();
        let beginning = sheet.save();
        for gesture in then {
            act(&mut sheet, gesture);
        }
        let end = sheet.save();
        let values = everything(&mut sheet);
        while sheet.undo() {}
        prop_assert_eq!(sheet.save(), beginning);
        prop_assert!(!sheet.can_undo());
        while sheet.redo() {}
        while sheet.can_redo() { prop_assert!(sheet.redo()); }
        let again = Sheet::<f64>::open(&sheet.save()).unwrap();
        prop_assert_eq!(everything(&mut again.clone()), everything(&mut sheet));
        if !sheet.can_redo() && sheet.save() == end {
            prop_assert_eq!(everything(&mut sheet), values);
        }
    }

    #[test]
    fn a_crash_loses_nothing(before in gestures(), after in gestures()) {
        let mut sheet = Sheet::new();
        for gesture in before {
            act(&mut sheet, gesture);
        }
        let snapshot = sheet.snapshot();
        let kept = serde_json::to_string(&snapshot).unwrap();
        for gesture in after {
            act(&mut sheet, gesture);
        }
        let log: String = sheet.log().iter().map(|entry| entry.line() + "\n").collect();
        let cut = format!("{log}{{\"step\":[{{\"edit\":\"ce");
        let snapshot = serde_json::from_str(&kept).unwrap();
        let mut again = Sheet::<f64>::recover(&snapshot, &Entry::read_lines(&cut)).unwrap();
        prop_assert_eq!(again.save(), sheet.save());
        loop {
            let (a, b) = (again.undo(), sheet.undo());
            prop_assert_eq!((a, again.save()), (b, sheet.save()));
            if !a { break; }
        }
        while sheet.redo() {
            prop_assert!(again.redo());
        }
        prop_assert_eq!(everything(&mut again), everything(&mut sheet));
    }
}

#[test]
fn a_drag_is_one_step() {
    let mut sheet: Sheet = drawn("A1: (0, 0)\n A2: =A1");
    sheet.begin_gesture();
    for x in [0.25, 0.5, 0.75] {
        sheet.move_pole(at("A1"), &[], &[x, 1.0]).unwrap();
        sheet.recalculate_all();
    }
    sheet.end_gesture();
    assert_eq!(sheet.document().text(at("A1")), "(0.75, 1)");
    sheet.undo();
    assert_eq!(sheet.document().text(at("A1")), "(0, 0)");
    sheet.redo();
    assert_eq!(sheet.document().text(at("A1")), "(0.75, 1)");
    sheet.begin_gesture();
    sheet.set(at("A1"), "1");
    sheet.set(at("A1"), "(0.75, 1)");
    sheet.end_gesture();
    assert!(sheet.undo());
    assert_eq!(sheet.document().text(at("A1")), "(0, 0)");
    assert!(sheet.can_redo());
}

#[test]
fn a_damaged_snapshot_is_refused() {
    let mut sheet: Sheet = drawn("A1: 1");
    let mut snapshot = sheet.snapshot();
    snapshot.document.truncate(20);
    assert!(Sheet::<f64>::recover(&snapshot, &[]).is_err());
    let log = Entry::read_lines(r#"{"step":[{"edit":"camera","settings":{"zoom":null}}]}"#);
    assert_eq!(log.len(), 1);
    assert!(Sheet::<f64>::recover(&Snapshot::default(), &log).is_err());
    let name = Entry::read_lines(r#"{"step":[{"edit":"name","name":"A1","target":"A1"}]}"#);
    assert!(Sheet::<f64>::recover(&sheet.snapshot(), &name).is_err());
    assert!(Entry::read_lines(r#"{"step":[{"edit":"cell","at":"A0","text":""}]}"#).is_empty());
}
