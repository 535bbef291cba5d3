//! The native format: forms as JSON, every number exact.
//!
//! ```json
//! {
//!   "pforms": 1,
//!   "forms": [
//!     {
//!       "name": "arc",
//!       "orders": [3],
//!       "ambient": 2,
//!       "poles": [[1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 2.0, 2.0]]
//!     }
//!   ]
//! }
//! ```
//!
//! A spline has `degrees` and `knots` too, a full knot vector for each axis; `orders` and `poles` are
//! those of its net.
//!
//! Poles are homogeneous, the weight last and multiplied in. They are one flat array, an array of
//! poles, or nested like the axes of the form. A number is a JSON number (an `f64`, restored to
//! the last bit) or a string with an exact fraction, `"1/3"`.

mod number;
mod poles;
mod read;
mod write;

pub use number::Number;
pub use read::read;
pub use write::write;
