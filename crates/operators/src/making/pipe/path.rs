//! The path of a tube, cut where it or a law has a joint.

use pforms_kernel::{Error, Form, Result};

use super::poly::Poly;
use super::vector::Vector;
use crate::measuring::vector::{norm, plus};
use crate::{Spline, stretch, tangent_form};

/// A part of the path: one polynomial or rational curve.
#[derive(Clone, Debug)]
pub(super) struct Part {
    /// Where it begins, as a parameter of the path.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// The homogeneous coordinates: x, y, z and the weight.
    pub path: [Poly; 4],
    /// A direction of the tangent, of any length, without zeros at the ends.
    pub direction: Vector,
    /// A direction of the binormal likewise; 0 where the path is straight.
    pub bend: Vector,
}

/// A direction that turns by less is straight.
const STRAIGHT: f64 = 1e-12;

/// Coefficients below this share of the largest are taken for zeros at an end.
const NOISE: f64 = 64.0 * f64::EPSILON;

/// How often a path is halved to see that its weight stays away from 0.
const DEPTH: usize = 40;

/// Degrees beyond this would make polynomials whose binomials overflow.
const HIGHEST: usize = 64;

impl Part {
    fn new(curve: &Form, from: f64, to: f64) -> Result<Self> {
        let direction = components(&tangent_form(&centred(curve)?, 0)?);
        let [x, y, z, _] = direction;
        let path = components(curve);
        require_near(&path[3], from, to, DEPTH)?;
        let direction = Vector([x, y, z]);
        if direction.most() == 0.0 {
            let received = format!("no movement from {from} to {to}");
            return Err(Error::degenerate("path", received, "a curve with a tangent"));
        }
        let direction = tidy(&direction);
        let bend = direction.cross(&direction.derivative());
        let bend = if bend.most() > STRAIGHT { tidy(&bend) } else { Vector::constant([0.0; 3]) };
        Ok(Self { from, to, path, direction, bend })
    }

    /// The two halves.
    pub(super) fn halves(&self) -> (Self, Self) {
        let middle = 0.5 * self.from + 0.5 * self.to;
        let [x, y, z, w] = self.path.each_ref().map(Poly::halves);
        let (d, e) = self.direction.halves();
        let (b, c) = self.bend.halves();
        let part = |from, to, path, direction: &Vector, bend: &Vector| Self {
            from,
            to,
            path,
            direction: tidy(direction),
            bend: tidy(bend),
        };
        let left = part(self.from, middle, [x.0, y.0, z.0, w.0], &d, &b);
        let right = part(middle, self.to, [x.1, y.1, z.1, w.1], &e, &c);
        (left, right)
    }

    /// Does the path run straight over all of it?
    pub(super) fn is_straight(&self) -> bool {
        self.bend.most() == 0.0
    }

    /// Can it be cut once more, so that the middle is a parameter of its own?
    pub(super) fn is_divisible(&self) -> bool {
        let middle = 0.5 * self.from + 0.5 * self.to;
        let length = self.to - self.from;
        self.from < middle
            && middle < self.to
            && length > 64.0 * f64::EPSILON * self.from.abs().max(self.to.abs())
    }

    /// The euclidean point at a local parameter.
    pub(super) fn point(&self, t: f64) -> [f64; 3] {
        let [x, y, z, w] = self.path.each_ref().map(|x| x.at(t));
        [x / w, y / w, z / w]
    }

    /// Length of the derivative by the local parameter.
    pub(super) fn speed(&self, t: f64) -> f64 {
        let [x, y, z, w] = self.path.each_ref().map(|p| (p.at(t), p.derivative().at(t)));
        let slope = |p: (f64, f64)| (p.1 - p.0 / w.0 * w.1) / w.0;
        norm(&[slope(x), slope(y), slope(z)])
    }
}

/// A direction of length about 1, without zeros at its ends.
fn tidy(direction: &Vector) -> Vector {
    let direction = direction.without_end_zeros(NOISE);
    let size = direction.most();
    if size > 0.0 { direction.scaled(1.0 / size) } else { direction }
}

/// The coordinates of a curve in space, the weight last.
fn components(curve: &Form) -> [Poly; 4] {
    std::array::from_fn(|k| Poly(curve.homogeneous().iter().skip(k).step_by(4).copied().collect()))
}

/// The curve moved and scaled to about 1, so that products neither overflow nor lose the small
/// differences of a far-away curve.
fn centred(curve: &Form) -> Result<Form> {
    let mut poles = curve.homogeneous().to_vec();
    let heaviest = poles.chunks_exact(4).map(|pole| pole[3].abs()).fold(0.0, f64::max);
    let Some(first) = poles.chunks_exact(4).find(|pole| pole[3].abs() > 1e-3 * heaviest) else {
        return Err(Error::domain("path", "weights 0", "a curve of points"));
    };
    let origin = [first[0] / first[3], first[1] / first[3], first[2] / first[3]];
    for pole in poles.chunks_exact_mut(4) {
        pole[3] /= heaviest;
        for k in 0..3 {
            pole[k] = pole[k] / heaviest - origin[k] * pole[3];
        }
    }
    let size =
        poles.chunks_exact(4).flat_map(|pole| &pole[..3]).fold(0.0_f64, |m, x| m.max(x.abs()));
    if size > 0.0 {
        poles.chunks_exact_mut(4).flat_map(|pole| &mut pole[..3]).for_each(|x| *x /= size);
    }
    Form::from_homogeneous(curve.orders(), 3, poles)
}

/// Complains unless the weight keeps its sign, which is decided by its coefficients.
fn require_near(weight: &Poly, from: f64, to: f64, depth: usize) -> Result<()> {
    let sign = weight.first().signum();
    if weight.scaled(sign).least() > 0.0 {
        return Ok(());
    }
    if depth == 0 || weight.first() == 0.0 || sign * weight.last() <= 0.0 {
        let received = format!("a weight that vanishes between {from} and {to}");
        return Err(Error::domain("path", received, "a path that stays near"));
    }
    let (left, right) = weight.halves();
    let middle = 0.5 * from + 0.5 * to;
    require_near(&left, from, middle, depth - 1)?;
    require_near(&right, middle, to, depth - 1)
}

/// The path in parts, cut at its joints and at these shares of its window.
pub(super) fn parts(path: &Spline, cuts: &[f64]) -> Result<Vec<Part>> {
    let (from, to) = path.window(0)?;
    let breaks = path.breaks().swap_remove(0);
    let mut parts = Vec::new();
    for (piece, ends) in path.pieces()?.iter().zip(breaks.windows(2)) {
        let (start, end) = (ends[0], ends[1]);
        let inside = cuts.iter().map(|share| from + share * (to - from));
        let mut own: Vec<f64> = inside.filter(|t| start < *t && *t < end).collect();
        own.insert(0, start);
        own.push(end);
        own.dedup();
        for pair in own.windows(2) {
            let local = |t: f64| (t - start) / (end - start);
            let curve = if own.len() == 2 {
                piece.clone()
            } else {
                stretch(piece, &[local(pair[0])], &[local(pair[1])])?
            };
            parts.push(Part::new(&curve, pair[0], pair[1])?);
        }
    }
    require_joined(&parts)?;
    Ok(parts)
}

/// Gaps below this share of the path's extent are closed.
const GAP: f64 = 1e-9;

fn require_joined(parts: &[Part]) -> Result<()> {
    let Some(first) = parts.first() else { return Ok(()) };
    let start = first.point(0.0);
    let ends = parts.iter().flat_map(|part| [part.point(0.5), part.point(1.0)]);
    let extent = ends.map(|end| norm(&plus(&end, -1.0, &start))).fold(0.0, f64::max);
    for pair in parts.windows(2) {
        let gap = gap(&pair[0], &pair[1]);
        if gap > GAP * extent {
            let received = format!("a gap of {gap:e} of its size at {}", pair[1].from);
            return Err(Error::degenerate("path", received, "a curve in one piece"));
        }
    }
    Ok(())
}

/// The way from the end of a part to the beginning of another.
pub(super) fn gap(before: &Part, after: &Part) -> f64 {
    norm(&plus(&after.point(0.0), -1.0, &before.point(1.0)))
}

/// The path as a spline in space, when it is a curve that stays away from infinity.
pub(super) fn in_space(path: &Spline) -> Result<Spline> {
    let net = path.net();
    if net.axes() != 1 || !(2..=3).contains(&net.ambient()) {
        return Err(Error::shape(
            "path",
            format!("a {} in {}D", net.kind(), net.ambient()),
            "a curve in 2D or 3D",
        ));
    }
    let degree = path.degrees()[0];
    if degree > HIGHEST {
        return Err(Error::accuracy(
            "path",
            format!("degree {degree}"),
            format!("at most {HIGHEST}"),
        ));
    }
    if net.ambient() == 3 {
        return Ok(path.clone());
    }
    let poles = net.homogeneous().chunks_exact(3).flat_map(|p| [p[0], p[1], 0.0, p[2]]).collect();
    let net = Form::from_homogeneous(net.orders(), 3, poles)?;
    Spline::on(net, path.knots().to_vec())
}
