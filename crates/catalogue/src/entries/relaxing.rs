//! Surfaces of little area on a boundary.

use pforms_kernel::{Rational, Traced};
use pforms_operators::{self as operators, Functional, MinimalOptions, Poles, Shape};

use super::{Outcome, PLAIN, part};
use crate::cost::{require_system, workable};
use crate::operator::{Call, Group};
use crate::parameter::Fallback;
use crate::words::words;
use crate::{Arithmetic, Bound, Failure, Operator, Parameter, Takes, Value, Words};

const KINDS: &[Words] = &[
    words("dirichlet", "dirichlet"),
    words("harmonic", "harmonique"),
    words("laplace", "laplace"),
    words("area", "aire"),
];

const PARTS: &[Words] = &[
    words("surface", "surface"),
    words("area", "aire"),
    words("error", "écart"),
    words("coons", "coons"),
    words("energy", "énergie"),
    words("laplacian", "laplacien"),
    words("curvature", "courbure"),
    words("slope", "pente"),
    words("steps", "pas"),
    words("report", "fiche"),
];

pub(super) static ENTRIES: &[Operator] = &[Operator {
    name: "minimal",
    english: &["MINIMAL"],
    french: &["MINIMAL"],
    group: Group::Inside,
    summary: words(
        "A surface of little area on a given boundary.",
        "Une surface de petite aire sur un bord donné.",
    ),
    help: words(
        "The boundary is that of one form, whose inner poles are not looked at, or faces in the order of \
         COONS. kind = \"dirichlet\" makes the energy of a stretched skin least, \"harmonic\" comes nearest \
         to ΔS = 0, \"laplace\" makes each pole the mean of its neighbours: three linear systems, exact. \
         \"area\" goes down on the area itself, never above the Coons patch. part = \"report\" gives all that \
         is known: area, coons (the area of that patch), energy, laplacian, curvature, slope, steps.",
        "Le bord est celui d'une forme, dont les pôles intérieurs ne comptent pas, ou des faces dans \
         l'ordre de COONS. genre = \"dirichlet\" rend minimale l'énergie d'une peau tendue, \"harmonique\" \
         approche au mieux ΔS = 0, \"laplace\" fait de chaque pôle la moyenne de ses voisins : trois \
         systèmes linéaires, exacts. \"aire\" descend sur l'aire elle-même, jamais au-dessus du carreau de \
         Coons. partie = \"fiche\" donne tout ce qu'on sait : aire, coons (l'aire de ce carreau), énergie, \
         laplacien, courbure, pente, pas.",
    ),
    parameters: &[
        Parameter::new(
            Takes::Form,
            words("boundary", "bord"),
            words("One form, or two faces for each axis.", "Une forme, ou deux faces par axe."),
        )
        .variadic(),
        Parameter::new(
            Takes::Text,
            words("kind", "genre"),
            words("What is made least.", "Ce qu'on rend minimal."),
        )
        .or(Fallback::Text("dirichlet"))
        .choices(KINDS),
        Parameter::new(
            Takes::Wholes,
            words("orders", "ordres"),
            words(
                "Orders to raise the boundary to: more poles to move.",
                "Ordres auxquels élever le bord : plus de pôles à déplacer.",
            ),
        )
        .range(1.0, 256.0)
        .or_absent("those of the boundary", "ceux du bord"),
        Parameter::new(
            Takes::Numbers,
            words("sides", "côtés"),
            words(
                "Lengths of the sides of the parameters' box.",
                "Longueurs des côtés du pavé des paramètres.",
            ),
        )
        .or_absent("those of the window", "ceux de la fenêtre"),
        Parameter::new(
            Takes::List,
            words("keep", "garder"),
            words(
                "Places of inner poles that stay: [[i, j], …].",
                "Places de pôles intérieurs qui restent : [[i, j], …].",
            ),
        )
        .or_absent("none", "aucune"),
        Parameter::new(
            Takes::Number,
            words("accuracy", "précision"),
            words(
                "Of \"area\": the slope at which the descent ends.",
                "Pour \"aire\" : la pente à laquelle la descente s'arrête.",
            ),
        )
        .range(0.0, 1.0)
        .or_absent("1e-9", "1e-9"),
        part("surface", PARTS),
    ],
    example: "=MINIMAL([(0, 0, 0), (1, 0, 1), (2, 0, 0)], [(0, 2, 0), (1, 2, 1), (2, 2, 0)], \
              [(0, 0, 0), (0, 1, -1), (0, 2, 0)], [(2, 0, 0), (2, 1, -1), (2, 2, 0)])",
    source: "book 0233, 37; Monterde 2004",
    see: &["coons", "unroll"],
    call: Call { floating, exact: Some(linear::<Rational>), traced: Some(linear::<Traced>) },
    ..PLAIN
}];

const LINEAR: Words = Words {
    en: "\"dirichlet\", \"harmonic\" or \"laplace\" in exact mode",
    fr: "\"dirichlet\", \"harmonique\" ou \"laplace\" en mode exact",
};

const SURFACE: Words = Words {
    en: "\"surface\" in exact mode: areas are roots",
    fr: "\"surface\" en mode exact : les aires sont des racines",
};

const NOT_WITH_KIND: Words = Words {
    en: "no accuracy, as this kind is a linear system",
    fr: "pas de précision, ce genre étant un système linéaire",
};

fn functional<S: Arithmetic>(a: &Bound<S>) -> Result<Option<Functional>, Failure> {
    let functional = match a.choice(1)? {
        "dirichlet" => Functional::Dirichlet,
        "harmonic" => Functional::Harmonic,
        "laplace" => Functional::Laplace,
        _ => return Ok(None),
    };
    if a.is_given(5) {
        return Err(a.refused(5, &a.value(5), NOT_WITH_KIND));
    }
    Ok(Some(functional))
}

/// The boundary, and what is asked of the surface on it.
fn asked<S: Arithmetic>(a: &Bound<S>) -> Result<(Vec<Shape<S>>, MinimalOptions<S>), Failure> {
    let boundary = a.shapes(0)?;
    for shape in &boundary {
        workable(shape.net().clone())?;
    }
    let axes = match &boundary[..] {
        [single] => single.net().axes(),
        faces => faces.len() / 2,
    };
    let orders = if a.is_given(2) { a.wholes(2, axes)? } else { Vec::new() };
    let sides = if a.is_given(3) { a.numbers(3, axes)? } else { Vec::new() };
    let keep = if a.is_given(4) { places(a)? } else { Vec::new() };
    require_system(&boundary, &orders)?;
    Ok((boundary, MinimalOptions { orders, sides, keep }))
}

fn places<S: Arithmetic>(a: &Bound<S>) -> Result<Vec<Vec<usize>>, Failure> {
    let place = |item: &Value<S>| match item {
        Value::List(numbers) => numbers.iter().map(|number| a.whole_of(4, number)).collect(),
        other => Err(a.mistyped(4, other)),
    };
    a.list(4)?.iter().map(place).collect()
}

fn linear<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let Some(functional) = functional(a)? else { return Err(a.refused(1, &a.value(1), LINEAR)) };
    if a.choice(6)? != "surface" {
        return Err(a.refused(6, &a.value(6), SURFACE));
    }
    let (boundary, options) = asked(a)?;
    Ok(value(operators::extremal(&boundary, functional, &options)?))
}

fn floating(a: &Bound<f64>) -> Outcome<f64> {
    let functional = functional(a)?;
    let (boundary, options) = asked(a)?;
    let part = a.choice(6)?;
    let polynomial = boundary.iter().all(|shape| shape.net().uniform_weight().is_some());
    if let Some(functional) = functional
        && part == "surface"
        && polynomial
    {
        return Ok(value(operators::extremal(&boundary, functional, &options)?));
    }
    let accuracy = if a.is_given(5) { a.number(5)? } else { 1e-9 };
    let found = operators::minimal(&boundary, functional, &options, accuracy)?;
    let optional = |number: Option<f64>| number.map_or(Value::Empty, Value::Number);
    let mut entries = vec![
        Value::Number(found.area),
        Value::Number(found.error),
        optional(found.coons_area),
        Value::Number(found.energy),
        Value::Number(found.laplacian),
        Value::Number(found.curvature),
        Value::Number(found.slope),
        Value::Number(found.steps as f64),
    ];
    entries.insert(0, value(found.surface));
    let mut named = PARTS.iter().copied().zip(entries);
    Ok(match part {
        "report" => Value::Record(named.collect()),
        part => named.find(|(name, _)| name.en == part).map_or(Value::Empty, |(_, value)| value),
    })
}

fn value<S: Arithmetic>(shape: Shape<S>) -> Value<S> {
    match shape {
        Shape::Form(form) => form.into(),
        Shape::Spline(spline) => spline.into(),
    }
}
