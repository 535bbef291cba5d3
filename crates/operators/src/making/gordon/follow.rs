//! Curves run through at another pace: cubic splines over common knots, within a tolerance.

use pforms_kernel::{Error, Form, Result, limit};

use super::pace::Pace;
use super::path::{Path, Side};
use crate::algebra::Spline;
use crate::measuring::vector::{norm, plus};

/// Knots nearer than this are one.
const SAME: f64 = 1e-9;

/// The narrowest piece.
const NARROW: f64 = 1e-6;

/// A knot, and whether some curve has a corner there.
#[derive(Clone, Copy)]
struct Break {
    at: f64,
    corner: bool,
}

/// Each path at its pace as a cubic spline from 0 to 1, all over the same knots: at each knot it has
/// the point and the velocity of the path, and between knots it stays within `tolerance` at the
/// points that are looked at. Pieces are halved until it does.
///
/// Errors: `Accuracy` when pieces get too narrow; `Limit`.
pub(super) fn followed(
    paths: &[Path],
    paces: &[Pace],
    places: &[f64],
    tolerance: f64,
) -> Result<Vec<Spline>> {
    let mut breaks = first_breaks(paths, paces, places)?;
    let mut k = 0;
    while k + 1 < breaks.len() {
        let (from, to) = (breaks[k].at, breaks[k + 1].at);
        let mut off = 0.0_f64;
        for (path, pace) in paths.iter().zip(paces) {
            off = off.max(deviation(path, pace, from, to)?);
        }
        if off <= tolerance {
            k += 1;
            continue;
        }
        if to - from < NARROW {
            let expected = format!("{tolerance:e} with pieces of {NARROW} at least");
            return Err(Error::accuracy("accuracy", format!("{off:e} off"), expected));
        }
        breaks.insert(k + 1, Break { at: 0.5 * (from + to), corner: false });
        limit::check::<f64>("the curve", &[3 * breaks.len()], 4)?;
    }
    paths.iter().zip(paces).map(|(path, pace)| spline(path, pace, &breaks)).collect()
}

/// The places, the ends, and the corners of all curves.
fn first_breaks(paths: &[Path], paces: &[Pace], places: &[f64]) -> Result<Vec<Break>> {
    let plain = |at: f64| Break { at, corner: false };
    let mut breaks: Vec<Break> = places.iter().copied().chain([0.0, 1.0]).map(plain).collect();
    for (path, pace) in paths.iter().zip(paces) {
        for kink in path.kinks()? {
            let at = pace.inverse(kink);
            match breaks.iter_mut().find(|known| (known.at - at).abs() < SAME) {
                Some(known) => known.corner = true,
                None => breaks.push(Break { at, corner: true }),
            }
        }
    }
    breaks.sort_by(|a, b| a.at.total_cmp(&b.at));
    breaks.dedup_by(|b, a| b.at == a.at);
    Ok(breaks)
}

/// The poles of the cubic with the points and velocities of the path at both ends.
fn cubic(path: &Path, pace: &Pace, from: f64, to: f64) -> Result<[Vec<f64>; 4]> {
    let third = (to - from) / 3.0;
    let end = |u: f64, side: Side, reach: f64| -> Result<[Vec<f64>; 2]> {
        let (t, rate) = pace.at(u);
        let point = path.at(t)?;
        let next = plus(&point, reach * rate, &path.velocity(t, side)?);
        Ok([point, next])
    };
    let [a, b] = end(from, Side::After, third)?;
    let [d, c] = end(to, Side::Before, -third)?;
    Ok([a, b, c, d])
}

/// How far the cubic is from the path, at points between its ends.
fn deviation(path: &Path, pace: &Pace, from: f64, to: f64) -> Result<f64> {
    const LOOKS: usize = 8;
    let poles = cubic(path, pace, from, to)?.concat();
    let ambient = path.spline().ambient();
    let form: Form = Form::from_points(&[4], ambient, &poles, None)?;
    let mut most = 0.0_f64;
    for i in 1..LOOKS {
        let local = i as f64 / LOOKS as f64;
        let there = path.at(pace.at(from + local * (to - from)).0)?;
        most = most.max(norm(&plus(&form.at(&[local])?, -1.0, &there)));
    }
    Ok(most)
}

/// The cubics end to end: neighbours share a pole only at corners, for elsewhere it is between the
/// poles beside it.
fn spline(path: &Path, pace: &Pace, breaks: &[Break]) -> Result<Spline> {
    let ambient = path.spline().ambient();
    let (mut points, mut knots) = (Vec::new(), vec![0.0; 4]);
    let last = breaks.len() - 2;
    for (k, pair) in breaks.windows(2).enumerate() {
        let [a, b, c, d] = cubic(path, pace, pair[0].at, pair[1].at)?;
        if k == 0 {
            points.extend(a);
        }
        points.extend(b.into_iter().chain(c));
        let corner = pair[1].corner;
        if corner || k == last {
            points.extend(d);
        }
        if k < last {
            knots.extend(vec![pair[1].at; if corner { 3 } else { 2 }]);
        }
    }
    knots.extend([1.0; 4]);
    let net = Form::from_points(&[points.len() / ambient], ambient, &points, None)?;
    Spline::new(net, &[3], vec![knots])
}
