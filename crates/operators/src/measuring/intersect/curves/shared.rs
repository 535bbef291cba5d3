//! Parts of one curve: the arcs that they share, and where the curve comes back to itself.

use pforms_kernel::{Form, Result};

use super::closest::{closest, jet};
use super::flat::{Flat, views};
use super::leftover::{Window, contact_in, gathered, undecided};
use super::overlap::{ends, overlaps};
use super::searches::Searches;
use super::settle::met;
use super::settled;
use super::touches::stay_near;
use crate::measuring::intersect::answer::{Contact, Intersections, Overlap, Undecided};
use crate::measuring::intersect::exact::Meeting;
use crate::measuring::vector::norm;
use crate::stretch;

/// Arcs of one curve are the same if their computed ends are.
const ARC: f64 = 1e-12;

/// What two parts of one curve have in common; `answer` holds the crossings that were found.
///
/// Errors: those of projection on either curve.
pub(super) fn shared(
    a: &Form,
    b: &Form,
    live: &[usize],
    left: &[Window],
    margin: f64,
    answer: &mut Intersections,
) -> Result<()> {
    let margin = margin.max(ARC);
    answer.overlaps = overlaps(a, b, margin)?;
    answer.overlaps.iter_mut().for_each(|overlap| {
        overlap.gap = 0.0;
        overlap.proved = true;
    });
    let ends = ends(a, b, margin)?;
    if answer.overlaps.is_empty() {
        // Neither at the speed of the other up to a homography: the same arc nevertheless.
        for pair in ends.windows(2) {
            let ([s, t], [u, v]) = (pair[0], pair[1]);
            let long = u - s > BESIDE && (v - t).abs() > BESIDE;
            if long && stay_near(a, b, pair[0], pair[1], margin) {
                let (first, second) = ([vec![s], vec![u]], [vec![t], vec![v]]);
                answer.overlaps.push(Overlap { first, second, gap: 0.0, proved: true });
            }
        }
    }
    if answer.overlaps.is_empty() {
        let at_end = |w: &Window| {
            let near = |x: f64, [from, to]: [f64; 2]| from - BESIDE <= x && x <= to + BESIDE;
            ends.iter().any(|end| near(end[0], w[0]) && near(end[1], w[1]))
        };
        for window in gathered(left).iter().filter(|window| !at_end(window)) {
            match contact_in(a, b, window, margin) {
                Ok(found) => answer.contacts.extend(found),
                Err(window) => answer.undecided.push(window),
            }
        }
    } else {
        answer.contacts.clear();
        beside(a, b, margin, answer)?;
        for overlap in answer.overlaps.clone() {
            nodes(a, b, live, &overlap, answer)?;
        }
    }
    if turns_back(a)? || turns_back(b)? {
        // The same arc run to and fro: which shares belong together is not looked into.
        answer.undecided.push(undecided(&[[0.0, 1.0], [0.0, 1.0]]));
    }
    for [s, t] in ends {
        let mut contact = met(a, &Meeting { s, t, order: 0 });
        contact.error = ARC;
        answer.contacts.push(contact);
    }
    Ok(())
}

/// Windows as near to an end as this are explained by it.
const BESIDE: f64 = 1e-6;

/// What curves that share arcs have in common beside them: the rest of the first curve meets the second,
/// the arcs meet the rest of the second.
fn beside(a: &Form, b: &Form, margin: f64, answer: &mut Intersections) -> Result<()> {
    let arcs = |of: &dyn Fn(&Overlap) -> [f64; 2]| -> Vec<[f64; 2]> {
        let sorted = |[from, to]: [f64; 2]| [from.min(to), from.max(to)];
        answer.overlaps.iter().map(|overlap| sorted(of(overlap))).collect()
    };
    let first = arcs(&|o| [o.first[0][0], o.first[1][0]]);
    let second = arcs(&|o| [o.second[0][0], o.second[1][0]]);
    let mut pairs: Vec<Window> = rest(&first).into_iter().map(|s| [s, [0.0, 1.0]]).collect();
    let others = rest(&second);
    pairs.extend(first.iter().flat_map(|s| others.iter().map(move |t| [*s, *t])));
    for [s, t] in pairs {
        let (p, q) = (stretch(a, &s[..1], &s[1..])?, stretch(b, &t[..1], &t[1..])?);
        let found = settled(&p, &q, margin)?;
        let at = |[from, to]: [f64; 2], x: &[f64]| vec![from + x[0] * (to - from)];
        answer.contacts.extend(found.contacts.into_iter().map(|c| Contact {
            first: at(s, &c.first),
            second: at(t, &c.second),
            error: c.error.max(ARC),
            ..c
        }));
        answer.undecided.extend(found.undecided.into_iter().map(|u| Undecided {
            first: u.first.map(|x| at(s, &x)),
            second: u.second.map(|x| at(t, &x)),
        }));
    }
    Ok(())
}

/// What is left of the window from 0 to 1.
fn rest(arcs: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sorted = arcs.to_vec();
    sorted.sort_by(|x, y| x[0].total_cmp(&y[0]));
    let mut rest = Vec::new();
    let mut from = 0.0;
    for [start, end] in sorted {
        rest.push([from, start]);
        from = f64::max(from, end);
    }
    rest.push([from, 1.0]);
    rest.retain(|[from, to]| to - from > 1e-9);
    rest
}

/// An arc is cut in so many parts to find where it crosses itself.
const PARTS: usize = 16;

/// The crossings of an arc with itself: both curves pass them twice.
fn nodes(
    a: &Form,
    b: &Form,
    live: &[usize],
    overlap: &Overlap,
    answer: &mut Intersections,
) -> Result<()> {
    let ([from, to], [start, end]) =
        (overlap.first.each_ref().map(|x| x[0]), overlap.second.each_ref().map(|x| x[0]));
    let at = |x: f64| from + x * (to - from);
    let cut = |i: usize, j: usize| {
        stretch(a, &[at(i as f64 / PARTS as f64)], &[at(j as f64 / PARTS as f64)])
    };
    let parts = (0..PARTS).map(|i| cut(i, i + 1)).collect::<Result<Vec<_>>>()?;
    let mut doubt = false;
    for i in 1..PARTS {
        doubt |= !turns_little(&cut(i - 1, i + 1)?);
    }
    let view = &views(live)[0];
    let mut searches = Searches::new();
    for i in 0..PARTS {
        for j in i + 2..PARTS {
            let flat = Flat::new(&parts[i], &parts[j], view);
            let found = searches.run(&flat, 0.0, false);
            doubt |= !found.left.is_empty();
            for root in &found.roots {
                let s = [i as f64 + root.s, j as f64 + root.t].map(|x| at(x / PARTS as f64));
                // In space they may pass each other.
                if distance(a, s) > ARC {
                    continue;
                }
                // The same points on the other curve, each near its share of the arc.
                let feet = s.map(|s| {
                    let share = start + (s - from) / (to - from) * (end - start);
                    closest(a, b, [s, share], &[[s, s], [start.min(end), start.max(end)]])
                });
                let apart = (feet[0].t - feet[1].t).abs() > BESIDE;
                if !apart || feet.iter().any(|foot| foot.gap > ARC) {
                    doubt = true;
                    continue;
                }
                for (s, t) in [(s[0], feet[1].t), (s[1], feet[0].t)] {
                    let mut contact = met(a, &Meeting { s, t, order: 1 });
                    contact.error = ARC.max(root.error);
                    answer.contacts.push(contact);
                }
            }
        }
    }
    if doubt {
        answer.undecided.push(undecided(&[[from, to], [start.min(end), start.max(end)]]));
    }
    Ok(())
}

/// The distance of two points of a curve.
fn distance(a: &Form, [s, t]: [f64; 2]) -> f64 {
    let (p, q) = (jet(a, s).0, jet(a, t).0);
    norm(&p.iter().zip(&q).map(|(x, y)| x - y).collect::<Vec<_>>())
}

/// May a curve stop and go back on itself?
fn turns_back(form: &Form) -> Result<bool> {
    let at = |i: usize| [i as f64 / PARTS as f64];
    for i in 1..PARTS {
        if !turns_little(&stretch(form, &at(i - 1), &at(i + 1))?) {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Does a curve turn by less than half a turn? Then it does not cross itself.
fn turns_little(form: &Form) -> bool {
    let last = form.ambient();
    let poles: Vec<Vec<f64>> = form
        .homogeneous()
        .chunks_exact(form.width())
        .map(|pole| pole[..last].iter().map(|x| x / pole[last]).collect())
        .collect();
    let steps: Vec<Vec<f64>> = poles
        .windows(2)
        .map(|pair| pair[1].iter().zip(&pair[0]).map(|(x, y)| x - y).collect())
        .collect();
    let dot = |p: &[f64], q: &[f64]| p.iter().zip(q).map(|(x, y)| x * y).sum::<f64>();
    let whole: Vec<f64> = (0..last).map(|k| poles[poles.len() - 1][k] - poles[0][k]).collect();
    steps.iter().all(|step| dot(step, &whole) > 0.0)
}
