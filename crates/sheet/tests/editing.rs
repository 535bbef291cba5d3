//! Copies, names, insertions and poles.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on must stop")]

mod common;

use common::{at, drawn, text};
use pforms_kernel::Error;
use pforms_sheet::{Clip, Range, Sheet, Target};

fn range(text: &str) -> Range {
    match Target::read(text).unwrap() {
        Target::Cells(range) => range,
        Target::Cell(at) => Range { first: at.into(), last: at.into() },
    }
}

fn sources(sheet: &Sheet) -> Vec<String> {
    sheet.document().cells().map(|(at, text)| format!("{at}: {text}")).collect()
}

#[test]
fn copies_shift_their_references() {
    let mut sheet: Sheet = drawn("A1: 1\n A2: =A1 + $A$1\n A4: 9\n B4: 8");
    let clip = sheet.copy(&range("A2:A3"));
    let clip: Clip = serde_json::from_str(&serde_json::to_string(&clip).unwrap()).unwrap();
    sheet.paste(&clip, at("B3")).unwrap();
    assert_eq!(sources(&sheet), ["A1: 1", "A2: =A1 + $A$1", "A4: 9", "B3: =B2 + $A$1"]);
    sheet.undo();
    let refused = sheet.paste(&clip, at("A1"));
    assert!(matches!(refused, Err(Error::Shape(_))));
    assert!(sheet.paste(&sheet.copy(&range("A1:B2")), at("ZZZ1000000")).is_err());
    assert_eq!(sources(&sheet), ["A1: 1", "A2: =A1 + $A$1", "A4: 9", "B4: 8"]);
}

#[test]
fn filling_repeats_a_formula() {
    let mut sheet: Sheet = drawn("A1: 1\n A2: =A1*2");
    sheet.fill(at("A2"), &range("A2:A11")).unwrap();
    sheet.recalculate_all();
    assert_eq!(text(&sheet, "A11"), "1024");
    assert!(matches!(sheet.fill(at("A2"), &range("B1:ZZZ9")), Err(Error::Limit { .. })));
    assert!(sheet.fill(at("A2"), &range("B1:B2")).is_err());
    sheet.undo();
    assert_eq!(sources(&sheet).len(), 2);
}

#[test]
fn names_are_renamed_everywhere() {
    let mut sheet: Sheet = drawn("A1: 3\n B1: =Side + side*2\n B2: side");
    sheet.set_name("side", "A1").unwrap();
    sheet.rename("SIDE", "côté").unwrap();
    sheet.recalculate_all();
    assert_eq!(sources(&sheet), ["A1: 3", "B1: =côté + côté*2", "B2: side"]);
    assert_eq!(text(&sheet, "B1"), "9");
    sheet.rename("côté", "Côté").unwrap();
    assert_eq!(sheet.document().names().map(|(name, _)| name).collect::<Vec<_>>(), ["Côté"]);
    sheet.set_name("other", "A1").unwrap();
    assert!(sheet.rename("côté", "other").is_err());
    assert!(sheet.rename("nobody", "somebody").is_err());
    for bad in ["A1", "", "1x", "a b", "TRUE", "vrai", "x(", "=x", "x:y", "x;y"] {
        assert!(sheet.set_name(bad, "A1").is_err(), "{bad}");
    }
}

#[test]
fn insertions_move_what_lies_beyond() {
    let mut sheet: Sheet = drawn(
        "A1: 1
         A2: 2
         A3: =A1 + A2
         B1: =A1:A2
         C9: =A3 + $A$3",
    );
    sheet.set_name("total", "A3").unwrap();
    let style = serde_json::json!({ "draw": ["points"] });
    sheet.set_show(at("A3"), style.as_object().cloned()).unwrap();
    let note = serde_json::json!({ "cell": "A3", "text": "the sum" });
    sheet.set_notes(vec![note.as_object().cloned().unwrap()]).unwrap();
    let before = sheet.save();
    sheet.insert_rows(2, 3).unwrap();
    assert_eq!(
        sources(&sheet),
        ["A1: 1", "A5: 2", "A6: =A1 + A5", "B1: =A1:A5", "C12: =A6 + $A$6"]
    );
    assert_eq!(sheet.document().target("total").unwrap().to_string(), "A6");
    assert!(sheet.document().show(at("A6")).is_some() && sheet.document().show(at("A3")).is_none());
    assert_eq!(sheet.document().notes()[0]["cell"], "A6");
    sheet.insert_columns(1, 1).unwrap();
    assert_eq!(sources(&sheet)[2], "B6: =B1 + B5");
    sheet.undo();
    sheet.undo();
    assert_eq!(sheet.save(), before);
    sheet.set(at("A1000000"), "1");
    assert!(sheet.insert_rows(1, 1).is_err());
}

#[test]
fn only_points_typed_in_cells_are_moved() {
    let mut sheet: Sheet = drawn(
        "A1: [ (sqrt(4)/2, 0, 1; 0.3), (0.1, 0.2,  0.3) ]
         A2: [[(0, 0), (1, 0)], [(0, 1), (1, 1)]]
         A3: (1, 2; 0)
         A4: =[(0, 0), (1, 1)]
         A5: [(0, 0), (1, 1]
         A6: 3",
    );
    assert_eq!(sheet.editable_poles(at("A1")), [[0], [1]]);
    assert_eq!(sheet.editable_poles(at("A2")), [[0, 0], [0, 1], [1, 0], [1, 1]]);
    assert_eq!(sheet.editable_poles(at("A3")), [[0; 0]]);
    for cell in ["A4", "A5", "A6", "A7"] {
        assert!(sheet.editable_poles(at(cell)).is_empty(), "{cell}");
        assert!(matches!(sheet.move_pole(at(cell), &[0], &[1.0, 2.0]), Err(Error::Shape(_))));
    }
    sheet.move_pole(at("A1"), &[0], &[1.0, 0.5, 1.0]).unwrap();
    let moved = "[ (sqrt(4)/2, 0.5, 1; 0.3), (0.1, 0.2,  0.3) ]";
    assert_eq!(sheet.document().text(at("A1")), moved);
    sheet.move_pole(at("A2"), &[1, 0], &[-1e-7, 3.0]).unwrap();
    sheet.recalculate_all();
    assert_eq!(sheet.document().text(at("A2")), "[[(0, 0), (1, 0)], [(-1e-7, 3), (1, 1)]]");
    sheet.move_pole(at("A3"), &[], &[4.0, 5.0]).unwrap();
    assert_eq!(sheet.document().text(at("A3")), "(4, 5; 0)");
    for (index, coordinates) in
        [(vec![2], vec![0.0; 3]), (vec![0], vec![0.0; 2]), (vec![0, 0], vec![0.0; 3])]
    {
        assert!(matches!(sheet.move_pole(at("A1"), &index, &coordinates), Err(Error::Shape(_))));
    }
    assert!(matches!(sheet.move_pole(at("A3"), &[], &[f64::NAN, 0.0]), Err(Error::Domain(_))));
}
