//! The form: an array of poles, and nothing else.

use std::sync::Arc;

use smallvec::SmallVec;

use crate::{Error, Kind, Result, Scalar, limit, stopping};

/// A tensor-product rational Bézier form with any number of axes in a space of any dimension.
///
/// The poles are homogeneous, the weight last and multiplied in: the pole `(x, y, z)` of weight
/// `w` is stored `(x·w, y·w, z·w, w)`. A weight may be negative, or 0: then the pole is a
/// direction. The array is in C order, so the last index runs fastest, and parameter `k` runs
/// along array axis `k`. A form is immutable and cheap to clone; all its numbers are finite.
///
/// ```
/// use pforms_kernel::Form;
/// // A quarter of a circle, by the weight √½ of its middle pole.
/// let w = 0.5_f64.sqrt();
/// let arc: Form = Form::from_points(&[3], 2, &[1., 0., 1., 1., 0., 1.], Some(&[1., w, 1.]))?;
/// let middle = arc.at(&[0.5])?;
/// assert!((middle[0].hypot(middle[1]) - 1.0).abs() < 1e-15);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Form<S = f64> {
    orders: SmallVec<[usize; 8]>,
    ambient: usize,
    poles: Arc<Vec<S>>,
}

impl<S: Scalar> Form<S> {
    /// A form of the given `orders` from homogeneous poles, `ambient + 1` numbers each.
    ///
    /// Errors: `Shape` when an order or `ambient` is 0 or the count does not fit; `Domain` when a
    /// number is NaN or infinite; `Limit` above the cap.
    pub fn from_homogeneous(orders: &[usize], ambient: usize, poles: Vec<S>) -> Result<Self> {
        // Nearly everything that takes long makes forms: here it can be stopped.
        stopping::check()?;
        let count = checked_count::<S>(orders, ambient, ambient + 1)?;
        if poles.len() != count {
            return Err(Error::shape(
                "poles",
                format!("{} numbers", poles.len()),
                format!("{count} for orders {orders:?} and {} coordinates a pole", ambient + 1),
            ));
        }
        require_finite("poles", &poles, ambient + 1)?;
        Ok(Self { orders: SmallVec::from_slice(orders), ambient, poles: Arc::new(poles) })
    }

    /// A form from euclidean points, `ambient` numbers each, and their weights (1 if absent).
    ///
    /// A weight 0 takes the point as a direction: it is stored `(x, y, z, 0)`.
    ///
    /// Errors: as [`Form::from_homogeneous`], and `Shape` when the weights do not match the points.
    pub fn from_points(
        orders: &[usize],
        ambient: usize,
        points: &[S],
        weights: Option<&[S]>,
    ) -> Result<Self> {
        let count = checked_count::<S>(orders, ambient, ambient)?;
        if points.len() != count {
            return Err(Error::shape(
                "points",
                format!("{} numbers", points.len()),
                format!("{count} for orders {orders:?} in dimension {ambient}"),
            ));
        }
        let expected = count / ambient;
        if let Some(weights) = weights
            && weights.len() != expected
        {
            return Err(Error::shape(
                "weights",
                format!("{} weights", weights.len()),
                format!("{expected}, one for each pole"),
            ));
        }
        if let Some(weight) = weights.and_then(|list| list.iter().find(|w| !w.is_finite())) {
            return Err(Error::domain("weights", format!("{weight:?}"), "finite numbers"));
        }
        let mut poles = Vec::with_capacity(expected * (ambient + 1));
        for (index, point) in points.chunks_exact(ambient).enumerate() {
            let weight = weights.map_or_else(S::one, |weights| weights[index].clone());
            push_pole(&mut poles, point, weight);
        }
        Self::from_homogeneous(orders, ambient, poles)
    }

    /// A single point of weight 1: a form without axes.
    pub fn point(coordinates: &[S]) -> Result<Self> {
        Self::from_points(&[], coordinates.len(), coordinates, None)
    }

    /// Number of poles along each axis.
    pub fn orders(&self) -> &[usize] {
        &self.orders
    }

    /// Degree along each axis: the order less 1.
    pub fn degrees(&self) -> Vec<usize> {
        self.orders.iter().map(|order| order - 1).collect()
    }

    /// Number of parameters.
    pub fn axes(&self) -> usize {
        self.orders.len()
    }

    /// Dimension of the space the form lies in, the weight not counted.
    pub fn ambient(&self) -> usize {
        self.ambient
    }

    /// Numbers stored for a pole: the coordinates and the weight.
    pub fn width(&self) -> usize {
        self.ambient + 1
    }

    /// Number of poles.
    pub fn pole_count(&self) -> usize {
        self.poles.len() / self.width()
    }

    /// Bytes the poles occupy.
    pub fn bytes(&self) -> usize {
        self.poles.len() * size_of::<S>()
    }

    /// All homogeneous poles, in C order, the weight last.
    pub fn homogeneous(&self) -> &[S] {
        &self.poles
    }

    /// The kind, in the notation of the book.
    pub fn kind(&self) -> Kind {
        Kind::new(&self.orders)
    }

    /// The weight of every pole.
    pub fn weights(&self) -> Vec<S> {
        self.poles.chunks_exact(self.width()).map(|pole| pole[self.ambient].clone()).collect()
    }

    /// Do the weights differ? A form whose weights are all equal is polynomial.
    pub fn is_rational(&self) -> bool {
        self.uniform_weight().is_none()
    }

    /// The weight that all poles have, if they have one weight.
    pub fn uniform_weight(&self) -> Option<&S> {
        let first = &self.poles[self.ambient];
        let mut poles = self.poles.chunks_exact(self.width());
        poles.all(|pole| pole[self.ambient] == *first).then_some(first)
    }

    /// The same form with every weight replaced by `weight`, the other coordinates left alone.
    ///
    /// An affine operator on a polynomial form gives a polynomial form: this makes that hold to
    /// the bit, where sums of rounded coefficients would give weights like 0.9999999999999999.
    #[must_use]
    pub fn with_uniform_weight(mut self, weight: &S) -> Self {
        let width = self.width();
        for pole in Arc::make_mut(&mut self.poles).chunks_exact_mut(width) {
            pole[width - 1] = weight.clone();
        }
        self
    }

    /// The euclidean poles, `ambient` numbers each.
    ///
    /// Errors: `Domain` when a pole is at infinity (weight 0).
    pub fn points(&self) -> Result<Vec<S>> {
        let mut points = Vec::with_capacity(self.pole_count() * self.ambient);
        for (index, pole) in self.poles.chunks_exact(self.width()).enumerate() {
            let weight = &pole[self.ambient];
            if weight.is_zero() {
                return Err(Error::domain(
                    "poles",
                    format!("weight 0 at pole {:?}", self.unravel(index)),
                    "finite poles (read the homogeneous ones, or the direction, instead)",
                ));
            }
            let coordinates = pole[..self.ambient].iter();
            points.extend(coordinates.map(|x| x.clone() / weight.clone()));
        }
        Ok(points)
    }

    /// One homogeneous pole.
    ///
    /// Errors: `Shape` when `index` has the wrong length or leaves the array.
    pub fn pole(&self, index: &[usize]) -> Result<&[S]> {
        let start = self.ravel(index)? * self.width();
        Ok(&self.poles[start..start + self.width()])
    }

    /// The same form with one homogeneous pole replaced.
    ///
    /// Errors: `Shape` for a wrong index or width, `Domain` when a number is not finite.
    pub fn with_pole(&self, index: &[usize], pole: &[S]) -> Result<Self> {
        let start = self.ravel(index)? * self.width();
        if pole.len() != self.width() {
            return Err(Error::shape(
                "pole",
                format!("{} numbers", pole.len()),
                format!("{} (the weight last)", self.width()),
            ));
        }
        let mut poles = self.poles.as_ref().clone();
        poles[start..start + self.width()].clone_from_slice(pole);
        Self::from_homogeneous(&self.orders, self.ambient, poles)
    }

    /// The same form in another scalar.
    ///
    /// Errors: `Domain` when a number does not survive the journey.
    pub fn map_scalar<T: Scalar>(&self, convert: impl FnMut(&S) -> T) -> Result<Form<T>> {
        let poles = self.poles.iter().map(convert).collect();
        Form::from_homogeneous(&self.orders, self.ambient, poles)
    }

    /// The same form in exact fractions: every `f64` is one.
    pub fn exact(&self) -> Result<Form<crate::Rational>> {
        self.map_scalar(|x| crate::Rational::from_f64(x.to_f64()).unwrap_or_default())
    }

    /// A form of the same ambient space, with other orders and poles.
    pub(crate) fn derived(&self, orders: &[usize], poles: Vec<S>) -> Result<Self> {
        Self::from_homogeneous(orders, self.ambient, poles)
    }

    /// Complains unless `axis` is one of the form's.
    pub fn require_axis(&self, axis: usize) -> Result<()> {
        if axis < self.axes() {
            return Ok(());
        }
        let expected = match self.axes() {
            0 => "no axis: the form is a point".to_owned(),
            axes => format!("0 to {} for a {}", axes - 1, self.kind()),
        };
        Err(Error::shape("axis", axis, expected))
    }

    /// Complains unless there is one entry for each axis.
    pub fn require_per_axis<T>(&self, argument: &str, entries: &[T]) -> Result<()> {
        if entries.len() == self.axes() {
            return Ok(());
        }
        Err(Error::shape(
            argument,
            format!("{} values", entries.len()),
            format!("{}, one for each axis of a {}", self.axes(), self.kind()),
        ))
    }

    fn ravel(&self, index: &[usize]) -> Result<usize> {
        self.require_per_axis("index", index)?;
        let mut flat = 0;
        for (&i, &order) in index.iter().zip(&self.orders) {
            if i >= order {
                return Err(Error::shape(
                    "index",
                    format!("{index:?}"),
                    format!("indices below {:?}", self.orders.as_slice()),
                ));
            }
            flat = flat * order + i;
        }
        Ok(flat)
    }

    fn unravel(&self, flat: usize) -> Vec<usize> {
        let mut rest = flat;
        let mut index: Vec<usize> = self
            .orders
            .iter()
            .rev()
            .map(|&order| {
                let i = rest % order;
                rest /= order;
                i
            })
            .collect();
        index.reverse();
        index
    }
}

fn push_pole<S: Scalar>(poles: &mut Vec<S>, point: &[S], weight: S) {
    if weight.is_zero() {
        poles.extend_from_slice(point);
    } else {
        poles.extend(point.iter().map(|x| x.clone() * weight.clone()));
    }
    poles.push(weight);
}

fn checked_count<S>(orders: &[usize], ambient: usize, width: usize) -> Result<usize> {
    if ambient == 0 {
        return Err(Error::shape("ambient", 0, "at least 1 coordinate"));
    }
    if orders.contains(&0) {
        return Err(Error::shape(
            "orders",
            format!("{orders:?}"),
            "at least 1 pole along every axis",
        ));
    }
    limit::check::<S>("the form", orders, width)
}

/// Numbers looked at without a branch.
const FEW: usize = 64;

fn require_finite<S: Scalar>(argument: &str, numbers: &[S], width: usize) -> Result<()> {
    // A branch for each number would take longer than looking at it.
    let finite = |part: &[S]| part.iter().fold(true, |all, x| all & x.is_finite());
    if numbers.chunks(FEW).all(finite) {
        return Ok(());
    }
    let first = numbers.iter().position(|x| !x.is_finite()).unwrap_or(0);
    Err(Error::domain(
        argument,
        format!("{:?} in pole {}, coordinate {}", numbers[first], first / width, first % width),
        "finite numbers (a pole at infinity has weight 0)",
    ))
}
