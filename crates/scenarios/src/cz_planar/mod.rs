//! Experiment `cz-planar`: Example 5.1 of paper 003, a planar system with nonlinear measurements and no invariant.
//!
//! Reading order: [`plant`], [`snapshots`] (the sets of the first steps), [`figures`], [`tables`], [`report`].

pub mod figures;
pub mod plant;
pub mod report;
pub mod snapshots;
pub mod tables;

use setrep::Complexity;

use crate::noise::NoiseKind;
use crate::set_study::{Case, Cell, Contender, RADIUS, Trajectory, study, timing};
use crate::{Context, Experiment, Mode, Output, Results, Row, ScenarioError, monte_carlo};

/// The filters, in the order of the tables.
pub const METHODS: [&str; 6] = ["zmv", "zfo", "czmv", "czfo", "rcz", "rcz/cheap"];
/// Noises of the study.
pub const KINDS: [NoiseKind; 3] = [NoiseKind::Uniform, NoiseKind::Vertices, NoiseKind::ConstantVertex];
/// Steps of a run: full size, quick.
const STEPS: (usize, usize) = (40, 20);

/// Example 5.1 of paper 003: Figures 2 and 3, Table 2.
#[derive(Clone, Copy, Debug)]
pub struct PlanarExperiment;

impl Experiment for PlanarExperiment {
    fn name(&self) -> &'static str {
        "cz-planar"
    }

    fn describe(&self) -> &'static str {
        "paper 003, Example 5.1: zonotopes against constrained zonotopes on nonlinear measurements (Figures 2 and 3, Table 2)"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let (runs, steps) = (context.runs_or(100, 8), if context.quick { STEPS.1 } else { STEPS.0 });
        let contenders = contenders()?;
        let studies = studies(context, runs, steps, &contenders)?;
        let first = trajectory_of(context, NoiseKind::Uniform, steps, 0)?;
        let snapshots = snapshots::take(&first, &contenders)?;
        let timings = timings(&first, &contenders)?;

        let mut results = Results::new(self.name(), context.seed, runs);
        results.rows = tables::rows(&studies);
        let report = report::report(&results, &timings, &studies, first.widest(), steps);
        let figures = vec![figures::figure_2(&snapshots), figures::figure_3(&studies)];
        Ok(Output { results, timings, report, figures, curves: Vec::new() })
    }
}

/// The filters with the paper's limits.
///
/// # Errors
/// None: the sizes of the plant fit.
pub fn contenders() -> Result<Vec<Contender>, ScenarioError> {
    let case = Case {
        system: plant::system()?,
        start: plant::start()?,
        limit: Complexity { generators: 8, constraints: 3 },
        feasible: Vec::new(),
    };
    case.contenders(&METHODS, Mode::Rigorous)
}

/// The runs of all filters with noises of one kind.
#[derive(Debug, Clone)]
pub struct Study {
    /// The noises.
    pub kind: NoiseKind,
    /// The filters.
    pub cells: Vec<Cell>,
}

/// One study a kind of noise.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven; those of the filters.
pub fn studies(
    context: &Context<'_>,
    runs: usize,
    steps: usize,
    contenders: &[Contender],
) -> Result<Vec<Study>, ScenarioError> {
    let of = |kind: NoiseKind| {
        let simulate = |rng: &mut _| plant::simulate(kind, steps, rng);
        Ok(Study { kind, cells: study(context, &label(kind), runs, simulate, contenders, &[RADIUS])? })
    };
    KINDS.into_iter().map(of).collect()
}

/// The trajectory of one run of a study.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven.
pub fn trajectory_of(
    context: &Context<'_>,
    kind: NoiseKind,
    steps: usize,
    run: usize,
) -> Result<Trajectory, ScenarioError> {
    plant::simulate(kind, steps, &mut monte_carlo::stream(context.seed, &label(kind), run))
}

/// Name of the random streams.
fn label(kind: NoiseKind) -> String {
    format!("cz-planar, {}", kind.name())
}

/// Times of a step, one filter after the other on one thread.
fn timings(trajectory: &Trajectory, contenders: &[Contender]) -> Result<Vec<Row>, ScenarioError> {
    let mut rows = Vec::new();
    for contender in contenders {
        let times = timing::phase_times(trajectory, contender)?;
        let paper = tables::TABLE_2.iter().find(|paper| paper.0 == contender.method).map(|paper| paper.1);
        rows.extend(timing::rows("Table 2", NoiseKind::Uniform.name(), contender, &times, paper));
    }
    Ok(rows)
}
