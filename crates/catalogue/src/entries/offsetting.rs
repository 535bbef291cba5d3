//! Parallels, shells, developable surfaces and unrolling.

use pforms_kernel::Rational;
use pforms_operators as operators;
use pforms_operators::{
    Developability, Distance, Parallel, ParallelOptions, Shape, Side, Spline, Unrolling,
};

use super::{FORM, Outcome, PLAIN, list_of_numbers, part};
use crate::arithmetic::require_plain;
use crate::cost::multipliable;
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value, Words};

const COMPOSED: Operator = Operator { group: Group::Composed, ..PLAIN };

const PARTS: &[Words] = &[words("form", "forme"), words("error", "écart"), words("gap", "fente")];

const UNROLLED: &[Words] = &[
    words("form", "forme"),
    words("length", "longueur"),
    words("angle", "angle"),
    words("area", "aire"),
];

const KNOWN: &[Words] = &[
    words("developable", "développable"),
    words("exact", "exact"),
    words("gauss", "gauss"),
    words("parameters", "paramètres"),
];

const DISTANCE: Parameter = Parameter::new(
    Takes::Any,
    words("distance", "distance"),
    words(
        "A number, or a form in dimension 1 over the same axes.",
        "Un nombre, ou une forme en dimension 1 sur les mêmes axes.",
    ),
);

const TOLERANCE: Parameter = Parameter::new(
    Takes::Number,
    words("tolerance", "tolérance"),
    words(
        "How far any point may be from its true place, in the unit of the form.",
        "De combien un point peut être loin de sa vraie place, dans l'unité de la forme.",
    ),
)
.range(0.0, f64::MAX)
.or(Fallback::Ratio(1, 1_000_000));

const SIDE: Parameter = Parameter::new(
    Takes::Any,
    words("side", "côté"),
    words(
        "Of a curve in space: the vector it is seen from, or \"principal\", the inside of its bend.",
        "D'une courbe de l'espace : le vecteur d'où on la voit, ou \"principal\", le dedans de sa courbure.",
    ),
)
.choices(&[words("principal", "principal")])
.or_absent("left of a plane curve, along u × v of a surface", "à gauche d'une courbe plane, selon u × v d'une surface");

const FOLDS: Parameter = Parameter::new(
    Takes::Boolean,
    words("folds", "replis"),
    words(
        "Accept a result that turns back on itself.",
        "Accepter un résultat qui se replie sur lui-même.",
    ),
)
.or(Fallback::Boolean(false));

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "parallel",
        english: &["PARALLEL"],
        french: &["PARALLELE"],
        summary: words(
            "The curve or surface at a distance from another, within a tolerance.",
            "La courbe ou surface à une distance d'une autre, à une tolérance près.",
        ),
        help: words(
            "A rational spline on the true normals; only their length is approximated, and where that is \
             a polynomial (planes, spheres, cylinders, cones, tori) not even that. part = \"error\" gives \
             a bound on the error over the whole window, \"gap\" how far pieces part at a corner. A \
             distance that reaches the radius of curvature is an error that says where.",
            "Une spline rationnelle sur les vraies normales ; seule leur longueur est approchée, et là où \
             elle est un polynôme (plans, sphères, cylindres, cônes, tores) pas même elle. partie = \
             \"écart\" donne une borne de l'erreur sur toute la fenêtre, \"fente\" de combien les morceaux \
             s'écartent à un coin. Une distance qui atteint le rayon de courbure est une erreur qui dit où.",
        ),
        parameters: &[FORM, DISTANCE, TOLERANCE, SIDE, FOLDS, part("form", PARTS)],
        example: "=PARALLEL([(0, 0), (1, 2), (2, 0)], -0.2)",
        source: "book 325; Farouki, Pythagorean-Hodograph Curves",
        see: &["shell", "offset_poles", "frame", "normal_form"],
        call: call!(floating parallel),
        ..COMPOSED
    },
    Operator {
        name: "shell",
        english: &["SHELL"],
        french: &["COQUE"],
        summary: words(
            "What lies between a form and its parallel: a surface made thick.",
            "Ce qui est entre une forme et sa parallèle : une surface rendue épaisse.",
        ),
        help: words(
            "A volume for a surface, a strip for a curve; axis 0 goes through the thickness. Otherwise \
             as PARALLEL.",
            "Un volume pour une surface, une bande pour une courbe ; l'axe 0 traverse l'épaisseur. Pour \
             le reste, voir PARALLELE.",
        ),
        parameters: &[FORM, DISTANCE, TOLERANCE, SIDE, FOLDS, part("form", PARTS)],
        example: "=SHELL([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]], 0.1)",
        source: "book 325; wiki, the ship",
        see: &["parallel"],
        call: call!(floating shell),
        ..COMPOSED
    },
    Operator {
        name: "offset_poles",
        english: &["OFFSET"],
        french: &["DECALE"],
        summary: words(
            "The poles moved along the normals: near the parallel, with the same orders.",
            "Les pôles déplacés le long des normales : près de la parallèle, aux mêmes ordres.",
        ),
        help: words(
            "Pole i of n takes the normal at the parameter i/(n-1), in a spline at the mean of its knots. \
             Orders, weights and knots stay; poles at infinity do not move.",
            "Le pôle i de n prend la normale au paramètre i/(n-1), dans une spline à la moyenne de ses \
             noeuds. Ordres, poids et noeuds restent ; les pôles à l'infini ne bougent pas.",
        ),
        parameters: &[FORM, DISTANCE, SIDE],
        example: "=OFFSET([(0, 0), (1, 2), (2, 0)], 0.2)",
        source: "book 325",
        see: &["parallel"],
        call: call!(floating offset_poles),
        ..COMPOSED
    },
    Operator {
        name: "tangent_developable",
        english: &["DEVELOPABLE"],
        french: &["DEVELOPPABLE"],
        summary: words(
            "The surface swept by the tangents of a curve.",
            "La surface que balaient les tangentes d'une courbe.",
        ),
        help: words(
            "The point plus length times the derivative, along axis 0; the curve runs along axis 1. \
             Exact: a pS2n of a polynomial pLn.",
            "Le point plus la longueur fois la dérivée, selon l'axe 0 ; la courbe suit l'axe 1. \
             Exacte : une pS2n pour une pLn polynomiale.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Form,
                words("curve", "courbe"),
                words("The curve.", "La courbe."),
            ),
            Parameter::new(
                Takes::Number,
                words("length", "longueur"),
                words(
                    "How far to go along the derivative; negative: backwards.",
                    "Jusqu'où suivre la dérivée ; négative : en arrière.",
                ),
            )
            .or(Fallback::Ratio(1, 1)),
        ],
        example: "=DEVELOPABLE([(0, 0, 0), (1, 0, 0), (2, 1, 0), (3, 3, 1)], 1/2)",
        source: "book 326",
        see: &["is_developable", "unroll", "hodograph"],
        call: call!(tangent_developable),
        ..COMPOSED
    },
    Operator {
        name: "is_developable",
        english: &["ISDEVELOPABLE"],
        french: &["ESTDEVELOPPABLE"],
        summary: words(
            "Can a surface be laid out flat without stretching?",
            "Une surface peut-elle être mise à plat sans étirement ?",
        ),
        help: words(
            "All coefficients of the numerator of its Gauss curvature are computed. part = \"exact\": do \
             they vanish in exact arithmetic, or but for rounding? Where it is not developable, \"gauss\" \
             and \"parameters\" give a curvature and its place.",
            "Tous les coefficients du numérateur de sa courbure de Gauss sont calculés. partie = \"exact\" : \
             s'annulent-ils en calcul exact, ou à l'arrondi près ? Là où elle n'est pas développable, \
             \"gauss\" et \"paramètres\" donnent une courbure et son lieu.",
        ),
        parameters: &[FORM, part("developable", KNOWN)],
        gives: Takes::Any,
        example: "=ISDEVELOPABLE(DEVELOPABLE([(0, 0, 0), (1, 0, 0), (2, 1, 0), (3, 3, 1)]))",
        source: "book 326; do Carmo, Differential Geometry",
        see: &["unroll", "tangent_developable", "curvature"],
        call: call!(is_developable),
        ..COMPOSED
    },
    Operator {
        name: "unroll",
        english: &["UNROLL"],
        french: &["DEROULE"],
        summary: words(
            "A surface laid out flat, with what that does to it measured.",
            "Une surface mise à plat, avec la mesure de ce que cela lui fait.",
        ),
        help: words(
            "Developable surfaces keep lengths, angles and areas. Others are stretched: part = \"length\", \
             \"angle\" (radian) or \"area\" gives the largest change. The parameters stay the same.",
            "Les surfaces développables gardent longueurs, angles et aires. Les autres sont étirées : \
             partie = \"longueur\", \"angle\" (radian) ou \"aire\" donne le plus grand changement. Les \
             paramètres restent les mêmes.",
        ),
        parameters: &[
            FORM,
            Parameter::new(
                Takes::Number,
                words("accuracy", "précision"),
                words(
                    "Of the result, in sizes of the form.",
                    "Du résultat, en tailles de la forme.",
                ),
            )
            .range(0.0, 1.0)
            .or(Fallback::Ratio(1, 1_000_000_000_000)),
            part("form", UNROLLED),
        ],
        gives: Takes::Any,
        example: "=UNROLL(DEVELOPABLE([(0, 0, 0), (1, 0, 0), (2, 1, 0), (3, 3, 1)]))",
        source: "book 326",
        see: &["is_developable", "tangent_developable"],
        call: call!(floating unroll),
        ..COMPOSED
    },
];

/// The form as a spline whose pieces may be multiplied by themselves.
fn spline<S: Arithmetic>(shape: Shape<S>) -> Result<Spline<S>, Failure> {
    let spline = shape.into_spline();
    multipliable(spline.piece(&vec![0; spline.axes()])?)?;
    Ok(spline)
}

fn distance(a: &Bound<f64>) -> Result<Distance, Failure> {
    Ok(match a.value(1) {
        Value::Number(distance) => distance.into(),
        other => a.form_of(1, &other)?.into(),
    })
}

fn side(a: &Bound<f64>, index: usize) -> Result<Side, Failure> {
    Ok(match a.value(index) {
        Value::Empty => Side::Natural,
        Value::Form(point) if point.axes() == 0 && point.ambient() == 3 => {
            let vector = point.homogeneous();
            Side::Across([vector[0], vector[1], vector[2]])
        }
        Value::Text(_) => {
            a.choice(index)?;
            Side::Principal
        }
        other => return Err(a.mistyped(index, &other)),
    })
}

fn options(a: &Bound<f64>) -> Result<ParallelOptions, Failure> {
    Ok(ParallelOptions { tolerance: a.number(2)?, side: side(a, 3)?, folds: a.boolean(4)? })
}

fn answer(a: &Bound<f64>, found: Parallel) -> Outcome<f64> {
    Ok(match a.choice(5)? {
        "error" => Value::Number(found.error),
        "gap" => Value::Number(found.gap),
        _ => found.spline.into(),
    })
}

fn parallel(a: &Bound<f64>) -> Outcome<f64> {
    answer(a, operators::parallel(spline(a.shape(0)?)?, distance(a)?, &options(a)?)?)
}

fn shell(a: &Bound<f64>) -> Outcome<f64> {
    answer(a, operators::shell(spline(a.shape(0)?)?, distance(a)?, &options(a)?)?)
}

fn offset_poles(a: &Bound<f64>) -> Outcome<f64> {
    let shape = a.shape(0)?;
    let whole = matches!(shape, Shape::Form(_));
    let moved = operators::offset_poles(spline(shape)?, distance(a)?, &side(a, 2)?)?;
    Ok(if whole { moved.net().clone().into() } else { moved.into() })
}

fn tangent_developable<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let length = a.number(1)?;
    Ok(match a.shape(0)? {
        Shape::Form(curve) => {
            operators::tangent_developable(&multipliable(curve)?, &length)?.into()
        }
        Shape::Spline(curve) => operators::tangent_developable_of_spline(&curve, &length)?.into(),
    })
}

fn is_developable<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let surface = spline(a.shape(0)?)?;
    require_plain(surface.net().homogeneous())?;
    let Developability { developable, exact, gauss, parameters } =
        operators::is_developable(surface)?;
    let read = |x: f64| S::from_f64(x).unwrap_or_else(S::zero);
    Ok(match a.choice(1)? {
        "exact" => Value::Boolean(exact),
        "gauss" => Value::Number(read(gauss)),
        "parameters" => list_of_numbers(parameters.into_iter().map(read)),
        _ => Value::Boolean(developable),
    })
}

fn unroll(a: &Bound<f64>) -> Outcome<f64> {
    let Unrolling { spline: flat, distortion } =
        operators::unroll(spline(a.shape(0)?)?, a.number(1)?)?;
    Ok(match a.choice(2)? {
        "length" => Value::Number(distortion.length),
        "angle" => Value::Number(distortion.angle),
        "area" => Value::Number(distortion.area),
        _ => flat.into(),
    })
}
