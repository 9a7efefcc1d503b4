//! The filter of strips on Problem 3: widths of heading, scale and arm at every fix, containment, contradictions.

use estimators::{
    Culprit, Estimator, EstimatorError, InvariantStrips, PlanarBox, PlanarIncrement, PlanarMeasurement, StripsOptions,
};
use scalars::Interval;
use setrep::Membership;

use crate::ScenarioError;
use crate::guaranteed_invariant::follow::{membership, within};
use crate::guaranteed_invariant::lever::{Bounds, LeverTruth};
use crate::guaranteed_invariant::robot_spans::Span;
use crate::guaranteed_invariant::settings::{ARM_PRIOR_M, POSITION_PRIOR_M, SCALE_PRIOR};
use crate::region::Containment;
use crate::vehicle::TruePose;

/// The set after a fix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeverStep {
    /// Index of the state.
    pub state: usize,
    /// Width of the heading, rad.
    pub heading_rad: f64,
    /// The scale.
    pub scale: Interval,
    /// The arm, m.
    pub arm_m: [Interval; 2],
    /// Area of the position box, m^2.
    pub area: f64,
    /// Whether the truth is in the set.
    pub membership: Membership,
}

/// One run.
#[derive(Clone, Debug, PartialEq)]
pub struct LeverRun {
    /// The fixes before a contradiction, if there is one.
    pub steps: Vec<LeverStep>,
    /// Index of the state whose fix is proven to contradict the bounds.
    pub contradiction: Option<usize>,
    /// What takes part in that contradiction.
    pub culprits: Vec<Culprit>,
    /// Largest number of rows.
    pub most_rows: usize,
}

impl LeverRun {
    /// Runs the filter, heading unknown, scale and arm within their priors, position within its prior of the first state.
    ///
    /// # Errors
    /// Those of the filter, but for a proven contradiction, which ends the run.
    pub fn new(truth: &LeverTruth, bounds: &Bounds) -> Result<Self, ScenarioError> {
        Self::with_spans(truth, bounds, &[])
    }

    /// The same with bounds on the motion over several increments, by which there is a fix after each.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_spans(truth: &LeverTruth, bounds: &Bounds, spans: &[Span]) -> Result<Self, ScenarioError> {
        let first = truth.states[0].rounded().position.map(|x| Interval::point(x) + within(POSITION_PRIOR_M));
        let scale = Interval::point(SCALE_PRIOR[0]).hull(Interval::point(SCALE_PRIOR[1]));
        let prior = PlanarBox::scale_and_lever_arm(Interval::ENTIRE, scale, first, [within(ARM_PRIOR_M); 2]);
        let longest = spans.iter().map(|span| span.windows).max().unwrap_or(0);
        let options = StripsOptions { spans: longest, ..StripsOptions::calibration() };
        let mut filter = InvariantStrips::new(&prior, options)?;
        let mut run = Self {
            steps: Vec::with_capacity(truth.fixes.len()),
            contradiction: None,
            culprits: Vec::new(),
            most_rows: 0,
        };
        let mut moved = 0;
        for &(state, fix) in &truth.fixes {
            for increment in &truth.increments[moved..state] {
                filter.predict(&PlanarIncrement::odometry(
                    Interval::point(increment.turn_rad),
                    increment.shift_m.map(Interval::point),
                    within(bounds.turn_rad),
                    bounds.shift_m.map(within),
                ))?;
            }
            moved = state;
            for span in spans {
                if let Some(motion) = span.motion_to(state) {
                    filter.bound_span(span.windows, &motion)?;
                }
            }
            match filter.update(&[PlanarMeasurement::position(fix, [within(bounds.fix_m); 2]).with_unknown_arm(0)]) {
                Err(EstimatorError::Inconsistent(proof)) => {
                    run.contradiction = Some(state);
                    run.culprits = proof.culprits;
                    return Ok(run);
                }
                other => other?,
            }
            run.most_rows = run.most_rows.max(filter.num_rows());
            run.steps.push(LeverStep::of(&filter, truth, state)?);
        }
        Ok(run)
    }

    /// Containment counted over the fixes.
    #[must_use]
    pub fn containment(&self) -> Containment {
        let mut containment = Containment::default();
        self.steps.iter().for_each(|step| containment.add(step.membership));
        containment
    }

    /// The first state that is proven outside its set.
    #[must_use]
    pub fn lost(&self) -> Option<usize> {
        self.steps.iter().find(|step| step.membership == Membership::ProvenOutside).map(|step| step.state)
    }

    /// The set after the fix of a state.
    #[must_use]
    pub fn at(&self, state: usize) -> Option<&LeverStep> {
        self.steps.iter().find(|step| step.state == state)
    }
}

impl LeverStep {
    fn of(filter: &InvariantStrips, truth: &LeverTruth, state: usize) -> Result<Self, ScenarioError> {
        let set = filter.enclosure();
        Ok(Self {
            state,
            heading_rad: set.heading_width_rad(),
            scale: set.scale,
            arm_m: set.body[0],
            area: set.position_area(),
            membership: membership(filter, &as_box(&truth.states[state], truth))?,
        })
    }
}

fn as_box(state: &TruePose, truth: &LeverTruth) -> PlanarBox {
    let [theta, x1, x2] = state.coordinates();
    let arm = truth.constants.arm_m.map(Interval::point);
    PlanarBox::scale_and_lever_arm(theta, Interval::point(truth.constants.scale), [x1, x2], arm)
}

#[cfg(test)]
mod tests {
    use crate::guaranteed_invariant::lever::simulate;
    use crate::guaranteed_invariant::settings::{FIX_EVERY, SETTINGS};
    use crate::monte_carlo::stream;

    use super::*;

    /// Twenty seconds of Problem 3 on a slow circle: nothing is lost, and the scale is known better than before.
    #[test]
    fn a_short_run_holds_the_truth() {
        let setting = SETTINGS[6];
        let bounds = setting.step_bounds();
        let increments = setting.increments()[..200].to_vec();
        let noise = (setting.kind, &bounds);
        let truth = simulate(setting.constants, increments, FIX_EVERY, noise, &mut stream(1, "short", 0)).unwrap();
        let run = LeverRun::new(&truth, &bounds).unwrap();
        assert_eq!((run.contradiction, run.lost(), run.steps.len()), (None, None, 20));
        assert!(run.steps[19].scale.width() < 0.2, "{}", run.steps[19].scale);
    }
}
