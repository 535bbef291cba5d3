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
        let factorials = self.orders.iter().flat_map(|&order| 1..=order);
        let scale = factorials.fold(S::one(), |product, k| product * S::from_integer(k as i64));
        let top = self.coefficients.len() - 1;
        self.coefficients[top].clone() * scale
    }

    /// `self += factor·other`.
    pub fn add_multiple(&mut self, factor: &S, other: &Self) {
        S::add_multiple(&mut self.coefficients, factor, &other.coefficients);
    }

    /// The product, truncated.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::constant(&self.orders, S::zero());
        for (i, a) in self.indices().iter().zip(&self.coefficients) {
            for (j, b) in self.indices().iter().zip(&other.coefficients) {
                if let Some(k) = self.position_of_sum(i, j) {
                    product.coefficients[k] += a.clone() * b.clone();
                }
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
            return Err(vanishing_weight());
        }
        let indices = self.indices();
        let mut quotient = Self::constant(&self.orders, S::zero());
        for (k, target) in indices.iter().enumerate() {
            let mut rest = self.coefficients[k].clone();
            for (j, known) in indices[..k].iter().enumerate() {
                let gap: Option<Vec<usize>> =
                    target.iter().zip(known).map(|(a, b)| a.checked_sub(*b)).collect();
                if let Some(gap) = gap {
                    let d = divisor.coefficients[self.position(&gap)].clone();
                    rest = rest - d * quotient.coefficients[j].clone();
                }
            }
            quotient.coefficients[k] = rest / divisor.value().clone();
        }
        Ok(quotient)
    }

    fn indices(&self) -> Vec<Vec<usize>> {
        let mut all = vec![Vec::new()];
        for &order in &self.orders {
            all = all
                .into_iter()
                .flat_map(|prefix| {
                    (0..=order).map(move |i| {
                        let mut index = prefix.clone();
                        index.push(i);
                        index
                    })
                })
                .collect();
        }
        all
    }

    fn position(&self, index: &[usize]) -> usize {
        let digits = index.iter().zip(&self.orders);
        digits.fold(0, |flat, (i, order)| flat * (order + 1) + i)
    }

    fn position_of_sum(&self, i: &[usize], j: &[usize]) -> Option<usize> {
        let sum: Vec<usize> = i.iter().zip(j).map(|(a, b)| a + b).collect();
        let inside = sum.iter().zip(&self.orders).all(|(s, order)| s <= order);
        inside.then(|| self.position(&sum))
    }
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
        Ok((0..self.width()).map(component).collect())
    }

    /// The derivative `∂^orders` of the euclidean point at `parameters`, `ambient` numbers.
    ///
    /// Errors: `Shape` as for [`Form::jets`]; `Domain` where the weight vanishes.
    pub fn derivative_at(&self, parameters: &[S], orders: &[usize]) -> Result<Vec<S>> {
        let mut jets = self.jets(parameters, orders)?;
        let weight = jets.pop().ok_or_else(vanishing_weight)?;
        jets.iter().map(|jet| Ok(jet.divided_by(&weight)?.top_derivative())).collect()
    }
}

pub(crate) fn vanishing_weight() -> Error {
    Error::domain(
        "parameters",
        "a point where the weight vanishes",
        "parameters where the form is finite",
    )
}
