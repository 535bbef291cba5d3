//! The parameters at which a form passes through given points.

use std::cmp::Ordering;

use pforms_kernel::{Error, Result, Scalar};

/// Where on each axis the points of a net are met.
#[derive(Clone, Debug, PartialEq)]
pub enum Nodes<S = f64> {
    /// `i / (order − 1)`: the book's choice. Fine up to some ten points; the poles then grow
    /// like `2^order`, for any method, because the problem itself is sensitive.
    Uniform,
    /// The zeros of the Chebyshev polynomial of the first kind, mapped from `[−1, 1]` to
    /// `[0, 1]`: `sin²(π(2i+1) / 4·order)`. All inside the window; the calmest choice.
    Chebyshev,
    /// The extrema of the Chebyshev polynomial, mapped likewise: `sin²(πi / 2(order−1))`. Nearly
    /// as calm, and the ends 0 and 1 are among them, so that patches with a common border meet.
    Lobatto,
    /// One list for each axis, as many distinct numbers as its order, in any order and anywhere
    /// on the real line.
    Given(Vec<Vec<S>>),
}

impl<S: Scalar> Nodes<S> {
    /// The nodes of one axis of the given order.
    ///
    /// A single node lies in the middle, at ½. Chebyshev nodes are computed in `f64`, to a
    /// rounding each, and are the same numbers in every scalar and on every machine.
    ///
    /// Errors: `Shape` when the given lists do not cover the axis or have another length.
    ///
    /// ```
    /// use pforms_operators::Nodes;
    /// assert_eq!(Nodes::<f64>::Uniform.on_axis(0, 5)?, [0.0, 0.25, 0.5, 0.75, 1.0]);
    /// # Ok::<(), pforms_kernel::Error>(())
    /// ```
    pub fn on_axis(&self, axis: usize, order: usize) -> Result<Vec<S>> {
        if let Self::Given(lists) = self {
            return given(lists, axis, order);
        }
        if order == 1 {
            return Ok(vec![S::ratio(1, 2)]);
        }
        let count = order as i64;
        let exactly = |x| S::from_f64(x).unwrap_or_else(S::zero);
        Ok((0..count)
            .map(|i| match self {
                Self::Chebyshev => exactly(sine_squared(2 * i + 1, 2 * count)),
                Self::Lobatto => exactly(sine_squared(i, count - 1)),
                Self::Uniform | Self::Given(_) => S::ratio(i, count - 1),
            })
            .collect())
    }
}

/// `sin²(π/2 · part/whole)`, symmetric about ½ to the last bit.
fn sine_squared(part: i64, whole: i64) -> f64 {
    match (2 * part).cmp(&whole) {
        Ordering::Equal => 0.5,
        Ordering::Greater => 1.0 - sine_squared(whole - part, whole),
        Ordering::Less => {
            let sine = libm::sin(std::f64::consts::FRAC_PI_2 * part as f64 / whole as f64);
            sine * sine
        }
    }
}

fn given<S: Scalar>(lists: &[Vec<S>], axis: usize, order: usize) -> Result<Vec<S>> {
    match lists.get(axis) {
        Some(list) if list.len() == order => Ok(list.clone()),
        other => Err(Error::shape(
            "nodes",
            format!("{} on axis {axis}", other.map_or(0, Vec::len)),
            format!("{order}, the order of the net"),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pforms_kernel::Rational;

    #[test]
    fn chebyshev_nodes_are_symmetric_and_increase() {
        for nodes in [Nodes::<f64>::Chebyshev, Nodes::Lobatto] {
            for order in 1..40 {
                let list = nodes.on_axis(0, order).unwrap();
                assert!(list.windows(2).all(|pair| pair[0] < pair[1]));
                for (a, b) in list.iter().zip(list.iter().rev()) {
                    assert_eq!(a.max(*b), 1.0 - a.min(*b));
                }
            }
        }
    }

    #[test]
    fn lobatto_nodes_reach_the_ends() {
        let list = Nodes::<Rational>::Lobatto.on_axis(0, 7).unwrap();
        assert_eq!(list[0], Rational::ratio(0, 1));
        assert_eq!(list[6], Rational::ratio(1, 1));
        assert!((list[1].to_f64() - (1.0 - 0.75_f64.sqrt()) / 2.0).abs() < 1e-16);
    }

    #[test]
    fn a_list_of_the_wrong_length_is_named() {
        let error = Nodes::Given(vec![vec![0.0, 1.0]]).on_axis(1, 3).unwrap_err();
        assert_eq!(
            error.to_string(),
            "nodes: received 0 on axis 1, expected 3, the order of the net"
        );
    }
}
