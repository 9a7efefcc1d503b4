//! How often each filter loses the truth, although it starts with a set that contains the initial error.

use setrep::{Matrix, Membership, Zonotope};

use crate::inzsmf::cases::TABLE_I;
use crate::inzsmf::errors::{Error, euclidean_errors, invariant_errors};
use crate::inzsmf::published::{Coordinates, PublishedFilter, PublishedGain, Settings};
use crate::inzsmf::sound::{SoundInZsmf, SoundZsmf, Variant};
use crate::inzsmf::study::truth_of;
use crate::inzsmf::tracking::Tracker;
use crate::noise::NoiseKind;
use crate::vehicle::{INITIAL_POSE, Pose, TruePose, Truth};
use crate::{Context, Mode, ScenarioError, monte_carlo};

/// Steps of a run.
pub const STEPS: usize = 400;
/// Every so many steps the gauge is computed also where containment is proven.
const GAUGE_STRIDE: usize = 10;
/// Noises of the study.
pub const KINDS: [NoiseKind; 4] = NoiseKind::ALL;

/// A filter of the study. The initial set is `diag(1.05 |e_0| + 0.05)` in its own coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Watched {
    /// ZSMF with a sound reduction to 30 generators.
    Zsmf,
    /// InZSMF with a sound reduction to 30 generators.
    InZsmf,
    /// ZSMF with the signed box sum.
    ZsmfSigned,
    /// InZSMF with the signed box sum and the gain of the current step.
    InZsmfSigned,
}

impl Watched {
    /// All filters of the study.
    pub const ALL: [Self; 4] = [Self::Zsmf, Self::InZsmf, Self::ZsmfSigned, Self::InZsmfSigned];

    /// Method and mode in the rows.
    #[must_use]
    pub fn name(self) -> (&'static str, Mode) {
        match self {
            Self::Zsmf => ("zsmf", Mode::Sound),
            Self::InZsmf => ("inzsmf", Mode::Sound),
            Self::ZsmfSigned => ("zsmf", Mode::Published),
            Self::InZsmfSigned => ("inzsmf/current-gain", Mode::Published),
        }
    }

    fn start(self, initial: Pose) -> Result<Box<dyn Watchable>, ScenarioError> {
        let coordinates = match self {
            Self::Zsmf | Self::ZsmfSigned => Coordinates::Euclidean,
            Self::InZsmf | Self::InZsmfSigned => Coordinates::LeftInvariant,
        };
        let radii = initial_radii(coordinates, initial)?;
        let signed = || {
            let settings =
                Settings { lagging_gain: false, ..Settings::of_the_tables(coordinates, PublishedGain::FRadius) };
            PublishedFilter::new(settings, initial, radii)
        };
        Ok(match self {
            Self::Zsmf => Box::new(SoundZsmf::new(&Variant::of_the_paper(), initial, radii)?),
            Self::InZsmf => Box::new(SoundInZsmf::new(&Variant::of_the_paper(), initial, radii)?),
            Self::ZsmfSigned | Self::InZsmfSigned => Box::new(signed()),
        })
    }
}

/// `1.05 |e_0| + 0.05` for the initial error in the given coordinates.
fn initial_radii(coordinates: Coordinates, initial: Pose) -> Result<[f64; 3], ScenarioError> {
    let truth = TruePose::new(INITIAL_POSE);
    let errors = match coordinates {
        Coordinates::Euclidean => euclidean_errors(&truth, &initial, 0.0),
        Coordinates::LeftInvariant => invariant_errors(&truth, &TruePose::new(initial).enclosure(), 0.0)?,
    };
    // With no reach beyond the principal value, there is one candidate.
    Ok(errors.first().map_or([0.05; 3], |error| error.map(|e| 1.05 * e.mag() + 0.05)))
}

/// A filter whose error set can be compared with the truth.
pub trait Watchable: Tracker {
    /// The set of errors, around zero, in the filter's coordinates.
    ///
    /// # Errors
    /// Those of the set's constructor.
    fn error_set(&self) -> Result<Zonotope, ScenarioError>;

    /// All errors that stand for the truth, as intervals: one for every full turn whose heading lies within `reach_rad`, and the
    /// principal one first.
    ///
    /// # Errors
    /// Those of the logarithm.
    fn errors(&self, truth: &TruePose, reach_rad: f64) -> Result<Vec<Error>, ScenarioError>;
}

impl Watchable for PublishedFilter {
    fn error_set(&self) -> Result<Zonotope, ScenarioError> {
        let entries: Vec<f64> = self.columns().iter().flat_map(|column| [column[0], column[1], column[2]]).collect();
        Ok(Zonotope::new(&[0.0; 3], &Matrix::from_column_slice(3, self.columns().len(), &entries)?)?)
    }

    fn errors(&self, truth: &TruePose, reach_rad: f64) -> Result<Vec<Error>, ScenarioError> {
        match self.coordinates() {
            Coordinates::Euclidean => Ok(euclidean_errors(truth, &self.center(), reach_rad)),
            Coordinates::LeftInvariant => invariant_errors(truth, &TruePose::new(self.center()).enclosure(), reach_rad),
        }
    }
}

/// What became of one run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RunTally {
    /// Steps looked at.
    pub steps: usize,
    /// Steps at which truth and set are proven disjoint.
    pub violated: usize,
    /// Steps at which the truth is proven inside.
    pub proven: usize,
    /// Largest gauge: the factor by which the set would have to grow to reach the truth (approximate).
    pub gauge: f64,
}

/// All runs of one filter, initial estimate and noise.
#[derive(Clone, Debug, PartialEq)]
pub struct Tally {
    /// Index in [`TABLE_I`].
    pub case: usize,
    /// The noises.
    pub kind: NoiseKind,
    /// The filter.
    pub watched: Watched,
    /// Run by run.
    pub runs: Vec<RunTally>,
}

impl Tally {
    /// Runs with a violation.
    #[must_use]
    pub fn runs_violated(&self) -> usize {
        self.runs.iter().filter(|run| run.violated > 0).count()
    }

    /// Largest gauge of all runs.
    #[must_use]
    pub fn largest_gauge(&self) -> f64 {
        self.runs.iter().fold(0.0, |largest, run| largest.max(run.gauge))
    }
}

/// Runs the study; every `stride`-th step is looked at, the first one always.
///
/// # Errors
/// Those of the filters and sets.
pub fn study(context: &Context<'_>, runs: usize, stride: usize) -> Result<Vec<Tally>, ScenarioError> {
    let mut plan = Vec::new();
    for kind in KINDS {
        for watched in Watched::ALL {
            plan.extend((0..TABLE_I.len()).map(|case| (kind, watched, case)));
        }
    }
    let by_run = monte_carlo::run(context, "inzsmf containment", runs, |run, _| {
        let truths = KINDS.map(|kind| truth_of(context, kind, STEPS, run));
        let mut tallies = Vec::with_capacity(plan.len());
        for (truth, plan) in truths.into_iter().zip(plan.chunk_by(|a, b| a.0 == b.0)) {
            let truth = truth?;
            for &(_, watched, case) in plan {
                tallies.push(watch_from(&truth, watched, TABLE_I[case].pose, stride)?);
            }
        }
        Ok::<_, ScenarioError>(tallies)
    })?;
    let tally = |(index, &(kind, watched, case)): (usize, &(NoiseKind, Watched, usize))| Tally {
        case,
        kind,
        watched,
        runs: by_run.iter().map(|run| run[index]).collect(),
    };
    Ok(plan.iter().enumerate().map(tally).collect())
}

/// Follows one run from an initial estimate, with a first set that contains the initial error.
///
/// # Errors
/// Those of the filter and of the sets.
pub fn watch_from(truth: &Truth, watched: Watched, initial: Pose, stride: usize) -> Result<RunTally, ScenarioError> {
    watch(truth, &mut *watched.start(initial)?, stride)
}

/// Follows one run.
fn watch(truth: &Truth, filter: &mut dyn Watchable, stride: usize) -> Result<RunTally, ScenarioError> {
    let mut tally = RunTally::default();
    for (k, output) in truth.outputs.iter().enumerate() {
        filter.step(*output)?;
        if k % stride == 0 {
            look(&truth.states[k + 1], filter, k % GAUGE_STRIDE == 0, &mut tally)?;
        }
    }
    Ok(tally)
}

/// Three-valued comparison of one step. The gauge of a step with proven containment is below 1; it is computed only if asked for.
fn look(
    truth: &TruePose,
    filter: &dyn Watchable,
    gauge_inside: bool,
    tally: &mut RunTally,
) -> Result<(), ScenarioError> {
    let set = filter.error_set()?;
    let reach_rad = set.interval_hull()[0].mag();
    let errors = match filter.errors(truth, reach_rad) {
        // Half a turn off, where the logarithm jumps: nothing is proven of this step.
        Err(ScenarioError::Group(_)) => {
            tally.steps += 1;
            return Ok(());
        }
        errors => errors?,
    };
    let memberships = errors.iter().map(|error| set.membership(error)).collect::<Result<Vec<_>, _>>()?;
    tally.steps += 1;
    let proven = memberships.contains(&Membership::ProvenInside);
    tally.proven += usize::from(proven);
    tally.violated += usize::from(memberships.iter().all(|membership| *membership == Membership::ProvenOutside));
    if proven && !gauge_inside {
        return Ok(());
    }
    let mut gauge = f64::INFINITY;
    for error in &errors {
        gauge = gauge.min(set.gauge_approx(&error.map(|e| e.mid()))?);
    }
    tally.gauge = tally.gauge.max(gauge);
    Ok(())
}
