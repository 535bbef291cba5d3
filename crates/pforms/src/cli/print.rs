//! Standard output, whose reader may go away at any time (`pforms eval … | head`).

use std::io::{self, Write};

/// Prints lines; one that nobody reads any more ends the program as if all had been read.
pub(crate) fn lines<T: AsRef<str>>(lines: impl IntoIterator<Item = T>) -> io::Result<()> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    let mut each = lines.into_iter();
    match each.try_for_each(|line| writeln!(out, "{}", line.as_ref())).and_then(|()| out.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        other => other,
    }
}

/// Columns of text, each as wide as its widest entry; the last one is not padded.
pub(crate) fn table(rows: &[Vec<String>]) -> Vec<String> {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns)
        .map(|k| {
            rows.iter().filter_map(|row| row.get(k)).map(|x| x.chars().count()).max().unwrap_or(0)
        })
        .collect();
    let padded = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).map(|(text, width)| {
            let missing = width - text.chars().count();
            text.clone() + &" ".repeat(missing)
        });
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    rows.iter().map(padded).collect()
}

#[cfg(test)]
mod tests {
    #[test]
    fn columns_line_up() {
        let row = |a: &str, b: &str| vec![a.to_owned(), b.to_owned()];
        assert_eq!(super::table(&[row("é", "x"), row("abc", "y")]), ["é    x", "abc  y"]);
    }

    #[test]
    fn a_column_may_be_wider_than_a_format_allows() {
        let wide = "x".repeat(70_000);
        let rows = [vec![wide.clone(), "y".to_owned()], vec!["a".to_owned()]];
        assert_eq!(super::table(&rows), [format!("{wide}  y"), "a".to_owned()]);
    }
}
