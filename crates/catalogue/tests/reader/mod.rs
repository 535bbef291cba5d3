//! A reader of the few things the examples of the catalogue are written with, so that they can be
//! computed where the formula language is not known.

use pforms_catalogue::{Arguments, Arithmetic, Infix, Value, binary, find, negate};

/// Computes an example such as `=MI((0, 0), (1, 2))`.
pub(crate) fn compute<S: Arithmetic>(text: &str) -> Value<S> {
    let mut reader = Reader { rest: text.strip_prefix('=').expect("an example begins with =") };
    let value = reader.comparison();
    assert_eq!(reader.rest.trim(), "", "in {text}");
    value
}

struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    fn takes(&mut self, sign: &str) -> bool {
        self.rest = self.rest.trim_start();
        match self.rest.strip_prefix(sign) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn run(&mut self, belongs: impl Fn(char) -> bool) -> &'a str {
        self.rest = self.rest.trim_start();
        let end = self.rest.find(|c| !belongs(c)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        word
    }

    fn comparison<S: Arithmetic>(&mut self) -> Value<S> {
        let left = self.quotient();
        for (sign, infix) in [("<", Infix::Less), (">", Infix::Greater)] {
            if self.takes(sign) {
                return binary(infix, &left, &self.quotient());
            }
        }
        left
    }

    fn quotient<S: Arithmetic>(&mut self) -> Value<S> {
        let mut left = self.operand();
        while self.takes("/") {
            left = binary(Infix::Divide, &left, &self.operand());
        }
        left
    }

    fn operand<S: Arithmetic>(&mut self) -> Value<S> {
        if self.takes("-") {
            return negate(&self.operand());
        }
        if self.takes("[") {
            return Value::list(self.items("]"));
        }
        if self.takes("(") {
            return self.point();
        }
        if self.takes("\"") {
            let text = self.run(|c| c != '"').to_owned();
            assert!(self.takes("\""));
            return Value::Text(text);
        }
        let word = self.run(|c| c.is_alphanumeric() || c == '.');
        match word {
            "TRUE" => Value::Boolean(true),
            "FALSE" => Value::Boolean(false),
            _ if word.starts_with(|c: char| c.is_ascii_digit()) => {
                Value::Number(S::read(word).unwrap())
            }
            _ => self.call(word),
        }
    }

    fn items<S: Arithmetic>(&mut self, end: &str) -> Vec<Value<S>> {
        let mut items = Vec::new();
        while !self.takes(end) {
            items.push(self.comparison());
            self.takes(",");
        }
        items
    }

    fn point<S: Arithmetic>(&mut self) -> Value<S> {
        let mut numbers = Vec::new();
        let mut weight = None;
        while !self.takes(")") {
            let heavy = self.takes(";");
            let Value::Number(x) = self.comparison() else { panic!("no number at {}", self.rest) };
            if heavy {
                weight = Some(x);
            } else {
                numbers.push(x);
            }
            self.takes(",");
        }
        Value::point(&numbers, weight)
    }

    fn call<S: Arithmetic>(&mut self, name: &str) -> Value<S> {
        assert!(self.takes("("), "{name} is not called");
        let mut arguments = Arguments::new([]);
        while !self.takes(")") {
            let before = self.rest;
            let name = self.run(char::is_alphanumeric);
            if !name.is_empty() && self.takes("=") {
                arguments.push_named(name, self.comparison());
            } else {
                self.rest = before;
                arguments.push(self.comparison());
            }
            self.takes(",");
        }
        find(name).unwrap_or_else(|| panic!("no operator {name}")).call(arguments)
    }
}
