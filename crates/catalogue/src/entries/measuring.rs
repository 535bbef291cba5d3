//! Areas, volumes, centres, inertia and boxes, each with the error it may have.

use pforms_kernel::{Form, Rational, Traced};
use pforms_mesh::{Mesh, mesh_area, mesh_box, mesh_mass, mesh_volume};
use pforms_operators::{self as operators, BoundingBox, Mass, Measure, Poles, Shape};

use super::lists::entry;
use super::{Outcome, PART, PLAIN, list_of_numbers, part};
use crate::cost::require_points;
use crate::operator::{Call, Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value, Words};

pub(super) const INSIDE: Operator = Operator { group: Group::Inside, ..PLAIN };

/// The forms that are measured together.
const FORMS: Parameter = Parameter::new(
    Takes::Any,
    words("forms", "formes"),
    words(
        "Forms, splines or lists of them; or meshes.",
        "Des formes, des splines ou des listes ; ou des maillages.",
    ),
)
.variadic();

const SIGNED: Parameter = Parameter::new(
    Takes::Boolean,
    words("signed", "signé"),
    words(
        "With the sign of the orientation; what is folded over counts less.",
        "Avec le signe de l'orientation ; ce qui est replié compte en moins.",
    ),
)
.or(Fallback::Boolean(false));

const FILLED: Parameter = Parameter::new(
    Takes::Boolean,
    words("filled", "plein"),
    words(
        "Take closed curves or surfaces for what they enclose.",
        "Prendre des courbes ou surfaces fermées pour ce qu'elles enferment.",
    ),
)
.or(Fallback::Boolean(false));

const ACCURACY: Parameter = Parameter::new(
    Takes::Number,
    words("accuracy", "précision"),
    words("Relative to the measure.", "Relative à la mesure."),
)
.range(0.0, 1.0)
.or(Fallback::Ratio(1, 1_000_000_000_000));

const AREA_PARTS: &[Words] = &[words("area", "aire"), words("error", "écart")];

const VOLUME_PARTS: &[Words] = &[words("volume", "volume"), words("error", "écart")];

const CENTRE_PARTS: &[Words] = &[words("point", "point"), words("error", "écart")];

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "area",
        english: &["AREA"],
        french: &["AIRE"],
        summary: words(
            "The area of surfaces, or what closed plane curves enclose.",
            "L'aire de surfaces, ou celle qu'enferment des courbes planes.",
        ),
        help: words(
            "In any dimension, added up. Without sign: what is folded over counts as often as it \
             covers; signed = TRUE gives the integral of the determinant, for surfaces in the plane. \
             Curves have to close up. The error is proved; part = \"error\" gives it. Exact sheets \
             measure polynomial plane forms, exactly.",
            "En toute dimension, additionnées. Sans signe : un repli compte autant de fois qu'il couvre ; \
             signé = VRAI donne l'intégrale du déterminant, pour les surfaces du plan. Les courbes \
             doivent se fermer. L'erreur est prouvée ; partie = \"écart\" la donne. Les feuilles exactes \
             mesurent exactement les formes polynomiales du plan.",
        ),
        parameters: &[FORMS, SIGNED, ACCURACY, part("area", AREA_PARTS)],
        gives: Takes::Number,
        example: "=AREA(FACET([2, 2], [3, 2], 2))",
        source: "catalogue 7; Trefethen 2013, chapter 19",
        see: &["arc_length", "volume", "centroid"],
        call: Call {
            floating: area,
            exact: Some(exact_area::<Rational>),
            traced: Some(exact_area::<Traced>),
        },
        ..INSIDE
    },
    Operator {
        name: "volume",
        english: &["VOLUME"],
        french: &["VOLUME"],
        summary: words(
            "The volume of forms, or of what a closed shell encloses.",
            "Le volume de formes, ou de ce qu'enferme une coque fermée.",
        ),
        help: words(
            "Forms with three axes or more: what they fill, without sign, or signed = TRUE. Surfaces in \
             space: what they enclose; they have to close up, in any order and either way round, and a \
             border that stays open is named. The error is proved; part = \"error\" gives it. Exact \
             sheets measure polynomial forms, exactly.",
            "Formes à trois axes ou plus : ce qu'elles remplissent, sans signe, ou signé = VRAI. Surfaces \
             de l'espace : ce qu'elles enferment ; elles doivent se fermer, dans n'importe quel ordre et \
             sens, et un bord resté ouvert est nommé. L'erreur est prouvée ; partie = \"écart\" la \
             donne. Les feuilles exactes mesurent exactement les formes polynomiales.",
        ),
        parameters: &[FORMS, SIGNED, ACCURACY, part("volume", VOLUME_PARTS)],
        gives: Takes::Number,
        example: "=VOLUME(CUBE(2, [1, 2, 3]))",
        source: "catalogue 7; Gauss's theorem",
        see: &["area", "centroid", "jacobian"],
        call: Call {
            floating: volume,
            exact: Some(exact_volume::<Rational>),
            traced: Some(exact_volume::<Traced>),
        },
        ..INSIDE
    },
    Operator {
        name: "centroid",
        english: &["CENTROID"],
        french: &["CENTROIDE", "BARYCENTRE"],
        summary: words(
            "The centre of mass of curves, surfaces or solids.",
            "Le centre de gravité de courbes, surfaces ou solides.",
        ),
        help: words(
            "Of density 1, taken together. filled = TRUE takes closed curves of the plane and closed \
             surfaces for what they enclose. part = \"error\" tells how far off it may be, at most.",
            "De densité 1, pris ensemble. plein = VRAI prend courbes planes et surfaces fermées pour ce \
             qu'elles enferment. partie = \"écart\" dit de combien il peut différer, au plus.",
        ),
        parameters: &[FORMS, FILLED, ACCURACY, part("point", CENTRE_PARTS)],
        gives: Takes::Point,
        example: "=CENTROID([(1, 0), (1, 1), (0, 1; 2)])",
        source: "catalogue 7",
        see: &["inertia", "area", "volume"],
        call: call!(floating centroid),
        ..INSIDE
    },
    Operator {
        name: "inertia",
        english: &["INERTIA"],
        french: &["INERTIE"],
        summary: words(
            "Mass, centre, inertia and principal axes.",
            "Masse, centre, inertie et axes principaux.",
        ),
        help: words(
            "A record: measure; centroid; tensor, about the centre: the integral of |x|² less the \
             products of coordinates, density 1; moments about the principal axes, the least first; \
             axes, directions; error, of the tensor. part = \"moments\" takes one entry.",
            "Une fiche : mesure ; centre ; tenseur, au centre : l'intégrale de |x|² moins les produits \
             des coordonnées, densité 1 ; moments des axes principaux, le moindre d'abord ; axes, des \
             directions ; écart, du tenseur. partie = \"moments\" prend une entrée.",
        ),
        parameters: &[FORMS, FILLED, ACCURACY, PART],
        gives: Takes::Record,
        example: "=INERTIA([[(0, 0), (0, 1)], [(2, 0), (2, 1)]])",
        source: "catalogue 7",
        see: &["centroid", "volume", "item"],
        call: call!(floating inertia),
        ..INSIDE
    },
    Operator {
        name: "box",
        english: &["BOX"],
        french: &["BOITE"],
        summary: words("The least box around forms.", "La plus petite boîte autour de formes."),
        help: words(
            "Its sides along the axes of space; around the points, not the poles. A record: lower, \
             upper: its corners, nothing lies outside; error: points come as near to each face, at \
             least; form: the box itself. part = \"form\" takes one entry.",
            "Ses côtés suivent les axes de l'espace ; autour des points, non des pôles. Une fiche : bas, \
             haut : ses coins, rien ne dépasse ; écart : des points approchent chaque face d'autant au \
             moins ; forme : la boîte même. partie = \"forme\" prend une entrée.",
        ),
        parameters: &[
            FORMS,
            Parameter::new(
                Takes::Number,
                words("accuracy", "précision"),
                words("In sizes of the whole.", "En tailles du tout."),
            )
            .range(0.0, 1.0)
            .or(Fallback::Ratio(1, 1_000_000_000_000)),
            PART,
        ],
        gives: Takes::Record,
        example: "=BOX([(0, 0), (1, 2), (2, 0)])",
        source: "catalogue 7",
        see: &["area", "pole"],
        call: call!(floating bounding_box),
        ..INSIDE
    },
];

/// Work of one form, in evaluations, about.
const EVALUATIONS: usize = 1 << 12;

/// All forms and splines, lists of them taken apart; a list of points is a net.
fn shapes<S: Arithmetic>(a: &Bound<S>) -> Result<Vec<Shape<S>>, Failure> {
    let mut all = Vec::new();
    for value in a.all(0) {
        gather(a, value, &mut all)?;
    }
    for shape in &all {
        require_points(shape.net(), EVALUATIONS, 0.0)?;
    }
    Ok(all)
}

fn gather<S: Arithmetic>(
    a: &Bound<S>,
    value: &Value<S>,
    all: &mut Vec<Shape<S>>,
) -> Result<(), Failure> {
    match value {
        Value::List(items) if items.iter().any(holds_forms) => {
            items.iter().try_for_each(|item| gather(a, item, all))
        }
        other => {
            all.push(a.shape_of(0, other)?);
            Ok(())
        }
    }
}

/// Is it a form with axes, a spline, or a list that has one?
fn holds_forms<S: Arithmetic>(value: &Value<S>) -> bool {
    match value {
        Value::Form(form) => form.axes() > 0,
        Value::Spline(_) | Value::Immersed(_) => true,
        Value::List(items) => items.iter().any(holds_forms),
        _ => false,
    }
}

fn one_of(measured: Measure, wanted: &str) -> Value {
    Value::Number(if wanted == "error" { measured.error } else { measured.value })
}

/// All that is measured when it is meshes; nothing when there is none among it.
fn meshes(a: &Bound<f64>) -> Result<Option<Vec<Mesh>>, Failure> {
    let (mut found, mut others) = (Vec::new(), None);
    let mut waiting: Vec<Value> = a.all(0).iter().rev().cloned().collect();
    while let Some(value) = waiting.pop() {
        match value {
            Value::Mesh(mesh) => found.push(mesh),
            Value::List(items) if items.iter().any(holds_meshes) => {
                waiting.extend(items.iter().rev().cloned());
            }
            other => others = Some(other),
        }
    }
    match others {
        _ if found.is_empty() => Ok(None),
        None => Ok(Some(found)),
        Some(other) => Err(a.refused(
            0,
            &other,
            words("meshes alone, or forms alone", "des maillages seuls, ou des formes seules"),
        )),
    }
}

fn holds_meshes(value: &Value) -> bool {
    match value {
        Value::Mesh(_) => true,
        Value::List(items) => items.iter().any(holds_meshes),
        _ => false,
    }
}

fn area(a: &Bound<f64>) -> Outcome<f64> {
    if let Some(meshes) = meshes(a)? {
        return Ok(one_of(mesh_area(&meshes)?, a.choice(3)?));
    }
    let (shapes, wanted) = (shapes(a)?, a.choice(3)?);
    let measured = if a.boolean(1)? { operators::signed_area } else { operators::area };
    Ok(one_of(measured(&shapes, a.number(2)?)?, wanted))
}

fn exact_area<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let shapes = shapes(a)?;
    require_plane(&shapes)?;
    exact(a, &shapes)
}

/// Complains unless all lies in the plane: surfaces, or curves that close up.
fn require_plane<S: Arithmetic>(shapes: &[Shape<S>]) -> Result<(), Failure> {
    match shapes.iter().find(|shape| shape.net().ambient() != 2) {
        None => Ok(()),
        Some(shape) => Err(pforms_kernel::Error::shape(
            "forms",
            format!("a {} in dimension {}", shape.net().kind(), shape.net().ambient()),
            "forms in the plane, for an area without rounding",
        )
        .into()),
    }
}

fn volume(a: &Bound<f64>) -> Outcome<f64> {
    if let Some(meshes) = meshes(a)? {
        return Ok(one_of(mesh_volume(&meshes, a.boolean(1)?)?, a.choice(3)?));
    }
    let (shapes, wanted) = (shapes(a)?, a.choice(3)?);
    Ok(one_of(operators::volume(&shapes, a.boolean(1)?, a.number(2)?)?, wanted))
}

fn exact_volume<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    exact(a, &shapes(a)?)
}

fn exact<S: Arithmetic>(a: &Bound<S>, shapes: &[Shape<S>]) -> Outcome<S> {
    let (signed, wanted) = (a.boolean(1)?, a.choice(3)?);
    if wanted == "error" {
        return Ok(Value::Number(S::zero()));
    }
    Ok(Value::Number(operators::volume_exact(shapes, signed)?))
}

fn mass(a: &Bound<f64>) -> Result<Mass, Failure> {
    if let Some(meshes) = meshes(a)? {
        return Ok(mesh_mass(&meshes, a.boolean(1)?)?);
    }
    Ok(operators::mass(&shapes(a)?, a.boolean(1)?, a.number(2)?)?)
}

fn centroid(a: &Bound<f64>) -> Outcome<f64> {
    let wanted = a.choice(3)?;
    let mass = mass(a)?;
    Ok(match wanted {
        "error" => Value::Number(mass.centroid_error),
        _ => Value::point(&mass.centroid, None),
    })
}

fn inertia(a: &Bound<f64>) -> Outcome<f64> {
    let mass = mass(a)?;
    let size = mass.centroid.len();
    let rows = mass.inertia.chunks_exact(size).map(|row| list_of_numbers(row.iter().copied()));
    let axes = mass.axes.chunks_exact(size).map(|axis| Value::point(axis, Some(0.0)));
    let entries = vec![
        (words("measure", "mesure"), Value::Number(mass.measure.value)),
        (words("centroid", "centre"), Value::point(&mass.centroid, None)),
        (words("tensor", "tenseur"), Value::list(rows.collect())),
        (words("moments", "moments"), list_of_numbers(mass.moments.iter().copied())),
        (words("axes", "axes"), Value::list(axes.collect())),
        (words("error", "écart"), Value::Number(mass.inertia_error)),
    ];
    if a.is_given(3) { entry(&entries, &a.text(3)?) } else { Ok(Value::Record(entries)) }
}

fn bounding_box(a: &Bound<f64>) -> Outcome<f64> {
    let found = match meshes(a)? {
        Some(meshes) => mesh_box(&meshes)?,
        None => operators::bounding_box(&shapes(a)?, a.number(1)?)?,
    };
    let entries = vec![
        (words("lower", "bas"), Value::point(&found.lower, None)),
        (words("upper", "haut"), Value::point(&found.upper, None)),
        (words("error", "écart"), Value::Number(found.error)),
        (words("form", "forme"), as_form(&found)?.into()),
    ];
    if a.is_given(2) { entry(&entries, &a.text(2)?) } else { Ok(Value::Record(entries)) }
}

/// The box as a form: an axis along each coordinate.
fn as_form(found: &BoundingBox) -> Result<Form, Failure> {
    let dimension = found.lower.len();
    let mut points = Vec::with_capacity(dimension << dimension);
    for corner in 0..1_usize << dimension {
        for axis in 0..dimension {
            let far = corner >> (dimension - 1 - axis) & 1 == 1;
            points.push(if far { found.upper[axis] } else { found.lower[axis] });
        }
    }
    Ok(Form::from_points(&vec![2; dimension], dimension, &points, None)?)
}
