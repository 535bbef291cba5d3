//! Projection onto splines: the nearest of the feet on all pieces that could be near enough.

use pforms_kernel::{Error, Result};

use super::{Projection, Projector};
use crate::Spline;
use crate::measuring::patches::{Patch, patches, size};

/// A spline made ready for projection: each of its pieces.
pub struct SplineProjector {
    pieces: Vec<Piece>,
    axes: usize,
    ambient: usize,
    /// Distances that differ by less are the same.
    tie: f64,
}

struct Piece {
    projector: Projector,
    patch: Patch,
}

impl SplineProjector {
    /// Makes a spline ready. The `accuracy` is that of [`super::project`].
    ///
    /// Errors: those of [`Projector::new`] for any of the pieces.
    pub fn new(spline: &Spline, accuracy: f64) -> Result<Self> {
        let patches = patches(&spline.clone().into())?;
        let size = size(&patches);
        let piece =
            |patch: Patch| Ok(Piece { projector: Projector::new(&patch.form, accuracy)?, patch });
        let pieces = patches.into_iter().map(piece).collect::<Result<Vec<_>>>()?;
        let (axes, ambient) = (spline.axes(), spline.ambient());
        Ok(Self { pieces, axes, ambient, tie: accuracy * size })
    }

    /// The nearest points of the spline over its window, as [`super::project`] answers for a form:
    /// parameters are those of the spline, and the gap counts all pieces.
    ///
    /// A point is projected on the piece whose hull is nearest, then on those whose hull is no farther
    /// than what was found.
    ///
    /// Errors: as [`super::project`].
    pub fn project(&self, points: &[f64]) -> Result<Projection> {
        if !points.len().is_multiple_of(self.ambient) {
            let expected = format!("{} for each point", self.ambient);
            return Err(Error::shape("points", format!("{} numbers", points.len()), expected));
        }
        let mut searches: Vec<Search> =
            points.chunks_exact(self.ambient).map(|point| self.search(point)).collect();
        loop {
            let mut asked: Vec<(usize, usize)> = searches
                .iter_mut()
                .enumerate()
                .filter_map(|(i, search)| Some((search.next()?, i)))
                .collect();
            if asked.is_empty() {
                break;
            }
            asked.sort_unstable();
            for group in asked.chunk_by(|a, b| a.0 == b.0) {
                let piece = &self.pieces[group[0].0];
                let part: Vec<f64> = group
                    .iter()
                    .flat_map(|(_, i)| &points[i * self.ambient..(i + 1) * self.ambient])
                    .copied()
                    .collect();
                let found = piece.projector.project(&part)?;
                for (k, (number, i)) in group.iter().enumerate() {
                    searches[*i].feet.push(self.foot(*number, &found, k));
                }
            }
        }
        let mut all = Projection::default();
        for search in searches {
            search.settle(self.tie, &mut all);
        }
        Ok(all)
    }

    fn search(&self, point: &[f64]) -> Search {
        let mut waiting: Vec<(f64, usize)> =
            self.pieces.iter().map(|piece| piece.distance(point)).zip(0..).collect();
        // The nearest is taken from the end.
        waiting.sort_by(|a, b| b.0.total_cmp(&a.0).then(b.1.cmp(&a.1)));
        Search { waiting, feet: Vec::new() }
    }

    /// The answer number `k` of those of a piece.
    fn foot(&self, piece: usize, found: &Projection, k: usize) -> Foot {
        let local = &found.parameters[k * self.axes..(k + 1) * self.axes];
        Foot {
            parameters: self.pieces[piece].patch.whole(local),
            point: found.points[k * self.ambient..(k + 1) * self.ambient].to_vec(),
            distance: found.distances[k],
            gap: found.gaps[k],
            unique: found.unique[k],
        }
    }
}

impl Piece {
    /// A length below the distance of every point of the piece; 0 when nothing is known.
    fn distance(&self, point: &[f64]) -> f64 {
        let outside = |(x, (low, high)): (&f64, &(f64, f64))| (low - x).max(x - high).max(0.0);
        let squares = point.iter().zip(&self.patch.hull).map(outside);
        // Less a few roundings, of this and of the poles.
        squares.fold(0.0, f64::hypot) * (1.0 - 1e-12)
    }
}

/// The way to the foot of one point.
struct Search {
    /// Pieces not yet looked at, with a bound of their distance; the nearest last.
    waiting: Vec<(f64, usize)>,
    feet: Vec<Foot>,
}

struct Foot {
    parameters: Vec<f64>,
    point: Vec<f64>,
    distance: f64,
    gap: f64,
    unique: bool,
}

impl Search {
    /// The next piece that may be nearer than what was found.
    fn next(&mut self) -> Option<usize> {
        let found = self.feet.iter().map(|foot| foot.distance).fold(f64::INFINITY, f64::min);
        let (bound, piece) = self.waiting.pop()?;
        if bound <= found { Some(piece) } else { None }
    }

    /// The first of the nearest feet, which is the only one if no other is as near.
    fn settle(self, tie: f64, all: &mut Projection) {
        let least = self.feet.iter().map(|foot| foot.distance).fold(f64::INFINITY, f64::min);
        let below = self.feet.iter().map(|foot| foot.distance - foot.gap).fold(least, f64::min);
        let mut near: Vec<Foot> =
            self.feet.into_iter().filter(|foot| foot.distance <= least + tie).collect();
        near.sort_by(|a, b| {
            let order = a.parameters.iter().zip(&b.parameters).map(|(s, t)| s.total_cmp(t));
            order.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
        });
        let same = near.windows(2).all(|pair| pair[0].parameters == pair[1].parameters);
        let unique = same && near.iter().all(|foot| foot.unique);
        if let Some(first) = near.into_iter().next() {
            all.parameters.extend(first.parameters);
            all.points.extend(first.point);
            all.distances.push(first.distance);
            all.gaps.push((first.distance - below).max(first.gap));
            all.unique.push(unique);
        }
    }
}
