//! Systems of a few equations that may depend on each other.

/// A solution of `rows·x = right`, the rows as good as consistent: unknowns that the rows leave open
/// are 0. The rows are worked off by largest pivots; what is below `rank` of the largest is nothing.
pub(super) fn solve<const N: usize>(
    rows: &mut [[f64; N]],
    right: &mut [f64],
    rank: f64,
) -> [f64; N] {
    let mut taken = [usize::MAX; N];
    let mut free: Vec<usize> = (0..rows.len()).collect();
    let mut largest = 0.0_f64;
    for _ in 0..N.min(rows.len()) {
        let mut best = (0.0, 0, 0);
        for &i in &free {
            for (j, owner) in taken.iter().enumerate() {
                if *owner == usize::MAX && rows[i][j].abs() > best.0 {
                    best = (rows[i][j].abs(), i, j);
                }
            }
        }
        let (size, i, j) = best;
        largest = largest.max(size);
        if size <= rank * largest || size == 0.0 {
            break;
        }
        taken[j] = i;
        free.retain(|row| *row != i);
        for other in 0..rows.len() {
            let factor = rows[other][j] / rows[i][j];
            if other != i && factor != 0.0 {
                let pivot = rows[i];
                rows[other].iter_mut().zip(pivot).for_each(|(x, y)| *x -= factor * y);
                right[other] -= factor * right[i];
            }
        }
    }
    let mut solution = [0.0; N];
    for (j, i) in taken.iter().enumerate() {
        if *i != usize::MAX {
            solution[j] = right[*i] / rows[*i][j];
        }
    }
    solution
}

#[cfg(test)]
mod tests {
    use super::solve;

    #[test]
    fn what_is_open_stays_zero() {
        let mut rows = [[1.0, 2.0, 0.0], [2.0, 4.0, 0.0], [0.0, 0.0, 3.0]];
        let found = solve(&mut rows, &mut [4.0, 8.0, 6.0], 1e-9);
        assert_eq!(found, [0.0, 2.0, 2.0]);
    }
}
