//! The order of the curves of a network: along each curve the others follow one another the same way.

use pforms_kernel::{Error, Result};

/// For each curve of a family, the parameters of the crossings with the curves of the other one.
pub(super) struct Order {
    /// Numbers of the crossing curves, from the first crossed to the last.
    pub across: Vec<usize>,
    /// Which curves of the family run the other way.
    pub reversed: Vec<bool>,
    /// Parameters along each curve, in the order `across`, once those are turned round.
    pub parameters: Vec<Vec<f64>>,
}

/// Finds the order from all parameters where curve `j` of the family is met by curve `i` of the
/// other: `met[j][i]`, in growing order. The first curve sets the direction.
///
/// A curve that closes is met twice by a curve through its seam. Where that curve is given twice,
/// once for each side, the first stands for the beginning and the second for the end.
///
/// Curves that are single `points` are met everywhere: they say nothing, and get no parameters here.
///
/// Errors: `Domain` when no direction of some curve gives the order of the first; `Degenerate` when
/// all are points.
pub(super) fn order(name: &str, met: &[Vec<Vec<f64>>], points: &[bool]) -> Result<Order> {
    let Some(lead) = points.iter().position(|point| !point) else {
        return Err(Error::degenerate(name, "curves that are points", "a curve with a length"));
    };
    let first = chosen(&met[lead]);
    let mut across: Vec<usize> = (0..first.len()).collect();
    across.sort_by(|a, b| first[*a].total_cmp(&first[*b]));
    let mut order = Order { across, reversed: Vec::new(), parameters: Vec::new() };
    for (j, lists) in met.iter().enumerate() {
        if points[j] {
            order.reversed.push(false);
            order.parameters.push(Vec::new());
            continue;
        }
        let turned: Vec<Vec<f64>> =
            lists.iter().map(|list| list.iter().rev().map(|t| 1.0 - t).collect()).collect();
        let ways = [(false, chosen(lists)), (true, chosen(&turned))];
        let sorted = |list: &Vec<f64>| order.across.iter().map(|&i| list[i]).collect::<Vec<f64>>();
        let right = ways.iter().map(|(way, list)| (*way, sorted(list)));
        let Some((way, list)) = right.into_iter().find(|(_, list)| list.is_sorted_by(|a, b| a < b))
        else {
            return Err(Error::domain(
                name,
                format!("curve {j} crossed at {:?}", sorted(&ways[0].1)),
                format!("crossings in the order {:?}, as along curve {lead}", order.across),
            ));
        };
        order.reversed.push(way);
        order.parameters.push(list);
    }
    Ok(order)
}

/// One parameter for each crossing curve; curves met at the same places share these out.
fn chosen(lists: &[Vec<f64>]) -> Vec<f64> {
    const SAME: f64 = 1e-3;
    let alike = |a: &Vec<f64>, b: &Vec<f64>| {
        a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x - y).abs() < SAME)
    };
    let choose = |(i, list): (usize, &Vec<f64>)| {
        let before = lists[..i].iter().filter(|other| alike(other, list)).count();
        let after = lists[i + 1..].iter().filter(|other| alike(other, list)).count();
        let last = list.len() - 1;
        if before > 0 && after == 0 { list[last] } else { list[before.min(last)] }
    };
    lists.iter().enumerate().map(choose).collect()
}
