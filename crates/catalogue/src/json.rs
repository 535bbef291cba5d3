//! Values as JSON, for programs that ask for a cell.

use pforms_kernel::Form;
use pforms_operators::Knots;
use serde_json::{Map, Value as Json, json};

use crate::{Arithmetic, Language, Value};

impl<S: Arithmetic> Value<S> {
    /// The value as JSON.
    ///
    /// Numbers are numbers, or strings such as `"1/3"` in exact mode. A form is an object with
    /// `kind`, `orders`, `ambient`, `rational` and `poles`: homogeneous, nested by axis, the
    /// weight last; a spline has `piecewise`, `degrees` and `knots` beside those of its net.
    /// A mesh has `kind`, `ambient`, `vertices` and `triangles`. An error is `{"error": {family, message, hint, origin}}`.
    pub fn to_json(&self) -> Json {
        match self {
            Self::Empty => Json::Null,
            Self::Number(x) => x.json(),
            Self::Boolean(value) => (*value).into(),
            Self::Text(text) => text.as_str().into(),
            Self::Form(form) => of_form(form),
            Self::Spline(pieces) => {
                let mut object = of_form(pieces.net());
                object["piecewise"] = true.into();
                object["degrees"] = json!(pieces.degrees());
                let list = |knots: &Knots<S>| knots.as_slice().iter().map(S::json).collect();
                let knots: Vec<Json> = pieces.knots().iter().map(list).collect();
                object["knots"] = knots.into();
                object
            }
            Self::Immersed(lazy) => json!({
                "kind": lazy.kind(),
                "orders": lazy.forecast().orders,
                "host": of_form(lazy.host()),
                "inner": of_form(lazy.inner()),
            }),
            Self::Mesh(mesh) => json!({
                "kind": self.kind(Language::English),
                "ambient": mesh.ambient(),
                "vertices": mesh.vertices().chunks_exact(mesh.ambient()).collect::<Vec<_>>(),
                "triangles": mesh.triangles(),
            }),
            Self::List(items) => items.iter().map(Self::to_json).collect(),
            Self::Record(entries) => entries
                .iter()
                .map(|(name, value)| (name.en.to_owned(), value.to_json()))
                .collect::<Map<_, _>>()
                .into(),
            Self::Error(failure) => json!({ "error": {
                "family": failure.family(),
                "message": failure.message(Language::English),
                "hint": failure.hint(Language::English),
                "origin": failure.origin(),
            }}),
        }
    }
}

fn of_form<S: Arithmetic>(form: &Form<S>) -> Json {
    json!({
        "kind": form.kind().to_string(),
        "orders": form.orders(),
        "ambient": form.ambient(),
        "rational": form.is_rational(),
        "poles": nested(form.homogeneous(), form.orders(), form.width()),
    })
}

fn nested<S: Arithmetic>(numbers: &[S], orders: &[usize], width: usize) -> Json {
    match orders.split_first() {
        None => numbers.iter().map(S::json).collect(),
        Some((&order, rest)) => numbers
            .chunks_exact((numbers.len() / order).max(width))
            .map(|part| nested(part, rest, width))
            .collect(),
    }
}
