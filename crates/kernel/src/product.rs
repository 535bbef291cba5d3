//! Multiply: products of Bernstein polynomials, in the basis where they are convolutions.

use smallvec::{SmallVec, smallvec};

use crate::{Binomials, Error, Form, Result, Scalar, limit};

/// A polynomial with any number of variables and `width` components in the *scaled* Bernstein
/// basis: coefficient `i` is the pole times `C(n, i)` along every axis.
///
/// In this basis a product is a plain convolution of coefficients. Nothing is subtracted that
/// the poles do not subtract, so products of degree 27 and more keep their poles to a few
/// roundings (Farouki and Rajan, *Algorithms for polynomials in Bernstein form*, 1988;
/// Sánchez-Reyes, *Algebraic manipulation in the Bernstein form made simple via convolutions*, 2003).
#[derive(Clone, Debug, PartialEq)]
pub struct Scaled<S = f64> {
    degrees: Each,
    width: usize,
    coefficients: SmallVec<[S; 32]>,
}

/// One number for each axis.
type Each = SmallVec<[usize; 4]>;

impl<S: Scalar> Scaled<S> {
    /// The zero polynomial of these degrees, with `width` components.
    ///
    /// Errors: `Limit` above the cap, `Accuracy` where binomials overflow.
    pub fn zero(degrees: &[usize], width: usize) -> Result<Self> {
        let orders: Each = degrees.iter().map(|degree| degree + 1).collect();
        let count = limit::check::<S>("the product", &orders, width)?;
        require_degrees::<S>(degrees)?;
        let coefficients = smallvec![S::zero(); count];
        Ok(Self { degrees: degrees.into(), width, coefficients })
    }

    /// The homogeneous coordinates of a form, all its `ambient + 1` components.
    pub fn from_form(form: &Form<S>) -> Self {
        let mut scaled = Self {
            degrees: form.orders().iter().map(|order| order - 1).collect(),
            width: form.width(),
            coefficients: form.homogeneous().into(),
        };
        scaled.rescale(|pole, binomial| pole * binomial);
        scaled
    }

    /// The constant 1, as a polynomial of the given degrees.
    ///
    /// Errors: `Limit` above the cap.
    pub fn one(degrees: &[usize]) -> Result<Self> {
        let mut scaled = Self::zero(degrees, 1)?;
        scaled.coefficients.fill(S::one());
        scaled.rescale(|pole, binomial| pole * binomial);
        Ok(scaled)
    }

    /// A polynomial of degree 0 along each of `axes` axes: one coefficient of several components.
    pub fn constant(axes: usize, components: &[S]) -> Self {
        Self {
            degrees: smallvec![0; axes],
            width: components.len(),
            coefficients: components.into(),
        }
    }

    /// Degree along each axis.
    pub fn degrees(&self) -> &[usize] {
        &self.degrees
    }

    /// Number of components.
    pub fn width(&self) -> usize {
        self.width
    }

    /// All coefficients, in C order, the components of each side by side.
    pub fn coefficients(&self) -> &[S] {
        &self.coefficients
    }

    /// The same, to be changed.
    pub fn coefficients_mut(&mut self) -> &mut [S] {
        &mut self.coefficients
    }

    /// Component `k` alone.
    #[must_use]
    pub fn component(&self, k: usize) -> Self {
        let every = self.coefficients.chunks_exact(self.width);
        Self {
            degrees: self.degrees.clone(),
            width: 1,
            coefficients: every.map(|pole| pole[k].clone()).collect(),
        }
    }

    /// `self + factor·other`, both of the same degrees and width.
    pub fn add_multiple(&mut self, factor: &S, other: &Self) {
        debug_assert!(self.degrees == other.degrees && self.width == other.width);
        S::add_multiple(&mut self.coefficients, factor, &other.coefficients);
    }

    /// `self += a·b`, where `b` has a single component and the degrees of `a` and `b` add up to
    /// those of `self`.
    pub fn add_product(&mut self, a: &Self, b: &Self) {
        debug_assert!(b.width == 1 && a.width == self.width);
        let strides = self.strides();
        let run = a.degrees.last().map_or(1, |degree| degree + 1) * a.width;
        let outer = a.degrees.len().saturating_sub(1);
        let starts = offsets(&a.degrees[..outer], &strides);
        let shifts = offsets(&b.degrees, &strides);
        for (factor, shift) in b.coefficients.iter().zip(&shifts) {
            if factor.is_zero() {
                continue;
            }
            for (line, start) in a.coefficients.chunks_exact(run).zip(&starts) {
                let target = &mut self.coefficients[shift + start..][..run];
                S::add_multiple(target, factor, line);
            }
        }
    }

    /// The product of `self` and a polynomial of one component.
    ///
    /// Errors: `Shape` when the axes differ, `Limit` above the cap.
    pub fn times(&self, factor: &Self) -> Result<Self> {
        if self.degrees.len() != factor.degrees.len() || factor.width != 1 {
            return Err(Error::shape(
                "factor",
                format!("{} axes, {} components", factor.degrees.len(), factor.width),
                format!("{} axes and a single component", self.degrees.len()),
            ));
        }
        let sums = self.degrees.iter().zip(&factor.degrees);
        let degrees: Each = sums.map(|(a, b)| a + b).collect();
        let mut product = Self::zero(&degrees, self.width)?;
        product.add_product(self, factor);
        Ok(product)
    }

    /// The same polynomial written with higher degrees: a product with 1.
    ///
    /// Errors: `Shape` when a degree would fall, `Limit` above the cap.
    pub fn raised_to(&self, degrees: &[usize]) -> Result<Self> {
        let gaps: Option<Each> =
            degrees.iter().zip(&self.degrees).map(|(to, from)| to.checked_sub(*from)).collect();
        match gaps {
            Some(gaps) if gaps.len() == self.degrees.len() => {
                if gaps.iter().all(|&gap| gap == 0) {
                    return Ok(self.clone());
                }
                self.times(&Self::one(&gaps)?)
            }
            _ => Err(Error::shape(
                "degrees",
                format!("{degrees:?}"),
                format!("at least {:?}", self.degrees),
            )),
        }
    }

    /// The derivative along `axis`, of one degree less (0 stays 0).
    #[must_use]
    pub fn derivative(&self, axis: usize) -> Self {
        let degree = self.degrees[axis];
        let mut degrees = self.degrees.clone();
        degrees[axis] = degree.saturating_sub(1);
        let inner = self.strides()[axis];
        let mut coefficients = SmallVec::with_capacity(self.coefficients.len());
        for block in self.coefficients.chunks_exact(inner * (degree + 1)) {
            if degree == 0 {
                coefficients.resize(coefficients.len() + inner, S::zero());
            }
            for i in 0..degree {
                let (left, right) = (S::from_integer((degree - i) as i64), i as i64 + 1);
                let lines = block[i * inner..].iter().zip(&block[(i + 1) * inner..]);
                coefficients.extend(
                    lines.take(inner).map(|(a, b)| {
                        S::from_integer(right) * b.clone() - left.clone() * a.clone()
                    }),
                );
            }
        }
        Self { degrees, width: self.width, coefficients }
    }

    /// The components of `self` followed by those of `other`, of the same degrees.
    #[must_use]
    pub fn beside(&self, other: &Self) -> Self {
        debug_assert!(self.degrees == other.degrees);
        let poles = self.coefficients.chunks_exact(self.width);
        let others = other.coefficients.chunks_exact(other.width);
        Self {
            degrees: self.degrees.clone(),
            width: self.width + other.width,
            coefficients: poles.zip(others).flat_map(|(a, b)| a.iter().chain(b).cloned()).collect(),
        }
    }

    /// The first `count` components alone.
    #[must_use]
    pub fn truncated(&self, count: usize) -> Self {
        let poles = self.coefficients.chunks_exact(self.width);
        Self {
            degrees: self.degrees.clone(),
            width: count,
            coefficients: poles.flat_map(|pole| pole[..count].iter().cloned()).collect(),
        }
    }

    /// The difference `self − other`, both of the same degrees and width.
    #[must_use]
    pub fn minus(mut self, other: &Self) -> Self {
        self.add_multiple(&-S::one(), other);
        self
    }

    /// Back to poles: the components are homogeneous coordinates, the weight last.
    ///
    /// Errors: `Shape` with fewer than two components, `Domain` when a number overflowed.
    pub fn into_form(mut self) -> Result<Form<S>> {
        if self.width < 2 {
            return Err(Error::shape(
                "components",
                self.width,
                "a coordinate and a weight at least",
            ));
        }
        require_degrees::<S>(&self.degrees)?;
        self.rescale(|scaled, binomial| scaled / binomial);
        let orders: Each = self.degrees.iter().map(|degree| degree + 1).collect();
        Form::from_homogeneous(&orders, self.width - 1, self.coefficients.into_vec())
    }

    /// Distance in the array between neighbours along each axis.
    fn strides(&self) -> Each {
        let mut step = self.width;
        let mut strides: Each = self
            .degrees
            .iter()
            .rev()
            .map(|degree| {
                let stride = step;
                step *= degree + 1;
                stride
            })
            .collect();
        strides.reverse();
        strides
    }

    /// Applies `change(coefficient, C(n, i))` along every axis.
    fn rescale(&mut self, change: impl Fn(S, S) -> S) {
        let mut inner = self.width;
        for &degree in self.degrees.iter().rev() {
            let row = Binomials::<S>::of(degree);
            for block in self.coefficients.chunks_exact_mut(inner * (degree + 1)) {
                for (line, binomial) in block.chunks_exact_mut(inner).zip(row.iter()) {
                    for x in line {
                        *x = change(x.clone(), binomial.clone());
                    }
                }
            }
            inner *= degree + 1;
        }
    }
}

fn require_degrees<S: Scalar>(degrees: &[usize]) -> Result<()> {
    degrees.iter().try_for_each(|&degree| limit::check_degree::<S>(degree))
}

/// Position of every index `(i₀, i₁, …)`, each up to its degree, in an array of these strides.
fn offsets(degrees: &[usize], strides: &[usize]) -> SmallVec<[usize; 32]> {
    let mut positions = smallvec![0];
    for (degree, stride) in degrees.iter().zip(strides) {
        let known: SmallVec<[usize; 32]> = std::mem::take(&mut positions);
        let shifted = |start: usize| (0..=*degree).map(move |i| start + i * stride);
        positions.extend(known.into_iter().flat_map(shifted));
    }
    positions
}
