//! Normals at scattered parameters: the points of a block go with those near the same corner.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::Result;
use pforms_kernel::lanes::{Job, Lanes, bernstein_slopes};

use super::direction::{BLOCK, Block};
use super::net::{Nets, Pole, is_far};

/// The normals at `(us[i], vs[i])`, into `out`.
pub(super) struct Scattered<'a> {
    pub nets: &'a Nets<'a>,
    pub us: &'a [f64],
    pub vs: &'a [f64],
    pub out: &'a mut [f64],
}

impl Job for Scattered<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<const N: usize>(self) -> Result<()> {
        let Self { nets, us, vs, out } = self;
        let (out, _) = out.as_chunks_mut::<3>();
        let [first, second] = nets.orders();
        let mut rows = [Rows::<N>::new(first), Rows::new(second)];
        let mut block = Block::new();
        let mut normals = [[0.0; 3]; BLOCK];
        let parts = us.chunks(BLOCK).zip(vs.chunks(BLOCK)).zip(out.chunks_mut(BLOCK));
        for ((us, vs), out) in parts {
            for (far_u, far_v) in [(false, false), (true, false), (false, true), (true, true)] {
                let near = |i: &usize| is_far(us[*i]) == far_u && is_far(vs[*i]) == far_v;
                let places: Vec<usize> = (0..us.len()).filter(near).collect();
                let net = nets.near(far_u, far_v);
                for (group, places) in places.chunks(N).enumerate() {
                    rows[0].fill(pick(us, places));
                    rows[1].fill(pick(vs, places));
                    let [along_u, along_v] = &rows;
                    let at = group * N;
                    block.put(0, at, &sum(&along_u.values, &along_v.values, net));
                    block.put(1, at, &sum(&along_u.slopes, &along_v.values, net));
                    block.put(2, at, &sum(&along_u.values, &along_v.slopes, net));
                }
                let found = &mut normals[..places.len()];
                block.write(found, nets, |i| [us[places[i]], vs[places[i]]])?;
                for (place, normal) in places.iter().zip(found) {
                    out[*place] = *normal;
                }
            }
        }
        Ok(())
    }
}

/// The numbers at some places, the last again where they are fewer than lanes.
#[inline(always)]
fn pick<const N: usize>(list: &[f64], places: &[usize]) -> Lanes<N> {
    Lanes(std::array::from_fn(|k| list[places[k.min(places.len() - 1)]]))
}

/// Basis values and slopes along one axis.
struct Rows<const N: usize> {
    values: Vec<Lanes<N>>,
    slopes: Vec<Lanes<N>>,
}

impl<const N: usize> Rows<N> {
    fn new(order: usize) -> Self {
        Self { values: vec![Lanes::ZERO; order], slopes: vec![Lanes::ZERO; order] }
    }

    #[inline(always)]
    fn fill(&mut self, t: Lanes<N>) {
        bernstein_slopes(t, &mut self.values, &mut self.slopes);
    }
}

/// `Σ b_j · Σ a_i · pole_ij`: summed in the order of a grid, for the same bits.
#[inline(always)]
fn sum<const N: usize>(a: &[Lanes<N>], b: &[Lanes<N>], net: &[Pole]) -> [Lanes<N>; 4] {
    let mut total = [Lanes::ZERO; 4];
    for (j, factor) in b.iter().enumerate() {
        let mut sum = [Lanes::ZERO; 4];
        for (entry, pole) in a.iter().zip(net[j..].iter().step_by(b.len())) {
            for k in 0..4 {
                sum[k] = sum[k] + *entry * Lanes::splat(pole[k]);
            }
        }
        for k in 0..4 {
            total[k] = total[k] + *factor * sum[k];
        }
    }
    total
}
