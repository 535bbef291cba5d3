//! Pieces in one spline, joined where they meet.

use pforms_kernel::{Form, Result, limit};

use crate::{Spline, raise_together, sub};

/// Roundings by which poles that are the same may differ.
const SAME: f64 = 4096.0 * f64::EPSILON;

/// The spline of forms that lie side by side, in C order, between these breaks; and the largest gap.
///
/// Where the end poles of all neighbours agree they become one; elsewhere both stay.
pub(in crate::making) fn joined(forms: &[Form], breaks: &[Vec<f64>]) -> Result<(Spline, f64)> {
    let forms = raise_together(&forms.iter().collect::<Vec<_>>())?;
    let counts: Vec<usize> = breaks.iter().map(|list| list.len() - 1).collect();
    let mut gap = 0.0_f64;
    let (mut starts, mut orders, mut knots) = (Vec::new(), Vec::new(), Vec::new());
    for (axis, list) in breaks.iter().enumerate() {
        let degree = forms[0].orders()[axis] - 1;
        let mut begin = vec![0];
        let mut vector = vec![list[0]; degree + 1];
        for joint in 1..counts[axis] {
            let apart = apart(&forms, &counts, axis, joint)?;
            gap = gap.max(apart.unwrap_or(0.0));
            let shared = apart.is_none() && degree > 0;
            begin.push(begin[joint - 1] + degree + usize::from(!shared));
            vector.extend(vec![list[joint]; degree + usize::from(!shared)]);
        }
        vector.extend(vec![list[counts[axis]]; degree + 1]);
        orders.push(begin[counts[axis] - 1] + degree + 1);
        starts.push(begin);
        knots.push(vector);
    }
    let net = gathered(&forms, &counts, &starts, &orders)?;
    Ok((Spline::new(net, &forms[0].degrees(), knots)?, gap))
}

/// The largest distance across a joint, when the poles there differ.
fn apart(forms: &[Form], counts: &[usize], axis: usize, joint: usize) -> Result<Option<f64>> {
    let stride: usize = counts[axis + 1..].iter().product();
    let mut largest: Option<f64> = None;
    for flat in (0..forms.len()).filter(|flat| flat / stride % counts[axis] == joint) {
        let before = sub(&forms[flat - stride], axis, &1.0)?;
        let after = sub(&forms[flat], axis, &0.0)?;
        let size = before.homogeneous().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let pairs = || before.homogeneous().iter().zip(after.homogeneous());
        if pairs().any(|(x, y)| (x - y).abs() > SAME * size) {
            let lists = vec![[0.0, 0.25, 0.5, 0.75, 1.0]; before.axes()];
            let lists: Vec<&[f64]> = lists.iter().map(<[f64; 5]>::as_slice).collect();
            let (here, there) = (before.grid(&lists)?, after.grid(&lists)?);
            let points =
                here.chunks_exact(before.ambient()).zip(there.chunks_exact(after.ambient()));
            let distance = points.map(|(p, q)| {
                crate::measuring::vector::norm(&crate::measuring::vector::plus(p, -1.0, q))
            });
            largest = Some(distance.fold(largest.unwrap_or(0.0), f64::max));
        }
    }
    Ok(largest)
}

/// All poles in one array; of two that are the same the first.
fn gathered(
    forms: &[Form],
    counts: &[usize],
    starts: &[Vec<usize>],
    orders: &[usize],
) -> Result<Form> {
    let width = forms[0].width();
    let mut poles = vec![0.0; limit::check::<f64>("the parallel", orders, width)?];
    for (flat, form) in forms.iter().enumerate().rev() {
        let cell = unravelled(flat, counts);
        let first: Vec<usize> = cell.iter().zip(starts).map(|(&i, list)| list[i]).collect();
        for (index, pole) in form.homogeneous().chunks_exact(width).enumerate() {
            let index = unravelled(index, form.orders());
            let place = index.iter().zip(&first).zip(orders);
            let place = place.fold(0, |flat, ((i, start), order)| flat * order + start + i);
            poles[place * width..][..width].copy_from_slice(pole);
        }
    }
    Form::from_homogeneous(orders, forms[0].ambient(), poles)
}

fn unravelled(flat: usize, orders: &[usize]) -> Vec<usize> {
    let mut rest = flat;
    let mut index = vec![0; orders.len()];
    for (i, order) in index.iter_mut().zip(orders).rev() {
        *i = rest % order;
        rest /= order;
    }
    index
}
