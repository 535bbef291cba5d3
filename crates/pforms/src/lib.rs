//! Pascalian forms: curved shapes of any dimension built from one gesture, finding the middle.
//!
//! This is the front door: the kernel and the operators under one name, and the rooms behind them
//! as modules. A guided tour, from one point to a sheet:
//!
//! # Forms are their poles
//!
//! ```
//! use pforms::{Form, stack, midpoint};
//!
//! // The middle of two points; and the form that two points generate, a segment.
//! let [p, q]: [Form; 2] = [Form::point(&[0., 0., 1.])?, Form::point(&[1., 0., 0.])?];
//! assert_eq!(midpoint(&[&p, &q])?.points()?, [0.5, 0., 0.5]);
//! let segment = stack(&[&p, &q])?;
//! assert_eq!(segment.kind().to_string(), "pL2");
//!
//! // Two segments generate a facet, two facets a cube, and so on.
//! let facet = stack(&[&segment, &Form::from_points(&[2], 3, &[0., 1., 0., 1., 1., 1.], None)?])?;
//! assert_eq!(facet.kind().to_string(), "pS22");
//! assert_eq!(facet.at(&[0.5, 0.5])?, [0.5, 0.5, 0.5]);
//! # Ok::<(), pforms::Error>(())
//! ```
//!
//! # One inside another, exactly
//!
//! ```
//! use pforms::{Form, Rational, Scalar, diagonal, immerse};
//!
//! // u·v as a form over the unit square, and a parabola drawn in that square.
//! let number = |x: i64| Rational::from_integer(x.into());
//! let saddle = Form::from_points(&[2, 2], 1, &[0, 0, 0, 1].map(number), None)?;
//! let parabola = Form::from_points(&[3], 2, &[0, 0, 1, 0, 1, 1].map(number), None)?;
//! let curve = immerse(&parabola, &saddle)?;
//! assert_eq!(curve.kind().to_string(), "pL5");
//! // u = 2t − t², v = t²: at t = 1/3 their product is 5/81, without rounding.
//! assert_eq!(curve.at(&[Rational::ratio(1, 3)])?, [Rational::ratio(5, 81)]);
//! assert_eq!(diagonal(&saddle, 0, 1)?.kind().to_string(), "pL3");
//! # Ok::<(), pforms::Error>(())
//! ```
//!
//! # A sheet that recalculates
//!
//! ```
//! use pforms::sheet::Sheet;
//!
//! let mut sheet: Sheet = Sheet::new();
//! sheet.set("A1".parse()?, "[(0, 0), (1, 1)]");
//! sheet.set("A2".parse()?, "[(0, 2), (1, 0)]");
//! sheet.set("A3".parse()?, "=DIAG(MIR(A1, A2))");
//! sheet.recalculate_all();
//! assert_eq!(sheet.value("A3".parse()?).kind(Default::default()), "pL3");
//!
//! // Only what depends on a change is computed again.
//! sheet.move_pole("A2".parse()?, &[0], &[0.0, 3.0])?;
//! assert_eq!(sheet.recalculate_all().changed.len(), 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use pforms_kernel::*;
pub use pforms_operators::*;

pub use pforms_catalogue as catalogue;
pub use pforms_formats as formats;
pub use pforms_formula as formula;
pub use pforms_mesh as mesh;
pub use pforms_scene as scene;
pub use pforms_sheet as sheet;
