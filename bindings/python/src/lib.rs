//! pforms for Python: NumPy in and out, the lock released, errors translated. Computes nothing.

// Documentation here is what Python's `help` shows, so it is written as Python's is.
#![allow(clippy::doc_markdown, clippy::doc_link_with_quotes)]

mod arguments;
mod arithmetic;
mod arrays;
mod columns;
mod combining;
mod composing;
mod drawing;
mod embedding;
mod errors;
mod evaluation;
mod files;
mod form;
mod forms;
mod geodesics;
mod gestures;
mod grids;
mod harmony;
mod immersed;
mod inside;
mod intersecting;
mod iterating;
mod joining;
mod lengths;
mod making;
mod measuring;
mod meshes;
mod offsetting;
mod operators;
mod outputs;
mod parameters;
mod piping;
mod planking;
mod points;
mod products;
mod projecting;
mod rational;
mod relaxing;
mod rows;
mod sampling;
mod settings;
mod shapes;
mod sheet;
mod sizes;
mod slices;
mod solids;
mod spanning;
mod spline;
mod spline_methods;
mod spline_operators;
mod splining;
mod tessellating;
mod transforming;
mod values;
mod vectors;
mod view;

/// The compiled half of the package `pforms`.
#[pyo3::pymodule]
mod _pforms {
    #[pymodule_export]
    use crate::combining::{combine, cube, extrude, facet, line, ruled, symmetric};
    #[pymodule_export]
    use crate::composing::{affine_matrix, affine_sweep};
    #[pymodule_export]
    use crate::drawing::_draw_forms;
    #[pymodule_export]
    use crate::embedding::{PyEmbedding, deform, embed};
    #[pymodule_export]
    use crate::files::{_read_forms, _write_forms};
    #[pymodule_export]
    use crate::form::PyForm;
    #[pymodule_export]
    use crate::geodesics::{geodesic, geodesic_between};
    #[pymodule_export]
    use crate::gestures::{bernstein, explain, midpoint, partition, pascal, stack};
    #[pymodule_export]
    use crate::grids::grid;
    #[pymodule_export]
    use crate::harmony::{golden, ratios};
    #[pymodule_export]
    use crate::immersed::{PyImmersed, forecast, immerse};
    #[pymodule_export]
    use crate::inside::{immerse_points, polyline, segment, tile};
    #[pymodule_export]
    use crate::intersecting::{intersect, intersect_many};
    #[pymodule_export]
    use crate::iterating::{iterate, peano, random_points, thirds};
    #[pymodule_export]
    use crate::joining::{continuity, insert_knots, join_forms, remove_knots};
    #[pymodule_export]
    use crate::lengths::{arc_length, by_arc_length, parameter_at_length};
    #[pymodule_export]
    use crate::making::{fit, interpolate};
    #[pymodule_export]
    use crate::meshes::{_make_mesh, _mesh_area, _mesh_is_closed, _mesh_volume};
    #[pymodule_export]
    use crate::offsetting::{
        is_developable, offset_poles, parallel, shell, tangent_developable, unroll,
    };
    #[pymodule_export]
    use crate::piping::{pipe, waving_pipe};
    #[pymodule_export]
    use crate::planking::planks;
    #[pymodule_export]
    use crate::products::{cross, revolve};
    #[pymodule_export]
    use crate::rational::{
        arc, bezier_cone, bezier_cylinder, bezier_sphere, bezier_torus, circle, classify, cone,
        conic, cylinder, ellipse, hyperbola, parabola, sphere, torus, torus_knot, viviani,
    };
    #[pymodule_export]
    use crate::relaxing::minimal;
    #[pymodule_export]
    use crate::settings::{cap, set_cap, set_threads, threads};
    #[pymodule_export]
    use crate::sheet::PySheet;
    #[pymodule_export]
    use crate::sizes::{
        area, bounding_box, centroid, inertia, is_injective, jacobian, slice, volume,
    };
    #[pymodule_export]
    use crate::solids::{common, difference, union};
    #[pymodule_export]
    use crate::spanning::{coons, gordon};
    #[pymodule_export]
    use crate::spline::PySpline;
    #[pymodule_export]
    use crate::splining::{bspline, concatenate, interpolating_spline, nurbs};
    #[pymodule_export]
    use crate::tessellating::tessellate;
    #[pymodule_export]
    use crate::transforming::{
        mirror, project_to_plane, rotate, scale, shear, transform, translate,
    };

    /// The version of pforms.
    #[pymodule_export]
    #[allow(non_upper_case_globals)]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
