//! What must hold of any spline, proved on real models in exact arithmetic.
//!
//! The numbers of a file are binary fractions, so a model is an exact spline to begin with.

use pforms_kernel::{Form, Rational, Scalar};
use pforms_operators::Spline;
use pforms_testkit::Random;

type Exact = Spline<Rational>;

/// Above so many numbers in the net exact arithmetic takes too long for a test.
const MOST: usize = 400;

/// All laws, on a spline and where its size allows on its exact image.
pub(crate) fn hold(name: &str, spline: &Spline) {
    let mut random = Random::new(name.len() as u64);
    rounding(name, spline, &mut random);
    if spline.net().homogeneous().len() > MOST {
        return;
    }
    let exact = spline.map_scalar(|x| Rational::from_f64(*x).unwrap()).unwrap();
    let places: Vec<Vec<Rational>> = (0..3).map(|_| place(&exact, &mut random)).collect();
    let values: Vec<Vec<Rational>> =
        places.iter().map(|place| exact.homogeneous_at(place).unwrap()).collect();
    let same = |other: &Exact, what: &str| {
        for (place, value) in places.iter().zip(&values) {
            assert_eq!(other.homogeneous_at(place).unwrap(), *value, "{name}: {what} at {place:?}");
        }
    };
    pieces(name, &exact, &places, &values);
    taken_apart(name, &exact);
    derivatives(name, &exact, &places[0]);
    same(&exact.elevate(&vec![1; exact.axes()]).unwrap(), "elevated");
    for axis in 0..exact.axes() {
        let t = places[0][axis].clone();
        let finer = exact.insert_knots(axis, &[t.clone(), places[1][axis].clone()]).unwrap();
        same(&finer, "with more knots");
        removed(name, &exact, axis, &t);
        halves(name, &exact, axis, &t);
        turned(name, &exact, axis);
        let (sub, place) = (exact.sub(axis, &t).unwrap(), without(&places[0], axis));
        assert_eq!(sub.homogeneous_at(&place).unwrap(), values[0], "{name}: sub-spline of {axis}");
    }
}

/// Parameters inside the windows, none of them a knot of any model here.
fn place(exact: &Exact, random: &mut Random) -> Vec<Rational> {
    let inside = |axis| {
        let (from, to) = exact.window(axis).unwrap();
        let share = Rational::ratio(random.integer(1, 1008), 1009);
        from.clone() + (to - from) * share
    };
    (0..exact.axes()).map(inside).collect()
}

fn without(place: &[Rational], axis: usize) -> Vec<Rational> {
    [&place[..axis], &place[axis + 1..]].concat()
}

/// Each piece, on its own [0, 1], is the spline over its window.
fn pieces(name: &str, exact: &Exact, places: &[Vec<Rational>], values: &[Vec<Rational>]) {
    for (place, value) in places.iter().zip(values) {
        let (piece, local, _) = piece_at(exact, place);
        assert_eq!(piece.homogeneous_at(&local).unwrap(), *value, "{name}: its piece");
    }
}

/// The piece over a place, the place in that piece, and how long its windows are.
fn piece_at(exact: &Exact, place: &[Rational]) -> (Form<Rational>, Vec<Rational>, Vec<Rational>) {
    let (mut index, mut local, mut lengths) = (Vec::new(), Vec::new(), Vec::new());
    for (t, list) in place.iter().zip(exact.breaks()) {
        let i = list.partition_point(|b| b <= t) - 1;
        let length = list[i + 1].clone() - list[i].clone();
        local.push((t.clone() - list[i].clone()) / length.clone());
        lengths.push(length);
        index.push(i);
    }
    (exact.piece(&index).unwrap(), local, lengths)
}

/// The derivative as a spline has the values of the derivatives of the pieces.
fn derivatives(name: &str, exact: &Exact, place: &[Rational]) {
    let (piece, local, lengths) = piece_at(exact, place);
    for axis in 0..exact.axes() {
        for times in 1..=if exact.axes() == 1 { 3 } else { 1 } {
            let mut orders = vec![0; exact.axes()];
            orders[axis] = times;
            let here = exact.derivative(&orders).unwrap().at(place).unwrap();
            let factor = (0..times).fold(Rational::ratio(1, 1), |f, _| f / lengths[axis].clone());
            let there = piece.derivative_at(&local, &orders).unwrap();
            let there: Vec<Rational> = there.into_iter().map(|x| x * factor.clone()).collect();
            assert_eq!(here, there, "{name}: derivative {orders:?}");
        }
    }
}

/// Taken apart into pieces and laid end to end again; the knots that this adds removed again.
fn taken_apart(name: &str, exact: &Exact) {
    let bezier = exact.bezier().unwrap();
    assert!(bezier.is_bezier(), "{name}");
    assert_eq!(bezier.breaks(), exact.breaks(), "{name}");
    assert_eq!(bezier.pieces().unwrap(), exact.pieces().unwrap(), "{name}");
    if let [breaks] = bezier.breaks().as_slice() {
        let again = Spline::end_to_end(&exact.pieces().unwrap(), 0, breaks).unwrap();
        assert_eq!(again.pieces().unwrap(), exact.pieces().unwrap(), "{name}: end to end");
    }
    let mut back = bezier;
    for axis in 0..exact.axes() {
        for t in &exact.breaks()[axis] {
            let surplus = back.knots()[axis].multiplicity(t) - exact.knots()[axis].multiplicity(t);
            for _ in 0..surplus {
                let removal = back.remove_knot(axis, t).unwrap();
                assert_eq!(removal.defect, Rational::default(), "{name}: knot {t:?} of {axis}");
                back = removal.spline;
            }
        }
    }
    assert_eq!(back, *exact, "{name}: pieces and back");
}

fn removed(name: &str, exact: &Exact, axis: usize, t: &Rational) {
    let removal = exact.insert_knots(axis, std::slice::from_ref(t)).unwrap();
    let removal = removal.remove_knot(axis, t).unwrap();
    assert_eq!((removal.spline, removal.defect), (exact.clone(), Rational::default()), "{name}");
}

/// The two parts have the parameters of the whole, and its points.
fn halves(name: &str, exact: &Exact, axis: usize, t: &Rational) {
    let (low, high) = exact.split(axis, t).unwrap();
    for (part, share) in [(&low, 3), (&high, 5)] {
        let mut place: Vec<Rational> = (0..exact.axes())
            .map(|k| {
                let (from, to) = part.window(k).unwrap();
                from.clone() + (to - from) * Rational::ratio(share, 7)
            })
            .collect();
        let value = exact.homogeneous_at(&place).unwrap();
        assert_eq!(part.homogeneous_at(&place).unwrap(), value, "{name}: split along {axis}");
        place[axis] = t.clone();
        let value = exact.homogeneous_at(&place).unwrap();
        assert_eq!(part.homogeneous_at(&place).unwrap(), value, "{name}: where {axis} is cut");
    }
}

/// Run backwards twice, turned and turned back: the same, bit for bit.
fn turned(name: &str, exact: &Exact, axis: usize) {
    let back = exact.reverse(axis).unwrap();
    assert_eq!(back.reverse(axis).unwrap(), *exact, "{name}: backwards");
    let mut axes: Vec<usize> = (0..exact.axes()).collect();
    axes.rotate_left(axis);
    let turned = exact.transpose(&axes).unwrap();
    axes.rotate_left((2 * (exact.axes() - axis)) % exact.axes());
    let mut again = vec![0; axes.len()];
    for (to, from) in (0..axes.len()).map(|k| (k + axis) % axes.len()).enumerate() {
        again[from] = to;
    }
    assert_eq!(turned.transpose(&again).unwrap(), *exact, "{name}: turned");
}

/// In floating point: every road to a point gives it within a few roundings of the size of the poles.
fn rounding(name: &str, spline: &Spline, random: &mut Random) {
    let bound = 1e-13 * crate::scale(spline);
    let by = vec![1; spline.axes()];
    let raised = spline.elevate(&by).unwrap();
    let bezier = spline.bezier().unwrap();
    for _ in 0..10 {
        let fractions: Vec<f64> = (0..spline.axes()).map(|_| random.unit()).collect();
        let place = crate::at_fractions(spline, &fractions);
        let point = spline.at(&place).unwrap();
        for other in [&raised, &bezier] {
            let gap = crate::gap(&other.at(&place).unwrap(), &point);
            assert!(gap <= bound, "{name}: {gap}");
        }
        for axis in 0..spline.axes() {
            let finer = spline.insert_knots(axis, &place[axis..=axis]).unwrap();
            let gap = crate::gap(&finer.at(&place).unwrap(), &point);
            assert!(gap <= bound, "{name}: {gap}");
        }
    }
}

/// A form is a spline of one piece, and that piece is the form.
#[test]
fn a_form_is_a_spline_of_one_piece() {
    for (form, mut random) in pforms_testkit::exact_forms(0..=3) {
        let form: Form<Rational> = form;
        let spline = Spline::from(form.clone());
        let place: Vec<Rational> = random.parameters(form.axes());
        assert_eq!(spline.homogeneous_at(&place).unwrap(), form.homogeneous_at(&place).unwrap());
        assert_eq!(spline.pieces().unwrap(), [form]);
    }
}
