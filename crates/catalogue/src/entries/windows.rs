//! The same form otherwise: other windows, other orders, other axes.

use pforms_kernel::{Form, Rational};
use pforms_operators::{self as operators, Poles, Shape};

use super::{AXIS, FORM, Outcome, PLAIN, T, list_of_forms, of_either, part};
use crate::arithmetic::require_plain;
use crate::cost::{workable, workable_at, workable_shape, workable_spline};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value};

const FUNDAMENTAL: Operator = Operator { group: Group::Fundamental, ..PLAIN };

const BY: Parameter = Parameter::new(
    Takes::Wholes,
    words("by", "de"),
    words("By how many poles along each axis.", "De combien de pôles le long de chaque axe."),
)
.variadic()
.range(0.0, 1024.0)
.or(Fallback::Ratio(1, 1));

const fn end(
    en: &'static str,
    fr: &'static str,
    help_en: &'static str,
    help_fr: &'static str,
) -> Parameter {
    Parameter::new(Takes::Numbers, words(en, fr), words(help_en, help_fr))
        .unit("parameter", "paramètre")
}

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "subdivide",
        english: &["SUBDIVIDE"],
        french: &["SUBDIVISION", "SUBDIVISE"],
        summary: words(
            "The form cut into 2^r pieces along each axis, with their control net.",
            "La forme coupée en 2^r morceaux le long de chaque axe, avec leur réseau de pôles.",
        ),
        help: words(
            "The pieces are the form; their poles approach it quickly. NET takes the refined net, of \
             order (n-1)·2^r + 1 along each axis, PIECE one of the pieces.",
            "Les morceaux sont la forme ; leurs pôles s'en approchent vite. RESEAU prend le réseau \
             raffiné, d'ordre (n-1)·2^r + 1 le long de chaque axe, MORCEAU l'un des morceaux.",
        ),
        parameters: &[
            FORM,
            Parameter::new(
                Takes::Wholes,
                words("r", "r"),
                words("How often each axis is halved.", "Nombre de dichotomies de chaque axe."),
            )
            .variadic()
            .range(0.0, 40.0)
            .or(Fallback::Ratio(1, 1)),
        ],
        example: "=SUBDIVIDE([(0, 0), (1, 2), (2, 0)], 2)",
        source: "book 211",
        see: &["split", "net", "piece"],
        call: call!(subdivide),
        ..FUNDAMENTAL
    },
    Operator {
        name: "split",
        english: &["SPLIT"],
        french: &["DECOUPE"],
        summary: words(
            "The two parts of a form at a parameter.",
            "Les deux parties d'une forme en un paramètre.",
        ),
        help: words(
            "A list of two forms: the windows [0, t] and [t, 1] of the axis. They share their poles \
             at the cut to the bit. The parts of a spline keep their parameters.",
            "Une liste de deux formes : les fenêtres [0, t] et [t, 1] de l'axe. Leurs pôles à la \
             coupure sont les mêmes, au bit près. Les parties d'une spline gardent leurs paramètres.",
        ),
        parameters: &[FORM, AXIS, T],
        gives: Takes::List,
        example: "=SPLIT([(0, 0), (1, 2), (2, 0)], 0, 1/3)",
        source: "book 211; course, de Casteljau",
        see: &["stretch", "subdivide", "item"],
        call: call!(split),
        ..FUNDAMENTAL
    },
    Operator {
        name: "elevate",
        english: &["ELEVATE"],
        french: &["ELEVATION", "ELEVE"],
        summary: words("The same form with more poles.", "La même forme avec plus de pôles."),
        help: words(
            "The points do not change. Exact, any number of axes.",
            "Les points ne changent pas. Exact, quel que soit le nombre d'axes.",
        ),
        parameters: &[FORM, BY],
        example: "=ELEVATE([(0, 0), (1, 2), (2, 0)], 1)",
        source: "book 212; course, élévation",
        see: &["reduce"],
        call: call!(elevate),
        ..FUNDAMENTAL
    },
    Operator {
        name: "reduce",
        english: &["REDUCE"],
        french: &["REDUCTION", "REDUIT"],
        summary: words(
            "The best form with fewer poles, and how far off it can be.",
            "La meilleure forme avec moins de pôles, et l'écart qu'elle peut avoir.",
        ),
        help: words(
            "Best in the mean square of the poles; exact when the form was an elevated one. \
             part = \"bound\" gives a distance that no point of the window exceeds.",
            "La meilleure en moyenne quadratique ; exacte quand la forme avait été élevée. \
             partie = \"borne\" donne une distance qu'aucun point de la fenêtre ne dépasse.",
        ),
        parameters: &[
            FORM,
            Parameter { variadic: false, ..BY },
            part("form", &[words("form", "forme"), words("bound", "borne")]),
        ],
        example: "=REDUCE([(0, 0), (1, 2), (2, 2), (3, 0)], 1)",
        source: "book 212",
        see: &["elevate", "fit"],
        call: call!(reduce),
        ..FUNDAMENTAL
    },
    Operator {
        name: "stretch",
        english: &["STRETCH"],
        french: &["ETIRE", "ETIREMENT"],
        summary: words(
            "The form over another window: a part of it, or more of it.",
            "La forme sur une autre fenêtre : une partie, ou son prolongement.",
        ),
        help: words(
            "From a to b along each axis, any reals; a above b reverses. Give one number for all \
             axes or a list with one for each.",
            "De a à b le long de chaque axe, réels quelconques ; a supérieur à b renverse. Donner un \
             nombre pour tous les axes ou une liste d'un nombre par axe.",
        ),
        parameters: &[
            FORM,
            end("a", "a", "Where the new window begins.", "Début de la nouvelle fenêtre."),
            end("b", "b", "Where the new window ends.", "Fin de la nouvelle fenêtre."),
        ],
        example: "=STRETCH([(0, 0), (1, 2), (2, 0)], -1, 3/2)",
        source: "book 213",
        see: &["split", "reparametrise", "whole_line"],
        call: call!(stretch),
        ..FUNDAMENTAL
    },
    Operator {
        name: "reparametrise",
        english: &["MOBIUS"],
        french: &["MOBIUS"],
        summary: words(
            "A projective change of parameter: same points, same ends, other weights.",
            "Un changement projectif de paramètre : mêmes points, mêmes bouts, autres poids.",
        ),
        help: words(
            "The parameter becomes c·s / (1 - s + c·s). A negative c runs through infinity: the \
             complementary arc of a conic. WHOLELINE gives the whole of it.",
            "Le paramètre devient c·s / (1 - s + c·s). Un c négatif passe par l'infini : l'arc \
             complémentaire d'une conique. DROITEENTIERE la donne tout entière.",
        ),
        parameters: &[
            FORM,
            AXIS,
            Parameter::new(
                Takes::Number,
                words("c", "c"),
                words("The factor of the weights, not 0.", "Le facteur des poids, non nul."),
            ),
        ],
        example: "=MOBIUS([(1, 0), (1, 1; 1/2), (0, 1)], 0, 2)",
        source: "book 311",
        see: &["whole_line", "stretch"],
        call: call!(reparametrise),
        ..FUNDAMENTAL
    },
    Operator {
        name: "whole_line",
        english: &["WHOLELINE"],
        french: &["DROITEENTIERE"],
        summary: words(
            "The form over its whole parameter line, infinity included, as three forms.",
            "La forme sur toute la droite du paramètre, infini compris, en trois formes.",
        ),
        help: words(
            "The windows [-∞, 0], [0, 1] and [1, +∞]: a quarter of a circle gives the full circle.",
            "Les fenêtres [-∞, 0], [0, 1] et [1, +∞] : un quart de cercle donne le cercle entier.",
        ),
        parameters: &[FORM, AXIS.or(Fallback::Ratio(0, 1))],
        gives: Takes::List,
        example: "=WHOLELINE([(1, 0), (1, 1; 1/2), (0, 1)])",
        source: "book 311",
        see: &["reparametrise", "stretch"],
        call: call!(whole_line),
        ..FUNDAMENTAL
    },
    Operator {
        name: "reverse",
        english: &["REVERSE"],
        french: &["RENVERSE", "INVERSE"],
        summary: words(
            "The form run backwards along an axis.",
            "La forme parcourue à rebours le long d'un axe.",
        ),
        help: words("t becomes 1 - t. Exact.", "t devient 1 - t. Exact."),
        parameters: &[FORM, AXIS.or(Fallback::Ratio(0, 1))],
        example: "=REVERSE([(0, 0), (1, 2), (2, 0)])",
        source: "book 214",
        see: &["transpose", "stretch"],
        call: call!(reverse),
        ..FUNDAMENTAL
    },
    Operator {
        name: "transpose",
        english: &["TRANSPOSE", "PERMUTE"],
        french: &["TRANSPOSE", "PERMUTE"],
        summary: words(
            "The form with its axes in another order.",
            "La forme, ses axes dans un autre ordre.",
        ),
        help: words(
            "Axis k of the result is the k-th of the given axes. Without axes their order is turned \
             round: rows become columns.",
            "L'axe k du résultat est le k-ième des axes donnés. Sans axes, leur ordre est inversé : \
             les lignes deviennent des colonnes.",
        ),
        parameters: &[
            FORM,
            Parameter::new(
                Takes::Whole,
                words("axes", "axes"),
                words("Each axis once.", "Chaque axe une fois."),
            )
            .variadic()
            .or_absent("the reverse order", "l'ordre inverse"),
        ],
        example: "=TRANSPOSE([[(0, 0), (1, 0), (2, 0)], [(0, 1), (1, 1), (2, 1)]])",
        source: "book 214",
        see: &["reverse"],
        call: call!(transpose),
        ..FUNDAMENTAL
    },
    Operator {
        name: "sub",
        english: &["SUB", "SUBFORM"],
        french: &["SOUSFORME"],
        summary: words(
            "The sub-form where a parameter is fixed: a surface gives a curve.",
            "La sous-forme où un paramètre est fixé : une surface donne une courbe.",
        ),
        help: words(
            "One axis less, same space, exact. Of a curve, the point with its weight.",
            "Un axe de moins, même espace, exact. D'une courbe, le point avec son poids.",
        ),
        parameters: &[FORM, AXIS, T],
        example: "=SUB([[(0, 0, 0), (1, 0, 1)], [(0, 1, 1), (1, 1, 0)]], 0, 1/2)",
        source: "book 2141",
        see: &["evaluate", "stack"],
        call: call!(sub),
        ..FUNDAMENTAL
    },
];

fn subdivide<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let shape = workable_shape(a.shape(0)?)?;
    let r: Vec<u32> = a.wholes(1, shape.net().axes())?.iter().map(|&r| r as u32).collect();
    Ok(match shape {
        Shape::Form(form) => operators::subdivide(&form, &r)?.into(),
        Shape::Spline(spline) => spline.subdivide(&r)?.into(),
    })
}

fn split<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let (axis, t) = (a.whole(1)?, a.number(2)?);
    Ok(match a.shape(0)? {
        Shape::Form(form) => {
            let form = workable_at(form, std::slice::from_ref(&t))?;
            let (low, high) = operators::split(&form, axis, &t)?;
            list_of_forms(vec![low, high])
        }
        Shape::Spline(spline) => {
            let (low, high) = workable_spline(spline)?.split(axis, &t)?;
            Value::list(vec![low.into(), high.into()])
        }
    })
}

fn elevate<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    of_either(
        a,
        |form| {
            let form = workable(form)?;
            Ok(operators::elevate(&form, &a.wholes(1, form.axes())?)?)
        },
        |spline| Ok(spline.elevate(&a.wholes(1, spline.axes())?)?),
    )
}

fn reduce<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let form = workable(a.form(0)?)?;
    let wanted = a.choice(2)?;
    let reduction = operators::reduce(&form, &a.wholes(1, form.axes())?)?;
    if wanted == "form" {
        return Ok(reduction.form.into());
    }
    require_plain(form.homogeneous())?;
    let bound = S::from_f64(reduction.bound).unwrap_or_else(S::zero);
    Ok(Value::Number(bound))
}

fn stretch<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let ends = |axes| Ok::<_, Failure>((a.numbers(1, axes)?, a.numbers(2, axes)?));
    of_either(
        a,
        |form| {
            let (from, to) = ends(form.axes())?;
            let form = workable_at(workable_at(form, &from)?, &to)?;
            Ok(operators::stretch(&form, &from, &to)?)
        },
        |spline| {
            let (from, to) = ends(spline.axes())?;
            Ok(spline.stretch(&from, &to)?)
        },
    )
}

fn reparametrise<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let c = a.number(2)?;
    let form = workable_at(a.form(0)?, std::slice::from_ref(&c))?;
    Ok(operators::reparametrise(&form, a.whole(1)?, &c)?.into())
}

fn whole_line<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(list_of_forms(operators::whole_line(&workable(a.form(0)?)?, a.whole(1)?)?))
}

fn reverse<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let axis = a.whole(1)?;
    let form = |form| Ok(operators::reverse(&workable(form)?, axis)?);
    of_either(a, form, |spline| Ok(spline.reverse(axis)?))
}

fn transpose<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let order = |axes: usize| -> Result<Vec<usize>, Failure> {
        if a.is_given(1) {
            a.all(1).iter().map(|axis| a.whole_of(1, axis)).collect()
        } else {
            Ok((0..axes).rev().collect())
        }
    };
    let form = |form: Form<S>| Ok(operators::transpose(&form, &order(form.axes())?)?);
    of_either(a, form, |spline| Ok(spline.transpose(&order(spline.axes())?)?))
}

fn sub<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let (axis, t) = (a.whole(1)?, a.number(2)?);
    let form = |form| Ok(operators::sub(&workable_at(form, std::slice::from_ref(&t))?, axis, &t)?);
    of_either(a, form, |spline| Ok(spline.sub(axis, &t)?))
}
