//! The poles of a surface as seen from its corners.

use pforms_kernel::Form;

use crate::measuring::local::{corner_point, seen_from};

/// The coordinates seen from a corner, and the weight.
pub(super) type Pole = [f64; 4];

/// The poles seen from each of the four corners.
pub(super) struct Nets<'a> {
    pub surface: &'a Form,
    /// Numbered `far along u + 2·(far along v)`.
    corners: [Vec<Pole>; 4],
    /// The weight that all poles have, if they have one.
    pub uniform: Option<f64>,
    /// The largest coordinate seen from any corner.
    pub reach: f64,
}

impl<'a> Nets<'a> {
    pub(super) fn new(surface: &'a Form) -> Self {
        let corners = [[false, false], [true, false], [false, true], [true, true]];
        let corners = corners.map(|corner| seen_from_corner(surface, corner));
        let sizes = corners.iter().flat_map(|net| net.as_flattened()).map(|x| x.abs());
        let reach = sizes.fold(0.0, f64::max);
        Self { surface, corners, uniform: surface.uniform_weight().copied(), reach }
    }

    /// The poles seen from the corner nearest to a point, and one that is not used.
    pub(super) fn near(&self, far_u: bool, far_v: bool) -> &[Pole] {
        &self.corners[usize::from(far_u) + 2 * usize::from(far_v)]
    }

    /// Numbers of poles along the two axes.
    pub(super) fn orders(&self) -> [usize; 2] {
        [self.surface.orders()[0], self.surface.orders()[1]]
    }

    /// About how many operations a normal takes.
    pub(super) fn cost(&self) -> usize {
        6 * self.surface.homogeneous().len()
    }
}

/// Above it a parameter belongs to the far half of the window.
pub(super) const MIDDLE: f64 = 0.5;

pub(super) fn is_far(t: f64) -> bool {
    t > MIDDLE
}

fn seen_from_corner(surface: &Form, corner: [bool; 2]) -> Vec<Pole> {
    let centre = corner_point(surface, &corner);
    let (poles, _) = surface.homogeneous().as_chunks::<4>();
    let seen = |pole: &Pole, k: usize| seen_from(pole[k], centre[k] * pole[3]).value;
    let seen = poles.iter().map(|pole| [seen(pole, 0), seen(pole, 1), seen(pole, 2), pole[3]]);
    // Lines of an odd order are read with one pole more.
    seen.chain([[0.0; 4]]).collect()
}
