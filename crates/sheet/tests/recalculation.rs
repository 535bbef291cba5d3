//! What is computed again, and in what order.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on must stop")]

mod common;

use common::{at, drawn, shown, text};
use pforms_catalogue::Language;
use pforms_sheet::{Cancel, Report, Sheet};

fn changed(report: &Report) -> String {
    report.changed.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

#[test]
fn exactly_what_depends_on_a_change_is_computed_again() {
    let mut sheet: Sheet = drawn(
        "A1: 1
         A2: 10
         B1: =A1 + 1
         B2: =A2 * 2
         C1: =B1 + B2
         D1: =C1 + A1
         E1: =[B2, 5]",
    );
    assert_eq!(text(&sheet, "D1"), "23");
    sheet.set(at("A1"), "2");
    assert_eq!(changed(&sheet.recalculate_all()), "A1 B1 C1 D1");
    sheet.set(at("A2"), "20");
    assert_eq!(changed(&sheet.recalculate_all()), "A2 B2 C1 D1 E1");
    sheet.set(at("D1"), "=1");
    assert_eq!(changed(&sheet.recalculate_all()), "D1");
    sheet.set(at("A1"), "2");
    assert_eq!(changed(&sheet.recalculate_all()), "");
    assert_eq!(changed(&sheet.recalculate_all()), "");
}

#[test]
fn ranges_and_names_are_dependencies() {
    let mut sheet: Sheet = drawn(
        "A1: (0, 0)
         A2: (1, 1)
         A3: (2, 0)
         B1: =A1:A3
         C1: =base",
    );
    assert_eq!(text(&sheet, "B1"), "pL3 · 2D");
    assert!(text(&sheet, "C1").contains("nothing is called base"));
    sheet.set_name("Base", "A2").unwrap();
    assert_eq!(changed(&sheet.recalculate_all()), "C1");
    assert_eq!(text(&sheet, "C1"), "(1, 1)");
    sheet.set(at("A2"), "(5, 5)");
    assert_eq!(changed(&sheet.recalculate_all()), "A2 B1 C1");
    sheet.set_name("base", "A1:A2").unwrap();
    assert_eq!(changed(&sheet.recalculate_all()), "C1");
    assert_eq!(text(&sheet, "C1"), "pL2 · 2D");
    sheet.set(at("A4"), "(9, 9)");
    assert_eq!(changed(&sheet.recalculate_all()), "A4");
    sheet.set_name("base", "").unwrap();
    assert_eq!(changed(&sheet.recalculate_all()), "C1");
    assert!(text(&sheet, "C1").starts_with("! C1"));
}

#[test]
fn emptied_cells_are_reported_and_missed() {
    let mut sheet: Sheet = drawn("A1: 1\n B1: =A1 + 1\n C1: =A1");
    sheet.set(at("A1"), "");
    assert_eq!(changed(&sheet.recalculate_all()), "A1 B1 C1");
    assert_eq!(
        text(&sheet, "B1"),
        "! B1: A1: received an empty cell, expected a value (type a value into A1)"
    );
    assert_eq!(text(&sheet, "C1"), "");
}

#[test]
fn the_cells_of_a_circle_are_named_and_the_others_go_on() {
    let mut sheet: Sheet = drawn(
        "A1: =B2 + 1
         B2: =A1
         C1: =A1 + 1
         D1: =D1
         E1: =1 + 1
         F1: =G1:G3
         G2: =F1",
    );
    let way = |cell: &str, round: &str| {
        let hint = "change one of them so that it does without the next";
        format!("! {cell}: cells that need one another: {round} ({hint})")
    };
    assert_eq!(text(&sheet, "A1"), way("A1", "A1 → B2 → A1"));
    assert_eq!(text(&sheet, "B2"), way("B2", "A1 → B2 → A1"));
    assert_eq!(text(&sheet, "C1"), way("A1", "A1 → B2 → A1"));
    assert_eq!(text(&sheet, "D1"), way("D1", "D1 → D1"));
    assert_eq!(text(&sheet, "E1"), "2");
    assert_eq!(text(&sheet, "F1"), way("F1", "F1 → G2 → F1"));
    sheet.set(at("B2"), "4");
    assert_eq!(changed(&sheet.recalculate_all()), "B2 A1 C1");
    assert_eq!(text(&sheet, "C1"), "6");
}

#[test]
fn errors_keep_their_origin_on_the_way() {
    let sheet: Sheet = drawn("A1: =1/0\n A2: =A1 + 1\n A3: =[A2, 3]\n A4: =(A3, 1)");
    for cell in ["A1", "A2", "A3", "A4"] {
        assert!(text(&sheet, cell).starts_with("! A1: "), "{}", text(&sheet, cell));
    }
}

#[test]
fn a_broken_formula_tells_where() {
    let sheet: Sheet = drawn("A1: =(1, 2\n A2: =foo(1)\n A3: =(1, [2])\n A4: =1 +");
    assert!(text(&sheet, "A1").starts_with("! A1: formula, line 1, column "));
    assert!(text(&sheet, "A2").contains("there is no operator foo"));
    assert!(text(&sheet, "A3").contains("point: received [2], list, expected numbers"));
    assert!(text(&sheet, "A4").starts_with("! A4: formula, line 1, column "));
}

#[test]
fn gaps_in_a_range_are_errors_and_empty_ends_are_not() {
    let sheet: Sheet = drawn(
        "A1: (0, 0)
         A3: (1, 1)
         B1: =A1:A3
         B2: =A3:A9
         C1: (0, 0)
         D1: (1, 0)
         C2: (0, 1)
         D2: (1, 1)
         E1: =C1:D9
         E2: =A1:ZZZ1000000",
    );
    assert!(text(&sheet, "B1").contains("A2: received an empty cell"));
    assert_eq!(text(&sheet, "B2"), "pL1 · 2D");
    assert_eq!(text(&sheet, "E1"), "pS22 · 2D");
    assert!(text(&sheet, "E2").contains("E2"), "it holds itself: {}", text(&sheet, "E2"));
}

#[test]
fn ranges_are_as_long_as_what_they_hold() {
    let sheet: Sheet = drawn(
        "B1: (0, 0)
         C1: (1, 0)
         B2: (0, 1)
         C2: (1, 1)
         A1: =B1:ZZZ1000000
         A2: =D1:ZZZ1000000
         A3: =MIR(D1:D1000000)
         A4: =C1:ZZZ2
         A5: =A4:A3",
    );
    assert_eq!(text(&sheet, "A1"), "pS22 · 2D");
    assert_eq!(text(&sheet, "A2"), "[]");
    assert!(text(&sheet, "A3").starts_with("! A3: MIR, forms"), "{}", text(&sheet, "A3"));
    assert_eq!(text(&sheet, "A4"), "pS21 · 2D");
    assert!(text(&sheet, "A5").starts_with("! A3: "), "{}", text(&sheet, "A5"));
}

#[test]
fn a_chain_of_a_hundred_thousand_cells() {
    let mut sheet: Sheet = Sheet::new();
    sheet.set(at("A1"), "1");
    for row in 2..=100_000 {
        sheet.set(at(&format!("A{row}")), &format!("=A{}+1", row - 1));
    }
    assert_eq!(sheet.recalculate_all().changed.len(), 100_000);
    assert_eq!(text(&sheet, "A100000"), "100000");
    sheet.set(at("A1"), "=A100000");
    sheet.recalculate_all();
    assert!(text(&sheet, "A500").contains("cells that need one another: A1 → A100000 → A99999 → "));
    sheet.set(at("A1"), "2");
    sheet.recalculate_all();
    assert_eq!(text(&sheet, "A100000"), "100001");
}

#[test]
fn formulas_without_measure() {
    let mut sheet: Sheet = Sheet::new();
    sheet.set(at("A1"), &format!("={}1", "1+".repeat(50_000)));
    sheet.set(at("A2"), &format!("={}1{}", "(".repeat(10_000), ")".repeat(10_000)));
    sheet.set(at("A3"), &format!("={}1{}", "[".repeat(10_000), "]".repeat(10_000)));
    sheet.set(at("A4"), &format!("={}1", "-".repeat(10_000)));
    sheet.set(at("A5"), &"(".repeat(100_000));
    sheet.set(at("A6"), &format!("={}1{}", "SQRT(".repeat(200), ")".repeat(200)));
    sheet.set(at("A7"), &format!("=[{}]", vec!["(1,2,3)"; 12_500].join(",")));
    sheet.set(at("A8"), &format!("={}", "2^".repeat(240) + "1"));
    sheet.recalculate_all();
    assert_eq!(text(&sheet, "A1"), "50001");
    for cell in ["A3", "A4", "A5"] {
        assert!(text(&sheet, cell).starts_with('!'), "{cell}");
    }
    assert_eq!(text(&sheet, "A6"), "1");
    assert_eq!(text(&sheet, "A7"), "pL12500 · 3D");
}

#[test]
fn a_formula_as_deep_as_allowed_needs_little_stack() {
    let evaluate = || {
        let mut sheet: Sheet = Sheet::new();
        sheet.set(at("A1"), &format!("={}1{}", "SQRT(".repeat(250), ")".repeat(250)));
        sheet.set(at("A2"), &format!("={}1{}", "[".repeat(60), "]".repeat(60)));
        sheet.recalculate_all();
        text(&sheet, "A1")
    };
    let small = std::thread::Builder::new().stack_size(512 * 1024);
    assert_eq!(small.spawn(evaluate).unwrap().join().unwrap(), "1");
}

#[test]
fn a_budget_stops_and_goes_on() {
    let mut sheet: Sheet = Sheet::new();
    // Each look at this clock takes a second.
    sheet.set_clock(|| {
        use std::sync::atomic::{AtomicU32, Ordering};
        static TICKS: AtomicU32 = AtomicU32::new(0);
        f64::from(TICKS.fetch_add(1, Ordering::Relaxed))
    });
    for row in 1..=20 {
        sheet.set(at(&format!("A{row}")), "=1+1");
    }
    let token = Cancel::new().with_budget(10.0);
    let first = sheet.recalculate(&token);
    assert!(first.remaining > 0 && !first.changed.is_empty());
    assert!(sheet.info(at("A20"), Language::English).pending);
    let mut rounds = 1;
    while sheet.recalculate(&token).remaining > 0 {
        rounds += 1;
    }
    assert!((2..20).contains(&rounds), "{rounds}");
    assert_eq!(text(&sheet, "A20"), "2");
    assert_eq!(sheet.info(at("A20"), Language::English).cost.seconds, Some(1.0));
    let none = sheet.recalculate(&Cancel::new().with_budget(0.0));
    assert_eq!(none.changed.len(), 0);
}

#[test]
fn a_cancelled_token_leaves_everything_to_do() {
    let mut sheet: Sheet = drawn("A1: 1\n A2: =A1");
    sheet.set(at("A1"), "2");
    let token = Cancel::new();
    token.clone().cancel();
    let report = sheet.recalculate(&token);
    assert_eq!((report.changed.len(), report.remaining), (0, 2));
    assert_eq!(shown(&sheet), ["A1: 1", "A2: 1"]);
    sheet.recalculate_all();
    assert_eq!(shown(&sheet), ["A1: 2", "A2: 2"]);
}

#[test]
fn text_and_odd_cells() {
    let sheet: Sheet = drawn(
        "A1: two towers
         A2: '=A1
         A3: ((1, 2)
         B1: =A1
         B2: =A1 + 1
         B3: =\"a \"\"b\"\"\"
         B4: =TRUE
         B5: =vrai",
    );
    assert_eq!(text(&sheet, "A2"), "=A1");
    assert!(text(&sheet, "A3").starts_with("! A3: formula"));
    assert_eq!(text(&sheet, "B1"), "two towers");
    assert!(text(&sheet, "B2").starts_with("! B2: "));
    assert_eq!(text(&sheet, "B3"), "a \"b\"");
    assert_eq!(text(&sheet, "B4"), text(&sheet, "B5"));
}

#[test]
fn vanishing_numbers_are_errors() {
    let sheet: Sheet = drawn("A1: (1, 2; 0)\n A2: =1e308*10\n A3: =(1e999, 0)\n A4: =0/0");
    assert_eq!(text(&sheet, "A1"), "(1, 2; 0)");
    for cell in ["A2", "A3", "A4"] {
        assert!(text(&sheet, cell).starts_with(&format!("! {cell}: ")), "{}", text(&sheet, cell));
    }
}

#[test]
fn a_chain_typed_backwards_takes_no_longer() {
    let mut sheet: Sheet = Sheet::new();
    for row in (2..=50_000).rev() {
        sheet.set(at(&format!("A{row}")), &format!("=A{}+1", row - 1));
    }
    sheet.set(at("A1"), "1");
    assert_eq!(sheet.recalculate_all().changed.first(), Some(&at("A1")));
    assert_eq!(text(&sheet, "A50000"), "50000");
}

#[test]
fn a_sheet_may_go_to_another_thread() {
    fn goes<T: Send + Sync>() {}
    goes::<Sheet>();
    goes::<Sheet<pforms_kernel::Rational>>();
    goes::<Cancel>();
}
