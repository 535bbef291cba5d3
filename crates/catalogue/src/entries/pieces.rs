//! Forms in pieces: their net, their pieces.

use pforms_kernel::Rational;
use pforms_operators::{Poles, Shape, Spline};

use super::{Outcome, PLAIN, list_of_forms};
use crate::operator::call;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes};

const PIECES: Parameter = Parameter::new(
    Takes::Form,
    words("pieces", "morceaux"),
    words(
        "A form in pieces, such as SUBDIVIDE gives.",
        "Une forme en morceaux, telle qu'en donne SUBDIVISION.",
    ),
);

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "net",
        english: &["NET"],
        french: &["RESEAU"],
        summary: words(
            "The control net of a form in pieces, as one form.",
            "Le réseau de pôles d'une forme en morceaux, en une seule forme.",
        ),
        help: words(
            "The poles of all pieces in one array; a form that is whole is its own net.",
            "Les pôles de tous les morceaux en un tableau ; une forme entière est son propre réseau.",
        ),
        parameters: &[PIECES],
        example: "=NET(SUBDIVIDE([(0, 0), (1, 2), (2, 0)], 2))",
        source: "book 211",
        see: &["subdivide", "pieces"],
        call: call!(net),
        ..PLAIN
    },
    Operator {
        name: "pieces",
        english: &["PIECES"],
        french: &["MORCEAUX"],
        summary: words("The pieces, as a list of forms.", "Les morceaux, en une liste de formes."),
        help: words("The last axis runs fastest.", "Le dernier axe varie le plus vite."),
        parameters: &[PIECES],
        gives: Takes::List,
        example: "=PIECES(SUBDIVIDE([(0, 0), (1, 2), (2, 0)], 1))",
        source: "book 211",
        see: &["piece", "net"],
        call: call!(pieces),
        ..PLAIN
    },
    Operator {
        name: "piece",
        english: &["PIECE"],
        french: &["MORCEAU"],
        summary: words("One of the pieces.", "L'un des morceaux."),
        help: words("Indices start at 0.", "Les indices commencent à 0."),
        parameters: &[
            PIECES,
            Parameter::new(
                Takes::Whole,
                words("index", "indice"),
                words("One number for each axis, from 0.", "Un nombre par axe, à partir de 0."),
            )
            .variadic(),
        ],
        example: "=PIECE(SUBDIVIDE([(0, 0), (1, 2), (2, 0)], 2), 3)",
        source: "book 211",
        see: &["pieces"],
        call: call!(piece),
        ..PLAIN
    },
];

fn net<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(a.shape(0)?.net().clone().into())
}

fn pieces<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let pieces = in_pieces(a)?;
    let count = pieces.counts().iter().try_fold(1usize, |product, &n| product.checked_mul(n));
    if count.is_none_or(|count| count > crate::LIST_CAP) {
        let expected = words("fewer pieces", "moins de morceaux");
        return Err(a.refused(0, &a.value(0), expected));
    }
    Ok(list_of_forms(pieces.pieces()?))
}

fn piece<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let index: Vec<usize> =
        a.all(1).iter().map(|value| a.whole_of(1, value)).collect::<Result<_, _>>()?;
    Ok(in_pieces(a)?.piece(&index)?.into())
}

/// The first argument; a form that is whole is one piece.
fn in_pieces<S: Arithmetic>(a: &Bound<S>) -> Result<Spline<S>, Failure> {
    a.shape(0).map(Shape::into_spline)
}
