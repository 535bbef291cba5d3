//! The search for all feet of one point: on every face of every piece, and which of the places found
//! stand in the whole.

use pforms_kernel::{Error, Form, Result};

use super::field::{Field, Side};
use super::{Feet, Foot, FootKind};
use crate::measuring::invert::Doubt;
use crate::measuring::patches::Patch;
use crate::measuring::system::{BORDER, Limits, Solutions, solve};
use crate::measuring::vector::norm;

/// Points farther than this many sizes are refused: the equations would overflow.
const FARTHEST: f64 = 1e60;

/// The pieces, made ready.
pub(super) struct Search {
    pub patches: Vec<Patch>,
    /// How many along each axis.
    pub counts: Vec<usize>,
    /// Along which axes the shape ends where it begins.
    pub closed: Vec<bool>,
    pub unit: f64,
    pub limits: Limits,
}

/// How the distance changes from a place into the window, across the face it was found on.
enum Stand {
    /// It falls: no foot.
    Falls,
    /// No change is known: it is less than rounding.
    Level,
    /// It grows.
    Sure,
}

/// A place on a piece that may be a foot.
struct Candidate {
    patch: usize,
    face: Vec<Side>,
    local: Vec<f64>,
    radius: f64,
    proved: bool,
    kind: FootKind,
}

impl Search {
    /// The feet of a point.
    ///
    /// Errors: `Domain` for a point out of all proportion; those of evaluation.
    pub(super) fn feet(&self, point: &[f64]) -> Result<Feet> {
        let point: Vec<f64> = point.iter().map(|x| x / self.unit).collect();
        if let Some(x) = point.iter().find(|x| x.is_nan() || x.abs() > FARTHEST) {
            let expected = format!("points within {FARTHEST:e} times the size of the form");
            return Err(Error::domain("points", x * self.unit, expected));
        }
        let fields = self
            .patches
            .iter()
            .map(|patch| Field::new(&patch.form, &point))
            .collect::<Result<Vec<_>>>()?;
        let (mut candidates, mut doubts): (Vec<Candidate>, _) = (Vec::new(), Vec::new());
        for (number, field) in fields.iter().enumerate() {
            for face in faces(self.counts.len()) {
                self.on_face(number, field, &face, &mut candidates, &mut doubts)?;
            }
        }
        let mut feet = Feet { feet: Vec::new(), doubts };
        for mut candidate in candidates {
            match self.stands(&fields, &candidate) {
                Stand::Falls => continue,
                Stand::Sure => {}
                Stand::Level => {
                    // A foot of the window may be here, told by its own equations; if not by them,
                    // there is no more to tell.
                    candidate.proved = false;
                    candidate.kind = FootKind::Flat;
                }
            }
            let foot = self.foot(&fields, &candidate)?;
            if include(&mut feet.feet, &foot) && !foot.proved && candidate.radius == 0.0 {
                let (lower, upper) = (foot.parameters.clone(), foot.parameters);
                feet.doubts.push(Doubt { lower, upper });
            }
        }
        feet.feet.sort_by(|a, b| {
            let each = a.parameters.iter().zip(&b.parameters).map(|(s, t)| s.total_cmp(t));
            each.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
        });
        Ok(feet)
    }

    /// Adds the places of a face where nothing changes along its free axes.
    fn on_face(
        &self,
        patch: usize,
        field: &Field,
        face: &[Side],
        candidates: &mut Vec<Candidate>,
        doubts: &mut Vec<Doubt>,
    ) -> Result<()> {
        let fixed = |free: &[f64]| -> Vec<f64> {
            let mut free = free.iter();
            let at = |side: &Side| match side {
                Side::Free => free.next().copied().unwrap_or(0.0),
                Side::Low => 0.0,
                Side::High => 1.0,
            };
            face.iter().map(at).collect()
        };
        if !face.contains(&Side::Free) {
            let kind = FootKind::Minimum;
            candidates.push(Candidate {
                patch,
                face: face.to_vec(),
                local: fixed(&[]),
                radius: 0.0,
                proved: true,
                kind,
            });
            return Ok(());
        }
        let equations = field.on_face(face)?;
        let Solutions { roots, clusters, .. } = solve(&equations, &self.limits);
        for root in roots {
            let kind = FootKind::at(&equations, &root.parameters);
            let (local, radius) = (fixed(&root.parameters), root.radius);
            let face = face.to_vec();
            candidates.push(Candidate { patch, face, local, radius, proved: true, kind });
        }
        for cluster in clusters {
            let (local, radius) = (fixed(&cluster.parameters), cluster.width());
            let (kind, sides) = (FootKind::Flat, face.to_vec());
            let candidate = Candidate { patch, face: sides, local, radius, proved: false, kind };
            if !Self::may_stand(field, face, &fixed(&cluster.lower), &fixed(&cluster.upper)) {
                continue;
            }
            candidates.push(candidate);
            let whole = |corner: &[f64]| self.patches[patch].whole(&fixed(corner));
            doubts.push(Doubt { lower: whole(&cluster.lower), upper: whole(&cluster.upper) });
        }
        Ok(())
    }

    /// Can there be a foot in a part of a face, for all that is known of the axes across it?
    fn may_stand(field: &Field, face: &[Side], lower: &[f64], upper: &[f64]) -> bool {
        face.iter().enumerate().all(|(axis, side)| {
            let sign = match side {
                Side::Free => return true,
                Side::Low => 1.0,
                Side::High => -1.0,
            };
            field.equations.greatest(axis, sign, lower, upper) >= 0.0
        })
    }

    /// Does the distance not fall from there at first order, on any piece that it belongs to?
    fn stands(&self, fields: &[Field], candidate: &Candidate) -> Stand {
        let mut stand = Stand::Sure;
        for (patch, local) in self.neighbours(candidate) {
            let field = &fields[patch];
            let foot = seen(&fields[candidate.patch].seen, &candidate.local);
            let there = seen(&field.seen, &local);
            if !together(foot.as_deref(), there.as_deref()) {
                continue;
            }
            let inward = |axis: usize| match local[axis] {
                0.0 => 1.0,
                1.0 => -1.0,
                _ => 0.0,
            };
            let rates = field.equations.rates(&local, candidate.radius);
            for (axis, (value, slack)) in rates.into_iter().enumerate() {
                let value = inward(axis) * value;
                if value < -slack {
                    return Stand::Falls;
                }
                if candidate.face[axis] != Side::Free && value <= slack {
                    stand = Stand::Level;
                }
            }
        }
        stand
    }

    /// The piece of a candidate and those that meet it there, each with the place in it.
    fn neighbours(&self, candidate: &Candidate) -> Vec<(usize, Vec<f64>)> {
        let mut all = vec![(candidate.patch, candidate.local.clone())];
        let mut stride = 1;
        for (axis, count) in self.counts.iter().enumerate().rev() {
            let index = candidate.patch / stride % count;
            let goes_on = self.closed[axis];
            let across = match candidate.local[axis] {
                0.0 if index > 0 => Some((index - 1, 1.0)),
                0.0 if goes_on => Some((count - 1, 1.0)),
                1.0 if index + 1 < *count => Some((index + 1, 0.0)),
                1.0 if goes_on => Some((0, 0.0)),
                _ => None,
            };
            if let Some((to, t)) = across {
                let beyond = all.clone().into_iter().map(|(patch, mut local)| {
                    local[axis] = t;
                    (patch + to * stride - index * stride, local)
                });
                all.extend(beyond);
            }
            stride *= count;
        }
        all
    }

    fn foot(&self, fields: &[Field], candidate: &Candidate) -> Result<Foot> {
        let patch = &self.patches[candidate.patch];
        let offset = fields[candidate.patch].seen.at(&candidate.local)?;
        let point = patch.form.at(&candidate.local)?.iter().map(|x| x * self.unit).collect();
        let mut parameters = patch.whole(&candidate.local);
        for (axis, t) in parameters.iter_mut().enumerate() {
            // Where the shape closes the place has one pair of parameters too many.
            let last = self.patches[self.patches.len() - 1].window[axis].1;
            if self.closed[axis] && *t == last {
                *t = self.patches[0].window[axis].0;
            }
        }
        Ok(Foot {
            parameters,
            point,
            distance: norm(&offset) * self.unit,
            error: candidate.radius * patch.side(),
            kind: candidate.kind,
            proved: candidate.proved,
        })
    }
}

/// The place of a form, if it is finite.
fn seen(form: &Form, local: &[f64]) -> Option<Vec<f64>> {
    form.at(local).ok()
}

/// Pieces that meet do so to this part of the size; otherwise the spline is torn there.
const TORN: f64 = 1e-9;

fn together(a: Option<&[f64]>, b: Option<&[f64]>) -> bool {
    let (Some(a), Some(b)) = (a, b) else { return false };
    let gap: Vec<f64> = a.iter().zip(b).map(|(x, y)| x - y).collect();
    norm(&gap) <= TORN * (1.0 + norm(a))
}

/// All faces of a window, those of more dimensions first.
fn faces(axes: usize) -> Vec<Vec<Side>> {
    let mut all: Vec<Vec<Side>> = vec![Vec::new()];
    for _ in 0..axes {
        let longer = |face: Vec<Side>| {
            [Side::Free, Side::Low, Side::High].map(|side| [face.clone(), vec![side]].concat())
        };
        all = all.into_iter().flat_map(longer).collect();
    }
    all.sort_by_key(|face| face.iter().filter(|side| **side != Side::Free).count());
    all
}

/// Adds a foot unless it is one of those already there, found from another face or piece. Is it new?
fn include(feet: &mut Vec<Foot>, foot: &Foot) -> bool {
    let same = |other: &Foot| {
        let reach = 2.0 * (foot.error + other.error) + 2.0 * BORDER;
        let pairs = foot.parameters.iter().zip(&other.parameters);
        pairs.clone().all(|(s, t)| (s - t).abs() <= reach * (1.0 + s.abs()))
    };
    match feet.iter().position(same) {
        Some(i) if foot.proved && !feet[i].proved => feet[i] = foot.clone(),
        Some(_) => {}
        None => {
            feet.push(foot.clone());
            return true;
        }
    }
    false
}
