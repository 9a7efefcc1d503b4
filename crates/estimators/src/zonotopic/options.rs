//! [`ZonotopeOptions`]: which of the zonotope filters a filter is.

use setrep::{Reduction, Strip, StripRule};

use crate::Extension;

/// How an output becomes a strip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum StripForm {
    /// The linear part and the range of the output evaluated apart ([`OutputStrip`](nonlin_bounds::OutputStrip)), as in the paper. Such a
    /// strip is at least twice as wide as the set and hardly ever cuts it.
    Apart,
    /// A row of the tightest affine enclosure that the output is smooth enough for
    /// ([`AffineEnclosure`](nonlin_bounds::AffineEnclosure)): as wide as noise and remainder.
    Row,
}

/// Options of a [`ZonotopeFilter`](crate::ZonotopeFilter). They affect tightness and time, never validity, but for
/// [`feasible`](Self::feasible), which is a promise about the states.
///
/// | filter of paper 003 | options |
/// |---|---|
/// | ZMV, ZFO | [`ZonotopeOptions::zmv`], [`ZonotopeOptions::zfo`] |
/// | ZMV+F, ZFO+F | [`feasible`](Self::feasible) given |
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ZonotopeOptions {
    /// How the dynamics are enclosed in a prediction, which needs `C1` on the hull.
    pub extension: Extension,
    /// How outputs of the measurement and of the invariant become strips.
    pub strips: StripForm,
    /// Which of the enclosures of an intersection with a strip is taken.
    pub rule: StripRule,
    /// "+F": strips that are known to contain every state. An update cuts with them after the measurement (Remark 11).
    pub feasible: Vec<Strip>,
    /// "+C": whether an update ends with the strips of the invariant of the system, if it has one.
    pub consistency: bool,
    /// Most generators after an update; at least as many as states.
    pub generators: usize,
    /// How generators are reduced to so many.
    pub reduction: Reduction,
    /// Whether the hull is cut with that from before a reduction or an intersection, which still holds the state. The filters of the paper
    /// forget it.
    pub keep_hull: bool,
}

impl ZonotopeOptions {
    /// ZMV: predictions by the mean value theorem.
    #[must_use]
    pub fn zmv(generators: usize) -> Self {
        Self {
            extension: Extension::MeanValue,
            strips: StripForm::Apart,
            rule: StripRule::Determinant,
            feasible: Vec::new(),
            consistency: false,
            generators,
            reduction: Reduction::Method4,
            keep_hull: false,
        }
    }

    /// ZFO: predictions by Taylor's theorem of first order.
    #[must_use]
    pub fn zfo(generators: usize) -> Self {
        Self { extension: Extension::FirstOrder, ..Self::zmv(generators) }
    }

    /// The same with tight strips, which the paper does not have.
    #[must_use]
    pub fn with_rows(self) -> Self {
        Self { strips: StripForm::Row, ..self }
    }

    /// The same with the strips of the invariant: "+C".
    #[must_use]
    pub fn with_consistency(self) -> Self {
        Self { consistency: true, ..self }
    }

    /// The same with strips that contain every state: "+F".
    #[must_use]
    pub fn with_feasible(self, feasible: Vec<Strip>) -> Self {
        Self { feasible, ..self }
    }
}
