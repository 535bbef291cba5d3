//! Derivatives at many points in `f64`, without an allocation per point.

use crate::basis::taylor_row_into;
use crate::bulk::add_lines;
use crate::jet::{factorials, lower, unreachable};
use crate::{Form, Result, pascal_row};

impl Form<f64> {
    /// Derivatives `∂^orders` of the points at scattered parameters, into `out`.
    ///
    /// Errors: as [`Form::scattered`].
    pub fn scattered_derivative_into(
        &self,
        parameters: &[&[f64]],
        orders: &[usize],
        out: &mut [f64],
    ) -> Result<()> {
        self.require_per_axis("derivative", orders)?;
        let mut derivatives = Derivatives::new(self, orders);
        let ambient = self.ambient();
        self.each_scattered(parameters, out, ambient, |form, at, part| {
            derivatives.write(form, at, part)
        })
    }
}

/// Buffers and tables for derivatives at one point after another without allocating.
struct Derivatives {
    orders: Vec<usize>,
    choices: Vec<Vec<f64>>,
    below: Vec<Vec<usize>>,
    scale: f64,
    uniform: Option<f64>,
    row: Vec<f64>,
    from: Vec<f64>,
    to: Vec<f64>,
}

impl Derivatives {
    fn new(form: &Form<f64>, orders: &[usize]) -> Self {
        Self {
            orders: orders.to_vec(),
            choices: form.degrees().into_iter().map(pascal_row).collect(),
            below: lower(orders),
            scale: factorials(orders),
            uniform: form.uniform_weight().copied(),
            row: Vec::new(),
            from: Vec::new(),
            to: Vec::new(),
        }
    }

    /// The derivative at one point: the local Taylor coefficients, then their quotient in place.
    fn write(&mut self, form: &Form<f64>, parameters: &[f64], out: &mut [f64]) -> Result<()> {
        self.expand(form, parameters);
        let width = form.width();
        let weight = |jet: &[f64], k: usize| jet[k * width + width - 1];
        let divisor = weight(&self.from, 0);
        if divisor == 0.0 {
            return Err(unreachable(&divisor));
        }
        for (k, below) in self.below.iter().enumerate() {
            for c in 0..width - 1 {
                let mut rest = self.from[k * width + c];
                for &j in &below[..below.len() - 1] {
                    rest -= weight(&self.from, k - j) * self.from[j * width + c];
                }
                self.from[k * width + c] = rest / divisor;
            }
        }
        let top = (self.below.len() - 1) * width;
        for (x, derivative) in out.iter_mut().zip(&self.from[top..]) {
            *x = derivative * self.scale;
        }
        if out.iter().all(|x| x.is_finite()) { Ok(()) } else { Err(unreachable(&divisor)) }
    }

    /// Leaves in `from` the homogeneous Taylor coefficients, one pole for each multi-index.
    fn expand(&mut self, form: &Form<f64>, parameters: &[f64]) {
        self.from.clear();
        self.from.extend_from_slice(form.homogeneous());
        let mut before = 1;
        for (axis, t) in parameters.iter().enumerate() {
            let order = form.orders()[axis];
            let block = self.from.len() / before;
            let inner = block / order;
            self.to.clear();
            self.to.resize(before * (self.orders[axis] + 1) * inner, 0.0);
            for r in 0..=self.orders[axis] {
                taylor_row_into(&self.choices[axis], r, t, &mut self.row);
                for part in 0..before {
                    let target = (part * (self.orders[axis] + 1) + r) * inner;
                    let source = &self.from[part * block..][..block];
                    add_lines(&self.row, source, &mut self.to[target..target + inner]);
                }
            }
            before *= self.orders[axis] + 1;
            std::mem::swap(&mut self.from, &mut self.to);
        }
        if let Some(weight) = self.uniform {
            for (k, pole) in self.from.chunks_exact_mut(form.width()).enumerate() {
                pole[form.ambient()] = if k == 0 { weight } else { 0.0 };
            }
        }
    }
}
