//! Splines from poles, from knots, from pieces.

use pforms_kernel::{Error, Form, Rational};
use pforms_operators::{self as operators, KnotRule, Spline};

use super::{AXIS, Outcome, PLAIN};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value, Words};

pub(super) const SPLINES: Operator = Operator { group: Group::Splines, ..PLAIN };

const KNOTS: &[Words] = &[words("uniform", "uniforme"), words("clamped", "accrochés")];

pub(super) const CLOSED: Parameter = Parameter::new(
    Takes::Any,
    words("closed", "fermée"),
    words("TRUE to go round; or one truth for each axis.", "VRAI pour fermer ; ou un par axe."),
)
.or(Fallback::Boolean(false));

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "bspline",
        english: &["BSPLINE"],
        french: &["BSPLINE"],
        summary: words(
            "The B-spline of a net: a window of degree + 1 poles that slides along.",
            "La B-spline d'un réseau : une fenêtre de degré + 1 pôles qui glisse.",
        ),
        help: words(
            "Any degree, any number of axes. knots: \"uniform\" as in the book, each piece one unit of \
             the parameter; \"clamped\" to begin and end in the first and last pole; or a full list \
             (poles + degree + 1; for a closed axis one turn, poles + 1), or one for each axis.",
            "De tout degré, sur tout nombre d'axes. noeuds : \"uniforme\" comme dans le livre, chaque \
             morceau valant une unité du paramètre ; \"accrochés\" pour partir du premier pôle et \
             finir au dernier ; ou une liste complète (pôles + degré + 1 ; un tour, pôles + 1, si \
             l'axe est fermé), ou une par axe.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Form,
                words("points", "points"),
                words("A row or a net of poles.", "Une rangée ou un réseau de pôles."),
            ),
            Parameter::new(
                Takes::Wholes,
                words("degree", "degré"),
                words("The degree of the pieces.", "Le degré des morceaux."),
            )
            .range(0.0, 255.0)
            .or(Fallback::Ratio(3, 1)),
            Parameter::new(
                Takes::Any,
                words("knots", "noeuds"),
                words("Where the pieces meet.", "Où les morceaux se rejoignent."),
            )
            .choices(KNOTS)
            .or(Fallback::Text("uniform")),
            CLOSED,
        ],
        example: "=BSPLINE([(0, 0), (0, 2), (2, 2), (2, 0)], 2)",
        source: "book 341",
        see: &["nurbs", "interpolating_spline", "pieces"],
        call: call!(bspline),
        ..SPLINES
    },
    Operator {
        name: "nurbs",
        english: &["NURBS"],
        french: &["NURBS"],
        summary: words(
            "The rational B-spline of poles, weights and full knot vectors.",
            "La B-spline rationnelle de pôles, poids et vecteurs de noeuds complets.",
        ),
        help: words(
            "The knots say the degree: n poles and m knots make degree m - n - 1. weights: a number for \
             each pole, in order, or a factor for all. PIECES takes it apart, CONCATENATE and REMOVEKNOTS \
             put it together again, exactly.",
            "Les noeuds disent le degré : n pôles et m noeuds font le degré m - n - 1. poids : un par \
             pôle, dans l'ordre, ou un facteur pour tous. MORCEAUX la démonte, CONCATENE et RETIRENOEUDS \
             la remontent, exactement.",
        ),
        parameters: &[
            Parameter::new(
                Takes::Form,
                words("poles", "pôles"),
                words("A row or a net of poles.", "Une rangée ou un réseau de pôles."),
            ),
            Parameter::new(
                Takes::Any,
                words("weights", "poids"),
                words("One for each pole, or a factor for all.", "Un par pôle, ou un facteur."),
            ),
            Parameter::new(
                Takes::List,
                words("knots", "noeuds"),
                words(
                    "A full list; a list of lists for several axes.",
                    "Une liste complète ; une liste de listes pour plusieurs axes.",
                ),
            ),
        ],
        example: "=NURBS([(1, 0), (1, 1), (0, 1)], [1, 1/2, 1], [0, 0, 0, 1, 1, 1])",
        source: "book 343; The NURBS Book, chapter 4",
        see: &["bspline", "pieces", "remove_knots"],
        call: call!(nurbs),
        ..SPLINES
    },
    Operator {
        name: "concatenate",
        english: &["CONCATENATE"],
        french: &["CONCATENE"],
        summary: words(
            "Forms end to end along an axis, as one spline.",
            "Des formes bout à bout le long d'un axe, en une spline.",
        ),
        help: words(
            "Degrees that differ are raised. Where the end of a form is the start of the next they \
             share its poles, the weights of the next being scaled to agree; elsewhere the spline has a \
             gap. breaks says where each begins; 0, 1, 2, … if it is not given.",
            "Les degrés sont d'abord élevés au plus grand. Là où la fin d'une forme est le début de la \
             suivante, elles partagent leurs pôles, les poids de la suivante étant mis à l'échelle ; \
             ailleurs la spline a une lacune. jonctions dit où chacune commence ; 0, 1, 2, … sinon.",
        ),
        parameters: &[
            Parameter::new(
                Takes::List,
                words("forms", "formes"),
                words("The forms, in order.", "Les formes, dans l'ordre."),
            ),
            AXIS.or(Fallback::Ratio(0, 1)),
            Parameter::new(
                Takes::List,
                words("breaks", "jonctions"),
                words("The parameters where they meet.", "Les paramètres où elles se joignent."),
            )
            .or_absent("whole numbers from 0", "les entiers à partir de 0"),
        ],
        example: "=CONCATENATE(PIECES(SUBDIVIDE([(0, 0), (1, 2), (2, 0)], 1)))",
        source: "book 34",
        see: &["pieces", "remove_knots", "continuity"],
        call: call!(concatenate),
        ..SPLINES
    },
];

fn bspline<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let net = a.form(0)?;
    let axes = net.axes();
    let degrees = a.wholes(1, axes)?;
    let closed = truths(a, 3, axes)?;
    Ok(operators::bspline(&net, &degrees, &rules(a, 2, axes)?, &closed)?.into())
}

/// A rule for the knots of each axis: a word, a list of numbers, or one of these for each axis.
fn rules<S: Arithmetic>(
    a: &Bound<S>,
    index: usize,
    axes: usize,
) -> Result<Vec<KnotRule<S>>, Failure> {
    let one = |value: &Value<S>| match value {
        Value::List(items) => {
            let numbers = items.iter().map(|item| a.number_of(index, item));
            Ok(KnotRule::Given(numbers.collect::<Result<_, _>>()?))
        }
        other => Ok(match a.choice_of(index, other)? {
            "clamped" => KnotRule::Clamped,
            _ => KnotRule::Uniform,
        }),
    };
    per_axis(a, index, axes, |value| !matches!(value, Value::Number(_)), one)
}

/// A truth for each axis.
pub(super) fn truths<S: Arithmetic>(
    a: &Bound<S>,
    index: usize,
    axes: usize,
) -> Result<Vec<bool>, Failure> {
    let one = |value: &Value<S>| match value {
        Value::Boolean(truth) => Ok(*truth),
        other => Err(a.mistyped(index, other)),
    };
    per_axis(a, index, axes, |_| true, one)
}

/// One value for all axes, or a list with one for each: a list whose items are `apart`.
pub(super) fn per_axis<S: Arithmetic, T: Clone>(
    a: &Bound<S>,
    index: usize,
    axes: usize,
    apart: impl Fn(&Value<S>) -> bool,
    one: impl Fn(&Value<S>) -> Result<T, Failure>,
) -> Result<Vec<T>, Failure> {
    match a.value(index) {
        Value::List(items) if items.iter().all(apart) => {
            if items.len() == axes {
                return items.iter().map(one).collect();
            }
            let expected = format!("{axes}, one for each axis");
            Err(Error::shape(a.name(index), format!("{} values", items.len()), expected).into())
        }
        value => Ok(vec![one(&value)?; axes]),
    }
}

fn nurbs<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let net = a.form(0)?;
    let net = match a.value(1) {
        // One factor for all: the weights that the points bring stay in proportion.
        Value::Number(weight) => net.map_scalar(|x| x.clone() * weight.clone())?,
        Value::List(_) => {
            let weights = a.flat_numbers(1)?;
            Form::from_points(net.orders(), net.ambient(), &net.points()?, Some(&weights))?
        }
        other => return Err(a.mistyped(1, &other)),
    };
    let lists = a.list(2)?;
    let numbers = |items: &[Value<S>]| -> Result<Vec<S>, Failure> {
        items.iter().map(|item| a.number_of(2, item)).collect()
    };
    let knots = if lists.iter().all(|item| matches!(item, Value::List(_))) {
        let one = |item: &Value<S>| match item {
            Value::List(items) => numbers(items),
            other => Err(a.mistyped(2, other)),
        };
        lists.iter().map(one).collect::<Result<_, _>>()?
    } else {
        vec![numbers(&lists)?]
    };
    Ok(operators::nurbs(net, knots)?.into())
}

fn concatenate<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let items = a.list(0)?;
    let forms = items.iter().map(|item| a.form_of(0, item)).collect::<Result<Vec<_>, _>>()?;
    let breaks = if a.is_given(2) {
        a.flat_numbers(2)?
    } else {
        (0..=forms.len() as i64).map(S::from_integer).collect()
    };
    Ok(Spline::end_to_end(&forms, a.whole(1)?, &breaks)?.into())
}
