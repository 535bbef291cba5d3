//! What sources mean, shown as nested words: `(+ 1 (* 2 3))`.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use pforms_formula::{Argument, Expression, Language, Locale, NodeId, Problem, Tree, parse};

fn shape(tree: &Tree, id: NodeId) -> String {
    let all = |ids: &[NodeId]| {
        let shapes: Vec<String> = ids.iter().map(|id| shape(tree, *id)).collect();
        shapes.join(" ")
    };
    match &tree[id].expression {
        Expression::Number(text) | Expression::Name(text) => text.clone(),
        Expression::Text(text) => format!("{text:?}"),
        Expression::Boolean(value) => value.to_string(),
        Expression::CellRef(cell) => cell.to_string(),
        Expression::Range(range) => range.to_string(),
        Expression::List(items) => format!("[{}]", all(items)),
        Expression::Unary { sign, operand } => {
            format!("({} {})", sign.symbol(), shape(tree, *operand))
        }
        Expression::Binary { operator, left, right } => {
            format!("({} {})", operator.symbol(), all(&[*left, *right]))
        }
        Expression::Point { coordinates, weight } => {
            let weight = weight.map_or(String::new(), |w| format!("; {}", shape(tree, w)));
            format!("(point {}{weight})", all(coordinates))
        }
        Expression::Call(call) => {
            let arguments: Vec<String> = call.arguments.iter().map(|a| argument(tree, a)).collect();
            format!("({}!{})", call.name, arguments.concat())
        }
        Expression::Error(fault) => {
            let name = format!("{:?}", fault.problem);
            let name = name.split(['(', '{', ' ']).next().unwrap_or_default().to_owned();
            format!("<{}>", format!("{name} {}", all(&fault.parts)).trim_end())
        }
    }
}

fn argument(tree: &Tree, argument: &Argument) -> String {
    let keyword = argument.keyword.as_ref().map_or(String::new(), |keyword| format!("{keyword}:"));
    format!(" {keyword}{}", shape(tree, argument.value))
}

fn check(locale: Locale, cases: &[(&str, &str)]) {
    for (source, expected) in cases {
        let tree = parse(source, locale);
        assert_eq!(&shape(&tree, tree.root()), expected, "{source}");
    }
}

#[test]
fn operators() {
    check(
        Locale::DecimalPoint,
        &[
            ("1+2*3", "(+ 1 (* 2 3))"),
            ("1-2-3", "(- (- 1 2) 3)"),
            ("2^3^2", "(^ 2 (^ 3 2))"),
            ("-2^2", "(- (^ 2 2))"),
            ("2^-3^2", "(^ 2 (- (^ 3 2)))"),
            ("-a*b", "(* (- a) b)"),
            ("2 × 3 ÷ 4 · 5 − 6", "(- (* (/ (* 2 3) 4) 5) 6)"),
            ("a ≤ b + 1", "(<= a (+ b 1))"),
            ("a<>1 = (b≠2)", "(= (<> a 1) (<> b 2))"),
            ("2**3", "(^ 2 3)"),
        ],
    );
}

#[test]
fn values() {
    check(
        Locale::DecimalPoint,
        &[
            ("=  1.50e-3", "1.50e-3"),
            ("1.", "1"),
            ("(1, 2.5, 3; .5)", "(point 1 2.5 3; .5)"),
            ("(1, 2 | 0)", "(point 1 2; 0)"),
            ("(x,)", "(point x)"),
            ("(x; w)", "(point x; w)"),
            ("((x))", "x"),
            ("[]", "[]"),
            ("[[1;2],(3,4)]", "[[1 2] (point 3 4)]"),
            ("\"say \"\"x\"\"\"", "\"say \\\"x\\\"\""),
            ("«\u{a0}été\u{a0}»", "\"été\""),
            ("vrai", "true"),
            ("$a$1:b3", "$A$1:B3"),
            ("A1 : B3", "A1:B3"),
            ("ABCD1 + A0 + pL04 + élan_2", "(+ (+ (+ ABCD1 A0) pL04) élan_2)"),
        ],
    );
}

#[test]
fn calls() {
    check(
        Locale::DecimalPoint,
        &[
            ("MIR()", "(MIR!)"),
            ("mir(A1; A2, A3)", "(mir! A1 A2 A3)"),
            ("LOG10(2)+ATAN2 (1,2)", "(+ (LOG10! 2) (ATAN2! 1 2))"),
            ("F(A1:B2, kind: \"x\", by=(1,2))", "(F! A1:B2 kind:\"x\" by:(point 1 2))"),
            ("F(r: A1:B2)", "(F! r:A1:B2)"),
            ("F(x==1, (x=1), A1=1)", "(F! (= x 1) (= x 1) (= A1 1))"),
            ("si(x=1; 2; 3)", "(si! (= x 1) 2 3)"),
        ],
    );
}

#[test]
fn decimal_commas() {
    check(
        Locale::DecimalComma,
        &[
            ("=(1,5; 2; 3 | 0,5)", "(point 1.5 2 3; 0.5)"),
            ("(1,5;)", "(point 1.5)"),
            ("(1,5)", "1.5"),
            ("MI(A1;1,5e-3)", "(MI! A1 1.5e-3)"),
            ("MI(A1, 1.5)", "(MI! A1 1.5)"),
            ("[,5;-,5]", "[.5 (- .5)]"),
        ],
    );
}

#[test]
fn faults_keep_what_was_understood() {
    check(
        Locale::DecimalPoint,
        &[
            ("", "<Empty>"),
            ("=", "<Empty>"),
            ("1 +", "(+ 1 <MissingOperand>)"),
            ("1 * / 2", "(/ (* 1 <MissingOperand>) 2)"),
            ("1 2 3", "<MissingOperator 1 2 3>"),
            ("2x", "<MissingOperator 2 x>"),
            ("F(1,,2,)", "(F! 1 <MissingItem> 2 <MissingItem>)"),
            ("(1,2,)", "(point 1 2 <MissingItem>)"),
            ("()", "<EmptyBrackets>"),
            ("(,1)", "(point <MissingItem> 1)"),
            ("(;1)", "(point <MissingItem>; 1)"),
            ("F(1, [2, 3)", "(F! 1 <Unclosed [2 3]>)"),
            ("(1, 2]", "<Mismatched (point 1 2)>"),
            ("1)+2, 3", "<Unopened 1 (+ 2) 3>"),
            ("1, 2", "<LooseSeparator 1 2>"),
            ("(1, 2; 3, 4)", "(point 1 2; <AfterWeight 3 4>)"),
            ("[1 | 2]", "[<MisplacedWeight 1 2>]"),
            ("1 + #! + 2", "(+ (+ 1 <Unexpected>) 2)"),
            ("\"abc", "<UnclosedText \"abc\">"),
            ("$A", "<BadAddress>"),
            ("A1000001", "<OutsideSheet>"),
            ("A1:", "<RangeEnd A1>"),
            ("A1:x", "<MissingOperator <RangeEnd A1> x>"),
            ("F(a: )", "(F! a:<MissingItem>)"),
            ("F(p1: 2)", "(F! <MissingOperator <RangeEnd P1> 2>)"),
        ],
    );
}

#[test]
fn faults_have_a_place_and_speak_two_languages() {
    let tree = parse("=é + MIR(A1, #)", Locale::DecimalPoint);
    let (span, fault) = tree.errors().next().unwrap();
    assert_eq!((fault.place.of(tree.source()), fault.column, span), ("#", 13, fault.place));
    assert_eq!(fault.problem, Problem::Unexpected("#".into()));
    assert_eq!(fault.problem.message(Language::English), "“#” has no meaning here.");
    assert_eq!(fault.problem.message(Language::French), "« # » n’a pas de sens ici.");
    assert!(!fault.problem.hint(Language::French).is_empty());
}

#[test]
fn spans_cover_their_brackets() {
    let tree = parse("= (1+2)*F( (3) ) ", Locale::DecimalPoint);
    assert_eq!(tree.text(tree.root()), "(1+2)*F( (3) )");
    let Expression::Binary { left, right, .. } = tree[tree.root()].expression else { panic!() };
    assert_eq!((tree.text(left), tree.text(right)), ("1+2", "F( (3) )"));
}
