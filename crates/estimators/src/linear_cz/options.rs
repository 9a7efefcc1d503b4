//! Options of a [`LinearCz`](super::LinearCz).

use setrep::{Complexity, Reduction};

/// How a measurement is written in a [`LinearCz`](super::LinearCz).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum NoiseForm {
    /// The noise widens the range of a row if it acts on each output by itself: no generators. Noise that mixes outputs is written as
    /// generators all the same.
    Ranges,
    /// The generators and constraints of the noise join those of the set, as in (B.3).
    Generators,
}

/// Options of a [`LinearCz`](super::LinearCz). Without a limit sets are exact but for rounding, and grow with every step.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LinearOptions {
    /// How large a set may be after an update; `None` for as large as it gets.
    pub limit: Option<Complexity>,
    /// How generators are reduced to that.
    pub reduction: Reduction,
    /// How measurements are written.
    pub noise: NoiseForm,
    /// Whether an update ends with the consistency step.
    pub consistency: bool,
}

impl Default for LinearOptions {
    fn default() -> Self {
        Self { limit: None, reduction: Reduction::Method4, noise: NoiseForm::Ranges, consistency: true }
    }
}
