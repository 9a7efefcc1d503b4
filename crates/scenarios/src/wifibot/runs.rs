//! Monte Carlo runs along a drive: noise on the fixes and the first heading are drawn, the drive is the log's.

use rand::RngExt;
use setrep::{Membership, Reduction};

use crate::metrics::{RunMetrics, RunSums, wrap_angle};
use crate::noise::{BoundedNoise, NoiseKind};
use crate::truth::output_within;
use crate::vehicle::Pose;
use crate::wifibot::drive::Drive;
use crate::wifibot::filters::{Filter, Settings};
use crate::{Context, ScenarioError, monte_carlo};

/// Filters compared: name, whether invariant, reduction.
pub const METHODS: [(&str, bool, (Reduction, usize)); 4] = [
    ("zsmf", false, (Reduction::Combastel, 30)),
    ("inzsmf", true, (Reduction::Combastel, 30)),
    ("zsmf/girard-60", false, (Reduction::Girard, 60)),
    ("inzsmf/girard-60", true, (Reduction::Girard, 60)),
];

/// The state of a filter at a window end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Centre of the set.
    pub center: Pose,
    /// Heading error of the centre, rad in `(-pi, pi]`.
    pub heading_error_rad: f64,
    /// Distance of the centre from the reference position, m.
    pub position_error_m: f64,
    /// Widths of the box `(theta, x1, x2)`.
    pub widths: [f64; 3],
    /// Whether reference and set are proven disjoint.
    pub lost: bool,
    /// Whether the reference is proven inside.
    pub proven: bool,
}

/// One run of one filter.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The papers' metrics.
    pub metrics: RunMetrics,
    /// Window by window.
    pub steps: Vec<Step>,
}

impl Run {
    /// Share of steps at which reference and set are not proven disjoint, in percent.
    #[must_use]
    pub fn containment(&self) -> f64 {
        self.share(|step| !step.lost)
    }

    /// Share of steps at which the reference is proven inside, in percent.
    #[must_use]
    pub fn contained_proven(&self) -> f64 {
        self.share(|step| step.proven)
    }

    fn share(&self, holds: impl Fn(&Step) -> bool) -> f64 {
        100.0 * self.steps.iter().filter(|step| holds(step)).count() as f64 / self.steps.len() as f64
    }
}

/// All runs of all [`METHODS`]: outer index the method, inner the run.
///
/// # Errors
/// Those of the filters, and [`ScenarioError::Setting`] if no float is a fix within the bound.
pub fn runs(
    context: &Context<'_>,
    name: &str,
    drive: &Drive,
    fix_bound_m: f64,
    runs: usize,
) -> Result<Vec<Vec<Run>>, ScenarioError> {
    let by_run = monte_carlo::run(context, name, runs, |_, rng| {
        let heading_rad = std::f64::consts::PI * (2.0 * rng.random::<f64>() - 1.0);
        let mut noise = BoundedNoise::new(NoiseKind::Uniform, [fix_bound_m; 2]);
        let fixes = drive.reference.iter().map(|pose| fix(pose, noise.draw(rng), fix_bound_m));
        let fixes = fixes.collect::<Result<Vec<_>, _>>()?;
        METHODS.iter().map(|method| follow(drive, method, fix_bound_m, heading_rad, &fixes)).collect()
    })?;
    let of_method = |index: usize| by_run.iter().map(|run: &Vec<Run>| run[index].clone()).collect();
    Ok((0..METHODS.len()).map(of_method).collect())
}

/// The reference position plus noise, within the bound of it whatever the rounding.
fn fix(reference: &Pose, noise: [f64; 2], bound: f64) -> Result<[f64; 2], ScenarioError> {
    let coordinate = |i: usize| {
        let position = scalars::Interval::point(reference.position[i]);
        let too_small = ScenarioError::Setting { name: "fix bound [m]", expected: "some ulps of the position", value: bound };
        output_within(&position, noise[i], bound).ok_or(too_small)
    };
    Ok([coordinate(0)?, coordinate(1)?])
}

/// One filter along one series of fixes.
fn follow(
    drive: &Drive,
    &(_, invariant, reduction): &(&str, bool, (Reduction, usize)),
    fix_bound_m: f64,
    heading_rad: f64,
    fixes: &[[f64; 2]],
) -> Result<Run, ScenarioError> {
    let settings = Settings { increment_bounds: drive.bounds, fix_bound_m, reduction };
    let start = Pose { heading_rad, position: fixes[0] };
    let mut filter =
        if invariant { Filter::invariant(&settings, start)? } else { Filter::euclidean(&settings, start)? };
    let (mut sums, mut steps) = (RunSums::default(), Vec::with_capacity(drive.increments.len()));
    for ((increment, fix), reference) in drive.increments.iter().zip(fixes).zip(&drive.reference[1..]) {
        filter.step(increment, *fix)?;
        let (center, widths) = (filter.center(), filter.widths()?);
        let heading_error_rad = wrap_angle(reference.heading_rad - center.heading_rad);
        let position_error =
            [reference.position[0] - center.position[0], reference.position[1] - center.position[1]];
        sums.add_step(heading_error_rad, position_error, widths);
        let (set, errors) = filter.errors(*reference)?;
        let memberships = errors.iter().map(|error| set.membership(error)).collect::<Result<Vec<_>, _>>()?;
        steps.push(Step {
            center,
            heading_error_rad,
            position_error_m: position_error[0].hypot(position_error[1]),
            widths,
            lost: memberships.iter().all(|membership| *membership == Membership::ProvenOutside),
            proven: memberships.contains(&Membership::ProvenInside),
        });
    }
    Ok(Run { metrics: sums.metrics(), steps })
}
