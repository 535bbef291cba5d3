//! The sheets printed in the manual, run.
//!
//! A fence marked `sheet` holds cells, `A1  =MI(…)`, and what they come to: `A1 → value` for
//! equality, `A1 ≅ value` where only the points count, `A1 ∋ text` for a part of a text. It runs in
//! exact arithmetic; where an operator has none, in floating point within [`ACCURACY`].

#![expect(clippy::unwrap_used, reason = "a test may stop where it stands")]

use std::fs;
use std::path::{Path, PathBuf};

use pforms_catalogue::{Arithmetic, Language, Value};
use pforms_kernel::{Form, Rational};
use pforms_sheet::Sheet;

/// The numbers in the manual are small, and so are the degrees: a thousand roundings.
const ACCURACY: f64 = 1e-12;

/// Cells for the expected values, out of the way of the printed ones.
const ASIDE: &str = "ZZ";

#[test]
fn every_sheet_in_the_manual_comes_to_what_is_printed() {
    let mut fences = 0;
    let mut failures = Vec::new();
    for page in pages(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src")) {
        let text = fs::read_to_string(&page).unwrap();
        for fence in sheets(&text) {
            fences += 1;
            if run::<Rational>(&fence, 0.0).is_err()
                && let Err(message) = run::<f64>(&fence, ACCURACY)
            {
                failures.push(format!("{}: {message}", page.display()));
            }
        }
    }
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
    assert!(fences > 20, "only {fences} sheets found");
}

fn pages(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(pages(&path));
        } else if path.extension().is_some_and(|ending| ending == "md") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The lines of each fence, without the indentation of a tab.
fn sheets(text: &str) -> Vec<Vec<&str>> {
    let mut found = Vec::new();
    let mut open: Option<Vec<&str>> = None;
    for line in text.lines().map(str::trim) {
        match (&mut open, line) {
            (None, "```sheet") => open = Some(Vec::new()),
            (Some(_), "```") => found.extend(open.take()),
            (Some(lines), line) => lines.push(line),
            (None, _) => {}
        }
    }
    found
}

fn run<S: Arithmetic>(lines: &[&str], accuracy: f64) -> Result<(), String> {
    let mut sheet = Sheet::<S>::new();
    let mut claims = Vec::new();
    for line in lines.iter().filter(|line| !line.is_empty()) {
        let (place, rest) = line.split_once(' ').ok_or(format!("{line:?} is no cell"))?;
        let claim = ['→', '≅', '∋'].into_iter().find(|sign| rest.starts_with(*sign));
        let Some(sign) = claim else {
            set(&mut sheet, place, rest.trim())?;
            continue;
        };
        let expected = rest.trim_start_matches(sign).trim();
        let aside = format!("{ASIDE}{}", claims.len() + 1);
        if sign != '∋' {
            set(&mut sheet, &aside, expected)?;
        }
        claims.push((place, sign, expected, aside));
    }
    sheet.recalculate_all();
    no_errors(&sheet)?;
    claims.iter().try_for_each(|(place, sign, expected, aside)| {
        let came = get(&sheet, place)?;
        let holds = match sign {
            '∋' => matches!(&came, Value::Text(text) if text.contains(expected)),
            _ => alike(&tree(&came), &tree(&get(&sheet, aside)?), *sign == '≅', accuracy),
        };
        let shown = came.display(Language::English);
        if holds { Ok(()) } else { Err(format!("{place} {sign} {expected}, but it is {shown}")) }
    })
}

fn set<S: Arithmetic>(sheet: &mut Sheet<S>, place: &str, text: &str) -> Result<(), String> {
    let at = place.parse().map_err(|error| format!("{place}: {error}"))?;
    sheet.set(at, text);
    Ok(())
}

fn get<S: Arithmetic>(sheet: &Sheet<S>, place: &str) -> Result<Value<S>, String> {
    sheet.get(place).map_err(|error| error.to_string())
}

fn no_errors<S: Arithmetic>(sheet: &Sheet<S>) -> Result<(), String> {
    sheet.addresses().try_for_each(|at| match sheet.value(at) {
        error @ Value::Error(_) => Err(format!("{at}: {}", error.display(Language::English))),
        _ => Ok(()),
    })
}

/// A value as nested lists, so that a form and the list of its poles are the same.
#[derive(Debug)]
enum Tree<S> {
    Pole(Vec<S>),
    Number(S),
    List(Vec<Tree<S>>),
    Other(String),
}

fn tree<S: Arithmetic>(value: &Value<S>) -> Tree<S> {
    match value {
        Value::Number(number) => Tree::Number(number.clone()),
        Value::Form(form) => net(form),
        Value::Spline(pieces) => net(pieces.net()),
        Value::List(items) => Tree::List(items.iter().map(tree).collect()),
        other => Tree::Other(other.display(Language::English)),
    }
}

fn net<S: Arithmetic>(form: &Form<S>) -> Tree<S> {
    fn part<S: Arithmetic>(orders: &[usize], numbers: &[S]) -> Tree<S> {
        match orders.split_first() {
            None => Tree::Pole(numbers.to_vec()),
            Some((order, rest)) => {
                let rows = numbers.chunks(numbers.len() / order);
                Tree::List(rows.map(|row| part(rest, row)).collect())
            }
        }
    }
    part(form.orders(), form.homogeneous())
}

fn alike<S: Arithmetic>(a: &Tree<S>, b: &Tree<S>, projective: bool, accuracy: f64) -> bool {
    match (a, b) {
        (Tree::Number(a), Tree::Number(b)) => near(a, b, accuracy),
        (Tree::Pole(a), Tree::Pole(b)) => {
            let (a, b) = if projective { (point(a), point(b)) } else { (a.clone(), b.clone()) };
            a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| near(a, b, accuracy))
        }
        (Tree::List(a), Tree::List(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| alike(a, b, projective, accuracy))
        }
        (Tree::Other(a), Tree::Other(b)) => a == b,
        _ => false,
    }
}

fn near<S: Arithmetic>(a: &S, b: &S, accuracy: f64) -> bool {
    a == b || (a.to_f64() - b.to_f64()).abs() < accuracy
}

fn point<S: Arithmetic>(pole: &[S]) -> Vec<S> {
    let (weight, coordinates) = pole.split_last().unwrap();
    coordinates.iter().map(|x| x.clone() / weight.clone()).collect()
}
