//! B-splines, chains and interpolating splines: exact laws, and the results of the original system.
#![allow(clippy::unwrap_used)]

mod common;

use common::family;
use pforms_kernel::{Form, Rational, Scalar};
use pforms_operators::{
    KnotRule, Spline, SplineEnds, bspline, cubic_chain, interpolating_spline, nurbs,
    quadratic_chain, remove_knots,
};
use pforms_testkit::{Random, Weights, cases, net, numbers, relative_error};

/// Sums of a few products.
const ROUNDING: f64 = 1e-14;

fn uniform<S: Scalar>(poles: &Form<S>, degree: usize, closed: bool) -> Spline<S> {
    let axes = poles.axes();
    bspline(poles, &vec![degree; axes], &vec![KnotRule::Uniform; axes], &vec![closed; axes])
        .unwrap()
}

fn same_pieces(spline: &Spline, expected: &serde_json::Value) {
    let pieces = spline.pieces().unwrap();
    let wanted = expected.as_array().unwrap();
    assert_eq!(pieces.len(), wanted.len());
    for (piece, wanted) in pieces.iter().zip(wanted) {
        let wanted: Form = net(wanted);
        let error = relative_error(piece, &wanted.exact().unwrap());
        assert!(error.is_some_and(|error| error < ROUNDING), "{error:?}");
    }
}

#[test]
fn windows_of_the_book() {
    for case in cases("spline_windows") {
        let degree = case.params["degree"].as_u64().unwrap() as usize;
        same_pieces(&uniform(&net(&case.input), degree, false), &case.expected);
    }
}

#[test]
fn chains_of_the_book() {
    for case in cases("spline_interpolating") {
        let points: Form = net(&case.input);
        let start: Vec<Vec<f64>> =
            case.params["start"].as_array().unwrap().iter().map(numbers).collect();
        let factor = if case.params["circle"] == true { 0.5_f64.sqrt() } else { 1.0 };
        let chain = match case.params["degree"].as_u64().unwrap() {
            2 => quadratic_chain(&points, &start[0], &factor),
            _ => cubic_chain(&points, [&start[0], &start[1]]),
        };
        same_pieces(&chain.unwrap(), &case.expected);
    }
}

#[test]
fn windows_of_any_degree_are_smooth_exactly() {
    let mut random = Random::new(41);
    for degree in 0..=5 {
        let poles = random.form::<Rational>(&[degree + 4], 2, Weights::Positive);
        let pieces = uniform(&poles, degree, false).pieces().unwrap();
        for pair in pieces.windows(2) {
            for order in 0..degree {
                let [end, start] = [(&pair[0], 1), (&pair[1], 0)].map(|(piece, t)| {
                    let jets = piece.jets(&[Rational::ratio(t, 1)], &[order]).unwrap();
                    jets.iter().map(pforms_kernel::Jet::top_derivative).collect::<Vec<_>>()
                });
                assert_eq!(end, start, "degree {degree}, order {order}");
            }
        }
    }
}

#[test]
fn a_closed_spline_has_no_first_pole() {
    let mut random = Random::new(43);
    for degree in 0..=4 {
        let poles = random.form::<Rational>(&[5], 2, Weights::Positive);
        let mut turned = poles.homogeneous().to_vec();
        turned.rotate_left(3);
        let turned = Form::from_homogeneous(&[5], 2, turned).unwrap();
        let (a, b) = (uniform(&poles, degree, true), uniform(&turned, degree, true));
        assert_eq!(a.counts(), [5]);
        let (mut there, here) = (a.pieces().unwrap(), b.pieces().unwrap());
        there.rotate_left(1);
        assert_eq!(there, here);
    }
    // Fewer poles than the degree: the window goes round more than once.
    let two = random.form::<Rational>(&[2], 2, Weights::One);
    assert_eq!(uniform(&two, 3, true).counts(), [2]);
}

#[test]
fn surfaces_and_volumes_are_products() {
    let mut random = Random::new(47);
    let poles = random.form::<Rational>(&[4, 5, 3], 2, Weights::Any);
    let rules = [
        KnotRule::Uniform,
        KnotRule::Clamped,
        KnotRule::Given(vec![0, 0, 1, 3, 3].into_iter().map(|k| Rational::ratio(k, 1)).collect()),
    ];
    let volume = bspline(&poles, &[2, 3, 1], &rules, &[false; 3]).unwrap();
    assert_eq!(volume.counts(), [2, 2, 2]);
    let at = [Rational::ratio(4, 3), Rational::ratio(1, 2), Rational::ratio(2, 1)];
    let inner = volume.sub(2, &at[2]).unwrap().sub(1, &at[1]).unwrap();
    assert_eq!(inner.homogeneous_at(&at[..1]).unwrap(), volume.homogeneous_at(&at).unwrap());
    // The corner of the clamped axes is a pole.
    let edge = volume.sub(0, &Rational::ratio(1, 1)).unwrap();
    let zero = Rational::ratio(0, 1);
    assert_eq!(
        edge.homogeneous_at(&[zero.clone(), zero]).unwrap(),
        edge.net().pole(&[0, 0]).unwrap()
    );
    let closed = bspline(
        &poles,
        &[2, 3, 1],
        &[KnotRule::Uniform, KnotRule::Uniform, KnotRule::Uniform],
        &[true, false, true],
    )
    .unwrap();
    assert_eq!(closed.counts(), [4, 2, 3]);
}

#[test]
fn what_is_inserted_is_removed_exactly() {
    let mut random = Random::new(53);
    for degree in 1..=4 {
        let poles = random.form::<Rational>(&[degree + 3, 2], 3, Weights::Positive);
        let rules = [KnotRule::Uniform, KnotRule::Clamped];
        let spline = bspline(&poles, &[degree, 1], &rules, &[false; 2]).unwrap();
        let more: Vec<Rational> =
            [(1, 1), (1, 2), (1, 2), (7, 3)].iter().map(|(a, b)| Rational::ratio(*a, *b)).collect();
        let more = &more[..degree.min(4)];
        let cut = spline.insert_knots(0, more).unwrap();
        let zero = Rational::ratio(0, 1);
        let back = remove_knots(&cut, 0, Some(more), &zero).unwrap();
        assert_eq!((back.spline, back.error), (spline.clone(), zero.clone()));
        // Pieces, and the spline from its pieces.
        let clamped = spline.restrict(0, &zero, &Rational::ratio(3, 1)).unwrap();
        let bezier = clamped.bezier().unwrap();
        let back = remove_knots(&bezier, 0, None, &zero).unwrap();
        assert_eq!(back.spline, clamped);
    }
}

#[test]
fn a_needed_knot_stays() {
    let mut random = Random::new(59);
    let spline = uniform(&random.form::<f64>(&[6], 2, Weights::One), 3, false);
    assert_eq!(remove_knots(&spline, 0, None, &1e-9).unwrap().spline, spline);
    assert_eq!(family(remove_knots(&spline, 0, Some(&[1.0]), &1e-9)), "Accuracy");
    assert_eq!(family(remove_knots(&spline, 0, Some(&[0.5]), &1e-9)), "Domain");
    assert_eq!(family(remove_knots(&spline, 1, None, &1e-9)), "Shape");
    assert_eq!(family(remove_knots(&spline, 0, None, &-1.0)), "Domain");
    let loose = remove_knots(&spline, 0, Some(&[1.0]), &10.0).unwrap();
    assert!(loose.error > 0.01);
}

#[test]
fn interpolating_splines_pass_and_are_smooth_exactly() {
    let mut random = Random::new(61);
    for count in 2..=7 {
        let points = random.form::<Rational>(&[count], 2, Weights::Positive);
        let list: Vec<Rational> =
            (0..count as i64).map(|i| Rational::ratio(i * i + i, 3)).collect();
        let mut closed = points.homogeneous().to_vec();
        closed.truncate(3 * (count - 1));
        closed.extend_from_within(0..3);
        let closed = Form::from_homogeneous(&[count], 2, closed).unwrap();
        let vector =
            |k: i64| vec![Rational::ratio(k, 2), Rational::ratio(-1, k), Rational::ratio(0, 1)];
        for ends in [
            SplineEnds::Natural,
            SplineEnds::NotAKnot,
            SplineEnds::Clamped(vector(1), vector(3)),
            SplineEnds::Periodic,
        ] {
            let points = if ends == SplineEnds::Periodic { &closed } else { &points };
            let spline = interpolating_spline(
                points,
                std::slice::from_ref(&list),
                std::slice::from_ref(&ends),
            )
            .unwrap();
            for (t, pole) in list.iter().zip(points.homogeneous().chunks_exact(3)) {
                assert_eq!(spline.homogeneous_at(std::slice::from_ref(t)).unwrap(), pole);
            }
            let slope = |t: &Rational, order| {
                let homogeneous = flat(&spline);
                homogeneous.derivative(&[order]).unwrap().at(std::slice::from_ref(t)).unwrap()
            };
            let (first, last) = (&list[0], &list[count - 1]);
            match ends {
                SplineEnds::Natural => {
                    assert!(slope(first, 2).iter().chain(&slope(last, 2)).all(Scalar::is_zero));
                }
                SplineEnds::Clamped(start, end) => {
                    assert_eq!((slope(first, 1), slope(last, 1)), (start, end));
                }
                SplineEnds::NotAKnot if count > 3 => {
                    let pieces = flat(&spline).derivative(&[3]).unwrap().pieces().unwrap();
                    assert_eq!(pieces[0].points().unwrap(), pieces[1].points().unwrap());
                }
                SplineEnds::NotAKnot => {}
                SplineEnds::Periodic => {
                    for order in 1..=2 {
                        assert_eq!(slope(first, order), slope(last, order));
                    }
                }
            }
        }
    }
}

/// The spline of the homogeneous coordinates, as points of a space of one dimension more.
fn flat(spline: &Spline<Rational>) -> Spline<Rational> {
    let net = Form::from_points(
        spline.net().orders(),
        spline.ambient() + 1,
        spline.net().homogeneous(),
        None,
    );
    Spline::on(net.unwrap(), spline.knots().to_vec()).unwrap()
}

#[test]
fn surfaces_are_interpolated_axis_by_axis() {
    let mut random = Random::new(67);
    let points = random.form::<Rational>(&[4, 5], 3, Weights::One);
    let list = |n: i64| (0..n).map(|i| Rational::ratio(i, n - 1)).collect::<Vec<_>>();
    let (u, v) = (list(4), list(5));
    let ends = [SplineEnds::Natural, SplineEnds::NotAKnot];
    let surface = interpolating_spline(&points, &[u.clone(), v.clone()], &ends).unwrap();
    for (i, s) in u.iter().enumerate() {
        for (j, t) in v.iter().enumerate() {
            let point = surface.homogeneous_at(&[s.clone(), t.clone()]).unwrap();
            assert_eq!(point, points.pole(&[i, j]).unwrap());
        }
    }
    assert!(!surface.net().is_rational());
}

#[test]
fn the_cubic_chain_is_unstable_and_the_spline_is_not() {
    let count = 20;
    let values: Vec<f64> = (0..count).map(|i| (0.4 * f64::from(i)).sin()).collect();
    let points = Form::from_points(&[count as usize], 1, &values, None).unwrap();
    let start = |p: f64| [vec![p, 1.0], vec![0.0, 1.0]];
    let run = |p: f64| {
        let [p, q] = start(p);
        cubic_chain(&points, [&p, &q]).unwrap()
    };
    let (here, there) = (run(0.0), run(1e-6));
    let growth = |i: usize| {
        let [a, b] = [&here, &there].map(|chain| chain.piece(&[i]).unwrap().homogeneous()[4]);
        (a - b).abs()
    };
    let rate = growth(12) / growth(11);
    assert!((rate - (2.0 + 3.0_f64.sqrt())).abs() < 1e-6, "{rate}");
    // The same change of the tangent at the start dies out by the same rate.
    let list: Vec<f64> = (0..count).map(f64::from).collect();
    let spline = |slope: f64| {
        let ends = SplineEnds::Clamped(vec![slope, 0.0], vec![0.0, 0.0]);
        interpolating_spline(&points, std::slice::from_ref(&list), &[ends]).unwrap()
    };
    let (here, there) = (spline(0.0), spline(1.0));
    let gap = |i: usize| {
        let [a, b] = [&here, &there].map(|s| s.piece(&[i]).unwrap().homogeneous()[2]);
        (a - b).abs()
    };
    assert!((gap(5) / gap(4) * (2.0 + 3.0_f64.sqrt()) - 1.0).abs() < 1e-6);
}

#[test]
fn knots_that_will_not_do() {
    let poles = Form::from_points(&[4], 1, &[0.0, 1.0, 2.0, 3.0], None).unwrap();
    let open = |degree, rule| family(bspline(&poles, &[degree], &[rule], &[false]));
    assert_eq!(open(4, KnotRule::Uniform), "Shape");
    assert_eq!(open(2, KnotRule::Given(vec![0.0, 1.0, 2.0])), "Shape");
    assert_eq!(open(2, KnotRule::Given(vec![0.0, 1.0, 2.0, 1.5, 3.0, 4.0, 5.0])), "Domain");
    assert_eq!(open(2, KnotRule::Given(vec![0.0, 1.0, 1.0, 1.0, 1.0, 4.0, 5.0])), "Domain");
    assert_eq!(open(2, KnotRule::Given(vec![0.0, f64::NAN, 1.0, 1.0, 2.0, 4.0, 5.0])), "Domain");
    let closed = |rule| family(bspline(&poles, &[2], &[rule], &[true]));
    assert_eq!(closed(KnotRule::Clamped), "Shape");
    assert_eq!(closed(KnotRule::Given(vec![0.0, 1.0, 2.0])), "Shape");
    assert_eq!(closed(KnotRule::Given(vec![0.0; 5])), "Domain");
    assert_eq!(family(bspline(&poles, &[2, 2], &[KnotRule::Uniform], &[true])), "Shape");
    assert_eq!(family(bspline(&poles, &[usize::MAX], &[KnotRule::Uniform], &[true])), "Limit");
    assert_eq!(family(nurbs(poles.clone(), vec![vec![0.0; 4]])), "Shape");
    assert_eq!(family(nurbs(poles.clone(), vec![vec![0.0; 12]])), "Shape");
    assert_eq!(
        family(nurbs(poles.clone(), vec![vec![0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0]])),
        "Domain"
    );
    let through = |points: &Form, list: Vec<f64>, ends| {
        family(interpolating_spline(points, &[list], &[ends]))
    };
    assert_eq!(through(&poles, vec![0.0, 1.0, 1.0, 2.0], SplineEnds::Natural), "Domain");
    assert_eq!(through(&poles, vec![0.0, 1.0, 2.0], SplineEnds::Natural), "Shape");
    assert_eq!(through(&poles, vec![0.0, 1.0, f64::NAN, 2.0], SplineEnds::Natural), "Domain");
    assert_eq!(through(&poles, vec![0.0, 1.0, 2.0, 3.0], SplineEnds::Periodic), "Domain");
    let clamped = SplineEnds::Clamped(vec![1.0], vec![1.0, 0.0]);
    assert_eq!(through(&poles, vec![0.0, 1.0, 2.0, 3.0], clamped), "Shape");
    let one = Form::from_points(&[1], 1, &[0.0], None).unwrap();
    assert_eq!(through(&one, vec![0.0], SplineEnds::Natural), "Shape");
    assert_eq!(family(quadratic_chain(&one, &[0.0, 1.0], &1.0)), "Shape");
    assert_eq!(family(quadratic_chain(&poles, &[0.0], &1.0)), "Shape");
    assert_eq!(family(quadratic_chain(&poles, &[f64::NAN, 1.0], &1.0)), "Domain");
    assert_eq!(family(cubic_chain(&poles, [&[1.0, 1.0], &[f64::INFINITY, 1.0]])), "Domain");
}

#[test]
fn knots_taken_out_together_are_those_taken_out_one_by_one() {
    let mut random = Random::new(61);
    for degree in 1..=4 {
        let poles = random.form::<Rational>(&[degree + 9, 3], 2, Weights::Positive);
        let rules = [KnotRule::Uniform, KnotRule::Clamped];
        let spline = bspline(&poles, &[degree, 1], &rules, &[false; 2]).unwrap();
        let third = |k: i64| Rational::ratio(k, 3);
        let more: Vec<Rational> = (1..24).filter(|k| k % 3 > 0).map(third).collect();
        let cut = spline.insert_knots(0, &more).unwrap();
        let together = remove_knots(&cut, 0, Some(&more), &third(0)).unwrap();
        let mut single = cut.clone();
        for knot in &more {
            single = single.remove_knot(0, knot).unwrap().spline;
        }
        assert_eq!((&together.spline, &single), (&spline, &spline));
        // Knots that are needed: the same poles, and the same error.
        let all = [third(3), third(6), third(9)];
        let (mut single, mut error) = (spline.clone(), third(0));
        for knot in &all {
            let removal = single.remove_knot(0, knot).unwrap();
            (single, error) = (removal.spline, error + removal.defect);
        }
        let together = remove_knots(&spline, 0, Some(&all), &third(3_000_000)).unwrap();
        assert_eq!((together.spline, together.error), (single, error));
    }
}

#[test]
fn floating_knots_are_removed_to_the_same_bits() {
    let mut random = Random::new(67);
    for weights in [Weights::One, Weights::Positive] {
        let spline = uniform(&random.form::<f64>(&[40], 3, weights), 3, false);
        let pieces = spline.bezier().unwrap();
        let found = remove_knots(&pieces, 0, None, &1e-12).unwrap();
        let largest = pieces.net().homogeneous().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let (mut single, mut error) = (pieces.clone(), 0.0);
        let breaks = pieces.breaks().swap_remove(0);
        for knot in &breaks[1..breaks.len() - 1] {
            while single.knots()[0].multiplicity(knot) > 0 {
                let removal = single.remove_knot(0, knot).unwrap();
                if error + removal.defect > 1e-12 * largest {
                    break;
                }
                (single, error) = (removal.spline, error + removal.defect);
            }
        }
        assert!(single.net().orders()[0] < pieces.net().orders()[0] - 20);
        assert_eq!((found.spline, found.error), (single, error));
    }
}
