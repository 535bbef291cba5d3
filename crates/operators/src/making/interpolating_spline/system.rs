//! The slopes that make cubics through given values meet twice continuously differentiable.

use pforms_kernel::{Error, Result, Scalar};

use super::SplineEnds;

/// A row of the system: coefficients of the unknowns before, here and after, and the right side.
struct Row<S> {
    before: S,
    here: S,
    after: S,
    right: Vec<S>,
}

/// The slope at every value; `steps` are the distances between their parameters.
pub(super) fn slopes<S: Scalar>(
    values: &[&[S]],
    steps: &[S],
    ends: &SplineEnds<S>,
) -> Result<Vec<Vec<S>>> {
    let rises: Vec<Vec<S>> = values
        .windows(2)
        .zip(steps)
        .map(|(pair, h)| {
            let both = pair[0].iter().zip(pair[1]);
            both.map(|(from, to)| (to.clone() - from.clone()) / h.clone()).collect()
        })
        .collect();
    let last = steps.len() - 1;
    // h_i·m_{i−1} + 2(h_{i−1} + h_i)·m_i + h_{i−1}·m_{i+1} = 3(h_i·d_{i−1} + h_{i−1}·d_i)
    let inner = |left: usize, right: usize| {
        let (a, b) = (&steps[left], &steps[right]);
        let three = S::from_integer(3);
        Row {
            before: b.clone(),
            here: S::from_integer(2) * (a.clone() + b.clone()),
            after: a.clone(),
            right: mixed(
                &(three.clone() * b.clone()),
                &rises[left],
                &(three * a.clone()),
                &rises[right],
            ),
        }
    };
    if *ends == SplineEnds::Periodic {
        if values[0] != values[values.len() - 1] {
            return Err(Error::domain(
                "points",
                "a last point that is not the first",
                "the first point again at the end of a periodic axis",
            ));
        }
        let rows = (0..=last).map(|i| inner(if i == 0 { last } else { i - 1 }, i)).collect();
        let mut found = cyclic(rows)?;
        found.push(found[0].clone());
        return Ok(found);
    }
    let mut rows = vec![end_row(steps, &rises, ends, true)];
    rows.extend((1..=last).map(|i| inner(i - 1, i)));
    rows.push(end_row(steps, &rises, ends, false));
    tridiagonal(rows)
}

/// The equation of an end.
fn end_row<S: Scalar>(steps: &[S], rises: &[Vec<S>], ends: &SplineEnds<S>, first: bool) -> Row<S> {
    let last = steps.len() - 1;
    let (near, far) = if first { (0, 1.min(last)) } else { (last, last.saturating_sub(1)) };
    let multiple = |factor: i64| -> Vec<S> {
        rises[near].iter().map(|d| S::from_integer(factor) * d.clone()).collect()
    };
    let (here, neighbour, right) = match (ends, steps.len()) {
        (SplineEnds::Clamped(start, end), _) => {
            (S::one(), S::zero(), if first { start.clone() } else { end.clone() })
        }
        // A line through two points, a parabola through three.
        (SplineEnds::NotAKnot, 1) => (S::one(), S::zero(), multiple(1)),
        (SplineEnds::NotAKnot, 2) => (S::one(), S::one(), multiple(2)),
        (SplineEnds::NotAKnot, _) => {
            let (a, b) = (&steps[near], &steps[far]);
            let sum = a.clone() + b.clone();
            let own = (a.clone() + S::from_integer(2) * sum.clone()) * b.clone() / sum.clone();
            let other = a.clone() * a.clone() / sum.clone();
            (b.clone(), sum, mixed(&own, &rises[near], &other, &rises[far]))
        }
        _ => (S::from_integer(2), S::one(), multiple(3)),
    };
    let (before, after) = if first { (S::zero(), neighbour) } else { (neighbour, S::zero()) };
    Row { before, here, after, right }
}

fn mixed<S: Scalar>(a: &S, x: &[S], b: &S, y: &[S]) -> Vec<S> {
    x.iter().zip(y).map(|(x, y)| a.clone() * x.clone() + b.clone() * y.clone()).collect()
}

/// Elimination without exchange: every row but those of the ends has a dominant diagonal, and those
/// of the ends leave one behind.
fn tridiagonal<S: Scalar>(mut rows: Vec<Row<S>>) -> Result<Vec<Vec<S>>> {
    for i in 1..rows.len() {
        let (done, rest) = rows.split_at_mut(i);
        let (above, row) = (&done[i - 1], &mut rest[0]);
        let factor = -(row.before.clone() / pivot(above)?);
        row.here = row.here.clone() + factor.clone() * above.after.clone();
        S::add_multiple(&mut row.right, &factor, &above.right);
    }
    let mut found: Vec<Vec<S>> = Vec::with_capacity(rows.len());
    for row in rows.iter().rev() {
        let mut value = row.right.clone();
        if let Some(next) = found.last() {
            S::add_multiple(&mut value, &-row.after.clone(), next);
        }
        let here = pivot(row)?;
        found.push(value.into_iter().map(|x| x / here.clone()).collect());
    }
    found.reverse();
    Ok(found)
}

fn pivot<S: Scalar>(row: &Row<S>) -> Result<S> {
    if row.here.is_zero() || !row.here.is_finite() {
        return Err(Error::degenerate(
            "parameters",
            "parameters whose steps are too unlike",
            "steps that can be divided by one another",
        ));
    }
    Ok(row.here.clone())
}

/// The same for a ring of rows: the last unknown is moved to the right side, and found last.
fn cyclic<S: Scalar>(mut rows: Vec<Row<S>>) -> Result<Vec<Vec<S>>> {
    let Some(closing) = rows.pop() else { return Ok(Vec::new()) };
    let last = rows.len();
    if last == 0 {
        let sum = closing.before + closing.here + closing.after;
        return Ok(vec![closing.right.into_iter().map(|x| x / sum.clone()).collect()]);
    }
    for (i, row) in rows.iter_mut().enumerate() {
        let mut share = S::zero();
        if i == 0 {
            share += std::mem::replace(&mut row.before, S::zero());
        }
        if i + 1 == last {
            share += std::mem::replace(&mut row.after, S::zero());
        }
        row.right.push(share);
    }
    let mut found = tridiagonal(rows)?;
    let columns: Vec<S> = found.iter_mut().map(|line| line.pop().unwrap_or_else(S::zero)).collect();
    // before·x_{last−1} + here·x_last + after·x_0 = right, with x_i = found_i − columns_i·x_last.
    let here = closing.here
        - closing.before.clone() * columns[last - 1].clone()
        - closing.after.clone() * columns[0].clone();
    let mut right = closing.right;
    S::add_multiple(&mut right, &-closing.before, &found[last - 1]);
    S::add_multiple(&mut right, &-closing.after, &found[0]);
    let end: Vec<S> = right.into_iter().map(|x| x / here.clone()).collect();
    for (line, column) in found.iter_mut().zip(columns) {
        S::add_multiple(line, &-column, &end);
    }
    found.push(end);
    Ok(found)
}
