//! The formulas of the book that `explain` must find by itself.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::Kind;
use pforms_operators::{diagonal, elevate, explain, midpoint, subdivide};

fn kinds(names: &[&str]) -> Vec<Kind> {
    names.iter().map(|name| name.parse().unwrap()).collect()
}

fn diagonal_of(kind: &str) -> Vec<String> {
    let text = explain(&kinds(&[kind]), |forms| diagonal(&forms[0], 0, 1)).unwrap();
    text.lines().map(str::to_owned).collect()
}

/// Section 13, with its misprints of pS32 and pS43 corrected. The book's pS32 is two rows of three
/// points, which is a pS23 here.
#[test]
fn diagonals_of_section_13() {
    assert_eq!(diagonal_of("pS22"), ["q0 = p00", "q1 = (p01 + p10)/2", "q2 = p11"]);
    assert_eq!(
        diagonal_of("pS23"),
        ["q0 = p00", "q1 = (2·p01 + p10)/3", "q2 = (p02 + 2·p11)/3", "q3 = p12"]
    );
    assert_eq!(
        diagonal_of("pS33"),
        [
            "q0 = p00",
            "q1 = (p01 + p10)/2",
            "q2 = (p02 + 4·p11 + p20)/6",
            "q3 = (p12 + p21)/2",
            "q4 = p22",
        ]
    );
    assert_eq!(
        diagonal_of("pS24"),
        [
            "q0 = p00",
            "q1 = (3·p01 + p10)/4",
            "q2 = (p02 + p11)/2",
            "q3 = (p03 + 3·p12)/4",
            "q4 = p13",
        ]
    );
    assert_eq!(
        diagonal_of("pS34"),
        [
            "q0 = p00",
            "q1 = (3·p01 + 2·p10)/5",
            "q2 = (3·p02 + 6·p11 + p20)/10",
            "q3 = (p03 + 6·p12 + 3·p21)/10",
            "q4 = (2·p13 + 3·p22)/5",
            "q5 = p23",
        ]
    );
    assert_eq!(
        diagonal_of("pS44"),
        [
            "q0 = p00",
            "q1 = (p01 + p10)/2",
            "q2 = (p02 + 3·p11 + p20)/5",
            "q3 = (p03 + 9·p12 + 9·p21 + p30)/20",
            "q4 = (p13 + 3·p22 + p31)/5",
            "q5 = (p23 + p32)/2",
            "q6 = p33",
        ]
    );
}

#[test]
fn other_operators_explain_themselves() {
    let middle =
        explain(&kinds(&["pP", "pP", "pP"]), |forms| midpoint(&forms.iter().collect::<Vec<_>>()));
    assert_eq!(middle.unwrap(), "q = (a + 2·b + c)/4");
    let raised = explain(&kinds(&["pL3"]), |forms| elevate(&forms[0], &[1])).unwrap();
    assert_eq!(raised, "q0 = p0\nq1 = (p0 + 2·p1)/3\nq2 = (2·p1 + p2)/3\nq3 = p2");
    let halves = explain(&kinds(&["pL3"]), |forms| Ok(subdivide(&forms[0], &[1])?.net().clone()));
    assert_eq!(halves.unwrap().lines().nth(2), Some("q2 = (p0 + 2·p1 + p2)/4"));
}
