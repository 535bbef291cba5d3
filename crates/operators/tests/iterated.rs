//! Thirds, sets made of their copies and Peano's curve, exactly.
#![allow(missing_docs, clippy::unwrap_used)]

use pforms_kernel::{Form, Rational, Scalar};
use pforms_operators::{Poles, Rule, Shape, iterate, peano, sub, thirds};

fn form(orders: &[usize], ambient: usize, numbers: &[i64]) -> Form<Rational> {
    let numbers: Vec<Rational> = numbers.iter().map(|x| Scalar::from_integer(*x)).collect();
    Form::from_points(orders, ambient, &numbers, None).unwrap()
}

fn rules() -> [Rule<Rational>; 3] {
    [Rule::Cantor, Rule::Sponge, Rule::Sierpinski(Rational::ratio(2, 5))]
}

#[test]
fn thirds_cut_a_segment_and_a_parabola() {
    let f = form(&[3], 2, &[0, 0, 1, 5, 4, 2]);
    let points: Vec<Shape<Rational>> =
        f.homogeneous().chunks(3).map(|p| Form::point(&p[..2]).unwrap().into()).collect();
    let found = thirds(&points).unwrap().map(|shape| shape.net().clone());
    let at = |k| sub(&f, 0, &Rational::ratio(k, 3)).unwrap();
    assert_eq!(found, [at(1), at(2)]);
}

#[test]
fn a_generation_is_the_copies_of_its_copies() {
    let curve = form(&[3], 2, &[0, 0, 1, 2, 3, 1]);
    let surface = form(&[2, 3], 1, &[0, 1, 4, 9, 2, 7]);
    let volume = form(&[2, 2, 2], 1, &[0, 1, 2, 3, 5, 8, 13, 21]);
    for rule in rules() {
        for form in [&curve, &surface, &volume] {
            let first = iterate(form, 1, &rule).unwrap();
            let again: Vec<_> = first.iter().flat_map(|f| iterate(f, 1, &rule).unwrap()).collect();
            assert_eq!(iterate(form, 2, &rule).unwrap(), again);
        }
    }
}

#[test]
fn copies_are_as_many_as_the_dimension_says() {
    let count = |orders: &[usize], n, rule: &Rule<Rational>| {
        let numbers: Vec<i64> = (0..orders.iter().product::<usize>() as i64).collect();
        iterate(&form(orders, 1, &numbers), n, rule).unwrap().len()
    };
    let [cantor, sponge, gasket] = rules();
    assert_eq!([1, 2, 3].map(|axes| count(&vec![2; axes], 2, &cantor)), [4, 16, 64]);
    assert_eq!([1, 2, 3].map(|axes| count(&vec![2; axes], 2, &sponge)), [4, 64, 400]);
    assert_eq!(count(&[3], 5, &gasket), 243);
    assert_eq!(count(&[3], 0, &gasket), 1);
}

#[test]
fn two_homotheties_of_a_third_are_the_set_of_cantor() {
    let unit = form(&[2], 1, &[0, 1]);
    let third = Rule::Sierpinski(Rational::ratio(1, 3));
    assert_eq!(iterate(&unit, 6, &third).unwrap(), iterate(&unit, 6, &Rule::Cantor).unwrap());
}

#[test]
fn every_cell_is_passed_once_from_neighbour_to_neighbour() {
    for (n, axes) in [(1, 1), (3, 1), (1, 2), (2, 2), (3, 2), (1, 3), (2, 3)] {
        let curve = peano::<Rational>(n, axes).unwrap();
        let points = curve.net().points().unwrap();
        let side = 3_i64.pow(n as u32);
        let step = Rational::ratio(1, side);
        let mut places: Vec<Vec<Rational>> = points.chunks(axes).map(<[_]>::to_vec).collect();
        for pair in places.windows(2) {
            let apart = pair[0].iter().zip(&pair[1]).filter(|(a, b)| a != b);
            let lengths: Vec<Rational> =
                apart.map(|(a, b)| if a < b { b - a } else { a - b }).collect();
            assert_eq!(lengths, std::slice::from_ref(&step));
        }
        places.sort();
        places.dedup();
        assert_eq!(places.len(), 3_usize.pow((n * axes) as u32));
    }
}

#[test]
fn the_next_generation_is_finer_at_the_same_places() {
    // The mean of the 3^d cells that replace a cell is its middle.
    for axes in [1, 2, 3] {
        let coarse = peano::<Rational>(1, axes).unwrap().net().points().unwrap();
        let fine = peano::<Rational>(2, axes).unwrap().net().points().unwrap();
        let cells = 3_usize.pow(axes as u32);
        for (middle, own) in coarse.chunks(axes).zip(fine.chunks(axes * cells)) {
            for k in 0..axes {
                let sum = own.chunks(axes).fold(<Rational as Scalar>::zero(), |s, p| s + &p[k]);
                assert_eq!(sum / <Rational as Scalar>::from_integer(cells as i64), middle[k]);
            }
        }
    }
}

#[test]
fn what_cannot_be_is_named() {
    let unit: Form = Form::from_points(&[2], 1, &[0., 1.], None).unwrap();
    let family = |form: &Form, n, rule: Rule| iterate(form, n, &rule).unwrap_err().family();
    assert_eq!(family(&unit, 60, Rule::Cantor), "Limit");
    assert_eq!(family(&unit, usize::MAX, Rule::Sponge), "Limit");
    assert_eq!(family(&Form::point(&[1.0]).unwrap(), 1, Rule::Cantor), "Shape");
    let far = Form::from_homogeneous(&[2], 1, vec![0., 1., 1., 0.]).unwrap();
    assert_eq!(family(&far, 1, Rule::Sierpinski(0.5)), "Domain");
    assert_eq!(peano::<f64>(0, 2).unwrap_err().family(), "Shape");
    assert_eq!(peano::<f64>(2, 0).unwrap_err().family(), "Shape");
    assert_eq!(peano::<f64>(30, 2).unwrap_err().family(), "Limit");
    assert_eq!(thirds::<f64>(&[]).unwrap_err().family(), "Shape");
}
