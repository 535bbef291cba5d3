//! Regular nets, and forms that spread along a direction: extrusions and ruled forms.

use pforms_kernel::{Form, Rational};
use pforms_operators as operators;

use super::{Outcome, PLAIN};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value};

const COMPOSED: Operator = Operator { group: Group::Composed, source: "book 321", ..PLAIN };

const ORDERS: Parameter = Parameter::new(
    Takes::Wholes,
    words("orders", "ordres"),
    words("How many poles along each axis.", "Combien de pôles le long de chaque axe."),
)
.or(Fallback::Ratio(2, 1));

const SIZE: Parameter = Parameter::new(
    Takes::Numbers,
    words("size", "taille"),
    words("How long, or how long along each axis.", "La longueur, ou une par axe."),
)
.or(Fallback::Ratio(1, 1));

const AMBIENT: Parameter = Parameter::new(
    Takes::Whole,
    words("ambient", "espace"),
    words("The dimension of the space.", "La dimension de l'espace."),
)
.or_absent("3, or the number of axes if it is more", "3, ou le nombre d'axes s'il est plus grand");

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "line",
        english: &["LINE"],
        french: &["LIGNE"],
        summary: words(
            "A straight curve along x with poles at equal steps.",
            "Une courbe droite le long de x, aux pôles également espacés.",
        ),
        help: words(
            "Centred on the origin; to be bent by moving poles.",
            "Centrée sur l'origine ; à courber en déplaçant des pôles.",
        ),
        parameters: &[
            Parameter { takes: Takes::Whole, name: words("order", "ordre"), ..ORDERS },
            Parameter { takes: Takes::Number, ..SIZE },
            AMBIENT,
        ],
        example: "=LINE(3, 2)",
        see: &["facet", "cube"],
        call: call!(line),
        ..COMPOSED
    },
    Operator {
        name: "facet",
        english: &["FACET"],
        french: &["FACETTE"],
        summary: words(
            "A flat surface in the plane xy with poles at equal steps.",
            "Une surface plane dans le plan xy, aux pôles également espacés.",
        ),
        help: words(
            "Centred on the origin; x runs along axis 0, y along axis 1.",
            "Centrée sur l'origine ; x court le long de l'axe 0, y le long de l'axe 1.",
        ),
        parameters: &[ORDERS, SIZE, AMBIENT],
        example: "=FACET([3, 2], 2)",
        see: &["line", "cube"],
        call: call!(facet),
        ..COMPOSED
    },
    Operator {
        name: "cube",
        english: &["CUBE"],
        french: &["CUBE"],
        summary: words(
            "A box with poles at equal steps, in any number of dimensions.",
            "Une boîte aux pôles également espacés, en toute dimension.",
        ),
        help: words(
            "Centred on the origin; coordinate k runs along axis k. A list of orders tells how many axes \
             there are: four make a hypercube in 4D.",
            "Centrée sur l'origine ; la coordonnée k court le long de l'axe k. Une liste d'ordres dit \
             combien il y a d'axes : quatre font un hypercube en 4D.",
        ),
        parameters: &[ORDERS, SIZE, AMBIENT],
        example: "=CUBE([2, 2, 3], 2)",
        see: &["line", "facet", "tile"],
        call: call!(cube),
        ..COMPOSED
    },
    Operator {
        name: "extrude",
        english: &["EXTRUDE"],
        french: &["EXTRUSION"],
        summary: words(
            "A form carried along a vector or a path, and all it passes through.",
            "Une forme portée le long d'un vecteur ou d'un chemin, et tout ce qu'elle traverse.",
        ),
        help: words(
            "path(s) + form(t): the axes of the path come first. A point or direction is a vector: the \
             path is the segment from the origin. Exact, of forms and splines of any dimension.",
            "chemin(s) + forme(t) : les axes du chemin viennent d'abord. Un point ou une direction est un \
             vecteur : le chemin est le segment depuis l'origine. Exact, pour des formes et des splines \
             de toute dimension.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Form,
                words("form", "forme"),
                words("What is carried.", "Ce qui est porté."),
            ),
            Parameter::new(
                Takes::Form,
                words("path", "chemin"),
                words("A vector, or a form of vectors.", "Un vecteur, ou une forme de vecteurs."),
            ),
        ],
        example: "=EXTRUDE([(1, 0, 0), (1, 1, 0), (0, 1, 0)], (0, 0, 2))",
        source: "book 312, 322",
        see: &["ruled", "translate"],
        call: call!(extrude),
        ..COMPOSED
    },
    Operator {
        name: "ruled",
        english: &["RULED"],
        french: &["REGLEE"],
        summary: words(
            "Straight lines from each point of a form to the same point of another.",
            "Des droites de chaque point d'une forme au même point d'une autre.",
        ),
        help: words(
            "Two curves make a ruled surface, two surfaces a volume, a form and a point a cone. A new \
             axis 0: MIR of the two, orders raised and knots made common as needed.",
            "Deux courbes font une surface réglée, deux surfaces un volume, une forme et un point un \
             cône. Un nouvel axe 0 : MIR des deux, ordres élevés et noeuds mis en commun au besoin.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Form,
                words("first", "première"),
                words("Where the lines begin.", "Où partent les droites."),
            ),
            Parameter::new(
                Takes::Form,
                words("second", "seconde"),
                words("Where they end.", "Où elles arrivent."),
            ),
        ],
        example: "=RULED([(0, 0, 0), (1, 0, 1)], [(0, 1, 1), (1, 1, 0)])",
        source: "book 12, 332",
        see: &["stack", "extrude"],
        call: call!(ruled),
        ..COMPOSED
    },
];

fn line<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    regular(a, &[a.whole(0)?])
}

fn facet<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    regular(a, &a.wholes(0, 2)?)
}

fn cube<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let axes = if let Value::List(items) = a.value(0) { items.len() } else { 3 };
    regular(a, &a.wholes(0, axes)?)
}

fn regular<S: Arithmetic>(a: &Bound<S>, orders: &[usize]) -> Outcome<S> {
    let sizes = match orders {
        [_] => vec![a.number(1)?],
        _ => a.numbers(1, orders.len())?,
    };
    let ambient = if a.is_given(2) { a.whole(2)? } else { orders.len().max(3) };
    Ok(operators::regular(orders, &sizes, ambient)?.into())
}

fn extrude<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let form = a.shape(0)?;
    let path = match a.value(1) {
        Value::Form(vector) if vector.axes() == 0 => path_of(a, &vector)?.into(),
        _ => a.shape(1)?,
    };
    Ok(Value::from(operators::extrude_shapes(&form, &path)?))
}

/// The path along the coordinates of a point or a direction.
fn path_of<S: Arithmetic>(a: &Bound<S>, vector: &Form<S>) -> Result<Form<S>, Failure> {
    Ok(operators::path_of(&a.vector(1)?, vector.ambient())?)
}

fn ruled<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(Value::from(operators::ruled_shapes(&a.shape(0)?, &a.shape(1)?)?))
}
