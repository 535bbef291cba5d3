//! An immersed form that stays unexpanded: host and inner side by side.

use pforms_kernel::{Form, Jet, Result, Scalar};

use super::immerse::require_fit;
use super::{Forecast, Poles, forecast, immerse};

/// `host ∘ inner` without its poles: degrees multiply under immersion, and evaluation does not
/// need them. Points and derivatives are exact; [`Immersed::expand`] makes the poles.
#[derive(Clone, Debug, PartialEq)]
pub struct Immersed<S = f64> {
    host: Form<S>,
    inner: Form<S>,
}

impl<S: Scalar> Immersed<S> {
    /// The inner form, seen inside the host.
    ///
    /// Errors: `Shape` when the inner coordinates do not fit the host's axes.
    pub fn new(inner: Form<S>, host: Form<S>) -> Result<Self> {
        require_fit(&inner, &host)?;
        Ok(Self { host, inner })
    }

    /// The form in whose parameters the inner one lives.
    pub fn host(&self) -> &Form<S> {
        &self.host
    }

    /// The form inside.
    pub fn inner(&self) -> &Form<S> {
        &self.inner
    }

    /// The kind as the book writes it: `ipL3`.
    pub fn kind(&self) -> String {
        format!("i{}", self.inner.kind())
    }

    /// What [`Immersed::expand`] would cost.
    pub fn forecast(&self) -> Forecast {
        forecast::<S>(self.inner.orders(), self.host.orders(), self.host.ambient())
    }

    /// The poles, by [`immerse`].
    ///
    /// Errors: `Limit` with the forecast size.
    pub fn expand(&self) -> Result<Form<S>> {
        immerse(&self.inner, &self.host)
    }

    /// The euclidean point at `parameters` of the inner form.
    ///
    /// Errors: `Shape`; `Domain` where a weight vanishes.
    pub fn at(&self, parameters: &[S]) -> Result<Vec<S>> {
        let inside = self.inner.at(parameters)?;
        self.host.at(&inside[..self.host.axes()])
    }

    /// The derivative `∂^orders` of the point, exact at any order: the chain rule on truncated
    /// Taylor series, through the triangle of de Casteljau.
    ///
    /// Errors: `Shape`; `Domain` where a weight vanishes.
    pub fn derivative_at(&self, parameters: &[S], orders: &[usize]) -> Result<Vec<S>> {
        let mut inside = self.inner.jets(parameters, orders)?;
        let weight = inside.split_off(self.inner.ambient()).remove(0);
        let arguments: Vec<Jet<S>> = inside[..self.host.axes()]
            .iter()
            .map(|jet| jet.divided_by(&weight))
            .collect::<Result<_>>()?;
        let poles = self.host.homogeneous().iter();
        let mut level: Vec<Jet<S>> = poles.map(|x| Jet::constant(orders, x.clone())).collect();
        for (argument, &order) in arguments.iter().zip(self.host.orders()) {
            level = contract(&level, argument, order);
        }
        let outer = level.split_off(self.host.ambient()).remove(0);
        level.iter().map(|jet| Ok(jet.divided_by(&outer)?.top_derivative())).collect()
    }
}

/// The poles of an immersed form are those of its host: it moves with the place it lives in.
impl<S: Scalar> Poles<S> for Immersed<S> {
    fn net(&self) -> &Form<S> {
        &self.host
    }

    fn with_net(&self, net: Form<S>) -> Result<Self> {
        Ok(Self { host: self.host.with_net(net)?, inner: self.inner.clone() })
    }
}

/// Contracts the first axis, of `order` poles, at a parameter that is itself a series.
fn contract<S: Scalar>(level: &[Jet<S>], t: &Jet<S>, order: usize) -> Vec<Jet<S>> {
    let inner = level.len() / order;
    let mut rest = level.to_vec();
    while rest.len() > inner {
        let pairs = rest.iter().zip(&rest[inner..]);
        rest = pairs.map(|(a, b)| toward(a, b, t)).collect();
    }
    rest
}

/// `a + t·(b − a)`.
fn toward<S: Scalar>(a: &Jet<S>, b: &Jet<S>, t: &Jet<S>) -> Jet<S> {
    let mut gap = b.clone();
    gap.add_multiple(&-S::one(), a);
    let mut sum = a.clone();
    sum.add_multiple(&S::one(), &t.times(&gap));
    sum
}
