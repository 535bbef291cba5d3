//! Operators take splines as they take forms.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use pforms_catalogue::{Language, Value};
use pforms_kernel::Rational;

mod reader;

/// Two pieces of a parabola, and of a twisted surface.
const CURVE: &str = "SUBDIVIDE([(0, 0), (1, 2; 1/2), (2, 0)], 1)";
const SURFACE: &str = "SUBDIVIDE([[(0, 0, 0), (1, 0, 1)], [(0, 1, 1), (1, 1, 0)]], 1, 0)";

fn value(text: &str) -> Value<Rational> {
    reader::compute::<Rational>(text).settle()
}

fn shown(text: &str) -> String {
    value(&text.replace("CURVE", CURVE).replace("SURFACE", SURFACE)).display(Language::English)
}

/// The formula means the same of the pieces as of the whole form.
fn agrees(formula: &str) {
    let whole = |pieces: &str, form: &str| formula.replace(pieces, form);
    let curve = whole("CURVE", "[(0, 0), (1, 2; 1/2), (2, 0)]");
    let of_form = curve.replace("SURFACE", "[[(0, 0, 0), (1, 0, 1)], [(0, 1, 1), (1, 1, 0)]]");
    let of_pieces = formula.replace("CURVE", CURVE).replace("SURFACE", SURFACE);
    assert_ne!(of_form, of_pieces);
    let (a, b) = (value(&of_form), value(&of_pieces));
    assert!(!a.is_error(), "{formula}: {a:?}");
    assert_eq!(a, b, "{formula}");
}

#[test]
fn points_of_results_are_those_of_the_form() {
    for formula in [
        "=GRID(CURVE, 5)",
        "=GRID(SURFACE, 3, 2)",
        "=POINT(ELEVATE(CURVE, 2), [0, 1/3, 1/2, 1])",
        "=POINT(DERIVATIVE(CURVE, 2), [0, 1/3, 1/2, 1])",
        "=POINT(HODOGRAPH(SURFACE, 1), 1/3, 2/3)",
        "=POINT(STRETCH(CURVE, -1, 3/2), [0, 1/3, 1])",
        "=POINT(STRETCH(SURFACE, [1, 0], [0, 1/2]), 1/5, 1/7)",
        "=POINT(REVERSE(CURVE), [0, 1/3, 1])",
        "=POINT(TRANSPOSE(SURFACE), 1/5, 1/3)",
        "=POINT(SUB(SURFACE, 0, 2/3), 1/4)",
        "=SUB(CURVE, 0, 1/3)",
        "=POINT(SUBDIVIDE(CURVE, 1), [1/8, 7/9])",
        "=POINT(TANGENT(CURVE), [1/8, 7/9])",
        "=POINT(NORMAL(CURVE), [1/8, 7/9])",
        "=POINT(NORMAL(SURFACE), 1/8, 7/9)",
        "=POINT(MIR(CURVE, REVERSE(CURVE)), 1/3, 7/9)",
        "=POINT(MI(CURVE, REVERSE(CURVE)), [1/8, 7/9])",
    ] {
        agrees(formula);
    }
}

#[test]
fn questions_of_measure_are_answered_for_the_piece() {
    let of = |text: &str| reader::compute::<f64>(&text.replace("CURVE", CURVE)).settle();
    let number = |text: &str| match of(text) {
        Value::Number(x) => x,
        other => panic!("{text}: {other:?}"),
    };
    let whole = "[(0, 0), (1, 2; 1/2), (2, 0)]";
    for formula in ["=CURVATURE(CURVE, 1/3)", "=FRAME(CURVE, 3/4, part=\"speed\")"] {
        let (a, b) = (number(formula), number(&formula.replace("CURVE", whole)));
        // Two roads to one number, a few roundings each.
        assert!((a - b).abs() < 1e-12 * b.abs(), "{formula}: {a} {b}");
    }
    let foot = number("=PROJECT(CURVE, (1, 3), part=\"distance\")");
    let expected = number(&format!("=PROJECT({whole}, (1, 3), part=\"distance\")"));
    assert!((foot - expected).abs() < 1e-14);
    assert_eq!(
        of("=PROJECT(CURVE, (1, 3), part=\"parameters\")").display(Language::English),
        "[0.5]"
    );
}

#[test]
fn a_cell_says_what_a_spline_is() {
    assert_eq!(shown("=CURVE"), "spline of 2 pL3 · 2D · rational");
    assert_eq!(value(&format!("={SURFACE}")).display(Language::French), "spline de 2×1 pS22 · 3D");
    assert_eq!(shown("=KIND(CURVE)"), "spline of 2 pL3");
    assert_eq!(shown("=ORDERS(CURVE)"), "[5]");
    assert_eq!(shown("=WEIGHTS(CURVE)"), "[1, 3/4, 3/4, 3/4, 1]");
    assert_eq!(shown("=POLE(CURVE, 4)"), "(2, 0)");
    assert_eq!(shown("=WITHPOLE(CURVE, 4, (3, 0))"), "spline of 2 pL3 · 2D · rational");
    assert_eq!(shown("=POINT(WITHPOLE(CURVE, 4, (3, 0)), 1)"), "(3, 0)");
    assert_eq!(
        shown("=SPLIT(CURVE, 0, 1/4)"),
        "[spline of 1 pL3 · 2D · rational, spline of 2 pL3 · 2D · rational]"
    );
}

#[test]
fn what_takes_no_spline_says_so() {
    let failure = value(&format!("=MOBIUS({CURVE}, 0, 2)"));
    let failure = failure.failure().unwrap();
    assert!(failure.hint(Language::English).unwrap().starts_with("NET(…)"));
    assert!(failure.message(Language::English).contains("spline of 2 pL3"));
    let far = shown("=MI(CURVE, NURBS([(0, 0), (1, 1)], 1, [0, 0, 3, 3]))");
    assert!(far.contains("window"), "{far}");
}
