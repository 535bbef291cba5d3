//! Cones of directions: what tangents and normals of a piece can be.

use super::space::{V3, cross, dot, norm, plus, times, unit};

/// All directions within `angle` of an axis.
#[derive(Clone, Copy)]
pub(super) struct Cone {
    pub axis: V3,
    pub angle: f64,
}

/// Differences of poles below this are rounding alone.
const NOTHING: f64 = 1e-15;

/// Rounding of a difference of poles, in units of the largest coordinate.
const ROUNDING: f64 = 4e-15;

impl Cone {
    /// A cone that holds all `directions`, each known but for an error of length `slack`; none when
    /// they spread over a right angle or more. Vanishing directions do not count.
    pub(super) fn around(directions: impl Iterator<Item = V3> + Clone, slack: f64) -> Option<Self> {
        let mut sum = [0.0; 3];
        for direction in directions.clone() {
            if let Some(along) = unit(&direction).filter(|_| norm(&direction) > NOTHING) {
                sum = plus(&sum, 1.0, &along);
            }
        }
        let axis = unit(&sum)?;
        let mut widest = 0.0_f64;
        for direction in directions {
            if norm(&direction) <= NOTHING && slack == 0.0 {
                continue;
            }
            let (along, across) = (dot(&direction, &axis), norm(&cross(&direction, &axis)));
            let off = slack + ROUNDING.min(0.25 * norm(&direction));
            if along <= off {
                return None;
            }
            widest = widest.max((across + off) / (along - off));
        }
        Some(Self { axis, angle: libm::atan(widest) })
    }

    /// The cone of all normals to a direction of one cone and a direction of another: the normals
    /// of a surface whose tangents these are. Sederberg and Meyers, *Loop detection in surface patch
    /// intersections*, 1988.
    pub(super) fn of_normals(u: &Self, v: &Self) -> Option<Self> {
        let normal = cross(&u.axis, &v.axis);
        let (sine, cosine) = (norm(&normal), dot(&u.axis, &v.axis).abs());
        let (a, b) = (libm::sin(u.angle), libm::sin(v.angle));
        let spread = (a * a + b * b + 2.0 * a * b * cosine).sqrt() / sine;
        // Written so that NaN is no cone.
        let narrow = spread < 1.0;
        narrow.then(|| Self { axis: times(&normal, 1.0 / sine), angle: libm::asin(spread) })
    }

    /// The angle between the axes.
    fn between(&self, other: &Self) -> f64 {
        libm::atan2(norm(&cross(&self.axis, &other.axis)), dot(&self.axis, &other.axis))
    }

    /// Is no direction of one parallel to a direction of the other? Then the intersection of surfaces
    /// with these normals runs along the product of the axes, never back: it has no loops and no
    /// singular points. Sinha, Klassen and Wang, *Exploiting topological and geometric properties for
    /// selective subdivision*, 1985.
    pub(super) fn is_across(&self, other: &Self) -> bool {
        let between = self.between(other);
        self.angle + other.angle < between.min(std::f64::consts::PI - between) - 1e-12
    }

    /// Is no direction of one normal to a direction of the other? Then a curve with these tangents
    /// meets a surface with those normals once at most.
    pub(super) fn is_never_normal_to(&self, other: &Self) -> bool {
        let between = self.between(other);
        let least = between.min(std::f64::consts::PI - between);
        least + self.angle + other.angle < std::f64::consts::FRAC_PI_2 - 1e-12
    }
}
