//! A text as words, each with its place.

use pforms_kernel::{Error, Place, Result};

/// The words of a text, in order.
pub(crate) struct Tokens<'a> {
    what: &'static str,
    text: &'a str,
    /// Where the next word is looked for.
    at: usize,
    /// Where the last word began.
    word: usize,
}

impl<'a> Tokens<'a> {
    /// Errors: `Format` when the bytes are not UTF-8.
    pub(crate) fn new(what: &'static str, bytes: &'a [u8]) -> Result<Self> {
        let text = std::str::from_utf8(bytes).map_err(|error| {
            let before = String::from_utf8_lossy(&bytes[..error.valid_up_to()]);
            Error::format(what, Some(place(&before)), "not text (UTF-8)")
        })?;
        let start = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        Ok(Self { what, text, at: start, word: start })
    }

    /// A [`Error::Format`] at the last word.
    pub(crate) fn error(&self, message: impl std::fmt::Display) -> Error {
        Error::format(self.what, Some(place(&self.text[..self.word])), message)
    }

    pub(crate) fn bytes_left(&self) -> usize {
        self.text.len() - self.at
    }

    fn next(&mut self) -> Option<&'a str> {
        let rest = &self.text[self.at..];
        let word = rest.trim_start();
        self.word = self.text.len() - word.len();
        let end = word.find(char::is_whitespace).unwrap_or(word.len());
        self.at = self.word + end;
        (end > 0).then(|| &word[..end])
    }

    fn parse<T: std::str::FromStr>(&mut self, wanted: &str, kind: &str) -> Result<T> {
        let Some(word) = self.next() else {
            return Err(self.error(format!("the file ends where {wanted} should stand")));
        };
        word.parse().map_err(|_| {
            let shown: String = word.chars().take(40).collect();
            self.error(format!("{shown:?} where {wanted}, {kind}, should stand"))
        })
    }

    /// The next word as a whole number, not negative.
    pub(crate) fn whole(&mut self, wanted: &str) -> Result<usize> {
        self.parse(wanted, "a whole number")
    }

    /// The next word as a finite number.
    pub(crate) fn number(&mut self, wanted: &str) -> Result<f64> {
        let number: f64 = self.parse(wanted, "a number")?;
        if number.is_finite() {
            return Ok(number);
        }
        Err(self.error(format!("{number} where {wanted}, a finite number, should stand")))
    }

    /// Complains unless nothing but space is left.
    pub(crate) fn end(&mut self, after: &str) -> Result<()> {
        match self.next() {
            None => Ok(()),
            Some(word) => {
                let shown: String = word.chars().take(40).collect();
                Err(self.error(format!("{shown:?} after {after}, where the file should end")))
            }
        }
    }
}

/// The place just after a text.
fn place(before: &str) -> Place {
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().map_or(0, |last| last.chars().count()) + 1;
    Place { line, column }
}
