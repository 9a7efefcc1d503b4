//! What an experiment is, what it is given and what it hands back.
//!
//! An experiment computes; it writes and prints nothing. Its [`Output`] turns into named files in memory, which the command line writes.

use std::path::Path;

use crate::{Curve, Figure, Report, Results, Row, ScenarioError};

/// An experiment of a paper, or of ours, that can be run by name.
pub trait Experiment: Sync {
    /// The name on the command line and of the output folder.
    fn name(&self) -> &'static str;

    /// One line for the list of experiments.
    fn describe(&self) -> &'static str;

    /// Runs it.
    ///
    /// # Errors
    /// [`ScenarioError::DataMissing`] if it needs data that is not there (a caller skips it); anything else is a failure.
    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError>;
}

/// All experiments, in the order in which they are run and shown.
#[must_use]
pub fn all() -> Vec<&'static dyn Experiment> {
    vec![
        &crate::inzsmf::InZsmfExperiment,
        &crate::wifibot::WifibotExperiment,
        &crate::wheel_lever::WheelLeverExperiment,
        &crate::wheel_lever_3d::WheelLever3dExperiment,
        &crate::images::ImagesExperiment,
        &crate::cz_planar::PlanarExperiment,
        &crate::cz_attitude::AttitudeExperiment,
        &crate::tank_chain::TankChainExperiment,
        &crate::polytope_planar::PolytopePlanarExperiment,
        &crate::unicycle::UnicycleExperiment,
        &crate::batch_reactor::BatchReactorExperiment,
        &crate::vehicle_polar::VehiclePolarExperiment,
        &crate::guaranteed_invariant::GuaranteedInvariantExperiment,
    ]
}

/// A sign of life: `done` of `total` runs of `label` have ended.
#[derive(Debug, Clone, Copy)]
pub struct Progress<'a> {
    /// What is being run.
    pub label: &'a str,
    /// Runs ended so far.
    pub done: usize,
    /// Runs in all.
    pub total: usize,
}

/// What an experiment is given.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// Seed of all random streams.
    pub seed: u64,
    /// Monte Carlo runs per case, if the user said so.
    pub runs: Option<usize>,
    /// Smaller cases: all of them together take less than two minutes.
    pub quick: bool,
    /// Folder with data that does not ship with the project.
    pub data: Option<&'a Path>,
    /// Called after every run, from any thread.
    pub progress: &'a (dyn Fn(Progress<'_>) + Sync),
}

impl std::fmt::Debug for Context<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { seed, runs, quick, data, progress: _ } = self;
        let mut view = f.debug_struct("Context");
        view.field("seed", seed).field("runs", runs).field("quick", quick).field("data", data).finish_non_exhaustive()
    }
}

impl Context<'_> {
    /// Full-size runs with a seed, no data and silent.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self { seed, runs: None, quick: false, data: None, progress: &|_| {} }
    }

    /// The number of runs: the user's, else `quick` or `full` (at least one).
    #[must_use]
    pub fn runs_or(&self, full: usize, quick: usize) -> usize {
        self.runs.unwrap_or(if self.quick { quick } else { full }).max(1)
    }

    /// How often a run is timed, of which the fastest counts: once in quick mode.
    #[must_use]
    pub fn repetitions(&self, full: usize) -> usize {
        if self.quick { 1 } else { full }
    }

    /// Passes a sign of life on.
    pub fn report(&self, progress: Progress<'_>) {
        (self.progress)(progress);
    }
}

/// What an experiment hands back.
#[derive(Debug, Clone)]
pub struct Output {
    /// The numbers: a function of the seed and the settings alone.
    pub results: Results,
    /// Wall-clock numbers (`ns_per_step`, `ART`), kept apart because they differ from run to run.
    pub timings: Vec<Row>,
    /// The text with tables and figures.
    pub report: Report,
    /// Figures; each is written as SVG with its data as CSV beside it.
    pub figures: Vec<Figure>,
    /// Curves that no figure shows.
    pub curves: Vec<Curve>,
}

/// A file in memory.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct File {
    /// Name within the experiment's folder.
    pub name: String,
    /// Content (all our formats are text).
    pub text: String,
}

impl Output {
    /// The files of the experiment's folder: `report.md`, `results.json`, `timings.json`, figures as SVG and CSV, curves as CSV.
    ///
    /// # Errors
    /// [`ScenarioError::Ragged`] or [`ScenarioError::Serialise`] from the single artefacts.
    pub fn files(&self) -> Result<Vec<File>, ScenarioError> {
        let file = |name: &str, text: String| File { name: name.to_owned(), text };
        let timings = Results {
            rows: self.timings.clone(),
            ..Results::new(&*self.results.experiment, self.results.seed, self.results.runs)
        };
        let mut files = vec![
            file("report.md", self.report.to_markdown()),
            file("results.json", self.results.to_json()?),
            file("timings.json", timings.to_json()?),
        ];
        for figure in &self.figures {
            files.push(file(&format!("{}.svg", figure.name()), figure.to_svg()));
            files.push(file(&format!("{}.csv", figure.name()), figure.data().to_csv()?));
        }
        for curve in &self.curves {
            files.push(file(&format!("{}.csv", curve.name()), curve.to_csv()?));
        }
        Ok(files)
    }
}
