//! Union, difference and common part of closed meshes, by Manifold (E. Lalish; the port of
//! L. Brubaker): exact decisions, so that the result is closed whatever came in.

use manifold_rust::cancel::CancelToken;
use manifold_rust::manifold::Manifold;
use manifold_rust::types::{BooleanEngine, Error as Fault, MeshGL64, OpType, WindingRule};
use pforms_kernel::{Error, Result, stopping};

use super::Shell;
use super::bound::{corners, size};
use crate::Mesh;
use crate::vector::Vec3;

/// What is to be done with solids.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// Everything that is in one of them.
    Union,
    /// What is in the first and in none of the others.
    Difference,
    /// What is in all of them.
    Common,
}

/// Faces nearer than this share of the size may be taken for one.
const MERGED: f64 = 1e-11;

/// Combines solids, each made of shells; returns how far a point may have been moved, too.
pub(super) fn combined(operation: Operation, solids: &[Vec<Shell>]) -> Result<(Mesh, f64)> {
    let unit = Unit::of(solids);
    let mut bodies = Vec::with_capacity(solids.len());
    for shells in solids {
        let mut body = Manifold::empty();
        for shell in shells {
            body = apply(&body, &unit.body(shell)?, OpType::Add)?;
        }
        bodies.push(body);
    }
    let step = match operation {
        Operation::Union => OpType::Add,
        Operation::Difference => OpType::Subtract,
        Operation::Common => OpType::Intersect,
    };
    let mut bodies = bodies.into_iter();
    let mut result = bodies.next().unwrap_or_else(Manifold::empty);
    for body in bodies {
        result = apply(&result, &body, step)?;
    }
    let merged = MERGED * solids.iter().flatten().map(|shell| size(&shell.places)).sum::<f64>();
    Ok((unit.mesh(&result)?, merged))
}

fn apply(first: &Manifold, second: &Manifold, step: OpType) -> Result<Manifold> {
    // Nothing, as the library has it, would be a solid of its own: these three are quicker said.
    match step {
        OpType::Add if first.is_empty() => return Ok(second.clone()),
        OpType::Add | OpType::Subtract if second.is_empty() => return Ok(first.clone()),
        _ if first.is_empty() || second.is_empty() => return Ok(Manifold::empty()),
        _ => {}
    }
    stoppable(|token| {
        first.boolean_with_engine_and_token(second, step, BooleanEngine::Auto, Some(token))
    })
}

/// Work of the library, which knows a token by which it can be stopped.
fn stoppable(work: impl Fn(&CancelToken) -> Manifold + Sync) -> Result<Manifold> {
    let token = CancelToken::new();
    checked(stopping::beside(|| work(&token), || token.cancel()))
}

fn checked(body: Manifold) -> Result<Manifold> {
    match body.status() {
        Fault::NoError => Ok(body),
        Fault::Cancelled => Err(Error::Stopped),
        Fault::ResultTooLarge => Err(Error::Limit {
            what: "the combined solid".to_owned(),
            bytes: 1 << 32,
            cap: 1 << 31,
        }),
        fault => Err(Error::degenerate("solids", format!("{fault:?}"), "closed shells")),
    }
}

/// The place and the power of two that make all solids about as large as 1: the library measures
/// what is near in units of the largest coordinate, and squares it.
struct Unit {
    centre: Vec3,
    factor: f64,
}

impl Unit {
    fn of(solids: &[Vec<Shell>]) -> Self {
        let places: Vec<Vec3> = solids
            .iter()
            .flatten()
            .filter(|shell| !shell.places.is_empty())
            .flat_map(|shell| <[Vec3; 2]>::from(corners(&shell.places)))
            .collect();
        if places.is_empty() {
            return Self { centre: [0.0; 3], factor: 1.0 };
        }
        let (low, high) = corners(&places);
        let extent = (0..3).map(|k| high[k] / 2.0 - low[k] / 2.0).fold(0.0, f64::max);
        let farthest = low.iter().chain(&high).fold(0.0_f64, |most, x| most.max(x.abs()));
        // Near the origin nothing is moved, so that nothing is rounded.
        let far = farthest > 8.0 * extent;
        let middle = [0, 1, 2].map(|k| low[k] / 2.0 + high[k] / 2.0);
        let exponent = libm::frexp(extent.max(f64::MIN_POSITIVE)).1.clamp(-1000, 1000);
        let factor = libm::ldexp(1.0, -exponent);
        Self { centre: if far { middle } else { [0.0; 3] }, factor }
    }

    /// The body of a shell; where it is wound more than once, or crosses itself, the solid of that.
    fn body(&self, shell: &Shell) -> Result<Manifold> {
        stopping::check()?;
        let scaled = |(k, x): (usize, &f64)| (x - self.centre[k % 3]) * self.factor;
        let coordinates = shell.places.as_flattened().iter().enumerate();
        let body = Manifold::from_mesh_gl64_robust(&MeshGL64 {
            num_prop: 3,
            vert_properties: coordinates.map(scaled).collect(),
            tri_verts: shell.triangles.as_flattened().iter().map(|k| u64::from(*k)).collect(),
            ..MeshGL64::default()
        });
        let body = checked(body)?;
        if !stopping::beside(|| body.has_self_intersections(), || ()) {
            return Ok(body);
        }
        stoppable(|token| body.rebuild_solid_with_token(WindingRule::Positive, Some(token)))
    }

    fn mesh(&self, body: &Manifold) -> Result<Mesh> {
        if body.is_empty() {
            return Ok(Mesh::empty());
        }
        let made = body.get_mesh_gl64(-1);
        let width = made.num_prop as usize;
        let back = |(k, x): (usize, &f64)| x / self.factor + self.centre[k];
        let places = made.vert_properties.chunks_exact(width.max(3));
        let places: Vec<f64> =
            places.flat_map(|one| one[..3].iter().enumerate().map(back)).collect();
        let triangles = made.tri_verts.as_chunks::<3>().0.iter();
        Mesh::new(3, places, triangles.map(|corners| corners.map(|k| k as u32)).collect())
    }
}
