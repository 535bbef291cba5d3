//! Which ranges hold a cell, without visiting the cells of any range.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use pforms_formula::{Address, Range};

/// The cells from one column and row to another, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Rectangle {
    columns: (u32, u32),
    rows: (u32, u32),
}

impl From<&Range> for Rectangle {
    fn from(range: &Range) -> Self {
        Self { columns: range.columns(), rows: range.rows() }
    }
}

impl Rectangle {
    fn holds(&self, at: Address) -> bool {
        let within = |(low, high): (u32, u32), value| (low..=high).contains(&value);
        within(self.columns, at.column()) && within(self.rows, at.row())
    }

    fn level(&self) -> Level {
        (exponent(self.columns), exponent(self.rows))
    }

    /// The tiles of its level that it touches: four at most, since a tile is no smaller than it.
    fn tiles(&self) -> impl Iterator<Item = Tile> {
        let level = self.level();
        let columns = (self.columns.0 >> level.0)..=(self.columns.1 >> level.0);
        let rows = (self.rows.0 >> level.1)..=(self.rows.1 >> level.1);
        columns.flat_map(move |column| rows.clone().map(move |row| (level, column, row)))
    }
}

/// Exponents of the width and height of a tile.
type Level = (u32, u32);

/// A tile: its level, and which it is along each side.
type Tile = (Level, u32, u32);

/// The smallest `k` for which the extent fits in `2^k`.
fn exponent((low, high): (u32, u32)) -> u32 {
    (high - low + 1).next_power_of_two().trailing_zeros()
}

/// Rectangles and their users, laid on grids of tiles: one grid for each size of rectangle.
#[derive(Clone, Debug, Default)]
pub(crate) struct RangeIndex {
    users: HashMap<Rectangle, BTreeSet<Address>>,
    tiles: HashMap<Tile, BTreeSet<Rectangle>>,
    levels: BTreeMap<Level, usize>,
}

impl RangeIndex {
    pub(crate) fn insert(&mut self, range: Rectangle, user: Address) {
        let users = self.users.entry(range).or_default();
        let first = users.is_empty();
        users.insert(user);
        if first {
            *self.levels.entry(range.level()).or_default() += 1;
            for tile in range.tiles() {
                self.tiles.entry(tile).or_default().insert(range);
            }
        }
    }

    pub(crate) fn remove(&mut self, range: Rectangle, user: Address) {
        let Some(users) = self.users.get_mut(&range) else { return };
        users.remove(&user);
        if users.is_empty() {
            self.users.remove(&range);
            self.forget(range);
        }
    }

    fn forget(&mut self, range: Rectangle) {
        for tile in range.tiles() {
            if let Some(ranges) = self.tiles.get_mut(&tile) {
                ranges.remove(&range);
                if ranges.is_empty() {
                    self.tiles.remove(&tile);
                }
            }
        }
        if let Some(count) = self.levels.get_mut(&range.level()) {
            *count -= 1;
            if *count == 0 {
                self.levels.remove(&range.level());
            }
        }
    }

    /// The cells that use a range, in order.
    pub(crate) fn users(&self, range: Rectangle) -> impl Iterator<Item = &Address> {
        self.users.get(&range).into_iter().flatten()
    }

    /// The ranges that hold a cell, in order.
    pub(crate) fn around(&self, at: Address) -> BTreeSet<Rectangle> {
        let tile = |level: &Level| (*level, at.column() >> level.0, at.row() >> level.1);
        let near = self.levels.keys().filter_map(|level| self.tiles.get(&tile(level)));
        near.flatten().filter(|range| range.holds(at)).copied().collect()
    }
}
