//! Mirrors and shadows: maps that leave a plane where it is.

use pforms_kernel::Rational;
use pforms_operators as operators;

use super::Outcome;
use super::transforming::{CENTRE, MOVED, TRANSFORMATION, centre, on_poles};
use crate::operator::call;
use crate::words::words;
use crate::{Arithmetic, Bound, Operator, Parameter, Takes};

const NORMAL: Parameter = Parameter::new(
    Takes::Point,
    words("normal", "normale"),
    words("A direction at right angles to the plane.", "Une direction perpendiculaire au plan."),
);

const ORIGIN: Parameter = Parameter {
    name: words("origin", "origine"),
    help: words("A point of the plane.", "Un point du plan."),
    ..CENTRE
};

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "mirror",
        english: &["MIRROR"],
        french: &["MIROIR"],
        summary: words("A form seen in a plane mirror.", "Une forme vue dans un miroir plan."),
        help: words(
            "In 2D the mirror is a line. The length of the normal does not matter. Exact.",
            "En 2D le miroir est une droite. La longueur de la normale est indifférente. Exact.",
        ),
        parameters: &[MOVED, NORMAL, ORIGIN],
        example: "=MIRROR([(1, 0, 0), (2, 1, 0)], (1, 0, 0))",
        source: "book 231",
        see: &["scale", "project_to_plane"],
        call: call!(mirror),
        ..TRANSFORMATION
    },
    Operator {
        name: "project_to_plane",
        english: &["SHADOW"],
        french: &["OMBRE"],
        summary: words("The shadow of a form on a plane.", "L'ombre d'une forme sur un plan."),
        help: words(
            "From a point the shadow is central (a perspective), from a direction such as (0, 0, 1; 0) \
             parallel; without one it is orthogonal. Exact: a central shadow changes the weights, so \
             that the shadow of a parabola may be any conic.",
            "Depuis un point l'ombre est centrale (une perspective), depuis une direction comme \
             (0, 0, 1; 0) parallèle ; à défaut, orthogonale. Exact : une ombre centrale change les \
             poids, si bien que l'ombre d'une parabole peut être toute conique.",
        ),
        parameters: &[
            MOVED,
            NORMAL,
            ORIGIN,
            Parameter::new(
                Takes::Point,
                words("from", "depuis"),
                words("The lamp: a point or a direction.", "La lampe : un point ou une direction."),
            )
            .or_absent("the normal", "la normale"),
        ],
        example: "=SHADOW([(0, 0, 1), (1, 0, 2)], (0, 0, 1), from=(0, 0, 4))",
        source: "book 3111",
        see: &["mirror", "transform", "project"],
        call: call!(project_to_plane),
        ..TRANSFORMATION
    },
];

fn mirror<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let normal = a.vector(1)?;
    on_poles(a, &|net| Ok(operators::mirror(net, &normal, &centre(a, 2, net)?)?))
}

fn project_to_plane<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let normal = a.vector(1)?;
    let from = if a.is_given(3) {
        a.point(3)?.homogeneous().to_vec()
    } else {
        normal.iter().cloned().chain([S::zero()]).collect()
    };
    on_poles(a, &|net| Ok(operators::project_to_plane(net, &normal, &centre(a, 2, net)?, &from)?))
}
