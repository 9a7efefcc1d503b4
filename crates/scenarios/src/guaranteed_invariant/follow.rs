//! The filter of strips along the vehicle of paper 000: sizes and containment at every step, and where it finds a contradiction.

use estimators::{
    Estimator, EstimatorError, InvariantStrips, PlanarBox, PlanarIncrement, PlanarMeasurement, StripsOptions,
};
use scalars::Interval;
use setrep::Membership;

use crate::ScenarioError;
use crate::region::Containment;
use crate::vehicle::{OUTPUT_BOUNDS, Pose, SPEED, TruePose, Truth};

/// Half width of the first heading interval around an initial estimate, rad: holds the paper's errors of up to half pi.
pub const HEADING_PRIOR_RAD: f64 = 1.65;
/// Half width of the first position box, m: holds the paper's errors of up to 5 m.
pub const POSITION_PRIOR_M: f64 = 5.3;

/// `[-b, b]`.
#[must_use]
pub fn within(bound: f64) -> Interval {
    let b = Interval::point(bound.abs());
    (-b).hull(b)
}

/// What the filter is told at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// Any heading, a position box around the origin.
    UnknownHeading,
    /// Heading and position within the priors of an initial estimate.
    Near(Pose),
}

impl Start {
    /// The first set.
    #[must_use]
    pub fn prior(self) -> PlanarBox {
        let position = |at: [f64; 2]| at.map(|x| Interval::point(x) + within(POSITION_PRIOR_M));
        match self {
            Self::UnknownHeading => PlanarBox::se2(Interval::ENTIRE, position([0.0; 2])),
            Self::Near(pose) => {
                let heading = Interval::point(pose.heading_rad) + within(HEADING_PRIOR_RAD);
                PlanarBox::se2(heading, position(pose.position))
            }
        }
    }
}

/// The motion of a period: exact decimals, and noises in the paper's bounds.
#[must_use]
pub fn increment() -> PlanarIncrement {
    let period = Interval::ratio(1, 100);
    let noise = within((period * Interval::decimal("0.1")).hi());
    let tangent = [period * Interval::decimal("0.4"), period.scale(SPEED), Interval::ZERO];
    PlanarIncrement::exponential(tangent, [noise; 3])
}

/// The set at one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripStep {
    /// Bounds of the heading minus the true heading, rad, each in `(-pi, pi]`; none if any heading is possible.
    pub heading_off_rad: Option<[f64; 2]>,
    /// Width of the heading, rad.
    pub heading_width_rad: f64,
    /// Area of the position box, m^2.
    pub area: f64,
    /// Whether the truth is in the set.
    pub membership: Membership,
}

/// One run; step `k` is the set after the output of time `k`, `k = 0..`.
#[derive(Clone, Debug, PartialEq)]
pub struct StripRun {
    /// The steps before a contradiction, if there is one.
    pub steps: Vec<StripStep>,
    /// Step whose output is proven to contradict the bounds.
    pub contradiction: Option<usize>,
    /// Largest number of rows.
    pub most_rows: usize,
    /// Linear programs of all updates.
    pub programs: usize,
}

impl StripRun {
    /// Runs the filter along all outputs, calling `visit` after each.
    ///
    /// # Errors
    /// Those of the filter, but for a proven contradiction, which ends the run.
    pub fn new(
        truth: &Truth,
        start: Start,
        mut visit: impl FnMut(usize, &mut InvariantStrips) -> Result<(), ScenarioError>,
    ) -> Result<Self, ScenarioError> {
        let mut filter = InvariantStrips::new(&start.prior(), StripsOptions::pose())?;
        let increment = increment();
        let mut run =
            Self { steps: Vec::with_capacity(truth.outputs.len()), contradiction: None, most_rows: 0, programs: 0 };
        for (k, output) in truth.outputs.iter().enumerate() {
            if k > 0 {
                filter.predict(&increment)?;
            }
            match filter.update(&[PlanarMeasurement::position(*output, OUTPUT_BOUNDS.map(within))]) {
                Err(EstimatorError::Inconsistent(_)) => {
                    run.contradiction = Some(k);
                    return Ok(run);
                }
                other => other?,
            }
            run.most_rows = run.most_rows.max(filter.num_rows());
            run.programs += filter.programs();
            run.steps.push(StripStep::of(&filter, &truth.states[k])?);
            visit(k, &mut filter)?;
        }
        Ok(run)
    }

    /// Means over the steps `from..` of heading width (rad) and area (m^2).
    #[must_use]
    pub fn means(&self, from: usize) -> [f64; 2] {
        let steps = self.steps.get(from..).unwrap_or_default();
        let mean = |of: fn(&StripStep) -> f64| steps.iter().map(of).sum::<f64>() / steps.len() as f64;
        [mean(|step| step.heading_width_rad), mean(|step| step.area)]
    }

    /// Containment counted over the steps.
    #[must_use]
    pub fn containment(&self) -> Containment {
        let mut containment = Containment::default();
        self.steps.iter().for_each(|step| containment.add(step.membership));
        containment
    }
}

impl StripStep {
    fn of(filter: &InvariantStrips, truth: &TruePose) -> Result<Self, ScenarioError> {
        let set = filter.enclosure();
        let heading = truth.heading.value();
        let off = |end: f64| crate::metrics::wrap_angle(end - heading);
        let [theta, x1, x2] = truth.coordinates();
        Ok(Self {
            heading_off_rad: set.heading_ends_rad().map(|(lo, hi)| [off(lo), off(hi)]),
            heading_width_rad: set.heading_width_rad(),
            area: set.position_area(),
            membership: membership(filter, &PlanarBox::se2(theta, [x1, x2]))?,
        })
    }
}

/// Whether a state known to lie in a box lies in the set.
///
/// # Errors
/// A box of another group.
pub fn membership(filter: &InvariantStrips, state: &PlanarBox) -> Result<Membership, ScenarioError> {
    Ok(if filter.excludes(state)? {
        Membership::ProvenOutside
    } else if filter.includes(state)? {
        Membership::ProvenInside
    } else {
        Membership::Undecided
    })
}

#[cfg(test)]
mod tests {
    use crate::Context;
    use crate::guaranteed_invariant::noise::{Drive, truth_of};

    use super::*;

    fn run(drive: Drive, excess: f64, steps: usize) -> StripRun {
        let truth = truth_of(&Context::new(2), drive, excess, steps, 0).unwrap();
        StripRun::new(&truth, Start::UnknownHeading, |_, _| Ok(())).unwrap()
    }

    /// From an unknown heading the truth is never proven outside, also by noises that keep it on the boundary, and the heading becomes known.
    #[test]
    fn short_runs_hold_the_truth() {
        for drive in [Drive::Uniform, Drive::Vertex(5), Drive::Vertex(26)] {
            let run = run(drive, 1.0, 60);
            assert_eq!((run.contradiction, run.steps.len()), (None, 60));
            assert!(run.steps.iter().all(|step| step.membership != Membership::ProvenOutside), "{}", drive.name());
            assert!(run.steps[59].heading_width_rad < 1.5, "{}", run.steps[59].heading_width_rad);
        }
    }

    /// Noises half as large again as their bounds are found out.
    #[test]
    fn broken_bounds_are_proven() {
        assert!(run(Drive::Uniform, 1.5, 100).contradiction.is_some());
    }
}
