//! Which parameters belong to data points.

use pforms_kernel::{Error, Result};

/// How the parameters of data points are found.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Parameters {
    /// Equally spaced in `[0, 1]`.
    Uniform,
    /// In proportion to the distances between neighbours; on a grid, averaged over all lines of
    /// an axis (*The NURBS Book*, section 9.2.1 and algorithm A9.3). The usual choice.
    #[default]
    Chord,
    /// In proportion to the square roots of the distances (Lee 1989): calmer at sharp turns.
    Centripetal,
    /// Given: for a grid one list for each axis, as long as the grid; for scattered points one
    /// list for each axis, as long as there are points.
    Given(Vec<Vec<f64>>),
}

/// Points on a grid, `ambient` numbers each, in C order.
pub(crate) struct Grid<'a> {
    pub points: &'a [f64],
    pub counts: &'a [usize],
    pub ambient: usize,
}

impl Parameters {
    /// One list for each axis of a grid.
    pub(crate) fn of_grid(&self, grid: &Grid) -> Result<Vec<Vec<f64>>> {
        match self {
            Self::Given(lists) => {
                require_lists(lists, grid.counts)?;
                Ok(lists.clone())
            }
            Self::Uniform => Ok(grid.counts.iter().map(|&count| uniform(count)).collect()),
            Self::Chord => grid.along_every_axis(|distance| distance),
            Self::Centripetal => grid.along_every_axis(f64::sqrt),
        }
    }
}

/// Complains unless the lists are finite and have these lengths.
pub(crate) fn require_lists(lists: &[Vec<f64>], counts: &[usize]) -> Result<()> {
    let lengths: Vec<usize> = lists.iter().map(Vec::len).collect();
    if lengths != counts {
        return Err(Error::shape(
            "parameters",
            format!("lists of lengths {lengths:?}"),
            format!("lengths {counts:?}, one list for each axis"),
        ));
    }
    match lists.iter().flatten().find(|t| !t.is_finite()) {
        None => Ok(()),
        Some(t) => Err(Error::domain("parameters", t, "finite numbers")),
    }
}

fn uniform(count: usize) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|i| i as f64 / last).collect()
}

impl Grid<'_> {
    fn along_every_axis(&self, measure: impl Fn(f64) -> f64) -> Result<Vec<Vec<f64>>> {
        (0..self.counts.len()).map(|axis| self.along(axis, &measure)).collect()
    }

    /// Cumulated lengths of the lines along `axis`, each scaled to 1, averaged.
    fn along(&self, axis: usize, measure: impl Fn(f64) -> f64) -> Result<Vec<f64>> {
        let count = self.counts[axis];
        if count == 1 {
            return Ok(vec![0.0]);
        }
        let mut sums = vec![0.0; count];
        let mut lines = 0.0;
        for line in self.lines(axis) {
            let mut lengths = vec![0.0];
            for pair in line.windows(2) {
                lengths.push(lengths[lengths.len() - 1] + measure(distance(pair[0], pair[1])));
            }
            let total = lengths[count - 1];
            if total > 0.0 {
                lines += 1.0;
                for (sum, length) in sums.iter_mut().zip(&lengths) {
                    *sum += length / total;
                }
            }
        }
        if lines == 0.0 {
            return Err(Error::degenerate(
                "points",
                format!("points that all coincide along axis {axis}"),
                "distinct points, or uniform or given parameters",
            ));
        }
        for sum in &mut sums {
            *sum /= lines;
        }
        sums[count - 1] = 1.0;
        Ok(sums)
    }

    /// Every line of points along `axis`.
    fn lines(&self, axis: usize) -> impl Iterator<Item = Vec<&[f64]>> {
        let stride: usize = self.counts[axis + 1..].iter().product();
        let outer: usize = self.counts[..axis].iter().product();
        let count = self.counts[axis];
        (0..outer * stride).map(move |line| {
            let start = line / stride * stride * count + line % stride;
            (0..count)
                .map(|i| &self.points[(start + i * stride) * self.ambient..][..self.ambient])
                .collect()
        })
    }
}

/// The distance of two points.
pub(crate) fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (x, y)| libm::hypot(sum, x - y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chords_and_their_roots() {
        let points = [0.0, 0.0, 3.0, 4.0, 3.0, 5.0];
        let grid = Grid { points: &points, counts: &[3], ambient: 2 };
        assert_eq!(Parameters::Chord.of_grid(&grid).unwrap(), [[0.0, 5.0 / 6.0, 1.0]]);
        let root = 5.0_f64.sqrt();
        let list = &Parameters::Centripetal.of_grid(&grid).unwrap()[0];
        assert!((list[1] - root / (root + 1.0)).abs() < 1e-15);
        assert_eq!(Parameters::Uniform.of_grid(&grid).unwrap(), [[0.0, 0.5, 1.0]]);
    }

    #[test]
    fn sizes_do_not_matter() {
        for size in [1e-200, 1e200, 1e-300, 1e307] {
            let points = [0.0, 0.0, 3.0 * size, 4.0 * size, 3.0 * size, 5.0 * size];
            let grid = Grid { points: &points, counts: &[3], ambient: 2 };
            let list = &Parameters::Chord.of_grid(&grid).unwrap()[0];
            assert!((list[1] - 5.0 / 6.0).abs() < 1e-15, "{size}");
        }
    }

    #[test]
    fn a_grid_averages_its_lines_and_skips_collapsed_ones() {
        // Two lines along axis 0: a point, and points at 0, 1, 4.
        let points = [7.0, 0.0, 7.0, 1.0, 7.0, 4.0];
        let grid = Grid { points: &points, counts: &[3, 2], ambient: 1 };
        let lists = Parameters::Chord.of_grid(&grid).unwrap();
        assert_eq!(lists[0], [0.0, 0.25, 1.0]);
        assert_eq!(lists[1], [0.0, 1.0]);
    }

    #[test]
    fn coincident_points_have_no_chord() {
        let grid = Grid { points: &[1.0, 1.0, 1.0], counts: &[3], ambient: 1 };
        let error = Parameters::Chord.of_grid(&grid).unwrap_err();
        assert_eq!(error.family(), "Degenerate");
    }
}
