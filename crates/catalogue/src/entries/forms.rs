//! Poles, weights and orders: what a form is made of.

use pforms_kernel::{Form, Rational};
use pforms_operators::Poles;

use super::{FORM, Outcome, PLAIN, list_of_numbers};
use crate::operator::call;
use crate::words::words;
use crate::{Arithmetic, Bound, Language, Operator, Parameter, Takes, Value};

const INDEX: Parameter = Parameter::new(
    Takes::Whole,
    words("index", "indice"),
    words("One number for each axis, from 0.", "Un nombre par axe, à partir de 0."),
);

const ANY: Parameter =
    Parameter::new(Takes::Any, words("value", "valeur"), words("The value.", "La valeur."));

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "form",
        english: &["FORM"],
        french: &["FORME"],
        summary: words(
            "The form whose poles are a net of points.",
            "La forme dont les pôles sont un réseau de points.",
        ),
        help: words(
            "A nested list of points becomes a form wherever one is asked for, so this is seldom \
             needed; it also expands a lazily immersed form.",
            "Une liste emboîtée de points devient une forme partout où il en faut une : c'est rarement \
             nécessaire ; développe aussi une forme immergée paresseuse.",
        ),
        parameters: &[Parameter::new(
            Takes::Form,
            words("net", "réseau"),
            words(
                "Points, rows of points, rows of rows.",
                "Des points, des rangées de points, etc.",
            ),
        )],
        example: "=FORM([(0, 0), (1, 2), (2, 0)])",
        see: &["net", "pole"],
        call: call!(form),
        ..PLAIN
    },
    Operator {
        name: "pole",
        english: &["POLE"],
        french: &["POLE"],
        summary: words(
            "A pole of a form, with its weight.",
            "Un pôle d'une forme, avec son poids.",
        ),
        help: words("Indices start at 0.", "Les indices commencent à 0."),
        parameters: &[FORM, INDEX.variadic()],
        gives: Takes::Point,
        example: "=POLE([(0, 0), (1, 2; 1/2), (2, 0)], 1)",
        see: &["with_pole", "weights"],
        call: call!(pole),
        ..PLAIN
    },
    Operator {
        name: "with_pole",
        english: &["WITHPOLE"],
        french: &["AVECPOLE"],
        summary: words("The same form with one pole replaced.", "La même forme, un pôle remplacé."),
        help: words(
            "The index is a number for a curve, a list such as [0, 2] for more axes. The point brings \
             its own weight.",
            "L'indice est un nombre pour une courbe, une liste telle que [0, 2] pour plusieurs axes. \
             Le point apporte son poids.",
        ),
        parameters: &[
            FORM,
            Parameter { takes: Takes::Any, ..INDEX },
            Parameter::new(
                Takes::Point,
                words("point", "point"),
                words("The new pole.", "Le nouveau pôle."),
            ),
        ],
        example: "=WITHPOLE([(0, 0), (1, 2), (2, 0)], 1, (1, 3; 2))",
        source: "book 33, deformed forms",
        see: &["pole"],
        call: call!(with_pole),
        ..PLAIN
    },
    Operator {
        name: "weights",
        english: &["WEIGHTS"],
        french: &["POIDS"],
        summary: words("The weights of the poles.", "Les poids des pôles."),
        help: words("A list, nested like the net.", "Une liste, emboîtée comme le réseau."),
        parameters: &[FORM],
        gives: Takes::List,
        example: "=WEIGHTS([(1, 0), (1, 1; 1/2), (0, 1)])",
        see: &["pole"],
        call: call!(weights),
        ..PLAIN
    },
    Operator {
        name: "orders",
        english: &["ORDERS"],
        french: &["ORDRES"],
        summary: words(
            "How many poles a form has along each axis.",
            "Combien de pôles une forme a le long de chaque axe.",
        ),
        help: words("The order is the degree plus 1.", "L'ordre est le degré plus 1."),
        parameters: &[Parameter { takes: Takes::Any, ..FORM }],
        gives: Takes::List,
        example: "=ORDERS([(0, 0), (1, 2), (2, 0)])",
        source: "book 12",
        see: &["kind"],
        call: call!(orders),
        ..PLAIN
    },
    Operator {
        name: "kind",
        english: &["KIND"],
        french: &["GENRE"],
        summary: words(
            "What a value is, in the notation of the book.",
            "Ce qu'est une valeur, dans la notation du livre.",
        ),
        help: words(
            "pL4 a curve of 4 poles, pS33 a surface, ipL3 an immersed curve; else a word.",
            "pL4 une courbe de 4 pôles, pS33 une surface, ipL3 une courbe immergée ; sinon un mot.",
        ),
        parameters: &[ANY],
        gives: Takes::Text,
        example: "=KIND([(0, 0), (1, 2), (2, 0)])",
        source: "book 12",
        see: &["orders"],
        call: call!(kind),
        ..PLAIN
    },
    Operator {
        name: "coordinates",
        english: &["COORDINATES"],
        french: &["COORDONNEES"],
        summary: words(
            "The coordinates of a point, as a list of numbers.",
            "Les coordonnées d'un point, en une liste de nombres.",
        ),
        help: words(
            "Without the weight. ITEM(COORDINATES(p), 2) is the third.",
            "Sans le poids. ELEMENT(COORDONNEES(p), 2) est la troisième.",
        ),
        parameters: &[Parameter::new(
            Takes::Point,
            words("point", "point"),
            words("The point.", "Le point."),
        )],
        gives: Takes::List,
        example: "=COORDINATES((1, 2, 3))",
        see: &["pole", "item"],
        call: call!(coordinates),
        ..PLAIN
    },
];

fn form<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(a.form(0)?.into())
}

fn pole<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let shape = a.shape(0)?;
    let form = shape.net();
    let index: Vec<usize> =
        a.all(1).iter().map(|value| a.whole_of(1, value)).collect::<Result<_, _>>()?;
    Ok(Form::from_homogeneous(&[], form.ambient(), form.pole(&index)?.to_vec())?.into())
}

fn with_pole<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let index: Vec<usize> = match a.value(1) {
        Value::List(items) => {
            items.iter().map(|value| a.whole_of(1, value)).collect::<Result<_, _>>()?
        }
        one => vec![a.whole_of(1, &one)?],
    };
    let (shape, point) = (a.shape(0)?, a.point(2)?);
    let net = shape.net().with_pole(&index, point.homogeneous())?;
    Ok(shape.with_net(net)?.into())
}

fn weights<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let shape = a.shape(0)?;
    let form = shape.net();
    let flat = form.weights().into_iter().map(Value::Number).collect();
    Ok(nested(flat, form.orders()))
}

/// A flat list in C order, nested by axis.
fn nested<S: Arithmetic>(flat: Vec<Value<S>>, orders: &[usize]) -> Value<S> {
    let level = |items: Vec<Value<S>>, &order: &usize| {
        items.chunks_exact(order).map(|row| Value::list(row.to_vec())).collect()
    };
    let outer: Vec<Value<S>> = orders.iter().rev().fold(flat, level);
    outer.into_iter().next().unwrap_or_default()
}

fn orders<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let value = a.value(0);
    let orders = match value.orders() {
        Some(orders) => orders,
        None => a.form_of(0, &value)?.orders().to_vec(),
    };
    Ok(list_of_numbers(orders.into_iter().map(|order| S::from_integer(order as i64))))
}

fn kind<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(Value::Text(a.value(0).settle().kind(Language::English)))
}

fn coordinates<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(list_of_numbers(a.point(0)?.points()?))
}
