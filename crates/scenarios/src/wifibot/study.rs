//! Runs of the filters along the logs: noise draws on the fixes, wrong first headings.

use setrep::Membership;

use crate::metrics::{RunMetrics, RunSums, wrap_angle};
use crate::noise::{BoundedNoise, NoiseKind};
use crate::vehicle::{Pose, TruePose};
use crate::wifibot::filters::{FIX_BOUND_M, Follower, Method};
use crate::wifibot::odometry::Course;
use crate::{Context, ScenarioError, monte_carlo};

/// Errors of the first headings, degrees.
pub const HEADING_ERRORS_DEG: [f64; 5] = [0.0, 45.0, 90.0, 135.0, 170.0];
/// Step from which the metrics count as converged.
pub const SETTLED: usize = 20;

/// A filter after one fix, beside the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The estimate.
    pub center: Pose,
    /// Heading of the reference minus that of the estimate, rad in `(-pi, pi]`.
    pub heading_error_rad: f64,
    /// Position of the reference minus that of the estimate, m.
    pub position_error: [f64; 2],
    /// Widths of the box of the set (heading, x1, x2).
    pub widths: [f64; 3],
    /// Whether the reference is in the set.
    pub membership: Membership,
}

/// One filter along one log with one first heading and one draw of noise; step `k` is second `k`, the first is 1.
pub type Track = Vec<Step>;

/// Metrics of a track.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// Over all steps.
    pub whole: RunMetrics,
    /// From step [`SETTLED`] on.
    pub settled: RunMetrics,
    /// Share of steps at which the reference is not proven outside.
    pub containment: f64,
    /// Share of steps at which the reference is proven inside.
    pub contained_proven: f64,
}

impl Summary {
    /// The metrics of a track.
    #[must_use]
    pub fn of(track: &[Step]) -> Self {
        let metrics = |steps: &[Step]| {
            let mut sums = RunSums::default();
            for step in steps {
                sums.add_step(step.heading_error_rad, step.position_error, step.widths);
            }
            sums.metrics()
        };
        let share = |is: fn(Membership) -> bool| {
            track.iter().filter(|step| is(step.membership)).count() as f64 / track.len() as f64
        };
        Self {
            whole: metrics(track),
            settled: metrics(track.get(SETTLED - 1..).unwrap_or_default()),
            containment: share(|membership| membership != Membership::ProvenOutside),
            contained_proven: share(|membership| membership == Membership::ProvenInside),
        }
    }
}

/// All tracks of a log, by (first heading, method, run).
#[derive(Clone, Debug)]
pub struct Study {
    runs: Vec<Vec<Track>>,
    /// The fixes of the first run, that of the start first.
    pub first_fixes: Vec<[f64; 2]>,
}

impl Study {
    /// Runs all filters from all first headings with `runs` draws of noise, the same draw for all of them.
    ///
    /// # Errors
    /// Those of the filters and sets.
    pub fn new(context: &Context<'_>, course: &Course, runs: usize) -> Result<Self, ScenarioError> {
        let name = format!("wifibot{}", course.number);
        let runs = monte_carlo::run(context, &name, runs, |_, rng| {
            let mut noise = BoundedNoise::new(NoiseKind::Uniform, [FIX_BOUND_M; 2]);
            let poses = std::iter::once(course.start).chain(course.windows.iter().map(|window| window.end));
            let fixes: Vec<[f64; 2]> = poses
                .map(|pose| {
                    let v = noise.draw(rng);
                    [pose.position[0] + v[0], pose.position[1] + v[1]]
                })
                .collect();
            let mut tracks = Vec::new();
            for degrees in HEADING_ERRORS_DEG {
                for method in Method::ALL {
                    tracks.push(track(course, &fixes, method, degrees)?);
                }
            }
            Ok::<_, ScenarioError>((fixes, tracks))
        })?;
        let (mut fixes, runs): (Vec<_>, Vec<_>) = runs.into_iter().unzip();
        Ok(Self { runs, first_fixes: fixes.swap_remove(0) })
    }

    /// The tracks of a first heading (an index of [`HEADING_ERRORS_DEG`]) and method, one a run.
    pub fn tracks(&self, heading: usize, method: Method) -> impl Iterator<Item = &Track> {
        let column = heading * Method::ALL.len() + method as usize;
        self.runs.iter().filter_map(move |tracks| tracks.get(column))
    }

    /// Draws of noise.
    #[must_use]
    pub fn len(&self) -> usize {
        self.runs.len()
    }

    /// True if there are no runs.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.runs.is_empty()
    }
}

/// The guess at the start: the first fix, and the reference heading turned by `degrees`.
#[must_use]
pub fn guess(course: &Course, first_fix: [f64; 2], degrees: f64) -> Pose {
    Pose { heading_rad: wrap_angle(course.start.heading_rad + degrees.to_radians()), position: first_fix }
}

fn track(course: &Course, fixes: &[[f64; 2]], method: Method, degrees: f64) -> Result<Track, ScenarioError> {
    let mut filter = method.start(&guess(course, fixes[0], degrees), course.bounds())?;
    let mut steps = Vec::with_capacity(course.windows.len());
    for (window, fix) in course.windows.iter().zip(&fixes[1..]) {
        filter.predict(window)?;
        filter.correct(*fix)?;
        steps.push(look(&*filter, &window.end)?);
    }
    Ok(steps)
}

fn look(filter: &dyn Follower, reference: &Pose) -> Result<Step, ScenarioError> {
    let center = filter.center();
    Ok(Step {
        center,
        heading_error_rad: wrap_angle(reference.heading_rad - center.heading_rad),
        position_error: [reference.position[0] - center.position[0], reference.position[1] - center.position[1]],
        widths: filter.widths()?,
        membership: membership(filter, reference)?,
    })
}

/// Whether the reference is in the set, in any of its turns.
fn membership(filter: &dyn Follower, reference: &Pose) -> Result<Membership, ScenarioError> {
    let set = filter.error_set()?;
    let reach_rad = set.interval_hull()[0].mag();
    let errors = match filter.errors(&TruePose::new(*reference), reach_rad) {
        // Half a turn off, where the logarithm jumps: nothing is proven.
        Err(ScenarioError::Group(_)) => return Ok(Membership::Undecided),
        errors => errors?,
    };
    let mut found = Membership::ProvenOutside;
    for error in &errors {
        match set.membership(error)? {
            Membership::ProvenInside => return Ok(Membership::ProvenInside),
            Membership::Undecided => found = Membership::Undecided,
            Membership::ProvenOutside => {}
        }
    }
    Ok(found)
}
