//! The curves of a network that run one way.

use pforms_kernel::Result;

use super::crossings::Crossing;
use super::follow::followed;
use super::network::paths;
use super::order::order;
use super::pace::Pace;
use super::path::Path;
use crate::algebra::Spline;
use crate::measuring::vector::{norm, plus};

/// Curves along one axis, brought to one pace.
pub(super) struct Family {
    pub paths: Vec<Path>,
    pub paces: Vec<Pace>,
    pub curves: Vec<Spline>,
    /// Parameters where the other family crosses.
    pub places: Vec<f64>,
    /// The other family in the order in which it crosses.
    pub across: Vec<usize>,
}

impl Family {
    pub(super) fn new(
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
    pub(super) fn as_given(curves: &[Spline], surface: &Spline, axis: usize) -> Result<Self> {
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
    pub(super) fn ordered(&self, order: &[usize]) -> Result<Self> {
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
    pub(super) fn distance(&self, surface: &Spline, axis: usize, at: &[f64]) -> Result<f64> {
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
