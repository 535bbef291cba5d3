//! Solids combined: volumes against closed forms, within the bound that comes with them.
#![allow(missing_docs, clippy::unwrap_used)]

use std::f64::consts::PI;

use pforms_kernel::{Form, Result};
use pforms_mesh::{Mesh, Operation, Part, Solid, combine, solid};
use pforms_testkit::whole_sphere;

use Operation::{Common, Difference, Union};

/// A closed form of the reference cases.
fn truth(id: &str, name: &str) -> f64 {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/truth/closed-forms.json");
    let all: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let items = all["items"].as_array().unwrap();
    let item = items.iter().find(|item| item["id"] == id).unwrap();
    item["values"][name].as_str().unwrap().parse().unwrap()
}

fn parts(forms: Vec<Form>) -> Vec<Part> {
    forms.into_iter().map(|form| Part::Shape(form.into())).collect()
}

/// Every pole moved: `matrix` by rows, then `shift`.
fn moved(forms: &[Form], matrix: [[f64; 3]; 3], shift: [f64; 3]) -> Vec<Form> {
    let pole = |p: &[f64]| {
        let row = |k: usize| (0..3).map(|j| matrix[k][j] * p[j]).sum::<f64>() + shift[k] * p[3];
        [row(0), row(1), row(2), p[3]]
    };
    let form = |form: &Form| {
        let poles = form.homogeneous().chunks(4).flat_map(pole).collect();
        Form::from_homogeneous(form.orders(), 3, poles).unwrap()
    };
    forms.iter().map(form).collect()
}

fn shifted(forms: &[Form], shift: [f64; 3]) -> Vec<Form> {
    moved(forms, [[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]], shift)
}

fn scaled(forms: &[Form], factor: f64) -> Vec<Form> {
    moved(forms, [[factor, 0., 0.], [0., factor, 0.], [0., 0., factor]], [0.0; 3])
}

/// The cylinder of radius 1 round the z-axis, from −`half` to `half`, with its two caps.
fn cylinder(half: f64) -> Vec<Form> {
    let w = 0.5_f64.sqrt();
    let corners =
        [[1., 0.], [1., 1.], [0., 1.], [-1., 1.], [-1., 0.], [-1., -1.], [0., -1.], [1., -1.]];
    let mut forms = Vec::new();
    for quarter in 0..4 {
        let arc = [0, 1, 2].map(|k| corners[(2 * quarter + k) % 8]);
        let ring = |z: f64| -> Vec<f64> { arc.iter().flat_map(|p| [p[0], p[1], z]).collect() };
        let weights = [1., w, 1., 1., w, 1.];
        let side = [ring(-half), ring(half)].concat();
        forms.push(Form::from_points(&[2, 3], 3, &side, Some(&weights)).unwrap());
        for z in [-half, half] {
            let cap = [ring(z), [0., 0., z].repeat(3)].concat();
            forms.push(Form::from_points(&[2, 3], 3, &cap, Some(&weights)).unwrap());
        }
    }
    forms
}

fn cube(low: [f64; 3], high: [f64; 3]) -> Form {
    let mut points = Vec::new();
    for x in [low[0], high[0]] {
        for y in [low[1], high[1]] {
            for z in [low[2], high[2]] {
                points.extend([x, y, z]);
            }
        }
    }
    Form::from_points(&[2, 2, 2], 3, &points, None).unwrap()
}

fn done(operation: Operation, a: &[Part], b: &[Part], accuracy: f64) -> Solid {
    let made = combine(operation, &[a.to_vec(), b.to_vec()], accuracy).unwrap();
    assert!(made.mesh.vertex_count() == 0 || made.mesh.is_closed());
    made
}

fn volume(solid: &Solid) -> f64 {
    solid.mesh.volume().unwrap()
}

/// Within the bound, which is not `most` times as large as it need be.
fn within(solid: &Solid, expected: f64, most: f64) {
    let (off, bound) = ((volume(solid) - expected).abs(), solid.volume_error);
    assert!(off <= bound, "{off:e} above {bound:e}");
    assert!(bound <= most * off, "{bound:e} for {off:e}, {} times", bound / off);
}

/// Equal but for the rounding of a sum of a few cones.
fn near(volume: f64, expected: f64) {
    assert!((volume - expected).abs() < 1e-13 * expected.abs().max(1.0), "{volume}");
}

#[test]
fn two_balls_have_a_lens_together() {
    let lens = truth("two-spheres-1-1-1", "lens_volume");
    let ball = whole_sphere();
    let other = shifted(&ball, [1.0, 0.0, 0.0]);
    // What the bound has too much is mostly of second order: it falls with the accuracy.
    for (accuracy, most) in [(1e-2, 8.0), (1e-3, 4.0), (1e-4, 3.0)] {
        let both = done(Common, &parts(ball.clone()), &parts(other.clone()), accuracy);
        within(&both, lens, most);
        // The box round a ball has a diagonal of twice the root of 3.
        assert!(both.distance <= 3.5 * accuracy);
    }
}

#[test]
fn two_cylinders_cross_in_the_solid_of_steinmetz() {
    let upright = cylinder(2.0);
    let lying = moved(&upright, [[0., 0., 1.], [0., 1., 0.], [-1., 0., 0.]], [0.0; 3]);
    let both = done(Common, &parts(upright), &parts(lying), 1e-4);
    // For the sake of the caps the sides are far finer than was asked: what is left is rounding up.
    within(&both, 16.0 / 3.0, 120.0);
}

#[test]
fn a_drilled_ball_is_a_napkin_ring() {
    let ring = truth("coaxial-sphere-cylinder-2-1", "ring_volume");
    let ball = scaled(&whole_sphere(), 2.0);
    let left = done(Difference, &parts(ball), &parts(cylinder(3.0)), 1e-3);
    within(&left, ring, 5.0);
}

#[test]
fn volumes_add_up_to_rounding() {
    let ball = parts(whole_sphere());
    let turned =
        moved(&cylinder(0.7), [[0.6, -0.8, 0.], [0.8, 0.6, 0.], [0., 0., 1.]], [0.3, 0.2, 0.1]);
    for other in [parts(turned), parts(vec![cube([0.1; 3], [1.3, 0.9, 2.0])])] {
        let alone = |body: &[Part]| volume(&solid(body, 1e-2).unwrap());
        let [union, common] = [Union, Common].map(|op| volume(&done(op, &ball, &other, 1e-2)));
        let [one, two] =
            [(&ball, &other), (&other, &ball)].map(|(a, b)| volume(&done(Difference, a, b, 1e-2)));
        assert!((alone(&ball) + alone(&other) - union - common).abs() < 1e-11);
        assert!((one + two + common - union).abs() < 1e-11);
    }
}

#[test]
fn touching_and_equal_solids_are_no_exceptions() {
    let box_at = |x: f64| parts(vec![cube([x, 0., 0.], [x + 1., 1., 1.])]);
    let unit = box_at(0.0);
    // Side by side with a common face: one box.
    let row = done(Union, &unit, &box_at(1.0), 1e-3);
    near(volume(&row), 2.0);
    assert_eq!(row.mesh.vertex_count(), 12, "nothing is left of the wall between");
    assert_eq!(done(Common, &unit, &box_at(1.0), 1e-3).mesh.triangles().len(), 0);
    // Faces in one plane, from inside.
    near(volume(&done(Difference, &unit, &box_at(0.5), 1e-3)), 0.5);
    near(volume(&done(Union, &unit, &box_at(0.5), 1e-3)), 1.5);
    // The same twice.
    near(volume(&done(Union, &unit, &unit, 1e-3)), 1.0);
    near(volume(&done(Common, &unit, &unit, 1e-3)), 1.0);
    near(volume(&done(Difference, &unit, &unit, 1e-3)), 0.0);
    // Apart.
    near(volume(&done(Union, &unit, &box_at(5.0), 1e-3)), 2.0);
    near(volume(&done(Common, &unit, &box_at(5.0), 1e-3)), 0.0);
    // Along an edge, and at a corner.
    for corner in [[1., 1., 0.], [1., 1., 1.]] {
        let other = parts(vec![cube(corner, corner.map(|x| x + 1.0))]);
        near(volume(&done(Union, &unit, &other, 1e-3)), 2.0);
        near(volume(&done(Common, &unit, &other, 1e-3)), 0.0);
    }
}

#[test]
fn equal_balls_are_one() {
    let ball = parts(whole_sphere());
    let alone = volume(&solid(&ball, 1e-3).unwrap());
    let unit = alone.max(1.0);
    assert!((volume(&done(Union, &ball, &ball, 1e-3)) - alone).abs() < 1e-12 * unit);
    assert!((volume(&done(Common, &ball, &ball, 1e-3)) - alone).abs() < 1e-12 * unit);
    assert!(volume(&done(Difference, &ball, &ball, 1e-3)).abs() < 1e-12 * unit);
}

#[test]
fn a_hollow_stays_hollow() {
    let outer = parts(vec![cube([0.0; 3], [3.0; 3])]);
    let inner = parts(vec![cube([1.0; 3], [2.0; 3])]);
    let hollow = done(Difference, &outer, &inner, 1e-3).mesh;
    near(hollow.volume().unwrap(), 26.0);
    // Given back as a mesh it is still hollow; filled it is whole.
    let again = vec![Part::Mesh(hollow.clone())];
    near(volume(&solid(&again, 1e-3).unwrap()), 26.0);
    near(volume(&done(Union, &again, &inner, 1e-3)), 27.0);
    // Inside out as a whole it is turned.
    let turned = hollow.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
    let turned = Mesh::new(3, hollow.vertices().to_vec(), turned).unwrap();
    near(turned.volume().unwrap(), -26.0);
    near(volume(&solid(&[Part::Mesh(turned)], 1e-3).unwrap()), 26.0);
}

#[test]
fn nothing_is_a_solid_too() {
    let nothing = vec![Part::Mesh(Mesh::empty())];
    let unit = parts(vec![cube([0.0; 3], [1.0; 3])]);
    near(volume(&done(Union, &nothing, &unit, 1e-3)), 1.0);
    near(volume(&done(Difference, &unit, &nothing, 1e-3)), 1.0);
    near(volume(&done(Difference, &nothing, &unit, 1e-3)), 0.0);
    near(volume(&done(Common, &unit, &nothing, 1e-3)), 0.0);
}

#[test]
fn patches_may_face_either_way_and_be_cut_differently() {
    // The ball with every second octant turned, and one of them in four pieces: no edge of these
    // is one of its neighbours.
    let mut forms = Vec::new();
    for (k, octant) in whole_sphere().into_iter().enumerate() {
        let turned = octant.homogeneous().chunks(12).rev().flatten().copied().collect();
        let form =
            if k % 2 == 0 { octant } else { Form::from_homogeneous(&[3, 3], 3, turned).unwrap() };
        if k == 3 {
            forms.extend(quarters(&form));
        } else {
            forms.push(form);
        }
    }
    for accuracy in [1e-2, 1e-3] {
        let ball = solid(&parts(forms.clone()), accuracy).unwrap();
        assert!(ball.mesh.is_closed());
        within(&ball, 4.0 / 3.0 * PI, 6.0);
    }
}

/// A surface in four, halved both ways at 1/3.
fn quarters(form: &Form) -> Vec<Form> {
    use pforms_operators::split;
    let (low, high) = split(form, 0, &(1.0 / 3.0)).unwrap();
    [low, high]
        .iter()
        .flat_map(|half| <[Form; 2]>::from(split(half, 1, &(1.0 / 3.0)).unwrap()))
        .collect()
}

#[test]
fn a_shell_that_crosses_itself_holds_what_it_is_wound_round() {
    // Two balls as one list of patches cross each other.
    let mut forms = whole_sphere();
    forms.extend(shifted(&whole_sphere(), [1.0, 0.0, 0.0]));
    let both = solid(&parts(forms), 1e-3).unwrap();
    within(&both, 8.0 / 3.0 * PI - truth("two-spheres-1-1-1", "lens_volume"), 5.0);
}

#[test]
fn a_mirrored_volume_is_a_solid_all_the_same() {
    let mirrored =
        moved(&[cube([0.0; 3], [1.0; 3])], [[-1., 0., 0.], [0., 1., 0.], [0., 0., 1.]], [0.0; 3]);
    assert_eq!(volume(&solid(&parts(mirrored), 1e-3).unwrap()), 1.0);
}

#[test]
fn a_full_turn_meets_itself_in_a_wall() {
    use pforms_operators::{Axis, Part as Turn, circle, revolve_along};
    let profile = [0., -1., 0., 0.5, -1., 0., 0., 1., 0., 0.5, 1., 0.];
    let profile = Form::from_points(&[2, 2], 3, &profile, None).unwrap();
    let turn = circle(&1.0, Turn::Whole).unwrap();
    let axis = Axis::with_length([0.0; 3], [0.0, 1.0, 0.0], &1.0).unwrap();
    let drill = revolve_along(&profile.into(), &turn, &axis).unwrap();
    let drill = solid(&[Part::Shape(drill)], 1e-3).unwrap();
    within(&drill, PI / 2.0, 15.0);
}

#[test]
fn size_and_place_change_nothing() {
    let ball = whole_sphere();
    let expected = done(Common, &parts(ball.clone()), &parts(shifted(&ball, [1., 0., 0.])), 1e-2);
    for exponent in [0, -300, 300] {
        let unit = 2.0_f64.powi(exponent);
        let small = scaled(&ball, unit);
        let other = shifted(&small, [unit, 0.0, 0.0]);
        let made = done(Common, &parts(small), &parts(other), 1e-2);
        let volume = volume(&made) / unit / unit / unit;
        assert!((volume - truth("two-spheres-1-1-1", "lens_volume")).abs() < expected.volume_error);
        assert!((made.volume_error / unit / unit / unit / expected.volume_error - 1.0).abs() < 0.1);
        let again = made.mesh.triangles() == expected.mesh.triangles();
        assert!(again || exponent != 0, "the same twice");
    }
    let far = shifted(&ball, [1e6, -1e6, 1e6]);
    let made = done(Common, &parts(far.clone()), &parts(shifted(&far, [1., 0., 0.])), 1e-2);
    // Poles are rounded there to 1e-10, and other triangles may be chosen: each of the two meshes is
    // within its own bound of one lens.
    let lens = truth("two-spheres-1-1-1", "lens_volume");
    let [here, there] = [&expected, &made].map(|solid| (volume(solid) - lens).abs());
    assert!(here <= expected.volume_error && there <= made.volume_error + 1e-9);
    let ratio = made.volume_error / expected.volume_error;
    assert!((0.5..1.5).contains(&ratio), "{ratio}");
}

#[test]
fn tiny_and_huge_solids_keep_their_bounds() {
    let huge = parts(vec![cube([-1e6; 3], [1e6; 3])]);
    let tiny = parts(vec![cube([-1e-3; 3], [1e-3; 3])]);
    for (operation, expected) in [(Common, 8e-9), (Difference, 8e18), (Union, 8e18)] {
        let made = done(operation, &huge, &tiny, 1e-3);
        assert!((volume(&made) - expected).abs() <= made.volume_error);
    }
    for unit in [1e-100, 1e100] {
        let [one, two] = [0.0, 0.5].map(|x| {
            let low = [x * unit, 0.0, 0.0];
            parts(vec![cube(low, [(x + 1.0) * unit, unit, unit])])
        });
        let made = done(Difference, &one, &two, 1e-3);
        near(volume(&made) / unit / unit / unit, 0.5);
    }
    // Beyond the largest number there is no volume, but a mesh.
    let beyond = solid(&parts(vec![cube([0.0; 3], [1e120; 3])]), 1e-3).unwrap();
    assert!(beyond.mesh.is_closed());
    assert_eq!(beyond.mesh.volume().unwrap_err().family(), "Accuracy");
}

fn refused(body: &[Part]) -> (&'static str, String) {
    let error = solid(body, 1e-3).unwrap_err();
    (error.family(), error.to_string())
}

#[test]
fn what_is_no_solid_is_named() {
    let (family, message) = refused(&parts(whole_sphere()[1..].to_vec()));
    assert_eq!(family, "Shape");
    assert!(message.contains("open shell") && message.contains("solid"), "{message}");
    let line = Form::from_points(&[2], 3, &[0., 0., 0., 1., 0., 0.], None).unwrap();
    assert_eq!(refused(&parts(vec![line])).0, "Shape");
    let flat = Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 1., 0., 1., 1.], None).unwrap();
    assert_eq!(refused(&parts(vec![flat])).0, "Shape");
    assert_eq!(refused(&[Part::Mesh(Mesh::cloud(3, vec![0.0; 9]).unwrap())]).0, "Shape");
    assert_eq!(refused(&[]).0, "Shape");
    // A box without height, and one that is a point.
    assert_eq!(refused(&parts(vec![cube([0.0; 3], [1., 1., 0.])])).0, "Degenerate");
    assert_eq!(refused(&parts(vec![cube([1.0; 3], [1.0; 3])])).0, "Degenerate");
    assert_eq!(combine(Union, &[], 1e-3).unwrap_err().family(), "Shape");
    for accuracy in [0.0, -1.0, f64::NAN, 0.5] {
        let error = solid(&parts(whole_sphere()), accuracy).unwrap_err();
        assert_eq!(error.family(), "Domain");
    }
    assert_eq!(solid(&parts(whole_sphere()), 1e-12).unwrap_err().family(), "Limit");
}

#[test]
fn a_strip_of_one_side_has_no_inside() {
    // The projective plane of six vertices: every edge belongs to two triangles.
    let faces = [
        [0, 1, 2],
        [0, 2, 3],
        [0, 3, 4],
        [0, 4, 5],
        [0, 5, 1],
        [1, 2, 4],
        [2, 3, 5],
        [3, 4, 1],
        [4, 5, 2],
        [5, 1, 3],
    ];
    let corners: Vec<f64> = (0..18).map(|k| f64::from(k * k % 7)).collect();
    let mesh = Mesh::new(3, corners, faces.to_vec()).unwrap();
    let (family, message) = refused(&[Part::Mesh(mesh)]);
    assert_eq!(family, "Shape");
    assert!(message.contains("one side"), "{message}");
}

#[test]
fn meshes_are_checked() -> Result<()> {
    assert_eq!(Mesh::new(3, vec![0.0; 4], vec![]).unwrap_err().family(), "Shape");
    assert_eq!(Mesh::new(0, vec![], vec![]).unwrap_err().family(), "Shape");
    assert_eq!(Mesh::new(3, vec![f64::NAN; 3], vec![]).unwrap_err().family(), "Domain");
    assert_eq!(Mesh::new(3, vec![0.0; 9], vec![[0, 1, 3]]).unwrap_err().family(), "Domain");
    // A triangle in the plane, in space and in dimension 4.
    for ambient in 2..5 {
        let mut corners = vec![0.0; 3 * ambient];
        (corners[ambient], corners[2 * ambient + 1]) = (3.0, 4.0);
        let mesh = Mesh::new(ambient, corners, vec![[0, 1, 2]])?;
        assert_eq!(mesh.area(), 6.0);
        for unit in [2.0_f64.powi(-500), 2.0_f64.powi(500)] {
            let corners = mesh.vertices().iter().map(|x| x * unit).collect();
            assert_eq!(mesh.with_vertices(ambient, corners)?.area(), 6.0 * unit * unit);
        }
    }
    assert_eq!(Mesh::cloud(2, vec![0.0; 4])?.volume().unwrap_err().family(), "Shape");
    Ok(())
}
