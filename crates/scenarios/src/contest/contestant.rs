//! [`Contestant`]: what is asked of a filter, be it statistical or set-valued.

use estimators::kalman::{Flat, Forecast, Kalman, Motion, Observe, Sensor};
use estimators::{Estimator, EstimatorError, SetFilter, ZfMethod};
use scalars::Interval;
use setrep::Membership;

use crate::ScenarioError;
use crate::region::in_box;

/// Standard deviations of the confidence intervals that are shown and counted.
pub const SIGMAS: f64 = 3.0;

/// Where a state lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Held {
    /// In the region that the filter states: the box of all confidence intervals, or the set.
    pub region: Membership,
    /// In the box of all confidence intervals, or in the hull of the set.
    pub hull: Membership,
}

/// A filter of either kind, of `N` states.
pub trait Contestant<const N: usize> {
    /// A prediction, then an update by `y`.
    ///
    /// # Errors
    /// What the filter says.
    fn advance(&mut self, y: &[f64]) -> Result<(), EstimatorError>;

    /// Mean or center.
    fn center(&self) -> [f64; N];

    /// Half widths of the interval of each state: three standard deviations, or of the set's hull.
    fn half_widths(&self) -> [f64; N];

    /// Where an exact state lies; proven for sets.
    ///
    /// # Errors
    /// What the set says.
    fn holds(&self, state: &[f64; N]) -> Result<Held, ScenarioError>;
}

impl<Mo, Rule, const N: usize, const M: usize, const W: usize, const V: usize> Contestant<N>
    for Kalman<Mo, Rule, Flat, N, M, W, V>
where
    Mo: Motion<Flat, N, W, Input = [f64]> + Sensor<Flat, N, M, V>,
    Rule: Forecast<Mo, Flat, N, W> + Observe<Mo, Flat, N, M, V>,
{
    fn advance(&mut self, y: &[f64]) -> Result<(), EstimatorError> {
        self.predict(&[])?;
        self.update(y)
    }

    fn center(&self) -> [f64; N] {
        (*self.belief().mean()).into()
    }

    fn half_widths(&self) -> [f64; N] {
        (self.belief().standard_deviations() * SIGMAS).into()
    }

    /// A confidence interval is no bound, so its ends need no proof.
    fn holds(&self, state: &[f64; N]) -> Result<Held, ScenarioError> {
        let (center, half) = (Contestant::center(self), self.half_widths());
        let inside = (0..N).all(|i| (state[i] - center[i]).abs() <= half[i]);
        let verdict = if inside { Membership::ProvenInside } else { Membership::ProvenOutside };
        Ok(Held { region: verdict, hull: verdict })
    }
}

/// A zonotopic filter of `N` states.
#[derive(Debug, Clone)]
pub struct Zonotopic<const LINEARIZED: bool>(pub SetFilter<ZfMethod<LINEARIZED>>);

/// Sets of more generators than this are looked at through their hull alone: exact membership would take all their facets.
const MEMBERSHIP_GENERATORS: usize = 60;

impl<const LINEARIZED: bool, const N: usize> Contestant<N> for Zonotopic<LINEARIZED> {
    fn advance(&mut self, y: &[f64]) -> Result<(), EstimatorError> {
        self.0.predict(&[])?;
        self.0.update(y)
    }

    fn center(&self) -> [f64; N] {
        std::array::from_fn(|i| self.0.enclosure().center()[i])
    }

    fn half_widths(&self) -> [f64; N] {
        std::array::from_fn(|i| self.0.hull()[i].rad())
    }

    fn holds(&self, state: &[f64; N]) -> Result<Held, ScenarioError> {
        let point = state.map(Interval::point);
        let (set, hull) = (self.0.enclosure(), in_box(self.0.hull(), &point));
        let beyond = set.num_generators() > MEMBERSHIP_GENERATORS || hull == Membership::ProvenOutside;
        Ok(Held { region: if beyond { hull } else { set.membership(&point)? }, hull })
    }
}
