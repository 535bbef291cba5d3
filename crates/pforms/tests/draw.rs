//! `pforms draw` and `pforms convert`, as a person runs them.
#![allow(clippy::unwrap_used)]

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const TEAPOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/models/newell-teapot32.bpt");
const OCTANT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/sheets/octant.pfs");

/// A folder of its own for each test.
fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Exit code and complaints.
fn pforms(folder: &Path, arguments: &[&str], input: &str) -> (i32, String) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_pforms"))
        .current_dir(folder)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    let output = child.wait_with_output().unwrap();
    assert!(output.stdout.is_empty());
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}

fn done(folder: &Path, arguments: &[&str], input: &str) {
    assert_eq!(pforms(folder, arguments, input), (0, String::new()), "{arguments:?}");
}

fn fails(folder: &Path, arguments: &[&str], input: &str) -> String {
    let (code, complaint) = pforms(folder, arguments, input);
    assert_eq!(code, 1, "{arguments:?}: {complaint}");
    complaint
}

#[test]
fn a_sheet_goes_into_every_drawing() {
    let folder = folder("sheet");
    for (name, start) in [
        ("o.glb", "glTF"),
        ("o.obj", "# pforms\nmtllib o.mtl\n"),
        ("o.stl", "pforms"),
        ("o.pov", "// pforms"),
    ] {
        done(&folder, &["draw", OCTANT, "-o", name], "");
        let bytes = std::fs::read(folder.join(name)).unwrap();
        assert!(bytes.starts_with(start.as_bytes()), "{name}");
        assert!(bytes.len() > 10_000, "{name}");
    }
    assert!(std::fs::read_to_string(folder.join("o.mtl")).unwrap().contains("newmtl A4"));
}

#[test]
fn a_sheet_gives_its_forms_exactly() {
    let folder = folder("forms");
    done(&folder, &["draw", OCTANT, "-o", "o.json", "--cell", "A4", "--cell", "viviani"], "");
    let text = std::fs::read(folder.join("o.json")).unwrap();
    let forms = pforms::formats::read("o.json", &text).unwrap();
    let kinds: Vec<String> = forms.iter().map(|named| named.net().kind().to_string()).collect();
    assert_eq!(kinds, ["pS33", "pL5"]);
    assert_eq!(forms[0].name.as_deref(), Some("A4"));
    let complaint = fails(&folder, &["draw", OCTANT, "-o", "o.bpt"], "");
    assert!(complaint.contains("octant.pfs") || complaint.contains(".bpt"), "{complaint}");
}

#[test]
fn the_teapot_travels_and_comes_back() {
    let folder = folder("teapot");
    done(&folder, &["convert", TEAPOT, "pot.json"], "");
    done(&folder, &["convert", "pot.json", "pot.bpt"], "");
    done(&folder, &["convert", "pot.bpt", "again.json"], "");
    let read = |name: &str| std::fs::read(folder.join(name)).unwrap();
    assert_eq!(read("pot.json"), read("again.json"));
    let length = |name: &str| read(name).len();
    done(&folder, &["draw", TEAPOT, "-o", "fine.stl", "--tolerance", "0.005"], "");
    done(&folder, &["draw", TEAPOT, "-o", "rough.stl", "--fineness", "1"], "");
    assert!(length("fine.stl") > 4 * length("rough.stl"));
    // Four triangles a side of a patch, less those that the bottom shrinks to nothing.
    assert_eq!(length("rough.stl"), 84 + 50 * (32 * 8 - 4 * 2));
    done(&folder, &["convert", TEAPOT, "pot.pov"], "");
    assert!(String::from_utf8(read("pot.pov")).unwrap().contains("bicubic_patch"));
}

#[test]
fn options_go_before_what_the_sheet_says() {
    let folder = folder("options");
    let sheet = "pfs = 1\n[cells]\nA1 = \"[(0,0),(1,2),(2,0)]\"\n[show.A1]\nradius = 0.5\n";
    let arguments = [
        "draw",
        "-",
        "-o",
        "a.pov",
        "--color",
        "#ff0000",
        "--view",
        "oz",
        "--draw",
        "poles",
        "--opacity",
        "0.5",
        "--zoom",
        "0.25",
        "--no-axes",
    ];
    done(&folder, &arguments, sheet);
    let text = std::fs::read_to_string(folder.join("a.pov")).unwrap();
    assert_eq!(text.matches("sphere {").count(), 3);
    for part in [", 0.5 }", "<1.0000, 0.0000, 0.0000, 0.5000>", "orthographic", "x*4.0*"] {
        assert!(text.contains(part), "{part} is missing in {text}");
    }
    assert!(!text.contains("cylinder"));
}

#[test]
fn complaints_name_the_file_the_cell_and_the_place() {
    let folder = folder("complaints");
    let sheet =
        |show: &str| format!("pfs = 1\n[cells]\nA1 = \"=1/0\"\nA2 = \"[(0,0),(1,1)]\"\n{show}");
    let draw = ["draw", "-", "-o", "x.glb"];
    for (input, parts) in [
        (sheet("[show.A1]\n"), ["-: A1: ", "0"]),
        (sheet("[show.A2]\ncolour = \"red\"\n"), ["-: A2: ", "`colour`"]),
        (sheet("[show.A2]\ndraw = [\"envelope\"]\n"), ["A2: draw: ", "curve"]),
        (sheet("[camera]\nangle = 1\n[show.A2]\n"), ["camera", "`angle`"]),
        (sheet(""), ["nothing is shown", "--cell"]),
        ("pfs = 1\n[cells\n".to_owned(), ["-, line 2", "column"]),
        ("{\"pforms\": 1, \"forms\": [3]}".to_owned(), ["-, line 1, column", "3"]),
        ("1\n3 3\n0 0 zero\n".to_owned(), ["-, line 2, column", "too short"]),
    ] {
        let complaint = fails(&folder, &draw, &input);
        for part in parts {
            assert!(complaint.contains(part), "{complaint:?} lacks {part:?}");
        }
    }
    assert!(!folder.join("x.glb").exists(), "nothing is written after a complaint");
    let missing = fails(&folder, &["draw", "nowhere.bpt", "-o", "x.glb"], "");
    assert!(missing.contains("nowhere.bpt"), "{missing}");
    let ending = fails(&folder, &["convert", TEAPOT, "x.docx"], "");
    assert!(ending.contains(".glb") && ending.contains(".json"), "{ending}");
    let folderless = fails(&folder, &["convert", TEAPOT, "no/such/x.stl"], "");
    assert!(folderless.contains("no/such/x.stl"), "{folderless}");
    let unknown = fails(&folder, &["draw", TEAPOT, "-o", "x.glb", "--cell", "lid"], "");
    assert!(unknown.contains("lid"), "{unknown}");
}

#[test]
fn every_sheet_of_the_gallery_can_be_drawn() {
    let folder = folder("gallery");
    let gallery = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/sheets");
    let mut drawn = 0;
    for entry in std::fs::read_dir(gallery).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|ending| ending == "pfs") {
            let file = path.display().to_string();
            done(&folder, &["draw", &file, "-o", "figure.glb"], "");
            drawn += 1;
        }
    }
    assert!(drawn > 20);
}
