//! Where the distance from a point does not change: one polynomial for each axis.

use pforms_kernel::{Form, Result, Scaled, pascal_row};

use crate::measuring::guarded::Guarded;
use crate::measuring::system::{Equations, Polynomial};

/// `S_k = ½·W³·∂_k|X/W − p|²` over a piece; half the derivative of the square where `W` is 1.
pub(super) struct Field {
    slopes: Vec<Polynomial>,
    /// All of them, to be evaluated.
    pub equations: Equations,
    /// `X − p·W` and `W`.
    pub seen: Form,
}

/// One axis of a face: the whole of it, or one of its ends.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Free,
    Low,
    High,
}

impl Field {
    /// Errors: `Domain` for a pole that overflows, `Limit`.
    pub(super) fn new(form: &Form, point: &[f64]) -> Result<Self> {
        let ambient = form.ambient();
        let mut poles = Vec::with_capacity(form.homogeneous().len());
        let mut guarded = Vec::with_capacity(form.homogeneous().len());
        for pole in form.homogeneous().chunks_exact(ambient + 1) {
            let weight = pole[ambient];
            for (x, p) in pole.iter().zip(point) {
                let product = p * weight;
                let value = x - product;
                // A product with 1 is exact, and the difference as exact as what is left.
                let size = value.abs() + if weight == 1.0 { 0.0 } else { product.abs() };
                poles.push(value);
                guarded.push(Guarded { value, size });
            }
            poles.push(weight);
            guarded.push(Guarded::from(weight));
        }
        let seen = Form::from_homogeneous(form.orders(), ambient, poles)?;
        let guarded = Form::from_homogeneous(form.orders(), ambient, guarded)?;
        let slopes = slopes(&guarded)?;
        let equations = Equations::new(slopes.clone())?;
        Ok(Self { slopes, equations, seen })
    }

    /// The equations of a face with one free axis at least: no change along those that are free.
    pub(super) fn on_face(&self, face: &[Side]) -> Result<Equations> {
        let free = face.iter().zip(&self.slopes).filter(|(side, _)| **side == Side::Free);
        Equations::new(free.map(|(_, slope)| restricted(slope, face)).collect())
    }
}

/// `Q·(∂_kQ·W − Q·∂_kW)` for each axis, `Q·∂_kQ` if all weights are the same.
fn slopes(form: &Form<Guarded>) -> Result<Vec<Polynomial>> {
    let all = Scaled::from_form(form);
    let ambient = form.ambient();
    let weight = form.is_rational().then(|| all.component(ambient));
    let coordinates: Vec<Scaled<Guarded>> = (0..ambient).map(|j| all.component(j)).collect();
    let axis_slope = |k: usize| -> Result<Polynomial> {
        let mut sum: Option<Scaled<Guarded>> = None;
        for q in &coordinates {
            let change = q.derivative(k);
            let change = match &weight {
                Some(w) => change.times(w)?.minus(&q.times(&w.derivative(k))?),
                None => change,
            };
            let term = change.times(q)?;
            match &mut sum {
                Some(sum) => sum.add_multiple(&Guarded::from(1.0), &term),
                None => sum = Some(term),
            }
        }
        Ok(sum.map_or_else(
            || Polynomial { orders: vec![1; form.axes()], coefficients: vec![0.0], noise: 0.0 },
            |sum| unscaled(&sum),
        ))
    };
    (0..form.axes()).map(axis_slope).collect()
}

/// Roundings that each coefficient may carry, in its size: as long as sums are.
const ROUNDINGS: f64 = 8.0;

/// Back to Bernstein coefficients.
fn unscaled(scaled: &Scaled<Guarded>) -> Polynomial {
    let orders: Vec<usize> = scaled.degrees().iter().map(|degree| degree + 1).collect();
    let mut binomials = vec![1.0];
    for order in &orders {
        let row = pascal_row::<f64>(order - 1);
        binomials = binomials.iter().flat_map(|b| row.iter().map(move |c| b * c)).collect();
    }
    let terms = ROUNDINGS + orders.iter().sum::<usize>() as f64;
    let mut noise = 0.0_f64;
    let coefficients = scaled
        .coefficients()
        .iter()
        .zip(&binomials)
        .map(|(x, b)| {
            noise = noise.max(terms * f64::EPSILON * x.size / b);
            x.value / b
        })
        .collect();
    Polynomial { orders, coefficients, noise }
}

/// The coefficients at the ends of the axes that are not free.
fn restricted(polynomial: &Polynomial, face: &[Side]) -> Polynomial {
    let mut coefficients = polynomial.coefficients.clone();
    let mut orders = Vec::with_capacity(face.len());
    let mut inner = 1;
    for (side, order) in face.iter().zip(&polynomial.orders).rev() {
        if *side == Side::Free {
            inner *= order;
            orders.push(*order);
            continue;
        }
        let skip = if *side == Side::Low { 0 } else { order - 1 };
        let lines = coefficients.chunks_exact(inner * order);
        coefficients = lines.flat_map(|block| &block[skip * inner..][..inner]).copied().collect();
    }
    orders.reverse();
    Polynomial { orders, coefficients, noise: polynomial.noise }
}
