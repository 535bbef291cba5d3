//! A surface cut into cells, sampled at their nodes, and laid out from a line.

use pforms_kernel::{Error, Form, Result};

use super::distortion::Distortion;
use super::line::{Pose, Spot, laid_out};
use super::quadrature::{ORDER, Quadrature};
use crate::making::parallel::{Interval, joined};
use crate::measuring::about_one::{seen_locally, shifted, with_weights_about_one};
use crate::measuring::vector::{cross, norm};
use crate::{Nodes, Spline, derivative, interpolate, stretch, surface_frame};

/// The cells of a surface, and what it is like at their nodes.
pub(super) struct Chart {
    pieces: Vec<Vec<Form>>,
    breaks: Vec<Vec<f64>>,
    lists: [Vec<Interval>; 2],
    /// For each cell in C order, its spots in C order.
    spots: Vec<Vec<Spot>>,
    quadrature: Quadrature,
}

/// The line that is laid out first: along `axis`, at a node of an interval of the other one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Base {
    axis: usize,
    interval: usize,
    node: usize,
}

/// Intervals along an axis: enough for anything smooth.
const MOST: usize = 64;

impl Chart {
    pub(super) fn new(surface: &Spline, unit: i32) -> Result<Self> {
        let counts = surface.counts();
        let mut pieces = Vec::new();
        for i in 0..counts[0] {
            let row = (0..counts[1]).map(|j| in_space(&surface.piece(&[i, j])?, unit));
            pieces.push(row.collect::<Result<Vec<_>>>()?);
        }
        let whole = |count: usize| (0..count).map(Interval::whole).collect::<Vec<_>>();
        let mut chart = Self {
            pieces,
            breaks: surface.breaks(),
            lists: [whole(counts[0]), whole(counts[1])],
            spots: Vec::new(),
            quadrature: Quadrature::new()?,
        };
        chart.sample()?;
        Ok(chart)
    }

    /// Lines to begin from: along each axis, in the middle and at both sides of the other.
    pub(super) fn bases(&self) -> Vec<Base> {
        let mut bases = Vec::new();
        for axis in 0..2 {
            let last = self.lists[1 - axis].len() - 1;
            let middle =
                if last.is_multiple_of(2) { (last / 2, ORDER / 2) } else { (last / 2 + 1, 0) };
            for (interval, node) in [(0, 0), middle, (last, ORDER - 1)] {
                bases.push(Base { axis, interval, node });
            }
        }
        bases
    }

    fn sample(&mut self) -> Result<()> {
        self.spots = Vec::new();
        for one in &self.lists[0] {
            for other in &self.lists[1] {
                let cell = self.cell(one, other)?;
                self.spots.push(spots(&cell, &self.quadrature.nodes)?);
            }
        }
        Ok(())
    }

    /// The part of the surface over two intervals.
    fn cell(&self, one: &Interval, other: &Interval) -> Result<Form> {
        stretch(
            &self.pieces[one.piece][other.piece],
            &[one.low, other.low],
            &[one.high, other.high],
        )
    }

    fn spot(&self, cell: [usize; 2], node: [usize; 2]) -> &Spot {
        &self.spots[cell[0] * self.lists[1].len() + cell[1]][node[0] * ORDER + node[1]]
    }

    /// Halves the marked intervals of each axis.
    ///
    /// Errors: `Accuracy` when there are too many.
    pub(super) fn halve(&mut self, marked: &[Vec<bool>; 2]) -> Result<()> {
        for (list, marked) in self.lists.iter_mut().zip(marked) {
            let pairs = list.iter().zip(marked);
            *list =
                pairs.flat_map(|(one, cut)| if *cut { one.halves() } else { vec![*one] }).collect();
            if list.len() > MOST {
                let received = format!("one that takes more than {MOST} pieces along an axis");
                return Err(Error::accuracy("accuracy", received, "a larger number"));
            }
        }
        self.sample()
    }

    /// The points of the plane that belong to the nodes of all cells.
    pub(super) fn laid_out(&self, base: Base) -> Result<Flat> {
        let counts = [self.lists[0].len(), self.lists[1].len()];
        let mut flat =
            Flat { counts, points: vec![vec![[0.0; 2]; ORDER * ORDER]; counts[0] * counts[1]] };
        let across = 1 - base.axis;
        for (index, poses) in self.base_line(base)?.iter().enumerate() {
            for (node, pose) in poses.iter().enumerate() {
                let cell = |other: usize| ordered(base.axis, index, other);
                let at = |other: usize| ordered(base.axis, node, other);
                let turned = self.spot(cell(base.interval), at(base.node)).angle(base.axis);
                let start = Pose { angle: pose.angle + turned, ..*pose };
                let line = |other: usize| -> Vec<&Spot> {
                    (0..ORDER).map(|k| self.spot(cell(other), at(k))).collect()
                };
                let mut put = |other: usize, poses: &[Pose]| {
                    for (k, pose) in poses.iter().enumerate() {
                        flat.put(cell(other), at(k), pose.point);
                    }
                };
                let first =
                    laid_out(&line(base.interval), across, start, base.node, &self.quadrature);
                put(base.interval, &first);
                let mut end = first[ORDER - 1];
                for other in base.interval + 1..counts[across] {
                    let (old, new) = (line(other - 1), line(other));
                    end.angle += crease(old[ORDER - 1], new[0], across);
                    let poses = laid_out(&new, across, end, 0, &self.quadrature);
                    put(other, &poses);
                    end = poses[ORDER - 1];
                }
                let mut end = first[0];
                for other in (0..base.interval).rev() {
                    let (old, new) = (line(other + 1), line(other));
                    end.angle += crease(old[0], new[ORDER - 1], across);
                    let poses = laid_out(&new, across, end, ORDER - 1, &self.quadrature);
                    put(other, &poses);
                    end = poses[0];
                }
            }
        }
        Ok(flat)
    }

    /// The line to begin from, interval by interval.
    fn base_line(&self, base: Base) -> Result<Vec<Vec<Pose>>> {
        let mut all: Vec<Vec<Pose>> = Vec::new();
        let mut pose = Pose { point: [0.0; 2], angle: if base.axis == 0 { 0.0 } else { QUARTER } };
        for index in 0..self.lists[base.axis].len() {
            let cell = |index: usize| ordered(base.axis, index, base.interval);
            let line = |index: usize| -> Vec<&Spot> {
                let node = |k: usize| ordered(base.axis, k, base.node);
                (0..ORDER).map(|k| self.spot(cell(index), node(k))).collect()
            };
            let spots = line(index);
            if spots.iter().all(|spot| norm(&spot.first[base.axis]) == 0.0) {
                return Err(Error::degenerate(
                    "form",
                    "a surface that is collapsed along the line to begin from",
                    "a surface with lines to unroll",
                ));
            }
            if index > 0 {
                pose.angle += crease(line(index - 1)[ORDER - 1], spots[0], base.axis);
            }
            let poses = laid_out(&spots, base.axis, pose, 0, &self.quadrature);
            pose = poses[ORDER - 1];
            all.push(poses);
        }
        Ok(all)
    }

    /// Parameters where the intervals of an axis begin and end.
    fn ends(&self, axis: usize) -> Vec<f64> {
        let breaks = &self.breaks[axis];
        let starts = self.lists[axis]
            .iter()
            .map(|one| breaks[one.piece] + (breaks[one.piece + 1] - breaks[one.piece]) * one.low);
        starts.chain(breaks.last().copied()).collect()
    }
}

const QUARTER: f64 = std::f64::consts::FRAC_PI_2;

/// The turn of a line along `axis` where a new piece begins: the other line there stays one.
fn crease(before: &Spot, after: &Spot, axis: usize) -> f64 {
    before.angle(axis) - after.angle(axis)
}

/// A pair of which the first belongs to `axis`.
fn ordered(axis: usize, own: usize, other: usize) -> [usize; 2] {
    if axis == 0 { [own, other] } else { [other, own] }
}

/// The points of the plane at the nodes of all cells.
pub(super) struct Flat {
    counts: [usize; 2],
    points: Vec<Vec<[f64; 2]>>,
}

impl Flat {
    fn put(&mut self, cell: [usize; 2], node: [usize; 2], point: [f64; 2]) {
        self.points[cell[0] * self.counts[1] + cell[1]][node[0] * ORDER + node[1]] = point;
    }

    /// The polynomial through the nodes of every cell.
    pub(super) fn forms(&self) -> Result<Vec<Form>> {
        let form = |points: &Vec<[f64; 2]>| {
            let net = Form::from_points(&[ORDER, ORDER], 2, points.as_flattened(), None)?;
            interpolate(&net, &Nodes::Lobatto)
        };
        self.points.iter().map(form).collect()
    }

    /// Along each axis, which intervals are too long for the polynomials in them.
    pub(super) fn unresolved(&self, accuracy: f64) -> Result<[Vec<bool>; 2]> {
        let mut marked = self.counts.map(|count| vec![false; count]);
        for (index, form) in self.forms()?.iter().enumerate() {
            let cell = [index / self.counts[1], index % self.counts[1]];
            for axis in 0..2 {
                // Three poles to spare: the derivatives are good as well.
                if !fits(form, axis, ORDER - 3, accuracy)? {
                    marked[axis][cell[axis]] = true;
                }
            }
        }
        Ok(marked)
    }

    /// The polynomial of every cell with as few poles as the accuracy allows, in places and slopes.
    pub(super) fn lowered(&self, accuracy: f64) -> Result<Vec<Form>> {
        let mut forms = self.forms()?;
        for axis in 0..2 {
            for order in 2..ORDER {
                let low: Vec<Form> =
                    forms.iter().map(|form| lowered(form, axis, order)).collect::<Result<_>>()?;
                let mut all = true;
                for (form, low) in forms.iter().zip(&low) {
                    all &= fits(form, axis, order, accuracy)? && slopes_fit(form, low, accuracy)?;
                }
                if all {
                    forms = low;
                    break;
                }
            }
        }
        Ok(forms)
    }

    /// The largest distortion of these forms, one for each cell, at a grid of points in it.
    pub(super) fn distortion(&self, chart: &Chart, forms: &[Form]) -> Result<Distortion> {
        let places: Vec<f64> = (0..PROBES).map(|i| i as f64 / (PROBES - 1) as f64).collect();
        let mut distortion = Distortion::default();
        for (index, form) in forms.iter().enumerate() {
            let (i, j) = (index / self.counts[1], index % self.counts[1]);
            let cell = chart.cell(&chart.lists[0][i], &chart.lists[1][j])?;
            let probes = spots_at(&cell, &places, false)?;
            let u = derivative(form, &[1, 0])?.grid(&[&places, &places])?;
            let v = derivative(form, &[0, 1])?.grid(&[&places, &places])?;
            let pairs = u.chunks_exact(2).zip(v.chunks_exact(2));
            for (spot, (u, v)) in probes.iter().zip(pairs) {
                distortion.at(&spot.first, &[[u[0], u[1]], [v[0], v[1]]]);
            }
        }
        Ok(distortion)
    }
}

/// All cells in one spline, the middle of the net moved nowhere: the line begun from starts in the
/// origin.
pub(super) fn in_one(forms: &[Form], chart: &Chart, unit: i32) -> Result<Spline> {
    let scaled = |form: &Form| {
        let points: Vec<f64> = form.points()?.iter().map(|x| shifted(*x, unit)).collect();
        Form::from_points(form.orders(), 2, &points, None)
    };
    let forms = forms.iter().map(scaled).collect::<Result<Vec<_>>>()?;
    Ok(joined(&forms, &[chart.ends(0), chart.ends(1)])?.0)
}

/// Points along each axis of a cell at which distortion is measured.
const PROBES: usize = 11;

/// Would fewer poles along an axis do? Compared at points: poles of so many would differ by rounding.
fn fits(form: &Form, axis: usize, order: usize, accuracy: f64) -> Result<bool> {
    let low = lowered(form, axis, order)?;
    let fine =
        |k: usize| Nodes::<f64>::Lobatto.on_axis(k, if k == axis { 3 * ORDER } else { ORDER });
    let (u, v) = (fine(0)?, fine(1)?);
    let (one, other) = (low.grid(&[&u, &v])?, form.grid(&[&u, &v])?);
    Ok(one.iter().zip(&other).all(|(x, y)| (x - y).abs() <= accuracy))
}

/// Do the derivatives differ by no more than the accuracy, as a share of the largest of them?
fn slopes_fit(form: &Form, low: &Form, accuracy: f64) -> Result<bool> {
    let fine = Nodes::<f64>::Lobatto.on_axis(0, 2 * ORDER)?;
    for orders in [[1, 0], [0, 1]] {
        let [here, there] = [form, low]
            .map(|form| derivative(form, &orders).and_then(|slope| slope.grid(&[&fine, &fine])));
        let (here, there) = (here?, there?);
        let size = here.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if here.iter().zip(&there).any(|(x, y)| (x - y).abs() > accuracy * size) {
            return Ok(false);
        }
    }
    Ok(true)
}

/// The polynomial of a lower order that meets the form at Lobatto's nodes.
fn lowered(form: &Form, axis: usize, order: usize) -> Result<Form> {
    let mut orders = form.orders().to_vec();
    orders[axis] = order;
    let nodes = |axis: usize| Nodes::<f64>::Lobatto.on_axis(axis, orders[axis]);
    let (u, v) = (nodes(0)?, nodes(1)?);
    let net = Form::from_points(&orders, 2, &form.grid(&[&u, &v])?, None)?;
    interpolate(&net, &Nodes::Lobatto)
}

/// A piece near the origin, of size about 1, in space.
fn in_space(piece: &Form, unit: i32) -> Result<Form> {
    let local = seen_locally(&with_weights_about_one(piece)?, unit)?.map_scalar(|x| x.value)?;
    if local.ambient() == 3 {
        return Ok(local);
    }
    let poles = local.homogeneous().chunks_exact(3).flat_map(|p| [p[0], p[1], 0.0, p[2]]);
    Form::from_homogeneous(local.orders(), 3, poles.collect())
}

fn spots(cell: &Form, nodes: &[f64]) -> Result<Vec<Spot>> {
    spots_at(cell, nodes, true)
}

/// The surface at a square grid of parameters; the normals only if they are wanted.
fn spots_at(cell: &Form, nodes: &[f64], with_normals: bool) -> Result<Vec<Spot>> {
    // Homogeneous coordinates, as a polynomial in dimension 4.
    let lifted = Form::from_points(cell.orders(), 4, cell.homogeneous(), None)?;
    let values = |orders: [usize; 2]| derivative(&lifted, &orders)?.grid(&[nodes, nodes]);
    let all = [[0, 0], [1, 0], [0, 1], [2, 0], [0, 2]].map(values);
    let [point, u, v, uu, vv] = all;
    let (point, u, v, uu, vv) = (point?, u?, v?, uu?, vv?);
    let at =
        |list: &[f64], i: usize| [list[4 * i], list[4 * i + 1], list[4 * i + 2], list[4 * i + 3]];
    let mut spots = Vec::with_capacity(nodes.len() * nodes.len());
    for i in 0..nodes.len() * nodes.len() {
        let (p, first) = euclidean(at(&point, i), [at(&u, i), at(&v, i)])?;
        let bent = |axis: usize, d: [f64; 4], dd: [f64; 4]| -> [f64; 3] {
            let w = point[4 * i + 3];
            [0, 1, 2].map(|k| (dd[k] - p[k] * dd[3] - 2.0 * first[axis][k] * d[3]) / w)
        };
        let second = [bent(0, at(&u, i), at(&uu, i)), bent(1, at(&v, i), at(&vv, i))];
        let place = [nodes[i / nodes.len()], nodes[i % nodes.len()]];
        let normal = if with_normals { normal(cell, &first, place)? } else { [0.0; 3] };
        spots.push(Spot { first, second, normal });
    }
    Ok(spots)
}

/// The point and its two derivatives, from homogeneous coordinates.
fn euclidean(point: [f64; 4], [u, v]: [[f64; 4]; 2]) -> Result<([f64; 3], [[f64; 3]; 2])> {
    let w = point[3];
    let p = [0, 1, 2].map(|k| point[k] / w);
    if p.iter().any(|x| !x.is_finite()) {
        return Err(Error::domain("form", "a weight that vanishes", "a form that is finite"));
    }
    let along = |d: [f64; 4]| [0, 1, 2].map(|k| (d[k] - p[k] * d[3]) / w);
    Ok((p, [along(u), along(v)]))
}

/// Share of `|f_u|·|f_v|` above which their product tells the normal.
const CLEAR: f64 = 1e-6;

fn normal(cell: &Form, [u, v]: &[[f64; 3]; 2], place: [f64; 2]) -> Result<[f64; 3]> {
    let product = cross(u, v);
    let area = norm(&product);
    if area > CLEAR * norm(u) * norm(v) {
        return Ok(product.map(|x| x / area));
    }
    match surface_frame(cell, place[0], place[1])?.normal.as_deref() {
        Some(&[x, y, z]) => Ok([x, y, z]),
        _ => Err(Error::degenerate("form", "a surface without a normal", "a surface with normals")),
    }
}
