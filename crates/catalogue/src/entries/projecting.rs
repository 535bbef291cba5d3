//! Nearest points of a form.

use pforms_kernel::{Error, Form};
use pforms_operators::{self as operators, Poles, Projection, Shape, SplineProjector};

use super::lists::entry;
use super::{FORM, Outcome, PART, PLAIN, list_of_numbers};
use crate::cost::require_points;
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Bound, Failure, Operator, Parameter, Takes, Value, Words};

pub(super) static ENTRIES: &[Operator] = &[Operator {
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
         part = \"distance\" takes one entry.",
        "Une fiche : paramètres, point, distance ; écart : de combien tout autre point de la forme \
         peut être plus proche, au plus ; unique : est-il prouvé que ces paramètres seuls donnent le \
         point le plus proche ? De plusieurs points, les pôles d'un réseau, chaque entrée est une \
         liste et point le réseau des pieds. partie = \"distance\" en prend une.",
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
    ],
    gives: Takes::Record,
    example: "=PROJECT([(0, 0), (1, 2), (2, 0)], (1, 3))",
    source: "catalogue 7; Ma and Hewitt 2003",
    see: &["evaluate", "frame", "item"],
    call: call!(floating project),
    ..PLAIN
}];

/// Work of one point, in evaluations of the form, about.
const EVALUATIONS: usize = 1 << 10;

fn project(a: &Bound<f64>) -> Outcome<f64> {
    let (shape, net) = (a.shape(0)?, a.form(1)?);
    let form = shape.net();
    if net.ambient() != form.ambient() {
        let received = format!("points in dimension {}", net.ambient());
        return Err(
            Error::shape("points", received, format!("dimension {}", form.ambient())).into()
        );
    }
    require_points(form, EVALUATIONS.saturating_mul(net.pole_count()), 0.0)?;
    let (points, accuracy) = (net.points()?, a.number(3)?);
    let found = match &shape {
        Shape::Form(form) => operators::project(form, &points, accuracy)?,
        Shape::Spline(spline) => SplineProjector::new(spline, accuracy)?.project(&points)?,
    };
    let entries = entries(&found, form, &net)?;
    if a.is_given(2) { entry(&entries, &a.text(2)?) } else { Ok(Value::Record(entries)) }
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
