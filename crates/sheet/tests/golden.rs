//! The golden cases of every operator, through formulas, in both arithmetics; and the examples of
//! the catalogue.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on must stop")]

mod common;

use std::fs;

use common::at;
use pforms_catalogue::{Arithmetic, Language, Value, catalogue, find};
use pforms_kernel::{Form, Rational, Scalar};
use pforms_sheet::Sheet;
use serde_json::Value as Json;

/// What double precision may lose, of the largest coordinate.
const ROUNDING: f64 = 1e-13;

fn files() -> Vec<(String, Json)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/operators");
    let mut files: Vec<_> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let golden = files.into_iter().filter(|path| {
        path.extension().is_some_and(|end| end == "json") && !path.ends_with("schema.json")
    });
    golden
        .map(|path| {
            let name = path.file_stem().unwrap().to_string_lossy().into_owned();
            (name, serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap())
        })
        .collect()
}

fn computed<S: Arithmetic>(case: &Json) -> Value<S> {
    let mut sheet = Sheet::<S>::new();
    for (cell, text) in case["cells"].as_object().unwrap() {
        sheet.set(at(cell), text.as_str().unwrap());
    }
    sheet.set(at("Z1"), case["formula"].as_str().unwrap());
    sheet.recalculate_all();
    sheet.value(at("Z1")).clone()
}

fn exact(text: &Json) -> Rational {
    text.as_str().unwrap().parse().unwrap()
}

fn form_of(json: &Json) -> Form<Rational> {
    let orders: Vec<usize> =
        json["orders"].as_array().unwrap().iter().map(|n| n.as_u64().unwrap() as usize).collect();
    let poles: Vec<&Vec<Json>> =
        json["poles"].as_array().unwrap().iter().map(|pole| pole.as_array().unwrap()).collect();
    let ambient = poles[0].len() - 1;
    let numbers = poles.iter().flat_map(|pole| pole.iter().map(exact)).collect();
    Form::from_homogeneous(&orders, ambient, numbers).unwrap()
}

/// How far apart two numbers may be: nothing in exact arithmetic.
struct Allowance {
    relative: f64,
}

impl Allowance {
    fn equal<S: Arithmetic>(&self, found: &S, wanted: &Rational, size: f64) -> bool {
        if S::EXACT {
            return found.to_exact() == *wanted;
        }
        (found.to_f64() - Scalar::to_f64(wanted)).abs() <= self.relative * size.max(1.0)
    }

    fn same_form<S: Arithmetic>(
        &self,
        found: &Form<S>,
        wanted: &Form<Rational>,
        projective: bool,
    ) -> bool {
        if found.orders() != wanted.orders() || found.ambient() != wanted.ambient() {
            return false;
        }
        let width = wanted.width();
        let found = found.homogeneous().chunks_exact(width);
        let size = wanted.homogeneous().iter().map(|x| Scalar::to_f64(x).abs()).fold(0.0, f64::max);
        found.zip(wanted.homogeneous().chunks_exact(width)).all(|(found, wanted)| {
            let factor = if projective { common_factor(found, wanted) } else { S::one() };
            let scaled = found.iter().map(|x| x.clone() * factor.clone());
            scaled.zip(wanted).all(|(x, y)| self.equal(&x, y, size))
        })
    }

    fn matches<S: Arithmetic>(&self, found: &Value<S>, wanted: &Json) -> bool {
        let (kind, content) = wanted
            .as_object()
            .unwrap()
            .iter()
            .find(|(kind, _)| kind.as_str() != "projective")
            .unwrap();
        match (kind.as_str(), found) {
            ("form", Value::Form(form)) => {
                self.same_form(form, &form_of(content), wanted["projective"] == true)
            }
            ("net", Value::Spline(pieces)) => {
                self.same_form(pieces.net(), &form_of(content), false)
            }
            ("number", Value::Number(x)) => {
                let wanted = exact(content);
                self.equal(x, &wanted, Scalar::to_f64(&wanted).abs())
            }
            ("at_least", Value::Number(x)) => {
                x.to_f64() >= Scalar::to_f64(&exact(content)) * (1.0 - ROUNDING)
            }
            ("decimal", Value::Number(x)) => self.near(x.to_f64(), content),
            ("decimals", Value::Form(form)) => {
                let point = if form.weights()[0].is_zero() {
                    form.homogeneous()[..form.ambient()].to_vec()
                } else {
                    form.points().unwrap()
                };
                let wanted = content.as_array().unwrap();
                point.len() == wanted.len()
                    && point.iter().zip(wanted).all(|(x, y)| self.near(x.to_f64(), y))
            }
            ("truth", Value::Boolean(truth)) => content.as_bool() == Some(*truth),
            ("text", Value::Text(text)) => content.as_str() == Some(text),
            ("contains", Value::Text(text)) => content
                .as_array()
                .unwrap()
                .iter()
                .all(|line| text.lines().any(|own| own.trim() == line.as_str().unwrap())),
            ("list", Value::List(items)) => {
                let wanted = content.as_array().unwrap();
                items.len() == wanted.len()
                    && items.iter().zip(wanted).all(|(item, wanted)| self.matches(item, wanted))
            }
            ("record", Value::Record(entries)) => {
                content.as_object().unwrap().iter().all(|(key, wanted)| {
                    entries
                        .iter()
                        .any(|(name, value)| name.en == key && self.matches(value, wanted))
                })
            }
            ("error", Value::Error(failure)) => content.as_str() == Some(failure.family()),
            _ => false,
        }
    }

    fn near(&self, found: f64, wanted: &Json) -> bool {
        let wanted = wanted.as_f64().unwrap();
        (found - wanted).abs() <= self.relative * wanted.abs().max(1.0)
    }
}

/// What brings a pole to the scale of another: the quotient of their largest coordinates.
fn common_factor<S: Arithmetic>(found: &[S], wanted: &[Rational]) -> S {
    let largest = (0..wanted.len())
        .max_by(|i, j| {
            Scalar::to_f64(&wanted[*i]).abs().total_cmp(&Scalar::to_f64(&wanted[*j]).abs())
        })
        .unwrap();
    if found[largest].is_zero() {
        return S::one();
    }
    S::read(&wanted[largest].numer().to_string()).unwrap()
        / S::read(&wanted[largest].denom().to_string()).unwrap()
        / found[largest].clone()
}

fn complain<S: Arithmetic>(case: &Json, allowance: &Allowance) -> Option<String> {
    let found = computed::<S>(case);
    if allowance.matches(&found, &case["expected"]) {
        return None;
    }
    let mode = if S::EXACT { "exact" } else { "floating" };
    let json: String = found.to_json().to_string().chars().take(600).collect();
    Some(format!("{} ({mode}): {}\n  found {json}", case["id"], case["formula"]))
}

#[test]
fn every_golden_case_holds_in_both_arithmetics() {
    let mut wrong = Vec::new();
    let mut count = 0;
    for (_, file) in files() {
        let Some(operator) = find(file["formula_name"].as_str().unwrap()) else {
            wrong.push(format!("no operator is called {}", file["formula_name"]));
            continue;
        };
        let is_exact = serde_json::to_value(operator).unwrap()["exact"] == true;
        for case in file["cases"].as_array().unwrap() {
            let numeric = case["kind"] == "numeric";
            let relative = case["tolerance"].as_f64().unwrap_or(ROUNDING);
            wrong.extend(complain::<f64>(case, &Allowance { relative }));
            if is_exact && !numeric {
                wrong.extend(complain::<Rational>(case, &Allowance { relative }));
            }
            count += 1;
        }
    }
    assert!(count > 200, "{count}");
    assert!(wrong.is_empty(), "{} of {count}\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn every_example_of_the_catalogue_computes() {
    for operator in catalogue() {
        let is_exact = serde_json::to_value(operator).unwrap()["exact"] == true;
        let cells = serde_json::json!({ "A1": "(0, 0)", "A2": "(1, 2)" });
        let case = serde_json::json!({ "cells": cells, "formula": operator.example });
        let floating = computed::<f64>(&case);
        assert!(
            !floating.is_error(),
            "{}: {}",
            operator.example,
            floating.display(Language::English)
        );
        if is_exact {
            let exact = computed::<Rational>(&case);
            assert!(
                !exact.is_error(),
                "{}: {}",
                operator.example,
                exact.display(Language::English)
            );
        }
    }
}

#[test]
fn french_names_and_accents_call_the_same() {
    for (english, french) in [
        ("=ELEVATE(A1, 1)", "=Élévation(A1; 1)"),
        ("=MIR(A1, A1)", "=mir(A1; A1)"),
        ("=IF(TRUE, 1, 2)", "=SI(VRAI; 1; 2)"),
    ] {
        let cells = serde_json::json!({ "A1": "[(0, 0), (1, 1)]" });
        let value = |formula: &str| {
            computed::<f64>(&serde_json::json!({ "cells": cells, "formula": formula })).to_json()
        };
        assert_eq!(value(english), value(french), "{french}");
    }
}

/// Words that no French sentence has.
const ENGLISH: &[&str] = &[
    "the", "an", "of", "form", "number", "with", "without", "that", "which", "and", "or", "to",
    "for", "from", "at", "in", "its", "is", "are", "one", "each", "than", "as", "by", "least",
    "most", "above", "between", "other", "curve", "weights", "poles", "numbers", "knots", "shell",
    "mesh", "whole", "would", "have", "axis",
];

#[test]
fn errors_are_french_in_french() {
    let mut english = Vec::new();
    for (name, file) in files() {
        for case in file["cases"].as_array().unwrap() {
            if case["kind"] != "error" {
                continue;
            }
            let found = computed::<f64>(case);
            let Some(failure) = found.failure() else { continue };
            let message = failure.message(Language::French);
            // Before that stand the cell, the operator and the parameter.
            let said = message.split_once("reçu ").map_or(message, |(_, said)| said);
            let outside: String = said.split(['«', '»', '“', '”', '"']).step_by(2).collect();
            let mut words = outside.split(|c: char| !c.is_alphanumeric() && c != '\'' && c != '_');
            if words.any(|word| ENGLISH.contains(&word)) || said.contains("attendu a ") {
                english.push(format!("{name}: {message}"));
            }
        }
    }
    assert!(english.is_empty(), "{}", english.join("\n"));
}
