//! Reading a Rust file: the paths it names and the numbers it writes, outside its tests.

use proc_macro2::{TokenStream, TokenTree};
use syn::spanned::Spanned as _;
use syn::visit::{self, Visit};

/// A path as written (`crate :: making :: fit`), or a number literal, and the line it stands on.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Mention {
    pub(super) text: String,
    pub(super) line: usize,
}

/// What a file mentions.
#[derive(Debug, Default)]
pub(super) struct Mentions {
    pub(super) paths: Vec<Mention>,
    pub(super) floats: Vec<Mention>,
}

/// Reads a file; items under `#[cfg(test)]` and doc comments do not count.
pub(super) fn mentions(text: &str) -> syn::Result<Mentions> {
    let mut mentions = Mentions::default();
    mentions.visit_file(&syn::parse_file(text)?);
    Ok(mentions)
}

impl Mentions {
    fn use_tree(&mut self, prefix: &str, tree: &syn::UseTree) {
        let joined = |name: &dyn std::fmt::Display| match prefix {
            "" => name.to_string(),
            _ => format!("{prefix}::{name}"),
        };
        let text = match tree {
            syn::UseTree::Path(path) => return self.use_tree(&joined(&path.ident), &path.tree),
            syn::UseTree::Group(group) => {
                return group.items.iter().for_each(|item| self.use_tree(prefix, item));
            }
            syn::UseTree::Name(name) => joined(&name.ident),
            syn::UseTree::Rename(name) => joined(&name.ident),
            syn::UseTree::Glob(_) => joined(&"*"),
        };
        self.paths.push(Mention { text, line: tree.span().start().line });
    }

    /// The body of a macro call is no syntax tree: paths are put together from its tokens.
    fn tokens(&mut self, tokens: TokenStream) {
        let mut path = String::new();
        let mut line = 0;
        for token in tokens {
            match &token {
                TokenTree::Ident(name) if path.is_empty() || path.ends_with("::") => {
                    line = token.span().start().line;
                    path.push_str(&name.to_string());
                    continue;
                }
                TokenTree::Punct(mark) if mark.as_char() == ':' && !path.is_empty() => {
                    path.push(':');
                    continue;
                }
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Literal(literal) => {
                    self.literal(&literal.to_string(), token.span().start().line);
                }
                _ => {}
            }
            self.finish_path(&mut path, line);
            if let TokenTree::Ident(name) = &token {
                line = token.span().start().line;
                path = name.to_string();
            }
        }
        self.finish_path(&mut path, line);
    }

    fn finish_path(&mut self, path: &mut String, line: usize) {
        let text = std::mem::take(path);
        if text.contains("::") {
            self.paths.push(Mention { text, line });
        }
    }

    fn literal(&mut self, text: &str, line: usize) {
        if syn::parse_str::<syn::LitFloat>(text).is_ok() {
            self.floats.push(Mention { text: text.to_owned(), line });
        }
    }
}

impl<'ast> Visit<'ast> for Mentions {
    fn visit_item(&mut self, item: &'ast syn::Item) {
        if !is_test(attributes(item)) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.use_tree("", &item.tree);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let names: Vec<String> =
            path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        self.paths.push(Mention { text: names.join("::"), line: path.span().start().line });
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        self.tokens(call.tokens.clone());
    }

    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}

    fn visit_lit_float(&mut self, literal: &'ast syn::LitFloat) {
        self.literal(literal.token().to_string().as_str(), literal.span().start().line);
    }
}

fn attributes(item: &syn::Item) -> &[syn::Attribute] {
    match item {
        syn::Item::Fn(item) => &item.attrs,
        syn::Item::Mod(item) => &item.attrs,
        syn::Item::Impl(item) => &item.attrs,
        syn::Item::Use(item) => &item.attrs,
        syn::Item::Const(item) => &item.attrs,
        syn::Item::Macro(item) => &item.attrs,
        _ => &[],
    }
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        syn::Meta::Path(path) => path.is_ident("test"),
        syn::Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string() == "test",
        syn::Meta::NameValue(_) => false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn paths(text: &str) -> Vec<String> {
        mentions(text).unwrap().paths.into_iter().map(|mention| mention.text).collect()
    }

    #[test]
    fn a_grouped_use_is_taken_apart() {
        let text = "use crate::{algebra::elevate, making::{fit, arc as bow}, kernel::*};";
        assert_eq!(
            paths(text),
            [
                "crate::algebra::elevate",
                "crate::making::fit",
                "crate::making::arc",
                "crate::kernel::*"
            ]
        );
    }

    #[test]
    fn paths_in_code_and_in_macros_are_seen() {
        let text = "fn f() { crate::making::fit(); vec![super::making::arc(1)]; }";
        assert!(paths(text).contains(&"crate::making::fit".to_owned()));
        assert!(paths(text).contains(&"super::making::arc".to_owned()));
    }

    #[test]
    fn numbers_are_seen_with_their_line_and_tests_are_not_read() {
        let text = "fn f() {\n    g(1e-9);\n}\n#[cfg(test)]\nmod tests { const T: f64 = 1e-12; }";
        assert_eq!(mentions(text).unwrap().floats, [Mention { text: "1e-9".to_owned(), line: 2 }]);
    }
}
