//! Points, derivatives and the polar form.

use pforms_kernel::{Form, Rational};
use pforms_operators::{self as operators, Poles, Shape, Spline};

use super::{AXIS, FORM, Outcome, PLAIN, of_either};
use crate::cost::{longest, multipliable, require_points, workable};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, LIST_CAP, Operator, Parameter, Takes, Value};

const FUNDAMENTAL: Operator = Operator { group: Group::Fundamental, ..PLAIN };

/// The highest derivative a sheet asks for along an axis.
const DERIVATIVE_CAP: f64 = 16.0;

const PARAMETERS: Parameter = Parameter::new(
    Takes::Numbers,
    words("parameters", "paramètres"),
    words(
        "One for each axis; a list gives as many points.",
        "Un par axe ; une liste donne autant de points.",
    ),
)
.variadic()
.unit("parameter", "paramètre");

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "evaluate",
        english: &["POINT"],
        french: &["POINT"],
        summary: words(
            "The point of a form at parameters.",
            "Le point d'une forme en des paramètres.",
        ),
        help: words(
            "Any reals; 0 to 1 is the usual window. Lists of parameters give a list of points, single \
             numbers beside them count for all. Pieces and immersed forms are evaluated as they are.",
            "Réels quelconques ; de 0 à 1 d'ordinaire. Des listes de paramètres donnent une liste de \
             points, un nombre seul vaut pour tous. Les formes en morceaux et les formes immergées \
             sont évaluées telles quelles.",
        ),
        parameters: &[FORM, PARAMETERS.or_absent("none, for a point", "aucun, pour un point")],
        gives: Takes::Point,
        example: "=POINT([(0, 0), (1, 2), (2, 0)], 1/4)",
        source: "book 2141",
        see: &["grid", "sub", "derivative"],
        call: call!(evaluate),
        ..FUNDAMENTAL
    },
    Operator {
        name: "grid",
        english: &["GRID"],
        french: &["GRILLE"],
        summary: words(
            "Points of a form on a regular grid.",
            "Des points d'une forme sur une grille régulière.",
        ),
        help: words(
            "A net of as many points along each axis, both ends of the window included (that of its \
             knots, for a spline). \
             INTERPOLATE(GRID(f, ORDERS(f))) is f again when it is polynomial.",
            "Un réseau d'autant de points le long de chaque axe, bords compris (ceux des noeuds, pour \
             une spline). \
             INTERPOLE(GRILLE(f, ORDRES(f))) redonne f quand elle est polynomiale.",
        ),
        parameters: &[
            FORM,
            Parameter::new(
                Takes::Wholes,
                words("counts", "nombres"),
                words(
                    "How many points along each axis.",
                    "Combien de points le long de chaque axe.",
                ),
            )
            .variadic()
            .range(1.0, 4097.0),
        ],
        example: "=GRID([(0, 0), (1, 2), (2, 0)], 5)",
        source: "book 2141",
        see: &["evaluate", "interpolate"],
        call: call!(grid),
        ..FUNDAMENTAL
    },
    Operator {
        name: "derivative",
        english: &["DERIVATIVE"],
        french: &["DERIVEE"],
        summary: words(
            "A derivative, as a form of vectors.",
            "Une dérivée, en tant que forme de vecteurs.",
        ),
        help: words(
            "Its points are the derivative vectors. Of a polynomial form the degree falls; of a \
             rational one it is the exact quotient, and the degree grows.",
            "Ses points sont les vecteurs dérivés. Le degré d'une forme polynomiale baisse ; pour une \
             forme rationnelle c'est le quotient exact, et le degré augmente.",
        ),
        parameters: &[
            FORM,
            Parameter::new(
                Takes::Wholes,
                words("orders", "ordres"),
                words("How often along each axis.", "Combien de fois le long de chaque axe."),
            )
            .variadic()
            .range(0.0, DERIVATIVE_CAP)
            .or(Fallback::Ratio(1, 1)),
        ],
        example: "=DERIVATIVE([(0, 0), (1, 2), (2, 0)], 2)",
        source: "course, hodographe",
        see: &["hodograph", "evaluate"],
        call: call!(derivative),
        ..FUNDAMENTAL
    },
    Operator {
        name: "hodograph",
        english: &["HODOGRAPH"],
        french: &["HODOGRAPHE"],
        summary: words(
            "The first derivative along an axis, as a form.",
            "La dérivée première le long d'un axe, en tant que forme.",
        ),
        help: words(
            "Drawn from the origin, the curve of velocities.",
            "Tracée depuis l'origine, la courbe des vitesses.",
        ),
        parameters: &[FORM, AXIS.or(Fallback::Ratio(0, 1))],
        example: "=HODOGRAPH([(0, 0), (1, 2), (2, 0)])",
        source: "course, hodographe",
        see: &["derivative", "tangent_form"],
        call: call!(hodograph),
        ..FUNDAMENTAL
    },
    Operator {
        name: "blossom",
        english: &["BLOSSOM"],
        french: &["BLOSSOM", "FLORAISON"],
        summary: words(
            "The polar form: as many arguments as the degree.",
            "La forme polaire : autant d'arguments que le degré.",
        ),
        help: words(
            "Symmetric, affine in each argument, and the point when all are equal: the poles of a \
             curve of degree 2 are its values at (0, 0), (0, 1), (1, 1). For a curve the arguments \
             one after another, else a list for each axis.",
            "Symétrique, affine en chaque argument, et le point quand tous sont égaux : les pôles \
             d'une courbe de degré 2 sont ses valeurs en (0, 0), (0, 1), (1, 1). Pour une courbe les \
             arguments à la suite, sinon une liste par axe.",
        ),
        parameters: &[
            FORM,
            Parameter::new(
                Takes::Numbers,
                words("arguments", "arguments"),
                words(
                    "As many as the degree, along each axis.",
                    "Autant que le degré, pour chaque axe.",
                ),
            )
            .variadic(),
        ],
        gives: Takes::Point,
        example: "=BLOSSOM([(0, 0), (1, 2), (2, 0)], 0, 1)",
        source: "Ramshaw 1987",
        see: &["bernstein", "stretch"],
        call: call!(blossom),
        ..FUNDAMENTAL
    },
];

fn evaluate<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let place = match a.value(0) {
        whole @ (Value::Spline(_) | Value::Immersed(_)) => whole,
        other => a.form_of(0, &other)?.into(),
    };
    let given = a.all(1);
    if let Value::Form(form) = &place {
        let numbers = a.flat_numbers(1)?;
        require_points(form, numbers.len().max(1), longest(&numbers))?;
    }
    let mut lists = given.iter().filter_map(as_list);
    let Some(first) = lists.next() else {
        return point_at(a, &place, given.iter());
    };
    if lists.any(|list| list.len() != first.len()) {
        let expected = words("lists of one length", "des listes de même longueur");
        return Err(a.refused(1, &given[0], expected));
    }
    let points = (0..first.len()).map(|i| {
        point_at(a, &place, given.iter().map(|value| as_list(value).map_or(value, |list| &list[i])))
    });
    Ok(Value::list(points.collect::<Result<_, _>>()?))
}

fn as_list<S>(value: &Value<S>) -> Option<&Vec<Value<S>>> {
    match value {
        Value::List(items) => Some(items),
        _ => None,
    }
}

fn point_at<'a, S: Arithmetic>(
    a: &Bound<S>,
    place: &Value<S>,
    parameters: impl Iterator<Item = &'a Value<S>>,
) -> Outcome<S> {
    let at: Vec<S> = parameters.map(|t| a.number_of(1, t)).collect::<Result<_, _>>()?;
    let point = match place {
        Value::Spline(pieces) => pieces.at(&at)?,
        Value::Immersed(lazy) => lazy.at(&at)?,
        other => a.form_of(0, other)?.at(&at)?,
    };
    Ok(Form::point(&point)?.into())
}

fn grid<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let shape = a.shape(0)?;
    let net = shape.net();
    let counts = a.wholes(1, net.axes())?;
    let total = counts.iter().try_fold(1usize, |product, &count| product.checked_mul(count));
    let Some(total) = total.filter(|&total| total <= LIST_CAP) else {
        return Err(a.refused(1, &a.value(1), words("fewer points", "moins de points")));
    };
    let finest = counts.iter().copied().max().unwrap_or(1);
    let bits = longest(&[S::ratio(1, finest as i64)]);
    match &shape {
        Shape::Form(form) => require_points(form, total, bits)?,
        Shape::Spline(spline) => {
            require_points(&spline.piece(&vec![0; net.axes()])?, total, bits)?;
        }
    }
    let mut points = Vec::with_capacity(total * net.ambient());
    for flat in 0..total {
        let at = parameters_of(flat, &counts);
        points.extend(match &shape {
            Shape::Form(form) => form.at(&at)?,
            Shape::Spline(spline) => spline.at(&in_window(spline, at)?)?,
        });
    }
    Ok(Form::from_points(&counts, net.ambient(), &points, None)?.into())
}

/// The parameters of point number `flat` of a regular grid, the last axis fastest.
fn parameters_of<S: Arithmetic>(flat: usize, counts: &[usize]) -> Vec<S> {
    let mut rest = flat;
    let mut parameters: Vec<S> = counts
        .iter()
        .rev()
        .map(|&count| {
            let index = rest % count;
            rest /= count;
            if count == 1 { S::ratio(1, 2) } else { S::ratio(index as i64, count as i64 - 1) }
        })
        .collect();
    parameters.reverse();
    parameters
}

/// Shares of the window as parameters of the spline.
fn in_window<S: Arithmetic>(spline: &Spline<S>, shares: Vec<S>) -> Result<Vec<S>, Failure> {
    let place = |(axis, share): (usize, S)| -> Result<S, Failure> {
        let (from, to) = spline.window(axis)?;
        Ok(if share == S::one() { to } else { from.clone() + share * (to - from) })
    };
    shares.into_iter().enumerate().map(place).collect()
}

fn derivative<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    of_either(
        a,
        |form| {
            let form = multipliable(form)?;
            Ok(operators::derivative(&form, &a.wholes(1, form.axes())?)?)
        },
        |spline| {
            multipliable(spline.piece(&vec![0; spline.axes()])?)?;
            Ok(spline.derivative(&a.wholes(1, spline.axes())?)?)
        },
    )
}

fn hodograph<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let axis = a.whole(1)?;
    let form = |form| Ok(operators::hodograph(&multipliable(form)?, axis)?);
    of_either(a, form, |spline| Ok(spline.hodograph(axis)?))
}

fn blossom<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let form = workable(a.form(0)?)?;
    let read = |value: &Value<S>| a.number_of(1, value);
    let lists: Vec<Vec<S>> = if a.all(1).iter().any(|value| as_list(value).is_some()) {
        let list = |value: &Value<S>| match value {
            Value::List(items) => items.iter().map(read).collect::<Result<_, Failure>>(),
            one => Ok(vec![read(one)?]),
        };
        a.all(1).iter().map(list).collect::<Result<_, _>>()?
    } else {
        vec![a.all(1).iter().map(read).collect::<Result<_, _>>()?]
    };
    let slices: Vec<&[S]> = lists.iter().map(Vec::as_slice).collect();
    let point = operators::blossom(&form, &slices)?;
    Ok(Form::from_homogeneous(&[], form.ambient(), point)?.into())
}
