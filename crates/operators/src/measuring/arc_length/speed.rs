//! The speed of a curve on a window, integrated by Gauss with a bound of the error.

use pforms_kernel::{Form, Result, Scaled, taylor_rows};

use crate::algebra::stretch;
use crate::measuring::vector::norm;

/// Nodes and weights of the 16-point rule of Gauss on `[−1, 1]`, the positive half.
const GAUSS: [[f64; 2]; 8] = [
    [0.095_012_509_837_637_44, 0.189_450_610_455_068_64],
    [0.281_603_550_779_258_9, 0.182_603_415_044_923_64],
    [0.458_016_777_657_227_39, 0.169_156_519_395_002_65],
    [0.617_876_244_402_643_8, 0.149_595_988_816_576_7],
    [0.755_404_408_355_003, 0.124_628_971_255_534_07],
    [0.865_631_202_387_831_8, 0.095_158_511_682_492_6],
    [0.944_575_023_073_232_6, 0.062_253_523_938_647_456],
    [0.989_400_934_991_649_9, 0.027_152_459_411_754_176],
];

/// Radii of the discs in which the speed is shown to be analytic, in units of half the window.
const RADII: [f64; 9] = [4.0, 3.0, 2.5, 2.2, 2.0, 1.8, 1.65, 1.5, 1.35];

/// The speed of a piece of curve over its own window `[0, 1]`.
#[derive(Clone, Debug)]
pub(crate) struct Speed {
    /// `N = X'·W − X·W'` beside `W`, as a form: the speed is `|N|/W²`.
    quotient: Form,
    /// Distances from pole to pole, and from end to end, where all weights have one sign.
    polygon: Option<[f64; 2]>,
}

impl Speed {
    /// The speed on the window `[from, to]` of a piece.
    pub(crate) fn of(piece: &Form, from: f64, to: f64) -> Result<Self> {
        let local =
            if from == 0.0 && to == 1.0 { piece.clone() } else { stretch(piece, &[from], &[to])? };
        let local = seen_from_its_start(&local)?;
        Ok(Self { quotient: quotient(&local)?, polygon: polygon(&local) })
    }

    /// The speed at a parameter.
    pub(crate) fn at(&self, t: f64) -> Result<f64> {
        let mut point = self.quotient.homogeneous_at(&[t])?;
        let weight = point.pop().unwrap_or(1.0);
        Ok(norm(&point) / (weight * weight))
    }

    /// The 16-point rule over `[from, to]`.
    pub(crate) fn integral(&self, from: f64, to: f64) -> Result<f64> {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let mut sum = 0.0;
        for [node, weight] in GAUSS {
            sum += weight * (self.at(middle - half * node)? + self.at(middle + half * node)?);
        }
        Ok(half * sum)
    }

    /// A bound of the error of [`Speed::integral`] over `[0, 1]` or any part of it, if there is a
    /// disc around the window in which neither `N·N` nor `W` can vanish.
    ///
    /// Taylor's coefficients at the middle bound both in a disc of radius `R` (in halves of the
    /// window). The speed is analytic there, so in the ellipse of Bernstein with
    /// `ρ = R + √(R² − 1)`, and 16 points are off by at most `64/15·M·ρ⁻³⁰/(1 − ρ⁻²)`
    /// (Trefethen, *Approximation Theory and Approximation Practice*, theorem 19.3).
    pub(super) fn bound(&self) -> Result<Option<f64>> {
        let degree = self.quotient.orders()[0] - 1;
        let series = self.quotient.along(0, &taylor_rows(degree, degree, &0.5))?;
        let ambient = self.quotient.ambient();
        let coefficient = |k: usize, axis: usize| {
            series.homogeneous()[k * (ambient + 1) + axis] * 0.5_f64.powi(k as i32)
        };
        let mut square = vec![0.0; 2 * degree + 1];
        for axis in 0..ambient {
            for i in 0..=degree {
                for j in 0..=degree {
                    square[i + j] += coefficient(i, axis) * coefficient(j, axis);
                }
            }
        }
        let weight: Vec<f64> = (0..=degree).map(|k| coefficient(k, ambient)).collect();
        let bounds = RADII.into_iter().filter_map(|radius| {
            let most = beyond_zero(&square, radius)?.1.sqrt();
            let least = beyond_zero(&weight, radius)?.0;
            let rho = radius + (radius * radius - 1.0).sqrt();
            let rule = 64.0 / 15.0 * rho.powi(-30) / (1.0 - rho.powi(-2));
            Some(0.5 * rule * most / (least * least))
        });
        Ok(bounds.reduce(f64::min))
    }

    /// The distance of the ends and the length of the control polygon: the length lies between.
    ///
    /// A plane meets the curve no more often than its polygon, and lengths are means of such counts
    /// (Crofton); so it needs weights of one sign.
    pub(super) fn polygon(&self) -> Option<[f64; 2]> {
        self.polygon
    }
}

/// The least and largest modulus of a series in a disc, unless it might vanish there.
fn beyond_zero(series: &[f64], radius: f64) -> Option<(f64, f64)> {
    /// What is left of the first coefficient may be no smaller.
    const KEPT: f64 = 0.05;
    let first = series[0].abs();
    let rest = series[1..].iter().rev().fold(0.0, |sum, c| (sum + c.abs()) * radius);
    (first > 0.0 && rest <= (1.0 - KEPT) * first).then_some((first - rest, first + rest))
}

/// The curve moved so that it starts at the origin, its largest weight near 1.
fn seen_from_its_start(curve: &Form) -> Result<Form> {
    let (ambient, width) = (curve.ambient(), curve.width());
    let poles = curve.homogeneous().chunks_exact(width);
    let heaviest =
        poles.clone().map(|pole| pole[ambient]).max_by(|a, b| a.abs().total_cmp(&b.abs()));
    let unit = match heaviest {
        Some(weight) if weight != 0.0 => weight,
        _ => 1.0,
    };
    let first = &curve.homogeneous()[..width];
    let mut moved = Vec::with_capacity(curve.homogeneous().len());
    for pole in poles {
        let weight = pole[ambient] / unit;
        moved.extend((0..ambient).map(|axis| {
            let start = if first[ambient] == 0.0 { 0.0 } else { first[axis] / first[ambient] };
            pole[axis] / unit - start * weight
        }));
        moved.push(weight);
    }
    Form::from_homogeneous(curve.orders(), ambient, moved)
}

fn quotient(curve: &Form) -> Result<Form> {
    let (all, ambient) = (Scaled::from_form(curve), curve.ambient());
    if curve.orders()[0] == 1 {
        return Form::from_points(&[1], ambient, &vec![0.0; ambient], None);
    }
    let (points, weight) = (all.truncated(ambient), all.component(ambient));
    if !curve.is_rational() {
        let slope = points.derivative(0);
        return slope.beside(&Scaled::one(slope.degrees())?).into_form();
    }
    let slope = points.derivative(0).times(&weight)?;
    let numerator = slope.minus(&points.times(&weight.derivative(0))?);
    let weight = weight.raised_to(numerator.degrees())?;
    numerator.beside(&weight).into_form()
}

fn polygon(curve: &Form) -> Option<[f64; 2]> {
    let weights = curve.weights();
    if !weights.iter().all(|w| *w > 0.0) && !weights.iter().all(|w| *w < 0.0) {
        return None;
    }
    let points = curve.points().ok()?;
    let ambient = curve.ambient();
    let apart =
        |a: &[f64], b: &[f64]| norm(&a.iter().zip(b).map(|(x, y)| x - y).collect::<Vec<_>>());
    let poles: Vec<&[f64]> = points.chunks_exact(ambient).collect();
    let along = poles.windows(2).map(|pair| apart(pair[0], pair[1])).sum();
    Some([apart(poles[0], poles[poles.len() - 1]), along])
}
