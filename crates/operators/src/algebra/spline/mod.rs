//! Splines: forms laid end to end, with a knot vector for each axis.

mod combine;
mod derivative;
mod diagonal;
mod evaluate;
mod knots;
mod locate;
mod pieces;
mod refine;
mod removal;
mod rows;
mod sampled;
mod shape;
mod subdivide;
mod thinning;
mod window;

use pforms_kernel::{Error, Form, Result, Scalar};

pub use combine::{midpoint_shapes, stack_shapes};
pub use knots::Knots;
pub use locate::Located;
pub(crate) use pieces::Pieces;
pub(super) use pieces::indices;
pub use removal::Removal;
pub use shape::{Poles, Shape};
pub(crate) use thinning::Thinning;

/// A tensor-product rational B-spline form of any degrees with any number of axes: NURBS.
///
/// Its net is an array of homogeneous poles as a [`Form`] has, and along each axis a knot vector
/// says how the poles are shared between pieces. Each piece is a form; a form is a spline of one
/// piece. Immutable, exact in every scalar. Book 34; *The NURBS Book*, chapters 2 to 5.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::Spline;
/// // The uniform quadratic over four poles has two pieces, which meet half way between poles.
/// let net: Form = Form::from_points(&[4], 2, &[0., 0., 0., 2., 2., 2., 2., 0.], None)?;
/// let spline = Spline::new(net, &[2], vec![vec![0., 1., 2., 3., 4., 5., 6.]])?;
/// assert_eq!(spline.at(&[3.0])?, [1.0, 2.0]);
/// assert_eq!(spline.pieces()?.len(), 2);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Spline<S = f64> {
    net: Form<S>,
    knots: Vec<Knots<S>>,
}

impl<S: Scalar> Spline<S> {
    /// A spline from its net and, for each axis, a degree and a full knot vector.
    ///
    /// Errors: `Shape` unless each vector has `order + degree + 1` knots; otherwise as
    /// [`Knots::new`].
    pub fn new(net: Form<S>, degrees: &[usize], knots: Vec<Vec<S>>) -> Result<Self> {
        net.require_per_axis("degrees", degrees)?;
        net.require_per_axis("knots", &knots)?;
        let mut all = Vec::with_capacity(degrees.len());
        for ((&degree, list), &order) in degrees.iter().zip(knots).zip(net.orders()) {
            if order.checked_add(degree).is_none_or(|sum| sum + 1 != list.len()) {
                return Err(Error::shape(
                    "knots",
                    format!("{} knots", list.len()),
                    format!("poles + degree + 1 = {order} + {degree} + 1"),
                ));
            }
            all.push(Knots::new(degree, list)?);
        }
        Ok(Self { net, knots: all })
    }

    /// A spline from its net and knots.
    ///
    /// Errors: `Shape` unless the knots of each axis mix as many poles as there are.
    pub fn on(net: Form<S>, knots: Vec<Knots<S>>) -> Result<Self> {
        net.require_per_axis("knots", &knots)?;
        for (axis, (one, &order)) in knots.iter().zip(net.orders()).enumerate() {
            if one.order() != order {
                return Err(Error::shape(
                    "net",
                    format!("{order} poles along axis {axis}"),
                    format!("{}, as its knots have", one.order()),
                ));
            }
        }
        Ok(Self { net, knots })
    }

    /// Bézier pieces end to end, neighbours sharing their end poles: along an axis of degree `d`
    /// with `k` pieces the net has `d·k + 1` poles.
    ///
    /// Along an axis of degree 0 all pieces are one and the same: it becomes a single piece.
    ///
    /// Errors: `Shape` when the net has another number of poles or an axis has no two breaks;
    /// `Domain` unless the breaks grow.
    pub fn joined(net: Form<S>, degrees: &[usize], breaks: &[Vec<S>]) -> Result<Self> {
        net.require_per_axis("degrees", degrees)?;
        net.require_per_axis("breaks", breaks)?;
        let mut knots = Vec::with_capacity(degrees.len());
        for (axis, (&degree, list)) in degrees.iter().zip(breaks).enumerate() {
            let pieces = list.len().saturating_sub(1);
            if pieces == 0 || net.orders()[axis] != degree * pieces + 1 {
                return Err(Error::shape(
                    "net",
                    format!("{} poles along axis {axis}", net.orders()[axis]),
                    format!("degree · pieces + 1 = {}", degree * pieces + 1),
                ));
            }
            if let Some(at) = list.windows(2).position(|pair| pair[0] >= pair[1]) {
                let received = format!("{:?}, then {:?}", list[at], list[at + 1]);
                return Err(Error::domain("breaks", received, "breaks that grow"));
            }
            knots.push(Knots::of_breaks(degree, list, degree)?);
        }
        Ok(Self { net, knots })
    }

    /// The poles, in one array.
    pub fn net(&self) -> &Form<S> {
        &self.net
    }

    /// The knots of each axis, with its degree.
    pub fn knots(&self) -> &[Knots<S>] {
        &self.knots
    }

    /// Degree of every piece along each axis.
    pub fn degrees(&self) -> Vec<usize> {
        self.knots.iter().map(Knots::degree).collect()
    }

    /// Along each axis, the parameters where pieces begin and end.
    pub fn breaks(&self) -> Vec<Vec<S>> {
        self.knots.iter().map(Knots::breaks).collect()
    }

    /// Number of pieces along each axis.
    pub fn counts(&self) -> Vec<usize> {
        self.knots.iter().map(|knots| knots.spans().len()).collect()
    }

    /// Where the parameter of `axis` begins and ends.
    ///
    /// Errors: `Shape` when there is no such axis.
    pub fn window(&self, axis: usize) -> Result<(S, S)> {
        self.net.require_axis(axis)?;
        let (from, to) = self.knots[axis].window();
        Ok((from.clone(), to.clone()))
    }

    /// Number of parameters.
    pub fn axes(&self) -> usize {
        self.net.axes()
    }

    /// Dimension of the space it lies in.
    pub fn ambient(&self) -> usize {
        self.net.ambient()
    }

    /// Does every piece keep the end poles it shares, so that the net holds all their poles?
    pub fn is_bezier(&self) -> bool {
        self.knots.iter().all(|knots| knots.spans().iter().all(|&span| knots.is_bezier_over(span)))
    }

    /// The same spline in another scalar.
    ///
    /// Errors: `Domain` when a number does not survive the journey or knots fall together.
    pub fn map_scalar<T: Scalar>(&self, convert: impl Fn(&S) -> T) -> Result<Spline<T>> {
        let knots = self.knots.iter();
        let lists = knots.map(|knots| knots.as_slice().iter().map(&convert).collect());
        let lists = lists.collect();
        Spline::new(self.net.map_scalar(&convert)?, &self.degrees(), lists)
    }
}

impl<S: Scalar> From<Form<S>> for Spline<S> {
    /// One piece, on the window from 0 to 1.
    fn from(form: Form<S>) -> Self {
        let knots = form.orders().iter().map(|&order| Knots::single(order - 1)).collect();
        Self { net: form, knots }
    }
}

impl<S: Scalar> Knots<S> {
    /// Those of one piece on the window from 0 to 1.
    pub(super) fn single(degree: usize) -> Self {
        Self { degree, list: [vec![S::zero(); degree + 1], vec![S::one(); degree + 1]].concat() }
    }
}
