//! Parts of pieces along one axis.

/// From `low` to `high` of a piece whose own window is 0 to 1.
#[derive(Clone, Copy, Debug)]
pub(in crate::making) struct Interval {
    pub piece: usize,
    pub low: f64,
    pub high: f64,
}

impl Interval {
    /// All of a piece.
    pub(in crate::making) fn whole(piece: usize) -> Self {
        Self { piece, low: 0.0, high: 1.0 }
    }

    /// The two halves.
    pub(in crate::making) fn halves(&self) -> Vec<Self> {
        let middle = f64::midpoint(self.low, self.high);
        vec![Self { high: middle, ..*self }, Self { low: middle, ..*self }]
    }
}
