//! The laws of the exact operators, in exact arithmetic, with `==`.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Form, Matrix, Rational, Scalar, binomial};
use pforms_operators::{
    Spline, blossom, combine, derivative, diagonal, diagonal_all, elevate, hodograph, midpoint,
    partition, raise_together, reparametrise, reverse, split, stack, stretch, sub, subdivide,
    transpose, whole_line,
};
use pforms_testkit::{Random, Weights, exact_forms};

type Exact = Form<Rational>;

fn zero() -> Rational {
    Scalar::zero()
}

fn one() -> Rational {
    Scalar::one()
}

/// Two forms are the same function when they agree as homogeneous points on a grid that is
/// unisolvent for the higher of their degrees.
fn assert_same_function(a: &Exact, b: &Exact) {
    let raised = raise_together(&[a, b]).unwrap();
    assert_eq!(raised[0], raised[1]);
}

#[test]
fn midpoint_is_the_middle_of_the_stack() {
    for (f, mut random) in exact_forms(0..=3) {
        let count = random.size(1, 5);
        let others: Vec<Exact> = (0..count)
            .map(|_| {
                let orders = random.orders(f.axes(), 4);
                random.form(&orders, f.ambient(), Weights::Positive)
            })
            .collect();
        let all: Vec<&Exact> = std::iter::once(&f).chain(&others).collect();
        let generated = stack(&all).unwrap();
        let half = Rational::ratio(1, 2);
        let middle = midpoint(&all).unwrap();
        assert_eq!(middle, sub(&generated, 0, &half).unwrap());
        let n = all.len() - 1;
        let k: Vec<Rational> =
            (0..=n).map(|i| binomial::<Rational>(n, i) * half.power(n)).collect();
        assert_eq!(middle, combine(&k, &all).unwrap(), "row {n} of Pascal's triangle");
    }
}

#[test]
fn stack_has_the_given_forms_at_its_ends() {
    for (f, mut random) in exact_forms(0..=3) {
        let g: Exact = random.form(f.orders(), f.ambient(), Weights::Positive);
        let generated = stack(&[&f, &g, &f]).unwrap();
        assert_eq!(generated.orders()[0], 3);
        assert_eq!(sub(&generated, 0, &zero()).unwrap(), f);
        assert_eq!(sub(&stack(&[&f, &g]).unwrap(), 0, &one()).unwrap(), g);
    }
}

#[test]
fn diagonal_is_the_form_where_two_parameters_agree() {
    for (f, mut random) in exact_forms(2..=4) {
        let first = random.size(0, f.axes() - 2);
        let second = random.size(first + 1, f.axes() - 1);
        let merged = diagonal(&f, first, second).unwrap();
        let m = f.orders()[first] + f.orders()[second] - 1;
        assert_eq!(merged.orders()[first], m);
        for _ in 0..4 {
            let at = random.parameters::<Rational>(merged.axes());
            let mut both = at.clone();
            both.insert(second, at[first].clone());
            assert_eq!(merged.homogeneous_at(&at).unwrap(), f.homogeneous_at(&both).unwrap());
        }
        assert_eq!(merged, diagonal(&f, second, first).unwrap());
    }
}

#[test]
fn diagonal_of_all_axes_does_not_depend_on_the_order_of_merging() {
    for (f, _) in exact_forms(3..=4) {
        let mut from_the_front = f.clone();
        while from_the_front.axes() > 1 {
            from_the_front = diagonal(&from_the_front, 0, 1).unwrap();
        }
        assert_eq!(from_the_front, diagonal_all(&f).unwrap());
    }
}

#[test]
fn elevation_leaves_the_form_unchanged_and_composes() {
    for (f, mut random) in exact_forms(0..=4) {
        let by: Vec<usize> = (0..f.axes()).map(|_| random.size(0, 3)).collect();
        let more: Vec<usize> = (0..f.axes()).map(|_| random.size(0, 2)).collect();
        let raised = elevate(&f, &by).unwrap();
        for _ in 0..3 {
            let at: Vec<Rational> = (0..f.axes()).map(|_| random.fraction()).collect();
            assert_eq!(raised.homogeneous_at(&at).unwrap(), f.homogeneous_at(&at).unwrap());
        }
        let both: Vec<usize> = by.iter().zip(&more).map(|(a, b)| a + b).collect();
        assert_eq!(elevate(&raised, &more).unwrap(), elevate(&f, &both).unwrap());
    }
}

#[test]
fn subdivision_is_the_form() {
    for (f, mut random) in exact_forms(1..=3) {
        let r: Vec<u32> = (0..f.axes()).map(|_| random.size(0, 2) as u32).collect();
        let refined: Spline<Rational> = subdivide(&f, &r).unwrap();
        for (axis, &levels) in r.iter().enumerate() {
            let expected = (f.orders()[axis] - 1) * (1 << levels) + 1;
            assert_eq!(refined.net().orders()[axis], expected);
        }
        for _ in 0..4 {
            let at = random.parameters::<Rational>(f.axes());
            assert_eq!(refined.at(&at).ok(), f.at(&at).ok());
        }
        let counts = refined.counts();
        let last: Vec<usize> = counts.iter().map(|count| count - 1).collect();
        let (a, b): (Vec<Rational>, Vec<Rational>) = counts
            .iter()
            .map(|&count| (Rational::ratio(count as i64 - 1, count as i64), one()))
            .unzip();
        assert_eq!(refined.piece(&last).unwrap(), stretch(&f, &a, &b).unwrap());
    }
}

#[test]
fn stretch_reads_the_form_on_the_new_window_and_composes() {
    for (f, mut random) in exact_forms(1..=3) {
        let mut list = || -> Vec<Rational> { (0..f.axes()).map(|_| random.fraction()).collect() };
        let (a, b, c, d, t) = (list(), list(), list(), list(), list());
        let map = |a: &[Rational], b: &[Rational], t: &[Rational]| -> Vec<Rational> {
            (0..t.len())
                .map(|k| (one() - t[k].clone()) * a[k].clone() + t[k].clone() * b[k].clone())
                .collect()
        };
        let stretched = stretch(&f, &a, &b).unwrap();
        assert_eq!(
            stretched.homogeneous_at(&t).unwrap(),
            f.homogeneous_at(&map(&a, &b, &t)).unwrap()
        );
        assert_eq!(
            stretch(&stretched, &c, &d).unwrap(),
            stretch(&f, &map(&a, &b, &c), &map(&a, &b, &d)).unwrap()
        );
    }
}

#[test]
fn split_meets_and_reverse_is_a_stretch() {
    for (f, mut random) in exact_forms(1..=3) {
        let axis = random.size(0, f.axes() - 1);
        let t: Rational = random.fraction();
        let (low, high) = split(&f, axis, &t).unwrap();
        assert_eq!(sub(&low, axis, &one()).unwrap(), sub(&high, axis, &zero()).unwrap());
        assert_eq!(sub(&low, axis, &one()).unwrap(), sub(&f, axis, &t).unwrap());
        let mut a = vec![zero(); f.axes()];
        let mut b = vec![one(); f.axes()];
        std::mem::swap(&mut a[axis], &mut b[axis]);
        assert_eq!(reverse(&f, axis).unwrap(), stretch(&f, &a, &b).unwrap());
    }
}

#[test]
fn operators_on_different_axes_commute() {
    for (f, mut random) in exact_forms(2..=4) {
        let mut by = vec![0; f.axes()];
        by[0] = 2;
        let t: Rational = random.fraction();
        let last = f.axes() - 1;
        let raise = |g: &Exact| elevate(g, &by[..g.axes()]).unwrap();
        assert_eq!(raise(&sub(&f, last, &t).unwrap()), sub(&raise(&f), last, &t).unwrap());
        let halves = |g: &Exact| split(g, last, &t).unwrap().0;
        assert_eq!(raise(&halves(&f)), halves(&raise(&f)));
    }
}

#[test]
fn mixed_derivatives_do_not_depend_on_their_order() {
    for seed in 0..8 {
        let mut random = Random::new(seed);
        let f: Exact = random.form(&[3, 2], 2, Weights::Positive);
        let t = random.parameters::<Rational>(2);
        let first_u = hodograph(&hodograph(&f, 0).unwrap(), 1).unwrap();
        let first_v = hodograph(&hodograph(&f, 1).unwrap(), 0).unwrap();
        assert_eq!(first_u.at(&t).unwrap(), first_v.at(&t).unwrap());
        assert_eq!(first_u.at(&t).unwrap(), f.derivative_at(&t, &[1, 1]).unwrap());
    }
}

/// A linear map of homogeneous poles: an affine or projective map of the space.
fn mapped(f: &Exact, matrix: &Matrix<Rational>) -> Exact {
    let poles = f.homogeneous().chunks_exact(f.width());
    let images = poles.flat_map(|pole| {
        (0..matrix.rows())
            .map(|i| {
                let terms = matrix.row(i).iter().zip(pole);
                terms.fold(zero(), |sum, (m, x)| sum + m * x)
            })
            .collect::<Vec<_>>()
    });
    Form::from_homogeneous(f.orders(), f.ambient(), images.collect()).unwrap()
}

#[test]
fn operators_commute_with_projective_maps() {
    for (f, mut random) in exact_forms(2..=3) {
        let width = f.width();
        let rows = (0..width).map(|_| (0..width).map(|_| random.fraction()).collect()).collect();
        let matrix = Matrix::from_rows(rows).unwrap();
        let map = |g: &Exact| mapped(g, &matrix);
        let t: Vec<Rational> = random.parameters(f.axes());
        let ones = vec![1; f.axes()];
        assert_eq!(map(&elevate(&f, &ones).unwrap()), elevate(&map(&f), &ones).unwrap());
        assert_eq!(map(&diagonal(&f, 0, 1).unwrap()), diagonal(&map(&f), 0, 1).unwrap());
        assert_eq!(
            map(&stretch(&f, &t, &vec![one(); f.axes()]).unwrap()),
            stretch(&map(&f), &t, &vec![one(); f.axes()]).unwrap()
        );
        let levels = vec![1; f.axes()];
        assert_eq!(
            &map(subdivide(&f, &levels).unwrap().net()),
            subdivide(&map(&f), &levels).unwrap().net()
        );
        assert_eq!(
            map(&midpoint(&[&f, &f, &f]).unwrap()),
            midpoint(&[&map(&f), &map(&f), &map(&f)]).unwrap()
        );
    }
}

#[test]
fn blossom_is_symmetric_affine_and_the_point_on_its_diagonal() {
    for (f, mut random) in exact_forms(1..=2) {
        let arguments: Vec<Vec<Rational>> = f
            .degrees()
            .iter()
            .map(|&degree| (0..degree).map(|_| random.fraction()).collect())
            .collect();
        let of = |lists: &[Vec<Rational>]| {
            let borrowed: Vec<&[Rational]> = lists.iter().map(Vec::as_slice).collect();
            blossom(&f, &borrowed).unwrap()
        };
        let mut shuffled = arguments.clone();
        for list in &mut shuffled {
            list.reverse();
        }
        assert_eq!(of(&arguments), of(&shuffled));
        let t: Rational = random.fraction();
        let equal: Vec<Vec<Rational>> = f.degrees().iter().map(|&d| vec![t.clone(); d]).collect();
        assert_eq!(of(&equal), f.homogeneous_at(&vec![t.clone(); f.axes()]).unwrap());
        if f.degrees()[0] > 0 {
            let with_first = |x: Rational| {
                let mut lists = arguments.clone();
                lists[0][0] = x;
                of(&lists)
            };
            let [low, high] = [with_first(zero()), with_first(one())];
            let between: Vec<Rational> = low
                .iter()
                .zip(&high)
                .map(|(a, b)| (one() - t.clone()) * a.clone() + t.clone() * b.clone())
                .collect();
            assert_eq!(with_first(t), between);
        }
    }
}

#[test]
fn reparametrisation_keeps_the_points_and_the_ends() {
    for (f, mut random) in exact_forms(1..=2) {
        let axis = random.size(0, f.axes() - 1);
        let c = Rational::ratio(random.integer(1, 9), random.integer(1, 5));
        let changed = reparametrise(&f, axis, &c).unwrap();
        let s = random.parameters::<Rational>(f.axes());
        let mut t = s.clone();
        let moved = c.clone() * s[axis].clone();
        t[axis] = moved.clone() / (one() - s[axis].clone() + moved);
        assert_eq!(changed.at(&s).ok(), f.at(&t).ok());
        let back = reparametrise(&changed, axis, &(one() / c)).unwrap();
        assert_eq!(back, f);
    }
    assert!(reparametrise(&Random::new(1).form(&[3], 2, Weights::One), 0, &zero()).is_err());
}

/// The quarter of the unit circle as `(1 − t², 2t) / (1 + t²)`, exact over the rationals.
fn quarter_circle() -> Exact {
    let poles = [1, 0, 1, 1, 1, 1, 0, 2, 2].map(|x: i64| <Rational as Scalar>::from_integer(x));
    Form::from_homogeneous(&[3], 2, poles.to_vec()).unwrap()
}

#[test]
fn the_whole_line_of_a_quarter_circle_is_the_circle() {
    let pieces = whole_line(&quarter_circle(), 0).unwrap();
    assert_eq!(pieces.len(), 3);
    let ends = |f: &Exact| [f.at(&[zero()]).unwrap(), f.at(&[one()]).unwrap()];
    for (k, piece) in pieces.iter().enumerate() {
        assert_eq!(ends(piece)[1], ends(&pieces[(k + 1) % 3])[0], "closed");
        let mut quadrants = 0;
        for i in 0..=8 {
            let point = piece.at(&[Rational::ratio(i, 8)]).unwrap();
            let square = point[0].clone() * point[0].clone() + point[1].clone() * point[1].clone();
            assert_eq!(square, one());
            quadrants += usize::from(point[0] < zero() || point[1] < zero());
        }
        assert_eq!(quadrants > 0, k != 1, "only the middle piece is the quarter");
    }
}

#[test]
fn derivatives_are_the_derivatives_of_the_points() {
    let mut tried = 0;
    for (f, mut random) in exact_forms(1..=2) {
        let orders: Vec<usize> = (0..f.axes()).map(|_| random.size(0, 2)).collect();
        let form = derivative(&f, &orders).unwrap();
        let at = random.parameters::<Rational>(f.axes());
        if let Ok(expected) = f.derivative_at(&at, &orders) {
            assert_eq!(form.at(&at).unwrap(), expected);
            tried += 1;
        }
    }
    assert!(tried > 20, "{tried} points where the weight does not vanish");
}

#[test]
fn derivative_of_a_product_of_powers() {
    // x = t³/6 has derivatives t²/2, t, 1, 0.
    let cubic: Exact =
        Form::from_points(&[4], 1, &[0, 0, 0, 1].map(|x| Rational::ratio(x, 6)), None).unwrap();
    let t = [Rational::ratio(2, 5)];
    let expected = [(2, 25), (2, 5), (1, 1), (0, 1)].map(|(n, d)| Rational::ratio(n, d));
    for (order, value) in expected.into_iter().enumerate() {
        assert_eq!(cubic.derivative_at(&t, &[order + 1]).unwrap(), std::slice::from_ref(&value));
        assert_eq!(derivative(&cubic, &[order + 1]).unwrap().at(&t).unwrap(), [value]);
    }
}

#[test]
fn transposition_relabels_the_parameters() {
    for (f, mut random) in exact_forms(3..=3) {
        let axes = [2, 0, 1];
        let turned = transpose(&f, &axes).unwrap();
        let at = random.parameters::<Rational>(3);
        let seen: Vec<Rational> = axes.iter().map(|&axis| at[axis].clone()).collect();
        assert_eq!(turned.homogeneous_at(&seen).unwrap(), f.homogeneous_at(&at).unwrap());
        assert!(transpose(&f, &[0, 0, 1]).is_err());
    }
}

#[test]
fn partition_is_dyadic() {
    let list = partition(&Rational::ratio(1, 3), &one(), 3).unwrap();
    assert_eq!(list.len(), 9);
    let step = Rational::ratio(1, 12);
    for pair in list.windows(2) {
        assert_eq!(pair[1].clone() - pair[0].clone(), step);
    }
}

#[test]
fn raising_together_keeps_the_functions() {
    for (f, mut random) in exact_forms(1..=3) {
        let orders = random.orders(f.axes(), 5);
        let g: Exact = random.form(&orders, f.ambient(), Weights::Any);
        let raised = raise_together(&[&f, &g]).unwrap();
        assert_same_function(&raised[0], &f);
        assert_same_function(&raised[1], &g);
    }
}
