//! Gordon surfaces of curves whose crossings are not known beforehand.

use pforms_kernel::{Error, Form, Result};

use super::crossings::{Crossing, crossings};
use super::family::Family;
use super::path::Path;
use super::{extent, gordon, require_curves};
use crate::algebra::Spline;
use crate::measuring::vector::{norm, plus};

/// A Gordon surface, and how well it keeps its curves.
#[derive(Clone, Debug, PartialEq)]
pub struct Network {
    /// The surface over the unit square.
    pub spline: Spline,
    /// Largest distance found between a curve and the surface at its parameter.
    pub error: f64,
    /// Largest distance between two curves that cross.
    pub gap: f64,
    /// Parameters of the curves that run along v.
    pub u: Vec<f64>,
    /// Parameters of the curves that run along u.
    pub v: Vec<f64>,
}

/// The surface through a network of curves, whose crossings, order and directions are found.
///
/// Crossings are where two curves come within `accuracy` times the largest coordinate. The first curve
/// of each family sets the direction; ends that reach beyond the outermost crossings are cut off. A
/// closed family has its seam curve twice, as the first and the last. A curve may be a single point,
/// as a nose is.
///
/// Where the crossings lie at the same parameters along all curves of a family, those curves are kept
/// as they are. Otherwise they are run through at a pace that makes their crossings agree at the mean
/// parameters: as point sets they stay what they are, but as splines they are then cubics that
/// follow them within a quarter of the accuracy; and so are rational curves. `error` says how far
/// surface and curves are apart in the end, looked at on every piece.
///
/// Errors: `Shape` for too few curves and for anything else; `Domain` for curves that do not meet, with
/// the gap, or cross in different orders; `Accuracy` when it cannot be reached; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Spline, gordon_network};
/// let curve = |points: &[f64]| -> pforms_kernel::Result<Spline> {
///     Ok(Form::from_points(&[points.len() / 2], 2, points, None)?.into())
/// };
/// let us = [curve(&[-1., 0., 3., 0.])?, curve(&[2., 2., 0., 2.])?];
/// let vs = [curve(&[0., 0., 0., 2.])?, curve(&[2., 0., 2., 3.])?];
/// let found = gordon_network(&us, &vs, 1e-6)?;
/// assert!(found.error < 1e-6 && found.gap < 1e-12);
/// assert_eq!(found.spline.at(&[0.0, 1.0])?, [0.0, 2.0]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn gordon_network(us: &[Spline], vs: &[Spline], accuracy: f64) -> Result<Network> {
    require_curves(us, vs)?;
    if us.is_empty() || vs.is_empty() {
        let name = if us.is_empty() { "us" } else { "vs" };
        return Err(Error::shape(name, "no curves", "curves, or parameters of those of the other"));
    }
    if !(accuracy > 0.0 && accuracy <= 1.0) {
        return Err(Error::domain("accuracy", accuracy, "a number between 0 and 1"));
    }
    // Squares of lengths neither overflow nor vanish near 1, and a power of two costs no bit.
    let size = power_of_two(extent(us, vs));
    let [us, vs] = [scaled(us, 1.0 / size)?, scaled(vs, 1.0 / size)?];
    let found = found(&us, &vs, accuracy, size)?;
    let spline = times(&found.spline, size)?;
    Ok(Network { spline, error: found.error * size, gap: found.gap * size, ..found })
}

/// The largest power of two up to a size, within what can be inverted.
fn power_of_two(size: f64) -> f64 {
    if size > 0.0 { size.log2().floor().clamp(-1000.0, 1000.0).exp2() } else { 1.0 }
}

fn scaled(splines: &[Spline], factor: f64) -> Result<Vec<Spline>> {
    splines.iter().map(|spline| times(spline, factor)).collect()
}

fn times(spline: &Spline, factor: f64) -> Result<Spline> {
    let net = spline.net();
    let mut poles = net.homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(net.width()) {
        for x in &mut pole[..net.ambient()] {
            *x *= factor;
        }
    }
    let net = Form::from_homogeneous(net.orders(), net.ambient(), poles)?;
    Spline::on(net, spline.knots().to_vec())
}

/// The surface of curves whose largest coordinate is between 1 and 2, once `size` times that.
fn found(us: &[Spline], vs: &[Spline], accuracy: f64, size: f64) -> Result<Network> {
    let reach = accuracy * extent(us, vs);
    let [along, across] = [paths(us)?, paths(vs)?];
    let met = all_crossings(&along, &across, reach, size)?;
    let gap = met.iter().flatten().map(|all| least_gap(all)).fold(0.0, f64::max);
    let first = Family::new("us", &along, &met, |crossing| crossing.s, reach)?;
    let turned: Vec<Vec<Vec<Crossing>>> =
        (0..vs.len()).map(|i| met.iter().map(|row| row[i].clone()).collect()).collect();
    let second = Family::new("vs", &across, &turned, |crossing| crossing.t, reach)?;
    let [first, second] = [first.ordered(&second.across)?, second.ordered(&first.across)?];
    let (u, v) = (first.places.clone(), second.places.clone());
    // Gaps are within reach already; what is followed is off by half of that more at most.
    let spline = gordon(&first.curves, &second.curves, &u, &v, &(2.0 * accuracy))?;
    let error = first.distance(&spline, 1, &v)?.max(second.distance(&spline, 0, &u)?);
    Ok(Network { spline, error, gap, u, v })
}

impl Network {
    /// [`gordon`] in floating numbers, and how well it keeps its curves.
    ///
    /// Errors: as [`gordon`].
    pub fn given(
        us: &[Spline],
        vs: &[Spline],
        u: &[f64],
        v: &[f64],
        accuracy: f64,
    ) -> Result<Self> {
        let spline = gordon(us, vs, u, v, &accuracy)?;
        let (first, second) =
            (Family::as_given(us, &spline, 0)?, Family::as_given(vs, &spline, 1)?);
        let mut gap = 0.0_f64;
        for ((along, own), at_v) in first.paths.iter().zip(&first.paces).zip(v) {
            for ((across, other), at_u) in second.paths.iter().zip(&second.paces).zip(u) {
                let there = across.at(other.at(*at_v).0)?;
                gap = gap.max(norm(&plus(&along.at(own.at(*at_u).0)?, -1.0, &there)));
            }
        }
        let error = first.distance(&spline, 1, v)?.max(second.distance(&spline, 0, u)?);
        Ok(Self { spline, error, gap, u: u.to_vec(), v: v.to_vec() })
    }
}

pub(super) fn paths(curves: &[Spline]) -> Result<Vec<Path>> {
    curves.iter().map(Path::new).collect()
}

fn least_gap(all: &[Crossing]) -> f64 {
    all.iter().map(|crossing| crossing.gap).fold(f64::INFINITY, f64::min)
}

fn all_crossings(
    us: &[Path],
    vs: &[Path],
    reach: f64,
    size: f64,
) -> Result<Vec<Vec<Vec<Crossing>>>> {
    let mut met = Vec::with_capacity(us.len());
    for (j, along) in us.iter().enumerate() {
        let mut row = Vec::with_capacity(vs.len());
        for (i, across) in vs.iter().enumerate() {
            let all = crossings(along, across, reach)?;
            let gap = least_gap(&all);
            if gap > reach {
                let received = format!("curve {j} of us and curve {i} of vs {} apart", gap * size);
                return Err(Error::domain("us", received, format!("at most {}", reach * size)));
            }
            row.push(all);
        }
        met.push(row);
    }
    Ok(met)
}
