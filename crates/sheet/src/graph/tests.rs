use super::*;
use pforms_formula::{Locale, parse, references};

fn at(text: &str) -> Address {
    text.parse().unwrap()
}

/// A graph drawn as lines `A1 = formula`.
fn graph(lines: &str) -> Graph {
    let mut graph = Graph::default();
    for line in lines.lines().filter(|line| !line.trim().is_empty()) {
        let (cell, formula) = line.split_once('=').unwrap();
        let found = references(&parse(formula, Locale::DecimalPoint));
        let mut mentions =
            Mentions { cells: found.cells.into_iter().collect(), ..Default::default() };
        found.ranges.iter().for_each(|range| mentions.add_range(range));
        graph.link(at(cell.trim()), mentions);
    }
    graph
}

fn list(cells: &BTreeSet<Address>) -> String {
    cells.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

/// The cells that mention one, by itself or in a range.
fn users(graph: &Graph, cell: &str) -> String {
    let through = |node| match node {
        Node::Range(_) => graph.next(node),
        Node::Cell(_) => vec![node],
    };
    let nodes = graph.next(Node::Cell(at(cell))).into_iter().flat_map(through);
    list(&nodes.filter_map(|node| node.cell()).collect())
}

fn dependents(graph: &Graph, seeds: &[&str]) -> BTreeSet<Address> {
    let mut dirty = BTreeSet::new();
    graph.spread(seeds.iter().map(|text| at(text)), &mut dirty);
    dirty
}

fn order(graph: &Graph, seeds: &[&str]) -> Vec<String> {
    let dirty = dependents(graph, seeds);
    let stage = |stage| match stage {
        Stage::Compute(at) => at.to_string(),
        Stage::Circle(circle) => format!("circle of {}", circle.rounds.len()),
    };
    graph.stages(&dirty).into_iter().map(stage).collect()
}

#[test]
fn only_dependents_are_reached_and_in_order() {
    let graph = graph("B1 = A1 + 1\n C1 = B1 + A2\n D1 = A1:C1\n E1 = A2\n");
    assert_eq!(list(&dependents(&graph, &["B1"])), "B1 C1 D1");
    assert_eq!(order(&graph, &["A1"]), ["A1", "B1", "C1", "D1"]);
    assert_eq!(order(&graph, &["A2"]), ["A2", "C1", "D1", "E1"]);
}

#[test]
fn a_range_of_the_whole_sheet_costs_nothing() {
    let graph = graph("A1 = B1:ZZZ1000000\n A2 = C3:D4\n A3 = C4:C4\n");
    assert_eq!(users(&graph, "C4"), "A1 A2 A3");
    assert_eq!(users(&graph, "ZZZ1000000"), "A1");
    assert_eq!(users(&graph, "A9"), "");
}

#[test]
fn linking_again_forgets_the_old_ranges() {
    let mut graph = graph("A1 = B1:C9 + D1\n");
    graph.link(at("A1"), Mentions::default());
    assert!(users(&graph, "B2").is_empty() && users(&graph, "D1").is_empty());
    assert!(graph.ranges.around(at("B2")).is_empty());
}

#[test]
fn circles_are_walked_cell_by_cell() {
    let graph = graph("A1 = B2\n B2 = C1:C5\n C3 = A1\n D1 = A1\n E1 = E1\n");
    let dirty = dependents(&graph, &["A1", "E1"]);
    let stages = graph.stages(&dirty);
    let rounds: Vec<String> = stages
        .iter()
        .filter_map(|stage| match stage {
            Stage::Circle(circle) => Some(circle.rounds.values().map(|r| list_in_order(r))),
            Stage::Compute(_) => None,
        })
        .flatten()
        .collect();
    assert_eq!(rounds, ["A1 B2 C3", "A1 B2 C3", "A1 B2 C3", "E1"]);
    assert!(stages.contains(&Stage::Compute(at("D1"))));
}

fn list_in_order(cells: &[Address]) -> String {
    cells.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

#[test]
fn a_long_chain_and_a_long_circle_do_not_overflow() {
    let cell = |row| Address::new(1, row).unwrap();
    let mut graph = Graph::default();
    for row in 2..=100_000 {
        let cells = BTreeSet::from([cell(row - 1)]);
        graph.link(cell(row), Mentions { cells, ..Default::default() });
    }
    let dirty = dependents(&graph, &["A1"]);
    assert_eq!(graph.stages(&dirty).len(), 100_000);
    let cells = BTreeSet::from([cell(100_000)]);
    graph.link(cell(1), Mentions { cells, ..Default::default() });
    let stages = graph.stages(&dirty);
    assert!(matches!(&stages[0], Stage::Circle(circle) if circle.rounds.len() == 100_000));
}
