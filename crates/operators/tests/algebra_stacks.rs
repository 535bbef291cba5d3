//! A stack of forms is acted on as form by form, to the bit: its first axis is left alone.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Form, Rational, Result, Scalar};
use pforms_operators::{diagonal, elevate, split, stack, stretch, sub, subdivide, unstack};
use pforms_testkit::{Random, Weights, exact_forms};

/// The forms that an operator gives for the stack, and those it gives for each.
fn assert_alike<S: Scalar>(
    forms: &[Form<S>],
    together: impl Fn(&Form<S>) -> Result<Form<S>>,
    alone: impl Fn(&Form<S>) -> Result<Form<S>>,
) {
    let stacked = stack(&forms.iter().collect::<Vec<_>>()).unwrap();
    let each: Vec<Form<S>> = forms.iter().map(|form| alone(form).unwrap()).collect();
    assert_eq!(unstack(&together(&stacked).unwrap()).unwrap(), each);
}

/// The same numbers, the first of them for the axis that is left alone.
fn with_first<T: Clone>(first: T, list: &[T]) -> Vec<T> {
    [&[first], list].concat()
}

fn check<S: Scalar>(forms: &[Form<S>]) {
    let axes = forms[0].axes();
    let number = |k: usize| S::ratio(2 * k as i64 + 1, 5);
    let (by, r): (Vec<usize>, Vec<u32>) = (0..axes).map(|k| ((k + 1) % 3, k as u32 % 3)).unzip();
    let (a, b): (Vec<S>, Vec<S>) = (0..axes).map(|k| (number(k), -number(k))).unzip();
    assert_alike(forms, |f| Ok(f.clone()), |f| Ok(f.clone()));
    assert_alike(forms, |f| elevate(f, &with_first(0, &by)), |f| elevate(f, &by));
    let (from, to) = (with_first(S::zero(), &a), with_first(S::one(), &b));
    assert_alike(forms, |f| stretch(f, &from, &to), |f| stretch(f, &a, &b));
    for axis in 0..axes {
        let t = number(axis);
        assert_alike(forms, |f| sub(f, axis + 1, &t), |f| sub(f, axis, &t));
        assert_alike(forms, |f| Ok(split(f, axis + 1, &t)?.0), |f| Ok(split(f, axis, &t)?.0));
        for other in (0..axes).filter(|other| *other != axis) {
            let merged = |f: &Form<S>| diagonal(f, axis + 1, other + 1);
            assert_alike(forms, merged, |f| diagonal(f, axis, other));
        }
    }
    let levels = with_first(0, &r);
    for piece in 0..subdivide(&forms[0], &r).unwrap().counts().iter().product::<usize>() {
        let part = |f: &Form<S>, r: &[u32]| Ok(subdivide(f, r)?.pieces()?.swap_remove(piece));
        assert_alike(forms, |f| part(f, &levels), |f| part(f, &r));
    }
}

#[test]
fn a_stack_is_acted_on_as_each_of_its_forms() {
    for (f, mut random) in exact_forms(0..=3) {
        let mut another = || random.form::<Rational>(f.orders(), f.ambient(), Weights::Positive);
        check(&[f.clone(), another(), another()]);
    }
}

#[test]
fn to_the_bit() {
    for seed in 0..20 {
        let mut random = Random::new(seed);
        for weights in [Weights::One, Weights::Positive] {
            let axes = random.size(0, 4);
            let orders = random.orders(axes, 5);
            let forms: Vec<Form> = (0..4).map(|_| random.form(&orders, 3, weights)).collect();
            check(&forms);
        }
    }
}

#[test]
fn ten_thousand_forms_are_no_exception() {
    let count = 10_000;
    let poles: Vec<f64> = (0..count * 16).map(|k| f64::from(k as i32 % 97)).collect();
    let forms = Form::from_points(&[count, 2, 4], 2, &poles, None).unwrap();
    let last = unstack(&forms).unwrap().swap_remove(count - 1);
    let merged = diagonal(&forms, 1, 2).unwrap();
    assert_eq!(unstack(&merged).unwrap()[count - 1], diagonal(&last, 0, 1).unwrap());
    let raised = elevate(&forms, &[0, 3, 1]).unwrap();
    assert_eq!(unstack(&raised).unwrap()[count - 1], elevate(&last, &[3, 1]).unwrap());
}
