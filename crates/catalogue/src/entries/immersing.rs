//! Forms inside forms.

use pforms_kernel::{Error, Kind, Rational};
use pforms_operators as operators;
use pforms_operators::{Immersed, Poles, Shape};

use super::{Outcome, PLAIN, list_of_forms, list_of_numbers};
use crate::cost::{require_bendable, require_immersible};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value};

const IMMERSION: Operator = Operator { group: Group::Interpolation, ..PLAIN };

const INNER: Parameter = Parameter::new(
    Takes::Form,
    words("inner", "intérieure"),
    words(
        "The form inside, in the space of the host's parameters.",
        "La forme intérieure, dans l'espace des paramètres de l'hôte.",
    ),
);

const HOST: Parameter = Parameter::new(
    Takes::Form,
    words("host", "hôte"),
    words("The form it is drawn in.", "La forme où elle est tracée."),
);

const fn place(
    en: &'static str,
    fr: &'static str,
    help_en: &'static str,
    help_fr: &'static str,
) -> Parameter {
    Parameter::new(Takes::Point, words(en, fr), words(help_en, help_fr))
        .unit("parameter", "paramètre")
}

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "immerse",
        english: &["IMMERSE"],
        french: &["IMMERSION", "IMMERGE"],
        summary: words(
            "One form exactly inside another, with its poles.",
            "Une forme exactement dans une autre, avec ses pôles.",
        ),
        help: words(
            "Coordinate k of the inner form is parameter k of the host. With a spline on either side the \
             result is one, cut where the inner form crosses a knot. Along each inner axis of order \
             q the result has order (m-1 summed over the host's orders)·(q-1) + 1; FORECAST tells \
             before any work. With lazy = TRUE the poles are not made until something needs them.",
            "La coordonnée k de la forme intérieure est le paramètre k de l'hôte. Avec une spline d'un \
             côté ou de l'autre le résultat en est une, coupée où la forme intérieure passe un nœud. Le long de chaque axe \
             intérieur d'ordre q, le résultat est d'ordre (somme des m-1 de l'hôte)·(q-1) + 1 ; \
             PREVISION l'annonce avant tout calcul. Avec paresseux = VRAI, les pôles ne sont calculés \
             que lorsqu'ils servent.",
        ),
        parameters: &[
            INNER,
            HOST,
            Parameter::new(
                Takes::Boolean,
                words("lazy", "paresseux"),
                words(
                    "Keep host and inner form side by side.",
                    "Garder l'hôte et la forme intérieure côte à côte.",
                ),
            )
            .or(Fallback::Boolean(false)),
        ],
        example: "=IMMERSE([(0, 0), (1, 0), (1, 1)], [[(0, 0, 0), (1, 0, 1)], [(0, 1, 1), (1, 1, 0)]])",
        source: "book 223; DeRose, Goldman, Hagen, Mann 1993",
        see: &["forecast", "segment", "tile"],
        call: call!(immerse),
        ..IMMERSION
    },
    Operator {
        name: "forecast",
        english: &["FORECAST"],
        french: &["PREVISION"],
        summary: words(
            "What an immersion would cost, before any work.",
            "Ce que coûterait une immersion, avant tout calcul.",
        ),
        help: words(
            "A record of the orders, the number of poles and the bytes. Forms, or kinds such as \
             \"pS33\" of forms in space.",
            "Une fiche : les ordres, le nombre de pôles et les octets. Des formes, ou des genres tels \
             que \"pS33\" de formes de l'espace.",
        ),
        parameters: &[
            Parameter { takes: Takes::Any, ..INNER },
            Parameter { takes: Takes::Any, ..HOST },
        ],
        gives: Takes::Record,
        example: "=FORECAST(\"pL4\", \"pS33\")",
        source: "book 2236",
        see: &["immerse"],
        call: call!(forecast),
        ..IMMERSION
    },
    Operator {
        name: "segment",
        english: &["ISEGMENT", "SEGMENT"],
        french: &["ISEGMENT"],
        summary: words(
            "An immersed segment: a straight line of the host's parameters.",
            "Un segment immergé : une droite dans les paramètres de l'hôte.",
        ),
        help: words(
            "From parameter point a to parameter point b: the book's isocline. Points such as (0, 1/2), \
             one number for each axis of the host.",
            "Du point de paramètres a au point de paramètres b : l'isocline du livre. Des points tels \
             que (0, 1/2), un nombre par axe de l'hôte.",
        ),
        parameters: &[
            HOST,
            place("a", "a", "Where it begins.", "Son début."),
            place("b", "b", "Where it ends.", "Sa fin."),
        ],
        example: "=ISEGMENT([[(0, 0, 0), (1, 0, 1)], [(0, 1, 1), (1, 1, 0)]], (0, 0), (1, 1/2))",
        source: "book 2232 to 2234",
        see: &["polyline", "immerse"],
        call: call!(segment),
        ..IMMERSION
    },
    Operator {
        name: "polyline",
        english: &["IPOLYLINE"],
        french: &["IPOLYLIGNE"],
        summary: words(
            "Immersed segments from each parameter point to the next.",
            "Des segments immergés, de chaque point de paramètres au suivant.",
        ),
        help: words("A list of curves.", "Une liste de courbes."),
        parameters: &[
            HOST,
            place("points", "points", "The corners, in order.", "Les sommets, dans l'ordre.")
                .variadic(),
        ],
        gives: Takes::List,
        example: "=IPOLYLINE([[(0, 0, 0), (1, 0, 1)], [(0, 1, 1), (1, 1, 0)]], (0, 0), (1, 1/2), (0, 1))",
        source: "book 2234",
        see: &["segment"],
        call: call!(polyline),
        ..IMMERSION
    },
    Operator {
        name: "tile",
        english: &["TILE"],
        french: &["PAVE"],
        summary: words(
            "A motif repeated in the parameters of a cage.",
            "Un motif répété dans les paramètres d'une cage.",
        ),
        help: words(
            "The forms of the cell, drawn in the unit square or cube, are repeated along each parameter \
             and immersed in the cage; copies that meet at a face of the cell meet in the cage.",
            "Les formes de la cellule, dessinées dans le carré ou le cube unité, sont répétées le long \
             de chaque paramètre et immergées dans la cage ; les copies qui se touchent sur une face de \
             la cellule se touchent dans la cage.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Any,
                words("cell", "motif"),
                words("A form or a list of forms.", "Une forme ou une liste de formes."),
            ),
            Parameter::new(
                Takes::Form,
                words("cage", "cage"),
                words("The form or spline that is filled.", "La forme ou spline à remplir."),
            ),
            Parameter::new(
                Takes::Wholes,
                words("counts", "nombres"),
                words(
                    "How many copies along each axis.",
                    "Combien de copies le long de chaque axe.",
                ),
            )
            .variadic()
            .range(1.0, 4096.0),
        ],
        gives: Takes::List,
        example: "=TILE([(0, 0), (1/2, 1), (1, 0)], [[(0, 0, 0), (1, 0, 1)], [(0, 1, 1), (1, 1, 0)]], 2)",
        source: "book 223, microstructures",
        see: &["immerse"],
        call: call!(tile),
        ..IMMERSION
    },
];

fn immerse<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let (inner, host) = match (a.shape(0)?, a.shape(1)?) {
        (Shape::Form(inner), Shape::Form(host)) => (inner, host),
        (inner, host) => return immerse_spline(a, &inner, &host),
    };
    if a.boolean(2)? {
        return Ok(Value::Immersed(Immersed::new(inner, host)?));
    }
    require_immersible(&inner, &host, 1)?;
    Ok(operators::immerse(&inner, &host)?.into())
}

/// One of the two is a spline: neither is kept aside, since the joints decide where to cut.
fn immerse_spline<S: Arithmetic>(a: &Bound<S>, inner: &Shape<S>, host: &Shape<S>) -> Outcome<S> {
    if a.boolean(2)? {
        let expected = words("FALSE for a spline", "FAUX pour une spline");
        return Err(a.refused(2, &Value::Boolean(true), expected));
    }
    require_bendable(inner, host, 1)?;
    Ok(operators::immerse_spline(inner, host)?.into())
}

fn forecast<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let (inner, _) = shape_of(a, 0)?;
    let (host, ambient) = shape_of(a, 1)?;
    let plan = operators::forecast::<S>(&inner, &host, ambient);
    let large = |count: u128| S::from_f64(count as f64).map_or(Value::Empty, Value::Number);
    let orders = plan.orders.iter().map(|&order| S::from_integer(order as i64));
    Ok(Value::Record(vec![
        (words("orders", "ordres"), list_of_numbers(orders)),
        (words("poles", "pôles"), large(plan.poles)),
        (words("bytes", "octets"), large(plan.bytes)),
    ]))
}

fn shape_of<S: Arithmetic>(a: &Bound<S>, index: usize) -> Result<(Vec<usize>, usize), Failure> {
    match a.value(index) {
        Value::Text(text) => Ok((text.parse::<Kind>()?.orders().to_vec(), 3)),
        Value::Immersed(lazy) => Ok((lazy.forecast().orders, lazy.host().ambient())),
        other => {
            let form = a.form_of(index, &other)?;
            Ok((form.orders().to_vec(), form.ambient()))
        }
    }
}

fn segment<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let host = a.form(0)?;
    let from = parameters_of(a, 1, &a.value(1), host.axes())?;
    let to = parameters_of(a, 2, &a.value(2), host.axes())?;
    Ok(operators::segment(&host, &from, &to)?.into())
}

fn polyline<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let host = a.form(0)?;
    let corners: Vec<Vec<S>> = match a.all(1) {
        [Value::Form(row)] if row.axes() == 1 => {
            let points = row.points()?;
            points.chunks_exact(row.ambient()).map(<[S]>::to_vec).collect()
        }
        values => values
            .iter()
            .map(|value| parameters_of(a, 1, value, host.axes()))
            .collect::<Result<_, _>>()?,
    };
    let slices: Vec<&[S]> = corners.iter().map(Vec::as_slice).collect();
    Ok(list_of_forms(operators::polyline(&host, &slices)?))
}

/// A place in the host: a point, a list of numbers, or a number in a curve. Coordinates beyond the
/// host's axes may be 0.
fn parameters_of<S: Arithmetic>(
    a: &Bound<S>,
    index: usize,
    value: &Value<S>,
    axes: usize,
) -> Result<Vec<S>, Failure> {
    let mut place = match value {
        Value::Form(point) if point.axes() == 0 => point.points()?,
        Value::List(items) => {
            items.iter().map(|x| a.number_of(index, x)).collect::<Result<_, _>>()?
        }
        Value::Number(x) => vec![x.clone()],
        other => return Err(a.mistyped(index, other)),
    };
    if place.iter().skip(axes).all(S::is_zero) {
        place.truncate(axes);
    }
    Ok(place)
}

fn tile<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let cage = a.shape(1)?;
    let counts = a.wholes(2, cage.net().axes())?;
    let motif: Vec<Shape<S>> = match a.value(0) {
        Value::List(items) if !Value::List(items.clone()).is_points() => {
            items.iter().map(|item| a.shape_of(0, item)).collect::<Result<_, _>>()?
        }
        one => vec![a.shape_of(0, &one)?],
    };
    let copies = counts.iter().try_fold(motif.len(), |product, &n| product.checked_mul(n));
    let Some(copies) = copies.filter(|copies| *copies <= crate::LIST_CAP) else {
        let error = Error::domain("counts", format!("{counts:?}"), "fewer copies");
        let french = format!("nombres : reçu {counts:?}, attendu moins de copies");
        return Err(Failure::of(error, french));
    };
    for shape in &motif {
        require_bendable(shape, &cage, copies)?;
    }
    let tiles = operators::tile_shapes(&motif, &cage, &counts)?;
    Ok(Value::list(tiles.into_iter().map(Value::from).collect()))
}
