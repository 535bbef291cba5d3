//! Straight lines on surfaces.

use pforms_kernel::{Error, Form};
use pforms_operators::{
    self as operators, Connection, Ending, Geodesic, GeodesicOptions, Heading, Minimality,
};

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

const WAYS: &[Words] = &[
    words("curve", "courbe"),
    words("parameters", "paramètres"),
    words("length", "longueur"),
    words("error", "erreur"),
    words("gap", "écart"),
    words("minimality", "minimalité"),
    words("all", "toutes"),
    words("lengths", "longueurs"),
];

const fn end(name: Words, help: Words) -> Parameter {
    Parameter::new(Takes::Point, name, help)
}

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
    see: &["project", "segment", "curvature", "planks"],
    call: call!(floating geodesic),
    ..INSIDE
},
Operator {
    name: "geodesic_between",
    english: &["GEODESICBETWEEN"],
    french: &["GEODESIQUEENTRE"],
    summary: words(
        "The straight line of a surface from one of its points to another.",
        "La ligne droite d'une surface d'un de ses points à un autre.",
    ),
    help: words(
        "The shortest of the lines found in directions all around the first point. part = \"minimality\" says \
         whether it is proved that none is shorter (\"proved\", where it is straight), that none near it is \
         (\"local\"), or that the points are conjugate (\"family\"), as on opposite sides of a sphere; \"all\" \
         gives every line found, \"lengths\" their lengths. 0 is the length between a point and itself.",
        "La plus courte des lignes trouvées dans les directions tout autour du premier point. partie = \
         \"minimalité\" dit s'il est prouvé qu'aucune n'est plus courte (\"proved\", où elle est droite), \
         qu'aucune ne l'est auprès d'elle (\"local\"), ou que les points sont conjugués (\"family\"), comme \
         de part et d'autre d'une sphère ; \"toutes\" donne chaque ligne trouvée, \"longueurs\" leurs \
         longueurs. Entre un point et lui-même la longueur est 0.",
    ),
    parameters: &[
        SURFACE,
        end(words("p", "p"), words("Parameters (u, v) of the first.", "Les paramètres (u, v) du premier.")),
        end(words("q", "q"), words("Parameters (u, v) of the other.", "Les paramètres (u, v) de l'autre.")),
        part("curve", WAYS),
        Parameter::new(
            Takes::Number,
            words("longest", "maximum"),
            words("Lines up to this length are sought.", "Des lignes jusqu'à cette longueur sont cherchées."),
        )
        .range(0.0, f64::MAX)
        .or_absent(
            "one and a half times the segment between the parameters",
            "une fois et demie le segment entre les paramètres",
        ),
        ACCURACY,
        SEAMS,
    ],
    example: "=GEODESICBETWEEN([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]], (0, 1/4), (1, 1/2))",
    source: "book 36; do Carmo 1976, sections 5.3 and 5.5",
    see: &["geodesic", "segment"],
    call: call!(floating geodesic_between),
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

fn geodesic_between(a: &Bound<f64>) -> Outcome<f64> {
    let surface = a.shape(0)?.into_spline();
    let [p, q] = [single(a, 1)?, single(a, 2)?];
    let longest = if a.is_given(4) { Some(a.number(4)?) } else { None };
    let options = GeodesicOptions { accuracy: a.number(5)?, seams: a.boolean(6)? };
    let part = a.choice(3)?;
    if let "all" | "lengths" = part {
        let lines = operators::geodesic_between(surface, p, q, longest, &options)?;
        let value = |line: Connection| match part {
            "lengths" => Value::Number(line.geodesic.length),
            _ => line.geodesic.spline.into(),
        };
        return Ok(Value::list(lines.into_iter().map(value).collect()));
    }
    let line = operators::shortest_geodesic(surface, p, q, longest, &options)?;
    let Some(Connection { geodesic, gap, minimality }) = line else {
        return same_point(part, a);
    };
    match part {
        "gap" => Ok(Value::Number(gap)),
        "minimality" => Ok(Value::Text(known(minimality).to_owned())),
        _ => wanted(geodesic, part),
    }
}

/// What there is to say of a point and itself.
fn same_point(part: &str, a: &Bound<f64>) -> Outcome<f64> {
    match part {
        "length" | "error" | "gap" => Ok(Value::Number(0.0)),
        "minimality" => Ok(Value::Text(known(Minimality::Proved).to_owned())),
        _ => {
            let received = a.value(2).said(crate::Language::English);
            Err(Error::degenerate("q", received, "another point than p").into())
        }
    }
}

fn known(minimality: Minimality) -> &'static str {
    match minimality {
        Minimality::Proved => "proved",
        Minimality::Local => "local",
        Minimality::Family => "family",
        Minimality::Not => "not",
    }
}

/// The parameters of one point.
fn single(a: &Bound<f64>, index: usize) -> Result<[f64; 2], Failure> {
    match places(&a.point(index)?)?[..] {
        [place] => Ok(place),
        _ => Err(a.mistyped(index, &a.value(index))),
    }
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
