//! The cage as embedding works on it: pieces at the origin, of size about one.

use pforms_kernel::{Error, Result};

use crate::measuring::project::target::binade;
use crate::measuring::project::weight::{Weights, positive_weights};
use crate::{Poles, Shape, Spline};

/// Points farther than this many sizes of the cage are refused: products with them would overflow.
const FARTHEST: f64 = 1e120;

/// A cage moved to the origin and scaled by a power of two, cut into its pieces.
pub(super) struct Cage {
    /// Orders of every piece.
    pub orders: Vec<usize>,
    /// Numbers of a pole: one for each axis, and the weight of a rational cage.
    pub width: usize,
    /// Poles of the pieces, the last axis fastest.
    pub pieces: Vec<Vec<f64>>,
    /// Pieces along each axis.
    pub counts: Vec<usize>,
    /// Where pieces begin and end.
    pub breaks: Vec<Vec<f64>>,
    /// Do pieces part at a break?
    pub parted: bool,
    /// No weight in the window is less.
    pub least_weight: f64,
    /// What rounding may do to a point of the cage.
    pub noise: f64,
    /// Half the largest side of its box.
    pub half: f64,
    centre: Vec<f64>,
    scale: f64,
}

impl Cage {
    /// Errors: `Shape` unless there are as many parameters as coordinates; `Domain` when the weight
    /// vanishes in the window or a pole overflows; `Degenerate` when it is flat along an axis.
    pub(super) fn new(cage: &Shape) -> Result<Self> {
        let axes = cage.net().axes();
        require_volume(cage)?;
        let (counts, breaks, parted) = match cage {
            Shape::Form(_) => (vec![1; axes], vec![vec![0.0, 1.0]; axes], false),
            Shape::Spline(spline) => (spline.counts(), spline.breaks(), is_parted(spline)),
        };
        let forms = cage.pieces()?;
        let weights: Vec<Weights> = forms.iter().map(positive_weights).collect::<Result<_>>()?;
        let least = weights.iter().fold(f64::INFINITY, |least, w| least.min(w.least));
        let largest = weights.iter().fold(0.0_f64, |most, w| most.max(w.largest));
        let side = |k: usize| {
            let low = weights.iter().fold(f64::INFINITY, |least, w| least.min(w.lower[k]));
            let high = weights.iter().fold(f64::NEG_INFINITY, |most, w| most.max(w.upper[k]));
            (low / 2.0 + high / 2.0, high / 2.0 - low / 2.0)
        };
        let sides: Vec<(f64, f64)> = (0..axes).map(side).collect();
        let half = sides.iter().fold(0.0_f64, |most, side| most.max(side.1));
        if half == 0.0 {
            return Err(Error::degenerate("cage", "a single point", "a cage with an inside"));
        }
        let away = sides.iter().fold(0.0_f64, |most, side| most.max(side.0.abs()));
        let (centre, scale) = (sides.iter().map(|side| side.0).collect::<Vec<_>>(), binade(half));
        let rational = forms.iter().any(pforms_kernel::Form::is_rational)
            || forms.windows(2).any(|pair| pair[0].uniform_weight() != pair[1].uniform_weight());
        let unit = binade(largest);
        let mut amplified = 1.0_f64;
        let pieces = forms.iter().zip(&weights).map(|(form, found)| {
            let mut poles = Vec::with_capacity(form.homogeneous().len());
            for pole in form.homogeneous().chunks_exact(axes + 1) {
                place(pole, &centre, scale, found.sign * unit, rational, &mut poles);
                if found.sign * pole[axes] <= 0.0 {
                    amplified = poles.iter().fold(amplified, |most, x| most.max(x.abs()));
                }
            }
            poles
        });
        let pieces: Vec<Vec<f64>> = pieces.collect();
        let least_weight = if rational { least / unit } else { 1.0 };
        let orders = forms[0].orders().to_vec();
        let degrees: usize = orders.iter().map(|order| order - 1).sum();
        let roundings = (2 * degrees + axes + 8) as f64;
        Ok(Self {
            width: axes + usize::from(rational),
            noise: roundings * f64::EPSILON * amplified / least_weight.min(1.0)
                * (1.0 + away / scale),
            half: half / scale,
            orders,
            pieces,
            counts,
            breaks,
            parted,
            least_weight,
            centre,
            scale,
        })
    }

    /// Number of parameters, and of coordinates.
    pub(super) fn axes(&self) -> usize {
        self.orders.len()
    }

    /// Do the weights differ?
    pub(super) fn is_rational(&self) -> bool {
        self.width > self.axes()
    }

    /// A point in the coordinates of the pieces.
    ///
    /// Errors: `Domain` when it is not finite or out of reach.
    #[inline]
    pub(super) fn place(&self, point: &[f64], placed: &mut [f64]) -> Result<()> {
        let mut is_near = true;
        for ((to, x), centre) in placed.iter_mut().zip(point).zip(&self.centre) {
            *to = (x - centre) / self.scale;
            is_near &= to.abs() <= FARTHEST;
        }
        if is_near { Ok(()) } else { Err(too_far(point)) }
    }

    /// A length among the pieces as one of the cage.
    pub(super) fn length(&self, placed: f64) -> f64 {
        placed * self.scale
    }

    /// Index of a piece along each axis.
    pub(super) fn index(&self, piece: usize) -> Vec<usize> {
        let mut rest = piece;
        let mut index = vec![0; self.axes()];
        for (i, count) in index.iter_mut().zip(&self.counts).rev() {
            *i = rest % count;
            rest /= count;
        }
        index
    }

    /// Number of the piece with an index along each axis.
    pub(super) fn number(&self, index: &[usize]) -> usize {
        index.iter().zip(&self.counts).fold(0, |flat, (i, count)| flat * count + i)
    }

    /// A parameter of the cage for that of a piece along `axis`; the ends are exact.
    pub(super) fn parameter(&self, axis: usize, piece: usize, t: f64) -> f64 {
        let (from, to) = (self.breaks[axis][piece], self.breaks[axis][piece + 1]);
        if t < 0.5 { from + t * (to - from) } else { to - (1.0 - t) * (to - from) }
    }

    /// [`Cage::parameter`] beyond the ends of a piece.
    pub(super) fn continued_parameter(&self, axis: usize, piece: usize, t: f64) -> f64 {
        let (from, to) = (self.breaks[axis][piece], self.breaks[axis][piece + 1]);
        from + t * (to - from)
    }

    /// How long the window of a piece is along `axis`, in windows of the cage.
    pub(super) fn share(&self, axis: usize, piece: usize) -> f64 {
        let breaks = &self.breaks[axis];
        (breaks[piece + 1] - breaks[piece]) / (breaks[breaks.len() - 1] - breaks[0])
    }
}

#[cold]
fn too_far(point: &[f64]) -> Error {
    if let Some(x) = point.iter().find(|x| !x.is_finite()) {
        return Error::domain("points", x, "finite coordinates");
    }
    let expected = format!("points within {FARTHEST:e} times the size of the cage");
    Error::domain("points", format!("{point:?}"), expected)
}

/// Complains unless there is a coordinate for each parameter, and more than one pole along each.
fn require_volume(cage: &Shape) -> Result<()> {
    let net = cage.net();
    if net.axes() == 0 || net.axes() != net.ambient() {
        return Err(Error::shape(
            "cage",
            format!("a {} in {}D", net.kind(), net.ambient()),
            "as many parameters as coordinates, at least one",
        ));
    }
    let degrees = match cage {
        Shape::Form(form) => form.degrees(),
        Shape::Spline(spline) => spline.degrees(),
    };
    match degrees.iter().position(|degree| *degree == 0) {
        None => Ok(()),
        Some(axis) => Err(Error::degenerate(
            "cage",
            format!("degree 0 along axis {axis}"),
            "a cage that varies along each axis",
        )),
    }
}

fn is_parted(spline: &Spline) -> bool {
    spline.knots().iter().any(|knots| {
        let breaks = knots.breaks();
        breaks[1..breaks.len() - 1].iter().any(|t| knots.multiplicity(t) > knots.degree())
    })
}

/// `(X − centre·w) / scale`, and the weight of a rational cage in units of `unit`. A pole that is a
/// point is divided first, so that what is far away and small keeps its digits.
fn place(pole: &[f64], centre: &[f64], scale: f64, unit: f64, rational: bool, into: &mut Vec<f64>) {
    let weight = pole[centre.len()];
    let share = if rational { weight / unit } else { 1.0 };
    for (x, centre) in pole.iter().zip(centre) {
        into.push(if !rational || weight * unit > 0.0 {
            (x / weight - centre) / scale * share
        } else {
            (x / unit - centre * share) / scale
        });
    }
    if rational {
        into.push(share);
    }
}
