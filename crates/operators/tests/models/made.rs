//! Curves and surfaces made from the same arguments as verb makes them.

use pforms_kernel::Form;
use pforms_operators::{
    Axis, Part, Poles, Shape, Spline, arc, cone, cylinder, extrude, extrude_along, revolve, ruled,
    sphere,
};
use pforms_testkit::models::{document, plain};
use pforms_testkit::numbers;
use serde_json::Value;

use crate::{at_fractions, gap, spline};

/// The cases of a kind, as many as there should be.
fn cases(kind: &str, count: usize) -> Vec<Value> {
    let all = document("../peers/made.json");
    let mut list = all["cases"].as_array().unwrap().clone();
    list.retain(|case| case["kind"] == kind);
    assert_eq!(list.len(), count, "{kind}");
    list
}

fn vector(value: &Value) -> [f64; 3] {
    numbers(value).try_into().unwrap()
}

fn form(value: &Value) -> Spline {
    spline(&plain::read(value))
}

/// The two have the same points at the same fractions of their windows; `turned` says which
/// fractions of ours belong to those of the peer.
fn same(case: &Value, ours: &Spline, turned: impl Fn(&[f64]) -> Vec<f64>) {
    let theirs = form(&case["expected"]["form"]);
    for i in 0..=60_u32 {
        let shares: Vec<f64> =
            (0..theirs.axes() as u32).map(|k| f64::from(i * (7 * k + 1) % 61) / 60.0).collect();
        let there = theirs.at(&at_fractions(&theirs, &shares)).unwrap();
        let here = ours.at(&at_fractions(ours, &turned(&shares))).unwrap();
        let bound = case["tolerance"].as_f64().unwrap();
        assert!(gap(&here, &there) <= bound, "{} at {shares:?}: {here:?} {there:?}", case["id"]);
    }
}

/// Arcs of circles and ellipses: on `a · cos + b · sin` about a centre.
#[test]
fn arcs() {
    for case in [cases("make_arc", 8), cases("make_ellipseArc", 5)].concat() {
        let args = case["input"]["args"].as_array().unwrap();
        let (centre, mut a, mut b) = (vector(&args[0]), vector(&args[1]), vector(&args[2]));
        if let Some(radius) = args.get(5).map(|_| args[3].as_f64().unwrap()) {
            a = a.map(|x| radius * x);
            b = b.map(|x| radius * x);
        }
        let [from, to] =
            [&args[args.len() - 2], &args[args.len() - 1]].map(|x| x.as_f64().unwrap());
        let flat = arc(1.0, to - from, 3, from).unwrap();
        let ours = moved(&flat, centre, [a, b, [0.0; 3]]);
        same(&case, &ours, <[f64]>::to_vec);
    }
}

/// The shape with its axes put along others, about another origin.
fn moved(shape: &Shape, origin: [f64; 3], axes: [[f64; 3]; 3]) -> Spline {
    let place = |pole: &[f64; 4]| {
        let [x, y, z, w] = *pole;
        let at = |k: usize| origin[k] * w + axes[0][k] * x + axes[1][k] * y + axes[2][k] * z;
        [at(0), at(1), at(2), w]
    };
    let net = shape.net();
    let poles = net.homogeneous().as_chunks().0.iter().flat_map(place).collect();
    let net = Form::from_homogeneous(net.orders(), 3, poles).unwrap();
    shape.with_net(net).unwrap().into_spline()
}

#[test]
fn surfaces_of_extrusion_and_translation() {
    for case in cases("make_extrudedSurface", 4) {
        let args = &case["input"]["args"];
        let by = vector(&args[0]).map(|x| x * args[1].as_f64().unwrap());
        let profile = plain::read(&args[2]).net;
        let ours = Spline::from(extrude(&profile, &by).unwrap());
        // The peer comes down from the far end.
        same(&case, &ours, |at| vec![1.0 - at[0], at[1]]);
    }
    for case in cases("make_rationalTranslationalSurface", 1) {
        let [profile, rail] = [0, 1].map(|k| plain::read(&case["input"]["args"][k]).net);
        let ours = Spline::from(extrude_along(&profile, &rail).unwrap());
        same(&case, &ours, |at| vec![at[1], at[0]]);
    }
    for case in cases("make_fourPointSurface", 7) {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| vector(&case["input"]["args"][k]));
        let side = |from: [f64; 3], to: [f64; 3]| {
            Form::from_points(&[2], 3, &[from, to].concat(), None).unwrap()
        };
        let ours = Spline::from(ruled(&side(a, d), &side(b, c)).unwrap());
        same(&case, &ours, <[f64]>::to_vec);
    }
}

#[test]
fn surfaces_of_revolution() {
    for case in cases("make_revolvedSurface", 5) {
        let args = &case["input"]["args"];
        let profile: Shape = form(&args[0]).into();
        let axis = Axis::new(vector(&args[1]), vector(&args[2])).unwrap();
        let ours = revolve(&profile, args[3].as_f64().unwrap(), &axis, 3).unwrap().into_spline();
        same(&case, &ours, |at| vec![at[1], at[0]]);
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Ours stand on Oy and go round from x towards z.
#[test]
fn quadrics() {
    let number = |value: &Value| value.as_f64().unwrap();
    for case in cases("make_cylindricalSurface", 3) {
        let args = &case["input"]["args"];
        let (up, x) = (vector(&args[0]), vector(&args[1]));
        let ours = cylinder(&number(&args[4]), &number(&args[3]), Part::Pieces).unwrap();
        let ours = moved(&ours, vector(&args[2]), [x, up, cross(up, x)]);
        same(&case, &ours, |at| vec![1.0 - at[0], at[1]]);
    }
    for case in cases("make_conicalSurface", 2) {
        let args = &case["input"]["args"];
        let (up, x) = (vector(&args[0]), vector(&args[1]));
        let ours = cone(&number(&args[4]), &number(&args[3]), &0.0, Part::Pieces).unwrap();
        let ours = moved(&ours, vector(&args[2]), [x, up, cross(up, x)]);
        same(&case, &ours, |at| vec![1.0 - at[1], at[0]]);
    }
    for case in cases("make_sphericalSurface", 2) {
        let args = &case["input"]["args"];
        let (up, x) = (vector(&args[1]), vector(&args[2]));
        let ours = sphere(&number(&args[3]), Part::Pieces).unwrap();
        let ours = moved(&ours, vector(&args[0]), [x, up, cross(up, x)]);
        same(&case, &ours, |at| vec![at[1], at[0]]);
    }
}
