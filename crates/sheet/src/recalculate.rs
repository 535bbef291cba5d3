//! Computing what a change has touched, and nothing else.

use std::cell::Cell as Flag;

use pforms_catalogue::{Arithmetic, Failure, Value};
use pforms_formula::Address;
use pforms_kernel::stopping::stoppable;

use crate::cell::Cost;
use crate::evaluate::Surroundings;
use crate::graph::{Circle, Stage};
use crate::{Cancel, Sheet};

/// What a recomputation did.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// The cells that were computed again, or emptied, in the order in which it was done.
    pub changed: Vec<Address>,
    /// Cells that are still to be computed, because it was cancelled or its time was over.
    pub remaining: usize,
}

/// Cells of a circle that an error names before it leaves some out.
const NAMED: usize = 12;

impl<S: Arithmetic> Sheet<S> {
    /// Computes the cells that depend on what was changed, each after those it uses.
    ///
    /// Stops early by the token's will or budget; calling again goes on where it stopped.
    pub fn recalculate(&mut self, cancel: &Cancel) -> Report {
        let mut report = Report::default();
        let end = cancel.budget().zip(self.clock).map(|(budget, clock)| clock() + budget);
        let late =
            |clock| end.zip(clock).is_some_and(|(end, clock): (f64, fn() -> f64)| clock() >= end);
        if self.plan.is_empty() {
            self.plan = self.graph.stages(&self.dirty);
        }
        while let Some(stage) = self.plan.front() {
            let over = !report.changed.is_empty() && late(self.clock);
            if over || cancel.is_cancelled() {
                break;
            }
            let done = match stage.clone() {
                Stage::Compute(at) => self.compute(at, cancel).map(|()| vec![at]),
                Stage::Circle(circle) => Some(self.refuse(&circle)),
            };
            let Some(done) = done else { break };
            self.plan.pop_front();
            for at in done {
                self.dirty.remove(&at);
                report.changed.push(at);
            }
        }
        report.remaining = self.dirty.len();
        report
    }

    /// [`Sheet::recalculate`] to the end.
    pub fn recalculate_all(&mut self) -> Report {
        self.recalculate(&Cancel::new())
    }

    /// Computes one cell, whose precedents are computed; `None` when cancelled half-way.
    fn compute(&mut self, at: Address, cancel: &Cancel) -> Option<()> {
        let Some(cell) = self.cells.get(&at) else { return Some(()) };
        let start = self.clock.map(|clock| clock());
        let around = Surroundings {
            document: &self.document,
            cells: &self.cells,
            graph: &self.graph,
            cancel,
            interrupted: Flag::new(false),
        };
        let token = cancel.clone();
        let (value, stopped) =
            stoppable(move || token.is_cancelled(), || around.cell(at, &cell.content));
        if stopped || around.interrupted.get() {
            return None;
        }
        let seconds = self.clock.zip(start).map(|(clock, start)| clock() - start);
        self.store(at, value, seconds);
        Some(())
    }

    fn store(&mut self, at: Address, value: Value<S>, seconds: Option<f64>) {
        if let Some(cell) = self.cells.get_mut(&at) {
            cell.cost = Cost { seconds, orders: value.orders(), bytes: value.bytes() };
            cell.value = value;
        }
    }

    /// Gives every cell of a circle the error that tells the way round.
    fn refuse(&mut self, circle: &Circle) -> Vec<Address> {
        for (at, round) in &circle.rounds {
            let failure = going_round(round).at(at.to_string());
            self.store(*at, failure.into(), None);
        }
        circle.rounds.keys().copied().collect()
    }
}

/// `A1 → B2 → A1`, the middle left out of a long one.
fn going_round(round: &[Address]) -> Failure {
    let mut stops: Vec<String> = round.iter().take(NAMED).map(ToString::to_string).collect();
    if round.len() > NAMED {
        stops.push(format!("… ({})", round.len()));
    }
    stops.extend(round.first().map(ToString::to_string));
    let way = stops.join(" → ");
    Failure::new(
        "Cycle",
        format!("cells that need one another: {way}"),
        format!("des cellules qui ont besoin l'une de l'autre : {way}"),
    )
    .with_hint(
        "change one of them so that it does without the next",
        "changez l'une d'elles pour qu'elle se passe de la suivante",
    )
}
