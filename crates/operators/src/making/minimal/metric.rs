//! The first fundamental form of a surface at a point.

use crate::measuring::vector::dot;

/// `E`, `F`, `G`, and the root of `EG − F²`.
#[derive(Clone, Copy)]
pub(super) struct Metric {
    pub e: f64,
    pub f: f64,
    pub g: f64,
    pub area: f64,
}

/// Parallel derivatives: below this much of their lengths their angle is rounding.
const PARALLEL: f64 = 1e-14;

/// How far from the metric the softened one is, as a part of its trace.
const SOFT: f64 = 1e-6;

impl Metric {
    /// From the derivatives along u and v. The area is that of orthogonal vectors, not a difference.
    pub(super) fn of(u: &[f64], v: &[f64]) -> Self {
        let (e, f, g) = (dot(u, u), dot(u, v), dot(v, v));
        let (long, short, square) = if e >= g { (u, v, e) } else { (v, u, g) };
        if square == 0.0 {
            return Self { e, f, g, area: 0.0 };
        }
        let share = f / square;
        let rest = long.iter().zip(short).map(|(a, b)| b - share * a);
        let height = rest.fold(0.0, |sum, x| sum + x * x).sqrt();
        let parallel = height <= PARALLEL * dot(short, short).sqrt();
        Self { e, f, g, area: if parallel { 0.0 } else { height * square.sqrt() } }
    }

    /// What turns derivatives into the slope of the area by them: `(G, −F, E)/area`; 0 where there
    /// is none.
    pub(super) fn slope(self) -> [f64; 3] {
        if self.area > 0.0 { self.conformal() } else { [0.0; 3] }
    }

    /// The same for a metric nearby that is nowhere degenerate; `size` is the least that counts.
    pub(super) fn softened(self, size: f64) -> [f64; 3] {
        let more = SOFT * (self.e + self.g + size * size);
        let (e, g) = (self.e + more, self.g + more);
        let area = (self.area * self.area + more * (self.e + self.g + more)).sqrt();
        Self { e, f: self.f, g, area }.conformal()
    }

    fn conformal(self) -> [f64; 3] {
        [self.g / self.area, -self.f / self.area, self.e / self.area]
    }
}
