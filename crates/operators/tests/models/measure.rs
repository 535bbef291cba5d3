//! Length, area, volume by Gauss quadrature, piece by piece.

use pforms_kernel::Form;
use pforms_operators::Spline;

/// What quadrature says of a spline.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Measured {
    /// Length, area or volume.
    pub(crate) size: f64,
    /// The integral of the determinant of the derivatives, where there are as many as coordinates.
    pub(crate) signed: f64,
}

/// The measure of a spline by `count` nodes along each axis of each piece.
pub(crate) fn measure(spline: &Spline, count: usize) -> Measured {
    let rule = gauss(count);
    let mut sum = Measured::default();
    for piece in spline.bezier().unwrap().pieces().unwrap() {
        let part = piece_measure(&piece, &rule);
        sum.size += part.size;
        sum.signed += part.signed;
    }
    sum
}

/// The measure of several splines together.
pub(crate) fn total(splines: &[Spline], count: usize) -> f64 {
    splines.iter().map(|spline| measure(spline, count).size).sum()
}

/// The integral of `f · n` over a surface, a third of it: the volume that closed surfaces enclose.
pub(crate) fn flux(spline: &Spline, count: usize) -> f64 {
    let rule = gauss(count);
    let mut sum = 0.0;
    for piece in spline.bezier().unwrap().pieces().unwrap() {
        for (weight, point, columns) in samples(&piece, &rule) {
            sum += weight * determinant(&[point, columns[0].clone(), columns[1].clone()]) / 3.0;
        }
    }
    sum
}

fn piece_measure(piece: &Form, rule: &Rule) -> Measured {
    let mut sum = Measured::default();
    for (weight, _, columns) in samples(piece, rule) {
        let gram: Vec<Vec<f64>> =
            columns.iter().map(|a| columns.iter().map(|b| dot(a, b)).collect()).collect();
        sum.size += weight * determinant(&gram).max(0.0).sqrt();
        if columns.len() == piece.ambient() {
            sum.signed += weight * determinant(&columns);
        }
    }
    sum
}

/// Nodes on [0, 1] and their weights.
pub(crate) struct Rule {
    nodes: Vec<f64>,
    weights: Vec<f64>,
}

/// At every node of a piece: the weight, the point, and the derivative along each axis.
fn samples(piece: &Form, rule: &Rule) -> Vec<(f64, Vec<f64>, Vec<Vec<f64>>)> {
    let axes = piece.axes();
    let lists: Vec<&[f64]> = vec![&rule.nodes; axes];
    let values = lifted(piece).grid(&lists).unwrap();
    let slopes: Vec<Vec<f64>> =
        (0..axes).map(|axis| lifted(&slope(piece, axis)).grid(&lists).unwrap()).collect();
    let width = piece.width();
    values
        .chunks(width)
        .enumerate()
        .map(|(index, value)| {
            let w = value[width - 1];
            let point: Vec<f64> = value[..width - 1].iter().map(|x| x / w).collect();
            let columns = slopes.iter().map(|list| {
                let row = &list[index * width..(index + 1) * width];
                point.iter().zip(row).map(|(x, dx)| (dx - x * row[width - 1]) / w).collect()
            });
            let columns = columns.collect();
            (node_weight(rule, axes, index), point, columns)
        })
        .collect()
}

fn node_weight(rule: &Rule, axes: usize, mut index: usize) -> f64 {
    let mut weight = 1.0;
    for _ in 0..axes {
        weight *= rule.weights[index % rule.weights.len()];
        index /= rule.weights.len();
    }
    weight
}

/// The homogeneous coordinates as points of a polynomial form.
fn lifted(form: &Form) -> Form {
    Form::from_points(form.orders(), form.width(), form.homogeneous(), None).unwrap()
}

/// The derivative of the homogeneous coordinates along an axis: differences of poles, by the degree.
fn slope(form: &Form, axis: usize) -> Form {
    let stride = form.orders()[axis + 1..].iter().product::<usize>() * form.width();
    let (order, numbers) = (form.orders()[axis], form.homogeneous());
    if order == 1 {
        return form.map_scalar(|_| 0.0).unwrap();
    }
    let mut poles = Vec::new();
    for block in numbers.chunks(stride * order) {
        let pairs = block[stride..].iter().zip(block);
        poles.extend(pairs.map(|(after, before)| (after - before) * (order - 1) as f64));
    }
    let mut orders = form.orders().to_vec();
    orders[axis] -= 1;
    Form::from_homogeneous(&orders, form.ambient(), poles).unwrap()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn determinant(rows: &[Vec<f64>]) -> f64 {
    let minor = |skip: usize| -> Vec<Vec<f64>> {
        let without = |row: &Vec<f64>| {
            row.iter().enumerate().filter(|(k, _)| *k != skip).map(|(_, x)| *x).collect()
        };
        rows[1..].iter().map(without).collect()
    };
    match rows {
        [] => 1.0,
        [first, ..] => {
            let sign = |k: usize| if k.is_multiple_of(2) { 1.0 } else { -1.0 };
            (0..first.len()).map(|k| sign(k) * first[k] * determinant(&minor(k))).sum()
        }
    }
}

/// The rule of Gauss and Legendre on [0, 1]; the nodes by Newton's method.
pub(crate) fn gauss(count: usize) -> Rule {
    let legendre = |x: f64| {
        let (mut before, mut here) = (1.0, x);
        for k in 2..=count {
            let k = k as f64;
            (before, here) = (here, ((2.0 * k - 1.0) * x * here - (k - 1.0) * before) / k);
        }
        (here, count as f64 * (x * here - before) / (x * x - 1.0))
    };
    let (mut nodes, mut weights) = (Vec::new(), Vec::new());
    for i in 0..count {
        let mut x = -(std::f64::consts::PI * (i as f64 + 0.75) / (count as f64 + 0.5)).cos();
        for _ in 0..20 {
            let (value, slope) = legendre(x);
            x -= value / slope;
        }
        let slope = legendre(x).1;
        nodes.push(f64::midpoint(1.0, x));
        weights.push(1.0 / ((1.0 - x * x) * slope * slope));
    }
    Rule { nodes, weights }
}

#[test]
fn the_rule_integrates_powers() {
    for count in [2, 5, 12, 21] {
        let rule = gauss(count);
        for power in 0..2 * count {
            let values = rule.nodes.iter().map(|x| x.powi(power as i32));
            let sum: f64 = values.zip(&rule.weights).map(|(value, weight)| value * weight).sum();
            assert!((sum - 1.0 / (power as f64 + 1.0)).abs() < 1e-15, "{count} {power}");
        }
    }
}
