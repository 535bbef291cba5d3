//! Surface and surface: the curves along which they cross, and how they touch.
//!
//! Pairs of parts are halved until each is apart or crosses cleanly: then no normal of one is parallel
//! to a normal of the other, and the intersection in it has no loops. So every branch passes one of the
//! lines on which parts were halved, or a border; the points on all of these are found, and every
//! branch is followed from there, by steps as long as quintics follow it. Each such point must be
//! passed exactly once. What does not become clean is where surfaces touch: there the critical
//! points of their distance across the common tangent plane are found, and what they are.

mod cone;
mod contact;
mod hermite;
mod join;
mod meet;
mod pair;
mod pairs;
mod patch;
mod pierce;
mod pivots;
mod positive;
mod space;
mod touch;
mod trace;
mod track;
mod tree;
mod whole;

pub(super) use whole::surface_surface;
