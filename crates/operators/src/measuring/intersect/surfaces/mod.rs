//! Where two surfaces meet.

use pforms_kernel::{Error, Result};

use super::Intersections;
use crate::{Poles, Shape};

/// Over the windows of both.
pub(super) fn surface_surface(_: &Shape, second: &Shape, _: f64) -> Result<Intersections> {
    Err(Error::domain("second", second.net().kind(), "a curve"))
}
