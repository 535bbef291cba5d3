//! Affine and projective maps: one matrix on all homogeneous poles.

use pforms_kernel::{Form, Matrix, Rational};
use pforms_operators::{self as operators, Poles};

use super::{FORM, Outcome, PLAIN};
use crate::operator::{Group, call};
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value};

pub(super) const TRANSFORMATION: Operator = Operator { group: Group::Transformations, ..PLAIN };

/// What moves.
pub(super) const MOVED: Parameter = Parameter {
    takes: Takes::Any,
    help: words(
        "A form, a spline, an immersed form (its host moves), or a list of them.",
        "Une forme, une spline, une forme immergée (c'est son hôte qui bouge), ou une liste.",
    ),
    ..FORM
};

pub(super) const CENTRE: Parameter = Parameter::new(
    Takes::Point,
    words("centre", "centre"),
    words("The point that stays.", "Le point qui ne bouge pas."),
)
.or_absent("the origin", "l'origine");

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "translate",
        english: &["TRANSLATE"],
        french: &["TRANSLATION", "DEPLACE"],
        summary: words("A form moved by a vector.", "Une forme déplacée d'un vecteur."),
        help: words(
            "Every point moves by the same vector; directions (weight 0) stay. Exact.",
            "Chaque point se déplace du même vecteur ; les directions (poids 0) restent. Exact.",
        ),
        parameters: &[
            MOVED,
            Parameter::new(
                Takes::Point,
                words("by", "vecteur"),
                words("The vector.", "Le vecteur."),
            ),
        ],
        example: "=TRANSLATE([(0, 0, 0), (1, 0, 0)], (0, 0, 2))",
        source: "book 231",
        see: &["rotate", "scale", "transform"],
        call: call!(translate),
        ..TRANSFORMATION
    },
    Operator {
        name: "scale",
        english: &["SCALE"],
        french: &["ECHELLE", "HOMOTHETIE"],
        summary: words(
            "A form made larger or smaller about a centre.",
            "Une forme agrandie ou réduite depuis un centre.",
        ),
        help: words(
            "One factor, or one for each coordinate. A negative factor mirrors, 0 flattens, -1 is the \
             symmetry about the centre. Exact.",
            "Un facteur, ou un par coordonnée. Un facteur négatif retourne, 0 aplatit, -1 est la \
             symétrie autour du centre. Exact.",
        ),
        parameters: &[
            MOVED,
            Parameter::new(
                Takes::Any,
                words("factors", "facteurs"),
                words(
                    "A number, or one for each coordinate, as a list or a point.",
                    "Un nombre, ou un par coordonnée, en liste ou en point.",
                ),
            ),
            CENTRE,
        ],
        example: "=SCALE([(0, 0, 0), (1, 2, 3)], (0.5, 1, 0.5))",
        source: "book 231",
        see: &["translate", "mirror", "transform"],
        call: call!(scale),
        ..TRANSFORMATION
    },
    Operator {
        name: "shear",
        english: &["SHEAR"],
        french: &["GLISSEMENT", "CISAILLE"],
        summary: words(
            "A form whose layers slide over one another.",
            "Une forme dont les couches glissent l'une sur l'autre.",
        ),
        help: words(
            "Every point moves by the vector times its given coordinate, counted from the centre. The \
             vector has 0 there, so layers keep their place and volumes stay. Exact.",
            "Chaque point se déplace du vecteur multiplié par sa coordonnée donnée, comptée depuis le \
             centre. Le vecteur y a 0 : les couches restent en place et les volumes aussi. Exact.",
        ),
        parameters: &[
            MOVED,
            Parameter::new(
                Takes::Whole,
                words("coordinate", "coordonnée"),
                words("0 is x, 1 is y, 2 is z.", "0 est x, 1 est y, 2 est z."),
            ),
            Parameter::new(
                Takes::Point,
                words("by", "vecteur"),
                words(
                    "How far a layer slides for each unit of that coordinate.",
                    "De combien glisse une couche par unité de cette coordonnée.",
                ),
            ),
            CENTRE,
        ],
        example: "=SHEAR([(0, 0, 0), (1, 2, 3)], 1, (1/2, 0, 0))",
        source: "book 231",
        see: &["scale", "transform"],
        call: call!(shear),
        ..TRANSFORMATION
    },
    Operator {
        name: "transform",
        english: &["TRANSFORM"],
        french: &["TRANSFORME"],
        summary: words(
            "A form under any affine or projective map, given by its matrix.",
            "Une forme par une application affine ou projective quelconque, donnée par sa matrice.",
        ),
        help: words(
            "The matrix acts on homogeneous coordinates, the weight last: in 3D it has 4 columns. A last \
             row 0, 0, 0, 1 is an affine map, whose translation is the last column. Fewer or more rows \
             lead into another space. Exact.",
            "La matrice agit sur les coordonnées homogènes, le poids en dernier : en 3D elle a 4 \
             colonnes. Une dernière ligne 0, 0, 0, 1 est une application affine, la translation étant \
             la dernière colonne. Moins ou plus de lignes mènent dans un autre espace. Exact.",
        ),
        parameters: &[
            MOVED,
            Parameter::new(
                Takes::List,
                words("matrix", "matrice"),
                words("A list of rows, each a list of numbers.", "Une liste de lignes de nombres."),
            ),
        ],
        example: "=TRANSFORM([(0, 0), (1, 2)], [[0, 1, 0], [1, 0, 0], [0, 0, 1]])",
        source: "book 231",
        see: &["translate", "rotate", "scale", "project_to_plane"],
        call: call!(transform),
        ..TRANSFORMATION
    },
];

fn translate<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let by = a.vector(1)?;
    on_poles(a, &|net| Ok(operators::translate(net, &by)?))
}

fn scale<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    on_poles(a, &|net| {
        let factors = match a.value(1) {
            Value::Number(x) => vec![x; net.ambient()],
            _ => a.vector(1)?,
        };
        Ok(operators::scale(net, &factors, &centre(a, 2, net)?)?)
    })
}

fn shear<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let (coordinate, by) = (a.whole(1)?, a.vector(2)?);
    on_poles(a, &|net| Ok(operators::shear(net, coordinate, &by, &centre(a, 3, net)?)?))
}

fn transform<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let row = |row: &Value<S>| match row {
        Value::List(items) => items.iter().map(|x| a.number_of(1, x)).collect(),
        other => Err(a.mistyped(1, other)),
    };
    let rows: Vec<Vec<S>> = a.list(1)?.iter().map(row).collect::<Result<_, Failure>>()?;
    let matrix = Matrix::from_rows(rows)?;
    on_poles(a, &|net| Ok(operators::transform(net, &matrix)?))
}

/// The point that stays, or the origin of the space that a form lies in.
pub(super) fn centre<S: Arithmetic>(
    a: &Bound<S>,
    index: usize,
    net: &Form<S>,
) -> Result<Vec<S>, Failure> {
    if a.is_given(index) { a.vector(index) } else { Ok(vec![S::zero(); net.ambient()]) }
}

/// What happens to a net of poles.
type Act<'a, S> = dyn Fn(&Form<S>) -> Result<Form<S>, Failure> + 'a;

/// Acts on the poles of the first argument: those of a form or a spline, of the host of an immersed
/// form, of each item of a list.
pub(super) fn on_poles<S: Arithmetic>(a: &Bound<S>, act: &Act<'_, S>) -> Outcome<S> {
    moved(a, &a.value(0), act)
}

fn moved<S: Arithmetic>(a: &Bound<S>, value: &Value<S>, act: &Act<'_, S>) -> Outcome<S> {
    match value {
        Value::Immersed(lazy) => Ok(Value::Immersed(lazy.with_net(act(lazy.net())?)?)),
        Value::List(items) if !items.is_empty() && !value.is_points() => {
            items.iter().map(|item| moved(a, item, act)).collect::<Result<_, _>>().map(Value::list)
        }
        other => {
            let shape = a.shape_of(0, other)?;
            Ok(shape.with_net(act(shape.net())?)?.into())
        }
    }
}
