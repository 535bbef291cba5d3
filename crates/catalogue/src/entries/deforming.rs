//! Forms that follow a cage.

use pforms_kernel::{Error, Form, Rational};
use pforms_mesh::Mesh;
use pforms_operators::{
    self as operators, Embedder, Embedding, Outside, Poles, Rest, Shape, Standing,
};

use super::lists::entry;
use super::{Outcome, PART, PLAIN};
use crate::arithmetic::require_plain;
use crate::cost::{require_bendable, require_points};
use crate::operator::{Group, call};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value};

pub(super) static ENTRIES: &[Operator] = &[Operator {
    name: "deform",
    english: &["DEFORM"],
    french: &["DEFORME"],
    group: Group::Inside,
    summary: words(
        "What lies in a cage follows it when it is bent; forms exactly.",
        "Ce qui est dans une cage la suit quand elle se déforme ; les formes, exactement.",
    ),
    help: words(
        "A form, a spline or a list of them in the box at rest becomes one in the bent cage, by an \
         immersion. With points = TRUE each pole is a point that follows for itself, so that the cage may \
         be bent at rest too, and so do the vertices of a mesh; a point outside stays. part = \"inside\" then \
         tells which are not.",
        "Une forme, une spline ou une liste, dans la boîte au repos, en devient une dans la cage déformée, \
         par immersion. Avec points = VRAI chaque pôle est un point qui suit pour lui-même, et la cage \
         peut être courbe au repos aussi ; de même les sommets d'un maillage. Un point dehors reste ; partie = \
         \"dedans\" dit alors lesquels n'y sont pas.",
    ),
    parameters: &[
        Parameter::new(
            Takes::Any,
            words("object", "objet"),
            words(
                "A form, a spline, a mesh, or a list.",
                "Une forme, une spline, un maillage, ou une liste.",
            ),
        ),
        Parameter::new(
            Takes::Form,
            words("cage", "cage"),
            words(
                "The bent cage: as many parameters as the object has coordinates.",
                "La cage déformée : autant de paramètres que l'objet a de coordonnées.",
            ),
        ),
        Parameter::new(
            Takes::Form,
            words("rest", "repos"),
            words(
                "Two opposite corners of a box, or the cage at rest.",
                "Deux sommets opposés d'une boîte, ou la cage au repos.",
            ),
        )
        .or_absent("coordinates are parameters", "les coordonnées sont les paramètres"),
        Parameter::new(
            Takes::Boolean,
            words("points", "points"),
            words("Are the poles points to move?", "Les pôles sont-ils des points à déplacer ?"),
        )
        .or(Fallback::Boolean(false)),
        PART,
    ],
    gives: Takes::Any,
    example: "=DEFORM([(0, 0), (4, 2)], [[(0, 0), (1, 2)], [(4, 0), (5, 2)]], [(0, 0), (4, 2)])",
    source: "book 35; catalogue 7; Sederberg and Parry 1986",
    see: &["immerse", "tile", "project"],
    call: call!(deform),
    ..PLAIN
}];

fn deform<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let cage = a.shape(1)?;
    let rest = rest(a, &cage)?;
    let points = a.boolean(3)?;
    if a.is_given(4) && !points && !matches!(a.value(0), Value::Mesh(_)) {
        let expected = words("no part without points = TRUE", "aucune partie sans points = VRAI");
        return Err(a.refused(4, &a.value(4), expected));
    }
    each(&a.value(0), &|value| {
        if let Value::Mesh(mesh) = value {
            return carried(a, mesh, &cage, &rest);
        }
        let object = a.shape_of(0, value)?;
        if points { followed(a, &object, &cage, &rest) } else { bent(&object, &cage, &rest) }
    })
}

/// Does it with a form, or with all in a list.
fn each<S: Arithmetic>(value: &Value<S>, act: &impl Fn(&Value<S>) -> Outcome<S>) -> Outcome<S> {
    match value {
        Value::List(items) if !value.is_points() => {
            let moved = items.iter().map(|item| each(item, act)).collect::<Result<_, _>>()?;
            Ok(Value::list(moved))
        }
        one => act(one),
    }
}

/// Two points are the corners of a box; anything else is a cage.
fn rest<S: Arithmetic>(a: &Bound<S>, cage: &Shape<S>) -> Result<Rest<S>, Failure> {
    if !a.is_given(2) {
        return Ok(Rest::Window);
    }
    match a.shape(2)? {
        Shape::Form(corners)
            if *corners.orders() == [2] && corners.ambient() == cage.net().axes() =>
        {
            let points = corners.points()?;
            let (lower, upper) = points.split_at(corners.ambient());
            Ok(Rest::Box(lower.to_vec(), upper.to_vec()))
        }
        other => Ok(Rest::Cage(other)),
    }
}

fn bent<S: Arithmetic>(object: &Shape<S>, cage: &Shape<S>, rest: &Rest<S>) -> Outcome<S> {
    require_bendable(object, cage, 1)?;
    Ok(operators::deform(object, cage, rest)?.into())
}

/// Work of one point, in evaluations of the cage, about.
const EVALUATIONS: usize = 1 << 6;

/// The poles as points, in the floating arithmetic that finds them in the cage.
fn followed<S: Arithmetic>(
    a: &Bound<S>,
    object: &Shape<S>,
    cage: &Shape<S>,
    rest: &Rest<S>,
) -> Outcome<S> {
    if S::EXACT {
        let expected = words("FALSE in exact mode", "FAUX en mode exact");
        return Err(a.refused(3, &a.value(3), expected));
    }
    let at_rest = rest.cage(cage)?;
    for shape in [object, cage, &at_rest] {
        require_plain(shape.net().homogeneous())?;
    }
    let net = object.net();
    require_points(at_rest.net(), EVALUATIONS.saturating_mul(net.pole_count()), 0.0)?;
    let points: Vec<f64> = net.points()?.iter().map(S::to_f64).collect();
    let (at_rest, cage) = (rough(&at_rest)?, rough(cage)?);
    if net.ambient() != cage.net().axes() {
        let received = format!("points in dimension {}", net.ambient());
        let expected = format!("dimension {}, as the cage has parameters", cage.net().axes());
        return Err(Error::shape("object", received, expected).into());
    }
    let embedding = Embedder::new(&at_rest, ACCURACY, Outside::Keep)?.embed(&points)?;
    let moved: Option<Vec<S>> = embedding.at(&cage)?.iter().map(|x| S::from_f64(*x)).collect();
    let moved = moved.unwrap_or_default();
    let image =
        Form::from_points(net.orders(), cage.net().ambient(), &moved, Some(&net.weights()))?;
    answered(a, object.with_net(image)?.into(), &embedding)
}

/// The vertices of a mesh as points.
fn carried<S: Arithmetic>(
    a: &Bound<S>,
    mesh: &Mesh,
    cage: &Shape<S>,
    rest: &Rest<S>,
) -> Outcome<S> {
    let at_rest = rest.cage(cage)?;
    for shape in [cage, &at_rest] {
        require_plain(shape.net().homogeneous())?;
    }
    let axes = cage.net().axes();
    if mesh.ambient() != axes {
        let received = format!("a mesh in dimension {}", mesh.ambient());
        let expected = format!("dimension {axes}, as the cage has parameters");
        return Err(Error::shape("object", received, expected).into());
    }
    require_points(at_rest.net(), EVALUATIONS.saturating_mul(mesh.vertex_count()), 0.0)?;
    let (at_rest, cage) = (rough(&at_rest)?, rough(cage)?);
    let embedding = Embedder::new(&at_rest, ACCURACY, Outside::Keep)?.embed(mesh.vertices())?;
    let image = mesh.with_vertices(cage.net().ambient(), embedding.at(&cage)?)?;
    answered(a, image.into(), &embedding)
}

/// What has moved, or which points of it were in the cage.
fn answered<S: Arithmetic>(a: &Bound<S>, image: Value<S>, embedding: &Embedding) -> Outcome<S> {
    if !a.is_given(4) {
        return Ok(image);
    }
    let inside = embedding.standings.iter();
    let inside = inside.map(|standing| Value::Boolean(*standing == Standing::Inside));
    let entries = [
        (words("points", "points"), image),
        (words("inside", "dedans"), Value::list(inside.collect())),
    ];
    entry(&entries, &a.text(4)?)
}

/// What is nearer to the cage, in sizes of it, counts as in it.
const ACCURACY: f64 = 1e-12;

fn rough<S: Arithmetic>(shape: &Shape<S>) -> Result<Shape, Failure> {
    Ok(match shape {
        Shape::Form(form) => form.map_scalar(S::to_f64)?.into(),
        Shape::Spline(spline) => spline.map_scalar(S::to_f64)?.into(),
    })
}
