//! How smoothly forms meet, and forms made to meet.

use pforms_operators::{
    self as operators, Continuity, ContinuityOptions, FormEnd, Shape, Smoothness,
};

use super::lists::entry;
use super::splining::SPLINES;
use super::{AXIS, Outcome, PART, list_of_numbers, part};
use crate::operator::call;
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Bound, Failure, Operator, Parameter, Takes, Value, Words};

const F: Parameter =
    Parameter::new(Takes::Form, words("f", "f"), words("The first form.", "La première forme."));

const AT: Parameter = Parameter::new(
    Takes::List,
    words("at", "en"),
    words(
        "Ends that meet: [1, 0] the end of f and the start of g; with axes [axis, end, axis, end].",
        "Les bouts joints : [1, 0] la fin de f et le début de g ; avec axes [axe, bout, axe, bout].",
    ),
)
.or_absent("the end of f and the start of g", "la fin de f et le début de g");

const KINDS: &[Words] = &[words("geometric", "géométrique"), words("parametric", "paramétrique")];

const PARTS: &[Words] = &[
    words("both", "les deux"),
    words("first", "première"),
    words("second", "seconde"),
    words("moved", "déplacement"),
];

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "continuity",
        english: &["CONTINUITY"],
        french: &["RACCORD", "CONTINUITE"],
        summary: words(
            "How smoothly two forms meet, or a spline at its joints: C^k and G^k, with gaps.",
            "La qualité d'un raccord, ou de ceux d'une spline : C^k et G^k, avec les écarts.",
        ),
        help: words(
            "Of one spline: a record for each inner knot, with its parameter t. gaps are the \
             differences of the derivatives of order 0, 1, …; geometric gaps the distance, the angle, \
             the difference of the curvatures. -1 when the forms do not meet. A gap counts as none \
             below accuracy, relative to what is compared.",
            "D'une seule spline : une fiche par noeud intérieur, avec son paramètre t. écarts : les \
             différences des dérivées d'ordre 0, 1, … ; écarts géométriques : la distance, l'angle, la \
             différence des courbures. -1 quand les formes ne se touchent pas. Un écart est nul sous la \
             précision, relative à ce qui est comparé.",
        ),
        parameters: &[
            F,
            Parameter::new(
                Takes::Form,
                words("g", "g"),
                words("The second form.", "La seconde forme."),
            )
            .or_absent("f alone, at its joints", "f seule, à ses raccords"),
            AT,
            Parameter::new(
                Takes::Whole,
                words("order", "ordre"),
                words("The highest order looked at.", "L'ordre le plus haut examiné."),
            )
            .range(0.0, 16.0)
            .or(Fallback::Ratio(2, 1)),
            Parameter::new(
                Takes::Number,
                words("accuracy", "précision"),
                words("Below it a gap counts as none.", "En dessous, un écart compte pour nul."),
            )
            .or(Fallback::Ratio(1, 1_000_000_000)),
            AXIS.or(Fallback::Ratio(0, 1)),
            PART,
        ],
        gives: Takes::Record,
        example: "=CONTINUITY([(0, 0), (1, 0), (2, 1)], [(2, 1), (4, 3), (4, 5)])",
        source: "course 3; book 341",
        see: &["join_forms", "bspline", "curvature"],
        call: call!(floating continuity),
        ..SPLINES
    },
    Operator {
        name: "join_forms",
        english: &["JOINFORMS"],
        french: &["RACCORDER"],
        summary: words(
            "Two forms made to meet smoothly, by moving poles near the joint.",
            "Deux formes raccordées en déplaçant des pôles près de la jonction.",
        ),
        help: words(
            "moving: how many rows of poles of f and of g may move, counted from the joint; they move \
             as little as may be. order 1 makes tangents agree, 2 curvatures; kind \"parametric\" makes \
             the derivatives agree.",
            "mobiles : combien de rangées de pôles de f et de g peuvent bouger, comptées depuis la \
             jonction ; elles bougent le moins possible. ordre 1 accorde les tangentes, 2 les \
             courbures ; genre \"paramétrique\" accorde les dérivées.",
        ),
        parameters: &[
            F,
            Parameter::new(
                Takes::Form,
                words("g", "g"),
                words("The second form.", "La seconde forme."),
            ),
            Parameter::new(
                Takes::Whole,
                words("order", "ordre"),
                words("How smoothly.", "Avec quelle continuité."),
            )
            .range(0.0, 16.0)
            .or(Fallback::Ratio(1, 1)),
            Parameter::new(
                Takes::Text,
                words("kind", "genre"),
                words("What is to agree.", "Ce qui doit s'accorder."),
            )
            .choices(KINDS)
            .or(Fallback::Text("geometric")),
            Parameter::new(
                Takes::Wholes,
                words("moving", "mobiles"),
                words("Rows of poles that may move.", "Les rangées de pôles mobiles."),
            )
            .or_absent("order + 1 on either side", "ordre + 1 de chaque côté"),
            AT,
            part("both", PARTS),
        ],
        gives: Takes::List,
        example: "=JOINFORMS([(0, 0), (1, 1), (2, 1)], [(2, 1), (3, 2), (4, 0)])",
        source: "course 3",
        see: &["continuity", "with_pole"],
        call: call!(floating join_forms),
        ..SPLINES
    },
];

fn continuity(a: &Bound<f64>) -> Outcome<f64> {
    let f = a.shape(0)?;
    let options = ContinuityOptions { order: a.whole(3)?, accuracy: a.number(4)? };
    let chosen = |entries: Vec<(Words, Value)>| -> Outcome<f64> {
        if a.is_given(6) { entry(&entries, &a.text(6)?) } else { Ok(Value::Record(entries)) }
    };
    if a.is_given(1) {
        let joint = operators::continuity(&f, &a.shape(1)?, ends(a, 2)?, options)?;
        return chosen(entries(&joint));
    }
    let joints = operators::joints(&f.into_spline(), a.whole(5)?, options)?;
    let records = joints.iter().map(|(t, joint)| {
        let mut all = vec![(words("t", "t"), Value::Number(*t))];
        all.extend(entries(joint));
        chosen(all)
    });
    Ok(Value::list(records.collect::<Result<_, _>>()?))
}

fn entries(joint: &Continuity) -> Vec<(Words, Value)> {
    let order = |order: Option<usize>| Value::Number(order.map_or(-1.0, |order| order as f64));
    vec![
        (words("parametric", "paramétrique"), order(joint.parametric)),
        (words("geometric", "géométrique"), order(joint.geometric)),
        (words("gaps", "écarts"), list_of_numbers(joint.parametric_gaps.iter().copied())),
        (
            words("geometric gaps", "écarts géométriques"),
            list_of_numbers(joint.geometric_gaps.iter().copied()),
        ),
    ]
}

/// Ends of axes: `[end, end]` of axis 0, or `[axis, end, axis, end]`.
fn ends(a: &Bound<f64>, index: usize) -> Result<[FormEnd; 2], Failure> {
    if !a.is_given(index) {
        return Ok([FormEnd::end(0), FormEnd::start(0)]);
    }
    let end = |axis: f64, end: f64| match (axis, end) {
        (axis, 0.0) if axis >= 0.0 && axis.fract() == 0.0 => Some(FormEnd::start(axis as usize)),
        (axis, 1.0) if axis >= 0.0 && axis.fract() == 0.0 => Some(FormEnd::end(axis as usize)),
        _ => None,
    };
    let both = match a.flat_numbers(index)?[..] {
        [f, g] => end(0.0, f).zip(end(0.0, g)),
        [f_axis, f, g_axis, g] => end(f_axis, f).zip(end(g_axis, g)),
        _ => None,
    };
    let expected = words(
        "two ends, 0 or 1, or an axis before each",
        "deux bouts, 0 ou 1, ou un axe devant chacun",
    );
    let [f, g] = both.ok_or_else(|| a.refused(index, &a.value(index), expected))?.into();
    Ok([f, g])
}

fn join_forms(a: &Bound<f64>) -> Outcome<f64> {
    let (f, g, order) = (a.shape(0)?, a.shape(1)?, a.whole(2)?);
    let smoothness = match a.choice(3)? {
        "parametric" => Smoothness::Parametric(order),
        _ => Smoothness::Geometric(order),
    };
    let moving = if a.is_given(4) {
        let rows = a.wholes(4, 2)?;
        [rows[0], rows[1]]
    } else {
        let most = |shape: &Shape, end: FormEnd| {
            let knots = shape.clone().into_spline().knots().get(end.axis).cloned();
            knots.map_or(0, |knots| knots.degree() + 1).min(order + 1)
        };
        let at = ends(a, 5)?;
        [most(&f, at[0]), most(&g, at[1])]
    };
    let wanted = a.choice(6)?;
    let joined = operators::join_forms(&f, &g, ends(a, 5)?, smoothness, moving)?;
    Ok(match wanted {
        "first" => joined.f.into(),
        "second" => joined.g.into(),
        "moved" => Value::Number(joined.moved),
        _ => Value::list(vec![joined.f.into(), joined.g.into()]),
    })
}
