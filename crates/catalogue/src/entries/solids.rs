//! Solids together and apart.

use pforms_mesh::{Operation, Part, combine};

use super::lists::entry;
use super::{Outcome, PLAIN};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Bound, Failure, Operator, Parameter, Takes, Value};

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "union",
        english: &["UNION"],
        french: &["UNION"],
        summary: words(
            "Everything that is in one of the solids, as a mesh.",
            "Tout ce qui est dans l'un des solides, en maillage.",
        ),
        example: "=UNION(CUBE(2, 1), TRANSLATE(CUBE(2, 1), (0.5, 0, 0)))",
        see: &["difference", "common"],
        call: call!(floating | a | answer(a, Operation::Union)),
        ..SOLIDS
    },
    Operator {
        name: "difference",
        english: &["DIFFERENCE"],
        french: &["DIFFERENCE"],
        summary: words(
            "The first solid without the others, as a mesh.",
            "Le premier solide sans les autres, en maillage.",
        ),
        example: "=DIFFERENCE(CUBE(2, 1), TRANSLATE(CUBE(2, 1), (0.5, 0, 0)))",
        see: &["union", "common"],
        call: call!(floating | a | answer(a, Operation::Difference)),
        ..SOLIDS
    },
    Operator {
        name: "common",
        english: &["COMMON"],
        french: &["COMMUN"],
        summary: words(
            "What is in all of the solids, as a mesh.",
            "Ce qui est dans tous les solides, en maillage.",
        ),
        example: "=COMMON(CUBE(2, 1), TRANSLATE(CUBE(2, 1), (0.5, 0, 0)))",
        see: &["union", "difference"],
        call: call!(floating | a | answer(a, Operation::Common)),
        ..SOLIDS
    },
];

const SOLIDS: Operator = Operator {
    group: Group::Inside,
    help: words(
        "A solid is a closed surface, a list of the patches of one (they are glued where they meet), \
         a volume, a closed mesh, or a list of these: what is inside any of them. Which way round \
         patches are given does not matter. An open shell is an error that tells where. The result is \
         a closed mesh, empty if there is nothing. part = \"volume\" gives its volume, \"error\" by how \
         much the true one may differ, at most, \"distance\" how far a surface may be from its mesh, \
         \"all\" everything.",
        "Un solide est une surface fermée, une liste de ses carreaux (cousus là où ils se touchent), \
         un volume, un maillage fermé, ou une liste de ceux-ci : ce qui est dans l'un d'eux. Le sens \
         des carreaux n'importe pas. Une enveloppe ouverte est une erreur qui dit où. Le résultat est \
         un maillage fermé, vide s'il n'y a rien. partie = \"volume\" donne son volume, \"erreur\" de \
         combien le vrai peut en différer, au plus, \"distance\" à quelle distance une surface peut \
         être de son maillage, \"tout\" l'ensemble.",
    ),
    parameters: &[
        Parameter::new(
            Takes::Solid,
            words("solids", "solides"),
            words("The solids.", "Les solides."),
        )
        .variadic(),
        super::part(
            "mesh",
            &[
                words("mesh", "maillage"),
                words("volume", "volume"),
                words("error", "erreur"),
                words("distance", "distance"),
                words("all", "tout"),
            ],
        ),
        Parameter::new(
            Takes::Number,
            words("accuracy", "précision"),
            words(
                "How far a mesh may be from its surface, in diagonals of the box round the solid.",
                "À quelle distance de sa surface un maillage peut être, en diagonales de la boîte \
                 autour du solide.",
            ),
        )
        .range(1e-5, 0.1)
        .or(Fallback::Ratio(1, 1000)),
    ],
    gives: Takes::Solid,
    source: "catalogue 7; Lalish, Manifold 2020; Barki, Guennebaud and Foufou 2015",
    ..PLAIN
};

fn answer(a: &Bound<f64>, operation: Operation) -> Outcome<f64> {
    let bodies: Vec<Vec<Part>> =
        a.all(0).iter().map(|value| body(a, value)).collect::<Result<_, _>>()?;
    let asked = a.choice(1)?;
    let solid = combine(operation, &bodies, a.number(2)?)?;
    if asked == "mesh" {
        return Ok(solid.mesh.into());
    }
    let entries = vec![
        (words("volume", "volume"), Value::Number(solid.mesh.volume()?)),
        (words("error", "erreur"), Value::Number(solid.volume_error)),
        (words("distance", "distance"), Value::Number(solid.distance)),
        (words("mesh", "maillage"), solid.mesh.into()),
    ];
    if asked == "all" { Ok(Value::Record(entries)) } else { entry(&entries, asked) }
}

/// The parts of a solid: those of the items of a list that is no net of points.
fn body(a: &Bound<f64>, value: &Value) -> Result<Vec<Part>, Failure> {
    match value {
        Value::Mesh(mesh) => Ok(vec![Part::Mesh(mesh.clone())]),
        Value::Form(_) | Value::Spline(_) | Value::Immersed(_) => {
            Ok(vec![Part::Shape(a.shape_of(0, value)?)])
        }
        Value::List(_) if value.is_points() => Ok(vec![Part::Shape(a.shape_of(0, value)?)]),
        Value::List(items) => {
            let mut parts = Vec::new();
            for item in items {
                parts.extend(body(a, item)?);
            }
            Ok(parts)
        }
        _ => Err(a.mistyped(0, value)),
    }
}
