//! Jacobians, folds, and slices of forms with one more axis.

use pforms_kernel::Rational;
use pforms_operators::{self as operators, Poles};

use super::lists::entry;
use super::measuring::INSIDE;
use super::{AXIS, FORM, Outcome, PART, list_of_numbers};
use crate::cost::{multipliable, require_points, workable_shape};
use crate::operator::call;
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Operator, Parameter, Takes, Value};

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "jacobian",
        english: &["JACOBIAN"],
        french: &["JACOBIEN"],
        summary: words(
            "The Jacobian determinant of a form, as a form.",
            "Le déterminant jacobien d'une forme, en forme.",
        ),
        help: words(
            "For as many axes as coordinates: a surface in the plane, a volume in space. Exact, rational \
             forms too: of degrees d·n - 1, or (d + 1)·n where weights differ. Of a spline a spline, with \
             gaps where derivatives may jump.",
            "Pour autant d'axes que de coordonnées : une surface du plan, un volume de l'espace. Exact, \
             même rationnel : de degrés d·n - 1, ou (d + 1)·n si les poids diffèrent. D'une spline une \
             spline, avec des coupures où les dérivées peuvent sauter.",
        ),
        parameters: &[FORM],
        example: "=JACOBIAN([[(0, 0), (0, 1)], [(1, 0), (2, 2)]])",
        source: "catalogue 7",
        see: &["is_injective", "volume", "derivative"],
        call: call!(jacobian),
        ..INSIDE
    },
    Operator {
        name: "is_injective",
        english: &["FOLDS"],
        french: &["REPLIS"],
        summary: words(
            "Does a form fold over? With a proof either way.",
            "Une forme se replie-t-elle ? Avec une preuve.",
        ),
        help: words(
            "A record: answer: \"none\" is a proof that the Jacobian determinant has one sign, \"folds\" that \
             it has both, \"undecided\" that it is too near 0 somewhere; positive, negative: parameters \
             where it is so; undecided: boxes of parameters; regular: does it vanish nowhere; injective: is \
             it proved that no two parameters give one point.",
            "Une fiche : réponse : \"none\" prouve que le déterminant jacobien a un seul signe, \"folds\" \
             qu'il a les deux, \"undecided\" qu'il est trop près de 0 ; positif, négatif : des paramètres \
             où il l'est ; indécis : des boîtes de paramètres ; régulier : ne s'annule-t-il nulle part ; \
             injectif : est-il prouvé que deux paramètres ne donnent pas le même point.",
        ),
        parameters: &[
            FORM,
            Parameter::new(
                Takes::Number,
                words("accuracy", "précision"),
                words(
                    "Determinants that are smaller, relative to their mean, stay open.",
                    "Les déterminants plus petits, relativement à leur moyenne, restent indécis.",
                ),
            )
            .range(0.0, 1.0)
            .or(Fallback::Ratio(1, 1_000_000_000)),
            PART,
        ],
        gives: Takes::Record,
        example: "=FOLDS([[(0, 0), (0, 1)], [(1, 0), (1/4, 1/4)]])",
        source: "catalogue 7; Meisters and Olech 1963",
        see: &["jacobian", "volume", "item"],
        call: call!(floating folds),
        ..INSIDE
    },
    Operator {
        name: "slice",
        english: &["SLICE"],
        french: &["TRANCHE"],
        summary: words(
            "The form with one axis less where a parameter is t: a frame of a film.",
            "La forme à un axe de moins où un paramètre vaut t : une image d'un film.",
        ),
        help: words(
            "As SUB, and of several t a list of forms. An axis may be time, load or style: a hypervolume is \
             a film of volumes, a space of designs.",
            "Comme SOUS, et de plusieurs t une liste de formes. Un axe peut être le temps, la charge ou le \
             style : un hypervolume est un film de volumes, un espace de projets.",
        ),
        parameters: &[
            FORM,
            AXIS,
            Parameter::new(
                Takes::Any,
                words("t", "t"),
                words("A parameter, or a list of them.", "Un paramètre, ou une liste."),
            )
            .unit("parameter", "paramètre"),
        ],
        gives: Takes::Any,
        example: "=SLICE([[(0, 0), (0, 1)], [(1, 0), (2, 2)]], 1, 1/2)",
        source: "catalogue 7; book 2141",
        see: &["sub", "stack", "immerse"],
        call: call!(slice),
        ..INSIDE
    },
];

fn jacobian<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let shape = workable_shape(a.shape(0)?)?;
    multipliable(shape.net().clone())?;
    Ok(match operators::jacobian_shape(&shape)? {
        operators::Shape::Form(form) => form.into(),
        operators::Shape::Spline(spline) => spline.into(),
    })
}

/// Evaluations that a proof may take, about.
const EVALUATIONS: usize = 1 << 12;

fn folds(a: &Bound<f64>) -> Outcome<f64> {
    let shape = a.shape(0)?;
    require_points(shape.net(), EVALUATIONS, 0.0)?;
    let found = operators::folds(&shape, a.number(1)?)?;
    let place = |at: &Option<Vec<f64>>| list_of_numbers(at.iter().flatten().copied());
    let boxes = found.undecided.iter().map(|ends| {
        Value::list(ends.iter().map(|end| list_of_numbers(end.iter().copied())).collect())
    });
    let entries = vec![
        (words("answer", "réponse"), Value::Text(found.answer.name().to_owned())),
        (words("positive", "positif"), place(&found.positive)),
        (words("negative", "négatif"), place(&found.negative)),
        (words("undecided", "indécis"), Value::list(boxes.collect())),
        (words("regular", "régulier"), Value::Boolean(found.regular)),
        (words("injective", "injectif"), Value::Boolean(found.injective)),
    ];
    if a.is_given(2) { entry(&entries, &a.text(2)?) } else { Ok(Value::Record(entries)) }
}

fn slice<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let (shape, axis) = (a.shape(0)?, a.whole(1)?);
    let at = |t: &S| -> Outcome<S> {
        Ok(match &shape {
            operators::Shape::Form(form) => operators::sub(form, axis, t)?.into(),
            operators::Shape::Spline(spline) => {
                match operators::Shape::from(spline.sub(axis, t)?) {
                    operators::Shape::Form(form) => form.into(),
                    operators::Shape::Spline(spline) => spline.into(),
                }
            }
        })
    };
    match a.value(2) {
        Value::List(_) => {
            let frames = a.flat_numbers(2)?;
            require_points(shape.net(), frames.len(), 0.0)?;
            Ok(Value::list(frames.iter().map(at).collect::<Result<Vec<_>, _>>()?))
        }
        other => at(&a.number_of(2, &other)?),
    }
}
