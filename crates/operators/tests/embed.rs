//! Embedding against the points it was made from, dense sampling and exact answers.
#![allow(clippy::unwrap_used)]

use pforms_kernel::{Dual, Form, Rational, Scalar};
use pforms_operators::{
    Embedding, Outside, Poles, Shape, Spline, Standing, embed, pole_derivatives, subdivide,
};
use pforms_testkit::{ROUNDS, Random, Weights};

const ACCURACY: f64 = 1e-12;

fn embedded(cage: &Shape, points: &[f64]) -> Embedding {
    embed(cage, points, ACCURACY, Outside::Keep).unwrap()
}

/// A net near the regular one, each coordinate off by at most `amplitude` sides.
fn shaken(random: &mut Random, orders: &[usize], amplitude: f64, rational: bool) -> Form {
    let axes = orders.len();
    let (mut points, mut weights) = (Vec::new(), Vec::new());
    for flat in 0..orders.iter().product::<usize>() {
        let mut rest = flat;
        let mut index = vec![0; axes];
        for (i, order) in index.iter_mut().zip(orders).rev() {
            *i = rest % order;
            rest /= order;
        }
        points.extend(index.iter().map(|i| *i as f64 + amplitude * (2.0 * random.unit() - 1.0)));
        weights.push(if rational { 0.7 + 0.6 * random.unit() } else { 1.0 });
    }
    Form::from_points(orders, axes, &points, Some(&weights)).unwrap()
}

/// Parameters in the window, a list for each axis; its corners and sides are among them.
fn scattered(random: &mut Random, axes: usize, count: usize) -> Vec<Vec<f64>> {
    let mut one = || match random.integer(0, 9) {
        0 => 0.0,
        1 => 1.0,
        _ => random.unit(),
    };
    (0..axes).map(|_| (0..count).map(|_| one()).collect()).collect()
}

fn points_of(cage: &Shape, lists: &[Vec<f64>]) -> Vec<f64> {
    let lists: Vec<&[f64]> = lists.iter().map(Vec::as_slice).collect();
    match cage {
        Shape::Form(form) => form.scattered(&lists).unwrap(),
        Shape::Spline(spline) => spline.scattered(&lists).unwrap(),
    }
}

/// Every point is found where it came from, once.
fn assert_found(cage: &Shape, lists: &[Vec<f64>], bound: f64) {
    let points = points_of(cage, lists);
    let found = embedded(cage, &points);
    let back = found.at(cage).unwrap();
    let size = 1.0 + points.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    for i in 0..found.len() {
        assert_eq!(
            found.standings[i],
            Standing::Inside,
            "{cage:?} {:?}",
            lists.iter().map(|l| l[i]).collect::<Vec<_>>()
        );
        assert!(found.counts[i] == 1 && found.complete[i]);
        for (axis, list) in lists.iter().enumerate() {
            let gap = (found.parameters[axis][i] - list[i]).abs();
            assert!(gap <= bound, "{gap}");
        }
        let axes = lists.len();
        let gap: f64 = (0..axes).map(|k| (back[i * axes + k] - points[i * axes + k]).powi(2)).sum();
        assert!(gap.sqrt() <= found.residuals[i] + 4.0 * f64::EPSILON * size);
        assert!(found.residuals[i] <= 1e-12 * size);
    }
}

#[test]
fn points_are_found_where_they_came_from() {
    let mut random = Random::new(1);
    let shapes: [&[usize]; 10] = [
        &[2],
        &[5],
        &[2, 2],
        &[4, 4],
        &[3, 6],
        &[2, 2, 2],
        &[3, 3, 3],
        &[4, 4, 4],
        &[2, 3, 5],
        &[2, 3, 2, 2],
    ];
    for orders in shapes {
        for rational in [false, true] {
            let cage = shaken(&mut random, orders, 0.1, rational);
            let count = if orders.len() > 3 { 20 } else { 700 };
            let lists = scattered(&mut random, orders.len(), count);
            assert_found(&cage.into(), &lists, 1e-13);
        }
    }
}

/// A strong twist is one-to-one though its slopes are nowhere near one matrix.
#[test]
fn twisted_and_turned_cages_are_certified_piece_by_piece() {
    let mut points = Vec::new();
    for i in 0..2 {
        for j in 0..2 {
            for k in 0..5 {
                let turn = 0.6 * f64::from(k);
                let (x, y) = (f64::from(2 * i - 1), f64::from(2 * j - 1));
                let (sin, cos) = (libm::sin(turn), libm::cos(turn));
                points.extend([x * cos - y * sin, x * sin + y * cos, 2.0 * f64::from(k)]);
            }
        }
    }
    let cage: Form = Form::from_points(&[2, 2, 5], 3, &points, None).unwrap();
    let mut random = Random::new(2);
    let lists = scattered(&mut random, 3, 2000);
    assert_found(&cage.into(), &lists, 1e-12);
}

#[test]
fn splines_hand_points_from_piece_to_piece() {
    let mut random = Random::new(3);
    for rational in [false, true] {
        let net = shaken(&mut random, &[6, 4, 5], 0.1, rational);
        let knots = vec![
            vec![0., 0., 0., 1., 2.5, 4., 5., 5., 5.],
            vec![-1., -1., -0.5, 0.5, 1., 1.],
            vec![0., 0., 0., 0., 2., 3., 3., 3., 3.],
        ];
        let spline = Spline::new(net, &[2, 1, 3], knots).unwrap();
        let mut lists = scattered(&mut random, 3, 600);
        for (axis, list) in lists.iter_mut().enumerate() {
            let (from, to) = spline.window(axis).unwrap();
            for t in list.iter_mut() {
                *t = from + *t * (to - from);
            }
            list[0] = spline.breaks()[axis][1];
        }
        assert_found(&spline.into(), &lists, 1e-12);
    }
    // The same cage cut into pieces gives the same parameters.
    let form = shaken(&mut random, &[4, 4, 4], 0.1, false);
    let lists = scattered(&mut random, 3, 500);
    let points = points_of(&form.clone().into(), &lists);
    let pieces = embedded(&subdivide(&form, &[1, 2, 0]).unwrap().into(), &points);
    for (found, list) in pieces.parameters.iter().zip(&lists) {
        for (t, expected) in found.iter().zip(list) {
            assert!((t - expected).abs() < 1e-13);
        }
    }
}

#[test]
fn points_outside_are_reported_and_stay() {
    let mut random = Random::new(4);
    for orders in [&[4, 4][..], &[4, 4, 4], &[2, 3, 4]] {
        let cage = shaken(&mut random, orders, 0.15, true);
        let axes = orders.len();
        let points: Vec<f64> = (0..3000 * axes)
            .map(|k| random.unit() * (orders[k % axes] as f64 + 1.0) - 1.0)
            .collect();
        let found = embedded(&cage.clone().into(), &points);
        let moved = found.at(&cage.clone().into()).unwrap();
        let samples: Vec<f64> = (0..=24).map(|i| f64::from(i) / 24.0).collect();
        let grid = cage.grid(&vec![&samples[..]; axes]).unwrap();
        let mut outside = 0;
        for (i, point) in points.chunks_exact(axes).enumerate() {
            assert!(found.complete[i]);
            if found.standings[i] == Standing::Inside {
                assert!(found.residuals[i] < 1e-12);
            } else {
                outside += 1;
                assert_eq!(&moved[i * axes..(i + 1) * axes], point);
                // The steepest step between samples is below 0.3; a point outside is on none.
                assert!(grid.chunks_exact(axes).all(|x| x != point));
            }
        }
        assert!(outside > 500 && outside < 2900);
    }
}

/// Just beyond a side, and as near to it as the accuracy.
#[test]
fn sides_are_told_from_what_lies_beyond() {
    let mut random = Random::new(5);
    let cage = shaken(&mut random, &[4, 4, 4], 0.1, false);
    let shape: Shape = cage.clone().into();
    for axis in 0..3 {
        for (side, beyond) in [(0.0, -1.0), (1.0, 1.0)] {
            let at = |gap: f64| {
                let mut t = vec![0.3, 0.6, 0.4];
                t[axis] = side + beyond * gap;
                cage.at(&t).unwrap()
            };
            for gap in [1e-3, 1e-6, 1e-9] {
                assert_eq!(embedded(&shape, &at(gap)).standings, [Standing::Outside]);
                assert_eq!(embedded(&shape, &at(-gap)).standings, [Standing::Inside]);
                let near = embed(&shape, &at(gap), 1e-2, Outside::Keep).unwrap();
                assert_eq!(near.standings, [Standing::Inside]);
                assert!(near.residuals[0] > 0.1 * gap);
            }
            assert_eq!(embedded(&shape, &at(1e-16)).standings, [Standing::Inside]);
        }
    }
}

#[test]
fn a_cage_goes_on_beyond_its_window_on_request() {
    let mut random = Random::new(6);
    let form = shaken(&mut random, &[3, 3, 4], 0.05, true);
    let spline: Shape = subdivide(&form, &[1, 0, 1]).unwrap().into();
    for cage in [Shape::Form(form), spline] {
        let lists: Vec<Vec<f64>> =
            (0..3).map(|_| (0..300).map(|_| 1.6 * random.unit() - 0.3).collect()).collect();
        let points = points_of(&cage, &lists);
        let found = embed(&cage, &points, ACCURACY, Outside::Extend).unwrap();
        let back = found.at(&cage).unwrap();
        let mut stay = 0;
        for (i, residual) in found.residuals.iter().enumerate() {
            let (x, y) = (&back[3 * i..3 * i + 3], &points[3 * i..3 * i + 3]);
            if found.standings[i] == Standing::Outside {
                // Far out the continued cage turns over, and steps do not arrive.
                stay += 1;
                assert_eq!(x, y);
                continue;
            }
            let gap: f64 = x.iter().zip(y).map(|(x, y)| (x - y).powi(2)).sum();
            assert!(gap.sqrt() <= 2.0 * residual && *residual < 1e-8, "{gap} {residual}");
        }
        let extended = found.standings.iter().filter(|s| **s == Standing::Extended).count();
        assert!(extended > 100 && stay < 10, "{extended} {stay}");
        let refused = embed(&cage, &points, ACCURACY, Outside::Refuse);
        assert_eq!(refused.unwrap_err().family(), "Domain");
    }
}

/// `x = 4u(1 − u)` covers each of its points twice; the fold lies at ½.
#[test]
fn folded_cages_give_the_first_place_and_count_the_others() {
    let fold: Form =
        Form::from_points(&[3, 2], 2, &[0., 0., 0., 1., 2., 0., 2., 1., 0., 0., 0., 1.], None)
            .unwrap();
    let found = embedded(&fold.clone().into(), &[0.75, 0.5, 0.36, 0.25, 1.5, 0.5]);
    assert_eq!(found.counts, [2, 2, 0]);
    assert!(found.complete.iter().all(|complete| *complete), "{found:?}");
    assert!((found.parameters[0][0] - 0.25).abs() < 1e-14);
    assert!((found.parameters[0][1] - 0.1).abs() < 1e-14);
    let signs = found.jacobians(&fold.clone().into()).unwrap();
    assert!(signs[0] > 0.0 && signs[1] > 0.0 && signs[2] == 0.0);
    // On the fold itself the place is double: found, and not called alone.
    let edge = embedded(&fold.into(), &[1.0, 0.5]);
    assert_eq!(edge.standings, [Standing::Inside]);
    assert!(!edge.complete[0] && (edge.parameters[0][0] - 0.5).abs() < 1e-6);
}

#[test]
fn collapsed_edges_and_far_or_tiny_cages() {
    // A triangle: the edge v = 1 is a point.
    let cage: Form =
        Form::from_points(&[2, 2], 2, &[0., 0., 0.5, 1., 1., 0., 0.5, 1.], None).unwrap();
    let found = embedded(&cage.into(), &[0.5, 0.5, 0.5, 1.0, 0.9, 0.9]);
    assert_eq!(found.standings[0], Standing::Inside);
    assert!(found.counts[0] == 1 && found.complete[0]);
    assert_eq!(found.standings[1..], [Standing::Inside, Standing::Outside]);
    assert!(!found.complete[1]);
    let mut random = Random::new(7);
    for scale in [1e-150, 1e150] {
        let unit = shaken(&mut random, &[3, 3, 3], 0.1, true);
        let mut poles = unit.homogeneous().to_vec();
        for pole in poles.chunks_exact_mut(4) {
            pole[..3].iter_mut().for_each(|x| *x *= scale);
        }
        let cage: Shape = Form::from_homogeneous(&[3, 3, 3], 3, poles).unwrap().into();
        let lists = scattered(&mut random, 3, 100);
        let found = embedded(&cage, &points_of(&cage, &lists));
        for (found, list) in found.parameters.iter().zip(&lists) {
            assert!(found.iter().zip(list).all(|(t, s)| (t - s).abs() < 1e-13));
        }
    }
    // Far from the origin the residual says what rounding has left.
    let mut poles = shaken(&mut random, &[3, 3], 0.1, false).homogeneous().to_vec();
    poles.chunks_exact_mut(3).for_each(|pole| pole[0] += 1e9);
    let far: Shape = Form::from_homogeneous(&[3, 3], 2, poles).unwrap().into();
    let lists = scattered(&mut random, 2, 100);
    let found = embedded(&far, &points_of(&far, &lists));
    assert!(found.inside().all(|inside| inside));
    for (found, list) in found.parameters.iter().zip(&lists) {
        assert!(found.iter().zip(list).all(|(t, s)| (t - s).abs() < 1e-6));
    }
}

#[test]
fn bad_input_is_named() {
    let family = |cage: Form, points: &[f64]| {
        embed(&cage.into(), points, ACCURACY, Outside::Keep).unwrap_err().family()
    };
    let square: Form =
        Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 1., 0., 1., 1.], None).unwrap();
    assert_eq!(family(square.clone(), &[0.0]), "Shape");
    assert_eq!(family(square.clone(), &[f64::NAN, 0.0]), "Domain");
    assert_eq!(family(square.clone(), &[f64::INFINITY, 0.0]), "Domain");
    assert_eq!(family(square.clone(), &[1e300, 0.0]), "Domain");
    let accuracy = embed(&square.clone().into(), &[], -1.0, Outside::Keep);
    assert_eq!(accuracy.unwrap_err().family(), "Domain");
    assert!(embedded(&square.into(), &[]).is_empty());
    let surface = Form::from_points(&[2, 2], 3, &[0.0; 12], None).unwrap();
    assert_eq!(family(surface, &[0.0; 3]), "Shape");
    let point = Form::from_points(&[2, 2], 2, &[1.0; 8], None).unwrap();
    assert_eq!(family(point, &[1.0; 2]), "Degenerate");
    let flat = Form::from_points(&[2, 1], 2, &[0., 0., 1., 1.], None).unwrap();
    assert_eq!(family(flat, &[0.0; 2]), "Degenerate");
    let infinite = Form::from_points(&[2], 1, &[0., 1.], Some(&[1., -1.])).unwrap();
    assert_eq!(family(infinite, &[0.0]), "Domain");
    let wide = Form::from_points(&[2; 5], 5, &[0.0; 160], None).unwrap();
    assert_eq!(family(wide, &[0.0; 5]), "Degenerate");
}

/// A cage that is flat everywhere has no inside: its points are found, none of them alone.
#[test]
fn a_flat_cage_is_no_endless_work() {
    let flat: Form =
        Form::from_points(&[2, 2], 2, &[0., 0., 1., 1., 1., 1., 2., 2.], None).unwrap();
    let found = embedded(&flat.into(), &[1.0, 1.0, 1.0, 0.0]);
    assert_eq!(found.standings, [Standing::Inside, Standing::Outside]);
    assert!(!found.complete[0] && found.complete[1]);
}

#[test]
fn sensitivities_are_those_of_dual_numbers() {
    let mut random = Random::new(8);
    for round in 0..ROUNDS.min(40) as usize {
        let axes = 1 + round % 3;
        let orders: Vec<usize> = (0..axes).map(|_| random.size(2, 4)).collect();
        let weights = [Weights::One, Weights::Positive, Weights::Any][round % 3];
        let cage: Form<Rational> = random.form(&orders, axes, weights);
        let place: Vec<Rational> = random.parameters(axes);
        let Ok(row) = pole_derivatives(&cage.clone().into(), &place) else {
            assert!(cage.at(&place).is_err());
            continue;
        };
        let at: Vec<Dual<Rational>> = place.iter().cloned().map(Dual::constant).collect();
        for pole in 0..cage.pole_count() {
            let moving = moving(&cage, pole);
            let slopes = moving.at(&at).unwrap();
            let entry = row.iter().find(|(index, _)| *index == pole);
            let expected = entry.map_or_else(Rational::default, |(_, factor)| factor.clone());
            assert_eq!(slopes[0].slope, expected);
            assert!(slopes[1..].iter().all(|x| x.slope.is_zero()));
        }
    }
}

/// The form with the first coordinate of a pole on its way, its weight at rest.
fn moving(form: &Form<Rational>, pole: usize) -> Form<Dual<Rational>> {
    let width = form.width();
    let mut poles: Vec<Dual<Rational>> =
        form.homogeneous().iter().cloned().map(Dual::constant).collect();
    let weight = form.homogeneous()[pole * width + form.ambient()].clone();
    poles[pole * width].slope = if weight.is_zero() { Rational::one() } else { weight };
    Form::from_homogeneous(form.orders(), form.ambient(), poles).unwrap()
}

#[test]
fn sensitivities_carry_points_along() {
    let mut random = Random::new(9);
    let net = shaken(&mut random, &[5, 4, 4], 0.1, true);
    let knots = vec![
        vec![0., 0., 0., 0.3, 0.7, 1., 1., 1.],
        vec![0., 0., 0.5, 0.6, 1., 1.],
        vec![0., 0., 0., 0., 1., 1., 1., 1.],
    ];
    let cage: Shape = Spline::new(net.clone(), &[2, 1, 3], knots).unwrap().into();
    let lists = scattered(&mut random, 3, 200);
    let found = embedded(&cage, &points_of(&cage, &lists));
    let matrix = found.sensitivities(&cage).unwrap();
    assert_eq!((matrix.rows(), matrix.columns()), (200, net.pole_count()));
    assert!((0..200).all(|i| matrix.row(i).count() <= 3 * 2 * 4));
    // Weights kept, the point is linear in the poles: rows times poles is the point.
    let poles = net.points().unwrap();
    for axis in 0..3 {
        let column: Vec<f64> = poles.iter().skip(axis).step_by(3).copied().collect();
        let moved = matrix.apply(&column).unwrap();
        let at = found.at(&cage).unwrap();
        for (i, x) in moved.iter().enumerate() {
            assert!((x - at[3 * i + axis]).abs() < 1e-13);
        }
    }
    assert_eq!(cage.net().pole_count(), matrix.columns());
}
