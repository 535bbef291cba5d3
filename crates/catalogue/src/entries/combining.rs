//! Sums of forms with coefficients, of their poles or of their points.

use pforms_kernel::Rational;
use pforms_operators::{self as operators, Poles, Shape};

use super::{Outcome, PLAIN};
use crate::cost::require_combinable;
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value};

const COMBINATION: Operator = Operator { group: Group::Combinations, ..PLAIN };

const POINTWISE: Parameter = Parameter::new(
    Takes::Boolean,
    words("pointwise", "ponctuel"),
    words(
        "Combine the points, not the poles: orders add where weights differ.",
        "Combiner les points et non les pôles : les ordres s'ajoutent quand les poids diffèrent.",
    ),
)
.or(Fallback::Boolean(false));

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "combine",
        english: &["COMBINE"],
        french: &["COMBINE"],
        summary: words(
            "A sum of forms with coefficients.",
            "Une somme de formes affectées de coefficients.",
        ),
        help: words(
            "Homogeneous: coefficients that sum to 1 give points, to 0 directions. Orders are raised, \
             splines brought to common knots. With pointwise the points are combined, exactly, whatever \
             the weights.",
            "Homogène : des coefficients de somme 1 donnent des points, de somme 0 des directions. Les \
             ordres sont élevés, les splines mises sur les mêmes noeuds. Avec ponctuel, ce sont les \
             points qui se combinent, exactement, quels que soient les poids.",
        ),
        parameters: &[
            Parameter::new(
                Takes::List,
                words("k", "k"),
                words("A coefficient for each form.", "Un coefficient par forme."),
            ),
            Parameter::new(
                Takes::Form,
                words("forms", "formes"),
                words("Forms or splines.", "Des formes ou des splines."),
            )
            .variadic(),
            POINTWISE,
        ],
        example: "=COMBINE([2, -1], (0, 0), (1, 2))",
        source: "book 33",
        see: &["midpoint", "symmetric"],
        call: call!(combine),
        ..COMBINATION
    },
    Operator {
        name: "symmetric",
        english: &["SYMMETRIC"],
        french: &["SYMETRIQUE"],
        summary: words(
            "The form symmetric to another with respect to a third.",
            "La forme symétrique d'une autre par rapport à une troisième.",
        ),
        help: words(
            "2·middle - form: every point on the other side of the corresponding one. Where weights \
             differ, poles and points have different symmetries: pointwise takes the points.",
            "2·milieu - forme : chaque point de l'autre côté de celui qui lui répond. Quand les poids \
             diffèrent, pôles et points ont des symétries différentes : ponctuel prend celle des points.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Form,
                words("middle", "milieu"),
                words("What lies half-way.", "Ce qui est à mi-chemin."),
            ),
            Parameter::new(
                Takes::Form,
                words("form", "forme"),
                words("What is taken across.", "Ce qui passe de l'autre côté."),
            ),
            POINTWISE,
        ],
        example: "=SYMMETRIC([(1, 0), (1, 2)], [(0, 0), (0, 1)])",
        source: "book 33",
        see: &["combine", "mirror"],
        call: call!(symmetric),
        ..COMBINATION
    },
];

fn combine<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let k: Vec<S> = a.list(0)?.iter().map(|x| a.number_of(0, x)).collect::<Result<_, _>>()?;
    let shapes: Vec<Shape<S>> =
        a.all(1).iter().map(|value| a.shape_of(1, value)).collect::<Result<_, Failure>>()?;
    let pointwise = a.boolean(2)?;
    require_affordable(&shapes, pointwise)?;
    Ok(Value::from(operators::combine_shapes(&k, &shapes, pointwise)?))
}

fn symmetric<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let (middle, form) = (a.shape(0)?, a.shape(1)?);
    let pointwise = a.boolean(2)?;
    require_affordable(&[middle.clone(), form.clone()], pointwise)?;
    Ok(Value::from(operators::symmetric(&middle, &form, pointwise)?))
}

fn require_affordable<S: Arithmetic>(shapes: &[Shape<S>], pointwise: bool) -> Result<(), Failure> {
    if pointwise {
        require_combinable(&shapes.iter().map(Poles::net).collect::<Vec<_>>())?;
    }
    Ok(())
}
