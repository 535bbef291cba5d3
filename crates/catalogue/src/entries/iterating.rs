//! Thirds, sets that are made of copies of themselves, and random points.

use pforms_kernel::Rational;
use pforms_mesh::Mesh;
use pforms_operators::{self as operators, Rule, Spread};

use super::{FORM, Outcome, PLAIN, list_of_forms};
use crate::cost::{require_points, workable};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Operator, Parameter, Takes, Value};

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "thirds",
        english: &["THIRDS"],
        french: &["TIERS"],
        summary: words(
            "The forms at one third and at two thirds between forms.",
            "Les formes au tiers et aux deux tiers entre des formes.",
        ),
        help: words(
            "As MI is the form at 1/2 of the one that forms generate, these are those at 1/3 and 2/3. Of \
             two points, the two that cut their segment in three. Exact.",
            "Comme MI est la forme en 1/2 de celle que des formes engendrent, celles-ci sont celles en 1/3 \
             et 2/3. De deux points, ceux qui coupent leur segment en trois. Exact.",
        ),
        parameters: &[Parameter::new(
            Takes::Form,
            words("forms", "formes"),
            words("The forms, in order.", "Les formes, dans l'ordre."),
        )
        .variadic()],
        gives: Takes::List,
        example: "=THIRDS((0, 0), (3, 6))",
        see: &["midpoint", "iterate"],
        call: call!(thirds),
        ..FRACTAL
    },
    Operator {
        name: "iterate",
        english: &["ITERATE"],
        french: &["ITERE"],
        summary: words(
            "Copies of a form, copies of these, and so on: the sets of Cantor, Menger and Sierpinski.",
            "Les copies d'une forme, leurs copies, et ainsi de suite : les ensembles de Cantor, Menger et \
             Sierpinski.",
        ),
        help: words(
            "\"cantor\" keeps the first and the last third along every axis, \"sponge\" all thirds but those \
             in the middle along two axes or more: 8 of 9 parts of a surface, 20 of 27 of a volume. \
             \"sierpinski\" takes the homotheties of a ratio centred at the poles. Of m copies, generation \
             n has m^n. Exact.",
            "\"cantor\" garde le premier et le dernier tiers selon chaque axe, \"éponge\" tous les tiers sauf \
             ceux du milieu selon deux axes ou plus : 8 parties sur 9 d'une surface, 20 sur 27 d'un \
             volume. \"sierpinski\" prend les homothéties d'un rapport centrées aux pôles. De m copies, \
             la génération n en a m^n. Exact.",
        ),
        parameters: &[
            FORM,
            GENERATION,
            Parameter::new(
                Takes::Text,
                words("rule", "règle"),
                words("What one generation does.", "Ce que fait une génération."),
            )
            .or(Fallback::Text("cantor"))
            .choices(&[
                words("cantor", "cantor"),
                words("sponge", "éponge"),
                words("sierpinski", "sierpinski"),
            ]),
            Parameter::new(
                Takes::Number,
                words("ratio", "rapport"),
                words("Of the homotheties.", "Des homothéties."),
            )
            .or(Fallback::Ratio(1, 2)),
        ],
        gives: Takes::List,
        example: "=ITERATE([(0, 0), (1, 2), (2, 0)], 3, \"sierpinski\")",
        see: &["thirds", "peano", "subdivide"],
        call: call!(iterate),
        ..FRACTAL
    },
    Operator {
        name: "peano",
        english: &["PEANO"],
        french: &["PEANO"],
        summary: words(
            "Peano's curve: a line that comes by everywhere in a square or a cube.",
            "La courbe de Peano : une ligne qui passe partout dans un carré ou un cube.",
        ),
        help: words(
            "Through the middles of 3^n cells along each axis, from cell to neighbouring cell; a spline of \
             degree 1. Immersed in a form it runs all over it: IMMERSE(PEANO(2), form). Exact.",
            "Par les milieux de 3^n cases selon chaque axe, d'une case à sa voisine ; une spline de degré \
             1. Immergée dans une forme elle la parcourt toute : IMMERGE(PEANO(2), forme). Exact.",
        ),
        parameters: &[
            GENERATION,
            Parameter::new(
                Takes::Whole,
                words("axes", "axes"),
                words("2 for a square, 3 for a cube.", "2 pour un carré, 3 pour un cube."),
            )
            .range(1.0, 8.0)
            .or(Fallback::Ratio(2, 1)),
        ],
        example: "=PEANO(2)",
        see: &["iterate", "immerse"],
        call: call!(peano),
        ..FRACTAL
    },
    Operator {
        name: "random_points",
        english: &["RANDOM"],
        french: &["ALEA"],
        summary: words(
            "Random points of a form, evenly by length, area or volume, or crowded in the middle.",
            "Des points au hasard d'une forme, répartis selon la longueur, l'aire ou le volume, ou serrés \
             au milieu.",
        ),
        help: words(
            "A cloud. \"uniform\" is even whatever the parametrisation; \"gaussian\" has parameters normal \
             about the middle of the window, a sixth of it the standard deviation. The same seed gives \
             the same points everywhere.",
            "Un nuage. \"uniforme\" est réparti également quel que soit le paramétrage ; \"gaussien\" a des \
             paramètres normaux autour du milieu de la fenêtre, d'écart type un sixième. La même graine \
             donne partout les mêmes points.",
        ),
        parameters: &[
            FORM,
            Parameter::new(Takes::Whole, words("count", "nombre"), words("How many.", "Combien."))
                .range(0.0, 1_000_000.0),
            Parameter::new(
                Takes::Text,
                words("law", "loi"),
                words("How they are spread.", "Comment ils sont répartis."),
            )
            .or(Fallback::Text("uniform"))
            .choices(&[words("uniform", "uniforme"), words("gaussian", "gaussien")]),
            Parameter::new(
                Takes::Whole,
                words("seed", "graine"),
                words("Another number, other points.", "Un autre nombre, d'autres points."),
            )
            .range(0.0, 9_007_199_254_740_992.0)
            .or(Fallback::Ratio(0, 1)),
        ],
        gives: Takes::Any,
        example: "=RANDOM([(0, 0), (1, 2), (2, 0)], 100)",
        see: &["grid", "iterate"],
        call: call!(floating random_points),
        ..FRACTAL
    },
];

const FRACTAL: Operator = Operator { group: Group::Inside, source: "book 37, remark 1", ..PLAIN };

const GENERATION: Parameter = Parameter::new(
    Takes::Whole,
    words("generation", "génération"),
    words("How often.", "Combien de fois."),
)
.range(0.0, 4096.0);

/// Evaluations of a form that a random point takes, about.
const DRAWS: usize = 16;

fn thirds<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let [first, second] = operators::thirds(&a.shapes(0)?)?;
    Ok(Value::list(vec![first.into(), second.into()]))
}

fn iterate<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let rule = match a.choice(2)? {
        "sponge" => Rule::Sponge,
        "sierpinski" => Rule::Sierpinski(a.number(3)?),
        _ => Rule::Cantor,
    };
    Ok(list_of_forms(operators::iterate(&workable(a.form(0)?)?, a.whole(1)?, &rule)?))
}

fn peano<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(operators::peano::<S>(a.whole(0)?, a.whole(1)?)?.into())
}

fn random_points(a: &Bound<f64>) -> Outcome<f64> {
    let (shape, count) = (a.shape(0)?, a.whole(1)?);
    let net = operators::Poles::net(&shape);
    let law = if a.choice(2)? == "gaussian" { Spread::Gaussian } else { Spread::Uniform };
    require_points(net, DRAWS.saturating_mul(count), 0.0)?;
    let points = operators::random_points(&shape, count, law, a.whole(3)? as u64)?;
    Ok(Mesh::cloud(net.ambient(), points)?.into())
}
