//! How far the cells are from each point.

use pforms_kernel::lanes::Lanes;

use super::super::cells::{MOST, SLACK};
use super::super::search::Search;
use super::{Quick, difference, dot, keep_lanes, least, less, most};

/// Square distances from the middles of the cells, and what follows from them.
pub(super) struct Near<'a, const N: usize> {
    counts: [usize; 2],
    centres: &'a [[f64; 3]],
    radii: &'a [f64],
    squares: Vec<Lanes<N>>,
}

/// Bits for the number of a cell: there are at most as many.
const TAG: u64 = MOST as u64 - 1;

/// A box of parameters for each lane.
#[derive(Clone, Copy)]
pub(super) struct Window<const N: usize> {
    pub lower: [Lanes<N>; 2],
    pub upper: [Lanes<N>; 2],
}

impl<'a, const N: usize> Near<'a, N> {
    #[inline(always)]
    pub(super) fn new(quick: &'a Quick, search: &'a Search) -> Self {
        let (centres, _) = quick.centres.as_chunks::<3>();
        let squares = vec![Lanes::ZERO; centres.len()];
        Self { counts: quick.counts, centres, radii: &search.cells.radii, squares }
    }

    /// Parameters of the nearest middle.
    #[inline(always)]
    pub(super) fn start(&mut self, x: &[Lanes<N>; 3]) -> [Lanes<N>; 2] {
        // The last bits of a square distance hardly tell; they carry the number of the cell.
        let mut nearest = Lanes::splat(f64::INFINITY);
        let cells = self.centres.iter().zip(&mut self.squares).enumerate();
        for (place, (centre, square)) in cells {
            keep_lanes();
            let centre =
                [Lanes::splat(centre[0]), Lanes::splat(centre[1]), Lanes::splat(centre[2])];
            let offset = difference(x, &centre);
            *square = dot(&offset, &offset);
            let tagged = square.map(|x| f64::from_bits(x.to_bits() & !TAG | place as u64));
            nearest = least(nearest, tagged);
        }
        let place = nearest.map(|x| (x.to_bits() & TAG) as f64);
        let half = Lanes::splat(0.5);
        let [rows, columns] =
            [Lanes::splat(self.counts[0] as f64), Lanes::splat(self.counts[1] as f64)];
        let row = ((place + half) / columns).map(f64::floor);
        [(row + half) / rows, (place - row * columns + half) / columns]
    }

    /// The least box of cells outside of which the form is farther than `reach`.
    #[inline(always)]
    pub(super) fn within(&self, reach: Lanes<N>) -> Window<N> {
        let far = Lanes::splat(f64::INFINITY);
        let (mut lower, mut upper) = ([far; 2], [-far; 2]);
        let lines = self.squares.chunks_exact(self.counts[1]);
        for (i, (squares, radii)) in lines.zip(self.radii.chunks_exact(self.counts[1])).enumerate()
        {
            let (mut first, mut last) = (far, -far);
            for (j, (square, radius)) in squares.iter().zip(radii).enumerate() {
                keep_lanes();
                let bound = (reach + Lanes::splat(*radius)) * Lanes::splat(1.0 + SLACK);
                let square_bound = bound * bound;
                let j = Lanes::splat(j as f64);
                // A bound that is no number leaves nothing out.
                first = less(square_bound, *square, first, least(first, j));
                last = less(square_bound, *square, last, j);
            }
            lower[1] = least(lower[1], first);
            upper[1] = most(upper[1], last);
            let i = Lanes::splat(i as f64);
            lower[0] = less(first, far, least(lower[0], i), lower[0]);
            upper[0] = less(first, far, i, upper[0]);
        }
        let mut window = Window { lower, upper };
        for axis in 0..2 {
            let count = Lanes::splat(self.counts[axis] as f64);
            window.lower[axis] = lower[axis] / count;
            window.upper[axis] = (upper[axis] + Lanes::ONE) / count;
        }
        window
    }
}
