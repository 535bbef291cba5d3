//! The native format: exact round trips, and no trust in what is read.
#![allow(missing_docs, clippy::unwrap_used)]

use pforms_formats::{Named, json, read};
use pforms_kernel::{Error, Form, Rational, Scalar};
use pforms_operators::{Shape, Spline};
use proptest::prelude::*;

fn named(name: &str, form: Form) -> Named {
    Named { name: Some(name.to_owned()), shape: form.into() }
}

fn fails(text: &str) -> (usize, usize, String) {
    match json::read::<f64>(text.as_bytes()).unwrap_err() {
        Error::Format { place: Some(place), message, .. } => (place.line, place.column, message),
        other => panic!("{other:?}"),
    }
}

#[test]
fn documents_are_readable_and_stable() {
    let arc = Form::from_homogeneous(&[2], 1, vec![0.1, 1.0, -0.0, 1e-300]).unwrap();
    let point = Form::point(&[1.0, 2.0]).unwrap();
    let bytes = json::write(&[named("an \"arc\"", arc), point.into()]);
    let expected = r#"{
  "pforms": 1,
  "forms": [
    {
      "name": "an \"arc\"",
      "orders": [2],
      "ambient": 1,
      "poles": [
        [0.1, 1.0],
        [-0.0, 1e-300]
      ]
    },
    {
      "orders": [],
      "ambient": 2,
      "poles": [
        [1.0, 2.0, 1.0]
      ]
    }
  ]
}
"#;
    assert_eq!(String::from_utf8(bytes.clone()).unwrap(), expected);
    let forms = json::read::<f64>(&bytes).unwrap();
    assert_eq!(json::write(&forms), bytes);
    assert_eq!(json::write::<f64>(&[]), b"{\n  \"pforms\": 1,\n  \"forms\": []\n}\n");
    assert!(json::read::<f64>(&json::write::<f64>(&[])).unwrap().is_empty());
}

#[test]
fn flat_listed_and_nested_poles_are_the_same() {
    let read = |poles: &str| {
        let text = format!(
            "{{\"pforms\":1,\"forms\":[{{\"orders\":[2,2],\"ambient\":1,\"poles\":{poles}}}]}}"
        );
        json::read::<f64>(text.as_bytes()).unwrap().remove(0).net().clone()
    };
    let nested = read("[[[0,1],[1,1]],[[2,1],[3,1]]]");
    assert_eq!(nested, read("[[0,1],[1,1],[2,1],[3,1]]"));
    assert_eq!(nested, read("[0,1,1,1,2,1,3,1]"));
}

#[test]
fn exact_fractions_survive() {
    let third = Rational::ratio(1, 3);
    let form = Form::from_homogeneous(&[1], 1, vec![third.clone(), Rational::one()]).unwrap();
    let bytes = json::write(&[form.clone().into()]);
    assert_eq!(json::read::<Rational>(&bytes).unwrap()[0].net(), &form);
    assert_eq!(json::read::<f64>(&bytes).unwrap()[0].net().homogeneous(), [1.0 / 3.0, 1.0]);
    let mixed = br#"{"pforms":1,"forms":[{"orders":[],"ambient":2,"poles":["-22/7", 0.1, 1]}]}"#;
    let exact = &json::read::<Rational>(mixed).unwrap()[0].net().clone();
    assert_eq!(exact.homogeneous()[1], Rational::from_f64(0.1).unwrap());
}

#[test]
fn damage_is_told_with_its_place() {
    let document = |inside: &str| format!("{{\n  \"pforms\": 1,\n  \"forms\": [\n{inside}\n]}}");
    let form = |orders: &str, ambient: &str, poles: &str| {
        document(&format!("{{\"orders\": {orders}, \"ambient\": {ambient},\n\"poles\": {poles}}}"))
    };
    for (text, line, part) in [
        ("{\n \"pforms\": 2, \"forms\": []}".to_owned(), 2, "version 2"),
        ("{\"pforms\": 1, \"forms\": [], \"more\": 1}".to_owned(), 1, "unknown field `more`"),
        (form("[2]", "1", "[[0,1],[1,1,1]]"), 5, "ragged: an array of 2 numbers beside"),
        (form("[2]", "1", "[[0,1],3]"), 5, "ragged"),
        (form("[2]", "1", "[0,1,2]"), 5, "3 numbers"),
        (form("[2,1]", "1", "[[[0,1],[1,1]]]"), 5, "array"),
        (form("[0]", "1", "[]"), 5, "at least 1 pole"),
        (form("[2]", "0", "[1,1]"), 5, "at least 1 coordinate"),
        (form("[2]", "1", "[0,1,2,\"1/0\"]"), 5, "\"1/0\" is no fraction"),
        (form("[2]", "1", "[0,1,2,\"nan\"]"), 5, "no fraction"),
        (form("[2]", "1", "[0,1,2,1e999]"), 5, "out of range"),
        (form("[2]", "1", "[0,1,2,null]"), 5, "a number"),
        (form("[2]", "18446744073709551615", "[0,1]"), 5, "ambient"),
        (form("[1000000,1000000,1000000]", "3", "[0,1]"), 5, "refused"),
        (form("[-1]", "3", "[0,1]"), 4, "-1"),
        (form("\"x\"", "3", "[0,1]"), 4, "sequence"),
        ("\u{feff}[]".to_owned(), 1, "an object with"),
        ("{\"pforms\": 1}".to_owned(), 1, "missing field `forms`"),
        ("{".to_owned(), 1, "EOF"),
        (String::new(), 1, "EOF"),
    ] {
        let (at, column, message) = fails(&text);
        // What is wrong with a form as a whole is told right after it.
        assert!(at == line || at == line + 1, "{text}: {message} in line {at}");
        assert!(message.contains(part), "{message} lacks {part}");
        assert!(column <= text.len(), "{message}");
    }
}

#[test]
fn deep_nesting_and_long_fractions_are_refused() {
    let deep = format!(
        "{{\"pforms\":1,\"forms\":[{{\"orders\":[1],\"ambient\":1,\"poles\":{}",
        "[".repeat(100_000)
    );
    assert!(fails(&deep).2.contains("recursion"));
    let long = "9".repeat(1_000_000);
    let text = format!(
        "{{\"pforms\":1,\"forms\":[{{\"orders\":[1],\"ambient\":1,\"poles\":[\"{long}\",1]}}]}}"
    );
    assert!(fails(&text).2.len() < 200);
    let huge = format!(
        "{{\"pforms\":1,\"forms\":[{{\"orders\":[1],\"ambient\":1,\"poles\":[\"{}\",1]}}]}}",
        "9".repeat(400)
    );
    assert!(fails(&huge).2.contains("fraction"));
    assert!(json::read::<Rational>(huge.as_bytes()).is_ok());
}

#[test]
fn a_document_cut_anywhere_is_refused() {
    let form = Form::from_homogeneous(&[2, 1], 1, vec![0.5, 1.0, -1e-7, 2.0]).unwrap();
    let bytes = json::write(&[named("é", form)]);
    let whole = bytes.len() - 1; // the final line break
    for cut in 0..whole {
        let error = json::read::<f64>(&bytes[..cut]).unwrap_err();
        assert!(matches!(error, Error::Format { place: Some(_), .. }), "{cut}: {error}");
    }
}

#[test]
fn content_tells_what_the_name_does_not() {
    let bytes = json::write(&[Form::point(&[1.0]).unwrap().into()]);
    assert_eq!(read("forms.txt", &bytes).unwrap().len(), 1);
    assert_eq!(read("x", b"1\n0 0\n1 2 3\n").unwrap()[0].net().orders(), [1, 1]);
    assert_eq!(read("x", b"what?").unwrap_err().family(), "Format");
    assert_eq!(read("x", b"").unwrap_err().family(), "Format");
}

proptest! {
    #[test]
    fn every_bit_survives(numbers in prop::collection::vec(prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO, 12)) {
        let form = Form::from_homogeneous(&[2, 3], 1, numbers).unwrap();
        let back = json::read::<f64>(&json::write(&[form.clone().into()])).unwrap();
        let bits = |form: &Form| form.homogeneous().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(bits(back[0].net()), bits(&form));
    }

    #[test]
    fn a_changed_byte_never_panics(at in 0usize..200, byte in any::<u8>()) {
        let form = Form::from_homogeneous(&[2, 2], 1, vec![0.5, 1.0, 3.0, 2.0, 1.0, 1.0, 7.0, 9.0]);
        let mut bytes = json::write(&[form.unwrap().into()]);
        let at = at % bytes.len();
        bytes[at] = byte;
        let _ = json::read::<f64>(&bytes);
        let _ = read("x.json", &bytes);
    }
}

#[test]
fn splines_come_back_with_their_knots() {
    let net = Form::from_points(&[4, 2], 1, &[0., 1., 2., 3., 0.1, 5., 6., 7.], None).unwrap();
    let knots = vec![vec![0.0, 0.0, 0.0, 0.1, 1.0, 1.0, 1.0], vec![-1.0, 0.0, 1.0, 2.0]];
    let spline = Spline::new(net, &[2, 1], knots).unwrap();
    let bytes = json::write(&[Named::from(spline.clone()), spline.net().clone().into()]);
    let text = String::from_utf8(bytes.clone()).unwrap();
    assert!(
        text.contains("      \"degrees\": [2, 1],\n      \"knots\": [[0.0, 0.0, 0.0, 0.1,"),
        "{text}"
    );
    let back = json::read::<f64>(&bytes).unwrap();
    assert_eq!(back[0].shape, Shape::Spline(spline.clone()));
    assert_eq!(back[1].shape, Shape::Form(spline.net().clone()));
    let exact = spline.map_scalar(|x| Rational::from_f64(*x).unwrap()).unwrap();
    let again = json::read::<Rational>(&json::write(&[Named::from(exact.clone())])).unwrap();
    assert_eq!(again[0].shape, Shape::Spline(exact));
    let with = |keys: &str| {
        fails(&format!(
            "{{\"pforms\": 1, \"forms\": [{{\"orders\": [2], \"ambient\": 1, \
             \"poles\": [[0, 1], [1, 1]], {keys}}}]}}"
        ))
        .2
    };
    assert!(with("\"degrees\": [1]").contains("go together"));
    assert!(with("\"degrees\": [1], \"knots\": [[0, 0, 1]]").contains("3 knots"));
    assert!(with("\"degrees\": [1], \"knots\": [0, 0, 1, 1]").contains("knots in an array"));
    assert!(with("\"degrees\": [1], \"knots\": [[0, 1, 0, 1]]").contains("decrease"));
}
