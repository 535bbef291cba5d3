//! Lanes as vectors of WebAssembly, which hold two numbers each.
//!
//! Elsewhere the compiler makes vectors of plain loops over lanes. For WebAssembly it often leaves pairs of numbers
//! apart, and whether it does changes with every build; here it is told. `N` is even.

#![allow(clippy::inline_always, reason = "one or two instructions each")]

use std::arch::wasm32::{
    f64x2, f64x2_add, f64x2_div, f64x2_extract_lane, f64x2_mul, f64x2_sqrt, f64x2_sub, v128,
};

use crate::lanes::Lanes;

macro_rules! operations {
    ($($name:ident: $operation:ident),*) => {$(
        #[inline(always)]
        pub(crate) fn $name<const N: usize>(a: Lanes<N>, b: Lanes<N>) -> Lanes<N> {
            each_pair(|pair| $operation(together(a, pair), together(b, pair)))
        }
    )*};
}

operations!(add: f64x2_add, sub: f64x2_sub, mul: f64x2_mul, div: f64x2_div);

#[inline(always)]
pub(crate) fn sqrt<const N: usize>(a: Lanes<N>) -> Lanes<N> {
    each_pair(|pair| f64x2_sqrt(together(a, pair)))
}

#[inline(always)]
fn each_pair<const N: usize>(pair: impl Fn(usize) -> v128) -> Lanes<N> {
    let mut lanes = Lanes::ZERO;
    for k in 0..N / 2 {
        let both = pair(k);
        lanes.0[2 * k] = f64x2_extract_lane::<0>(both);
        lanes.0[2 * k + 1] = f64x2_extract_lane::<1>(both);
    }
    lanes
}

#[inline(always)]
fn together<const N: usize>(lanes: Lanes<N>, pair: usize) -> v128 {
    f64x2(lanes.0[2 * pair], lanes.0[2 * pair + 1])
}
