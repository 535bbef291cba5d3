use pforms_kernel::Form;

use super::*;

fn curve(points: &[f64], ambient: usize) -> Form {
    Form::from_points(&[points.len() / ambient], ambient, points, None).unwrap()
}

fn polynomial(orders: &[usize], coefficients: &[f64]) -> Polynomial {
    Polynomial { orders: orders.to_vec(), coefficients: coefficients.to_vec(), noise: 0.0 }
}

#[test]
fn two_parabolas_cross_four_times() {
    // y = 4(2s−1)² − 1/… and its mirror in the diagonal: x = s, y = 16(s−1/2)²/… chosen to cross at 4.
    let a = curve(&[0., 1., 0.5, -1., 1., 1.], 2);
    let b = curve(&[1., 0., -1., 0.5, 1., 1.], 2);
    let equations = Equations::meeting(&a, &b).unwrap();
    let found = solve(&equations, &Limits::default());
    assert!(found.clusters.is_empty(), "{found:?}");
    assert_eq!(found.roots.len(), 4, "{found:?}");
    for root in &found.roots {
        let (p, q) = (a.at(&root.parameters[..1]).unwrap(), b.at(&root.parameters[1..]).unwrap());
        assert!((p[0] - q[0]).abs() < 1e-15 && (p[1] - q[1]).abs() < 1e-15);
        assert!(root.radius < 1e-13, "{root:?}");
    }
}

#[test]
fn ends_of_curves_are_on_them() {
    let a = curve(&[0., 0., 1., 1.], 2);
    let b = curve(&[1., 1., 2., 1.], 2);
    let found = solve(&Equations::meeting(&a, &b).unwrap(), &Limits::default());
    assert!(found.clusters.is_empty());
    assert_eq!(found.roots.len(), 1);
    assert_eq!(found.roots[0].parameters, [1.0, 0.0]);
}

#[test]
fn tangent_curves_are_a_small_cluster() {
    let a = curve(&[-1., 1., 0., -1., 1., 1.], 2);
    let b = curve(&[-1., 0., 1., 0.], 2);
    let found = solve(&Equations::meeting(&a, &b).unwrap(), &Limits::default());
    assert!(found.roots.is_empty() && found.clusters.len() == 1, "{found:?}");
    let cluster = &found.clusters[0];
    assert!(cluster.width() < 1e-6 && !cluster.unfinished, "{cluster:?}");
    assert!((cluster.parameters[0] - 0.5).abs() < 1e-7);
    assert!(found.work < 500, "{}", found.work);
}

#[test]
fn nearly_tangent_curves_are_told_apart() {
    for gap in [1e-6, 1e-9, 1e-12] {
        let b = curve(&[-1., gap, 1., gap], 2);
        let a = curve(&[-1., 1., 0., -1., 1., 1.], 2);
        let found = solve(&Equations::meeting(&a, &b).unwrap(), &Limits::default());
        assert!(found.clusters.is_empty() && found.roots.len() == 2, "{gap}: {found:?}");
        let b = curve(&[-1., -gap, 1., -gap], 2);
        let found = solve(&Equations::meeting(&a, &b).unwrap(), &Limits::default());
        assert!(found.clusters.is_empty() && found.roots.is_empty(), "{gap}: {found:?}");
    }
}

#[test]
fn a_common_arc_is_one_cluster() {
    let a = curve(&[-1., 1., 0., -1., 1., 1.], 2);
    let found = solve(&Equations::meeting(&a, &a).unwrap(), &Limits::default());
    assert_eq!(found.clusters.len(), 1);
    assert!(found.clusters[0].width() == 1.0);
    let line = curve(&[0., 0., 1., 1.], 2);
    let other = curve(&[0.5, 0.5, 2., 2.], 2);
    let found = solve(&Equations::meeting(&line, &other).unwrap(), &Limits::default());
    assert_eq!(found.clusters.len(), 1);
    assert!(!found.clusters[0].unfinished);
    assert!((found.clusters[0].lower[0] - 0.5).abs() < 0.04, "{found:?}");
}

#[test]
fn lines_in_space_meet_or_pass() {
    let a = curve(&[0., 0., 0., 1., 1., 1.], 3);
    let meets = curve(&[1., 0., 0.5, 0., 1., 0.5], 3);
    let found = solve(&Equations::meeting(&a, &meets).unwrap(), &Limits::default());
    assert!(found.clusters.is_empty() && found.roots.len() == 1, "{found:?}");
    let passes = curve(&[1., 0., 0.5 + 1e-13, 0., 1., 0.5 + 1e-13], 3);
    let equations = Equations::meeting(&a, &passes).unwrap();
    assert!(solve(&equations, &Limits::default()).roots.is_empty());
    let found = solve(&equations.with_tolerance(1e-12), &Limits::default());
    assert!(found.roots.len() == 1, "{found:?}");
}

#[test]
fn a_wild_single_unknown() {
    // Wilkinson-like: (t − 1/8)(t − 2/8) … (t − 7/8), by products of linear factors.
    let mut product = vec![1.0];
    for k in 1..8 {
        let (r, degree) = (f64::from(k) / 8.0, product.len() as f64);
        let mut next = vec![0.0; product.len() + 1];
        for (i, c) in product.iter().enumerate() {
            next[i] += c * -r * (degree - i as f64) / degree;
            next[i + 1] += c * (1.0 - r) * (i as f64 + 1.0) / degree;
        }
        product = next;
    }
    let equations = Equations::new(vec![polynomial(&[8], &product)]).unwrap();
    let found = solve(&equations, &Limits::default());
    assert!(found.clusters.is_empty() && found.roots.len() == 7, "{found:?}");
}

#[test]
fn nothing_at_all_is_everywhere() {
    let equations =
        Equations::new(vec![polynomial(&[2, 2], &[0.; 4]), polynomial(&[2, 1], &[-1., 1.])])
            .unwrap();
    let found = solve(&equations, &Limits::default());
    assert!(found.roots.is_empty() && found.clusters.len() == 1);
    let cluster = &found.clusters[0];
    assert!(cluster.lower[1] == 0.0 && cluster.upper[1] == 1.0 && !cluster.unfinished);
    assert!(cluster.lower[0] > 0.45 && cluster.upper[0] < 0.55, "{cluster:?}");
}
