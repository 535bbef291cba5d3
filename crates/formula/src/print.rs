//! Tree to text, with no more brackets than needed.

use crate::convert::convert_words;
use crate::locale::{Language, Locale};
use crate::operator::{LOOSEST, Operator, SIGN};
use crate::parse::{body, brackets::is_logical};
use crate::place::Span;
use crate::tree::{Argument, Call, Expression, Link, NodeId, Tree};

/// Writes a tree as a formula, without the leading `=`.
///
/// Parsing the text gives the [same](Tree::same) tree. A tree with errors keeps its own text and spacing, with its
/// decimals and separators put in `locale`.
pub fn print(tree: &Tree, locale: Locale, language: Language) -> String {
    if tree.has_errors() {
        let span = Span::new(body(&tree.source), tree.source.len());
        return convert_words(span.of(&tree.source), tree.locale, locale);
    }
    let mut printer = Printer { tree, locale, language, text: String::new() };
    printer.write(tree.root(), LOOSEST);
    printer.text
}

struct Printer<'a> {
    tree: &'a Tree,
    locale: Locale,
    language: Language,
    text: String,
}

impl Printer<'_> {
    /// Writes a node where an operator must be at least so strong to stand without brackets.
    fn write(&mut self, id: NodeId, strength: u8) {
        let tree = self.tree;
        match &tree[id].expression {
            Expression::Number(number) => self.number(number),
            Expression::Text(text) => self.quoted(text),
            Expression::Boolean(value) => self.text.push_str(self.language.boolean(*value)),
            Expression::Point { coordinates, weight } => self.point(coordinates, *weight),
            Expression::List(items) => self.bracketed('[', items, ']'),
            Expression::CellRef(cell) => self.text.push_str(&cell.to_string()),
            Expression::Range(range) => self.text.push_str(&range.to_string()),
            Expression::Name(name) => self.text.push_str(name),
            Expression::Unary { sign, operand } => self.grouped(strength > SIGN, |printer| {
                printer.text.push(sign.symbol());
                printer.write(*operand, SIGN);
            }),
            Expression::Binary { .. } => self.chain(id, strength),
            Expression::Call(call) => self.call(call),
            Expression::Error(_) => self.text.push_str(tree.text(id)),
        }
    }

    /// Left operands all begin at the same place, so their opening brackets can be written together.
    fn chain(&mut self, id: NodeId, strength: u8) {
        let (first, links) = self.tree.chain(id);
        let awaited =
            links.iter().skip(1).map(|next| next.operator.left_strength()).chain([strength]);
        let wrapped: Vec<bool> = links
            .iter()
            .zip(awaited)
            .map(|(link, awaited)| link.operator.strength() < awaited)
            .collect();
        let opened = wrapped.iter().filter(|wrapped| **wrapped).count();
        self.text.extend(std::iter::repeat_n('(', opened));
        self.write(first, links.first().map_or(LOOSEST, |link| link.operator.left_strength()));
        for (link, wrapped) in links.iter().zip(wrapped) {
            self.link(*link);
            if wrapped {
                self.text.push(')');
            }
        }
    }

    fn link(&mut self, link: Link) {
        let symbol = link.operator.symbol();
        match link.operator {
            Operator::Multiply | Operator::Divide | Operator::Power => self.text.push_str(symbol),
            _ => self.text.extend([" ", symbol, " "]),
        }
        let signed = matches!(self.tree[link.right].expression, Expression::Unary { .. });
        self.write(link.right, if signed { LOOSEST } else { link.operator.right_strength() });
    }

    fn number(&mut self, number: &str) {
        let mark = self.locale.mark();
        self.text.extend(number.chars().map(|c| if c == '.' { mark } else { c }));
    }

    fn quoted(&mut self, text: &str) {
        self.text.push('"');
        self.text.push_str(&text.replace('"', "\"\""));
        self.text.push('"');
    }

    fn point(&mut self, coordinates: &[NodeId], weight: Option<NodeId>) {
        let alone = coordinates.len() == 1 && weight.is_none();
        self.text.push('(');
        self.items(coordinates);
        if alone {
            self.text.push(self.locale.separator());
        }
        if let Some(weight) = weight {
            self.text.push_str(self.locale.weight_mark());
            self.text.push(' ');
            self.write(weight, LOOSEST);
        }
        self.text.push(')');
    }

    fn bracketed(&mut self, opening: char, items: &[NodeId], closing: char) {
        self.text.push(opening);
        self.items(items);
        self.text.push(closing);
    }

    fn items(&mut self, items: &[NodeId]) {
        for (index, item) in items.iter().enumerate() {
            self.separate(index);
            self.write(*item, LOOSEST);
        }
    }

    fn separate(&mut self, index: usize) {
        if index > 0 {
            self.text.push(self.locale.separator());
            self.text.push(' ');
        }
    }

    fn call(&mut self, call: &Call) {
        self.text.push_str(&call.name);
        self.text.push('(');
        for (index, argument) in call.arguments.iter().enumerate() {
            self.separate(index);
            self.argument(argument, is_logical(&call.name));
        }
        self.text.push(')');
    }

    fn argument(&mut self, argument: &Argument, logical: bool) {
        if let Some(keyword) = &argument.keyword {
            self.text.extend([keyword, ": "]);
        }
        let confusable =
            argument.keyword.is_none() && !logical && self.resembles_keyword(argument.value);
        self.grouped(confusable, |printer| printer.write(argument.value, LOOSEST));
    }

    /// Whether an argument begins like a keyword, `x = …`.
    fn resembles_keyword(&self, id: NodeId) -> bool {
        let (first, links) = self.tree.chain(id);
        let equal = links.first().is_some_and(|link| link.operator == Operator::Equal);
        equal && matches!(self.tree[first].expression, Expression::Name(_))
    }

    fn grouped(&mut self, brackets: bool, write: impl FnOnce(&mut Self)) {
        if brackets {
            self.text.push('(');
        }
        write(self);
        if brackets {
            self.text.push(')');
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    fn printed(source: &str) -> String {
        let tree = parse(source, Locale::DecimalPoint);
        let text = print(&tree, Locale::DecimalPoint, Language::English);
        assert!(parse(&text, Locale::DecimalPoint).same(&tree), "{source} became {text}");
        text
    }

    #[test]
    fn only_needed_brackets_remain() {
        for (source, expected) in [
            ("((1))", "1"),
            ("(1+2)+3", "1 + 2 + 3"),
            ("1+(2+3)", "1 + (2 + 3)"),
            ("((a+b)*c)^2", "((a + b)*c)^2"),
            ("(a^b)^c", "(a^b)^c"),
            ("a^(b^c)", "a^b^c"),
            ("(-a)^2", "(-a)^2"),
            ("-(a^2)", "-a^2"),
            ("-(a*b)", "-(a*b)"),
            ("(-a)*b", "-a*b"),
            ("a^(-b)", "a^-b"),
            ("a-(-b)", "a - -b"),
            ("(a<b)=(c>d)", "a < b = (c > d)"),
            ("F((x=1), y==2, z=3)", "F((x = 1), (y = 2), z: 3)"),
            ("IF((x=1), 2)", "IF(x = 1, 2)"),
            ("(x,)", "(x,)"),
            ("(x;w)", "(x; w)"),
            ("«\u{a0}a \"b\"\u{a0}»", "\"a \"\"b\"\"\""),
        ] {
            assert_eq!(printed(source), expected);
        }
    }

    #[test]
    fn errors_keep_their_text() {
        let tree = parse("= (1.5 , [2;", Locale::DecimalPoint);
        assert_eq!(print(&tree, Locale::DecimalPoint, Language::English), " (1.5 , [2;");
        assert_eq!(print(&tree, Locale::DecimalComma, Language::English), " (1,5 ; [2;");
    }

    #[test]
    fn words_follow_the_language() {
        let tree = parse("faux", Locale::DecimalPoint);
        assert_eq!(print(&tree, Locale::DecimalComma, Language::English), "FALSE");
        assert_eq!(print(&tree, Locale::DecimalPoint, Language::French), "FAUX");
    }
}
