//! The poles of a surface as seen from its corners.

use pforms_kernel::{Form, Result};

use crate::measuring::local::{corner_point, seen_from};

/// The coordinates seen from a corner, and the weight.
pub(super) type Pole = [f64; 4];

/// The poles seen from each of the four corners.
pub(super) struct Nets {
    /// The surface, its coordinates and its weights scaled by powers of two to about 1: products of
    /// four of them neither overflow nor vanish, and the normals are the same.
    pub surface: Form,
    /// Numbered `far along u + 2·(far along v)`.
    corners: [Vec<Pole>; 4],
    /// The weight that all poles have, if they have one.
    pub uniform: Option<f64>,
    /// The largest coordinate seen from any corner.
    pub reach: f64,
}

impl Nets {
    /// Errors: none, since scaled poles are finite.
    pub(super) fn new(surface: &Form) -> Result<Self> {
        let surface = of_size_one(surface)?;
        let corners = [[false, false], [true, false], [false, true], [true, true]];
        let corners = corners.map(|corner| seen_from_corner(&surface, corner));
        let sizes = corners.iter().flat_map(|net| net.as_flattened()).map(|x| x.abs());
        let reach = sizes.fold(0.0, f64::max);
        let uniform = surface.uniform_weight().copied();
        Ok(Self { surface, corners, uniform, reach })
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

fn of_size_one(surface: &Form) -> Result<Form> {
    let (poles, _) = surface.homogeneous().as_chunks::<4>();
    let largest = |size: fn(&Pole) -> f64| poles.iter().map(size).fold(0.0, f64::max);
    let lengths = power_of_two(largest(|[x, y, z, _]| x.abs().max(y.abs()).max(z.abs())));
    let weights = power_of_two(largest(|pole| pole[3].abs()));
    let scaled = poles.iter().flat_map(|[x, y, z, w]| {
        [scaled(*x, lengths), scaled(*y, lengths), scaled(*z, lengths), scaled(*w, weights)]
    });
    Form::from_homogeneous(surface.orders(), 3, scaled.collect())
}

/// The exponent of a size, in two halves: 2 to the power of all of it may overflow.
fn power_of_two(size: f64) -> [i32; 2] {
    let exponent = if size > 0.0 { (size.to_bits() >> 52) as i32 - 1023 } else { 0 };
    [exponent / 2, exponent - exponent / 2]
}

fn scaled(x: f64, exponents: [i32; 2]) -> f64 {
    exponents.iter().fold(x, |x, exponent| x * 2.0_f64.powi(-exponent))
}

fn seen_from_corner(surface: &Form, corner: [bool; 2]) -> Vec<Pole> {
    let centre = corner_point(surface, &corner);
    let (poles, _) = surface.homogeneous().as_chunks::<4>();
    let seen = |pole: &Pole, k: usize| seen_from(pole[k], centre[k] * pole[3]).value;
    let seen = poles.iter().map(|pole| [seen(pole, 0), seen(pole, 1), seen(pole, 2), pole[3]]);
    // Lines of an odd order are read with one pole more.
    seen.chain([[0.0; 4]]).collect()
}
