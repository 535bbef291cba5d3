//! Nearest points of a form.

use pforms_kernel::{Error, Form};
use pforms_operators::{
    self as operators, Doubt, Feet, Inversion, Poles, Projection, Shape, SplineProjector,
};

use super::lists::entry;
use super::{FORM, Outcome, PART, PLAIN, list_of_numbers};
use crate::cost::require_points;
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Bound, Failure, Operator, Parameter, Takes, Value, Words};

pub(super) static ENTRIES: &[Operator] = &[PROJECT, INVERT];

const PROJECT: Operator = Operator {
    name: "project",
    english: &["PROJECT"],
    french: &["PROJETTE"],
    group: Group::Inside,
    summary: words(
        "The nearest points of a form, with the proof that they are.",
        "Les points les plus proches d'une forme, avec la preuve qu'ils le sont.",
    ),
    help: words(
        "A record: parameters, point, distance; gap: by how much any other point of the form may be \
         nearer, at most; unique: is it proved that only these parameters give the nearest point? \
         Of several points, the poles of a net, each entry is a list and point the net of the feet. \
         part = \"distance\" takes one entry. With all = TRUE all feet, not the nearest alone: lists of \
         parameters, points, distances and kinds; complete: are these surely all? doubts: boxes \
         of parameters where that is not decided.",
        "Une fiche : paramètres, point, distance ; écart : de combien tout autre point de la forme \
         peut être plus proche, au plus ; unique : est-il prouvé que ces paramètres seuls donnent le \
         point le plus proche ? De plusieurs points, les pôles d'un réseau, chaque entrée est une \
         liste et point le réseau des pieds. partie = \"distance\" en prend une. Avec tous = VRAI tous \
         les pieds, et non le plus proche seul : listes des paramètres, points, distances et genres ; \
         complet : est-ce sûrement tout ? doutes : boîtes de paramètres où cela n'est pas décidé.",
    ),
    parameters: &[
        FORM,
        Parameter::new(
            Takes::Form,
            words("points", "points"),
            words("A point, or a net of points.", "Un point, ou un réseau de points."),
        ),
        PART,
        Parameter::new(
            Takes::Number,
            words("accuracy", "précision"),
            words(
                "In sizes of the form: distances that differ less are the same.",
                "En tailles de la forme : des distances qui diffèrent moins sont les mêmes.",
            ),
        )
        .range(0.0, 1.0)
        .or(Fallback::Ratio(1, 1_000_000_000_000)),
        Parameter::new(
            Takes::Boolean,
            words("all", "tous"),
            words(
                "All feet: from them no way leads nearer at first order.",
                "Tous les pieds : aucun chemin n'en mène plus près au premier ordre.",
            ),
        )
        .or(Fallback::Boolean(false)),
    ],
    gives: Takes::Record,
    example: "=PROJECT([(0, 0), (1, 2), (2, 0)], (1, 3))",
    source: "catalogue 7; Ma and Hewitt 2003",
    see: &["invert", "evaluate", "frame", "item"],
    call: call!(floating project),
    ..PLAIN
};

const INVERT: Operator = Operator {
    name: "invert",
    english: &["INVERT"],
    french: &["ANTECEDENTS"],
    group: Group::Inside,
    summary: words(
        "All parameters at which a form goes through a point.",
        "Tous les paramètres où une forme passe par un point.",
    ),
    help: words(
        "A record: parameters, a list for each place; distances, what rounding leaves of them; errors of \
         the parameters; proved; complete: are these surely all? doubts: boxes of parameters \
         where that is not decided. No place: the point is outside. Of several points, the poles of a \
         net, each entry is a list. part = \"parameters\" takes one entry.",
        "Une fiche : paramètres, une liste par endroit ; distances, ce que l'arrondi en laisse ; erreurs \
         des paramètres ; prouvés ; complet : est-ce sûrement tout ? doutes : boîtes de paramètres \
         où cela n'est pas décidé. Aucun endroit : le point est dehors. De plusieurs points, les pôles \
         d'un réseau, chaque entrée est une liste. partie = \"paramètres\" en prend une.",
    ),
    parameters: &[
        Parameter::new(
            Takes::Form,
            words("host", "hôte"),
            words("A curve, a surface or a volume.", "Une courbe, une surface ou un volume."),
        ),
        Parameter::new(
            Takes::Form,
            words("points", "points"),
            words("A point, or a net of points.", "Un point, ou un réseau de points."),
        ),
        PART,
        Parameter::new(
            Takes::Number,
            words("accuracy", "précision"),
            words(
                "In sizes of the host: what is no farther from it is on it.",
                "En tailles de l'hôte : ce qui n'en est pas plus loin est dessus.",
            ),
        )
        .range(0.0, 1.0)
        .or(Fallback::Ratio(1, 1_000_000_000_000)),
    ],
    gives: Takes::Record,
    example: "=INVERT([[(0, 0), (0, 1)], [(1, 0), (2, 2)]], (1, 3/4))",
    source: "catalogue 7; Mourrain and Pavone 2009",
    see: &["project", "evaluate", "immerse", "item"],
    call: call!(floating invert),
    ..PLAIN
};

/// Work of one point, in evaluations of the form, about.
const EVALUATIONS: usize = 1 << 10;

/// Work of one point when all feet are sought, on each piece.
const ALL: usize = 1 << 14;

fn project(a: &Bound<f64>) -> Outcome<f64> {
    let (shape, net) = (a.shape(0)?, points(a)?);
    let form = shape.net();
    let (places, accuracy, all) = (net.points()?, a.number(3)?, a.boolean(4)?);
    let work = if all { ALL } else { EVALUATIONS };
    require_points(form, work.saturating_mul(net.pole_count()), 0.0)?;
    let entries = if all {
        let found = operators::project_all(&shape, &places, accuracy)?;
        side_by_side(found.iter().map(feet).collect(), net.axes() == 0)
    } else {
        let found = match &shape {
            Shape::Form(form) => operators::project(form, &places, accuracy)?,
            Shape::Spline(spline) => SplineProjector::new(spline, accuracy)?.project(&places)?,
        };
        entries(&found, form, &net)?
    };
    if a.is_given(2) { entry(&entries, &a.text(2)?) } else { Ok(Value::Record(entries)) }
}

fn invert(a: &Bound<f64>) -> Outcome<f64> {
    let (host, net) = (a.shape(0)?, points(a)?);
    require_points(host.net(), EVALUATIONS.saturating_mul(net.pole_count()), 0.0)?;
    let found = operators::invert(&host, &net.points()?, a.number(3)?)?;
    let entries = side_by_side(found.iter().map(preimages).collect(), net.axes() == 0);
    if a.is_given(2) { entry(&entries, &a.text(2)?) } else { Ok(Value::Record(entries)) }
}

/// The points of the second argument, in the space of the first.
fn points(a: &Bound<f64>) -> Result<Form, Failure> {
    let (ambient, net) = (a.shape(0)?.net().ambient(), a.form(1)?);
    if net.ambient() == ambient {
        return Ok(net);
    }
    let received = format!("points in dimension {}", net.ambient());
    Err(Error::shape("points", received, format!("dimension {ambient}")).into())
}

type Entries = Vec<(Words, Value)>;

/// The record of one point, or records of several with lists for entries.
fn side_by_side(mut records: Vec<Entries>, single: bool) -> Entries {
    if single && records.len() == 1 {
        return records.swap_remove(0);
    }
    let Some(first) = records.first() else { return Vec::new() };
    let names: Vec<Words> = first.iter().map(|(name, _)| *name).collect();
    let column = |k: usize| records.iter().map(|record| record[k].1.clone()).collect();
    names.iter().enumerate().map(|(k, name)| (*name, Value::list(column(k)))).collect()
}

fn each<T>(items: &[T], value: impl Fn(&T) -> Value) -> Value {
    Value::list(items.iter().map(value).collect())
}

fn feet(found: &Feet) -> Entries {
    let feet = &found.feet;
    vec![
        (words("parameters", "paramètres"), each(feet, |foot| place(&foot.parameters))),
        (words("points", "points"), each(feet, |foot| Value::point(&foot.point, None))),
        (words("distances", "distances"), each(feet, |foot| Value::Number(foot.distance))),
        (words("kinds", "genres"), each(feet, |foot| Value::Text(foot.kind.name().to_owned()))),
        (words("errors", "erreurs"), each(feet, |foot| Value::Number(foot.error))),
        (words("proved", "prouvés"), each(feet, |foot| Value::Boolean(foot.proved))),
        (words("complete", "complet"), Value::Boolean(found.complete())),
        (words("doubts", "doutes"), each(&found.doubts, corners)),
    ]
}

fn preimages(found: &Inversion) -> Entries {
    let places = &found.solutions;
    vec![
        (words("parameters", "paramètres"), each(places, |one| place(&one.parameters))),
        (words("distances", "distances"), each(places, |one| Value::Number(one.distance))),
        (words("errors", "erreurs"), each(places, |one| Value::Number(one.error))),
        (words("proved", "prouvés"), each(places, |one| Value::Boolean(one.proved))),
        (words("complete", "complet"), Value::Boolean(found.complete())),
        (words("doubts", "doutes"), each(&found.doubts, corners)),
    ]
}

fn place(parameters: &[f64]) -> Value {
    list_of_numbers(parameters.iter().copied())
}

/// The lower and the upper corner of a box.
fn corners(doubt: &Doubt) -> Value {
    Value::list(vec![place(&doubt.lower), place(&doubt.upper)])
}

/// The entries for one point, or lists for those of a net.
fn entries(found: &Projection, form: &Form, net: &Form) -> Result<Vec<(Words, Value)>, Failure> {
    let single = net.axes() == 0;
    let listed = |numbers: &[f64]| match numbers {
        [x] if single => Value::Number(*x),
        _ => list_of_numbers(numbers.iter().copied()),
    };
    let parameters = match form.axes() {
        _ if single => list_of_numbers(found.parameters.iter().copied()),
        0 => Value::list(vec![list_of_numbers([]); net.pole_count()]),
        axes => {
            let places = found.parameters.chunks_exact(axes);
            Value::list(places.map(|place| list_of_numbers(place.iter().copied())).collect())
        }
    };
    let unique = match found.unique[..] {
        [unique] if single => Value::Boolean(unique),
        ref all => Value::list(all.iter().map(|unique| Value::Boolean(*unique)).collect()),
    };
    let feet = Form::from_points(net.orders(), net.ambient(), &found.points, None)?;
    Ok(vec![
        (words("parameters", "paramètres"), parameters),
        (words("point", "point"), feet.into()),
        (words("distance", "distance"), listed(&found.distances)),
        (words("gap", "écart"), listed(&found.gaps)),
        (words("unique", "unique"), unique),
    ])
}
