//! GLB, OBJ and STL: read back by little readers of our own.
#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use std::collections::HashMap;

use common::{mixed_scene, teapot};
use pforms_formats::{FORMATS, Format, glb, obj, stl, write_forms, write_scene};
use pforms_scene::{Scene, Shapes, Style};
use pforms_testkit::whole_sphere;
use serde_json::Value;

fn sphere_scene() -> Scene {
    let mut scene = Scene::default();
    let style = Style { tolerance: Some(1e-3), ..Style::default() };
    scene.add("ball", &Shapes::of(whole_sphere()), style).unwrap();
    scene
}

fn u32_at(bytes: &[u8], at: usize) -> usize {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize
}

fn f32_at(bytes: &[u8], at: usize) -> f32 {
    f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())
}

/// The two chunks of a GLB file.
fn chunks(file: &[u8]) -> (Value, Vec<u8>) {
    assert_eq!(&file[..4], b"glTF");
    assert_eq!((u32_at(file, 4), u32_at(file, 8)), (2, file.len()));
    let length = u32_at(file, 12);
    assert_eq!((length % 4, &file[16..20]), (0, b"JSON".as_slice()));
    let document = serde_json::from_slice(&file[20..20 + length]).unwrap();
    let rest = &file[20 + length..];
    if rest.is_empty() {
        return (document, Vec::new());
    }
    assert_eq!((u32_at(rest, 0) + 8, &rest[4..8]), (rest.len(), b"BIN\0".as_slice()));
    (document, rest[8..].to_vec())
}

#[test]
fn every_accessor_of_a_glb_is_sound() {
    let (document, binary) = chunks(&glb::write(&mixed_scene()).unwrap());
    let names: Vec<&str> =
        document["nodes"].as_array().unwrap().iter().map(|n| n["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["cube", "bundle", "curve", "octant", "point"]);
    assert_eq!(document["materials"][0]["alphaMode"], "BLEND");
    assert!(document["materials"][2].get("alphaMode").is_none());
    assert_eq!(document["buffers"][0]["byteLength"], binary.len());
    let accessor = |index: &Value| {
        let accessor = &document["accessors"][index.as_u64().unwrap() as usize];
        let view = &document["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
        let start = view["byteOffset"].as_u64().unwrap() as usize;
        let length = view["byteLength"].as_u64().unwrap() as usize;
        assert_eq!(start % 4, 0);
        (accessor, binary[start..start + length].to_vec())
    };
    for mesh in document["meshes"].as_array().unwrap() {
        for primitive in mesh["primitives"].as_array().unwrap() {
            let (positions, bytes) = accessor(&primitive["attributes"]["POSITION"]);
            let count = positions["count"].as_u64().unwrap() as usize;
            assert_eq!(bytes.len(), count * 12);
            for k in 0..3 {
                let values = (0..count).map(|i| f64::from(f32_at(&bytes, 12 * i + 4 * k)));
                assert_eq!(positions["min"][k].as_f64(), values.clone().reduce(f64::min));
                assert_eq!(positions["max"][k].as_f64(), values.reduce(f64::max));
            }
            let (normals, bytes) = accessor(&primitive["attributes"]["NORMAL"]);
            assert_eq!(normals["count"], count);
            for i in 0..count {
                let square: f32 = (0..3).map(|k| f32_at(&bytes, 12 * i + 4 * k).powi(2)).sum();
                assert!((square - 1.0).abs() < 1e-5);
            }
            let (_, bytes) = accessor(&primitive["indices"]);
            assert!(bytes.chunks(4).all(|index| u32_at(index, 0) < count));
        }
    }
}

#[test]
fn an_empty_scene_is_still_a_file() {
    let empty = Scene::default();
    let (document, binary) = chunks(&glb::write(&empty).unwrap());
    assert!(binary.is_empty() && document.get("meshes").is_none());
    assert_eq!(stl::write(&empty).unwrap().len(), 84);
    for format in [Format::Obj, Format::Pov] {
        assert!(!write_scene(format, &empty).unwrap().is_empty());
    }
}

#[test]
fn the_ball_is_closed_in_stl() {
    let file = stl::write(&sphere_scene()).unwrap();
    let count = u32_at(&file, 80);
    assert_eq!(file.len(), 84 + 50 * count);
    assert!(!file.starts_with(b"solid"), "readers would take it for text");
    let mut edges: HashMap<[[u32; 3]; 2], i32> = HashMap::new();
    let mut volume = 0.0;
    for facet in file[84..].chunks_exact(50) {
        let corner = |i: usize| [0, 1, 2].map(|k| f32_at(facet, 12 + 12 * i + 4 * k));
        let [a, b, c] = [corner(0), corner(1), corner(2)];
        for pair in [[a, b], [b, c], [c, a]] {
            let mut edge = pair.map(|p| p.map(f32::to_bits));
            edge.sort_unstable();
            *edges.entry(edge).or_default() += 1;
        }
        volume += a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    assert!(edges.values().all(|&count| count == 2));
    // Half of the octants are mirrored, so half of the facets turn the other way.
    assert!(volume.abs() < 0.1, "{volume}");
}

#[test]
fn an_obj_names_its_groups_and_counts_from_one() {
    let scene = mixed_scene();
    let text = String::from_utf8(obj::write(&scene, Some("mixed.mtl")).unwrap()).unwrap();
    assert!(text.contains("mtllib mixed.mtl\n"));
    let vertices = text.lines().filter(|line| line.starts_with("v ")).count();
    let normals = text.lines().filter(|line| line.starts_with("vn ")).count();
    assert_eq!(vertices, normals);
    let mut used = vec![false; vertices + 1];
    for line in text.lines().filter(|line| line.starts_with("f ")) {
        for corner in line[2..].split(' ') {
            let (vertex, normal) = corner.split_once("//").unwrap();
            assert_eq!(vertex, normal);
            used[vertex.parse::<usize>().unwrap()] = true;
        }
    }
    assert!(!used[0]);
    for name in ["cube", "bundle", "curve", "octant", "point"] {
        assert!(text.contains(&format!("o {name}\ng {name}\nusemtl {name}\n")));
        let library = String::from_utf8(obj::materials(&scene)).unwrap();
        assert!(library.contains(&format!("newmtl {name}\n")));
    }
}

#[test]
fn coordinates_beyond_single_precision_are_refused() {
    let far = pforms_kernel::Form::from_points(&[2], 1, &[0.0, 1e39], None).unwrap();
    let mut scene = Scene::default();
    scene.add("far", &Shapes::of(vec![far]), Style::default()).unwrap();
    for format in [Format::Glb, Format::Stl] {
        assert_eq!(write_scene(format, &scene).unwrap_err().family(), "Domain");
    }
}

#[test]
fn the_teapot_goes_into_every_drawing() {
    let mut scene = Scene::default();
    scene.add("teapot", &Shapes::of(teapot()), Style::default()).unwrap();
    for format in FORMATS {
        if format.holds_forms() {
            assert_eq!(write_scene(format, &scene).unwrap_err().family(), "Format");
        } else {
            assert!(write_scene(format, &scene).unwrap().len() > 1000, "{format}");
            assert_eq!(write_forms(format, &[]).unwrap_err().family(), "Format");
        }
    }
}
