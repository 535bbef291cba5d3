//! Value and slopes of `X − x·W`, which vanish where the cage takes the point `x`.

use pforms_kernel::bernstein_row;

use super::cage::Cage;

/// One place after another, in any number of axes.
pub(super) struct Jet {
    /// `X − x·W`.
    pub value: Vec<f64>,
    /// Its derivatives, `[coordinate][axis]`.
    pub slopes: Vec<f64>,
    /// The weight.
    pub weight: f64,
}

impl Jet {
    pub(super) fn new(cage: &Cage) -> Self {
        let axes = cage.axes();
        Self { value: vec![0.0; axes], slopes: vec![0.0; axes * axes], weight: 1.0 }
    }

    /// Moves to other parameters of a piece.
    pub(super) fn at(&mut self, cage: &Cage, poles: &[f64], at: &[f64], point: &[f64]) {
        let axes = cage.axes();
        let rows: Vec<[Vec<f64>; 2]> =
            at.iter().zip(&cage.orders).map(|(t, n)| rows(*n, *t)).collect();
        let mut sums = vec![0.0; cage.width];
        self.weight = 1.0;
        // The last round is the value; those before it are the slopes.
        for along in 0..=axes {
            contract(poles, &rows, along, &mut sums);
            let weight = sums.get(axes).copied().unwrap_or(if along == axes { 1.0 } else { 0.0 });
            for c in 0..axes {
                let sum = sums[c] - point[c] * weight;
                if along < axes {
                    self.slopes[c * axes + along] = sum;
                } else {
                    self.value[c] = sum;
                }
            }
            if along == axes {
                self.weight = weight;
            }
        }
    }
}

/// The Bernstein polynomials and their derivatives.
fn rows(order: usize, t: f64) -> [Vec<f64>; 2] {
    let values = bernstein_row(order - 1, &t);
    let mut slopes = vec![0.0; order];
    if order > 1 {
        let factor = (order - 1) as f64;
        for (j, x) in bernstein_row(order - 2, &t).iter().enumerate() {
            slopes[j] -= factor * x;
            slopes[j + 1] += factor * x;
        }
    }
    [values, slopes]
}

/// Sums of the poles with the values, and with the derivatives along one axis.
fn contract(poles: &[f64], rows: &[[Vec<f64>; 2]], along: usize, sums: &mut [f64]) {
    let mut poles = poles.to_vec();
    for (axis, row) in rows.iter().enumerate() {
        let row = &row[usize::from(axis == along)];
        let share = poles.len() / row.len();
        let mut sum = vec![0.0; share];
        for (factor, line) in row.iter().zip(poles.chunks_exact(share)) {
            for (sum, x) in sum.iter_mut().zip(line) {
                *sum += factor * x;
            }
        }
        poles = sum;
    }
    sums.copy_from_slice(&poles);
}
