//! Writing, always in the same order and spelling.

use std::fmt::Write;

use serde_json::Value;

use super::VERSION;
use crate::{Document, Settings};

/// The text of a sheet: the same document always gives the same bytes.
pub fn write(document: &Document) -> String {
    let mut out = format!("pfs = {VERSION}\n");
    for (key, title) in &document.titles {
        entry(&mut out, key, &Value::from(title.as_str()));
    }
    if !document.cells.is_empty() {
        out.push_str("\n[cells]\n");
        for (at, text) in &document.cells {
            entry(&mut out, &at.to_string(), &Value::from(text.as_str()));
        }
    }
    if !document.names.is_empty() {
        out.push_str("\n[names]\n");
        for name in document.names.values() {
            entry(&mut out, &name.spelling, &Value::from(name.target.to_string()));
        }
    }
    for (at, settings) in &document.shown {
        section(&mut out, &format!("[show.{at}]"), settings);
    }
    if !document.camera.is_empty() {
        section(&mut out, "[camera]", &document.camera);
    }
    for note in &document.notes {
        section(&mut out, "[[notes]]", note);
    }
    out
}

fn section(out: &mut String, header: &str, settings: &Settings) {
    let _ = writeln!(out, "\n{header}");
    for (key, item) in settings {
        entry(out, key, item);
    }
}

fn entry(out: &mut String, key: &str, item: &Value) {
    push_key(out, key);
    out.push_str(" = ");
    push_value(out, item);
    out.push('\n');
}

fn push_key(out: &mut String, key: &str) {
    let bare = |b: u8| b.is_ascii_alphanumeric() || b == b'_' || b == b'-';
    if !key.is_empty() && key.bytes().all(bare) {
        out.push_str(key);
    } else {
        push_text(out, key);
    }
}

/// Values lie at most as deep as reading allows, so this recursion is short.
fn push_value(out: &mut String, item: &Value) {
    match item {
        Value::Null => out.push_str("\"\""),
        Value::Bool(value) => out.push_str(if *value { "true" } else { "false" }),
        Value::Number(number) => push_number(out, number),
        Value::String(text) => push_text(out, text),
        Value::Array(items) => {
            out.push('[');
            for (i, item) in items.iter().enumerate() {
                out.push_str(if i > 0 { ", " } else { "" });
                push_value(out, item);
            }
            out.push(']');
        }
        Value::Object(entries) => {
            out.push_str("{ ");
            for (i, (key, item)) in entries.iter().enumerate() {
                out.push_str(if i > 0 { ", " } else { "" });
                push_key(out, key);
                out.push_str(" = ");
                push_value(out, item);
            }
            out.push_str(" }");
        }
    }
}

/// The shortest decimal that reads back as the same number.
fn push_number(out: &mut String, number: &serde_json::Number) {
    let _ = match number.as_i64() {
        Some(integer) => write!(out, "{integer}"),
        None => write!(out, "{:?}", number.as_f64().unwrap_or_default()),
    };
}

fn push_text(out: &mut String, text: &str) {
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04X}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
}
