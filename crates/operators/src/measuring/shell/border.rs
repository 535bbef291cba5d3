//! The borders of a patch, and which two of them are the same.

use pforms_kernel::{Form, Result, Scalar};

use crate::algebra::{Shape, Spline};
use crate::measuring::integral::{heaviest, infinite, least_weight};

/// One end of one axis of a patch.
#[derive(Clone, Debug)]
pub(super) struct Border<S> {
    /// The patch, the axis and whether it is its far end.
    pub patch: usize,
    pub axis: usize,
    pub far: bool,
    /// The border itself, every window from 0 to 1.
    shape: Spline<S>,
    /// Its point in the middle of the windows: the same for whatever runs through it otherwise.
    pub middle: Vec<f64>,
}

impl<S: Scalar> Border<S> {
    /// The borders of a patch that are not collapsed, to `tolerance`.
    ///
    /// Errors: `Domain` when a border is at infinity.
    pub(super) fn all(patch: usize, shape: &Shape<S>, tolerance: f64) -> Result<Vec<Self>> {
        let spline = shape.clone().into_spline();
        let mut borders = Vec::new();
        for axis in 0..spline.axes() {
            let (from, to) = spline.window(axis)?;
            for (far, end) in [(false, from), (true, to)] {
                let mut border = spline.sub(axis, &end)?;
                for axis in 0..border.axes() {
                    border = border.on_window(axis, &S::zero(), &S::one())?;
                }
                if is_collapsed(&border, tolerance)? {
                    continue;
                }
                let half = vec![S::ratio(1, 2); border.axes()];
                let middle = border.at(&half)?.iter().map(Scalar::to_f64).collect();
                borders.push(Self { patch, axis, far, shape: border, middle });
            }
        }
        Ok(borders)
    }

    /// The sign of the border's own axes in the orientation that the patch gives its border.
    fn induced(&self) -> i32 {
        if self.axis.is_multiple_of(2) == self.far { 1 } else { -1 }
    }

    /// How another border must be turned to be this one, by how much it then differs at most, and
    /// whether both patches have one orientation across it; `None` if it is another border.
    pub(super) fn matches(&self, other: &Self, tolerance: f64) -> Result<Option<Match>> {
        for (axes, parity) in permutations(self.shape.axes()) {
            let turned = other.shape.transpose(&axes)?;
            for flips in 0..1_u32 << axes.len() {
                let mut turned = turned.clone();
                for axis in 0..axes.len() {
                    if flips >> axis & 1 == 1 {
                        turned = turned.reverse(axis)?;
                    }
                }
                let gap = gap(&self.shape, &turned)?;
                if gap <= tolerance {
                    let sign = if flips.count_ones().is_multiple_of(2) { parity } else { -parity };
                    let agree = self.induced() * other.induced() * sign == -1;
                    return Ok(Some(Match { gap, agree, size: self.size() }));
                }
            }
        }
        Ok(None)
    }

    /// At least its measure, in a ball of diameter 1.
    ///
    /// A line meets a curve of degree `n` in the plane, a plane one in space, `n` times at most, and
    /// lengths are means of such counts (Crofton); so for areas.
    fn size(&self) -> f64 {
        let counts = self.shape.counts();
        let degrees = self.shape.degrees();
        let sheets: usize =
            counts.iter().zip(&degrees).map(|(count, degree)| count * degree).product();
        let orders: usize = (1..=self.shape.axes()).product();
        2.0 * (sheets * orders) as f64
    }
}

/// Two borders that are one.
pub(super) struct Match {
    /// By how much they differ at most.
    pub gap: f64,
    /// Do the patches have one orientation?
    pub agree: bool,
    /// At least the measure of the border, in a ball of diameter 1.
    pub size: f64,
}

/// Is the border a point, or drawn together along one axis? Then it is not a border.
fn is_collapsed<S: Scalar>(border: &Spline<S>, tolerance: f64) -> Result<bool> {
    let net = border.net().map_scalar(Scalar::to_f64)?;
    let least = positive_weight(&net)?;
    let width = net.width();
    let pole = |place: usize| &net.homogeneous()[place * width..][..width];
    for axis in 0..net.axes() {
        let (order, inner) =
            (net.orders()[axis], net.orders()[axis + 1..].iter().product::<usize>());
        let starts = (0..net.pole_count()).filter(|place| place / inner % order == 0);
        let mut widest = 0.0_f64;
        for start in starts {
            let line = (0..order).map(|i| pole(start + i * inner));
            let line =
                Form::from_homogeneous(&[order], width - 1, line.flatten().copied().collect())?;
            let point = heaviest(&line);
            for pole in line.homogeneous().chunks_exact(width) {
                let off = pole.iter().zip(&point).map(|(x, p)| x - p * pole[width - 1]);
                widest = widest.max(off.map(|x| x * x).sum::<f64>().sqrt() / least);
            }
        }
        if widest <= tolerance {
            return Ok(true);
        }
    }
    Ok(false)
}

/// A lower bound of the weight of a border.
///
/// Errors: `Domain` where it vanishes.
fn positive_weight(net: &Form) -> Result<f64> {
    match least_weight(net)? {
        least if least > 0.0 => Ok(least),
        _ => Err(infinite()),
    }
}

/// By how much two borders differ at most where they run alike; infinite where they do not.
///
/// With weights that are the same but for a factor, the points differ by no more than the homogeneous
/// poles do, over the least weight.
fn gap<S: Scalar>(a: &Spline<S>, b: &Spline<S>) -> Result<f64> {
    let common = Spline::on_common_knots(&[a.clone(), b.clone()])?;
    let [a, b] = [0, 1].map(|k| common[k].net());
    let width = a.width();
    let poles = a.homogeneous().chunks_exact(width).zip(b.homogeneous().chunks_exact(width));
    let Some((own, other)) = poles
        .clone()
        .map(|(p, q)| (p[width - 1].clone(), q[width - 1].clone()))
        .find(|(own, other)| !own.is_zero() && !other.is_zero())
    else {
        return Ok(f64::INFINITY);
    };
    let factor = own / other;
    let (mut worst, mut unlike) = (0.0_f64, 0.0_f64);
    for (p, q) in poles {
        let rest = |k: usize| (p[k].clone() - factor.clone() * q[k].clone()).to_f64();
        worst = worst.max((0..width - 1).map(|k| rest(k) * rest(k)).sum::<f64>().sqrt());
        unlike = unlike.max(rest(width - 1).abs());
    }
    let heavy = a.weights().iter().fold(0.0_f64, |most, w| most.max(w.to_f64().abs()));
    let same = if S::EXACT { unlike == 0.0 } else { unlike <= SAME * heavy };
    let least = positive_weight(&a.map_scalar(Scalar::to_f64)?)?;
    Ok(if same { worst / least } else { f64::INFINITY })
}

/// Weights that differ by no more, relative to the largest, are the same but for rounding.
const SAME: f64 = 1e-12;

/// All orders of so many axes, with their signs.
fn permutations(axes: usize) -> Vec<(Vec<usize>, i32)> {
    let mut all = vec![(Vec::new(), 1)];
    for next in 0..axes {
        let longer = |(order, sign): &(Vec<usize>, i32)| {
            let (order, sign) = (order.clone(), *sign);
            (0..=next).rev().map(move |place| {
                let mut longer = order.clone();
                longer.insert(place, next);
                (longer, if (next - place).is_multiple_of(2) { sign } else { -sign })
            })
        };
        all = all.iter().flat_map(longer).collect();
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn permutations_and_their_signs() {
        assert_eq!(permutations(0), [(vec![], 1)]);
        assert_eq!(permutations(2), [(vec![0, 1], 1), (vec![1, 0], -1)]);
        let signs: i32 = permutations(3).iter().map(|(_, sign)| sign).sum();
        assert!(permutations(3).len() == 6 && signs == 0);
    }
}
