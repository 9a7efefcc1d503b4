//! How much of the past a filter keeps.

use crate::EstimatorError;

/// Which rows a filter of strips keeps and which bounds it recomputes. Every choice is sound: dropping a row only enlarges the set.
///
/// Instants are counted by calls of `update`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StripsOptions {
    /// Instants for which the rows of a measurement are kept.
    pub memory: usize,
    /// Longest bucket: of the rows of one class from one bucket of instants the one with the least slack is kept (and those in use). A
    /// bucket at instant `k` has `k / 8` instants, at least 2 and at most this many; 0 keeps all rows that were in use lately.
    pub bucket: usize,
    /// Every so many instants the bounds of the position become rows of their own; 0 for never.
    pub refresh: usize,
    /// Whether each refresh also takes bounds of the sensor, the position, the arms and the scaled heading along and across the track.
    pub aligned: bool,
    /// Instants for which the rows of a refresh are kept.
    pub support_life: usize,
    /// Directions in which a wide heading is cut.
    pub caps: usize,
    /// Predictions back to which bounds on the motion over several of them reach: see
    /// [`InvariantStrips::bound_span`](crate::InvariantStrips::bound_span). 0 if there are none.
    pub spans: usize,
}

impl StripsOptions {
    /// For a pose measured at a high rate: about 110 rows, at most 210.
    #[must_use]
    pub const fn pose() -> Self {
        Self { memory: 300, bucket: 20, refresh: 10, aligned: false, support_life: 300, caps: 48, spans: 0 }
    }

    /// As [`pose`](Self::pose) without the refreshed rows: faster, and the area some percent larger.
    #[must_use]
    pub const fn fast_pose() -> Self {
        Self { refresh: 0, ..Self::pose() }
    }

    /// For scale and lever arms, measured at a low rate: some 250 rows, up to 400 while the heading is wide.
    #[must_use]
    pub const fn calibration() -> Self {
        Self { memory: 40, bucket: 0, refresh: 1, aligned: true, support_life: 30, caps: 48, spans: 0 }
    }

    pub(crate) fn check(&self) -> Result<(), EstimatorError> {
        if self.memory == 0 {
            return Err(EstimatorError::Size { what: "memory", expected: 1, found: 0 });
        }
        if self.caps < 8 {
            return Err(EstimatorError::Size { what: "caps", expected: 8, found: self.caps });
        }
        Ok(())
    }
}

impl Default for StripsOptions {
    fn default() -> Self {
        Self::pose()
    }
}
