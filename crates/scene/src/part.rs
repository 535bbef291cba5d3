//! What a drawn value consists of, and the same as buffers for a graphics card.

use pforms_mesh::vector::Vec3;
use pforms_mesh::{Polyline, Triangles};

use crate::Bounds;

/// A part of a drawn value, in the coordinates of the sheet and in full precision.
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    /// Points as spheres.
    Points {
        /// The centres.
        positions: Vec<Vec3>,
        /// Radius of each.
        radius: f64,
    },
    /// Lines as round tubes.
    Lines {
        /// The lines.
        polylines: Vec<Polyline>,
        /// Radius of each.
        radius: f64,
    },
    /// Triangles with unit normals.
    Triangles(Triangles),
}

/// A part for a graphics card; arrays of three numbers or three indices each, laid flat.
#[derive(Clone, Debug, PartialEq)]
pub enum Buffers {
    /// Points as spheres.
    Points {
        /// The centres.
        positions: Vec<f32>,
        /// Radius of each.
        radius: f64,
    },
    /// Lines as round tubes.
    Lines {
        /// All points, line after line.
        positions: Vec<f32>,
        /// The first point of each line, then the number of points.
        starts: Vec<u32>,
        /// Radius of each.
        radius: f64,
    },
    /// Triangles.
    Triangles {
        /// The vertices.
        positions: Vec<f32>,
        /// Their unit normals.
        normals: Vec<f32>,
        /// Three vertices for each triangle.
        indices: Vec<u32>,
    },
}

impl Part {
    /// The box round the part.
    pub fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::default();
        match self {
            Self::Points { positions, radius } => {
                for point in positions {
                    bounds.add(point, *radius);
                }
            }
            Self::Lines { polylines, radius } => {
                for point in polylines.iter().flat_map(|line| &line.points) {
                    bounds.add(point, *radius);
                }
            }
            Self::Triangles(mesh) => bounds = Bounds::of(&mesh.positions),
        }
        bounds
    }

    /// The part in single precision; indices are taken over, not copied.
    pub fn into_buffers(self) -> Buffers {
        match self {
            Self::Points { positions, radius } => {
                Buffers::Points { positions: flat(&positions), radius }
            }
            Self::Lines { polylines, radius } => {
                let mut starts = vec![0];
                let mut count = 0;
                let mut positions = Vec::new();
                for line in &polylines {
                    positions.extend(flat(&line.points));
                    count += line.points.len() as u32;
                    starts.push(count);
                }
                Buffers::Lines { positions, starts, radius }
            }
            Self::Triangles(mesh) => Buffers::Triangles {
                positions: flat(&mesh.positions),
                normals: flat(&mesh.normals),
                indices: mesh.indices.into_flattened(),
            },
        }
    }
}

fn flat(points: &[Vec3]) -> Vec<f32> {
    points.as_flattened().iter().map(|x| *x as f32).collect()
}
