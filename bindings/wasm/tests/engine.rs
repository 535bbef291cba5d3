//! What a page does with the engine, without a page.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use pforms_catalogue::Language;
use pforms_wasm::{Drawing, Engine, Gesture, Piece, Problem, Update};

const OCTANT: &str = include_str!("../../../cases/sheets/octant.pfs");

fn octant() -> Engine {
    let mut engine = Engine::new();
    let update = engine.open(OCTANT).unwrap();
    assert!(update.whole && update.undrawn.is_empty(), "{:?}", update.undrawn);
    engine
}

fn set(engine: &mut Engine, address: &str, text: &str) -> Update {
    engine.set(&[(address.to_owned(), text.to_owned())]).unwrap()
}

fn addresses(update: &Update) -> Vec<&str> {
    update.cells.iter().map(|cell| cell.info.address.as_str()).collect()
}

#[test]
fn the_octant_opens_with_cells_poles_drawings_notes_and_camera() {
    let mut engine = Engine::new();
    let update = engine.open(OCTANT).unwrap();
    assert_eq!(addresses(&update), ["A1", "A2", "A3", "A4", "A5"]);
    assert_eq!(update.cells[3].info.kind, "pS33");
    assert_eq!(update.cells[3].info.reads, ["A1", "A2", "A3"]);
    assert_eq!(update.cells[3].info.name.as_deref(), Some("octant"));
    assert_eq!(update.cells[3].style.as_ref().unwrap()["shading"], "smooth");
    assert_eq!(update.poles.len(), 3);
    assert_eq!(update.poles[0].poles[1].weight, "sqrt(2)/2");
    assert_eq!(update.drawings.len(), 5);
    assert!(update.camera.is_some() && !update.notes.unwrap().is_empty());
}

#[test]
fn a_drag_writes_the_cell_moves_what_depends_on_it_and_is_one_step() {
    let mut engine = octant();
    let before = engine.save();
    let mut drag =
        |to: [f64; 3], gesture| engine.move_pole("A1", &[0], &to, 0.01, gesture).unwrap();
    drag([0.0, 0.0, 1.0], Gesture::Begin);
    let update = drag([0.123_4, 0.000_3, 1.0], Gesture::During);
    assert_eq!(addresses(&update), ["A1", "A4", "A5"]);
    assert_eq!(update.drawings.len(), 3);
    let update = drag([0.25, 0.5, 1.0], Gesture::During);
    assert!(
        drag([0.254_9, 0.5, 1.0], Gesture::End).cells.is_empty(),
        "less than a step of the grid"
    );
    let source = &update.cells.first().unwrap().info.source;
    assert!(source.starts_with("[(0.25, 0.5, 1), (0, 1, 1; sqrt(2)/2)"), "{source}");
    let update = engine.undo();
    assert_eq!(addresses(&update), ["A1", "A4", "A5"]);
    assert!(!update.can_undo && update.can_redo);
    assert_eq!(engine.save(), before);
}

/// The index lists of a drawing's meshes.
fn triangles(drawing: &Drawing) -> Vec<Option<usize>> {
    let pieces = drawing.shape.as_deref().unwrap();
    let meshes = pieces.iter().filter_map(|piece| match piece {
        Piece::Mesh { indices, .. } => Some(indices.as_ref().map(Vec::len)),
        Piece::Balls { .. } => None,
    });
    meshes.collect()
}

#[test]
fn a_frame_of_a_drag_is_what_depends_on_the_pole_and_nothing_else() {
    let mut engine = octant();
    set(&mut engine, "B1", "=POINT(A4, 1/2, 1/2)");
    set(&mut engine, "C1", "[(5, 0, 0), (6, 0, 0)]");
    engine.set_name("C1", Some("apart")).unwrap();
    let mut drag =
        |to: [f64; 3], gesture| engine.move_pole("A1", &[0], &to, 0.01, gesture).unwrap();
    drag([0.0, 0.0, 1.0], Gesture::Begin);
    for step in 1..5 {
        let update = drag([0.01 * f64::from(step), 0.0, 1.0], Gesture::During);
        assert_eq!(addresses(&update), ["A1", "A4", "A5", "B1"]);
        let drawn: Vec<&str> = update.drawings.iter().map(|one| one.address.as_str()).collect();
        assert_eq!(drawn, ["A1", "A4", "A5"], "B1 is not shown, C1 has not changed");
        let held: Vec<&str> = update.poles.iter().map(|net| net.address.as_str()).collect();
        assert_eq!(held, ["A1"]);
        assert!(update.notes.is_none() && update.camera.is_none() && !update.whole);
    }
    drag([0.04, 0.0, 1.0], Gesture::End);
    assert_eq!(addresses(&engine.undo()), ["A1", "A4", "A5", "B1"]);
    assert_eq!(engine.redo().cells.len(), 4, "all frames are one step");
}

#[test]
fn triangles_that_stay_are_not_sent_again() {
    let mut engine = Engine::new();
    let net = "[[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]]";
    set(&mut engine, "A1", net);
    let style = serde_json::json!({ "draw": ["surface"], "fineness": 2 });
    let first = engine.set_style("A1", style.as_object().cloned()).unwrap();
    assert_eq!(triangles(&first.drawings[0]), [Some(96)]);
    let mut drag = |z, gesture| {
        let update = engine.move_pole("A1", &[0, 0], &[0.0, 0.0, z], 0.0, gesture).unwrap();
        triangles(&update.drawings[0])
    };
    drag(-0.1, Gesture::Begin);
    assert_eq!(drag(-0.2, Gesture::During), [None], "bent the same way");
    assert_eq!(drag(0.3, Gesture::End).len(), 1);
    let finer = serde_json::json!({ "draw": ["surface"], "fineness": 3 });
    let finer = engine.set_style("A1", finer.as_object().cloned()).unwrap();
    assert_eq!(triangles(&finer.drawings[0]), [Some(384)]);
    engine.set_style("A1", None).unwrap();
    let again = engine.set_style("A1", style.as_object().cloned()).unwrap();
    assert_eq!(triangles(&again.drawings[0]), [Some(96)], "the page has forgotten them");
    let whole = engine.set_language(Language::French);
    assert_eq!(triangles(&whole.drawings[0]), [Some(96)]);
}

#[test]
fn a_colour_travels_without_the_shape() {
    let mut engine = octant();
    let mut styled = |table: serde_json::Value| {
        let update = engine.set_style("A5", table.as_object().cloned()).unwrap();
        update.drawings.into_iter().next().unwrap()
    };
    let thick =
        |color, radius| serde_json::json!({ "draw": ["curve"], "color": color, "radius": radius });
    assert!(styled(thick("#112233", 0.03)).shape.is_some());
    let red = styled(thick("#ff0000", 0.03));
    assert_eq!((red.shape, red.color), (None, [1.0, 0.0, 0.0]));
    assert!(styled(thick("#ff0000", 0.02)).shape.is_some(), "another radius is another tube");
    let update = engine.move_pole("A1", &[0], &[0.2, 0.0, 1.0], 0.0, Gesture::End).unwrap();
    assert!(update.drawings.iter().all(|drawing| drawing.shape.is_some()));
}

#[test]
fn a_style_changes_the_drawing_and_nothing_else() {
    let mut engine = octant();
    let style = serde_json::json!({ "draw": ["points"], "color": "#112233", "fineness": 2 });
    let update = engine.set_style("A4", style.as_object().cloned()).unwrap();
    assert_eq!((addresses(&update), update.drawings.len()), (vec!["A4"], 1));
    let update = engine.set_style("A4", None).unwrap();
    assert_eq!(update.hidden, ["A4"]);
    let wrong = serde_json::json!({ "draw": ["velvet"] });
    assert!(engine.set_style("A4", wrong.as_object().cloned()).is_err());
    let unsuited = serde_json::json!({ "draw": ["envelope"] });
    let update = engine.set_style("A4", unsuited.as_object().cloned()).unwrap();
    assert_eq!(update.undrawn[0].address, "A4");
}

#[test]
fn a_snapshot_keeps_the_history() {
    let mut engine = octant();
    set(&mut engine, "B1", "1");
    set(&mut engine, "B1", "2");
    let snapshot = engine.snapshot().unwrap();
    let mut again = Engine::new();
    assert!(again.resume(&snapshot).unwrap().can_undo);
    let update = again.undo();
    assert_eq!(update.cells[0].info.text, "1");
    assert!(again.resume("{").is_err() && again.resume("{}").is_err());
    assert_eq!(again.redo().cells[0].info.text, "2");
}

#[test]
fn looking_round_is_kept_but_is_no_step() {
    let mut engine = octant();
    let camera = serde_json::json!({ "view": "AXO", "zoom": 0.5 });
    engine.set_camera(camera.as_object().cloned().unwrap()).unwrap();
    assert!(!engine.proceed().can_undo);
    assert!(engine.save().contains("zoom = 0.5"));
    let kept = engine.snapshot().unwrap();
    assert_eq!(Engine::new().resume(&kept).unwrap().camera.unwrap()["view"], "AXO");
    let wrong = serde_json::json!({ "view": "SIDEWAYS" });
    assert!(engine.set_camera(wrong.as_object().cloned().unwrap()).is_err());
}

#[test]
fn french_is_written_and_read_with_commas() {
    let mut engine = Engine::new();
    engine.set_language(Language::French);
    let update = set(&mut engine, "A1", "1,5");
    assert_eq!(
        (update.cells[0].info.text.as_str(), update.cells[0].info.kind.as_str()),
        ("1,5", "nombre")
    );
    let update = set(&mut engine, "A2", "=MILIEU((0; 0,5); (1; A1))");
    assert_eq!(update.cells[0].info.text, "(0,5; 1)");
    let update = engine.set_language(Language::English);
    assert_eq!(update.cells[1].info.source, "=MILIEU((0, 0.5), (1, A1))");
    assert_eq!(update.cells[1].info.text, "(0.5, 1)");
}

#[test]
fn errors_have_a_place_in_the_text_the_person_sees() {
    let mut engine = Engine::new();
    let update = set(&mut engine, "A1", "=\"é😀\" + DIAGG(1)");
    let error = update.cells[0].info.error.as_ref().unwrap();
    assert_eq!((error.from, error.to, error.origin.as_deref()), (Some(9), Some(14), None));
    let update = set(&mut engine, "A2", "=A1");
    let error = update.cells[0].info.error.as_ref().unwrap();
    assert_eq!((error.from, error.origin.as_deref()), (None, Some("A1")));
}

#[test]
fn cells_are_named_pasted_filled_and_emptied() {
    let mut engine = Engine::new();
    set(&mut engine, "A1", "2");
    engine.set_name("A1", Some("two")).unwrap();
    set(&mut engine, "B1", "=two*A1");
    engine.set_name("A1", Some("deux")).unwrap();
    assert!(engine.save().contains("=deux*A1"));
    let update = engine.fill("B1", "B1:B3").unwrap();
    assert_eq!(addresses(&update), ["B2", "B3"]);
    assert!(engine.save().contains("=deux*A3"));
    let update = set(&mut engine, "B2", "");
    assert_eq!(update.removed, ["B2"]);
    assert!(engine.set_name("A1", Some("not a name")).is_err());
}

#[test]
fn refusals_change_nothing() {
    let mut engine = octant();
    let before = engine.save();
    let refusals: Vec<Problem> = [
        engine.open("pfs = 1\n[cells").map(drop),
        engine.set(&[("A0".into(), "1".into())]).map(drop),
        engine.set(&[("B1".into(), "1".into()), ("?".into(), "1".into())]).map(drop),
        engine.move_pole("A4", &[0, 0], &[0.0; 3], 0.1, Gesture::Begin).map(drop),
        engine.move_pole("A1", &[9], &[0.0; 3], 0.1, Gesture::End).map(drop),
        engine.move_pole("A1", &[0], &[f64::NAN; 3], 0.1, Gesture::During).map(drop),
        engine.type_pole("A1", &[0], &[]).map(drop),
        engine.import("x.json", b"{").map(drop),
        engine.export("dwg", "x").map(drop),
    ]
    .into_iter()
    .map(Result::unwrap_err)
    .collect();
    assert!(refusals.iter().all(|refusal| !refusal.message.is_empty() && !refusal.fatal));
    assert_eq!(engine.save(), before);
}
