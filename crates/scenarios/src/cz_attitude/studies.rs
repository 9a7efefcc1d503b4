//! The Monte Carlo runs of the experiment.

use super::contenders::{OURS, PRINTED_NOISE, RANGED, SMALLER_NOISE, all, is_zonotopic, published, rigorous};
use super::paper::METHODS;
use super::simulation::simulate;
use crate::noise::NoiseKind;
use crate::set_study::{Cell, Contender, RADIUS, Trajectory, study};
use crate::{Context, ScenarioError, monte_carlo};

/// Noises of the containment study.
pub const KINDS: [NoiseKind; 3] = [NoiseKind::Uniform, NoiseKind::Vertices, NoiseKind::ConstantVertex];
/// Bounds of the search for the paper's.
pub const BOUNDS: [f64; 4] = [0.15, 0.125, 0.10, 0.075];
/// A bound far beyond the paper's, for our filter.
pub const LARGER_NOISE: f64 = 0.25;
/// Steps up to which it is watched.
pub const LARGER_STEPS: usize = 60;
/// Steps of the tables. The paper does not say how many it averages over; at so many its zonotope columns of Table 3 come out.
pub const TABLE_STEPS: usize = 190;
/// The step at which convergence is judged.
pub const JUDGED: usize = 30;

/// How much is run.
#[derive(Debug, Clone, Copy)]
pub struct Scale {
    /// Runs of the containment study.
    pub runs: usize,
    /// Runs of the tables.
    pub table_runs: usize,
    /// Steps of the tables.
    pub steps: usize,
    /// Steps of the search for the bound, if not to [`JUDGED`].
    pub search_steps: usize,
    /// Steps of the containment study.
    pub watched_steps: usize,
}

impl Scale {
    /// Full size or quick.
    #[must_use]
    pub fn of(context: &Context<'_>) -> Self {
        let runs = context.runs_or(100, 2);
        let (table_runs, steps, watched_steps) =
            if context.quick { (runs.min(1), JUDGED, 5) } else { (runs.min(6), TABLE_STEPS, 12) };
        Self { runs, table_runs, steps, search_steps: JUDGED, watched_steps }
    }
}

/// All filters at one bound on the measurement noise.
#[derive(Debug, Clone)]
pub struct Bound {
    /// The bound.
    pub noise: f64,
    /// Rigorous filters.
    pub rigorous: Vec<Cell>,
    /// Zonotope filters on the printed dynamics.
    pub published: Vec<Cell>,
}

impl Bound {
    /// The label of its rows.
    #[must_use]
    pub fn label(&self) -> String {
        label(self.noise)
    }

    /// Steps of its runs.
    #[must_use]
    pub fn steps(&self) -> usize {
        let first = self.rigorous.first().and_then(|cell| cell.runs.first());
        first.map_or(0, |run| run.values[0].len().saturating_sub(1))
    }

    /// The same without zonotope filters.
    fn constrained(&self) -> Self {
        let rigorous = self.rigorous.iter().filter(|cell| !is_zonotopic(&cell.method)).cloned().collect();
        Self { noise: self.noise, rigorous, published: Vec::new() }
    }

    /// The cells of the paper's table in its order, then ours: zonotope filters as published where they were run so.
    #[must_use]
    pub fn table(&self) -> Vec<&Cell> {
        let of = |method: &str| {
            let published = self.published.iter().find(|cell| cell.method == method);
            published.or_else(|| self.rigorous.iter().find(|cell| cell.method == method))
        };
        METHODS.into_iter().chain(OURS).filter_map(of).collect()
    }
}

/// `|v|<=b`.
#[must_use]
pub fn label(noise: f64) -> String {
    if (100.0 * noise).fract().abs() < 1e-9 { format!("|v|<={noise:.2}") } else { format!("|v|<={noise}") }
}

/// All runs.
#[derive(Debug, Clone)]
pub struct Studies {
    /// The printed bound and the smaller one, uniform noises.
    pub tables: [Bound; 2],
    /// Constrained-zonotope filters at all [`BOUNDS`], uniform noises: those of the tables, and runs of [`JUDGED`] steps at the other bounds.
    pub search: Vec<Bound>,
    /// Our filters at [`LARGER_NOISE`].
    pub larger: Bound,
    /// All rigorous filters at the printed bound with every kind of noise.
    pub containment: Vec<(NoiseKind, Vec<Cell>)>,
}

impl Studies {
    /// Runs everything.
    ///
    /// # Errors
    /// [`ScenarioError::Truth`] if a step cannot be proven; those of the filters.
    pub fn run(context: &Context<'_>, scale: &Scale) -> Result<Self, ScenarioError> {
        let table = |noise: f64| {
            let (own, textbook) = (rigorous(noise, &all())?, published(noise)?);
            let cells = uniform(context, noise, (scale.table_runs, scale.steps), own.into_iter().chain(textbook))?;
            let (rigorous, published) = cells.into_iter().partition(|cell| cell.mode == crate::Mode::Rigorous);
            Ok::<_, ScenarioError>(Bound { noise, rigorous, published })
        };
        let some = |noise: f64, runs: usize, steps: usize, names: &[&str]| {
            let cells = uniform(context, noise, (runs, steps), rigorous(noise, names)?)?;
            Ok::<_, ScenarioError>(Bound { noise, rigorous: cells, published: Vec::new() })
        };
        let constrained: Vec<&str> = all().into_iter().filter(|name| !is_zonotopic(name)).collect();
        let watched = |kind: NoiseKind| {
            let label = format!("cz-attitude, {}", kind.name());
            let simulate = |rng: &mut _| simulate(PRINTED_NOISE, kind, scale.watched_steps, rng);
            let contenders = rigorous(PRINTED_NOISE, &all())?;
            Ok((kind, study(context, &label, scale.runs, simulate, &contenders, &[RADIUS])?))
        };
        let tables = [table(PRINTED_NOISE)?, table(SMALLER_NOISE)?];
        let search = BOUNDS.into_iter().map(|noise| match tables.iter().find(|bound| bound.noise == noise) {
            Some(bound) => Ok(bound.constrained()),
            None => some(noise, scale.table_runs, scale.search_steps, &constrained),
        });
        Ok(Self {
            search: search.collect::<Result<_, _>>()?,
            tables,
            larger: some(LARGER_NOISE, scale.table_runs, LARGER_STEPS, &RANGED)?,
            containment: KINDS.into_iter().map(watched).collect::<Result<_, ScenarioError>>()?,
        })
    }
}

/// The trajectory of one run of the tables.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven.
pub fn trajectory_of(
    context: &Context<'_>,
    noise: f64,
    scale: &Scale,
    run: usize,
) -> Result<Trajectory, ScenarioError> {
    simulate(noise, NoiseKind::Uniform, scale.steps, &mut monte_carlo::stream(context.seed, &tables_label(noise), run))
}

/// Name of the random streams of runs at a bound.
fn tables_label(noise: f64) -> String {
    format!("cz-attitude, {}", label(noise))
}

fn uniform(
    context: &Context<'_>,
    noise: f64,
    (runs, steps): (usize, usize),
    contenders: impl IntoIterator<Item = Contender>,
) -> Result<Vec<Cell>, ScenarioError> {
    let contenders: Vec<Contender> = contenders.into_iter().collect();
    let simulate = |rng: &mut _| simulate(noise, NoiseKind::Uniform, steps, rng);
    study(context, &tables_label(noise), runs, simulate, &contenders, &[RADIUS])
}
