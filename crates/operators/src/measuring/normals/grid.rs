//! Normals on a grid: a line of poles for each `u`, and `v` in lanes.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::Result;
use pforms_kernel::vectors::{Job, Lanes, Simd, bernstein_slopes, line_sums};

use super::direction::{BLOCK, Block, Jets};
use super::net::{MIDDLE, Nets, Pole, is_far};

/// The normals at all `us` and `vs`, into `out`.
pub(super) struct Grid<'a> {
    pub nets: &'a Nets,
    pub us: &'a [f64],
    pub vs: &'a [f64],
    pub out: &'a mut [f64],
}

impl Job for Grid<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Result<()> {
        let Self { nets, us, vs, out } = self;
        let (out, _) = out.as_chunks_mut::<3>();
        let mut block = Block::new();
        let mut lines = [Line::new(simd, nets), Line::new(simd, nets)];
        let order = nets.orders()[1];
        for (tile, part) in vs.chunks(BLOCK).enumerate() {
            let groups = groups(simd, order, part);
            let sides = [false, true].map(|far| part.iter().any(|v| is_far(*v) == far));
            for (row, u) in us.iter().enumerate() {
                for far in 0..2 {
                    if sides[far] {
                        let net = nets.near(is_far(*u), far == 1);
                        lines[far].contract(net, order, Lanes::splat(simd, *u));
                    }
                }
                for (place, group) in groups.iter().enumerate() {
                    block.put(place * S::F64_LANES, &group.normals(&lines, nets));
                }
                let start = row * vs.len() + tile * BLOCK;
                let out = &mut out[start..start + part.len()];
                block.write(out, &nets.surface, |i| [*u, part[i]])?;
            }
        }
        Ok(())
    }
}

/// A net contracted along `u`: a line of poles along `v`, and its derivative.
struct Line<S: Simd> {
    poles: Vec<Pole>,
    slopes: Vec<Pole>,
    row: [Vec<Lanes<S>>; 2],
}

impl<S: Simd> Line<S> {
    fn new(simd: S, nets: &Nets) -> Self {
        let [first, second] = nets.orders();
        let row = vec![Lanes::splat(simd, 0.0); first];
        let poles = vec![[0.0; 4]; second.next_multiple_of(2)];
        Self { poles: poles.clone(), slopes: poles, row: [row.clone(), row] }
    }

    #[inline(always)]
    fn contract(&mut self, net: &[Pole], order: usize, u: Lanes<S>) {
        let [values, slopes] = &mut self.row;
        bernstein_slopes(u, values, slopes);
        combine(values, net, order, &mut self.poles);
        combine(slopes, net, order, &mut self.slopes);
    }
}

/// `line = Σ row · net`, the row the same in all lanes. A line of an odd order ends with a pole
/// that is not used, as does the net.
#[inline(always)]
fn combine<S: Simd>(row: &[Lanes<S>], net: &[Pole], order: usize, line: &mut [Pole]) {
    let (net, line) = (net.as_flattened(), line.as_flattened_mut());
    for at in (0..line.len()).step_by(S::F64_LANES) {
        let simd = row[0].simd();
        let mut sum = row[0] * Lanes::load(simd, &net[at..]);
        for (i, entry) in row.iter().enumerate().skip(1) {
            sum = sum + *entry * Lanes::load(simd, &net[4 * i * order + at..]);
        }
        sum.store(&mut line[at..]);
    }
}

/// The parameters along `v` in the lanes: their basis values and slopes, and the half they lie in.
struct Group<S: Simd> {
    vs: Lanes<S>,
    values: Vec<Lanes<S>>,
    slopes: Vec<Lanes<S>>,
    /// `None` when they lie in both.
    far: Option<bool>,
}

fn groups<S: Simd>(simd: S, order: usize, vs: &[f64]) -> Vec<Group<S>> {
    let group = |part: &[f64]| {
        let vs = Lanes::load_some(simd, part);
        let (mut values, mut slopes) = (vec![vs; order], vec![vs; order]);
        bernstein_slopes(vs, &mut values, &mut slopes);
        let far = is_far(part[0]);
        let one_side = part.iter().all(|v| is_far(*v) == far);
        Group { vs, values, slopes, far: one_side.then_some(far) }
    };
    vs.chunks(S::F64_LANES).map(group).collect()
}

impl<S: Simd> Group<S> {
    /// The normals on the line that is seen from the nearest corner.
    #[inline(always)]
    fn normals(&self, lines: &[Line<S>; 2], nets: &Nets) -> [Lanes<S>; 4] {
        if let Some(far) = self.far {
            return self.normals_on(&lines[usize::from(far)], nets);
        }
        let (near, far) = (self.normals_on(&lines[0], nets), self.normals_on(&lines[1], nets));
        let middle = Lanes::splat(self.vs.simd(), MIDDLE);
        let mut chosen = near;
        for k in 0..4 {
            chosen[k] = self.vs.if_above(middle, far[k], near[k]);
        }
        chosen
    }

    #[inline(always)]
    fn normals_on(&self, line: &Line<S>, nets: &Nets) -> [Lanes<S>; 4] {
        let simd = self.vs.simd();
        let jets = match nets.uniform {
            None => Jets {
                point: line_sums(&self.values, &line.poles),
                along_u: line_sums(&self.values, &line.slopes),
                along_v: line_sums(&self.slopes, &line.poles),
            },
            Some(weight) => Jets::polynomial(
                Lanes::splat(simd, weight),
                line_sums(&self.values, &line.slopes),
                line_sums(&self.slopes, &line.poles),
            ),
        };
        jets.normals(nets.reach)
    }
}
