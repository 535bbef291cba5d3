//! Laws of splines, in exact arithmetic.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Error, Form, Rational, Scalar};
use pforms_operators::{Knots, Poles, Spline, derivative, elevate, stretch, subdivide};
use pforms_testkit::{Random, Weights};

type Q = Rational;

fn q(n: i64, d: i64) -> Q {
    Q::ratio(n, d)
}

/// Knot vectors of every make: uniform, clamped, with repeated knots, with gaps.
fn vectors(degree: usize, random: &mut Random) -> Vec<Vec<Q>> {
    let p = degree as i64;
    let uniform: Vec<Q> = (0..2 * p + 5).map(|i| q(i, 1)).collect();
    let clamp = |inner: &[Q]| {
        let ends = [vec![q(0, 1); degree + 1], vec![q(1, 1); degree + 1]];
        [&ends[0][..], inner, &ends[1][..]].concat()
    };
    let once = clamp(&[q(1, 5), q(1, 3), q(3, 4)]);
    let meeting = clamp(&[vec![q(1, 3); degree.max(1)], vec![q(2, 3)]].concat());
    let parted = clamp(&[vec![q(1, 4); degree + 1], vec![q(1, 2)]].concat());
    let mut loose: Vec<Q> = (0..2 * p + 4).map(|_| random.fraction::<Q>()).collect();
    loose.sort();
    loose.dedup();
    while (loose.len() as i64) < 2 * p + 4 {
        let last = loose[loose.len() - 1].clone();
        loose.push(last + q(1, 2));
    }
    vec![uniform, once, meeting, parted, loose]
}

fn spline(random: &mut Random, degrees: &[usize], which: usize, rational: bool) -> Spline<Q> {
    let knots: Vec<Vec<Q>> =
        degrees.iter().map(|&degree| vectors(degree, random).swap_remove(which)).collect();
    let orders: Vec<usize> =
        knots.iter().zip(degrees).map(|(list, degree)| list.len() - degree - 1).collect();
    let count = orders.iter().product::<usize>();
    let points: Vec<Q> = (0..2 * count).map(|_| random.fraction::<Q>()).collect();
    let weights: Vec<Q> =
        (0..count).map(|i| if rational { q(1 + (i as i64 * 7) % 5, 2) } else { q(1, 1) }).collect();
    let net = Form::from_points(&orders, 2, &points, Some(&weights)).unwrap();
    Spline::new(net, degrees, knots).unwrap()
}

/// Parameters over the window, knots among them, and beyond.
fn places(spline: &Spline<Q>) -> Vec<Vec<Q>> {
    let per_axis: Vec<Vec<Q>> = spline
        .breaks()
        .iter()
        .map(|breaks| {
            let (from, to) = (breaks[0].clone(), breaks[breaks.len() - 1].clone());
            let length = to - from.clone();
            let mut list: Vec<Q> =
                [0, 3, 7, 11].iter().map(|&k| from.clone() + length.clone() * q(k, 11)).collect();
            list.extend(breaks.iter().skip(1).take(1).cloned());
            list
        })
        .collect();
    let mut all = vec![Vec::new()];
    for list in per_axis {
        all = all
            .into_iter()
            .flat_map(|place: Vec<Q>| {
                list.iter().map(move |t| [place.clone(), vec![t.clone()]].concat())
            })
            .collect();
    }
    all
}

fn each(test: impl Fn(&mut Random, &Spline<Q>)) {
    let mut random = Random::new(41);
    for degrees in [vec![0], vec![1], vec![2], vec![3], vec![5], vec![2, 3], vec![1, 2, 1]] {
        for which in 0..5 {
            for rational in [false, true] {
                let one = spline(&mut random, &degrees, which, rational);
                test(&mut random, &one);
            }
        }
    }
}

#[test]
fn pieces_are_the_spline_over_their_windows() {
    each(|_, spline| {
        let breaks = spline.breaks();
        let counts = spline.counts();
        let last: Vec<usize> = counts.iter().map(|n| n - 1).collect();
        for index in [vec![0; counts.len()], last] {
            let piece = spline.piece(&index).unwrap();
            let at: Vec<Q> = index
                .iter()
                .zip(&breaks)
                .map(|(&i, list)| {
                    list[i].clone() + (list[i + 1].clone() - list[i].clone()) * q(2, 5)
                })
                .collect();
            let local = vec![q(2, 5); index.len()];
            assert_eq!(piece.homogeneous_at(&local).unwrap(), spline.homogeneous_at(&at).unwrap());
        }
        assert_eq!(spline.pieces().unwrap().len(), counts.iter().product::<usize>());
        assert_eq!(spline.pieces().unwrap()[0], spline.piece(&vec![0; counts.len()]).unwrap());
    });
}

#[test]
fn more_knots_more_degrees_other_windows_change_no_point() {
    each(|_, spline| {
        let axis = spline.axes() - 1;
        let (from, to) = spline.window(axis).unwrap();
        let inside = |k: i64| from.clone() + (to.clone() - from.clone()) * q(k, 7);
        let cut = spline.insert_knots(axis, &[inside(5), inside(2), inside(3)]).unwrap();
        let raised = spline.elevate(&vec![2; spline.axes()]).unwrap();
        let part = spline.restrict(axis, &inside(1), &inside(6)).unwrap();
        let wider = spline.on_window(axis, &q(-3, 1), &q(4, 1)).unwrap();
        let bezier = spline.bezier().unwrap();
        assert!(bezier.is_bezier());
        for place in places(spline) {
            let here = spline.homogeneous_at(&place).unwrap();
            assert_eq!(cut.homogeneous_at(&place).unwrap(), here);
            assert_eq!(raised.homogeneous_at(&place).unwrap(), here);
            assert_eq!(bezier.homogeneous_at(&place).unwrap(), here);
            if place[axis] > inside(1) && place[axis] < inside(6) {
                assert_eq!(part.homogeneous_at(&place).unwrap(), here);
            }
            let mut moved = place.clone();
            let share = (place[axis].clone() - from.clone()) / (to.clone() - from.clone());
            moved[axis] = q(-3, 1) + share * q(7, 1);
            assert_eq!(wider.homogeneous_at(&moved).unwrap(), here);
        }
    });
}

#[test]
fn elevation_keeps_the_smoothness_and_the_ends() {
    each(|_, spline| {
        let raised = spline.elevate(&vec![1; spline.axes()]).unwrap();
        assert_eq!(raised.breaks(), spline.breaks());
        for (before, after) in spline.knots().iter().zip(raised.knots()) {
            let breaks = before.breaks();
            for t in &breaks[1..breaks.len() - 1] {
                assert_eq!(after.multiplicity(t), before.multiplicity(t) + 1);
            }
        }
    });
}

#[test]
fn what_is_inserted_can_be_removed() {
    each(|_, spline| {
        let axis = spline.axes() - 1;
        if spline.degrees()[axis] == 0 {
            return;
        }
        let (from, to) = spline.window(axis).unwrap();
        let t = from.clone() + (to - from) * q(3, 8);
        let mut cut = spline.insert_knots(axis, &vec![t.clone(); spline.degrees()[axis]]).unwrap();
        for _ in 0..spline.degrees()[axis] {
            let removal = cut.remove_knot(axis, &t).unwrap();
            assert_eq!(removal.defect, q(0, 1));
            cut = removal.spline;
        }
        assert_eq!(cut, *spline);
    });
}

#[test]
fn a_knot_that_is_needed_leaves_a_defect() {
    let net = Form::from_points(&[4], 1, &[q(0, 1), q(0, 1), q(1, 1), q(0, 1)], None).unwrap();
    let knots = [0, 0, 0, 1, 2, 2, 2].map(|k| q(k, 2)).to_vec();
    let spline = Spline::new(net, &[2], vec![knots]).unwrap();
    assert!(spline.remove_knot(0, &q(1, 2)).unwrap().defect > q(0, 1));
}

#[test]
fn pieces_put_together_again_are_the_spline() {
    each(|_, spline| {
        let again = spline.map_pieces(|piece, _| Ok(piece.clone())).unwrap();
        for place in places(spline) {
            assert_eq!(
                again.homogeneous_at(&place).unwrap(),
                spline.homogeneous_at(&place).unwrap()
            );
        }
        if spline.axes() == 1 {
            let chain =
                Spline::end_to_end(&spline.pieces().unwrap(), 0, &spline.breaks()[0]).unwrap();
            for place in places(spline) {
                assert_eq!(chain.at(&place).unwrap(), spline.at(&place).unwrap());
            }
        }
    });
}

#[test]
fn end_to_end_scales_weights_to_meet_and_keeps_gaps() {
    let form = |poles: &[i64]| {
        let poles = poles.iter().map(|&x| q(x, 1)).collect();
        Form::from_homogeneous(&[2], 1, poles).unwrap()
    };
    let breaks = [q(0, 1), q(1, 1), q(2, 1)];
    let meeting =
        Spline::end_to_end(&[form(&[0, 1, 2, 1]), form(&[4, 2, 6, 2])], 0, &breaks).unwrap();
    assert_eq!(meeting.net().orders(), [3]);
    assert_eq!(meeting.net().homogeneous(), [0, 1, 2, 1, 3, 1].map(|x| q(x, 1)));
    let parted =
        Spline::end_to_end(&[form(&[0, 1, 2, 1]), form(&[3, 1, 6, 1])], 0, &breaks).unwrap();
    assert_eq!(parted.net().orders(), [4]);
    assert_eq!(parted.at(&[q(1, 1)]).unwrap(), [q(3, 1)], "the piece that begins there counts");
}

#[test]
fn derivatives_are_those_of_the_pieces() {
    each(|_, spline| {
        let mut orders = vec![0; spline.axes()];
        orders[spline.axes() - 1] = 1;
        let slope = spline.derivative(&orders).unwrap();
        let axis = spline.axes() - 1;
        let breaks = spline.breaks();
        let at: Vec<Q> = breaks
            .iter()
            .map(|list| list[0].clone() + (list[1].clone() - list[0].clone()) * q(1, 3))
            .collect();
        let piece = derivative(&spline.piece(&vec![0; spline.axes()]).unwrap(), &orders).unwrap();
        let length = breaks[axis][1].clone() - breaks[axis][0].clone();
        let there = piece.at(&vec![q(1, 3); spline.axes()]).unwrap();
        let scaled: Vec<Q> = there.iter().map(|x| x.clone() / length.clone()).collect();
        assert_eq!(slope.at(&at).unwrap(), scaled);
    });
}

#[test]
fn sub_splines_reversal_and_transposition_commute_with_points() {
    each(|_, spline| {
        for place in places(spline) {
            let here = spline.homogeneous_at(&place).unwrap();
            let sub = spline.sub(0, &place[0]).unwrap();
            assert_eq!(sub.homogeneous_at(&place[1..]).unwrap(), here);
            let order: Vec<usize> = (0..spline.axes()).rev().collect();
            let turned: Vec<Q> = place.iter().rev().cloned().collect();
            let transposed = spline.transpose(&order).unwrap();
            assert_eq!(transposed.homogeneous_at(&turned).unwrap(), here);
        }
        let back = spline.reverse(0).unwrap();
        assert_eq!(back.reverse(0).unwrap(), *spline);
        let (from, to) = spline.window(0).unwrap();
        let mut place: Vec<Q> = spline.breaks().iter().map(|list| list[0].clone()).collect();
        let inside = from.clone() + (to.clone() - from.clone()) * q(3, 11);
        place[0] = inside.clone();
        let here = spline.homogeneous_at(&place).unwrap();
        place[0] = from + (to - inside);
        assert_eq!(back.homogeneous_at(&place).unwrap(), here);
    });
}

#[test]
fn splines_on_common_knots_are_the_same_splines() {
    let mut random = Random::new(7);
    let curves: Vec<Spline<Q>> = [(2, 1), (3, 2), (1, 3)]
        .map(|(degree, which)| spline(&mut random, &[degree], which, false))
        .to_vec();
    let common = Spline::on_common_knots(&curves).unwrap();
    for (before, after) in curves.iter().zip(&common) {
        assert_eq!(after.knots(), common[0].knots());
        for place in places(before) {
            assert_eq!(after.at(&place).unwrap(), before.at(&place).unwrap());
        }
    }
    let shifted = curves[0].on_window(0, &q(0, 1), &q(2, 1)).unwrap();
    assert!(matches!(Spline::on_common_knots(&[curves[1].clone(), shifted]), Err(Error::Shape(_))));
}

#[test]
fn a_form_is_a_spline_of_one_piece() {
    let mut random = Random::new(3);
    let form: Form<Q> = random.form(&[3, 4], 3, Weights::Positive);
    let spline = Spline::from(form.clone());
    assert_eq!(spline.piece(&[0, 0]).unwrap(), form);
    assert_eq!(spline.elevate(&[1, 2]).unwrap().net(), &elevate(&form, &[1, 2]).unwrap());
    let part = spline.restrict(0, &q(1, 4), &q(3, 2)).unwrap();
    let stretched = stretch(&form, &[q(1, 4), q(0, 1)], &[q(3, 2), q(1, 1)]).unwrap();
    assert_eq!(part.net(), &stretched);
    assert_eq!(subdivide(&form, &[2, 1]).unwrap().pieces().unwrap().len(), 8);
    let doubled = form.map_scalar(|x| x.clone() * q(2, 1)).unwrap();
    assert_eq!(spline.with_net(doubled.clone()).unwrap().net(), &doubled);
    assert!(spline.with_net(elevate(&form, &[1, 0]).unwrap()).is_err());
}

#[test]
fn bulk_points_are_those_of_single_ones() {
    let mut random = Random::new(9);
    for which in 0..5 {
        let exact = spline(&mut random, &[2, 3], which, true);
        let floating = exact.map_scalar(Scalar::to_f64).unwrap();
        let lists: Vec<Vec<f64>> = floating
            .breaks()
            .iter()
            .map(|list| {
                let (from, to) = (list[0], list[list.len() - 1]);
                (0..9).map(|i| from + (to - from) * f64::from((i * 5) % 9) / 8.0).collect()
            })
            .collect();
        let grid = floating.grid(&[&lists[0], &lists[1]]).unwrap();
        let size = grid.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        for (i, u) in lists[0].iter().enumerate() {
            for (j, v) in lists[1].iter().enumerate() {
                let at = floating.at(&[*u, *v]).unwrap();
                let there = &grid[2 * (9 * i + j)..][..2];
                // Both take some 40 roundings from the poles, whose convex combinations they are.
                assert!(at.iter().zip(there).all(|(a, b)| (a - b).abs() <= 1e-13 * size));
            }
        }
        let scattered = floating.scattered(&[&lists[0], &lists[1]]).unwrap();
        for (i, point) in scattered.chunks_exact(2).enumerate() {
            let at = floating.at(&[lists[0][i], lists[1][i]]).unwrap();
            assert!(at.iter().zip(point).all(|(a, b)| (a - b).abs() <= 1e-13 * size));
        }
    }
}

#[test]
fn bad_knots_are_named() {
    let refused = |degree: usize, knots: &[f64], words: &str| {
        let error = Knots::new(degree, knots.to_vec()).unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    };
    refused(2, &[0., 0., 0., 1., 1.], "at least 6 for degree 2");
    refused(1, &[0., 0., 2., 1., 3., 3.], "knots 2 and 3");
    refused(1, &[0., 0., 0., 1., 1.], "repeated more than 2 times");
    refused(1, &[0., f64::NAN, 1., 1.], "as knot 1");
    refused(0, &[1., 1.], "repeated more than 1 times");
    refused(1, &[0., 1., 1., 2.], "knot 1 less than knot 2");
    refused(1, &[-1.5e308, -1.5e308, 1.5e308, 1.5e308], "differences are finite");
    let net: Form = Form::from_points(&[3], 1, &[0., 1., 2.], None).unwrap();
    let error = Spline::new(net, &[2], vec![vec![0., 0., 1., 1.]]).unwrap_err();
    assert!(matches!(error, Error::Shape(_)));
}

/// What knots do to poles is local: work and memory grow with the poles, not with their square,
/// which for so many would be 10 GB.
#[test]
fn a_spline_of_many_poles_is_taken_apart() {
    let count = 20_000_u32;
    let points: Vec<f64> = (0..2 * count).map(|i| f64::from(i % 1009)).collect();
    let net = Form::from_points(&[count as usize], 2, &points, None).unwrap();
    let knots = (0..count + 4).map(f64::from).collect();
    let spline = Spline::new(net, &[3], vec![knots]).unwrap();
    let bezier = spline.bezier().unwrap();
    assert_eq!(bezier.net().orders(), [3 * (count as usize - 3) + 1]);
    let finer = spline.insert_knots(0, &[77.5]).unwrap();
    for t in [3.0, 4.25, 77.5, 12_345.625] {
        let point = spline.at(&[t]).unwrap();
        for other in [&bezier, &finer, &spline.elevate(&[1]).unwrap()] {
            let there = other.at(&[t]).unwrap();
            // Convex combinations of poles below 1009, some ten roundings.
            assert!(there.iter().zip(&point).all(|(a, b)| (a - b).abs() < 1e-11));
        }
    }
    let removal = finer.remove_knot(0, &77.5).unwrap();
    assert!(removal.defect < 1e-11 && removal.spline.knots() == spline.knots());
}

/// Two knots that differ by less than a rounding of the window's end cannot be told apart there.
#[test]
fn knots_that_would_fall_together_are_an_error() {
    let net: Form = Form::from_points(&[3], 1, &[0., 1., 2.], None).unwrap();
    let spline = Spline::new(net, &[1], vec![vec![0., 0., 1e-300, 1., 1.]]).unwrap();
    assert_eq!(spline.at(&[1e-300]).unwrap(), [1.0]);
    assert!(matches!(spline.reverse(0), Err(Error::Domain(_))));
    assert!(matches!(spline.on_window(0, &1.0, &2.0), Err(Error::Domain(_))));
}

#[test]
fn a_spline_of_one_piece_is_elevated_as_its_form() {
    let mut random = Random::new(12);
    let form: Form<Q> = random.form(&[3, 2], 2, Weights::Positive);
    let spline = Spline::from(form.clone()).on_window(0, &q(-1, 1), &q(5, 3)).unwrap();
    let raised = spline.elevate(&[2, 3]).unwrap();
    assert_eq!(*raised.net(), elevate(&form, &[2, 3]).unwrap());
    assert_eq!((raised.degrees(), raised.breaks()), (vec![4, 4], spline.breaks()));
}
