//! The short text of a value, as a cell shows it.

use pforms_kernel::{Form, Scalar};
use pforms_mesh::Mesh;

use crate::{Arithmetic, Language, Value};

/// Items of a list that are written out.
const SHOWN: usize = 6;

/// Lists in lists that are written out; deeper ones only tell how long they are.
const LEVELS: usize = 2;

/// Characters of a number that a cell has room for.
const ROOM: usize = 40;

/// Longest text that is repeated in an error.
const QUOTED: usize = 30;

impl<S: Arithmetic> Value<S> {
    /// The short text a cell shows: `0.25`, `1/3`, `(1, 2, 3; 0.5)`, `pS33 · 3D · rational`,
    /// `spline of 4 pL3 · 2D`.
    pub fn display(&self, language: Language) -> String {
        match self {
            Self::Empty => String::new(),
            Self::Number(x) => short(x),
            Self::Boolean(value) => boolean(*value, language).to_owned(),
            Self::Text(text) => text.clone(),
            Self::Form(form) if form.axes() == 0 => point(form),
            Self::Form(form) => of_form(&form.kind().to_string(), form, language),
            Self::Spline(spline) => of_form(&self.kind(language), spline.net(), language),
            Self::Immersed(lazy) => {
                let word = pick(language, "not expanded", "non développée");
                format!("{} · {}D · {word}", lazy.kind(), lazy.host().ambient())
            }
            Self::Mesh(mesh) => of_mesh(&self.kind(language), mesh, language),
            Self::List(items) => list(items, language, LEVELS),
            Self::Record(entries) => {
                let entry = |(name, value): &(crate::Words, Self)| {
                    format!("{}: {}", name.get(language), value.display(language))
                };
                entries.iter().map(entry).collect::<Vec<_>>().join(" · ")
            }
            Self::Error(failure) => failure.message(language).to_owned(),
        }
    }

    /// What it is and, if that is short, its text: how an error speaks of it.
    pub(crate) fn said(&self, language: Language) -> String {
        match self {
            Self::Text(text) if text.chars().count() <= QUOTED => match language {
                Language::English => format!("the text “{text}”"),
                Language::French => format!("le texte « {text} »"),
            },
            Self::Empty => pick(language, "an empty cell", "une cellule vide").to_owned(),
            Self::Number(x) => {
                let text = x.write();
                if text.len() <= QUOTED { text } else { self.kind(language) }
            }
            Self::Boolean(value) => boolean(*value, language).to_owned(),
            Self::List(items) => match language {
                Language::English => format!("a list of {}", items.len()),
                Language::French => format!("une liste de {}", items.len()),
            },
            _ => self.kind(language),
        }
    }
}

/// A number as a cell has room for it: a fraction of many digits as the decimal nearest to it.
fn short<S: Arithmetic>(x: &S) -> String {
    let text = x.write();
    if text.len() <= ROOM { text } else { format!("≈ {}", x.to_f64().write()) }
}

pub(crate) fn pick(language: Language, en: &'static str, fr: &'static str) -> &'static str {
    match language {
        Language::English => en,
        Language::French => fr,
    }
}

fn boolean(value: bool, language: Language) -> &'static str {
    if value { pick(language, "TRUE", "VRAI") } else { pick(language, "FALSE", "FAUX") }
}

fn of_form<S: Scalar>(kind: &str, form: &Form<S>, language: Language) -> String {
    let text = format!("{kind} · {}D", form.ambient());
    if form.is_rational() {
        format!("{text} · {}", pick(language, "rational", "rationnelle"))
    } else {
        text
    }
}

/// `mesh · 254 vertices · 504 triangles`, `cloud · 2D · 1000 points`.
fn of_mesh(kind: &str, mesh: &Mesh, language: Language) -> String {
    let (vertices, triangles) = (mesh.vertex_count(), mesh.triangles().len());
    if vertices == 0 {
        return kind.to_owned();
    }
    if mesh.is_cloud() {
        return format!("{kind} · {}D · {vertices} points", mesh.ambient());
    }
    let word = pick(language, "vertices", "sommets");
    format!("{kind} · {vertices} {word} · {triangles} triangles")
}

/// A point as the formula language writes it, the weight set off by a semicolon.
fn point<S: Arithmetic>(form: &Form<S>) -> String {
    let (coordinates, weight) = form.homogeneous().split_at(form.ambient());
    let divide = |x: &S| {
        if weight[0].is_zero() { short(x) } else { short(&(x.clone() / weight[0].clone())) }
    };
    let numbers: Vec<String> = coordinates.iter().map(divide).collect();
    let numbers = numbers.join(", ");
    if weight[0] != S::one() {
        format!("({numbers}; {})", short(&weight[0]))
    } else if form.ambient() == 1 {
        format!("({numbers},)")
    } else {
        format!("({numbers})")
    }
}

fn list<S: Arithmetic>(items: &[Value<S>], language: Language, levels: usize) -> String {
    let entry = |item: &Value<S>| match item {
        Value::List(inner) => list(inner, language, levels - 1),
        other => other.display(language),
    };
    let written = if levels == 0 { 0 } else { SHOWN };
    let mut shown: Vec<String> = items.iter().take(written).map(entry).collect();
    if items.len() > written {
        shown.push(format!("… ({})", items.len()));
    }
    format!("[{}]", shown.join(", "))
}
