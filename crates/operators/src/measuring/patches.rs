//! The pieces of a form or spline, each with its window and the box of its poles.

use pforms_kernel::{Form, Result};

use crate::Shape;

/// A piece, as a form on the window from 0 to 1.
pub(super) struct Patch {
    pub form: Form,
    /// Where its window begins and ends along each axis of the whole.
    pub window: Vec<(f64, f64)>,
    /// The least and the greatest of each coordinate of the poles: the piece lies between. Without
    /// bound where the weights have not one sign.
    pub hull: Vec<(f64, f64)>,
}

/// All pieces, the last axis fastest.
///
/// Errors: `Limit`.
pub(super) fn patches(shape: &Shape) -> Result<Vec<Patch>> {
    let spline = match shape {
        Shape::Form(form) => {
            let window = vec![(0.0, 1.0); form.axes()];
            return Ok(vec![Patch { hull: hull(form), form: form.clone(), window }]);
        }
        Shape::Spline(spline) => spline,
    };
    let (breaks, counts) = (spline.breaks(), spline.counts());
    let place = |number: usize| {
        let mut rest = number;
        let mut window: Vec<(f64, f64)> = counts
            .iter()
            .zip(&breaks)
            .rev()
            .map(|(count, list)| {
                let i = rest % count;
                rest /= count;
                (list[i], list[i + 1])
            })
            .collect();
        window.reverse();
        window
    };
    let pieces = spline.pieces()?.into_iter().enumerate();
    Ok(pieces
        .map(|(number, form)| Patch { hull: hull(&form), form, window: place(number) })
        .collect())
}

impl Patch {
    /// Parameters of the whole for those of the piece: exactly the break where two pieces meet.
    pub(super) fn whole(&self, local: &[f64]) -> Vec<f64> {
        let ends = local.iter().zip(&self.window);
        let at = |(t, (from, to)): (&f64, &(f64, f64))| {
            if *t == 1.0 { *to } else { from + t * (to - from) }
        };
        ends.map(at).collect()
    }

    /// The longest side of the window.
    pub(super) fn side(&self) -> f64 {
        self.window.iter().fold(0.0, |most, (from, to)| most.max(to - from))
    }

    /// Can a point be nearer to the piece than `reach`?
    pub(super) fn may_reach(&self, point: &[f64], reach: f64) -> bool {
        // A few roundings of the poles count too.
        point.iter().zip(&self.hull).all(|(x, (low, high))| {
            let slack = reach + 8.0 * f64::EPSILON * (low.abs().max(high.abs()));
            !(*x < low - slack || *x > high + slack)
        })
    }
}

/// Does the whole end where it begins along an axis: are the poles of both ends the same?
///
/// `counts` are the pieces along each axis; it is enough that poles agree to a rounding or two.
pub(super) fn is_closed(patches: &[Patch], counts: &[usize], axis: usize) -> bool {
    let stride: usize = counts[axis + 1..].iter().product();
    let across = stride * counts[axis];
    (0..patches.len()).filter(|number| (number / stride).is_multiple_of(counts[axis])).all(
        |first| {
            let last = first + across - stride;
            let (low, high) =
                (end(&patches[first].form, axis, false), end(&patches[last].form, axis, true));
            let size = low.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            low.iter().zip(&high).all(|(x, y)| (x - y).abs() <= 16.0 * f64::EPSILON * size)
        },
    )
}

/// The poles at one end of an axis.
fn end(form: &Form, axis: usize, far: bool) -> Vec<f64> {
    let inner = form.orders()[axis + 1..].iter().product::<usize>() * form.width();
    let order = form.orders()[axis];
    let skip = if far { order - 1 } else { 0 };
    let blocks = form.homogeneous().chunks_exact(order * inner);
    blocks.flat_map(|block| &block[skip * inner..][..inner]).copied().collect()
}

/// The diagonal of the box of all finite poles.
pub(super) fn size(patches: &[Patch]) -> f64 {
    let Some(first) = patches.first() else { return 0.0 };
    let side = |k: usize| {
        let ends = patches.iter().map(|patch| patch.hull[k]);
        let (low, high) = ends
            .filter(|(low, high)| low.is_finite() && high.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), (low, high)| {
                (a.min(low), b.max(high))
            });
        (high - low).max(0.0)
    };
    (0..first.hull.len()).map(side).fold(0.0_f64, f64::hypot)
}

/// The box of the poles, which holds the form if its weights have one sign.
fn hull(form: &Form) -> Vec<(f64, f64)> {
    let (poles, last) = (form.homogeneous().chunks_exact(form.width()), form.ambient());
    let one_sign =
        poles.clone().all(|pole| pole[last] > 0.0) || poles.clone().all(|pole| pole[last] < 0.0);
    if !one_sign {
        return vec![(f64::NEG_INFINITY, f64::INFINITY); last];
    }
    let coordinate = |k: usize| poles.clone().map(move |pole| pole[k] / pole[last]);
    let ends = |k: usize| {
        coordinate(k).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)))
    };
    (0..last).map(ends).collect()
}
