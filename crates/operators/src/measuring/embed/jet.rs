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
    /// The sums so far: with the values, then with the derivatives along each axis.
    sums: Vec<Vec<f64>>,
    room: Vec<f64>,
}

impl Jet {
    pub(super) fn new(cage: &Cage) -> Self {
        let axes = cage.axes();
        Self {
            value: vec![0.0; axes],
            slopes: vec![0.0; axes * axes],
            weight: 1.0,
            sums: vec![Vec::new(); axes + 1],
            room: Vec::new(),
        }
    }

    /// Moves to other parameters of a piece.
    pub(super) fn at(&mut self, cage: &Cage, poles: &[f64], at: &[f64], point: &[f64]) {
        let axes = cage.axes();
        self.sums[0].clear();
        self.sums[0].extend_from_slice(poles);
        for (axis, (t, order)) in at.iter().zip(&cage.orders).enumerate() {
            let (values, slopes) = rows(*order, *t);
            let (known, new) = self.sums.split_at_mut(axis + 1);
            contract(&known[0], &slopes, &mut new[0]);
            for sum in known {
                contract(sum, &values, &mut self.room);
                std::mem::swap(sum, &mut self.room);
            }
        }
        self.weight = self.sums[0].get(axes).copied().unwrap_or(1.0);
        for c in 0..axes {
            self.value[c] = self.sums[0][c] - point[c] * self.weight;
            for (axis, sum) in self.sums[1..].iter().enumerate() {
                let weight = sum.get(axes).copied().unwrap_or(0.0);
                self.slopes[c * axes + axis] = sum[c] - point[c] * weight;
            }
        }
    }
}

/// The Bernstein polynomials and their derivatives.
fn rows(order: usize, t: f64) -> (Vec<f64>, Vec<f64>) {
    let below = bernstein_row(order.saturating_sub(2), &t);
    let (mut values, mut slopes) = (vec![0.0; order], vec![0.0; order]);
    let degree = (order - 1) as f64;
    for (j, x) in below.iter().enumerate().take(order - 1) {
        values[j] += (1.0 - t) * x;
        values[j + 1] += t * x;
        slopes[j] -= degree * x;
        slopes[j + 1] += degree * x;
    }
    (values, slopes)
}

/// Sums of the lines along the first axis.
fn contract(poles: &[f64], row: &[f64], sum: &mut Vec<f64>) {
    let share = poles.len() / row.len();
    sum.clear();
    sum.resize(share, 0.0);
    for (factor, line) in row.iter().zip(poles.chunks_exact(share)) {
        for (sum, x) in sum.iter_mut().zip(line) {
            *sum += factor * x;
        }
    }
}
