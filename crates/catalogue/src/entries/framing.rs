//! Frames and curvatures, and the tangents and normals that are forms.

use pforms_kernel::Rational;
use pforms_operators as operators;
use pforms_operators::{
    Curvature, CurveFrame, FrameKind, Poles, Shape, Spline, SurfaceCurvature, SurfaceFrame,
    VolumeFrame,
};

use super::lists::entry;
use super::{AXIS, FORM, Outcome, PART, PLAIN, list_of_numbers, of_either};
use crate::cost::{multipliable, workable_shape};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value, Words};

const FUNDAMENTAL: Operator = Operator { group: Group::Fundamental, ..PLAIN };

const KINDS: &[Words] = &[
    words("frenet", "frenet"),
    words("rotation-minimising", "rotation minimale"),
    words("tangent", "tangente"),
];

const PARAMETERS: Parameter = Parameter::new(
    Takes::Number,
    words("parameters", "paramètres"),
    words("One for each axis.", "Un par axe."),
)
.variadic()
.unit("parameter", "paramètre");

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "frame",
        english: &["FRAME"],
        french: &["REPERE"],
        summary: words(
            "Tangents, normals and curvatures at a point of a form.",
            "Tangentes, normales et courbures en un point d'une forme.",
        ),
        help: words(
            "A record. Of a curve: point, tangent, normal, binormal, curvature, torsion, speed. Of a \
             surface: point, tu, tv, normal, gauss, mean, principal, first, second, area. \
             Of a volume: point, tu, tv, tw, \
             jacobian. part = \"normal\" takes one entry; vectors are \
             directions, so p + 0.3*n moves the point p along the normal n.",
            "Une fiche. D'une courbe : point, tangente, normale, binormale, courbure, torsion, vitesse. \
             D'une surface : point, tu, tv, normale, gauss, moyenne, principales, \
             première, seconde, aire. D'un volume : point, tu, tv, tw, \
             jacobien. partie = \"normale\" \
             en prend une entrée ; les vecteurs sont des directions : p + 0.3*n déplace le point p le \
             long de la normale n.",
        ),
        parameters: &[
            FORM,
            PARAMETERS,
            Parameter::new(
                Takes::Text,
                words("kind", "genre"),
                words("Which normals a curve has.", "Quelles normales a une courbe."),
            )
            .choices(KINDS)
            .or(Fallback::Text("frenet")),
            Parameter::new(
                Takes::Boolean,
                words("unit", "unitaire"),
                words(
                    "Vectors of length 1, or of their natural length.",
                    "Vecteurs de longueur 1, ou de leur longueur naturelle.",
                ),
            )
            .or(Fallback::Boolean(true)),
            PART,
            Parameter::new(
                Takes::Number,
                words("accuracy", "précision"),
                words(
                    "The angle by which a rotation-minimising normal may be off.",
                    "L'angle dont une normale à rotation minimale peut être fausse.",
                ),
            )
            .unit("radian", "radian")
            .range(0.0, 1.0)
            .or(Fallback::Ratio(1, 100_000_000)),
        ],
        gives: Takes::Record,
        example: "=FRAME([(0, 0, 0), (1, 2, 0), (2, 0, 1)], 1/2)",
        source: "book 2143; book 21431 for the flip at inflections",
        see: &["curvature", "tangent_form", "normal_form", "item"],
        call: call!(floating frame),
        ..FUNDAMENTAL
    },
    Operator {
        name: "curvature",
        english: &["CURVATURE"],
        french: &["COURBURE"],
        summary: words(
            "How a curve or a surface bends at a point.",
            "Comment une courbe ou une surface se courbe en un point.",
        ),
        help: words(
            "Of a curve the curvature (signed in the plane); part = \"torsion\" gives the torsion. Of a \
             surface in space a record: gauss, mean, principal.",
            "D'une courbe, la courbure (signée dans le plan) ; partie = \"torsion\" donne la torsion. \
             D'une surface de l'espace, une fiche : gauss, moyenne, principales.",
        ),
        parameters: &[FORM, PARAMETERS, PART],
        gives: Takes::Any,
        example: "=CURVATURE([(0, 0), (1, 0), (2, 2)], 0)",
        source: "book 2143; do Carmo, Differential Geometry",
        see: &["frame"],
        call: call!(floating curvature),
        ..FUNDAMENTAL
    },
    Operator {
        name: "tangent_form",
        english: &["TANGENT"],
        french: &["TANGENTE"],
        summary: words(
            "The tangent as a form of vectors, not of unit length.",
            "La tangente en tant que forme de vecteurs, non unitaires.",
        ),
        help: words(
            "Exact, polynomial even for a rational form: the derivative times the square of the weight.",
            "Exacte, polynomiale même pour une forme rationnelle : la dérivée fois le carré du poids.",
        ),
        parameters: &[FORM, AXIS.or(Fallback::Ratio(0, 1))],
        example: "=TANGENT([(1, 0), (1, 1; 1/2), (0, 1)])",
        source: "book 326",
        see: &["hodograph", "normal_form", "frame"],
        call: call!(tangent),
        ..FUNDAMENTAL
    },
    Operator {
        name: "normal_form",
        english: &["NORMAL"],
        french: &["NORMALE"],
        summary: words(
            "The normal as a form of vectors, not of unit length.",
            "La normale en tant que forme de vecteurs, non unitaires.",
        ),
        help: words(
            "Of a surface in space, of a curve in the plane (the tangent turned left) or in space (the \
             principal normal). Exact.",
            "D'une surface de l'espace, d'une courbe du plan (la tangente tournée à gauche) ou de \
             l'espace (la normale principale). Exacte.",
        ),
        parameters: &[FORM],
        example: "=NORMAL([[(0, 0, 0), (1, 0, 1)], [(0, 1, 1), (1, 1, 0)]])",
        source: "book 326",
        see: &["tangent_form", "binormal_form", "frame"],
        call: call!(normal),
        ..FUNDAMENTAL
    },
    Operator {
        name: "binormal_form",
        english: &["BINORMAL"],
        french: &["BINORMALE"],
        summary: words(
            "The binormal of a curve in space as a form of vectors.",
            "La binormale d'une courbe de l'espace en tant que forme de vecteurs.",
        ),
        help: words(
            "Exact; zero where the curve is straight.",
            "Exacte ; nulle là où la courbe est droite.",
        ),
        parameters: &[FORM],
        example: "=BINORMAL([(0, 0, 0), (1, 2, 0), (2, 0, 1)])",
        source: "book 326",
        see: &["tangent_form", "normal_form", "frame"],
        call: call!(binormal),
        ..FUNDAMENTAL
    },
];

type Entries = Vec<(Words, Value)>;

fn frame(a: &Bound<f64>) -> Outcome<f64> {
    let shape = workable_shape(a.shape(0)?)?;
    let at = parameters(a)?;
    let unit = a.boolean(3)?;
    let entries = match (shape.net().axes(), at.as_slice()) {
        (1, _) => of_curve(a, &shape, &at, unit)?,
        (2, [u, v]) => {
            let frame = match &shape {
                Shape::Form(form) => operators::surface_frame(form, *u, *v)?,
                Shape::Spline(spline) => spline.surface_frame(*u, *v)?,
            };
            of_surface(&if unit { frame } else { frame.unnormalised() })
        }
        _ => {
            shape.net().require_per_axis("parameters", &at)?;
            let frame = match &shape {
                Shape::Form(form) => operators::volume_frame(form, &at)?,
                Shape::Spline(spline) => spline.volume_frame(&at)?,
            };
            of_volume(&if unit { frame } else { frame.unnormalised() })
        }
    };
    picked(a, 4, entries)
}

fn parameters(a: &Bound<f64>) -> Result<Vec<f64>, Failure> {
    a.all(1).iter().map(|t| a.number_of(1, t)).collect()
}

/// The entry that is asked for, or the record.
fn picked(a: &Bound<f64>, index: usize, entries: Entries) -> Outcome<f64> {
    if a.is_given(index) { entry(&entries, &a.text(index)?) } else { Ok(Value::Record(entries)) }
}

fn of_curve(a: &Bound<f64>, shape: &Shape, at: &[f64], unit: bool) -> Result<Entries, Failure> {
    shape.net().require_per_axis("parameters", at)?;
    let kind = match a.choice(2)? {
        "rotation-minimising" => FrameKind::RotationMinimising,
        "tangent" => FrameKind::Tangent,
        _ => FrameKind::Frenet,
    };
    let accuracy = a.number(5)?;
    let mut frames = match shape {
        Shape::Form(form) => operators::curve_frames(form, at, kind, accuracy)?,
        Shape::Spline(spline) => spline.curve_frames(at, kind, accuracy)?,
    };
    let frame = frames.swap_remove(0);
    let CurveFrame { point, tangent, normal, binormal, speed, curvature, torsion, .. } =
        if unit { frame } else { frame.unnormalised(kind) };
    let mut entries = vec![
        (words("point", "point"), Value::point(&point, None)),
        (words("tangent", "tangente"), direction(&tangent)),
    ];
    push(&mut entries, words("normal", "normale"), normal.as_deref().map(direction));
    push(&mut entries, words("binormal", "binormale"), binormal.as_deref().map(direction));
    push(&mut entries, words("curvature", "courbure"), Some(finite(curvature)));
    push(&mut entries, words("torsion", "torsion"), torsion.map(finite));
    push(&mut entries, words("speed", "vitesse"), Some(finite(speed)));
    Ok(entries)
}

fn of_surface(frame: &SurfaceFrame) -> Entries {
    let mut entries = vec![
        (words("point", "point"), Value::point(&frame.point, None)),
        (words("tu", "tu"), direction(&frame.tangents[0])),
        (words("tv", "tv"), direction(&frame.tangents[1])),
    ];
    push(&mut entries, words("normal", "normale"), frame.normal.as_deref().map(direction));
    frame.curvature.iter().for_each(|bend| entries.extend(of_bend(bend)));
    push(&mut entries, words("first", "première"), Some(list_of_numbers(frame.first)));
    push(&mut entries, words("second", "seconde"), frame.second.map(list_of_numbers));
    push(&mut entries, words("area", "aire"), Some(finite(frame.area)));
    entries
}

fn of_bend(bend: &SurfaceCurvature) -> Entries {
    let mut entries = vec![
        (words("gauss", "gauss"), finite(bend.gauss)),
        (words("mean", "moyenne"), finite(bend.mean)),
        (words("principal", "principales"), Value::list(bend.principal.map(finite).to_vec())),
    ];
    if let Some(directions) = &bend.directions {
        let list = directions.iter().map(|vector| direction(vector)).collect();
        entries.push((words("directions", "directions"), Value::list(list)));
    }
    entries
}

fn of_volume(frame: &VolumeFrame) -> Entries {
    const NAMES: [Words; 3] = [words("tu", "tu"), words("tv", "tv"), words("tw", "tw")];
    let mut entries = vec![(words("point", "point"), Value::point(&frame.point, None))];
    let all = frame.tangents.iter().map(|tangent| direction(tangent));
    entries.extend(NAMES.into_iter().zip(all.clone()));
    if frame.tangents.len() > NAMES.len() {
        entries.push((words("tangents", "tangentes"), Value::list(all.collect())));
    }
    push(&mut entries, words("jacobian", "jacobien"), frame.jacobian.map(finite));
    entries
}

fn push(entries: &mut Entries, name: Words, value: Option<Value>) {
    entries.extend(value.map(|value| (name, value)));
}

/// A vector as a pole at infinity.
fn direction(vector: &[f64]) -> Value {
    Value::point(vector, Some(0.0))
}

/// A number, or the error that it is infinite here.
fn finite(x: f64) -> Value {
    x.checked().map(Value::Number).into()
}

fn curvature(a: &Bound<f64>) -> Outcome<f64> {
    let at = parameters(a)?;
    let bend = match workable_shape(a.shape(0)?)? {
        Shape::Form(form) => operators::curvature(&form, &at)?,
        Shape::Spline(spline) => spline.curvature(&at)?,
    };
    let entries = match bend {
        Curvature::Curve { curvature, torsion } => {
            let mut entries = vec![(words("curvature", "courbure"), finite(curvature))];
            push(&mut entries, words("torsion", "torsion"), torsion.map(finite));
            if !a.is_given(2) {
                return Ok(finite(curvature));
            }
            entries
        }
        Curvature::Surface(bend) => of_bend(&bend),
    };
    picked(a, 2, entries)
}

fn tangent<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let axis = a.whole(1)?;
    let form = |form| Ok(operators::tangent_form(&multipliable(form)?, axis)?);
    of_either(a, form, |spline| Ok(multipliable_pieces(spline)?.tangent_form(axis)?))
}

fn normal<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let form = |form| Ok(operators::normal_form(&multipliable(form)?)?);
    of_either(a, form, |spline| Ok(multipliable_pieces(spline)?.normal_form()?))
}

fn binormal<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let form = |form| Ok(operators::binormal_form(&multipliable(form)?)?);
    of_either(a, form, |spline| Ok(multipliable_pieces(spline)?.binormal_form()?))
}

/// The spline, if the first of its pieces may be multiplied by itself: all are of one size.
fn multipliable_pieces<S: Arithmetic>(spline: &Spline<S>) -> Result<&Spline<S>, Failure> {
    multipliable(spline.piece(&vec![0; spline.axes()])?)?;
    Ok(spline)
}
