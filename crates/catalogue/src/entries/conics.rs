//! Conics, circles and their arcs.

use pforms_kernel::{Error, Form, Rational};
use pforms_operators::{self as operators, Part, Shape};

use super::{Outcome, PLAIN};
use crate::elementary::{Elementary, use_floating_mode};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Words};

pub(super) const RATIONAL: Operator = Operator { group: Group::Rational, ..PLAIN };

pub(super) const fn length(
    en: &'static str,
    fr: &'static str,
    help_en: &'static str,
    help_fr: &'static str,
) -> Parameter {
    Parameter::new(Takes::Number, words(en, fr), words(help_en, help_fr))
}

pub(super) const RADIUS: Parameter =
    length("radius", "rayon", "A positive number.", "Un nombre positif.");

pub(super) const ORDER: Parameter = Parameter::new(
    Takes::Whole,
    words("order", "ordre"),
    words("Poles of every piece: 3, 4 or 5.", "Pôles de chaque morceau : 3, 4 ou 5."),
)
.or(Fallback::Ratio(3, 1));

/// Which part of a closed form is wanted.
pub(super) const fn dress(choices: &'static [Words]) -> Parameter {
    Parameter::new(
        Takes::Text,
        words("part", "partie"),
        words(
            "All of it in one form or in pieces, or a part.",
            "Le tout en une forme ou en morceaux, ou une partie.",
        ),
    )
    .or(Fallback::Text("whole"))
    .choices(choices)
}

pub(super) const WHOLE: Words = words("whole", "entier");
pub(super) const PIECES: Words = words("pieces", "morceaux");
pub(super) const QUARTER: Words = words("quarter", "quart");

const ROUND: &[Words] = &[WHOLE, PIECES];

const fn corner(en: &'static str, help_en: &'static str, help_fr: &'static str) -> Parameter {
    Parameter::new(Takes::Form, words(en, en), words(help_en, help_fr))
}

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "conic",
        english: &["CONIC"],
        french: &["CONIQUE"],
        summary: words(
            "The conic between two points whose tangents meet in a third.",
            "La conique entre deux points dont les tangentes se coupent en un troisième.",
        ),
        help: words(
            "w below 1 is an arc of an ellipse, 1 of a parabola, above 1 of a hyperbola, below 0 the \
             complementary arc; 0 leaves the chord. For a circle w is the cosine of half the angle. The \
             middle point may be a direction. Curves instead of points make a surface.",
            "w inférieur à 1 donne un arc d'ellipse, 1 de parabole, supérieur à 1 d'hyperbole, négatif \
             l'arc complémentaire ; 0 laisse la corde. Pour un cercle, w est le cosinus du demi-angle. \
             Le point du milieu peut être une direction. Des courbes au lieu de points font une surface.",
        ),
        parameters: &[
            corner("p0", "Where it begins.", "Son début."),
            corner(
                "p1",
                "Where the tangents at the ends meet.",
                "Où se coupent les tangentes aux bouts.",
            ),
            corner("p2", "Where it ends.", "Sa fin."),
            Parameter::new(
                Takes::Number,
                words("w", "w"),
                words("The weight of p1.", "Le poids de p1."),
            )
            .or(Fallback::Ratio(1, 1)),
        ],
        example: "=CONIC((1, 0), (1, 1), (0, 1), 1/2)",
        source: "book 311",
        see: &["arc", "classify", "stack"],
        call: call!(conic),
        ..RATIONAL
    },
    Operator {
        name: "arc",
        english: &["ARC"],
        french: &["ARC"],
        summary: words(
            "An arc of a circle of any angle, round the origin.",
            "Un arc de cercle d'angle quelconque, autour de l'origine.",
        ),
        help: words(
            "In the plane Oxy, from the angle start on, from x towards y, in radians. One form as long as \
             that is well conditioned, up to 120, 180 and 270 degrees for the orders 3, 4 and 5; beyond, \
             a spline of equal pieces. Any number of turns; a negative angle turns back.",
            "Dans le plan Oxy, depuis l'angle début, de x vers y, en radians. Une seule forme tant que \
             c'est bien conditionné, jusqu'à 120, 180 et 270 degrés pour les ordres 3, 4 et 5 ; au-delà, \
             une spline de morceaux égaux. Autant de tours qu'on veut ; un angle négatif tourne à rebours.",
        ),
        parameters: &[
            RADIUS,
            length("angle", "angle", "How far it turns; not 0.", "De combien il tourne ; non nul.")
                .unit("radian", "radian"),
            ORDER,
            length("start", "début", "Where it begins.", "Où il commence.")
                .unit("radian", "radian")
                .or(Fallback::Ratio(0, 1)),
        ],
        example: "=ARC(1, RADIANS(90))",
        source: "book 311",
        see: &["circle", "conic", "revolve"],
        call: call!(floating arc),
        ..RATIONAL
    },
    Operator {
        name: "circle",
        english: &["CIRCLE"],
        french: &["CERCLE"],
        summary: words("A circle round the origin.", "Un cercle autour de l'origine."),
        help: words(
            "In the plane Oxy, from x towards y. Whole it is one form of five poles, two of them \
             directions, and works in exact mode; part = \"pieces\" gives four quarters end to end, all \
             weights positive.",
            "Dans le plan Oxy, de x vers y. Entier, c'est une seule forme de cinq pôles, dont deux \
             directions, et il marche en mode exact ; partie = \"morceaux\" donne quatre quarts bout à \
             bout, de poids tous positifs.",
        ),
        parameters: &[RADIUS, dress(ROUND)],
        example: "=CIRCLE(1)",
        source: "book 311",
        see: &["arc", "ellipse", "sphere"],
        call: call!(circle),
        ..RATIONAL
    },
    Operator {
        name: "ellipse",
        english: &["ELLIPSE"],
        french: &["ELLIPSE"],
        summary: words("An ellipse round the origin.", "Une ellipse autour de l'origine."),
        help: words(
            "Half axis a along x, b along y; laid out as CIRCLE.",
            "Demi-axe a selon x, b selon y ; disposée comme CERCLE.",
        ),
        parameters: &[
            length("a", "a", "The half axis along x.", "Le demi-axe selon x."),
            length("b", "b", "The half axis along y.", "Le demi-axe selon y."),
            dress(ROUND),
        ],
        example: "=ELLIPSE(2, 1)",
        source: "book 311",
        see: &["circle", "hyperbola", "parabola"],
        call: call!(ellipse),
        ..RATIONAL
    },
    Operator {
        name: "hyperbola",
        english: &["HYPERBOLA"],
        french: &["HYPERBOLE"],
        summary: words(
            "An arc of a hyperbola with its vertex on the x axis.",
            "Un arc d'hyperbole de sommet sur l'axe des x.",
        ),
        help: words(
            "The part of x^2/a^2 - y^2/b^2 = 1 with x positive and y from -height to height. Exact mode \
             needs heights whose root is a fraction.",
            "La partie de x^2/a^2 - y^2/b^2 = 1 où x est positif et y va de -hauteur à hauteur. Le mode \
             exact demande des hauteurs dont la racine est une fraction.",
        ),
        parameters: &[
            length("a", "a", "From the centre to the vertex.", "Du centre au sommet."),
            length("b", "b", "The other half axis.", "L'autre demi-axe."),
            length(
                "height",
                "hauteur",
                "How high and how low it goes.",
                "Jusqu'où elle monte et descend.",
            ),
        ],
        example: "=HYPERBOLA(3, 4, 3)",
        source: "book 311",
        see: &["parabola", "ellipse", "classify"],
        call: call!(hyperbola),
        ..RATIONAL
    },
    Operator {
        name: "parabola",
        english: &["PARABOLA"],
        french: &["PARABOLE"],
        summary: words(
            "An arc of a parabola with its vertex at the origin.",
            "Un arc de parabole de sommet à l'origine.",
        ),
        help: words(
            "The part of y^2 = 4·focal·x with y from -height to height. Polynomial.",
            "La partie de y^2 = 4·focale·x où y va de -hauteur à hauteur. Polynomiale.",
        ),
        parameters: &[
            length("focal", "focale", "From the vertex to the focus.", "Du sommet au foyer."),
            length(
                "height",
                "hauteur",
                "How high and how low it goes.",
                "Jusqu'où elle monte et descend.",
            ),
        ],
        example: "=PARABOLA(1, 2)",
        source: "book 311",
        see: &["hyperbola", "ellipse", "classify"],
        call: call!(parabola),
        ..RATIONAL
    },
    Operator {
        name: "classify",
        english: &["CLASSIFY"],
        french: &["CLASSE"],
        summary: words("Which conic three poles are.", "Quelle conique sont trois pôles."),
        help: words(
            "\"circle\", \"ellipse\", \"parabola\", \"hyperbola\", \"segment\" or \"point\", by the weights of \
             a pL3. Numbers that differ by less than accuracy times their size are the same; in exact \
             mode only equal ones are.",
            "\"circle\", \"ellipse\", \"parabola\", \"hyperbola\", \"segment\" ou \"point\", d'après les poids \
             d'une pL3. Des nombres qui diffèrent de moins de précision fois leur taille sont les mêmes ; \
             en mode exact, seuls les égaux le sont.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Form,
                words("curve", "courbe"),
                words("A curve of three poles.", "Une courbe de trois pôles."),
            ),
            Parameter::new(
                Takes::Number,
                words("accuracy", "précision"),
                words("Relative to the size of the curve.", "Relative à la taille de la courbe."),
            )
            .range(0.0, 1.0)
            .or_absent("1e-12, and 0 in exact mode", "1e-12, et 0 en mode exact"),
        ],
        gives: Takes::Text,
        example: "=CLASSIFY([(1, 0), (1, 1), (0, 1; 2)])",
        source: "book 311",
        see: &["conic"],
        call: call!(classify),
        ..RATIONAL
    },
];

fn conic<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(operators::conic(&a.form(0)?, &a.form(1)?, &a.form(2)?, &a.number(3)?)?.into())
}

fn arc(a: &Bound<f64>) -> Outcome<f64> {
    Ok(operators::arc(a.number(0)?, a.number(1)?, a.whole(2)?, a.number(3)?)?.into())
}

/// The part that was chosen; in exact mode those with √2 are refused with a hint.
pub(super) fn part<S: Arithmetic>(a: &Bound<S>, index: usize) -> Result<Part, Failure> {
    let part = Part::named(a.choice(index)?)?;
    if part != Part::Whole && S::half_root().is_none() {
        let error = Error::domain("part", format!("{:?} in exact mode", part.name()), "\"whole\"");
        return Err(use_floating_mode(Failure::of(
            error,
            format!("partie : reçu « {} » en mode exact, attendu \"entier\"", part.name()),
        )));
    }
    Ok(part)
}

fn circle<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(operators::circle(&a.number(0)?, part(a, 1)?)?.into())
}

fn ellipse<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(operators::ellipse(&a.number(0)?, &a.number(1)?, part(a, 2)?)?.into())
}

fn hyperbola<S: Arithmetic>(bound: &Bound<S>) -> Outcome<S> {
    let [a, b, height] = [bound.number(0)?, bound.number(1)?, bound.number(2)?];
    if !S::EXACT {
        let arc = operators::hyperbola(a.plain()?, b.plain()?, height.plain()?)?;
        return in_scalar(&arc.into()).map(Into::into);
    }
    if b.is_zero() {
        return Err(Error::domain("b", 0, "a positive number").into());
    }
    let sinh = height / b.clone();
    let cosh = S::apply(Elementary::Sqrt, &(S::one() + sinh.power(2)))?;
    Ok(operators::hyperbola_by(&a, &b, &[cosh, sinh])?.into())
}

fn parabola<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(operators::parabola(&a.number(0)?, &a.number(1)?)?.into())
}

fn classify<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let curve: Form<S> = a.form(0)?;
    let accuracy = match (a.is_given(1), S::EXACT) {
        (true, _) => a.number(1)?,
        (false, true) => S::zero(),
        (false, false) => S::ratio(1, 1_000_000_000_000),
    };
    let kind = operators::classify(&curve, &accuracy)?;
    Ok(crate::Value::Text(kind.name().to_owned()))
}

/// What was computed in floating point, in the scalar of the sheet.
pub(super) fn in_scalar<S: Arithmetic>(shape: &Shape) -> Result<Shape<S>, Failure> {
    let convert = |x: &f64| S::from_f64(*x).unwrap_or_else(S::zero);
    Ok(match shape {
        Shape::Form(form) => form.map_scalar(convert)?.into(),
        Shape::Spline(spline) => spline.map_scalar(convert)?.into(),
    })
}
