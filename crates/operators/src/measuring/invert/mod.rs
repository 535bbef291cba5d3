//! Inversion: the parameters at which a form or spline goes through given points, all of them.

use pforms_kernel::{Error, Form, Result, limit, threads};

use super::patches::{Patch, patches, size};
use super::scale::unit;
use super::system::{Equations, Limits, Solutions, solve};
use super::vector::norm;
use crate::{Poles, Shape};

/// One place at which the host goes through a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Preimage {
    /// The parameters, one for each axis.
    pub parameters: Vec<f64>,
    /// How far the host is from the point there.
    pub distance: f64,
    /// The parameters are wrong by no more than this, if `proved`; otherwise the widest side of the
    /// box they were found in.
    pub error: f64,
    /// Is it shown that there is no other within the error, and, where host and space have one
    /// dimension, that there is one? Otherwise it is a place in a [`Doubt`].
    pub proved: bool,
}

/// A box of parameters in which it is not decided where, and how often, the host meets a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Doubt {
    /// Least parameters.
    pub lower: Vec<f64>,
    /// Greatest parameters.
    pub upper: Vec<f64>,
}

/// All parameters of one point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inversion {
    /// The solutions, in the order of their parameters. None: the point is outside.
    pub solutions: Vec<Preimage>,
    /// What is not decided. Every solution is among the proved ones or in one of these.
    pub doubts: Vec<Doubt>,
}

impl Inversion {
    /// Are the solutions all there are, each proved?
    pub fn complete(&self) -> bool {
        self.doubts.is_empty()
    }

    /// Does the host go through the point, as far as is known?
    pub fn inside(&self) -> bool {
        !self.solutions.is_empty()
    }
}

/// The parameters of points, `ambient` numbers each: all places at which `host` is no farther from
/// them than `accuracy` times its size.
///
/// A curve, a surface, a volume or a form of four axes, in a space of as many dimensions or more;
/// form or spline, rational or not. Every answer is proved: a box of parameters is dropped only
/// where the host is shown not to go through the point, and a solution counts as proved where the
/// equations are shown to have it alone. What cannot be shown, at folds, at collapsed edges, where
/// a curve runs twice over itself, is reported as a [`Doubt`] with the best place in it. Work on
/// each piece is bounded.
///
/// Errors: `Shape` when the host has no axes, more than four, or more than its space has dimensions,
/// or when the count of `points` does not fit; `Domain` for points that are not finite and for an
/// accuracy not between 0 and 1; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// // A loop goes twice through the origin.
/// let fold: Form = Form::from_points(&[4], 2, &[-1., -1., 2., 1., -2., 1., 1., -1.], None)?;
/// let crossing = pforms_operators::invert(&fold.clone().into(), &fold.at(&[0.25])?, 1e-12)?;
/// assert_eq!(crossing[0].solutions.len(), 1);
/// assert!(crossing[0].complete() && crossing[0].solutions[0].proved);
/// assert!((crossing[0].solutions[0].parameters[0] - 0.25).abs() < 1e-15);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn invert(host: &Shape, points: &[f64], accuracy: f64) -> Result<Vec<Inversion>> {
    Inverter::new(host, accuracy)?.invert(points)
}

/// A host made ready for inversion.
pub struct Inverter {
    patches: Vec<Patch>,
    ambient: usize,
    axes: usize,
    /// Coordinates are divided by this.
    unit: f64,
    /// How far the host may be from a point that it goes through.
    reach: f64,
    limits: Limits,
}

/// Parameters outside the window are put on its border up to this many accuracies.
const BORDER: f64 = 16.0;

impl Inverter {
    /// Makes a host ready. The `accuracy` is that of [`invert`].
    ///
    /// Errors: those of [`invert`] that are not of its points.
    pub fn new(host: &Shape, accuracy: f64) -> Result<Self> {
        let net = host.net();
        let (axes, ambient) = (net.axes(), net.ambient());
        if !(0.0..=1.0).contains(&accuracy) {
            return Err(Error::domain("accuracy", accuracy, "a number from 0 to 1"));
        }
        if axes == 0 || axes > 4 || axes > ambient {
            let received = format!("{axes} axes in dimension {ambient}");
            let expected = "1 to 4 axes, no more than the dimension of the space";
            return Err(Error::shape("host", received, expected));
        }
        let unit = unit([net]);
        let scaled = host.with_net(super::scale::in_units(net, unit)?)?;
        let patches = patches(&scaled)?;
        let reach = accuracy * size(&patches);
        let defaults = Limits::default();
        let border = defaults.border.max((BORDER * accuracy).min(1e-6));
        let most = MOST_WORK / net.width();
        Ok(Self {
            patches,
            ambient,
            axes,
            unit,
            reach,
            limits: Limits { most, border, ..defaults },
        })
    }

    /// [`invert`] with this host.
    ///
    /// Errors: those of [`invert`] that are of its points.
    pub fn invert(&self, points: &[f64]) -> Result<Vec<Inversion>> {
        if !points.len().is_multiple_of(self.ambient) {
            let expected = format!("{} for each point", self.ambient);
            return Err(Error::shape("points", format!("{} numbers", points.len()), expected));
        }
        let count = points.len() / self.ambient;
        limit::check::<Inversion>("the inversion", &[count], 1)?;
        let mut answers = vec![Inversion::default(); count];
        threads::fill_parts(&mut answers, 1, COST, |range, out| {
            let part = &points[range.start * self.ambient..range.end * self.ambient];
            for (point, answer) in part.chunks_exact(self.ambient).zip(out) {
                *answer = self.one(point)?;
            }
            Ok(())
        })?;
        Ok(answers)
    }

    fn one(&self, point: &[f64]) -> Result<Inversion> {
        if let Some(x) = point.iter().find(|x| !x.is_finite()) {
            return Err(Error::domain("points", x, "finite numbers"));
        }
        let point: Vec<f64> = point.iter().map(|x| x / self.unit).collect();
        if point.iter().any(|x| x.abs() > FARTHEST) {
            return Ok(Inversion::default());
        }
        let mut answer = Inversion::default();
        for patch in self.patches.iter().filter(|patch| patch.may_reach(&point, self.reach)) {
            self.on(patch, &point, &mut answer)?;
        }
        settle(&mut answer, self.patches.len() > 1);
        Ok(answer)
    }

    /// Adds what is found on a piece.
    fn on(&self, patch: &Patch, point: &[f64], answer: &mut Inversion) -> Result<()> {
        let target = Form::point(point)?;
        let mut equations = Equations::meeting(&patch.form, &target)?;
        if self.ambient > self.axes {
            let heaviest = patch.form.weights().iter().fold(0.0_f64, |most, w| most.max(w.abs()));
            equations = equations.with_tolerance(self.reach * heaviest);
        }
        let Solutions { roots, clusters, .. } = solve(&equations, &self.limits);
        for root in roots {
            let Some(distance) = self.distance(patch, point, &root.parameters) else { continue };
            let error = root.radius * patch.side();
            let parameters = patch.whole(&root.parameters);
            let distance = distance * self.unit;
            answer.solutions.push(Preimage { parameters, distance, error, proved: true });
        }
        for cluster in clusters {
            let error = cluster.width() * patch.side();
            if let Some(distance) = self.distance(patch, point, &cluster.parameters) {
                let parameters = patch.whole(&cluster.parameters);
                let distance = distance * self.unit;
                answer.solutions.push(Preimage { parameters, distance, error, proved: false });
            }
            let (lower, upper) = (patch.whole(&cluster.lower), patch.whole(&cluster.upper));
            answer.doubts.push(Doubt { lower, upper });
        }
        Ok(())
    }

    /// The distance of the point from where it is found; none if that is too far.
    fn distance(&self, patch: &Patch, point: &[f64], parameters: &[f64]) -> Option<f64> {
        let foot = patch.form.at(parameters).ok()?;
        let offset: Vec<f64> = foot.iter().zip(point).map(|(x, y)| x - y).collect();
        let distance = norm(&offset);
        (distance <= self.reach + ROUNDINGS * (norm(point) + norm(&foot))).then_some(distance)
    }
}

/// What rounding does to a distance, in sizes of the coordinates.
const ROUNDINGS: f64 = 256.0 * f64::EPSILON;

/// Points beyond this many sizes of the host are outside it: its poles are not.
const FARTHEST: f64 = 1e120;

/// Arithmetic for one point, about.
const COST: usize = 1 << 14;

/// Cells of one piece, times the coordinates, at most.
const MOST_WORK: usize = 1 << 16;

/// Solutions in the order of their parameters, those that two pieces found once.
fn settle(answer: &mut Inversion, pieces: bool) {
    let order = |a: &[f64], b: &[f64]| {
        let each = a.iter().zip(b).map(|(s, t)| s.total_cmp(t));
        each.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
    };
    answer.solutions.sort_by(|a, b| order(&a.parameters, &b.parameters));
    if !pieces {
        return;
    }
    let mut kept: Vec<Preimage> = Vec::with_capacity(answer.solutions.len());
    for solution in answer.solutions.drain(..) {
        let same = kept.iter().position(|other| {
            let reach = 2.0 * (solution.error + other.error);
            let pairs = solution.parameters.iter().zip(&other.parameters);
            pairs.clone().all(|(s, t)| (s - t).abs() <= reach + 16.0 * f64::EPSILON * s.abs())
        });
        match same {
            Some(i) if solution.proved && !kept[i].proved => kept[i] = solution,
            Some(_) => {}
            None => kept.push(solution),
        }
    }
    answer.solutions = kept;
}
