//! Formulas nobody would write: each has a value, an error among them, and none stops the sheet.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on must stop")]

mod common;

use common::{at, text};
use pforms_catalogue::{Arithmetic, Language, catalogue};
use pforms_kernel::Rational;
use pforms_sheet::Sheet;
use proptest::prelude::*;

/// Values that stand between the usual ones.
const ODD: [&str; 24] = [
    "0",
    "-1",
    "1/2",
    "3",
    "1e300",
    "1e-300",
    "0.1",
    "TRUE",
    "\"DIAG\"",
    "\"pS22\"",
    "(0, 0)",
    "(1, 2, 3; 0)",
    "(1, 2, 3; -1)",
    "(0, 0, 0; 0)",
    "(1,)",
    "[]",
    "[(0, 0), (1, 1)]",
    "[[(0, 0, 0), (1, 0, 1; 2)], [(0, 1, 0), (1, 1, 1; 0)]]",
    "[(0, 0), (1, 1, 1)]",
    "[[(0, 0)], [(1, 1), (2, 2)]]",
    "A1",
    "A2",
    "A1:A3",
    "Z9",
];

fn formula() -> impl Strategy<Value = String> {
    let names: Vec<&str> = catalogue().iter().map(|operator| operator.english[0]).collect();
    let odd = prop::sample::select(ODD.to_vec()).prop_map(str::to_owned);
    odd.prop_recursive(3, 12, 4, move |inner| {
        let call =
            (prop::sample::select(names.clone()), prop::collection::vec(inner.clone(), 0..4))
                .prop_map(|(name, arguments)| format!("{name}({})", arguments.join(", ")));
        let sign = prop::sample::select(vec!["+", "-", "*", "/", "^", "=", "<"]);
        let binary = (inner.clone(), sign, inner.clone())
            .prop_map(|(a, sign, b)| format!("({a}){sign}({b})"));
        let list =
            prop::collection::vec(inner, 0..3).prop_map(|items| format!("[{}]", items.join(", ")));
        prop_oneof![4 => call, 2 => binary, 1 => list]
    })
}

/// Computes the formula; says that everything can be shown.
fn survives<S: Arithmetic>(formula: &str) {
    let mut sheet = Sheet::<S>::new();
    sheet.set(at("A1"), "[[(0, 0, 0), (1, 0, 1)], [(0, 1, 0), (1, 1, 2; 0.5)]]");
    sheet.set(at("A2"), "2");
    sheet.set(at("A3"), &format!("={formula}"));
    sheet.recalculate_all();
    let value = sheet.value(at("A3"));
    let numbers = value.to_json()["poles"].to_string();
    assert!(value.is_error() || !numbers.contains("null,"), "{formula}: {numbers}");
    assert!(!text(&sheet, "A3").contains("NaN"), "{formula}");
    assert!(sheet.to_json(Language::French).to_string().len() > 2);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_formula_has_a_value(formula in formula()) {
        survives::<f64>(&formula);
        survives::<Rational>(&formula);
    }
}
