//! Products of curves: revolution, and any profile with any section.

use pforms_kernel::{Error, Form, Rational};
use pforms_operators::{self as operators, Axis, Part, Shape};

use super::conics::{ORDER, in_scalar, length};
use super::{Outcome, PLAIN};
use crate::elementary::{Elementary, use_floating_mode};
use crate::operator::{Group, call};
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes};

const COMPOSED: Operator = Operator { group: Group::Composed, ..PLAIN };

const PROFILE: Parameter = Parameter::new(
    Takes::Form,
    words("profile", "profil"),
    words(
        "A form or a spline, in the plane or in space.",
        "Une forme ou une spline, plane ou gauche.",
    ),
);

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "revolve",
        english: &["REVOLVE"],
        french: &["REVOLUTION"],
        summary: words(
            "The form that a profile leaves behind as it turns about an axis.",
            "La forme que laisse un profil qui tourne autour d'un axe.",
        ),
        help: words(
            "Its axes are those of the profile, then the turn, right-handed. Without an angle it goes all \
             the way round in one form, also in exact mode; with one in pieces as ARC. Profiles may be \
             rational, skew, surfaces, and touch the axis.",
            "Ses axes sont ceux du profil, puis le tour, direct. Sans angle, il se fait en entier et en une \
             seule forme, aussi en mode exact ; avec un angle, en morceaux comme ARC. Les profils peuvent \
             être rationnels, gauches, des surfaces, et toucher l'axe.",
        ),
        parameters: &[
            PROFILE,
            length("angle", "angle", "How far it turns; not 0.", "De combien il tourne ; non nul.")
                .unit("radian", "radian")
                .or_absent("all the way round", "un tour complet"),
            Parameter::new(
                Takes::Point,
                words("axis", "axe"),
                words("The direction of the axis.", "La direction de l'axe."),
            )
            .or_absent("Oy", "Oy"),
            Parameter::new(
                Takes::Point,
                words("through", "passage"),
                words("A point of the axis.", "Un point de l'axe."),
            )
            .or_absent("the origin", "l'origine"),
            ORDER,
        ],
        example: "=REVOLVE([(1, 0, 0), (2, 1, 0)])",
        source: "book 322",
        see: &["cross", "arc", "cylinder"],
        call: call!(revolve),
        ..COMPOSED
    },
    Operator {
        name: "cross",
        english: &["CROSS"],
        french: &["PRODUIT"],
        summary: words(
            "The product of a profile and a section about Oy.",
            "Le produit d'un profil et d'une section autour de Oy.",
        ),
        help: words(
            "The section says what becomes of the direction x: its point (a, b) turns and stretches the \
             horizontal plane as the complex number a + ib does to x + iz; its third coordinate lifts. A \
             circle turns the profile, from x towards z. Axes of the profile first.",
            "La section dit ce que devient la direction x : son point (a, b) tourne et étire le plan \
             horizontal comme le nombre complexe a + ib le fait de x + iz ; sa troisième coordonnée \
             élève. Un cercle fait tourner le profil, de x vers z. Les axes du profil d'abord.",
        ),
        parameters: &[
            PROFILE,
            Parameter::new(
                Takes::Form,
                words("section", "section"),
                words(
                    "A form or a spline, as the profile.",
                    "Une forme ou une spline, comme le profil.",
                ),
            ),
        ],
        example: "=CROSS([(1, 0, 0), (2, 1, 0)], CIRCLE(1))",
        source: "book 322",
        see: &["revolve", "torus"],
        call: call!(cross),
        ..COMPOSED
    },
];

fn cross<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    Ok(operators::cross(&a.shape(0)?, &a.shape(1)?)?.into())
}

fn revolve<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let profile = a.shape(0)?;
    let turn = if a.is_given(1) {
        turn(&a.number(1)?, a.whole(4)?)?
    } else {
        operators::circle(&S::one(), Part::Whole)?
    };
    Ok(operators::revolve_along(&profile, &turn, &axis(a)?)?.into())
}

fn turn<S: Arithmetic>(angle: &S, order: usize) -> Result<Shape<S>, Failure> {
    if S::EXACT {
        let error = Error::domain("angle", "an angle in exact mode", "none: all the way round");
        let french = "angle : reçu un angle en mode exact, attendu aucun : un tour complet";
        return Err(use_floating_mode(Failure::of(error, french)));
    }
    in_scalar(&operators::arc(1.0, angle.plain()?, order, 0.0)?)
}

/// The axis of the arguments; its direction is scaled before it is squared.
fn axis<S: Arithmetic>(a: &Bound<S>) -> Result<Axis<S>, Failure> {
    let through = match a.is_given(3) {
        true => vector("through", &a.point(3)?)?,
        false => [S::zero(), S::zero(), S::zero()],
    };
    let direction = match a.is_given(2) {
        true => vector("axis", &a.point(2)?)?,
        false => [S::zero(), S::one(), S::zero()],
    };
    let size = |x: &S| if *x < S::zero() { -x.clone() } else { x.clone() };
    let largest = direction.iter().map(size).fold(S::zero(), |a, b| if b > a { b } else { a });
    if largest.is_zero() {
        return Ok(Axis::with_length(through, direction, &largest)?);
    }
    let scaled = direction.map(|x| x / largest.clone());
    let square = scaled.iter().fold(S::zero(), |sum, x| sum + x.power(2));
    let length = S::apply(Elementary::Sqrt, &square)?;
    Ok(Axis::with_length(through, scaled, &length)?)
}

/// The coordinates of a point or of a direction in space.
fn vector<S: Arithmetic>(argument: &str, point: &Form<S>) -> Result<[S; 3], Failure> {
    let [x, y, z, w] = point.homogeneous() else {
        let received = format!("a point in {}D", point.ambient());
        return Err(Error::shape(argument, received, "a point in space").into());
    };
    let divisor = if w.is_zero() { S::one() } else { w.clone() };
    Ok([x, y, z].map(|coordinate| coordinate.clone() / divisor.clone()))
}
