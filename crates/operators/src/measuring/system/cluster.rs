//! What belongs together: one root found twice, neighbouring cells that are undecided.

use super::{Cluster, Equations, Root, newton};

/// A box, and whether it was left because the work was at an end.
type Left = ((Vec<f64>, Vec<f64>), bool);

/// Puts roots in the order of their parameters, and one for each.
///
/// Two cells that meet may both claim a root on their border. Each has shown that there is no other
/// in its ball.
pub(super) fn merge_roots(roots: &mut Vec<Root>) {
    roots.sort_by(|a, b| {
        let each = a.parameters.iter().zip(&b.parameters).map(|(s, t)| s.total_cmp(t));
        each.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
    });
    let mut kept: Vec<Root> = Vec::with_capacity(roots.len());
    for root in roots.drain(..) {
        let same = |other: &Root| {
            let reach = 2.0 * (root.radius + other.radius) + 16.0 * f64::EPSILON;
            root.parameters.iter().zip(&other.parameters).all(|(s, t)| (s - t).abs() <= reach)
        };
        if !kept.iter().rev().any(same) {
            kept.push(root);
        }
    }
    *roots = kept;
}

/// Gathers boxes that touch, or nearly so.
pub(super) fn gather(equations: &Equations, mut left: Vec<Left>) -> Vec<Cluster> {
    left.sort_by(|a, b| a.0.0[0].total_cmp(&b.0.0[0]));
    let mut parent: Vec<usize> = (0..left.len()).collect();
    // Boxes that begin before this one does, and reach it.
    let mut open: Vec<usize> = Vec::new();
    for i in 0..left.len() {
        open.retain(|j| reaches(&left[*j], &left[i], 0));
        for j in &open {
            if (1..equations.axes()).all(|axis| {
                reaches(&left[*j], &left[i], axis) && reaches(&left[i], &left[*j], axis)
            }) {
                let (a, b) = (leader(&mut parent, *j), leader(&mut parent, i));
                parent[a.max(b)] = a.min(b);
            }
        }
        open.push(i);
    }
    let mut clusters: Vec<(usize, Cluster)> = Vec::new();
    for (i, ((lower, upper), unfinished)) in left.into_iter().enumerate() {
        let group = leader(&mut parent, i);
        let cell = (lower.clone(), upper.clone());
        if let Some((_, known)) = clusters.iter_mut().find(|(leader, _)| *leader == group) {
            known.lower.iter_mut().zip(&lower).for_each(|(a, b)| *a = a.min(*b));
            known.upper.iter_mut().zip(&upper).for_each(|(a, b)| *a = a.max(*b));
            known.unfinished |= unfinished;
            known.cells.push(cell);
        } else {
            let (parameters, residual) = (Vec::new(), 0.0);
            let cells = vec![cell];
            clusters
                .push((group, Cluster { lower, upper, parameters, residual, unfinished, cells }));
        }
    }
    let finished = |(_, mut cluster): (usize, Cluster)| {
        let (parameters, values) = newton::least(equations, &cluster.lower, &cluster.upper);
        cluster.residual = equations.residual(&values);
        cluster.parameters = parameters;
        cluster
    };
    clusters.into_iter().map(finished).collect()
}

/// Does box `a` go as far as where `b` begins, along an axis, or nearly?
fn reaches(a: &Left, b: &Left, axis: usize) -> bool {
    let ((low, high), (start, end)) = (&a.0, &b.0);
    let slack = 0.5 * (high[axis] - low[axis] + end[axis] - start[axis]) + 4.0 * f64::EPSILON;
    high[axis] + slack >= start[axis]
}

fn leader(parent: &mut [usize], mut i: usize) -> usize {
    while parent[i] != i {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    i
}
