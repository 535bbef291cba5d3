//! Boards laid along straight lines of surfaces.

use pforms_kernel::Form;
use pforms_operators::{self as operators, Plank, PlankOptions, Spline};

use super::{Outcome, PLAIN, list_of_numbers, part};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Bound, Failure, Operator, Parameter, Takes, Value, Words};

const PARTS: &[Words] = &[
    words("strip", "bande"),
    words("line", "ligne"),
    words("outline", "contour"),
    words("flat", "plat"),
    words("axis", "axe"),
    words("nails", "clous"),
    words("marks", "repères"),
    words("crossings", "croisements"),
    words("complete", "complet"),
    words("length", "longueur"),
    words("bend", "courbure"),
    words("twist", "torsion"),
    words("slant", "biais"),
    words("strain", "allongement"),
    words("lift", "écart"),
    words("overhang", "débord"),
    words("widest", "maximum"),
    words("error", "erreur"),
];

pub(super) static ENTRIES: &[Operator] = &[Operator {
    name: "planks",
    english: &["PLANKS"],
    french: &["PLANCHES"],
    group: Group::Inside,
    summary: words(
        "Thin straight boards laid on a surface along its geodesics.",
        "Des planches minces et droites posées sur une surface le long de ses géodésiques.",
    ),
    help: words(
        "The strip touches the surface along the line and is developable: laid flat, it is a board with straight \
         edges and ends cut along its rulings. part = \"outline\" gives its outline, \"flat\" its face, \"axis\" \
         its middle, \"marks\" segments where others cross it, each board below the one before; \"nails\" these \
         places in space, \"crossings\" lists [distance, angle in radians, number of the other], \"complete\" \
         whether that is surely all. \"bend\" is the largest curvature, \"twist\" that of the normal, \"slant\" \
         the angle of the rulings, \"lift\" how far the edges stand off the surface, \"overhang\" how far they \
         go beyond its border, \"widest\" the width at which rulings cross, 0 if none. A generator of a \
         hyperboloid gives a twisted board, its edges stretched by \"strain\".",
        "La bande touche la surface le long de la ligne et elle est développable : mise à plat, c'est une planche \
         aux bords droits et aux bouts coupés selon ses génératrices. partie = \"contour\" donne son contour, \
         \"plat\" sa face, \"axe\" son milieu, \"repères\" des segments où d'autres la croisent, chaque planche \
         sous la précédente ; \"clous\" ces places dans l'espace, \"croisements\" des listes [distance, angle en \
         radians, numéro de l'autre], \"complet\" si c'est sûrement tout. \"courbure\" est la plus grande, \
         \"torsion\" celle de la normale, \"biais\" l'angle des génératrices, \"écart\" celui des bords à la \
         surface, \"débord\" ce qui en dépasse, \"maximum\" la largeur où des génératrices se croisent, 0 s'il \
         n'y en a pas. Une génératrice d'un hyperboloïde donne une planche vrillée, aux bords étirés de \
         \"allongement\".",
    ),
    parameters: &[
        Parameter::new(
            Takes::Form,
            words("surface", "surface"),
            words("The surface, in space.", "La surface, dans l'espace."),
        ),
        Parameter::new(
            Takes::Any,
            words("lines", "lignes"),
            words(
                "A geodesic in the parameters of the surface, such as GEODESIC(…, part = \"parameters\"), or a list.",
                "Une géodésique dans les paramètres de la surface, comme GEODESIQUE(…, partie = \"paramètres\"), \
                 ou une liste.",
            ),
        ),
        Parameter::new(
            Takes::Number,
            words("width", "largeur"),
            words("The width of the boards.", "La largeur des planches."),
        ),
        part("strip", PARTS),
        Parameter::new(
            Takes::Number,
            words("accuracy", "précision"),
            words(
                "Of the strips, in sizes of the surface.",
                "Celle des bandes, en tailles de la surface.",
            ),
        )
        .range(0.0, 1.0)
        .or(Fallback::Ratio(1, 100_000_000)),
        Parameter::new(
            Takes::Number,
            words("spacing", "espacement"),
            words(
                "From the axis of one flat board to that of the next.",
                "De l'axe d'une planche à plat à celui de la suivante.",
            ),
        )
        .or_absent("one and a half times the width", "une fois et demie la largeur"),
    ],
    example: "=PLANKS(CYLINDER(2, 1, part=\"quarter\"), [(0, 1/2), (1, 1/2)], 1/4)",
    source: "book 36; do Carmo 1976, section 3.5; Pottmann and Wallner 2001, chapter 6",
    see: &["geodesic", "unroll", "tangent_developable", "parallel"],
    call: call!(floating planks),
    ..PLAIN
}];

fn planks(a: &Bound<f64>) -> Outcome<f64> {
    let surface = a.shape(0)?.into_spline();
    let mut lines = Vec::new();
    let given = a.value(1);
    let listed = collected(a, &given, &mut lines)?;
    let (width, part, accuracy) = (a.number(2)?, a.choice(3)?, a.number(4)?);
    let spacing = if a.is_given(5) { a.number(5)? } else { 1.5 * width };
    let marks = matches!(part, "marks" | "nails" | "crossings" | "complete");
    let boards = operators::planks(surface, &lines, width, &PlankOptions { accuracy, marks })?;
    if part == "nails" {
        return nails(&boards);
    }
    let mut found = Vec::with_capacity(boards.len());
    for (number, board) in boards.into_iter().enumerate() {
        found.push(wanted(board, part, width, -spacing * number as f64)?);
    }
    Ok(if listed { Value::list(found) } else { found.pop().unwrap_or(Value::Empty) })
}

/// Collects the lines of a value, and says whether it is a list of them: so is a net, of its rows.
fn collected(a: &Bound<f64>, value: &Value<f64>, into: &mut Vec<Spline>) -> Result<bool, Failure> {
    match value {
        Value::List(items) if !value.is_points() => {
            for item in items {
                collected(a, item, into)?;
            }
            Ok(true)
        }
        _ => {
            let (lines, listed) = operators::plank_lines(a.shape_of(1, value)?)?;
            into.extend(lines);
            Ok(listed)
        }
    }
}

fn wanted(board: Plank, part: &str, width: f64, down: f64) -> Result<Value<f64>, Failure> {
    Ok(match part {
        "line" => Value::Spline(board.line),
        "outline" => Value::Spline(operators::translate(&board.outline, &[0.0, down])?),
        "axis" => operators::translate(&board.axis, &[0.0, down])?.into(),
        "flat" => flat(&board, down)?,
        "marks" => segments(&board, width, down)?,
        "crossings" => {
            let place = |mark: &operators::Mark| {
                list_of_numbers([mark.at, mark.angle, (mark.other + 1) as f64])
            };
            Value::list(board.marks.iter().map(place).collect())
        }
        "complete" => Value::Boolean(board.complete),
        "length" => Value::Number(board.length),
        "bend" => Value::Number(board.bend),
        "twist" => Value::Number(board.twist),
        "slant" => Value::Number(board.slant),
        "strain" => Value::Number(board.strain),
        "lift" => Value::Number(board.lift),
        "overhang" => Value::Number(board.overhang),
        "widest" => Value::Number(board.widest.unwrap_or(0.0)),
        "error" => Value::Number(board.error),
        _ => Value::Spline(board.strip),
    })
}

/// Where axes cross, in space, each place once.
fn nails(boards: &[Plank]) -> Outcome<f64> {
    let mut all = Vec::new();
    for (number, board) in boards.iter().enumerate() {
        for mark in board.marks.iter().filter(|mark| mark.other > number) {
            all.push(Form::point(&board.line.at(&[mark.at])?)?.into());
        }
    }
    Ok(Value::list(all))
}

/// A flat board as a facet.
fn flat(board: &Plank, down: f64) -> Result<Value<f64>, Failure> {
    let corner = |k: usize| board.outline.at(&[k as f64]);
    let points = [corner(0)?, corner(3)?, corner(1)?, corner(2)?].concat();
    let facet = Form::from_points(&[2, 2], 2, &points, None)?;
    Ok(operators::translate(&facet, &[0.0, down])?.into())
}

/// The sine of the least angle at which the mark of another board goes from edge to edge.
const LEAST: f64 = 0.25;

/// The axes of other boards, drawn across a flat one.
fn segments(board: &Plank, width: f64, down: f64) -> Result<Value<f64>, Failure> {
    let mut all = Vec::with_capacity(board.marks.len());
    for mark in &board.marks {
        let (sine, cosine) = libm::sincos(mark.angle);
        let reach = width / 2.0 / sine.abs().max(LEAST);
        let (x, y) = (reach * cosine, reach * sine);
        let ends = [mark.at - x, down - y, mark.at + x, down + y];
        all.push(Form::from_points(&[2], 2, &ends, None)?.into());
    }
    Ok(Value::list(all))
}
