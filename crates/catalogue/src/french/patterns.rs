//! Whole phrases with holes: `{}` stands for what an error put there, which is translated in its turn.

/// The French of a phrase that one of the patterns is, the most exact of them.
pub(super) fn translated(english: &str, inner: &dyn Fn(&str) -> String) -> Option<String> {
    let fits = super::phrases::PATTERNS.iter().chain(super::measures::PATTERNS);
    let fits = fits.filter_map(|(from, to)| Some((from, to, holes(from, english)?)));
    let (_, to, holes) = fits.max_by_key(|(from, _, _)| from.replace("{}", "").len())?;
    let mut holes = holes.into_iter().map(inner);
    let mut parts = to.split("{}");
    let mut french = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        french.push_str(&holes.next().unwrap_or_default());
        french.push_str(part);
    }
    Some(french)
}

/// What stands in the holes of a pattern, each as short as can be; none if the text is another.
fn holes<'a>(pattern: &str, text: &'a str) -> Option<Vec<&'a str>> {
    let mut literals = pattern.split("{}");
    let mut rest = text.strip_prefix(literals.next()?)?;
    let mut found = Vec::new();
    let mut literals = literals.peekable();
    while let Some(literal) = literals.next() {
        let at = match literals.peek() {
            Some(_) => rest.find(literal).filter(|_| !literal.is_empty())?,
            None if rest.ends_with(literal) => rest.len() - literal.len(),
            None => return None,
        };
        if at == 0 {
            return None;
        }
        found.push(&rest[..at]);
        rest = &rest[at + literal.len()..];
    }
    rest.is_empty().then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_in_holes() {
        assert_eq!(holes("a {} in {}D", "a pL3 in 2D"), Some(vec!["pL3", "2"]));
        assert_eq!(holes("a {} in {}D", "a pL3 in dimension 2"), None);
        assert_eq!(holes("a point", "a point"), Some(vec![]));
        assert_eq!(holes("a point", "a point or"), None);
    }
}
