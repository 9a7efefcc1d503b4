//! [`RczOptions`]: what the ranged constrained-zonotope filter may spend.

use nonlin_bounds::ForwardBackward;
use setrep::TemplateWidths;

/// How an update finds its hulls, and how the set is kept small.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Tier {
    /// Hulls by certified linear programs, reduction by re-encoding.
    LinearPrograms,
    /// No linear programs: hulls of the rescaled set, reduction by elimination and Method 4. Cheaper and looser.
    Rescaling,
}

/// Options of an [`Rcz`](crate::Rcz) filter. They affect tightness and time, never validity.
///
/// | dynamics | constructor | constraints | reduction | widths |
/// |---|---|---|---|---|
/// | fast, up to about four states, well measured | [`fast`](Self::fast) | `n + 1` | every step | single rows |
/// | slow, many states, weakly measured | [`slow`](Self::slow) | `2 n` | every 10th step | linear programs |
/// | little time | [`cheap`](Self::cheap) | `n + 1` | every step | - |
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RczOptions {
    /// Most constraints after a reduction.
    pub constraints: usize,
    /// The set is reduced before a prediction if so many predictions have passed since the last time.
    pub reduce_every: usize,
    /// How a reduction measures what a constraint is worth.
    pub widths: TemplateWidths,
    /// Most passes of an update.
    pub passes: usize,
    /// Passes end when no side of the hull has shrunk by this share.
    pub least_shrink: f64,
    /// Propagation of boxes through measurement and invariant before each pass, for functions that have a tape.
    #[cfg_attr(feature = "serde", serde(with = "crate::remote::StoredContraction"))]
    pub contraction: ForwardBackward,
    /// What hulls and reductions may cost.
    pub tier: Tier,
}

impl RczOptions {
    /// For `n` states with fast dynamics: what is old is soon forgotten anyway.
    #[must_use]
    pub fn fast(n: usize) -> Self {
        Self {
            constraints: n + 1,
            reduce_every: 1,
            widths: TemplateWidths::SingleRows,
            passes: 3,
            least_shrink: 0.02,
            contraction: ForwardBackward::default(),
            tier: Tier::LinearPrograms,
        }
    }

    /// For `n` states with slow dynamics and few measurements, which remember: reductions are rare and careful.
    #[must_use]
    pub fn slow(n: usize) -> Self {
        Self { constraints: 2 * n, reduce_every: 10, widths: TemplateWidths::LinearPrograms, ..Self::fast(n) }
    }

    /// For `n` states, without linear programs.
    #[must_use]
    pub fn cheap(n: usize) -> Self {
        Self { tier: Tier::Rescaling, ..Self::fast(n) }
    }
}
