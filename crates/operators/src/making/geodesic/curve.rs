//! A course as splines: in the parameters of the surface, and in space.

use pforms_kernel::{Error, Form, Result};

use super::atlas::Atlas;
use super::cap::Cap;
use super::step::along;
use super::trace::{Chart, Course, Leg};
use crate::measuring::vector::{norm, plus};
use crate::{Nodes, Spline, interpolate};

/// A course in the parameters and in space, both over the window from 0 to its length.
pub(super) struct Drawn {
    pub parameters: Spline,
    pub space: Spline,
    /// How far from the course they are, at most, in units of the atlas.
    pub error: f64,
}

/// Numbers of a polynomial of degree 7.
const ORDER: usize = 8;

/// Parts of a leg below this share of the course are left out: nobody can tell.
const SHORT: f64 = 1e-14;

/// Halvings of a leg over a collapsed edge.
const DEPTH: u32 = 40;

/// Draws a course to within `slack`.
///
/// Errors: `Accuracy` when that takes too many pieces.
pub(super) fn drawn(atlas: &Atlas, course: &Course, slack: f64) -> Result<Drawn> {
    let mut drawing = Drawing {
        atlas,
        slack,
        fit: Fit::new()?,
        shortest: SHORT * course.length.min(1.0),
        cuts: 16 * course.legs.len() + 4096,
        flat: Vec::new(),
        flat_breaks: vec![0.0],
        space: Vec::new(),
        space_breaks: vec![0.0],
        error: 0.0,
    };
    for leg in &course.legs {
        match leg.chart {
            Chart::Piece(net) => drawing.leg(leg, net)?,
            Chart::Cap(axis, side) => {
                if let Some(cap) = atlas.cap(axis, side) {
                    drawing.over_cap(leg, cap, [0.0, 1.0], DEPTH)?;
                }
            }
        }
    }
    let lengths =
        |breaks: &[f64]| -> Vec<f64> { breaks.iter().map(|s| atlas.length(*s)).collect() };
    Ok(Drawn {
        parameters: Spline::end_to_end(&drawing.flat, 0, &lengths(&drawing.flat_breaks))?,
        space: Spline::end_to_end(&drawing.space, 0, &lengths(&drawing.space_breaks))?,
        error: drawing.error,
    })
}

struct Drawing<'a> {
    atlas: &'a Atlas,
    slack: f64,
    fit: Fit,
    /// Parts of a leg that are no longer than this are left out.
    shortest: f64,
    /// How many more cuts there may be.
    cuts: usize,
    flat: Vec<Form>,
    flat_breaks: Vec<f64>,
    space: Vec<Form>,
    space_breaks: Vec<f64>,
    error: f64,
}

impl Drawing<'_> {
    /// A leg over a piece: its polynomials are those of the step.
    fn leg(&mut self, leg: &Leg, net: usize) -> Result<()> {
        let index = self.atlas.index(net);
        let mut poles = Vec::with_capacity(2 * ORDER);
        for k in 0..ORDER {
            poles.extend([0, 1].map(|axis: usize| {
                self.atlas.parameter(axis, index[axis], within(leg.path[axis][k]))
            }));
        }
        self.flat.push(Form::from_points(&[ORDER], 2, &poles, None)?);
        self.flat_breaks.push(leg.from + leg.by);
        let place = |share: f64| leg.path.map(|poles| along(&poles, share, 1.0)[0]);
        let atlas = self.atlas;
        self.in_space(leg, [0.0, 1.0], &|share| atlas.nets[net].point(place(share)), DEPTH)
    }

    /// A leg over the tangent plane of a cap: parameters are found place by place.
    fn over_cap(&mut self, leg: &Leg, cap: &Cap, part: [f64; 2], depth: u32) -> Result<()> {
        let run = 1 - cap.axis;
        if leg.by * (part[1] - part[0]) <= self.shortest {
            return Ok(());
        }
        self.count()?;
        let atlas = self.atlas;
        let at = |share: f64| -> (usize, [f64; 2]) {
            let [u, v] = leg.path.map(|poles| along(&poles, share, leg.by));
            let (net, place) = cap.place_under([u[0], v[0]], [u[1], v[1]]);
            // Beyond the sides of an open one by no more than the slack.
            (net, place.map(|t| t.clamp(0.0, 1.0)))
        };
        let point = |share: f64| {
            let (net, place) = at(share);
            atlas.nets[net].point(place)
        };
        let parameters = |share: f64| {
            let (net, place) = at(share);
            atlas.parameters(net, place)
        };
        let share = |t: f64| part[0] + (part[1] - part[0]) * t;
        let values: Vec<f64> = self.fit.nodes.iter().flat_map(|t| parameters(share(*t))).collect();
        let poles = self.fit.poles(&values, 2);
        let mut worst = 0.0_f64;
        for k in 0..ORDER - 1 {
            let drawn = self.fit.between(&poles, 2, k);
            let (net, place) = atlas.locate([drawn[0], drawn[1]]);
            let drawn = atlas.nets[net].point(place);
            worst = worst.max(norm(&plus(&drawn, -1.0, &point(share(self.fit.middle(k))))));
        }
        // Written so that NaN is cut further.
        let good = worst <= self.slack;
        if good || depth == 0 {
            let beyond = if cap.closed { 0.0 } else { self.slack };
            self.error = self.error.max(worst + beyond);
            self.flat.push(Form::from_points(&[ORDER], 2, &poles, None)?);
            self.flat_breaks.push(leg.from + leg.by * part[1]);
            return self.in_space(leg, part, &point, DEPTH);
        }
        // Where the parameter along the edge jumps, at the edge or over a seam, the course is cut.
        let value = |t: f64| parameters(share(t))[run];
        let gap = |k: &usize| (values[2 * k + 2 + run] - values[2 * k + run]).abs();
        let widest = (0..ORDER - 1).max_by(|a, b| gap(a).total_cmp(&gap(b)));
        let jump = widest.map(|k| (self.fit.nodes[k], self.fit.nodes[k + 1]));
        let cut = jump.and_then(|(from, to)| jump_between(&value, from, to));
        let (before, after) = cut.unwrap_or((0.5, 0.5));
        self.over_cap(leg, cap, [part[0], share(before)], depth - 1)?;
        self.over_cap(leg, cap, [share(after), part[1]], depth - 1)
    }

    /// The points of a part of a leg, by a polynomial or more.
    fn in_space(
        &mut self,
        leg: &Leg,
        part: [f64; 2],
        point: &impl Fn(f64) -> Vec<f64>,
        depth: u32,
    ) -> Result<()> {
        self.count()?;
        let share = |t: f64| part[0] + (part[1] - part[0]) * t;
        let values: Vec<f64> = self.fit.nodes.iter().flat_map(|t| point(share(*t))).collect();
        let ambient = self.atlas.ambient;
        let poles = self.fit.poles(&values, ambient);
        let mut worst = 0.0_f64;
        for k in 0..ORDER - 1 {
            let drawn = self.fit.between(&poles, ambient, k);
            worst = worst.max(norm(&plus(&drawn, -1.0, &point(share(self.fit.middle(k))))));
        }
        let middle = share(0.5);
        let splits = part[0] < middle && middle < part[1];
        if worst > self.slack && depth > 0 && splits {
            self.in_space(leg, [part[0], middle], point, depth - 1)?;
            return self.in_space(leg, [middle, part[1]], point, depth - 1);
        }
        self.error = self.error.max(worst);
        let poles: Vec<f64> =
            poles.chunks_exact(ambient).flat_map(|pole| self.atlas.point(pole)).collect();
        self.space.push(Form::from_points(&[ORDER], ambient, &poles, None)?);
        self.space_breaks.push(leg.from + leg.by * part[1]);
        Ok(())
    }

    /// Errors: `Accuracy` after too many cuts.
    fn count(&mut self) -> Result<()> {
        let accuracy = self.atlas.length(self.slack);
        let few =
            || Error::accuracy("accuracy", accuracy, "one that fewer pieces of a spline reach");
        self.cuts = self.cuts.checked_sub(1).ok_or_else(few)?;
        Ok(())
    }
}

/// Polynomials through values at Lobatto's nodes.
struct Fit {
    nodes: Vec<f64>,
    /// For each node the poles of the polynomial that is 1 there and 0 at the others.
    bases: Vec<f64>,
    /// The Bernstein polynomials in the middle between nodes.
    middles: Vec<f64>,
}

impl Fit {
    fn new() -> Result<Self> {
        let nodes = Nodes::<f64>::Lobatto.on_axis(0, ORDER)?;
        let mut units = vec![0.0; ORDER * ORDER];
        (0..ORDER).for_each(|k| units[k * ORDER + k] = 1.0);
        let units = Form::from_points(&[ORDER], ORDER, &units, None)?;
        let bases = interpolate(&units, &Nodes::Lobatto)?.points()?;
        let mut middles = Vec::with_capacity(ORDER * (ORDER - 1));
        for pair in nodes.windows(2) {
            middles.extend(units.at(&[f64::midpoint(pair[0], pair[1])])?);
        }
        Ok(Self { nodes, bases, middles })
    }

    fn middle(&self, k: usize) -> f64 {
        f64::midpoint(self.nodes[k], self.nodes[k + 1])
    }

    /// The poles of the polynomial through points of so many coordinates; its ends are exact.
    fn poles(&self, values: &[f64], ambient: usize) -> Vec<f64> {
        let mut poles = vec![0.0; ORDER * ambient];
        for (bases, pole) in self.bases.chunks_exact(ORDER).zip(poles.chunks_exact_mut(ambient)) {
            for (basis, point) in bases.iter().zip(values.chunks_exact(ambient)) {
                pole.iter_mut().zip(point).for_each(|(x, y)| *x += basis * y);
            }
        }
        let last = poles.len() - ambient;
        poles[..ambient].copy_from_slice(&values[..ambient]);
        poles[last..].copy_from_slice(&values[last..]);
        poles
    }

    /// The point between two nodes.
    fn between(&self, poles: &[f64], ambient: usize, k: usize) -> Vec<f64> {
        let row = &self.middles[k * ORDER..(k + 1) * ORDER];
        let mut point = vec![0.0; ambient];
        for (value, pole) in row.iter().zip(poles.chunks_exact(ambient)) {
            point.iter_mut().zip(pole).for_each(|(x, y)| *x += value * y);
        }
        point
    }
}

/// Where a function jumps between two places, to the last digit; none if it is only steep.
fn jump_between(value: &impl Fn(f64) -> f64, from: f64, to: f64) -> Option<(f64, f64)> {
    let (mut low, mut high) = (from, to);
    let whole = (value(high) - value(low)).abs();
    loop {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high || high - low < 1e-15 {
            break;
        }
        let here = value(middle);
        let before = (here - value(low)).abs() > (value(high) - here).abs();
        *(if before { &mut high } else { &mut low }) = middle;
    }
    ((value(high) - value(low)).abs() > 0.5 * whole && whole > 0.0).then_some((low, high))
}

/// A share that lies beyond a side by no more than the slack, on it.
fn within(share: f64) -> f64 {
    if share < 0.0 && share > -SLACK {
        return 0.0;
    }
    if share > 1.0 && share < 1.0 + SLACK {
        return 1.0;
    }
    share
}

const SLACK: f64 = 1e-6;
