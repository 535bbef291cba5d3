//! Searches for curves of any order, by the room their poles take on the stack.

use super::flat::Flat;
use super::quick::{Found, Search};

/// One search for every room, kept from pair to pair.
pub(super) struct Searches {
    plain: Rooms<2>,
    rational: Rooms<3>,
}

struct Rooms<const D: usize> {
    four: Search<D, 4>,
    six: Search<D, 6>,
    nine: Search<D, 9>,
    some: Search<D, 16>,
    many: Search<D, 64>,
}

impl Searches {
    pub(super) fn new() -> Self {
        Self { plain: Rooms::new(), rational: Rooms::new() }
    }

    /// All crossings of two curves of order 64 at most.
    pub(super) fn run(&mut self, flat: &Flat, margin: f64, eager: bool) -> Found {
        if flat.rational {
            self.rational.run(flat, margin, eager)
        } else {
            self.plain.run(flat, margin, eager)
        }
    }
}

impl<const D: usize> Rooms<D> {
    fn new() -> Self {
        Self {
            four: Search::new(),
            six: Search::new(),
            nine: Search::new(),
            some: Search::new(),
            many: Search::new(),
        }
    }

    fn run(&mut self, flat: &Flat, margin: f64, eager: bool) -> Found {
        let (a, b) = (&flat.a, &flat.b);
        match a.len().max(b.len()) {
            0..=4 => self.four.run(a, b, margin, eager),
            5..=6 => self.six.run(a, b, margin, eager),
            7..=9 => self.nine.run(a, b, margin, eager),
            10..=16 => self.some.run(a, b, margin, eager),
            _ => self.many.run(a, b, margin, eager),
        }
    }
}
