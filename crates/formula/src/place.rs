//! Places in a source text.

/// A stretch of the source, in bytes; both ends lie between characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Span {
    /// First byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

impl Span {
    /// The stretch from `start` to `end`.
    pub fn new(start: usize, end: usize) -> Self {
        Self { start, end }
    }

    /// The text it covers; empty if the span does not belong to `source`.
    pub fn of(self, source: &str) -> &str {
        source.get(self.start..self.end).unwrap_or_default()
    }
}

/// Byte offset of the `index`-th UTF-16 unit, as browsers count carets. Past the end: the length of the text.
///
/// ```
/// assert_eq!(pforms_formula::byte_from_utf16("é😀x", 3), 6);
/// ```
pub fn byte_from_utf16(source: &str, index: usize) -> usize {
    let mut units = 0;
    for (byte, character) in source.char_indices() {
        if units >= index {
            return byte;
        }
        units += character.len_utf16();
    }
    source.len()
}

/// Number of UTF-16 units before a byte offset. Past the end: the length of the text in such units.
pub fn utf16_from_byte(source: &str, byte: usize) -> usize {
    let before = source.char_indices().take_while(|(start, _)| *start < byte);
    before.map(|(_, character)| character.len_utf16()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn utf16_offsets_go_both_ways() {
        let source = "a−😀z";
        for (byte, unit) in [(0, 0), (1, 1), (4, 2), (8, 4), (9, 5)] {
            assert_eq!(byte_from_utf16(source, unit), byte);
            assert_eq!(utf16_from_byte(source, byte), unit);
        }
        assert_eq!(byte_from_utf16(source, 99), 9);
    }
}
