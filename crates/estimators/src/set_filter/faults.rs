//! [`FaultPolicy`]: how a filter goes on after a proven contradiction.

use scalars::Interval;
use scalars::rounding::add_up;
use setrep::{ConstrainedZonotope, Part, SetError, SupportFunction, VPolytope, Workspace, Zonotope, ZonotopeBundle};

use super::{Method, SetFilter};
use crate::error::{check_finite, check_size};
use crate::{EstimatorError, Inconsistency};

/// How a filter goes on after a proven contradiction. One of the promises behind it was broken: the guarantee holds again from the moment
/// that what the policy assumes is true.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum FaultPolicy<S> {
    /// Keep the predicted set and do without the measurement. Assumes that the measurement is at fault: an outlier, a failing sensor.
    KeepPrediction,
    /// Go on from this set, with the measurement unless it contradicts that as well. Assumes that the state lies in the set, whatever happened
    /// before: a model or an initial set that was wrong.
    Reset(S),
    /// Add a box to the predicted set until the measurement agrees. Assumes that the predicted set misses the state by no more than the box, as
    /// often as it was added: noise that exceeds its bounds a little. If the measurement never agrees, it is dropped and the predicted set
    /// kept.
    Inflate {
        /// Half the sides of the box, one for each state.
        radii: Vec<f64>,
        /// How often the box is added at most.
        attempts: usize,
    },
}

/// A contradiction that was met, and how the filter went on.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// The contradiction, with its proof.
    pub inconsistency: Inconsistency,
    /// What was done.
    pub recovery: Recovery,
}

/// What a filter did about a contradiction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Recovery {
    /// The predicted set was kept, the measurement dropped.
    Dropped,
    /// The filter went on from the set given.
    Reset {
        /// Whether the measurement was used on it; it contradicts that set as well if not.
        measurement_used: bool,
    },
    /// The predicted set was enlarged, and the measurement used.
    Inflated {
        /// How often the box was added.
        times: usize,
    },
}

/// A set that can be enlarged by a box.
pub trait Inflate {
    /// Adds the box of these half sides: `X + [-radii, radii]`, or a superset.
    ///
    /// # Errors
    /// [`SetError`] for radii that do not fit; the set is then unchanged.
    fn inflate(&mut self, radii: &[f64]) -> Result<(), SetError>;
}

impl Inflate for Zonotope {
    fn inflate(&mut self, radii: &[f64]) -> Result<(), SetError> {
        self.add_box(&around_zero(radii))
    }
}

impl Inflate for ConstrainedZonotope {
    fn inflate(&mut self, radii: &[f64]) -> Result<(), SetError> {
        self.add_box(&around_zero(radii))
    }
}

/// Member by member.
impl Inflate for ZonotopeBundle {
    fn inflate(&mut self, radii: &[f64]) -> Result<(), SetError> {
        self.add_box(&around_zero(radii), &mut Workspace::new())
    }
}

/// The remainder grows.
impl Inflate for VPolytope {
    fn inflate(&mut self, radii: &[f64]) -> Result<(), SetError> {
        let fits = self.dim() == radii.len();
        let larger = |(held, &more): (&f64, &f64)| add_up(*held, more);
        let remainder: Vec<f64> = self.remainder().iter().zip(radii).map(larger).collect();
        // A wrong length is refused by name.
        *self = Self::with_remainder(self.vertices().clone(), if fits { &remainder } else { radii })?;
        Ok(())
    }
}

fn around_zero(radii: &[f64]) -> Vec<Interval> {
    radii.iter().map(|&r| Interval::ZERO.inflate(r)).collect()
}

impl<M: Method> SetFilter<M> {
    /// Goes on from a set, at the same step: what was known before is forgotten.
    ///
    /// # Errors
    /// As [`new`](SetFilter::new); the filter is then unchanged.
    pub fn reset(&mut self, set: M::Set) -> Result<(), EstimatorError> {
        check_size("set to go on from", self.system.states(), set.dim())?;
        let mut state = M::start(&self.system, set, &self.options, &mut self.scratch)?;
        state.step = self.state.step;
        self.state = state;
        Ok(())
    }
}

impl<M: Method> SetFilter<M>
where
    M::Set: Inflate,
{
    /// [`update_some`](SetFilter::update_some), and after a proven contradiction what `policy` says. Returns the fault, if there was one; its
    /// proof is still that of the set before.
    ///
    /// # Errors
    /// All but contradictions: those of [`update`](crate::Estimator::update), a policy that does not fit the system. The filter is then
    /// unchanged.
    ///
    /// ```
    /// use estimators::{FaultPolicy, Rcz, RczOptions, Recovery, Relation, System};
    /// use nonlin_bounds::function;
    /// use setrep::{ConstrainedZonotope, Zonotope};
    ///
    /// let noise = Zonotope::from_box(&[0.0], &[0.1])?;
    /// let walk = Relation::new(function!(|[x, w]: 2| -> 1 { [x + w] }));
    /// let seen = Relation::new(function!(|[x, v]: 2| -> 1 { [x + v] }));
    /// let system = System::new(walk, noise.clone(), seen, noise)?;
    /// let mut filter = Rcz::new(system, ConstrainedZonotope::from_box(&[0.0], &[1.0])?, RczOptions::fast(1))?;
    ///
    /// // The bounds say that the measurement lies within 1.1.
    /// let fault = filter.update_or_recover(&[Some(1.5)], &[], &FaultPolicy::KeepPrediction)?;
    /// assert_eq!(fault.map(|fault| fault.recovery), Some(Recovery::Dropped));
    /// let policy = FaultPolicy::Inflate { radii: vec![0.3], attempts: 3 };
    /// let fault = filter.update_or_recover(&[Some(1.5)], &[], &policy)?;
    /// assert_eq!(fault.map(|fault| fault.recovery), Some(Recovery::Inflated { times: 2 }));
    /// assert!(filter.hull()[0].contains(1.5) && filter.hull()[0].lo() > 1.39);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn update_or_recover(
        &mut self,
        output: &[Option<f64>],
        p: &[f64],
        policy: &FaultPolicy<M::Set>,
    ) -> Result<Option<Fault>, EstimatorError> {
        self.or_recover(policy, |filter| filter.update_some(output, p))
    }

    /// [`consistency`](crate::Estimator::consistency), and after a proven contradiction what `policy` says, with the invariant for the
    /// measurement.
    ///
    /// # Errors
    /// As [`update_or_recover`](Self::update_or_recover).
    pub fn consistency_or_recover(&mut self, policy: &FaultPolicy<M::Set>) -> Result<Option<Fault>, EstimatorError> {
        self.or_recover(policy, crate::Estimator::consistency)
    }

    fn or_recover(
        &mut self,
        policy: &FaultPolicy<M::Set>,
        attempt: impl Fn(&mut Self) -> Result<(), EstimatorError>,
    ) -> Result<Option<Fault>, EstimatorError> {
        self.check_policy(policy)?;
        let inconsistency = match attempt(self) {
            Ok(()) => return Ok(None),
            Err(EstimatorError::Inconsistent(inconsistency)) => *inconsistency,
            Err(error) => return Err(error),
        };
        let before = self.state.clone();
        let recovery = self.recover(policy, &attempt);
        if !matches!(recovery, Ok(Recovery::Reset { .. } | Recovery::Inflated { .. })) {
            self.state = before;
        }
        Ok(Some(Fault { inconsistency, recovery: recovery? }))
    }

    fn recover(
        &mut self,
        policy: &FaultPolicy<M::Set>,
        attempt: &impl Fn(&mut Self) -> Result<(), EstimatorError>,
    ) -> Result<Recovery, EstimatorError> {
        match policy {
            FaultPolicy::KeepPrediction => Ok(Recovery::Dropped),
            FaultPolicy::Reset(set) => {
                self.reset(set.clone())?;
                Ok(Recovery::Reset { measurement_used: agrees(attempt(self))? })
            }
            FaultPolicy::Inflate { radii, attempts } => {
                for times in 1..=*attempts {
                    self.inflate(radii)?;
                    if agrees(attempt(self))? {
                        return Ok(Recovery::Inflated { times });
                    }
                }
                Ok(Recovery::Dropped)
            }
        }
    }

    /// Adds a box to set and hull.
    fn inflate(&mut self, radii: &[f64]) -> Result<(), EstimatorError> {
        let mut set = self.state.set.clone();
        set.inflate(radii)?;
        let held: Vec<Interval> = self.state.hull.iter().zip(radii).map(|(side, &r)| side.inflate(r)).collect();
        self.reset(set)?;
        for (side, held) in self.state.hull.iter_mut().zip(held) {
            // Both hold the state.
            let both = side.intersection(held);
            if !both.is_empty() {
                *side = both;
            }
        }
        Ok(())
    }

    /// `Ok` if the policy fits the system.
    fn check_policy(&self, policy: &FaultPolicy<M::Set>) -> Result<(), EstimatorError> {
        let n = self.system.states();
        match policy {
            FaultPolicy::KeepPrediction => Ok(()),
            FaultPolicy::Reset(set) => check_size("set to go on from", n, set.dim()),
            FaultPolicy::Inflate { radii, .. } => {
                check_size("radii of a fault policy", n, radii.len())?;
                check_finite("radii of a fault policy", radii)?;
                match radii.iter().position(|&r| r < 0.0) {
                    None => Ok(()),
                    Some(row) => Err(SetError::Negative { part: Part::Radius, row, col: 0, value: radii[row] }.into()),
                }
            }
        }
    }
}

/// Whether an attempt was no contradiction.
fn agrees(result: Result<(), EstimatorError>) -> Result<bool, EstimatorError> {
    match result {
        Ok(()) => Ok(true),
        Err(EstimatorError::Inconsistent(_)) => Ok(false),
        Err(error) => Err(error),
    }
}
