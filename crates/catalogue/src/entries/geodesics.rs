//! Straight lines on surfaces.

use pforms_kernel::{Error, Form};
use pforms_operators::{self as operators, Ending, Geodesic, GeodesicOptions, Heading};

use super::{Outcome, PLAIN, part};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Bound, Failure, Operator, Parameter, Takes, Value, Words};

const INSIDE: Operator = Operator { group: Group::Inside, ..PLAIN };

const PARTS: &[Words] = &[
    words("curve", "courbe"),
    words("parameters", "paramètres"),
    words("length", "longueur"),
    words("error", "erreur"),
    words("ending", "fin"),
    words("end", "bout"),
    words("point", "point"),
    words("direction", "direction"),
    words("conjugate", "conjugué"),
    words("crease", "pli"),
];

const SURFACE: Parameter =
    Parameter::new(Takes::Form, words("surface", "surface"), words("The surface.", "La surface."));

const ACCURACY: Parameter = Parameter::new(
    Takes::Number,
    words("accuracy", "précision"),
    words("Of the places, in sizes of the surface.", "Celle des places, en tailles de la surface."),
)
.range(0.0, 1.0)
.or(Fallback::Ratio(1, 10_000_000_000));

const SEAMS: Parameter = Parameter::new(
    Takes::Boolean,
    words("seams", "coutures"),
    words(
        "Go on over sides of the window that are one and the same line.",
        "Continuer au delà des côtés de la fenêtre qui sont une seule et même ligne.",
    ),
)
.or(Fallback::Boolean(true));

pub(super) static ENTRIES: &[Operator] = &[Operator {
    name: "geodesic",
    english: &["GEODESIC"],
    french: &["GEODESIQUE"],
    summary: words(
        "The straight line of a surface that starts at a point in a direction.",
        "La ligne droite d'une surface qui part d'un point dans une direction.",
    ),
    help: words(
        "A spline over its own length. It goes on over knots, seams and the poles of a sphere, and ends where \
         it has the length asked for or leaves the window: part = \"ending\" says which, \"error\" how far any \
         point may be off, \"parameters\" gives it in the parameters of the surface, \"conjugate\" the length \
         from which on there are shorter ways, 0 if there is none. Several starts give a list.",
        "Une spline sur sa propre longueur. Elle passe les noeuds, les coutures et les pôles d'une sphère, et \
         finit à la longueur demandée ou au bord de la fenêtre : partie = \"fin\" dit où, \"erreur\" de combien \
         un point peut être à côté, \"paramètres\" la donne dans les paramètres de la surface, \"conjugué\" la \
         longueur à partir de laquelle il y a plus court, 0 s'il n'y en a pas. Plusieurs départs donnent une \
         liste.",
    ),
    parameters: &[
        SURFACE,
        Parameter::new(
            Takes::Form,
            words("start", "départ"),
            words(
                "Parameters, as a point (u, v), or a list of them.",
                "Les paramètres, en un point (u, v), ou une liste.",
            ),
        ),
        Parameter::new(
            Takes::Any,
            words("direction", "direction"),
            words(
                "(u', v'), a vector in space, or an angle A: u' = cos A, v' = sin A·|f_u|/|f_v|.",
                "(u', v'), un vecteur de l'espace, ou un angle A : u' = cos A, v' = sin A·|f_u|/|f_v|.",
            ),
        )
        .unit("radians", "radians"),
        Parameter::new(
            Takes::Number,
            words("length", "longueur"),
            words("How long it becomes, at most.", "Sa longueur, au plus."),
        ),
        part("curve", PARTS),
        ACCURACY,
        SEAMS,
    ],
    example: "=GEODESIC([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]], (0, 0), 0.7, 1)",
    source: "book 0232 and 36; Hairer, Nørsett and Wanner 1993",
    see: &["project", "segment", "curvature", "unroll"],
    call: call!(floating geodesic),
    ..INSIDE
}];

fn geodesic(a: &Bound<f64>) -> Outcome<f64> {
    let surface = a.shape(0)?.into_spline();
    let starts = a.form(1)?;
    let (starts, listed) = (places(&starts)?, starts.axes() > 0);
    let heading = heading(a, 2, surface.ambient())?;
    let options = GeodesicOptions { accuracy: a.number(5)?, seams: a.boolean(6)? };
    let (length, part) = (a.number(3)?, a.choice(4)?);
    let mut found = Vec::with_capacity(starts.len());
    for start in starts {
        let line = operators::geodesic(surface.clone(), start, &heading, length, &options)?;
        found.push(wanted(line, part)?);
    }
    Ok(if listed { Value::list(found) } else { found.pop().unwrap_or(Value::Empty) })
}

/// Pairs of parameters from the poles of a net.
fn places(net: &Form) -> Result<Vec<[f64; 2]>, Failure> {
    if net.ambient() != 2 {
        let received = format!("points in dimension {}", net.ambient());
        return Err(Error::shape("start", received, "points (u, v)").into());
    }
    Ok(net.points()?.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect())
}

fn heading(a: &Bound<f64>, index: usize, ambient: usize) -> Result<Heading, Failure> {
    if let Value::Number(angle) = a.value(index) {
        return Ok(Heading::Angle(angle));
    }
    let vector = a.vector(index)?;
    match vector[..] {
        [u, v] if ambient != 2 => Ok(Heading::Parameters([u, v])),
        _ if vector.len() == ambient => Ok(Heading::Vector(vector)),
        _ => {
            let received = format!("{} numbers", vector.len());
            Err(Error::shape("direction", received, format!("2 or {ambient}")).into())
        }
    }
}

fn wanted(line: Geodesic, part: &str) -> Result<Value<f64>, Failure> {
    Ok(match part {
        "parameters" => Value::Spline(line.parameters),
        "length" => Value::Number(line.length),
        "error" => Value::Number(line.error),
        "ending" => Value::Text(ending(line.ending).to_owned()),
        "end" => Form::point(&line.end)?.into(),
        "point" => Form::point(&line.point)?.into(),
        "direction" => Form::point(&line.direction)?.into(),
        "conjugate" => Value::Number(line.conjugate.unwrap_or(0.0)),
        "crease" => Value::Number(line.crease),
        _ => Value::Spline(line.spline),
    })
}

fn ending(ending: Ending) -> &'static str {
    match ending {
        Ending::Length => "length",
        Ending::Border => "border",
        Ending::Collapsed => "collapsed",
        Ending::Singular => "singular",
        Ending::Torn => "torn",
    }
}
