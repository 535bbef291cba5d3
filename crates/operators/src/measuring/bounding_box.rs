//! The least box around forms, proved to an accuracy.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use pforms_kernel::{Error, Form, Result};

use super::integral::{Local, infinite, require_accuracy};
use super::patches::patches;
use crate::algebra::{Poles, Shape, split};

/// The least box around forms, its sides along the axes of space.
#[derive(Clone, Debug, PartialEq)]
pub struct BoundingBox {
    /// The lower corner: no point lies below.
    pub lower: Vec<f64>,
    /// The upper corner: no point lies above.
    pub upper: Vec<f64>,
    /// Each face is farther out than a point of the forms by no more than this.
    pub error: f64,
    /// For each coordinate a point that is lowest but for the error: the form and its parameters.
    pub lowest: Vec<(usize, Vec<f64>)>,
    /// The same for the highest.
    pub highest: Vec<(usize, Vec<f64>)>,
}

/// Boxes of parameters that one face of the box may take.
const CELLS: usize = 1 << 15;

/// The least box around forms and splines together: around their points, not their poles.
///
/// Poles over their weights bound a box of parameters, its corners are points: the boxes that may reach
/// farthest are halved until no point can be outside by more than `accuracy` times the size of the whole.
/// Bounds hold with all rounding: the box contains the forms.
///
/// Errors: `Shape` for different dimensions; `Domain` when `accuracy` is not between 0 and 1 or a form
/// goes to infinity; `Accuracy` when it would take too many boxes.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::bounding_box;
/// let arch: Form = Form::from_points(&[3], 2, &[0., 0., 1., 2., 2., 0.], None)?;
/// let tight = bounding_box(&[arch.into()], 1e-12)?;
/// assert!((tight.upper[1] - 1.0).abs() <= tight.error && tight.upper[1] >= 1.0); // its pole is at 2
/// assert_eq!(tight.highest[1].1, [0.5]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn bounding_box(shapes: &[Shape], accuracy: f64) -> Result<BoundingBox> {
    require_accuracy(accuracy)?;
    let ambient = same_dimension(shapes)?;
    let mut pieces = Vec::new();
    for (number, shape) in shapes.iter().enumerate() {
        pieces.extend(patches(shape)?.into_iter().map(|patch| (number, patch)));
    }
    let forms: Vec<Form> = pieces.iter().map(|(_, patch)| patch.form.clone()).collect();
    let local = Local::new(&forms)?;
    let mut found = BoundingBox {
        lower: Vec::new(),
        upper: Vec::new(),
        error: 0.0,
        lowest: Vec::new(),
        highest: Vec::new(),
    };
    for axis in 0..ambient {
        for sign in [-1.0, 1.0] {
            let reached = Search::farthest(&local.pieces, axis, sign, accuracy)?;
            let (number, patch) = &pieces[reached.piece];
            let place = (*number, patch.whole(&reached.parameters));
            let outer = (sign * reached.bound + local.origin[axis]) * local.unit;
            // Rounded outwards.
            let slack =
                2.0 * f64::EPSILON * (outer.abs() + (local.origin[axis] * local.unit).abs());
            let outer = outer + sign * slack;
            if !outer.is_finite() {
                return Err(infinite());
            }
            found.error =
                found.error.max((reached.bound - reached.value) * local.unit + 2.0 * slack);
            if sign < 0.0 {
                found.lower.push(outer);
                found.lowest.push(place);
            } else {
                found.upper.push(outer);
                found.highest.push(place);
            }
        }
    }
    Ok(found)
}

fn same_dimension(shapes: &[Shape]) -> Result<usize> {
    let Some(first) = shapes.first() else {
        return Err(Error::shape("shapes", "none", "a form or more"));
    };
    let ambient = first.net().ambient();
    match shapes.iter().find(|shape| shape.net().ambient() != ambient) {
        None => Ok(ambient),
        Some(other) => Err(Error::shape(
            "shapes",
            format!("a form in dimension {}", other.net().ambient()),
            format!("dimension {ambient}, as the first"),
        )),
    }
}

/// How far the forms reach along an axis.
struct Reached {
    /// No point reaches farther.
    bound: f64,
    /// A point reaches so far.
    value: f64,
    piece: usize,
    /// Its parameters in the piece.
    parameters: Vec<f64>,
}

struct Search {
    reached: Reached,
    waiting: BinaryHeap<Cell>,
    /// The largest bound among boxes that were put aside.
    aside: f64,
    wanted: f64,
}

impl Search {
    fn farthest(pieces: &[Form], axis: usize, sign: f64, accuracy: f64) -> Result<Reached> {
        let nowhere = f64::NEG_INFINITY;
        let reached = Reached { bound: nowhere, value: nowhere, piece: 0, parameters: Vec::new() };
        let waiting = BinaryHeap::new();
        let mut search = Self { reached, waiting, aside: nowhere, wanted: accuracy };
        for (number, piece) in pieces.iter().enumerate() {
            search.add(Cell::whole(number, piece, axis, sign)?);
        }
        for _ in 0..CELLS {
            let Some(cell) = search.waiting.pop() else { break };
            if cell.bound <= search.reached.value + search.wanted {
                search.waiting.push(cell);
                break;
            }
            match cell.halves()? {
                Some(halves) => halves.into_iter().for_each(|half| search.add(half)),
                None if cell.bound.is_finite() => search.aside = search.aside.max(cell.bound),
                None => return Err(infinite()),
            }
        }
        let open = search.waiting.peek().map_or(nowhere, |cell| cell.bound);
        let bound = open.max(search.aside).max(search.reached.value);
        let off = bound - search.reached.value;
        if off <= accuracy {
            return Ok(Reached { bound, ..search.reached });
        }
        let expected = format!("a coarser one: the faces are known to {off:.1e}");
        Err(Error::accuracy("accuracy", accuracy, expected))
    }

    /// Takes down the corners of a box, and keeps it if it may reach farther.
    fn add(&mut self, cell: Cell) {
        for (parameters, value) in cell.corners() {
            if value > self.reached.value {
                self.reached.value = value;
                self.reached.piece = cell.piece;
                self.reached.parameters = parameters;
            }
        }
        if cell.bound <= self.reached.value + self.wanted {
            self.aside = self.aside.max(cell.bound);
        } else {
            self.waiting.push(cell);
        }
    }
}

/// A box of parameters; one coordinate, with its sign, and the weight there.
struct Cell {
    piece: usize,
    low: Vec<f64>,
    high: Vec<f64>,
    depth: usize,
    values: Form,
    bound: f64,
}

impl Cell {
    fn whole(piece: usize, form: &Form, axis: usize, sign: f64) -> Result<Self> {
        let poles = form.homogeneous().chunks_exact(form.width());
        let poles = poles.flat_map(|pole| [sign * pole[axis], pole[form.ambient()]]).collect();
        let values = Form::from_homogeneous(form.orders(), 1, poles)?;
        let axes = form.axes();
        Ok(Self::new(piece, vec![0.0; axes], vec![1.0; axes], 0, values))
    }

    fn new(piece: usize, low: Vec<f64>, high: Vec<f64>, depth: usize, values: Form) -> Self {
        let (mut bound, mut size) = (f64::NEG_INFINITY, 0.0_f64);
        for [x, weight] in values.homogeneous().as_chunks::<2>().0 {
            let here = if *weight > 0.0 { x / weight } else { f64::INFINITY };
            bound = bound.max(here);
            size = size.max(here.abs());
        }
        let steps: usize = values.orders().iter().sum::<usize>() * (depth + 1) + 4;
        let bound =
            if bound.is_finite() { bound + steps as f64 * f64::EPSILON * size } else { bound };
        // As soon as something is at infinity, so is the bound.
        let bound = if size.is_finite() { bound } else { f64::INFINITY };
        Self { piece, low, high, depth, values, bound }
    }

    fn corners(&self) -> impl Iterator<Item = (Vec<f64>, f64)> {
        let orders = self.values.orders();
        let poles = self.values.homogeneous().as_chunks::<2>().0;
        // An axis of one pole has both ends in it.
        let wide: Vec<usize> = (0..orders.len()).filter(|axis| orders[*axis] > 1).collect();
        (0..1_usize << wide.len()).filter_map(move |bits| {
            let far = |axis: usize| {
                wide.iter().position(|one| *one == axis).is_some_and(|k| bits >> k & 1 == 1)
            };
            let place = orders.iter().enumerate().fold(0, |place, (axis, order)| {
                place * order + if far(axis) { order - 1 } else { 0 }
            });
            let at = |axis| if far(axis) { self.high[axis] } else { self.low[axis] };
            let [x, weight] = poles[place];
            (weight > 0.0).then(|| ((0..orders.len()).map(at).collect(), x / weight))
        })
    }

    /// Both halves along the axis of the largest differences; `None` at the end of all digits.
    fn halves(&self) -> Result<Option<[Self; 2]>> {
        let Some(axis) = self.axis() else { return Ok(None) };
        let middle = f64::midpoint(self.low[axis], self.high[axis]);
        if !(self.low[axis] < middle && middle < self.high[axis]) {
            return Ok(None);
        }
        let (first, second) = split(&self.values, axis, &0.5)?;
        let (mut upper, mut lower) = (self.high.clone(), self.low.clone());
        (upper[axis], lower[axis]) = (middle, middle);
        let (depth, piece) = (self.depth + 1, self.piece);
        Ok(Some([
            Self::new(piece, self.low.clone(), upper, depth, first),
            Self::new(piece, lower, self.high.clone(), depth, second),
        ]))
    }

    fn axis(&self) -> Option<usize> {
        let orders = self.values.orders();
        let poles = self.values.homogeneous().as_chunks::<2>().0;
        let wide = |axis: &usize| orders[*axis] > 1;
        if !self.bound.is_finite() {
            // Where the weight may vanish there is nothing to compare.
            let mut turns = (0..orders.len()).map(|k| (self.depth + k) % orders.len());
            return turns.find(wide);
        }
        let value = |place: usize| poles[place][0] / poles[place][1];
        let variation = |axis: usize| {
            let inner: usize = orders[axis + 1..].iter().product();
            let inside = |place: &usize| place / inner % orders[axis] + 1 < orders[axis];
            let steps = (0..poles.len()).filter(inside);
            steps.map(|place| (value(place + inner) - value(place)).abs()).fold(0.0, f64::max)
        };
        let axes = (0..orders.len()).filter(wide).map(|axis| (variation(axis), axis));
        axes.rev().max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, axis)| axis)
    }
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        let places = || self.low.iter().zip(&other.low).map(|(a, b)| b.total_cmp(a));
        let first = self.bound.total_cmp(&other.bound).then(other.piece.cmp(&self.piece));
        first.then_with(|| places().find(|order| order.is_ne()).unwrap_or(Ordering::Equal))
    }
}
