//! Forms through points, and near them.

use pforms_kernel::{Form, Rational};
use pforms_operators as operators;
use pforms_operators::{FitOptions, Nodes, Parameters};

use super::{Outcome, PLAIN, part};
use crate::cost::workable_at;
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value, Words};

const INTERPOLATION: Operator = Operator { group: Group::Interpolation, ..PLAIN };

const NODES: &[Words] =
    &[words("uniform", "uniforme"), words("chebyshev", "tchebychev"), words("lobatto", "lobatto")];

const PARAMETERS: &[Words] =
    &[words("chord", "corde"), words("uniform", "uniforme"), words("centripetal", "centripète")];

const FIT_PARTS: &[Words] =
    &[words("form", "forme"), words("error", "écart"), words("mean error", "écart moyen")];

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "interpolate",
        english: &["INTERPOLATE"],
        french: &["INTERPOLE", "INTERPOLATION"],
        summary: words(
            "The form of the same orders through a net of points.",
            "La forme de mêmes ordres passant par un réseau de points.",
        ),
        help: words(
            "Any number of axes. Points are met at equal steps unless nodes says otherwise: \
             \"chebyshev\" or \"lobatto\", or a list of parameters for each axis. From some ten points \
             on, equal steps make the poles run away; Chebyshev's do not.",
            "Quel que soit le nombre d'axes. Les points sont atteints à pas égaux, sauf si noeuds dit \
             autrement : \"tchebychev\" ou \"lobatto\", ou une liste de paramètres par axe. À partir \
             d'une dizaine de points, les pas égaux font s'emballer les pôles ; ceux de Tchebychev non.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Form,
                words("net", "réseau"),
                words("The points to pass through.", "Les points par où passer."),
            ),
            Parameter::new(
                Takes::Any,
                words("nodes", "noeuds"),
                words("At which parameters.", "En quels paramètres."),
            )
            .choices(NODES)
            .or(Fallback::Text("uniform")),
            Parameter::new(
                Takes::Boolean,
                words("homogeneous", "homogène"),
                words(
                    "Interpolate the weights too, so that directions are welcome.",
                    "Interpoler aussi les poids ; les directions sont alors permises.",
                ),
            )
            .or(Fallback::Boolean(false)),
        ],
        example: "=INTERPOLATE([(0, 0), (1, 1), (2, 0)])",
        source: "book 221",
        see: &["fit", "grid"],
        call: call!(interpolate),
        ..INTERPOLATION
    },
    Operator {
        name: "fit",
        english: &["FIT"],
        french: &["APPROCHE"],
        summary: words(
            "The form of given orders nearest to points.",
            "La forme d'ordres donnés la plus proche de points.",
        ),
        help: words(
            "Least squares. parameters: \"chord\", \"uniform\", \"centripetal\", or a list for each axis. \
             part = \"error\" gives the largest distance to a point, \"mean error\" the root of the mean \
             square.",
            "Moindres carrés. paramètres : \"corde\", \"uniforme\", \"centripète\", ou une liste par axe. \
             partie = \"écart\" donne la plus grande distance à un point, \"écart moyen\" la racine du \
             carré moyen.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Form,
                words("points", "points"),
                words("A row or a net of points.", "Une rangée ou un réseau de points."),
            ),
            Parameter::new(
                Takes::Wholes,
                words("orders", "ordres"),
                words("How many poles along each axis.", "Combien de pôles le long de chaque axe."),
            )
            .range(1.0, 256.0),
            Parameter::new(
                Takes::Any,
                words("parameters", "paramètres"),
                words(
                    "Where on the form the points belong.",
                    "À quels paramètres répondent les points.",
                ),
            )
            .choices(PARAMETERS)
            .or(Fallback::Text("chord")),
            Parameter::new(
                Takes::Boolean,
                words("ends", "bouts"),
                words("Pass exactly through the ends.", "Passer exactement par les bouts."),
            )
            .or(Fallback::Boolean(false)),
            Parameter::new(
                Takes::List,
                words("weights", "poids"),
                words("How much each point counts.", "Ce que compte chaque point."),
            )
            .or_absent("all points count the same", "tous les points comptent autant"),
            part("form", FIT_PARTS),
        ],
        example: "=FIT([(0, 0), (1, 0.9), (2, 1.1), (3, 0)], 3, ends=TRUE)",
        source: "book 221; The NURBS Book, 9.4",
        see: &["interpolate", "reduce"],
        call: call!(floating fit),
        ..INTERPOLATION
    },
];

fn interpolate<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let net = a.form(0)?;
    let widest = net.orders().iter().copied().max().unwrap_or(1);
    let net = workable_at(net, &[S::ratio(1, widest as i64)])?;
    let nodes = match a.value(1) {
        Value::List(items) => Nodes::Given(lists_of(a, 1, &items, net.axes())?),
        _ => match a.choice(1)? {
            "chebyshev" => Nodes::Chebyshev,
            "lobatto" => Nodes::Lobatto,
            _ => Nodes::Uniform,
        },
    };
    Ok(if a.boolean(2)? {
        operators::interpolate_homogeneous(&net, &nodes)?.into()
    } else {
        operators::interpolate(&net, &nodes)?.into()
    })
}

/// One list of numbers for each axis; a plain list of numbers counts for all axes.
pub(super) fn lists_of<S: Arithmetic>(
    a: &Bound<S>,
    index: usize,
    items: &[Value<S>],
    axes: usize,
) -> Result<Vec<Vec<S>>, Failure> {
    let numbers = |items: &[Value<S>]| {
        items.iter().map(|item| a.number_of(index, item)).collect::<Result<Vec<_>, Failure>>()
    };
    if !items.iter().any(|item| matches!(item, Value::List(_))) {
        return Ok(vec![numbers(items)?; axes]);
    }
    let list = |item: &Value<S>| match item {
        Value::List(row) => numbers(row),
        other => Err(a.mistyped(index, other)),
    };
    items.iter().map(list).collect()
}

fn fit(a: &Bound<f64>) -> Outcome<f64> {
    let net = a.form(0)?;
    let given = a.value(1);
    let axes = if let Value::List(items) = &given { items.len() } else { net.axes() };
    let weights = a.is_given(4).then(|| a.list(4)).transpose()?;
    let read = |list: Vec<Value<f64>>| {
        list.iter().map(|x| a.number_of(4, x)).collect::<Result<Vec<_>, Failure>>()
    };
    let options = FitOptions {
        orders: a.wholes(1, axes)?,
        parameters: parameters(a, axes)?,
        weights: weights.map(read).transpose()?,
        ends: a.boolean(3)?,
    };
    let mut shape = net.orders().to_vec();
    shape.push(net.ambient());
    let wanted = a.choice(5)?;
    let result = operators::fit(&net.points()?, &shape, &options)?;
    Ok(match wanted {
        "error" => Value::Number(result.max_error),
        "mean error" => Value::Number(result.rms_error),
        _ => Value::from(Form::clone(&result.form)),
    })
}

fn parameters(a: &Bound<f64>, axes: usize) -> Result<Parameters, Failure> {
    Ok(match a.value(2) {
        Value::List(items) => Parameters::Given(lists_of(a, 2, &items, axes)?),
        _ => match a.choice(2)? {
            "uniform" => Parameters::Uniform,
            "centripetal" => Parameters::Centripetal,
            _ => Parameters::Chord,
        },
    })
}
