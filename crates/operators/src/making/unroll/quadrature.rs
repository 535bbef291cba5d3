//! Integrals between the nodes of one interval.

use pforms_kernel::{Form, Result};

use crate::{Nodes, interpolate};

/// Poles of the polynomials that a surface is laid out in, along each axis.
pub(super) const ORDER: usize = 13;

/// Lobatto's nodes on an interval from 0 to 1, and the integrals up to each of them.
pub(super) struct Quadrature {
    pub nodes: Vec<f64>,
    /// Row `i`: what the value at each node adds to the integral from 0 to node `i`.
    rows: Vec<Vec<f64>>,
}

impl Quadrature {
    pub(super) fn new() -> Result<Self> {
        let nodes = Nodes::<f64>::Lobatto.on_axis(0, ORDER)?;
        let mut rows = vec![vec![0.0; ORDER]; ORDER];
        for k in 0..ORDER {
            let mut values = vec![0.0; ORDER];
            values[k] = 1.0;
            let hat =
                interpolate(&Form::from_points(&[ORDER], 1, &values, None)?, &Nodes::Lobatto)?;
            let mut poles = vec![0.0];
            let mut sum = 0.0;
            for pole in hat.points()? {
                sum += pole / ORDER as f64;
                poles.push(sum);
            }
            let integral = Form::from_points(&[ORDER + 1], 1, &poles, None)?;
            for (row, value) in rows.iter_mut().zip(integral.grid(&[&nodes])?) {
                row[k] = value;
            }
        }
        Ok(Self { nodes, rows })
    }

    /// The integral of a function from node `from` to every node.
    pub(super) fn integrals(&self, values: &[f64], from: usize) -> Vec<f64> {
        let whole: Vec<f64> =
            self.rows.iter().map(|row| crate::measuring::vector::dot(row, values)).collect();
        whole.iter().map(|value| value - whole[from]).collect()
    }
}
