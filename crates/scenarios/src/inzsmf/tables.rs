//! Rows of `results.json` from the cells of the studies.

use crate::inzsmf::cases::{Cells, TABLE_I, TABLE_II, TABLE_II_CASE};
use crate::inzsmf::containment::{RunTally, Tally};
use crate::inzsmf::study::{Cell, Contender, find};
use crate::metrics::RunMetrics;
use crate::{Mode, Row};

/// Name of the table of the sound reductions and orders.
pub const ORDERS: &str = "orders and reductions";
/// Name of the table of the containment study.
pub const CONTAINMENT: &str = "containment";

/// How the paper's number stands beside ours.
#[derive(Clone, Copy, Debug)]
enum Paper {
    /// Same settings.
    Reproduced(Cells),
    /// Other settings.
    ForReference(Cells),
    /// The paper has no such cell.
    None,
}

/// Table I in `published` and in `sound` mode.
#[must_use]
pub fn table_i(cells: &[Cell]) -> Vec<Row> {
    let mut rows = Vec::new();
    for (case, estimate) in TABLE_I.iter().enumerate() {
        let (zsmf, inzsmf) = (estimate.paper_zsmf, estimate.paper_inzsmf);
        let wanted = [
            ("zsmf", Mode::Published, Paper::Reproduced(zsmf)),
            ("inzsmf", Mode::Published, Paper::Reproduced(inzsmf)),
            ("inzsmf/current-gain", Mode::Published, Paper::ForReference(inzsmf)),
            ("inzsmf/world-box", Mode::Published, Paper::ForReference(inzsmf)),
            ("zsmf", Mode::Sound, Paper::ForReference(zsmf)),
            ("inzsmf", Mode::Sound, Paper::ForReference(inzsmf)),
        ];
        for (method, mode, paper) in wanted {
            rows.extend(find(cells, case, method, mode).iter().flat_map(|cell| rows_of("Table I", cell, paper)));
        }
    }
    rows
}

/// Table II in `published` and in `sound` mode.
#[must_use]
pub fn table_ii(cells: &[Cell]) -> Vec<Row> {
    let mut rows = Vec::new();
    for mode in [Mode::Published, Mode::Sound] {
        for (method, _, paper) in TABLE_II {
            let paper = if mode == Mode::Published { Paper::Reproduced(paper) } else { Paper::ForReference(paper) };
            let cell = find(cells, TABLE_II_CASE, method, mode);
            rows.extend(cell.iter().flat_map(|cell| rows_of("Table II", cell, paper)));
        }
    }
    let world = find(cells, TABLE_II_CASE, "inzsmf/pole-world-box", Mode::Published);
    rows.extend(world.iter().flat_map(|cell| rows_of("Table II", cell, Paper::ForReference(TABLE_II[1].2))));
    rows
}

/// The sound filters with other orders and reductions.
#[must_use]
pub fn orders(cells: &[Cell]) -> Vec<Row> {
    cells.iter().flat_map(|cell| rows_of(ORDERS, cell, Paper::None)).collect()
}

/// The containment study: one row a metric, filter, initial estimate and noise.
#[must_use]
pub fn containment(tallies: &[Tally]) -> Vec<Row> {
    tallies.iter().flat_map(containment_rows).collect()
}

fn containment_rows(tally: &Tally) -> [Row; 4] {
    let (method, mode) = tally.watched.name();
    let label = format!("{};{}", tally.kind.name(), TABLE_I[tally.case].label);
    let row = |metric, unit| Row::new(CONTAINMENT, &*label, method).mode(mode).metric(metric, unit);
    let share = |count: fn(&RunTally) -> usize| -> Vec<f64> {
        tally.runs.iter().map(|run| count(run) as f64 / run.steps as f64).collect()
    };
    [
        row("containment", "").mean_of(&share(|run| run.steps - run.violated)),
        row("contained_proven", "").mean_of(&share(|run| run.proven)),
        row("gauge_max", "").value(tally.largest_gauge()),
        row("runs_violated", "runs").value(tally.runs_violated() as f64),
    ]
}

/// Wall-clock time of one step, in the rows of `timings.json`: `ART` in s beside the paper's, and `ns_per_step`.
#[must_use]
pub fn timings(times: &[(usize, &Contender, f64)]) -> Vec<Row> {
    let rows = |&(case, contender, seconds): &(usize, &Contender, f64)| {
        let row = |metric, unit| {
            Row::new("ART", TABLE_I[case].label, &*contender.method).mode(contender.mode).metric(metric, unit)
        };
        let art = row("ART", "s").value(seconds);
        let of_table_ii = || TABLE_II.iter().find(|paper| paper.0 == contender.method).map(|paper| paper.1);
        let paper = match &*contender.method {
            "zsmf" => Some(TABLE_I[case].paper_step_time_s[0]),
            "inzsmf" => Some(TABLE_I[case].paper_step_time_s[1]),
            _ => of_table_ii(),
        };
        [paper.map_or(art.clone(), |paper| art.paper_ref(paper)), row("ns_per_step", "ns").value(1e9 * seconds)]
    };
    times.iter().flat_map(rows).collect()
}

/// The four metrics of a cell, each beside the paper's.
fn rows_of(table: &str, cell: &Cell, paper: Paper) -> Vec<Row> {
    let row = |(metric, (name, unit)): (usize, (&str, &str))| {
        let row = Row::new(table, TABLE_I[cell.case].label, &*cell.method).mode(cell.mode).metric(name, unit);
        let row = match paper {
            Paper::Reproduced(numbers) => row.paper(numbers[metric]),
            Paper::ForReference(numbers) => row.paper_ref(numbers[metric]),
            Paper::None => row,
        };
        row.mean_of(&cell.samples(metric))
    };
    RunMetrics::NAMES.into_iter().enumerate().map(row).collect()
}
