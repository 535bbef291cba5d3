//! Parameters as a growing function of other parameters, with a continuous derivative.

/// Growing cubic pieces through given values (Fritsch and Carlson, 1980; slopes of Fritsch and
/// Butland, 1984).
#[derive(Clone, Debug)]
pub(super) struct Pace {
    places: Vec<f64>,
    values: Vec<f64>,
    slopes: Vec<f64>,
}

impl Pace {
    /// Through values that grow, at places that grow: two at least.
    pub(super) fn new(places: Vec<f64>, values: Vec<f64>) -> Self {
        let rates: Vec<f64> = places
            .windows(2)
            .zip(values.windows(2))
            .map(|(x, y)| (y[1] - y[0]) / (x[1] - x[0]))
            .collect();
        let slope = |i: usize| match (i.checked_sub(1).and_then(|k| rates.get(k)), rates.get(i)) {
            (Some(left), Some(right)) => {
                let (a, b) = (places[i] - places[i - 1], places[i + 1] - places[i]);
                let (p, q) = (2.0 * b + a, b + 2.0 * a);
                (p + q) / (p / left + q / right)
            }
            (Some(rate), None) | (None, Some(rate)) => *rate,
            (None, None) => 1.0,
        };
        let slopes = (0..places.len()).map(slope).collect();
        Self { places, values, slopes }
    }

    /// The value and the derivative at `u`.
    pub(super) fn at(&self, u: f64) -> (f64, f64) {
        let k = self.places.partition_point(|x| *x <= u).clamp(1, self.places.len() - 1) - 1;
        let (from, to) = (self.places[k], self.places[k + 1]);
        let (length, t) = (to - from, (u - from) / (to - from));
        let (y, z) = (self.values[k], self.values[k + 1]);
        let (p, q) = (self.slopes[k] * length, self.slopes[k + 1] * length);
        let rise = z - y;
        let curve = t * (1.0 - t);
        let value = y + t * rise + curve * ((1.0 - t) * (p - rise) - t * (q - rise));
        let slope =
            rise + (1.0 - t) * (1.0 - 3.0 * t) * (p - rise) - t * (2.0 - 3.0 * t) * (q - rise);
        (value, slope / length)
    }

    /// Where the value is `t`; before the first or after the last, that end.
    pub(super) fn inverse(&self, t: f64) -> f64 {
        let last = self.places.len() - 1;
        let (mut low, mut high) = (self.places[0], self.places[last]);
        for _ in 0..64 {
            let middle = 0.5 * (low + high);
            if self.at(middle).0 < t { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}

#[cfg(test)]
mod tests {
    use super::Pace;

    #[test]
    fn it_grows_through_its_values_and_back() {
        let pace = Pace::new(vec![0.0, 0.2, 0.7, 1.0], vec![0.0, 0.5, 0.55, 1.0]);
        let mut before = -1.0;
        for i in 0..=1000 {
            let u = f64::from(i) / 1000.0;
            let (value, slope) = pace.at(u);
            assert!(value > before && slope > 0.0, "{u}");
            assert!((pace.inverse(value) - u).abs() < 1e-12, "{u}");
            before = value;
            let (near, _) = pace.at(u + 1e-7);
            assert!(((near - value) / 1e-7 - slope).abs() < 1e-4, "{u}");
        }
        for (place, value) in [(0.0, 0.0), (0.2, 0.5), (0.7, 0.55), (1.0, 1.0)] {
            assert!((pace.at(place).0 - value).abs() < 1e-15);
        }
    }
}
