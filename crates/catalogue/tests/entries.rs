//! What must be true of every entry.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::collections::HashMap;

use pforms_catalogue::{Language, Operator, catalogue, find, fold};
use pforms_kernel::Rational;

mod reader;

fn works_in_exact_mode(operator: &Operator) -> bool {
    serde_json::to_value(operator).unwrap()["exact"].as_bool().unwrap()
}

#[test]
fn every_example_computes() {
    // Derivatives are those of cells: a sheet tests that example.
    for operator in catalogue().iter().filter(|operator| operator.name != "sensitivities") {
        let value = reader::compute::<f64>(operator.example).settle();
        assert!(!value.is_error(), "{}: {value:?}", operator.example);
        if works_in_exact_mode(operator) {
            let value = reader::compute::<Rational>(operator.example).settle();
            assert!(!value.is_error(), "{} in exact mode: {value:?}", operator.example);
        }
    }
}

#[test]
fn a_name_calls_one_operator() {
    let mut owners: HashMap<String, &str> = HashMap::new();
    for operator in catalogue() {
        for name in operator.names() {
            let owner = owners.insert(fold(name), operator.name);
            assert!(owner.is_none_or(|owner| owner == operator.name), "{name} is taken");
            assert_eq!(find(&name.to_lowercase()).unwrap().name, operator.name);
        }
        assert_eq!(fold(operator.english[0]), operator.english[0], "typed without accents");
    }
}

#[test]
fn everything_is_said_in_both_languages() {
    for operator in catalogue() {
        let mut said = vec![operator.summary];
        said.extend(operator.parameters.iter().flat_map(|p| [p.name, p.help]));
        for words in said {
            assert!(!words.en.is_empty() && !words.fr.is_empty(), "{}: {words:?}", operator.name);
        }
        assert_eq!(operator.help.en.is_empty(), operator.help.fr.is_empty(), "{}", operator.name);
        assert!(operator.summary.en.len() <= 90, "{}: a line is shorter", operator.name);
    }
}

#[test]
fn parameters_of_an_operator_have_different_names() {
    for operator in catalogue() {
        let names = operator.parameters.iter().map(|parameter| parameter.name);
        for (i, name) in names.clone().enumerate() {
            for other in names.clone().skip(i + 1) {
                assert!(!other.matches(name.en) && !other.matches(name.fr), "{}", operator.name);
            }
        }
        let optional = operator.parameters.iter().map(|parameter| !parameter.is_required());
        assert!(optional.is_sorted(), "{}: what may be left out comes last", operator.name);
    }
}

#[test]
fn relatives_exist() {
    for operator in catalogue() {
        for name in operator.see {
            assert!(find(name).is_some_and(|found| found.name == *name), "{name} is unknown");
        }
        let signature = operator.signature(Language::French);
        assert!(signature.starts_with(operator.french[0]), "{signature}");
    }
}

#[test]
fn the_catalogue_serialises_for_the_other_faces() {
    let json = serde_json::to_value(catalogue()).unwrap();
    assert_eq!(json.as_array().unwrap().len(), catalogue().len());
    let stretch = json.as_array().unwrap().iter().find(|entry| entry["name"] == "stretch").unwrap();
    assert_eq!(stretch["french"][0], "ETIRE");
    assert_eq!(stretch["parameters"][1]["unit"]["en"], "parameter");
    assert_eq!(stretch["exact"], true);
}
