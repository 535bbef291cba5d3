//! How densely each part of a patch is to be sampled along either axis.

use super::net::{Net, Quadruple, bernstein};
use crate::vector::{Vec3, add, cross, dot, norm, scale, subtract, unit};

/// Cells of the lattice on which curvatures are taken, along each axis.
const LATTICE: usize = 4;

/// Nodes along each axis.
const NODES: usize = LATTICE + 1;

/// Equal intervals of a profile.
pub(crate) const CELLS: usize = 32;

/// Segments per unit of a parameter, even on each of the intervals.
pub(crate) type Profile = [f64; CELLS];

/// A surface is at least so dense that its speed changes by this share from sample to sample.
const SPEED_CHANGE: f64 = 0.7;

/// Share of the tolerance that an axis without curvature may claim.
const LEAST_SHARE: f64 = 0.05;

/// How densely a patch is sampled: the rows, the columns, and the borders `u = 0`, `u = 1`,
/// `v = 0`, `v = 1`, each along its own axis.
#[derive(Clone, Debug)]
pub(crate) struct Field {
    pub(crate) rows: Profile,
    pub(crate) columns: Profile,
    pub(crate) borders: [Profile; 4],
}

impl Field {
    /// Densities at which triangles stray by about `tolerance`, from the curvatures on a lattice.
    ///
    /// Cells of sides `h` and `k` stray by `(A·h² + 2B·hk + C·k²)/8`; the fewest have `A·h² = C·k²`.
    pub(crate) fn of(net: &Net, tolerance: f64) -> Self {
        let (mut across, mut along) = ([[0.0; NODES]; NODES], [[0.0; NODES]; NODES]);
        let mut rows = [const { Vec::new() }; 3];
        for i in 0..NODES {
            let lines = lines_at(net, i as f64 / LATTICE as f64, &mut rows);
            for j in 0..NODES {
                let v = j as f64 / LATTICE as f64;
                [across[i][j], along[j][i]] = densities(&lines, v, &mut rows, tolerance);
            }
        }
        let densest =
            |of: &[[f64; NODES]; NODES]| even(of.map(|list| list.into_iter().fold(0.0, f64::max)));
        let end = |of: &[[f64; NODES]; NODES], k: usize| even(of.map(|list| list[k]));
        Self {
            rows: densest(&across),
            columns: densest(&along),
            borders: [end(&along, 0), end(&along, LATTICE), end(&across, 0), end(&across, LATTICE)],
        }
    }

    /// The densities with the axes exchanged.
    pub(crate) fn transposed(&self) -> Self {
        let [a, b, c, d] = self.borders;
        Self { rows: self.columns, columns: self.rows, borders: [c, d, a, b] }
    }

    /// All profiles.
    pub(crate) fn profiles(&mut self) -> impl Iterator<Item = &mut Profile> {
        [&mut self.rows, &mut self.columns].into_iter().chain(&mut self.borders)
    }
}

/// Intervals with the means of values at nodes, linear between them.
fn even(nodes: [f64; NODES]) -> Profile {
    std::array::from_fn(|k| {
        let place = (k as f64 + 0.5) * LATTICE as f64 / CELLS as f64;
        let (i, t) = (place as usize, place.fract());
        (1.0 - t) * nodes[i] + t * nodes[i + 1]
    })
}

/// The integral of a profile: the number of segments it asks for.
pub(crate) fn total(profile: &Profile) -> f64 {
    profile.iter().sum::<f64>() / CELLS as f64
}

/// The integral of a profile from 0 to `t`.
pub(crate) fn integral(profile: &Profile, t: f64) -> f64 {
    let place = t * CELLS as f64;
    let whole = (place as usize).min(CELLS - 1);
    (profile[..whole].iter().sum::<f64>() + profile[whole] * (place - whole as f64)) / CELLS as f64
}

/// The parameters between which a profile has `count` equal shares of its integral over `[a, b]`;
/// the ends are left out.
pub(crate) fn spread(profile: &Profile, [a, b]: [f64; 2], count: usize, out: &mut Vec<f64>) {
    out.clear();
    let (low, high) = (integral(profile, a), integral(profile, b));
    if !(high > low && high.is_finite()) {
        out.extend((1..count).map(|k| a + (b - a) * k as f64 / count as f64));
        return;
    }
    let (mut cell, mut before) = (0, 0.0);
    for k in 1..count {
        let sum = (low + (high - low) * k as f64 / count as f64) * CELLS as f64;
        while cell + 1 < CELLS && before + profile[cell] <= sum {
            before += profile[cell];
            cell += 1;
        }
        let t = (cell as f64 + ((sum - before) / profile[cell]).min(1.0)) / CELLS as f64;
        out.push(t.clamp(a, b));
    }
}

/// The row at `u` and its first two derivatives across the rows.
fn lines_at(net: &Net, u: f64, rows: &mut [Vec<f64>; 3]) -> [Vec<Quadruple>; 3] {
    fill(net.rows - 1, u, rows);
    [0, 1, 2].map(|order| {
        let mut line = vec![[0.0; 4]; net.columns];
        for (factor, row) in rows[order].iter().zip(net.poles.chunks_exact(net.columns)) {
            for (sum, pole) in line.iter_mut().zip(row) {
                *sum = std::array::from_fn(|k| sum[k] + factor * pole[k]);
            }
        }
        line
    })
}

/// The two densities at a point of a row.
fn densities(
    lines: &[Vec<Quadruple>; 3],
    v: f64,
    rows: &mut [Vec<f64>; 3],
    tolerance: f64,
) -> [f64; 2] {
    fill(lines[0].len() - 1, v, rows);
    let sum = |u_order: usize, v_order: usize| -> Quadruple {
        let mut sum = [0.0; 4];
        for (factor, pole) in rows[v_order].iter().zip(&lines[u_order]) {
            sum = std::array::from_fn(|k| sum[k] + factor * pole[k]);
        }
        sum
    };
    let place = |value: Quadruple, less: Vec3| subtract([value[0], value[1], value[2]], less);
    let point = sum(0, 0);
    let w = point[3];
    let at = scale(1.0 / w, [point[0], point[1], point[2]]);
    let [hu, hv, huu, huv, hvv] = [sum(1, 0), sum(0, 1), sum(2, 0), sum(1, 1), sum(0, 2)];
    let du = scale(1.0 / w, place(hu, scale(hu[3], at)));
    let dv = scale(1.0 / w, place(hv, scale(hv[3], at)));
    let second = |value: Quadruple, first: Vec3| {
        scale(1.0 / w, place(value, add(first, scale(value[3], at))))
    };
    let duu = second(huu, scale(2.0 * hu[3], du));
    let duv = second(huv, add(scale(hu[3], dv), scale(hv[3], du)));
    let dvv = second(hvv, scale(2.0 * hv[3], dv));
    let twist = unit(cross(du, dv)).map_or(0.0, |normal| dot(duv, normal).abs());
    let least = 8.0 * LEAST_SHARE * tolerance;
    let (a, c) = (beside(duu, du).max(least), beside(dvv, dv).max(least));
    let factor = ((1.0 + twist / (a * c).sqrt()) / (4.0 * tolerance)).sqrt();
    let speed = |second: Vec3, first: Vec3| {
        let change = norm(second) / (SPEED_CHANGE * norm(first));
        if change > 0.0 { change.min(2.0 * LATTICE as f64) } else { 0.0 }
    };
    [(a.sqrt() * factor).max(speed(duu, du)), (c.sqrt() * factor).max(speed(dvv, dv))]
}

/// The part of a second derivative at right angles to the first.
fn beside(second: Vec3, first: Vec3) -> f64 {
    unit(first)
        .map_or_else(|| norm(second), |way| norm(subtract(second, scale(dot(second, way), way))))
}

/// The Bernstein polynomials at `t` and their first two derivatives.
fn fill(degree: usize, t: f64, rows: &mut [Vec<f64>; 3]) {
    for (order, row) in rows.iter_mut().enumerate() {
        if order > degree {
            row.clear();
            row.resize(degree + 1, 0.0);
            continue;
        }
        bernstein(degree - order, t, row);
        for step in 0..order {
            let factor = (degree - order + step + 1) as f64;
            let mut left = 0.0;
            for entry in row.iter_mut() {
                let here = factor * *entry;
                (left, *entry) = (here, left - here);
            }
            row.push(left);
        }
    }
}
