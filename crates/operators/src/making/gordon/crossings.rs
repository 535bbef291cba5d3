//! Where two curves cross, or come as near as is asked.

use pforms_kernel::{Result, limit};

use super::path::{Path, Side};
use crate::measuring::vector::{dot, norm, plus};

/// Parameters on both curves, and the distance between the points there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    pub s: f64,
    pub t: f64,
    pub gap: f64,
}

/// Crossings nearer to each other, in both parameters, are one.
const APART: f64 = 1e-5;

/// Every place where the curves come within `reach` of each other and no nearer beside it, in the
/// order of the first parameter; without any, the nearest alone.
///
/// Points along both curves are compared, and each pair that is nearer than its neighbours is
/// improved by damped Gauss–Newton steps.
pub(super) fn crossings(a: &Path, b: &Path, reach: f64) -> Result<Vec<Crossing>> {
    let (s, t) = (a.parameters(), b.parameters());
    let width = a.spline().ambient();
    let (here, there) = (a.points(&s)?, b.points(&t)?);
    let (p, q) = (rows(&here, width), rows(&there, width));
    limit::check::<f64>("the distances", &[s.len(), t.len()], 1)?;
    let apart: Vec<Vec<f64>> =
        p.iter().map(|x| q.iter().map(|y| norm(&plus(x, -1.0, y))).collect()).collect();
    let (across, along) = (steps(&p), steps(&q));
    let mut found: Vec<Crossing> = Vec::new();
    let mut nearest: Option<Crossing> = None;
    for (k, row) in apart.iter().enumerate() {
        for (l, &distance) in row.iter().enumerate() {
            let beside = |i: usize, count: usize| i.saturating_sub(1)..(i + 2).min(count);
            let least =
                beside(k, p.len()).all(|i| beside(l, q.len()).all(|j| apart[i][j] >= distance));
            if !least {
                continue;
            }
            let near = distance <= across[k] + along[l] + reach;
            if !near && nearest.is_some_and(|best| best.gap <= distance) {
                continue;
            }
            let crossing = improved(a, b, Crossing { s: s[k], t: t[l], gap: distance })?;
            if nearest.is_none_or(|best| crossing.gap < best.gap) {
                nearest = Some(crossing);
            }
            if crossing.gap <= reach {
                keep(&mut found, crossing);
            }
        }
    }
    if found.is_empty() {
        found.extend(nearest);
    }
    found.sort_by(|x, y| x.s.total_cmp(&y.s));
    Ok(found)
}

fn rows(points: &[f64], width: usize) -> Vec<&[f64]> {
    points.chunks_exact(width).collect()
}

/// The longer of the two steps beside each point.
fn steps(points: &[&[f64]]) -> Vec<f64> {
    let gaps: Vec<f64> = points.windows(2).map(|x| norm(&plus(x[1], -1.0, x[0]))).collect();
    let gap = |i: usize| gaps.get(i).copied().unwrap_or(0.0);
    (0..points.len()).map(|i| if i == 0 { gap(0) } else { gap(i).max(gap(i - 1)) }).collect()
}

fn keep(found: &mut Vec<Crossing>, new: Crossing) {
    let same = |old: &&mut Crossing| (old.s - new.s).abs() < APART && (old.t - new.t).abs() < APART;
    match found.iter_mut().find(same) {
        None => found.push(new),
        Some(old) if new.gap < old.gap => *old = new,
        Some(_) => {}
    }
}

/// The nearest pair of points downhill from a start.
fn improved(a: &Path, b: &Path, start: Crossing) -> Result<Crossing> {
    const STEPS: usize = 60;
    let (mut best, mut damping) = (start, 1e-9);
    for _ in 0..STEPS {
        let residual = plus(&a.at(best.s)?, -1.0, &b.at(best.t)?);
        let forward = a.velocity(best.s, Side::After)?;
        let backward: Vec<f64> = b.velocity(best.t, Side::After)?.iter().map(|x| -x).collect();
        let Some([ds, dt]) = step(&forward, &backward, &residual, best, damping) else { break };
        let next = [(best.s + ds).clamp(0.0, 1.0), (best.t + dt).clamp(0.0, 1.0)];
        let gap = norm(&plus(&a.at(next[0])?, -1.0, &b.at(next[1])?));
        let moved = (next[0] - best.s).abs().max((next[1] - best.t).abs());
        if gap < best.gap {
            best = Crossing { s: next[0], t: next[1], gap };
            damping = (damping * 0.1).max(1e-12);
        } else {
            damping *= 10.0;
        }
        if moved < 1e-16 || damping > 1e9 {
            break;
        }
    }
    Ok(best)
}

/// The step of Gauss and Newton, damped; a parameter at an end does not go beyond.
fn step(
    forward: &[f64],
    backward: &[f64],
    residual: &[f64],
    at: Crossing,
    damping: f64,
) -> Option<[f64; 2]> {
    let gradient = [dot(forward, residual), dot(backward, residual)];
    let held = |t: f64, slope: f64| (t <= 0.0 && slope > 0.0) || (t >= 1.0 && slope < 0.0);
    let (mut aa, mut bb, ab) =
        (dot(forward, forward), dot(backward, backward), dot(forward, backward));
    // Where a curve stands still there is nothing to be gained by its parameter.
    let held = [held(at.s, gradient[0]) || aa == 0.0, held(at.t, gradient[1]) || bb == 0.0];
    aa *= 1.0 + damping;
    bb *= 1.0 + damping;
    let solved = match held {
        [true, true] => return None,
        [true, false] => [0.0, -gradient[1] / bb],
        [false, true] => [-gradient[0] / aa, 0.0],
        [false, false] => {
            let determinant = aa * bb - ab * ab;
            [
                (ab * gradient[1] - bb * gradient[0]) / determinant,
                (ab * gradient[0] - aa * gradient[1]) / determinant,
            ]
        }
    };
    solved.iter().all(|x| x.is_finite()).then_some(solved)
}
