//! Normals on a grid: a line of poles for each `u`, and `v` in lanes.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::Result;
use pforms_kernel::lanes::{Job, Lanes, bernstein_slopes};

use super::direction::{BLOCK, Block};
use super::net::{Nets, Pole, is_far};

/// The normals at all `us` and `vs`, into `out`.
pub(super) struct Grid<'a> {
    pub nets: &'a Nets<'a>,
    pub us: &'a [f64],
    pub vs: &'a [f64],
    pub out: &'a mut [f64],
}

impl Job for Grid<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<const N: usize>(self) -> Result<()> {
        let Self { nets, us, vs, out } = self;
        let (out, _) = out.as_chunks_mut::<3>();
        let mut block = Block::new();
        let mut lines = [Line::new(nets), Line::new(nets)];
        for (tile, part) in vs.chunks(BLOCK).enumerate() {
            let groups = groups::<N>(nets.orders()[1], part);
            for (row, u) in us.iter().enumerate() {
                for (far, line) in [false, true].into_iter().zip(&mut lines) {
                    if groups.iter().any(|group| group.far != Some(!far)) {
                        line.contract(nets.near(is_far(*u), far), *u);
                    }
                }
                for (place, group) in groups.iter().enumerate() {
                    group.put(&lines, &mut block, place * N);
                }
                let start = row * vs.len() + tile * BLOCK;
                block.write(&mut out[start..start + part.len()], nets, |i| [*u, part[i]])?;
            }
        }
        Ok(())
    }
}

/// A net contracted along `u`: a line of poles along `v`, and its derivative.
struct Line {
    poles: Vec<Pole>,
    slopes: Vec<Pole>,
    row: [Vec<Lanes<1>>; 2],
}

impl Line {
    fn new(nets: &Nets) -> Self {
        let [first, second] = nets.orders();
        let (row, poles) = (vec![Lanes::ZERO; first], vec![[0.0; 4]; second]);
        Self { poles: poles.clone(), slopes: poles, row: [row.clone(), row] }
    }

    #[inline(always)]
    fn contract(&mut self, net: &[Pole], u: f64) {
        let [values, slopes] = &mut self.row;
        bernstein_slopes(Lanes([u]), values, slopes);
        combine(values, net, &mut self.poles);
        combine(slopes, net, &mut self.slopes);
    }
}

/// `line = Σ row · net`.
#[inline(always)]
fn combine(row: &[Lanes<1>], net: &[Pole], line: &mut [Pole]) {
    line.fill([0.0; 4]);
    for (entry, poles) in row.iter().zip(net.chunks_exact(line.len())) {
        for (sum, pole) in line.iter_mut().zip(poles) {
            for k in 0..4 {
                sum[k] += entry.0[0] * pole[k];
            }
        }
    }
}

/// `N` parameters along `v`: their basis values and slopes, and the half they lie in.
struct Group<const N: usize> {
    vs: Lanes<N>,
    values: Vec<Lanes<N>>,
    slopes: Vec<Lanes<N>>,
    /// `None` when they lie in both.
    far: Option<bool>,
}

fn groups<const N: usize>(order: usize, vs: &[f64]) -> Vec<Group<N>> {
    let group = |part: &[f64]| {
        let (mut values, mut slopes) = (vec![Lanes::ZERO; order], vec![Lanes::ZERO; order]);
        let vs = Lanes::load_some(part);
        bernstein_slopes(vs, &mut values, &mut slopes);
        let far = is_far(vs.0[0]);
        let one_side = vs.0.iter().all(|v| is_far(*v) == far);
        Group { vs, values, slopes, far: one_side.then_some(far) }
    };
    vs.chunks(N).map(group).collect()
}

impl<const N: usize> Group<N> {
    /// Puts down the sums over the line that is seen from the nearest corner.
    #[inline(always)]
    fn put(&self, lines: &[Line; 2], block: &mut Block, at: usize) {
        let Some(far) = self.far else { return self.put_both(lines, block, at) };
        let line = &lines[usize::from(far)];
        block.put(0, at, &line_sum(&self.values, &line.poles));
        block.put(1, at, &line_sum(&self.values, &line.slopes));
        block.put(2, at, &line_sum(&self.slopes, &line.poles));
    }

    /// The same for lanes on both sides.
    fn put_both(&self, [near, far]: &[Line; 2], block: &mut Block, at: usize) {
        let choose = |near: Lanes<N>, far: Lanes<N>| {
            Lanes::<N>(std::array::from_fn(
                |k| if is_far(self.vs.0[k]) { far.0[k] } else { near.0[k] },
            ))
        };
        let both = |row: &[Lanes<N>], near: &[Pole], far: &[Pole]| {
            let (near, far) = (line_sum(row, near), line_sum(row, far));
            [0, 1, 2, 3].map(|k| choose(near[k], far[k]))
        };
        block.put(0, at, &both(&self.values, &near.poles, &far.poles));
        block.put(1, at, &both(&self.values, &near.slopes, &far.slopes));
        block.put(2, at, &both(&self.slopes, &near.poles, &far.poles));
    }
}

/// `Σ row · pole`.
#[inline(always)]
fn line_sum<const N: usize>(row: &[Lanes<N>], poles: &[Pole]) -> [Lanes<N>; 4] {
    let mut sum = [Lanes::ZERO; 4];
    for (entry, pole) in row.iter().zip(poles) {
        for k in 0..4 {
            sum[k] = sum[k] + *entry * Lanes::splat(pole[k]);
        }
    }
    sum
}
