//! How arguments find their parameters, and what is said when they do not.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use pforms_catalogue::{Arguments, Failure, Language, Value, complete, find, unknown};
use pforms_kernel::Rational;

mod reader;

fn value(text: &str) -> Value {
    reader::compute::<f64>(text).settle()
}

fn shown(text: &str) -> String {
    value(text).display(Language::English)
}

fn failure(text: &str) -> Failure {
    value(text).failure().unwrap_or_else(|| panic!("{text} is no error")).clone()
}

fn complaint(text: &str) -> String {
    failure(text).message(Language::English).to_owned()
}

#[test]
fn the_octant_of_sphere_and_its_arc() {
    let meridian = "[(1, 0, 0), (1, 0, 1), (0, 0, 1; 2)]";
    let sphere = format!("MIR({meridian}, [(1, 0, 0), (1, 1, 1), (0, 0, 1; 2)], {meridian})");
    assert_eq!(shown(&format!("={sphere}")), "pS33 · 3D · rational");
    assert_eq!(shown(&format!("=DIAG({sphere})")), "pL5 · 3D · rational");
    assert_eq!(shown(&format!("=DIAG({sphere}, \"tout\")")), "pL5 · 3D · rational");
}

#[test]
fn names_in_either_language_call_with_arguments_by_name() {
    let english = value("=STRETCH(form=[(0, 0), (1, 2), (2, 0)], a=-1, b=2)");
    assert_eq!(english, value("=étire([(0, 0), (1, 2), (2, 0)], b=2, a=-1)"));
    assert_eq!(english, value("=ETIRE(forme=[(0, 0), (1, 2), (2, 0)], a=[-1], b=[2])"));
    assert_eq!(shown("=ELEVATE([(0, 0), (1, 2)])"), "pL3 · 2D", "by is 1 when it is not given");
}

#[test]
fn lists_and_ranges_spread() {
    let points = || ["=(0, 0)", "=(1, 2)", "=(2, 0)"].map(value).to_vec();
    let mir = find("MIR").unwrap();
    let mut range = Arguments::new([]);
    let mut cells = points();
    cells.insert(1, Value::Empty);
    range.push_range(cells);
    let curve = mir.call(range);
    assert_eq!(curve.kind(Language::English), "pL3");
    assert_eq!(curve, mir.call(Arguments::new(points())));
    assert_eq!(curve, mir.call(Arguments::new([Value::list(points())])));
    let mut rows = Arguments::new([]);
    rows.push_range(vec![Value::list(points()), Value::list(points())]);
    assert_eq!(mir.call(rows).kind(Language::English), "pS23");
    assert_eq!(shown("=MIR([(0, 0), (1, 0)], [(0, 1), (1, 1)])"), "pS22 · 2D");
    assert_eq!(shown("=SUM(1, [2, [3]], 4)"), "10");
}

#[test]
fn parameters_may_be_lists_of_their_own() {
    assert_eq!(shown("=POINT([(0, 0), (1, 2), (2, 0)], [0, 1/2, 1])"), "pL3 · 2D");
    assert_eq!(shown("=POINT([[(0, 0), (1, 0)], [(0, 1), (1, 1)]], [0, 1/2], 1)"), "pL2 · 2D");
    assert_eq!(shown("=POINT(SUBDIVIDE([(0, 0), (1, 2), (2, 0)], 3), 1/2)"), "(1, 1)");
    assert_eq!(shown("=POINT((1, 2))"), "(1, 2)");
    assert!(complaint("=ORDERS(5)").contains("expected a form or a net of points"));
    assert_eq!(shown("=BLOSSOM([[(0, 0), (1, 0)], [(0, 1), (1, 1)]], [1/2], [1])"), "(1, 0.5)");
    assert_eq!(
        shown("=SUBDIVIDE([[(0, 0), (1, 0)], [(0, 1), (1, 1)]], 1, 2)"),
        "spline of 2×4 pS22 · 2D"
    );
}

#[test]
fn explain_prints_what_the_book_prints() {
    let text = shown("=EXPLAIN(\"DIAG\", \"pS33\")");
    assert_eq!(text.lines().nth(2), Some("q2 = (p02 + 4·p11 + p20)/6"));
    assert_eq!(shown("=EXPLIQUER(\"milieu\", \"pP\", \"pP\")"), "q = (a + b)/2");
    assert_eq!(shown("=EXPLAIN(\"SUB\", \"pL3\", 0, 0.5)"), "q = (p0 + 2·p1 + p2)/4");
    assert_eq!(
        complaint("=EXPLAIN(\"ORDERS\", \"pL3\")"),
        "EXPLAIN, operator: received an operator that gives list, expected an operator that gives a form"
    );
    assert!(complaint("=EXPLAIN(\"EXPLAIN\", \"EXPLAIN\", \"pL3\")").starts_with("EXPLAIN, "));
}

#[test]
fn wrong_arguments_are_named() {
    assert_eq!(
        complaint("=MI(\"x\")"),
        "MI, forms: received the text “x”, expected a form or a net of points"
    );
    assert_eq!(complaint("=SUB((0, 0), 0)"), "SUB, t: received nothing, expected a number");
    assert_eq!(
        complaint("=SUB([(0, 0), (1, 1)], 0.5, 0)"),
        "SUB, axis: received 0.5, expected a whole number from 0"
    );
    assert_eq!(
        complaint("=SUB([(0, 0), (1, 1)], 1, 0)"),
        "SUB, axis: received 1, expected 0 to 0 for a pL2"
    );
    assert_eq!(
        complaint("=REVERSE((0, 0), 0, 1)"),
        "REVERSE, arguments: received 3, expected at most 2: REVERSE(form, [axis])"
    );
    assert_eq!(
        failure("=SUB([(0, 0), (1, 1)], 1, 0)").message(Language::French),
        "SOUSFORME, axe : reçu 1, attendu 0 à 0 pour une pL2"
    );
    assert_eq!(complaint("=SQRT(4, x=9)"), "SQRT, x: received two values, expected one");
    assert_eq!(
        complaint("=PARTITION(0, 1, 60)"),
        "PARTITION, r: received 60, expected a number from 0 to 19"
    );
    assert_eq!(
        complaint("=STRETCH([(0, 0), (1, 1)], [0, 0], 1)"),
        "STRETCH, a: received a list of 2, expected one, or 1"
    );
    assert_eq!(
        complaint("=REDUCE([(0, 0), (1, 1)], 1, \"all\")"),
        "REDUCE, part: received the text “all”, expected \"form\", \"bound\""
    );
    assert_eq!(
        failure("=MI(\"x\")").message(Language::French),
        "MI, formes : reçu le texte « x », attendu une forme ou un réseau de points"
    );
}

#[test]
fn near_misses_are_suggested() {
    let wrong = failure("=SUB([(0, 0), (1, 1)], axes=0, t=0)");
    assert_eq!(
        wrong.message(Language::English),
        "SUB, unknown argument “axes”, expected form, axis, t"
    );
    assert_eq!(wrong.hint(Language::English), Some("did you mean axis?"));
    assert_eq!(unknown("DAIG").hint(Language::English), Some("did you mean DIAG?"));
    assert_eq!(unknown("ELEVATON").hint(Language::French), Some("vouliez-vous dire ELEVATION ?"));
    assert_eq!(unknown("ZZZZZZ").hint(Language::English), None);
}

#[test]
fn forms_in_pieces_and_numbers_explain_what_to_do() {
    let pieces = failure("=MOBIUS(SUBDIVIDE([(0, 0), (1, 1)], 1), 0, 2)");
    assert!(pieces.hint(Language::English).unwrap().starts_with("NET(…)"));
    let number = failure("=MIR(1, 2)");
    assert_eq!(number.hint(Language::English), Some("a one-dimensional point is written (x,)"));
    assert_eq!(shown("=MIR(1/0, 2)"), "divisor: received 0, expected a number other than 0");
}

#[test]
fn errors_flow_and_conditions_choose() {
    let origin: Value = Failure::new("Cycle", "A1 → A1", "A1 → A1").at("A1").into();
    let call =
        |name: &str, arguments: Vec<Value>| find(name).unwrap().call(Arguments::new(arguments));
    assert_eq!(call("MI", vec![Value::Empty, origin.clone()]), origin);
    assert_eq!(
        call("IF", vec![Value::Boolean(true), Value::Number(1.0), origin.clone()]),
        Value::Number(1.0)
    );
    assert_eq!(call("SI", vec![Value::Boolean(false), Value::Number(1.0), origin.clone()]), origin);
    assert_eq!(call("SI", vec![origin.clone(), Value::Number(1.0)]), origin);
    assert_eq!(call("SIERREUR", vec![origin, Value::Number(2.0)]), Value::Number(2.0));
    assert_eq!(shown("=IF(2 > 1, \"yes\", \"no\")"), "yes");
}

#[test]
fn exact_mode_says_where_it_ends() {
    let exact = |text: &str| reader::compute::<Rational>(text);
    assert_eq!(exact("=SQRT(1/4)").display(Language::English), "1/2");
    let fit = exact("=FIT([(0, 0), (1, 1), (2, 0)], 2)");
    let failure = fit.failure().unwrap();
    assert_eq!(
        failure.message(Language::English),
        "FIT, mode: received exact mode, expected floating mode"
    );
    assert!(failure.hint(Language::French).unwrap().contains("mode flottant"));
    assert!(exact("=SQRT(2)").failure().unwrap().hint(Language::English).is_some());
}

#[test]
fn absurd_sizes_are_refused_at_once() {
    for text in [
        "=ELEVATE([(0, 0), (1, 1)], 100000)",
        "=SUBDIVIDE([(0, 0), (1, 1)], 40)",
        "=PASCAL(100000000)",
        "=SEQUENCE(0, 1, 100000000)",
        "=SEQUENCE(0, 1e300)",
        "=GRID([[(0, 0), (1, 0)], [(0, 1), (1, 1)]], 4097, 1e9)",
        "=TILE([(0, 0), (1, 1)], [[(0, 0), (1, 0)], [(0, 1), (1, 1)]], 4096, 4096)",
        "=EXPLAIN(\"DIAG\", \"pS[999999,999999]\")",
        "=DERIVATIVE([(0, 0; 1), (1, 1; 2)], 17)",
        "=TRANSPOSE([(0, 0), (1, 1)], 7)",
        "=DIAG((0, 0))",
        "=ITEM([1, 2], 2)",
        "=POLE([(0, 0), (1, 1)], 9)",
    ] {
        assert!(value(text).is_error(), "{text}");
    }
}

#[test]
fn completion_offers_the_language_first() {
    let names = |prefix: &str, language| -> Vec<&str> {
        complete(prefix, language).iter().map(|completion| completion.name).collect()
    };
    assert_eq!(names("él", Language::French), ["ELEMENT", "ELEVATION", "ELLIPSE"]);
    assert_eq!(names("mi", Language::English)[..3], ["MI", "MIN", "MINIMAL"]);
    assert!(names("racin", Language::English).contains(&"SQRT"));
    assert!(names("qqq", Language::English).is_empty());
}

#[test]
fn frames_are_records_with_names_in_both_languages() {
    let curve = "[(0, 0, 0), (1, 0, 0), (2, 2, 0)]";
    assert_eq!(shown(&format!("=FRAME({curve}, 0, part=\"tangent\")")), "(1, 0, 0; 0)");
    assert_eq!(shown(&format!("=REPERE({curve}, 0, partie=\"courbure\")")), "1");
    assert_eq!(shown(&format!("=ELEMENT(REPERE({curve}, 0), \"binormale\")")), "(0, 0, 1; 0)");
    assert_eq!(shown(&format!("=FRAME({curve}, 0, part=\"tangent\", unit=FALSE)")), "(2, 0, 0; 0)");
    let speed = format!("=FRAME({curve}, 1, kind=\"rotation minimale\", part=\"speed\")");
    assert!(shown(&speed).starts_with("4.4721359549995"));
    let record = value(&format!("=FRAME({curve}, 0)")).to_json();
    assert_eq!(record["torsion"], 0.0);
    let saddle = "[[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]]";
    assert_eq!(shown(&format!("=FRAME({saddle}, 0, 0, part=\"normal\")")), "(0, 0, 1; 0)");
    assert_eq!(shown(&format!("=CURVATURE({saddle}, 0, 0, part=\"principales\")")), "[1, -1]");
    assert_eq!(shown(&format!("=CURVATURE({curve}, 0)")), "1");
    assert_eq!(
        complaint(&format!("=FRAME({saddle}, 0, 0, part=\"torsion\")")),
        "FRAME, entry: received “torsion”, expected point, tu, tv, normal, gauss, mean, \
         principal, directions, first, second, area"
    );
    assert!(complaint(&format!("=FRAME({curve}, 0, 1)")).contains("parameters"));
}

#[test]
fn nearest_points_are_records_with_names_in_both_languages() {
    let parabola = "[(-1, 1), (0, -1), (1, 1)]";
    assert_eq!(shown(&format!("=PROJECT({parabola}, (0, -1), part=\"point\")")), "(0, 0)");
    assert_eq!(shown(&format!("=PROJETTE({parabola}, (0, -1), partie=\"paramètres\")")), "[0.5]");
    assert_eq!(shown(&format!("=PROJETTE({parabola}, (0, 3), partie=\"unique\")")), "FALSE");
    let several = format!("=PROJECT({parabola}, [(0, -1), (0, -2)], part=\"distance\")");
    assert_eq!(shown(&several), "[1, 2]");
    let french = failure(&format!("=PROJETTE({parabola}, (0, 0, 0))"));
    assert!(french.message(Language::French).contains("dimension 2"), "{french:?}");
}

#[test]
fn an_immersion_that_would_take_hours_is_refused() {
    let host = "ELEVATE([[[(0, 0, 0), (0, 0, 1)], [(0, 1, 0), (0, 1, 1)]], \
                [[(1, 0, 0), (1, 0, 1)], [(1, 1, 0), (1, 1, 1)]]], 28)";
    let inner = "ELEVATE([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]], 28)";
    let refused = failure(&format!("=IMMERSE({inner}, {host})"));
    assert_eq!(refused.family(), "Limit");
    let lazy = format!("IMMERSE({inner}, {host}, lazy=TRUE)");
    assert_eq!(shown(&format!("=POINT({lazy}, 1/4, 3/4)")), "(0.25, 0.75, 0)");
    assert_eq!(failure(&format!("=REVERSE({lazy})")).family(), "Limit");
}

#[test]
fn fractions_that_would_grow_for_minutes_are_refused() {
    let exact = |text: &str| reader::compute::<Rational>(text);
    for text in [
        "=STRETCH(ELEVATE([(0,), (1/3,), (1/5,)], 100), 0.123456789123456789, 2)",
        "=POINT(ELEVATE([(0,), (1/2,), (1,)], 900), PARTITION(0, 1/3, 6))",
        "=INTERPOLATE(GRID([(0,), (1/2,), (1,)], 200))",
    ] {
        let family = exact(text).failure().map(Failure::family);
        assert_eq!(family, Some("Limit"), "{text}");
        assert!(!value(text).is_error(), "{text} in floating mode");
    }
    let mut curve = exact("=[(1/3,), (1/7,), (1/9,)]").settle();
    let host = curve.clone();
    let immerse = find("IMMERSE").unwrap();
    let refused = (0..30).find_map(|_| {
        curve = immerse.call(Arguments::new([curve.clone(), host.clone()]));
        curve.failure().map(Failure::family)
    });
    assert_eq!(refused, Some("Limit"));
}

#[test]
fn what_has_no_part_is_refused_by_name() {
    let points = "[(0, 0), (1, 1), (2, 0), (3, 1)]";
    let tangents = "tangents=[(1, 0), (0, 1)]";
    for (call, argument) in [
        (format!("=SPLINE({points}, {tangents})"), "tangents"),
        (format!("=SPLINE({points}, circle=TRUE)"), "circle"),
        (format!("=SPLINE({points}, 2, ends=\"periodic\")"), "ends"),
        (format!("=SPLINE({points}, 2, parameters=\"uniform\")"), "parameters"),
        (format!("=SPLINE({points}, start=[(0, 1), (1, 2)], {tangents})"), "tangents"),
        ("=REVOLVE([(1, 0), (2, 1)], order=4)".to_owned(), "order"),
        ("=ITERATE([(0, 0), (1, 0)], 2, ratio=1/3)".to_owned(), "ratio"),
        ("=CONTINUITY([(0, 0), (1, 0)], at=[0, 1])".to_owned(), "at"),
        ("=CONTINUITY([(0, 0), (1, 0)], [(1, 0), (2, 0)], axis=0)".to_owned(), "axis"),
        (
            "=FRAME([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]], 0, 0, kind=\"tangent\")"
                .to_owned(),
            "kind",
        ),
    ] {
        let failure = failure(&call);
        assert_eq!(failure.family(), "Shape", "{call}");
        let said = failure.message(Language::English);
        assert!(said.contains(&format!("{argument}: received")), "{call}: {said}");
        assert!(said.contains("the other arguments leave it no part"), "{call}: {said}");
    }
    // FALSE asks for nothing, and what is exact keeps every accuracy.
    assert_eq!(shown(&format!("=SPLINE({points}, circle=FALSE)")), "spline of 3 pL4 · 2D");
    let facet = "[[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]]";
    assert!(value(&format!("=FRAME({facet}, 0, 0, accuracy=1/100)")).failure().is_none());
}

#[test]
fn no_argument_is_passed_over() {
    for operator in pforms_catalogue::catalogue() {
        let name = operator.formula_name(Language::English);
        let opening = format!("={name}(");
        let Some(inner) = operator.example.strip_prefix(&opening) else { continue };
        let Some(inner) = inner.strip_suffix(')') else { continue };
        if operator.takes_errors {
            continue;
        }
        let optional = operator.parameters.iter().filter(|parameter| !parameter.is_required());
        for parameter in optional.map(|parameter| parameter.name.en) {
            // What is exact keeps every accuracy.
            if matches!(parameter, "accuracy" | "tolerance") {
                continue;
            }
            let call = format!("{opening}{inner}, {parameter}=\"no such thing\")");
            assert!(value(&call).failure().is_some(), "{call}");
        }
    }
}
