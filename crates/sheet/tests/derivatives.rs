//! D(result, source): derivatives through a sheet, against the same formulas differenced exactly.
#![allow(missing_docs, clippy::unwrap_used)]

use pforms_catalogue::Value;
use pforms_kernel::{Rational, Scalar};
use pforms_sheet::Sheet;

fn sheet(cells: &[(&str, &str)]) -> Sheet {
    let mut sheet = Sheet::new();
    for (at, text) in cells {
        sheet.set(at.parse().unwrap(), text);
    }
    sheet.recalculate_all();
    sheet
}

fn value(sheet: &Sheet, at: &str) -> Value {
    sheet.get(at).unwrap()
}

fn shown(sheet: &Sheet, at: &str) -> String {
    value(sheet, at).display(pforms_catalogue::Language::English)
}

const CHAIN: [(&str, &str); 8] = [
    ("A1", "[(0, 0, 0), (1, 0, 1), (2, 1, 0; 2)]"),
    ("A2", "[(0, 1, 0), (1, 2, 0), (2, 2, 1)]"),
    ("A3", "[(0, 3, 0; 1/2), (1, 3, 2), (3, 3, 0)]"),
    ("A4", "=MIR(A1, A2, A3)"),
    ("A5", "=DIAG(A4)"),
    ("A6", "=SPLIT(ELEVATE(A5, 1), 0, 1/3)"),
    ("A7", "=IMMERSE([(0, 0), (1/2, 1), (1, 1/4)], A4)"),
    ("A8", "=HODOGRAPH(TRANSLATE(ROTATE(A7, PI()/3), (1, 2, 3; 0)))"),
];

/// The coordinates and weights of the poles of a cell, with one number of A1 moved.
fn moved(cell: &str, index: usize, by: &Rational) -> Vec<Rational> {
    let mut sheet: Sheet<Rational> = Sheet::new();
    for (at, text) in CHAIN.iter().filter(|(at, _)| *at != "A8") {
        sheet.set(at.parse().unwrap(), text);
    }
    let first = ["0", "0", "0", "1", "1", "0", "1", "1", "2", "1", "0", "2"];
    let number = |(i, text): (usize, &&str)| {
        let x: Rational = text.parse().unwrap();
        if i == index { x + by.clone() } else { x }
    };
    let numbers: Vec<Rational> = first.iter().enumerate().map(number).collect();
    let pole = |p: &[Rational]| format!("({}, {}, {}; {})", p[0], p[1], p[2], p[3]);
    let poles: Vec<String> = numbers.chunks(4).map(pole).collect();
    sheet.set("A1".parse().unwrap(), &format!("[{}]", poles.join(", ")));
    sheet.recalculate_all();
    let mut found = Vec::new();
    euclidean(&sheet.get(cell).unwrap(), &mut found);
    found
}

fn euclidean(value: &Value<Rational>, into: &mut Vec<Rational>) {
    match value {
        Value::Form(form) => {
            for pole in form.homogeneous().chunks_exact(form.width()) {
                let w = &pole[form.ambient()];
                into.extend(pole[..form.ambient()].iter().map(|x| x / w));
                into.push(w.clone());
            }
        }
        Value::List(items) => items.iter().for_each(|item| euclidean(item, into)),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_chain_of_operators_has_the_derivatives_of_its_formula() {
    let sheet = sheet(&CHAIN);
    let step = Rational::ratio(1, 1 << 40);
    for cell in ["A4", "A5", "A6", "A7"] {
        let found = sheet.sensitivities(cell, "A1").unwrap();
        let matrix = found.matrix().unwrap();
        assert_eq!(matrix.columns(), 12);
        for index in 0..12 {
            let (ahead, behind) = (moved(cell, index, &step), moved(cell, index, &-step.clone()));
            for (row, (a, b)) in ahead.iter().zip(&behind).enumerate() {
                let slope = ((a - b) / (&step + &step)).to_f64();
                let given = matrix.row(row).find(|(i, _)| *i == index).map_or(0.0, |(_, x)| *x);
                // Central differences in exact arithmetic: off by third derivatives times 2⁻⁸⁰.
                assert!((given - slope).abs() < 1e-12, "{cell} {row} {index}: {given} {slope}");
            }
        }
        let weights: Vec<f64> = (0..matrix.rows()).map(|i| f64::from(i as u8 % 7) - 3.0).collect();
        let (backwards, forwards) =
            (found.gradient(&weights).unwrap(), matrix.transposed(&weights).unwrap());
        for (a, b) in backwards.iter().zip(&forwards) {
            assert!((a - b).abs() < 1e-11);
        }
    }
}

#[test]
fn formulas_of_numbers_follow_the_rules_of_calculus() {
    let sheet = sheet(&[
        ("A1", "2"),
        ("A2", "=A1^3"),
        ("A3", "=SQRT(A2) + SIN(A1)*EXP(-A1)"),
        ("B1", "=D(A2, A1)"),
        ("B2", "=D(A3, A1) - (1.5*SQRT(2) + EXP(-2)*(COS(2) - SIN(2)))"),
        ("B3", "=D([A1, A2, 7], A1)"),
        ("B4", "=D(A1*A2, A1:A2)"),
        ("B5", "=D(A2^A1, A1) - 64*(LN(8) + 2*12/8)"),
        ("B6", "=D(IF(A1 > 1, 5*A1, A1), A1)"),
        ("B7", "=D(7, A1)"),
    ]);
    assert_eq!(shown(&sheet, "B1"), "12");
    let Value::Number(error) = value(&sheet, "B2") else { panic!() };
    assert!(error.abs() < 1e-15);
    assert_eq!(shown(&sheet, "B3"), "[1, 12, 0]");
    assert_eq!(shown(&sheet, "B4"), "[8, 2]");
    let Value::Number(error) = value(&sheet, "B5") else { panic!("{}", shown(&sheet, "B5")) };
    assert!(error.abs() < 1e-12);
    assert_eq!(shown(&sheet, "B6"), "5");
    assert_eq!(shown(&sheet, "B7"), "0");
}

#[test]
fn what_has_no_derivative_says_so() {
    let sheet = sheet(&[
        ("A1", "[(0, 0), (1, 1), (2, 0)]"),
        ("A2", "=PROJECT(A1, (1, 2), part=\"distance\")"),
        ("A3", "=REDUCE(ELEVATE(A1, 1), 1, \"bound\")"),
        ("A4", "hello"),
        ("A5", "=A5 + 1"),
        ("A6", "=MI((0, 0), (1, 1))"),
        ("B1", "=D(A2, A1)"),
        ("B2", "=D(A1, (1, 2))"),
        ("B3", "=D(A1)"),
        ("B4", "=D(A1, C9)"),
        ("B5", "=D(A4, A1)"),
        ("B6", "=D(A1, A4)"),
        ("B7", "=D(A5, A1)"),
        ("B8", "=D(PROJECT(A6, (1, 2), part=\"distance\"), A1)"),
        ("B9", "=D(D(A1, A1), A1)"),
        ("B10", "=D(POINT(A1, 1/2), A1)"),
        ("B11", "=D(SQRT(0*POLE(A1, 0)), A1)"),
    ]);
    for at in ["B1", "B2", "B3", "B4", "B5", "B6", "B7", "B9", "B11"] {
        assert!(value(&sheet, at).is_error(), "{at}: {}", shown(&sheet, at));
    }
    // What does not depend on the source may be measured.
    assert!(!value(&sheet, "B8").is_error(), "{}", shown(&sheet, "B8"));
    assert!(!value(&sheet, "B10").is_error());
    assert!(shown(&sheet, "B1").contains("derivative") || value(&sheet, "B1").is_error());
}

#[test]
fn exact_sheets_are_asked_for_floating_numbers() {
    let mut sheet: Sheet<Rational> = Sheet::new();
    sheet.set("A1".parse().unwrap(), "2");
    sheet.set("A2".parse().unwrap(), "=D(A1^2, A1)");
    sheet.recalculate_all();
    assert!(sheet.get("A2").unwrap().is_error());
    assert!(sheet.sensitivities("A1", "A1").is_err());
}
