//! Options of a [`Vh`](crate::Vh) filter.

use nonlin_bounds::Expansion;

/// What a [`Vh`](crate::Vh) filter may spend. The options affect tightness and time, never validity.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct VhOptions {
    /// Most vertices of a set after a call, at least the `2^n` of a box.
    pub vertices: usize,
    /// Most passes of an update, each with the Jacobian over the hull that the last one has left.
    pub passes: usize,
    /// Passes end when no side of the hull has shrunk by this share.
    pub least_shrink: f64,
    /// Cut the prediction with the range of the dynamics by [`RangeMethod::Tight`](nonlin_bounds::RangeMethod::Tight).
    pub tight_range: bool,
    /// The points about which functions are expanded.
    pub center: VhCenter,
}

/// The point of a set about which a [`Vh`](crate::Vh) filter expands functions; any point is valid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum VhCenter {
    /// The mean of the vertices, which lies inside of the set as paper 004 asks.
    #[default]
    VertexMean,
    /// The middle of the interval hull, which makes `|v - x_0|` least coordinate by coordinate; [`WidthBound::Centered`](crate::WidthBound::Centered)
    /// is for it.
    HullCenter,
}

impl VhCenter {
    pub(super) fn expansion(self) -> Expansion<'static> {
        match self {
            Self::VertexMean => Expansion::SetCenter,
            Self::HullCenter => Expansion::HullCenter,
        }
    }
}

impl VhOptions {
    /// As in paper 004: one pass. At most 64 vertices, where the paper has no limit.
    #[must_use]
    pub fn paper() -> Self {
        Self { vertices: 64, passes: 1, least_shrink: 0.02, tight_range: false, center: VhCenter::VertexMean }
    }

    /// Up to three passes, and the tight range.
    #[must_use]
    pub fn tight() -> Self {
        Self { passes: 3, tight_range: true, ..Self::paper() }
    }
}
