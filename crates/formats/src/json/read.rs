//! JSON to forms.

use pforms_kernel::{Error, Form, Place, Result};
use pforms_operators::{Shape, Spline};
use serde::Deserialize;

use super::Number;
use super::poles::Array;
use crate::Named;

/// The version of the format this reads and writes.
pub(super) const VERSION: u64 = 1;

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    bound = "S: Number",
    expecting = "an object with `pforms`, the version, and `forms`"
)]
struct Document<S> {
    pforms: Version,
    forms: Vec<Entry<S>>,
}

#[derive(Deserialize)]
#[serde(try_from = "u64")]
struct Version;

impl TryFrom<u64> for Version {
    type Error = String;

    fn try_from(version: u64) -> std::result::Result<Self, String> {
        match version {
            VERSION => Ok(Self),
            other => Err(format!("version {other}; this program reads version {VERSION}")),
        }
    }
}

#[derive(Deserialize)]
#[serde(try_from = "Raw<S>", bound = "S: Number")]
struct Entry<S>(Named<S>);

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    bound = "S: Number",
    expecting = "an object with `orders`, `ambient` and `poles`, of a spline `degrees` and `knots`"
)]
struct Raw<S> {
    name: Option<String>,
    orders: Vec<usize>,
    ambient: usize,
    poles: Array<S>,
    degrees: Option<Vec<usize>>,
    knots: Option<Vec<Array<S>>>,
}

impl<S: Number> TryFrom<Raw<S>> for Entry<S> {
    type Error = String;

    fn try_from(raw: Raw<S>) -> std::result::Result<Self, String> {
        let said = |problem: String| match &raw.name {
            Some(name) => format!("form {name:?}: {problem}"),
            None => problem,
        };
        let Raw { orders, ambient, poles: Array { numbers, shape }, degrees, knots, .. } = raw;
        if ambient == usize::MAX {
            return Err(said(format!("ambient: {ambient} coordinates")));
        }
        let width = ambient + 1;
        let form = Form::from_homogeneous(&orders, ambient, numbers)
            .map_err(|error| said(error.to_string()))?;
        let nested =
            shape.split_last().is_some_and(|(last, rest)| *last == width && rest == orders);
        let listed = shape == [form.pole_count(), width];
        if shape.len() > 1 && !nested && !listed {
            return Err(said(format!("poles in an array of {shape:?}, orders {orders:?}")));
        }
        let shape = match (degrees, knots) {
            (None, None) => Shape::Form(form),
            (Some(degrees), Some(knots)) => {
                if let Some(list) = knots.iter().find(|list| list.shape.len() != 1) {
                    return Err(said(format!("knots in an array of {:?}", list.shape)));
                }
                let knots = knots.into_iter().map(|list| list.numbers).collect();
                let spline = Spline::new(form, &degrees, knots);
                spline.map_err(|error| said(error.to_string()))?.into()
            }
            _ => return Err(said("`degrees` and `knots` go together".to_owned())),
        };
        Ok(Self(Named { name: raw.name, shape }))
    }
}

/// Reads the forms of a document, in `f64` or in exact fractions.
///
/// Errors: `Format`, with line and column, for anything that is not such a document.
///
/// ```
/// use pforms_formats::json;
/// let text = br#"{"pforms": 1, "forms": [{"orders": [2], "ambient": 1, "poles": [0, 1, "1/2", 1]}]}"#;
/// let forms = json::read::<f64>(text)?;
/// assert_eq!(forms[0].net().at(&[0.5])?, [0.25]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn read<S: Number>(bytes: &[u8]) -> Result<Vec<Named<S>>> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    match serde_json::from_slice::<Document<S>>(bytes) {
        Ok(document) => {
            let Version = document.pforms;
            Ok(document.forms.into_iter().map(|Entry(named)| named).collect())
        }
        Err(error) => {
            let place = Place { line: error.line(), column: error.column() };
            let told = error.to_string();
            // The place is told by the error itself.
            let message =
                told.rsplit_once(" at line ").map_or(told.as_str(), |(message, _)| message);
            Err(Error::format("JSON", Some(place), message))
        }
    }
}
