//! The factors of the nodes that are asked for again and again, made once.

use std::any::Any;
use std::sync::OnceLock;

use pforms_kernel::Scalar;

use super::Nodes;
use super::vandermonde::{Vandermonde, Window};
use crate::measuring::twofold::Twofold;

/// The highest order that is remembered: all of them together take less than 2 MB.
const HIGHEST: usize = 48;

type Factors = [OnceLock<Vandermonde<f64>>; HIGHEST + 1];

static UNIFORM: Factors = [const { OnceLock::new() }; HIGHEST + 1];
static CHEBYSHEV: Factors = [const { OnceLock::new() }; HIGHEST + 1];
static LOBATTO: Factors = [const { OnceLock::new() }; HIGHEST + 1];

/// The factors for `f64` at nodes that go by a rule, where they are remembered.
pub(crate) fn known<S: Scalar>(nodes: &Nodes<S>, order: usize) -> Option<&'static Vandermonde<S>> {
    let (rule, factors) = match nodes {
        Nodes::Uniform => (Nodes::<Twofold<S>>::Uniform, &UNIFORM),
        Nodes::Chebyshev => (Nodes::Chebyshev, &CHEBYSHEV),
        Nodes::Lobatto => (Nodes::Lobatto, &LOBATTO),
        Nodes::Given(_) => return None,
    };
    let place: &'static dyn Any = factors.get(order)?;
    let place = place.downcast_ref::<OnceLock<Vandermonde<S>>>()?;
    let list = || rule.on_axis(0, order).unwrap_or_default();
    let (start, end) = (Twofold::zero(), Twofold::one());
    Some(place.get_or_init(|| Vandermonde::new(&Window { nodes: list(), start, end })))
}
