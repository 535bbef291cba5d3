//! Which cell depends on which, and in what order they are computed.
//!
//! A range is a node of its own between its cells and those that use it, so a rectangle of a
//! billion cells costs as much as one cell. Nothing here recurses.

mod components;
mod ranges;

use std::collections::{BTreeMap, BTreeSet, HashMap, VecDeque};
use std::sync::Arc;

use pforms_formula::{Address, Range};

use components::components;
use ranges::{RangeIndex, Rectangle};

/// What one cell mentions; names come with what they stand for among the cells and ranges.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Mentions {
    pub(crate) cells: BTreeSet<Address>,
    pub(crate) ranges: BTreeSet<Rectangle>,
    pub(crate) names: BTreeSet<String>,
}

impl Mentions {
    pub(crate) fn add_range(&mut self, range: &Range) {
        self.ranges.insert(Rectangle::from(range));
    }
}

/// One step of a recomputation.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Stage {
    /// Compute this cell; all that it uses is computed.
    Compute(Address),
    /// These cells use one another in a circle.
    Circle(Circle),
}

/// Cells that use one another, and for each of them a shortest way round.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Circle {
    pub(crate) rounds: BTreeMap<Address, Arc<[Address]>>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum Node {
    Cell(Address),
    Range(Rectangle),
}

/// Circles with more cells than this share one way round.
const LARGE_CIRCLE: usize = 256;

/// The dependencies between the cells of a sheet.
#[derive(Clone, Debug, Default)]
pub(crate) struct Graph {
    mentions: HashMap<Address, Mentions>,
    users: HashMap<Address, BTreeSet<Address>>,
    ranges: RangeIndex,
    name_users: BTreeMap<String, BTreeSet<Address>>,
}

impl Graph {
    /// Makes `at` depend on what it mentions, and on nothing else.
    pub(crate) fn link(&mut self, at: Address, mentions: Mentions) {
        self.unlink(at);
        for &cell in &mentions.cells {
            self.users.entry(cell).or_default().insert(at);
        }
        for &range in &mentions.ranges {
            self.ranges.insert(range, at);
        }
        for name in &mentions.names {
            self.name_users.entry(name.clone()).or_default().insert(at);
        }
        if mentions != Mentions::default() {
            self.mentions.insert(at, mentions);
        }
    }

    fn unlink(&mut self, at: Address) {
        let Some(mentions) = self.mentions.remove(&at) else { return };
        for &cell in &mentions.cells {
            remove_user(&mut self.users, cell, at);
        }
        for &range in &mentions.ranges {
            self.ranges.remove(range, at);
        }
        for name in &mentions.names {
            if let Some(users) = self.name_users.get_mut(name) {
                users.remove(&at);
            }
        }
    }

    /// The cells that mention a name, given in folded form.
    pub(crate) fn users_of_name(&self, name: &str) -> impl Iterator<Item = Address> + '_ {
        self.name_users.get(name).into_iter().flatten().copied()
    }

    /// Adds seeds, and all that depends on them, to cells that hold whatever depends on them.
    pub(crate) fn spread(
        &self,
        seeds: impl IntoIterator<Item = Address>,
        dirty: &mut BTreeSet<Address>,
    ) {
        let mut passed: BTreeSet<Rectangle> = BTreeSet::new();
        let mut waiting: Vec<Node> = seeds.into_iter().map(Node::Cell).collect();
        while let Some(node) = waiting.pop() {
            let new = match node {
                Node::Cell(at) => dirty.insert(at),
                Node::Range(range) => passed.insert(range),
            };
            if new {
                waiting.extend(self.next(node));
            }
        }
    }

    /// The order in which to compute cells: by address, as far as they leave the choice.
    ///
    /// The set holds whatever depends on any of them.
    pub(crate) fn stages(&self, dirty: &BTreeSet<Address>) -> VecDeque<Stage> {
        let starts = dirty.iter().rev().map(|at| Node::Cell(*at));
        let backwards = |node| {
            let mut next = self.next(node);
            next.reverse();
            next
        };
        let found = components(starts, backwards);
        found.into_iter().rev().filter_map(|component| self.stage(&component)).collect()
    }

    fn stage(&self, component: &[Node]) -> Option<Stage> {
        match component {
            [Node::Range(_)] => None,
            [Node::Cell(at)] if !self.next(Node::Cell(*at)).contains(&Node::Cell(*at)) => {
                Some(Stage::Compute(*at))
            }
            circle => Some(Stage::Circle(self.circle(circle))),
        }
    }

    fn circle(&self, component: &[Node]) -> Circle {
        let inside: BTreeSet<Node> = component.iter().copied().collect();
        let mut rounds: BTreeMap<Address, Arc<[Address]>> = BTreeMap::new();
        for at in inside.iter().filter_map(Node::cell) {
            if rounds.contains_key(&at) {
                continue;
            }
            let shared = rounds.values().next().filter(|_| inside.len() > LARGE_CIRCLE).cloned();
            let round = shared.unwrap_or_else(|| self.round(at, &inside).into());
            for cell in round.iter() {
                rounds.entry(*cell).or_insert_with(|| round.clone());
            }
            rounds.entry(at).or_insert(round);
        }
        Circle { rounds }
    }

    /// A shortest way from a cell back to itself, in the direction of use, its ends named once.
    fn round(&self, at: Address, inside: &BTreeSet<Node>) -> Vec<Address> {
        let start = Node::Cell(at);
        let mut came_from: HashMap<Node, Node> = HashMap::new();
        let mut waiting = VecDeque::from([start]);
        while let Some(node) = waiting.pop_front() {
            for next in self.next(node).into_iter().filter(|next| inside.contains(next)) {
                came_from.entry(next).or_insert_with(|| {
                    waiting.push_back(next);
                    node
                });
            }
            if came_from.contains_key(&start) {
                break;
            }
        }
        let mut round = vec![at];
        let mut node = came_from.get(&start).copied().unwrap_or(start);
        while node != start {
            round.extend(node.cell());
            node = came_from.get(&node).copied().unwrap_or(start);
        }
        round
    }

    /// Where a change goes from here, in order.
    fn next(&self, node: Node) -> Vec<Node> {
        match node {
            Node::Cell(at) => {
                let direct = self.users.get(&at).into_iter().flatten().map(|at| Node::Cell(*at));
                direct.chain(self.ranges.around(at).into_iter().map(Node::Range)).collect()
            }
            Node::Range(range) => self.ranges.users(range).map(|at| Node::Cell(*at)).collect(),
        }
    }
}

impl Node {
    fn cell(&self) -> Option<Address> {
        match self {
            Self::Cell(at) => Some(*at),
            Self::Range(_) => None,
        }
    }
}

fn remove_user(users: &mut HashMap<Address, BTreeSet<Address>>, cell: Address, user: Address) {
    if let Some(set) = users.get_mut(&cell) {
        set.remove(&user);
        if set.is_empty() {
            users.remove(&cell);
        }
    }
}

#[cfg(test)]
mod tests;
