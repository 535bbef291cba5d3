//! Calls of operators. All they take is computed first, but for the branch that IF does not take.

use pforms_catalogue::{Arguments, Arithmetic, Value, find, unknown};
use pforms_formula::{Argument, Call, Expression, NodeId, Range};

use super::Evaluator;
use crate::Target;

impl<S: Arithmetic> Evaluator<'_, S> {
    pub(super) fn call(&self, call: &Call) -> Value<S> {
        let Some(operator) = find(&call.name) else {
            let name: String = call.name.chars().take(40).collect();
            return unknown(&name).into();
        };
        let special = match operator.name {
            "if" => self.branch(call),
            "sensitivities" => self.sensitivities(call),
            _ => None,
        };
        match special {
            Some(value) => value,
            None => operator.call(self.arguments(&call.arguments)),
        }
    }

    /// The branch that a sound IF takes; anything else about IF is left to the catalogue.
    fn branch(&self, call: &Call) -> Option<Value<S>> {
        let conditional = call.keywords().next().is_none();
        let branches: Vec<NodeId> = call.positional().collect();
        match (conditional, branches.as_slice()) {
            (true, [condition, yes, rest @ ..]) if rest.len() == 1 => {
                match self.operand(*condition) {
                    Value::Boolean(true) => Some(self.value(*yes)),
                    Value::Boolean(false) => Some(self.value(rest[0])),
                    Value::Error(failure) => Some(Value::Error(failure)),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    fn arguments(&self, given: &[Argument]) -> Arguments<S> {
        let mut arguments = Arguments::new([]);
        for argument in given {
            match (&argument.keyword, self.range(argument.value)) {
                (Some(name), _) => arguments.push_named(name, self.operand(argument.value)),
                (None, Some(range)) => match self.around.rows(&range) {
                    Ok(cells) => arguments.push_range(cells),
                    Err(failure) => arguments.push(failure.into()),
                },
                (None, None) => arguments.push(self.operand(argument.value)),
            }
        }
        arguments
    }

    /// The range a node stands for, written out or by name.
    fn range(&self, id: NodeId) -> Option<Range> {
        match &self.node(id).expression {
            Expression::Range(range) => Some(*range),
            Expression::Name(name) => match self.around.document.target(name)? {
                Target::Cells(range) => Some(range),
                Target::Cell(_) => None,
            },
            _ => None,
        }
    }
}
