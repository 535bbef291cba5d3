//! `pforms eval` and `pforms operators`, as a person runs them.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on must stop")]

use std::io::Write;
use std::process::{Command, Output, Stdio};

const OCTANT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/sheets/octant.pfs");

const SHEET: &str = r#"pfs = 1
[cells]
A1 = "[(0, 0), (1, 0.1)]"
A2 = "=1/3"
A3 = "=A9 + 1"
A4 = "=SUBDIVIDE(A1, 1)"
[names]
third = "A2"
"#;

fn pforms(arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_pforms"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    child.wait_with_output().unwrap()
}

/// Exit code and standard output.
fn answer(arguments: &[&str], input: &str) -> (i32, String) {
    let output = pforms(arguments, input);
    (output.status.code().unwrap(), String::from_utf8(output.stdout).unwrap())
}

#[test]
fn every_cell_in_a_line() {
    let (code, text) = answer(&["eval", "-"], SHEET);
    assert_eq!(code, 0);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "A1  pL2              2D");
    assert_eq!(lines[1], "A2  number           0.3333333333333333");
    assert!(lines[2].starts_with("A3  error            A3: A9: received an empty cell"), "{text}");
    assert!(lines[3].starts_with("A4  spline of 2 pL2  2D"), "{text}");
}

#[test]
fn a_cell_in_full_with_its_poles() {
    let (code, text) = answer(&["eval", "-", "third", "A1", "--exact"], SHEET);
    assert_eq!(code, 0);
    assert_eq!(
        text,
        "A2  =1/3\n  1/3\nA1  [(0, 0), (1, 0.1)]\n  pL2 · 2D\n  [0]  0  0     ; 1\n  [1]  1  1/10  ; 1\n"
    );
    assert_eq!(answer(&["eval", OCTANT, "viviani"], "").0, 0);
}

#[test]
fn an_error_asked_for_is_told_by_the_exit_code() {
    let (code, text) = answer(&["eval", "-", "A3", "--lang", "fr"], SHEET);
    assert_eq!(code, 1);
    assert!(text.contains("cellule vide"), "{text}");
    assert_eq!(answer(&["eval", "-", "A1:A2"], SHEET).0, 0);
    let unknown = pforms(&["eval", "-", "nobody"], SHEET);
    assert_eq!(unknown.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&unknown.stderr).contains("neither a cell nor a name"));
}

#[test]
fn json_for_programs() {
    let (_, text) = answer(&["eval", "-", "--json", "--exact"], SHEET);
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["cells"]["A2"]["value"], "1/3");
    assert_eq!(json["cells"]["A1"]["value"]["poles"][1][1], "1/10");
    assert_eq!(json["cells"]["A3"]["error"]["origin"], "A3");
    assert_eq!(json["names"]["third"], "A2");
    let (code, text) = answer(&["eval", "-", "A3", "--json"], SHEET);
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!((code, &json["cells"]["A3"]["kind"]), (1, &"error".into()));
}

#[test]
fn a_damaged_or_missing_file_is_named_with_its_place() {
    for (arguments, input, expected) in [
        (
            ["eval", "-"],
            "pfs = 1\n[cells]\nA0 = \"1\"",
            "-, line 3, column 1: \"A0\" is no address",
        ),
        (["eval", "-"], "pfs = 7", "version 7"),
        (["eval", "/nowhere/at.all"], "", "/nowhere/at.all"),
    ] {
        let output = pforms(&arguments, input);
        let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(1), "{complaint}");
        assert!(complaint.contains(expected), "{complaint}");
    }
    assert_eq!(pforms(&["evaluate"], "").status.code(), Some(2));
}

#[test]
fn operators_are_listed_and_explained() {
    let (code, text) = answer(&["operators"], "");
    assert_eq!(code, 0);
    assert!(text.contains("MIR(forms, …)") && text.contains("IMMERSE("), "{text}");
    let (_, page) = answer(&["operators", "élévation", "--lang", "fr"], "");
    assert!(page.starts_with("ELEVATION("), "{page}");
    let (_, json) = answer(&["operators", "DIAG", "--json"], "");
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json[0]["name"], "diagonal");
    let wrong = pforms(&["operators", "DIAGG"], "");
    assert_eq!(wrong.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&wrong.stderr).contains("DIAG"), "{wrong:?}");
}
