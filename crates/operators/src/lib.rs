//! The operators of pforms: forms in, forms or numbers out. One file per operator.
//!
//! * `algebra`: exact, generic over the scalar, no tolerance anywhere;
//! * `measuring`: questions about a form, answered in `f64` with a stated accuracy;
//! * `making`: constructions that use both.
//!
//! ```
//! use pforms_kernel::Form;
//! use pforms_operators::{diagonal, stack};
//!
//! // A skew facet from two segments; its diagonal is a parabola.
//! let a: Form = Form::from_points(&[2], 3, &[0., 0., 0., 1., 0., 1.], None)?;
//! let b = Form::from_points(&[2], 3, &[0., 1., 1., 1., 1., 0.], None)?;
//! let facet = stack(&[&a, &b])?;
//! assert_eq!(facet.kind().to_string(), "pS22");
//! assert_eq!(diagonal(&facet, 0, 1)?.kind().to_string(), "pL3");
//! # Ok::<(), pforms_kernel::Error>(())
//! ```

mod algebra;
mod making;
mod measuring;

pub use algebra::*;
pub use making::*;
pub use measuring::*;
