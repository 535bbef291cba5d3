//! Where a curve meets a surface.

use pforms_kernel::{Error, Form, Result};

use super::Intersections;

/// On the windows from 0 to 1.
pub(super) fn curve_surface(_: &Form, surface: &Form, _: f64) -> Result<Intersections> {
    Err(Error::domain("second", surface.kind(), "a curve"))
}
