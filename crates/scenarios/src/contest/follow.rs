//! [`follow`](self::follow()): one filter in one run, and the [`Record`] of it.

use estimators::EstimatorError;
use setrep::Membership;

use super::{Contestant, Truth};
use crate::ScenarioError;

/// What is looked at.
#[derive(Debug, Clone, Copy)]
pub struct Watch<'a> {
    /// Steps up to this one do not count for [`Record::late_rmse`].
    pub late: usize,
    /// Steps at which half widths are kept.
    pub marks: &'a [usize],
    /// A half width beyond this is a divergence.
    pub limit: f64,
    /// Containment is looked at every so many steps.
    pub stride: usize,
    /// Whether the noises keep their bounds: a refuted update then means that the set has lost the state.
    pub bounded: bool,
}

/// What became of a filter in one run of steps `1..=len`.
#[derive(Debug, Clone, PartialEq)]
pub struct Record<const N: usize> {
    /// Root mean square errors over all steps (47); NaN after a divergence.
    pub rmse: [f64; N],
    /// The same over the late steps.
    pub late_rmse: [f64; N],
    /// Half widths at the marks; NaN beyond a divergence.
    pub marks: Vec<[f64; N]>,
    /// Steps at which containment was looked at, and of these: with the state in the region, and in all intervals.
    pub watched: usize,
    /// Steps with the state not proven outside the region.
    pub held: usize,
    /// Steps with the state proven inside.
    pub proven: usize,
    /// Steps with the state not proven outside the hull.
    pub boxed: usize,
    /// Updates that were proven to contradict the prediction; the filter went on without them.
    pub refuted: usize,
    /// Step at which the filter failed or outgrew the limit.
    pub diverged: Option<usize>,
}

impl<const N: usize> Record<N> {
    fn new(marks: usize) -> Self {
        Self {
            rmse: [f64::NAN; N],
            late_rmse: [f64::NAN; N],
            marks: vec![[f64::NAN; N]; marks],
            watched: 0,
            held: 0,
            proven: 0,
            boxed: 0,
            refuted: 0,
            diverged: None,
        }
    }

    /// Counts a step; `lost` if the filter has said itself that it cannot hold the state.
    fn count(&mut self, filter: &dyn Contestant<N>, state: &[f64; N], lost: bool) -> Result<(), ScenarioError> {
        let held = filter.holds(state)?;
        self.watched += 1;
        self.held += usize::from(!lost && held.region != Membership::ProvenOutside);
        self.proven += usize::from(!lost && held.region == Membership::ProvenInside);
        self.boxed += usize::from(!lost && held.hull != Membership::ProvenOutside);
        Ok(())
    }
}

/// Center and half widths of one step.
pub type Course<const N: usize> = Vec<([f64; N], [f64; N])>;

/// The run of a filter under its name.
pub type Named<const N: usize> = (&'static str, Course<N>);

/// Follows a run; `keep` is called after every step. A filter that contradicts an output goes on without it; one that finds no bounds has
/// diverged.
///
/// # Errors
/// Those of looking at a set, and those of the filter that say that it is used wrongly.
pub fn follow<const N: usize, const M: usize>(
    filter: &mut dyn Contestant<N>,
    truth: &Truth<N, M>,
    watch: &Watch<'_>,
    mut keep: impl FnMut([f64; N], [f64; N]),
) -> Result<Record<N>, ScenarioError> {
    let (mut all, mut late) = ([0.0; N], [0.0; N]);
    let mut record = Record::new(watch.marks.len());
    for (k, (x, y)) in (1..).zip(truth.states.iter().zip(&truth.outputs)) {
        let refuted = match filter.advance(y) {
            Ok(()) => false,
            Err(EstimatorError::Inconsistent(_)) => true,
            Err(error @ EstimatorError::Size { .. }) => return Err(error.into()),
            Err(_) => {
                record.diverged = Some(k);
                false
            }
        };
        record.refuted += usize::from(refuted);
        let (center, half_widths) = (filter.center(), filter.half_widths());
        // NaN is beyond the limit, too.
        if !half_widths.iter().chain(&center).all(|x| x.abs() <= watch.limit) {
            record.diverged = record.diverged.or(Some(k));
        }
        if record.diverged.is_some() {
            return Ok(record);
        }
        keep(center, half_widths);
        for i in 0..N {
            let squared = (x[i] - center[i]) * (x[i] - center[i]);
            all[i] += squared;
            late[i] += if k > watch.late { squared } else { 0.0 };
        }
        if let Some(mark) = watch.marks.iter().position(|&mark| mark == k) {
            record.marks[mark] = half_widths;
        }
        let lost = refuted && watch.bounded;
        if lost || k % watch.stride == 0 {
            record.count(filter, x, lost)?;
        }
    }
    let steps = truth.states.len();
    record.rmse = all.map(|sum| (sum / steps as f64).sqrt());
    record.late_rmse = late.map(|sum| (sum / steps.saturating_sub(watch.late) as f64).sqrt());
    Ok(record)
}
