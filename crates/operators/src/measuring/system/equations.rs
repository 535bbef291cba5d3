//! Polynomials over the unit box, brought to common degrees, with what their rounding may be.

use pforms_kernel::{Error, Form, Result, bernstein_row, limit};

use super::{Each, MOST_UNKNOWNS};

/// A polynomial in Bernstein form over the unit box.
#[derive(Clone, Debug)]
pub(crate) struct Polynomial {
    /// Coefficients along each axis.
    pub orders: Vec<usize>,
    /// The coefficients, the last axis fastest.
    pub coefficients: Vec<f64>,
    /// No coefficient is wrong by more.
    pub noise: f64,
}

/// Equations `F_i(u) = 0` in the same unknowns, of the same degrees, the largest coefficients near 1.
#[derive(Clone, Debug)]
pub(crate) struct Equations {
    orders: Vec<usize>,
    number: usize,
    count: usize,
    coefficients: Vec<f64>,
    noise: Vec<f64>,
    tolerance: Vec<f64>,
    units: Vec<f64>,
}

impl Equations {
    /// A system of at least as many equations as unknowns.
    ///
    /// Errors: `Shape` when they differ in axes, are fewer than these, or have none or more than
    /// four; `Domain` when a coefficient is not finite; `Limit` above the cap.
    pub(crate) fn new(polynomials: Vec<Polynomial>) -> Result<Self> {
        let axes = polynomials.first().map_or(0, |first| first.orders.len());
        let number = polynomials.len();
        let fits = polynomials.iter().all(|polynomial| polynomial.orders.len() == axes);
        if !fits || axes == 0 || axes > MOST_UNKNOWNS || number < axes {
            let received = format!("{number} equations in {axes} unknowns");
            let expected = "1 to 4 unknowns and as many equations or more";
            return Err(Error::shape("equations", received, expected));
        }
        // At least linear along each axis, so that every unknown counts.
        let mut orders = vec![2; axes];
        for polynomial in &polynomials {
            for (most, order) in orders.iter_mut().zip(&polynomial.orders) {
                *most = (*most).max(*order);
            }
        }
        let count = limit::check::<f64>("the equations", &orders, number)? / number;
        let mut all = Self {
            number,
            count,
            coefficients: Vec::with_capacity(count * number),
            noise: Vec::with_capacity(number),
            tolerance: vec![0.0; number],
            units: Vec::with_capacity(number),
            orders,
        };
        for polynomial in polynomials {
            all.push(polynomial)?;
        }
        Ok(all)
    }

    /// The equations of the points that two forms have in common, in the parameters of the first and
    /// then of the second: `X(u)·V(v) − Y(v)·W(u) = 0` for each coordinate of `X/W` and `Y/V`.
    ///
    /// Poles are taken as exact. Scale the forms first: their products must not overflow.
    ///
    /// Errors: `Shape` when their spaces differ in dimension; otherwise as [`Equations::new`].
    pub(crate) fn meeting(a: &Form, b: &Form) -> Result<Self> {
        if a.ambient() != b.ambient() {
            let received = format!("forms in dimensions {} and {}", a.ambient(), b.ambient());
            return Err(Error::shape("forms", received, "forms in one space"));
        }
        let ambient = a.ambient();
        let orders = [a.orders(), b.orders()].concat();
        limit::check::<f64>("the equations", &orders, ambient)?;
        let difference = |k: usize| {
            let mut noise = 0.0_f64;
            let mut coefficients = Vec::with_capacity(a.pole_count() * b.pole_count());
            for p in a.homogeneous().chunks_exact(ambient + 1) {
                for q in b.homogeneous().chunks_exact(ambient + 1) {
                    let (left, right) = (p[k] * q[ambient], q[k] * p[ambient]);
                    // A product with 1 is exact.
                    let of_products = if q[ambient] == 1.0 { 0.0 } else { left.abs() }
                        + if p[ambient] == 1.0 { 0.0 } else { right.abs() };
                    coefficients.push(left - right);
                    noise = noise.max(of_products + (left - right).abs());
                }
            }
            Polynomial { orders: orders.clone(), coefficients, noise: 0.5 * f64::EPSILON * noise }
        };
        Self::new((0..ambient).map(difference).collect())
    }

    /// The same equations, each solved where it is no larger than this, in the units it was given in.
    ///
    /// Only of use with more equations than unknowns, which rounding leaves without a solution.
    #[must_use]
    pub(crate) fn with_tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = self.units.iter().map(|unit| tolerance / unit).collect();
        self
    }

    fn push(&mut self, polynomial: Polynomial) -> Result<()> {
        let Polynomial { orders, mut coefficients, mut noise } = polynomial;
        if coefficients.len() != orders.iter().product::<usize>() {
            let received = format!("{} coefficients", coefficients.len());
            return Err(Error::shape("equations", received, format!("those of orders {orders:?}")));
        }
        let size = coefficients.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if !(size.is_finite() && noise.is_finite() && coefficients.iter().all(|x| x.is_finite())) {
            return Err(Error::domain("equations", "a coefficient that overflows", "finite ones"));
        }
        let mut orders = orders;
        for (axis, target) in self.orders.clone().into_iter().enumerate() {
            while orders[axis] < target {
                coefficients = elevated(&coefficients, &orders, axis);
                orders[axis] += 1;
                noise += f64::EPSILON * size;
            }
        }
        let scale = size.max(noise);
        let unit = if scale > 0.0 { libm::ldexp(1.0, libm::ilogb(scale)) } else { 1.0 };
        self.coefficients.extend(coefficients.iter().map(|x| x / unit));
        // Division by the unit may underflow, by less than the smallest number.
        self.noise.push(noise / unit + f64::MIN_POSITIVE);
        self.units.push(unit);
        Ok(())
    }

    pub(crate) fn axes(&self) -> usize {
        self.orders.len()
    }

    pub(crate) fn number(&self) -> usize {
        self.number
    }

    /// Coefficients of one equation.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    pub(crate) fn orders(&self) -> &[usize] {
        &self.orders
    }

    pub(super) fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    pub(super) fn noise(&self) -> &[f64] {
        &self.noise
    }

    pub(super) fn tolerance(&self) -> &[f64] {
        &self.tolerance
    }

    /// The largest of values of the equations, in the units they were given in.
    pub(super) fn residual(&self, values: &[f64]) -> f64 {
        values.iter().zip(&self.units).fold(0.0, |most, (x, unit)| most.max(x.abs() * unit))
    }

    /// How far rounding may put [`Equations::jet`]'s values off, the noise of the coefficients included.
    pub(super) fn noise_of_values(&self, equation: usize) -> f64 {
        let degrees: usize = self.orders.iter().map(|order| order - 1).sum();
        // Each row is right to 2·degree roundings, each sum to as many as its terms, of values below 2.
        let roundings = 3 * degrees + 2 * self.axes();
        self.noise[equation] + f64::EPSILON * roundings as f64
    }

    /// The derivatives at a place, in the units the equations were given in: a row for each.
    pub(crate) fn slopes(&self, at: &[f64]) -> Vec<f64> {
        let mut place = [0.0; MOST_UNKNOWNS];
        place[..at.len()].copy_from_slice(at);
        let rows = self.jet(&place).1.into_iter().zip(&self.units);
        rows.flat_map(|(row, unit)| row.map(|x| x * unit).into_iter().take(at.len())).collect()
    }

    /// The value of each equation at a place, and by how much it may be off if the place is by
    /// `radius`.
    pub(crate) fn rates(&self, at: &[f64], radius: f64) -> Vec<(f64, f64)> {
        let mut place = [0.0; MOST_UNKNOWNS];
        place[..at.len()].copy_from_slice(at);
        let (values, slopes) = self.jet(&place);
        let reach = |row: &Each| 2.0 * radius * row.iter().map(|x| x.abs()).sum::<f64>();
        let each = values.into_iter().zip(&slopes).enumerate();
        each.map(|(i, (value, row))| (value, self.noise_of_values(i) + reach(row))).collect()
    }

    /// A bound of the greatest value of one equation, times `sign`, over a box.
    pub(crate) fn greatest(&self, equation: usize, sign: f64, lower: &[f64], upper: &[f64]) -> f64 {
        let mut cell = super::cell::Cell::whole(self, 0.0);
        for axis in 0..self.axes() {
            if upper[axis] > lower[axis] {
                cell.restrict(axis, lower[axis], upper[axis]);
            } else {
                // Nearly no side; the ends themselves are exact.
                let (from, to) = if lower[axis] > 0.5 { (1.0 - 1e-12, 1.0) } else { (0.0, 1e-12) };
                cell.restrict(axis, lower[axis].min(from), lower[axis].max(to).min(1.0));
            }
        }
        let values = cell.each().nth(equation).unwrap_or(&[]);
        let most = values.iter().fold(f64::NEG_INFINITY, |most, x| most.max(sign * x));
        most + cell.noise[equation]
    }

    /// Values of the equations, and their derivatives, equation by equation.
    pub(super) fn jet(&self, at: &Each) -> (Vec<f64>, Vec<Each>) {
        let axes = self.axes();
        let mut values = vec![0.0; self.number];
        let mut slopes = vec![[0.0; MOST_UNKNOWNS]; self.number];
        let rows: Vec<(Vec<f64>, Vec<f64>)> =
            self.orders.iter().zip(at).map(|(order, t)| rows(order - 1, *t)).collect();
        for (i, part) in self.coefficients.chunks_exact(self.count).enumerate() {
            // The value, then the derivatives along the axes summed so far, the last first.
            let mut sums = vec![part.to_vec()];
            for (row, slope) in rows.iter().rev() {
                let inner = &sums[0];
                let newest = contracted(inner, slope);
                for sum in &mut sums {
                    *sum = contracted(sum, row);
                }
                sums.push(newest);
            }
            values[i] = sums[0][0];
            for (k, sum) in sums[1..].iter().enumerate() {
                slopes[i][axes - 1 - k] = sum[0];
            }
        }
        (values, slopes)
    }
}

/// The Bernstein polynomials of a degree at `t`, and their derivatives.
fn rows(degree: usize, t: f64) -> (Vec<f64>, Vec<f64>) {
    let below = bernstein_row(degree - 1, &t);
    let mut row = vec![0.0; degree + 1];
    let mut slope = vec![0.0; degree + 1];
    for (i, b) in below.iter().enumerate() {
        row[i] += (1.0 - t) * b;
        row[i + 1] += t * b;
        slope[i] -= degree as f64 * b;
        slope[i + 1] += degree as f64 * b;
    }
    (row, slope)
}

/// Lines of numbers, the length of `row`, each summed with its weights.
fn contracted(numbers: &[f64], row: &[f64]) -> Vec<f64> {
    let sum = |line: &[f64]| line.iter().zip(row).map(|(x, b)| x * b).sum();
    numbers.chunks_exact(row.len()).map(sum).collect()
}

/// One degree more along an axis.
fn elevated(coefficients: &[f64], orders: &[usize], axis: usize) -> Vec<f64> {
    let (order, inner) = (orders[axis], orders[axis + 1..].iter().product::<usize>());
    let mut raised = Vec::with_capacity(coefficients.len() / order * (order + 1));
    for block in coefficients.chunks_exact(order * inner) {
        for i in 0..=order {
            let share = i as f64 / order as f64;
            for k in 0..inner {
                let before = if i > 0 { block[(i - 1) * inner + k] } else { 0.0 };
                let here = if i < order { block[i * inner + k] } else { 0.0 };
                raised.push(share * before + (1.0 - share) * here);
            }
        }
    }
    raised
}
