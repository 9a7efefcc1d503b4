//! Study (a): the vehicle of paper 000 with four kinds of noise, from eight initial estimates and from an unknown heading.

use crate::guaranteed_invariant::follow::{Start, StripRun};
use crate::guaranteed_invariant::noise::{Drive, VERTICES, truth_of};
use crate::inzsmf::cases::{STEPS, TABLE_I};
use crate::inzsmf::containment::{RunTally, Watched, watch_from};
use crate::inzsmf::sound::Variant;
use crate::inzsmf::study::Contender;
use crate::inzsmf::tracking::track;
use crate::region::Containment;
use crate::vehicle::Truth;
use crate::{Context, Mode, ScenarioError, inzsmf, monte_carlo};

/// First step of the means "from k = 200".
pub const SETTLED: usize = 200;
/// Every so many steps the containment of the first-order filters is looked at.
pub const WATCH_STRIDE: usize = 10;

/// One run of one filter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sizes {
    /// Means over `k = 1..=N` of heading width and area.
    pub whole: [f64; 2],
    /// The same from step [`SETTLED`] on.
    pub settled: [f64; 2],
    /// Truth and set compared (filter of strips only).
    pub containment: Containment,
    /// Largest number of rows (filter of strips only).
    pub most_rows: usize,
    /// Linear programs a step (filter of strips only).
    pub programs: f64,
    /// Step of a proven contradiction (filter of strips only).
    pub contradiction: Option<usize>,
}

/// A start: unknown heading, or an index in [`TABLE_I`].
pub type Case = Option<usize>;

/// All runs of one filter, noise and start.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// The noises.
    pub drive: Drive,
    /// The start.
    pub case: Case,
    /// The filter's name.
    pub method: String,
    /// Its mode.
    pub mode: Mode,
    /// Run by run.
    pub runs: Vec<Sizes>,
}

/// Containment of a first-order filter that starts with a set that holds the truth.
#[derive(Clone, Debug, PartialEq)]
pub struct Loss {
    /// The noises.
    pub drive: Drive,
    /// Index in [`TABLE_I`].
    pub case: usize,
    /// The filter.
    pub watched: Watched,
    /// Run by run.
    pub runs: Vec<RunTally>,
}

/// Name of the filter in the rows.
pub const STRIPS: &str = "invariant-strips";

/// How much is run.
#[derive(Clone, Debug)]
pub struct Scale {
    /// Runs a cell.
    pub runs: usize,
    /// Initial estimates, as indices in [`TABLE_I`].
    pub cases: Vec<usize>,
    /// Vertices that are held for a whole run.
    pub vertices: Vec<u8>,
}

impl Scale {
    /// Ten runs of all; in quick mode a tenth of that.
    #[must_use]
    pub fn of(context: &Context<'_>) -> Self {
        let quick = context.quick;
        Self {
            runs: context.runs_or(10, 1),
            cases: if quick { vec![5] } else { (0..TABLE_I.len()).collect() },
            vertices: (0..VERTICES).filter(|number| !quick || number % 16 == 3).collect(),
        }
    }
}

/// Runs the filter of strips: every noise from an unknown heading and from the initial estimates, then every single vertex.
///
/// # Errors
/// Those of the filter and of the simulator.
pub fn strips(context: &Context<'_>, scale: &Scale) -> Result<Vec<Cell>, ScenarioError> {
    let cases: Vec<Case> = std::iter::once(None).chain(scale.cases.iter().copied().map(Some)).collect();
    let plan: Vec<(Drive, Case)> =
        Drive::ALL.into_iter().flat_map(|drive| cases.iter().map(move |&case| (drive, case))).collect();
    let total = plan.len() * scale.runs;
    let runs = monte_carlo::run(context, "invariant strips", total, |index, _| {
        let (drive, case) = plan[index / scale.runs];
        let truth = truth_of(context, drive, 1.0, STEPS + 1, index % scale.runs)?;
        sizes(&truth, start(case))
    })?;
    let vertices = monte_carlo::run(context, "invariant strips, vertices", scale.vertices.len(), |index, _| {
        sizes(&truth_of(context, Drive::Vertex(scale.vertices[index]), 1.0, STEPS + 1, 0)?, Start::UnknownHeading)
    })?;
    let cell = |(&(drive, case), runs): (&(Drive, Case), &[Sizes])| strip_cell(drive, case, runs.into());
    let mut cells: Vec<Cell> = plan.iter().zip(runs.chunks(scale.runs)).map(cell).collect();
    cells.push(strip_cell(Drive::Vertex(0), None, vertices));
    Ok(cells)
}

fn strip_cell(drive: Drive, case: Case, runs: Vec<Sizes>) -> Cell {
    Cell { drive, case, method: STRIPS.to_owned(), mode: Mode::Rigorous, runs }
}

fn start(case: Case) -> Start {
    case.map_or(Start::UnknownHeading, |case| Start::Near(TABLE_I[case].pose))
}

fn sizes(truth: &Truth, start: Start) -> Result<Sizes, ScenarioError> {
    let run = StripRun::new(truth, start, |_, _| Ok(()))?;
    Ok(Sizes {
        whole: run.means(1),
        settled: run.means(SETTLED),
        containment: run.containment(),
        most_rows: run.most_rows,
        programs: run.programs as f64 / truth.outputs.len() as f64,
        contradiction: run.contradiction,
    })
}

/// The paper's filters, published and sound, on the same noises.
///
/// # Errors
/// Those of the filters.
pub fn first_order(context: &Context<'_>, scale: &Scale) -> Result<Vec<Cell>, ScenarioError> {
    let contenders = first_order_contenders()?;
    let mut cells = Vec::new();
    for drive in Drive::ALL {
        let by_run = monte_carlo::run(context, "paper's filters", scale.runs, |run, _| {
            let truth = truth_of(context, drive, 1.0, STEPS, run)?;
            let mut sizes = Vec::new();
            for &case in &scale.cases {
                for contender in &contenders {
                    sizes.push(followed(&truth, contender, case)?);
                }
            }
            Ok::<_, ScenarioError>(sizes)
        })?;
        for (position, &case) in scale.cases.iter().enumerate() {
            for (index, contender) in contenders.iter().enumerate() {
                let column = position * contenders.len() + index;
                let runs = by_run.iter().map(|sizes| sizes[column]).collect();
                let (method, mode) = (contender.method.clone(), contender.mode);
                cells.push(Cell { drive, case: Some(case), method, mode, runs });
            }
        }
    }
    Ok(cells)
}

/// ZSMF and InZSMF with the paper's numbers, and with valid reductions.
///
/// # Errors
/// Those of the gains.
pub fn first_order_contenders() -> Result<Vec<Contender>, ScenarioError> {
    let published = inzsmf::published::contenders()?.into_iter().filter(|c| !c.method.contains('/'));
    Ok(published.chain(Variant::of_the_paper().contenders()).collect())
}

fn followed(truth: &Truth, contender: &Contender, case: usize) -> Result<Sizes, ScenarioError> {
    let mut settled = [0.0; 2];
    let metrics = track(truth, &mut *contender.start(TABLE_I[case].pose)?, |k, step| {
        if k >= SETTLED {
            settled[0] += step.widths[0];
            settled[1] += step.widths[1] * step.widths[2];
        }
    })?;
    let count = (truth.outputs.len() + 1 - SETTLED) as f64;
    let whole = [metrics.aar_heading, metrics.aar_position];
    Ok(Sizes { whole, settled: settled.map(|sum| sum / count), ..Sizes::default() })
}

/// How often the paper's filters lose the truth on the same noises.
///
/// # Errors
/// Those of the filters and sets.
pub fn losses(context: &Context<'_>, scale: &Scale) -> Result<Vec<Loss>, ScenarioError> {
    let mut losses = Vec::new();
    let plan: Vec<(usize, Watched)> =
        scale.cases.iter().flat_map(|&case| Watched::ALL.into_iter().map(move |watched| (case, watched))).collect();
    for drive in Drive::ALL {
        let by_run = monte_carlo::run(context, "paper's filters, containment", scale.runs, |run, _| {
            let truth = truth_of(context, drive, 1.0, STEPS, run)?;
            let tallies =
                plan.iter().map(|&(case, watched)| watch_from(&truth, watched, TABLE_I[case].pose, WATCH_STRIDE));
            tallies.collect::<Result<Vec<_>, ScenarioError>>()
        })?;
        losses.extend(plan.iter().enumerate().map(|(index, &(case, watched))| Loss {
            drive,
            case,
            watched,
            runs: by_run.iter().map(|tallies| tallies[index]).collect(),
        }));
    }
    Ok(losses)
}
