//! The least box round what is drawn.

use pforms_mesh::vector::{Vec3, norm, subtract};

/// A box along the axes; empty until a point is added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The corner with the least coordinates.
    pub low: Vec3,
    /// The corner with the greatest.
    pub high: Vec3,
}

impl Default for Bounds {
    fn default() -> Self {
        Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] }
    }
}

impl Bounds {
    /// The box round some points.
    pub fn of<'a>(points: impl IntoIterator<Item = &'a Vec3>) -> Self {
        let mut bounds = Self::default();
        for point in points {
            bounds.add(point, 0.0);
        }
        bounds
    }

    /// Makes room for a ball.
    pub fn add(&mut self, point: &Vec3, radius: f64) {
        for (low, x) in self.low.iter_mut().zip(point) {
            *low = low.min(x - radius);
        }
        for (high, x) in self.high.iter_mut().zip(point) {
            *high = high.max(x + radius);
        }
    }

    /// Makes room for another box.
    pub fn join(&mut self, other: &Self) {
        if !other.is_empty() {
            self.add(&other.low, 0.0);
            self.add(&other.high, 0.0);
        }
    }

    /// Does it hold no point at all?
    pub fn is_empty(&self) -> bool {
        self.low[0] > self.high[0]
    }

    /// Centre and radius of a ball round the box; the unit ball round an empty one.
    pub fn ball(&self) -> (Vec3, f64) {
        if self.is_empty() {
            return ([0.0; 3], 1.0);
        }
        let centre = std::array::from_fn(|k| self.low[k] / 2.0 + self.high[k] / 2.0);
        let radius = norm(subtract(self.high, centre));
        (centre, if radius > 0.0 { radius } else { 1.0 })
    }
}
