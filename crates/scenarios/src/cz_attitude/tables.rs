//! The rows of the experiment.

use super::contenders::{PRINTED_NOISE, is_zonotopic};
use super::paper::{METHODS, TABLE_3, index_of};
use super::plant::START_RADIUS;
use super::studies::{Bound, JUDGED, LARGER_STEPS, Studies, TABLE_STEPS};
use crate::set_study::ratios::average_ratios;
use crate::set_study::rows::row_of;
use crate::set_study::{Cell, RADIUS, ratios, rows};
use crate::{Mode, Row};

/// Table of the radii.
pub const RADII: &str = "Figures 5 and 6";
/// Ratios at the printed bound.
pub const RATIOS: &str = "Table 3";
/// Ratios at the smaller bound.
pub const SMALLER_RATIOS: &str = "Table 3 at |v|<=0.10";
/// Ratios of rigorous filters alone.
pub const RIGOROUS_RATIOS: &str = "Table 3, all rigorous";
/// Convergence at several bounds.
pub const SEARCH: &str = "Bounds";
/// Steps at which radii are listed.
pub const STEPS: [usize; 12] = [0, 1, 2, 5, 10, 16, 20, 30, 40, 100, 150, 190];
/// Averages of the acceptance figures go up to this step.
pub const AVERAGED: usize = 40;
/// A run has converged if its radius is at most this share of that of `X_0`.
pub const CONVERGED: f64 = 1.0 / 3.0;
/// Cells within this factor of the paper's count as reproduced.
pub const AGREEMENT: f64 = 1.35;

/// All rows.
#[must_use]
pub fn rows(studies: &Studies) -> Vec<Row> {
    let [printed, smaller] = &studies.tables;
    let mut all: Vec<Row> = studies.tables.iter().flat_map(radii).collect();
    all.extend(table_3(RATIOS, printed));
    all.extend(table_3(SMALLER_RATIOS, smaller));
    for over in &printed.rigorous {
        all.extend(printed.rigorous.iter().map(|of| ratios::row(RIGOROUS_RATIOS, of, over)));
    }
    for bound in &studies.search {
        all.extend(bound.rigorous.iter().flat_map(|cell| converged(&bound.label(), cell)));
    }
    let larger = &studies.larger;
    all.extend(
        larger
            .rigorous
            .iter()
            .flat_map(|cell| rows::at_steps(RADII, &larger.label(), cell, (0, RADIUS), &[0, 20, LARGER_STEPS])),
    );
    for (kind, cells) in &studies.containment {
        all.extend(cells.iter().flat_map(|cell| rows::containment(kind.name(), cell)));
    }
    all
}

fn radii(bound: &Bound) -> Vec<Row> {
    let label = bound.label();
    let of = |cell: &Cell| {
        let radius = (0, RADIUS);
        let steps = cell.runs.first().map_or(0, |run| run.values[0].len());
        let listed: Vec<usize> = STEPS.into_iter().filter(|&k| k < steps).collect();
        let mut rows = rows::at_steps(RADII, &label, cell, radius, &listed);
        rows.push(rows::mean_to(RADII, &label, cell, radius, AVERAGED));
        rows.push(rows::mean(RADII, &label, cell, radius));
        rows
    };
    bound.published.iter().chain(&bound.rigorous).flat_map(of).collect()
}

/// Every filter over every other one, beside the paper's ratio.
fn table_3(table: &str, bound: &Bound) -> Vec<Row> {
    let cells = bound.table();
    let ratio = |over: &Cell, of: &Cell| {
        let row = ratios::row(table, of, over);
        match paper_ratio(over, of) {
            Some(paper) if bound.steps() == TABLE_STEPS && reproduces(bound.noise, over, of) => row.paper(paper),
            Some(paper) => row.paper_ref(paper),
            None => row,
        }
    };
    cells.iter().flat_map(|over| cells.iter().map(|of| ratio(over, of))).collect()
}

/// The paper's number for the ratio of two filters.
#[must_use]
pub fn paper_ratio(over: &Cell, of: &Cell) -> Option<f64> {
    Some(TABLE_3[index_of(&over.method)?][index_of(&of.method)?])
}

/// Whether the settings of a cell are those that reproduce the paper's: zonotopes on the printed dynamics, at the printed bound; the others
/// at the smaller one.
fn reproduces(noise: f64, over: &Cell, of: &Cell) -> bool {
    let zonotopic = is_zonotopic(&over.method) && is_zonotopic(&of.method);
    zonotopic == (noise == PRINTED_NOISE)
}

/// A filter's ratio over ZMV as published, in a study of the tables.
#[must_use]
pub fn over_zmv(bound: &Bound, method: &str) -> Option<f64> {
    let cells = bound.table();
    let find = |method: &str| cells.iter().find(|cell| cell.method == method);
    let ratios = average_ratios(find(method)?, find(METHODS[0])?);
    Some(ratios.iter().sum::<f64>() / ratios.len() as f64)
}

/// Radius and share of converged runs at the step at which convergence is judged.
fn converged(label: &str, cell: &Cell) -> Vec<Row> {
    let mut rows = rows::at_steps(SEARCH, label, cell, (0, RADIUS), &[JUDGED]);
    rows.push(rows::convergence(SEARCH, label, cell, 0, JUDGED, CONVERGED * START_RADIUS));
    let largest = cell.at(0, JUDGED).into_iter().fold(0.0, f64::max);
    rows.push(row_of(SEARCH, label, cell).metric(format!("max(radius)@{JUDGED}"), "").value(largest));
    rows
}

/// True for the zonotope filters as published.
#[must_use]
pub fn is_published(cell: &Cell) -> bool {
    cell.mode == Mode::Published
}
