//! How the numbers of an immersion lie in memory: all that the orders of two forms decide.

use std::cell::RefCell;
use std::rc::Rc;

use smallvec::{SmallVec, smallvec};

/// One number for each axis, or for each row of a small net.
pub(super) type Each = SmallVec<[usize; 8]>;

/// The layout of an immersion: which sums it nests, and what room they need.
///
/// A polynomial of degree `m` in the coordinates of the inner form has the degree `m·q` along an axis
/// where that has the degree `q`.
pub(super) struct Shape {
    inner: Each,
    host: Each,
    /// Numbers for a pole.
    pub width: usize,
    /// All axes of the host but the last.
    pub axes: Vec<Axis>,
    /// Where the coefficients of the inner form lie in a polynomial of the last axis' basis.
    pub basis_places: Each,
    /// Coefficients of a polynomial of the last axis' basis.
    pub basis_room: usize,
    /// How many polynomials that are.
    pub order: usize,
}

/// One axis of the host, contracted by nesting.
pub(super) struct Axis {
    pub degree: usize,
    /// The number of the factor of its second pole.
    pub first_factor: usize,
    /// Where the coefficients of the inner form lie in the layout of the sum, in poles.
    pub places: Each,
    /// Where the rows of a pole begin in that layout.
    pub rows: Each,
    /// Numbers in a row.
    pub run: usize,
    /// Numbers in the sum.
    pub room: usize,
    /// Numbers in a term of it, at most.
    pub term_room: usize,
    /// Is the `k`-th pole multiplied by `X^k`? Otherwise by `X`, again and again.
    pub powers: SmallVec<[bool; 8]>,
}

/// Numbers that a basis may have however small the result is.
const SMALL_BASIS: usize = 256;

/// Coefficients of the longest power that is kept.
const LONG: usize = 64;

thread_local! {
    /// The shape that was used last: many forms are often drawn in one host.
    static LAST: RefCell<Option<Rc<Shape>>> = const { RefCell::new(None) };
}

impl Shape {
    /// The shape for forms of these orders, of which `width` homogeneous coordinates are wanted.
    pub(super) fn of(inner: &[usize], host: &[usize], width: usize) -> Rc<Self> {
        LAST.with_borrow_mut(|last| match last {
            Some(shape) if shape.is_for(inner, host, width) => Rc::clone(shape),
            _ => Rc::clone(last.insert(Rc::new(Self::new(inner, host, width)))),
        })
    }

    /// Numbers in each sum but the first, of which each is a term in the sum before, too.
    pub(super) fn rooms(&self) -> impl Iterator<Item = usize> {
        let sums = self.axes[1..].iter().map(|axis| axis.room).chain([0]);
        self.axes.iter().zip(sums).map(|(axis, sum)| axis.term_room.max(sum))
    }

    fn is_for(&self, inner: &[usize], host: &[usize], width: usize) -> bool {
        *self.inner == *inner && *self.host == *host && self.width == width
    }

    /// The last axis is contracted with a basis if that is small beside the result, else nested
    /// like the others, with an axis of one pole behind it.
    fn new(inner: &[usize], host: &[usize], width: usize) -> Self {
        let size = |degree: usize| orders(inner, degree).iter().product::<usize>();
        let mut degrees: Each = host.iter().map(|order| order - 1).collect();
        let last = degrees.last().copied().unwrap_or(0);
        let small = SMALL_BASIS.max(size(degrees.iter().sum()) * width / 4);
        if degrees.len() < 2 || size(last) * (last + 1) > small {
            degrees.push(0);
        }
        degrees.resize(degrees.len().max(2), 0);
        let mut done = degrees.pop().unwrap_or(0);
        let basis = Layout::new(inner, 1, 0, done);
        let mut axes: Vec<Axis> = Vec::with_capacity(degrees.len());
        let order = done + 1;
        for &degree in degrees.iter().rev() {
            axes.push(Layout::new(inner, width, done, degree).axis(degree));
            done += degree;
        }
        axes.reverse();
        let mut first = 0;
        for axis in &mut axes {
            axis.first_factor = first;
            first += axis.degree;
        }
        Self {
            inner: inner.into(),
            host: host.into(),
            width,
            axes,
            basis_places: basis.places(),
            basis_room: basis.room,
            order,
        }
    }
}

/// How the poles of an axis lie in their sum.
struct Layout<'a> {
    /// Orders of the inner form.
    inner: &'a [usize],
    width: usize,
    /// Degree of the poles in the coordinates of the inner form.
    done: usize,
    /// Distances in the sum, in poles, between neighbours along each inner axis.
    strides: Each,
    /// Numbers in the sum.
    room: usize,
}

impl<'a> Layout<'a> {
    fn new(inner: &'a [usize], width: usize, done: usize, degree: usize) -> Self {
        let mut count = 1;
        let mut strides: Each = SmallVec::new();
        for order in orders(inner, done + degree).iter().rev() {
            strides.push(count);
            count *= order;
        }
        strides.reverse();
        Self { inner, width, done, strides, room: count * width }
    }

    fn axis(&self, degree: usize) -> Axis {
        let powers: SmallVec<[bool; 8]> = (1..=degree).map(|k| self.power_pays(k)).collect();
        let steps = (1..degree).rev().find(|&steps| !powers[steps]).unwrap_or(0);
        let (rows, run) = self.rows();
        Axis {
            degree,
            first_factor: 0,
            places: self.places(),
            rows,
            run,
            room: self.room,
            term_room: self.span(self.done + steps),
            powers,
        }
    }

    /// Numbers from the first to the last coefficient of a polynomial of the given degree.
    fn span(&self, degree: usize) -> usize {
        let orders = orders(self.inner, degree);
        let ends = orders.iter().zip(&self.strides).map(|(order, stride)| (order - 1) * stride);
        (ends.sum::<usize>() + 1) * self.width
    }

    fn places(&self) -> Each {
        positions(self.inner, &self.strides)
    }

    /// Where the rows of a pole begin, and their length.
    fn rows(&self) -> (Each, usize) {
        let orders = orders(self.inner, self.done);
        let Some((last, outer)) = orders.split_last() else { return (smallvec![0], self.width) };
        let mut rows = positions(outer, &self.strides);
        rows.iter_mut().for_each(|start| *start *= self.width);
        (rows, last * self.width)
    }

    /// Does a product with `X^k` take less work than `k` products with `X`? Each of these is a pass
    /// that costs about as much as two taps. Long powers are not kept.
    fn power_pays(&self, k: usize) -> bool {
        let taps = |k: usize| orders(self.inner, k).iter().product::<usize>();
        let passes = (0..k).map(|steps| (taps(1) + 2) * self.span(self.done + steps));
        taps(k) <= LONG && (taps(k) + 2) * self.span(self.done) <= passes.sum()
    }
}

/// Orders of a polynomial of the given degree in the coordinates of an inner form.
pub(super) fn orders(inner: &[usize], degree: usize) -> Each {
    inner.iter().map(|order| degree.saturating_mul(order - 1).saturating_add(1)).collect()
}

/// Where the entries of an array of these sizes lie in one of these strides, in C order.
fn positions(sizes: &[usize], strides: &[usize]) -> Each {
    let mut all: Each = smallvec![0];
    for (&size, &stride) in sizes.iter().zip(strides) {
        let known = std::mem::take(&mut all);
        all.extend(known.iter().flat_map(|start| (0..size).map(move |i| start + i * stride)));
    }
    all
}
