//! How the distance changes around a foot.

use crate::measuring::system::Equations;

/// How the distance changes around a foot, along the axes that are free there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FootKind {
    /// It grows: a local nearest point.
    Minimum,
    /// It falls along every axis.
    Maximum,
    /// It grows and falls.
    Saddle,
    /// Second derivatives do not tell.
    Flat,
}

impl FootKind {
    /// The name on all faces.
    pub fn name(self) -> &'static str {
        match self {
            Self::Minimum => "minimum",
            Self::Maximum => "maximum",
            Self::Saddle => "saddle",
            Self::Flat => "flat",
        }
    }

    /// By the signs of the pivots of the second derivatives, which are the slopes of the equations.
    pub(super) fn at(equations: &Equations, parameters: &[f64]) -> Self {
        let axes = parameters.len();
        let mut matrix = equations.slopes(parameters);
        let size = matrix.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let mut signs = Vec::with_capacity(axes);
        for k in 0..axes {
            // The largest pivot left on the diagonal; a matrix that has none there is indefinite.
            let best = (k..axes)
                .max_by(|i, j| matrix[i * axes + i].abs().total_cmp(&matrix[j * axes + j].abs()))
                .unwrap_or(k);
            (0..axes).for_each(|j| matrix.swap(k * axes + j, best * axes + j));
            (0..axes).for_each(|i| matrix.swap(i * axes + k, i * axes + best));
            let pivot = matrix[k * axes + k];
            if pivot.abs() <= NOISE * size {
                let rest =
                    (k..axes).any(|i| (k..axes).any(|j| matrix[i * axes + j].abs() > NOISE * size));
                return if rest { Self::Saddle } else { Self::Flat };
            }
            signs.push(pivot > 0.0);
            for i in k + 1..axes {
                let factor = matrix[i * axes + k] / pivot;
                for j in k..axes {
                    matrix[i * axes + j] -= factor * matrix[k * axes + j];
                }
            }
        }
        match (signs.contains(&true), signs.contains(&false)) {
            (true, false) => Self::Minimum,
            (false, true) => Self::Maximum,
            _ => Self::Saddle,
        }
    }
}

/// Second derivatives below this part of the largest are rounding.
const NOISE: f64 = 1e-13;
