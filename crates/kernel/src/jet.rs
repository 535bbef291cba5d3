//! Truncated Taylor series: derivatives of quotients and compositions at a point.

use crate::{Error, Form, Result, Scalar, taylor_rows};

/// The Taylor coefficients `∂^α f / α!` of a scalar function at a point, for every multi-index
/// `α ≤ orders`, in C order.
#[derive(Clone, Debug, PartialEq)]
pub struct Jet<S = f64> {
    orders: Vec<usize>,
    coefficients: Vec<S>,
}

impl<S: Scalar> Jet<S> {
    /// A constant.
    pub fn constant(orders: &[usize], value: S) -> Self {
        let count = orders.iter().map(|order| order + 1).product();
        let mut coefficients = vec![S::zero(); count];
        coefficients[0] = value;
        Self { orders: orders.to_vec(), coefficients }
    }

    /// The value at the point.
    pub fn value(&self) -> &S {
        &self.coefficients[0]
    }

    /// The highest derivative kept: `∂^orders f`.
    pub fn top_derivative(&self) -> S {
        let top = self.coefficients.len() - 1;
        self.coefficients[top].clone() * factorials(&self.orders)
    }

    /// `self += factor·other`.
    pub fn add_multiple(&mut self, factor: &S, other: &Self) {
        S::add_multiple(&mut self.coefficients, factor, &other.coefficients);
    }

    /// The product, truncated.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::constant(&self.orders, S::zero());
        for (k, below) in lower(&self.orders).iter().enumerate() {
            for &j in below {
                product.coefficients[k] +=
                    self.coefficients[j].clone() * other.coefficients[k - j].clone();
            }
        }
        product
    }

    /// The quotient, truncated; the divisor must not vanish at the point.
    ///
    /// From `q·d = n` read coefficient by coefficient (*The NURBS Book*, equation 4.20).
    ///
    /// Errors: `Domain` when it does.
    pub fn divided_by(&self, divisor: &Self) -> Result<Self> {
        if divisor.value().is_zero() {
            return Err(unreachable(divisor.value()));
        }
        let mut quotient = self.clone();
        for (k, below) in lower(&self.orders).iter().enumerate() {
            let mut rest = self.coefficients[k].clone();
            for &j in &below[..below.len() - 1] {
                let d = divisor.coefficients[k - j].clone();
                rest = rest - d * quotient.coefficients[j].clone();
            }
            quotient.coefficients[k] = rest / divisor.value().clone();
        }
        Ok(quotient)
    }
}

/// For every multi-index `k ≤ orders`, the flat positions of the multi-indices `j ≤ k`, `k` last.
///
/// The position of `k − j` is the difference of the positions.
pub(crate) fn lower(orders: &[usize]) -> Vec<Vec<usize>> {
    let mut all = vec![vec![0]];
    for &order in orders {
        let coarser = std::mem::take(&mut all);
        for below in &coarser {
            for i in 0..=order {
                let finer = |j: &usize| (0..=i).map(|k| j * (order + 1) + k).collect::<Vec<_>>();
                all.push(below.iter().flat_map(finer).collect());
            }
        }
    }
    all
}

/// `∂^orders` over the last Taylor coefficient: the product of the factorials.
pub(crate) fn factorials<S: Scalar>(orders: &[usize]) -> S {
    let factors = orders.iter().flat_map(|&order| 1..=order);
    factors.fold(S::one(), |product, k| product * S::from_integer(k as i64))
}

impl<S: Scalar> Form<S> {
    /// The homogeneous Taylor expansion at `parameters`: a jet for each of the `ambient + 1`
    /// coordinates, with every derivative up to `orders`.
    ///
    /// Errors: `Shape` unless there is one parameter and one order for each axis.
    pub fn jets(&self, parameters: &[S], orders: &[usize]) -> Result<Vec<Jet<S>>> {
        self.require_per_axis("parameters", parameters)?;
        self.require_per_axis("derivative", orders)?;
        let mut local = self.clone();
        for (axis, (t, &order)) in parameters.iter().zip(orders).enumerate() {
            local = local.along(axis, &taylor_rows(self.orders()[axis] - 1, order, t))?;
        }
        let component = |k: usize| Jet {
            orders: orders.to_vec(),
            coefficients: local
                .homogeneous()
                .chunks_exact(self.width())
                .map(|pole| pole[k].clone())
                .collect(),
        };
        let mut jets: Vec<Jet<S>> = (0..self.ambient()).map(component).collect();
        jets.push(match self.uniform_weight() {
            Some(weight) => Jet::constant(orders, weight.clone()),
            None => component(self.ambient()),
        });
        Ok(jets)
    }

    /// The derivative `∂^orders` of the euclidean point at `parameters`, `ambient` numbers.
    ///
    /// Errors: `Shape` as for [`Form::jets`]; `Domain` where the weight vanishes or a coordinate
    /// overflows.
    pub fn derivative_at(&self, parameters: &[S], orders: &[usize]) -> Result<Vec<S>> {
        let mut jets = self.jets(parameters, orders)?;
        let weight = jets.pop().unwrap_or_else(|| Jet::constant(orders, S::zero()));
        let coordinate = |jet: &Jet<S>| {
            let derivative = jet.divided_by(&weight)?.top_derivative();
            if derivative.is_finite() { Ok(derivative) } else { Err(unreachable(weight.value())) }
        };
        jets.iter().map(coordinate).collect()
    }
}

/// Why there is no point where the weight is this.
#[cold]
pub(crate) fn unreachable<S: Scalar>(weight: &S) -> Error {
    let received = match weight.is_zero() {
        true => "a point where the weight vanishes",
        false => "a point beyond the largest floating number",
    };
    Error::domain("parameters", received, "parameters where the form is finite")
}
