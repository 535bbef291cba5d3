//! Laws of affine sweeps, in exact arithmetic: the matrices are random forms, of any weights.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Form, Rational, Scalar};
use pforms_operators::{
    affine_matrix, affine_sweep, binormal_form, diagonal, elevate, midpoint, normal_form, stack,
    stretch, sub, tangent_form, transpose,
};
use pforms_testkit::{ROUNDS, Random, Weights};

const ANY: [Weights; 3] = [Weights::One, Weights::Positive, Weights::Any];

/// Matrices of 0 to 2 axes and a section of 0 to 2 axes that they fit.
fn pair(random: &mut Random) -> (Form<Rational>, Form<Rational>) {
    let (rows, columns) = (random.size(2, 4), random.size(2, 4));
    let matrix = matrices(random, rows, columns);
    let axes = random.size(0, 2);
    let orders = random.orders(axes, 3);
    let weights = ANY[random.size(0, 2)];
    (matrix, random.form(&orders, columns - 1, weights))
}

/// Matrices whose entries are any fractions at all, a weight among them.
fn matrices(random: &mut Random, rows: usize, columns: usize) -> Form<Rational> {
    let axes = random.size(0, 2);
    let orders = random.orders(axes, 3);
    let count = orders.iter().product::<usize>() * rows * columns;
    let entries = (0..count).map(|_| random.fraction()).collect();
    Form::from_homogeneous(&orders, rows * columns - 1, entries).unwrap()
}

fn each(law: impl Fn(&Form<Rational>, &Form<Rational>, &mut Random)) {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let (matrix, section) = pair(&mut random);
        law(&matrix, &section, &mut random);
    }
}

#[test]
fn sweeping_commutes_with_stacking_on_either_side() {
    each(|matrix, section, random| {
        let other = random.form::<Rational>(matrix.orders(), matrix.ambient(), Weights::Any);
        let matrices = stack(&[matrix, &other]).unwrap();
        let swept = [matrix, &other].map(|m| affine_sweep(m, section).unwrap());
        let together = stack(&[&swept[0], &swept[1]]).unwrap();
        assert_eq!(affine_sweep(&matrices, section).unwrap(), together);

        let other = random.form::<Rational>(section.orders(), section.ambient(), Weights::Any);
        let sections = stack(&[section, &other]).unwrap();
        let swept = [section, &other].map(|s| affine_sweep(matrix, s).unwrap());
        let together = stack(&[&swept[0], &swept[1]]).unwrap();
        let order: Vec<usize> =
            (1..=matrix.axes()).chain([0]).chain(matrix.axes() + 1..together.axes()).collect();
        let found = affine_sweep(matrix, &sections).unwrap();
        assert_eq!(found, transpose(&together, &order).unwrap());
    });
}

#[test]
fn sweeping_commutes_with_the_middle() {
    each(|matrix, section, random| {
        let other = random.form::<Rational>(matrix.orders(), matrix.ambient(), Weights::Any);
        let swept = [matrix, &other].map(|m| affine_sweep(m, section).unwrap());
        let middle = midpoint(&[matrix, &other]).unwrap();
        let expected = midpoint(&[&swept[0], &swept[1]]).unwrap();
        assert_eq!(affine_sweep(&middle, section).unwrap(), expected);
    });
}

#[test]
fn at_each_parameter_a_matrix_acts_on_a_point() {
    each(|matrix, section, random| {
        let mut form = affine_sweep(matrix, section).unwrap();
        let (mut one, mut point) = (matrix.clone(), section.clone());
        while one.axes() > 0 {
            let t = random.fraction();
            form = sub(&form, 0, &t).unwrap();
            one = sub(&one, 0, &t).unwrap();
        }
        while point.axes() > 0 {
            let t = random.fraction();
            form = sub(&form, 0, &t).unwrap();
            point = sub(&point, 0, &t).unwrap();
        }
        let rows = one.homogeneous().chunks_exact(point.width());
        let expected: Vec<Rational> = rows
            .map(|row| {
                row.iter()
                    .zip(point.homogeneous())
                    .fold(Rational::zero(), |sum, (a, b)| sum + a.clone() * b.clone())
            })
            .collect();
        assert_eq!(form.homogeneous(), expected);
    });
}

#[test]
fn raising_and_stretching_before_or_after_is_the_same() {
    each(|matrix, section, random| {
        let swept = affine_sweep(matrix, section).unwrap();
        let by: Vec<usize> = (0..swept.axes()).map(|_| random.size(0, 2)).collect();
        let (mine, own) = by.split_at(matrix.axes());
        let raised = [elevate(matrix, mine).unwrap(), elevate(section, own).unwrap()];
        assert_eq!(affine_sweep(&raised[0], &raised[1]).unwrap(), elevate(&swept, &by).unwrap());

        let a: Vec<Rational> = (0..swept.axes()).map(|_| random.fraction()).collect();
        let b: Vec<Rational> = (0..swept.axes()).map(|_| random.fraction()).collect();
        let n = matrix.axes();
        let windows = [
            stretch(matrix, &a[..n], &b[..n]).unwrap(),
            stretch(section, &a[n..], &b[n..]).unwrap(),
        ];
        let expected = stretch(&swept, &a, &b).unwrap();
        assert_eq!(affine_sweep(&windows[0], &windows[1]).unwrap(), expected);
    });
}

#[test]
fn matrices_follow_one_another() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let (first, second) = (matrices(&mut random, 3, 2), matrices(&mut random, 2, 4));
        let section: Form<Rational> = random.form(&[3], 3, Weights::Any);
        let twice = affine_sweep(&first, &affine_sweep(&second, &section).unwrap()).unwrap();
        let product = product(&first, &second);
        assert_eq!(affine_sweep(&product, &section).unwrap(), twice);
    }
}

/// Every 3×2 matrix times every 2×4 matrix.
fn product(first: &Form<Rational>, second: &Form<Rational>) -> Form<Rational> {
    let mut entries = Vec::new();
    for a in first.homogeneous().chunks_exact(6) {
        for b in second.homogeneous().chunks_exact(8) {
            for row in a.chunks_exact(2) {
                for j in 0..4 {
                    entries.push(row[0].clone() * b[j].clone() + row[1].clone() * b[4 + j].clone());
                }
            }
        }
    }
    let orders = [first.orders(), second.orders()].concat();
    Form::from_homogeneous(&orders, 11, entries).unwrap()
}

#[test]
fn a_translation_along_a_segment_extrudes_and_a_diagonal_follows() {
    let mut random = Random::new(7);
    let section: Form<Rational> = random.form(&[4], 3, Weights::Positive);
    let point = |p: [i64; 3]| Form::point(&p.map(|x| Rational::ratio(x, 1))).unwrap();
    let zero = || point([0, 0, 0]);
    let unit = |k: usize| point([0, 1, 2].map(|i| i64::from(i == k)));
    let [x, y, z] = [0, 1, 2].map(unit);
    let still = affine_matrix(&[&x, &y, &z, &zero()]).unwrap();
    assert_eq!(affine_sweep(&still, &section).unwrap(), section);
    let moved = affine_matrix(&[&x, &y, &z, &z]).unwrap();
    let prism = affine_sweep(&stack(&[&still, &moved]).unwrap(), &section).unwrap();
    assert_eq!(prism.kind().to_string(), "pS24");
    let top = affine_sweep(&moved, &section).unwrap();
    assert_eq!(prism, stack(&[&section, &top]).unwrap());
    assert_eq!(diagonal(&prism, 0, 1).unwrap().kind().to_string(), "pL5");
}

/// `origin + Σ s_k·vector_k`, at one parameter, from the euclidean values.
fn frame_point(columns: &[&Form<Rational>], u: &Rational, s: &[Rational]) -> Vec<Rational> {
    let (origin, vectors) = columns.split_last().unwrap();
    let mut point = origin.at(std::slice::from_ref(u)).unwrap();
    for (vector, s) in vectors.iter().zip(s) {
        let value = vector.at(std::slice::from_ref(u)).unwrap();
        Rational::add_multiple(&mut point, s, &value);
    }
    point
}

#[test]
fn columns_are_vectors_and_an_origin() {
    for seed in 0..ROUNDS {
        let mut random = Random::new(seed);
        let mut column = || {
            let weights = [Weights::One, Weights::Positive][random.size(0, 1)];
            let order = random.size(1, 4);
            random.form::<Rational>(&[order], 3, weights)
        };
        let columns: [Form<Rational>; 3] = [column(), column(), column()];
        let columns: Vec<&Form<Rational>> = columns.iter().collect();
        let s: [Rational; 2] = [random.fraction(), random.fraction()];
        let matrix = affine_matrix(&columns).unwrap();
        let swept = affine_sweep(&matrix, &Form::point(&s).unwrap()).unwrap();
        let u = random.parameter();
        assert_eq!(swept.at(std::slice::from_ref(&u)).unwrap(), frame_point(&columns, &u, &s));
    }
}

#[test]
fn unnormalised_frames_sweep_without_a_root() {
    for (seed, weights) in [(1, Weights::One), (2, Weights::Positive)] {
        let mut random = Random::new(seed);
        let path: Form<Rational> = random.form(&[4], 3, weights);
        let frame = [
            normal_form(&path).unwrap(),
            binormal_form(&path).unwrap(),
            tangent_form(&path, 0).unwrap(),
        ];
        let columns = [&frame[0], &frame[1], &frame[2], &path];
        let matrix = affine_matrix(&columns).unwrap();
        let section: Form<Rational> = random.form(&[3], 3, Weights::Positive);
        let swept = affine_sweep(&matrix, &section).unwrap();
        let (u, v) = (Rational::ratio(2, 7), Rational::ratio(3, 5));
        let s = section.at(std::slice::from_ref(&v)).unwrap();
        assert_eq!(swept.at(&[u.clone(), v]).unwrap(), frame_point(&columns, &u, &s));
    }
}

#[test]
fn directions_are_columns_too() {
    let along = Form::from_points(&[], 2, &[3.0, 4.0], Some(&[0.0])).unwrap();
    let heavy = Form::from_points(&[], 2, &[1.0, 2.0], Some(&[4.0])).unwrap();
    let matrix: Form = affine_matrix(&[&along, &heavy]).unwrap();
    assert_eq!(matrix.homogeneous(), [3.0, 1.0, 4.0, 2.0, 0.0, 1.0]);
    // A column without axes is the same everywhere.
    let path: Form = Form::from_points(&[2], 2, &[0.0, 0.0, 5.0, 0.0], None).unwrap();
    let matrix = affine_matrix(&[&along, &path]).unwrap();
    assert_eq!(matrix.homogeneous(), [3.0, 0.0, 4.0, 0.0, 0.0, 1.0, 3.0, 5.0, 4.0, 0.0, 0.0, 1.0]);
}

#[test]
fn what_does_not_fit_is_refused() {
    let family = |result: pforms_kernel::Result<Form>| result.unwrap_err().family();
    let plane: Form = Form::point(&[1.0, 2.0]).unwrap();
    let space: Form = Form::point(&[1.0, 2.0, 3.0]).unwrap();
    assert_eq!(family(affine_sweep(&space, &space)), "Shape"); // one row of four
    assert_eq!(family(affine_sweep(&plane, &plane)), "Shape");
    let ragged: Form = Form::point(&[0.0; 9]).unwrap();
    assert_eq!(family(affine_sweep(&ragged, &plane)), "Shape");
    assert_eq!(family(affine_matrix(&[])), "Shape");
    assert_eq!(family(affine_matrix(&[&plane, &space])), "Shape");
    let direction = Form::from_points(&[], 2, &[1.0, 0.0], Some(&[0.0])).unwrap();
    assert_eq!(family(affine_matrix(&[&plane, &direction])), "Domain");
    let huge: Form = Form::point(&[1e200; 8]).unwrap();
    let far: Form = Form::point(&[1e200; 2]).unwrap();
    assert_eq!(family(affine_sweep(&huge, &far)), "Domain");
}
