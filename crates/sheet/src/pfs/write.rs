//! Writing, always in the same order and spelling.

use std::fmt::Write;
use std::mem;

use serde_json::Value;

use super::VERSION;
use super::remarks::{END, Remark, Remarks};
use crate::{Document, Settings};

/// The text of a sheet: the same document always gives the same bytes.
pub fn write(document: &Document) -> String {
    let mut writer = Writer { out: String::new(), remarks: document.remarks.clone() };
    writer.line("pfs", &format!("pfs = {VERSION}"));
    for (key, title) in &document.titles {
        writer.entry("", key, &Value::from(title.as_str()));
    }
    if !document.cells.is_empty() {
        writer.header("cells", "[cells]");
        for (at, text) in &document.cells {
            writer.entry("cells", &at.to_string(), &Value::from(text.as_str()));
        }
    }
    if !document.names.is_empty() {
        writer.header("names", "[names]");
        for name in document.names.values() {
            writer.entry("names", &name.spelling, &Value::from(name.target.to_string()));
        }
    }
    for (at, settings) in &document.shown {
        writer.section(&format!("show.{at}"), &format!("[show.{at}]"), settings);
    }
    if !document.camera.is_empty() {
        writer.section("camera", "[camera]", &document.camera);
    }
    for (number, note) in document.notes.iter().enumerate() {
        writer.section(&format!("notes.{number}"), "[[notes]]", note);
    }
    writer.finish()
}

/// Writes lines with what was remarked on them.
struct Writer {
    out: String,
    /// What has not been written yet.
    remarks: Remarks,
}

impl Writer {
    fn section(&mut self, name: &str, header: &str, settings: &Settings) {
        self.header(name, header);
        for (key, item) in settings {
            self.entry(name, key, item);
        }
    }

    fn header(&mut self, name: &str, header: &str) {
        self.out.push('\n');
        self.line(name, header);
    }

    fn entry(&mut self, table: &str, key: &str, item: &Value) {
        let mut line = String::new();
        push_key(&mut line, key);
        line.push_str(" = ");
        push_value(&mut line, item);
        let name = if table.is_empty() { key.to_owned() } else { format!("{table}.{key}") };
        self.line(&name, &line);
    }

    fn line(&mut self, name: &str, line: &str) {
        let Remark { above, beside } = self.remarks.remove(name).unwrap_or_default();
        for comment in &above {
            self.comment(comment);
        }
        self.out.push_str(line);
        match beside {
            Some(comment) => {
                self.out.push_str("  ");
                self.comment(&comment);
            }
            None => self.out.push('\n'),
        }
    }

    fn comment(&mut self, comment: &str) {
        self.out.push('#');
        self.out.extend(comment.chars().filter(|c| *c == '\t' || !c.is_control()));
        self.out.push('\n');
    }

    /// What was remarked on lines that are gone, and at the end.
    fn finish(mut self) -> String {
        let mut rest = mem::take(&mut self.remarks);
        let last = rest.remove(END);
        let left = rest.into_values().chain(last);
        let left: Vec<String> =
            left.flat_map(|remark| remark.above.into_iter().chain(remark.beside)).collect();
        if !left.is_empty() {
            self.out.push('\n');
        }
        for comment in &left {
            self.comment(comment);
        }
        self.out
    }
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
