//! Cylinder, cone, sphere and torus, curves on them, and polynomial patches near them.

use pforms_kernel::Rational;
use pforms_operators as operators;
use pforms_operators::{Bicubic, Part};

use super::conics::{PIECES, QUARTER, RADIUS, RATIONAL, WHOLE, dress, length};
use super::{Outcome, part as choice_of};
use crate::operator::call;
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Operator, Parameter, Takes, Value, Words};

const ROUND: &[Words] = &[WHOLE, PIECES, QUARTER];
const SPHERE: &[Words] =
    &[WHOLE, PIECES, words("half", "moitié"), QUARTER, words("octant", "octant")];
const OUTER: Words = words("outer", "extérieur");
const INNER: Words = words("inner", "intérieur");
const TORUS: &[Words] = &[WHOLE, PIECES, QUARTER, OUTER, INNER];
const VIVIANI: &[Words] = &[words("octant", "octant"), WHOLE];
const BICUBIC: &[Words] = &[
    words("form", "forme"),
    words("error", "écart"),
    words("outside", "dehors"),
    words("inside", "dedans"),
];

const HEIGHT: Parameter = length("height", "hauteur", "A positive number.", "Un nombre positif.");
const MAJOR: Parameter = length(
    "major",
    "grand",
    "The radius of the circle that the tube follows.",
    "Le rayon du cercle que suit le tube.",
);
const MINOR: Parameter = length("minor", "petit", "The radius of the tube.", "Le rayon du tube.");

const fn turns(name: &'static str, help_en: &'static str, help_fr: &'static str) -> Parameter {
    Parameter::new(Takes::Number, words(name, name), words(help_en, help_fr)).range(-1e6, 1e6)
}

const NEAR: Words = words(
    "Four by four poles of weight 1. part = \"error\" gives the largest distance to the surface, \
     \"outside\" and \"inside\" how far it goes to either side.",
    "Quatre fois quatre pôles de poids 1. partie = \"écart\" donne la plus grande distance à la \
     surface, \"dehors\" et \"dedans\" ce qu'elle en sort de chaque côté.",
);

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "cylinder",
        english: &["CYLINDER"],
        french: &["CYLINDRE"],
        summary: words("A cylinder about Oy, exactly.", "Un cylindre d'axe Oy, exactement."),
        help: words(
            "From y = 0 to y = height: axis 0 upwards, axis 1 round from x towards z. Whole it is one \
             form and works in exact mode; \"pieces\" are four quarters, all weights positive; \"quarter\" \
             is one of them.",
            "De y = 0 à y = hauteur : axe 0 vers le haut, axe 1 autour, de x vers z. Entier, c'est une \
             seule forme et il marche en mode exact ; \"morceaux\" donne quatre quarts de poids tous \
             positifs ; \"quart\" l'un d'eux.",
        ),
        parameters: &[RADIUS, HEIGHT, dress(ROUND)],
        example: "=CYLINDER(1, 2)",
        source: "book 312",
        see: &["cone", "revolve", "bezier_cylinder"],
        call: call!(cylinder),
        ..RATIONAL
    },
    Operator {
        name: "cone",
        english: &["CONE"],
        french: &["CONE"],
        summary: words("A cone about Oy, exactly.", "Un cône d'axe Oy, exactement."),
        help: words(
            "Its radius goes from radius at y = 0 to top at y = height; laid out as CYLINDER. With top = 0 \
             one edge is the apex.",
            "Son rayon va de rayon en y = 0 à haut en y = hauteur ; disposé comme CYLINDRE. Avec haut = 0, \
             un bord est le sommet.",
        ),
        parameters: &[
            RADIUS,
            HEIGHT,
            length(
                "top",
                "haut",
                "The radius at the top, at least 0.",
                "Le rayon en haut, au moins 0.",
            )
            .or(Fallback::Ratio(0, 1)),
            dress(ROUND),
        ],
        example: "=CONE(1, 2)",
        source: "book 312",
        see: &["cylinder", "revolve", "bezier_cone"],
        call: call!(cone),
        ..RATIONAL
    },
    Operator {
        name: "sphere",
        english: &["SPHERE"],
        french: &["SPHERE"],
        summary: words(
            "A sphere round the origin, exactly.",
            "Une sphère autour de l'origine, exactement.",
        ),
        help: words(
            "Axis 0 along the meridians towards y, axis 1 round Oy from x towards z. Whole it is one pS45 \
             and works in exact mode; \"pieces\" are eight octants, all weights positive; \"half\" lies \
             above the equator, \"quarter\" is a quarter turn, \"octant\" the book's pS33.",
            "Axe 0 le long des méridiens vers y, axe 1 autour de Oy, de x vers z. Entière, c'est une seule \
             pS45 et elle marche en mode exact ; \"morceaux\" donne huit octants de poids tous positifs ; \
             \"moitié\" le dessus de l'équateur, \"quart\" un quart de tour, \"octant\" la pS33 du livre.",
        ),
        parameters: &[RADIUS, dress(SPHERE)],
        example: "=SPHERE(1)",
        source: "book 312",
        see: &["torus", "viviani", "bezier_sphere"],
        call: call!(sphere),
        ..RATIONAL
    },
    Operator {
        name: "torus",
        english: &["TORUS"],
        french: &["TORE"],
        summary: words("A torus about Oy, exactly.", "Un tore d'axe Oy, exactement."),
        help: words(
            "Axis 0 round the tube, from the largest radius upwards; axis 1 round Oy from x towards z. \
             Whole it is one pS55 and works in exact mode; \"pieces\" are sixteen pS33; \"quarter\" is a \
             quarter turn of the tube; \"outer\" and \"inner\" the book's sixteenths.",
            "Axe 0 autour du tube, du plus grand rayon vers le haut ; axe 1 autour de Oy, de x vers z. \
             Entier, c'est une seule pS55 et il marche en mode exact ; \"morceaux\" donne seize pS33 ; \
             \"quart\" un quart de tour du tube ; \"extérieur\" et \"intérieur\" les seizièmes du livre.",
        ),
        parameters: &[MAJOR, MINOR, dress(TORUS)],
        example: "=TORUS(2, 1)",
        source: "book 312",
        see: &["sphere", "torus_knot", "bezier_torus"],
        call: call!(torus),
        ..RATIONAL
    },
    Operator {
        name: "viviani",
        english: &["VIVIANI"],
        french: &["VIVIANI"],
        summary: words(
            "Viviani's window, the diagonal of an octant of sphere.",
            "La fenêtre de Viviani, diagonale d'un octant de sphère.",
        ),
        help: words(
            "Where longitude and latitude are equal, on the sphere of this radius. part = \"whole\" is the \
             closed curve, the same diagonal on the whole line of parameters, in three pieces.",
            "Où longitude et latitude sont égales, sur la sphère de ce rayon. partie = \"entier\" donne la \
             courbe fermée, la même diagonale sur toute la droite des paramètres, en trois morceaux.",
        ),
        parameters: &[RADIUS, choice_of("octant", VIVIANI)],
        example: "=VIVIANI(1)",
        source: "book 3131",
        see: &["sphere", "diagonal", "whole_line"],
        call: call!(floating viviani),
        ..RATIONAL
    },
    Operator {
        name: "torus_knot",
        english: &["KNOT"],
        french: &["NOEUD"],
        summary: words(
            "A knot on a torus, as diagonals.",
            "Un noeud sur un tore, fait de diagonales.",
        ),
        help: words(
            "It goes p times round the axis Oy and q times round the tube, numbers without a common \
             divisor, in 2·max(p, q) pieces that lie on the torus exactly. KNOT(2, 3, …) is the trefoil. A \
             negative number makes the mirror image.",
            "Il fait p fois le tour de l'axe Oy et q fois celui du tube, nombres sans diviseur commun, en \
             2·max(p, q) morceaux qui sont exactement sur le tore. NOEUD(2; 3; …) est le trèfle. Un nombre \
             négatif donne l'image dans un miroir.",
        ),
        parameters: &[
            turns("p", "Turns round the axis.", "Tours autour de l'axe."),
            turns("q", "Turns round the tube.", "Tours autour du tube."),
            MAJOR,
            MINOR,
        ],
        example: "=KNOT(2, 3, 1, 1/2)",
        source: "book 3133",
        see: &["torus", "diagonal"],
        call: call!(floating torus_knot),
        ..RATIONAL
    },
    Operator {
        name: "bezier_cylinder",
        english: &["BEZIERCYLINDER"],
        french: &["BEZIERCYLINDRE"],
        summary: words(
            "A polynomial patch near a quarter of a cylinder.",
            "Un carreau polynomial proche d'un quart de cylindre.",
        ),
        help: NEAR,
        parameters: &[RADIUS, HEIGHT, choice_of("form", BICUBIC)],
        example: "=BEZIERCYLINDER(1, 2)",
        source: "page on bicubic patches",
        see: &["cylinder", "bezier_cone"],
        call: call!(floating bezier_cylinder),
        ..RATIONAL
    },
    Operator {
        name: "bezier_cone",
        english: &["BEZIERCONE"],
        french: &["BEZIERCONE"],
        summary: words(
            "A polynomial patch near a quarter of a cone.",
            "Un carreau polynomial proche d'un quart de cône.",
        ),
        help: NEAR,
        parameters: &[RADIUS, HEIGHT, choice_of("form", BICUBIC)],
        example: "=BEZIERCONE(1, 2)",
        source: "page on bicubic patches",
        see: &["cone", "bezier_cylinder"],
        call: call!(floating bezier_cone),
        ..RATIONAL
    },
    Operator {
        name: "bezier_sphere",
        english: &["BEZIERSPHERE"],
        french: &["BEZIERSPHERE"],
        summary: words(
            "A polynomial patch near an octant of a sphere.",
            "Un carreau polynomial proche d'un octant de sphère.",
        ),
        help: NEAR,
        parameters: &[RADIUS, choice_of("form", BICUBIC)],
        example: "=BEZIERSPHERE(1)",
        source: "page on bicubic patches",
        see: &["sphere", "bezier_torus"],
        call: call!(floating bezier_sphere),
        ..RATIONAL
    },
    Operator {
        name: "bezier_torus",
        english: &["BEZIERTORUS"],
        french: &["BEZIERTORE"],
        summary: words(
            "A polynomial patch near a sixteenth of a torus.",
            "Un carreau polynomial proche d'un seizième de tore.",
        ),
        help: NEAR,
        parameters: &[
            MAJOR,
            MINOR,
            Parameter::new(
                Takes::Text,
                words("side", "côté"),
                words(
                    "Of the tube, away from the axis or towards it.",
                    "Du tube, loin de l'axe ou vers lui.",
                ),
            )
            .or(Fallback::Text("outer"))
            .choices(&[OUTER, INNER]),
            choice_of("form", BICUBIC),
        ],
        example: "=BEZIERTORUS(2, 1)",
        source: "page on bicubic patches",
        see: &["torus", "bezier_sphere"],
        call: call!(floating bezier_torus),
        ..RATIONAL
    },
];

fn cylinder<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let part = super::conics::part(a, 2)?;
    Ok(operators::cylinder(&a.number(0)?, &a.number(1)?, part)?.into())
}

fn cone<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let part = super::conics::part(a, 3)?;
    Ok(operators::cone(&a.number(0)?, &a.number(1)?, &a.number(2)?, part)?.into())
}

fn sphere<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(operators::sphere(&a.number(0)?, super::conics::part(a, 1)?)?.into())
}

fn torus<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let part = super::conics::part(a, 2)?;
    Ok(operators::torus(&a.number(0)?, &a.number(1)?, part)?.into())
}

fn viviani(a: &Bound<f64>) -> Outcome<f64> {
    Ok(operators::viviani(&a.number(0)?, Part::named(a.choice(1)?)?)?.into())
}

fn torus_knot(a: &Bound<f64>) -> Outcome<f64> {
    let (p, q) = (a.integer(0)?, a.integer(1)?);
    Ok(Value::Spline(operators::torus_knot(p, q, a.number(2)?, a.number(3)?)?))
}

fn bezier_cylinder(a: &Bound<f64>) -> Outcome<f64> {
    wanted(a, 2, operators::bezier_cylinder(a.number(0)?, a.number(1)?)?)
}

fn bezier_cone(a: &Bound<f64>) -> Outcome<f64> {
    wanted(a, 2, operators::bezier_cone(a.number(0)?, a.number(1)?)?)
}

fn bezier_sphere(a: &Bound<f64>) -> Outcome<f64> {
    wanted(a, 1, operators::bezier_sphere(a.number(0)?)?)
}

fn bezier_torus(a: &Bound<f64>) -> Outcome<f64> {
    let side = Part::named(a.choice(2)?)?;
    wanted(a, 3, operators::bezier_torus(a.number(0)?, a.number(1)?, side)?)
}

fn wanted(a: &Bound<f64>, index: usize, patch: Bicubic) -> Outcome<f64> {
    Ok(match a.choice(index)? {
        "error" => Value::Number(patch.error()),
        "outside" => Value::Number(patch.outside),
        "inside" => Value::Number(patch.inside),
        _ => patch.form.into(),
    })
}
