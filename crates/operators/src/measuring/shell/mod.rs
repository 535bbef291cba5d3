//! Patches that close up: which borders meet, and which way round each patch is.

mod border;

use pforms_kernel::{Error, Result, Scalar};

use self::border::Border;
use crate::algebra::{Poles, Shape};

/// A closed shell of patches.
#[derive(Clone, Debug)]
pub(crate) struct Shell {
    /// For each patch 1 or −1: times its own orientation, that of the first patch it hangs together
    /// with.
    pub signs: Vec<i32>,
    /// At most the measure of the cracks along borders that meet but for rounding.
    pub cracks: f64,
}

impl Shell {
    /// Finds out which borders of the patches are the same, to `tolerance` times the `size` of them
    /// all.
    ///
    /// A border meets one other border, of another patch or of the same one, whole: with the same poles
    /// on common knots, in whatever order and direction. Collapsed borders need no other.
    ///
    /// Errors: `Degenerate` naming a border that meets no other, and when patches form a one-sided
    /// surface; `Domain` when a border goes to infinity.
    pub(crate) fn closed<S: Scalar>(
        patches: &[Shape<S>],
        size: f64,
        tolerance: f64,
    ) -> Result<Self> {
        let tolerance = tolerance * size;
        let mut borders = Vec::new();
        for (place, patch) in patches.iter().enumerate() {
            borders.extend(Border::all(place, patch, tolerance)?);
        }
        borders.sort_by(|a, b| a.middle[0].total_cmp(&b.middle[0]));
        let mut met = vec![false; borders.len()];
        let mut links: Vec<Vec<(usize, bool)>> = vec![Vec::new(); patches.len()];
        let mut cracks = 0.0;
        for k in 0..borders.len() {
            if met[k] {
                continue;
            }
            let own = &borders[k];
            let mut found = None;
            for (place, other) in borders.iter().enumerate().skip(k + 1) {
                if other.middle[0] > own.middle[0] + tolerance {
                    break;
                }
                let mut pairs = own.middle.iter().zip(&other.middle);
                if !met[place] && pairs.all(|(x, y)| (x - y).abs() <= tolerance) {
                    found = own.matches(other, tolerance)?.map(|same| (place, same));
                }
                if found.is_some() {
                    break;
                }
            }
            let Some((place, same)) = found else { return Err(open(own, patches)) };
            (met[k], met[place]) = (true, true);
            let axes = patches[own.patch].net().axes() as i32 - 1;
            cracks += same.gap * same.size * size.powi(axes);
            links[own.patch].push((borders[place].patch, same.agree));
            links[borders[place].patch].push((own.patch, same.agree));
        }
        Ok(Self { signs: oriented(&links)?, cracks })
    }
}

/// The sign of each patch, from neighbour to neighbour.
fn oriented(links: &[Vec<(usize, bool)>]) -> Result<Vec<i32>> {
    let mut signs = vec![0; links.len()];
    for first in 0..links.len() {
        if signs[first] != 0 {
            continue;
        }
        signs[first] = 1;
        let mut waiting = vec![first];
        while let Some(patch) = waiting.pop() {
            for (neighbour, agree) in &links[patch] {
                let sign = if *agree { signs[patch] } else { -signs[patch] };
                if signs[*neighbour] == 0 {
                    signs[*neighbour] = sign;
                    waiting.push(*neighbour);
                } else if signs[*neighbour] != sign {
                    return Err(Error::degenerate(
                        "patches",
                        format!("a one-sided surface, found out at patch {neighbour}"),
                        "a surface with an inside and an outside",
                    ));
                }
            }
        }
    }
    Ok(signs)
}

fn open<S: Scalar>(border: &Border<S>, patches: &[Shape<S>]) -> Error {
    let end = if border.far { "end" } else { "start" };
    let kind = patches[border.patch].net().kind();
    let middle: Vec<String> = border.middle.iter().map(|x| format!("{x:.6}")).collect();
    Error::degenerate(
        "patches",
        format!(
            "an open border: the {end} of axis {} of patch {}, a {kind}, about ({})",
            border.axis,
            border.patch,
            middle.join(", ")
        ),
        "a closed shell, where each border is that of one other patch",
    )
}
