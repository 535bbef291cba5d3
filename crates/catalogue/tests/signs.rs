//! The signs of formulas, and the elementary functions.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use pforms_catalogue::{Arithmetic, Elementary, Infix, Language, Value, binary, negate};
use pforms_kernel::{Rational, Scalar};

mod reader;

fn value(text: &str) -> Value {
    reader::compute(text)
}

fn shown(sign: Infix, left: &str, right: &str) -> String {
    binary(sign, &value(left), &value(right)).settle().display(Language::English)
}

#[test]
fn forms_combine_homogeneously() {
    assert_eq!(shown(Infix::Add, "=(0, 0)", "=(1, 2)"), "(0.5, 1; 2)");
    assert_eq!(shown(Infix::Subtract, "=(1, 2)", "=(0, 0)"), "(1, 2; 0)");
    assert_eq!(shown(Infix::Add, "=(1, 2)", "=(0, 1; 0)"), "(1, 3)");
    assert_eq!(shown(Infix::Multiply, "=2", "=(1, 2)"), "(1, 2; 2)");
    assert_eq!(shown(Infix::Divide, "=(1, 2; 3)", "=3"), "(1, 2)");
    assert_eq!(shown(Infix::Add, "=[(0, 0), (1, 0), (2, 0)]", "=[(0, 0), (1, 1)]"), "pL3 · 2D");
    assert_eq!(negate(&value("=(1, 2)")).display(Language::English), "(1, 2; -1)");
    let third: Value<Rational> =
        binary(Infix::Divide, &reader::compute("=(1, 2; 3)"), &reader::compute("=7"));
    assert_eq!(third.display(Language::English), "(1, 2; 3/7)");
}

#[test]
fn a_direction_translates_pieces_and_lists() {
    let moved =
        binary(Infix::Add, &value("=SUBDIVIDE([(0, 0), (1, 2), (2, 0)], 1)"), &value("=(0, 1; 0)"));
    let Value::Spline(pieces) = moved else { panic!("{moved:?}") };
    assert_eq!(pieces.at(&[0.5]).unwrap(), [1.0, 2.0]);
    assert_eq!(shown(Infix::Add, "=[(0, 0), (1, 1)]", "=(0, 1; 0)"), "pL2 · 2D");
    assert_eq!(shown(Infix::Multiply, "=[1, 2]", "=[3, 4]"), "[3, 8]");
    assert_eq!(shown(Infix::Power, "=[1, 2]", "=2"), "[1, 4]");
}

#[test]
fn signs_without_meaning_say_so() {
    assert_eq!(
        shown(Infix::Multiply, "=(1, 2)", "=(1, 2)"),
        "*: received pP * pP, expected values that go together"
    );
    assert_eq!(
        shown(Infix::Add, "=(1, 2)", "=3"),
        "+: received pP + 3, expected values that go together"
    );
    assert!(binary(Infix::Divide, &value("=3"), &value("=(1, 2)")).is_error());
    assert!(binary(Infix::Less, &value("=3"), &value("=\"3\"")).is_error());
    assert!(binary(Infix::Add, &value("=[1]"), &value("=[1, 2]")).is_error());
    assert!(binary(Infix::Divide, &value("=(1, 2)"), &value("=0")).is_error());
    assert!(binary(Infix::Multiply, &value("=1e300"), &value("=1e300")).is_error());
    assert!(binary(Infix::Add, &value("=(1, 2)"), &value("=(1, 2, 3)")).is_error());
}

#[test]
fn comparison_is_exact() {
    assert_eq!(shown(Infix::Equal, "=[(0, 0), (1, 1)]", "=FORM([(0, 0), (1, 1)])"), "TRUE");
    assert_eq!(shown(Infix::NotEqual, "=\"a\"", "=1"), "TRUE");
    assert_eq!(shown(Infix::LessEqual, "=2", "=2"), "TRUE");
    assert_eq!(shown(Infix::Greater, "=\"b\"", "=\"a\""), "TRUE");
}

#[test]
fn exact_powers_and_roots() {
    let q = Rational::ratio;
    assert_eq!(q(2, 3).raise(&q(-2, 1)).unwrap(), q(9, 4));
    assert_eq!(q(8, 27).raise(&q(2, 3)).unwrap(), q(4, 9));
    assert_eq!(q(0, 1).raise(&q(0, 1)).unwrap(), q(1, 1));
    assert_eq!(q(-8, 1).raise(&q(1, 3)).unwrap(), q(-2, 1));
    for (base, exponent) in [(q(2, 1), q(1, 2)), (q(0, 1), q(-1, 1)), (q(-4, 1), q(1, 2))] {
        assert_eq!(base.raise(&exponent).unwrap_err().family(), "Domain");
    }
    assert_eq!(q(3, 1).raise(&q(1_000_000_000_000, 1)).unwrap_err().family(), "Limit");
    assert_eq!(q(-1, 1).raise(&q(1_000_000_000_001, 1)).unwrap(), q(-1, 1));
}

#[test]
fn exact_numbers_do_not_grow_without_bound() {
    let mut value: Value<Rational> = reader::compute("=2/3");
    for _ in 0..64 {
        value = binary(Infix::Multiply, &value, &value);
    }
    assert_eq!(value.failure().unwrap().family(), "Limit");
}

#[test]
fn elementary_functions_have_domains() {
    assert_eq!(f64::apply(Elementary::Log10, &1000.0).unwrap(), 3.0);
    let error = f64::apply(Elementary::Sqrt, &-1.0).unwrap_err();
    assert_eq!(error.message(Language::English), "x: received -1, expected a number at least 0");
    assert!(f64::apply(Elementary::Exp, &1e4).is_err());
    assert!(f64::apply(Elementary::Asin, &2.0).is_err());
    assert_eq!(
        Rational::apply(Elementary::Log10, &Rational::ratio(1, 100)).unwrap(),
        Rational::ratio(-2, 1)
    );
    assert!(Rational::apply(Elementary::Sin, &Rational::ratio(1, 2)).is_err());
    assert!(Rational::apply(Elementary::Ln, &Rational::ratio(-1, 1)).is_err());
}

#[test]
fn numbers_become_the_simple_fractions_they_stand_for() {
    for (x, n, d) in [(0.1, 1, 10), (1.0 / 3.0, 1, 3), (-22.0 / 7.0, -22, 7), (0.0, 0, 1)] {
        assert_eq!(x.to_exact(), Rational::ratio(n, d));
    }
    for x in [1e-300, 5e-324, f64::MAX, 2_f64.sqrt(), 0.1 + 0.2] {
        assert_eq!(x.to_exact().to_f64(), x);
    }
}

#[test]
fn splines_are_combined_on_common_knots() {
    let [a, b] = ["=SUBDIVIDE([(0, 0), (1, 2), (2, 0)], 1)", "=SUBDIVIDE([(0, 0), (2, 2)], 2)"];
    let sum = binary(Infix::Add, &value(a), &value(b));
    let Value::Spline(spline) = sum else { panic!("{sum:?}") };
    assert_eq!((spline.degrees(), spline.counts()), (vec![2], vec![4]));
    assert_eq!(spline.at(&[0.5]).unwrap(), [1.0, 1.0]);
    let half = binary(Infix::Divide, &value(a), &Value::Number(2.0));
    let Value::Spline(half) = half else { panic!("{half:?}") };
    assert_eq!(half.net().weights(), [0.5; 5]);
}

#[test]
fn a_function_multiplies_a_form() {
    let segment = value("=[(1, 0), (1, 4)]");
    let product = binary(Infix::Multiply, &value("=[(0,), (1,)]").settle(), &segment);
    let Value::Form(form) = product else { panic!("{product:?}") };
    assert_eq!(form.at(&[0.5]).unwrap(), [0.5, 1.0]);
    assert!(binary(Infix::Multiply, &segment.clone().settle(), &segment.settle()).is_error());
}
