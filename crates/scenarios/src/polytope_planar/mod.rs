//! Experiment `polytope-planar`: Example I of paper 004, a planar system with linear measurements.
//!
//! Reading order: [`plant`], [`report`].

pub mod plant;
pub mod report;

use plant::Form;

use crate::noise::NoiseKind;
use crate::polytopes::cost::{Cost, cost_rows, costs};
use crate::polytopes::sizes::study_sizes;
use crate::polytopes::tables::{self, PaperVolumes};
use crate::polytopes::{PolytopeCase, frames, methods};
use crate::set_study::{Cell, Contender, Trajectory, timing};
use crate::{Context, Experiment, Output, Results, Row, ScenarioError, monte_carlo};
use estimators::VhOptions;

/// Steps after the first one.
pub const STEPS: usize = 4;

/// Volumes of Table II.
pub const TABLE_II: &PaperVolumes = &[
    ("rrsr", [0.3496, 0.5926, 0.6288, 0.5780, 0.4120]),
    ("vh", [0.3496, 0.5489, 0.5826, 0.4077, 0.2306]),
    ("d-zb", [0.3496, 0.5691, 0.5877, 0.5661, 0.4266]),
    ("d-cz", [0.3496, 0.6226, 0.6077, 0.5936, 0.4676]),
    ("comb", [0.3496, 0.5405, 0.5625, 0.4033, 0.2302]),
];

/// Runs of the paper.
pub const PAPER_RUNS: usize = 50;

/// Seconds of Table II, averaged over `k = 1 ..= 4`.
const SECONDS: [(&str, f64); 5] =
    [("rrsr", 0.9611), ("vh", 0.6732), ("d-zb", 3.4758), ("d-cz", 2.7642), ("comb", 7.1332)];

/// Example I of paper 004: Table II, Figure 2.
#[derive(Clone, Copy, Debug)]
pub struct PolytopePlanarExperiment;

impl Experiment for PolytopePlanarExperiment {
    fn name(&self) -> &'static str {
        "polytope-planar"
    }

    fn describe(&self) -> &'static str {
        "paper 004, Example I: direct polytopic sets against constrained zonotopes and bundles (Table II, Figure 2)"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let runs = context.runs_or(50, 8);
        let studies = studies(context, runs)?;
        let first = trajectory(context, NoiseKind::Uniform, 0)?;
        let contenders = contenders(Form::Cas, 3.0)?;
        let outlines = frames::outlines(&first, &contenders, [0, 1])?;
        let images = frames::images(&plant::Step, plant::points(3.0), STEPS)?;
        let figure = frames::figure(
            (
                "figure-2",
                "Sets after the update, first run; X0 with tripled generators, Jacobian as printed by a computer algebra system",
            ),
            ([0, 1], ["x1", "x2"]),
            &outlines,
            &images,
            &first,
        );
        let costs = costs(&first, plant::case(Form::Cas, 3.0)?.vh(VhOptions::paper())?)?;

        let mut results = Results::new(self.name(), context.seed, runs);
        results.rows = rows(&studies);
        let timings = timings(&first, &contenders, &costs)?;
        let report = report::report(&results, &timings, &studies, &costs);
        Ok(Output { results, timings, report, figures: vec![figure], curves: Vec::new() })
    }
}

/// The runs of all filters with one first set, form and kind of noise.
#[derive(Debug, Clone)]
pub struct Study {
    /// Factor of the generators of `X_0`.
    pub scale: f64,
    /// The Jacobian.
    pub form: Form,
    /// The noises.
    pub kind: NoiseKind,
    /// The filters.
    pub cells: Vec<Cell>,
}

impl Study {
    /// What varies, for the rows.
    #[must_use]
    pub fn label(&self) -> String {
        let start = if self.scale == 1.0 { "X0 as printed" } else { "X0x3" };
        match self.kind {
            NoiseKind::Uniform => start.to_owned(),
            kind => format!("{start}, {}", kind.name()),
        }
    }

    /// The cell of a filter.
    #[must_use]
    pub fn cell(&self, method: &str) -> Option<&Cell> {
        self.cells.iter().find(|cell| cell.method == method)
    }

    /// Whether table and form are those that the paper's numbers fit.
    #[must_use]
    pub fn reproduces(&self) -> bool {
        self.scale != 1.0 && self.form == Form::Cas && self.kind == NoiseKind::Uniform
    }
}

/// The filters of the paper; with the tight Jacobian the default ones as well.
///
/// # Errors
/// None: the sizes fit.
pub fn contenders(form: Form, scale: f64) -> Result<Vec<Contender>, ScenarioError> {
    let case: PolytopeCase = plant::case(form, scale)?;
    let defaults: &[&str] = if form == Form::Tight { &methods::DEFAULTS } else { &[] };
    Ok(methods::PAPER.iter().chain(defaults).filter_map(|name| case.contender(name)).collect())
}

/// Both first sets and both forms with uniform noise; the tripled set with noise at its vertices. All have the same noises run by run.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven; those of the filters.
pub fn studies(context: &Context<'_>, runs: usize) -> Result<Vec<Study>, ScenarioError> {
    let uniform = [(3.0, Form::Cas), (3.0, Form::Tight), (1.0, Form::Cas), (1.0, Form::Tight)];
    let all = uniform
        .map(|(scale, form)| (scale, form, NoiseKind::Uniform))
        .into_iter()
        .chain([(3.0, Form::Cas, NoiseKind::Vertices), (3.0, Form::Tight, NoiseKind::Vertices)]);
    all.map(|(scale, form, kind)| {
        let simulate = |rng: &mut _| plant::simulate(kind, STEPS, rng);
        let contenders = contenders(form, scale)?;
        let cells = study_sizes(context, &stream(kind), runs, simulate, contenders)?;
        Ok(Study { scale, form, kind, cells })
    })
    .collect()
}

/// The trajectory of one run of a study.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven.
pub fn trajectory(context: &Context<'_>, kind: NoiseKind, run: usize) -> Result<Trajectory, ScenarioError> {
    plant::simulate(kind, STEPS, &mut monte_carlo::stream(context.seed, &stream(kind), run))
}

/// Name of the random streams.
fn stream(kind: NoiseKind) -> String {
    format!("polytope-planar, {}", kind.name())
}

/// All rows of `results.json`.
fn rows(studies: &[Study]) -> Vec<Row> {
    let mut rows = Vec::new();
    for study in studies {
        for cell in &study.cells {
            rows.extend(tables::rows("Table II", &study.label(), cell, "", TABLE_II, study.reproduces()));
        }
    }
    rows
}

/// Times of a step, one filter after the other on one thread, and the cost of V-H in interval hulls.
fn timings(trajectory: &Trajectory, contenders: &[Contender], costs: &[Cost]) -> Result<Vec<Row>, ScenarioError> {
    let mut rows = Vec::new();
    for contender in contenders {
        let times = timing::phase_times(trajectory, contender)?;
        let paper = SECONDS.iter().find(|(name, _)| *name == contender.method).map(|(_, seconds)| *seconds);
        rows.extend(timing::rows("Table II", "X0x3", contender, &times, None).into_iter().map(|row| {
            match paper.filter(|_| row.metric_name() == "ART") {
                Some(seconds) => row.paper_ref(seconds),
                None => row,
            }
        }));
    }
    rows.extend(cost_rows("Table II", "X0x3", costs));
    Ok(rows)
}
