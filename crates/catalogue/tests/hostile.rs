//! Whatever is given, in whatever order: an answer or an error, at once, and never a panic.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::time::{Duration, Instant};

use pforms_catalogue::{
    Arguments, Arithmetic, Failure, Infix, Language, Value, binary, catalogue, negate,
};
use pforms_kernel::Rational;

mod reader;

const POOL: [&str; 21] = [
    "=0",
    "=-1",
    "=1/2",
    "=3",
    "=1e300",
    "=TRUE",
    "=\"pS33\"",
    "=\"DIAG\"",
    "=[]",
    "=[0, 1]",
    "=[[1], 2]",
    "=(1, 2, 3)",
    "=(0, 0, 1; 0)",
    "=(0,)",
    "=[(0, 0), (1, 1)]",
    "=[(1, 0; -1), (1, 1; 0), (0, 0; 1)]",
    "=[[(0, 0, 0), (0, 0, 0)], [(0, 0, 0), (0, 0, 0)]]",
    "=[[[(0, 0, 0; 0)], [(1, 0, 0)]], [[(0, 1, 0)], [(1, 1, 1)]]]",
    "=[[(0, 0), (1, 0)], [(0, 1)]]",
    "=SUBDIVIDE([(0, 0), (1, 2)], 1)",
    "=FORECAST(\"pL3\", \"pS99\")",
];

fn pool<S: Arithmetic>() -> Vec<Value<S>> {
    let mut values: Vec<Value<S>> = POOL.iter().map(|text| reader::compute(text)).collect();
    values.push(Value::Empty);
    values.push(reader::compute(
        "=IMMERSE([(0, 0), (1, 1)], [[(0, 0), (1, 0)], [(0, 1), (1, 1)]], TRUE)",
    ));
    values.push(Failure::new("Cycle", "A1", "A1").into());
    values
}

/// Every value at every place, up to three places, each result looked at.
fn every_call<S: Arithmetic>() {
    let pool = pool::<S>();
    for operator in catalogue() {
        let started = Instant::now();
        let call = |arguments: &[&Value<S>]| {
            let value = operator.call(Arguments::new(arguments.iter().map(|&value| value.clone())));
            let settled = value.settle();
            settled.display(Language::English);
            settled.to_json();
        };
        call(&[]);
        for (i, first) in pool.iter().enumerate() {
            call(&[first]);
            for second in &pool {
                call(&[first, second]);
            }
            for (j, second) in pool.iter().enumerate() {
                for third in pool.iter().skip((i + j) % 3).step_by(3) {
                    call(&[first, second, third]);
                }
            }
        }
        assert!(started.elapsed() < Duration::from_secs(20), "{} is slow", operator.name);
    }
}

#[test]
fn every_call_answers_in_floating_mode() {
    every_call::<f64>();
}

#[test]
fn every_call_answers_in_exact_mode() {
    every_call::<Rational>();
}

#[test]
fn every_sign_answers() {
    use Infix::{Add, Divide, Equal, Less, Multiply, Power, Subtract};
    let pool = pool::<f64>();
    for left in &pool {
        negate(left);
        for right in &pool {
            for sign in [Add, Subtract, Multiply, Divide, Power, Equal, Less] {
                assert_eq!(binary(sign, left, right), binary(sign, left, right));
            }
        }
    }
}
