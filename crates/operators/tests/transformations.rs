//! The laws of affine and projective maps, in exact arithmetic with `==`.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Form, Matrix, Rational, Scalar};
use pforms_operators::{
    Immersed, Poles, Rotation, Spline, Turn, immerse, mirror, project_to_plane, projection,
    reflection, rotate, rotation_matrix, scale, scaling, shear, shearing, transform, translate,
    translation,
};
use pforms_testkit::{Random, Weights, exact_forms};

type Exact = Form<Rational>;

fn vector(random: &mut Random, length: usize) -> Vec<Rational> {
    (0..length).map(|_| random.fraction()).collect()
}

/// A vector that is not 0.
fn direction(random: &mut Random, length: usize) -> Vec<Rational> {
    let mut vector = vector(random, length);
    vector[0] += Rational::ratio(4, 1);
    vector
}

fn matrix(random: &mut Random, rows: usize, columns: usize) -> Matrix<Rational> {
    Matrix::from_rows((0..rows).map(|_| vector(random, columns)).collect()).unwrap()
}

fn dot(a: &[Rational], b: &[Rational]) -> Rational {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn half(random: &mut Random) -> Turn<Rational> {
    Turn::half_tangent(&random.fraction()).unwrap()
}

/// A random rotation that fits the dimension.
fn rotation(random: &mut Random, ambient: usize) -> Rotation<Rational> {
    let turn = half(random);
    match (ambient, random.size(0, 2)) {
        (3, 0) => {
            let axes = [[1, 2, 2], [0, 0, -3], [2, 3, 6], [4, -4, 7]];
            let lengths = [3, 3, 7, 9];
            let pick = random.size(0, 3);
            let axis = axes[pick].map(|x| Rational::ratio(x, lengths[pick]));
            Rotation::Axis(axis, turn)
        }
        (3, 1) => Rotation::Book([turn, half(random), half(random)]),
        _ => {
            let from = random.size(0, ambient - 1);
            let to = (from + random.size(1, ambient - 1)) % ambient;
            Rotation::Plane(from, to, turn)
        }
    }
}

#[test]
fn the_image_of_a_form_is_the_form_of_the_images() {
    for (form, mut random) in exact_forms(0..=3) {
        let rows = form.width() + random.size(0, 2);
        let map = matrix(&mut random, rows, form.width());
        let image = transform(&form, &map).unwrap();
        let at = random.parameters(form.axes());
        let point = form.homogeneous_at(&at).unwrap();
        assert_eq!(image.homogeneous_at(&at).unwrap(), map.act(&point, 1).unwrap());
    }
}

#[test]
fn maps_compose_as_matrices_do() {
    for (form, mut random) in exact_forms(0..=2) {
        let first = matrix(&mut random, form.width() + 1, form.width());
        let second = matrix(&mut random, form.width(), form.width() + 1);
        let steps = transform(&transform(&form, &first).unwrap(), &second).unwrap();
        assert_eq!(transform(&form, &second.times(&first).unwrap()).unwrap(), steps);
    }
}

#[test]
fn an_immersed_form_moves_with_its_host() {
    let mut random = Random::new(11);
    let host: Exact = random.form(&[3, 2], 3, Weights::Positive);
    let inner: Exact = random.inner_form(&[3], 2, Weights::Positive);
    let map = matrix(&mut random, 4, 4);
    let lazy = Immersed::new(inner.clone(), host.clone()).unwrap();
    let moved = transform(&lazy, &map).unwrap();
    assert_eq!(moved.inner(), &inner);
    assert_eq!(moved.net(), &transform(&host, &map).unwrap());
    let expanded = transform(&immerse(&inner, &host).unwrap(), &map).unwrap();
    assert_eq!(moved.expand().unwrap(), expanded);
}

#[test]
fn a_spline_moves_by_its_poles() {
    let mut random = Random::new(12);
    let net: Exact = random.form(&[5, 3], 3, Weights::Positive);
    let knots = [vec![0, 0, 1, 2, 2, 3, 5, 6], vec![0, 0, 0, 1, 1, 1]];
    let knots = knots.map(|list| list.into_iter().map(|k| Rational::ratio(k, 1)).collect());
    let spline = Spline::new(net, &[2, 2], knots.to_vec()).unwrap();
    let map = matrix(&mut random, 4, 4);
    let moved = transform(&spline, &map).unwrap();
    assert_eq!(moved.knots(), spline.knots());
    for (new, old) in moved.pieces().unwrap().iter().zip(&spline.pieces().unwrap()) {
        assert_eq!(new, &transform(old, &map).unwrap());
    }
}

#[test]
fn points_move_and_directions_stay_under_translation() {
    for (form, mut random) in exact_forms(0..=3) {
        let by = vector(&mut random, form.ambient());
        let moved = translate(&form, &by).unwrap();
        assert_eq!(moved.weights(), form.weights());
        let width = form.width();
        let pairs = moved.homogeneous().chunks(width).zip(form.homogeneous().chunks(width));
        for (new, old) in pairs {
            for k in 0..by.len() {
                assert_eq!(new[k], &old[k] + &old[by.len()] * &by[k]);
            }
        }
        let back: Vec<Rational> = by.iter().map(|x| -x.clone()).collect();
        assert_eq!(translate(&moved, &back).unwrap(), form);
    }
}

#[test]
fn scaling_multiplies_what_lies_between_centre_and_point() {
    for (form, mut random) in exact_forms(0..=3) {
        let ambient = form.ambient();
        let [factors, centre] = [vector(&mut random, ambient), vector(&mut random, ambient)];
        let scaled = scale(&form, &factors, &centre).unwrap();
        for (new, old) in
            scaled.homogeneous().chunks(ambient + 1).zip(form.homogeneous().chunks(ambient + 1))
        {
            for k in 0..ambient {
                let offset = &centre[k] * &old[ambient];
                assert_eq!(new[k], &offset + &factors[k] * (&old[k] - &offset));
            }
            assert_eq!(new[ambient], old[ambient]);
        }
    }
}

#[test]
fn a_shear_slides_and_slides_back() {
    for (form, mut random) in exact_forms(0..=2) {
        let ambient = form.ambient();
        let coordinate = random.size(0, ambient - 1);
        let [mut by, centre] = [vector(&mut random, ambient), vector(&mut random, ambient)];
        by[coordinate] = Scalar::zero();
        let slid = shear(&form, coordinate, &by, &centre).unwrap();
        for (new, old) in
            slid.homogeneous().chunks(ambient + 1).zip(form.homogeneous().chunks(ambient + 1))
        {
            let height = &old[coordinate] - &centre[coordinate] * &old[ambient];
            for k in 0..ambient {
                assert_eq!(new[k], &old[k] + &height * &by[k]);
            }
        }
        let back: Vec<Rational> = by.iter().map(|x| -x.clone()).collect();
        assert_eq!(shear(&slid, coordinate, &back, &centre).unwrap(), form);
    }
}

#[test]
fn rotations_keep_scalar_products_and_the_centre() {
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let ambient = random.size(2, 5);
        let centre = vector(&mut random, ambient);
        let rotation = rotation(&mut random, ambient);
        let map = rotation_matrix(&rotation, &centre).unwrap();
        for i in 0..ambient {
            for j in 0..ambient {
                let columns = (0..ambient).map(|row| &map.row(row)[i] * &map.row(row)[j]);
                assert_eq!(columns.sum::<Rational>(), Rational::ratio(i64::from(i == j), 1));
            }
        }
        let there: Exact = Form::point(&centre).unwrap();
        assert_eq!(rotate(&there, &rotation, &centre).unwrap(), there);
    }
}

#[test]
fn rotations_turn_the_way_they_say() {
    let quarter = || Turn::<Rational>::quarters(1);
    let axes = [0, 1, 2].map(|k| [0, 1, 2].map(|i| Rational::ratio(i64::from(i == k), 1)));
    let point = |k: usize| Exact::point(&axes[k]).unwrap();
    let origin = vec![<Rational as Scalar>::zero(); 3];
    let turned =
        |k: usize, rotation| rotate(&point(k), &rotation, &origin).unwrap().points().unwrap();
    for k in 0..3 {
        let (next, last) = ((k + 1) % 3, (k + 2) % 3);
        let right_handed = Rotation::Axis(axes[k].clone(), quarter());
        assert_eq!(turned(next, right_handed.clone()), axes[last]);
        assert_eq!(turned(k, right_handed), axes[k]);
        assert_eq!(turned(k, Rotation::Plane(k, next, quarter())), axes[next]);
    }
    // The book: y toward z, x toward z, x toward y.
    let still = || Turn::quarters(0);
    assert_eq!(turned(1, Rotation::Book([quarter(), still(), still()])), axes[2]);
    assert_eq!(turned(0, Rotation::Book([still(), quarter(), still()])), axes[2]);
    assert_eq!(turned(0, Rotation::Book([still(), still(), quarter()])), axes[1]);
    // About x first: y goes to z, which the second angle leaves, then to −x.
    assert_eq!(turned(1, Rotation::Book([quarter(), quarter(), still()])), origin_less(&axes[0]));
}

fn origin_less(axis: &[Rational]) -> Vec<Rational> {
    axis.iter().map(|x| -x.clone()).collect()
}

#[test]
fn a_turn_and_its_inverse_leave_nothing() {
    for (form, mut random) in exact_forms(0..=2) {
        if form.ambient() < 2 {
            continue;
        }
        let centre = vector(&mut random, form.ambient());
        let turn = half(&mut random);
        let there = rotate(&form, &Rotation::Plane(0, 1, turn.clone()), &centre).unwrap();
        assert_eq!(rotate(&there, &Rotation::Plane(0, 1, turn.inverse()), &centre).unwrap(), form);
    }
}

#[test]
fn a_mirror_undoes_itself_and_keeps_lengths() {
    for (form, mut random) in exact_forms(0..=2) {
        let ambient = form.ambient();
        let origin = vector(&mut random, ambient);
        let normal = direction(&mut random, ambient);
        let image = mirror(&form, &normal, &origin).unwrap();
        assert_eq!(mirror(&image, &normal, &origin).unwrap(), form);
        assert_eq!(image.weights(), form.weights());
        let map = reflection(&normal, &origin).unwrap();
        for i in 0..ambient {
            for j in 0..ambient {
                let columns = (0..ambient).map(|row| &map.row(row)[i] * &map.row(row)[j]);
                assert_eq!(columns.sum::<Rational>(), Rational::ratio(i64::from(i == j), 1));
            }
        }
        // Half-way between a pole and its image lies the plane, along the normal.
        for (new, old) in
            image.homogeneous().chunks(ambient + 1).zip(form.homogeneous().chunks(ambient + 1))
        {
            let sum: Vec<Rational> = (0..ambient).map(|k| &new[k] + &old[k]).collect();
            let weight = &new[ambient] + &old[ambient];
            assert_eq!(dot(&normal, &sum), dot(&normal, &origin) * weight);
        }
    }
}

#[test]
fn a_shadow_lies_on_the_plane_in_line_with_the_lamp() {
    for (form, mut random) in exact_forms(0..=2) {
        let ambient = form.ambient();
        let origin = vector(&mut random, ambient);
        let normal = direction(&mut random, ambient);
        let plane: Vec<Rational> = normal.iter().cloned().chain([-dot(&normal, &origin)]).collect();
        let from = direction(&mut random, ambient + 1);
        let Ok(shadow) = project_to_plane(&form, &normal, &origin, &from) else {
            assert_eq!(dot(&plane, &from), Scalar::zero());
            continue;
        };
        let height = dot(&plane, &from);
        for (new, old) in
            shadow.homogeneous().chunks(ambient + 1).zip(form.homogeneous().chunks(ambient + 1))
        {
            assert_eq!(dot(&plane, new), Scalar::zero());
            for k in 0..=ambient {
                assert_eq!(&height * (&old[k] - &new[k]), dot(&plane, old) * &from[k]);
            }
        }
        assert_eq!(project_to_plane(&shadow, &normal, &origin, &from).unwrap(), shadow);
    }
}

#[test]
fn the_shadow_of_a_parabola_is_a_circle() {
    // A parabola on the cone x² + y² = z², seen from its apex.
    let r = |n: i64| Rational::ratio(n, 1);
    let points = [1, 0, 1, 1, 1, 1, 0, 2, 2].map(r);
    let parabola: Exact = Form::from_points(&[3], 3, &points, None).unwrap();
    let [origin, up, apex] = [[0, 0, 1].map(r), [0, 0, 1].map(r), [0, 0, 0].map(r)];
    let lamp: Vec<Rational> = apex.into_iter().chain([r(1)]).collect();
    let arc = project_to_plane(&parabola, &up, &origin, &lamp).unwrap();
    for k in 0..=6 {
        let point = arc.at(&[Rational::ratio(k, 6)]).unwrap();
        assert_eq!(&point[0] * &point[0] + &point[1] * &point[1], r(1));
        assert_eq!(point[2], r(1));
    }
}

#[test]
fn half_tangents_lie_on_the_circle_however_steep() {
    for (numerator, denominator) in [(0, 1), (1, 2), (-3, 4), (1, 1), (-1, 1), (7, 1), (-1000, 3)] {
        let t = Rational::ratio(numerator, denominator);
        let turn = Turn::half_tangent(&t).unwrap();
        let [one, square] = [Rational::ratio(1, 1), &t * &t];
        assert_eq!(turn.cosine() * (&one + &square), &one - &square);
        assert_eq!(turn.sine() * (&one + &square), &t + &t);
    }
    let steep = Turn::half_tangent(&1e200).unwrap();
    assert_eq!((*steep.cosine(), *steep.sine()), (-1.0, 2e-200));
}

#[test]
fn degrees_are_exact_at_quarters_and_of_any_size() {
    for quarters in [-7_i64, -2, 0, 1, 3, 40_001] {
        let turn = Turn::degrees(90.0 * quarters as f64).unwrap();
        assert_eq!(turn, Turn::quarters(quarters));
    }
    // An ulp for the angle in radians, one for the function.
    for degrees in [-725.0_f64, -33.0, 12.5, 77.0, 135.0, 1e6 + 20.0] {
        let (turn, radians) = (Turn::degrees(degrees).unwrap(), (degrees % 360.0).to_radians());
        assert!((turn.cosine() - radians.cos()).abs() < 4e-15, "{degrees}");
        assert!((turn.sine() - radians.sin()).abs() < 4e-15, "{degrees}");
    }
}

#[test]
fn sizes_near_the_ends_of_the_range_are_no_obstacle() {
    let segment: Form = Form::from_points(&[2], 3, &[1., 2., 3., -4., 5., 6.], None).unwrap();
    let upright = mirror(&segment, &[0., 0., 1.], &[0.; 3]).unwrap();
    for size in [1e-300, 1e-150, 1e150, 1e300] {
        assert_eq!(mirror(&segment, &[0., 0., size], &[0.; 3]).unwrap(), upright);
        let axis = Rotation::about(&[0., 0., size], Turn::quarters(1)).unwrap();
        let turned = rotate(&segment, &axis, &[0.; 3]).unwrap();
        assert_eq!(turned.points().unwrap(), [-2., 1., 3., -5., -4., 6.]);
        let skew = Rotation::about(&[size, size, size], Turn::quarters(1)).unwrap();
        let Rotation::Axis(k, _) = skew else { unreachable!() };
        assert!((k.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-15);
        let ray = [0., 0., size, 0.];
        let flat = project_to_plane(&segment, &[0., 0., size], &[0.; 3], &ray).unwrap();
        assert_eq!(flat.points().unwrap(), [1., 2., 0., -4., 5., 0.]);
    }
    let lens = [0., 0., 0., 1e-300];
    let scene = project_to_plane(&segment, &[0., 0., 1.], &[0., 0., 1e300], &lens).unwrap();
    assert!((scene.points().unwrap()[0] * 3e-300 - 1.0).abs() < 1e-15);
}

#[test]
fn what_cannot_be_is_said() {
    let curve: Form = Form::from_points(&[2], 3, &[1., 2., 3., -4., 5., 6.], None).unwrap();
    let flat: Form = Form::from_points(&[2], 2, &[1., 2., 3., -4.], None).unwrap();
    let nan = f64::NAN;
    let turn = || Turn::quarters(1);
    let family = |result: pforms_kernel::Result<Form>| result.unwrap_err().family();
    assert_eq!(family(translate(&curve, &[1., 2.])), "Shape");
    assert_eq!(family(translate(&curve, &[1., 2., nan])), "Domain");
    assert_eq!(
        family(translate(&curve, &[f64::MAX; 3]).and_then(|f| translate(&f, &[f64::MAX; 3]))),
        "Domain"
    );
    assert_eq!(family(scale(&curve, &[1., 2.], &[0.; 3])), "Shape");
    assert_eq!(family(scale(&curve, &[1.; 3], &[0.; 2])), "Shape");
    assert_eq!(family(shear(&curve, 3, &[0.; 3], &[0.; 3])), "Shape");
    assert_eq!(family(shear(&curve, 1, &[0., 1., 0.], &[0.; 3])), "Domain");
    assert_eq!(family(mirror(&curve, &[0.; 3], &[0.; 3])), "Degenerate");
    assert_eq!(family(mirror(&curve, &[1., 0.], &[0.; 2])), "Shape");
    let along = project_to_plane(&curve, &[0., 0., 1.], &[0.; 3], &[1., 0., 0., 0.]);
    assert_eq!(family(along), "Degenerate");
    assert_eq!(family(project_to_plane(&curve, &[0., 0., 1.], &[0.; 3], &[1.; 3])), "Shape");
    assert_eq!(family(rotate(&flat, &Rotation::Axis([0., 0., 1.], turn()), &[0.; 2])), "Shape");
    assert_eq!(family(rotate(&flat, &Rotation::Plane(0, 2, turn()), &[0.; 2])), "Shape");
    assert_eq!(family(rotate(&flat, &Rotation::Plane(1, 1, turn()), &[0.; 2])), "Shape");
    assert_eq!(Rotation::about(&[0.; 3], turn()).unwrap_err().family(), "Degenerate");
    assert_eq!(Rotation::about(&[0., 1.], turn()).unwrap_err().family(), "Shape");
    assert_eq!(Turn::radians(f64::INFINITY).unwrap_err().family(), "Domain");
    assert_eq!(Turn::of(nan, 0.0).unwrap_err().family(), "Domain");
    let half = Rational::ratio(1, 2);
    assert_eq!(Turn::of(half.clone(), half).unwrap_err().family(), "Domain");
    let three = Matrix::from_rows(vec![vec![1.; 3]; 3]).unwrap();
    assert_eq!(family(transform(&curve, &three)), "Shape");
    let row = Matrix::from_rows(vec![vec![1.; 4]]).unwrap();
    assert_eq!(family(transform(&curve, &row)), "Shape");
    let bad = Matrix::from_rows(vec![vec![nan; 4]; 4]).unwrap();
    assert_eq!(family(transform(&curve, &bad)), "Domain");
    assert!(translation::<f64>(&[]).is_err() && scaling::<f64>(&[], &[]).is_err());
    assert!(shearing::<f64>(0, &[], &[]).is_err() && projection::<f64>(&[], &[], &[]).is_err());
    assert_eq!(Rotation::about(&[nan, 0., 0.], turn()).unwrap_err().family(), "Domain");
}
