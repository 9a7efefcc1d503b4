//! Experiment `unicycle`: Example II of paper 004, a robot with distances and bearings of two landmarks.
//!
//! Reading order: [`plant`], [`report`].

pub mod plant;
pub mod report;

use estimators::VhOptions;

use crate::noise::NoiseKind;
use crate::polytopes::cost::{Cost, cost_rows, costs};
use crate::polytopes::sizes::study_sizes;
use crate::polytopes::tables::{self, PaperVolumes};
use crate::polytopes::{frames, methods};
use crate::set_study::{Cell, Contender, Trajectory, timing};
use crate::{Context, Experiment, Output, Results, Row, ScenarioError, monte_carlo};

/// Steps after the first one.
pub const STEPS: usize = 4;

/// Volumes of Table III.
pub const TABLE_III: &PaperVolumes = &[
    ("rrsr", [0.3022e-4, 0.4012e-4, 0.3022e-4, 0.4002e-4, 0.3021e-4]),
    ("vh", [0.3000e-4, 0.3001e-4, 0.4000e-4, 0.4000e-4, 0.3000e-4]),
    ("d-zb", [0.3001e-4, 0.5011e-4, 0.3012e-4, 0.3002e-4, 0.3021e-4]),
    ("d-cz", [0.3022e-4, 0.4001e-4, 0.4002e-4, 0.4011e-4, 0.4000e-4]),
];

/// Seconds of Table III, averaged over `k = 1 ..= 4`.
const SECONDS: [(&str, f64); 4] = [("rrsr", 1.1366), ("vh", 62.191), ("d-zb", 132.86), ("d-cz", 4.0671)];

/// Example II of paper 004: Table III, Figure 3.
#[derive(Clone, Copy, Debug)]
pub struct UnicycleExperiment;

impl Experiment for UnicycleExperiment {
    fn name(&self) -> &'static str {
        "unicycle"
    }

    fn describe(&self) -> &'static str {
        "paper 004, Example II: polytopic sets of a robot with nonlinear measurements (Table III, Figure 3)"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let runs = context.runs_or(20, 4);
        let studies = studies(context, runs)?;
        let first = trajectory(context, Setting::NOISY, 0)?;
        let contenders = contenders(Setting::NOISY)?;
        let images = frames::images(&plant::Robot { is_noisy: true }, plant::points(1.0), STEPS)?;
        let mut figures = Vec::new();
        for (name, axes, labels) in [
            ("figure-3-position", [0, 1], ["s_x [m]", "s_y [m]"]),
            ("figure-3-heading", [0, 2], ["s_x [m]", "theta [rad]"]),
        ] {
            let outlines = frames::outlines(&first, &contenders, axes)?;
            let title = (name, "Projections of the sets after the update, first run, with process noise");
            figures.push(frames::figure(title, (axes, labels), &outlines, &images, &first));
        }
        let mut costed = Vec::new();
        for setting in [Setting::NOISY, Setting::QUIET] {
            let filter = plant::case(setting.is_noisy, setting.scale)?.vh(VhOptions::paper())?;
            costed.push((setting, costs(&trajectory(context, setting, 0)?, filter)?));
        }

        let mut results = Results::new(self.name(), context.seed, runs);
        results.rows = rows(&studies);
        let timings = timings(&first, &contenders, &costed)?;
        let report = report::report(&results, &timings, &studies, &costed);
        Ok(Output { results, timings, report, figures, curves: Vec::new() })
    }
}

/// What varies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting {
    /// With process noise, in the estimator and in the truth.
    pub is_noisy: bool,
    /// Factor of the half-widths of `X_0`.
    pub scale: f64,
    /// The noises.
    pub kind: NoiseKind,
}

impl Setting {
    /// With process noise.
    pub const NOISY: Self = Self { is_noisy: true, scale: 1.0, kind: NoiseKind::Uniform };
    /// With process noise and an `X_0` five times wider, which fits Table III at `k = 0`.
    pub const WIDE: Self = Self { scale: 5.0, ..Self::NOISY };
    /// Without process noise.
    pub const QUIET: Self = Self { is_noisy: false, ..Self::NOISY };
    /// With process noise, all noises at vertices of their bounds.
    pub const VERTICES: Self = Self { kind: NoiseKind::Vertices, ..Self::NOISY };
    /// All of them.
    pub const ALL: [Self; 4] = [Self::NOISY, Self::WIDE, Self::QUIET, Self::VERTICES];

    /// For the rows.
    #[must_use]
    pub fn label(&self) -> String {
        let start = if self.scale == 1.0 { "X0" } else { "X0x5" };
        let noise = if self.is_noisy { "with W" } else { "without W" };
        match self.kind {
            NoiseKind::Uniform => format!("{start}, {noise}"),
            kind => format!("{start}, {noise}, {}", kind.name()),
        }
    }

    /// Name of the random streams, the same for every `X_0`.
    fn stream(&self) -> String {
        format!("unicycle, {}, {}", if self.is_noisy { "with W" } else { "without W" }, self.kind.name())
    }
}

/// The runs of all filters in one setting.
#[derive(Debug, Clone)]
pub struct Study {
    /// The setting.
    pub setting: Setting,
    /// The filters.
    pub cells: Vec<Cell>,
}

impl Study {
    /// The cell of a filter.
    #[must_use]
    pub fn cell(&self, method: &str) -> Option<&Cell> {
        self.cells.iter().find(|cell| cell.method == method)
    }
}

/// All filters; COMB, which costs most, with process noise drawn uniformly only.
///
/// # Errors
/// None: the sizes fit.
pub fn contenders(setting: Setting) -> Result<Vec<Contender>, ScenarioError> {
    let case = plant::case(setting.is_noisy, setting.scale)?;
    let with_comb = setting.is_noisy && setting.kind == NoiseKind::Uniform;
    let names = methods::PAPER.iter().chain(&methods::DEFAULTS).filter(|name| with_comb || **name != "comb");
    Ok(names.filter_map(|name| case.contender(name)).collect())
}

/// One study a setting.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven; those of the filters.
pub fn studies(context: &Context<'_>, runs: usize) -> Result<Vec<Study>, ScenarioError> {
    let of = |setting: Setting| {
        let simulate = |rng: &mut _| plant::simulate(setting.is_noisy, setting.kind, STEPS, rng);
        let contenders = contenders(setting)?;
        let cells = study_sizes(context, &setting.stream(), runs, simulate, contenders)?;
        Ok(Study { setting, cells })
    };
    Setting::ALL.into_iter().map(of).collect()
}

/// The trajectory of one run of a study.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven.
pub fn trajectory(context: &Context<'_>, setting: Setting, run: usize) -> Result<Trajectory, ScenarioError> {
    let mut rng = monte_carlo::stream(context.seed, &setting.stream(), run);
    plant::simulate(setting.is_noisy, setting.kind, STEPS, &mut rng)
}

/// All rows of `results.json`. The paper's settings are not known, so its numbers are for reference.
fn rows(studies: &[Study]) -> Vec<Row> {
    let mut rows = Vec::new();
    for study in studies {
        for cell in &study.cells {
            rows.extend(tables::rows("Table III", &study.setting.label(), cell, "m^2 rad", TABLE_III, false));
        }
    }
    rows
}

/// Times of a step, one filter after the other on one thread, and the cost of V-H in interval hulls.
fn timings(
    trajectory: &Trajectory,
    contenders: &[Contender],
    costed: &[(Setting, Vec<Cost>)],
) -> Result<Vec<Row>, ScenarioError> {
    let mut rows = Vec::new();
    let label = Setting::NOISY.label();
    for contender in contenders {
        let times = timing::phase_times(trajectory, contender)?;
        let paper = SECONDS.iter().find(|(name, _)| *name == contender.method).map(|(_, seconds)| *seconds);
        rows.extend(timing::rows("Table III", &label, contender, &times, None).into_iter().map(|row| {
            match paper.filter(|_| row.metric_name() == "ART") {
                Some(seconds) => row.paper_ref(seconds),
                None => row,
            }
        }));
    }
    for (setting, costs) in costed {
        rows.extend(cost_rows("Table III", &setting.label(), costs));
    }
    Ok(rows)
}
