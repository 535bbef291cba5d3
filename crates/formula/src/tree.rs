//! The syntax tree: one flat list of nodes, each after the nodes it is made of.
//!
//! Being flat, a tree of any shape is dropped, cloned, printed for debugging and searched without recursion.

use crate::locale::Locale;
use crate::operator::{Operator, Sign};
use crate::place::Span;
use crate::problem::Problem;
use crate::reference::{Range, Reference};
use std::ops::Index;

/// Which node of a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeId(u32);

impl NodeId {
    /// Position in [`Tree::nodes`].
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A parsed source.
///
/// Brackets, calls, signs and right operands nest at most [`crate::DEPTH_LIMIT`] deep, so a recursive walk is
/// safe, *provided* it takes left operands with [`Tree::chain`]: `1+1+…+1` leans to the left without limit.
#[derive(Clone, Debug, PartialEq)]
pub struct Tree {
    pub(crate) source: String,
    pub(crate) locale: Locale,
    pub(crate) nodes: Vec<Node>,
    pub(crate) root: NodeId,
}

/// A piece of the tree and where it stands in the source.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// What it is.
    pub expression: Expression,
    /// Where it stands; brackets that only group are not part of it.
    pub span: Span,
}

/// What a node says.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A decimal number without sign, as typed but with a decimal point, so that `0.1` may be read as 1/10. Always
    /// `[digits][.digits][e[+-]digits]` with a digit before the `e`; [`str::parse::<f64>`] reads it.
    Number(String),
    /// A quoted text, without its quotes.
    Text(String),
    /// True or false.
    Boolean(bool),
    /// `(x, y, z)` or `(x, y, z; w)`; at least one coordinate.
    Point {
        /// The coordinates, at least one.
        coordinates: Vec<NodeId>,
        /// The weight, if written.
        weight: Option<NodeId>,
    },
    /// `[a, b, …]`, possibly empty.
    List(Vec<NodeId>),
    /// One cell, `A1`.
    CellRef(Reference),
    /// A rectangle of cells, `A1:B3`.
    Range(Range),
    /// A name given to a cell, as typed.
    Name(String),
    /// A sign and its operand.
    Unary {
        /// The sign.
        sign: Sign,
        /// What it stands before.
        operand: NodeId,
    },
    /// An operator between two operands; walk these with [`Tree::chain`].
    Binary {
        /// The operator.
        operator: Operator,
        /// Left operand.
        left: NodeId,
        /// Right operand.
        right: NodeId,
    },
    /// `NAME(arguments)`.
    Call(Call),
    /// What could not be understood.
    Error(Fault),
}

/// A function or operator called by name.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// The name as typed; names of functions do not distinguish capitals.
    pub name: String,
    /// Where the name stands.
    pub name_span: Span,
    /// The arguments in the order written, with and without keyword.
    pub arguments: Vec<Argument>,
}

impl Call {
    /// The arguments without keyword, in order.
    pub fn positional(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.arguments.iter().filter(|a| a.keyword.is_none()).map(|a| a.value)
    }

    /// The arguments with a keyword, in order, repeated keywords included.
    pub fn keywords(&self) -> impl Iterator<Item = (&str, NodeId)> + '_ {
        self.arguments.iter().filter_map(|a| Some((a.keyword.as_deref()?, a.value)))
    }
}

/// One argument of a call.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    /// The keyword of `key: value` or `key=value`, as typed.
    pub keyword: Option<String>,
    /// Where the keyword stands; empty without keyword.
    pub keyword_span: Span,
    /// The value.
    pub value: NodeId,
}

/// What went wrong at a node, and what was understood nonetheless.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// What is wrong, with messages in each language.
    pub problem: Problem,
    /// What to underline; may be empty where something is missing.
    pub place: Span,
    /// Character column of the place in the source, counted from 0.
    pub column: usize,
    /// The parts that were understood, in order.
    pub parts: Vec<NodeId>,
}

impl Tree {
    /// The outermost node.
    pub fn root(&self) -> NodeId {
        self.root
    }

    /// The text that was parsed, a leading `=` included.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// The locale it was parsed in.
    pub fn locale(&self) -> Locale {
        self.locale
    }

    /// Every node, each after the nodes it is made of.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The source text of a node.
    pub fn text(&self, id: NodeId) -> &str {
        self[id].span.of(&self.source)
    }

    /// The error nodes, with the span of all that each of them holds.
    pub fn errors(&self) -> impl Iterator<Item = (Span, &Fault)> {
        self.nodes.iter().filter_map(|node| match &node.expression {
            Expression::Error(fault) => Some((node.span, fault)),
            _ => None,
        })
    }

    /// Whether anything could not be understood.
    pub fn has_errors(&self) -> bool {
        self.errors().next().is_some()
    }

    /// Unrolls the left operands of a binary node: `a + b * c - d` is `a`, then `+ b*c`, then `- d`.
    ///
    /// Evaluating the first and folding the rest gives the value of the node without recursion to the left. Any
    /// other node is its own chain, with nothing to fold. Each item also names the binary node it belongs to.
    pub fn chain(&self, id: NodeId) -> (NodeId, Vec<Link>) {
        let mut links = Vec::new();
        let mut first = id;
        while let Expression::Binary { operator, left, right } = self[first].expression {
            links.push(Link { operator, right, node: first });
            first = left;
        }
        links.reverse();
        (first, links)
    }

    /// Whether both say the same, wherever their pieces stand in their sources.
    pub fn same(&self, other: &Self) -> bool {
        let alike = |(a, b): (&Node, &Node)| a.expression.unplaced() == b.expression.unplaced();
        self.root == other.root
            && self.nodes.len() == other.nodes.len()
            && self.nodes.iter().zip(&other.nodes).all(alike)
    }

    pub(crate) fn id(index: usize) -> NodeId {
        NodeId(u32::try_from(index).unwrap_or(u32::MAX))
    }
}

/// One step of a [`Tree::chain`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Link {
    /// The operator.
    pub operator: Operator,
    /// The right operand.
    pub right: NodeId,
    /// The binary node whose value is reached with this step.
    pub node: NodeId,
}

impl Expression {
    /// The same without the places kept inside calls.
    fn unplaced(&self) -> Self {
        let mut copy = self.clone();
        if let Self::Call(call) = &mut copy {
            call.name_span = Span::default();
            call.arguments.iter_mut().for_each(|a| a.keyword_span = Span::default());
        }
        copy
    }
}

impl Index<NodeId> for Tree {
    type Output = Node;

    /// The node of that id, which must come from this tree.
    fn index(&self, id: NodeId) -> &Node {
        &self.nodes[id.index()]
    }
}
