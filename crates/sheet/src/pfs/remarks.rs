//! The comments of a sheet written by hand: kept with the line they stand by.

use std::collections::BTreeMap;
use std::mem;

use serde::{Deserialize, Serialize};

/// What stands above a line of the file, line by line, and beside it; without the `#`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Remark {
    /// Above the line.
    #[serde(default)]
    pub above: Vec<String>,
    /// Behind it.
    #[serde(default)]
    pub beside: Option<String>,
}

/// Remarks by the line they belong to, named by its table and key: `cells`, `cells.A1`,
/// `show.A4.draw`, `notes.0.text`, `pfs`; [`END`] is the end of the file.
pub type Remarks = BTreeMap<String, Remark>;

/// The name of the end of the file.
pub(crate) const END: &str = "";

/// The comments of a text that is known to be TOML.
pub(super) fn remarks(source: &str) -> Remarks {
    let mut reader = Reader::default();
    for line in source.lines() {
        reader.line(line);
    }
    let above = mem::take(&mut reader.waiting);
    if !above.is_empty() {
        reader.remarks.entry(END.to_owned()).or_default().above = above;
    }
    reader.remarks
}

#[derive(Default)]
struct Reader {
    remarks: Remarks,
    /// Comments whose line has not come yet.
    waiting: Vec<String>,
    table: String,
    notes: usize,
    /// The line that is being read, and what of it is open.
    name: String,
    quote: Option<&'static str>,
    depth: usize,
}

impl Reader {
    fn line(&mut self, line: &str) {
        let fresh = self.quote.is_none() && self.depth == 0;
        if fresh {
            let bare = line.trim_start();
            if let Some(comment) = bare.strip_prefix('#') {
                return self.waiting.push(text(comment));
            }
            if bare.is_empty() {
                return;
            }
            self.name = self.named(bare);
            let above = mem::take(&mut self.waiting);
            if !above.is_empty() {
                self.remarks.entry(self.name.clone()).or_default().above.extend(above);
            }
        }
        let Some(comment) = self.scan(line) else { return };
        let remark = self.remarks.entry(self.name.clone()).or_default();
        match &remark.beside {
            // Inside a list of several lines, which becomes one.
            None if self.depth == 0 => remark.beside = Some(comment),
            _ => remark.above.push(comment),
        }
    }

    /// The name of a line: of a header, or of a key.
    fn named(&mut self, line: &str) -> String {
        if let Some(header) = line.strip_prefix('[') {
            let header = header.trim_start_matches('[');
            let name = plain(&header[..end_of_key(header, ']')]);
            self.table = if name == "notes" {
                self.notes += 1;
                format!("notes.{}", self.notes - 1)
            } else {
                addressed(name)
            };
            return self.table.clone();
        }
        let key = plain(&line[..end_of_key(line, '=')]);
        if self.table.is_empty() {
            addressed(key)
        } else {
            addressed(format!("{}.{key}", self.table))
        }
    }

    /// Goes over a line, its texts and brackets; the comment behind it.
    fn scan(&mut self, line: &str) -> Option<String> {
        let mut rest = line;
        while let Some(c) = rest.chars().next() {
            let step = match self.quote {
                Some(quote) if rest.starts_with(quote) => {
                    self.quote = None;
                    // A long text may end in quotes of its own.
                    let own = rest[quote.len()..]
                        .bytes()
                        .take(2)
                        .take_while(|b| quote.as_bytes()[0] == *b);
                    quote.len() + if quote.len() == 3 { own.count() } else { 0 }
                }
                Some(quote) if c == '\\' && quote.starts_with('"') => {
                    1 + rest[1..].chars().next().map_or(0, char::len_utf8)
                }
                Some(_) => c.len_utf8(),
                None => match c {
                    '#' => return Some(text(&rest[1..])),
                    '"' | '\'' => {
                        let quotes = ["\"\"\"", "'''", "\"", "'"];
                        let quote = quotes.into_iter().find(|quote| rest.starts_with(quote));
                        self.quote = quote;
                        quote.map_or(1, str::len)
                    }
                    '[' | '{' => {
                        self.depth += 1;
                        1
                    }
                    ']' | '}' => {
                        self.depth = self.depth.saturating_sub(1);
                        1
                    }
                    other => other.len_utf8(),
                },
            };
            rest = &rest[step..];
        }
        // Only long texts go on.
        self.quote = self.quote.filter(|quote| quote.len() == 3);
        None
    }
}

/// A comment as it stands behind its `#`.
fn text(comment: &str) -> String {
    comment.trim_end().to_owned()
}

/// Where a key ends: at `stop`, outside quotes.
fn end_of_key(line: &str, stop: char) -> usize {
    let mut quote = None;
    let end = line.char_indices().find(|(_, c)| {
        match quote {
            Some(open) if open == *c => quote = None,
            None if matches!(c, '"' | '\'') => quote = Some(*c),
            _ => {}
        }
        quote.is_none() && *c == stop
    });
    end.map_or(line.len(), |(at, _)| at)
}

/// A key without spaces and quotes.
fn plain(key: &str) -> String {
    key.split('.').map(|part| part.trim().trim_matches(['"', '\''])).collect::<Vec<_>>().join(".")
}

/// Addresses in capitals, as they are written.
fn addressed(name: String) -> String {
    let mut parts = name.split('.');
    match (parts.next(), parts.next()) {
        (Some(table @ ("cells" | "show")), Some(at)) => {
            let rest = &name[table.len() + 1 + at.len()..];
            format!("{table}.{}{rest}", at.to_ascii_uppercase())
        }
        _ => name,
    }
}
