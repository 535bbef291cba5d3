//! The sections of an MFEM NURBS mesh.

/// What the file says, in its own numbering.
#[derive(Default, Debug)]
pub(super) struct Mesh {
    /// Parameters of every patch.
    pub(super) dimension: usize,
    /// The corners of each patch, in MFEM's order.
    pub(super) elements: Vec<Vec<usize>>,
    /// Edges: the number of their knots, and their two ends.
    pub(super) edges: Vec<(usize, [usize; 2])>,
    /// Number of vertices.
    pub(super) vertices: usize,
    /// Degree and knots.
    pub(super) knots: Vec<(usize, Vec<f64>)>,
    /// Vertices that hang on a larger patch: the vertex, its knot spans there, and the corners there.
    pub(super) hanging: Vec<(usize, Vec<usize>, Vec<usize>)>,
    /// All weights, then all euclidean points, where the mesh numbers its poles.
    pub(super) weights: Vec<f64>,
    pub(super) points: Vec<Vec<f64>>,
    /// What follows the word `patches`, where each patch has poles of its own.
    pub(super) patches: Option<Vec<String>>,
}

/// The words of the file, its remarks left out.
pub(super) struct Words(std::iter::Peekable<std::vec::IntoIter<String>>);

impl Words {
    pub(super) fn new(words: Vec<String>) -> Self {
        Self(words.into_iter().peekable())
    }

    pub(super) fn next(&mut self) -> Option<String> {
        self.0.next()
    }

    pub(super) fn whole(&mut self) -> usize {
        let word = self.0.next().expect("a number");
        word.parse().unwrap_or_else(|_| panic!("{word:?} is no whole number"))
    }

    pub(super) fn wholes(&mut self, count: usize) -> Vec<usize> {
        (0..count).map(|_| self.whole()).collect()
    }

    /// The numbers from here on, as far as they go.
    pub(super) fn numbers(&mut self) -> Vec<f64> {
        let parse = |word: &String| word.parse::<f64>().is_ok();
        let mut list = Vec::new();
        while let Some(word) = self.0.next_if(parse) {
            list.push(word.parse().expect("just looked"));
        }
        list
    }

    /// Knot vectors: how many, then of each its degree, its poles and its knots.
    pub(super) fn knots(&mut self) -> Vec<(usize, Vec<f64>)> {
        let count = self.whole();
        (0..count)
            .map(|_| {
                let (degree, poles) = (self.whole(), self.whole());
                let mut number = || self.0.next().expect("a knot").parse().expect("a number");
                (degree, (0..=degree + poles).map(|_| number()).collect())
            })
            .collect()
    }
}

/// Corners of a segment, a square, a cube.
const CORNERS: [usize; 6] = [1, 2, 0, 4, 0, 8];

impl Mesh {
    pub(super) fn read(text: &str) -> Self {
        let mut lines = text.lines();
        let heading = lines.next().expect("a heading");
        assert!(heading.starts_with("MFEM NURBS"), "{heading}");
        let nested = heading.contains("NC-patch");
        let remarkless = lines.map(|line| line.split('#').next().unwrap_or_default());
        let words = remarkless.flat_map(str::split_whitespace).map(str::to_owned).collect();
        let mut words = Words::new(words);
        let mut mesh = Self::default();
        while let Some(section) = words.next() {
            mesh.section(&section, &mut words, nested);
        }
        mesh
    }

    fn section(&mut self, name: &str, words: &mut Words, nested: bool) {
        match name {
            "dimension" => self.dimension = words.whole(),
            "elements" => {
                let count = words.whole();
                self.elements = (0..count).filter_map(|_| element(words, nested)).collect();
            }
            "edges" => {
                let count = words.whole();
                self.edges =
                    (0..count).map(|_| (words.whole(), [words.whole(), words.whole()])).collect();
            }
            "vertices" => self.vertices = words.whole(),
            "coordinates" => {
                self.vertices = words.whole();
                words.numbers();
            }
            "vertex_to_knotspan" => {
                let (count, spans) = (words.whole(), self.dimension - 1);
                self.hanging = (0..count)
                    .map(|_| (words.whole(), words.wholes(spans), words.wholes(1 << spans)))
                    .collect();
            }
            "knotvectors" => self.knots = words.knots(),
            "weights" => self.weights = words.numbers(),
            "FiniteElementSpace" => self.space(words),
            "patches" => self.patches = Some(std::iter::from_fn(|| words.next()).collect()),
            // Neither the boundary nor the spacing of later refinements shapes a patch.
            "boundary" | "spacing" => drop(words.numbers()),
            "mfem_mesh_end" => {}
            other => panic!("a section {other:?}"),
        }
    }

    fn space(&mut self, words: &mut Words) {
        assert_eq!(words.next().as_deref(), Some("FiniteElementCollection:"));
        words.next();
        assert_eq!(words.next().as_deref(), Some("VDim:"));
        let width = words.whole();
        assert_eq!(words.next().as_deref(), Some("Ordering:"));
        assert_eq!(words.whole(), 1, "coordinates of a pole side by side");
        self.points = words.numbers().chunks(width).map(<[f64]>::to_vec).collect();
    }
}

/// The corners of an element; of a tree of elements only the leaves are patches.
fn element(words: &mut Words, nested: bool) -> Option<Vec<usize>> {
    if nested {
        let _rank = words.whole();
    }
    let _attribute = words.whole();
    let corners = CORNERS[words.whole()];
    let split = nested && words.whole() != 0;
    let list = words.wholes(corners);
    (!split).then_some(list)
}
