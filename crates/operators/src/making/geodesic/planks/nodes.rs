//! Polynomials of degree 7 through Lobatto's nodes: poles, slopes, integrals, and places between.

use pforms_kernel::{Form, Result};

use crate::measuring::vector::dot;
use crate::{Nodes, interpolate};

/// Nodes of one piece.
pub(super) const ORDER: usize = 8;

/// What is known of a piece from its values at the nodes, once and for all pieces.
pub(super) struct Rule {
    pub nodes: Vec<f64>,
    /// Half way between neighbouring nodes.
    pub middles: Vec<f64>,
    /// Row `i`: what each value adds to Bernstein pole `i`.
    poles: Vec<Vec<f64>>,
    /// Row `i`: what each adds to the slope at node `i`.
    slopes: Vec<Vec<f64>>,
    /// Row `i`: what each adds to the integral from 0 to node `i`.
    integrals: Vec<Vec<f64>>,
    at_middles: Vec<Vec<f64>>,
}

impl Rule {
    pub(super) fn new() -> Result<Self> {
        let nodes = Nodes::<f64>::Lobatto.on_axis(0, ORDER)?;
        let mut poles = vec![vec![0.0; ORDER]; ORDER];
        for k in 0..ORDER {
            let mut values = vec![0.0; ORDER];
            values[k] = 1.0;
            let hat =
                interpolate(&Form::from_points(&[ORDER], 1, &values, None)?, &Nodes::Lobatto)?;
            for (row, pole) in poles.iter_mut().zip(hat.points()?) {
                row[k] = pole;
            }
        }
        // The ends are poles, without rounding.
        for (row, k) in [(0, 0), (ORDER - 1, ORDER - 1)] {
            poles[row] = (0..ORDER).map(|j| f64::from(u8::from(j == k))).collect();
        }
        let middles: Vec<f64> = nodes.windows(2).map(|p| f64::midpoint(p[0], p[1])).collect();
        let degree = (ORDER - 1) as f64;
        let sloped: Vec<Vec<f64>> = poles
            .windows(2)
            .map(|pair| pair[1].iter().zip(&pair[0]).map(|(b, a)| degree * (b - a)).collect())
            .collect();
        let mut summed = vec![vec![0.0; ORDER]];
        for (row, pole) in poles.iter().enumerate() {
            summed.push(summed[row].iter().zip(pole).map(|(s, p)| s + p / ORDER as f64).collect());
        }
        let rows =
            |poles: &[Vec<f64>], places: &[f64]| places.iter().map(|t| mixed(poles, *t)).collect();
        Ok(Self {
            slopes: rows(&sloped, &nodes),
            integrals: rows(&summed, &nodes),
            at_middles: rows(&poles, &middles),
            nodes,
            middles,
            poles,
        })
    }

    pub(super) fn poles(&self, values: &[f64]) -> Vec<f64> {
        self.poles.iter().map(|row| dot(row, values)).collect()
    }

    /// Slopes at the nodes of a piece of length 1.
    pub(super) fn slopes(&self, values: &[f64]) -> Vec<f64> {
        self.slopes.iter().map(|row| dot(row, values)).collect()
    }

    /// Integrals from the begin of a piece of length 1 to each node.
    pub(super) fn integrals(&self, values: &[f64]) -> Vec<f64> {
        self.integrals.iter().map(|row| dot(row, values)).collect()
    }

    pub(super) fn at_middles(&self, values: &[f64]) -> Vec<f64> {
        self.at_middles.iter().map(|row| dot(row, values)).collect()
    }

    pub(super) fn at(&self, values: &[f64], t: f64) -> f64 {
        value(&self.poles(values), t)
    }

    /// The values that are not known, from the polynomial through those that are.
    pub(super) fn filled(&self, values: &[Option<f64>]) -> Vec<f64> {
        let known: Vec<(f64, f64)> =
            self.nodes.iter().zip(values).filter_map(|(t, x)| x.map(|x| (*t, x))).collect();
        let through = |t: f64| -> f64 {
            let term = |(i, (a, x)): (usize, &(f64, f64))| {
                let others = known.iter().enumerate().filter(|(k, _)| *k != i);
                x * others.map(|(_, (b, _))| (t - b) / (a - b)).product::<f64>()
            };
            known.iter().enumerate().map(term).sum()
        };
        self.nodes.iter().zip(values).map(|(t, x)| x.unwrap_or_else(|| through(*t))).collect()
    }
}

/// The value of a polynomial from its Bernstein poles.
pub(super) fn value(poles: &[f64], t: f64) -> f64 {
    let mut row = poles.to_vec();
    for length in (1..poles.len()).rev() {
        for i in 0..length {
            row[i] = (1.0 - t) * row[i] + t * row[i + 1];
        }
    }
    row[0]
}

/// The row of a place: poles that are rows themselves, mixed.
fn mixed(poles: &[Vec<f64>], t: f64) -> Vec<f64> {
    (0..ORDER).map(|k| value(&poles.iter().map(|row| row[k]).collect::<Vec<_>>(), t)).collect()
}
