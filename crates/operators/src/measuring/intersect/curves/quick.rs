//! All crossings of two plane curves, in floating arithmetic and on the stack, with proofs.
//!
//! Pairs of parts are clipped and halved until they are apart, or until no direction of one is a
//! direction of the other: then they meet once at most, and Newton's steps find where. Whatever
//! resists, tangents, ends that nearly lie on the other curve, shared arcs, is left over for exact
//! arithmetic.

use smallvec::SmallVec;

use super::clip::clip;
use super::part::{Part, apart, box_of};
use super::root::{Bounds, Root, root};

/// What was found.
#[derive(Default)]
pub(super) struct Found {
    /// Crossings, proved.
    pub roots: SmallVec<[Root; 16]>,
    /// Windows that may hold more: `from`, `to` of each.
    pub left: Vec<[[f64; 2]; 2]>,
}

/// A pair of parts.
#[derive(Clone, Copy)]
struct Pair<const D: usize, const N: usize> {
    a: Part<D, N>,
    b: Part<D, N>,
}

/// Pairs that are looked at before the rest is left over.
const MOST: usize = 1 << 11;

/// Windows left over before the search ends.
const LEFT: usize = 64;

/// A window below this is not halved again.
const FINEST: f64 = 1.0 / (1_u64 << 32) as f64;

/// Roots this near to a part belong to it.
const BESIDE: f64 = 1e-10;

/// Pairs in waiting, kept from one search to the next.
pub(super) struct Search<const D: usize, const N: usize> {
    pairs: Vec<Pair<D, N>>,
}

impl<const D: usize, const N: usize> Search<D, N> {
    pub(super) fn new() -> Self {
        Self { pairs: Vec::with_capacity(64) }
    }

    /// All crossings of curves with coordinates below 2, and all windows in which they may come nearer
    /// than `margin` without a crossing that is proved. With `eager` the first of these ends it.
    pub(super) fn run(
        &mut self,
        a: &[[f64; 3]],
        b: &[[f64; 3]],
        margin: f64,
        eager: bool,
    ) -> Found {
        let whole = Pair { a: Part::<D, N>::new(a), b: Part::<D, N>::new(b) };
        let bounds = [Bounds::new(&whole.a), Bounds::new(&whole.b)];
        let task = Task { a: whole.a, b: whole.b, bounds, margin };
        let mut found = Found::default();
        self.pairs.clear();
        self.pairs.push(whole);
        let mut seen = 0;
        while let Some(pair) = self.pairs.pop() {
            seen += 1;
            if seen > MOST || found.left.len() > LEFT || (eager && !found.left.is_empty()) {
                found.left.push(pair.window());
                found.left.extend(self.pairs.drain(..).map(|pair| pair.window()));
                break;
            }
            task.settle(pair, &mut self.pairs, &mut found);
        }
        found
    }
}

impl<const D: usize, const N: usize> Pair<D, N> {
    fn window(&self) -> [[f64; 2]; 2] {
        [[self.a.from, self.a.to], [self.b.from, self.b.to]]
    }
}

struct Task<const D: usize, const N: usize> {
    a: Part<D, N>,
    b: Part<D, N>,
    bounds: [Bounds; 2],
    margin: f64,
}

/// A part that keeps more than this share of itself is halved.
const SHARE: f64 = 0.7;

impl<const D: usize, const N: usize> Task<D, N> {
    /// Settles a pair, or puts its halves in waiting.
    #[allow(clippy::large_types_passed_by_value, reason = "it is cut in place")]
    fn settle(&self, pair: Pair<D, N>, waiting: &mut Vec<Pair<D, N>>, found: &mut Found) {
        let Pair { mut a, mut b } = pair;
        loop {
            let (p, noise_a) = a.points();
            let (q, noise_b) = b.points();
            let (own, other) = (&p[..a.order], &q[..b.order]);
            let margin = self.margin + noise_a + noise_b;
            if apart(&box_of(own), &box_of(other), margin) {
                return;
            }
            let Some(of_b) = clip(&b, other, own, margin) else { return };
            let Some(of_a) = clip(&a, own, other, margin) else { return };
            if self.is_single(&a, &b, own, other, [noise_a, noise_b]) {
                let shares = [0.5 * (of_a.0 + of_a.1), 0.5 * (of_b.0 + of_b.1)];
                if self.meet(&a, &b, shares, found) {
                    return;
                }
            }
            let (keep_a, keep_b) = (of_a.1 - of_a.0, of_b.1 - of_b.0);
            if a.length() < FINEST && b.length() < FINEST {
                found.left.push([[a.from, a.to], [b.from, b.to]]);
                return;
            }
            let (cut_a, cut_b) = (keep_a < SHARE, keep_b < SHARE);
            if cut_a {
                a = a.cut(of_a.0, of_a.1);
            }
            if cut_b {
                b = b.cut(of_b.0, of_b.1);
            }
            if !cut_a && !cut_b {
                halve(a, b, waiting);
                return;
            }
        }
    }

    /// Can the parts meet once at most, even if each were a little longer? So they do if no
    /// direction of one, a mean of the steps from pole to pole, is one of the other.
    fn is_single(
        &self,
        a: &Part<D, N>,
        b: &Part<D, N>,
        p: &[[f64; 2]],
        q: &[[f64; 2]],
        noise: [f64; 2],
    ) -> bool {
        let slack = |part: &Part<D, N>, bounds: &Bounds, noise: f64, points: &[[f64; 2]]| {
            let least = if D == 3 {
                (0..points.len()).fold(1.0_f64, |least, i| least.min(part.weight(i)))
            } else {
                1.0
            };
            8.0 * BESIDE * bounds.bend(least) * part.length() + 2.0 * noise
        };
        let of_a = slack(a, &self.bounds[0], noise[0], p);
        let of_b = slack(b, &self.bounds[1], noise[1], q);
        let step = |points: &[[f64; 2]], i: usize| {
            [points[i + 1][0] - points[i][0], points[i + 1][1] - points[i][1]]
        };
        let mut sign = 0.0;
        for i in 0..p.len() - 1 {
            let [x, y] = step(p, i);
            let size = x.abs() + y.abs();
            for j in 0..q.len() - 1 {
                let [u, v] = step(q, j);
                let cross = x * v - y * u;
                let doubt = of_a * (u.abs() + v.abs() + of_b) + of_b * size;
                if sign == 0.0 {
                    sign = cross.signum();
                }
                let clear = cross * sign > 2.0 * doubt;
                if !clear {
                    return false;
                }
            }
        }
        true
    }

    /// Looks for the one crossing of two parts; true if the pair is settled.
    fn meet(&self, a: &Part<D, N>, b: &Part<D, N>, shares: [f64; 2], found: &mut Found) -> bool {
        let place = |part: &Part<D, N>, share: f64| part.from + share * part.length();
        let start = [place(a, shares[0]), place(b, shares[1])];
        let reach = [2.0 * a.length(), 2.0 * b.length()];
        let Some(root) = root(&self.a, &self.b, &self.bounds, start, reach) else { return false };
        let beside = |part: &Part<D, N>, t: f64| t >= part.from - BESIDE && t <= part.to + BESIDE;
        if root.error > BESIDE || !beside(a, root.s) || !beside(b, root.t) {
            return false;
        }
        let inside = |t: f64| t > root.error && t < 1.0 - root.error;
        let snapped = match (inside(root.s), inside(root.t)) {
            (true, true) => Some(root),
            _ => self.at_ends(root),
        };
        match snapped {
            Some(root) => {
                let same = |other: &Root| {
                    let reach = root.error + other.error;
                    (root.s - other.s).abs() <= reach && (root.t - other.t).abs() <= reach
                };
                if !found.roots.iter().any(same) {
                    found.roots.push(root);
                }
            }
            None => found.left.push([[a.from, a.to], [b.from, b.to]]),
        }
        true
    }

    /// A root at an end of both, if these ends are the same point to the bit.
    fn at_ends(&self, root: Root) -> Option<Root> {
        let end = |t: f64| match t {
            _ if t.abs() <= root.error => Some(0.0),
            _ if (t - 1.0).abs() <= root.error => Some(1.0),
            _ => None,
        };
        let (s, t) = (end(root.s)?, end(root.t)?);
        let pole = |part: &Part<D, N>, t: f64| {
            let i = if t == 0.0 { 0 } else { part.order - 1 };
            (part.poles[i], part.weight(i))
        };
        let ((p, v), (q, w)) = (pole(&self.a, s), pole(&self.b, t));
        let same = if v == w { p == q } else { false };
        same.then_some(Root { s, t, error: 0.0 })
    }
}

/// Halves the part that is longer in space, or both.
fn halve<const D: usize, const N: usize>(
    a: Part<D, N>,
    b: Part<D, N>,
    waiting: &mut Vec<Pair<D, N>>,
) {
    let size = |part: &Part<D, N>| {
        let ([x, y], [u, v]) = (part.point(0), part.point(part.order - 1));
        let [m, n] = part.point(part.order / 2);
        (m - x).abs() + (n - y).abs() + (u - m).abs() + (v - n).abs()
    };
    let (size_a, size_b) = (size(&a), size(&b));
    if size_a > 2.0 * size_b || a.order == 1 && b.order == 1 {
        let (left, right) = a.halves();
        waiting.extend([Pair { a: right, b }, Pair { a: left, b }]);
    } else if size_b > 2.0 * size_a {
        let (left, right) = b.halves();
        waiting.extend([Pair { a, b: right }, Pair { a, b: left }]);
    } else {
        let (parts_a, parts_b) = (a.halves(), b.halves());
        for a in [parts_a.1, parts_a.0] {
            for b in [parts_b.1, parts_b.0] {
                waiting.push(Pair { a, b });
            }
        }
    }
}
