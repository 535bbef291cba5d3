//! Exact operators: generic over the scalar, linear or multilinear in the poles, no tolerance.

mod blossom;
mod combine;
mod derivative;
mod diagonal;
mod elevate;
mod explain;
mod immerse;
mod lazy;
mod partition;
mod piecewise;
mod reduce;
mod relabel;
mod reparametrise;
mod segment;
mod stack;
mod stretch;
mod subdivide;
mod tile;

pub use blossom::blossom;
pub use combine::combine;
pub use derivative::{derivative, hodograph};
pub use diagonal::{diagonal, diagonal_all};
pub use elevate::{elevate, elevation_matrix, raise_to, raise_together};
pub use explain::explain;
pub use immerse::{Forecast, forecast, immerse, immerse_points};
pub use lazy::Immersed;
pub use partition::partition;
pub use piecewise::Piecewise;
pub use reduce::{Reduction, reduce};
pub use relabel::{reverse, sub, transpose};
pub use reparametrise::{reparametrise, whole_line};
pub use segment::{polyline, segment};
pub use stack::{midpoint, stack, unstack};
pub use stretch::{split, stretch, stretch_matrix};
pub use subdivide::{subdivide, subdivision_matrix};
pub use tile::tile;
