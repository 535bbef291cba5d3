//! The figures of the book, computed; the octant and the arc of Viviani among them.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on must stop")]

mod common;

use common::{at, drawn, gallery, text};
use pforms_catalogue::{Arithmetic, Language, Value, catalogue};
use pforms_kernel::{Form, Rational, Scalar};
use pforms_sheet::Sheet;

fn computed<S: Arithmetic>(name: &str, source: &str) -> Sheet<S> {
    let mut sheet = Sheet::open(source).unwrap_or_else(|error| panic!("{name}: {error}"));
    sheet.recalculate_all();
    sheet
}

fn errors<S: Arithmetic>(sheet: &Sheet<S>) -> Vec<String> {
    let failures = sheet.addresses().filter_map(|at| sheet.value(at).failure());
    failures.map(ToString::to_string).collect()
}

/// Does the sheet call something that leaves the fractions?
fn leaves_fractions(source: &str) -> bool {
    let source = source.to_uppercase();
    let rounding = catalogue()
        .iter()
        .filter(|entry| serde_json::to_value(entry).is_ok_and(|entry| entry["exact"] == false));
    let mut names = rounding.flat_map(|entry| entry.english.iter().chain(entry.french));
    names.any(|name| source.contains(&format!("{name}(")))
        || ["SQRT(", "RACINE(", "COS(", "SIN(", "TAN(", "RADIANS(", "PI", "\"AREA\""]
            .iter()
            .any(|call| source.contains(call))
}

#[test]
fn every_sheet_computes_and_polynomial_ones_exactly() {
    let mut exact_ones = 0;
    for (name, source) in gallery() {
        let floating = computed::<f64>(&name, &source);
        assert_eq!(errors(&floating), [""; 0], "{name}");
        assert!(floating.addresses().count() > 0, "{name}");
        let document = floating.document();
        assert!(
            document.shown().all(|(at, _)| !document.text(at).is_empty()),
            "{name} shows nothing"
        );
        let cells: String = document.cells().map(|(_, text)| text).collect();
        if leaves_fractions(&cells) {
            continue;
        }
        let exact = computed::<Rational>(&name, &source);
        assert_eq!(errors(&exact), [""; 0], "{name}, exactly");
        for at in exact.addresses() {
            if let (Value::Form(exact), Value::Form(floating)) =
                (exact.value(at), floating.value(at))
            {
                assert!(distance(exact, floating) < 1e-13, "{name}, {at}");
            }
        }
        exact_ones += 1;
    }
    assert!(exact_ones > 10, "{exact_ones}");
}

fn distance(exact: &Form<Rational>, floating: &Form) -> f64 {
    assert_eq!(exact.orders(), floating.orders());
    let size = exact.homogeneous().iter().map(|x| Scalar::to_f64(x).abs()).fold(1.0, f64::max);
    let pairs = exact.homogeneous().iter().zip(floating.homogeneous());
    pairs.map(|(x, y)| (Scalar::to_f64(x) - y).abs()).fold(0.0, f64::max) / size
}

#[test]
fn the_octant_lies_on_the_sphere_and_its_diagonal_on_the_cylinder() {
    let octant = gallery().into_iter().find(|(name, _)| name == "octant").unwrap().1;
    let sheet = computed::<f64>("octant", &octant);
    let Value::Form(sphere) = sheet.get("octant").unwrap() else { panic!("no form") };
    let Value::Form(viviani) = sheet.get("viviani").unwrap() else { panic!("no form") };
    assert_eq!(
        (sphere.kind().to_string(), viviani.kind().to_string()),
        ("pS33".into(), "pL5".into())
    );
    for i in 0..=20 {
        for j in 0..=20 {
            let point = sphere.at(&[f64::from(i) / 20.0, f64::from(j) / 20.0]).unwrap();
            let radius = point.iter().map(|x| x * x).sum::<f64>();
            assert!((radius - 1.0).abs() < 1e-14, "{point:?}");
        }
        let on_curve = viviani.at(&[f64::from(i) / 20.0]).unwrap();
        let on_sphere = sphere.at(&[f64::from(i) / 20.0, f64::from(i) / 20.0]).unwrap();
        assert!(on_curve.iter().zip(&on_sphere).all(|(a, b)| (a - b).abs() < 1e-14));
    }
}

#[test]
fn an_octant_of_fractions_is_a_sphere_exactly() {
    // The quarter circle (1 − t², 2t)/(1 + t²) has rational weights 1, 1, 2.
    let sheet: Sheet<Rational> = drawn(
        "A1: [(1, 0, 0; 1), (1, 1, 0; 1), (0, 1, 0; 2)]
         B1: =A1
         C1: =POINT(B1, 1/3)
         C2: =COORDINATES(C1)
         C3: =ITEM(C2, 0)^2 + ITEM(C2, 1)^2",
    );
    assert_eq!(text(&sheet, "C1"), "(4/5, 3/5, 0)");
    assert_eq!(text(&sheet, "C3"), "1");
}

#[test]
fn numbers_stay_exact_fractions() {
    let sheet: Sheet<Rational> =
        drawn("A1: 1/3\n A2: 0.1\n A3: =A1 + A2\n A4: =SQRT(2)\n A5: =SQRT(4/9)");
    assert_eq!(text(&sheet, "A3"), "13/30");
    assert!(text(&sheet, "A4").contains("floating mode"));
    assert_eq!(text(&sheet, "A5"), "2/3");
}

#[test]
fn a_condition_computes_only_the_branch_it_takes() {
    let sheet: Sheet = drawn(
        "A1: 0
         A2: =IF(A1 = 0, 5, 1/A1)
         A3: =IF(A1 <> 0, 1/A1, A9)
         A4: =SI(1/A1 > 0, 1, 2)
         A5: =IFERROR(1/A1, 7)
         A6: =IF(A1, 1, 2)",
    );
    assert_eq!(text(&sheet, "A2"), "5");
    assert_eq!(text(&sheet, "A3"), "");
    assert!(text(&sheet, "A4").starts_with("! A4: "));
    assert_eq!(text(&sheet, "A5"), "7");
    assert!(text(&sheet, "A6").starts_with("! A6: "));
}

#[test]
fn ranges_spread_and_lists_are_curves() {
    let mut sheet: Sheet = drawn(
        "A1: [(0, 0), (1, 0)]
         A2: [(0, 1), (1, 1)]
         A3: [(0, 2), (1, 3)]
         B1: =MIR(A1:A3)
         B2: =MIR(A1, A2, A3)
         B3: =MIR(rows)
         B4: =MIR([(0, 0), (1, 1), (2, 0)])
         B5: =MI(A1:A3) + (0, 0, 1; 0)
         B6: =MIR(A1, [(0, 0), (1, 1), (2, 2, 2)])
         B7: =EXPLAIN(DIAG, \"pS22\")",
    );
    sheet.set_name("rows", "A1:A3").unwrap();
    sheet.recalculate_all();
    let value = |cell: &str| sheet.value(at(cell)).to_json();
    assert_eq!(value("B1")["kind"], "pS32");
    assert_eq!(value("B1"), value("B2"));
    assert_eq!(value("B1"), value("B3"));
    assert_eq!(text(&sheet, "B4"), "pL3 · 2D");
    assert!(text(&sheet, "B5").starts_with("! B5: "), "2D and 3D: {}", text(&sheet, "B5"));
    assert!(text(&sheet, "B6").starts_with("! B6: "));
    assert!(text(&sheet, "B7").contains("q1 = (p01 + p10)/2"), "{}", text(&sheet, "B7"));
}

#[test]
fn results_beyond_the_cap_are_refused_before_they_are_made() {
    let sheet: Sheet = drawn(
        "A1: [[(0, 0, 0), (1, 0, 0)], [(0, 1, 0), (1, 1, 1)]]
         A2: =ELEVATE(MIR(A1, A1), 1000)
         A3: =ELEVATE(A1, 1e300)
         A4: =SUBDIVIDE(A1, 40)
         A5: =(0, 0)",
    );
    for cell in ["A2", "A3", "A4"] {
        let failure = sheet.value(at(cell)).failure().cloned().expect(cell);
        assert!(failure.origin() == Some(cell), "{failure}");
    }
    assert!(text(&sheet, "A2").contains("refused"), "{}", text(&sheet, "A2"));
    assert_eq!(text(&sheet, "A5"), "(0, 0)");
    let french = sheet.info(at("A2"), Language::French).error.unwrap();
    assert!(french.message(Language::French).contains("refusé"), "{french}");
}
