//! Courses of the filters over time, for the figures: one run in full, and root mean squares over all runs.

use crate::inzsmf::cases::{STEPS, TABLE_I};
use crate::inzsmf::study::{Contender, truth_of};
use crate::inzsmf::tracking::{TrackedStep, track};
use crate::noise::NoiseKind;
use crate::vehicle::Truth;
use crate::{Context, Mode, ScenarioError, monte_carlo};

/// What one filter did from one initial estimate.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// Index in [`TABLE_I`].
    pub case: usize,
    /// The filter's name.
    pub method: String,
    /// Its mode.
    pub mode: Mode,
    /// Steps `1..=N` of the first run.
    pub first_run: Vec<TrackedStep>,
    /// Root mean square over the runs of the heading error at each step, rad.
    pub rms_heading: Vec<f64>,
    /// Root mean square over the runs of the position error at each step, m.
    pub rms_position: Vec<f64>,
}

/// Courses of several filters, and the truth of the first run.
#[derive(Clone, Debug, PartialEq)]
pub struct Courses {
    /// Truth of the first run.
    pub truth: Truth,
    /// Courses, in the order asked for.
    pub courses: Vec<Course>,
}

impl Courses {
    /// The course of a case, a method and a mode.
    #[must_use]
    pub fn find(&self, case: usize, method: &str, mode: Mode) -> Option<&Course> {
        self.courses.iter().find(|course| course.case == case && course.method == method && course.mode == mode)
    }
}

/// Squared errors at every step of one run.
struct SquaredErrors {
    heading: Vec<f64>,
    position: Vec<f64>,
    steps: Vec<TrackedStep>,
}

/// Records the courses of the pairs (case, contender) over `runs` runs with uniform noises.
///
/// # Errors
/// Those of the filters.
pub fn record(context: &Context<'_>, runs: usize, pairs: &[(usize, &Contender)]) -> Result<Courses, ScenarioError> {
    let by_run = monte_carlo::run(context, "inzsmf figures", runs, |run, _| {
        let truth = truth_of(context, NoiseKind::Uniform, STEPS, run)?;
        let errors = |pair: &(usize, &Contender)| squared_errors(&truth, pair, run == 0);
        pairs.iter().map(errors).collect::<Result<Vec<_>, ScenarioError>>()
    })?;
    let courses = pairs.iter().enumerate().map(|(index, &(case, contender))| {
        let rms = |series: fn(&SquaredErrors) -> &Vec<f64>| {
            let mean_square = |k: usize| by_run.iter().map(|run| series(&run[index])[k]).sum::<f64>() / runs as f64;
            (0..STEPS).map(|k| mean_square(k).sqrt()).collect()
        };
        Course {
            case,
            method: contender.method.clone(),
            mode: contender.mode,
            first_run: by_run.first().map(|run| run[index].steps.clone()).unwrap_or_default(),
            rms_heading: rms(|errors| &errors.heading),
            rms_position: rms(|errors| &errors.position),
        }
    });
    Ok(Courses { truth: truth_of(context, NoiseKind::Uniform, STEPS, 0)?, courses: courses.collect() })
}

fn squared_errors(
    truth: &Truth,
    &(case, contender): &(usize, &Contender),
    keep_steps: bool,
) -> Result<SquaredErrors, ScenarioError> {
    let (mut heading, mut position, mut steps) = (Vec::with_capacity(STEPS), Vec::with_capacity(STEPS), Vec::new());
    track(truth, &mut *contender.start(TABLE_I[case].pose)?, |_, step| {
        heading.push(step.heading_error_rad.powi(2));
        position.push(step.position_error.iter().map(|e| e * e).sum());
        if keep_steps {
            steps.push(*step);
        }
    })?;
    Ok(SquaredErrors { heading, position, steps })
}
