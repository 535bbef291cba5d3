//! Vertices at one place, or near it, made one.

use std::collections::HashMap;

use crate::vector::{Vec3, norm, subtract};

/// The vertices without repetitions, and the triangles between them; triangles that have become
/// lines are left out, and so are vertices that belong to none.
pub(crate) fn welded(places: &[Vec3], triangles: &[[u32; 3]]) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let (places, triangles, _) = joined(places, triangles, &at_one_place(places));
    (places, triangles)
}

/// For each vertex the first one at its place.
pub(crate) fn at_one_place(places: &[Vec3]) -> Vec<u32> {
    let mut known: HashMap<[u64; 3], u32> = HashMap::new();
    let mut same: Vec<u32> = Vec::with_capacity(places.len());
    for (number, place) in places.iter().enumerate() {
        // Adding 0 turns −0 into 0: the same place must have the same bits.
        let key = place.map(|x| (x + 0.0).to_bits());
        same.push(*known.entry(key).or_insert(number as u32));
    }
    same
}

/// The mesh with every vertex replaced by the one `same` names, then without what nobody needs; and
/// which triangles were kept.
pub(crate) fn joined(
    places: &[Vec3],
    triangles: &[[u32; 3]],
    same: &[u32],
) -> (Vec<Vec3>, Vec<[u32; 3]>, Vec<usize>) {
    let mut number = vec![u32::MAX; places.len()];
    let (mut kept, mut indices, mut numbers) = (Vec::new(), Vec::new(), Vec::new());
    for (triangle, corners) in triangles.iter().enumerate() {
        let [a, b, c] = corners.map(|vertex| same[vertex as usize]);
        if a == b || b == c || c == a {
            continue;
        }
        numbers.push(triangle);
        indices.push([a, b, c].map(|vertex| {
            let own = &mut number[vertex as usize];
            if *own == u32::MAX {
                *own = kept.len() as u32;
                kept.push(places[vertex as usize]);
            }
            *own
        }));
    }
    (kept, indices, numbers)
}

/// Points in cells of space, so that those near a place are found quickly.
pub(crate) struct Near<'a> {
    places: &'a [Vec3],
    cell: f64,
    cells: HashMap<[i64; 3], Vec<u32>>,
    all: Vec<u32>,
}

impl<'a> Near<'a> {
    /// Some of the points, in cells about as wide as one asks about.
    pub(crate) fn new(places: &'a [Vec3], some: Vec<u32>, cell: f64) -> Self {
        let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
        for vertex in &some {
            cells.entry(index(places[*vertex as usize], cell)).or_default().push(*vertex);
        }
        Self { places, cell, cells, all: some }
    }

    /// The points in a box, and some round it.
    pub(crate) fn within(&self, low: Vec3, high: Vec3) -> Vec<u32> {
        let (from, to) = (index(low, self.cell), index(high, self.cell));
        let counts = [0, 1, 2].map(|k| (to[k] - from[k]) as f64 + 1.0);
        if counts.iter().product::<f64>() > self.all.len() as f64 {
            return self.all.clone();
        }
        let mut found = Vec::new();
        for x in from[0]..=to[0] {
            for y in from[1]..=to[1] {
                for z in from[2]..=to[2] {
                    found.extend(self.cells.get(&[x, y, z]).into_iter().flatten());
                }
            }
        }
        found
    }

    /// The nearest point to one of them, not farther than `reach` and not one that is `barred`.
    pub(crate) fn nearest(
        &self,
        vertex: u32,
        reach: f64,
        barred: impl Fn(u32) -> bool,
    ) -> Option<(u32, f64)> {
        let here = self.places[vertex as usize];
        self.within(here.map(|x| x - reach), here.map(|x| x + reach))
            .into_iter()
            .filter(|other| *other != vertex && !barred(*other))
            .map(|other| (other, norm(subtract(self.places[other as usize], here))))
            .filter(|(_, distance)| *distance <= reach)
            .min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)))
    }
}

fn index(place: Vec3, cell: f64) -> [i64; 3] {
    place.map(|x| libm::floor(x / cell) as i64)
}
