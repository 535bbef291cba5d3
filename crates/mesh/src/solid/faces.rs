//! Patches before they are meshed: those without an area are left out, those inside a volume cancel,
//! and borders that differ by rounding become the same.

use pforms_kernel::{Form, Result};

use crate::pieces::{Piece, finite_pieces};
use crate::space::{embed, project, quadruples};
use crate::vector::{Vec3, cross, norm, subtract};
use crate::weld::Near;

/// Homogeneous poles this near to each other, in sizes of the shell, were the same before they were
/// rounded.
const ROUNDED: f64 = 1e-12;

/// Poles this near a line, in sizes of the shell, are on it but for their rounding.
const ON_A_LINE: f64 = 1e-14;

type Quadruple = [f64; 4];

/// A patch in space, with the pieces of its window on which its weight keeps its sign.
pub(super) struct Face {
    pub(super) form: Form,
    pub(super) pieces: Vec<Piece>,
}

impl Face {
    /// Errors: `Domain` where the weight vanishes.
    pub(super) fn of(patch: &Form) -> Result<Self> {
        let form = embed(patch)?;
        let pieces = finite_pieces(&form)?;
        Ok(Self { form, pieces })
    }

    /// Is it a point or a curve and no more, as a face that turns on an axis is? It has no area, and
    /// its neighbours on both sides meet without it.
    pub(super) fn is_curve(&self, centre: Vec3, radius: f64) -> bool {
        self.is_straight(radius) || (0..2).any(|axis| self.is_constant(axis, centre, radius))
    }

    /// Do all poles lie on a line? Those of the pieces: none of these is at infinity.
    fn is_straight(&self, radius: f64) -> bool {
        let poles = || self.pieces.iter().flat_map(|piece| quadruples(&piece.form)).map(project);
        let Some(first) = poles().next() else { return false };
        let away = |place: Vec3| subtract(place, first).map(|x| x / radius);
        let far = poles().map(away).max_by(|a, b| norm(*a).total_cmp(&norm(*b)));
        let side = far.unwrap_or_default();
        poles().all(|place| norm(cross(away(place), side)) <= ON_A_LINE * norm(side))
    }

    /// Does nothing change along an axis: are all rows of poles multiples of the first?
    fn is_constant(&self, axis: usize, centre: Vec3, radius: f64) -> bool {
        let (orders, poles) = (self.form.orders(), quadruples(&self.form));
        let [n, m] = [orders[axis], orders[1 - axis]];
        let row = |i: usize| -> Vec<f64> {
            let pole = |j: usize| if axis == 0 { poles[i * m + j] } else { poles[j * n + i] };
            (0..m).flat_map(|j| local(&pole(j), centre, radius)).collect()
        };
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let first = row(0);
        let square = product(&first, &first);
        (1..n).map(row).all(|row| {
            let factor = product(&row, &first) / square;
            let off = row.iter().zip(&first).map(|(x, y)| (x - factor * y).abs());
            off.fold(0.0, f64::max) <= ON_A_LINE * square.sqrt() * factor.abs()
        })
    }
}

/// The box round the poles of all pieces: its centre and half its diagonal.
pub(super) fn ball(faces: &[Face]) -> (Vec3, f64) {
    let poles = || {
        let pieces = faces.iter().flat_map(|face| &face.pieces);
        pieces.flat_map(|piece| quadruples(&piece.form)).map(project)
    };
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for pole in poles() {
        for k in 0..3 {
            (low[k], high[k]) = (low[k].min(pole[k]), high[k].max(pole[k]));
        }
    }
    let centre = [0, 1, 2].map(|k| low[k] / 2.0 + high[k] / 2.0);
    (centre, poles().map(|pole| norm(subtract(pole, centre))).fold(0.0, f64::max))
}

/// A homogeneous pole seen from the centre, in radii.
fn local([x, y, z, w]: &Quadruple, centre: Vec3, radius: f64) -> Quadruple {
    let place = [x, y, z];
    let [x, y, z] = [0, 1, 2].map(|k| (place[k] - centre[k] * w) / radius);
    [x, y, z, *w]
}

/// The faces of a volume without those that coincide: it is on both sides of these, as of the wall in
/// which a full turn meets itself.
pub(super) fn without_walls(mut faces: Vec<Face>) -> Vec<Face> {
    let (centre, radius) = ball(&faces);
    let nets: Vec<(Vec<usize>, Vec<Quadruple>)> = faces
        .iter()
        .map(|face| {
            let all = quadruples(&face.form);
            let heaviest = all.iter().fold(f64::MIN_POSITIVE, |most, pole| most.max(pole[3].abs()));
            let own = |pole: &Quadruple| local(&pole.map(|x| x / heaviest), centre, radius);
            (face.form.orders().to_vec(), all.iter().map(own).collect())
        })
        .collect();
    let mut wall = vec![false; faces.len()];
    for i in 0..faces.len() {
        let other =
            (i + 1..faces.len()).find(|&j| !wall[j] && !wall[i] && same(&nets[i], &nets[j]));
        if let Some(j) = other {
            (wall[i], wall[j]) = (true, true);
        }
    }
    let mut walls = wall.into_iter();
    faces.retain(|_| !walls.next().unwrap_or(false));
    faces
}

/// Are two nets the same but for their rounding, in one of the eight ways to lay a square on another?
fn same(first: &(Vec<usize>, Vec<Quadruple>), second: &(Vec<usize>, Vec<Quadruple>)) -> bool {
    let ((orders, poles), (others, places)) = (first, second);
    let [n, m] = [orders[0], orders[1]];
    (0..8).any(|way| {
        let [back, down, swapped] = [way & 1 == 1, way & 2 == 2, way & 4 == 4];
        let fits = if swapped { [m, n] } else { [n, m] };
        let at = |i: usize, j: usize| {
            let i = if back { n - 1 - i } else { i };
            let j = if down { m - 1 - j } else { j };
            places[if swapped { j * n + i } else { i * m + j }]
        };
        let near = |sign: f64| {
            (0..n * m).all(|k| {
                let (a, b) = (poles[k], at(k / m, k % m));
                (0..4).all(|x| (a[x] - sign * b[x]).abs() <= ROUNDED)
            })
        };
        others[..] == fits && (near(1.0) || near(-1.0))
    })
}

/// Makes poles on the borders of patches one that differ by no more than rounding, so that a border
/// is sampled alike whatever patch it is taken from; returns how far a point was moved at most.
///
/// Errors: those of [`Form::from_homogeneous`], which no pole here can cause.
pub(super) fn align(faces: &mut [Face], radius: f64) -> Result<f64> {
    let mut poles: Vec<Quadruple> = Vec::new();
    for face in &*faces {
        poles.extend(rim(face.form.orders()).map(|k| quadruples(&face.form)[k]));
    }
    let places: Vec<Vec3> = poles.iter().map(|[x, y, z, _]| [*x, *y, *z]).collect();
    let near = Near::new(&places, (0..poles.len() as u32).collect(), 1e-6 * radius);
    let reach = |pole: &Quadruple| {
        let largest = pole[..3].iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        ROUNDED * radius + 8.0 * f64::EPSILON * largest
    };
    let (mut target, mut farthest) = (Vec::with_capacity(poles.len()), 0.0_f64);
    for (number, pole) in poles.iter().enumerate() {
        let (place, reach) = (places[number], reach(pole));
        let distance = |other: &Quadruple| {
            let way = [0, 1, 2].map(|k| other[k] - pole[k]);
            norm(way).max((other[3] - pole[3]).abs() * radius)
        };
        let first = near
            .within(place.map(|x| x - reach), place.map(|x| x + reach))
            .into_iter()
            .filter(|k| (*k as usize) < number && target[*k as usize] == *k as usize)
            .find(|k| distance(&poles[*k as usize]) <= reach)
            .map_or(number, |k| k as usize);
        farthest = farthest.max(distance(&poles[first]));
        target.push(first);
    }
    if farthest == 0.0 {
        return Ok(0.0);
    }
    let mut next = target.iter();
    for face in &mut *faces {
        let mut own = quadruples(&face.form).to_vec();
        for (k, target) in rim(face.form.orders()).zip(&mut next) {
            own[k] = poles[*target];
        }
        face.form = Form::from_homogeneous(face.form.orders(), 3, own.concat())?;
    }
    let weights = || {
        let pieces = faces.iter().flat_map(|face| &face.pieces);
        pieces.flat_map(|piece| quadruples(&piece.form)).map(|pole| pole[3].abs())
    };
    // By the difference of the pole, and of its weight times the distance of the point.
    Ok(2.0 * farthest / weights().fold(f64::INFINITY, f64::min))
}

/// The indices of the poles on the border of a net, the first side first.
fn rim(orders: &[usize]) -> impl Iterator<Item = usize> + use<> {
    let [n, m] = [orders[0], orders[1]];
    (0..n * m).filter(move |k| k / m == 0 || k / m + 1 == n || k % m == 0 || k % m + 1 == m)
}
