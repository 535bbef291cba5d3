//! Points and triangles as a value: what a solid, a scan or a cloud of points is.

use std::sync::Arc;

use pforms_kernel::{Error, Result, limit};

use crate::Triangles;
use crate::vector::{Vec3, cross, dot, subtract};

/// Points of any dimension and triangles between them; without triangles, a cloud of points.
///
/// It is immutable and cheap to share. All its numbers are finite: every constructor checks. Seen
/// from outside, the corners of a triangle run counter-clockwise.
///
/// ```
/// use pforms_mesh::Mesh;
/// let corners = vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.];
/// let faces = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
/// let simplex = Mesh::new(3, corners, faces)?;
/// assert_eq!(simplex.volume()?, 1.0 / 6.0);
/// assert!(simplex.is_closed());
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh(Arc<Parts>);

#[derive(Debug, PartialEq)]
struct Parts {
    ambient: usize,
    vertices: Vec<f64>,
    triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// Vertices, `ambient` coordinates each, and three of them for each triangle.
    ///
    /// Errors: `Shape` for coordinates that are no whole number of points, or none; `Domain` for
    /// one that is not finite and a triangle of a vertex that is not there; `Limit` from 2³² on.
    pub fn new(ambient: usize, vertices: Vec<f64>, triangles: Vec<[u32; 3]>) -> Result<Self> {
        if ambient == 0 || !vertices.len().is_multiple_of(ambient) {
            let received = format!("{} coordinates", vertices.len());
            return Err(Error::shape("vertices", received, format!("points of {ambient}")));
        }
        if let Some(x) = vertices.iter().find(|x| !x.is_finite()) {
            return Err(Error::domain("vertices", x, "finite numbers"));
        }
        let count = vertices.len() / ambient;
        if count > u32::MAX as usize {
            limit::check::<[f64; 1 << 20]>("the mesh", &[count], ambient)?;
        }
        if let Some(vertex) = triangles.as_flattened().iter().find(|v| **v as usize >= count) {
            return Err(Error::domain("triangles", vertex, format!("a vertex below {count}")));
        }
        Ok(Self(Arc::new(Parts { ambient, vertices, triangles })))
    }

    /// Points alone.
    ///
    /// Errors: as [`Mesh::new`].
    pub fn cloud(ambient: usize, points: Vec<f64>) -> Result<Self> {
        Self::new(ambient, points, Vec::new())
    }

    /// Nothing at all, the solid without a point.
    pub fn empty() -> Self {
        Self(Arc::new(Parts { ambient: 3, vertices: Vec::new(), triangles: Vec::new() }))
    }

    pub(crate) fn of_space(vertices: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self> {
        Self::new(3, vertices.into_flattened(), triangles)
    }

    /// Number of coordinates of a vertex.
    pub fn ambient(&self) -> usize {
        self.0.ambient
    }

    /// The coordinates of all vertices, one vertex after the other.
    pub fn vertices(&self) -> &[f64] {
        &self.0.vertices
    }

    /// Number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.0.vertices.len() / self.0.ambient
    }

    /// Three vertices for each triangle.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.0.triangles
    }

    /// Has it no triangles?
    pub fn is_cloud(&self) -> bool {
        self.0.triangles.is_empty()
    }

    /// Bytes its numbers occupy.
    pub fn bytes(&self) -> usize {
        size_of_val(self.vertices()) + size_of_val(self.triangles())
    }

    /// The same triangles between other vertices, of any dimension.
    ///
    /// Errors: `Shape` for another number of vertices; those of [`Mesh::new`].
    pub fn with_vertices(&self, ambient: usize, vertices: Vec<f64>) -> Result<Self> {
        let expected = self.vertex_count();
        if ambient == 0 || vertices.len() != expected * ambient {
            let received = format!("{} coordinates", vertices.len());
            return Err(Error::shape("vertices", received, format!("{expected} points")));
        }
        Self::new(ambient, vertices, self.0.triangles.clone())
    }

    /// The mesh with one vertex at each place that has some; vertices of no triangle are left out.
    ///
    /// Errors: `Shape` unless it is in space.
    pub fn welded(&self) -> Result<Self> {
        self.require_space()?;
        let (vertices, triangles) = crate::weld::welded(&self.places(), self.triangles());
        Self::of_space(vertices, triangles)
    }

    fn require_space(&self) -> Result<()> {
        if self.0.ambient == 3 {
            return Ok(());
        }
        let received = format!("a mesh in dimension {}", self.0.ambient);
        Err(Error::shape("mesh", received, "a mesh in dimension 3"))
    }

    /// The vertices in space: missing coordinates are 0, of more than three the first three.
    pub fn places(&self) -> Vec<Vec3> {
        let place = |point: &[f64]| [0, 1, 2].map(|k| point.get(k).copied().unwrap_or(0.0));
        self.0.vertices.chunks_exact(self.0.ambient).map(place).collect()
    }

    /// Does every edge of a triangle run the other way in another one, as often?
    pub fn is_closed(&self) -> bool {
        !self.is_cloud() && crate::edges::open(self.triangles()).is_empty()
    }

    /// The area of all triangles.
    pub fn area(&self) -> f64 {
        let at =
            |vertex: u32| &self.0.vertices[vertex as usize * self.0.ambient..][..self.0.ambient];
        self.triangles().iter().map(|corners| area(corners.map(at))).sum()
    }

    /// The volume inside a closed mesh in space; where it is wound several times, so often; what
    /// is turned inside out counts negative.
    ///
    /// Errors: `Shape` unless it is closed and in space; `Accuracy` beyond the largest number.
    pub fn volume(&self) -> Result<f64> {
        self.require_space()?;
        if self.vertex_count() == 0 {
            return Ok(0.0);
        }
        if !self.is_closed() {
            return Err(Error::shape("mesh", "one with a border", "a closed mesh"));
        }
        let volume = volume(&self.places(), self.triangles());
        if volume.is_finite() {
            return Ok(volume);
        }
        Err(Error::accuracy("volume", volume, "at most 1.8e308"))
    }

    /// The box round all vertices: its lowest and its highest corner; nothing round nothing.
    pub fn bounds(&self) -> Option<(Vec<f64>, Vec<f64>)> {
        let mut points = self.0.vertices.chunks_exact(self.0.ambient);
        let first = points.next()?.to_vec();
        let (mut low, mut high) = (first.clone(), first);
        for point in points {
            for (k, x) in point.iter().enumerate() {
                (low[k], high[k]) = (low[k].min(*x), high[k].max(*x));
            }
        }
        Some((low, high))
    }

    /// The triangles in space with a unit normal at each corner, for a picture.
    ///
    /// Light runs smoothly over facets that meet at less than 30°; other edges stay sharp.
    pub fn shaded(&self) -> Triangles {
        crate::crease::shaded(&self.places(), self.triangles())
    }

    /// The edges of all triangles, each once, as lines in space.
    pub fn wires(&self) -> Vec<crate::Polyline> {
        let places = self.places();
        let mut pairs: Vec<[u32; 2]> = crate::edges::directed(self.triangles())
            .map(|([a, b], _)| [a.min(b), a.max(b)])
            .collect();
        pairs.sort_unstable();
        pairs.dedup();
        let line = |pair: [u32; 2]| pair.map(|vertex| places[vertex as usize]).to_vec();
        pairs.into_iter().map(|pair| crate::Polyline::through(line(pair))).collect()
    }
}

impl From<&Triangles> for Mesh {
    /// The triangles; vertices at one place become one.
    fn from(triangles: &Triangles) -> Self {
        let (vertices, indices) = crate::weld::welded(&triangles.positions, &triangles.indices);
        let parts = Parts { ambient: 3, vertices: vertices.into_flattened(), triangles: indices };
        Self(Arc::new(parts))
    }
}

/// Of a triangle in any dimension: a side times the height over it.
pub(crate) fn area([a, b, c]: [&[f64]; 3]) -> f64 {
    let side = |to: &[f64]| -> Vec<f64> { to.iter().zip(a).map(|(x, y)| x - y).collect() };
    let (mut p, mut q) = (side(b), side(c));
    let largest = p.iter().chain(&q).fold(0.0_f64, |most, x| most.max(x.abs()));
    // A power of two changes no digit; in units of it squares neither overflow nor vanish.
    let unit = libm::ldexp(1.0, libm::frexp(largest).1.clamp(-1000, 1000));
    p.iter_mut().chain(&mut q).for_each(|x| *x /= unit);
    let product = |x: &[f64], y: &[f64]| -> f64 { x.iter().zip(y).map(|(x, y)| x * y).sum() };
    let square = product(&p, &p);
    if square == 0.0 {
        return 0.0;
    }
    // The part of q at right angles to p: no cancellation between products of squares.
    let share = product(&p, &q) / square;
    let height: Vec<f64> = q.iter().zip(&p).map(|(x, y)| x - share * y).collect();
    (square * product(&height, &height)).sqrt() / 2.0 * unit * unit
}

/// The volume of the cones from a point in the middle, which keeps the rounding small.
pub(crate) fn volume(places: &[Vec3], triangles: &[[u32; 3]]) -> f64 {
    let (volume, unit) = volume_in_units(places, triangles);
    volume * unit * unit * unit
}

/// The volume in units of a length, which neither overflows nor vanishes, and that length.
pub(crate) fn volume_in_units(places: &[Vec3], triangles: &[[u32; 3]]) -> (f64, f64) {
    let Some(first) = triangles.first() else { return (0.0, 1.0) };
    let (mut low, mut high) = (places[first[0] as usize], places[first[0] as usize]);
    for vertex in triangles.as_flattened() {
        for (k, x) in places[*vertex as usize].iter().enumerate() {
            (low[k], high[k]) = (low[k].min(*x), high[k].max(*x));
        }
    }
    let middle = [0, 1, 2].map(|k| low[k] / 2.0 + high[k] / 2.0);
    let extent = (0..3).map(|k| high[k] - middle[k]).fold(0.0, f64::max);
    if extent == 0.0 {
        return (0.0, 1.0);
    }
    // A power of two changes no digit.
    let unit = libm::ldexp(1.0, libm::frexp(extent).1.clamp(-1000, 1000));
    let cone = |corners: &[u32; 3]| {
        let [a, b, c] =
            corners.map(|vertex| subtract(places[vertex as usize], middle).map(|x| x / unit));
        dot(a, cross(b, c)) / 6.0
    };
    (triangles.iter().map(cone).sum(), unit)
}
