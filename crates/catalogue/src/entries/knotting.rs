//! More knots and fewer, the same spline.

use pforms_kernel::Rational;
use pforms_operators::{self as operators, Shape};

use super::splining::SPLINES;
use super::{AXIS, Outcome, list_of_numbers, part};
use crate::cost::workable;
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Operator, Parameter, Takes, Value, Words};

const SPLINE: Parameter = Parameter::new(
    Takes::Form,
    words("spline", "spline"),
    words("The spline; a form is one of a single piece.", "La spline ; une forme en est une."),
);

const PARTS: &[Words] = &[words("spline", "spline"), words("error", "écart")];

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "insert_knots",
        english: &["INSERTKNOTS"],
        french: &["INSERENOEUDS"],
        summary: words(
            "The same spline with more knots, and so with more poles.",
            "La même spline avec plus de noeuds, donc plus de pôles.",
        ),
        help: words(
            "Nothing moves. A knot is inserted as often as it stands in the list; as often as the \
             degree makes the curve pass through a pole there, once more cuts it.",
            "Rien ne bouge. Un noeud est inséré autant de fois qu'il figure dans la liste ; autant de \
             fois que le degré, la courbe y passe par un pôle ; une fois de plus la coupe.",
        ),
        parameters: &[
            SPLINE,
            Parameter::new(
                Takes::Numbers,
                words("knots", "noeuds"),
                words("The knots to insert.", "Les noeuds à insérer."),
            ),
            AXIS.or(Fallback::Ratio(0, 1)),
        ],
        example: "=INSERTKNOTS([(0, 0), (1, 2), (2, 0)], [1/4, 1/2])",
        source: "The NURBS Book, 5.2",
        see: &["remove_knots", "subdivide", "pieces"],
        call: call!(insert_knots),
        ..SPLINES
    },
    Operator {
        name: "remove_knots",
        english: &["REMOVEKNOTS"],
        french: &["RETIRENOEUDS"],
        summary: words(
            "The same spline without knots that it can spare.",
            "La même spline sans les noeuds dont elle peut se passer.",
        ),
        help: words(
            "Without a list every knot that can be spared goes. A knot can be spared when no pole moves \
             by more than accuracy, relative to the largest coordinate. part = \"error\" tells how far \
             they move.",
            "Sans liste, tout noeud superflu part. Un noeud l'est quand aucun pôle ne bouge de plus que \
             la précision, relative à la plus grande coordonnée. partie = \"écart\" dit de combien.",
        ),
        parameters: &[
            SPLINE,
            Parameter::new(
                Takes::Numbers,
                words("knots", "noeuds"),
                words("The knots to remove.", "Les noeuds à retirer."),
            )
            .or_absent("all that can be spared", "tous ceux qui sont superflus"),
            AXIS.or(Fallback::Ratio(0, 1)),
            Parameter::new(
                Takes::Number,
                words("accuracy", "précision"),
                words("How far poles may move.", "De combien les pôles peuvent bouger."),
            )
            .range(0.0, f64::INFINITY)
            .or_absent("1e-12, and 0 in exact mode", "1e-12, et 0 en mode exact"),
            part("spline", PARTS),
        ],
        example: "=REMOVEKNOTS(SUBDIVIDE([(0, 0), (1, 2), (2, 0)], 2))",
        source: "The NURBS Book, 5.4",
        see: &["insert_knots", "concatenate"],
        call: call!(remove_knots),
        ..SPLINES
    },
    Operator {
        name: "knots",
        english: &["KNOTS"],
        french: &["NOEUDS"],
        group: Group::Forms,
        summary: words("The knots of an axis of a spline.", "Les noeuds d'un axe d'une spline."),
        help: words(
            "The full list: those at the ends as often as they count.",
            "La liste complète : ceux des bouts autant de fois qu'ils comptent.",
        ),
        parameters: &[SPLINE, AXIS.or(Fallback::Ratio(0, 1))],
        gives: Takes::List,
        example: "=KNOTS(BSPLINE([(0, 0), (0, 2), (2, 2)], 2))",
        source: "book 343",
        see: &["insert_knots", "pieces"],
        call: call!(knots),
        ..SPLINES
    },
];

fn insert_knots<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let spline = a.shape(0)?.into_spline();
    workable(spline.net().clone())?;
    Ok(spline.insert_knots(a.whole(2)?, &a.flat_numbers(1)?)?.into())
}

fn remove_knots<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let spline = a.shape(0)?.into_spline();
    workable(spline.net().clone())?;
    let knots = if a.is_given(1) { Some(a.flat_numbers(1)?) } else { None };
    let accuracy = match () {
        () if a.is_given(3) => a.number(3)?,
        () if S::EXACT => S::zero(),
        () => S::ratio(1, 1_000_000_000_000),
    };
    let wanted = a.choice(4)?;
    let found = operators::remove_knots(&spline, a.whole(2)?, knots.as_deref(), &accuracy)?;
    Ok(if wanted == "error" { Value::Number(found.error) } else { found.spline.into() })
}

fn knots<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let spline = a.shape(0).map(Shape::into_spline)?;
    let axis = a.whole(1)?;
    spline.net().require_axis(axis)?;
    Ok(list_of_numbers(spline.knots()[axis].as_slice().iter().cloned()))
}
