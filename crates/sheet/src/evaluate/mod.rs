//! From the tree of one cell to its value.
//!
//! Brackets nest at most [`pforms_formula::DEPTH_LIMIT`] deep and chains of operators are folded,
//! so the recursion here is short.

mod calls;
mod derivatives;
mod references;

use std::cell::Cell as Flag;
use std::collections::BTreeMap;

use pforms_catalogue::{Arithmetic, Failure, Infix, Language, Value, binary, negate};
use pforms_formula::{Address, Content, Expression, Link, Node, NodeId, Operator, Sign, Tree};
use pforms_kernel::{Error, Place};

use crate::cell::Cell;
use crate::graph::Graph;
use crate::{Cancel, Document};

pub use derivatives::Sensitivities;

/// What evaluation reads: the cells computed so far, and what names stand for.
pub(crate) struct Surroundings<'a, S> {
    pub(crate) document: &'a Document,
    pub(crate) cells: &'a BTreeMap<Address, Cell<S>>,
    pub(crate) graph: &'a Graph,
    pub(crate) cancel: &'a Cancel,
    /// Set when evaluation was cancelled half-way: its value is worth nothing.
    pub(crate) interrupted: Flag<bool>,
}

impl<S: Arithmetic> Surroundings<'_, S> {
    /// The value of a cell; an error that starts here names it as its origin.
    pub(crate) fn cell(&self, at: Address, content: &Content) -> Value<S> {
        let value = match content {
            Content::Empty => Value::Empty,
            Content::Text(text) => Value::Text(text.clone()),
            Content::Literal(tree) | Content::Formula(tree) => match tree.errors().next() {
                Some((_, fault)) => misread(fault).into(),
                None => Evaluator { tree, around: self }.value(tree.root()).settle(),
            },
        };
        match value {
            Value::Error(failure) => failure.at(at.to_string()).into(),
            sound => sound,
        }
    }
}

/// One tree on its way to a value.
struct Evaluator<'a, S> {
    tree: &'a Tree,
    around: &'a Surroundings<'a, S>,
}

impl<S: Arithmetic> Evaluator<'_, S> {
    /// The value of a node; [`Value::Empty`] for an empty cell.
    fn value(&self, id: NodeId) -> Value<S> {
        match &self.node(id).expression {
            Expression::Number(digits) => S::read(digits).map(Value::Number).into(),
            Expression::Text(text) => Value::Text(text.clone()),
            Expression::Boolean(value) => Value::Boolean(*value),
            Expression::Point { coordinates, weight } => self.point(coordinates, *weight),
            Expression::List(items) => {
                Value::list(items.iter().map(|item| self.operand(*item)).collect())
            }
            Expression::CellRef(reference) => self.around.at(reference.address),
            Expression::Range(range) => self.around.rows(range).map(Value::list).into(),
            Expression::Name(name) => self.name(name),
            Expression::Unary { sign: Sign::Plus, operand } => self.operand(*operand),
            Expression::Unary { sign: Sign::Minus, operand } => negate(&self.operand(*operand)),
            Expression::Binary { .. } => self.chain(id),
            Expression::Call(call) => self.call(call),
            Expression::Error(fault) => misread(fault).into(),
        }
    }

    /// The value of a node that something is done with: an empty cell is an error that names it.
    fn operand(&self, id: NodeId) -> Value<S> {
        match self.value(id) {
            Value::Empty => references::empty(self.tree.text(id)).into(),
            value => value,
        }
    }

    /// `a + b − c + …`, from the left.
    fn chain(&self, id: NodeId) -> Value<S> {
        let (first, links) = self.tree.chain(id);
        let fold = |left: Value<S>, link: &Link| {
            binary(sign(link.operator), &left, &self.operand(link.right))
        };
        links.iter().fold(self.operand(first), fold)
    }

    fn point(&self, coordinates: &[NodeId], weight: Option<NodeId>) -> Value<S> {
        let numbers: Result<Vec<S>, Failure> =
            coordinates.iter().map(|id| self.coordinate(*id)).collect();
        let weight = weight.map(|id| self.coordinate(id)).transpose();
        match (numbers, weight) {
            (Ok(numbers), Ok(weight)) => Value::point(&numbers, weight),
            (Err(failure), _) | (_, Err(failure)) => failure.into(),
        }
    }

    fn coordinate(&self, id: NodeId) -> Result<S, Failure> {
        match self.operand(id) {
            Value::Number(x) => Ok(x),
            Value::Error(failure) => Err(failure),
            other => {
                let text: String = self.tree.text(id).chars().take(40).collect();
                let (en, fr) = (other.kind(Language::English), other.kind(Language::French));
                Err(Failure::of(
                    Error::shape("point", format!("{text}, {en}"), "numbers"),
                    format!("point : reçu {text}, {fr}, attendu des nombres"),
                ))
            }
        }
    }

    fn node(&self, id: NodeId) -> &Node {
        &self.tree[id]
    }
}

/// What is wrong with the text of a formula, as an error with its place.
fn misread(fault: &pforms_formula::Fault) -> Failure {
    use pforms_formula::Language::{English, French};
    let place = Place { line: 1, column: fault.column + 1 };
    let (en, fr) = (fault.problem.message(English), fault.problem.message(French));
    let french = format!("formule, colonne {} : {fr}", place.column);
    Failure::of(Error::format("formula", Some(place), en), french)
        .with_hint(fault.problem.hint(English), fault.problem.hint(French))
}

fn sign(operator: Operator) -> Infix {
    match operator {
        Operator::Add => Infix::Add,
        Operator::Subtract => Infix::Subtract,
        Operator::Multiply => Infix::Multiply,
        Operator::Divide => Infix::Divide,
        Operator::Power => Infix::Power,
        Operator::Equal => Infix::Equal,
        Operator::NotEqual => Infix::NotEqual,
        Operator::Less => Infix::Less,
        Operator::LessEqual => Infix::LessEqual,
        Operator::Greater => Infix::Greater,
        Operator::GreaterEqual => Infix::GreaterEqual,
    }
}
