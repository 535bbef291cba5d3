//! pforms for Python: NumPy in and out, the lock released, errors translated. Computes nothing.

mod arguments;
mod arithmetic;
mod arrays;
mod columns;
mod errors;
mod evaluation;
mod form;
mod gestures;
mod immersed;
mod inside;
mod making;
mod measuring;
mod operators;
mod parameters;
mod piecewise;

/// The compiled half of the package `pforms`.
#[pyo3::pymodule]
mod _pforms {
    #[pymodule_export]
    use crate::form::PyForm;
    #[pymodule_export]
    use crate::gestures::{bernstein, combine, explain, midpoint, partition, pascal, stack};
    #[pymodule_export]
    use crate::immersed::{PyImmersed, immerse};
    #[pymodule_export]
    use crate::inside::{immerse_points, polyline, segment, tile};
    #[pymodule_export]
    use crate::making::{fit, interpolate};
    #[pymodule_export]
    use crate::piecewise::PyPiecewise;

    /// The version of pforms.
    #[pymodule_export]
    #[allow(non_upper_case_globals)]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
