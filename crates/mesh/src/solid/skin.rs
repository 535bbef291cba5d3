//! Triangles on their way to a shell, each with how far the surface it stands for strays from it.

use crate::Triangles;
use crate::adaptive::Stray;
use crate::vector::{Vec3, norm, subtract};
use crate::weld::{at_one_place, joined};

/// Vertices, triangles, and a stray for each triangle.
#[derive(Default)]
pub(super) struct Skin {
    pub(super) places: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) strays: Vec<Stray>,
    /// No point was moved farther than this.
    pub(super) moved: f64,
}

impl Skin {
    /// The meshes together, with one vertex at each place.
    pub(super) fn of(meshes: Vec<(Triangles, Vec<Stray>)>) -> Self {
        let mut skin = Self::default();
        for (mesh, strays) in meshes {
            let shift = skin.places.len() as u32;
            skin.places.extend(mesh.positions);
            skin.triangles.extend(mesh.indices.iter().map(|corners| corners.map(|k| k + shift)));
            skin.strays.extend(strays);
        }
        skin.join(&at_one_place(&skin.places));
        skin
    }

    /// Replaces every vertex by the one `same` names, and leaves out triangles that were lines.
    pub(super) fn join(&mut self, same: &[u32]) {
        let mut farthest = 0.0_f64;
        for (corners, stray) in self.triangles.iter().zip(&mut self.strays) {
            let way = |vertex: u32| {
                let other = same[vertex as usize];
                if other == vertex {
                    return 0.0;
                }
                norm(subtract(self.places[other as usize], self.places[vertex as usize]))
            };
            let moved = corners.map(way).into_iter().fold(0.0, f64::max);
            if moved > 0.0 {
                *stray = stray.moved(moved);
                farthest = farthest.max(moved);
            }
        }
        self.moved += farthest;
        let (places, triangles, kept) = joined(&self.places, &self.triangles, same);
        self.strays = kept.into_iter().map(|number| self.strays[number]).collect();
        (self.places, self.triangles) = (places, triangles);
    }
}
