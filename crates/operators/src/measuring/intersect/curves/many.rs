//! Many pairs of curves in one call.

use pforms_kernel::{Error, Form, Result, limit, threads};
use smallvec::SmallVec;

use super::flat::{Flat, views};
use super::root::Root;
use super::searches::Searches;
use super::{HIGHEST, margin};
use crate::measuring::intersect::answer::{ContactKind, Intersections};
use crate::measuring::intersect::intersect;

/// The contacts of many pairs of forms, one pair after another.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Crossings {
    /// Those of pair `i` are `starts[i]..starts[i + 1]`.
    pub starts: Vec<usize>,
    /// Parameters in the first form, then in the second.
    pub parameters: Vec<f64>,
    /// How they meet.
    pub kinds: Vec<ContactKind>,
    /// By how much a parameter may be off, at most.
    pub errors: Vec<f64>,
    /// For each pair: is it sure that there is nothing else?
    pub complete: Vec<bool>,
    /// The whole answer for pairs that share more than points.
    pub overlapping: Vec<(usize, Intersections)>,
}

/// What is known of a pair until all are done.
#[derive(Clone)]
enum Outcome {
    Quick(SmallVec<[Root; 4]>),
    Whole(Box<Intersections>),
}

/// Multiplications for a pair, about.
const COST: usize = 1 << 15;

/// Where the forms of each pair meet: [`intersect`] for thousands of pairs.
///
/// Errors: those of [`intersect`], the first of them.
///
/// ```
/// use pforms_kernel::Form;
/// let form = |points: &[f64]| Form::from_points(&[points.len() / 2], 2, points, None);
/// let (rising, falling) = (form(&[0., 0., 1., 1.])?, form(&[0., 1., 1., 0.])?);
/// let arch = form(&[0., 0., 0.5, 1.5, 1., 0.])?;
/// let found = pforms_operators::intersect_many(&[(&rising, &falling), (&arch, &falling)], 1e-14)?;
/// assert_eq!(found.starts, [0, 1, 3]);
/// assert_eq!(found.parameters[..2], [0.5, 0.5]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn intersect_many(pairs: &[(&Form, &Form)], accuracy: f64) -> Result<Crossings> {
    if !(0.0..=1.0).contains(&accuracy) {
        return Err(Error::domain("accuracy", accuracy, "a number from 0 to 1"));
    }
    limit::check::<Outcome>("the contacts", &[pairs.len()], 1)?;
    let mut outcomes = vec![Outcome::Quick(SmallVec::new()); pairs.len()];
    threads::fill_parts(&mut outcomes, 1, COST, |range, out| {
        let mut searches = Searches::new();
        for ((a, b), outcome) in pairs[range].iter().zip(out) {
            *outcome = if let Some(roots) = quick(&mut searches, a, b, accuracy) {
                Outcome::Quick(roots)
            } else {
                let whole = intersect(&(*a).clone().into(), &(*b).clone().into(), accuracy)?;
                Outcome::Whole(Box::new(whole))
            };
        }
        Ok(())
    })?;
    Ok(collected(outcomes))
}

/// The crossings of plane curves, if these are all there is.
fn quick(
    searches: &mut Searches,
    a: &Form,
    b: &Form,
    accuracy: f64,
) -> Option<SmallVec<[Root; 4]>> {
    let plain = |form: &Form| {
        form.axes() == 1
            && form.ambient() == 2
            && form.orders()[0] <= HIGHEST
            && form.homogeneous().chunks_exact(3).all(|pole| pole[2] > 0.0)
    };
    if !plain(a) || !plain(b) {
        return None;
    }
    let flat = Flat::new(a, b, &views(&[0, 1])[0]);
    let found = searches.run(&flat, margin(&[a, b], accuracy) * flat.scale, true);
    if !found.left.is_empty() {
        return None;
    }
    let mut roots: SmallVec<[Root; 4]> = found.roots.iter().copied().collect();
    roots.sort_unstable_by(|x, y| x.s.total_cmp(&y.s).then(x.t.total_cmp(&y.t)));
    Some(roots)
}

fn collected(outcomes: Vec<Outcome>) -> Crossings {
    let mut all = Crossings { starts: vec![0], ..Crossings::default() };
    for (i, outcome) in outcomes.into_iter().enumerate() {
        match outcome {
            Outcome::Quick(roots) => {
                for root in &roots {
                    all.parameters.extend([root.s, root.t]);
                    all.errors.push(root.error);
                    all.kinds.push(ContactKind::Crossing);
                }
                all.complete.push(true);
            }
            Outcome::Whole(whole) => {
                for contact in &whole.contacts {
                    all.parameters.extend(contact.first.iter().chain(&contact.second));
                    all.errors.push(contact.error);
                    all.kinds.push(contact.kind);
                }
                all.complete.push(whole.complete);
                if !whole.overlaps.is_empty() || !whole.branches.is_empty() {
                    all.overlapping.push((i, *whole));
                }
            }
        }
        all.starts.push(all.errors.len());
    }
    all
}
