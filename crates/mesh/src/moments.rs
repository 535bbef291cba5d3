//! Areas, volumes, centres, inertia and boxes of meshes: sums over triangles, exact but for rounding.

use pforms_kernel::{Error, Result};
use pforms_operators::{BoundingBox, Mass, Measure, Moments};

use crate::Mesh;
use crate::edges::open;
use crate::vector::{Vec3, cross, dot};

/// The area of the triangles of some meshes, in any dimension, with a bound of its rounding.
///
/// Errors: `Domain` beyond the largest number.
///
/// ```
/// use pforms_mesh::{Mesh, mesh_area};
/// let corners = vec![0., 0., 3., 0., 0., 4.];
/// assert_eq!(mesh_area(&[Mesh::new(2, corners, vec![[0, 1, 2]])?])?.value, 6.0);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn mesh_area(meshes: &[Mesh]) -> Result<Measure> {
    Sums::of(meshes, false)?.measure(2)
}

/// The volume inside closed meshes in space, added up with its rounding: inside each, however it is
/// turned as a whole, unless it is `signed`.
///
/// Errors: `Degenerate` for a mesh that is open, naming an edge; `Shape` in another dimension; `Domain`
/// beyond the largest number.
pub fn mesh_volume(meshes: &[Mesh], signed: bool) -> Result<Measure> {
    let sums = Sums::of(meshes, true)?;
    if signed {
        return sums.measure(3);
    }
    let mut sum = Measure { value: 0.0, error: 0.0 };
    for mesh in meshes {
        let own = Sums::of(std::slice::from_ref(mesh), true)?.measure(3)?;
        sum = Measure { value: sum.value + own.value.abs(), error: sum.error + own.error };
    }
    let rounding = meshes.len() as f64 * f64::EPSILON * sum.value;
    Ok(Measure { value: sum.value, error: sum.error + rounding })
}

/// The mass of meshes of density 1, taken together: of their triangles, or with `filled` of what they
/// enclose.
///
/// Errors: as [`mesh_area`] and [`mesh_volume`]; `Degenerate` when there is no mass.
///
/// ```
/// use pforms_mesh::{Mesh, mesh_mass};
/// let corners = vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.];
/// let simplex = Mesh::new(3, corners, vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])?;
/// let mass = mesh_mass(&[simplex], true)?;
/// assert!((mass.measure.value - 1.0 / 6.0).abs() <= mass.measure.error);
/// assert!((mass.centroid[0] - 0.25).abs() <= mass.centroid_error);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn mesh_mass(meshes: &[Mesh], filled: bool) -> Result<Mass> {
    let Sums { mut values, error, origin, unit } = Sums::of(meshes, filled)?;
    if filled && values[0] < 0.0 {
        for x in &mut values {
            *x = -*x;
        }
    }
    let dimension = if filled { 3 } else { 2 };
    Mass::of_moments(Moments { values, error, origin, unit }, dimension)
}

/// The box round the vertices of meshes: exactly. The parameter of a point is the number of its vertex.
///
/// Errors: `Shape` for none, an empty one, and different dimensions.
pub fn mesh_box(meshes: &[Mesh]) -> Result<BoundingBox> {
    let ambient = same_dimension(meshes)?;
    let mut found = BoundingBox {
        lower: vec![f64::INFINITY; ambient],
        upper: vec![f64::NEG_INFINITY; ambient],
        error: 0.0,
        lowest: vec![(0, Vec::new()); ambient],
        highest: vec![(0, Vec::new()); ambient],
    };
    for (number, mesh) in meshes.iter().enumerate() {
        for (vertex, point) in mesh.vertices().chunks_exact(ambient).enumerate() {
            for (k, x) in point.iter().enumerate() {
                if *x < found.lower[k] {
                    (found.lower[k], found.lowest[k]) = (*x, (number, vec![vertex as f64]));
                }
                if *x > found.upper[k] {
                    (found.upper[k], found.highest[k]) = (*x, (number, vec![vertex as f64]));
                }
            }
        }
    }
    if found.lower.iter().any(|x| x.is_infinite()) {
        return Err(Error::shape("meshes", "nothing", "one vertex at least"));
    }
    Ok(found)
}

fn same_dimension(meshes: &[Mesh]) -> Result<usize> {
    let Some(first) = meshes.first() else {
        return Err(Error::shape("meshes", "none", "one at least"));
    };
    if let Some(other) = meshes.iter().find(|mesh| mesh.ambient() != first.ambient()) {
        let received = format!("one in dimension {}", other.ambient());
        return Err(Error::shape(
            "meshes",
            received,
            format!("all in dimension {}", first.ambient()),
        ));
    }
    Ok(first.ambient())
}

/// Moments seen from the middle, in units of the size: nothing cancels, overflows or vanishes.
struct Sums {
    /// Of the content of all triangles or cones; of that times each coordinate, then of each product.
    values: Vec<f64>,
    /// By how much each of them may be off.
    error: f64,
    origin: Vec<f64>,
    unit: f64,
}

impl Sums {
    fn of(meshes: &[Mesh], filled: bool) -> Result<Self> {
        let ambient = same_dimension(meshes)?;
        if filled {
            meshes.iter().try_for_each(require_shell)?;
        }
        let (mut low, mut high) = (vec![0.0; ambient], vec![0.0; ambient]);
        for (number, (lowest, highest)) in meshes.iter().filter_map(Mesh::bounds).enumerate() {
            for k in 0..ambient {
                low[k] = if number == 0 { lowest[k] } else { lowest[k].min(low[k]) };
                high[k] = if number == 0 { highest[k] } else { highest[k].max(high[k]) };
            }
        }
        let extent = (0..ambient).map(|k| high[k] / 2.0 - low[k] / 2.0).fold(0.0, f64::max);
        // A power of two changes no digit.
        let unit = libm::ldexp(1.0, libm::frexp(extent).1.clamp(-1000, 1000));
        let middle: Vec<f64> = (0..ambient).map(|k| low[k] / 2.0 + high[k] / 2.0).collect();
        let mut sums = Self {
            values: vec![0.0; 1 + ambient + ambient * (ambient + 1) / 2],
            error: 0.0,
            origin: middle.iter().map(|x| x / unit).collect(),
            unit,
        };
        let (mut sizes, mut count) = (0.0, 0_usize);
        for mesh in meshes {
            let local: Vec<f64> = mesh
                .vertices()
                .iter()
                .enumerate()
                .map(|(k, x)| (x - middle[k % ambient]) / unit)
                .collect();
            for corners in mesh.triangles() {
                let places = corners.map(|vertex| &local[vertex as usize * ambient..][..ambient]);
                let size = if filled { cone(places) } else { crate::mesh::area(places) };
                sums.add(size, places, filled);
                // Of a cone the products have so many roundings, whatever is left of them.
                sizes += if filled { crate::mesh::area(places) } else { size };
                count += 1;
            }
        }
        // Every coordinate is at most 1: no moment of a triangle is above its content.
        sums.error = (count + 64) as f64 * f64::EPSILON * sizes;
        Ok(sums)
    }

    /// Adds what a triangle, or the cone over it from the origin, contributes.
    fn add(&mut self, size: f64, places: [&[f64]; 3], filled: bool) {
        let ambient = places[0].len();
        let [first, second] = if filled { [4.0, 20.0] } else { [3.0, 12.0] };
        let sum = |k: usize| places[0][k] + places[1][k] + places[2][k];
        self.values[0] += size;
        let mut next = 1 + ambient;
        for i in 0..ambient {
            self.values[1 + i] += size * sum(i) / first;
            for j in i..ambient {
                let products: f64 = places.iter().map(|place| place[i] * place[j]).sum();
                self.values[next] += size * (products + sum(i) * sum(j)) / second;
                next += 1;
            }
        }
    }

    fn measure(&self, dimension: usize) -> Result<Measure> {
        let scaled = |x: f64| (0..dimension).fold(x, |x, _| x * self.unit);
        let measure = Measure { value: scaled(self.values[0]), error: scaled(self.error) };
        if measure.value.is_finite() && measure.error.is_finite() {
            return Ok(measure);
        }
        Err(Error::domain("meshes", "a measure beyond the largest number", "smaller meshes"))
    }
}

/// The signed volume of the cone from the origin over a triangle in space.
fn cone(places: [&[f64]; 3]) -> f64 {
    let [a, b, c]: [Vec3; 3] = places.map(|place| [place[0], place[1], place[2]]);
    dot(a, cross(b, c)) / 6.0
}

/// Complains unless a mesh encloses something for sure.
fn require_shell(mesh: &Mesh) -> Result<()> {
    if mesh.ambient() != 3 {
        let received = format!("a mesh in dimension {}", mesh.ambient());
        return Err(Error::shape("mesh", received, "a mesh in space"));
    }
    let welded = mesh.welded()?;
    let border = open(welded.triangles());
    let Some(([a, b], _)) = border.first() else { return Ok(()) };
    let places = welded.places();
    let name = |vertex: u32| {
        let [x, y, z] = places[vertex as usize];
        format!("({x}, {y}, {z})")
    };
    let received = format!(
        "an open mesh: {} edges of one triangle, one from {} to {}",
        border.len(),
        name(*a),
        name(*b)
    );
    Err(Error::degenerate("mesh", received, "a closed mesh, each edge run both ways"))
}
