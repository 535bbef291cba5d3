//! Normals at scattered parameters: the points of a block go with those near the same corner.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::Result;
use pforms_kernel::vectors::{Job, Lanes, MOST, Simd, bernstein_slopes};

use super::direction::{BLOCK, Block, Jets};
use super::net::{Nets, Pole, is_far};

/// The normals at `(us[i], vs[i])`, into `out`.
pub(super) struct Scattered<'a> {
    pub nets: &'a Nets,
    pub us: &'a [f64],
    pub vs: &'a [f64],
    pub out: &'a mut [f64],
}

impl Job for Scattered<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Result<()> {
        let Self { nets, us, vs, out } = self;
        let (out, _) = out.as_chunks_mut::<3>();
        let [first, second] = nets.orders();
        let mut rows = [Rows::new(simd, first), Rows::new(simd, second)];
        let mut block = Block::new();
        let mut normals = [[0.0; 3]; BLOCK];
        let parts = us.chunks(BLOCK).zip(vs.chunks(BLOCK)).zip(out.chunks_mut(BLOCK));
        for ((us, vs), out) in parts {
            for (far_u, far_v) in [(false, false), (true, false), (false, true), (true, true)] {
                let near = |i: &usize| is_far(us[*i]) == far_u && is_far(vs[*i]) == far_v;
                let places: Vec<usize> = (0..us.len()).filter(near).collect();
                let net = nets.near(far_u, far_v);
                for (group, places) in places.chunks(S::F64_LANES).enumerate() {
                    rows[0].fill(pick(simd, us, places));
                    rows[1].fill(pick(simd, vs, places));
                    let jets = jets(&rows, net, nets.uniform);
                    block.put(group * S::F64_LANES, &jets.normals(nets.reach));
                }
                let found = &mut normals[..places.len()];
                block.write(found, &nets.surface, |i| [us[places[i]], vs[places[i]]])?;
                for (place, normal) in places.iter().zip(found) {
                    out[*place] = *normal;
                }
            }
        }
        Ok(())
    }
}

/// The numbers at some places, not more than there are lanes.
#[inline(always)]
fn pick<S: Simd>(simd: S, list: &[f64], places: &[usize]) -> Lanes<S> {
    let mut picked = [0.0; MOST];
    for (x, place) in picked.iter_mut().zip(places) {
        *x = list[*place];
    }
    Lanes::load(simd, &picked)
}

/// Basis values and slopes along one axis.
struct Rows<S: Simd> {
    values: Vec<Lanes<S>>,
    slopes: Vec<Lanes<S>>,
}

impl<S: Simd> Rows<S> {
    fn new(simd: S, order: usize) -> Self {
        let zeros = vec![Lanes::splat(simd, 0.0); order];
        Self { values: zeros.clone(), slopes: zeros }
    }

    #[inline(always)]
    fn fill(&mut self, t: Lanes<S>) {
        bernstein_slopes(t, &mut self.values, &mut self.slopes);
    }
}

#[inline(always)]
fn jets<S: Simd>([u, v]: &[Rows<S>; 2], net: &[Pole], uniform: Option<f64>) -> Jets<S> {
    match uniform {
        None => Jets {
            point: sum(&u.values, &v.values, net),
            along_u: sum(&u.slopes, &v.values, net),
            along_v: sum(&u.values, &v.slopes, net),
        },
        Some(weight) => Jets::polynomial(
            Lanes::splat(u.values[0].simd(), weight),
            sum(&u.slopes, &v.values, net),
            sum(&u.values, &v.slopes, net),
        ),
    }
}

/// `Σ b_j · Σ a_i · pole_ij` of the first `C` components, in the order of a grid: for the same bits.
#[inline(always)]
fn sum<S: Simd, const C: usize>(a: &[Lanes<S>], b: &[Lanes<S>], net: &[Pole]) -> [Lanes<S>; C] {
    let simd = a[0].simd();
    let mut total = [Lanes::splat(simd, 0.0); C];
    for (j, factor) in b.iter().enumerate() {
        let mut sum = [Lanes::splat(simd, 0.0); C];
        for (i, entry) in a.iter().enumerate() {
            let pole = &net[i * b.len() + j];
            for c in 0..C {
                sum[c] = sum[c] + *entry * Lanes::splat(simd, pole[c]);
            }
        }
        for c in 0..C {
            total[c] = total[c] + *factor * sum[c];
        }
    }
    total
}
