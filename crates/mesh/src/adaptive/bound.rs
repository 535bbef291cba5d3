//! How far a surface strays from a triangle between three of its points, proven.
//!
//! Along a direction `d`, the height of the surface `P/w` over the plane through `a` is `g/w` with
//! `g = d·(P − a·w)`, a polynomial. Where `g` vanishes at the corners of a triangle,
//! `g(p) = −½ Σ λₖ ∂²g[vₖ − p]` with second derivatives from between `p` and the corners. With the
//! second derivatives in `mean ± spread` on the box round the triangle, the mean gives
//! `−½ Σ λᵢλⱼ ∂²g[vᵢ − vⱼ]`, whose maximum is known, and the spread at most `⅛` of its sum (Filip,
//! Magedson and Markot, *Surface algorithms using bounds on derivatives*, 1986).
//!
//! Only two things count: the height over the plane of the triangle, and how far the surface
//! reaches over its edges in that plane. Points that move along an edge, because the parameter
//! does not run evenly, cost nothing.

use pforms_kernel::lanes::Job;

use super::net::{Net, Quadruple};
use crate::vector::{Vec3, cross, dot, norm, subtract};

/// Second derivatives of four functions on the unit box, as `mean ± spread`: `∂ᵤᵤ`, `∂ᵤᵥ`, `∂ᵥᵥ`.
struct Curvature {
    mean: [[f64; 4]; 3],
    spread: [[f64; 4]; 3],
}

/// A triangle over a box of parameters that has become the unit square.
pub(crate) struct Facet {
    /// Parameters of the corners in the box.
    pub(crate) at: [[f64; 2]; 3],
    /// The corners.
    pub(crate) places: [Vec3; 3],
}

/// What is known of the surface over a triangle.
#[allow(clippy::large_enum_variant, reason = "nearly all are of the large kind")]
pub(crate) enum Bound {
    /// No point of the surface is farther from the triangle; the parts that the axes have in it.
    Within(f64, [f64; 2]),
    /// Its height over the plane, and how far it reaches over the edges.
    Seen(Seen),
}

/// The surface seen along the normal of a triangle, lengths multiplied by that of a direction.
pub(crate) struct Seen {
    places: [Vec3; 3],
    normal: Vec3,
    across: [Vec3; 3],
    /// Second derivatives along the edges, of the height and of the distances over the edges.
    edges: [[f64; 4]; 3],
    spread: [f64; 4],
    weights: [f64; 2],
    /// Height over the plane, a length.
    height: f64,
    /// Distances over the edges, lengths.
    over: [f64; 3],
    /// What lies over an edge has a barycentric coordinate towards the inside of at most this
    /// times that of either end.
    sliver: [f64; 3],
    /// What the second derivatives along either axis have in the height and over each edge.
    shares: [[f64; 4]; 2],
}

/// The bound on a triangle, by the widest vectors of the machine.
pub(crate) struct Proof<'a> {
    /// The net between the row parameters of the box, and the box's column parameters.
    pub(crate) strip: &'a Net,
    pub(crate) columns: [f64; 2],
    pub(crate) facet: &'a Facet,
    pub(crate) cell: &'a mut Net,
    pub(crate) scratch: &'a mut Vec<Quadruple>,
}

impl Job for Proof<'_> {
    type Output = Bound;

    #[inline(always)]
    fn run<const N: usize>(self) -> Bound {
        self.strip.columns_between(self.columns, self.cell);
        bound(self.cell, self.facet, self.scratch)
    }
}

/// A bound on the distance between any point of the surface over the triangle and the triangle.
///
/// Infinite while poles in the box have weights that are not positive.
#[inline(always)]
fn bound(cell: &Net, facet: &Facet, scratch: &mut Vec<Quadruple>) -> Bound {
    let weights = cell.weights();
    if weights[0] <= 0.0 {
        return Bound::Within(f64::INFINITY, [1.0; 2]);
    }
    let seen = Seen::of(cell, facet, weights, scratch);
    match seen {
        Some(seen) => Bound::Seen(seen),
        None => at_same_parameters(cell, facet, weights[0], scratch),
    }
}

impl Seen {
    /// By the height over the plane, and by what reaches over one edge; nothing where the
    /// parameters run so unevenly that a point may lie over two edges.
    ///
    /// A point over the edge `(i, j)` is `λₗ` away from it, and on the line through it from the
    /// third corner the edge reaches over by at most `½·λᵢλⱼ` times its second derivative.
    #[inline(always)]
    fn of(
        cell: &Net,
        facet: &Facet,
        weights: [f64; 2],
        scratch: &mut Vec<Quadruple>,
    ) -> Option<Self> {
        let places = facet.places;
        let sides = [0, 1, 2].map(|k| subtract(places[(k + 1) % 3], places[k]));
        let normal = cross(sides[0], sides[1]);
        let size = dot(normal, normal);
        if size <= 0.0 {
            return None;
        }
        let across = sides.map(|side| cross(side, normal));
        let directions = [normal, across[0], across[1], across[2]];
        let bases = [places[0], places[0], places[1], places[2]];
        let columns: [[f64; 4]; 4] = std::array::from_fn(|row| {
            std::array::from_fn(|k| match row {
                3 => -dot(directions[k], bases[k]),
                x => directions[k][x],
            })
        });
        let curvature = Curvature::of(cell, &columns, scratch);
        let edges = [0, 1, 2].map(|k| curvature.along(&facet.at, k, (k + 1) % 3));
        let spread = curvature.spread_sum();
        let height =
            (highest(edges.map(|edge| edge[0])) + spread[0] / 8.0) / (size.sqrt() * weights[0]);
        let (mut over, mut sliver) = ([0.0; 3], [0.0; 3]);
        for k in 0..3 {
            let edge = [0, 1, 2].map(|edge: usize| edges[edge][k + 1]);
            let own = (-edge[k]).max(0.0) + curvature.spread_along(&facet.at, k)[k + 1];
            over[k] = own / (8.0 * weights[0] * dot(across[k], across[k]).sqrt());
            let others = edge[(k + 1) % 3].abs().max(edge[(k + 2) % 3].abs()) + edge[k].abs() / 4.0;
            let inside = size * weights[0] - 0.5 * (others + spread[k + 1]);
            sliver[k] = if inside > 0.0 { own / (2.0 * inside) } else { f64::INFINITY };
        }
        let single = (0..3).all(|k| sliver[k] * sliver[(k + 1) % 3] < 1.0);
        let lengths = directions.map(|direction| dot(direction, direction).sqrt());
        let shares = [0, 1].map(|axis: usize| {
            let second = curvature.largest(2 * axis);
            std::array::from_fn(|k| {
                let step = k
                    .checked_sub(1)
                    .map_or(1.0, |k| facet.at[(k + 1) % 3][axis] - facet.at[k][axis]);
                step * step * second[k] / lengths[k]
            })
        });
        single.then_some(Self {
            places,
            normal,
            across,
            edges,
            spread,
            weights,
            height,
            over,
            sliver,
            shares,
        })
    }

    /// What either axis has in the distance beside an edge.
    pub(crate) fn shares(&self, edge: usize) -> [f64; 2] {
        self.shares.map(|share| share[0].hypot(share[edge + 1]))
    }

    /// The distance from the triangle itself.
    pub(crate) fn alone(&self, edge: usize) -> f64 {
        (self.height * self.height + self.over[edge] * self.over[edge]).sqrt()
    }

    /// The distance when what reaches over `edge` comes to lie over the neighbour there, whose
    /// third corner is `apex`: the two planes differ by the sine of an angle.
    pub(crate) fn beside(&self, edge: usize, apex: Vec3) -> f64 {
        let alone = self.alone(edge);
        let [i, j, l] = [0, 1, 2].map(|k| self.places[(edge + k) % 3]);
        let normal = cross(subtract(i, j), subtract(apex, j));
        let turned = cross(normal, self.normal);
        let sizes = dot(normal, normal) * dot(self.normal, self.normal);
        let beside = self.height + (dot(turned, turned) / sizes).sqrt() * self.over[edge];
        let ahead = dot(normal, self.normal) > 0.0;
        if beside < alone && ahead && self.lands(edge, normal, [i, j, l, apex]) {
            beside
        } else {
            alone
        }
    }

    /// Does what reaches over an edge surely lie between the other two edges of the neighbour?
    fn lands(&self, edge: usize, normal: Vec3, [i, j, l, apex]: [Vec3; 4]) -> bool {
        let size = dot(normal, normal);
        let sliver = self.sliver[edge];
        let [least, most] = self.weights;
        let other = [cross(subtract(apex, i), normal), cross(subtract(j, apex), normal)];
        other.iter().zip([i, j]).all(|(direction, base)| {
            let (edges, spread) = self.towards(*direction, base);
            let [ij, jl, li] = [0, 1, 2].map(|k| edges[(edge + k) % 3].abs());
            let third = dot(*direction, subtract(l, base)).max(0.0) * most;
            let bulge = 0.5 * (ij + sliver * (jl + li)) + 0.625 * (1.0 + sliver) * spread;
            sliver * third + bulge <= size * least
        })
    }

    /// Second derivatives along the edges, and their spread, of the distance from `base` in
    /// another direction, a sum of those known.
    fn towards(&self, direction: Vec3, base: Vec3) -> ([f64; 3], f64) {
        let size = dot(self.normal, self.normal);
        let [a, b] = [self.across[0], self.across[1]];
        // `a × b` is along the normal; the duals of `a` and `b` lie in the plane.
        let volume = dot(cross(a, b), self.normal);
        let factors = [
            dot(direction, self.normal) / size,
            dot(direction, cross(b, self.normal)) / volume,
            dot(direction, cross(self.normal, a)) / volume,
        ];
        let directions = [self.normal, a, b];
        let bases = [self.places[0], self.places[0], self.places[1]];
        let offset: f64 =
            (0..3).map(|k| factors[k] * dot(directions[k], subtract(base, bases[k]))).sum();
        let rational = self.weights[0] != self.weights[1];
        // The three distances over the edges add up to `−size` times the weight.
        let weight = |of: [f64; 4]| if rational { (of[1] + of[2] + of[3]) / size } else { 0.0 };
        let edges = self
            .edges
            .map(|edge| (0..3).map(|k| factors[k] * edge[k]).sum::<f64>() + offset * weight(edge));
        let spread = (0..3).map(|k| factors[k].abs() * self.spread[k]).sum::<f64>()
            + (offset * weight(self.spread)).abs();
        (edges, spread)
    }
}

/// By the distance between points of the surface and of the triangle at the same parameters.
#[cold]
#[inline(never)]
fn at_same_parameters(
    cell: &Net,
    facet: &Facet,
    least: f64,
    scratch: &mut Vec<Quadruple>,
) -> Bound {
    let places = facet.places;
    let [x, y, z] = places[0];
    let columns =
        [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [-x, -y, -z, 1.0]];
    let curvature = Curvature::of(cell, &columns, scratch);
    let reach = [1, 2].map(|k| norm(subtract(places[k], places[0])));
    let length = |d: [f64; 4]| norm([d[0], d[1], d[2]]) + d[3].abs() * reach[0].max(reach[1]);
    let edges = [0, 1, 2].map(|k| length(curvature.along(&facet.at, k, (k + 1) % 3)));
    let [uu, uv, vv] = curvature.spread.map(length);
    let distance = (highest(edges) + (uu + 2.0 * uv + vv) / 8.0) / least;
    Bound::Within(distance, [0, 2].map(|kind| length(curvature.largest(kind))))
}

/// The maximum of `½·|λ₀λ₁·a + λ₁λ₂·b + λ₂λ₀·c|` over the triangle.
#[inline(always)]
fn highest([a, b, c]: [f64; 3]) -> f64 {
    let mut highest = a.abs().max(b.abs()).max(c.abs()) / 8.0;
    // Inside, the gradient vanishes at barycentric coordinates with these ratios.
    let inner = [b * (a + c - b), c * (a + b - c), a * (b + c - a)];
    let sum: f64 = inner.iter().sum();
    if inner.iter().all(|x| x * sum > 0.0) {
        highest = highest.max((a * b * c / (2.0 * sum)).abs());
    }
    highest
}

impl Curvature {
    /// Of the functions whose values at a pole are `pole · columns`.
    #[inline(always)]
    fn of(cell: &Net, columns: &[[f64; 4]; 4], values: &mut Vec<Quadruple>) -> Self {
        let (rows, width, poles) = (cell.rows, cell.columns, &cell.poles);
        let mut ranges = [Range::default(); 3];
        values.clear();
        values.extend(poles.iter().map(|pole| seen(pole, columns)));
        let second = |a: usize, b: usize, c: usize, d: usize| -> Quadruple {
            std::array::from_fn(|k| (values[a][k] - values[b][k]) - (values[c][k] - values[d][k]))
        };
        for i in 0..rows {
            for j in 0..width {
                let here = i * width + j;
                if i + 2 < rows {
                    let [next, last] = [here + width, here + 2 * width];
                    ranges[0].include(second(last, next, next, here));
                }
                if i + 1 < rows && j + 1 < width {
                    let below = here + width;
                    ranges[1].include(second(below + 1, below, here + 1, here));
                }
                if j + 2 < width {
                    ranges[2].include(second(here + 2, here + 1, here + 1, here));
                }
            }
        }
        let [n, m] = [rows as f64 - 1.0, width as f64 - 1.0];
        let factors = [n * (n - 1.0), n * m, m * (m - 1.0)];
        let part = |k: usize, of: fn(&Range, usize) -> f64| {
            std::array::from_fn(
                |l| if factors[k] > 0.0 { factors[k] * of(&ranges[k], l) } else { 0.0 },
            )
        };
        Self {
            mean: [0, 1, 2].map(|k| part(k, Range::mean)),
            spread: [0, 1, 2].map(|k| part(k, Range::spread)),
        }
    }

    /// The second derivative along the edge between two corners, by the means.
    #[inline(always)]
    fn along(&self, at: &[[f64; 2]; 3], from: usize, to: usize) -> [f64; 4] {
        let [u, v] = [at[to][0] - at[from][0], at[to][1] - at[from][1]];
        let [uu, uv, vv] = &self.mean;
        std::array::from_fn(|k| u * u * uu[k] + 2.0 * u * v * uv[k] + v * v * vv[k])
    }

    /// The largest second derivatives of one kind.
    #[inline(always)]
    fn largest(&self, kind: usize) -> [f64; 4] {
        std::array::from_fn(|k| self.mean[kind][k].abs() + self.spread[kind][k])
    }

    /// How far the second derivative along that edge may be off.
    #[inline(always)]
    fn spread_along(&self, at: &[[f64; 2]; 3], from: usize) -> [f64; 4] {
        let to = (from + 1) % 3;
        let [u, v] = [at[to][0] - at[from][0], at[to][1] - at[from][1]].map(f64::abs);
        let [uu, uv, vv] = &self.spread;
        std::array::from_fn(|k| u * u * uu[k] + 2.0 * u * v * uv[k] + v * v * vv[k])
    }

    #[inline(always)]
    fn spread_sum(&self) -> [f64; 4] {
        let [uu, uv, vv] = &self.spread;
        std::array::from_fn(|k| uu[k] + 2.0 * uv[k] + vv[k])
    }
}

#[inline(always)]
fn seen(pole: &Quadruple, columns: &[[f64; 4]; 4]) -> Quadruple {
    std::array::from_fn(|k| {
        (pole[0] * columns[0][k] + pole[1] * columns[1][k])
            + (pole[2] * columns[2][k] + pole[3] * columns[3][k])
    })
}

/// Least and greatest of some numbers, for four functions.
#[derive(Clone, Copy)]
struct Range {
    low: Quadruple,
    high: Quadruple,
}

impl Default for Range {
    fn default() -> Self {
        Self { low: [f64::INFINITY; 4], high: [f64::NEG_INFINITY; 4] }
    }
}

impl Range {
    #[inline(always)]
    fn include(&mut self, values: Quadruple) {
        for ((low, high), value) in self.low.iter_mut().zip(&mut self.high).zip(values) {
            *low = if value < *low { value } else { *low };
            *high = if value > *high { value } else { *high };
        }
    }

    #[inline(always)]
    fn mean(&self, k: usize) -> f64 {
        0.5 * (self.low[k] + self.high[k])
    }

    #[inline(always)]
    fn spread(&self, k: usize) -> f64 {
        0.5 * (self.high[k] - self.low[k])
    }
}

/// The same for a triangle over the whole box, one of whose sides `u = const` is its first corner.
pub(crate) fn fan_distance(cell: &Net, places: [Vec3; 3], scratch: &mut Vec<Quadruple>) -> f64 {
    let least = cell.weights()[0];
    let [a, b, c] = places;
    let normal = cross(subtract(b, a), subtract(c, a));
    let size = norm(normal);
    if !(least > 0.0 && size > 0.0) {
        return f64::INFINITY;
    }
    let offset = -dot(normal, a);
    let columns = [normal[0], normal[1], normal[2], offset].map(|x| [x, 0.0, 0.0, 0.0]);
    let curvature = Curvature::of(cell, &columns, scratch);
    let [uu, _, vv] = [0, 1, 2].map(|k| curvature.mean[k][0].abs() + curvature.spread[k][0]);
    let last = cell.poles.len() - 1;
    let corners = [0, cell.columns - 1, last + 1 - cell.columns, last];
    let off = corners.map(|k| seen(&cell.poles[k], &columns)[0].abs());
    let height = (off.into_iter().fold(0.0, f64::max) + (uu + vv) / 8.0) / (size * least);
    let over = cell.poles.iter().map(|pole| beyond(crate::space::project(pole), &places, normal));
    height.hypot(over.fold(0.0, f64::max))
}

/// How far a point lies beside a triangle, seen along its normal.
fn beyond(point: Vec3, places: &[Vec3; 3], normal: Vec3) -> f64 {
    let mut inside = true;
    let mut nearest = f64::INFINITY;
    for k in 0..3 {
        let side = subtract(places[(k + 1) % 3], places[k]);
        let way = subtract(point, places[k]);
        let across = cross(side, normal);
        let outside = dot(way, across) / norm(across);
        inside &= outside <= 0.0;
        let along = dot(way, side) / dot(side, side);
        let past = (along - along.clamp(0.0, 1.0)) * norm(side);
        nearest = nearest.min(outside.hypot(past));
    }
    if inside { 0.0 } else { nearest }
}
