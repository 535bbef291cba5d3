//! Points of a spline.

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use super::{Knots, Spline};

impl<S: Scalar> Spline<S> {
    /// The homogeneous point at `parameters`; outside the window the outermost pieces go on, and at
    /// a gap the piece that begins there counts. Exact.
    ///
    /// Errors: `Shape` unless there is one parameter for each axis; `Domain` when one is not finite.
    pub fn homogeneous_at(&self, parameters: &[S]) -> Result<Vec<S>> {
        self.net.require_per_axis("parameters", parameters)?;
        if let Some(t) = parameters.iter().find(|t| !t.is_finite()) {
            return Err(Error::domain("parameters", format!("{t:?}"), "finite numbers"));
        }
        let (spans, factors): (Vec<usize>, Vec<Vec<S>>) = self
            .knots
            .iter()
            .zip(parameters)
            .map(|(knots, t)| {
                let (first, factors) = knots.basis(t);
                (first + knots.degree(), factors)
            })
            .unzip();
        // Only the poles of one piece count.
        let mut poles = Vec::new();
        self.copy(&spans, self.net.homogeneous(), &mut poles);
        let weight = poles[self.ambient()].clone();
        let one_weight = poles.chunks_exact(self.net.width()).all(|p| p[self.ambient()] == weight);
        for factors in &factors {
            let share = poles.len() / factors.len();
            let mut sum = vec![S::zero(); share];
            for (factor, line) in factors.iter().zip(poles.chunks_exact(share)) {
                S::add_multiple(&mut sum, factor, line);
            }
            poles = sum;
        }
        if one_weight {
            poles[self.ambient()] = weight;
        }
        Ok(poles)
    }

    /// The euclidean point at `parameters`, as [`Spline::homogeneous_at`].
    ///
    /// Errors: as there, and `Domain` where the weight vanishes.
    pub fn at(&self, parameters: &[S]) -> Result<Vec<S>> {
        Form::from_homogeneous(&[], self.ambient(), self.homogeneous_at(parameters)?)?.at(&[])
    }
}

impl Spline<f64> {
    /// Points at every combination of the `parameters`, a list for each axis: shape
    /// `(m₁, …, m_d, c)`, the last axis fastest. Each piece is evaluated at once, as a form.
    ///
    /// Errors: as [`Form::grid`].
    pub fn grid(&self, parameters: &[&[f64]]) -> Result<Vec<f64>> {
        self.net.require_per_axis("parameters", parameters)?;
        let sizes: Vec<usize> = parameters.iter().map(|list| list.len()).collect();
        let ambient = self.ambient();
        let mut points = vec![0.0; limit::check::<f64>("the points", &sizes, ambient)?];
        let groups: Vec<Vec<Group>> =
            self.knots.iter().zip(parameters).map(|(knots, list)| groups(knots, list)).collect();
        let counts: Vec<usize> = groups.iter().map(Vec::len).collect();
        for index in super::indices(&counts) {
            let chosen: Vec<&Group> = index.iter().zip(&groups).map(|(i, all)| &all[*i]).collect();
            let spans: Vec<usize> = chosen.iter().map(|group| group.span).collect();
            let lists: Vec<&[f64]> = chosen.iter().map(|group| group.local.as_slice()).collect();
            let part = self.over(&spans)?.grid(&lists)?;
            for (place, point) in part.chunks_exact(ambient).enumerate() {
                let mut rest = place;
                let mut target = 0;
                let mut stride = 1;
                for (group, size) in chosen.iter().zip(&sizes).rev() {
                    target += group.places[rest % group.places.len()] * stride;
                    rest /= group.places.len();
                    stride *= size;
                }
                points[target * ambient..(target + 1) * ambient].copy_from_slice(point);
            }
        }
        Ok(points)
    }

    /// Points at scattered parameters, lists of one length, one for each axis: shape `(m, c)`.
    ///
    /// Errors: as [`Form::scattered`].
    pub fn scattered(&self, parameters: &[&[f64]]) -> Result<Vec<f64>> {
        self.net.require_per_axis("parameters", parameters)?;
        let count = parameters.first().map_or(1, |list| list.len());
        if let Some(list) = parameters.iter().find(|list| list.len() != count) {
            let received = format!("{} and {count} numbers", list.len());
            return Err(Error::shape("parameters", received, "lists of one length"));
        }
        let ambient = self.ambient();
        let mut points = vec![0.0; limit::check::<f64>("the points", &[count], ambient)?];
        let mut order: Vec<(Vec<usize>, usize)> = (0..count)
            .map(|i| {
                let spans = self.knots.iter().zip(parameters);
                (spans.map(|(knots, list)| knots.span(&list[i])).collect(), i)
            })
            .collect();
        order.sort();
        for group in order.chunk_by(|a, b| a.0 == b.0) {
            let spans = &group[0].0;
            let locals: Vec<Vec<f64>> = (0..self.axes())
                .map(|axis| {
                    let list = group.iter().map(|(_, i)| parameters[axis][*i]);
                    list.map(|t| self.knots[axis].local(spans[axis], t)).collect()
                })
                .collect();
            let lists: Vec<&[f64]> = locals.iter().map(Vec::as_slice).collect();
            let piece = self.over(spans)?;
            let part = if lists.is_empty() { piece.at(&[])? } else { piece.scattered(&lists)? };
            for ((_, i), point) in group.iter().zip(part.chunks_exact(ambient)) {
                points[i * ambient..(i + 1) * ambient].copy_from_slice(point);
            }
        }
        Ok(points)
    }
}

/// Parameters that fall on one piece, with their places in the list.
struct Group {
    span: usize,
    places: Vec<usize>,
    local: Vec<f64>,
}

fn groups(knots: &Knots<f64>, parameters: &[f64]) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    for (place, &t) in parameters.iter().enumerate() {
        let span = knots.span(&t);
        let known = groups.iter().rposition(|group| group.span == span);
        let which = known.unwrap_or_else(|| {
            groups.push(Group { span, places: Vec::new(), local: Vec::new() });
            groups.len() - 1
        });
        groups[which].places.push(place);
        groups[which].local.push(knots.local(span, t));
    }
    groups
}

impl<S: Scalar> Knots<S> {
    /// The parameter of the piece over `span` that corresponds to `t`.
    pub(super) fn local(&self, span: usize, t: S) -> S {
        let (from, to) = (&self.as_slice()[span], &self.as_slice()[span + 1]);
        (t - from.clone()) / (to.clone() - from.clone())
    }
}
