//! Elementary functions.

use pforms_kernel::{Rational, binomial as choose};

use super::{Outcome, PLAIN};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Elementary, Infix, Operator, Parameter, Takes, Value, binary};

const NUMBER: Operator = Operator { group: Group::Numbers, gives: Takes::Number, ..PLAIN };

const X: Parameter =
    Parameter::new(Takes::Number, words("x", "x"), words("The number.", "Le nombre."));

const ANGLE: Parameter =
    Parameter::new(Takes::Number, words("angle", "angle"), words("The angle.", "L'angle."))
        .unit("radian", "radian");

const VALUES: Parameter = Parameter::new(
    Takes::Number,
    words("numbers", "nombres"),
    words("Numbers, lists of numbers, ranges.", "Des nombres, des listes de nombres, des plages."),
)
.variadic();

const NO_HELP: crate::Words = words("", "");

const FRACTIONS: crate::Words = words(
    "Exact mode gives a value when it is a fraction.",
    "Le mode exact donne une valeur quand c'est une fraction.",
);

/// Declares functions of one number, each the same in all but its name and words.
macro_rules! elementary {
    ($($routine:ident $variant:ident $parameter:ident [$($en:literal),+] [$($fr:literal),+]
        $summary_en:literal $summary_fr:literal $example:literal;)+) => {
        static ELEMENTARY: &[Operator] = &[$(Operator {
            name: stringify!($routine),
            english: &[$($en),+],
            french: &[$($fr),+],
            summary: words($summary_en, $summary_fr),
            help: FRACTIONS,
            parameters: &[$parameter],
            example: $example,
            call: call!($routine),
            ..NUMBER
        }),+];
        $(fn $routine<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
            S::apply(Elementary::$variant, &a.number(0)?).map(Value::Number)
        })+
    };
}

elementary! {
    sqrt Sqrt X ["SQRT"] ["RACINE"] "The square root." "La racine carrée." "=SQRT(1/4)";
    sin Sin ANGLE ["SIN"] ["SIN"] "The sine of an angle." "Le sinus d'un angle." "=SIN(0)";
    cos Cos ANGLE ["COS"] ["COS"] "The cosine of an angle." "Le cosinus d'un angle." "=COS(0)";
    tan Tan ANGLE ["TAN"] ["TAN"] "The tangent of an angle." "La tangente d'un angle." "=TAN(0)";
    asin Asin X ["ASIN"] ["ASIN", "ARCSIN"] "The angle with a given sine." "L'angle de sinus donné." "=ASIN(0)";
    acos Acos X ["ACOS"] ["ACOS", "ARCCOS"] "The angle with a given cosine." "L'angle de cosinus donné." "=ACOS(1)";
    atan Atan X ["ATAN"] ["ATAN", "ARCTAN"] "The angle with a given tangent." "L'angle de tangente donnée." "=ATAN(0)";
    exp Exp X ["EXP"] ["EXP"] "The exponential." "L'exponentielle." "=EXP(0)";
    ln Ln X ["LN"] ["LN"] "The natural logarithm." "Le logarithme népérien." "=LN(1)";
    log Log10 X ["LOG"] ["LOG"] "The decimal logarithm." "Le logarithme décimal." "=LOG(1000)";
    radians Radians X ["RADIANS"] ["RADIANS"] "Degrees as radians." "Des degrés en radians." "=RADIANS(0)";
    degrees Degrees ANGLE ["DEGREES"] ["DEGRES"] "Radians as degrees." "Des radians en degrés." "=DEGREES(0)";
}

pub(super) fn entries() -> Vec<Operator> {
    [ELEMENTARY, OTHERS].concat()
}

static OTHERS: &[Operator] = &[
    Operator {
        name: "atan2",
        english: &["ATAN2"],
        french: &["ATAN2"],
        summary: words("The angle of a direction.", "L'angle d'une direction."),
        help: words("ATAN2(y, x), from -π to π.", "ATAN2(y, x), de -π à π."),
        parameters: &[
            Parameter::new(Takes::Number, words("y", "y"), words("The ordinate.", "L'ordonnée.")),
            Parameter::new(Takes::Number, words("x", "x"), words("The abscissa.", "L'abscisse.")),
        ],
        example: "=ATAN2(0, 1)",
        call: call!(atan2),
        ..NUMBER
    },
    Operator {
        name: "pi",
        english: &["PI"],
        french: &["PI"],
        summary: words("The number π.", "Le nombre π."),
        help: words(
            "PI() or PI; no fraction, so not in exact mode.",
            "PI() ou PI ; pas une fraction, donc pas en mode exact.",
        ),
        example: "=PI()",
        call: call!(floating pi),
        ..NUMBER
    },
    Operator {
        name: "abs",
        english: &["ABS"],
        french: &["ABS"],
        summary: words("A number without its sign.", "Un nombre sans son signe."),
        help: NO_HELP,
        parameters: &[X],
        example: "=ABS(-2)",
        call: call!(abs),
        ..NUMBER
    },
    Operator {
        name: "floor",
        english: &["FLOOR"],
        french: &["PLANCHER", "ENT"],
        summary: words(
            "The greatest whole number not above.",
            "Le plus grand entier qui ne dépasse pas.",
        ),
        help: NO_HELP,
        parameters: &[X],
        example: "=FLOOR(7/2)",
        see: &["ceiling", "round"],
        call: call!(floor),
        ..NUMBER
    },
    Operator {
        name: "ceiling",
        english: &["CEILING"],
        french: &["PLAFOND"],
        summary: words(
            "The least whole number not below.",
            "Le plus petit entier qui n'est pas dépassé.",
        ),
        help: NO_HELP,
        parameters: &[X],
        example: "=CEILING(7/2)",
        see: &["floor", "round"],
        call: call!(ceiling),
        ..NUMBER
    },
    Operator {
        name: "round",
        english: &["ROUND"],
        french: &["ARRONDI"],
        summary: words(
            "The nearest number with few decimals.",
            "Le nombre le plus proche avec peu de décimales.",
        ),
        help: words("A half goes away from zero.", "Un demi s'éloigne de zéro."),
        parameters: &[
            X,
            Parameter::new(
                Takes::Whole,
                words("decimals", "décimales"),
                words("How many decimals.", "Combien de décimales."),
            )
            .range(0.0, 15.0)
            .or(Fallback::Ratio(0, 1)),
        ],
        example: "=ROUND(2/3, 2)",
        see: &["floor", "ceiling"],
        call: call!(round),
        ..NUMBER
    },
    Operator {
        name: "mod",
        english: &["MOD"],
        french: &["MOD"],
        summary: words("What a division leaves.", "Le reste d'une division."),
        help: words(
            "a - b·FLOOR(a/b): it has the sign of b.",
            "a - b·PLANCHER(a/b) : il a le signe de b.",
        ),
        parameters: &[
            Parameter::new(Takes::Number, words("a", "a"), words("The dividend.", "Le dividende.")),
            Parameter::new(
                Takes::Number,
                words("b", "b"),
                words("The divisor, not 0.", "Le diviseur, non nul."),
            ),
        ],
        example: "=MOD(7, 3)",
        see: &["floor"],
        call: call!(modulo),
        ..NUMBER
    },
    Operator {
        name: "binomial",
        english: &["BINOMIAL"],
        french: &["BINOMIAL", "COMBIN"],
        summary: words(
            "How many ways to choose k of n.",
            "Combien de façons de choisir k parmi n.",
        ),
        help: words("An entry of Pascal's triangle.", "Un terme du triangle de Pascal."),
        parameters: &[
            Parameter::new(Takes::Whole, words("n", "n"), words("Of how many.", "Parmi combien."))
                .range(0.0, 1000.0),
            Parameter::new(Takes::Whole, words("k", "k"), words("How many.", "Combien."))
                .range(0.0, 1000.0),
        ],
        example: "=BINOMIAL(4, 2)",
        see: &["pascal"],
        call: call!(binomial),
        ..NUMBER
    },
    Operator {
        name: "min",
        english: &["MIN"],
        french: &["MIN"],
        summary: words("The least of numbers.", "Le plus petit de nombres."),
        help: NO_HELP,
        parameters: &[VALUES],
        example: "=MIN(3, [1, 2])",
        see: &["max"],
        call: call!(min),
        ..NUMBER
    },
    Operator {
        name: "max",
        english: &["MAX"],
        french: &["MAX"],
        summary: words("The greatest of numbers.", "Le plus grand de nombres."),
        help: NO_HELP,
        parameters: &[VALUES],
        example: "=MAX(3, [1, 2])",
        see: &["min"],
        call: call!(max),
        ..NUMBER
    },
    Operator {
        name: "sum",
        english: &["SUM"],
        french: &["SOMME"],
        summary: words("The sum of numbers, or of forms.", "La somme de nombres, ou de formes."),
        help: words("Forms are added as + adds them.", "Les formes s'ajoutent comme avec +."),
        parameters: &[Parameter { takes: Takes::Any, ..VALUES }],
        gives: Takes::Any,
        example: "=SUM(1, 2, [3, 4])",
        see: &["midpoint", "combine"],
        call: call!(sum),
        ..NUMBER
    },
];

fn atan2<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    S::angle(&a.number(0)?, &a.number(1)?).map(Value::Number)
}

fn pi(_: &Bound<f64>) -> Outcome<f64> {
    Ok(Value::Number(std::f64::consts::PI))
}

fn abs<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let x = a.number(0)?;
    Ok(Value::Number(if x < S::zero() { -x } else { x }))
}

fn floor<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(Value::Number(a.number(0)?.floor()))
}

fn ceiling<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(Value::Number(-(-a.number(0)?).floor()))
}

fn round<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let (x, scale) = (a.number(0)?, S::from_integer(10).power(a.whole(1)?));
    let size = if x < S::zero() { -x.clone() } else { x.clone() };
    let rounded = (size * scale.clone() + S::ratio(1, 2)).floor() / scale;
    Ok(Value::Number(if x < S::zero() { -rounded } else { rounded }))
}

fn modulo<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let (x, y) = (a.number(0)?, a.number(1)?);
    let whole = crate::arithmetic::quotient(&x, &y)?.floor();
    Ok(Value::Number(x - y * whole))
}

fn binomial<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(Value::Number(choose(a.whole(0)?, a.whole(1)?)))
}

fn min<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    extreme(a, |x, best| x < best)
}

fn max<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    extreme(a, |x, best| x > best)
}

fn extreme<S: Arithmetic>(a: &Bound<S>, better: impl Fn(&S, &S) -> bool) -> Outcome<S> {
    let numbers = a.flat_numbers(0)?;
    let best = numbers.into_iter().reduce(|best, x| if better(&x, &best) { x } else { best });
    best.map(Value::Number).ok_or_else(|| a.mistyped(0, &Value::Empty))
}

fn sum<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let mut values = Vec::new();
    a.all(0).iter().for_each(|value| flatten(value, &mut values));
    let add = |total, value: &&Value<S>| binary(Infix::Add, &total, value);
    match values.split_first() {
        None => Ok(Value::Number(S::zero())),
        Some((first, rest)) => Ok(rest.iter().fold((*first).clone(), add)),
    }
}

fn flatten<'a, S>(value: &'a Value<S>, into: &mut Vec<&'a Value<S>>) {
    match value {
        Value::List(items) => items.iter().for_each(|item| flatten(item, into)),
        Value::Empty => {}
        other => into.push(other),
    }
}
