//! Interpolation against exact arithmetic.
#![allow(clippy::unwrap_used)]

use pforms_kernel::{Form, Rational, Scalar, bernstein_row};
use pforms_operators::{Nodes, interpolate, interpolate_homogeneous};

/// A reproducible sequence of fractions in `[−1, 1]`, exact in `f64`.
fn noise(seed: u64) -> impl FnMut() -> Rational {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        Rational::ratio((state >> 44) as i64 - (1 << 19), 1 << 19)
    }
}

fn random_net(seed: u64, orders: &[usize], ambient: usize) -> Form<Rational> {
    let mut next = noise(seed);
    let count: usize = orders.iter().product();
    let points: Vec<Rational> = (0..count * ambient).map(|_| next()).collect();
    let weights: Vec<Rational> = (0..count)
        .map(|_| next() / Rational::from_integer(4.into()) + Rational::ratio(5, 4))
        .collect();
    Form::from_points(orders, ambient, &points, Some(&weights)).unwrap()
}

fn rough(form: &Form<Rational>) -> Form {
    form.map_scalar(Rational::to_f64).unwrap()
}

#[test]
fn formulas_of_the_book() {
    // Section 221: rows of coefficients of b₀ … b_n, over a common denominator.
    let book: [&[(&[i64], i64)]; 3] = [
        &[(&[1, 0, 0], 1), (&[-1, 4, -1], 2), (&[0, 0, 1], 1)],
        &[(&[1, 0, 0, 0], 1), (&[-5, 18, -9, 2], 6), (&[2, -9, 18, -5], 6), (&[0, 0, 0, 1], 1)],
        &[
            (&[1, 0, 0, 0, 0], 1),
            (&[-13, 48, -36, 16, -3], 12),
            (&[13, -64, 120, -64, 13], 18),
            (&[-3, 16, -36, 48, -13], 12),
            (&[0, 0, 0, 0, 1], 1),
        ],
    ];
    for rows in book {
        let order = rows.len();
        let coordinates: Vec<Rational> = (0..order * order)
            .map(|k| Rational::ratio(i64::from(k / order == k % order), 1))
            .collect();
        let basis = Form::from_points(&[order], order, &coordinates, None).unwrap();
        let expected: Vec<Rational> = rows
            .iter()
            .flat_map(|(row, whole)| row.iter().map(|part| Rational::ratio(*part, *whole)))
            .collect();
        let solved = interpolate(&basis, &Nodes::Uniform).unwrap();
        assert_eq!(solved.points().unwrap(), expected);
    }
}

#[test]
fn passes_through_its_net_exactly_in_any_dimension() {
    for orders in [vec![], vec![1], vec![6], vec![3, 4], vec![2, 3, 4], vec![2, 1, 3, 2]] {
        for nodes in [Nodes::Uniform, Nodes::Chebyshev, Nodes::Lobatto] {
            let net = random_net(7, &orders, 2);
            let exact = interpolate(&net, &nodes).unwrap();
            let homogeneous = interpolate_homogeneous(&net, &nodes).unwrap();
            assert!(!exact.is_rational());
            for flat in 0..net.pole_count() {
                let (index, at) = index_and_nodes(&nodes, &orders, flat);
                let pole = net.pole(&index).unwrap();
                assert_eq!(homogeneous.homogeneous_at(&at).unwrap(), pole);
                let point: Vec<Rational> = pole[..2].iter().map(|x| x / &pole[2]).collect();
                assert_eq!(exact.at(&at).unwrap(), point);
            }
        }
    }
}

fn index_and_nodes(
    nodes: &Nodes<Rational>,
    orders: &[usize],
    flat: usize,
) -> (Vec<usize>, Vec<Rational>) {
    let mut rest = flat;
    let mut index = vec![0; orders.len()];
    for (i, order) in index.iter_mut().zip(orders).rev() {
        *i = rest % order;
        rest /= order;
    }
    let at = index
        .iter()
        .enumerate()
        .map(|(axis, &i)| nodes.on_axis(axis, orders[axis]).unwrap()[i].clone())
        .collect();
    (index, at)
}

#[test]
fn given_nodes_may_lie_anywhere_in_any_order() {
    let lists: [&[(i64, i64)]; 4] = [
        &[(1, 2), (0, 1), (1, 1), (1, 5)],
        &[(-3, 1), (7, 2), (0, 1), (1, 3)],
        &[(2, 1), (3, 1), (4, 1), (9, 1)],
        &[(-5, 1), (-4, 1), (-3, 1), (-1, 7)],
    ];
    for list in lists {
        let list: Vec<Rational> = list.iter().map(|(a, b)| Rational::ratio(*a, *b)).collect();
        let net = random_net(3, &[4], 3);
        let curve = interpolate_homogeneous(&net, &Nodes::Given(vec![list.clone()])).unwrap();
        for (i, node) in list.iter().enumerate() {
            assert_eq!(
                curve.homogeneous_at(std::slice::from_ref(node)).unwrap(),
                net.pole(&[i]).unwrap()
            );
        }
    }
}

#[test]
fn points_of_a_form_give_the_form_back() {
    let form = random_net(11, &[3, 5], 3);
    let nodes = Nodes::<Rational>::Uniform;
    let samples: Vec<Rational> = nodes
        .on_axis(0, 3)
        .unwrap()
        .iter()
        .flat_map(|u| {
            let row = nodes.on_axis(1, 5).unwrap();
            row.into_iter()
                .flat_map(|v| form.homogeneous_at(&[u.clone(), v]).unwrap())
                .collect::<Vec<_>>()
        })
        .collect();
    let net = Form::from_homogeneous(&[3, 5], 3, samples).unwrap();
    assert_eq!(interpolate_homogeneous(&net, &nodes).unwrap(), form);
}

/// `|A⁻¹|·|q|` for every pole: what roundings of the data alone can change.
///
/// `A` is totally positive, so the signs of `A⁻¹` alternate like a chessboard, and data whose
/// signs alternate likewise are amplified without cancellation.
fn sensitivity(net: &Form<Rational>, nodes: &Nodes<Rational>) -> Form<Rational> {
    let mut data = net.homogeneous().to_vec();
    for (flat, pole) in data.chunks_exact_mut(net.width()).enumerate() {
        let (index, _) = index_and_nodes(nodes, net.orders(), flat);
        let odd = index.iter().sum::<usize>() % 2 == 1;
        for x in pole {
            *x = if odd { -magnitude(x) } else { magnitude(x) };
        }
    }
    let alternating = Form::from_homogeneous(net.orders(), net.ambient(), data).unwrap();
    interpolate_homogeneous(&alternating, nodes).unwrap().map_scalar(magnitude).unwrap()
}

fn magnitude(x: &Rational) -> Rational {
    if *x < Rational::zero() { -x.clone() } else { x.clone() }
}

/// Largest error of a pole in units of its sensitivity times `ε`.
fn worst(net: &Form<Rational>, nodes: &Nodes<Rational>, floating: &Nodes) -> f64 {
    let exact = interpolate_homogeneous(net, nodes).unwrap();
    let found = interpolate_homogeneous(&rough(net), floating).unwrap();
    let sensitivity = sensitivity(net, nodes);
    let triples =
        found.homogeneous().iter().zip(exact.homogeneous()).zip(sensitivity.homogeneous());
    triples
        .map(|((found, exact), scale)| {
            let error = magnitude(&(Rational::from_f64(*found).unwrap() - exact));
            (error / scale).to_f64() / f64::EPSILON
        })
        .fold(0.0, f64::max)
}

/// Chebyshev nodes rounded to 20 bits: short fractions keep exact arithmetic quick.
fn short(nodes: &Nodes, order: usize) -> Vec<f64> {
    let whole = 2.0_f64.powi(20);
    nodes.on_axis(0, order).unwrap().iter().map(|t| (t * whole).round() / whole).collect()
}

fn exactly(list: &[f64]) -> Vec<Rational> {
    list.iter().map(|t| Rational::from_f64(*t).unwrap()).collect()
}

/// `10⁻¹⁵` in units of `ε`: the promise of the operator. Measured: 1.3.
const PROMISE: f64 = 4.5;

#[test]
fn degree_30_at_chebyshev_nodes_is_as_right_as_its_condition() {
    for nodes in [Nodes::Chebyshev, Nodes::Lobatto] {
        for order in [2, 5, 16, 31] {
            let list = short(&nodes, order);
            let exact = Nodes::Given(vec![exactly(&list)]);
            let net = random_net(order as u64, &[order], 2);
            let found = worst(&net, &exact, &Nodes::Given(vec![list]));
            println!("{nodes:?} order {order}: {found:.2} ε·|A⁻¹||q|");
            assert!(found < PROMISE, "order {order}: {found} ε");
        }
    }
    let found = worst(&random_net(3, &[12], 2), &Nodes::Chebyshev, &Nodes::Chebyshev);
    assert!(found < PROMISE, "{found} ε");
}

#[test]
fn surfaces_of_degree_30_too() {
    let lists = [31, 4].map(|order| short(&Nodes::Chebyshev, order));
    let exact = Nodes::Given(lists.iter().map(|list| exactly(list)).collect());
    let found = worst(&random_net(5, &[31, 4], 1), &exact, &Nodes::Given(lists.to_vec()));
    println!("31×4 Chebyshev: {found:.2} ε·|A⁻¹||q|");
    assert!(found < PROMISE, "{found} ε");
}

#[test]
fn forty_points_at_uniform_nodes() {
    let net = random_net(1, &[40], 3);
    let found = worst(&net, &Nodes::Uniform, &Nodes::Uniform);
    println!("40 uniform nodes: {found:.2} ε·|A⁻¹||q|");
    assert!(found < PROMISE, "{found} ε");
    // And the residual, measured against what the poles weigh at each node.
    let curve = interpolate_homogeneous(&rough(&net), &Nodes::Uniform).unwrap().exact().unwrap();
    for i in 0..40 {
        let t = Rational::ratio(i as i64, 39);
        let row = bernstein_row(39, &t);
        let reached = curve.homogeneous_at(&[t]).unwrap();
        for (k, x) in reached.iter().enumerate() {
            let weight = row.iter().zip(curve.homogeneous().chunks_exact(4));
            let weight = weight.fold(Rational::zero(), |sum, (b, p)| sum + b * magnitude(&p[k]));
            let residual = magnitude(&(x - &net.pole(&[i]).unwrap()[k]));
            assert!((residual / weight).to_f64() < 1e-14);
        }
    }
}

/// Factors that are remembered are those that would be made; many threads may ask at once.
#[test]
fn remembered_nodes_are_as_good_as_given_ones() {
    let solve = |order: usize| {
        let net = rough(&random_net(order as u64, &[order, 3], 2));
        for nodes in [Nodes::Uniform, Nodes::Chebyshev, Nodes::Lobatto] {
            let by_rule = interpolate_homogeneous(&net, &nodes).unwrap();
            if nodes != Nodes::Uniform {
                let lists = [order, 3].map(|order| nodes.on_axis(0, order).unwrap());
                let given = Nodes::Given(lists.to_vec());
                assert_eq!(by_rule, interpolate_homogeneous(&net, &given).unwrap());
            }
            assert_eq!(by_rule, interpolate_homogeneous(&net, &nodes).unwrap());
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| [1, 2, 9, 48, 49].into_iter().for_each(solve));
        }
    });
}

#[test]
fn scaling_by_a_power_of_two_changes_no_bit() {
    let net = rough(&random_net(9, &[12], 3));
    let scaled = net.map_scalar(|x| x * 2.0_f64.powi(100)).unwrap();
    let result = interpolate_homogeneous(&net, &Nodes::Uniform).unwrap();
    let expected = result.map_scalar(|x| x * 2.0_f64.powi(100)).unwrap();
    assert_eq!(interpolate_homogeneous(&scaled, &Nodes::Uniform).unwrap(), expected);
}

#[test]
fn bad_nodes_are_named() {
    let net = rough(&random_net(2, &[3, 2], 2));
    let with = |u: Vec<f64>| interpolate(&net, &Nodes::Given(vec![u, vec![0.0, 1.0]])).unwrap_err();
    assert_eq!(
        with(vec![0.5, 0.0, 0.5]).to_string(),
        "nodes: received nodes 0 and 2 of axis 0 both at 0.5, expected distinct nodes"
    );
    assert_eq!(with(vec![0.0, 1.0]).family(), "Shape");
    assert_eq!(with(vec![0.0, f64::NAN, 1.0]).family(), "Domain");
    let infinite = Form::from_points(&[2], 1, &[0.0, 1.0], Some(&[1.0, 0.0])).unwrap();
    assert_eq!(interpolate(&infinite, &Nodes::Uniform).unwrap_err().family(), "Domain");
    assert!(interpolate_homogeneous(&infinite, &Nodes::Uniform).is_ok());
}
