//! Measures of meshes against those of the forms they stand for: of flat faces the same but for rounding.
#![allow(missing_docs, clippy::unwrap_used)]

use pforms_kernel::Form;
use pforms_mesh::{Mesh, Part, envelope, mesh_area, mesh_box, mesh_mass, mesh_volume, solid};
use pforms_operators::{Mass, Shape, mass};

/// A skew box far from the origin: edges (1, 0.2, 0), (0.1, 2, 0.3) and (0, 0.4, 3).
fn skew(far: f64, unit: f64) -> Form {
    let corner = |k: usize| {
        let [x, y, z] = [k >> 2, k >> 1 & 1, k & 1].map(|k| k as f64);
        [x + 0.1 * y, 0.2 * x + 2.0 * y + 0.4 * z, 0.3 * y + 3.0 * z].map(|t| unit * (t + far))
    };
    let points: Vec<f64> = (0..8).flat_map(corner).collect();
    Form::from_points(&[2, 2, 2], 3, &points, None).unwrap()
}

fn meshed(form: &Form) -> Mesh {
    solid(&[Part::Shape(form.clone().into())], 1e-3).unwrap().mesh
}

fn agree(mesh: &Mass, form: &Mass, unit: f64) {
    let near = |x: f64, y: f64, error: f64| {
        assert!((x - y).abs() <= error, "{x} and {y}, off by more than {error:e}");
    };
    near(mesh.measure.value, form.measure.value, mesh.measure.error + form.measure.error);
    let error = mesh.centroid_error + form.centroid_error;
    assert!(error <= 1e-11 * unit);
    mesh.centroid.iter().zip(&form.centroid).for_each(|(x, y)| near(*x, *y, error));
    let error = mesh.inertia_error + form.inertia_error;
    mesh.inertia.iter().zip(&form.inertia).for_each(|(x, y)| near(*x, *y, error));
    mesh.moments.iter().zip(&form.moments).for_each(|(x, y)| near(*x, *y, error));
    assert!(error <= 1e-9 * form.moments[0]);
}

#[test]
fn a_box_weighs_as_its_faces_do() {
    for (far, unit) in [(0.0, 1.0), (100.0, 1.0), (0.0, 1e60), (0.0, 1e-60)] {
        let form = skew(far, unit);
        let mesh = [meshed(&form)];
        let full: Shape = form.clone().into();
        agree(&mesh_mass(&mesh, true).unwrap(), &mass(&[full], false, 1e-12).unwrap(), unit);
        let faces: Vec<Shape> = envelope(&form).unwrap().into_iter().map(Into::into).collect();
        agree(&mesh_mass(&mesh, false).unwrap(), &mass(&faces, false, 1e-12).unwrap(), unit);
    }
}

#[test]
fn volumes_add_up_and_have_a_sign() {
    let mesh = meshed(&skew(0.0, 1.0));
    // The determinant of the edges, by the first column.
    let expected = 1.0 * (2.0 * 3.0 - 0.3 * 0.4) - 0.2 * (0.1 * 3.0);
    let turned = mesh.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
    let turned = Mesh::new(3, mesh.vertices().to_vec(), turned).unwrap();
    let all = [mesh.clone(), turned.clone(), turned];
    for (signed, sum) in [(false, 3.0), (true, -1.0)] {
        let volume = mesh_volume(&all, signed).unwrap();
        assert!((volume.value - sum * expected).abs() <= volume.error && volume.error < 1e-11);
    }
    let one = mesh_mass(&[all[1].clone()], true).unwrap();
    assert!((one.measure.value - expected).abs() <= one.measure.error);
    let bounds = mesh_box(&all).unwrap();
    assert_eq!((bounds.lower, bounds.upper), (vec![0.0; 3], vec![1.1, 2.6, 3.3]));
    assert_eq!(bounds.error, 0.0);
}

#[test]
fn what_cannot_be_measured_says_so() {
    let mesh = meshed(&skew(0.0, 1.0));
    let opened = Mesh::new(3, mesh.vertices().to_vec(), mesh.triangles()[1..].to_vec()).unwrap();
    for error in [
        mesh_volume(std::slice::from_ref(&opened), false).unwrap_err(),
        mesh_mass(std::slice::from_ref(&opened), true).unwrap_err(),
    ] {
        assert_eq!(error.family(), "Degenerate");
        assert!(error.to_string().contains("3 edges of one triangle, one from ("), "{error}");
    }
    assert!(mesh_area(&[opened]).unwrap().value > 0.0);
    assert_eq!(mesh_area(&[]).unwrap_err().family(), "Shape");
    assert_eq!(mesh_box(&[Mesh::empty()]).unwrap_err().family(), "Shape");
    assert_eq!(mesh_volume(&[Mesh::empty()], false).unwrap().value, 0.0);
    assert_eq!(mesh_mass(&[Mesh::empty()], false).unwrap_err().family(), "Degenerate");
    let flat = Mesh::new(2, vec![0., 0., 1., 0., 0., 1.], vec![[0, 1, 2]]).unwrap();
    assert_eq!(mesh_area(std::slice::from_ref(&flat)).unwrap().value, 0.5);
    assert_eq!(mesh_volume(std::slice::from_ref(&flat), false).unwrap_err().family(), "Shape");
    assert_eq!(mesh_area(&[flat, mesh]).unwrap_err().family(), "Shape");
    let huge = skew(0.0, 1e150);
    assert_eq!(mesh_volume(&[meshed(&huge)], false).unwrap_err().family(), "Domain");
}
