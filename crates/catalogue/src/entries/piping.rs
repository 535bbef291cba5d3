//! Tubes.

use pforms_kernel::Form;
use pforms_operators::{self as operators, FrameKind, Law, Pipe, PipeOptions};

use super::{Outcome, PLAIN, part};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Bound, Failure, Operator, Parameter, Takes, Value, Words};

const COMPOSED: Operator = Operator { group: Group::Composed, ..PLAIN };

const FRAMES: &[Words] =
    &[words("rotation-minimising", "rotation minimale"), words("frenet", "frenet")];

const PARTS: &[Words] = &[
    words("tube", "tube"),
    words("error", "écart"),
    words("bending", "courbure"),
    words("closing", "fermeture"),
];

const PATH: Parameter = Parameter::new(
    Takes::Form,
    words("path", "chemin"),
    words("A curve, or a spline without corners.", "Une courbe, ou une spline sans coins."),
);

const SECTION: Parameter = Parameter::new(
    Takes::Form,
    words("section", "section"),
    words(
        "What is carried: x along the normal, y along the binormal, z along the tangent.",
        "Ce qui est porté : x suivant la normale, y la binormale, z la tangente.",
    ),
);

const FRAME: Parameter = Parameter::new(
    Takes::Text,
    words("frame", "repère"),
    words("Which normals the section follows.", "Les normales que suit la section."),
)
.choices(FRAMES)
.or(Fallback::Text("rotation-minimising"));

const TOLERANCE: Parameter = Parameter::new(
    Takes::Number,
    words("tolerance", "tolérance"),
    words(
        "Largest distance from the true tube.",
        "La plus grande distance permise au tube véritable.",
    ),
)
.or_absent("a millionth of the tube's radius", "un millionième du rayon du tube");

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "pipe",
        english: &["PIPE"],
        french: &["TUBE"],
        summary: words(
            "The tube that a section describes along a path, within a proved error.",
            "Le tube que décrit une section le long d'un chemin, à un écart prouvé près.",
        ),
        help: words(
            "A spline, exact along the section and at its centre line; its frames are near the true ones. \
             radius and twist (radians) are numbers, lists of numbers that make a curve in 1D, or such \
             curves. Closed paths close. part = \"error\" bounds the distance from the true tube; \
             \"bending\" is curvature times radius, and from 1 on the tube runs into itself; \"closing\" is \
             the angle spread over a closed path.",
            "Une spline, exacte le long de la section et sur son axe ; ses repères approchent les vrais. \
             rayon et vrille (radians) sont des nombres, des listes de nombres qui font une courbe en 1D, \
             ou de telles courbes. Les chemins fermés se ferment. partie = \"écart\" borne la distance au \
             tube véritable ; \"courbure\" est la courbure fois le rayon : à partir de 1 le tube rentre en \
             lui-même ; \"fermeture\" est l'angle réparti sur un chemin fermé.",
        ),
        parameters: &[
            PATH,
            SECTION,
            Parameter::new(
                Takes::Any,
                words("radius", "rayon"),
                words("Factor of the section.", "Le facteur de la section."),
            )
            .or(Fallback::Ratio(1, 1)),
            Parameter::new(
                Takes::Any,
                words("twist", "vrille"),
                words(
                    "The angle by which the section is turned.",
                    "L'angle dont tourne la section.",
                ),
            )
            .or(Fallback::Ratio(0, 1))
            .unit("radian", "radian"),
            FRAME,
            TOLERANCE,
            Parameter::new(
                Takes::Boolean,
                words("closed", "fermé"),
                words("Does the path close?", "Le chemin se ferme-t-il ?"),
            )
            .or_absent("when its ends agree", "si ses bouts se rejoignent"),
            part("tube", PARTS),
        ],
        example: "=PIPE([(0, 0, 0), (2, 0, 0), (-1, 2, 0), (1, 2, 1)], [(1/4, 0), (0, 1/4), (-1/4, 0)])",
        source: "book 323; Wang, Jüttler, Zheng, Liu 2008",
        see: &["affine_sweep", "waving_pipe", "frame"],
        call: call!(floating pipe),
        ..COMPOSED
    },
    Operator {
        name: "waving_pipe",
        english: &["WAVINGPIPE"],
        french: &["TUBEONDULE"],
        summary: words(
            "A tube whose radius swells and shrinks as a sine.",
            "Un tube dont le rayon enfle et s'amincit comme un sinus.",
        ),
        help: words(
            "PIPE with the radius radius·(1 + amplitude·sin(2π·periods·u)), u from 0 to 1 along the path.",
            "TUBE avec le rayon rayon·(1 + amplitude·sin(2π·périodes·u)), u de 0 à 1 le long du chemin.",
        ),
        parameters: &[
            PATH,
            SECTION,
            Parameter::new(
                Takes::Number,
                words("amplitude", "amplitude"),
                words("Share of the radius that waves.", "Part du rayon qui ondule."),
            )
            .range(-1.0, 1.0),
            Parameter::new(
                Takes::Number,
                words("periods", "périodes"),
                words("How many waves.", "Combien d'ondes."),
            )
            .range(-1000.0, 1000.0),
            Parameter::new(
                Takes::Number,
                words("radius", "rayon"),
                words("Factor of the section.", "Le facteur de la section."),
            )
            .or(Fallback::Ratio(1, 1)),
            FRAME,
            TOLERANCE,
            part("tube", PARTS),
        ],
        example: "=WAVINGPIPE([(0, 0, 0), (2, 0, 0), (2, 2, 1)], [(1/4, 0), (0, 1/4), (-1/4, 0)], 1/2, 3)",
        source: "book 324",
        see: &["pipe", "affine_sweep"],
        call: call!(floating waving_pipe),
        ..COMPOSED
    },
];

fn pipe(a: &Bound<f64>) -> Outcome<f64> {
    let options = PipeOptions {
        radius: law(a, 2)?,
        twist: law(a, 3)?,
        frame: frame(a, 4)?,
        tolerance: a.is_given(5).then(|| a.number(5)).transpose()?,
        closed: a.is_given(6).then(|| a.boolean(6)).transpose()?,
    };
    told(a, &options, 7)
}

fn waving_pipe(a: &Bound<f64>) -> Outcome<f64> {
    let radius = Law::Wave { mean: a.number(4)?, amplitude: a.number(2)?, periods: a.number(3)? };
    let options = PipeOptions {
        radius,
        frame: frame(a, 5)?,
        tolerance: a.is_given(6).then(|| a.number(6)).transpose()?,
        ..PipeOptions::default()
    };
    told(a, &options, 7)
}

/// The tube, or what is asked about it.
fn told(a: &Bound<f64>, options: &PipeOptions, wanted: usize) -> Outcome<f64> {
    let (path, section) = (a.shape(0)?.into_spline(), a.shape(1)?.into_spline());
    let wanted = a.choice(wanted)?;
    let Pipe { spline, error, bending, closing } = operators::pipe(&path, &section, options)?;
    Ok(match wanted {
        "error" => Value::Number(error),
        "bending" => Value::Number(bending),
        "closing" => Value::Number(closing),
        _ => spline.into(),
    })
}

fn frame(a: &Bound<f64>, index: usize) -> Result<FrameKind, Failure> {
    Ok(match a.choice(index)? {
        "frenet" => FrameKind::Frenet,
        _ => FrameKind::RotationMinimising,
    })
}

/// A number, numbers that are the poles of a curve in 1D, or such a curve.
fn law(a: &Bound<f64>, index: usize) -> Result<Law, Failure> {
    let value = a.value(index);
    Ok(match &value {
        Value::Number(number) => Law::Constant(*number),
        Value::List(items) if items.iter().all(|item| matches!(item, Value::Number(_))) => {
            let poles = a.flat_numbers(index)?;
            Form::from_points(&[poles.len()], 1, &poles, None)?.into()
        }
        value => a.shape_of(index, value)?.into_spline().into(),
    })
}
