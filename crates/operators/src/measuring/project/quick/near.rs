//! How far the cells are from each point.

use pforms_kernel::vectors::{self, Lanes, Simd};

use super::super::cells::{MOST, SLACK};
use super::super::search::Search;
use super::{Quick, difference, dot, least, less, most};

/// Square distances from the middles of the cells, and what follows from them.
pub(super) struct Near<'a, S: Simd> {
    counts: [usize; 2],
    centres: &'a [[f64; 3]],
    radii: &'a [f64],
    squares: Vec<Lanes<S>>,
}

/// Bits for the number of a cell: there are at most as many.
const TAG: u64 = MOST as u64 - 1;

/// A box of parameters for each lane.
#[derive(Clone, Copy)]
pub(super) struct Window<S: Simd> {
    pub lower: [Lanes<S>; 2],
    pub upper: [Lanes<S>; 2],
}

impl<'a, S: Simd> Near<'a, S> {
    #[inline(always)]
    pub(super) fn new(simd: S, quick: &'a Quick, search: &'a Search) -> Self {
        let (centres, _) = quick.centres.as_chunks::<3>();
        let squares = vec![Lanes::splat(simd, 0.0); centres.len()];
        Self { counts: quick.counts, centres, radii: &search.cells.radii, squares }
    }

    /// Parameters of the nearest middle.
    #[inline(always)]
    pub(super) fn start(&mut self, x: &[Lanes<S>; 3]) -> [Lanes<S>; 2] {
        let simd = x[0].simd();
        // The last bits of a square distance hardly tell; they carry the number of the cell.
        let mut nearest = Lanes::splat(simd, f64::INFINITY);
        let cells = self.centres.iter().zip(&mut self.squares).enumerate();
        for (place, (centre, square)) in cells {
            let centre = [
                Lanes::splat(simd, centre[0]),
                Lanes::splat(simd, centre[1]),
                Lanes::splat(simd, centre[2]),
            ];
            let offset = difference(x, &centre);
            *square = dot(&offset, &offset);
            let tagged = square.with_bits(TAG, place as u64);
            nearest = least(nearest, tagged);
        }
        let mut numbers = [0.0; vectors::MOST];
        nearest.store(&mut numbers);
        let [rows, columns] = self.counts;
        let mut start = [[0.0; vectors::MOST]; 2];
        for k in 0..S::F64_LANES {
            let place = (numbers[k].to_bits() & TAG) as usize;
            start[0][k] = ((place / columns) as f64 + 0.5) / rows as f64;
            start[1][k] = ((place % columns) as f64 + 0.5) / columns as f64;
        }
        [Lanes::load(simd, &start[0]), Lanes::load(simd, &start[1])]
    }

    /// The least box of cells outside of which the form is farther than `reach`.
    #[inline(always)]
    pub(super) fn within(&self, reach: Lanes<S>) -> Window<S> {
        let simd = reach.simd();
        let far = Lanes::splat(simd, f64::INFINITY);
        let (mut lower, mut upper) = ([far; 2], [-far; 2]);
        let lines = self.squares.chunks_exact(self.counts[1]);
        for (i, (squares, radii)) in lines.zip(self.radii.chunks_exact(self.counts[1])).enumerate()
        {
            let (mut first, mut last) = (far, -far);
            for (j, (square, radius)) in squares.iter().zip(radii).enumerate() {
                let bound = (reach + Lanes::splat(simd, *radius)) * Lanes::splat(simd, 1.0 + SLACK);
                let square_bound = bound * bound;
                let j = Lanes::splat(simd, j as f64);
                // A bound that is no number leaves nothing out.
                first = less(square_bound, *square, first, least(first, j));
                last = less(square_bound, *square, last, j);
            }
            lower[1] = least(lower[1], first);
            upper[1] = most(upper[1], last);
            let i = Lanes::splat(simd, i as f64);
            lower[0] = less(first, far, least(lower[0], i), lower[0]);
            upper[0] = less(first, far, i, upper[0]);
        }
        let mut window = Window { lower, upper };
        for axis in 0..2 {
            let count = Lanes::splat(simd, self.counts[axis] as f64);
            window.lower[axis] = lower[axis] / count;
            window.upper[axis] = (upper[axis] + Lanes::splat(simd, 1.0)) / count;
        }
        window
    }
}
