//! Very long and very deep sources: a tree at once, on a small stack, with a clear error where needed.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use pforms_formula::{
    Language, Locale, Problem, at, classify, convert, parse, point_spans, print, references, shift,
};
use std::time::{Duration, Instant};

/// Runs every entry point on the source, on a stack of half a megabyte, within five seconds even on a busy machine.
fn survives(source: &str) -> bool {
    let source = source.to_owned();
    let work = move || {
        let begun = Instant::now();
        let tree = parse(&source, Locale::DecimalPoint);
        assert!(begun.elapsed() < Duration::from_secs(1), "{:?}", begun.elapsed());
        let copy = tree.clone();
        assert!(copy.same(&tree));
        assert!(format!("{tree:?}").len() > source.len() / 8);
        let text = print(&tree, Locale::DecimalPoint, Language::English);
        if !tree.has_errors() {
            assert!(parse(&text, Locale::DecimalPoint).same(&tree));
        }
        references(&tree);
        point_spans(&tree);
        classify(&source, Locale::DecimalComma);
        convert(&source, Locale::DecimalPoint, Locale::DecimalComma);
        shift(&source, 1, 1);
        at(&source, source.len() / 2, Locale::DecimalPoint);
        assert!(begun.elapsed() < Duration::from_secs(5), "{:?}", begun.elapsed());
        tree.has_errors()
    };
    let thread = std::thread::Builder::new().stack_size(512 * 1024).spawn(work).unwrap();
    !thread.join().unwrap()
}

#[test]
fn long_but_sound() {
    let terms = vec!["A1"; 33_000].join("+");
    let points = vec!["(1, 2, 3; 0.5)"; 7_000].join(", ");
    assert!(survives(&format!("={terms}")));
    assert!(survives(&format!("[{points}]")));
    assert!(survives(&format!("={}", vec!["2*x"; 25_000].join("<"))));
    assert!(survives(&format!("=\"{}\"", "é\"\"".repeat(30_000))));
    assert!(survives(&format!("={}", "9".repeat(100_000))));
    assert!(survives(&format!("={}", "x".repeat(100_000))));
}

#[test]
fn long_and_broken() {
    for piece in [
        "1 ", "#", "# ", ",", ")", "]", "1)", ":", "|", "A1:", "\" ", "$", "(1;2;", "F(,", "F(a:",
        "*/", "=", "€x,",
    ] {
        assert!(!survives(&format!("={}", piece.repeat(100_000 / piece.len()))), "{piece}");
        assert!(
            !survives(&format!("=F({})", piece.repeat(100_000 / piece.len()))) || piece == ":",
            "{piece}"
        );
    }
}

#[test]
fn ten_thousand_deep() {
    let n = 10_000;
    for (open, core, close) in [
        ("(", "1", ")"),
        ("[", "1", "]"),
        ("-", "1", ""),
        ("2^", "2", ""),
        ("IF(A1>0, 1, ", "0", ")"),
        ("(1, ", "2", ")"),
        ("1+(", "2", ")"),
        ("F(k: ", "2", ")"),
        ("([", "1", "])"),
    ] {
        let source = format!("={}{core}{}", open.repeat(n), close.repeat(n));
        assert!(!survives(&source), "{open}");
        assert!(!survives(&format!("={}", open.repeat(n))), "{open}");
        let tree = parse(&source, Locale::DecimalPoint);
        let problems: Vec<&Problem> = tree.errors().map(|(_, fault)| &fault.problem).collect();
        assert!((1..5).contains(&problems.len()), "{open}");
        assert!(problems.iter().all(|problem| **problem == Problem::TooDeep(256)), "{open}");
    }
}

#[test]
fn depth_within_the_limit_is_sound() {
    for (open, close, n) in [
        ("(", ")", 250),
        ("-", "", 250),
        ("2^", "", 250),
        ("IF(A1>0, 1, ", ")", 250),
        ("1+2*(", ")", 80),
    ] {
        assert!(survives(&format!("={}1{}", open.repeat(n), close.repeat(n))), "{open}");
    }
}
