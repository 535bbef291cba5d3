//! Where two plane curves meet, in whole numbers: every `f64` is a fraction, so nothing is left to
//! rounding.
//!
//! The equation of one curve along the other is a polynomial (its resultant), whose roots are the
//! parameters of the meetings, as often as crossings fall together there. Roots of both
//! polynomials are paired where the points agree to [`AGREE`] binary places.

mod implicit;
mod isolate;
mod modular;
mod polynomial;

use num_bigint::BigInt;
use num_traits::Zero;

use implicit::{Equation, ExactCurve};
use isolate::{BITS, RealRoot, real_roots};

/// What is known of two curves.
pub(super) enum Exact {
    /// They are parts of one curve.
    Shared,
    /// One is run through more than once, or a point, or the degrees are too high.
    Unknown,
    /// All their meetings, and parameters of the second around which it comes near the first or goes
    /// away from it: where the equation of the first has an extremum.
    Meetings(Vec<Meeting>, Vec<f64>),
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
const DEGREE: usize = 100;

/// Points that agree to so many binary places, in units of the curves, are the same.
const AGREE: u64 = 100;

/// All meetings of two curves with homogeneous poles `x, y, w`.
pub(super) fn meetings(a: &[[f64; 3]], b: &[[f64; 3]]) -> Exact {
    let (a, b) = (ExactCurve::new(a), ExactCurve::new(b));
    if a.degree == 0 || b.degree == 0 || a.degree * b.degree > DEGREE {
        return Exact::Unknown;
    }
    let mut polynomials = Vec::with_capacity(2);
    for (one, other) in [(&a, &b), (&b, &a)] {
        let equation = Equation::new(one);
        let along = equation.along(other);
        if along.is_zero() {
            return if equation.is_void() { Exact::Unknown } else { Exact::Shared };
        }
        polynomials.push(along);
    }
    let (t, s) = (real_roots(&polynomials[0]), real_roots(&polynomials[1]));
    let (of_s, of_t) = (points(&a, &s), points(&b, &t));
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
    let turns = real_roots(&polynomials[0].derivative());
    Exact::Meetings(
        pairs.iter().map(meeting).collect(),
        turns.iter().map(RealRoot::value).collect(),
    )
}

fn points(curve: &ExactCurve, roots: &[RealRoot]) -> Vec<[BigInt; 3]> {
    let place = |root: &RealRoot| (&root.low << BITS.saturating_sub(root.k), BITS.max(root.k));
    roots
        .iter()
        .map(|root| {
            let (n, k) = place(root);
            curve.at(&n, k)
        })
        .collect()
}

fn agree(p: &[BigInt; 3], q: &[BigInt; 3]) -> bool {
    let scale = &p[2] * &q[2];
    (0..2).all(|k| {
        let gap = &p[k] * &q[2] - &q[k] * &p[2];
        gap.is_zero() || gap.bits() + AGREE < scale.bits()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(a: &[[f64; 2]], b: &[[f64; 2]]) -> Vec<(f64, f64, usize)> {
        let poles = |list: &[[f64; 2]]| -> Vec<[f64; 3]> {
            list.iter().map(|[x, y]| [*x, *y, 1.0]).collect()
        };
        match meetings(&poles(a), &poles(b)) {
            Exact::Meetings(list, _) => list.iter().map(|m| (m.s, m.t, m.order)).collect(),
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
        let arch = [[0., 0., 1.], [0.5, 1., 1.], [1., 0., 1.]];
        let half = [[0., 0., 1.], [0.25, 0.5, 1.], [0.5, 0.5, 1.]];
        assert!(matches!(meetings(&arch, &half), Exact::Shared));
        // A segment run to and fro: both places, twice each.
        let back = [[0., 0., 1.], [2., 2., 1.], [0., 0., 1.]];
        assert!(!matches!(meetings(&back, &arch), Exact::Shared));
    }
}
