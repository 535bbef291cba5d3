//! The steps from a boundary to a surface of little area.

use pforms_kernel::{Error, Form, Result};

use super::area::Minimal;
use super::boundary::Frame;
use super::descent::{FLOOR, Least};
use super::metric::Metric;
use super::patch::{Patch, Point};
use super::units::Units;
use super::{Functional, MinimalOptions, least};
use crate::algebra::{Poles, Shape, Spline};
use crate::measuring::vector::{dot, plus};
use crate::measuring::{Measure, area};

/// A boundary in small units, with what is known about the surfaces on it.
pub(super) struct Work {
    frame: Frame<f64>,
    /// The Coons patch; none if its weights change sign.
    coons: Option<Spline>,
    /// Lengths of the box of parameters, along u and v.
    sides: Vec<f64>,
    options: MinimalOptions,
    nodes: usize,
}

/// Nodes for each piece and axis at most, as long as a rule half as fine will not do.
const NODES: usize = 96;

/// Areas by two rules that differ less are taken for the same.
const AGREE: f64 = 1e-12;

/// Accuracies that are asked for in turn, as parts of an area.
const ACCURACIES: [f64; 4] = [1e-12, 1e-9, 1e-6, 1e-3];

/// Times the ratio of the sides is adjusted.
const ROUNDS: usize = 40;

impl Work {
    pub(super) fn new(frame: &Frame<f64>, units: &Units, options: &MinimalOptions) -> Result<Self> {
        let coons = frame.coons().ok().filter(|coons| Units::of(coons.net()).is_ok());
        let coons = coons.map(|coons| units.small(&coons)).transpose()?;
        let frame = Frame { spline: units.small(&frame.spline)?, ..frame.clone() };
        let sides = frame.sides(&options.sides)?;
        let nodes = 2 * frame.spline.degrees().into_iter().max().unwrap_or(0) + 8;
        Ok(Self { frame, coons, sides, options: options.clone(), nodes })
    }

    /// The coordinates of poles that make a functional least.
    pub(super) fn least(&self, functional: Functional) -> Result<Vec<f64>> {
        let net = self.frame.spline.net();
        if net.uniform_weight().is_some() {
            return Ok(coordinates(&least(&self.frame, functional, &self.options.sides)?));
        }
        if functional == Functional::Dirichlet {
            let patch = Patch::new(&self.frame.spline, self.nodes);
            return self.rational(&patch, self.ratio());
        }
        let received = "weights that are not equal";
        Err(Error::domain(
            "boundary",
            received,
            "equal weights, or the Dirichlet energy or the area",
        ))
    }

    /// The length of the box along v, that along u being 1, when `∂v` counts `1/ratio` times as `∂u`.
    fn length_ratio(&self, ratio: f64) -> f64 {
        ratio * self.sides[1] / self.sides[0] / self.ratio()
    }

    /// The scale of parameters along v by that along u.
    fn ratio(&self) -> f64 {
        let window = |axis: usize| self.frame.spline.knots()[axis].window();
        let scale = |axis: usize| self.sides[axis] / (window(axis).1 - window(axis).0);
        scale(1) / scale(0)
    }

    /// The least Dirichlet energy of a rational surface: its weights stay, and so the points depend on
    /// the coordinates linearly.
    fn rational(&self, patch: &Patch, ratio: f64) -> Result<Vec<f64>> {
        let rule = |_: Metric| [ratio, 0.0, 1.0 / ratio];
        let ambient = self.frame.spline.ambient();
        let mut all = coordinates(self.frame.spline.net());
        let matrix = patch.matrix(&all, &self.frame.free, rule).factored(&FLOOR, true)?;
        let slope = patch.slope(&all, rule);
        let poles = self.frame.free.iter().map(|&index| &slope[index * ambient..][..ambient]);
        let mut step: Vec<f64> = poles.flatten().copied().collect();
        matrix.solve(&mut step, ambient);
        for (&index, step) in self.frame.free.iter().zip(step.chunks_exact(ambient)) {
            let pole = &mut all[index * ambient..][..ambient];
            pole.iter_mut().zip(step).for_each(|(x, step)| *x -= step);
        }
        Ok(all)
    }

    /// The coordinates of poles of least area, and the steps it took.
    pub(super) fn descend(&self, accuracy: f64) -> Result<(Vec<f64>, usize)> {
        let mut nodes = self.nodes;
        let mut patch = Patch::new(&self.frame.spline, nodes);
        let mut best = self.start(&patch)?;
        let mut steps = 0;
        loop {
            let found = self.on(&patch).descend(best.clone(), accuracy)?;
            steps += found.steps;
            nodes *= 2;
            let finer = Patch::new(&self.frame.spline, nodes);
            let (before, after) = (finer.area(&best), finer.area(&found.coordinates));
            if !after.is_finite() {
                return Err(not_finite());
            }
            // The finer rule must agree that the area has become less.
            if after <= before {
                best = found.coordinates;
            }
            let same = (after - patch.area(&best)).abs() <= AGREE * after;
            if same || found.steps == 0 || nodes > NODES {
                return Ok((best, steps));
            }
            patch = finer;
        }
    }

    /// Of the poles that a descent found, the Coons patch and the surface of least Dirichlet energy those
    /// whose area, as it will be reported, is least.
    pub(super) fn lowest(&self, found: Vec<f64>) -> Result<Vec<f64>> {
        let mut all = vec![found];
        all.push(self.least(Functional::Dirichlet)?);
        if self.options.keep.is_empty() {
            all.extend(self.on_same_weights().map(coordinates));
        }
        let mut best: Option<(f64, Vec<f64>)> = None;
        for poles in all {
            let area = certified(&self.frame.spline.with_net(self.net_of(&poles)?)?)?.value;
            if best.as_ref().is_none_or(|(least, _)| area < *least) {
                best = Some((area, poles));
            }
        }
        best.map(|(_, poles)| poles).ok_or_else(not_finite)
    }

    /// The net of the Coons patch, if only coordinates tell it from others.
    fn on_same_weights(&self) -> Option<&Form> {
        let net = self.coons.as_ref().map(Spline::net)?;
        (net.weights() == self.frame.spline.net().weights()).then_some(net)
    }

    fn on<'a>(&'a self, patch: &'a Patch) -> Least<'a> {
        let ambient = self.frame.spline.ambient();
        Least { patch, free: &self.frame.free, ambient, size: 1e-6 }
    }

    /// The least area of the form itself, the Coons patch and surfaces of least Dirichlet energy.
    fn start(&self, patch: &Patch) -> Result<Vec<f64>> {
        let own = coordinates(self.frame.spline.net());
        let mut all = self.dirichlet(patch)?;
        if self.options.keep.is_empty() {
            all.extend(self.on_same_weights().map(coordinates));
        } else {
            all.push(own.clone());
        }
        let areas = all.into_iter().map(|poles| (patch.area(&poles), poles));
        let least = areas.filter(|(area, _)| area.is_finite()).min_by(|a, b| a.0.total_cmp(&b.0));
        Ok(least.map_or(own, |(_, poles)| poles))
    }

    /// Surfaces of least Dirichlet energy: on the window as it is, and on the box whose sides make the
    /// energy least, found by turns.
    fn dirichlet(&self, patch: &Patch) -> Result<Vec<Vec<f64>>> {
        let mut ratio = self.ratio();
        let mut all = vec![self.rational(patch, ratio)?];
        for _ in 0..ROUNDS {
            let last = &all[all.len() - 1];
            let [along, across] =
                [0, 1].map(|k| patch.sum(last, |point| dot(&point.slopes[k], &point.slopes[k])));
            let next = (across / along).sqrt();
            if !(1e-6..1e6).contains(&next) || (next / ratio - 1.0).abs() < 1e-15 {
                break;
            }
            ratio = next;
            let found = self.rational(patch, ratio)?;
            all.truncate(1);
            all.push(found);
        }
        if self.frame.spline.net().uniform_weight().is_some() {
            // The same, free of what the condition of the system does in plain numbers.
            for sides in [self.sides.clone(), vec![1.0, self.length_ratio(ratio)]] {
                if let Ok(net) = least(&self.frame, Functional::Dirichlet, &sides) {
                    all.push(coordinates(&net));
                }
            }
        }
        Ok(all)
    }

    /// What is known about a surface.
    pub(super) fn report(&self, poles: &[f64], steps: usize) -> Result<Minimal> {
        let surface = self.frame.spline.with_net(self.net_of(poles)?)?;
        let measured = certified(&surface)?;
        let patch = Patch::new(&surface, 2 * self.nodes);
        let ratio = self.ratio();
        let energy = patch.sum(poles, |point| {
            let [u, v] = &point.slopes;
            f64::midpoint(ratio * dot(u, u), dot(v, v) / ratio)
        });
        let coons = self.coons.as_ref().map(certified).transpose()?;
        let area = measured.value;
        let bent = patch.sum_of_bends(poles, |point, bends| {
            mean_curvature(point, bends).powi(2) * point.metric().area
        });
        Ok(Minimal {
            surface: self.frame.with(surface.net().clone())?,
            area,
            error: measured.error,
            coons_area: coons.map(|coons| coons.value),
            energy,
            laplacian: self.laplacian(&patch, poles),
            curvature: if area > 0.0 { (bent / area).sqrt() } else { 0.0 },
            slope: self.on(&patch).slope_at(poles)?,
            steps,
        })
    }

    /// The root of the mean square of `ΔS`, over the box of parameters.
    fn laplacian(&self, patch: &Patch, poles: &[f64]) -> f64 {
        let window = |axis: usize| {
            let (from, to) = self.frame.spline.knots()[axis].window();
            to - from
        };
        let [u, v] = [0, 1].map(|axis| (window(axis) / self.sides[axis]).powi(2));
        let square = patch.sum_of_bends(poles, |_, [uu, _, vv]| {
            uu.iter().zip(vv).map(|(a, b)| (u * a + v * b).powi(2)).sum()
        });
        (square / (window(0) * window(1))).sqrt()
    }

    fn net_of(&self, poles: &[f64]) -> Result<Form> {
        let net = self.frame.spline.net();
        let mut all = net.homogeneous().to_vec();
        let pairs = all.chunks_exact_mut(net.width()).zip(poles.chunks_exact(net.ambient()));
        pairs.for_each(|(pole, x)| pole[..net.ambient()].copy_from_slice(x));
        Form::from_homogeneous(net.orders(), net.ambient(), all)
    }
}

/// Half the trace of the second fundamental form, in any dimension: the size of its vector.
fn mean_curvature(point: &Point<'_>, [uu, uv, vv]: &[Vec<f64>; 3]) -> f64 {
    let metric = point.metric();
    if metric.area == 0.0 {
        return 0.0;
    }
    let square = metric.area * metric.area;
    let trace = uu.iter().zip(uv).zip(vv);
    let trace: Vec<f64> = trace
        .map(|((uu, uv), vv)| (metric.g * uu - 2.0 * metric.f * uv + metric.e * vv) / square)
        .collect();
    let [u, v] = &point.slopes;
    let (a, b) = (dot(&trace, u), dot(&trace, v));
    let along = [metric.g * a - metric.f * b, metric.e * b - metric.f * a].map(|x| x / square);
    let normal = plus(&plus(&trace, -along[0], u), -along[1], v);
    dot(&normal, &normal).sqrt() / 2.0
}

/// The area with a proved bound: as near as can be had, since near folds it is dear.
fn certified(surface: &Spline) -> Result<Measure> {
    let shape = [Shape::from(surface.clone())];
    let mut found = area(&shape, ACCURACIES[0]);
    for accuracy in &ACCURACIES[1..] {
        if !matches!(found, Err(Error::Accuracy { .. } | Error::Limit { .. })) {
            break;
        }
        found = area(&shape, *accuracy);
    }
    found
}

fn coordinates(net: &Form) -> Vec<f64> {
    let poles = net.homogeneous().chunks_exact(net.width());
    poles.flat_map(|pole| &pole[..net.ambient()]).copied().collect()
}

fn not_finite() -> Error {
    Error::accuracy("boundary", "an area that is not finite", "weights that do not vanish")
}
