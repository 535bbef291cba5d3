//! What flows from cell to cell.

use pforms_kernel::{Form, Kind};
use pforms_mesh::Mesh;
use pforms_operators::{Immersed, Shape, Spline};

use crate::{Arithmetic, Failure, Language, Message, Words};

/// Values one list may hold, counting those of the lists inside it.
pub const LIST_CAP: usize = 1 << 20;

/// Lists inside lists inside lists: no deeper than this.
pub const DEPTH_CAP: usize = 64;

/// The value of a cell, of an argument, of a result.
///
/// Every number in it is finite. A failure is a value too: an operator given one returns it
/// unchanged, so it reaches every cell that depends on its origin.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Value<S = f64> {
    /// Nothing: the value of a cell that holds no text.
    #[default]
    Empty,
    /// A number.
    Number(S),
    /// True or false.
    Boolean(bool),
    /// Text.
    Text(String),
    /// A form; a point is a form without axes.
    Form(Form<S>),
    /// Forms end to end, with knots.
    Spline(Spline<S>),
    /// An immersed form that has not been expanded: host and inner.
    Immersed(Immersed<S>),
    /// Points and triangles: a solid, or a cloud of points. Its numbers are floating in both modes.
    Mesh(Mesh),
    /// Values in order; make one with [`Value::list`], which keeps it within bounds.
    List(Vec<Value<S>>),
    /// Named values in order, such as a frame.
    Record(Vec<(Words, Value<S>)>),
    /// What went wrong.
    Error(Failure),
}

impl<S: Arithmetic> Value<S> {
    /// A point with euclidean coordinates and, if it is not 1, a weight; weight 0 makes a direction.
    ///
    /// The value is an error when the coordinates are none or not finite.
    pub fn point(coordinates: &[S], weight: Option<S>) -> Self {
        let weight = weight.unwrap_or_else(S::one);
        Form::from_points(&[], coordinates.len(), coordinates, Some(&[weight])).into()
    }

    /// A list; an error among the items is returned instead.
    ///
    /// The value is an error above [`LIST_CAP`] items or [`DEPTH_CAP`] levels.
    pub fn list(items: Vec<Self>) -> Self {
        if let Some(failure) = items.iter().find(|item| item.is_error()) {
            return failure.clone();
        }
        let list = Self::List(items);
        let (size, depth) = (list.size(), list.depth());
        if size > LIST_CAP {
            return too_large(size, LIST_CAP, &words_items()).into();
        }
        if depth > DEPTH_CAP {
            return too_large(depth, DEPTH_CAP, &words_levels()).into();
        }
        list
    }

    /// Is this an error?
    pub fn is_error(&self) -> bool {
        matches!(self, Self::Error(_))
    }

    /// The error in it, if it is one.
    pub fn failure(&self) -> Option<&Failure> {
        match self {
            Self::Error(failure) => Some(failure),
            _ => None,
        }
    }

    /// The final value of a cell: a regular list of points becomes a form, anything else stays.
    ///
    /// A list of points whose rows differ in length is an error that names the lengths.
    #[must_use]
    pub fn settle(self) -> Self {
        match self {
            Self::List(items) if items.iter().all(Self::is_points) && !items.is_empty() => {
                crate::net::form_of_list(&items).into()
            }
            Self::List(items) => Self::list(items.into_iter().map(Self::settle).collect()),
            other => other,
        }
    }

    /// A point, or a list of nothing but points, at any depth.
    pub(crate) fn is_points(&self) -> bool {
        match self {
            Self::Form(form) => form.axes() == 0,
            Self::List(items) => !items.is_empty() && items.iter().all(Self::is_points),
            _ => false,
        }
    }

    /// Orders of a form, along each of its axes; those of the expansion of an immersed form.
    pub fn orders(&self) -> Option<Vec<usize>> {
        match self {
            Self::Form(form) => Some(form.orders().to_vec()),
            Self::Spline(pieces) => Some(pieces.net().orders().to_vec()),
            Self::Immersed(immersed) => Some(immersed.forecast().orders),
            _ => None,
        }
    }

    /// Bytes its numbers occupy; in exact mode the digits are not counted.
    pub fn bytes(&self) -> usize {
        match self {
            Self::Empty | Self::Boolean(_) => 0,
            Self::Number(_) => size_of::<S>(),
            Self::Text(text) => text.len(),
            Self::Form(form) => form.bytes(),
            Self::Spline(pieces) => pieces.net().bytes(),
            Self::Immersed(lazy) => lazy.inner().bytes() + lazy.host().bytes(),
            Self::Mesh(mesh) => mesh.bytes(),
            Self::List(items) => items.iter().map(Self::bytes).sum(),
            Self::Record(entries) => entries.iter().map(|(_, value)| value.bytes()).sum(),
            Self::Error(failure) => failure.message(Language::English).len(),
        }
    }

    fn size(&self) -> usize {
        match self {
            Self::List(items) => items.iter().map(Self::size).sum::<usize>().max(1),
            _ => 1,
        }
    }

    fn depth(&self) -> usize {
        match self {
            Self::List(items) => 1 + items.iter().map(Self::depth).max().unwrap_or(0),
            _ => 0,
        }
    }

    /// What it is, in a word: `number`, `pP`, `pS33`, `ipL3`, `spline of 4 pL3`, `list`, …
    pub fn kind(&self, language: Language) -> String {
        let word = match self {
            Self::Empty => Words { en: "empty", fr: "vide" },
            Self::Number(_) => Words { en: "number", fr: "nombre" },
            Self::Boolean(_) => Words { en: "boolean", fr: "booléen" },
            Self::Text(_) => Words { en: "text", fr: "texte" },
            Self::Form(form) => return form.kind().to_string(),
            Self::Spline(spline) => return of_pieces(spline, language),
            Self::Immersed(lazy) => return lazy.kind(),
            Self::Mesh(mesh) if mesh.vertex_count() == 0 => {
                Words { en: "empty solid", fr: "solide vide" }
            }
            Self::Mesh(mesh) if mesh.is_cloud() => Words { en: "cloud", fr: "nuage" },
            Self::Mesh(_) => Words { en: "mesh", fr: "maillage" },
            Self::List(_) => Words { en: "list", fr: "liste" },
            Self::Record(_) => Words { en: "record", fr: "fiche" },
            Self::Error(_) => Words { en: "error", fr: "erreur" },
        };
        word.get(language).to_owned()
    }
}

/// `spline of 4 pL3`, `spline of 2×3 pS33`.
fn of_pieces<S: Arithmetic>(spline: &Spline<S>, language: Language) -> String {
    let counts: Vec<String> = spline.counts().iter().map(usize::to_string).collect();
    let orders: Vec<usize> = spline.degrees().iter().map(|degree| degree + 1).collect();
    let of = crate::display::pick(language, "spline of", "spline de");
    format!("{of} {} {}", counts.join("×"), Kind::new(&orders))
}

fn words_items() -> Message {
    Message::new("a list", "une liste")
}

fn words_levels() -> Message {
    Message::new("a nesting of lists", "un emboîtement de listes")
}

fn too_large(count: usize, cap: usize, what: &Message) -> Failure {
    Failure::new(
        "Limit",
        format!("{} of {count}: refused, the cap is {cap}", what.en),
        format!("{} de {count} : refusé, le plafond est {cap}", what.fr),
    )
}

impl<S> From<Failure> for Value<S> {
    fn from(failure: Failure) -> Self {
        Self::Error(failure)
    }
}

impl<S> From<Form<S>> for Value<S> {
    fn from(form: Form<S>) -> Self {
        Self::Form(form)
    }
}

impl<S> From<Mesh> for Value<S> {
    fn from(mesh: Mesh) -> Self {
        Self::Mesh(mesh)
    }
}

impl<S: Arithmetic> From<Spline<S>> for Value<S> {
    /// A spline without axes is a point.
    fn from(spline: Spline<S>) -> Self {
        Shape::from(spline).into()
    }
}

impl<S> From<Shape<S>> for Value<S> {
    fn from(shape: Shape<S>) -> Self {
        match shape {
            Shape::Form(form) => Self::Form(form),
            Shape::Spline(spline) => Self::Spline(spline),
        }
    }
}

impl<S, T: Into<Value<S>>, E: Into<Failure>> From<Result<T, E>> for Value<S> {
    fn from(result: Result<T, E>) -> Self {
        match result {
            Ok(value) => value.into(),
            Err(error) => error.into().into(),
        }
    }
}
