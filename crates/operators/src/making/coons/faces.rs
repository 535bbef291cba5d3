//! The faces of a box: which is where, and what they are called.

use pforms_kernel::{Error, Form, Result, Scalar};

use crate::algebra::raise_to;

/// Two faces for each axis, those across the last axis first.
#[derive(Clone)]
pub(super) struct Faces<S> {
    forms: Vec<Form<S>>,
}

/// Where a sub-face lies: at the start or the end of some axes, along the others.
pub(super) type Place = Vec<Option<usize>>;

impl<S: Scalar> Faces<S> {
    pub(super) fn new(given: &[&Form<S>]) -> Result<Self> {
        let axes = given.len() / 2;
        if given.is_empty() || given.len() % 2 == 1 {
            let expected = "two faces for each axis: 2 points, 4 curves, 6 surfaces, …";
            return Err(Error::shape("faces", given.len(), expected));
        }
        for (index, form) in given.iter().enumerate() {
            if form.axes() + 1 != axes || form.ambient() != given[0].ambient() {
                return Err(Error::shape(
                    "faces",
                    format!("a {} in {}D as face {index}", form.kind(), form.ambient()),
                    format!(
                        "{} faces with {} axes in {}D",
                        given.len(),
                        axes - 1,
                        given[0].ambient()
                    ),
                ));
            }
        }
        Ok(Self { forms: given.iter().map(|form| (*form).clone()).collect() })
    }

    /// Faces from forms that have all axes of the patch: each face is where its own form begins, for
    /// along the axis it stands across the form is the same everywhere.
    pub(super) fn of_whole(forms: &[Form<S>]) -> Result<Self> {
        let axes = forms.len() / 2;
        let face = |(index, form)| end(form, axes - 1 - index / 2, 0);
        Ok(Self { forms: forms.iter().enumerate().map(face).collect::<Result<_>>()? })
    }

    /// The same faces from other forms.
    pub(super) fn with(&self, forms: Vec<Form<S>>) -> Self {
        debug_assert_eq!(forms.len(), self.forms.len());
        Self { forms }
    }

    pub(super) fn forms(&self) -> &[Form<S>] {
        &self.forms
    }

    /// Axes of the patch.
    pub(super) fn axes(&self) -> usize {
        self.forms.len() / 2
    }

    /// Orders of the patch: the largest of any face along each axis, and at least 2.
    pub(super) fn orders(&self) -> Vec<usize> {
        let mut orders = vec![2; self.axes()];
        for (index, form) in self.forms.iter().enumerate() {
            let (across, _) = self.place(index);
            let along = (0..self.axes()).filter(|&axis| axis != across);
            for (axis, order) in along.zip(form.orders()) {
                orders[axis] = orders[axis].max(*order);
            }
        }
        orders
    }

    /// All faces with the orders of the patch.
    pub(super) fn raised(&self) -> Result<Self> {
        let orders = self.orders();
        let raise = |(index, form): (usize, &Form<S>)| {
            let mut own = orders.clone();
            own.remove(self.place(index).0);
            raise_to(form, &own)
        };
        Ok(self.with(self.forms.iter().enumerate().map(raise).collect::<Result<_>>()?))
    }

    /// The axis that a face stands across, and on which side: 0 or 1.
    pub(super) fn place(&self, index: usize) -> (usize, usize) {
        (self.axes() - 1 - index / 2, index % 2)
    }

    /// The face across an axis, on a side.
    pub(super) fn index(&self, axis: usize, side: usize) -> usize {
        2 * (self.axes() - 1 - axis) + side
    }

    /// The first given of the faces that a corner or edge belongs to.
    pub(super) fn first_at(&self, place: &[Option<usize>]) -> usize {
        let fixed = place.iter().enumerate().rev();
        let mut faces = fixed.filter_map(|(axis, side)| side.map(|side| self.index(axis, side)));
        faces.next().unwrap_or(0)
    }

    /// The part of a face that lies at a place, which must be on the face.
    pub(super) fn part(&self, index: usize, place: &[Option<usize>]) -> Result<Form<S>> {
        let (across, _) = self.place(index);
        let mut part = self.forms[index].clone();
        for axis in (0..self.axes()).rev().filter(|&axis| axis != across) {
            if let Some(side) = place[axis] {
                part = end(&part, axis - usize::from(axis > across), side)?;
            }
        }
        Ok(part)
    }

    /// What an error calls a face: `curve v=0`.
    pub(super) fn name(&self, index: usize) -> String {
        let (axis, side) = self.place(index);
        let what = match self.axes() {
            1 => "point",
            2 => "curve",
            3 => "surface",
            _ => "face",
        };
        format!("{what} {}={side}", axis_name(axis))
    }

    /// What an error calls a place: `corner (u, v) = (1, 0)`, `edge w=0, v=1`.
    pub(super) fn place_name(place: &[Option<usize>]) -> String {
        if place.iter().all(Option::is_some) {
            let names: Vec<String> = (0..place.len()).map(axis_name).collect();
            let sides: Vec<String> = place.iter().flatten().map(usize::to_string).collect();
            return format!("corner ({}) = ({})", names.join(", "), sides.join(", "));
        }
        let fixed = place
            .iter()
            .enumerate()
            .rev()
            .filter_map(|(axis, side)| side.map(|side| format!("{}={side}", axis_name(axis))));
        format!("edge {}", fixed.collect::<Vec<_>>().join(", "))
    }
}

fn axis_name(axis: usize) -> String {
    ["u", "v", "w"].get(axis).map_or_else(|| format!("t{axis}"), |name| (*name).to_owned())
}

/// The poles at the start or the end of an axis: the sub-form there.
fn end<S: Scalar>(form: &Form<S>, axis: usize, side: usize) -> Result<Form<S>> {
    let mut orders = form.orders().to_vec();
    let order = orders.remove(axis);
    let inner = orders[axis..].iter().product::<usize>() * form.width();
    let start = side * (order - 1) * inner;
    let blocks = form.homogeneous().chunks_exact(order * inner);
    let poles = blocks.flat_map(|block| block[start..start + inner].iter().cloned());
    Form::from_homogeneous(&orders, form.ambient(), poles.collect())
}
