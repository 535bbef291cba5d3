//! Forms put end to end: what subdivision makes.

use pforms_kernel::{Error, Form, Result, Scalar};

/// Pieces of one degree along each axis, joined where their end poles coincide.
///
/// The refined net holds the control polygons of the pieces put end to end, so along an axis of
/// degree `d` with `k` pieces it has `d·k + 1` poles; only every `d`-th lies on the form.
#[derive(Clone, Debug, PartialEq)]
pub struct Piecewise<S = f64> {
    net: Form<S>,
    degrees: Vec<usize>,
    breaks: Vec<Vec<S>>,
}

impl<S: Scalar> Piecewise<S> {
    /// Pieces from their net, degrees and parameters where they meet, ends included.
    ///
    /// Errors: `Shape` unless along each axis the net has `degree · pieces + 1` poles.
    pub fn new(net: Form<S>, degrees: Vec<usize>, breaks: Vec<Vec<S>>) -> Result<Self> {
        net.require_per_axis("degrees", &degrees)?;
        net.require_per_axis("breaks", &breaks)?;
        for (axis, (degree, list)) in degrees.iter().zip(&breaks).enumerate() {
            let pieces = list.len().saturating_sub(1);
            if pieces == 0 || net.orders()[axis] != degree * pieces + 1 {
                return Err(Error::shape(
                    "net",
                    format!("{} poles along axis {axis}", net.orders()[axis]),
                    format!("degree · pieces + 1 = {}", degree * pieces + 1),
                ));
            }
        }
        Ok(Self { net, degrees, breaks })
    }

    /// The refined net: all poles, in one array.
    pub fn net(&self) -> &Form<S> {
        &self.net
    }

    /// Degree of every piece along each axis.
    pub fn degrees(&self) -> &[usize] {
        &self.degrees
    }

    /// Along each axis, the parameters where pieces begin and end.
    pub fn breaks(&self) -> &[Vec<S>] {
        &self.breaks
    }

    /// Number of pieces along each axis.
    pub fn counts(&self) -> Vec<usize> {
        self.breaks.iter().map(|list| list.len() - 1).collect()
    }

    /// The piece at `index`.
    ///
    /// Errors: `Shape` when there is no such piece.
    pub fn piece(&self, index: &[usize]) -> Result<Form<S>> {
        let counts = self.counts();
        self.net.require_per_axis("index", index)?;
        if index.iter().zip(&counts).any(|(i, count)| i >= count) {
            return Err(Error::shape(
                "index",
                format!("{index:?}"),
                format!("indices below {counts:?}"),
            ));
        }
        let orders: Vec<usize> = self.degrees.iter().map(|degree| degree + 1).collect();
        let mut poles = Vec::with_capacity(orders.iter().product::<usize>() * self.net.width());
        self.copy_piece(index, self.net.orders(), self.net.homogeneous(), &mut poles);
        Form::from_homogeneous(&orders, self.net.ambient(), poles)
    }

    /// Copies what belongs to a piece from a part of the net, whose first axes are gone.
    fn copy_piece(&self, index: &[usize], orders: &[usize], part: &[S], poles: &mut Vec<S>) {
        let gone = self.degrees.len() - orders.len();
        let alone = (gone..self.degrees.len()).all(|axis| self.breaks[axis].len() == 2);
        if alone {
            return poles.extend_from_slice(part);
        }
        let (degree, share) = (self.degrees[gone], part.len() / orders[0]);
        for line in part.chunks_exact(share).skip(index[gone] * degree).take(degree + 1) {
            self.copy_piece(index, &orders[1..], line, poles);
        }
    }

    /// All pieces, the last axis fastest.
    ///
    /// Errors: `Limit`.
    pub fn pieces(&self) -> Result<Vec<Form<S>>> {
        indices(&self.counts()).iter().map(|index| self.piece(index)).collect()
    }

    /// The euclidean point at `parameters`; outside the breaks the outermost pieces go on.
    ///
    /// Errors: as [`Form::at`].
    pub fn at(&self, parameters: &[S]) -> Result<Vec<S>> {
        self.net.require_per_axis("parameters", parameters)?;
        let mut index = Vec::with_capacity(parameters.len());
        let mut local = Vec::with_capacity(parameters.len());
        for (t, list) in parameters.iter().zip(&self.breaks) {
            let inner = &list[1..list.len() - 1];
            let piece = inner.iter().filter(|knot| *knot <= t).count();
            let (from, to) = (&list[piece], &list[piece + 1]);
            local.push((t.clone() - from.clone()) / (to.clone() - from.clone()));
            index.push(piece);
        }
        self.piece(&index)?.at(&local)
    }
}

/// Every index below `counts`, the last fastest.
pub(super) fn indices(counts: &[usize]) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::with_capacity(counts.len())];
    for &count in counts {
        let prefixes = std::mem::take(&mut all);
        for prefix in prefixes {
            for i in 0..count {
                let mut index = prefix.clone();
                index.push(i);
                all.push(index);
            }
        }
    }
    all
}
