//! Patches to as few triangles as keep within a tolerance, proven, without cracks.
//!
//! Densities are guessed from the curvature, the patches laid out, every triangle is proven to lie
//! near enough or asks for more, and what has to change is laid out again.

mod bound;
mod curvature;
mod field;
mod layout;
mod net;

use std::collections::HashMap;

use pforms_kernel::{Error, Form, Result, stopping};

use crate::Triangles;
use crate::apex::collapsed;
use crate::edge::{Edge, Key};
use crate::pieces::require_finite;
use crate::require_room;
use crate::sample::Sampled;
use crate::space::{embed, quadruples, require_axes};
use crate::vector::Vec3;
pub(crate) use bound::Stray;
use field::{CELLS, Field, Profile, spread, total};
use layout::{Border, Draft, layout};
use net::Net;

/// Rounds after which densities grow everywhere, not only where a triangle asks for it.
const PATIENCE: usize = 8;

/// Meshes patches so that every point of them lies within `tolerance` of its mesh.
pub(crate) fn within(forms: &[Form], tolerance: f64, normals: bool) -> Result<Vec<Triangles>> {
    Ok(told(forms, tolerance, normals)?.into_iter().map(|(mesh, _)| mesh).collect())
}

/// Meshes patches as [`within`] does, and tells how far they stray from each triangle.
pub(crate) fn told(
    forms: &[Form],
    tolerance: f64,
    normals: bool,
) -> Result<Vec<(Triangles, Vec<Stray>)>> {
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(Error::domain("tolerance", tolerance, "a positive length"));
    }
    let forms: Vec<Form> = forms.iter().map(embed).collect::<Result<_>>()?;
    let unit = unit(&forms);
    if unit != 1.0 {
        let forms: Vec<Form> =
            forms.iter().map(|form| scaled(form, 1.0 / unit)).collect::<Result<_>>()?;
        let mut meshes = told(&forms, tolerance / unit, normals)?;
        for (mesh, strays) in &mut meshes {
            mesh.positions.as_flattened_mut().iter_mut().for_each(|x| *x *= unit);
            for Stray { height, over } in strays {
                (*height, *over) = (*height * unit, *over * unit);
            }
        }
        return Ok(meshes);
    }
    let mut lines = Vec::new();
    let mut known = HashMap::new();
    let mut patches: Vec<Patch> = forms
        .into_iter()
        .map(|form| Patch::new(form, tolerance, &mut lines, &mut known))
        .collect::<Result<_>>()?;
    for round in 0.. {
        stopping::check()?;
        spread_lines(&mut lines, &patches)?;
        let mut done = true;
        for patch in &mut patches {
            stopping::check()?;
            done &= patch.improve(&lines, tolerance, round)?;
        }
        if done {
            break;
        }
    }
    patches.iter().map(|patch| patch.mesh(normals)).collect()
}

/// The unit in which a bound may take fourth powers of lengths: 1 but for forms of astronomical or
/// subatomic size, else the power of two next to the largest coordinate.
fn unit(forms: &[Form]) -> f64 {
    const ORDINARY: std::ops::RangeInclusive<f64> = 1e-30..=1e30;
    let poles = forms.iter().flat_map(quadruples);
    let largest = poles.flat_map(|pole| &pole[..3]).fold(0.0_f64, |most, x| most.max(x.abs()));
    if largest == 0.0 || ORDINARY.contains(&largest) {
        return 1.0;
    }
    // The power of two below: its exponent without the digits.
    f64::from_bits(largest.to_bits() & f64::INFINITY.to_bits()).max(f64::MIN_POSITIVE)
}

/// The form multiplied by a power of two, which changes no digit.
pub(crate) fn scaled(form: &Form, factor: f64) -> Result<Form> {
    let mut poles = form.homogeneous().to_vec();
    for pole in poles.as_chunks_mut::<4>().0 {
        for x in &mut pole[..3] {
            *x *= factor;
        }
    }
    Form::from_homogeneous(form.orders(), 3, poles)
}

/// An edge that patches share, with its samples in its own direction.
struct Line {
    edge: Edge,
    profile: Profile,
    least: usize,
    ticks: Vec<f64>,
    points: Vec<Vec3>,
    surplus: f64,
    /// Whether the last round changed it.
    changed: bool,
}

/// A patch whose rows run along its second axis, or along its first if `swapped`.
struct Patch {
    form: Form,
    net: Net,
    swapped: bool,
    field: Field,
    /// The lines of `u = 0`, `u = 1`, `v = 0`, `v = 1`, and whether the patch runs against them.
    sides: [(usize, bool); 4],
    draft: Option<Draft>,
}

impl Patch {
    fn new(
        form: Form,
        tolerance: f64,
        lines: &mut Vec<Line>,
        known: &mut HashMap<Key, usize>,
    ) -> Result<Self> {
        require_axes(&form, 2, "a surface: two axes")?;
        let mut net = Net::of(&form, false);
        require_finite(&form)?;
        let edges = [(0, false), (0, true), (1, false), (1, true)]
            .map(|(fixed, high)| Edge::of(&form, fixed, high));
        let collapsed = collapsed(&form);
        let mut field = Field::of(&net, tolerance);
        let across = collapsed[2] || collapsed[3];
        let mut swapped = across && !(collapsed[0] || collapsed[1]);
        if !across && !collapsed[0] && !collapsed[1] {
            swapped = false;
        }
        if swapped {
            net = Net::of(&form, true);
            field = field.transposed();
        }
        let order = if swapped { [2, 3, 0, 1] } else { [0, 1, 2, 3] };
        let sides = order.map(|side: usize| {
            let edge = &edges[side];
            let line = *known.entry(edge.key()).or_insert_with(|| {
                lines.push(Line::new(edge.clone()));
                lines.len() - 1
            });
            // A fan takes the first segment of the edges next to it.
            let fans = collapsed.iter().filter(|collapsed| **collapsed).count();
            let next =
                if side < 2 { collapsed[2] || collapsed[3] } else { collapsed[0] || collapsed[1] };
            if next {
                lines[line].least = lines[line].least.max(fans + 1);
            }
            (line, edge.is_reversed())
        });
        Ok(Self { form, net, swapped, field, sides, draft: None })
    }

    /// Lays the patch out unless nothing has changed; tells whether it is near enough.
    fn improve(&mut self, lines: &[Line], tolerance: f64, round: usize) -> Result<bool> {
        let near = |draft: &Draft| draft.worst <= 1.0;
        if round > 1
            && self.draft.as_ref().is_some_and(near)
            && self.sides.iter().all(|(line, _)| !lines[*line].changed)
        {
            return Ok(true);
        }
        let borders = self.sides.map(|(line, reversed)| {
            let line = &lines[line];
            Border {
                ticks: &line.ticks,
                points: &line.points,
                reversed,
                collapsed: line.edge.single_point().is_some(),
                surplus: line.surplus,
            }
        });
        let coarser = round == 0;
        let draft = layout(&self.net, &self.field, &borders, tolerance, coarser)?;
        let done = near(&draft) && !coarser;
        if !done {
            draft.correct(&mut self.field, coarser);
            if round > PATIENCE {
                self.field.profiles().flatten().for_each(|density| *density *= 1.2);
            }
        }
        self.draft = Some(draft);
        Ok(done)
    }

    fn mesh(&self, normals: bool) -> Result<(Triangles, Vec<Stray>)> {
        let Some(draft) = &self.draft else { return Ok(Default::default()) };
        let mut mesh = Triangles {
            positions: draft.places.clone(),
            normals: Vec::new(),
            indices: draft.triangles.clone(),
        };
        let mut parameters = draft.parameters.clone();
        if self.swapped {
            for at in &mut parameters {
                at.swap(0, 1);
            }
            for corners in &mut mesh.indices {
                corners.swap(0, 1);
            }
        }
        if normals {
            let sampled = Sampled { form: &self.form, collapsed: collapsed(&self.form) };
            mesh.normals = sampled.normals_at(&parameters)?;
        }
        Ok((mesh, draft.strays.clone()))
    }
}

impl Line {
    fn new(edge: Edge) -> Self {
        Self {
            edge,
            profile: [f64::NAN; CELLS],
            least: 1,
            ticks: Vec::new(),
            points: Vec::new(),
            surplus: 1.0,
            changed: true,
        }
    }

    fn sample(&mut self, profile: Profile) -> Result<()> {
        self.changed = self.profile != profile;
        if !self.changed {
            return Ok(());
        }
        self.profile = profile;
        let asked = total(&profile);
        let count = (asked.ceil() as usize).max(self.least);
        require_room("the mesh", &[count])?;
        self.surplus = count as f64 / asked.max(f64::MIN_POSITIVE);
        let mut inner = Vec::new();
        spread(&profile, [0.0, 1.0], count, &mut inner);
        self.ticks.clear();
        self.ticks.push(0.0);
        self.ticks.extend(inner);
        self.ticks.push(1.0);
        self.points = self.edge.points(&self.ticks)?;
        Ok(())
    }
}

/// Samples every line as densely as the densest patch next to it asks for.
fn spread_lines(lines: &mut [Line], patches: &[Patch]) -> Result<()> {
    let mut profiles = vec![[0.0_f64; CELLS]; lines.len()];
    for patch in patches {
        for (side, (line, reversed)) in patch.sides.iter().enumerate() {
            let mut border = patch.field.borders[side];
            if *reversed {
                border.reverse();
            }
            for (profile, density) in profiles[*line].iter_mut().zip(border) {
                *profile = profile.max(density);
            }
        }
    }
    lines.iter_mut().zip(profiles).try_for_each(|(line, profile)| line.sample(profile))
}
