//! Numbers that remember how they were computed: derivatives of many results in many sources.

use std::cmp::Ordering;
use std::collections::{BTreeMap, HashMap};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};
use std::sync::Arc;
use std::sync::atomic::{self, AtomicU64};

use smallvec::SmallVec;

use crate::{Error, Result, Scalar, Sparse};

/// A number and the steps that led to it from the sources.
///
/// Running an operator on traced poles gives, exactly, the derivatives of all it computes: forwards
/// as a [`Sparse`] matrix ([`derivatives`]), or backwards in one sweep as the gradient of a weighted
/// sum of results ([`gradient`]). Comparison with `==` looks at the steps too, `<` at the values
/// alone. Griewank and Walther, *Evaluating Derivatives*, 2008, chapters 3 and 4.
///
/// ```
/// use pforms_kernel::{Form, Traced, derivatives};
/// let poles: Vec<Traced> = (0..3).map(|i| Traced::source(i as f64, i)).collect();
/// let parabola = Form::from_points(&[3], 1, &poles, None)?;
/// let point = parabola.at(&[Traced::constant(0.25)])?;
/// assert_eq!(point[0].value(), 0.5);
/// assert_eq!(derivatives(&point, 3)?.entries(), [0.5625, 0.375, 0.0625]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Traced {
    value: f64,
    /// `None`: it depends on no source.
    step: Option<Arc<Step>>,
}

/// A source, or what was computed from earlier steps, with the derivative in each of these.
#[derive(Debug)]
struct Step {
    /// Greater than those of the steps it comes from.
    number: u64,
    source: Option<usize>,
    from: SmallVec<[(f64, Arc<Step>); 2]>,
}

static NUMBERS: AtomicU64 = AtomicU64::new(0);

impl Traced {
    /// A number that does not move.
    pub fn constant(value: f64) -> Self {
        Self { value, step: None }
    }

    /// Source number `index`, with its present value.
    pub fn source(value: f64, index: usize) -> Self {
        Self { value, step: Some(step(Some(index), SmallVec::new())) }
    }

    /// The number itself.
    pub fn value(&self) -> f64 {
        self.value
    }

    /// Does it depend on no source?
    pub fn is_constant(&self) -> bool {
        self.step.is_none()
    }

    /// A function of numbers, from its value and its derivative in each of them.
    #[must_use]
    pub fn function(value: f64, partial: &[(f64, &Self)]) -> Self {
        let from: SmallVec<[(f64, Arc<Step>); 2]> = partial
            .iter()
            .filter_map(|(slope, number)| Some((*slope, Arc::clone(number.step.as_ref()?))))
            .collect();
        let step = match &from[..] {
            [] => None,
            [(1.0, same)] => Some(Arc::clone(same)),
            _ => Some(step(None, from)),
        };
        Self { value, step }
    }
}

fn step(source: Option<usize>, from: SmallVec<[(f64, Arc<Step>); 2]>) -> Arc<Step> {
    Arc::new(Step { number: NUMBERS.fetch_add(1, atomic::Ordering::Relaxed), source, from })
}

/// A long computation is taken down step by step, not by a recursion as deep as it is long.
impl Drop for Step {
    fn drop(&mut self) {
        let mut rest = std::mem::take(&mut self.from);
        while let Some((_, step)) = rest.pop() {
            if let Some(mut step) = Arc::into_inner(step) {
                rest.append(&mut step.from);
            }
        }
    }
}

/// The derivatives of all results in the sources `0` to `sources`: a row for each result, without
/// those that are 0.
///
/// Errors: `Shape` when a source of the results is not among them; `Domain` for a derivative that
/// is not finite.
pub fn derivatives(results: &[Traced], sources: usize) -> Result<Sparse> {
    let mut known: HashMap<u64, BTreeMap<usize, f64>> = HashMap::new();
    for step in history(results).values() {
        let mut row: BTreeMap<usize, f64> =
            step.source.map(|source| (source, 1.0)).into_iter().collect();
        for (slope, earlier) in step.from.iter().filter(|(slope, _)| *slope != 0.0) {
            for (source, derivative) in known.get(&earlier.number).into_iter().flatten() {
                *row.entry(*source).or_default() += slope * derivative;
            }
        }
        known.insert(step.number, row);
    }
    let row = |result: &Traced| {
        let row = result.step.as_ref().and_then(|step| known.get(&step.number));
        let kept = row.into_iter().flatten().filter(|(_, derivative)| **derivative != 0.0);
        kept.map(|(source, derivative)| (*source, *derivative)).collect()
    };
    let rows: Vec<Vec<(usize, f64)>> = results.iter().map(row).collect();
    rows.iter().flatten().try_for_each(|(_, derivative)| require_finite(*derivative))?;
    Sparse::from_rows(sources, rows)
}

/// The derivatives of `Σ weights[i]·results[i]` in the sources `0` to `sources`, in one sweep from
/// the results back to the sources: what it costs does not grow with their number.
///
/// Errors: as [`derivatives`]; `Shape` unless there is a weight for each result.
pub fn gradient(results: &[Traced], weights: &[f64], sources: usize) -> Result<Vec<f64>> {
    if weights.len() != results.len() {
        let expected = format!("{}, one for each result", results.len());
        return Err(Error::shape("weights", format!("{} numbers", weights.len()), expected));
    }
    let mut counts: HashMap<u64, f64> = HashMap::new();
    for (result, weight) in results.iter().zip(weights) {
        if let Some(step) = &result.step {
            *counts.entry(step.number).or_default() += weight;
        }
    }
    let mut gradient = vec![0.0; sources];
    for (number, step) in history(results).into_iter().rev() {
        let count = counts.remove(&number).unwrap_or_default();
        if let Some(source) = step.source {
            let expected = format!("one of {sources}");
            let received = format!("number {source}");
            *gradient
                .get_mut(source)
                .ok_or_else(|| Error::shape("sources", received, expected))? += count;
        }
        for (slope, earlier) in &step.from {
            *counts.entry(earlier.number).or_default() += slope * count;
        }
    }
    gradient.iter().try_for_each(|derivative| require_finite(*derivative))?;
    Ok(gradient)
}

fn require_finite(derivative: f64) -> Result<()> {
    if derivative.is_finite() {
        return Ok(());
    }
    Err(Error::domain("result", format!("a derivative {derivative}"), "a finite one"))
}

/// Every step that led to the results, in the order in which they were made.
fn history(results: &[Traced]) -> BTreeMap<u64, &Step> {
    let mut found = BTreeMap::new();
    let mut open: Vec<&Step> = results.iter().filter_map(|result| result.step.as_deref()).collect();
    while let Some(step) = open.pop() {
        if found.insert(step.number, step).is_none() {
            open.extend(step.from.iter().map(|(_, earlier)| &**earlier));
        }
    }
    found
}

impl PartialEq for Traced {
    fn eq(&self, other: &Self) -> bool {
        let number = |traced: &Self| traced.step.as_ref().map(|step| step.number);
        self.value == other.value && number(self) == number(other)
    }
}

impl PartialOrd for Traced {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl Add for Traced {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::function(self.value + other.value, &[(1.0, &self), (1.0, &other)])
    }
}

impl AddAssign for Traced {
    fn add_assign(&mut self, other: Self) {
        *self = self.clone() + other;
    }
}

impl Sub for Traced {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::function(self.value - other.value, &[(1.0, &self), (-1.0, &other)])
    }
}

impl Mul for Traced {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::function(self.value * other.value, &[(other.value, &self), (self.value, &other)])
    }
}

impl Div for Traced {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self::function(value, &[(1.0 / other.value, &self), (-value / other.value, &other)])
    }
}

impl Neg for Traced {
    type Output = Self;
    fn neg(self) -> Self {
        Self::function(-self.value, &[(-1.0, &self)])
    }
}

impl Scalar for Traced {
    const EXACT: bool = false;

    fn zero() -> Self {
        Self::constant(0.0)
    }

    fn one() -> Self {
        Self::constant(1.0)
    }

    fn from_integer(value: i64) -> Self {
        Self::constant(value as f64)
    }

    fn from_f64(value: f64) -> Option<Self> {
        f64::from_f64(value).map(Self::constant)
    }

    fn to_f64(&self) -> f64 {
        self.value
    }

    fn half_root() -> Option<Self> {
        f64::half_root().map(Self::constant)
    }

    fn is_finite(&self) -> bool {
        self.value.is_finite()
    }

    fn add_multiple(target: &mut [Self], factor: &Self, source: &[Self]) {
        for (sum, term) in target.iter_mut().zip(source) {
            let value = sum.value + factor.value * term.value;
            *sum = Self::function(value, &[(1.0, sum), (factor.value, term), (term.value, factor)]);
        }
    }
}
