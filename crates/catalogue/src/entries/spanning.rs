//! Forms spanned by their borders, and by networks of curves.

use pforms_kernel::Rational;
use pforms_operators as operators;
use pforms_operators::{CoonsOptions, Poles, Shape};

use super::{Outcome, PLAIN};
use crate::cost::{multipliable, workable};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Operator, Parameter, Takes};

const COMBINATION: Operator = Operator { group: Group::Combinations, ..PLAIN };

const ACCURACY: Parameter = Parameter::new(
    Takes::Number,
    words("accuracy", "précision"),
    words(
        "The largest gap where they should meet, in sizes of the largest coordinate.",
        "Le plus grand écart là où elles doivent se joindre, en tailles de la plus grande coordonnée.",
    ),
)
.range(0.0, 1.0)
.or_absent("1e-9, and 0 in exact mode", "1e-9, et 0 en mode exact");

pub(super) static ENTRIES: &[Operator] = &[Operator {
    name: "coons",
    english: &["COONS"],
    french: &["COONS"],
    summary: words(
        "The surface that four curves span, the volume of six surfaces, and so on.",
        "La surface que tendent quatre courbes, le volume de six surfaces, et ainsi de suite.",
    ),
    help: words(
        "Faces in pairs, those across the last axis first: COONS(v=0, v=1, u=0, u=1) of curves, \
         COONS(w=0, w=1, v=0, v=1, u=0, u=1) of surfaces. Opposite curves run the same way: the first \
         two along u, the last two along v from the first curve to the second. Orders may differ. The \
         border is kept exactly. Where weights do not agree, points are blended, and orders add up.",
        "Les faces par paires, d'abord celles du dernier axe : COONS(v=0, v=1, u=0, u=1) pour des \
         courbes, COONS(w=0, w=1, v=0, v=1, u=0, u=1) pour des surfaces. Les courbes opposées vont dans \
         le même sens : les deux premières suivant u, les deux autres suivant v, de la première à la \
         deuxième. Les ordres peuvent différer. Le bord est gardé exactement. Si les poids ne \
         s'accordent pas, ce sont les points qu'on combine, et les ordres s'ajoutent.",
    ),
    parameters: &[
        Parameter::new(
            Takes::Form,
            words("faces", "faces"),
            words(
                "Two forms for each axis, which meet at their borders.",
                "Deux formes par axe, qui se joignent à leurs bords.",
            ),
        )
        .variadic(),
        ACCURACY,
        Parameter::new(
            Takes::Boolean,
            words("pointwise", "ponctuel"),
            words(
                "Blend the points, whatever their weights.",
                "Combiner les points, quels que soient leurs poids.",
            ),
        )
        .or(Fallback::Boolean(false)),
    ],
    example: "=COONS([(0, 0, 0), (1, 0, 0)], [(0, 1, 0), (1, 1, 0)], \
              [(0, 0, 0), (0, 1/2, 1), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)])",
    source: "book 332; Coons 1967",
    see: &["stack", "combine"],
    call: call!(coons),
    ..COMBINATION
}];

fn coons<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let mut options = CoonsOptions { pointwise: a.boolean(2)?, ..CoonsOptions::default() };
    if a.is_given(1) {
        options.accuracy = a.number(1)?;
    }
    let shapes = a.all(0).iter().map(|value| a.shape_of(0, value));
    let shapes: Vec<Shape<S>> = shapes.collect::<Result<_, _>>()?;
    for shape in &shapes {
        let net = workable(shape.net().clone())?;
        if options.pointwise {
            multipliable(net)?;
        }
    }
    if shapes.iter().any(|shape| matches!(shape, Shape::Spline(_))) {
        let faces: Vec<_> = shapes.into_iter().map(Shape::into_spline).collect();
        return Ok(operators::coons_splines(&faces.iter().collect::<Vec<_>>(), &options)?.into());
    }
    let faces: Vec<_> = shapes.iter().map(Poles::net).collect();
    Ok(operators::coons(&faces, &options)?.into())
}
