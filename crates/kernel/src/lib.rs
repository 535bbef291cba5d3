//! The kernel of pforms: a form is nothing but its poles, and three moves act on them.
//!
//! * **evaluate** a form at parameters ([`Form::at`], [`Form::grid`]);
//! * **act along one axis** with a matrix ([`Form::along`]);
//! * **multiply** in the Bernstein basis ([`Scaled`]).
//!
//! ```
//! use pforms_kernel::{Form, Rational, Scalar};
//!
//! let parabola: Form = Form::from_points(&[3], 2, &[0., 0., 1., 2., 2., 0.], None)?;
//! assert_eq!(parabola.kind().to_string(), "pL3");
//! assert_eq!(parabola.at(&[0.5])?, [1.0, 1.0]);
//!
//! let exact = parabola.map_scalar(|x| Rational::from_f64(*x).unwrap())?;
//! let third = Rational::ratio(1, 3);
//! assert_eq!(exact.at(&[third])?, [Rational::ratio(2, 3), Rational::ratio(8, 9)]);
//! # Ok::<(), pforms_kernel::Error>(())
//! ```

mod act;
mod basis;
mod bulk;
mod bulk_derivative;
mod bulk_grid;
mod bulk_scattered;
mod dual;
mod error;
mod evaluate;
mod flat;
mod form;
mod jet;
mod kind;
pub mod limit;
mod matrix;
mod pascal;
mod planar;
mod product;
mod rational;
mod scalar;
mod sparse;
pub mod stopping;
pub mod threads;
mod traced;
mod vector_rows;
pub mod vectors;

pub use basis::{bernstein_row, blossom_row, projective_blossom_row, taylor_rows};
pub use bulk::{Batch, grids_into};
pub use dual::Dual;
pub use error::{Error, Fault, Place, Result};
pub use flat::{Factored, Flat, Tap};
pub use form::Form;
pub use jet::Jet;
pub use kind::Kind;
pub use matrix::Matrix;
pub use pascal::{Binomials, binomial, pascal_row};
pub use product::Scaled;
pub use rational::Rational;
pub use scalar::Scalar;
pub use sparse::Sparse;
pub use traced::{Traced, derivatives, gradient};
