//! Vectors of three polynomials.

use super::poly::Poly;
use crate::measuring::vector::norm;

/// A polynomial with values in space.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Vector(pub(super) [Poly; 3]);

impl Vector {
    pub(super) fn constant(value: [f64; 3]) -> Self {
        Self(value.map(Poly::constant))
    }

    fn map(&self, change: impl Fn(&Poly) -> Poly) -> Self {
        let [x, y, z] = &self.0;
        Self([change(x), change(y), change(z)])
    }

    pub(super) fn degree(&self) -> usize {
        self.0.iter().map(Poly::degree).max().unwrap_or(0)
    }

    pub(super) fn scaled(&self, factor: f64) -> Self {
        self.map(|x| x.scaled(factor))
    }

    pub(super) fn times(&self, factor: &Poly) -> Self {
        self.map(|x| x.times(factor))
    }

    pub(super) fn plus(&self, factor: f64, other: &Self) -> Self {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        Self([a.plus(factor, x), b.plus(factor, y), c.plus(factor, z)])
    }

    pub(super) fn derivative(&self) -> Self {
        self.map(Poly::derivative)
    }

    pub(super) fn dot(&self, other: &Self) -> Poly {
        let terms = self.0.iter().zip(&other.0).map(|(a, b)| a.times(b));
        terms.fold(Poly::constant(0.0), |sum, term| sum.plus(1.0, &term))
    }

    pub(super) fn cross(&self, other: &Self) -> Self {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        let minor = |p: &Poly, q: &Poly, r: &Poly, s: &Poly| p.times(q).plus(-1.0, &r.times(s));
        Self([minor(b, z, c, y), minor(c, x, a, z), minor(a, y, b, x)])
    }

    pub(super) fn at(&self, t: f64) -> [f64; 3] {
        self.0.each_ref().map(|x| x.at(t))
    }

    pub(super) fn first(&self) -> [f64; 3] {
        self.0.each_ref().map(Poly::first)
    }

    pub(super) fn last(&self) -> [f64; 3] {
        self.0.each_ref().map(Poly::last)
    }

    pub(super) fn halves(&self) -> (Self, Self) {
        let [x, y, z] = self.0.each_ref().map(Poly::halves);
        (Self([x.0, y.0, z.0]), Self([x.1, y.1, z.1]))
    }

    /// The coefficients, all of one degree.
    pub(super) fn poles(&self) -> Vec<[f64; 3]> {
        let [x, y, z] = self.0.each_ref().map(|x| x.raised(self.degree()));
        (0..=self.degree()).map(|i| [x.0[i], y.0[i], z.0[i]]).collect()
    }

    /// No value on `[0, 1]` is longer: the values are means of the coefficients.
    pub(super) fn most(&self) -> f64 {
        self.poles().iter().map(|pole| norm(pole)).fold(0.0, f64::max)
    }

    /// The polynomial of degree 5 with these values and first two derivatives at both ends.
    pub(super) fn hermite(start: [[f64; 3]; 3], end: [[f64; 3]; 3]) -> Self {
        Self(std::array::from_fn(|k| {
            Poly::hermite(start.map(|vector| vector[k]), end.map(|vector| vector[k]))
        }))
    }

    /// This vector without its zeros at the ends, where coefficients below `noise` times the
    /// largest count as zero: divided by powers of `t` and `1 − t` it keeps its direction.
    pub(super) fn without_end_zeros(&self, noise: f64) -> Self {
        let mut poles = self.poles();
        let size = poles.iter().map(|pole| norm(pole)).fold(0.0, f64::max);
        let zero = |pole: &[f64; 3]| norm(pole) <= noise * size;
        while poles.len() > 1 && zero(&poles[0]) {
            let degree = (poles.len() - 1) as f64;
            poles.remove(0);
            poles.iter_mut().enumerate().for_each(|(j, pole)| {
                *pole = pole.map(|x| x * degree / (j + 1) as f64);
            });
        }
        while poles.len() > 1 && zero(&poles[poles.len() - 1]) {
            let degree = (poles.len() - 1) as f64;
            poles.pop();
            poles.iter_mut().enumerate().for_each(|(j, pole)| {
                *pole = pole.map(|x| x * degree / (degree - j as f64));
            });
        }
        Self(std::array::from_fn(|k| Poly(poles.iter().map(|pole| pole[k]).collect())))
    }
}
