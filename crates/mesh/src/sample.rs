//! Points and unit normals of a surface in space.

use std::ops::Range;

use pforms_kernel::{Error, Form, Result};
use pforms_operators::{normal_grid_into, normals_into};

use crate::apex::apex_normals;
use crate::normal::Surface;
use crate::vector::Vec3;

/// Points and unit normals, one after the other.
pub(crate) struct Sample {
    pub(crate) positions: Vec<Vec3>,
    /// None if they were not asked for.
    pub(crate) normals: Vec<Vec3>,
}

/// A surface in space, and which of its edges `u = 0`, `u = 1`, `v = 0`, `v = 1` are single points.
#[derive(Clone, Copy)]
pub(crate) struct Sampled<'a> {
    pub(crate) form: &'a Form,
    pub(crate) collapsed: [bool; 4],
}

impl Sampled<'_> {
    /// Samples on the grid `us × vs`, in C order.
    pub(crate) fn grid(self, us: &[f64], vs: &[f64], normals: bool) -> Result<Sample> {
        let mut positions = vec![[0.0; 3]; us.len() * vs.len()];
        self.form.grid_into(&[us, vs], positions.as_flattened_mut())?;
        if !normals {
            return Ok(Sample { positions, normals: Vec::new() });
        }
        let mut normals = vec![[0.0; 3]; positions.len()];
        match self.grid_normals(us, vs, &mut normals) {
            Err(Error::Degenerate(_)) => {
                let at: Vec<[f64; 2]> =
                    us.iter().flat_map(|u| vs.iter().map(|v| [*u, *v])).collect();
                normals = Surface::new(self.form)?.normals(&at)?;
            }
            done => done?,
        }
        Ok(Sample { positions, normals })
    }

    /// Normals on a grid, those of collapsed edges by themselves.
    fn grid_normals(self, us: &[f64], vs: &[f64], out: &mut [Vec3]) -> Result<()> {
        let (rows, columns) = (self.inside(0, us), self.inside(1, vs));
        let width = vs.len();
        let inner = [&us[rows.clone()], &vs[columns.clone()]];
        if columns.len() == width {
            let part = &mut out[rows.start * width..rows.end * width];
            normal_grid_into(self.form, &inner, part.as_flattened_mut())?;
        } else {
            let mut part = vec![[0.0; 3]; rows.len() * columns.len()];
            normal_grid_into(self.form, &inner, part.as_flattened_mut())?;
            let lines = part.chunks_exact(columns.len().max(1));
            for (to, from) in out.chunks_exact_mut(width).skip(rows.start).zip(lines) {
                to[columns.clone()].copy_from_slice(from);
            }
        }
        for i in (0..us.len()).filter(|i| !rows.contains(i)) {
            let side = usize::from(us[i] != 0.0);
            apex_normals(self.form, side, vs, &mut out[i * width..][..width])?;
        }
        for j in (0..width).filter(|j| !columns.contains(j)) {
            let mut line = vec![[0.0; 3]; rows.len()];
            apex_normals(self.form, 2 + usize::from(vs[j] != 0.0), inner[0], &mut line)?;
            for (i, normal) in rows.clone().zip(line) {
                out[i * width + j] = normal;
            }
        }
        Ok(())
    }

    /// The parameters along an axis that do not belong to a collapsed edge.
    fn inside(self, axis: usize, list: &[f64]) -> Range<usize> {
        let first = self.collapsed[2 * axis] && list.first() == Some(&0.0);
        let last = self.collapsed[2 * axis + 1] && list.last() == Some(&1.0);
        let start = usize::from(first);
        start..(list.len() - usize::from(last)).max(start)
    }

    /// Unit normals at scattered parameters.
    pub(crate) fn normals_at(self, parameters: &[[f64; 2]]) -> Result<Vec<Vec3>> {
        match self.scattered_normals(parameters) {
            // A surface that is a line or a point somewhere still gets directions, any across it.
            Err(Error::Degenerate(_)) => Surface::new(self.form)?.normals(parameters),
            done => done,
        }
    }

    fn scattered_normals(self, parameters: &[[f64; 2]]) -> Result<Vec<Vec3>> {
        let [us, vs]: [Vec<f64>; 2] =
            [0, 1].map(|axis: usize| parameters.iter().map(|at| at[axis]).collect());
        let mut normals = vec![[0.0; 3]; parameters.len()];
        if !self.collapsed.contains(&true) {
            normals_into(self.form, &[&us, &vs], normals.as_flattened_mut())?;
            return Ok(normals);
        }
        let side = |at: &[f64; 2]| {
            (0..4).find(|&side| self.collapsed[side] && at[side / 2] == (side % 2) as f64)
        };
        let regular = |k: &usize| side(&parameters[*k]).is_none();
        let inner: Vec<usize> = (0..parameters.len()).filter(regular).collect();
        let lists = [&us, &vs].map(|list| inner.iter().map(|k| list[*k]).collect::<Vec<f64>>());
        let mut values = vec![[0.0; 3]; inner.len()];
        normals_into(self.form, &[&lists[0], &lists[1]], values.as_flattened_mut())?;
        for (k, value) in inner.into_iter().zip(values) {
            normals[k] = value;
        }
        for (at, normal) in parameters.iter().zip(&mut normals) {
            if let Some(side) = side(at) {
                let along = [at[1 - side / 2]];
                apex_normals(self.form, side, &along, std::slice::from_mut(normal))?;
            }
        }
        Ok(normals)
    }
}
