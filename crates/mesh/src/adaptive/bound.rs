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

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::vectors::{Job, Simd, in_lanes};

use super::curvature::{Scratch, curvature, curvature_here, restrict_here};
use super::net::{Net, Quadruple};
use crate::vector::{Vec3, cross, dot, norm, subtract};

/// A triangle over a box of parameters that has become the unit square.
pub(crate) struct Facet {
    /// Parameters of the corners in the box.
    pub(crate) at: [[f64; 2]; 3],
    /// The corners.
    pub(crate) places: [Vec3; 3],
}

impl Facet {
    /// The step in the box along the edge from one corner to the next.
    #[inline(always)]
    fn step(&self, from: usize) -> [f64; 2] {
        let [a, b] = [self.at[from], self.at[(from + 1) % 3]];
        [b[0] - a[0], b[1] - a[1]]
    }
}

/// A distance between points at the same parameters, and the parts that the axes have in it.
pub(crate) struct Unseen {
    pub(crate) distance: f64,
    pub(crate) shares: [f64; 2],
}

/// How far a surface strays from a triangle that stands for a part of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Stray {
    /// Over its plane.
    pub(crate) height: f64,
    /// Over its edges, seen along its normal.
    pub(crate) over: f64,
}

impl Stray {
    /// By a distance of which nothing else is known.
    pub(crate) fn any_way(distance: f64) -> Self {
        Self { height: distance, over: distance }
    }

    /// The same after corners of the triangle were moved.
    pub(crate) fn moved(self, distance: f64) -> Self {
        Self { height: self.height + distance, over: self.over + distance }
    }

    /// The distance from the triangle.
    pub(crate) fn reach(self) -> f64 {
        self.height.hypot(self.over)
    }
}

/// The surface seen along the normal of a triangle, lengths multiplied by that of a direction.
#[derive(Default)]
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

/// Looks along the normal of a triangle: the least weight, and whether that was enough.
struct Look<'a> {
    seen: &'a mut Seen,
    strip: &'a Net,
    columns: [f64; 2],
    facet: &'a Facet,
    scratch: &'a mut Scratch,
}

impl Job for Look<'_> {
    type Output = (f64, bool);

    #[inline(always)]
    fn run<V: Simd>(self, _: V) -> (f64, bool) {
        let weights = restrict_here(self.strip, self.columns, self.scratch);
        let enough =
            weights[0] > 0.0 && self.seen.see(self.strip, self.facet, weights, self.scratch);
        (weights[0], enough)
    }
}

impl Seen {
    /// Bounds the distance between a triangle and any point of the surface over it.
    ///
    /// By the height over its plane, and by what reaches over one edge. A point over the edge
    /// `(i, j)` is `λₗ` away from it, and on the line through it from the third corner the edge
    /// reaches over by at most `½·λᵢλⱼ` times its second derivative.
    ///
    /// Where the parameters run so unevenly that a point may lie over two edges, another bound is
    /// returned instead; it is infinite while poles in the box have weights that are not positive.
    pub(crate) fn look(
        &mut self,
        strip: &Net,
        columns: [f64; 2],
        facet: &Facet,
        scratch: &mut Scratch,
    ) -> Option<Unseen> {
        let (least, single) = in_lanes(Look { seen: self, strip, columns, facet, scratch });
        if least <= 0.0 {
            return Some(Unseen { distance: f64::INFINITY, shares: [1.0; 2] });
        }
        (!single).then(|| at_same_parameters(strip, facet, least, scratch))
    }

    /// Does every point lie over one edge at most?
    #[inline(always)]
    fn see(
        &mut self,
        strip: &Net,
        facet: &Facet,
        weights: [f64; 2],
        scratch: &mut Scratch,
    ) -> bool {
        let places = facet.places;
        let [a, b, c] = places;
        let sides = [subtract(b, a), subtract(c, b), subtract(a, c)];
        let normal = cross(sides[0], sides[1]);
        let size = dot(normal, normal);
        if size <= 0.0 {
            return false;
        }
        let across = [cross(sides[0], normal), cross(sides[1], normal), cross(sides[2], normal)];
        let directions = [normal, across[0], across[1], across[2]];
        let bases = [a, a, b, c];
        let mut columns = [[0.0; 4]; 4];
        let mut lengths = [0.0; 4];
        for (k, (way, base)) in directions.iter().zip(&bases).enumerate() {
            for x in 0..3 {
                columns[x][k] = way[x];
            }
            columns[3][k] = -dot(*way, *base);
            lengths[k] = dot(*way, *way).sqrt();
        }
        let curvature = curvature_here(strip, &columns, scratch);
        let steps = [facet.step(0), facet.step(1), facet.step(2)];
        let edges =
            [curvature.along(steps[0]), curvature.along(steps[1]), curvature.along(steps[2])];
        let spread = curvature.spread_sum();
        let height = highest([edges[0][0], edges[1][0], edges[2][0]]) + spread[0] / 8.0;
        let (mut over, mut sliver) = ([0.0; 3], [0.0; 3]);
        for k in 0..3 {
            let (next, last) = (edges[(k + 1) % 3][k + 1], edges[(k + 2) % 3][k + 1]);
            let edge = edges[k][k + 1];
            let own = (-edge).max(0.0) + curvature.spread_along(steps[k])[k + 1];
            over[k] = own / (8.0 * weights[0] * lengths[k + 1]);
            let others = next.abs().max(last.abs()) + edge.abs() / 4.0;
            let inside = size * weights[0] - 0.5 * (others + spread[k + 1]);
            sliver[k] = if inside > 0.0 { own / (2.0 * inside) } else { f64::INFINITY };
        }
        let most = sliver[0] * sliver[1];
        if most.max(sliver[1] * sliver[2]).max(sliver[2] * sliver[0]) >= 1.0 {
            return false;
        }
        let mut shares = [curvature.largest(0), curvature.largest(2)];
        for (axis, share) in shares.iter_mut().enumerate() {
            share[0] /= lengths[0];
            for k in 0..3 {
                share[k + 1] *= steps[k][axis] * steps[k][axis] / lengths[k + 1];
            }
        }
        let height = height / (lengths[0] * weights[0]);
        *self =
            Self { places, normal, across, edges, spread, weights, height, over, sliver, shares };
        true
    }

    /// What either axis has in the distance beside an edge.
    pub(crate) fn shares(&self, edge: usize) -> [f64; 2] {
        self.shares.map(|share| (share[0] * share[0] + share[edge + 1] * share[edge + 1]).sqrt())
    }

    /// The distance from the triangle itself.
    pub(crate) fn alone(&self, edge: usize) -> f64 {
        (self.height * self.height + self.over[edge] * self.over[edge]).sqrt()
    }

    /// Over the plane and over any edge.
    pub(crate) fn stray(&self) -> Stray {
        Stray { height: self.height, over: self.over.into_iter().fold(0.0, f64::max) }
    }

    /// Does what reaches over an edge count beside the height?
    pub(crate) fn reaches_over(&self, edge: usize) -> bool {
        self.over[edge] > 0.3 * self.height
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
fn at_same_parameters(strip: &Net, facet: &Facet, least: f64, scratch: &mut Scratch) -> Unseen {
    let places = facet.places;
    let [x, y, z] = places[0];
    let columns =
        [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [-x, -y, -z, 1.0]];
    let curvature = curvature(strip, &columns, scratch);
    let reach = [1, 2].map(|k| norm(subtract(places[k], places[0])));
    let length = |d: Quadruple| norm([d[0], d[1], d[2]]) + d[3].abs() * reach[0].max(reach[1]);
    let edges = [0, 1, 2].map(|k| length(curvature.along(facet.step(k))));
    let [uu, uv, vv] = curvature.spread.map(length);
    let distance = (highest(edges) + (uu + 2.0 * uv + vv) / 8.0) / least;
    Unseen { distance, shares: [0, 2].map(|kind| length(curvature.largest(kind))) }
}

/// The maximum of `½·|λ₀λ₁·a + λ₁λ₂·b + λ₂λ₀·c|` over the triangle.
#[inline(always)]
fn highest([a, b, c]: [f64; 3]) -> f64 {
    let mut highest = a.abs().max(b.abs()).max(c.abs()) / 8.0;
    // Inside, the gradient vanishes at barycentric coordinates with these ratios.
    let inner = [b * (a + c - b), c * (a + b - c), a * (b + c - a)];
    let sum = inner[0] + inner[1] + inner[2];
    if inner[0] * sum > 0.0 && inner[1] * sum > 0.0 && inner[2] * sum > 0.0 {
        highest = highest.max((a * b * c / (2.0 * sum)).abs());
    }
    highest
}

/// The same for a triangle over the whole box, one of whose sides `u = const` is its first corner.
pub(crate) fn fan_distance(
    strip: &Net,
    places: [Vec3; 3],
    weights: [f64; 2],
    scratch: &mut Scratch,
) -> f64 {
    let [a, b, c] = places;
    let normal = cross(subtract(b, a), subtract(c, a));
    let size = norm(normal);
    if weights[0] <= 0.0 {
        return f64::INFINITY;
    }
    if size <= 0.0 {
        // A triangle that is a line or a point: the surface lies in the hull of its poles.
        let poles = scratch.cell().iter().map(crate::space::project);
        return poles.map(|pole| from_sides(pole, &places)).fold(0.0, f64::max);
    }
    let functions = [normal[0], normal[1], normal[2], -dot(normal, a)];
    let curvature = curvature(strip, &functions.map(|x| [x, 0.0, 0.0, 0.0]), scratch);
    let [uu, vv] = [0, 2].map(|kind| curvature.largest(kind)[0]);
    let cell = scratch.cell();
    let corners = [0, strip.columns - 1, cell.len() - strip.columns, cell.len() - 1];
    let off = corners.map(|k| (0..4).map(|x| cell[k][x] * functions[x]).sum::<f64>().abs());
    let height = (off.into_iter().fold(0.0, f64::max) + (uu + vv) / 8.0) / (size * weights[0]);
    let over = cell.iter().map(|pole| beyond(crate::space::project(pole), &places, normal));
    height.hypot(over.fold(0.0, f64::max))
}

/// How far a point is from the nearest side of a triangle.
fn from_sides(point: Vec3, places: &[Vec3; 3]) -> f64 {
    let from = |k: usize| {
        let (side, way) = (subtract(places[(k + 1) % 3], places[k]), subtract(point, places[k]));
        let square = dot(side, side);
        let along = if square > 0.0 { (dot(way, side) / square).clamp(0.0, 1.0) } else { 0.0 };
        norm(subtract(way, side.map(|x| along * x)))
    };
    from(0).min(from(1)).min(from(2))
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
        nearest = nearest.min((outside * outside + past * past).sqrt());
    }
    if inside { 0.0 } else { nearest }
}
