//! The edges of triangles: which are open, and which way round each triangle goes.

use std::collections::HashMap;

/// Every edge of every triangle in the direction that triangle runs it, and the triangle.
pub(crate) fn directed(triangles: &[[u32; 3]]) -> impl Iterator<Item = ([u32; 2], usize)> + '_ {
    triangles
        .iter()
        .enumerate()
        .flat_map(|(number, &[a, b, c])| [([a, b], number), ([b, c], number), ([c, a], number)])
}

/// The edges that do not run as often one way as the other, with a triangle at each.
pub(crate) fn open(triangles: &[[u32; 3]]) -> Vec<([u32; 2], usize)> {
    let mut balance: HashMap<[u32; 2], i64> = HashMap::new();
    for ([a, b], _) in directed(triangles) {
        *balance.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
    }
    let excess = |[a, b]: [u32; 2]| {
        let ways = balance[&[a.min(b), a.max(b)]];
        if a < b { ways } else { -ways }
    };
    directed(triangles).filter(|(edge, _)| excess(*edge) > 0).collect()
}

/// The edges of an odd number of triangles, whichever way these run them, with a triangle at each.
pub(crate) fn borders(triangles: &[[u32; 3]]) -> Vec<([u32; 2], usize)> {
    let mut count: HashMap<[u32; 2], usize> = HashMap::new();
    for ([a, b], _) in directed(triangles) {
        *count.entry([a.min(b), a.max(b)]).or_default() += 1;
    }
    let odd = |[a, b]: [u32; 2]| count[&[a.min(b), a.max(b)]] % 2 == 1;
    directed(triangles).filter(|(edge, _)| odd(*edge)).collect()
}

/// Triangles next to each other across every edge that has exactly two.
fn neighbours(triangles: &[[u32; 3]]) -> Vec<Vec<usize>> {
    let mut sides: HashMap<[u32; 2], Vec<usize>> = HashMap::new();
    for ([a, b], number) in directed(triangles) {
        sides.entry([a.min(b), a.max(b)]).or_default().push(number);
    }
    let mut next = vec![Vec::new(); triangles.len()];
    for pair in sides.into_values() {
        if let [a, b] = pair[..] {
            next[a].push(b);
            next[b].push(a);
        }
    }
    for list in &mut next {
        list.sort_unstable();
    }
    next
}

/// The connected parts of a mesh, each turned so that its triangles agree across their edges; or
/// nothing if one has a single side.
pub(crate) fn oriented(triangles: &mut [[u32; 3]]) -> Option<Vec<Vec<usize>>> {
    let next = neighbours(triangles);
    let mut reached = vec![false; triangles.len()];
    let mut parts = Vec::new();
    for start in 0..triangles.len() {
        if reached[start] {
            continue;
        }
        reached[start] = true;
        let mut part = vec![start];
        let mut done = 0;
        while done < part.len() {
            let here = part[done];
            done += 1;
            for &other in &next[here] {
                let same = agree(triangles[here], triangles[other]);
                if !reached[other] {
                    if !same {
                        triangles[other].swap(1, 2);
                    }
                    reached[other] = true;
                    part.push(other);
                } else if !same {
                    return None;
                }
            }
        }
        part.sort_unstable();
        parts.push(part);
    }
    Some(parts)
}

/// Do two triangles run their common edge in opposite directions?
fn agree(first: [u32; 3], second: [u32; 3]) -> bool {
    let edges = |[a, b, c]: [u32; 3]| [[a, b], [b, c], [c, a]];
    let common = |[a, b]: [u32; 2]| edges(second).contains(&[b, a]);
    edges(first).into_iter().any(common)
}
