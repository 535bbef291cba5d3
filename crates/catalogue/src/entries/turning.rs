//! Rotation, and the units of angles.

use pforms_kernel::{Error, Form, Rational};
use pforms_operators::{self as operators, Rotation, Turn};

use super::Outcome;
use super::transforming::{CENTRE, MOVED, TRANSFORMATION, centre, on_poles};
use crate::operator::call;
use crate::parameter::Fallback;
use crate::words::words;
use crate::{
    Arithmetic, Bound, Elementary, Failure, Language, Operator, Parameter, Takes, Value, Words,
};

const UNITS: &[Words] = &[
    words("radians", "radians"),
    words("degrees", "degrés"),
    words("half tangent", "demi-tangente"),
];

/// In what an angle is given.
pub(super) const UNIT: Parameter = Parameter::new(
    Takes::Text,
    words("unit", "unité"),
    words(
        "What angles are counted in; \"half tangent\" is the tangent of half the angle.",
        "En quoi se comptent les angles ; \"demi-tangente\" est la tangente de la moitié de l'angle.",
    ),
)
.or(Fallback::Text("radians"))
.choices(UNITS);

pub(super) static ENTRIES: &[Operator] = &[Operator {
    name: "rotate",
    english: &["ROTATE"],
    french: &["ROTATION", "TOURNE"],
    summary: words("A form turned by an angle.", "Une forme tournée d'un angle."),
    help: words(
        "In 2D from x toward y; in 3D about an axis, z unless given, counter-clockwise seen from its \
         tip; in any dimension in the plane of two coordinates. A list of three angles is the book's: \
         about x, then about y from x toward z (not the usual way round), then about z. Exact for \
         quarter turns in degrees, and for half tangents.",
        "En 2D de x vers y ; en 3D autour d'un axe, z à défaut, dans le sens direct vu de sa pointe ; \
         en toute dimension dans le plan de deux coordonnées. Une liste de trois angles est celle du \
         livre : autour de x, puis de y en allant de x vers z (au rebours de l'usage), puis de z. Exact \
         pour les quarts de tour en degrés, et pour les demi-tangentes.",
    ),
    parameters: &[
        MOVED,
        Parameter::new(
            Takes::Any,
            words("angle", "angle"),
            words("The angle, or a list of three.", "L'angle, ou une liste de trois."),
        )
        .unit("radians", "radians"),
        Parameter::new(
            Takes::Point,
            words("axis", "axe"),
            words("The direction that stays, in 3D.", "La direction qui reste, en 3D."),
        )
        .or_absent("z", "z"),
        CENTRE,
        Parameter::new(
            Takes::Wholes,
            words("plane", "plan"),
            words(
                "Two coordinates: from the first toward the second; 0 is x.",
                "Deux coordonnées : de la première vers la seconde ; 0 est x.",
            ),
        )
        .or_absent("x toward y, in 2D", "x vers y, en 2D"),
        UNIT,
    ],
    example: "=ROTATE([(1, 0, 0), (2, 0, 0)], 90, unit=\"degrees\")",
    source: "book 231",
    see: &["translate", "mirror", "transform"],
    call: call!(rotate),
    ..TRANSFORMATION
}];

fn rotate<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let turns = match a.value(1) {
        Value::List(angles) => {
            angles.iter().map(|angle| turn(a, 1, angle, 5)).collect::<Result<Vec<_>, _>>()?
        }
        angle => vec![turn(a, 1, &angle, 5)?],
    };
    on_poles(a, &|net| {
        let rotation = rotation(a, net, &turns)?;
        Ok(operators::rotate(net, &rotation, &centre(a, 3, net)?)?)
    })
}

fn rotation<S: Arithmetic>(
    a: &Bound<S>,
    net: &Form<S>,
    turns: &[Turn<S>],
) -> Result<Rotation<S>, Failure> {
    let (axis, plane) = (a.is_given(2), a.is_given(4));
    let single = match turns {
        [x, y, z] if !axis && !plane => {
            return Ok(Rotation::Book([x.clone(), y.clone(), z.clone()]));
        }
        [turn] if !(axis && plane) => turn.clone(),
        _ => return Err(unfit(a)),
    };
    if axis {
        return Rotation::about_by(&a.vector(2)?, single, |square| {
            S::apply(Elementary::Sqrt, square)
        });
    }
    if plane {
        let [from, to] = a.wholes(4, 2)?[..] else {
            return Err(a.mistyped(4, &a.value(4)));
        };
        return Ok(Rotation::Plane(from, to, single));
    }
    if net.ambient() > 3 {
        let error =
            Error::shape("plane", "nothing", format!("two coordinates in {}D", net.ambient()));
        let french = format!("plan : rien reçu, attendu deux coordonnées en {}D", net.ambient());
        return Err(Failure::of(error, french));
    }
    Ok(Rotation::Plane(0, 1, single))
}

fn unfit<S: Arithmetic>(a: &Bound<S>) -> Failure {
    let value = a.value(1);
    let [en, fr] = [Language::English, Language::French].map(|language| value.said(language));
    let error =
        Error::shape("angle", en, "one angle with an axis or a plane, or three with neither");
    let expected = "un angle avec un axe ou un plan, ou trois sans l'un ni l'autre";
    Failure::of(error, format!("angle : reçu {fr}, attendu {expected}"))
}

/// How far to turn, in the unit that the parameter `unit` names.
pub(super) fn turn<S: Arithmetic>(
    a: &Bound<S>,
    index: usize,
    angle: &Value<S>,
    unit: usize,
) -> Result<Turn<S>, Failure> {
    let angle = a.number_of(index, angle)?;
    match a.choice(unit)? {
        "half tangent" => Ok(Turn::half_tangent(&angle)?),
        "degrees" => degrees(&angle),
        _ => {
            let [cosine, sine] = [Elementary::Cos, Elementary::Sin].map(|f| S::apply(f, &angle));
            Ok(Turn::of(cosine?, sine?)?)
        }
    }
}

fn degrees<S: Arithmetic>(angle: &S) -> Result<Turn<S>, Failure> {
    let quarters = (angle.clone() / S::from_integer(90)).whole();
    match quarters {
        Some(count) => Ok(Turn::quarters(count)),
        None if S::EXACT => Err(Elementary::Cos.irrational(&format!("{}°", angle.write()))),
        None => {
            let turn = Turn::degrees(angle.plain()?)?;
            let [cosine, sine] =
                [turn.cosine(), turn.sine()].map(|x| S::from_f64(*x).unwrap_or_else(S::zero));
            Ok(Turn::of(cosine, sine)?)
        }
    }
}
