//! Systems of polynomial equations: all solutions in a window, with the proof that they are all.
//!
//! `m ≥ n` equations in `n` unknowns, each a polynomial in Bernstein form over the unit box. The box
//! is cut into cells. A cell over which an equation keeps one sign holds no solution. In the others
//! the equations are combined so that each is nearly one unknown plus a constant; what is left over
//! bounds the place of every solution, and the cell shrinks (Mourrain and Pavone, *Subdivision
//! methods for solving polynomial equations*, 2009). Where the left-over varies little the map is a
//! contraction: then there is at most one solution, Newton's steps lead to it, and Banach's theorem
//! says in which ball it is. All bounds count the rounding of the coefficients.
//!
//! What is not decided is not dropped: it is reported as a [`Cluster`], a box that may hold a
//! multiple solution, a curve of them, or nothing. Every solution lies in a root's ball or in a
//! cluster.

mod cell;
mod cluster;
mod combined;
mod equations;
mod linear;
mod newton;

use std::collections::VecDeque;

use cell::Cell;
use combined::Combined;
pub(crate) use equations::{Equations, Polynomial};

/// Unknowns at most.
pub(crate) const MOST_UNKNOWNS: usize = 4;

/// One number for each unknown; those beyond are 0.
pub(crate) type Each = [f64; MOST_UNKNOWNS];

/// So far the window is looked at beyond its border, so that solutions on it are not lost.
pub(crate) const BORDER: f64 = 1.0 / (1_u64 << 46) as f64;

/// When to stop.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Cells narrower than this are cut no further.
    pub finest: f64,
    /// Cells that are nothing but noise are cut until they are no wider than this.
    pub coarsest: f64,
    /// Cells looked at, at most.
    pub most: usize,
    /// Solutions outside the window by no more than this are put on its border.
    pub border: f64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { finest: 1e-12, coarsest: 1.0 / 32.0, most: 1 << 14, border: BORDER }
    }
}

/// A solution that is alone in its ball.
#[derive(Clone, Debug)]
pub(crate) struct Root {
    /// Where it is, in the window: one number for each unknown.
    pub parameters: Vec<f64>,
    /// The solution is no farther than this from there, along each axis: proved. It may lie outside
    /// the window by as much, or by 2⁻⁴⁶.
    ///
    /// As many equations as unknowns: the solution exists. With more of them it is the only point
    /// nearby that can be one, and solves them to within noise and tolerance.
    pub radius: f64,
}

/// A box in which it is undecided whether there are solutions, and how many.
#[derive(Clone, Debug)]
pub(crate) struct Cluster {
    pub lower: Vec<f64>,
    pub upper: Vec<f64>,
    /// The place in it where the equations are least, as far as descent finds it.
    pub parameters: Vec<f64>,
    /// The largest absolute value of an equation there, in the units in which they were given.
    pub residual: f64,
    /// Was it left because the work was at an end? More of it would part this box; otherwise
    /// it is as fine as rounding (or the finest cell) allows.
    pub unfinished: bool,
    /// The cells it is made of, each with its lower and upper corner: for a curve of solutions a
    /// chain along it.
    pub cells: Vec<(Vec<f64>, Vec<f64>)>,
}

impl Cluster {
    /// Its longest side.
    pub(crate) fn width(&self) -> f64 {
        self.lower.iter().zip(&self.upper).map(|(a, b)| b - a).fold(0.0, f64::max)
    }
}

/// All solutions of a system in the window.
#[derive(Clone, Debug, Default)]
pub(crate) struct Solutions {
    /// Those proved to be alone, in the order of their parameters.
    pub roots: Vec<Root>,
    /// What is undecided; where there is none, the roots are all solutions.
    pub clusters: Vec<Cluster>,
    /// Cells looked at.
    pub work: usize,
}

/// All solutions of the equations in the unit box, which is closed.
pub(crate) fn solve(equations: &Equations, limits: &Limits) -> Solutions {
    let mut found = Solutions::default();
    let mut undecided = Vec::new();
    let mut scratch = Scratch::new(equations);
    // In the order of cutting: where the work ends, all that is left is about as small.
    let mut queue = VecDeque::from([Cell::whole(equations, limits.border)]);
    while let Some(cell) = queue.pop_front() {
        if found.work >= limits.most || pforms_kernel::stopping::is_stopped() {
            undecided.push((cell.bounds(), true));
            continue;
        }
        match scratch.examine(equations, cell, limits, &mut found.work) {
            Verdict::Nothing => {}
            Verdict::Root(root) => found.roots.push(root),
            Verdict::Noise(cell) => undecided.push((cell.bounds(), false)),
            Verdict::Parts(low, high) => queue.extend([low, high]),
        }
    }
    cluster::merge_roots(&mut found.roots);
    found.clusters = cluster::gather(equations, undecided);
    found
}

/// What is known of a cell after a look at it.
#[allow(clippy::large_enum_variant, reason = "one at a time, and never kept")]
enum Verdict {
    Nothing,
    Root(Root),
    /// Finer than is useful, or nothing but rounding.
    Noise(Cell),
    Parts(Cell, Cell),
}

/// A shrunken side is worth another look when it is shorter than this part of the cell's.
const SHRUNK: f64 = 0.7;

/// A side shorter than this part of the longest is not narrowed: what is known of it goes down to
/// rounding, where nothing can be shown.
const SLENDER: f64 = 1.0 / 1024.0;

/// Solutions are proved where the map shrinks distances to this part: with less, balls are wide.
const CONTRACTS: f64 = 0.5;

/// Room for the combined equations, used again for each cell.
struct Scratch {
    combined: Combined,
}

impl Scratch {
    fn new(equations: &Equations) -> Self {
        Self { combined: Combined::new(equations) }
    }

    fn examine(
        &mut self,
        equations: &Equations,
        mut cell: Cell,
        limits: &Limits,
        work: &mut usize,
    ) -> Verdict {
        loop {
            *work += 1;
            if cell.is_free(equations) {
                return Verdict::Nothing;
            }
            let combined = &mut self.combined;
            combined.prepare(equations, &cell);
            let Some(within) = combined.solutions_within() else { return Verdict::Nothing };
            let ratios: Vec<f64> = within[..equations.axes()].iter().map(|(a, b)| b - a).collect();
            let most = ratios.iter().fold(0.0_f64, |most, x| most.max(*x));
            if most < 1.0 && combined.contraction() < CONTRACTS {
                match newton::prove(equations, &cell, combined, limits.border) {
                    newton::Proof::Root(root) => return Verdict::Root(root),
                    newton::Proof::None => return Verdict::Nothing,
                    newton::Proof::Open => {}
                }
            }
            let width = cell.width();
            if width < limits.finest || (width <= limits.coarsest && combined.is_noise()) {
                return Verdict::Noise(cell);
            }
            // A side is narrowed while others are not left far behind.
            let narrows = |axis: usize| ratios[axis] < SHRUNK && cell.side(axis) > SLENDER * width;
            let sides: Vec<usize> = (0..equations.axes()).filter(|axis| narrows(*axis)).collect();
            if sides.is_empty() || *work >= limits.most {
                let axis = combined.axis_to_cut(&cell);
                let (low, high) = cell.parts(axis);
                return Verdict::Parts(low, high);
            }
            for axis in sides {
                cell.restrict(axis, within[axis].0, within[axis].1);
            }
        }
    }
}

#[cfg(test)]
mod tests;
