//! Laws that hold for every source.
#![cfg(not(target_arch = "wasm32"))]
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use pforms_formula::{
    Content, Expression, Language, Locale, Tree, at, classify, convert, map_references, parse,
    point_spans, print, references, replace_point, shift,
};
use proptest::prelude::*;

/// Words of the language in any order.
fn soup() -> impl Strategy<Value = String> {
    let words = prop::sample::select(vec![
        "1", "2.5", ".5", "1e3", "1,5", "A1", "$B$2", "C3:D4", "x", "é", "IF(", "F(", "(", ")",
        "[", "]", ",", ";", "|", ":", "=", "==", "+", "-", "−", "*", "^", "<", "≤", "\"t\"", "\"",
        "“", "»", "«", "#", "$", "k:", "k=", " ", "\u{a0}", "TRUE", "'", "A9999999", ".", "e",
    ]);
    prop::collection::vec(words, 0..40).prop_map(|words| words.concat())
}

fn any_source() -> impl Strategy<Value = String> {
    prop_oneof![
        any::<String>(),
        soup(),
        soup().prop_map(|s| format!("={s}")),
        soup().prop_map(|s| format!("[({s}"))
    ]
}

/// Sound expressions, with brackets around every part.
fn sound() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        "[0-9]{1,3}(\\.[0-9]{1,3})?(e-?[0-9])?",
        "\\.[0-9]{1,3}",
        "\"[a-zé ,;]{0,4}(\"\")?\"",
        prop::sample::select(vec!["A1", "$b$2", "C3:D4", "x", "élan", "TRUE", "faux", "[]"])
            .prop_map(String::from),
    ];
    leaf.prop_recursive(6, 60, 4, |inner| {
        let operator = prop::sample::select(vec!["+", "-", "*", "/", "^", "=", "<>", "<", "<=", ">", ">="]);
        let few = |low| prop::collection::vec(inner.clone(), low..4).prop_map(|items| items.join(", "));
        prop_oneof![
            3 => (inner.clone(), operator.clone(), inner.clone()).prop_map(|(a, o, b)| format!("({a}){o}({b})")),
            1 => (inner.clone(), operator, inner.clone()).prop_map(|(a, o, b)| format!("{a}{o}{b}")),
            1 => inner.clone().prop_map(|a| format!("-({a})")),
            1 => inner.clone().prop_map(|a| format!("+{a}")),
            1 => few(2).prop_map(|items| format!("({items})")),
            1 => inner.clone().prop_map(|a| format!("({a},)")),
            1 => (few(1), inner.clone()).prop_map(|(items, w)| format!("({items}; {w})")),
            1 => few(0).prop_map(|items| format!("[{items}]")),
            1 => few(0).prop_map(|items| format!("MIR({items})")),
            1 => few(1).prop_map(|items| format!("IF({items})")),
            1 => (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("F(({a}), k: {b})")),
        ]
    })
}

/// The nodes a node is made of.
fn children(expression: &Expression) -> Vec<usize> {
    let ids = match expression {
        Expression::Point { coordinates, weight } => {
            coordinates.iter().chain(weight).copied().collect()
        }
        Expression::List(items) => items.clone(),
        Expression::Unary { operand, .. } => vec![*operand],
        Expression::Binary { left, right, .. } => vec![*left, *right],
        Expression::Call(call) => call.arguments.iter().map(|a| a.value).collect(),
        Expression::Error(fault) => fault.parts.clone(),
        _ => Vec::new(),
    };
    ids.into_iter().map(pforms_formula::NodeId::index).collect()
}

fn assert_sane(tree: &Tree) {
    let mut parents = vec![0; tree.nodes().len()];
    for (index, node) in tree.nodes().iter().enumerate() {
        assert!(tree.source().get(node.span.start..node.span.end).is_some(), "{:?}", node.span);
        for child in children(&node.expression) {
            let inner = tree.nodes()[child].span;
            assert!(
                child < index && node.span.start <= inner.start && inner.end <= node.span.end,
                "{tree:?}"
            );
            parents[child] += 1;
        }
    }
    assert_eq!(parents.pop(), Some(0));
    assert!(
        parents.iter().all(|count| *count == 1) && tree.root().index() == parents.len(),
        "{tree:?}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_has_a_sane_tree(source in any_source()) {
        for locale in [Locale::DecimalPoint, Locale::DecimalComma] {
            let tree = parse(&source, locale);
            assert_sane(&tree);
            for (_, fault) in tree.errors() {
                let before = source.get(..fault.place.start).map(|text| text.chars().count());
                prop_assert_eq!(before, Some(fault.column));
                prop_assert!(source.get(fault.place.start..fault.place.end).is_some());
            }
            if !tree.has_errors() {
                let text = print(&tree, locale, Language::French);
                prop_assert!(parse(&text, locale).same(&tree), "{} became {}", source, text);
            }
        }
    }

    #[test]
    fn nothing_panics(source in any_source(), caret in 0..80_usize) {
        at(&source, caret, Locale::DecimalPoint);
        shift(&source, 1, -1);
        convert(&source, Locale::DecimalComma, Locale::DecimalPoint);
        if let Content::Literal(tree) | Content::Formula(tree) = classify(&source, Locale::DecimalPoint) {
            references(&tree);
            for (path, _) in point_spans(&tree) {
                replace_point(&source, &path, &[Some(1.0), None]);
            }
        }
    }

    #[test]
    fn sound_sources_print_and_parse(source in sound()) {
        let tree = parse(&source, Locale::DecimalPoint);
        prop_assert!(!tree.has_errors(), "{source}");
        for locale in [Locale::DecimalPoint, Locale::DecimalComma] {
            let text = print(&tree, locale, Language::English);
            let again = parse(&text, locale);
            prop_assert!(again.same(&tree), "{} became {}", source, text);
            prop_assert_eq!(print(&again, locale, Language::English), text);
        }
    }

    #[test]
    fn conversion_keeps_the_meaning(source in sound()) {
        let formula = format!("= {source}");
        let tree = parse(&formula, Locale::DecimalPoint);
        let comma = convert(&formula, Locale::DecimalPoint, Locale::DecimalComma);
        prop_assert!(parse(&comma, Locale::DecimalComma).same(&tree), "{} became {}", source, comma);
        let back = convert(&comma, Locale::DecimalComma, Locale::DecimalPoint);
        prop_assert_eq!(back, formula);
    }

    #[test]
    fn shifting_there_and_back(source in sound(), columns in 0..9_i64, rows in 0..9_i64) {
        let formula = format!("={source}");
        let plain = map_references(&formula, |cell| Some(cell.address.into())).unwrap();
        let there = shift(&plain, columns, rows).unwrap();
        prop_assert_eq!(shift(&there, -columns, -rows), Some(plain));
    }

    #[test]
    fn dragged_points_read_back(x in any::<f64>(), y in -1e9..1e9_f64) {
        let moved = replace_point("[7, [(1,2 ; 3)]]", &[1, 0], &[Some(x), Some(y)]);
        prop_assert_eq!(moved.is_some(), x.is_finite());
        if let Some(text) = moved {
            let Content::Literal(tree) = classify(&text, Locale::DecimalPoint) else { panic!("{text}") };
            let (_, span) = point_spans(&tree).remove(0);
            let inner = span.of(&text).trim_matches(['(', ')']);
            let read: Vec<f64> = inner.split([',', ';']).map(|n| n.trim().parse().unwrap()).collect();
            prop_assert_eq!(read, vec![x, y, 3.0]);
        }
    }
}
