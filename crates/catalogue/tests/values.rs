//! Values: what a cell settles to, how it is shown, what it refuses.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use pforms_catalogue::{Arithmetic, DEPTH_CAP, Failure, LIST_CAP, Language, Value};
use pforms_kernel::{Error, Rational, Scalar};

mod reader;

fn value(text: &str) -> Value {
    reader::compute(text)
}

fn settled(text: &str) -> Value {
    value(text).settle()
}

fn message(value: &Value) -> &str {
    value.failure().expect("an error").message(Language::English)
}

#[test]
fn nets_of_points_become_forms() {
    assert_eq!(settled("=[(0, 0, 0), (1, 1, 0)]").kind(Language::English), "pL2");
    assert_eq!(
        settled("=[[(0, 0), (1, 0), (2, 1)], [(0, 1), (1, 1), (2, 2)]]").orders(),
        Some(vec![2, 3])
    );
    assert_eq!(settled("=[1, 2]").kind(Language::French), "liste");
    assert!(matches!(settled("=[[(0, 0), (1, 0)], 3]"), Value::List(_)));
    assert!(matches!(settled("=[]"), Value::List(_)));
}

#[test]
fn irregular_nets_name_the_lengths() {
    let ragged = settled("=[[(0, 0), (1, 0)], [(0, 1), (1, 1), (2, 1)]]");
    assert_eq!(message(&ragged), "list: received rows of 2, 3, expected rows of one length");
    let mixed = settled("=[(0, 0), [(0, 1)]]");
    assert_eq!(message(&mixed), "list: received rows of ·, 1, expected rows of one length");
    let dimensions = settled("=[(0, 0), (0, 0, 1)]");
    assert_eq!(message(&dimensions), "list: received 2D, 3D, expected points of one dimension");
    assert!(ragged.failure().unwrap().message(Language::French).contains("rangées de 2, 3"));
}

#[test]
fn short_texts_of_a_cell() {
    let shows = |text: &str| settled(text).display(Language::English);
    assert_eq!(shows("=(1, 2, 3)"), "(1, 2, 3)");
    assert_eq!(shows("=(1, 2, 3; 0.5)"), "(1, 2, 3; 0.5)");
    assert_eq!(shows("=(0, 0, 1; 0)"), "(0, 0, 1; 0)");
    assert_eq!(shows("=(2,)"), "(2,)");
    assert_eq!(shows("=[(1, 0), (1, 1; 1/2), (0, 1)]"), "pL3 · 2D · rational");
    assert_eq!(shows("=[1, 2, \"a\", TRUE]"), "[1, 2, a, TRUE]");
    assert_eq!(shows("=SEQUENCE(1, 9)"), "[1, 2, 3, 4, 5, 6, … (9)]");
    assert_eq!(shows("=[[1, [2, 3], []], 4]"), "[[1, [… (2)], []], 4]");
    assert_eq!(shows("=SUBDIVIDE([(0, 0), (1, 2), (2, 0)], 2)"), "spline of 4 pL3 · 2D");
    assert_eq!(
        shows("=IMMERSE([(0, 0), (1, 1)], [[(0, 0), (1, 0)], [(0, 1), (1, 1)]], lazy=TRUE)"),
        "ipL2 · 2D · not expanded"
    );
    let french = settled("=[(1, 0), (1, 1; 1/2), (0, 1)]").display(Language::French);
    assert_eq!(french, "pL3 · 2D · rationnelle");
}

#[test]
fn numbers_are_shown_shortest() {
    let shows = |x: f64| Value::Number(x).display(Language::English);
    assert_eq!([shows(0.1), shows(-0.0), shows(1e21), shows(1e-9)], ["0.1", "0", "1e21", "1e-9"]);
    let third: Value<Rational> = reader::compute("=1/3");
    assert_eq!(third.display(Language::French), "1/3");
    assert_eq!(third.to_json(), "1/3");
    let long: Value<Rational> = Value::Number(Rational::ratio(1, 3).power(100));
    assert!(long.display(Language::English).starts_with("≈ 1.94032521748263"));
    assert!(long.to_json().as_str().unwrap().starts_with("1/5153775207320113310364"));
}

#[test]
fn forms_in_json_hold_homogeneous_poles() {
    let json = settled("=[(1, 0), (1, 1; 1/2), (0, 1)]").to_json();
    assert_eq!(json["kind"], "pL3");
    assert_eq!(json["rational"], true);
    assert_eq!(json["poles"], serde_json::json!([[1., 0., 1.], [0.5, 0.5, 0.5], [0., 1., 1.]]));
    let square = settled("=[[(0, 0), (1, 0)], [(0, 1), (1, 1)]]").to_json();
    assert_eq!(square["poles"][1][0], serde_json::json!([0., 1., 1.]));
    let exact: Value<Rational> = reader::compute("=(0.1, 2)");
    assert_eq!(exact.to_json()["poles"], serde_json::json!(["1/10", "2", "1"]));
}

#[test]
fn lists_are_bounded() {
    let long = Value::list(vec![Value::Number(1.0); LIST_CAP]);
    assert!(!long.is_error());
    let twice = Value::list(vec![long.clone(), long]);
    assert_eq!(twice.failure().unwrap().family(), "Limit");
    let nest = |levels| (0..levels).fold(Value::Number(0.0), |inner, _| Value::list(vec![inner]));
    assert!(!nest(DEPTH_CAP).is_error());
    assert!(message(&nest(DEPTH_CAP + 1)).contains("a nesting of lists of 65: refused"));
}

#[test]
fn decimals_are_read_exactly() {
    assert_eq!(Rational::read("0.1").unwrap().write(), "1/10");
    assert_eq!(Rational::read(".5e2").unwrap().write(), "50");
    assert_eq!(Rational::read("25e-3").unwrap().write(), "1/40");
    assert_eq!(f64::read("1e-3").unwrap(), 0.001);
    for text in ["", ".", "1e", "x", "1.2.3", "--1", "1e99999999999999999999"] {
        assert!(Rational::read(text).is_err(), "{text}");
    }
    assert!(f64::read("1e999").is_err());
    assert_eq!(Rational::read("1e999999").unwrap_err().family(), "Limit");
}

#[test]
fn a_failure_keeps_its_first_origin_and_becomes_an_error() {
    let failure = Failure::from(Error::shape("axis", 3, "0 to 1")).at("A1").at("B2");
    assert_eq!(failure.origin(), Some("A1"));
    assert_eq!(failure.message(Language::French), "axis : reçu 3, attendu 0 à 1");
    assert_eq!(failure.to_error().to_string(), "A1, axis: received 3, expected 0 to 1");
    assert_eq!(failure.to_error().family(), "Shape");
    let cycle = Failure::new("Cycle", "A1 → A1", "A1 → A1").with_hint("cut it", "coupez-la");
    assert_eq!(cycle.to_error().to_string(), "formula: A1 → A1 (cut it)");
}

#[test]
fn bytes_are_those_of_the_numbers() {
    assert_eq!(settled("=[(0, 0, 0), (1, 1, 0)]").bytes(), 64);
    assert_eq!(value("=[1, 2, 3]").bytes(), 24);
    assert_eq!(Value::<f64>::Empty.bytes(), 0);
}
