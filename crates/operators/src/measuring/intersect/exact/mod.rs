//! Where two curves meet, in whole numbers: every `f64` is a fraction, so nothing is left to rounding.
//!
//! The equation of one plane curve along the other is a polynomial (its resultant), whose roots are the
//! parameters of the meetings, as often as crossings fall together there. Curves in space are seen in
//! several planes: what these polynomials have in common is left. Roots of both polynomials are paired
//! where the points agree to [`AGREE`] binary places.

mod cluster;
mod implicit;
mod isolate;
mod modular;
mod polynomial;

use num_bigint::BigInt;
use num_traits::Zero;

pub(super) use cluster::{Around, Cluster};
use implicit::{Coordinates, Equation, work};
use isolate::{BITS, RealRoot, real_roots};
use polynomial::Polynomial;

/// What is known of two curves.
pub(super) enum Exact {
    /// They are parts of one curve.
    Shared,
    /// One is run through more than once, or a point, or degrees are too high or digits
    /// too many.
    Unknown,
    /// All their meetings.
    Meetings(Meetings),
}

/// All meetings of two curves, and the equations they come from.
pub(super) struct Meetings {
    pub list: Vec<Meeting>,
    /// Where they meet as seen in a plane: for plane curves the same.
    pub seen: Vec<Meeting>,
    /// For each view the equation of the second along the first, and of the first along the second.
    along: Vec<[Polynomial; 2]>,
}

/// A place where two curves meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    pub s: f64,
    pub t: f64,
    /// How many crossings fall together; 0 where branches of both do.
    pub order: usize,
}

/// The product of the degrees, that of the polynomials, at most.
const DEGREE: usize = 200;

/// Nanoseconds for the equations of one view, about, at most.
const WORK: f64 = 1e9;

/// Points that agree to so many binary places, in units of the curves, are the same.
const AGREE: u64 = 100;

/// All meetings of two curves with homogeneous poles, the weights last: in a plane, or in space.
pub(super) fn meetings(a: &[Vec<f64>], b: &[Vec<f64>]) -> Exact {
    let (a, b) = (Coordinates::new(a), Coordinates::new(b));
    let mut along: Vec<[Polynomial; 2]> = Vec::new();
    let none = || Polynomial::new(Vec::new());
    let mut common = [none(), none()];
    for view in 0..a.views() {
        let (p, q) = (a.seen(view), b.seen(view));
        let high = p.degree * q.degree > DEGREE || work(&p, &q) + work(&q, &p) > WORK;
        if p.degree == 0 || q.degree == 0 || high {
            return Exact::Unknown;
        }
        let mut pair = [none(), none()];
        for (along, [one, other]) in pair.iter_mut().zip([[&q, &p], [&p, &q]]) {
            let equation = Equation::new(one);
            *along = equation.along(other);
            if along.is_zero() && equation.is_void() {
                return Exact::Unknown;
            }
        }
        common = match along.is_empty() {
            true => pair.clone(),
            false => [common[0].gcd(&pair[0]), common[1].gcd(&pair[1])],
        };
        along.push(pair);
        if along.len() > 1 && common.iter().any(Polynomial::is_constant) {
            break;
        }
    }
    if common.iter().any(Polynomial::is_zero) {
        return Exact::Shared;
    }
    let list = paired([&a, &b].map(Coordinates::whole), &common);
    let first = along.iter().position(|pair| pair.iter().all(|p| !p.is_zero()));
    let seen = match first {
        Some(view) if along.len() > 1 => {
            paired([a.seen(view).whole(), b.seen(view).whole()], &along[view])
        }
        _ => list.clone(),
    };
    Exact::Meetings(Meetings { list, seen, along })
}

/// The roots of both polynomials where the points, with coordinates by `parts`, are the same.
fn paired([a, b]: [&[Polynomial]; 2], common: &[Polynomial; 2]) -> Vec<Meeting> {
    let (s, t) = (real_roots(&common[0]), real_roots(&common[1]));
    let (of_s, of_t) = (points(a, &s), points(b, &t));
    let pairs: Vec<(usize, usize)> = (0..s.len())
        .flat_map(|i| (0..t.len()).map(move |j| (i, j)))
        .filter(|(i, j)| agree(&of_s[*i], &of_t[*j]))
        .collect();
    let order = |i: usize, j: usize| {
        let of_s = pairs.iter().filter(|pair| pair.0 == i).count();
        let of_t = pairs.iter().filter(|pair| pair.1 == j).count();
        match (of_s, of_t) {
            // A smooth branch of either tells how often the other meets it.
            (1, 1) => s[i].times.min(t[j].times),
            (1, _) => s[i].times,
            (_, 1) => t[j].times,
            (n, m) => usize::from(n == s[i].times && m == t[j].times),
        }
    };
    let meeting =
        |&(i, j): &(usize, usize)| Meeting { s: s[i].value(), t: t[j].value(), order: order(i, j) };
    pairs.iter().map(meeting).collect()
}

impl Meetings {
    /// Parameters of the second curve around which it comes near the first or goes away from it, as
    /// seen in a plane: where the equation of the first has an extremum.
    pub(super) fn turns(&self) -> Vec<f64> {
        let Some([_, along]) = self.views().next() else { return Vec::new() };
        real_roots(&along.derivative()).iter().map(RealRoot::value).collect()
    }

    /// For each view the equations around a place of each curve.
    pub(super) fn around(&self, s: f64, t: f64) -> Vec<[Around; 2]> {
        self.views().map(|[p, q]| [Around::new(p, s), Around::new(q, t)]).collect()
    }

    /// Where the curves are not parts of one as seen.
    fn views(&self) -> impl Iterator<Item = &[Polynomial; 2]> {
        self.along.iter().filter(|pair| pair.iter().all(|p| !p.is_zero()))
    }
}

/// The homogeneous points at roots, times powers of two.
fn points(parts: &[Polynomial], roots: &[RealRoot]) -> Vec<Vec<BigInt>> {
    let degree = parts.iter().map(Polynomial::degree).max().unwrap_or(0);
    let point = |root: &RealRoot| {
        let (n, k) = (&root.low << BITS.saturating_sub(root.k), BITS.max(root.k));
        parts.iter().map(|part| part.scaled_at(&n, k, degree)).collect()
    };
    roots.iter().map(point).collect()
}

fn agree(p: &[BigInt], q: &[BigInt]) -> bool {
    let (Some((v, p)), Some((w, q))) = (p.split_last(), q.split_last()) else { return false };
    let scale = v * w;
    p.iter().zip(q).all(|(x, y)| {
        let gap = x * w - y * v;
        gap.is_zero() || gap.bits() + AGREE < scale.bits()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found<const N: usize>(a: &[[f64; N]], b: &[[f64; N]]) -> Vec<(f64, f64, usize)> {
        let poles = |list: &[[f64; N]]| -> Vec<Vec<f64>> {
            list.iter().map(|p| p.iter().copied().chain([1.0]).collect()).collect()
        };
        match meetings(&poles(a), &poles(b)) {
            Exact::Meetings(all) => all.list.iter().map(|m| (m.s, m.t, m.order)).collect(),
            Exact::Shared => panic!("shared"),
            Exact::Unknown => panic!("unknown"),
        }
    }

    #[test]
    fn an_arch_and_lines() {
        let arch = [[0., 0.], [0.5, 1.], [1., 0.]];
        assert_eq!(found(&arch, &[[0., 0.5], [1., 0.5]]), [(0.5, 0.5, 2)]);
        assert_eq!(found(&arch, &[[0., 0.375], [1., 0.375]]), [(0.25, 0.25, 1), (0.75, 0.75, 1)]);
        assert_eq!(found(&arch, &[[0., 0.], [1., 0.]]), [(0., 0., 1), (1., 1., 1)]);
        assert_eq!(found(&arch, &[[0., 0.75], [1., 0.75]]), []);
    }

    #[test]
    fn a_contact_of_order_five() {
        // y = x⁵ and y = 0 over [-1, 1].
        let quintic = [[-1., -1.], [-0.6, 1.], [-0.2, -1.], [0.2, 1.], [0.6, -1.], [1., 1.]];
        let quintic = quintic.map(|[x, y]| [x * 5.0, y]);
        assert_eq!(found(&quintic, &[[-5., 0.], [5., 0.]]), [(0.5, 0.5, 5)]);
    }

    #[test]
    fn parts_of_one_curve() {
        let arch = [[0., 0.], [0.5, 1.], [1., 0.]];
        let half = [[0., 0.], [0.25, 0.5], [0.5, 0.5]];
        let poles = |list: [[f64; 2]; 3]| list.map(|[x, y]| vec![x, y, 1.0]);
        assert!(matches!(meetings(&poles(arch), &poles(half)), Exact::Shared));
        // A segment run to and fro, 4t(1 − t)·(1, 1), passes both meetings with the arch twice: where
        // it is at (0, 0) and at (1/2, 1/2), that is at t = 0, 1 and (2 ∓ √2)/4.
        let back = [[0., 0.], [2., 2.], [0., 0.]];
        let all = found(&back, &arch);
        let root = (2.0 - 2.0_f64.sqrt()) / 4.0;
        let expected = [(0., 0., 1), (root, 0.5, 1), (1.0 - root, 0.5, 1), (1., 0., 1)];
        assert_eq!(all.len(), 4, "{all:?}");
        for (is, should) in all.iter().zip(expected) {
            assert!((is.0 - should.0).abs() <= f64::EPSILON, "{all:?}");
            assert_eq!((is.1, is.2), (should.1, should.2), "{all:?}");
        }
    }

    #[test]
    fn curves_in_space() {
        // A twisted cubic (t, t², t³) and its chord from 0 to 1, its tangent, and a line that passes it.
        let cubic = [[0., 0., 0.], [1., 0., 0.], [2., 1., 0.], [3., 3., 3.]];
        assert_eq!(found(&cubic, &[[0., 0., 0.], [3., 3., 3.]]), [(0., 0., 1), (1., 1., 1)]);
        assert_eq!(found(&cubic, &[[-1., 0., 0.], [1., 0., 0.]]), [(0., 0.5, 2)]);
        assert_eq!(found(&cubic, &[[-1., 0., 1.], [1., 0., 1.]]), []);
    }
}
