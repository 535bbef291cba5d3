//! What an intersection is: points, shared arcs, curves, and what stayed undecided.

use crate::Spline;

/// Where two forms meet, and whether that is all.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Intersections {
    /// Isolated places, in the order of the parameters of the first form.
    pub contacts: Vec<Contact>,
    /// Arcs or parts that both forms share.
    pub overlaps: Vec<Overlap>,
    /// Curves in which two surfaces meet.
    pub branches: Vec<Branch>,
    /// Is it sure that there is nothing else?
    pub complete: bool,
    /// Boxes of parameters that may hold more.
    pub undecided: Vec<Undecided>,
}

/// How two forms meet at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactKind {
    /// They go through each other.
    Crossing,
    /// They have a tangent in common, or one has none.
    Tangent,
    /// They come nearer than the accuracy and are not known to meet.
    Touch,
}

impl ContactKind {
    /// The name on all faces.
    pub fn name(self) -> &'static str {
        match self {
            Self::Crossing => "crossing",
            Self::Tangent => "tangent",
            Self::Touch => "touch",
        }
    }
}

/// One place where two forms meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// Parameters in the first form.
    pub first: Vec<f64>,
    /// Parameters in the second form.
    pub second: Vec<f64>,
    /// The point.
    pub point: Vec<f64>,
    /// How they meet.
    pub kind: ContactKind,
    /// How many crossings fall together here: 1 for a crossing, 2 or more for a tangent; 0 where
    /// that is not known.
    pub order: usize,
    /// The distance of the two forms there; 0 when they are proved to meet.
    pub gap: f64,
    /// By how much a parameter may be off, at most.
    pub error: f64,
    /// Is it proved that they meet here, and once?
    pub proved: bool,
}

/// A part that two forms share: an arc of two curves, an arc of a curve in a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Overlap {
    /// Parameters in the first form where it begins and ends.
    pub first: [Vec<f64>; 2],
    /// Parameters in the second form at the same two points.
    pub second: [Vec<f64>; 2],
    /// How far the forms are apart along it, at most; 0 when they are the same.
    pub gap: f64,
    /// Is it proved that they are the same?
    pub proved: bool,
}

/// A curve in which two surfaces meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// In the parameters of the first surface.
    pub first: Spline,
    /// In the parameters of the second surface.
    pub second: Spline,
    /// In space.
    pub curve: Spline,
    /// How far it may be from either surface, at most.
    pub error: f64,
    /// Does it end where it begins?
    pub closed: bool,
    /// Do the surfaces touch along it?
    pub tangent: bool,
}

/// A box of parameters that may hold more than was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Undecided {
    /// Lower and upper corner in the parameters of the first form.
    pub first: [Vec<f64>; 2],
    /// Lower and upper corner in the parameters of the second form.
    pub second: [Vec<f64>; 2],
}

impl Intersections {
    /// The same seen from the second form.
    #[must_use]
    pub fn swapped(self) -> Self {
        let mut contacts: Vec<Contact> = self
            .contacts
            .into_iter()
            .map(|c| Contact { first: c.second, second: c.first, ..c })
            .collect();
        sort(&mut contacts);
        let overlaps = self.overlaps.into_iter();
        let branches = self.branches.into_iter();
        let undecided = self.undecided.into_iter();
        Self {
            contacts,
            overlaps: overlaps.map(|o| Overlap { first: o.second, second: o.first, ..o }).collect(),
            branches: branches.map(|b| Branch { first: b.second, second: b.first, ..b }).collect(),
            undecided: undecided.map(|u| Undecided { first: u.second, second: u.first }).collect(),
            complete: self.complete,
        }
    }
}

/// In the order of the parameters.
pub(super) fn sort(contacts: &mut [Contact]) {
    contacts.sort_by(|a, b| {
        let pairs = a.first.iter().chain(&a.second).zip(b.first.iter().chain(&b.second));
        pairs.map(|(x, y)| x.total_cmp(y)).find(|o| o.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
    });
}
