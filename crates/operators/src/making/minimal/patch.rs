//! A surface of poles that move, at the nodes of a quadrature.

use super::gauss::{Node, nodes};
use super::metric::Metric;
use super::system::Banded;
use crate::algebra::Spline;

/// The functions of a surface at all nodes, for any coordinates of its poles.
///
/// Poles are homogeneous with fixed weights; the coordinates, multiplied by them, are what moves.
pub(super) struct Patch {
    ambient: usize,
    orders: [usize; 2],
    lines: [Vec<Node>; 2],
    weights: Vec<f64>,
}

/// The surface at a node.
pub(super) struct Point<'a> {
    /// Weight of the node.
    pub weight: f64,
    /// Derivatives by u and by v.
    pub slopes: [Vec<f64>; 2],
    w: [f64; 3],
    v: &'a Node,
    /// Room for homogeneous points.
    room: [Vec<f64>; 3],
}

/// Lines of poles that the functions of u at one node reduce a surface to: its values, first and
/// second derivatives along u, homogeneous.
type Lines = [Vec<f64>; 3];

impl Patch {
    /// With `count` nodes for each piece and axis.
    pub(super) fn new(surface: &Spline, count: usize) -> Self {
        let net = surface.net();
        let [u, v] = [0, 1].map(|axis| nodes(&surface.knots()[axis], count));
        let orders = [net.orders()[0], net.orders()[1]];
        Self { ambient: net.ambient(), orders, lines: [u, v], weights: net.weights() }
    }

    /// Walks over all nodes: `visit` gets each point, the lines it lies on, and the sums of its row;
    /// after each row `gather` gets the sums.
    fn walk<T>(
        &self,
        coordinates: &[f64],
        mut start: impl FnMut() -> T,
        mut visit: impl FnMut(&Point<'_>, &Lines, &mut T),
        mut gather: impl FnMut(&Node, &T),
    ) {
        let (d, width) = (self.ambient, self.ambient + 1);
        let Some(first) = self.lines[1].first() else { return };
        let mut lines = [0, 1, 2].map(|_| vec![0.0; self.orders[1] * width]);
        let mut point = Point {
            weight: 0.0,
            slopes: [vec![0.0; d], vec![0.0; d]],
            w: [0.0; 3],
            v: first,
            room: [0, 1, 2].map(|_| vec![0.0; width]),
        };
        for u in &self.lines[0] {
            self.reduce(u, coordinates, &mut lines);
            let mut sums = start();
            for v in &self.lines[1] {
                point.move_to(u, v, &lines);
                visit(&point, &lines, &mut sums);
            }
            gather(u, &sums);
        }
    }

    fn reduce(&self, u: &Node, coordinates: &[f64], lines: &mut Lines) {
        let (d, columns) = (self.ambient, self.orders[1]);
        for (line, row) in lines.iter_mut().zip(&u.rows) {
            line.fill(0.0);
            for (i, factor) in u.poles().zip(row) {
                let from = i * columns;
                let poles = coordinates[from * d..(from + columns) * d].chunks_exact(d);
                let targets = line.chunks_exact_mut(d + 1);
                for ((target, pole), weight) in targets.zip(poles).zip(&self.weights[from..]) {
                    target.iter_mut().zip(pole).for_each(|(sum, x)| *sum += factor * x);
                    target[d] += factor * weight;
                }
            }
        }
    }

    /// The sum over all nodes of what a rule makes of the point there.
    pub(super) fn sum(&self, coordinates: &[f64], mut rule: impl FnMut(&Point<'_>) -> f64) -> f64 {
        let mut sum = 0.0;
        self.walk(coordinates, || (), |point, _, ()| sum += point.weight * rule(point), |_, ()| ());
        sum
    }

    /// The same for a rule that asks for second derivatives `uu`, `uv`, `vv`.
    pub(super) fn sum_of_bends(
        &self,
        coordinates: &[f64],
        mut rule: impl FnMut(&Point<'_>, &[Vec<f64>; 3]) -> f64,
    ) -> f64 {
        let mut sum = 0.0;
        let visit = |point: &Point<'_>, lines: &Lines, (): &mut ()| {
            sum += point.weight * rule(point, &point.bends(lines));
        };
        self.walk(coordinates, || (), visit, |_, ()| ());
        sum
    }

    /// The area.
    pub(super) fn area(&self, coordinates: &[f64]) -> f64 {
        self.sum(coordinates, |point| point.metric().area)
    }

    /// The slope, by the coordinates of all poles, of the energy of which `rule` gives the
    /// symmetric matrix `(uu, uv, vv)` at a point.
    pub(super) fn slope(&self, coordinates: &[f64], rule: impl Fn(Metric) -> [f64; 3]) -> Vec<f64> {
        let (d, columns) = (self.ambient, self.orders[1]);
        let mut slope = vec![0.0; coordinates.len()];
        let start = || [0, 1].map(|_| vec![0.0; columns * d]);
        let visit = |point: &Point<'_>, _: &Lines, sums: &mut [Vec<f64>; 2]| {
            let [uu, uv, vv] = rule(point.metric()).map(|x| x * point.weight / point.w[0]);
            let [by_u, by_v] = point.turns();
            for k in 0..d {
                let (u, v) = (point.slopes[0][k], point.slopes[1][k]);
                let (pull, across) = (uu * u + uv * v, uv * u + vv * v);
                let rest = by_u * pull + by_v * across;
                for (j, (value, slope)) in point.v.rows[0].iter().zip(&point.v.rows[1]).enumerate()
                {
                    let at = (point.v.first + j) * d + k;
                    sums[1][at] += value * pull;
                    sums[0][at] += slope * across - value * rest;
                }
            }
        };
        let gather = |u: &Node, sums: &[Vec<f64>; 2]| {
            for (i, (value, derivative)) in u.rows[0].iter().zip(&u.rows[1]).enumerate() {
                let line = &mut slope[(u.first + i) * columns * d..][..columns * d];
                for ((x, a), b) in line.iter_mut().zip(&sums[0]).zip(&sums[1]) {
                    *x += value * a + derivative * b;
                }
            }
        };
        self.walk(coordinates, start, visit, gather);
        slope
    }

    /// The matrix, between free poles, of that energy with what the rule says held fixed.
    pub(super) fn matrix(
        &self,
        coordinates: &[f64],
        free: &[usize],
        rule: impl Fn(Metric) -> [f64; 3],
    ) -> Banded<f64> {
        let columns = self.orders[1];
        let square = columns * columns;
        let mut table = Table::new(self, free);
        let start = || [0, 1, 2].map(|_| vec![0.0; square]);
        let mut own = Vec::new();
        let visit = |point: &Point<'_>, _: &Lines, sums: &mut [Vec<f64>; 3]| {
            let [uu, uv, vv] = rule(point.metric()).map(|x| x * point.weight);
            let [by_u, by_v] = point.turns();
            let (values, slopes) = (&point.v.rows[0], &point.v.rows[1]);
            own.clear();
            own.extend(values.iter().zip(slopes).map(|(value, slope)| {
                let a = value / point.w[0];
                [a, -by_u * a, slope / point.w[0] - by_v * a]
            }));
            for (j, [a, c, b]) in own.iter().enumerate() {
                let at = (point.v.first + j) * columns + point.v.first;
                for (l, [a2, c2, b2]) in own.iter().enumerate() {
                    let pull = uu * c2 + uv * b2;
                    sums[0][at + l] += uu * a * a2;
                    sums[1][at + l] += a * pull;
                    sums[2][at + l] += c * pull + b * (uv * c2 + vv * b2);
                }
            }
        };
        self.walk(coordinates, start, visit, |u, sums| table.add(u, sums));
        Banded::new(table.rows)
    }
}

impl<'a> Point<'a> {
    fn move_to(&mut self, u: &Node, v: &'a Node, lines: &Lines) {
        (self.weight, self.v) = (u.weight * v.weight, v);
        for (room, (r, s)) in self.room.iter_mut().zip([(0, 0), (1, 0), (0, 1)]) {
            v.mix(&lines[r], s, room);
        }
        let d = self.slopes[0].len();
        self.w = [0, 1, 2].map(|k| self.room[k][d]);
        let [at, rest @ ..] = &self.room;
        for (slope, line) in self.slopes.iter_mut().zip(rest) {
            let turn = line[d] / at[d];
            for ((slope, x), at) in slope.iter_mut().zip(line).zip(at) {
                *slope = (x - turn * at) / self.w[0];
            }
        }
    }

    pub(super) fn metric(&self) -> Metric {
        Metric::of(&self.slopes[0], &self.slopes[1])
    }

    /// The second derivatives `uu`, `uv`, `vv`.
    fn bends(&self, lines: &Lines) -> [Vec<f64>; 3] {
        let d = self.slopes[0].len();
        [(2, 0, 0, 0), (1, 1, 0, 1), (0, 2, 1, 1)].map(|(r, s, a, b)| {
            let mut h = vec![0.0; d + 1];
            self.v.mix(&lines[r], s, &mut h);
            let bend = |k: usize| {
                let at = self.room[0][k] / self.w[0];
                let mixed = self.w[1 + a] * self.slopes[b][k] + self.w[1 + b] * self.slopes[a][k];
                (h[k] - h[d] * at - mixed) / self.w[0]
            };
            (0..d).map(bend).collect()
        })
    }

    /// The slopes of the weight as a part of it.
    fn turns(&self) -> [f64; 2] {
        [self.w[1] / self.w[0], self.w[2] / self.w[0]]
    }
}

/// The matrix as it grows.
struct Table {
    columns: usize,
    /// For each pole its place among the free ones.
    known: Vec<Option<usize>>,
    /// Poles of one line of v that share a piece with another: `|j − l|` at most.
    near: usize,
    rows: Vec<Vec<f64>>,
}

impl Table {
    fn new(patch: &Patch, free: &[usize]) -> Self {
        let [count, columns] = patch.orders;
        let mut known = vec![None; count * columns];
        free.iter().enumerate().for_each(|(k, &index)| known[index] = Some(k));
        let near = patch.lines.each_ref().map(|line| line.first().map_or(0, |n| n.rows[0].len()));
        let reach = near[0].saturating_sub(1) * columns + near[1].saturating_sub(1);
        let length = |k: usize| free[k..].iter().take_while(|&&i| i - free[k] <= reach).count();
        let rows = (0..free.len()).map(|k| vec![0.0; length(k)]).collect();
        Self { columns, known, near: near[1].saturating_sub(1), rows }
    }

    /// Adds what the nodes of one line give: `sums` between the functions of v, by derivatives of
    /// those of u, both, one or none.
    fn add(&mut self, u: &Node, sums: &[Vec<f64>; 3]) {
        let columns = self.columns;
        for (i, (value, slope)) in u.rows[0].iter().zip(&u.rows[1]).enumerate() {
            for (k, (value2, slope2)) in u.rows[0].iter().zip(&u.rows[1]).enumerate().skip(i) {
                let factors = [slope * slope2, slope * value2, value * slope2, value * value2];
                for j in 0..columns {
                    let Some(row) = self.known[(u.first + i) * columns + j] else { continue };
                    let from = if i == k { j } else { j.saturating_sub(self.near) };
                    for l in from..columns.min(j + self.near + 1) {
                        let Some(column) = self.known[(u.first + k) * columns + l] else {
                            continue;
                        };
                        self.rows[row][column - row] += factors[0] * sums[0][j * columns + l]
                            + factors[1] * sums[1][j * columns + l]
                            + factors[2] * sums[1][l * columns + j]
                            + factors[3] * sums[2][j * columns + l];
                    }
                }
            }
        }
    }
}
