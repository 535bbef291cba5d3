//! NURBS meshes of MFEM, as that library and splinepy write them.
//!
//! Either every patch lists its own poles, or the mesh numbers its poles once: first the vertices,
//! then those inside the edges, the faces and the patches, so that neighbours share them.

use super::mfem_elements::Numbering;
use super::mfem_mesh::{Mesh, Words};
use super::{Patch, last_fastest, pole};

/// The patches of the mesh, in order.
pub fn read(text: &str) -> Vec<Patch> {
    let mesh = Mesh::read(text);
    match &mesh.patches {
        Some(words) => listed(words.clone(), mesh.elements.len()),
        None => numbered(&mesh),
    }
}

/// Patches that list their poles, the first parameter fastest.
fn listed(words: Vec<String>, count: usize) -> Vec<Patch> {
    let mut words = Words::new(words);
    (0..count).map(|index| listed_patch(index, &mut words)).collect()
}

fn listed_patch(index: usize, words: &mut Words) -> Patch {
    assert_eq!(words.next().as_deref(), Some("knotvectors"));
    let (degrees, knots): (Vec<usize>, Vec<Vec<f64>>) = words.knots().into_iter().unzip();
    assert_eq!(words.next().as_deref(), Some("dimension"));
    let ambient = words.whole();
    // The plain word is MFEM's for poles with their weight multiplied in.
    let multiplied = match words.next().as_deref() {
        Some("controlpoints" | "controlpoints_homogeneous") => true,
        Some("controlpoints_cartesian") => false,
        other => panic!("poles called {other:?}"),
    };
    let list = words.numbers();
    let rows = list.chunks(ambient + 1);
    let poles: Vec<Vec<f64>> = rows
        .map(|row| if multiplied { row.to_vec() } else { pole(&row[..ambient], row[ambient]) })
        .collect();
    let orders: Vec<usize> = knots.iter().zip(&degrees).map(|(k, d)| k.len() - d - 1).collect();
    Patch::new(index.to_string(), &degrees, knots, &last_fastest(&orders, &poles))
}

/// Patches whose poles are numbered across the mesh.
fn numbered(mesh: &Mesh) -> Vec<Patch> {
    let numbering = Numbering::new(mesh);
    assert_eq!(numbering.count(), mesh.points.len(), "as many points as the numbering has");
    assert_eq!(numbering.count(), mesh.weights.len(), "as many weights as the numbering has");
    let patch = |index: usize| {
        let axes = numbering.axes(index);
        let (degrees, knots): (Vec<usize>, Vec<Vec<f64>>) =
            axes.iter().map(|axis| mesh.knots[*axis].clone()).unzip();
        let poles: Vec<Vec<f64>> = numbering
            .poles(index)
            .into_iter()
            .map(|number| pole(&mesh.points[number], mesh.weights[number]))
            .collect();
        Patch::new(index.to_string(), &degrees, knots, &poles)
    };
    (0..mesh.elements.len()).map(patch).collect()
}
