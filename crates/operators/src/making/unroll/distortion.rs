//! What a map from a surface to the plane does to lengths, angles and areas.

use crate::measuring::vector::{cross, dot, norm};

/// The largest changes found; 0 for an isometry. Measured on a grid over every piece of the result,
/// borders included, but for points where the surface has no area.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Distortion {
    /// Of a length: `|stretch − 1|`, over all directions.
    pub length: f64,
    /// Of an angle between two directions, in radians.
    pub angle: f64,
    /// Of an area: `|stretch − 1|`.
    pub area: f64,
}

/// Share of `|f_u|·|f_v|` below which the surface has no area at a point.
const FLAT: f64 = 1e-7;

impl Distortion {
    /// Takes in a point: the derivatives of the surface there, and those of the map to the plane.
    pub(super) fn at(&mut self, [a, b]: &[[f64; 3]; 2], [p, q]: &[[f64; 2]; 2]) {
        let (length, area) = (norm(a), norm(&cross(a, b)));
        if area <= FLAT * length * norm(b) || area == 0.0 {
            return;
        }
        // In an orthonormal basis of the tangent plane: a = (length, 0), b = (lean, across).
        let (lean, across) = (dot(a, b) / length, area / length);
        let e = [p[0] / length, p[1] / length];
        let f = [(q[0] - lean * e[0]) / across, (q[1] - lean * e[1]) / across];
        // Singular values of the matrix with columns e, f.
        let sum = libm::hypot(e[0] + f[1], e[1] - f[0]);
        let difference = libm::hypot(e[0] - f[1], e[1] + f[0]);
        let (most, least) = (f64::midpoint(sum, difference), f64::midpoint(sum, -difference).abs());
        let area = e[0] * f[1] - e[1] * f[0];
        self.length = self.length.max((most - 1.0).abs()).max((least - 1.0).abs());
        self.angle = self.angle.max(2.0 * libm::asin((difference / sum).clamp(0.0, 1.0)));
        self.area = self.area.max((area - 1.0).abs());
    }
}
