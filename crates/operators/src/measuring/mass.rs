//! Centres of mass and tensors of inertia.

use pforms_kernel::{Error, Result};

use super::integral::{Element, Integral, integrate};
use super::measure::{Measure, in_units, pieces, require_alike};
use super::volume::flux;
use crate::algebra::Shape;

/// Measure, centre and inertia of something of density 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Mass {
    /// Its length, area or volume.
    pub measure: Measure,
    /// Its centre.
    pub centroid: Vec<f64>,
    /// By how far the true centre may be from it, along any axis, at most.
    pub centroid_error: f64,
    /// The tensor of inertia about the centre, row by row: `∫ |x|²·1 − x·xᵀ`, in the plane the moments
    /// of area.
    pub inertia: Vec<f64>,
    /// By how much each entry, and each of `moments`, may be wrong at most.
    pub inertia_error: f64,
    /// The moments about the principal axes, the least first.
    pub moments: Vec<f64>,
    /// The principal axes, unit vectors row by row, in the order of their moments.
    pub axes: Vec<f64>,
}

/// The mass of curves, surfaces, volumes of density 1, taken together; or of what closed shells enclose.
///
/// With `filled`, forms with one axis fewer than coordinates are taken for the shell of what they
/// enclose, as [`volume`](super::volume) does; otherwise every form is itself, without sign. Errors are
/// bounded; `accuracy` is relative to the measure, and in sizes of the whole for the centre.
///
/// Errors: those of [`volume`](super::volume) and [`measure`](super::measure); `Degenerate` when
/// there is no mass.
///
/// ```
/// use pforms_operators::{Part, mass, sphere};
/// // Half of a spherical shell: its centre is half way up.
/// let half = sphere(&1.0, Part::Half)?;
/// let shell = mass(&[half], false, 1e-12)?;
/// assert!((shell.centroid[1] - 0.5).abs() <= shell.centroid_error);
/// assert!((shell.measure.value - 2.0 * std::f64::consts::PI).abs() <= shell.measure.error);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn mass(shapes: &[Shape], filled: bool, accuracy: f64) -> Result<Mass> {
    let (axes, ambient) = require_alike(shapes)?;
    if filled && axes + 1 < ambient {
        let received = format!("true for forms of {axes} axes in dimension {ambient}");
        return Err(Error::shape("filled", received, "shells, of an axis fewer than coordinates"));
    }
    let (integral, error, dimension) = if filled && axes + 1 == ambient {
        let (mut integral, through) = flux(shapes, 2, accuracy)?;
        let sign = integral.values[0].signum();
        let parts = |place: usize| match place {
            0 => ambient,
            _ if place <= ambient => ambient + 1,
            _ => ambient + 2,
        };
        for (place, value) in integral.values.iter_mut().enumerate() {
            *value *= sign / parts(place) as f64;
        }
        let error = (integral.error + through) / ambient as f64;
        (integral, error, ambient)
    } else {
        let integral = integrate(&pieces(shapes)?, Element::Size, 2, accuracy)?;
        let error = integral.error;
        (integral, error, axes)
    };
    Central::of(&integral, error, ambient)?.mass(&integral, dimension)
}

/// What something of density 1 adds up to, seen from an origin in units of a length.
#[derive(Clone, Debug, PartialEq)]
pub struct Moments {
    /// Its measure; the integrals of each coordinate, then of each product of two, `xᵢxⱼ` with `i ≤ j`.
    pub values: Vec<f64>,
    /// By how much each of these may be wrong, at most.
    pub error: f64,
    /// The origin, in the unit.
    pub origin: Vec<f64>,
    /// The unit, with which no number here is much larger than 1.
    pub unit: f64,
}

impl Mass {
    /// Centre and inertia from moments of a thing of this dimension (2 for surfaces).
    ///
    /// Errors: `Shape` for a wrong number of moments; `Degenerate` when there is no mass; `Domain`
    /// beyond the largest number.
    pub fn of_moments(moments: Moments, dimension: usize) -> Result<Self> {
        let Moments { values, error, origin, unit } = moments;
        let ambient = origin.len();
        let expected = 1 + ambient + ambient * (ambient + 1) / 2;
        if values.len() != expected {
            return Err(Error::shape("moments", values.len(), expected));
        }
        let integral = Integral { values, error, origin, unit };
        Central::of(&integral, error, ambient)?.mass(&integral, dimension)
    }
}

/// Moments about the centre, in units.
struct Central {
    measure: [f64; 2],
    /// Seen from the origin of the integral.
    centre: Vec<f64>,
    centre_error: f64,
    /// `∫ x·xᵀ`, row by row.
    second: Vec<f64>,
    second_error: f64,
}

impl Central {
    fn of(integral: &Integral, error: f64, ambient: usize) -> Result<Self> {
        let values = &integral.values;
        let mass = values[0];
        if mass <= error {
            return Err(Error::degenerate(
                "shapes",
                format!("a measure of {mass:.1e}, which may be 0"),
                "a length, an area or a volume, for a centre",
            ));
        }
        let centre: Vec<f64> = values[1..=ambient].iter().map(|x| x / mass).collect();
        let far = centre.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let centre_error = error * (1.0 + far) / (mass - error);
        let mut second = vec![0.0; ambient * ambient];
        let mut products = values[1 + ambient..].iter();
        for i in 0..ambient {
            for j in i..ambient {
                let product = products.next().copied().unwrap_or_default();
                let central = product - mass * centre[i] * centre[j];
                second[i * ambient + j] = central;
                second[j * ambient + i] = central;
            }
        }
        // d(∫xᵢxⱼ − m₁m₁/m₀), with m₁/m₀ known to the error of the centre.
        let second_error = error * (1.0 + far) * (1.0 + far) + mass * centre_error * centre_error;
        Ok(Self { measure: [mass, error], centre, centre_error, second, second_error })
    }

    fn mass(self, integral: &Integral, dimension: usize) -> Result<Mass> {
        let ambient = self.centre.len();
        let unit = integral.unit;
        let measure = in_units(self.measure[0], self.measure[1], unit, dimension)?;
        let trace: f64 = (0..ambient).map(|i| self.second[i * ambient + i]).sum();
        let tensor: Vec<f64> = (0..ambient * ambient)
            .map(|k| {
                let diagonal = if k % (ambient + 1) == 0 { trace } else { 0.0 };
                diagonal - self.second[k]
            })
            .collect();
        let error = ambient as f64 * self.second_error;
        let (moments, axes) = principal(&tensor, ambient);
        let scaled = |x: f64| in_units(x, 0.0, unit, dimension + 2).map(|measure| measure.value);
        let all = |list: &[f64]| list.iter().map(|x| scaled(*x)).collect::<Result<Vec<_>>>();
        let pairs = self.centre.iter().zip(&integral.origin);
        Ok(Mass {
            measure,
            centroid: pairs.map(|(x, origin)| (x + origin) * unit).collect(),
            centroid_error: self.centre_error * unit + rounding(&integral.origin) * unit,
            inertia: all(&tensor)?,
            inertia_error: scaled(error)?,
            moments: all(&moments)?,
            axes,
        })
    }
}

/// What adding the origin may round off.
fn rounding(origin: &[f64]) -> f64 {
    f64::EPSILON * origin.iter().fold(0.0_f64, |most, x| most.max(x.abs()))
}

/// Sweeps of Jacobi's rotations; some eight are enough for any matrix.
const SWEEPS: usize = 32;

/// Eigenvalues of a symmetric matrix, the least first, and unit eigenvectors: Jacobi's rotations.
fn principal(matrix: &[f64], size: usize) -> (Vec<f64>, Vec<f64>) {
    let mut a = matrix.to_vec();
    let mut vectors: Vec<f64> =
        (0..size * size).map(|k| if k % (size + 1) == 0 { 1.0 } else { 0.0 }).collect();
    for _ in 0..SWEEPS {
        let mut rotated = false;
        for p in 0..size {
            for q in p + 1..size {
                let (off, diagonal) =
                    (a[p * size + q], a[p * size + p].abs() + a[q * size + q].abs());
                if off.abs() <= f64::EPSILON * 0.25 * diagonal {
                    continue;
                }
                rotated = true;
                let theta = (a[q * size + q] - a[p * size + p]) / (2.0 * off);
                let sign = if theta < 0.0 { -1.0 } else { 1.0 };
                let t = sign / (theta.abs() + (theta * theta + 1.0).sqrt());
                let cosine = 1.0 / (t * t + 1.0).sqrt();
                rotate(&mut a, &mut vectors, size, [p, q], [cosine, t * cosine]);
            }
        }
        if !rotated {
            break;
        }
    }
    let mut order: Vec<usize> = (0..size).collect();
    order.sort_by(|i, j| a[i * size + i].total_cmp(&a[j * size + j]));
    let values = order.iter().map(|i| a[i * size + i]).collect();
    let rows = order.iter().flat_map(|i| {
        let row = &vectors[i * size..(i + 1) * size];
        // The largest coordinate positive, so that the answer does not depend on the way to it.
        let largest =
            row.iter().fold(0.0_f64, |most, x| if x.abs() > most.abs() { *x } else { most });
        row.iter().map(move |x| x * largest.signum())
    });
    (values, rows.collect())
}

/// Rotates rows and columns `p` and `q` of the matrix, and rows of the vectors.
fn rotate(a: &mut [f64], vectors: &mut [f64], size: usize, [p, q]: [usize; 2], [c, s]: [f64; 2]) {
    for k in 0..size {
        let (x, y) = (a[k * size + p], a[k * size + q]);
        (a[k * size + p], a[k * size + q]) = (c * x - s * y, s * x + c * y);
    }
    for k in 0..size {
        let (x, y) = (a[p * size + k], a[q * size + k]);
        (a[p * size + k], a[q * size + k]) = (c * x - s * y, s * x + c * y);
        let (x, y) = (vectors[p * size + k], vectors[q * size + k]);
        (vectors[p * size + k], vectors[q * size + k]) = (c * x - s * y, s * x + c * y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn principal_axes_of_a_known_matrix() {
        // Eigenvalues 1, 3 along the diagonals of the plane, 2 along z.
        let (values, axes) = principal(&[2., 1., 0., 1., 2., 0., 0., 0., 2.], 3);
        assert!(values.iter().zip([1., 2., 3.]).all(|(x, y)| (x - y).abs() < 1e-15));
        let half = 0.5_f64.sqrt();
        assert!((axes[0].abs() - half).abs() < 1e-15 && (axes[0] + axes[1]).abs() < 1e-15);
        assert_eq!(&axes[3..6], [0., 0., 1.]);
    }
}
