//! Every part of the window is shown to be farther, to hold a foot that is known, or to be so
//! small that what it may hide is told: branch and bound.

use std::collections::VecDeque;

use pforms_kernel::Result;

use super::cells::Cells;
use super::descent::Foot;
use super::products::Products;
use super::region::{Face, Margin, Region};
use super::target::Target;

/// Regions that are looked at for one point, for each axis.
const REGIONS: usize = 1 << 12;

/// Regions that are cut in the hope that each part holds one foot, before it is enough that none is
/// much nearer.
const PATIENCE: usize = 1 << 6;

/// Bytes that the regions of one point may occupy.
const BYTES: usize = 1 << 26;

/// Feet that are told apart; more of them lie on a curve.
const FEET: usize = 32;

/// Feet with parameters nearer than this are one.
const APART: f64 = 1e-6;

/// All that is known of a form before the first point.
pub(super) struct Search {
    /// The form.
    pub target: Target,
    /// Its window in cells.
    pub cells: Cells,
    /// How its poles multiply.
    pub products: Products,
    /// Feet whose distances differ less are at the same distance.
    pub tie: f64,
}

/// The answer for one point, in coordinates of the target.
pub(super) struct Answer {
    /// The foot.
    pub foot: Foot,
    /// By how much the form may come nearer, at most.
    pub gap: f64,
    /// Is every other point of the form farther?
    pub unique: bool,
}

impl Search {
    /// Errors: those of [`Target::new`] and [`Products::new`].
    pub(super) fn new(target: Target, accuracy: f64) -> Result<Self> {
        let cells = Cells::new(&target.form)?;
        let products = Products::new(&target.form)?;
        let tie = accuracy * target.extent;
        Ok(Self { target, cells, products, tie })
    }

    /// The answer for a point, from a start somewhere in the window.
    pub(super) fn answer(&self, point: &[f64], start: Vec<f64>) -> Answer {
        Task::new(self, point, start).answered()
    }
}

/// How a region is shown to hold one foot.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Proof {
    /// Beyond all rounding: the foot is the only one.
    Strict,
    /// But for rounding: others may be as near.
    Rounded,
}

/// The search for one point.
struct Task<'a> {
    search: &'a Search,
    point: &'a [f64],
    noise: f64,
    tie: f64,
    /// Local feet, the nearest first.
    feet: Vec<Foot>,
    /// No point of what has been settled is nearer.
    settled: f64,
    /// Might anything else be as near?
    doubtful: bool,
    /// Regions looked at.
    seen: usize,
}

impl<'a> Task<'a> {
    fn new(search: &'a Search, point: &'a [f64], start: Vec<f64>) -> Self {
        let noise = search.target.noise_at(point);
        let tie = search.tie.max(8.0 * noise);
        let mut task = Self {
            search,
            point,
            noise,
            tie,
            feet: Vec::new(),
            settled: f64::INFINITY,
            doubtful: false,
            seen: 0,
        };
        let (zeros, ones) = task.window();
        let form = &search.target.form;
        let foot = Foot::at(form, point, start).descended(form, point, &zeros, &ones);
        task.meet(foot);
        task
    }

    fn answered(mut self) -> Answer {
        let reach = self.least() + self.tie + self.noise;
        let (lower, upper) = self.search.cells.within(self.point, reach);
        let root = Region::new(&self.search.target, self.point, &lower, &upper);
        let mut queue = VecDeque::from([root]);
        let axes = self.search.products.orders.len();
        let most = (BYTES / self.search.target.form.bytes()).clamp(64, REGIONS * axes.max(1));
        while let Some(region) = queue.pop_front() {
            self.seen += 1;
            if self.seen > most {
                self.give_up(&region);
            } else {
                self.settle(&region, &mut queue);
            }
        }
        self.concluded()
    }

    /// Settles a region, or cuts it in two.
    fn settle(&mut self, region: &Region, queue: &mut VecDeque<Region>) {
        let (products, width) = (&self.search.products, self.width());
        let mut margin = region.margin(products, width, self.least() + self.tie);
        if margin.is_positive() {
            return;
        }
        if self.improves(region) {
            margin = region.margin(products, width, self.least() + self.tie);
        }
        if margin.is_positive()
            || self.holds_one_foot(region, &margin, Proof::Strict)
            || (self.seen > PATIENCE
                && (self.is_close(region) || self.holds_one_foot(region, &margin, Proof::Rounded)))
        {
            return;
        }
        let axis = margin.steepest(&products.orders);
        let t = self.cut(region, axis);
        let (left, right) = region.split(self.search.target.form.orders(), width, axis, t);
        queue.extend([left, right]);
    }

    /// Descends from the nearest corner of a region, should it be nearer than what is known.
    fn improves(&mut self, region: &Region) -> bool {
        let (distance, corner) =
            region.nearest_corner(self.search.target.form.orders(), self.width());
        let nearer = distance < self.least() * (1.0 - 1e-14);
        if nearer {
            let form = &self.search.target.form;
            let (zeros, ones) = self.window();
            let foot = Foot::at(form, self.point, corner);
            self.meet(foot.descended(form, self.point, &zeros, &ones));
        }
        nearer
    }

    /// Where the square distance is convex, descent finds the nearest point of the region; along
    /// axes where it only rises, convex on the face where they begin.
    fn holds_one_foot(&mut self, region: &Region, margin: &Margin, proof: Proof) -> bool {
        let Some((mut face, _)) = self.convex_face(margin, proof) else { return false };
        let form = &self.search.target.form;
        let (lower, upper) = face.of(region);
        let nearest = self.feet[0].parameters.iter().zip(lower.iter().zip(&upper));
        let start = nearest.map(|(t, (low, high))| t.clamp(*low, *high)).collect();
        let foot = Foot::at(form, self.point, start).descended(form, self.point, &lower, &upper);
        // W² times the square distance, less that of the foot, is what must be convex.
        let margin = region.margin(&self.search.products, self.width(), foot.distance);
        let Some((exact, noise)) = self.convex_face(&margin, proof) else { return false };
        if exact.sides != face.sides {
            return false;
        }
        face = exact;
        let orders = &self.search.products.orders;
        let weight = self.search.target.least_weight.powi(2);
        let deficit = match proof {
            Proof::Strict => {
                // That margin bends 2·W² times as much as half the square distance.
                let least = foot.least_bend(&lower, &upper) / 64.0;
                let (bends, _) = face.bends(orders);
                if least <= 0.0 || !bends.at_least(2.0 * (least * weight + noise)) {
                    return false;
                }
                foot.deficit(&lower, &upper, least, self.noise) / weight
            }
            Proof::Rounded => {
                let slopes = 4.0 * orders.iter().sum::<usize>() as f64 * margin.noise;
                foot.deficit(&lower, &upper, 0.0, self.noise) + 2.0 * noise + slopes
            }
        };
        let square = foot.distance * foot.distance - deficit / weight;
        let bound = square.max(0.0).sqrt();
        if proof == Proof::Rounded && bound < self.least() - self.tie {
            return false;
        }
        self.settled = self.settled.min(bound);
        if foot.distance <= self.least() + self.tie {
            let (zeros, ones) = self.window();
            self.meet(foot.descended(form, self.point, &zeros, &ones));
            self.doubtful |= proof == Proof::Rounded;
        }
        true
    }

    /// The face on which a margin is least, if it is convex there, and the rounding of its bends.
    fn convex_face(&self, margin: &Margin, proof: Proof) -> Option<(Face, f64)> {
        let orders = &self.search.products.orders;
        let sign = if proof == Proof::Strict { -1.0 } else { 1.0 };
        let face = margin.lowest_face(orders, sign);
        let (bends, noise) = face.bends(orders);
        bends.at_least(-sign * noise).then_some((face, noise))
    }

    /// Whatever the region holds is hardly nearer than what is known.
    fn is_close(&mut self, region: &Region) -> bool {
        let (products, width, least) = (&self.search.products, self.width(), self.least());
        let inner = least - self.tie;
        let close = (inner > 0.0 && region.margin(products, width, inner).is_positive())
            || region.diameter(width) <= self.tie;
        if close {
            self.give_up(region);
        }
        close
    }

    /// Takes note of what a region may hide.
    fn give_up(&mut self, region: &Region) {
        let least = region.least_distance(&self.search.products, self.width());
        self.settled = self.settled.min(least);
        self.doubtful |= least <= self.least() + self.tie;
    }

    /// Through the nearest foot, when that leaves no sliver; else through the middle.
    fn cut(&self, region: &Region, axis: usize) -> f64 {
        let (low, high) = (region.lower[axis], region.upper[axis]);
        let foot = self.feet[0].parameters[axis];
        let share = (foot - low) / (high - low);
        if (0.1..=0.9).contains(&share) { foot } else { 0.5 * (low + high) }
    }

    /// Keeps a foot, unless it is known.
    fn meet(&mut self, foot: Foot) {
        let same = |other: &Foot| {
            let pairs = other.parameters.iter().zip(&foot.parameters);
            pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) <= APART
        };
        if let Some(known) = self.feet.iter_mut().find(|other| same(other)) {
            if foot.distance < known.distance {
                *known = foot;
            }
        } else {
            self.feet.push(foot);
        }
        self.feet.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        self.feet.truncate(FEET);
    }

    fn concluded(self) -> Answer {
        let most = self.least() + self.tie;
        let near: Vec<&Foot> = self.feet.iter().filter(|foot| foot.distance <= most).collect();
        let unique = near.len() == 1 && !self.doubtful;
        let first = near.into_iter().min_by(|a, b| in_order(&a.parameters, &b.parameters));
        let foot = first.unwrap_or(&self.feet[0]).clone();
        let gap = (foot.distance - self.settled).max(0.0) + self.noise;
        Answer { gap: gap.min(foot.distance), foot, unique }
    }

    fn least(&self) -> f64 {
        self.feet[0].distance
    }

    fn width(&self) -> usize {
        self.point.len() + 1
    }

    fn window(&self) -> (Vec<f64>, Vec<f64>) {
        let axes = self.search.products.orders.len();
        (vec![0.0; axes], vec![1.0; axes])
    }
}

/// Of two places in the window, the one with the least first parameter that differs comes first.
fn in_order(a: &[f64], b: &[f64]) -> std::cmp::Ordering {
    let pairs = a.iter().zip(b).map(|(x, y)| x.total_cmp(y));
    pairs.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
}
