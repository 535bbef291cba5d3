//! Forms spanned by their borders, and by networks of curves.

use pforms_kernel::{Rational, Traced};
use pforms_operators as operators;
use pforms_operators::{CoonsOptions, Network, Poles, Shape, Spline};

use super::{Outcome, PLAIN, list_of_numbers, part};
use crate::cost::{multipliable, workable};
use crate::operator::{Call, Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value, Words};

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

const NETWORK_PARTS: &[Words] = &[
    words("form", "forme"),
    words("error", "écart"),
    words("gap", "jour"),
    words("u", "u"),
    words("v", "v"),
];

const PLACES: Words = words("where the curves cross, found", "où les courbes se croisent, trouvés");

pub(super) static ENTRIES: &[Operator] = &[COONS, GORDON];

const COONS: Operator = Operator {
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
};

const GORDON: Operator = Operator {
    name: "gordon",
    english: &["GORDON"],
    french: &["GORDON"],
    summary: words(
        "The surface through a network of curves.",
        "La surface passant par un réseau de courbes.",
    ),
    help: words(
        "us run along u and vs along v. Given u, a parameter for each of vs, and v, one for each of us, \
         the surface has every curve exactly. Without them crossings, order and directions are found, \
         and curves that cross at unequal parameters are followed within the accuracy: part = \
         \"error\" says how near, \"gap\" how far curves miss each other. Exact mode asks for u and v.",
        "us suivent u et vs suivent v. Si l'on donne u, un paramètre pour chacune de vs, et v, un pour \
         chacune de us, la surface contient exactement chaque courbe. Sinon croisements, ordre et sens \
         sont trouvés, et les courbes qui se croisent à des paramètres inégaux sont suivies à la \
         précision près : partie = \"écart\" dit de combien, \"jour\" de combien les courbes se \
         manquent. Le mode exact demande u et v.",
    ),
    parameters: &[
        Parameter::new(
            Takes::List,
            words("us", "us"),
            words("The curves along u.", "Les courbes suivant u."),
        ),
        Parameter::new(
            Takes::List,
            words("vs", "vs"),
            words("The curves along v.", "Les courbes suivant v."),
        ),
        Parameter::new(
            Takes::List,
            words("u", "u"),
            words("The parameters of vs, growing.", "Les paramètres de vs, croissants."),
        )
        .or(Fallback::Absent(PLACES)),
        Parameter::new(
            Takes::List,
            words("v", "v"),
            words("The parameters of us, growing.", "Les paramètres de us, croissants."),
        )
        .or(Fallback::Absent(PLACES)),
        Parameter::new(
            Takes::Number,
            words("accuracy", "précision"),
            words(
                "In sizes of the largest coordinate: the largest gap, and how near curves are followed.",
                "En tailles de la plus grande coordonnée : le plus grand jour, et de combien les courbes \
                 suivies peuvent s'écarter.",
            ),
        )
        .range(0.0, 1.0)
        .or_absent("1e-6, and 0 in exact mode", "1e-6, et 0 en mode exact"),
        part("form", NETWORK_PARTS),
    ],
    example: "=GORDON([[(0, 0), (2, 0)], [(0, 1), (2, 2)]], [[(0, 0), (0, 1)], [(2, 0), (2, 2)]], \
              [0, 1], [0, 1])",
    source: "book 332; Gordon 1971; The NURBS Book, 10.5",
    see: &["coons", "stack"],
    call: Call {
        floating: network,
        exact: Some(given::<Rational>),
        traced: Some(given::<Traced>),
    },
    ..COMBINATION
};

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

/// The curves of one family, and whether all are forms.
fn curves<S: Arithmetic>(a: &Bound<S>, index: usize) -> Result<(Vec<Spline<S>>, bool), Failure> {
    let shapes = match a.value(index) {
        Value::List(items) => {
            items.iter().map(|item| a.shape_of(index, item)).collect::<Result<Vec<_>, _>>()?
        }
        // A list of curves of one order has become a surface.
        Value::Form(form) if form.axes() == 2 => {
            operators::unstack(&form)?.into_iter().map(Shape::Form).collect()
        }
        other => return Err(a.mistyped(index, &other)),
    };
    for shape in &shapes {
        workable(shape.net().clone())?;
    }
    let forms = shapes.iter().all(|shape| matches!(shape, Shape::Form(_)));
    Ok((shapes.into_iter().map(Shape::into_spline).collect(), forms))
}

fn places<S: Arithmetic>(a: &Bound<S>, index: usize) -> Result<Vec<S>, Failure> {
    a.list(index)?.iter().map(|item| a.number_of(index, item)).collect()
}

/// The surface; one piece, of forms, is a form.
fn surface<S: Arithmetic>(spline: Spline<S>, forms: bool) -> Value<S> {
    if forms && spline.counts() == [1, 1] {
        return spline.net().clone().into();
    }
    spline.into()
}

fn given<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let ((us, first), (vs, second)) = (curves(a, 0)?, curves(a, 1)?);
    let accuracy = if a.is_given(4) { a.number(4)? } else { S::zero() };
    let (u, v) = (places(a, 2)?, places(a, 3)?);
    let spline = operators::gordon(&us, &vs, &u, &v, &accuracy)?;
    Ok(match a.choice(5)? {
        "u" => list_of_numbers(u),
        "v" => list_of_numbers(v),
        "form" => surface(spline, first && second),
        _ => Value::Number(S::zero()),
    })
}

fn network(a: &Bound<f64>) -> Outcome<f64> {
    let ((us, first), (vs, second)) = (curves(a, 0)?, curves(a, 1)?);
    let accuracy = if a.is_given(4) { a.number(4)? } else { 1e-6 };
    let found = if a.is_given(2) || a.is_given(3) {
        Network::given(&us, &vs, &places(a, 2)?, &places(a, 3)?, accuracy)?
    } else {
        operators::gordon_network(&us, &vs, accuracy)?
    };
    Ok(match a.choice(5)? {
        "error" => Value::Number(found.error),
        "gap" => Value::Number(found.gap),
        "u" => list_of_numbers(found.u),
        "v" => list_of_numbers(found.v),
        _ => surface(found.spline, first && second),
    })
}
