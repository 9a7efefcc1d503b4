//! [`FilterState`]: what a set-valued filter knows between calls.

use scalars::Interval;
use setrep::SupportFunction;

use crate::EstimatorError;
use crate::error::check_size;

/// The set of states, its hull and what the method keeps: all that has to be saved to go on later.
///
/// The state lies in the set **and** in the hull, which may be tighter than the set's own after a reduction.
#[derive(Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FilterState<S, M = ()> {
    /// The set.
    pub set: S,
    /// A box that holds the state as well.
    pub hull: Vec<Interval>,
    /// Number of predictions so far.
    pub step: u64,
    /// What the method keeps besides.
    pub memory: M,
}

/// Reuses the storage of the target in `clone_from`.
impl<S: Clone, M: Clone> Clone for FilterState<S, M> {
    fn clone(&self) -> Self {
        Self { set: self.set.clone(), hull: self.hull.clone(), step: self.step, memory: self.memory.clone() }
    }

    fn clone_from(&mut self, source: &Self) {
        self.set.clone_from(&source.set);
        self.hull.clone_from(&source.hull);
        self.step = source.step;
        self.memory.clone_from(&source.memory);
    }
}

impl<S: SupportFunction, M> FilterState<S, M> {
    /// `Ok` if a filter of `n` states can go on from this set and hull.
    pub(crate) fn check(&self, n: usize) -> Result<(), EstimatorError> {
        check_size("saved set", n, self.set.dim())?;
        check_size("saved hull", n, self.hull.len())?;
        if let Some(index) = self.hull.iter().position(Interval::is_empty) {
            return Err(EstimatorError::EmptyRange { what: "saved hull", index });
        }
        match self.hull.iter().position(|side| !side.is_bounded()) {
            Some(index) => Err(EstimatorError::NotFinite { what: "saved hull", index, value: self.hull[index].mag() }),
            None => Ok(()),
        }
    }
}
