//! Quadratic energies of poles: sums of products of one matrix for each axis.

use pforms_kernel::{Binomials, Form, Matrix, Result, Scalar};

use crate::algebra::Knots;

/// `½·Σ A[i, j]·⟨P_i, P_j⟩` with `A = Σ M_0 ⊗ M_1 ⊗ …`.
pub(super) struct Energy<S> {
    terms: Vec<Vec<Matrix<S>>>,
}

impl<S: Scalar> Energy<S> {
    /// `½·∫ |∇F|²`, after Dirichlet.
    pub(super) fn dirichlet(knots: &[Knots<S>], sides: &[S]) -> Result<Self> {
        let lines = lines(knots, sides);
        let mass = each(&lines, |line| line.integrals(0, 0))?;
        let slope = each(&lines, |line| line.integrals(1, 1))?;
        let term = |axis: usize| replaced(&mass, &[(axis, &slope[axis])]);
        Ok(Self { terms: (0..knots.len()).map(term).collect() })
    }

    /// `½·∫ |ΔF|²`: how far from harmonic. Of splines, over the pieces.
    pub(super) fn laplacian(knots: &[Knots<S>], sides: &[S]) -> Result<Self> {
        let lines = lines(knots, sides);
        let mass = each(&lines, |line| line.integrals(0, 0))?;
        let bend = each(&lines, |line| line.integrals(2, 2))?;
        let left = each(&lines, |line| line.integrals(2, 0))?;
        let right = each(&lines, |line| line.integrals(0, 2))?;
        let mut terms = Vec::with_capacity(knots.len() * knots.len());
        for a in 0..knots.len() {
            for (b, other) in right.iter().enumerate() {
                terms.push(if a == b {
                    replaced(&mass, &[(a, &bend[a])])
                } else {
                    replaced(&mass, &[(a, &left[a]), (b, other)])
                });
            }
        }
        Ok(Self { terms })
    }

    /// `½·Σ |P_i − P_j|²` over neighbours in the net: least where every pole is the mean of its
    /// neighbours.
    pub(super) fn net(orders: &[usize]) -> Self {
        let unit = |&order: &usize| {
            Matrix::from_rule(order, order, |i, j| if i == j { S::one() } else { S::zero() })
        };
        let second = |&order: &usize| {
            Matrix::from_rule(order, order, |i, j| match i.abs_diff(j) {
                0 => S::from_integer(2),
                1 => -S::one(),
                _ => S::zero(),
            })
        };
        let units: Vec<Matrix<S>> = orders.iter().map(unit).collect();
        let term = |axis: usize| replaced(&units, &[(axis, &second(&orders[axis]))]);
        Self { terms: (0..orders.len()).map(term).collect() }
    }

    /// The entry between two poles.
    pub(super) fn entry(&self, i: &[usize], j: &[usize]) -> S {
        self.terms.iter().fold(S::zero(), |sum, term| {
            let mut product = S::one();
            for ((matrix, &i), &j) in term.iter().zip(i).zip(j) {
                let factor = &matrix.row(i)[j];
                if factor.is_zero() {
                    return sum;
                }
                product = product * factor.clone();
            }
            sum + product
        })
    }

    /// How far apart two poles may be along an axis with an entry between them.
    pub(super) fn reach(&self, axis: usize) -> usize {
        let reach = |matrix: &Matrix<S>| {
            let of_row = |i: usize| {
                let entries = matrix.row(i).iter().enumerate();
                entries.filter(|(_, x)| !x.is_zero()).map(|(j, _)| i.abs_diff(j)).max()
            };
            (0..matrix.rows()).filter_map(of_row).max().unwrap_or(0)
        };
        self.terms.iter().map(|term| reach(&term[axis])).max().unwrap_or(0)
    }

    /// What the energy grows by with each homogeneous coordinate of each pole.
    pub(super) fn gradient(&self, net: &Form<S>) -> Result<Vec<S>> {
        let mut sum = vec![S::zero(); net.homogeneous().len()];
        for term in &self.terms {
            let mut part = net.clone();
            for (axis, matrix) in term.iter().enumerate() {
                part = part.along(axis, matrix)?;
            }
            S::add_multiple(&mut sum, &S::one(), part.homogeneous());
        }
        Ok(sum)
    }
}

/// One axis: its knots, in units in which its window is as long as its side.
struct Line<'a, S> {
    knots: &'a Knots<S>,
    scale: S,
}

fn lines<'a, S: Scalar>(knots: &'a [Knots<S>], sides: &[S]) -> Vec<Line<'a, S>> {
    let line = |(knots, side): (&'a Knots<S>, &S)| {
        let (from, to) = knots.window();
        Line { knots, scale: side.clone() / (to.clone() - from.clone()) }
    };
    knots.iter().zip(sides).map(line).collect()
}

impl<S: Scalar> Line<'_, S> {
    /// `∫ N_i^(r) · N_j^(s)` of the basis functions: exact, piece by piece in Bernstein's basis.
    fn integrals(&self, r: usize, s: usize) -> Result<Matrix<S>> {
        let (order, degree) = (self.knots.order(), self.knots.degree());
        let mut rows = vec![vec![S::zero(); order]; order];
        if r.max(s) <= degree {
            let products = products(degree - r, degree - s);
            for (length, first, poles) in self.knots.bezier_rows() {
                let length = length * self.scale.clone();
                let (left, right) = (differences(poles.clone(), r), differences(poles, s));
                let unit = length.clone() / length.power(r + s);
                for i in 0..=degree {
                    for j in 0..=degree {
                        let sum = integral(&left, i, &right, j, &products);
                        rows[first + i][first + j] += sum * unit.clone();
                    }
                }
            }
        }
        Matrix::from_rows(rows)
    }
}

fn integral<S: Scalar>(
    left: &[Vec<S>],
    i: usize,
    right: &[Vec<S>],
    j: usize,
    products: &[Vec<S>],
) -> S {
    let mut sum = S::zero();
    for (row, a) in products.iter().zip(left) {
        if a[i].is_zero() {
            continue;
        }
        for (product, b) in row.iter().zip(right) {
            sum += product.clone() * a[i].clone() * b[j].clone();
        }
    }
    sum
}

/// `∫ B_i^a · B_j^b` from 0 to 1.
fn products<S: Scalar>(a: usize, b: usize) -> Vec<Vec<S>> {
    let [first, second, whole] = [a, b, a + b].map(Binomials::<S>::of);
    let length = S::from_integer(a as i64 + b as i64 + 1);
    let entry = |i: usize, j: usize| -> S {
        first.get(i) * second.get(j) / (whole.get(i + j) * length.clone())
    };
    (0..=a).map(|i| (0..=b).map(|j| entry(i, j)).collect()).collect()
}

/// The Bézier poles of the `r`-th derivative, from those of the functions: a row for each pole.
pub(super) fn differences<S: Scalar>(mut rows: Vec<Vec<S>>, r: usize) -> Vec<Vec<S>> {
    for _ in 0..r {
        let degree = S::from_integer(rows.len() as i64 - 1);
        let difference = |pair: &[Vec<S>]| {
            let both = pair[0].iter().zip(&pair[1]);
            both.map(|(a, b)| (b.clone() - a.clone()) * degree.clone()).collect()
        };
        rows = rows.windows(2).map(difference).collect();
    }
    rows
}

fn each<S: Scalar>(
    lines: &[Line<'_, S>],
    integrals: impl Fn(&Line<'_, S>) -> Result<Matrix<S>>,
) -> Result<Vec<Matrix<S>>> {
    lines.iter().map(integrals).collect()
}

/// The matrices with some of them exchanged.
fn replaced<S: Scalar>(all: &[Matrix<S>], others: &[(usize, &Matrix<S>)]) -> Vec<Matrix<S>> {
    let mut term = all.to_vec();
    for (axis, matrix) in others {
        term[*axis] = (*matrix).clone();
    }
    term
}

/// The place of a pole along each axis.
pub(super) fn place(mut index: usize, orders: &[usize]) -> Vec<usize> {
    let mut place = vec![0; orders.len()];
    for (at, order) in place.iter_mut().zip(orders).rev() {
        *at = index % order;
        index /= order;
    }
    place
}

/// Is the pole inside, neither first nor last along any axis?
pub(super) fn is_inside(place: &[usize], orders: &[usize]) -> bool {
    place.iter().zip(orders).all(|(&at, &order)| at > 0 && at + 1 < order)
}
