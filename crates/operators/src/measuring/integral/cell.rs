//! A box of parameters of one piece, and its share of the integral.

use pforms_kernel::{Form, Result};

use super::bounds::{AlongAxis, Series};
use super::density::{Density, mean_length};
use super::rule::{RADII, Rules};
use crate::algebra::split;
use crate::measuring::vector::norm;

/// Part of a piece, with the polynomials of the integrand on its own window.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    /// The piece it belongs to.
    pub piece: usize,
    low: Vec<f64>,
    high: Vec<f64>,
    numerators: Form,
    square: Option<Form>,
    /// The piece itself, where its points or weights matter.
    host: Option<Form>,
}

/// The share of a cell.
#[derive(Clone, Debug)]
pub(super) struct Share {
    /// The integral of the element, then of it times each coordinate, then times each product of two.
    pub values: Vec<f64>,
    /// By how much each may be wrong.
    pub error: f64,
    /// Of that, what rounding did and no halving takes away.
    pub noise: f64,
    /// The axis along which it varies most.
    pub axis: usize,
}

impl Cell {
    /// All of a piece; `points` says whether its points are needed.
    pub(super) fn whole(piece: usize, density: &Density, host: &Form, points: bool) -> Self {
        let needed = points || density.power > 0;
        Self {
            piece,
            low: vec![0.0; host.axes()],
            high: vec![1.0; host.axes()],
            numerators: density.numerators.clone(),
            square: density.square.clone(),
            host: needed.then(|| host.clone()),
        }
    }

    /// Both halves along an axis; `None` when no parameter lies between its ends.
    pub(super) fn halves(&self, axis: usize) -> Result<Option<[Self; 2]>> {
        let middle = f64::midpoint(self.low[axis], self.high[axis]);
        if !(self.low[axis] < middle && middle < self.high[axis]) {
            return Ok(None);
        }
        let cut = |form: &Form| split(form, axis, &0.5);
        let cut_some = |form: &Option<Form>| -> Result<(Option<Form>, Option<Form>)> {
            Ok(form.as_ref().map(cut).transpose()?.unzip())
        };
        let numerators = cut(&self.numerators)?;
        let (square, host) = (cut_some(&self.square)?, cut_some(&self.host)?);
        let (mut high, mut low) = (self.high.clone(), self.low.clone());
        (high[axis], low[axis]) = (middle, middle);
        Ok(Some([
            Self {
                piece: self.piece,
                low: self.low.clone(),
                high,
                numerators: numerators.0,
                square: square.0,
                host: host.0,
            },
            Self {
                piece: self.piece,
                low,
                high: self.high.clone(),
                numerators: numerators.1,
                square: square.1,
                host: host.1,
            },
        ]))
    }

    /// Bytes it occupies, about.
    pub(super) fn bytes(&self) -> usize {
        let forms = [Some(&self.numerators), self.square.as_ref(), self.host.as_ref()];
        forms.into_iter().flatten().map(Form::bytes).sum::<usize>() + size_of::<Self>()
    }

    /// Its part of the window.
    pub(super) fn volume(&self) -> f64 {
        self.low.iter().zip(&self.high).map(|(low, high)| high - low).product()
    }

    /// About how much it contributes, rather too much.
    pub(super) fn estimate(&self, density: &Density) -> f64 {
        let divisor = self.host.as_ref().map_or(1.0, |host| {
            let weights = host.weights();
            let mean = weights.iter().sum::<f64>() / weights.len() as f64;
            mean.abs().powi(density.power as i32)
        });
        let most = mean_length(&self.numerators) * self.factor(density) * self.volume();
        if divisor > 0.0 { most / divisor } else { most }
    }

    /// The share of the cell, with an error of `target` or what one rule can do; `moments` is the
    /// highest degree in the coordinates, 0 to 2.
    pub(super) fn share(
        &self,
        density: &Density,
        moments: usize,
        target: f64,
        rules: &mut Rules,
    ) -> Result<Share> {
        let axes = self.low.len();
        let along = |axis| self.along(density, moments, axis);
        let bounds = (0..axes).map(along).collect::<Result<Vec<_>>>()?;
        let varies = |axis: usize| bounds[axis].variation;
        let axis = (0..axes).rev().max_by(|a, b| varies(*a).total_cmp(&varies(*b))).unwrap_or(0);
        let (mut counts, mut error) = (Vec::with_capacity(axes), 0.0);
        for bound in &bounds {
            let Some((count, rest)) = bound.nodes(target / axes as f64, axes) else {
                return Ok(self.enclosed(density, moments, axis));
            };
            counts.push(count);
            error += rest;
        }
        let (values, noise) = match self.mean(density) {
            Some(sums) => sums,
            None => self.integral(density, moments, &counts, rules)?,
        };
        Ok(Share { values, error: error + noise, noise, axis })
    }

    /// Bounds of the integrand, times the volume of the cell, where the parameter along `axis` is
    /// complex and the others in their windows.
    fn along(&self, density: &Density, moments: usize, axis: usize) -> Result<AlongAxis> {
        let numerators = Series::new(&self.numerators, axis, 0..self.numerators.ambient())?;
        let mut variation = numerators.variation;
        let mut most = match &self.square {
            Some(square) => {
                let square = Series::new(square, axis, 0..1)?;
                variation = variation.max(square.variation);
                let pairs = square.least.iter().zip(square.most);
                pairs
                    .map(|(least, most)| if *least > 0.0 { most.sqrt() } else { f64::INFINITY })
                    .collect()
            }
            None if density.signed || self.has_one_sign() => numerators.most.to_vec(),
            None => vec![f64::INFINITY; RADII.len()],
        };
        if let Some(host) = &self.host {
            let ambient = host.ambient();
            let weight = Series::new(host, axis, ambient..ambient + 1)?;
            let points = Series::new(host, axis, 0..ambient)?;
            variation = variation.max(weight.variation);
            for (k, most) in most.iter_mut().enumerate() {
                let least = weight.least[k];
                let reach = (points.most[k] / least).max(1.0).powi(moments as i32);
                let below = least.powi(density.power as i32);
                *most = if least > 0.0 { *most * reach / below } else { f64::INFINITY };
            }
        }
        let others = (0..self.low.len()).filter(|other| *other != axis);
        let others = others.map(|other| self.factor_along(density, other, 1.0)).product::<f64>();
        let scale = self.volume() * others;
        let mut scaled = [f64::INFINITY; RADII.len()];
        for ((scaled, most), radius) in scaled.iter_mut().zip(most).zip(RADII) {
            *scaled = most * scale * self.factor_along(density, axis, radius);
        }
        let single = self.square.is_none() && scaled[0].is_finite() && self.is_polynomial(density);
        let degree = single.then(|| {
            let factors: i32 = density.factors[axis].iter().sum();
            let host = self.host.as_ref().map_or(0, |host| host.orders()[axis] - 1);
            self.numerators.orders()[axis] - 1 + factors as usize + moments * host
        });
        Ok(AlongAxis { most: scaled, degree, variation })
    }

    fn is_polynomial(&self, density: &Density) -> bool {
        density.power == 0 && self.host.as_ref().is_none_or(|host| !host.is_rational())
    }

    /// Have all poles of the only component one sign?
    fn has_one_sign(&self) -> bool {
        let mut poles = self.numerators.homogeneous().iter().step_by(self.numerators.width());
        poles.clone().all(|x| *x >= 0.0) || poles.all(|x| *x <= 0.0)
    }

    /// The largest value of the factors over the cell.
    fn factor(&self, density: &Density) -> f64 {
        (0..self.low.len()).map(|axis| self.factor_along(density, axis, 1.0)).product()
    }

    /// The same along one axis, in the disc of this radius.
    fn factor_along(&self, density: &Density, axis: usize, radius: f64) -> f64 {
        let middle = f64::midpoint(self.low[axis], self.high[axis]);
        let reach = 0.5 * (self.high[axis] - self.low[axis]) * radius;
        let [a, b] = density.factors[axis];
        (middle + reach).powi(a) * (1.0 - middle + reach).powi(b)
    }

    /// The integral of a polynomial without more ado: the mean of its Bernstein coefficients.
    fn mean(&self, density: &Density) -> Option<(Vec<f64>, f64)> {
        let plain = self.square.is_none() && self.host.is_none();
        if !plain || density.factors.iter().flatten().any(|factor| *factor > 0) {
            return None;
        }
        let poles = self.numerators.homogeneous().as_chunks::<2>().0;
        let [sum, noise] = poles.iter().fold([0.0, 0.0], |[a, b], [x, y]| [a + x, b + y]);
        let share = self.volume() / poles.len() as f64;
        let sum = if density.signed { sum } else { sum.abs() };
        Some((vec![sum * share], noise * share))
    }

    /// The integral by a rule of so many nodes along each axis, and what rounding did to it.
    fn integral(
        &self,
        density: &Density,
        moments: usize,
        counts: &[usize],
        rules: &mut Rules,
    ) -> Result<(Vec<f64>, f64)> {
        let numerators = sampled(&self.numerators, counts, rules)?;
        let host = self.host.as_ref().map(|host| sampled(host, counts, rules)).transpose()?;
        let weights = self.node_weights(density, counts, rules);
        let width = numerators.width();
        let ambient = host.as_ref().map_or(0, Form::ambient);
        let mut values = vec![0.0; moment_count(ambient, moments)];
        let mut noise = 0.0;
        for (node, (numerator, weight)) in
            numerators.homogeneous().chunks_exact(width).zip(&weights).enumerate()
        {
            let (vector, unsure) = numerator.split_at(width - 1);
            let size = if density.signed { vector[0] } else { norm(vector) };
            let Some(host) = &host else {
                values[0] += weight * size;
                noise += weight * unsure[0];
                continue;
            };
            let (point, below) = host.homogeneous()[node * (ambient + 1)..].split_at(ambient);
            let share = weight / below[0].powi(density.power as i32);
            noise += share.abs() * unsure[0];
            add_moments(&mut values, share * size, point, below[0], moments);
        }
        Ok((values, noise))
    }

    /// Weights of the nodes times the factors there and the volume of the cell.
    fn node_weights(&self, density: &Density, counts: &[usize], rules: &mut Rules) -> Vec<f64> {
        let mut all = vec![self.volume()];
        for (axis, count) in counts.iter().enumerate() {
            let rule = rules.rule(*count);
            let [a, b] = density.factors[axis];
            let side = self.high[axis] - self.low[axis];
            let line: Vec<f64> = rule
                .nodes
                .iter()
                .zip(&rule.weights)
                .map(|(t, weight)| {
                    let (u, v) =
                        (self.low[axis] + side * t, 1.0 - self.high[axis] + side * (1.0 - t));
                    weight * u.powi(a) * v.powi(b)
                })
                .collect();
            all = all.iter().flat_map(|x| line.iter().map(move |y| x * y)).collect();
        }
        all
    }

    /// Where the integrand is not shown to be analytic: between 0 and the mean of its poles.
    fn enclosed(&self, density: &Density, moments: usize, axis: usize) -> Share {
        let (mut least, mut ambient, mut middle, mut reach) = (1.0, 0, Vec::new(), 1.0_f64);
        if let Some(host) = &self.host {
            ambient = host.ambient();
            let poles = host.homogeneous().chunks_exact(ambient + 1);
            least = poles.clone().map(|pole| pole[ambient]).fold(f64::INFINITY, f64::min).max(0.0);
            if least > 0.0 {
                middle = vec![0.0; ambient];
                for pole in poles {
                    let point: Vec<f64> =
                        pole[..ambient].iter().map(|x| x / pole[ambient]).collect();
                    reach = reach.max(norm(&point));
                    let share = 1.0 / host.pole_count() as f64;
                    middle.iter_mut().zip(&point).for_each(|(sum, x)| *sum += share * x);
                }
            }
        }
        let length = mean_length(&self.numerators) * self.factor(density) * self.volume();
        let most = length / least.powi(density.power as i32);
        let mut values = vec![0.0; moment_count(ambient, moments)];
        if most.is_finite() && !density.signed {
            add_moments(&mut values, 0.5 * most, &middle, 1.0, moments);
        }
        let error = match (most.is_finite(), density.signed || moments > 0) {
            (false, _) => f64::INFINITY,
            (true, true) => most * reach.powi(moments as i32),
            (true, false) => 0.5 * most,
        };
        Share { values, error, noise: 0.0, axis }
    }
}

/// How many integrals there are: of 1, of the coordinates, of their products.
pub(super) fn moment_count(ambient: usize, moments: usize) -> usize {
    match moments {
        0 => 1,
        1 => 1 + ambient,
        _ => 1 + ambient + ambient * (ambient + 1) / 2,
    }
}

/// Adds a mass at a point, in homogeneous coordinates.
fn add_moments(values: &mut [f64], mass: f64, point: &[f64], weight: f64, moments: usize) {
    values[0] += mass;
    if moments == 0 {
        return;
    }
    let mut place = 1 + point.len();
    for (i, x) in point.iter().enumerate() {
        let first = mass * x / weight;
        values[1 + i] += first;
        if moments > 1 {
            for y in &point[i..] {
                values[place] += first * y / weight;
                place += 1;
            }
        }
    }
}

/// The homogeneous values of a form at the nodes.
fn sampled(form: &Form, counts: &[usize], rules: &mut Rules) -> Result<Form> {
    let mut values = form.clone();
    for (axis, count) in counts.iter().enumerate() {
        values = values.along(axis, rules.rows(form.orders()[axis] - 1, *count))?;
    }
    Ok(values)
}
