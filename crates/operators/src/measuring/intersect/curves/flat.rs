//! Two curves as plane ones: what of them is flat, and in units of their own.

use pforms_kernel::Form;
use smallvec::SmallVec;

/// Homogeneous poles of a plane curve with coordinates below 1 and positive weights.
pub(super) type Poles3 = SmallVec<[[f64; 3]; 16]>;

/// Two curves in a plane.
pub(super) struct Flat {
    /// The poles of the first.
    pub a: Poles3,
    /// The poles of the second.
    pub b: Poles3,
    /// Has one of them weights that differ?
    pub rational: bool,
    /// Lengths are multiplied by this.
    pub scale: f64,
}

/// Coordinates of a space that is projected on a plane: for each of the two a sum of some.
pub(super) type View = [SmallVec<[(usize, f64); 3]>; 2];

/// The coordinates along which two curves differ from one constant: elsewhere they lie in a plane
/// with equal coordinate, exactly.
pub(super) fn live(a: &Form, b: &Form) -> SmallVec<[usize; 4]> {
    let width = a.width();
    let (first, weight) = (a.homogeneous(), width - 1);
    let constant = |k: usize| {
        let value = first[k] / first[weight];
        let flat = |form: &Form| {
            let uniform = form.uniform_weight().is_some();
            let mut poles = form.homogeneous().chunks_exact(width);
            let exact = value == 0.0 || uniform;
            exact && poles.all(|pole| pole[k] == value * pole[weight])
        };
        flat(a) && flat(b)
    };
    (0..weight).filter(|k| !constant(*k)).collect()
}

/// The views of a space: for a plane the only one; else planes of coordinates, then askew ones.
pub(super) fn views(live: &[usize]) -> Vec<View> {
    let one = |k: usize| SmallVec::from_slice(&[(k, 1.0)]);
    match *live {
        [] => vec![[SmallVec::new(), SmallVec::new()]],
        [x] => vec![[one(x), SmallVec::new()]],
        [x, y] => vec![[one(x), one(y)]],
        [x, y, ..] => {
            let z = live[2];
            let askew = |p: f64, q: f64| -> View {
                let sum = |k: usize, c: f64| SmallVec::from_slice(&[(k, 1.0), (z, c)]);
                [sum(x, p), sum(y, q)]
            };
            let mut all = vec![[one(x), one(y)], [one(y), one(z)], [one(x), one(z)]];
            all.extend([askew(0.625, -0.375), askew(-0.25, 0.5), askew(1.5, 2.25)]);
            all
        }
    }
}

impl Flat {
    /// Two curves as seen; their weights must have one sign each.
    pub(super) fn new(a: &Form, b: &Form, view: &View) -> Self {
        let (mut p, mut q) = (poles(a, view), poles(b, view));
        let rational = a.is_rational() || b.is_rational();
        let largest = |poles: &Poles3, k: usize| {
            poles.iter().fold(0.0_f64, |most, pole| most.max(pole[k].abs()))
        };
        for poles in [&mut p, &mut q] {
            let sign = poles[0][2].signum();
            let unit = sign / if rational { power(largest(poles, 2)) } else { largest(poles, 2) };
            for pole in poles.iter_mut() {
                *pole = pole.map(|x| x * unit);
            }
        }
        let reach = [&p, &q]
            .iter()
            .fold(0.0_f64, |most, poles| most.max(largest(poles, 0)).max(largest(poles, 1)));
        let scale = if reach > 0.0 { 1.0 / power(reach) } else { 1.0 };
        for pole in p.iter_mut().chain(&mut q) {
            pole[0] *= scale;
            pole[1] *= scale;
        }
        Self { a: p, b: q, rational, scale }
    }
}

/// Homogeneous poles as seen.
pub(super) fn poles(form: &Form, view: &View) -> Poles3 {
    let weight = form.ambient();
    let poles = form.homogeneous().chunks_exact(form.width());
    poles
        .map(|pole| {
            let sum = |k: usize| view[k].iter().map(|(i, c)| c * pole[*i]).sum();
            [sum(0), sum(1), pole[weight]]
        })
        .collect()
}

/// The power of two above a positive number.
fn power(x: f64) -> f64 {
    let (_, exponent) = libm::frexp(x);
    libm::ldexp(1.0, exponent.clamp(-1021, 1023))
}
