//! Reading, strictly: whatever would be lost is an error that names its line and column.

use std::ops::Range;

use pforms_formula::Address;
use pforms_kernel::{Error, Place, Result};
use serde_json::Value;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::VERSION;
use super::remarks::remarks;
use crate::document::Name;
use crate::name::{check_name, folded};
use crate::settings::DEPTH;
use crate::{Document, Settings, Target};

type Key<'a> = Spanned<std::borrow::Cow<'a, str>>;
type Item<'a> = Spanned<DeValue<'a>>;

/// Reads a sheet.
///
/// Errors: `Format`, with line and column, for a text that is not TOML, a version that is newer
/// than [`VERSION`], an unknown key, a wrong type, an impossible address or name, a cell given
/// twice.
///
/// ```
/// let error = pforms_sheet::pfs::read("pfs = 1\n[cells]\nA0 = \"1\"\n").unwrap_err();
/// assert!(error.to_string().starts_with("sheet, line 3, column 1: \"A0\" is no address"));
/// ```
pub fn read(source: &str) -> Result<Document> {
    let reader = Reader { source };
    let table = DeTable::parse(source).map_err(|error| {
        let place = error.span().unwrap_or(0..0);
        reader.error(&place, error.message())
    })?;
    let mut document = reader.document(table.get_ref())?;
    document.remarks = remarks(source);
    Ok(document)
}

/// [`read`] for a file of unknown content.
///
/// Errors: as [`read`]; bytes that are no text are reported by their place too.
pub fn read_bytes(bytes: &[u8]) -> Result<Document> {
    match std::str::from_utf8(bytes) {
        Ok(source) => read(source),
        Err(error) => {
            let (good, _) = bytes.split_at(error.valid_up_to());
            let source = std::str::from_utf8(good).unwrap_or_default();
            Err(Reader { source }.error(&(good.len()..good.len()), "not a text in UTF-8"))
        }
    }
}

struct Reader<'a> {
    source: &'a str,
}

impl Reader<'_> {
    fn document(&self, table: &DeTable<'_>) -> Result<Document> {
        self.version(table)?;
        let mut document = Document::default();
        for (key, item) in table {
            match key.get_ref().as_ref() {
                "pfs" => {}
                "cells" => self.cells(item, &mut document)?,
                "names" => self.names(item, &mut document)?,
                "show" => self.shown(item, &mut document)?,
                "camera" => document.camera = self.settings(item)?,
                "notes" => document.notes = self.notes(item)?,
                title if is_title(title) => {
                    document.titles.insert(title.to_owned(), self.text(item)?.to_owned());
                }
                other => {
                    let known = "pfs, title, cells, names, show, camera and notes";
                    return Err(self.error(
                        &key.span(),
                        format!("unknown key {other:?}; a sheet has {known}"),
                    ));
                }
            }
        }
        Ok(document)
    }

    fn version(&self, table: &DeTable<'_>) -> Result<()> {
        let Some((_, item)) = table.iter().find(|(key, _)| key.get_ref() == "pfs") else {
            return Err(self.error(&(0..0), "not a sheet: it does not say pfs = 1"));
        };
        let version = match item.get_ref() {
            DeValue::Integer(digits) => i64::from_str_radix(digits.as_str(), digits.radix()).ok(),
            _ => None,
        };
        match version {
            Some(1..=VERSION) => Ok(()),
            Some(newer) if newer > VERSION => Err(self.error(
                &item.span(),
                format!("version {newer} of the format; this program reads up to {VERSION}: a newer one is needed"),
            )),
            _ => Err(self.error(&item.span(), "pfs is the version of the format, 1")),
        }
    }

    fn cells(&self, item: &Item<'_>, document: &mut Document) -> Result<()> {
        for (key, item) in self.table(item)? {
            let at = self.address(key)?;
            let text = match item.get_ref() {
                DeValue::Integer(_) | DeValue::Float(_) => self.number(item)?.to_string(),
                _ => self.text(item)?.to_owned(),
            };
            if document.cells.insert(at, text).is_some() {
                return Err(self.error(&key.span(), format!("cell {at} is given twice")));
            }
        }
        document.cells.retain(|_, text| !text.is_empty());
        Ok(())
    }

    fn names(&self, item: &Item<'_>, document: &mut Document) -> Result<()> {
        for (key, item) in self.table(item)? {
            let spelling = key.get_ref().to_string();
            let at_key = |error: Error| self.error(&key.span(), message(&error));
            check_name(&spelling).map_err(at_key)?;
            let target = Target::read(self.text(item)?)
                .map_err(|error| self.error(&item.span(), message(&error)))?;
            let name = Name { spelling, target };
            if let Some(twin) = document.names.insert(folded(key.get_ref()), name) {
                let again = format!("the name {:?} is given twice", twin.spelling);
                return Err(self.error(&key.span(), again));
            }
        }
        Ok(())
    }

    fn shown(&self, item: &Item<'_>, document: &mut Document) -> Result<()> {
        for (key, item) in self.table(item)? {
            let at = self.address(key)?;
            if document.shown.insert(at, self.settings(item)?).is_some() {
                return Err(self.error(&key.span(), format!("show.{at} is given twice")));
            }
        }
        Ok(())
    }

    fn notes(&self, item: &Item<'_>) -> Result<Vec<Settings>> {
        match item.get_ref() {
            DeValue::Array(notes) => notes.iter().map(|note| self.settings(note)).collect(),
            other => Err(self.wrong_type(item, other, "tables [[notes]]")),
        }
    }

    fn settings(&self, item: &Item<'_>) -> Result<Settings> {
        let entries = self.table(item)?.iter();
        entries
            .map(|(key, item)| Ok((key.get_ref().to_string(), self.value(item, DEPTH)?)))
            .collect()
    }

    fn value(&self, item: &Item<'_>, depth: usize) -> Result<Value> {
        let Some(depth) = depth.checked_sub(1) else {
            let deep = format!("tables and lists lie more than {DEPTH} deep in one another");
            return Err(self.error(&item.span(), deep));
        };
        Ok(match item.get_ref() {
            DeValue::String(text) => Value::String(text.to_string()),
            DeValue::Boolean(value) => Value::Bool(*value),
            DeValue::Integer(_) | DeValue::Float(_) => Value::Number(self.number(item)?),
            DeValue::Array(items) => {
                let items = items.iter().map(|item| self.value(item, depth));
                Value::Array(items.collect::<Result<_>>()?)
            }
            DeValue::Table(entries) => {
                let entries = entries
                    .iter()
                    .map(|(key, item)| Ok((key.get_ref().to_string(), self.value(item, depth)?)));
                Value::Object(entries.collect::<Result<_>>()?)
            }
            other @ DeValue::Datetime(_) => {
                return Err(self.wrong_type(item, other, "a text, a number, a list or a table"));
            }
        })
    }

    fn number(&self, item: &Item<'_>) -> Result<serde_json::Number> {
        let number = match item.get_ref() {
            DeValue::Integer(digits) => {
                i64::from_str_radix(digits.as_str(), digits.radix()).ok().map(Into::into)
            }
            DeValue::Float(digits) => {
                digits.as_str().parse().ok().and_then(serde_json::Number::from_f64)
            }
            other => return Err(self.wrong_type(item, other, "a number")),
        };
        number.ok_or_else(|| self.error(&item.span(), "a number that is not finite or too large"))
    }

    fn table<'t, 'i>(&self, item: &'t Item<'i>) -> Result<&'t DeTable<'i>> {
        match item.get_ref() {
            DeValue::Table(table) => Ok(table),
            other => Err(self.wrong_type(item, other, "a table")),
        }
    }

    fn text<'t>(&self, item: &'t Item<'_>) -> Result<&'t str> {
        match item.get_ref() {
            DeValue::String(text) => Ok(text),
            other => Err(self.wrong_type(item, other, "a text in quotes")),
        }
    }

    fn address(&self, key: &Key<'_>) -> Result<Address> {
        key.get_ref().parse().map_err(|error| {
            self.error(&key.span(), format!("{:?} is no address: {error}", key.get_ref()))
        })
    }

    fn wrong_type(&self, item: &Item<'_>, found: &DeValue<'_>, expected: &str) -> Error {
        self.error(&item.span(), format!("expected {expected}, found {}", found.type_str()))
    }

    fn error(&self, place: &Range<usize>, message: impl std::fmt::Display) -> Error {
        let before = self.source.get(..place.start).unwrap_or(self.source);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let place = Place {
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
        };
        Error::format("sheet", Some(place), message)
    }
}

/// `title`, or `title_` and a language in small letters.
pub(crate) fn is_title(key: &str) -> bool {
    let language =
        |text: &str| (2..=8).contains(&text.len()) && text.bytes().all(|b| b.is_ascii_lowercase());
    key == "title" || key.strip_prefix("title_").is_some_and(language)
}

/// What an error of ours says, without the subject it names.
fn message(error: &Error) -> String {
    match error {
        Error::Format { message, .. } => message.clone(),
        other => other.to_string(),
    }
}
