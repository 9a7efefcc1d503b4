//! Rows of `results.json`.

use crate::guaranteed_invariant::broken::Broken;
use crate::guaranteed_invariant::lever_run::{LeverRun, LeverStep};
use crate::guaranteed_invariant::lever_study::Runs;
use crate::guaranteed_invariant::noise::Drive;
use crate::guaranteed_invariant::planar::{Cell, Loss, SETTLED, STRIPS, Sizes};
use crate::guaranteed_invariant::settings::{FIX_EVERY, LOOKED_AT_S, SETTINGS, Setting};
use crate::inzsmf::cases::TABLE_I;
use crate::inzsmf::containment::RunTally;
use crate::region::Containment;
use crate::results::Status;
use crate::{Mode, Row};

/// Table of the sizes on paper 000's experiment.
pub const SIZES: &str = "sizes";
/// Table of the containment there.
pub const CONTAINMENT: &str = "containment";
/// Table of the runs with broken bounds.
pub const BROKEN: &str = "broken bounds";
/// Table of Problem 3.
pub const LEVER: &str = "scale and lever arm";

// The names of the metrics say the step.
const _: () = assert!(SETTLED == 200);

/// Sizes of every cell, beside the paper's where the noise is the paper's.
#[must_use]
pub fn sizes(cells: &[Cell]) -> Vec<Row> {
    cells.iter().flat_map(size_rows).collect()
}

/// Name, unit and value.
type Metric<T> = (&'static str, &'static str, fn(&T) -> f64);

fn size_rows(cell: &Cell) -> Vec<Row> {
    let label = cell_label(cell.drive, cell.case);
    let row = |metric: &str, unit: &str| Row::new(SIZES, &*label, &*cell.method).mode(cell.mode).metric(metric, unit);
    let samples = |of: fn(&Sizes) -> f64| cell.runs.iter().map(of).collect::<Vec<f64>>();
    let strips = cell.method == STRIPS;
    let paper = cell
        .case
        .filter(|_| cell.drive == Drive::Uniform)
        .map(|case| if cell.method == "zsmf" { TABLE_I[case].paper_zsmf } else { TABLE_I[case].paper_inzsmf });
    let whole: [Metric<Sizes>; 2] = [("AAR(theta)", "rad", |run| run.whole[0]), ("AAR(x)", "m^2", |run| run.whole[1])];
    let mut rows: Vec<Row> = whole
        .iter()
        .enumerate()
        .map(|(index, (metric, unit, of))| {
            let row = row(metric, unit).mean_of(&samples(*of));
            paper.map_or(row.clone(), |paper| row.paper_ref(paper[2 + index]))
        })
        .collect();
    let settled: [Metric<Sizes>; 2] =
        [("AAR(theta)@200..", "rad", |run| run.settled[0]), ("AAR(x)@200..", "m^2", |run| run.settled[1])];
    rows.extend(settled.iter().map(|(metric, unit, of)| row(metric, unit).mean_of(&samples(*of))));
    if strips {
        let most = |of: fn(&Sizes) -> f64| samples(of).into_iter().fold(0.0, f64::max);
        rows.extend([
            row("AAR(theta)@200../largest", "rad").value(most(|run| run.settled[0])),
            row("AAR(x)@200../largest", "m^2").value(most(|run| run.settled[1])),
            row("rows/largest", "").value(most(|run| run.most_rows as f64)),
            row("programs a step", "").mean_of(&samples(|run| run.programs)),
        ]);
    }
    rows
}

/// Noise and start.
#[must_use]
pub fn cell_label(drive: Drive, case: Option<usize>) -> String {
    format!("{};{}", drive.name(), case.map_or("unknown heading", |case| TABLE_I[case].label))
}

/// Containment of all filters.
#[must_use]
pub fn containment(cells: &[Cell], losses: &[Loss]) -> Vec<Row> {
    let strips = cells.iter().flat_map(|cell| {
        let row = |metric: &str, unit: &str| {
            Row::new(CONTAINMENT, cell_label(cell.drive, cell.case), STRIPS).mode(Mode::Rigorous).metric(metric, unit)
        };
        let shares: Vec<_> = cell.runs.iter().filter_map(|run| run.containment.shares()).collect();
        let contradictions = cell.runs.iter().filter(|run| run.contradiction.is_some()).count();
        [
            row("containment", "").mean_of(&shares.iter().map(|share| share.0).collect::<Vec<_>>()),
            row("contained_proven", "").mean_of(&shares.iter().map(|share| share.1).collect::<Vec<_>>()),
            row("runs_violated", "runs").value(shares.iter().filter(|share| share.0 < 1.0).count() as f64),
            row("contradictions", "runs").value(contradictions as f64),
        ]
    });
    let losses = losses.iter().flat_map(|loss| {
        let (method, mode) = loss.watched.name();
        let label = cell_label(loss.drive, Some(loss.case));
        let row = |metric: &str, unit: &str| Row::new(CONTAINMENT, &*label, method).mode(mode).metric(metric, unit);
        let share = |count: fn(&RunTally) -> usize| -> Vec<f64> {
            loss.runs.iter().map(|run| count(run) as f64 / run.steps as f64).collect()
        };
        let violated = loss.runs.iter().filter(|run| run.violated > 0).count();
        [
            row("containment", "").mean_of(&share(|run| run.steps - run.violated)),
            row("contained_proven", "").mean_of(&share(|run| run.proven)),
            row("runs_violated", "runs").value(violated as f64),
        ]
    });
    strips.chain(losses).collect()
}

/// Steps of the proofs that bounds were broken.
#[must_use]
pub fn broken(studies: &[Broken]) -> Vec<Row> {
    let rows = |study: &Broken| {
        let label = format!("{};noise {} times its bounds", study.drive.name(), study.excess);
        let row =
            |metric: &str, unit: &str| Row::new(BROKEN, &*label, STRIPS).mode(Mode::Rigorous).metric(metric, unit);
        let found = study.found();
        let latest = found.iter().copied().fold(0.0, f64::max);
        let latest = row("contradiction-step/latest", "").value(latest);
        [
            row("contradiction-step", "").mean_of(&found),
            if found.is_empty() { latest.status(Status::Undefined) } else { latest },
            row("contradictions", "runs").value(found.len() as f64),
        ]
    };
    studies.iter().flat_map(rows).collect()
}

/// Problem 3: widths, and how they stand to the reference.
#[must_use]
pub fn lever(studies: &[Runs]) -> Vec<Row> {
    let run = SETTINGS.iter().zip(studies).filter(|(_, runs)| !runs.is_empty());
    run.flat_map(|(setting, runs)| lever_rows(setting, runs)).collect()
}

fn lever_rows(setting: &Setting, runs: &[LeverRun]) -> Vec<Row> {
    let row =
        |metric: String, unit: &str| Row::new(LEVER, setting.label, STRIPS).mode(Mode::Rigorous).metric(metric, unit);
    let mut rows = Vec::new();
    let mut ratios = Vec::new();
    let mut width = |name: &str, unit: &str, second: usize, reference: f64, of: fn(&LeverStep) -> f64| {
        let samples: Vec<f64> = runs.iter().filter_map(|run| run.at(second * FIX_EVERY)).map(of).collect();
        rows.push(row(format!("width({name})@{second}s"), unit).mean_of(&samples));
        if second == LOOKED_AT_S[2] {
            let largest = samples.iter().copied().fold(0.0, f64::max);
            rows.push(row(format!("width({name})@{second}s/largest"), unit).value(largest));
        }
        let mean = samples.iter().sum::<f64>() / samples.len() as f64;
        ratios.push(row(format!("width({name})@{second}s / reference"), "").value(mean / reference));
    };
    for (second, reference) in LOOKED_AT_S.into_iter().zip(setting.reference.heading_rad) {
        width("theta", "rad", second, reference, |step| step.heading_rad);
    }
    let last = LOOKED_AT_S[2];
    width("s", "", last, setting.reference.scale, |step| step.scale.width());
    width("X1", "m", last, setting.reference.arm_m[0], |step| step.arm_m[0].width());
    width("X2", "m", last, setting.reference.arm_m[1], |step| step.arm_m[1].width());
    rows.extend(ratios);
    rows.extend(containment_of(runs).map(|(metric, unit, value)| row(metric.to_owned(), unit).value(value)));
    rows.push(row("rows/largest".to_owned(), "").value(runs.iter().map(|run| run.most_rows).max().unwrap_or(0) as f64));
    rows
}

/// Containment over all runs: name, unit, value.
#[must_use]
pub fn containment_of(runs: &[LeverRun]) -> [(&'static str, &'static str, f64); 3] {
    let all = runs.iter().map(LeverRun::containment).fold(Containment::default(), |mut all, run| {
        all.points += run.points;
        all.not_outside += run.not_outside;
        all.inside += run.inside;
        all
    });
    let (kept, proven) = all.shares().unwrap_or((f64::NAN, f64::NAN));
    let contradictions = runs.iter().filter(|run| run.contradiction.is_some()).count();
    [("containment", "", kept), ("contained_proven", "", proven), ("contradictions", "runs", contradictions as f64)]
}
