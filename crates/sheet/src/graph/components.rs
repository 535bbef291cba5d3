//! Strongly connected components, without recursion.

use std::collections::HashMap;
use std::hash::Hash;

/// The sets of nodes that lead to one another, each set after those it leads to.
///
/// Linear in nodes and edges (Tarjan, *Depth-first search and linear graph algorithms*, 1972),
/// with the calls kept on a stack of our own.
pub(crate) fn components<N: Copy + Eq + Hash>(
    starts: impl Iterator<Item = N>,
    next: impl Fn(N) -> Vec<N>,
) -> Vec<Vec<N>> {
    let mut search = Search::new(next);
    for start in starts {
        search.from(start);
    }
    search.found
}

struct Search<N, F> {
    next: F,
    /// Order of discovery; nodes of finished components keep theirs.
    index: HashMap<N, usize>,
    /// For each node discovered: the earliest node still open that it is known to reach.
    low: Vec<usize>,
    finished: Vec<bool>,
    open: Vec<N>,
    found: Vec<Vec<N>>,
}

struct Frame<N> {
    node: N,
    index: usize,
    rest: std::vec::IntoIter<N>,
}

impl<N: Copy + Eq + Hash, F: Fn(N) -> Vec<N>> Search<N, F> {
    fn new(next: F) -> Self {
        Self {
            next,
            index: HashMap::new(),
            low: Vec::new(),
            finished: Vec::new(),
            open: Vec::new(),
            found: Vec::new(),
        }
    }

    fn from(&mut self, start: N) {
        if self.index.contains_key(&start) {
            return;
        }
        let mut frames = vec![self.enter(start)];
        while let Some(frame) = frames.last_mut() {
            let (node, at) = (frame.node, frame.index);
            if let Some(next) = frame.rest.next() {
                match self.index.get(&next) {
                    None => frames.push(self.enter(next)),
                    Some(&seen) if !self.finished[seen] => self.low[at] = self.low[at].min(seen),
                    Some(_) => {}
                }
                continue;
            }
            frames.pop();
            if let Some(parent) = frames.last() {
                self.low[parent.index] = self.low[parent.index].min(self.low[at]);
            }
            self.close(node, at);
        }
    }

    fn enter(&mut self, node: N) -> Frame<N> {
        let index = self.low.len();
        self.index.insert(node, index);
        self.low.push(index);
        self.finished.push(false);
        self.open.push(node);
        Frame { node, index, rest: (self.next)(node).into_iter() }
    }

    /// A node that reaches nothing earlier is the first of its component: all opened since is it.
    fn close(&mut self, node: N, index: usize) {
        if self.low[index] != index {
            return;
        }
        let from = self.open.iter().rposition(|open| *open == node).unwrap_or(0);
        let component = self.open.split_off(from);
        for member in &component {
            if let Some(&member) = self.index.get(member) {
                self.finished[member] = true;
            }
        }
        self.found.push(component);
    }
}
