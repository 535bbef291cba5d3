//! Gordon surfaces of curves whose crossings are not known beforehand.

use pforms_kernel::{Error, Form, Result};

use super::crossings::{Crossing, crossings};
use super::follow::followed;
use super::order::order;
use super::pace::Pace;
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

fn paths(curves: &[Spline]) -> Result<Vec<Path>> {
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

/// Curves along one axis, brought to one pace.
struct Family {
    paths: Vec<Path>,
    paces: Vec<Pace>,
    curves: Vec<Spline>,
    /// Parameters where the other family crosses.
    places: Vec<f64>,
    /// The other family in the order in which it crosses.
    across: Vec<usize>,
}

impl Family {
    fn new(
        name: &str,
        paths: &[Path],
        met: &[Vec<Vec<Crossing>>],
        parameter: impl Fn(&Crossing) -> f64,
        reach: f64,
    ) -> Result<Self> {
        let lists: Vec<Vec<Vec<f64>>> = met
            .iter()
            .zip(paths)
            .map(|(row, path)| {
                let near = 0.1 * reach / path.length()?.max(reach);
                Ok(row.iter().map(|all| settled(all.iter().map(&parameter), near)).collect())
            })
            .collect::<Result<_>>()?;
        let lengths = paths.iter().map(Path::length).collect::<Result<Vec<_>>>()?;
        let points: Vec<bool> = lengths.iter().map(|length| *length <= reach).collect();
        let mut order = order(name, &lists, &points)?;
        let turned = paths.iter().zip(&order.reversed);
        let paths: Vec<Path> = turned
            .map(|(path, &turn)| if turn { path.reversed() } else { Path::new(path.spline()) })
            .collect::<Result<_>>()?;
        let places = means(order.parameters.iter().filter(|own| !own.is_empty()));
        for own in order.parameters.iter_mut().filter(|own| own.is_empty()) {
            own.clone_from(&places);
        }
        let paces: Vec<Pace> = order.parameters.iter().map(|own| pace(own, &places)).collect();
        let mut family = Self { paths, paces, curves: Vec::new(), places, across: order.across };
        family.curves = if family.keeps_pace(&order.parameters, reach)? {
            family.cut(&order.parameters)?
        } else {
            followed(&family.paths, &family.paces, &family.places, 0.25 * reach)?
        };
        Ok(family)
    }

    /// Curves that run along `axis` of a surface at its own pace.
    fn as_given(curves: &[Spline], surface: &Spline, axis: usize) -> Result<Self> {
        let (from, to) = surface.window(axis)?;
        let pace = Pace::new(vec![from, to], vec![0.0, 1.0]);
        Ok(Self {
            paths: paths(curves)?,
            paces: vec![pace; curves.len()],
            curves: Vec::new(),
            places: Vec::new(),
            across: Vec::new(),
        })
    }

    /// Are the crossings at the same parameters of all curves, none of them rational?
    fn keeps_pace(&self, parameters: &[Vec<f64>], reach: f64) -> Result<bool> {
        for (path, own) in self.paths.iter().zip(parameters) {
            let (from, to) = ends(own);
            let near = 0.1 * reach / path.length()?.max(reach);
            let off = |(t, place): (&f64, &f64)| (from + place * (to - from) - t).abs() > near;
            if path.spline().net().is_rational() || own.iter().zip(&self.places).any(off) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The curves from the first crossing to the last, over the window from 0 to 1.
    fn cut(&self, parameters: &[Vec<f64>]) -> Result<Vec<Spline>> {
        let part = |(path, own): (&Path, &Vec<f64>)| match ends(own) {
            (0.0, 1.0) => Ok(path.spline().clone()),
            (from, to) => path.spline().restrict(0, &from, &to)?.on_window(0, &0.0, &1.0),
        };
        self.paths.iter().zip(parameters).map(part).collect()
    }

    /// The family in the order in which it crosses the other.
    fn ordered(&self, order: &[usize]) -> Result<Self> {
        let paths = order.iter().map(|&i| Path::new(self.paths[i].spline()));
        Ok(Self {
            paths: paths.collect::<Result<_>>()?,
            paces: order.iter().map(|&i| self.paces[i].clone()).collect(),
            curves: order.iter().map(|&i| self.curves[i].clone()).collect(),
            places: self.places.clone(),
            across: self.across.clone(),
        })
    }

    /// The largest distance between the curves and those of the surface at parameters `at` of `axis`.
    fn distance(&self, surface: &Spline, axis: usize, at: &[f64]) -> Result<f64> {
        const LOOKS: usize = 6;
        let breaks = &surface.breaks()[1 - axis];
        let between = |pair: &[f64]| {
            let (from, to) = (pair[0], pair[1]);
            (0..LOOKS).map(move |i| from + (to - from) * i as f64 / LOOKS as f64)
        };
        let last = breaks.last().copied();
        let looks: Vec<f64> = breaks.windows(2).flat_map(between).chain(last).collect();
        let mut most = 0.0_f64;
        for ((path, pace), place) in self.paths.iter().zip(&self.paces).zip(at) {
            let there = surface.sub(axis, place)?.scattered(&[&looks])?;
            for (u, point) in looks.iter().zip(there.chunks_exact(surface.ambient())) {
                most = most.max(norm(&plus(&path.at(pace.at(*u).0)?, -1.0, point)));
            }
        }
        Ok(most)
    }
}

/// Parameters in growing order, those next to an end at the end, each once.
fn settled(parameters: impl Iterator<Item = f64>, near: f64) -> Vec<f64> {
    let settle = |t: f64| {
        if t < near {
            0.0
        } else if t > 1.0 - near {
            1.0
        } else {
            t
        }
    };
    let mut list: Vec<f64> = parameters.map(settle).collect();
    list.sort_by(f64::total_cmp);
    list.dedup();
    list
}

/// Where a curve is cut: at its first and last crossing, or not at all if there is only one.
fn ends(own: &[f64]) -> (f64, f64) {
    match own {
        [from, .., to] => (*from, *to),
        _ => (0.0, 1.0),
    }
}

/// The mean of the crossings along all curves, each from 0 to 1.
fn means<'a>(parameters: impl Iterator<Item = &'a Vec<f64>>) -> Vec<f64> {
    let parameters: Vec<&Vec<f64>> = parameters.collect();
    let count = parameters.first().map_or(0, |own| own.len());
    let share = |own: &Vec<f64>, i: usize| {
        let (from, to) = ends(own);
        (own[i] - from) / (to - from)
    };
    let mean = |i: usize| match i {
        0 if count > 1 => 0.0,
        _ if count > 1 && i + 1 == count => 1.0,
        _ => parameters.iter().map(|&own| share(own, i)).sum::<f64>() / parameters.len() as f64,
    };
    (0..count).map(mean).collect()
}

/// The pace at which a curve meets its crossings at the common places.
fn pace(own: &[f64], places: &[f64]) -> Pace {
    let ([t], [place]) = (own, places) else { return Pace::new(places.to_vec(), own.to_vec()) };
    let inside = |x: f64| x > 0.0 && x < 1.0;
    if inside(*t) && inside(*place) {
        return Pace::new(vec![0.0, *place, 1.0], vec![0.0, *t, 1.0]);
    }
    Pace::new(vec![0.0, 1.0], vec![0.0, 1.0])
}
